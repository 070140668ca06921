// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleUnfolding.h"

#include "dggExactGeodesics.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Smallest relative height of a triangle that can locate points.
constexpr double LeastHeight = 1e-3;
}

dgg::Status TriangleUnfolding::Prepare(int count)
{
  std::vector<std::vector<double>> fields;
  DGG_RETURN_IF_ERROR(this->TakeSamples(count, fields));
  this->Table.clear();
  for (const std::vector<double>& field : fields)
  {
    for (const dgg::Id v : this->Samples)
    {
      this->Table.push_back(field[v]);
    }
  }
  this->FindTriangles(fields);
  return dgg::Status::Success();
}

/// Selects samples, each as far as possible from earlier ones, and computes the exact distances of
/// all vertices from each.
dgg::Status TriangleUnfolding::TakeSamples(int count, std::vector<std::vector<double>>& fields)
{
  dgg::ExactGeodesics solver(this->Mesh);
  // Vertices without a face are never selected.
  std::vector<double> least;
  least.reserve(static_cast<std::size_t>(this->Mesh.GetNumberOfVertices()));
  for (dgg::Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
  {
    least.push_back(this->Mesh.Kind(v) == dgg::VertexKind::Isolated ? 0.0 : dgg::Infinity);
  }
  this->Samples.clear();
  while (static_cast<int>(fields.size()) < count)
  {
    const auto farthest = std::max_element(least.begin(), least.end());
    if (farthest == least.end() || !(*farthest > 0.0))
    {
      break;
    }
    this->Samples.push_back(static_cast<dgg::Id>(farthest - least.begin()));
    dgg::ExactResult result;
    DGG_RETURN_IF_ERROR(
      solver.Run({ { dgg::SurfacePoint::AtVertex(this->Samples.back()), 0.0 } }, {}, result));
    for (std::size_t v = 0; v < least.size(); ++v)
    {
      least[v] = std::min(least[v], result.Distances[v]);
    }
    fields.push_back(std::move(result.Distances));
  }
  return dgg::Status::Success();
}

void TriangleUnfolding::FindTriangles(const std::vector<std::vector<double>>& fields)
{
  const auto nearestOf = [&](dgg::Id v, auto&& isWanted) {
    dgg::Id nearest = dgg::NoId;
    for (std::size_t i = 0; i < fields.size(); ++i)
    {
      if (isWanted(i) && (nearest == dgg::NoId || fields[i][v] < fields[nearest][v]))
      {
        nearest = static_cast<dgg::Id>(i);
      }
    }
    return nearest;
  };
  const dgg::Id n = this->Mesh.GetNumberOfVertices();
  std::vector<dgg::Id> cells;
  cells.reserve(static_cast<std::size_t>(n));
  for (dgg::Id v = 0; v < n; ++v)
  {
    cells.push_back(nearestOf(v, [](std::size_t) { return true; }));
  }
  this->Triangles.clear();
  for (dgg::Id f = 0; f < this->Mesh.GetNumberOfFaces(); ++f)
  {
    Triangle t{ { cells[this->Mesh.Origin(3 * f)], cells[this->Mesh.Origin(3 * f + 1)],
      cells[this->Mesh.Origin(3 * f + 2)] } };
    std::sort(t.begin(), t.end());
    if (!this->Mesh.IsDropped(f) && t[0] != t[1] && t[1] != t[2])
    {
      this->Triangles.push_back(t);
    }
  }
  std::sort(this->Triangles.begin(), this->Triangles.end());
  this->Triangles.erase(
    std::unique(this->Triangles.begin(), this->Triangles.end()), this->Triangles.end());

  std::vector<std::vector<Triangle>> around(fields.size());
  for (const Triangle& t : this->Triangles)
  {
    for (const dgg::Id i : t)
    {
      around[i].push_back(t);
    }
  }
  this->Places.clear();
  for (dgg::Id v = 0; v < n; ++v)
  {
    // Without triangles, the location is the nearest sample.
    const double least = fields[cells[v]][v];
    Place best{ { { cells[v], cells[v], cells[v] } }, { { least, least, least } },
      { { 1.0, 0.0, 0.0 } } };
    double mostInside = -dgg::Infinity;
    const dgg::Id cell = nearestOf(
      v, [&](std::size_t i) { return !around[i].empty() && fields[i][v] < dgg::Infinity; });
    for (const Triangle& t : cell == dgg::NoId ? std::vector<Triangle>() : around[cell])
    {
      Place place{ t, { { fields[t[0]][v], fields[t[1]][v], fields[t[2]][v] } }, {} };
      if (!this->Locate(place))
      {
        continue;
      }
      const double inside = *std::min_element(place.Weights.begin(), place.Weights.end());
      if (inside > mostInside)
      {
        mostInside = inside;
        best = place;
      }
    }
    this->Places.push_back(best);
  }
}

/// Computes barycentric coordinates in the plane from the differences of squared distances from the
/// corners. Returns false if the triangle is too flat.
bool TriangleUnfolding::Locate(Place& place) const
{
  const double length = this->Between(place.Corners[0], place.Corners[1]);
  const dgg::Point2 apex = dgg::LayOut(length, this->Between(place.Corners[0], place.Corners[2]),
    this->Between(place.Corners[1], place.Corners[2]));
  if (!(apex.Y > LeastHeight * length))
  {
    return false;
  }
  const double toFirst = place.Distances[0];
  const double toThird = place.Distances[2];
  const double x = dgg::FootOnEdge(length, toFirst, place.Distances[1]);
  const double y = 0.5 *
    ((toFirst - toThird) * (toFirst + toThird) + dgg::Dot(apex, apex) - 2.0 * x * apex.X) / apex.Y;
  place.Weights[2] = y / apex.Y;
  place.Weights[1] = (x - place.Weights[2] * apex.X) / length;
  place.Weights[0] = 1.0 - place.Weights[1] - place.Weights[2];
  return true;
}

/// Returns the sum over the sides of products of weights and squared length: the difference between
/// the weighted mean of squared distances from the corners and the squared distance from the point.
double TriangleUnfolding::InTriangle(const Place& place) const
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const double side = this->Between(place.Corners[i], place.Corners[j]);
    sum += place.Weights[i] * place.Weights[j] * side * side;
  }
  return sum;
}

