// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCurveMargin.h"

#include "dggUnfolding.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace dgg
{
namespace
{
/// Width of the margin as a fraction of the edges that it cuts.
constexpr double Width = 0.3;

/// A corner of the remaining polygon of a face.
struct Corner
{
  Id Vertex;
  std::array<double, 3> Barycentric;
};

class MarginRemover
{
public:
  MarginRemover(const SurfaceMesh& oldMesh, const SubMesh& surface,
    const std::vector<char>& isBlocked, const std::vector<char>& isCut, SubMesh& rest)
    : OldMesh(oldMesh)
    , Surface(surface)
    , IsBlocked(isBlocked)
    , IsCut(isCut)
    , Rest(rest)
    , NewPoints(2 * surface.Triangles.size(), NoId)
  {
  }

  void Run();

private:
  Corner CornerAt(Id h) const;
  Corner PointOn(Id h, bool nearOrigin);
  void AddPolygon(Id f, const std::vector<Corner>& polygon);
  void AddEdge(Id f, const Corner& a, const Corner& b);

  const SurfaceMesh& OldMesh;
  const SubMesh& Surface;
  const std::vector<char>& IsBlocked;
  const std::vector<char>& IsCut;
  SubMesh& Rest;
  std::vector<Id> NewPoints;  // two per half-edge: near its origin and near its end
  std::vector<Offset> Places; // per half-edge of the rest, the edge or face that contains it
};

void MarginRemover::Run()
{
  this->Rest = SubMesh();
  this->Rest.Points = this->Surface.Points;
  std::vector<Corner> polygon;
  for (Id f = 0; f < this->Surface.GetNumberOfFaces(); ++f)
  {
    polygon.clear();
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (!this->IsBlocked[this->Surface.Triangles[h]])
      {
        polygon.push_back(this->CornerAt(h));
        continue;
      }
      // Cut off the corner, or the strip along a side that is on a curve.
      const Id before = SurfaceMesh::Previous(h);
      if (!this->IsCut[before])
      {
        polygon.push_back(this->PointOn(before, false));
      }
      if (!this->IsCut[h])
      {
        polygon.push_back(this->PointOn(h, true));
      }
    }
    if (polygon.size() >= 3)
    {
      this->AddPolygon(f, polygon);
    }
  }
  this->Rest.Glue(this->Places);
}

Corner MarginRemover::CornerAt(Id h) const
{
  return { this->Surface.Triangles[h], CoordinatesOfCorner(h % 3) };
}

/// Returns the new point of a half-edge near one of its ends; both halves of an edge share it.
Corner MarginRemover::PointOn(Id h, bool nearOrigin)
{
  Corner corner{ NoId, { { 0.0, 0.0, 0.0 } } };
  corner.Barycentric[h % 3] = nearOrigin ? 1.0 - Width : Width;
  corner.Barycentric[(h + 1) % 3] = nearOrigin ? Width : 1.0 - Width;
  const Id t = this->Surface.Twins[h];
  const bool along = t != NoId && this->Surface.Triangles[t] == this->Surface.Triangles[h];
  Id& point = t != NoId && t < h ? this->NewPoints[2 * t + (nearOrigin == along ? 0 : 1)]
                                 : this->NewPoints[2 * h + (nearOrigin ? 0 : 1)];
  if (point == NoId)
  {
    point = this->Rest.GetNumberOfVertices();
    this->Rest.Points.push_back(
      this->Surface.ToParent(this->OldMesh, SurfaceMesh::Face(h), corner.Barycentric));
  }
  corner.Vertex = point;
  return corner;
}

/// Adds the remaining polygon of a face as a fan of triangles; it is convex.
void MarginRemover::AddPolygon(Id f, const std::vector<Corner>& polygon)
{
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    this->AddEdge(f, polygon[0], polygon[i]);
    this->AddEdge(f, polygon[i], polygon[i + 1]);
    this->AddEdge(f, polygon[i + 1], polygon[0]);
    this->Rest.Faces.push_back(this->Surface.Faces[f]);
  }
}

void MarginRemover::AddEdge(Id f, const Corner& a, const Corner& b)
{
  Offset where = static_cast<Offset>(this->Surface.Triangles.size()) + f;
  const double* lengths = this->Surface.Lengths.data() + 3 * static_cast<std::size_t>(f);
  const std::array<double, 3> d{ { b.Barycentric[0] - a.Barycentric[0],
    b.Barycentric[1] - a.Barycentric[1], b.Barycentric[2] - a.Barycentric[2] } };
  const Point2 apex = LayOut(lengths[0], lengths[2], lengths[1]);
  double length = Norm(d[1] * lengths[0] + d[2] * apex.X, d[2] * apex.Y);
  for (int k = 0; k < 3; ++k)
  {
    const int opposite = (k + 2) % 3;
    if (a.Barycentric[opposite] == 0.0 && b.Barycentric[opposite] == 0.0)
    {
      // Part of a side, identical in all faces of the edge.
      const Id h = 3 * f + k;
      const Id t = this->Surface.Twins[h];
      where = t != NoId && t < h ? t : h;
      length = lengths[k] * std::abs(d[k]);
    }
  }
  this->Places.push_back(where);
  this->Rest.Triangles.push_back(a.Vertex);
  this->Rest.Lengths.push_back(length);
}
}

void RemoveMargin(const SurfaceMesh& oldMesh, const SubMesh& surface,
  const std::vector<char>& isBlocked, const std::vector<char>& isCut, SubMesh& rest)
{
  MarginRemover(oldMesh, surface, isBlocked, isCut, rest).Run();
}
}
