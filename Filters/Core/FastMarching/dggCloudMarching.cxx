// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudMarching.h"

#include "dggBlockLoop.h"
#include "dggCloudNeighbors.h"
#include "dggFastMarching.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggTaskContext.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Bytes per point, without the band: positions, search structures for neighbors and spacings,
/// results.
constexpr double BytesPerPoint = 240.0;
constexpr Offset PointsPerTask = 1024;
/// Progress at the end of steps of the preparation.
constexpr double EndOfNodes = 0.1;
constexpr double EndOfSpacings = 0.5;

/// Finds the spacing of each point in the same manner as the builder of cloud graphs.
Status FindSpacings(const std::vector<Point3>& places, const ParallelFor& parallel,
  const ProgressCallback& progress, std::vector<float>& spacings)
{
  const CloudNeighbors tree(places);
  const auto n = static_cast<Offset>(places.size());
  const auto forAll = [&](const ProgressCallback& part, const auto& find) {
    using Neighbors = std::vector<CloudNeighbor>;
    return ForBlocks(
      n, PointsPerTask, parallel, part, [] { return Neighbors(); },
      [&](Neighbors& neighbors, Offset, Offset begin, Offset end) {
        for (Offset i = begin; i < end; ++i)
        {
          tree.FindNearest(places[i], SpacingNeighbors + 1, neighbors);
          find(i, neighbors);
        }
      });
  };
  std::vector<float> single(places.size());
  DGG_RETURN_IF_ERROR(
    forAll(ProgressPart(progress, 0.0, 0.5), [&](Offset i, const auto& neighbors) {
      single[i] =
        static_cast<float>(SpacingFrom(neighbors.back().SquaredDistance, neighbors.size() - 1));
    }));
  spacings.resize(places.size());
  return forAll(ProgressPart(progress, 0.5, 1.0), [&](Offset i, const auto& neighbors) {
    spacings[i] = SmoothSpacing(single[i], neighbors, single);
  });
}

Point3 OffsetOf(const SurfacePoint& point)
{
  return point.On == SurfacePoint::Support::Near
    ? Point3{ point.Barycentric[0], point.Barycentric[1], point.Barycentric[2] }
    : Point3();
}
}

Status CloudMarching::Prepare(
  const TaskContext& context, const BandOptions& options, const ProgressCallback& progress)
{
  const PreparedSurface& cloud = context.Surface;
  const Id n = cloud.GetMeshWithoutAngles().GetNumberOfVertices();
  const double bytes = BytesPerPoint * n;
  DGG_RETURN_IF_ERROR(context.Memory.Check("Fast marching on points", bytes, "Use fewer points"));
  DGG_RETURN_IF_ERROR(FindNodes(cloud.GetPositions(), n, this->Nodes, this->Places));
  this->NumberPlaces(n);
  DGG_RETURN_IF_ERROR(ReportTo(progress, EndOfNodes));
  if (this->Places.empty())
  {
    return Status::Success();
  }
  std::vector<float> spacings;
  DGG_RETURN_IF_ERROR(FindSpacings(
    this->Places, context.Parallel, ProgressPart(progress, EndOfNodes, EndOfSpacings), spacings));
  BandSizes sizes;
  DGG_RETURN_IF_ERROR(ChooseBandSizes(this->Nodes, this->Places, spacings, options, sizes));
  // Leaves memory for the march.
  const double ofBand = VoxelBand::PredictMemory(1.0);
  const double share = ofBand / (ofBand + BandMarching::PredictMemory(1.0));
  const auto limit = context.Memory.GetBytes();
  const Status status = this->Band.Build(this->Places, sizes.Radii, sizes.VoxelSize,
    static_cast<std::size_t>(std::max(1.0, share * (limit - bytes))), context.Parallel,
    ProgressPart(progress, EndOfSpacings, 1.0), "Use a smaller {Resolution} or {BandRadius}");
  if (this->Band.IsTooLarge())
  {
    return Status(Status::Code::OutOfMemory,
      JoinText("A band of voxels of size ", sizes.VoxelSize / this->Nodes.Scale,
        " needs more memory than the limit of ", FormatBytes(limit)))
      .At("MemoryLimit")
      .Fix("Use a smaller {Resolution} or {BandRadius}, or raise {MemoryLimit}");
  }
  DGG_RETURN_IF_ERROR(status);
  if (!BandMarching::CanMarchIn(this->Band))
  {
    return InvalidInput("The band has too many voxels for a march")
      .Fix("Use a smaller {Resolution} or {BandRadius}");
  }
  this->Marching = std::make_unique<BandMarching>(this->Band);
  this->BandRadius = sizes.MedianRadius;
  this->Resolution = sizes.Resolution;
  return Status::Success();
}

