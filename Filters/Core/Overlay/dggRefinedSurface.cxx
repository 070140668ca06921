// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggRefinedSurface.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace dgg
{
void RefinedSurface::Glue(const std::vector<Offset>& places)
{
  using Key = std::tuple<Offset, Id, Id>; // place and ends
  std::vector<std::pair<Key, Id>> halfEdges;
  halfEdges.reserve(places.size());
  for (Id h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    const std::pair<Id, Id> ends = std::minmax(this->Origin(h), this->Destination(h));
    halfEdges.emplace_back(Key(places[h], ends.first, ends.second), h);
  }
  std::sort(halfEdges.begin(), halfEdges.end());
  this->Twins.assign(places.size(), NoId);
  for (std::size_t begin = 0; begin < halfEdges.size();)
  {
    std::size_t end = begin + 1;
    while (end < halfEdges.size() && halfEdges[end].first == halfEdges[begin].first)
    {
      ++end;
    }
    for (std::size_t i = begin; i < end && end - begin > 1; ++i)
    {
      this->Twins[halfEdges[i].second] = halfEdges[i + 1 == end ? begin : i + 1].second;
    }
    begin = end;
  }
}

Status RefinedSurface::Build(const SurfaceMesh& oldMesh, SurfaceMesh& mesh) const
{
  return SurfaceMesh::FromGluedLengths(this->GetNumberOfVertices(), this->Triangles.data(),
    this->GetNumberOfFaces(), this->Lengths.data(), this->Twins.data(), mesh,
    { &oldMesh, this->Faces.data() });
}

SurfacePoint RefinedSurface::ToOldMesh(
  const SurfaceMesh& oldMesh, Id face, const std::array<double, 3>& barycentric) const
{
  std::array<double, 3> sum{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    std::array<double, 3> b{};
    FindInFace(oldMesh, this->Points[this->Triangles[3 * face + k]], this->Faces[face], b);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += barycentric[k] * b[c];
    }
  }
  return SurfacePoint::InTriangle(oldMesh, this->Faces[face], sum);
}

SurfacePoint RefinedSurface::ToOldMesh(
  const SurfaceMesh& oldMesh, const SurfaceMesh& mesh, Id face, const SurfacePoint& point) const
{
  std::array<double, 3> barycentric{};
  FindInFace(mesh, point, face, barycentric);
  if (mesh.IsFlipped(face))
  {
    std::swap(barycentric[1], barycentric[2]);
  }
  return this->ToOldMesh(oldMesh, face, barycentric);
}

SurfacePath RefinedSurface::ToOldMesh(
  const SurfaceMesh& oldMesh, const SurfaceMesh& mesh, const SurfacePath& path) const
{
  SurfacePath old;
  for (std::size_t i = 0; i < path.Points.size(); ++i)
  {
    const SurfacePoint& point = path.Points[i];
    SurfacePoint oldPoint;
    if (point.On == SurfacePoint::Support::Vertex)
    {
      oldPoint = this->Points[point.Vertex];
    }
    else
    {
      const Id face = path.Faces.empty() ? point.Face : path.Faces[i > 0 ? i - 1 : 0];
      oldPoint = this->ToOldMesh(oldMesh, mesh, face, point);
    }
    const bool isInside = i > 0 && i + 1 < path.Points.size();
    if (isInside && point.On == SurfacePoint::Support::Edge &&
      oldPoint.On == SurfacePoint::Support::Face &&
      this->Faces[path.Faces[i - 1]] == this->Faces[path.Faces[i]])
    {
      continue; // the path does not bend within a face of the old mesh
    }
    old.Append(oldMesh, oldPoint, i > 0 ? this->Faces[path.Faces[i - 1]] : NoId);
  }
  return old;
}
}
