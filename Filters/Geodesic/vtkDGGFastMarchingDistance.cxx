// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGFastMarchingDistance.h"

#include "DGGCloudMarching.h"
#include "DGGDistanceTask.h"
#include "DGGMeshQuality.h"

#include "dggFastMarching.h"
#include "dggInvalidInput.h"
#include "dggProgressPart.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <utility>

vtkStandardNewMacro(vtkDGGFastMarchingDistance);

namespace
{
constexpr double LeastRadius = 0.5;
constexpr double LargestRadius = 1000.0;
/// Progress weight of building a band.
constexpr double BandShare = 0.4;
}

/// Solver, kept until the mesh changes, or the band of a cloud.
struct vtkDGGFastMarchingDistance::Preparation
{
  std::uint64_t MeshBuild;
  std::unique_ptr<dgg::FastMarching> Solver;
  std::unique_ptr<DGGCloudMarching> OnCloud; // instead of Solver
  double BandRadius;                         // as requested
  int Resolution;
};

//------------------------------------------------------------------------------
vtkDGGFastMarchingDistance::vtkDGGFastMarchingDistance()
  : FrontShape(Spherical)
  , BandRadius(0.0)
  , Resolution(0)
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
  os << indent << "BandRadius: " << this->BandRadius << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "UsedBandRadius: " << this->GetUsedBandRadius() << "\n";
  os << indent << "UsedResolution: " << this->GetUsedResolution() << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
}

//------------------------------------------------------------------------------
const char* vtkDGGFastMarchingDistance::GetFrontShapeAsString() const
{
  return this->FrontShape == Planar ? "Planar" : "Spherical";
}

//------------------------------------------------------------------------------
double vtkDGGFastMarchingDistance::GetUsedBandRadius() const
{
  return this->Prepared && this->Prepared->OnCloud ? this->Prepared->OnCloud->GetBandRadius() : 0.0;
}

//------------------------------------------------------------------------------
int vtkDGGFastMarchingDistance::GetUsedResolution() const
{
  return this->Prepared && this->Prepared->OnCloud ? this->Prepared->OnCloud->GetResolution() : 0;
}

//------------------------------------------------------------------------------
bool vtkDGGFastMarchingDistance::IsCloud(vtkPolyData* input) const
{
  return input->GetNumberOfPoints() > 0 &&
    input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0;
}

//------------------------------------------------------------------------------
std::string vtkDGGFastMarchingDistance::GetMemoryRemedy() const
{
  return this->Superclass::GetMemoryRemedy() + ", or on a cloud a smaller Resolution";
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::CheckProperties() const
{
  const double radius = this->BandRadius;
  if (radius != 0.0 && !(radius >= LeastRadius && radius <= LargestRadius))
  {
    return dgg::InvalidInput("BandRadius is ", radius, ": call SetBandRadius() with voxels in [",
      LeastRadius, ", ", LargestRadius, "], or with 0 for an automatic one");
  }
  if (this->Resolution < 0 || this->Resolution > dgg::LargestResolution)
  {
    return dgg::InvalidInput("Resolution is ", this->Resolution,
      ": call SetResolution() with at most ", dgg::LargestResolution,
      ", or with 0 for an automatic one");
  }
  return this->Superclass::CheckProperties();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::ComputeDistances(DGGDistanceTask& task)
{
  return task.Context.Surface.IsCloud() ? this->MarchOnCloud(task) : this->MarchOnMesh(task);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::MarchOnMesh(DGGDistanceTask& task)
{
  dgg::MarchingOptions options;
  options.Update =
    this->FrontShape == Planar ? dgg::MarchingUpdate::Planar : dgg::MarchingUpdate::Spherical;
  options.MaximumDistance = task.MaximumDistance;
  options.WantVirtualSource = task.WantVirtualSource;
  options.Progress = task.Context.Progress;

  const dgg::PreparedSurface& mesh = task.Context.Surface;
  if (!this->Prepared || this->Prepared->MeshBuild != mesh.GetBuildNumber())
  {
    this->Prepared.reset(); // release before the next is allocated
    auto solver = std::make_unique<dgg::FastMarching>(mesh.GetMesh());
    this->Prepared.reset(
      new Preparation{ mesh.GetBuildNumber(), std::move(solver), nullptr, 0.0, 0 });
  }
  this->QualityWarning =
    this->WarnAboutQuality(DGGDescribeLongTriangles(mesh, DGGLongTrianglesMislead));
  dgg::MarchingResult result;
  const dgg::Status status = this->Prepared->Solver->Run(task.Sources, options, result);
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  task.VirtualSource = std::move(result.Virtual);
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::MarchOnCloud(DGGDistanceTask& task)
{
  const DGGContext& context = task.Context;
  const bool isKept = this->Prepared &&
    this->Prepared->MeshBuild == context.Surface.GetBuildNumber() &&
    this->Prepared->BandRadius == this->BandRadius &&
    this->Prepared->Resolution == this->Resolution;
  this->QualityWarning = false;
  if (!isKept)
  {
    this->Prepared.reset();
    dgg::BandOptions options;
    options.OffsetInVoxels = this->BandRadius;
    options.Resolution = this->Resolution;
    auto marching = std::make_unique<DGGCloudMarching>();
    DGG_RETURN_IF_ERROR(
      marching->Prepare(context, options, dgg::ProgressPart(context.Progress, 0.0, BandShare)));
    this->Prepared.reset(new Preparation{ context.Surface.GetBuildNumber(), nullptr,
      std::move(marching), this->BandRadius, this->Resolution });
  }
  return this->Prepared->OnCloud->Run(
    task, dgg::ProgressPart(context.Progress, isKept ? 0.0 : BandShare, 1.0));
}
