// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExactGeodesicDistance.h"

#include "vtkDGGDistanceTask.h"

#include "dggExactSources.h"

#include "vtkObjectFactory.h"

#include <utility>

vtkStandardNewMacro(vtkExactGeodesicDistance);

//------------------------------------------------------------------------------
vtkExactGeodesicDistance::vtkExactGeodesicDistance()
  : Engine(Triangle)
  , GenerateWindows(false)
{
}

//------------------------------------------------------------------------------
vtkExactGeodesicDistance::~vtkExactGeodesicDistance() = default;

//------------------------------------------------------------------------------
void vtkExactGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Engine: " << (this->Engine == Reference ? "Reference" : "Triangle") << "\n";
  os << indent << "GenerateWindows: " << (this->GenerateWindows ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
dgg::Status vtkExactGeodesicDistance::ComputeDistances(vtkDGGDistanceTask& task)
{
  dgg::ExactOptions options;
  options.Engine =
    this->Engine == Reference ? dgg::ExactEngine::Reference : dgg::ExactEngine::Triangle;
  options.MaximumDistance = task.MaximumDistance;
  options.Progress = task.Progress;
  options.KeepWindows = this->GenerateWindows;

  dgg::ExactGeodesics solver(task.Mesh);
  dgg::ExactResult result;
  const dgg::Status status = solver.Run(task.Sources, options, result);
  if (status.IsOk() && task.WantVirtualSource)
  {
    dgg::FindVirtualSources(task.Mesh, task.Sources, result, task.VirtualSource);
  }
  task.Windows = std::move(result.Windows);
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  return status;
}
