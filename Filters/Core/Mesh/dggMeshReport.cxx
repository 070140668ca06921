// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMeshReport.h"

#include "dggCounted.h"
#include "dggDisjointSets.h"
#include "dggEdges.h"
#include "dggPoint3.h"
#include "dggStatus.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace dgg
{
namespace
{
void CountEdges(const SurfaceMesh& mesh, MeshReport& report, Offset& edges)
{
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (mesh.IsDropped(SurfaceMesh::Face(h)) || FindEdge(mesh, h) != h)
    {
      continue;
    }
    ++edges;
    const Id t = mesh.Twin(h);
    if (t == NoId)
    {
      ++report.BoundaryEdges;
    }
    else if (!mesh.IsNonManifold(h) && mesh.Origin(t) == mesh.Origin(h) &&
      mesh.Origin(h) != mesh.Destination(h))
    {
      ++report.InconsistentEdges;
    }
  }
}

/// Fans around each vertex: classes of outgoing half-edges joined across manifold edges, regardless
/// of the directions of the half-edges.
class FanCounter
{
public:
  explicit FanCounter(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , Fans(mesh.GetNumberOfHalfEdges())
  {
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Id t = mesh.Twin(h);
      if (t != NoId && mesh.Twin(t) == h)
      {
        const bool opposed = mesh.Origin(t) == mesh.Destination(h);
        this->Fans.Join(h, opposed ? SurfaceMesh::Next(t) : t);
        this->Fans.Join(SurfaceMesh::Next(h), opposed ? t : SurfaceMesh::Next(t));
      }
    }
  }

  /// Returns the corner that represents the fan of corner h. A corner is identified by its outgoing
  /// half-edge.
  Id Fan(Id h) { return this->Fans.Find(h); }

  Offset CountAt(Id v)
  {
    Offset fans = 0;
    for (const Id* h = this->Mesh.FanBegin(v); h != this->Mesh.FanEnd(v); ++h)
    {
      fans += this->Fan(*h) == *h ? 1 : 0;
    }
    return fans;
  }

private:
  const SurfaceMesh& Mesh;
  DisjointSets Fans;
};

bool TouchesNonManifoldEdge(const SurfaceMesh& mesh, Id v)
{
  return std::any_of(mesh.FanBegin(v), mesh.FanEnd(v),
    [&](Id h) { return mesh.IsNonManifold(h) || mesh.IsNonManifold(SurfaceMesh::Previous(h)); });
}

SurfaceDefects CountDefects(
  const SurfaceMesh& mesh, FanCounter& fans, const std::function<bool(Id)>& isCounted)
{
  SurfaceDefects defects;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const bool isDefect = mesh.IsNonManifold(h) && FindEdge(mesh, h) == h &&
      isCounted(std::min(mesh.Origin(h), mesh.Destination(h)));
    defects.NonManifoldEdges += isDefect ? 1 : 0;
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const bool isDefect = isCounted(v) && fans.CountAt(v) > 1 && !TouchesNonManifoldEdge(mesh, v);
    defects.NonManifoldVertices += isDefect ? 1 : 0;
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const bool isDefect = mesh.IsDuplicate(f) &&
      isCounted(std::min({ mesh.Origin(3 * f), mesh.Origin(3 * f + 1), mesh.Origin(3 * f + 2) }));
    defects.DuplicateFaces += isDefect ? 1 : 0;
  }
  return defects;
}

/// Returns the number of boundary loops. Each boundary half-edge is joined to the boundary
/// half-edge at the other side of the fan.
Offset CountBoundaryLoops(const SurfaceMesh& mesh, FanCounter& fans)
{
  // Each open fan has two boundary edges at its ends, which belong to the same loop.
  DisjointSets loops(mesh.GetNumberOfHalfEdges());
  std::vector<Id> endOfFan(mesh.GetNumberOfHalfEdges(), NoId);
  auto visit = [&](Id corner, Id edge) {
    Id& other = endOfFan[fans.Fan(corner)];
    if (other == NoId)
    {
      other = edge;
    }
    else
    {
      loops.Join(other, edge);
    }
  };
  std::vector<Id> boundary;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsDropped(SurfaceMesh::Face(h)) && mesh.Twin(h) == NoId)
    {
      boundary.push_back(h);
      visit(h, h);
      visit(SurfaceMesh::Next(h), h);
    }
  }
  return std::count_if(boundary.begin(), boundary.end(), [&](Id h) { return loops.Find(h) == h; });
}

double MeasureMedianAnisotropy(const SurfaceMesh& mesh)
{
  std::vector<double> elongations;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    MeanAnisotropy ofFace;
    ofFace.Add(mesh, f);
    if (ofFace.Area > 0.0)
    {
      elongations.push_back(ofFace.Get());
    }
  }
  if (elongations.empty())
  {
    return 0.0;
  }
  const auto middle = elongations.begin() + static_cast<std::ptrdiff_t>(elongations.size() / 2);
  std::nth_element(elongations.begin(), middle, elongations.end());
  return *middle;
}

/// Returns a hash of the bits of a point; -0 equals +0.
std::uint64_t HashPoint(const double* p)
{
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = p[axis] + 0.0;
    std::uint64_t word = 0;
    std::memcpy(&word, &x, sizeof(word));
    hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return hash;
}
}

SurfaceDefects CountDefects(const SurfaceMesh& mesh, const std::function<bool(Id)>& isCounted)
{
  FanCounter fans(mesh);
  return CountDefects(mesh, fans, isCounted);
}

