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

/// Returns a point of a face of a mesh as a point of a submesh that contains the face.
SurfacePoint ToSubMesh(const SurfaceMesh& parent, const SurfacePoint& point, Id face,
  const SubMesh& subMesh, const SurfaceMesh& mesh)
{
  std::array<double, 3> barycentric{};
  FindInFace(parent, point, face, barycentric);
  const auto found = std::find(subMesh.Faces.begin(), subMesh.Faces.end(), face);
  return SurfacePoint::InFace(mesh, static_cast<Id>(found - subMesh.Faces.begin()), barycentric);
}
}

PathCorridor::PathCorridor(const SurfaceMesh& mesh, const std::uint8_t* isRim)
  : Mesh(mesh)
  , IsRim(isRim)
  , Selector(mesh)
{
}

bool PathCorridor::Shorten(double detour, SurfacePath& path)
{
  this->WasStopped = false;
  this->HasMetRim = false;
  if (path.Faces.size() < 2)
  {
    return false;
  }
  this->Selector.Clear();
  this->Vertices.clear();
  this->Length = path.Length;
  this->Detour = detour;
  this->LayPath(path);
  this->Grow();
  const SubMesh corridor = this->Selector.Take();
  for (std::size_t v = 0; v < this->Vertices.size() && this->IsRim; ++v)
  {
    this->HasMetRim =
      this->HasMetRim || (this->Vertices[v].IsNear && this->IsRim[corridor.Points[v].Vertex]);
  }
  SurfaceMesh mesh;
  if (!corridor.Build(this->Mesh, mesh).IsOk())
  {
    return false;
  }
  ExactPathFinder finder(mesh);
  std::vector<SurfacePath> found;
  std::size_t reports = LeastReports + corridor.Faces.size() / FacesPerReport;
  const Status status = finder.Find(
    ToSubMesh(this->Mesh, path.Points.front(), path.Faces.front(), corridor, mesh),
    { ToSubMesh(this->Mesh, path.Points.back(), path.Faces.back(), corridor, mesh) },
    [&](double) { return reports-- > 0; }, found, path.Length * (1.0 + Margin));
  this->WasStopped = status.IsAborted();
  if (!status.IsOk() || found.front().IsEmpty() ||
    !(found.front().Length < path.Length * (1.0 - LengthTolerance)))
  {
    return false;
  }
  SurfacePath shorter = corridor.ToParent(this->Mesh, mesh, found.front());
  shorter.Points.front() = path.Points.front();
  shorter.Points.back() = path.Points.back();
  shorter.Length = 0.0; // The ends may differ from the converted ones by rounding errors.
  for (std::size_t piece = 0; piece < shorter.Faces.size(); ++piece)
  {
    shorter.Length += MeasurePiece(this->Mesh, shorter, piece);
  }
  if (!(shorter.Length < path.Length * (1.0 - LengthTolerance)))
  {
    return false;
  }
  path = std::move(shorter);
  return true;
}

void PathCorridor::Put(Id v, const Point2& place, bool isNear)
{
  if (this->Selector.GetVertexId(v) != NoId)
  {
    Vertex& vertex = this->At(v);
    vertex.IsNear = vertex.IsNear || isNear;
    return;
  }
  this->Selector.AddVertex(v);
  this->Vertices.push_back({ place, isNear || this->IsWithin(place) });
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
      this->Selector.AddFace(f);
    }
    x += length;
  }
}

/// Grows the corridor face by face, over edges with an end that is near.
void PathCorridor::Grow()
{
  // NOLINTNEXTLINE(modernize-loop-convert): the list grows during the loop
  for (std::size_t next = 0; next < this->Selector.GetFaces().size(); ++next)
  {
    const Id f = this->Selector.GetFaces()[next];
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (!this->At(this->Mesh.Origin(h)).IsNear && !this->At(this->Mesh.Destination(h)).IsNear)
      {
        continue;
      }
      ForEachTwin(this->Mesh, h, [&](Id e) {
        const Id apex = this->Mesh.Apex(e);
        if (this->Selector.GetVertexId(apex) == NoId)
        {
          this->Put(apex, this->PlaceBehind(h, e), false);
        }
        this->Selector.AddFace(SurfaceMesh::Face(e));
      });
    }
  }
}

/// Returns the position of the apex of entry. It is on the opposite side of the edge from the apex
/// of exit.
Point2 PathCorridor::PlaceBehind(Id exit, Id entry)
{
  const Point2& a = this->At(this->Mesh.Origin(entry)).Place;
  const Point2& b = this->At(this->Mesh.Destination(entry)).Place;
  const Point2& own = this->At(this->Mesh.Apex(exit)).Place;
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
}
