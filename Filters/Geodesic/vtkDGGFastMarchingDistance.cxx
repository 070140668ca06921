// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGFastMarchingDistance.h"

#include "DGGDistanceInternals.h"

#include "dggCloudMarching.h"
#include "dggFastMarching.h"
#include "dggMeshQuality.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <memory>
#include <utility>

vtkStandardNewMacro(vtkDGGFastMarchingDistance);

namespace
{
constexpr double LeastRadius = 0.5;
constexpr double LargestRadius = 1000.0;
/// Progress weight of building a band.
constexpr double BandShare = 0.4;
}

//------------------------------------------------------------------------------
class vtkDGGFastMarchingDistance::vtkInternals
  : public DGGInternalsOf<vtkDGGFastMarchingDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override
  {
    return DGGDistanceInternals::GetMemoryRemedy() + ", or on a cloud a smaller {Resolution}";
  }
  void ForgetResults() override;
  dgg::Status ComputeDistances(DGGDistanceTask& task) override;

  ///@{
  /// Median radius of balls, in voxels, and resolution of the band of the last update.
  double UsedBandRadius = 0.0;
  int UsedResolution = 0;
  ///@}

private:
  /// Solver that is kept until the mesh changes, or the band of a cloud.
  struct Preparation
  {
    std::uint64_t MeshBuild;
    std::unique_ptr<dgg::FastMarching> Solver;
    std::unique_ptr<dgg::CloudMarching> OnCloud; // used instead of Solver for clouds
    double BandRadius;                           // as requested
    int Resolution;
  };

  dgg::Status MarchOnMesh(DGGDistanceTask& task);
  dgg::Status MarchOnCloud(DGGDistanceTask& task);

  std::unique_ptr<Preparation> Prepared;
};

vtkDGGInternalsMacro(vtkDGGFastMarchingDistance);

//------------------------------------------------------------------------------
vtkDGGFastMarchingDistance::vtkDGGFastMarchingDistance()
  : FrontShape(Spherical)
  , BandRadius(0.0)
  , Resolution(0)
  , QualityWarning(false)
{
  this->Internals.reset(new vtkInternals(this));
}

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
  return this->GetInternals().UsedBandRadius;
}

//------------------------------------------------------------------------------
int vtkDGGFastMarchingDistance::GetUsedResolution() const
{
  return this->GetInternals().UsedResolution;
}

//------------------------------------------------------------------------------
bool vtkDGGFastMarchingDistance::vtkInternals::IsCloud(vtkPolyData* input) const
{
  return input->GetNumberOfPoints() > 0 &&
    input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::vtkInternals::CheckProperties() const
{
  const double radius = this->Self->BandRadius;
  if (radius != 0.0 && !(radius >= LeastRadius && radius <= LargestRadius))
  {
    return dgg::InvalidValue("BandRadius", radius)
      .Fix("Use a number of voxels from ", LeastRadius, " to ", LargestRadius,
        ", or 0 for an automatic one");
  }
  if (this->Self->Resolution < 0 || this->Self->Resolution > dgg::LargestResolution)
  {
    return dgg::InvalidValue("Resolution", this->Self->Resolution)
      .Fix("Use a number of at most ", dgg::LargestResolution, ", or 0 for an automatic one");
  }
  return DGGDistanceInternals::CheckProperties();
}

//------------------------------------------------------------------------------
void vtkDGGFastMarchingDistance::vtkInternals::ForgetResults()
{
  this->Self->QualityWarning = false;
  this->UsedBandRadius = 0.0;
  this->UsedResolution = 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::vtkInternals::ComputeDistances(DGGDistanceTask& task)
{
  return task.Context.Surface.IsCloud() ? this->MarchOnCloud(task) : this->MarchOnMesh(task);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::vtkInternals::MarchOnMesh(DGGDistanceTask& task)
{
  dgg::MarchingOptions options;
  options.Update =
    this->Self->FrontShape == Planar ? dgg::MarchingUpdate::Planar : dgg::MarchingUpdate::Spherical;
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
  this->Self->QualityWarning =
    this->WarnAboutQuality(dgg::DescribeLongTriangles(mesh, dgg::LongTrianglesMislead));
  dgg::MarchingResult result;
  const dgg::Status status = this->Prepared->Solver->Run(task.Sources, options, result);
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  task.VirtualSource = std::move(result.Virtual);
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::vtkInternals::MarchOnCloud(DGGDistanceTask& task)
{
  const DGGContext& context = task.Context;
  const bool isKept = this->Prepared &&
    this->Prepared->MeshBuild == context.Surface.GetBuildNumber() &&
    this->Prepared->BandRadius == this->Self->BandRadius &&
    this->Prepared->Resolution == this->Self->Resolution;
  if (!isKept)
  {
    this->Prepared.reset();
    dgg::BandOptions options;
    options.OffsetInVoxels = this->Self->BandRadius;
    options.Resolution = this->Self->Resolution;
    auto marching = std::make_unique<dgg::CloudMarching>();
    DGG_RETURN_IF_ERROR(
      marching->Prepare(context, options, dgg::ProgressPart(context.Progress, 0.0, BandShare)));
    this->Prepared.reset(new Preparation{ context.Surface.GetBuildNumber(), nullptr,
      std::move(marching), this->Self->BandRadius, this->Self->Resolution });
  }
  const dgg::CloudMarching& marching = *this->Prepared->OnCloud;
  dgg::MarchingResult result;
  DGG_RETURN_IF_ERROR(marching.Run(context, task.Sources, task.MaximumDistance,
    dgg::ProgressPart(context.Progress, isKept ? 0.0 : BandShare, 1.0), result));
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  this->UsedBandRadius = marching.GetBandRadius();
  this->UsedResolution = marching.GetResolution();
  return dgg::Status::Success();
}
