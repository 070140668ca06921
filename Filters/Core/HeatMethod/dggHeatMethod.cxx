// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHeatMethod.h"

#include "dggHeap.h"
#include "dggHeatSystem.h"
#include "dggProgressPart.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Progress after the first step of the preparation, and after steps of a query.
constexpr double AnalysisDone = 0.4;
constexpr double SystemsDone = 0.8;
constexpr double SourcesDone = 0.9;

/// A corner that a source heats.
struct Corner
{
  Id Source;
  Id Vertex;
  double Weight;
  double Distance; ///< straight distance, without the initial distance
};

std::vector<Corner> FindCorners(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources)
{
  std::vector<Corner> corners;
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    ForEachCornerAround(mesh, sources[k].Point, [&](Id v, double weight, double distance) {
      corners.push_back({ static_cast<Id>(k), v, weight, distance });
    });
  }
  return corners;
}

/// Fails if all corners of a source lie on the boundary with Dirichlet conditions, so that the
/// source heats nothing.
Status CheckCorners(
  const HeatSystem& system, std::size_t numberOfSources, const std::vector<Corner>& corners)
{
  if (system.GetOptions().Boundary != HeatBoundary::Dirichlet)
  {
    return Status::Success();
  }
  std::vector<bool> isHeated(numberOfSources, false);
  for (const Corner& corner : corners)
  {
    isHeated[corner.Source] =
      isHeated[corner.Source] || (corner.Weight > 0.0 && !system.IsOnBoundary(corner.Vertex));
  }
  const auto lost = std::find(isHeated.begin(), isHeated.end(), false);
  return lost == isHeated.end()
    ? Status::Success()
    : InvalidInput("Source ", lost - isHeated.begin(),
        " lies on the boundary, where the Dirichlet condition removes its heat")
        .At("Boundary", lost - isHeated.begin())
        .Fix("Set {Boundary} to Neumann or Average");
}

/// Returns the smallest initial distance in each component; Infinity without a source.
std::vector<double> FindLeastOffsets(const HeatSystem& system,
  const std::vector<GeodesicSource>& sources, const std::vector<Corner>& corners)
{
  std::vector<double> leastOffsets(system.GetNumberOfComponents(), Infinity);
  for (const Corner& corner : corners)
  {
    double& least = leastOffsets[system.GetComponent(corner.Vertex)];
    least = std::min(least, sources[corner.Source].InitialDistance);
  }
  return leastOffsets;
}

/// Returns the heat of all sources. Initial distances are relative to the smallest one of the
/// component.
std::vector<HeatSystem::Load> FindLoads(const HeatSystem& system,
  const std::vector<GeodesicSource>& sources, const std::vector<Corner>& corners,
  const std::vector<double>& leastOffsets)
{
  std::vector<HeatSystem::Load> loads;
  for (const Corner& corner : corners)
  {
    if (corner.Weight > 0.0)
    {
      const Id component = system.GetComponent(corner.Vertex);
      const double offset = sources[corner.Source].InitialDistance - leastOffsets[component];
      loads.push_back({ corner.Vertex, corner.Weight, -offset / system.GetHeatLength(component) });
    }
  }
  return loads;
}

/// Returns the constant to be added to the values of each component.
std::vector<double> FindShifts(const HeatSystem& system, const std::vector<GeodesicSource>& sources,
  const std::vector<Corner>& corners, const std::vector<double>& leastOffsets,
  const std::vector<double>& values)
{
  // Constant that each source requires.
  std::vector<double> shifts(sources.size());
  std::vector<Id> components(sources.size(), NoId);
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    shifts[k] = sources[k].InitialDistance;
  }
  for (const Corner& corner : corners)
  {
    components[corner.Source] = system.GetComponent(corner.Vertex);
    shifts[corner.Source] += corner.Weight * (corner.Distance - values[corner.Vertex]);
  }
  // The sources with the smallest initial distance determine the constant. Other sources may be
  // dominated by one of these, and would then require a much larger constant.
  const auto isLeast = [&](std::size_t k) {
    return sources[k].InitialDistance == leastOffsets[components[k]];
  };
  const auto n = static_cast<std::size_t>(system.GetNumberOfComponents());
  std::vector<double> limits(n, -Infinity);
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    if (isLeast(k))
    {
      limits[components[k]] =
        std::max(limits[components[k]], shifts[k] + system.GetHeatLength(components[k]));
    }
  }
  std::vector<double> sums(n, 0.0);
  std::vector<double> counts(n, 0.0);
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    if (isLeast(k) || shifts[k] <= limits[components[k]])
    {
      sums[components[k]] += shifts[k];
      counts[components[k]] += 1.0;
    }
  }
  for (std::size_t c = 0; c < n; ++c)
  {
    sums[c] = counts[c] > 0.0 ? sums[c] / counts[c] : Infinity;
  }
  return sums;
}

