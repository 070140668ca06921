// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStraightWalk.h"

#include "dggStatus.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dgg
{
namespace
{
/// Maximum number of consecutive segments of zero length: a longer sequence makes no progress.
constexpr int MostEmptyPieces = 1000;
/// Maximum number of segments: among degenerate faces a walk may circulate forever.
constexpr std::size_t MostPieces = 1000000;

/// A position in a face and a direction, in the frame of a half-edge of the face.
struct Ray
{
  Id HalfEdge = NoId;
  Point2 Place;
  Point2 Direction; ///< unit vector
  /// True if the position is the origin of the half-edge: then the ray can only leave through the
  /// opposite edge.
  bool IsAtCorner = false;
};

/// The exit of a ray from its face.
struct Exit
{
  Id HalfEdge = NoId; ///< NoId if the ray does not leave
  double Distance = Infinity;
  double Parameter = 0.0; ///< along the half-edge
};

/// Returns the barycentric coordinates of a position given in the frame of half-edge h.
std::array<double, 3> CoordinatesOf(const SurfaceMesh& mesh, Id h, const Point2& place)
{
  std::array<double, 3> b{};
  const double apex = place.Y / mesh.ApexY(h);
  const double end = (place.X - apex * mesh.ApexX(h)) / mesh.Length(h);
  b[(h + 2) % 3] = apex;
  b[(h + 1) % 3] = end;
  b[h % 3] = 1.0 - apex - end;
  return ClampedToFace(b);
}

class Walk
{
public:
  Walk(const SurfaceMesh& mesh, double length, SurfacePath& path)
    : Mesh(mesh)
    , Remaining(length)
    , Path(path)
  {
  }

  void Start(const SurfacePoint& start, double angle)
  {
    this->Path.Points.push_back(start);
    if (!(this->Remaining > 0.0))
    {
      return;
    }
    Ray ray;
    bool goesOn = true;
    if (start.On == SurfacePoint::Support::Vertex)
    {
      goesOn = this->LeaveVertex(start.Vertex, angle, ray);
    }
    else
    {
      ray.HalfEdge = 3 * start.Face;
      ray.Place = PlaceInFrame(this->Mesh, ray.HalfEdge, start.Barycentric);
      ray.Direction = { std::cos(angle), std::sin(angle) };
      if (start.On == SurfacePoint::Support::Edge)
      {
        goesOn = this->LeaveEdge(start, ray);
      }
    }
    while (goesOn)
    {
      goesOn = this->CrossFace(ray);
    }
  }

private:
  /// Moves the ray into the next face if its direction leads out of the face of a point on an edge.
  bool LeaveEdge(const SurfacePoint& start, Ray& ray) const
  {
    ray = this->InFrameOf(start.HalfEdge, ray);
    ray.Place.Y = 0.0;
    return ray.Direction.Y >= 0.0 ||
      this->CrossEdge(start.HalfEdge, start.Barycentric[(start.HalfEdge + 1) % 3], ray);
  }

  /// Returns the same ray in the frame of another half-edge of its face.
  Ray InFrameOf(Id h, const Ray& ray) const
  {
    const Point2 start = CornersInFrame(this->Mesh, ray.HalfEdge)[(h - ray.HalfEdge + 3) % 3];
    const Point2 place = Difference(ray.Place, start);
    return { h, DirectionInFrame(this->Mesh, ray.HalfEdge, h, place),
      DirectionInFrame(this->Mesh, ray.HalfEdge, h, ray.Direction), false };
  }

  /// Starts from a vertex in a direction. Returns false if there is no face.
  bool LeaveVertex(Id vertex, double angle, Ray& ray) const
  {
    const double total = this->Mesh.TotalAngle(vertex);
    const bool isBoundary = this->Mesh.Kind(vertex) == VertexKind::Boundary;
    angle = isBoundary ? std::min(std::max(angle, 0.0), total)
                       : angle - total * std::floor(angle / total);
    for (const Id* g = this->Mesh.FanBegin(vertex); g != this->Mesh.FanEnd(vertex); ++g)
    {
      const double corner = this->Mesh.CornerAngle(*g);
      // The last corner absorbs rounding errors.
      if (angle - this->Mesh.PolarAngle(*g) <= corner || g + 1 == this->Mesh.FanEnd(vertex))
      {
        const double turn = std::min(std::max(angle - this->Mesh.PolarAngle(*g), 0.0), corner);
        ray = { *g, { 0.0, 0.0 }, { std::cos(turn), std::sin(turn) }, true };
        return true;
      }
    }
    return false;
  }

  Exit FindExit(const Ray& ray) const
  {
    const std::array<Point2, 3> corners = CornersInFrame(this->Mesh, ray.HalfEdge);
    Exit exit;
    for (int k = ray.IsAtCorner ? 1 : 0; k < (ray.IsAtCorner ? 2 : 3); ++k)
    {
      const Point2& a = corners[k];
      const Point2& b = corners[(k + 1) % 3];
      const Point2 edge = Difference(b, a);
      const Point2 place = Difference(ray.Place, a);
      const double outwards = -Cross(edge, ray.Direction);
      const double distance = std::max(0.0, Cross(edge, place)) / outwards;
      if (outwards > 0.0 && distance < exit.Distance)
      {
        exit.HalfEdge = ray.HalfEdge - ray.HalfEdge % 3 + (ray.HalfEdge + k) % 3;
        exit.Distance = distance;
        const Point2 meet{ place.X + distance * ray.Direction.X,
          place.Y + distance * ray.Direction.Y };
        exit.Parameter = std::min(std::max(Dot(edge, meet) / Dot(edge, edge), 0.0), 1.0);
      }
    }
    return exit;
  }

  /// Advances to the end of the walk, or through the boundary of the face into the next one.
  /// Returns false at the end.
  bool CrossFace(Ray& ray)
  {
    const Id face = SurfaceMesh::Face(ray.HalfEdge);
    const Exit exit = this->FindExit(ray);
    if (exit.HalfEdge == NoId || exit.Distance >= this->Remaining)
    {
      const double step = exit.HalfEdge == NoId ? 0.0 : this->Remaining;
      const Point2 place{ ray.Place.X + step * ray.Direction.X,
        ray.Place.Y + step * ray.Direction.Y };
      this->Append(face,
        SurfacePoint::InTriangle(this->Mesh, face, CoordinatesOf(this->Mesh, ray.HalfEdge, place)));
      return false;
    }
    const SurfacePoint point = SurfacePoint::OnEdge(this->Mesh, exit.HalfEdge, exit.Parameter);
    const double before = this->Path.Length;
    this->Append(face, point);
    this->Remaining -= exit.Distance;
    this->EmptyPieces = this->Path.Length > before ? 0 : this->EmptyPieces + 1;
    if (!(this->Remaining > 0.0) || this->EmptyPieces > MostEmptyPieces ||
      this->Path.Faces.size() > MostPieces)
    {
      return false;
    }
    ray = this->InFrameOf(exit.HalfEdge, ray);
    if (point.On == SurfacePoint::Support::Vertex)
    {
      return this->CrossVertex(point.Vertex, exit, ray);
    }
    return this->CrossEdge(exit.HalfEdge, exit.Parameter, ray);
  }

  void Append(Id face, const SurfacePoint& point)
  {
    if (this->Path.Append(this->Mesh, point, face) == 0.0)
    {
      this->Path.Points.pop_back();
      this->Path.Faces.pop_back();
    }
  }

  /// Crosses an edge; `ray` is in the frame of the half-edge and leads across it.
  bool CrossEdge(Id h, double parameter, Ray& ray) const
  {
    const Id twin = this->Mesh.Twin(h);
    if (twin == NoId)
    {
      return false;
    }
    const bool isOpposite = this->Mesh.Origin(twin) == this->Mesh.Destination(h);
    const double length = this->Mesh.Length(h);
    const double forward = isOpposite ? -ray.Direction.X : ray.Direction.X;
    ray = { twin, { length * (isOpposite ? 1.0 - parameter : parameter), 0.0 },
      { forward, -ray.Direction.Y }, false };
    return true;
  }

  /// Passes a vertex; `ray` is in the frame of the half-edge, at one end of it.
  bool CrossVertex(Id vertex, const Exit& exit, Ray& ray) const
  {
    if (this->Mesh.Kind(vertex) == VertexKind::Boundary)
    {
      return false;
    }
    const Id out = exit.Parameter < 0.5 ? exit.HalfEdge : SurfaceMesh::Next(exit.HalfEdge);
    const Point2 direction = this->InFrameOf(out, ray).Direction;
    const double back = std::atan2(-direction.Y, -direction.X);
    const double turn = std::min(std::max(back, 0.0), this->Mesh.CornerAngle(out));
    const double arrival = this->Mesh.PolarAngle(out) + turn;
    return this->LeaveVertex(vertex, arrival + 0.5 * this->Mesh.TotalAngle(vertex), ray);
  }

  const SurfaceMesh& Mesh;
  double Remaining;
  SurfacePath& Path;
  int EmptyPieces = 0;
};
}

double DirectionAt(const SurfaceMesh& mesh, const SurfacePoint& point, double angle)
{
  if (point.On != SurfacePoint::Support::Vertex || angle >= 0.0 ||
    mesh.Kind(point.Vertex) != VertexKind::Boundary)
  {
    return angle;
  }
  const double beyond = angle + 2.0 * Pi - mesh.TotalAngle(point.Vertex);
  return beyond < -angle ? angle + 2.0 * Pi : 0.0;
}

Status WalkStraight(const SurfaceMesh& mesh, const SurfacePoint& start, double angle, double length,
  SurfacePath& path)
{
  path.Clear();
  DGG_RETURN_IF_ERROR(start.Check(mesh));
  if (!std::isfinite(angle) || !(length >= 0.0 && length < Infinity))
  {
    return InvalidInput("The walk has the direction ", angle, " and the length ", length)
      .Fix("Use a finite angle and a finite length of at least 0");
  }
  Walk(mesh, length, path).Start(start, angle);
  return Status::Success();
}
}
