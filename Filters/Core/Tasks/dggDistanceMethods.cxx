// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggDistanceMethods.h"

#include "dggCloudMarching.h"
#include "dggCounted.h"
#include "dggDistanceOutput.h"
#include "dggExactGeodesics.h"
#include "dggFastMarching.h"
#include "dggMeshQuality.h"
#include "dggProgressPart.h"
#include "dggSourceFinding.h"
#include "dggSurfacePath.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace dgg
{
namespace
{
///@{
/// Progress after factorization, and after a band is built.
constexpr double FactorizedAt = 0.9;
constexpr double BandBuiltAt = 0.4;
///@}

///@{
/// Range of the radius of balls in a band, in voxels.
constexpr double LeastRadius = 0.5;
constexpr double LargestRadius = 1000.0;
///@}

constexpr Offset VerticesPerBlock = 4096;
/// Largest number of sources whose straight lines bound propagated distances, and tolerance at the
/// maximum distance in mean edges.
constexpr std::size_t MostStraightSources = 8;
constexpr double DistanceSlack = 1e-6;

/// Moves distances and their sources to a task.
template <typename Result>
void TakeResults(Result& result, DistanceTask& task)
{
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
}

/// Moves all results to a task.
template <typename Result>
void TakeAllResults(Result& result, DistanceTask& task)
{
  TakeResults(result, task);
  task.VirtualSource = std::move(result.Virtual);
}

/// Returns the reasons why distances of the heat method may be far off; empty if there are none.
std::string DescribeHeatQuality(const PreparedSurface& surface, double factor, Id triangles)
{
  return JoinReasons({ DescribeLongTriangles(surface, LongTrianglesMislead),
    triangles < FewestUsefulTriangles
      ? JoinText("A source is on a component of ", Counted(triangles, "triangle"), ", fewer than ",
          FewestUsefulTriangles,
          ", where mean errors are 10 % or more. Use exact distances, or subdivide the triangles")
      : "",
    factor < SmallestUsefulFactor || factor > LargestUsefulFactor
      ? JoinText("{TimeStepFactor} is ", factor, ", outside of ", SmallestUsefulFactor, " to ",
          LargestUsefulFactor, ", where mean errors are below 10 %. Use a number around 1")
      : "" });
}
}

//------------------------------------------------------------------------------
Status FindExactDistances(
  const TaskContext& context, ExactEngine engine, bool keepWindows, DistanceTask& task)
{
  const SurfaceMesh& mesh = context.Surface.GetMesh();
  ExactOptions options;
  options.Engine = engine;
  options.KeepWindows = keepWindows;
  options.MaximumDistance = task.MaximumDistance;
  options.Progress = context.Progress;
  if (keepWindows)
  {
    // At least 1, because 0 would mean no limit; 2^63 is one.
    options.MemoryLimit =
      static_cast<std::size_t>(std::clamp(context.Memory.GetBytes(), 1.0, 0x1p63));
  }
  ExactResult result;
  DGG_RETURN_IF_ERROR(ExactGeodesics(mesh).Run(task.Sources, options, result));
  if (task.WantVirtualSource)
  {
    FindVirtualSources(mesh, task.Sources, result, task.VirtualSource, context.Parallel);
  }
  task.Windows = std::move(result.Windows);
  TakeResults(result, task);
  return Status::Success();
}

//------------------------------------------------------------------------------
void KeepAboveStraightLine(const TaskContext& context, const std::vector<PlacedSource>& sources,
  double unit, double maximum, PropagationResult& result)
{
  if (sources.size() > MostStraightSources)
  {
    return;
  }
  const double* positions = context.Surface.GetPositions();
  const auto straightLine = [&](Offset v) {
    const double* p = positions + 3 * v;
    double least = Infinity;
    for (std::size_t k = 0; k < sources.size(); ++k)
    {
      const double x = (p[0] - sources[k].Position[0]) / unit;
      const double y = (p[1] - sources[k].Position[1]) / unit;
      const double z = (p[2] - sources[k].Position[2]) / unit;
      const double length = unit * std::sqrt(x * x + y * y + z * z);
      least = std::min(least, sources[k].InitialDistance + length);
    }
    return least;
  };
  const auto size = static_cast<Offset>(result.Distances.size());
  ForRange(context.Parallel, size, VerticesPerBlock, [&](Offset begin, Offset end) {
    for (Offset v = begin; v < end; ++v)
    {
      const double straight = straightLine(v);
      const double raise = straight - result.Distances[v];
      if (!(raise > 0.0))
      {
        continue;
      }
      // Rounding must not move a vertex beyond the maximum distance.
      const bool isReached = straight <= maximum + DistanceSlack * unit;
      result.Distances[v] = isReached ? std::min(straight, maximum) : Infinity;
      if (!result.NearestSource.empty() && !isReached)
      {
        result.NearestSource[v] = NoId;
      }
      if (!result.Virtual.empty())
      {
        result.Virtual[v].Offset = result.Distances[v] - result.Virtual[v].Length;
      }
    }
  });
}

//------------------------------------------------------------------------------
Status FindPropagatedDistances(const TaskContext& context, PropagationSession& session,
  std::optional<PropagationQuality> quality, DistanceTask& task)
{
  PropagationOptions options;
  options.Quality = quality ? *quality : PropagationSession::Choose(context.Surface);
  options.MaximumDistance = task.MaximumDistance;
  options.WantNearestSource = task.WantNearestSource;
  options.WantVirtualSource = task.WantVirtualSource;
  PropagationResult result;
  DGG_RETURN_IF_ERROR(session.Run(context, task.Sources, options, result));
  const SurfaceMesh& mesh = context.Surface.GetMeshWithoutAngles();
  std::vector<PlacedSource> sources;
  for (const GeodesicSource& source : task.Sources)
  {
    sources.push_back(
      { source.InitialDistance, PositionOf(mesh, source.Point, context.Surface.GetPositions()) });
  }
  KeepAboveStraightLine(
    context, sources, mesh.GetMeanEdgeLength(), options.MaximumDistance, result);
  task.QualityWarning = JoinReasons({ DescribeLongTriangles(context.Surface, LongTrianglesMislead),
    result.IsSettled ? "" : UnsettledDistances });
  TakeAllResults(result, task);
  return Status::Success();
}

//------------------------------------------------------------------------------
Status HeatSession::Run(const TaskContext& context, const HeatOptions& options,
  const std::string& remedy, DistanceTask& task)
{
  if (!this->Method || this->MeshBuild != context.Surface.GetBuildNumber())
  {
    this->EarlierFactorizations = this->GetNumberOfFactorizations();
    this->Method.reset(); // release before the next is allocated
    this->Method = std::make_unique<HeatMethod>(context.Surface.GetMesh());
    this->MeshBuild = context.Surface.GetBuildNumber();
  }
  bool isTooMuch = false;
  const Status status = this->Method->Prepare(
    options, ProgressPart(context.Progress, 0.0, FactorizedAt), [&](double bytes) {
      const Status check = context.Memory.Check("The heat method", bytes, remedy);
      isTooMuch = !check.IsOk();
      return check;
    });
  if (isTooMuch && this->Method->GetNumberOfFactorizations() == 0)
  {
    this->Method.reset(); // no factorization exists yet
  }
  DGG_RETURN_IF_ERROR(status);
  HeatQuery query;
  query.MaximumDistance = task.MaximumDistance;
  query.WantNearestSource = task.WantNearestSource;
  query.WantVirtualSource = task.WantVirtualSource;
  query.Progress = ProgressPart(context.Progress, FactorizedAt, 1.0);
  HeatResult result;
  DGG_RETURN_IF_ERROR(this->Method->Run(task.Sources, query, result));
  task.QualityWarning =
    DescribeHeatQuality(context.Surface, options.TimeStepFactor, result.FewestTriangles);
  TakeAllResults(result, task);
  return Status::Success();
}

//------------------------------------------------------------------------------
int HeatSession::GetNumberOfFactorizations() const
{
  return this->EarlierFactorizations +
    (this->Method ? this->Method->GetNumberOfFactorizations() : 0);
}

//------------------------------------------------------------------------------
MarchingSession::MarchingSession() = default;
MarchingSession::~MarchingSession() = default;

//------------------------------------------------------------------------------
Status MarchingSession::Check(const BandOptions& band)
{
  const double radius = band.OffsetInVoxels;
  if (radius != 0.0 && !(radius >= LeastRadius && radius <= LargestRadius))
  {
    return InvalidValue("BandRadius", radius)
      .Fix("Use a number of voxels from ", LeastRadius, " to ", LargestRadius,
        ", or 0 for an automatic one");
  }
  if (band.Resolution < 0 || band.Resolution > LargestResolution)
  {
    return InvalidValue("Resolution", band.Resolution)
      .Fix("Use a number of at most ", LargestResolution, ", or 0 for an automatic one");
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status MarchingSession::Run(
  const TaskContext& context, MarchingUpdate update, const BandOptions& band, DistanceTask& task)
{
  DGG_RETURN_IF_ERROR(Check(band));
  return context.Surface.IsCloud() ? this->MarchOnCloud(context, band, task)
                                   : this->MarchOnMesh(context, update, task);
}

//------------------------------------------------------------------------------
double MarchingSession::GetBandRadius() const
{
  return this->OnCloud ? this->OnCloud->GetBandRadius() : 0.0;
}

//------------------------------------------------------------------------------
Id MarchingSession::GetResolution() const
{
  return this->OnCloud ? this->OnCloud->GetResolution() : 0;
}

//------------------------------------------------------------------------------
Status MarchingSession::MarchOnMesh(
  const TaskContext& context, MarchingUpdate update, DistanceTask& task)
{
  MarchingOptions options;
  options.Update = update;
  options.MaximumDistance = task.MaximumDistance;
  options.WantVirtualSource = task.WantVirtualSource;
  options.Progress = context.Progress;
  if (!this->OnMesh || this->MeshBuild != context.Surface.GetBuildNumber())
  {
    this->OnCloud.reset();
    this->OnMesh.reset(); // release before the next is allocated
    this->OnMesh = std::make_unique<FastMarching>(context.Surface.GetMesh());
    this->MeshBuild = context.Surface.GetBuildNumber();
  }
  task.QualityWarning = DescribeLongTriangles(context.Surface, LongTrianglesMislead);
  MarchingResult result;
  DGG_RETURN_IF_ERROR(this->OnMesh->Run(task.Sources, options, result));
  TakeAllResults(result, task);
  return Status::Success();
}

//------------------------------------------------------------------------------
Status MarchingSession::MarchOnCloud(
  const TaskContext& context, const BandOptions& band, DistanceTask& task)
{
  const bool isKept = this->OnCloud && this->MeshBuild == context.Surface.GetBuildNumber() &&
    this->Band.OffsetInVoxels == band.OffsetInVoxels && this->Band.Resolution == band.Resolution;
  if (!isKept)
  {
    this->OnMesh.reset();
    this->OnCloud.reset();
    auto marching = std::make_unique<CloudMarching>();
    DGG_RETURN_IF_ERROR(
      marching->Prepare(context, band, ProgressPart(context.Progress, 0.0, BandBuiltAt)));
    this->OnCloud = std::move(marching);
    this->Band = band;
    this->MeshBuild = context.Surface.GetBuildNumber();
  }
  MarchingResult result;
  DGG_RETURN_IF_ERROR(this->OnCloud->Run(context, task.Sources, task.MaximumDistance,
    ProgressPart(context.Progress, isKept ? 0.0 : BandBuiltAt, 1.0), result));
  TakeResults(result, task);
  return Status::Success();
}
}