/// Converts values known up to a constant per component to distances.
void ShiftToDistances(const HeatSystem& system, const std::vector<GeodesicSource>& sources,
  const std::vector<Corner>& corners, const std::vector<double>& leastOffsets,
  std::vector<double>& values)
{
  const std::vector<double> shifts = FindShifts(system, sources, corners, leastOffsets, values);
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    const Id component = system.GetComponent(static_cast<Id>(v));
    values[v] = shifts[component] < Infinity
      ? std::max(values[v] + shifts[component], leastOffsets[component])
      : Infinity;
  }
  for (const Corner& corner : corners)
  {
    values[corner.Vertex] =
      std::min(values[corner.Vertex], sources[corner.Source].InitialDistance + corner.Distance);
  }
}

template <typename Visitor>
void ForEachAdjacent(const SurfaceMesh& mesh, Id v, Visitor&& visit)
{
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    const Id incoming = SurfaceMesh::Previous(*g);
    visit(mesh.Destination(*g), mesh.Length(*g));
    visit(mesh.Origin(incoming), mesh.Length(incoming));
  }
}

/// Computes the direction from the origin of half-edge h to the source, in the frame of h. Returns
/// false if the distances do not determine the direction.
bool PointToSource(const SurfaceMesh& mesh, Id h, double offset,
  const std::vector<double>& distances, Point2& direction)
{
  const double length = mesh.Length(h);
  const double x = mesh.ApexX(h);
  const double y = mesh.ApexY(h);
  const double a = distances[mesh.Origin(h)] - offset;
  const double b = distances[mesh.Destination(h)] - offset;
  const double c = distances[mesh.Apex(h)] - offset;
  // |p|^2 - d(p)^2 is linear in the plane; its gradient is twice the position of the source.
  direction.X = 0.5 * (length + (a - b) * (a + b) / length);
  direction.Y = 0.5 * ((x * x + y * y + (a - c) * (a + c)) - 2.0 * x * direction.X) / y;
  const double norm = Norm(direction.X, direction.Y);
  if (!(norm > 0.0) || !std::isfinite(norm))
  {
    return false;
  }
  direction.X /= norm;
  direction.Y /= norm;
  return true;
}

/// Returns the source of every vertex, found by steepest descent of the distances along edges, and
/// over the lowest pass at local minima; NoId where distances are Infinity.
std::vector<Id> FindNearestSources(const SurfaceMesh& mesh,
  const std::vector<GeodesicSource>& sources, const std::vector<Corner>& corners,
  const std::vector<double>& distances)
{
  std::vector<Id> nearest(distances.size(), NoId);
  std::vector<double> best(distances.size(), Infinity); // distances of corners
  std::vector<std::uint8_t> isDone(distances.size(), 0);
  std::vector<std::uint8_t> isPushed(distances.size(), 0);
  DistanceHeap heap;
  for (const Corner& corner : corners)
  {
    const Id v = corner.Vertex;
    const double straight = sources[corner.Source].InitialDistance + corner.Distance;
    if (straight < best[v])
    {
      best[v] = straight;
      nearest[v] = corner.Source;
    }
    if (!isPushed[v])
    {
      isPushed[v] = 1;
      heap.Push(distances[v], v);
    }
  }
  while (!heap.IsEmpty())
  {
    const DistanceHeap::Entry top = heap.Pop();
    const Id v = top.Index;
    // A corner keeps its source unless the field passes below it.
    double steepest = distances[v] < best[v] ? -Infinity : Infinity;
    ForEachAdjacent(mesh, v, [&](Id u, double length) {
      if (isDone[u] && (distances[v] - distances[u]) > steepest * length)
      {
        steepest = (distances[v] - distances[u]) / std::max(length, 1e-300);
        nearest[v] = nearest[u];
      }
    });
    isDone[v] = 1;
    ForEachAdjacent(mesh, v, [&](Id u, double) {
      if (!isPushed[u] && distances[u] < Infinity)
      {
        isPushed[u] = 1;
        heap.Push(std::max(top.Key, distances[u]), u);
      }
    });
  }
  return nearest;
}

