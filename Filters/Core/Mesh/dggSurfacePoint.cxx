// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfacePoint.h"

#include "dggBarycentric.h"
#include "dggStatus.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
/// Deviation from 0 or 1 below which barycentric coordinates are snapped.
constexpr double SnapTolerance = 1e-9;

/// Returns a snapped point. Coordinates refer to the corners in the order of the mesh.
SurfacePoint Snap(const SurfaceMesh& mesh, Id face, std::array<double, 3> b)
{
  SurfacePoint point;
  point.On = SurfacePoint::Support::Face;
  point.Face = face;
  point.Barycentric = b;
  if (face < 0 || face >= mesh.GetNumberOfFaces() || !AreBarycentric(b))
  {
    return point; // Check() will fail
  }
  int zeros = 0;
  double sum = 0.0;
  for (double& x : b)
  {
    x = x < SnapTolerance ? 0.0 : x;
    zeros += x == 0.0 ? 1 : 0;
    sum += x;
  }
  for (int k = 0; k < 3; ++k)
  {
    b[k] /= sum;
    if (zeros >= 2 ? b[k] > 0.0 : b[k] >= 1.0 - SnapTolerance)
    {
      point = SurfacePoint::AtVertex(mesh.Origin(3 * face + k));
      point.Face = face;
      point.Barycentric = CoordinatesOfCorner(k);
      return point;
    }
  }
  point.Barycentric = b;
  for (int k = 0; k < 3; ++k)
  {
    if (b[k] == 0.0)
    {
      point.On = SurfacePoint::Support::Edge;
      point.HalfEdge = 3 * face + (k + 1) % 3; // the edge opposite corner k
    }
  }
  return point;
}
}

SurfacePoint SurfacePoint::AtVertex(Id vertex)
{
  SurfacePoint point;
  point.Vertex = vertex;
  return point;
}

SurfacePoint SurfacePoint::NearVertex(Id vertex, const std::array<double, 3>& offset)
{
  SurfacePoint point = AtVertex(vertex);
  if (offset[0] != 0.0 || offset[1] != 0.0 || offset[2] != 0.0)
  {
    point.On = Support::Near;
    point.Barycentric = offset;
  }
  return point;
}

SurfacePoint SurfacePoint::InFace(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric)
{
  std::array<double, 3> b = barycentric;
  if (face >= 0 && face < mesh.GetNumberOfFaces() && mesh.IsFlipped(face))
  {
    std::swap(b[1], b[2]);
  }
  return Snap(mesh, face, b);
}

SurfacePoint SurfacePoint::InTriangle(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric)
{
  return Snap(mesh, face, barycentric);
}

SurfacePoint SurfacePoint::OnEdge(const SurfaceMesh& mesh, Id halfEdge, double t)
{
  return halfEdge < 0 ? Snap(mesh, NoId, {})
                      : Snap(mesh, SurfaceMesh::Face(halfEdge), CoordinatesOnEdge(halfEdge, t));
}

SurfacePoint SurfacePoint::InsideEdge(Id halfEdge, double t)
{
  SurfacePoint point;
  point.On = Support::Edge;
  point.HalfEdge = halfEdge;
  point.Face = SurfaceMesh::Face(halfEdge);
  point.Barycentric = CoordinatesOnEdge(halfEdge, t);
  return point;
}

Status SurfacePoint::Check(const SurfaceMesh& mesh) const
{
  if (this->On == Support::Vertex)
  {
    if (this->Vertex >= 0 && this->Vertex < mesh.GetNumberOfVertices())
    {
      return Status::Success();
    }
    return InvalidInput("Vertex ", this->Vertex, " does not exist")
      .Fix("Use ids from 0 to ", mesh.GetNumberOfVertices() - 1);
  }
  if (this->On == Support::Near)
  {
    return InvalidInput("The point near vertex ", this->Vertex, " is not on the mesh")
      .Fix("Use such points on clouds only");
  }
  if (this->Face < 0 || this->Face >= mesh.GetNumberOfFaces() || mesh.IsDropped(this->Face))
  {
    return InvalidInput("Face ", this->Face, " does not exist or has no area")
      .Fix("Use another face");
  }
  if (!AreBarycentric(this->Barycentric))
  {
    return InvalidInput("The barycentric coordinates (", this->Barycentric[0], ", ",
      this->Barycentric[1], ", ", this->Barycentric[2], ") in face ", this->Face,
      " are outside of the face")
      .Fix("Use non-negative numbers with the sum 1");
  }
  const std::array<double, 3>& b = this->Barycentric;
  const bool snapped = this->On == Support::Edge ? this->HalfEdge >= 3 * this->Face &&
      this->HalfEdge < 3 * this->Face + 3 && b[(this->HalfEdge + 2) % 3] == 0.0
                                                 : b[0] > 0.0 && b[1] > 0.0 && b[2] > 0.0;
  if (!snapped)
  {
    return InvalidInput(
      "The point in face ", this->Face, " does not lie on its vertex, edge or face")
      .Fix("Make the point with SurfacePoint::InFace() or OnEdge()");
  }
  return Status::Success();
}

bool IsSamePoint(const SurfacePoint& a, const SurfacePoint& b)
{
  if (IsVertex(a) || IsVertex(b))
  {
    return a.On == b.On && a.Vertex == b.Vertex;
  }
  // On and HalfEdge follow from these members.
  return a.Vertex == b.Vertex && a.Face == b.Face && a.Barycentric == b.Barycentric;
}

double UnrollFactor(const SurfaceMesh& mesh, const SurfacePoint& point)
{
  const bool isInterior = IsVertex(point) && mesh.Kind(point.Vertex) != VertexKind::Boundary &&
    mesh.TotalAngle(point.Vertex) > 0.0;
  return isInterior ? 2.0 * Pi / mesh.TotalAngle(point.Vertex) : 1.0;
}

Point2 PlaceInFrame(const SurfaceMesh& mesh, Id h, const std::array<double, 3>& b)
{
  const double end = b[(h + 1) % 3];
  const double apex = b[(h + 2) % 3];
  return { end * mesh.Length(h) + apex * mesh.ApexX(h), apex * mesh.ApexY(h) };
}

Point2 DirectionInFrame(const SurfaceMesh& mesh, Id from, Id to, const Point2& direction)
{
  const std::array<Point2, 3> corners = CornersInFrame(mesh, from);
  const Point2& a = corners[(to - from + 3) % 3];
  const Point2& b = corners[(to - from + 4) % 3];
  const double length = Distance(a, b);
  const Point2 axis{ (b.X - a.X) / length, (b.Y - a.Y) / length };
  return { Dot(axis, direction), Cross(axis, direction) };
}

double DistanceToCorner(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric, int k)
{
  return DistanceInFace(mesh, face, barycentric, CoordinatesOfCorner(k));
}

std::array<double, 3> ClampedToFace(std::array<double, 3> barycentric)
{
  double sum = 0.0;
  for (double& coordinate : barycentric)
  {
    coordinate = std::max(0.0, coordinate);
    sum += coordinate;
  }
  for (double& coordinate : barycentric)
  {
    coordinate /= sum;
  }
  return barycentric;
}

double DistanceInFace(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  // Displacement in barycentric coordinates, accurate for points close together.
  const Point2 d = PlaceInFrame(mesh, 3 * face, { { q[0] - p[0], q[1] - p[1], q[2] - p[2] } });
  return Norm(d.X, d.Y);
}
}