void CloudMarching::NumberPlaces(Id numberOfPoints)
{
  this->PlaceOf.assign(static_cast<std::size_t>(numberOfPoints), NoId);
  Id place = 0;
  for (const std::vector<Id>* points : { &this->Nodes.Originals, &this->Nodes.Outliers })
  {
    for (const Id point : *points)
    {
      this->PlaceOf[point] = place++;
    }
  }
  for (const auto& [copy, original] : this->Nodes.Coincident)
  {
    this->PlaceOf[copy] = this->PlaceOf[original];
  }
}

std::vector<BandSource> CloudMarching::FindStarts(
  const std::vector<GeodesicSource>& sources, std::vector<Id>& indices) const
{
  const double scale = this->Nodes.Scale;
  std::vector<BandSource> starts;
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const GeodesicSource& source = sources[k];
    const Id place = this->PlaceOf[source.Point.Vertex];
    if (place == NoId || static_cast<std::size_t>(place) >= this->Places.size())
    {
      continue;
    }
    const Point3 offset = scale * OffsetOf(source.Point);
    const double start = scale * source.InitialDistance;
    const Point3& closest = this->Places[place];
    starts.push_back(this->Marching->IsNear(closest + offset)
        ? BandSource{ closest + offset, start }
        : BandSource{ closest, start + Norm(offset) });
    indices.push_back(static_cast<Id>(k));
  }
  return starts;
}

Status CloudMarching::Run(const TaskContext& context, const std::vector<GeodesicSource>& sources,
  double maximumDistance, const ProgressCallback& progress, MarchingResult& result) const
{
  DGG_RETURN_IF_ERROR(context.Memory.Check("Fast marching",
    BandMarching::PredictMemory(static_cast<double>(this->Band.GetNumberOfBricks())),
    "Use a smaller {Resolution} or {BandRadius}"));
  const double scale = this->Nodes.Scale;
  std::vector<Id> indices;
  const std::vector<BandSource> starts = this->FindStarts(sources, indices);
  BandMarchingResult march;
  if (!starts.empty())
  {
    BandMarchingOptions options;
    options.MaximumDistance = scale * maximumDistance;
    options.Progress = progress;
    DGG_RETURN_IF_ERROR(this->Marching->Run(starts, this->Places, options, march));
  }
  const std::size_t count = this->Nodes.Originals.size() + this->Nodes.Outliers.size();
  march.Distances.resize(count, Infinity);
  march.NearestSource.resize(count, NoId);
  result.Distances.assign(this->PlaceOf.size(), Infinity);
  result.NearestSource.assign(this->PlaceOf.size(), NoId);
  for (std::size_t i = 0; i < count; ++i)
  {
    march.Distances[i] /= scale;
    Id& nearest = march.NearestSource[i];
    nearest = nearest == NoId ? NoId : indices[nearest];
  }
  // The distance of the point at or closest to a source is at most the initial distance of the
  // source plus their straight distance.
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const Id point = sources[k].Point.Vertex;
    const Id place = this->PlaceOf[point];
    double& distance = place == NoId ? result.Distances[point] : march.Distances[place];
    Id& nearest = place == NoId ? result.NearestSource[point] : march.NearestSource[place];
    const double start = sources[k].InitialDistance + Norm(OffsetOf(sources[k].Point));
    if (start < distance)
    {
      distance = start;
      nearest = static_cast<Id>(k);
    }
  }
  for (std::size_t i = 0; i < this->PlaceOf.size(); ++i)
  {
    if (this->PlaceOf[i] != NoId)
    {
      result.Distances[i] = march.Distances[this->PlaceOf[i]];
      result.NearestSource[i] = march.NearestSource[this->PlaceOf[i]];
    }
  }
  return Status::Success();
}
}
