// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLocator.h"

#include "dggBarycentric.h"
#include "dggOutliers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dgg
{
namespace
{
/// Rounding error of positions, in units in the last place of the largest coordinate.
constexpr double UnitsOfRounding = 8.0;

/// Number of neighbors that define the reach of a cloud around a point.
constexpr std::size_t NeighborCount = 6;

const double* At(const double* positions, Id i)
{
  return positions + 3 * static_cast<std::size_t>(i);
}
}

//------------------------------------------------------------------------------
Box SurfaceLocator::MeasureBox(const SurfaceMesh& mesh, const double* positions)
{
  Box whole;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.FanBegin(v) != mesh.FanEnd(v)) // other points may have any coordinates
    {
      whole.Add(At(positions, v));
    }
  }
  return whole;
}

//------------------------------------------------------------------------------
SurfaceLocator::SurfaceLocator(const SurfaceMesh& mesh, const double* positions)
  : SurfaceLocator(mesh, positions, MeasureBox(mesh, positions))
{
}

//------------------------------------------------------------------------------
SurfaceLocator::SurfaceLocator(const SurfaceMesh& mesh, const double* positions, const Box& whole)
  : Mesh(mesh)
  , Positions(positions)
{
  double largest = 0.0;
  double extent = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    largest = std::max({ largest, -whole.Low[k], whole.High[k] });
    extent = std::max(extent, whole.High[k] - whole.Low[k]);
  }
  this->Rounding = UnitsOfRounding * std::numeric_limits<double>::epsilon() * largest;
  this->Scale = std::ldexp(1.0, -std::ilogb(extent));
  this->Diagonal = whole.GetDiagonal();

  std::vector<Box> boxes(static_cast<std::size_t>(mesh.GetNumberOfFaces()));
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    for (const Id v : mesh.GetTriangle(f))
    {
      if (!mesh.IsDropped(f))
      {
        boxes[static_cast<std::size_t>(f)].Add(this->GetScaled(At(positions, v)).data());
      }
    }
  }
  this->Tree = BoxTree(boxes);
}

//------------------------------------------------------------------------------
SurfaceLocator::Vector SurfaceLocator::GetScaled(const double* position) const
{
  return { { position[0] * this->Scale, position[1] * this->Scale, position[2] * this->Scale } };
}

//------------------------------------------------------------------------------
std::array<Id, 3> SurfaceLocator::GetInputTriangle(Id face) const
{
  auto triangle = this->Mesh.GetTriangle(face);
  if (this->Mesh.IsFlipped(face))
  {
    std::swap(triangle[1], triangle[2]);
  }
  return triangle;
}

//------------------------------------------------------------------------------
SurfaceLocator::Vector SurfaceLocator::Project(
  const Vector& p, Id face, double& squaredDistance) const
{
  const auto ids = this->GetInputTriangle(face);
  TriangleCorners corners;
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = this->GetScaled(At(this->Positions, ids[k]));
  }
  return FindClosestInTriangle(corners, p, squaredDistance);
}

//------------------------------------------------------------------------------
bool SurfaceLocator::FindClosestPoint(
  const double position[3], SurfacePoint& closest, double& distance) const
{
  const Vector p = this->GetScaled(position);
  Id face = NoId;
  double squaredDistance = Infinity;
  this->Tree.Search(p, squaredDistance, [&](Id candidate) {
    double squared = Infinity;
    if (!this->Mesh.IsDropped(candidate))
    {
      this->Project(p, candidate, squared);
    }
    if (squared < squaredDistance || (squared == squaredDistance && candidate < face))
    {
      face = candidate;
      squaredDistance = squared;
    }
    return squaredDistance;
  });
  if (face == NoId)
  {
    return false;
  }
  closest = SurfacePoint::InFace(this->Mesh, face, this->Project(p, face, squaredDistance));
  if (closest.On == SurfacePoint::Support::Edge)
  {
    // All faces of the edge are equally close up to rounding errors. Use the smallest id.
    const Id first = SurfaceMesh::Face(FindEdge(this->Mesh, closest.HalfEdge));
    if (first != face)
    {
      face = first;
      closest = SurfacePoint::InFace(this->Mesh, face, this->Project(p, face, squaredDistance));
    }
  }
  distance = std::sqrt(squaredDistance) / this->Scale;
  return true;
}