/// Computes the polar angle at every vertex towards the source. The angle is the mean over the
/// faces of the vertex of the direction to the point with the given distances from the corners,
/// minus `offsets`; exact if the faces lie in a plane with the source. Angles around interior
/// vertices are scaled to 2 pi for the mean. At irregular vertices, the direction is taken from the
/// face into which it points best.
void FindDirectionsOfDescent(
  const SurfaceMesh& mesh, const std::vector<double>& distances, VirtualSources& sources)
{
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (!(distances[v] < Infinity))
    {
      continue;
    }
    const VertexKind kind = mesh.Kind(v);
    const bool isClosed = kind != VertexKind::Boundary && kind != VertexKind::Irregular;
    const double scale = isClosed ? 2.0 * Pi / mesh.TotalAngle(v) : 1.0;
    Point2 sum;
    double best = Infinity;
    for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
    {
      Point2 direction;
      if (!PointToSource(mesh, *g, sources[v].Offset, distances, direction))
      {
        continue;
      }
      const double corner = mesh.CornerAngle(*g);
      const double begin = mesh.PolarAngle(*g);
      const double turn = std::atan2(direction.Y, direction.X);
      if (kind == VertexKind::Irregular)
      {
        const double inside = std::min(std::max(turn, 0.0), corner);
        const double off = std::min(std::abs(turn - inside), std::abs(turn + 2.0 * Pi - inside));
        if (off < best)
        {
          best = off;
          sources[v].Angle = begin + inside;
        }
        continue;
      }
      // The direction is scaled around the center of the corner, because angles outside the corner
      // do not belong to the face.
      const double angle = scale * (begin + 0.5 * corner) + (turn - 0.5 * corner);
      sum.X += corner * std::cos(angle);
      sum.Y += corner * std::sin(angle);
    }
    if (kind != VertexKind::Irregular && (sum.X != 0.0 || sum.Y != 0.0))
    {
      const double total = mesh.TotalAngle(v);
      double angle = std::atan2(sum.Y, sum.X);
      if (isClosed)
      {
        sources[v].Angle = (angle < 0.0 ? angle + 2.0 * Pi : angle) / scale;
        continue;
      }
      // Clamp to the surface. If the direction points outside, use the nearer of the two ends.
      const double middle = 0.5 * total;
      angle += 2.0 * Pi * std::round((middle - angle) / (2.0 * Pi));
      sources[v].Angle = std::min(std::max(angle, 0.0), total);
    }
  }
}

/// Returns the virtual source of each vertex: the nearest source, in the direction opposite to the
/// gradient.
VirtualSources FindVirtualSources(
  const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources, const HeatResult& result)
{
  const std::vector<double>& distances = result.Distances;
  VirtualSources found(distances.size());
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    if (result.NearestSource[v] != NoId)
    {
      found[v].Offset = std::min(sources[result.NearestSource[v]].InitialDistance, distances[v]);
    }
    if (distances[v] < Infinity)
    {
      found[v].Length = distances[v] - found[v].Offset;
    }
  }
  FindDirectionsOfDescent(mesh, distances, found);
  return found;
}