double TriangleUnfolding::GetDistance(dgg::Id from, dgg::Id to) const
{
  const Bounds bounds = this->GetBounds(from, to);
  if (!(bounds.Upper < dgg::Infinity))
  {
    return dgg::Infinity;
  }
  const Place& p = this->Places[from];
  const Place& q = this->Places[to];
  double squared = -this->InTriangle(p) - this->InTriangle(q);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double between = this->Between(p.Corners[i], q.Corners[j]);
      squared += p.Weights[i] * q.Weights[j] * between * between;
    }
  }
  return std::min(std::max(std::sqrt(std::max(squared, 0.0)), bounds.Lower), bounds.Upper);
}

TriangleUnfolding::Bounds TriangleUnfolding::GetBounds(dgg::Id from, dgg::Id to) const
{
  const Place& p = this->Places[from];
  const Place& q = this->Places[to];
  Bounds bounds{ 0.0, dgg::Infinity };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double a = p.Distances[i];
      const double b = this->Between(p.Corners[i], q.Corners[j]);
      const double c = q.Distances[j];
      bounds.Upper = std::min(bounds.Upper, a + b + c);
      // Excess of the longest length over the sum of the other two; no bound if all are infinite.
      bounds.Lower = std::max(bounds.Lower, 2.0 * std::max(a, std::max(b, c)) - (a + b + c));
    }
  }
  return bounds;
}

std::size_t TriangleUnfolding::GetMemorySize() const
{
  return this->Table.size() * sizeof(double) + this->Places.size() * sizeof(Place);
}
