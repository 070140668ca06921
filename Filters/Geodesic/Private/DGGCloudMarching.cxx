// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGCloudMarching.h"

#include "DGGDistanceInternals.h"

#include "dggBlockLoop.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkOctreePointLocator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{
using dgg::Id;
using dgg::Point3;

/// Bytes per point, without the band: positions, search structures for neighbors and spacings,
/// results.
constexpr double BytesPerPoint = 240.0;
constexpr dgg::Offset PointsPerTask = 1024;
/// Progress at the end of steps of the preparation.
constexpr double EndOfNodes = 0.1;
constexpr double EndOfSpacings = 0.5;

/// Finds the spacing of each point in the same manner as vtkPointCloudDGG.
class SpacingFinder
{
public:
  explicit SpacingFinder(const std::vector<Point3>& places)
    : Places(places)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      points->SetPoint(static_cast<vtkIdType>(i), places[i].X, places[i].Y, places[i].Z);
    }
    this->Cloud->SetPoints(points);
    this->Locator->SetDataSet(this->Cloud);
    this->Locator->BuildLocator();
  }

  dgg::Status Find(const dgg::ParallelFor& parallel, const dgg::ProgressCallback& progress,
    std::vector<float>& spacings) const
  {
    const auto n = static_cast<dgg::Offset>(this->Places.size());
    std::vector<float> raw(this->Places.size());
    DGG_RETURN_IF_ERROR(dgg::ForBlocks(
      n, PointsPerTask, parallel, dgg::ProgressPart(progress, 0.0, 0.5), [] { return Close(); },
      [&](Close& close, dgg::Offset, dgg::Offset begin, dgg::Offset end) {
        for (dgg::Offset i = begin; i < end; ++i)
        {
          this->FindClosest(i, close);
          raw[i] = static_cast<float>(
            dgg::SpacingFrom(close.SquaredDistances.back(), close.SquaredDistances.size() - 1));
        }
      }));
    spacings.resize(raw.size());
    return dgg::ForBlocks(
      n, PointsPerTask, parallel, dgg::ProgressPart(progress, 0.5, 1.0), [] { return Close(); },
      [&](Close& close, dgg::Offset, dgg::Offset begin, dgg::Offset end) {
        std::vector<float> around;
        for (dgg::Offset i = begin; i < end; ++i)
        {
          this->FindClosest(i, close);
          around.clear();
          for (vtkIdType j = 0; j < close.Ids->GetNumberOfIds(); ++j)
          {
            around.push_back(raw[close.Ids->GetId(j)]);
          }
          spacings[i] = dgg::SmoothSpacing(raw[i], close.SquaredDistances, around);
        }
      });
  }

private:
  struct Close
  {
    vtkSmartPointer<vtkIdList> Ids = vtkSmartPointer<vtkIdList>::New();
    std::vector<double> SquaredDistances; // ascending
  };

  /// Finds the points closest to point i, including point i.
  void FindClosest(dgg::Offset i, Close& close) const
  {
    const Point3& p = this->Places[i];
    const double place[3] = { p.X, p.Y, p.Z };
    const std::size_t count = std::min(dgg::SpacingNeighbors + 1, this->Places.size());
    this->Locator->FindClosestNPoints(static_cast<int>(count), place, close.Ids);
    close.SquaredDistances.clear();
    for (vtkIdType j = 0; j < close.Ids->GetNumberOfIds(); ++j)
    {
      const Point3 way = this->Places[close.Ids->GetId(j)] - p;
      close.SquaredDistances.push_back(dgg::Dot(way, way));
    }
    std::sort(close.SquaredDistances.begin(), close.SquaredDistances.end());
  }

  const std::vector<Point3>& Places;
  vtkNew<vtkPolyData> Cloud;
  vtkNew<vtkOctreePointLocator> Locator; // adapts to the density
};

Point3 OffsetOf(const dgg::SurfacePoint& point)
{
  return point.On == dgg::SurfacePoint::Support::Near
    ? Point3{ point.Barycentric[0], point.Barycentric[1], point.Barycentric[2] }
    : Point3();
}
}