/// Marks vertices beyond the maximum distance as unreached.
void CutOff(double maximumDistance, HeatResult& result)
{
  for (std::size_t v = 0; v < result.Distances.size(); ++v)
  {
    if (!(result.Distances[v] > maximumDistance))
    {
      continue;
    }
    result.Distances[v] = Infinity;
    if (!result.Virtual.empty())
    {
      result.Virtual[v] = {};
    }
    if (!result.NearestSource.empty())
    {
      result.NearestSource[v] = NoId;
    }
  }
}
}

HeatMethod::HeatMethod(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , System(std::make_unique<HeatSystem>(mesh))
{
}

HeatMethod::~HeatMethod() = default;

Status HeatMethod::Check(const HeatOptions& options)
{
  if (options.TimeStepFactor >= SmallestTimeStepFactor &&
    options.TimeStepFactor <= LargestTimeStepFactor)
  {
    return Status::Success();
  }
  return InvalidValue("TimeStepFactor", options.TimeStepFactor)
    .Fix(
      "Use a number from ", SmallestTimeStepFactor, " to ", LargestTimeStepFactor, ", such as 1");
}

Status HeatMethod::Prepare(const HeatOptions& options, const ProgressCallback& progress,
  const std::function<Status(double bytes)>& checkMemory)
{
  HeatSystem& system = *this->System;
  DGG_RETURN_IF_ERROR(system.Analyze(options, ProgressPart(progress, 0.0, AnalysisDone)));
  DGG_RETURN_IF_ERROR(checkMemory && !system.HoldsFactors()
      ? checkMemory(system.GetEstimatedMemory())
      : Status::Success());
  return system.Factorize(ProgressPart(progress, AnalysisDone, 1.0));
}

double HeatMethod::GetEstimatedMemory() const
{
  return this->System->GetEstimatedMemory();
}

Status HeatMethod::Check(const std::vector<GeodesicSource>& sources, const HeatQuery& query) const
{
  DGG_RETURN_IF_ERROR(CheckSources(this->Mesh, sources));
  if (std::isnan(query.MaximumDistance))
  {
    return InvalidValue("MaximumDistance", query.MaximumDistance).Fix("Use a number or infinity");
  }
  return this->System->IsReady()
    ? Status::Success()
    : InvalidInput("The systems have not been factorized").Fix("Call Prepare() first");
}

Status HeatMethod::Run(
  const std::vector<GeodesicSource>& sources, const HeatQuery& query, HeatResult& result) const
{
  result = HeatResult();
  const HeatSystem& system = *this->System;
  DGG_RETURN_IF_ERROR(this->Check(sources, query));
  const std::vector<Corner> corners = FindCorners(this->Mesh, sources);
  DGG_RETURN_IF_ERROR(CheckCorners(system, sources.size(), corners));
  // Solve the heat flow, then find the function whose gradient is the normalized gradient of the
  // temperature. This function is the distance up to a constant per component.
  const std::vector<double> leastOffsets = FindLeastOffsets(system, sources, corners);
  result.Distances = system.Solve(FindLoads(system, sources, corners, leastOffsets),
    ProgressPart(query.Progress, 0.0, SystemsDone));
  if (result.Distances.empty())
  {
    return Status::Abort();
  }
  ShiftToDistances(system, sources, corners, leastOffsets, result.Distances);
  for (const Corner& corner : corners)
  {
    const Id triangles = system.GetNumberOfTriangles(system.GetComponent(corner.Vertex));
    if (triangles > 0)
    {
      result.FewestTriangles = std::min(result.FewestTriangles, triangles);
    }
  }
  if (query.WantNearestSource || query.WantVirtualSource)
  {
    result.NearestSource = FindNearestSources(this->Mesh, sources, corners, result.Distances);
  }
  if (query.Progress && !query.Progress(SourcesDone))
  {
    result = HeatResult();
    return Status::Abort();
  }
  if (query.WantVirtualSource)
  {
    result.Virtual = FindVirtualSources(this->Mesh, sources, result);
  }
  CutOff(query.MaximumDistance, result);
  if (!query.WantNearestSource)
  {
    result.NearestSource.clear();
  }
  return Status::Success();
}

int HeatMethod::GetNumberOfFactorizations() const
{
  return this->System->GetNumberOfFactorizations();
}
}
