// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBandPath.h"

#include "dggCloudFrame.h"
#include "dggLocalFit.h"
#include "dggMemoryLimit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace dgg
{
namespace
{
/// Distance between points that are put into a path, by the radius of a ball: about that of the
/// points of the cloud.
constexpr double StepByRadius = 0.6;
/// Points of the cloud that a surface is fitted to: those closer than that many radii.
constexpr double FitByRadius = 2.0;
/// How far a point moves towards the middle of its neighbours in one round.
constexpr double Damping = 0.7;
constexpr std::size_t LongestStride = 8;
constexpr int MostRounds = 200;
/// Rounds between two looks at the length, which must have dropped by that.
constexpr int RoundsPerLook = 5;
constexpr double LeastDrop = 1e-5;
constexpr int MostPointsPerGraphEdge = 1000;

double LengthOf(const std::vector<Point3>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += Norm(points[i] - points[i - 1]);
  }
  return length;
}
}

/// One path while it is moved.
class BandPathShortener::Relaxation
{
public:
  explicit Relaxation(const BandPathShortener& tables)
    : Tables(tables)
  {
  }

  void Add(const Point3& point, Id owner)
  {
    this->Points.push_back(point);
    this->Owners.push_back(owner);
  }

  /// Points between the last one and the next one, on the segment.
  void AddGraphEdge(const Point3& to, Id owner)
  {
    const Point3 from = this->Points.back();
    const Id first = this->Owners.back();
    const double radius = std::max(this->Tables.Radii[first], this->Tables.Radii[owner]);
    const double length = Norm(to - from);
    const int count = radius > 0.0 ? static_cast<int>(std::min<double>(MostPointsPerGraphEdge,
                                       std::ceil(length / (StepByRadius * radius))))
                                   : 1;
    for (int i = 1; i < count; ++i)
    {
      const double t = static_cast<double>(i) / count;
      this->Add(from + t * (to - from), t < 0.5 ? first : owner);
    }
    this->Add(to, owner);
  }

  /// Returns false when the caller asks to stop.
  bool Run(const ProgressCallback& progress)
  {
    for (std::size_t i = 1; i + 1 < this->Points.size(); ++i)
    {
      this->MoveTo(i, this->Points[i]);
    }
    std::vector<Point3> best = this->Points;
    double shortest = LengthOf(best);
    for (int round = 1; round <= MostRounds; ++round)
    {
      // Between neighbours that are far apart first: that straightens long bends, which single
      // steps would take very many rounds for.
      for (std::size_t stride = LongestStride; stride >= 1; stride /= 2)
      {
        if (progress && !progress(static_cast<double>(round) / (MostRounds + 1)))
        {
          return false;
        }
        for (std::size_t i = 1; i + 1 < this->Points.size(); ++i)
        {
          const std::size_t k = std::min({ stride, i, this->Points.size() - 1 - i });
          const Point3 middle = 0.5 * (this->Points[i - k] + this->Points[i + k]);
          this->MoveTo(i, this->Points[i] + Damping * (middle - this->Points[i]));
        }
      }
      if (round % RoundsPerLook == 0)
      {
        const double length = LengthOf(this->Points);
        if (!(length < shortest))
        {
          break;
        }
        const bool isDone = length > (1.0 - LeastDrop) * shortest;
        best = this->Points;
        shortest = length;
        if (isDone)
        {
          break;
        }
      }
    }
    this->Points.swap(best);
    return true;
  }

  std::vector<Point3> Points;

private:
  /// Move a point to the surface near a place, if that is in the band.
  void MoveTo(std::size_t i, const Point3& place)
  {
    const Id owner = this->FindOwner(this->Owners[i], place);
    this->Around.clear();
    const double radius = FitByRadius * this->Tables.Radii[owner];
    const auto add = [&](Id v) {
      const Point3 point = dgg::PointAt(this->Tables.Points, v);
      const Point3 d = point - place;
      if (Dot(d, d) <= radius * radius)
      {
        this->Around.push_back(point);
      }
    };
    add(owner);
    const GraphView& graph = this->Tables.Graph;
    for (Offset e = graph.Offsets[owner]; e < graph.Offsets[owner + 1]; ++e)
    {
      add(graph.Targets[e]);
    }
    const LocalFit fit = FitSurface(place, this->Around.data(), this->Around.size());
    Point3 moved = place + fit.ToSurface;
    if (!(Norm(fit.ToSurface) <= radius))
    {
      moved = place;
    }
    if (this->IsInBand(moved) && this->IsInBand(0.5 * (moved + this->Points[i - 1])) &&
      this->IsInBand(0.5 * (moved + this->Points[i + 1])))
    {
      this->Points[i] = moved;
      this->Owners[i] = owner;
    }
  }