//------------------------------------------------------------------------------
CloudLocator::CloudLocator(const double* positions, Id numberOfPoints)
  : Positions(positions)
{
  const Outliers far(positions, numberOfPoints, Outliers::RatioOfFar);
  this->Frame =
    CloudFrame(positions, numberOfPoints, [&](const Point3& p) { return far.IsOutlier(p); });
  std::vector<Box> boxes;
  for (Id v = 0; v < numberOfPoints; ++v)
  {
    const Point3 p = PointAt(positions, v);
    if (!IsFinite(p))
    {
      continue;
    }
    if (!far.IsOutlier(p))
    {
      const Point3 local = this->Frame.ToLocal(p);
      const std::array<double, 3> point{ { local.X, local.Y, local.Z } };
      boxes.push_back({ point, point });
      this->Ids.push_back(v);
    }
    else if (std::none_of(this->Far.begin(), this->Far.end(),
               [&](Id other) { return this->GetDistance(other, At(positions, v)) == 0.0; }))
    {
      this->Far.push_back(v); // the first at its position
    }
  }
  this->Tree = BoxTree(boxes);
}

//------------------------------------------------------------------------------
double CloudLocator::GetDistance(Id point, const double position[3]) const
{
  const double* p = At(this->Positions, point);
  return std::hypot(position[0] - p[0], position[1] - p[1], position[2] - p[2]);
}

//------------------------------------------------------------------------------
double CloudLocator::GetSquaredLimit(double distance) const
{
  constexpr double relative = 1.0 + 1e-12;
  constexpr double absolute = 1e-15; // local coordinates are at most 1
  const double limit = relative * this->Frame.GetScale() * distance + absolute;
  return limit * limit;
}

//------------------------------------------------------------------------------
bool CloudLocator::FindClosestPoint(
  const double position[3], SurfacePoint& closest, double& distance) const
{
  Id point = NoId;
  distance = Infinity;
  const auto compare = [&](Id candidate) {
    const double d = this->GetDistance(candidate, position);
    if (d < distance || (d == distance && candidate < point))
    {
      point = candidate;
      distance = d;
    }
  };
  for (const Id candidate : this->Far)
  {
    compare(candidate);
  }
  const Point3 local = this->Frame.ToLocal({ position[0], position[1], position[2] });
  this->Tree.Search(
    { { local.X, local.Y, local.Z } }, this->GetSquaredLimit(distance), [&](Id element) {
      compare(this->Ids[static_cast<std::size_t>(element)]);
      return this->GetSquaredLimit(distance);
    });
  if (point == NoId)
  {
    return false; // none, or beyond the range of double
  }
  const double* p = At(this->Positions, point);
  closest = SurfacePoint::NearVertex(
    point, { { position[0] - p[0], position[1] - p[1], position[2] - p[2] } });
  return true;
}

//------------------------------------------------------------------------------
double CloudLocator::GetReach(const SurfacePoint& closest) const
{
  const double* p = At(this->Positions, closest.Vertex);
  std::vector<double> nearest; // ascending, of the point itself and its neighbors
  const auto add = [&](Id candidate) {
    const double d = this->GetDistance(candidate, p);
    nearest.insert(std::upper_bound(nearest.begin(), nearest.end(), d), d);
    nearest.resize(std::min(nearest.size(), NeighborCount + 1));
    return this->GetSquaredLimit(nearest.size() > NeighborCount ? nearest.back() : Infinity);
  };
  if (std::any_of(
        this->Far.begin(), this->Far.end(), [&](Id v) { return this->GetDistance(v, p) == 0.0; }))
  {
    std::for_each(this->Far.begin(), this->Far.end(), add);
  }
  else
  {
    const Point3 local = this->Frame.ToLocal({ p[0], p[1], p[2] });
    this->Tree.Search({ { local.X, local.Y, local.Z } }, Infinity,
      [&](Id element) { return add(this->Ids[static_cast<std::size_t>(element)]); });
  }
  return nearest.size() > NeighborCount ? nearest.back() : 0.0;
}
}
