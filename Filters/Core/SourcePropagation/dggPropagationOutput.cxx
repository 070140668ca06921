// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagationOutput.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Single precision, by which a distance from a source nearby may be off.
constexpr double SeedSlack = 1e-5;
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
    result.Virtual.Offsets.assign(n, Infinity);
    result.Virtual.Lengths.assign(n, Infinity);
    result.Virtual.Angles.assign(n, 0.0);
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
    this->Result.Virtual.Offsets[v] = this->Result.Distances[v] - place.Length;
    this->Result.Virtual.Lengths[v] = place.Length;
    this->Result.Virtual.Angles[v] =
      place.HalfEdge == NoId ? 0.0 : this->Mesh.PolarAngle(place.HalfEdge) + place.Angle;
  }
}

void PropagationOutput::Take(Id v, const GeodesicSource& source, Id root, const VirtualPlace& place)
{
  const double distance = source.InitialDistance + place.Length;
  if (distance <= this->Result.Distances[v] + SeedSlack * (distance - this->Shift) &&
    distance <= this->Options.MaximumDistance)
  {
    this->Result.Distances[v] = distance;
    this->SetSource(v, root, place);
  }
}

void PropagationOutput::TakeSources(const std::vector<GeodesicSource>& sources)
{
  // The first one of several at the same distance comes last, and stays.
  for (std::size_t k = sources.size(); k-- > 0;)
  {
    const SurfacePoint& point = sources[k].Point;
    const auto root = static_cast<Id>(k);
    if (IsVertex(point))
    {
      this->Take(point.Vertex, sources[k], root, {});
      continue;
    }
    ForEachFaceAround(this->Mesh, point, [&](Id f, const std::array<double, 3>& b) {
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Point2 place = PlaceInFrame(this->Mesh, h, b);
        this->Take(this->Mesh.Origin(h), sources[k], root,
          { DistanceToCorner(this->Mesh, f, b, h % 3), h, std::atan2(place.Y, place.X) });
      }
    });
  }
}
}
