// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExactGeodesicDistance.h"

#include "DGGDistanceInternals.h"

#include "dggSourceFinding.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkExactGeodesicDistance);

//------------------------------------------------------------------------------
class vtkExactGeodesicDistance::vtkInternals
  : public DGGInternalsOf<vtkExactGeodesicDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status ComputeDistances(DGGDistanceTask& task) override;
};

//------------------------------------------------------------------------------
vtkExactGeodesicDistance::vtkExactGeodesicDistance()
  : Engine(Triangle)
  , GenerateWindows(false)
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkExactGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Engine: " << (this->Engine == Reference ? "Reference" : "Triangle") << "\n";
  os << indent << "GenerateWindows: " << (this->GenerateWindows ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
dgg::Status vtkExactGeodesicDistance::vtkInternals::ComputeDistances(DGGDistanceTask& task)
{
  dgg::ExactOptions options;
  options.Engine =
    this->Self->Engine == Reference ? dgg::ExactEngine::Reference : dgg::ExactEngine::Triangle;
  options.MaximumDistance = task.MaximumDistance;
  options.Progress = task.Context.Progress;
  options.KeepWindows = this->Self->GenerateWindows;
  if (options.KeepWindows)
  {
    // At least 1, because 0 would mean no limit.
    options.MemoryLimit = static_cast<std::size_t>(std::max(1.0, task.Context.Memory.GetBytes()));
  }

  dgg::ExactGeodesics solver(task.Context.Surface.GetMesh());
  dgg::ExactResult result;
  const dgg::Status status = solver.Run(task.Sources, options, result);
  if (status.IsOk() && task.WantVirtualSource)
  {
    dgg::FindVirtualSources(task.Context.Surface.GetMesh(), task.Sources, result,
      task.VirtualSource, task.Context.Parallel);
  }
  task.Windows = std::move(result.Windows);
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  return status;
}
