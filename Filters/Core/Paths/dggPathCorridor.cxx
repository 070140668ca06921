// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathCorridor.h"

#include "dggExactPath.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
/// Minimum relative gain for which a path is replaced.
constexpr double LengthTolerance = 1e-13;
/// Relative margin of the solver's radius beyond the length of the path, for rounding errors.
constexpr double Margin = 1e-9;
/// The solver is stopped after this minimum number of progress reports (one per 20000 windows),
/// plus one per this number of faces. Twenty windows per face are common in corridors of thousands
/// of faces; the solver is stopped beyond a hundred.
constexpr std::size_t LeastReports = 10;
constexpr std::size_t FacesPerReport = 200;
}

PathCorridor::PathCorridor(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Vertices(mesh.GetNumberOfVertices())
  , FaceRuns(mesh.GetNumberOfFaces(), 0)
{
}

bool PathCorridor::Shorten(double detour, SurfacePath& path)
{
  this->WasStopped = false;
  if (path.Faces.size() < 2)
  {
    return false;
  }
  this->Begin();
  this->Length = path.Length;
  this->Detour = detour;
  this->LayPath(path);
  this->Grow();
  SurfaceMesh part;
  if (!this->Build(part).IsOk())
  {
    return false;
  }
  ExactPathFinder finder(part);
  std::vector<SurfacePath> found;
  std::size_t reports = LeastReports + this->Faces.size() / FacesPerReport;
  const Status status = finder.Find(
    this->ToPart(part, path.Points.front(), path.Faces.front()),
    { this->ToPart(part, path.Points.back(), path.Faces.back()) },
    [&](double) { return reports-- > 0; }, found, path.Length * (1.0 + Margin));
  this->WasStopped = status.IsAborted();
  if (!status.IsOk() || found.front().IsEmpty() ||
    !(found.front().Length < path.Length * (1.0 - LengthTolerance)))
  {
    return false;
  }
  SurfacePath shorter;
  for (const SurfacePoint& point : found.front().Points)
  {
    shorter.Points.push_back(this->FromPart(part, point));
  }
  shorter.Points.front() = path.Points.front();
  shorter.Points.back() = path.Points.back();
  for (const Id face : found.front().Faces)
  {
    shorter.Faces.push_back(this->Faces[face]);
    shorter.Length += MeasurePiece(this->Mesh, shorter, shorter.Faces.size() - 1);
  }
  if (!(shorter.Length < path.Length * (1.0 - LengthTolerance)))
  {
    return false;
  }
  path = std::move(shorter);
  return true;
}

void PathCorridor::Begin()
{
  if (++this->Run == 0) // after four billion runs
  {
    std::fill(this->Vertices.begin(), this->Vertices.end(), Vertex());
    std::fill(this->FaceRuns.begin(), this->FaceRuns.end(), 0);
    this->Run = 1;
  }
  this->Faces.clear();
  this->PartVertices.clear();
  this->Triangles.clear();
  this->Lengths.clear();
}

void PathCorridor::Put(Id v, const Point2& place, bool isNear)
{
  Vertex& vertex = this->Vertices[v];
  if (vertex.Run == this->Run)
  {
    vertex.IsNear = vertex.IsNear || isNear;
    return;
  }
  vertex.Run = this->Run;
  vertex.Local = static_cast<Id>(this->PartVertices.size());
  vertex.Place = place;
  vertex.IsNear = isNear || this->IsWithin(place);
  this->PartVertices.push_back(v);
}

void PathCorridor::AddFace(Id f)
{
  if (this->FaceRuns[f] != this->Run)
  {
    this->FaceRuns[f] = this->Run;
    this->Faces.push_back(f);
  }
}

/// Lays out the path along the x axis.
void PathCorridor::LayPath(const SurfacePath& path)
{
  double x = 0.0;
  for (std::size_t i = 0; i < path.Faces.size(); ++i)
  {
    const Id f = path.Faces[i];
    const Id h = 3 * f;
    std::array<double, 3> from{};
    std::array<double, 3> to{};
    FindInFace(this->Mesh, path.Points[i], f, from);
    FindInFace(this->Mesh, path.Points[i + 1], f, to);
    const Point2 p = PlaceInFrame(this->Mesh, h, from);
    const Point2 ray = Difference(PlaceInFrame(this->Mesh, h, to), p);
    const double length = Norm(ray.X, ray.Y);
    if (length > 0.0)
    {
      const Point2 axis{ ray.X / length, ray.Y / length };
      for (int k = 0; k < 3; ++k)
      {
        const Point2 c = Difference(PlaceInFrame(this->Mesh, h, CoordinatesOfCorner(k)), p);
        this->Put(this->Mesh.Origin(h + k), { x + Dot(axis, c), dgg::Cross(axis, c) }, true);
      }
      this->AddFace(f);
    }
    x += length;
  }
}

/// Grows the corridor face by face, over edges with an end that is near.
void PathCorridor::Grow()
{
  // NOLINTNEXTLINE(modernize-loop-convert): the list grows during the loop
  for (std::size_t next = 0; next < this->Faces.size(); ++next)
  {
    const Id f = this->Faces[next];
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (!this->Vertices[this->Mesh.Origin(h)].IsNear &&
        !this->Vertices[this->Mesh.Destination(h)].IsNear)
      {
        continue;
      }
      ForEachTwin(this->Mesh, h, [&](Id e) {
        const Id apex = this->Mesh.Apex(e);
        if (!this->Find(apex))
        {
          this->Put(apex, this->PlaceBehind(h, e), false);
        }
        this->AddFace(SurfaceMesh::Face(e));
      });
    }
  }
}