std::vector<std::string> DescribeDefects(const SurfaceDefects& defects)
{
  std::vector<std::string> warnings;
  const auto warn = [&](Offset count, const char* noun, const char* what) {
    if (count > 0)
    {
      warnings.push_back(JoinText("The mesh has ", Counted(count, noun), what));
    }
  };
  warn(defects.NonManifoldEdges, "edge",
    " with more than two triangles. Paths may pass between any two of these triangles");
  warn(defects.NonManifoldVertices, "point",
    " where separate layers touch. Paths may pass between these layers");
  warn(defects.InconsistentEdges, "edge",
    " across which no orientation is consistent, as on a Moebius strip. Distances do not depend on "
    "orientation");
  warn(defects.DroppedCells, "polygon",
    " with fewer than three distinct points. Such polygons are ignored");
  warn(defects.Fans, "self-intersecting or self-touching polygon",
    ". Such polygons become fans around their first points. Triangulate them first if another "
    "shape is meant");
  warn(defects.DuplicateFaces, "triangle",
    " on the same three points as an earlier one. Such triangles are ignored");
  return warnings;
}

void MeanAnisotropy::Add(const SurfaceMesh& mesh, Id f)
{
  if (!mesh.IsDropped(f) && !mesh.IsDegenerate(f))
  {
    const double a = mesh.Length(3 * f);
    const double b = mesh.Length(3 * f + 1);
    const double c = mesh.Length(3 * f + 2);
    this->Weighted += std::max({ a, b, c }) * (a + b + c) / (4.0 * std::sqrt(3.0));
    this->Area += TriangleArea(a, b, c);
  }
}

MeanAnisotropy MeasureMeanAnisotropy(const SurfaceMesh& mesh)
{
  MeanAnisotropy mean;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    mean.Add(mesh, f);
  }
  return mean;
}

Offset CountCoincidentPoints(const double* points, Offset numberOfPoints)
{
  // The hash table of distinct points is at most half full.
  std::size_t size = 2;
  while (size < 2 * static_cast<std::size_t>(numberOfPoints))
  {
    size *= 2;
  }
  std::vector<Id> table(size, NoId);
  Offset count = 0;
  for (Offset i = 0; i < numberOfPoints; ++i)
  {
    const double* p = points + 3 * i;
    if (!IsFinite(PointAt(points, static_cast<Id>(i))))
    {
      continue;
    }
    std::size_t slot = HashPoint(p) & (size - 1);
    while (table[slot] != NoId && !std::equal(p, p + 3, points + 3 * Offset{ table[slot] }))
    {
      slot = (slot + 1) & (size - 1);
    }
    count += table[slot] == NoId ? 0 : 1;
    table[slot] = static_cast<Id>(i);
  }
  return count;
}

MeshReport InspectMesh(const SurfaceMesh& mesh, const double* points)
{
  MeshReport report;
  report.Vertices = mesh.GetNumberOfVertices();
  report.Faces = mesh.GetNumberOfFaces();
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    report.RepeatedVertexFaces += mesh.IsDropped(f) && !mesh.IsDuplicate(f) ? 1 : 0;
    report.ReorientedFaces += mesh.IsFlipped(f) ? 1 : 0;
  }
  Offset edges = 0;
  CountEdges(mesh, report, edges);

  FanCounter fanCounter(mesh);
  Offset fans = 0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Offset here = fanCounter.CountAt(v);
    fans += here;
    report.IsolatedVertices += here == 0 ? 1 : 0;
  }
  const SurfaceDefects defects = CountDefects(mesh, fanCounter, [](Id) { return true; });
  report.NonManifoldEdges = defects.NonManifoldEdges;
  report.NonManifoldVertices = defects.NonManifoldVertices;
  report.DuplicateFaces = defects.DuplicateFaces;
  report.BoundaryLoops = CountBoundaryLoops(mesh, fanCounter);
  report.DegenerateFaces = mesh.GetNumberOfDegenerateFaces();
  report.CoincidentPoints = points ? CountCoincidentPoints(points, report.Vertices) : 0;
  report.Mollification = mesh.GetMollification();
  const MeanAnisotropy mean = MeasureMeanAnisotropy(mesh);
  report.Area = mean.Area;
  report.MeanAnisotropy = mean.Get();
  report.MedianAnisotropy = MeasureMedianAnisotropy(mesh);

  Id components = 0;
  mesh.ComputeComponents(components);
  report.Components = components - report.IsolatedVertices;
  report.Orientable = report.InconsistentEdges == 0;

  // If every fan is a separate vertex, the surface is a manifold: chi = V - E + F = 2 C - 2 g - b.
  // The components of this manifold consist of faces joined by edges.
  if (report.NonManifoldEdges > 0 || !report.Orientable)
  {
    report.Genus = -1;
    return report;
  }
  DisjointSets sheets(static_cast<std::size_t>(mesh.GetNumberOfFaces()));
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (mesh.Twin(h) != NoId)
    {
      sheets.Join(SurfaceMesh::Face(h), SurfaceMesh::Face(mesh.Twin(h)));
    }
  }
  Offset numberOfSheets = 0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    numberOfSheets += !mesh.IsDropped(f) && sheets.Find(f) == f ? 1 : 0;
  }
  const Offset faces = report.Faces - report.RepeatedVertexFaces - report.DuplicateFaces;
  const Offset characteristic = fans - edges + faces;
  report.Genus = (2 * numberOfSheets - report.BoundaryLoops - characteristic) / 2;
  return report;
}
}
