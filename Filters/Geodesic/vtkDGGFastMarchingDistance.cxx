// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGFastMarchingDistance.h"

#include "DGGDistanceTask.h"
#include "DGGMeshQuality.h"

#include "dggFastMarching.h"

#include "vtkObjectFactory.h"

#include <utility>

vtkStandardNewMacro(vtkDGGFastMarchingDistance);

/// Kept until the mesh changes.
struct vtkDGGFastMarchingDistance::Preparation
{
  vtkMTimeType MeshTime;
  dgg::FastMarching Solver;
};

//------------------------------------------------------------------------------
vtkDGGFastMarchingDistance::vtkDGGFastMarchingDistance()
  : FrontShape(Spherical)
  , QualityWarning(false)
{
}

//------------------------------------------------------------------------------
vtkDGGFastMarchingDistance::~vtkDGGFastMarchingDistance() = default;

//------------------------------------------------------------------------------
void vtkDGGFastMarchingDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FrontShape: " << this->GetFrontShapeAsString() << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
}

//------------------------------------------------------------------------------
const char* vtkDGGFastMarchingDistance::GetFrontShapeAsString() const
{
  return this->FrontShape == Planar ? "Planar" : "Spherical";
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::ComputeDistances(DGGDistanceTask& task)
{
  dgg::MarchingOptions options;
  options.Update =
    this->FrontShape == Planar ? dgg::MarchingUpdate::Planar : dgg::MarchingUpdate::Spherical;
  options.MaximumDistance = task.MaximumDistance;
  options.WantVirtualSource = task.WantVirtualSource;
  options.Progress = task.Context.Progress;

  if (!this->Prepared || this->Prepared->MeshTime != task.Context.Surface.GetBuildTime())
  {
    this->Prepared.reset(); // before there are two
    this->Prepared.reset(new Preparation{
      task.Context.Surface.GetBuildTime(), dgg::FastMarching(task.Context.Surface.GetMesh()) });
    this->QualityWarning = DGGWarnOfLongTriangles(this);
  }
  dgg::MarchingResult result;
  const dgg::Status status = this->Prepared->Solver.Run(task.Sources, options, result);
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  task.VirtualSource = std::move(result.Virtual);
  return status;
}
