// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfacePath.h"

#include "dggStatus.h"

#include <cmath>
#include <limits>

namespace dgg
{
namespace
{
/// Relative tolerance between a length and the sum of its segments.
constexpr double LengthTolerance = 1e-9;
}

void SurfacePath::Clear()
{
  this->Points.clear();
  this->Faces.clear();
  this->Length = 0.0;
}

double SurfacePath::Append(const SurfaceMesh& mesh, const SurfacePoint& point, Id face)
{
  this->Points.push_back(point);
  if (this->Points.size() == 1)
  {
    return 0.0;
  }
  this->Faces.push_back(face);
  const double length = MeasurePiece(mesh, *this, this->Faces.size() - 1);
  this->Length += length;
  return length;
}

bool FindInFace(
  const SurfaceMesh& mesh, const SurfacePoint& point, Id face, std::array<double, 3>& barycentric)
{
  if (face < 0 || face >= mesh.GetNumberOfFaces())
  {
    return false;
  }
  bool isFound = false;
  if (point.On == SurfacePoint::Support::Vertex)
  {
    for (int k = 0; k < 3; ++k)
    {
      barycentric[k] = mesh.Origin(3 * face + k) == point.Vertex ? 1.0 : 0.0;
      isFound = isFound || barycentric[k] == 1.0;
    }
    return isFound;
  }
  ForEachFaceAround(mesh, point, [&](Id f, const std::array<double, 3>& b) {
    if (f == face)
    {
      barycentric = b;
      isFound = true;
    }
  });
  return isFound;
}

Id FindFaceOf(const SurfaceMesh& mesh, const SurfacePoint& point)
{
  if (point.On != SurfacePoint::Support::Vertex)
  {
    return point.Face;
  }
  const Id* fan = mesh.FanBegin(point.Vertex);
  return fan != mesh.FanEnd(point.Vertex) ? SurfaceMesh::Face(*fan) : NoId;
}

double MeasurePiece(const SurfaceMesh& mesh, const SurfacePath& path, std::size_t piece)
{
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  const Id face = path.Faces[piece];
  return FindInFace(mesh, path.Points[piece], face, p) &&
      FindInFace(mesh, path.Points[piece + 1], face, q)
    ? DistanceInFace(mesh, face, p, q)
    : std::numeric_limits<double>::quiet_NaN();
}

Status CheckPath(const SurfaceMesh& mesh, const SurfacePath& path)
{
  const std::size_t pieces = path.Points.empty() ? 0 : path.Points.size() - 1;
  if (path.Faces.size() != pieces)
  {
    return InvalidInput(
      "A path of ", path.Points.size(), " points has ", path.Faces.size(), " faces")
      .Fix("Give one face per piece");
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces; ++i)
  {
    const double length = MeasurePiece(mesh, path, i);
    if (!std::isfinite(length))
    {
      return InvalidInput("Piece ", i, " of the path does not lie in face ", path.Faces[i]);
    }
    sum += length;
  }
  if (!(std::abs(sum - path.Length) <= LengthTolerance * sum))
  {
    return InvalidInput(
      "The length of the path is ", path.Length, ", but its pieces have the length ", sum);
  }
  return Status::Success();
}

Status CheckCorners(const SurfaceMesh& mesh)
{
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const std::array<Id, 3> corners = mesh.GetTriangle(f);
    if (!mesh.IsDropped(f) &&
      (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]))
    {
      return InvalidInput("Face ", f, " has the vertices ", corners[0], ", ", corners[1], " and ",
        corners[2], ", which are not distinct")
        .Fix("Split its edges");
    }
  }
  return Status::Success();
}

std::array<double, 3> PositionOf(
  const SurfaceMesh& mesh, const SurfacePoint& point, const double* positions)
{
  if (point.On == SurfacePoint::Support::Vertex)
  {
    const double* p = positions + 3 * static_cast<std::size_t>(point.Vertex);
    return { { p[0], p[1], p[2] } };
  }
  if (point.On == SurfacePoint::Support::Near)
  {
    const double* p = positions + 3 * static_cast<std::size_t>(point.Vertex);
    const std::array<double, 3>& offset = point.Barycentric;
    return { { p[0] + offset[0], p[1] + offset[1], p[2] + offset[2] } };
  }
  std::array<double, 3> sum{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    const double* p = positions + 3 * static_cast<std::size_t>(mesh.Origin(3 * point.Face + k));
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += point.Barycentric[k] * p[c];
    }
  }
  return sum;
}
}