//------------------------------------------------------------------------------
dgg::Status DGGCloudMarching::Prepare(
  const DGGContext& context, const dgg::BandOptions& options, const dgg::ProgressCallback& progress)
{
  const dgg::PreparedSurface& cloud = context.Surface;
  const Id n = cloud.GetMeshWithoutAngles().GetNumberOfVertices();
  const double bytes = BytesPerPoint * n;
  DGG_RETURN_IF_ERROR(context.Memory.Check("Fast marching on points", bytes, "Use fewer points"));
  DGG_RETURN_IF_ERROR(dgg::FindNodes(cloud.GetPositions(), n, this->Nodes, this->Places));
  this->NumberPlaces(n);
  DGG_RETURN_IF_ERROR(dgg::ReportTo(progress, EndOfNodes));
  if (this->Places.empty())
  {
    return dgg::Status::Success();
  }
  std::vector<float> spacings;
  DGG_RETURN_IF_ERROR(
    SpacingFinder(this->Places)
      .Find(context.Parallel, dgg::ProgressPart(progress, EndOfNodes, EndOfSpacings), spacings));
  dgg::BandSizes sizes;
  DGG_RETURN_IF_ERROR(dgg::ChooseBandSizes(this->Nodes, this->Places, spacings, options, sizes));
  // Leaves memory for the march.
  const double ofBand = dgg::VoxelBand::PredictMemory(1.0);
  const double share = ofBand / (ofBand + dgg::BandMarching::PredictMemory(1.0));
  const auto limit = context.Memory.GetBytes();
  const dgg::Status status = this->Band.Build(this->Places, sizes.Radii, sizes.VoxelSize,
    static_cast<std::size_t>(std::max(1.0, share * (limit - bytes))), context.Parallel,
    dgg::ProgressPart(progress, EndOfSpacings, 1.0), "Use a smaller {Resolution} or {BandRadius}");
  if (this->Band.IsTooLarge())
  {
    return dgg::Status(dgg::Status::Code::OutOfMemory,
      dgg::JoinText("A band of voxels of size ", sizes.VoxelSize / this->Nodes.Scale,
        " needs more memory than the limit of ", dgg::FormatBytes(limit)))
      .At("MemoryLimit")
      .Fix("Use a smaller {Resolution} or {BandRadius}, or raise {MemoryLimit}");
  }
  DGG_RETURN_IF_ERROR(status);
  if (!dgg::BandMarching::CanMarchIn(this->Band))
  {
    return dgg::InvalidInput("The band has too many voxels for a march")
      .Fix("Use a smaller {Resolution} or {BandRadius}");
  }
  this->Marching = std::make_unique<dgg::BandMarching>(this->Band);
  this->BandRadius = sizes.MedianRadius;
  this->Resolution = sizes.Resolution;
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGCloudMarching::NumberPlaces(Id numberOfPoints)
{
  this->PlaceOf.assign(static_cast<std::size_t>(numberOfPoints), dgg::NoId);
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

//------------------------------------------------------------------------------
dgg::Status DGGCloudMarching::Run(
  DGGDistanceTask& task, const dgg::ProgressCallback& progress) const
{
  DGG_RETURN_IF_ERROR(task.Context.Memory.Check("Fast marching",
    dgg::BandMarching::PredictMemory(static_cast<double>(this->Band.GetNumberOfBricks())),
    "Use a smaller {Resolution} or {BandRadius}"));
  const double scale = this->Nodes.Scale;
  std::vector<dgg::BandSource> sources;
  std::vector<Id> numbers; // index per source of the band: its source of the task
  for (std::size_t k = 0; k < task.Sources.size(); ++k)
  {
    const dgg::GeodesicSource& source = task.Sources[k];
    const Id place = this->PlaceOf[source.Point.Vertex];
    if (place == dgg::NoId || static_cast<std::size_t>(place) >= this->Places.size())
    {
      continue;
    }
    const Point3 offset = scale * OffsetOf(source.Point);
    const double start = scale * source.InitialDistance;
    const Point3& closest = this->Places[place];
    sources.push_back(this->Marching->IsNear(closest + offset)
        ? dgg::BandSource{ closest + offset, start }
        : dgg::BandSource{ closest, start + dgg::Norm(offset) });
    numbers.push_back(static_cast<Id>(k));
  }
  dgg::BandMarchingResult result;
  if (!sources.empty())
  {
    dgg::BandMarchingOptions options;
    options.MaximumDistance = scale * task.MaximumDistance;
    options.Progress = progress;
    DGG_RETURN_IF_ERROR(this->Marching->Run(sources, this->Places, options, result));
  }
  const std::size_t count = this->Nodes.Originals.size() + this->Nodes.Outliers.size();
  result.Distances.resize(count, dgg::Infinity);
  result.NearestSource.resize(count, dgg::NoId);
  task.Distances.assign(this->PlaceOf.size(), dgg::Infinity);
  task.NearestSource.assign(this->PlaceOf.size(), dgg::NoId);
  for (std::size_t i = 0; i < count; ++i)
  {
    result.Distances[i] /= scale;
    Id& nearest = result.NearestSource[i];
    nearest = nearest == dgg::NoId ? dgg::NoId : numbers[nearest];
  }
  // The distance of the point at or closest to a source is at most the initial distance of the
  // source plus their straight distance.
  for (std::size_t k = 0; k < task.Sources.size(); ++k)
  {
    const Id point = task.Sources[k].Point.Vertex;
    const Id place = this->PlaceOf[point];
    double& distance = place == dgg::NoId ? task.Distances[point] : result.Distances[place];
    Id& nearest = place == dgg::NoId ? task.NearestSource[point] : result.NearestSource[place];
    const double start =
      task.Sources[k].InitialDistance + dgg::Norm(OffsetOf(task.Sources[k].Point));
    if (start < distance)
    {
      distance = start;
      nearest = static_cast<Id>(k);
    }
  }
  for (std::size_t i = 0; i < this->PlaceOf.size(); ++i)
  {
    if (this->PlaceOf[i] != dgg::NoId)
    {
      task.Distances[i] = result.Distances[this->PlaceOf[i]];
      task.NearestSource[i] = result.NearestSource[this->PlaceOf[i]];
    }
  }
  return dgg::Status::Success();
}
