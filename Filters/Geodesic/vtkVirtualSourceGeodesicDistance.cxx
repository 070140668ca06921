// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSourceGeodesicDistance.h"

#include "DGGDistanceTask.h"
#include "DGGMeshQuality.h"
#include "DGGPropagation.h"

#include "vtkObjectFactory.h"

#include <utility>

vtkStandardNewMacro(vtkVirtualSourceGeodesicDistance);

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::vtkVirtualSourceGeodesicDistance()
  : Quality(Automatic)
  , QualityWarning(false)
  , Propagation(new DGGPropagation)
{
}

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::~vtkVirtualSourceGeodesicDistance() = default;

//------------------------------------------------------------------------------
void vtkVirtualSourceGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quality: " << this->GetQualityAsString() << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
}

//------------------------------------------------------------------------------
const char* vtkVirtualSourceGeodesicDistance::GetQualityAsString() const
{
  static const char* const names[] = { "Automatic", "Fast", "High" };
  return names[this->Quality];
}

//------------------------------------------------------------------------------
std::string vtkVirtualSourceGeodesicDistance::GetMemoryRemedy() const
{
  return "use a smaller mesh, or SetQualityToFast()";
}

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::ComputeDistances(DGGDistanceTask& task)
{
  dgg::PropagationOptions options;
  options.Quality = this->Quality == Automatic ? DGGPropagation::Choose(task.Context.Surface)
    : this->Quality == High                    ? dgg::PropagationQuality::High
                                               : dgg::PropagationQuality::Fast;
  options.MaximumDistance = task.MaximumDistance;
  options.WantNearestSource = task.WantNearestSource;
  options.WantVirtualSource = task.WantVirtualSource;
  dgg::PropagationResult result;
  DGG_RETURN_IF_ERROR(this->Propagation->Run(task.Context, task.Sources, options, result));
  this->QualityWarning = this->WarnAboutQuality(
    DGGJoinReasons({ DGGDescribeLongTriangles(task.Context.Surface, DGGLongTrianglesMislead),
      result.IsSettled ? "" : DGGUnsettledDistances }));
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  task.VirtualSource = std::move(result.Virtual);
  return dgg::Status::Success();
}