  bool IsInBand(const Point3& point) const
  {
    const Point3 inGrid = this->Tables.Band.ToGrid(point);
    return this->Tables.Band.IsInBox(inGrid) &&
      this->Tables.Band.Contains(VoxelBand::VoxelOf(inGrid));
  }

  /// Walk to the point of the cloud that is nearest to a place, along edges.
  Id FindOwner(Id owner, const Point3& place) const
  {
    const GraphView& graph = this->Tables.Graph;
    double least = Norm(dgg::PointAt(this->Tables.Points, owner) - place);
    for (;;)
    {
      Id next = owner;
      for (Offset e = graph.Offsets[owner]; e < graph.Offsets[owner + 1]; ++e)
      {
        const double distance = Norm(dgg::PointAt(this->Tables.Points, graph.Targets[e]) - place);
        if (distance < least)
        {
          least = distance;
          next = graph.Targets[e];
        }
      }
      if (next == owner)
      {
        return owner;
      }
      owner = next;
    }
  }

  const BandPathShortener& Tables;
  std::vector<Id> Owners; ///< per point, the point of the cloud that is nearest
  std::vector<Point3> Around;
};

BandPathShortener::BandPathShortener(
  const double* points, const GraphView& graph, const double* radii)
  : Points(points)
  , Graph(graph)
  , Radii(radii)
{
}

Status BandPathShortener::Prepare(double voxelSize, std::size_t memoryLimit,
  const ParallelFor& parallel, const ProgressCallback& progress)
{
  const std::size_t copies =
    static_cast<std::size_t>(this->Graph.NumberOfVertices) * (sizeof(Point3) + sizeof(double));
  if (memoryLimit > 0 && copies >= memoryLimit)
  {
    return CheckMemory("the points of the band alone", static_cast<double>(copies) + 1.0,
      static_cast<double>(memoryLimit), "use fewer points");
  }
  std::vector<Point3> points;
  std::vector<double> radii;
  points.reserve(static_cast<std::size_t>(this->Graph.NumberOfVertices));
  radii.reserve(points.capacity());
  for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
  {
    const Point3 p = dgg::PointAt(this->Points, v);
    // Points without a ball are not in the band: outliers would make its box very large.
    if (IsFinite(p) && std::isfinite(this->Radii[v]) && this->Radii[v] > 0.0)
    {
      points.push_back(p);
      radii.push_back(this->Radii[v]);
    }
  }
  if (points.empty())
  {
    this->Band = VoxelBand();
    return Status::Success();
  }
  if (!(voxelSize > 0.0 && std::isfinite(voxelSize)))
  {
    return Status::Invalid("the size of voxels is not positive");
  }
  return this->Band.Build(points, radii, voxelSize, memoryLimit > 0 ? memoryLimit - copies : 0,
    parallel, progress, "build the graph of the cloud with larger voxels, or turn Straighten off");
}

Status BandPathShortener::Shorten(const std::vector<Id>& vertices, const Point3* start,
  const Point3* end, BandPath& path, const ProgressCallback& progress) const
{
  path = BandPath();
  if (vertices.empty())
  {
    return Status::Success();
  }
  for (const Id v : vertices)
  {
    if (v < 0 || v >= this->Graph.NumberOfVertices)
    {
      return Status::Invalid("point " + std::to_string(v) + " of the path does not exist");
    }
  }
  Relaxation relaxation(*this);
  relaxation.Add(start ? *start : dgg::PointAt(this->Points, vertices.front()), vertices.front());
  for (std::size_t i = start ? 0 : 1; i + (end ? 0 : 1) < vertices.size(); ++i)
  {
    relaxation.AddGraphEdge(dgg::PointAt(this->Points, vertices[i]), vertices[i]);
  }
  if (start || end || vertices.size() > 1)
  {
    relaxation.AddGraphEdge(
      end ? *end : dgg::PointAt(this->Points, vertices.back()), vertices.back());
  }
  if (!relaxation.Run(progress))
  {
    return Status::Abort();
  }
  path.Points.swap(relaxation.Points);
  path.Vertices.assign(path.Points.size(), NoId);
  path.Vertices.front() = start ? NoId : vertices.front();
  path.Vertices.back() = end ? path.Vertices.back() : vertices.back();
  path.Length = LengthOf(path.Points);
  return Status::Success();
}
}