/// Returns the position of the apex behind an edge, on the other side of the edge than its own
/// apex.
Point2 PathCorridor::PlaceBehind(Id exit, Id entry)
{
  const Point2& a = this->Vertices[this->Mesh.Origin(entry)].Place;
  const Point2& b = this->Vertices[this->Mesh.Destination(entry)].Place;
  const Point2& own = this->Vertices[this->Mesh.Apex(exit)].Place;
  const Point2 edge = Difference(b, a);
  const double length = Norm(edge.X, edge.Y);
  if (!(length > 0.0))
  {
    return a;
  }
  const double side = dgg::Cross(edge, Difference(own, a)) > 0.0 ? -1.0 : 1.0;
  return FromFrame(a, { edge.X / length, edge.Y / length },
    { this->Mesh.ApexX(entry), side * this->Mesh.ApexY(entry) });
}

bool PathCorridor::IsWithin(const Point2& place) const
{
  return Norm(place.X, place.Y) + Norm(this->Length - place.X, place.Y) <=
    this->Length * (1.0 + this->Detour);
}

Status PathCorridor::Build(SurfaceMesh& part)
{
  for (const Id f : this->Faces)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      this->Triangles.push_back(this->Vertices[this->Mesh.Origin(h)].Local);
      this->Lengths.push_back(this->Mesh.Length(h));
    }
  }
  return SurfaceMesh::FromLengths(static_cast<Offset>(this->PartVertices.size()),
    this->Triangles.data(), static_cast<Offset>(this->Faces.size()), this->Lengths.data(), part,
    { &this->Mesh, this->Faces.data() });
}

SurfacePoint PathCorridor::ToPart(const SurfaceMesh& part, const SurfacePoint& point, Id face) const
{
  if (point.On == SurfacePoint::Support::Vertex)
  {
    return SurfacePoint::AtVertex(this->Vertices[point.Vertex].Local);
  }
  std::array<double, 3> barycentric{};
  FindInFace(this->Mesh, point, face, barycentric);
  const auto place = std::find(this->Faces.begin(), this->Faces.end(), face);
  // The corners of the face were passed in the order of the mesh.
  return SurfacePoint::InFace(part, static_cast<Id>(place - this->Faces.begin()), barycentric);
}

SurfacePoint PathCorridor::FromPart(const SurfaceMesh& part, const SurfacePoint& point) const
{
  if (point.On == SurfacePoint::Support::Vertex)
  {
    return SurfacePoint::AtVertex(this->PartVertices[point.Vertex]);
  }
  // Restore the order in which the submesh was given its corners.
  std::array<double, 3> barycentric = point.Barycentric;
  if (part.IsFlipped(point.Face))
  {
    std::swap(barycentric[1], barycentric[2]);
  }
  return SurfacePoint::InTriangle(this->Mesh, this->Faces[point.Face], barycentric);
}
}
