// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagationOutput.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Error of distances from a nearby source due to single precision, relative.
constexpr double SeedSlack = 1e-5;

/// Calls visit(vertex, source, distance, place) for the corners of the faces that contain sources.
template <typename Visit>
void ForEachPlace(
  const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources, const Visit& visit)
{
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const SurfacePoint& point = sources[k].Point;
    const auto root = static_cast<Id>(k);
    const double offset = sources[k].InitialDistance;
    if (IsVertex(point))
    {
      visit(point.Vertex, root, offset, VirtualPlace());
      continue;
    }
    ForEachFaceAround(mesh, point, [&](Id f, const std::array<double, 3>& b) {
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Point2 place = PlaceInFrame(mesh, h, b);
        const double length = DistanceToCorner(mesh, f, b, h % 3);
        visit(mesh.Origin(h), root, offset + length, { length, h, std::atan2(place.Y, place.X) });
      }
    });
  }
}
}

PropagationOutput::PropagationOutput(const SurfaceMesh& mesh, const PropagationOptions& options,
  double shift, PropagationResult& result)
  : Mesh(mesh)
  , Options(options)
  , Shift(shift)
  , Result(result)
{
  const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  result.Distances.assign(n, Infinity);
  if (options.WantNearestSource)
  {
    result.NearestSource.assign(n, NoId);
  }
  if (options.WantVirtualSource)
  {
    result.Virtual.assign(n, {});
  }
}

bool PropagationOutput::SetDistance(Id v, double distance)
{
  const double maximum = this->Options.MaximumDistance;
  if (!(distance <= maximum + LimitSlack * (maximum - this->Shift)))
  {
    return false;
  }
  this->Result.Distances[v] = std::min(distance, maximum);
  return true;
}

void PropagationOutput::SetSource(Id v, Id root, const VirtualPlace& place)
{
  if (this->Options.WantNearestSource)
  {
    this->Result.NearestSource[v] = root;
  }
  if (this->Options.WantVirtualSource)
  {
    this->Result.Virtual[v] = { this->Result.Distances[v] - place.Length, place.Length,
      place.HalfEdge == NoId ? 0.0 : this->Mesh.PolarAngle(place.HalfEdge) + place.Angle };
  }
}

void PropagationOutput::TakeSources(const std::vector<GeodesicSource>& sources)
{
  const double maximum = this->Options.MaximumDistance;
  std::vector<double>& distances = this->Result.Distances;
  // If a source is as near as the stored distance, the nearest source decides; on ties the first
  // one.
  ForEachPlace(this->Mesh, sources, [&](Id v, Id, double distance, const VirtualPlace&) {
    if (distance <= distances[v] + SeedSlack * (distance - this->Shift) && distance <= maximum)
    {
      distances[v] = Infinity;
    }
  });
  ForEachPlace(this->Mesh, sources, [&](Id v, Id root, double distance, const VirtualPlace& place) {
    if (distance < distances[v] && distance <= maximum)
    {
      distances[v] = distance;
      this->SetSource(v, root, place);
    }
  });
}
}
