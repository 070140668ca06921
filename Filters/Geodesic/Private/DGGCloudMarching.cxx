// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGCloudMarching.h"

#include "DGGDistanceTask.h"
#include "DGGFreeMemory.h"

#include "dggInvalidInput.h"
#include "dggMemoryLimit.h"
#include "dggProgressPart.h"
#include "dggQuantile.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>

namespace
{
using dgg::Id;
using dgg::Point3;

/// Bytes per point, besides the band: places, what finds neighbours and spacings, results.
constexpr double BytesPerPoint = 240.0;
constexpr dgg::Offset PointsPerTask = 1024;
/// Shares of the progress of the preparation.
constexpr double EndOfNodes = 0.1;
constexpr double EndOfSpacings = 0.5;

/// The spacing of each point, as vtkPointCloudDGG finds it.
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

  std::vector<float> Find(const dgg::ParallelFor& parallel)
  {
    const std::size_t n = this->Places.size();
    const auto k = std::min(dgg::SpacingNeighbors, n - 1);
    const auto size = static_cast<dgg::Offset>(n);
    std::vector<float> raw(n);
    dgg::ForRange(parallel, size, PointsPerTask, [&](dgg::Offset begin, dgg::Offset end) {
      vtkNew<vtkIdList> close;
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        raw[i] = static_cast<float>(dgg::SpacingFrom(this->FindClosest(i, k, close), k));
      }
    });
    std::vector<float> spacings(n);
    dgg::ForRange(parallel, size, PointsPerTask, [&](dgg::Offset begin, dgg::Offset end) {
      vtkNew<vtkIdList> close;
      std::vector<float> around;
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        // Which of several points are the last ones does not matter: those before them count.
        const double last = this->FindClosest(i, k, close);
        around = { raw[i] };
        for (vtkIdType j = 0; j < close->GetNumberOfIds(); ++j)
        {
          const auto other = static_cast<std::size_t>(close->GetId(j));
          if (other != i && this->SquaredDistance(i, other) < last)
          {
            around.push_back(raw[other]);
          }
        }
        spacings[i] = dgg::SmoothSpacing(raw[i], around);
      }
    });
    return spacings;
  }

private:
  double SquaredDistance(std::size_t i, std::size_t j) const
  {
    const Point3 way = this->Places[j] - this->Places[i];
    return dgg::Dot(way, way);
  }

  /// The point and its k nearest; the squared distance of the last one.
  double FindClosest(std::size_t i, std::size_t k, vtkIdList* close) const
  {
    const Point3& p = this->Places[i];
    const double place[3] = { p.X, p.Y, p.Z };
    this->Locator->FindClosestNPoints(static_cast<int>(k) + 1, place, close);
    double last = 0.0;
    for (vtkIdType j = 0; j < close->GetNumberOfIds(); ++j)
    {
      last = std::max(last, this->SquaredDistance(i, static_cast<std::size_t>(close->GetId(j))));
    }
    return last;
  }

  const std::vector<Point3>& Places;
  vtkNew<vtkPolyData> Cloud;
  vtkNew<vtkStaticPointLocator> Locator;
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
  const DGGPreparedMesh& cloud = context.Surface;
  const Id n = cloud.GetMeshWithoutAngles().GetNumberOfVertices();
  const double bytes = BytesPerPoint * n;
  DGG_RETURN_IF_ERROR(DGGCheckMemory(
    "what has to be known of the points", bytes, context.MemoryLimit, "use fewer points"));
  DGG_RETURN_IF_ERROR(dgg::FindNodes(cloud.GetPositions(), n, this->Nodes, this->Places));
  this->NumberPlaces(n);
  DGG_RETURN_IF_ERROR(dgg::ReportTo(progress, EndOfNodes));
  if (this->Places.empty())
  {
    return dgg::Status::Success();
  }
  const std::vector<float> spacings = SpacingFinder(this->Places).Find(context.Parallel);
  DGG_RETURN_IF_ERROR(dgg::ReportTo(progress, EndOfSpacings));
  dgg::BandSizes sizes;
  DGG_RETURN_IF_ERROR(dgg::ChooseBandSizes(this->Nodes, this->Places, spacings, options, sizes));
  // With room for the march.
  const double ofBand = dgg::VoxelBand::PredictMemory(1.0);
  const double share = ofBand / (ofBand + dgg::BandMarching::PredictMemory(1.0));
  const auto limit = static_cast<double>(DGGGetMemoryLimit(context.MemoryLimit));
  const dgg::Status status = this->Band.Build(this->Places, sizes.Radii, sizes.VoxelSize,
    static_cast<std::size_t>(std::max(1.0, share * (limit - bytes))), context.Parallel,
    dgg::ProgressPart(progress, EndOfSpacings, 1.0), "use a smaller Resolution");
  if (this->Band.IsTooLarge())
  {
    return dgg::InvalidInput("marching in a band of voxels, each of size ",
      sizes.VoxelSize / this->Nodes.Scale, ", would take more than the limit of ",
      dgg::FormatBytes(limit), ": use a smaller Resolution, or set a higher MemoryLimit");
  }
  DGG_RETURN_IF_ERROR(status);
  this->Marching = std::make_unique<dgg::BandMarching>(this->Band);
  this->BandRadius = dgg::Quantile(sizes.Radii, 0.5) / sizes.VoxelSize;
  // A hair less, so that rounding does not make one more of those that are asked for.
  this->Resolution =
    static_cast<Id>(std::ceil((1.0 - 1e-12) * this->Nodes.Extent / sizes.VoxelSize));
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
  const double scale = this->Nodes.Scale;
  std::vector<dgg::BandSource> sources;
  std::vector<Id> numbers; // of these
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
  // The point that a source is at, or beside, is no farther than that.
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
