// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSubMesh.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace dgg
{
void SubMesh::Glue(const std::vector<Offset>& places)
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

Status SubMesh::Build(const SurfaceMesh& parent, SurfaceMesh& mesh) const
{
  return SurfaceMesh::FromGluedLengths(this->GetNumberOfVertices(), this->Triangles.data(),
    this->GetNumberOfFaces(), this->Lengths.data(), this->Twins.data(), mesh,
    { &parent, this->Faces.data() });
}

SurfacePoint SubMesh::ToParent(
  const SurfaceMesh& parent, Id face, const std::array<double, 3>& barycentric) const
{
  std::array<double, 3> sum{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    std::array<double, 3> b{};
    FindInFace(parent, this->Points[this->Triangles[3 * face + k]], this->Faces[face], b);
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += barycentric[k] * b[c];
    }
  }
  return SurfacePoint::InTriangle(parent, this->Faces[face], sum);
}

SurfacePoint SubMesh::ToParent(
  const SurfaceMesh& parent, const SurfaceMesh& mesh, Id face, const SurfacePoint& point) const
{
  std::array<double, 3> barycentric{};
  FindInFace(mesh, point, face, barycentric);
  if (mesh.IsFlipped(face))
  {
    std::swap(barycentric[1], barycentric[2]);
  }
  return this->ToParent(parent, face, barycentric);
}

SurfacePath SubMesh::ToParent(
  const SurfaceMesh& parent, const SurfaceMesh& mesh, const SurfacePath& path) const
{
  SurfacePath onParent;
  for (std::size_t i = 0; i < path.Points.size(); ++i)
  {
    const SurfacePoint& point = path.Points[i];
    SurfacePoint inParent;
    if (point.On == SurfacePoint::Support::Vertex)
    {
      inParent = this->Points[point.Vertex];
    }
    else
    {
      const Id face = path.Faces.empty() ? point.Face : path.Faces[i > 0 ? i - 1 : 0];
      inParent = this->ToParent(parent, mesh, face, point);
    }
    const bool isInside = i > 0 && i + 1 < path.Points.size();
    if (isInside && point.On == SurfacePoint::Support::Edge &&
      inParent.On == SurfacePoint::Support::Face &&
      this->Faces[path.Faces[i - 1]] == this->Faces[path.Faces[i]])
    {
      continue; // the path does not bend within a face of the parent
    }
    onParent.Append(parent, inParent, i > 0 ? this->Faces[path.Faces[i - 1]] : NoId);
  }
  return onParent;
}

FaceSelector::FaceSelector(const SurfaceMesh& parent)
  : Parent(parent)
  , VertexIds(parent.GetNumberOfVertices(), NoId)
  , FaceIds(parent.GetNumberOfFaces(), NoId)
{
}

bool FaceSelector::AddFace(Id face)
{
  if (this->FaceIds[face] != NoId)
  {
    return false;
  }
  this->Selected.Faces.push_back(face);
  this->FaceIds[face] = this->Selected.GetNumberOfFaces() - 1;
  return true;
}

Id FaceSelector::AddVertex(Id vertex)
{
  if (this->VertexIds[vertex] == NoId)
  {
    this->Selected.Points.push_back(SurfacePoint::AtVertex(vertex));
    this->VertexIds[vertex] = this->Selected.GetNumberOfVertices() - 1;
  }
  return this->VertexIds[vertex];
}

SubMesh FaceSelector::Take()
{
  const SurfaceMesh& mesh = this->Parent;
  const std::size_t halfEdges = 3 * this->Selected.Faces.size();
  std::vector<Id> triangles(halfEdges);
  std::vector<double> lengths(halfEdges);
  std::vector<Id> twins(halfEdges);
  Id next = 0;
  for (const Id f : this->Selected.Faces)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h, ++next)
    {
      triangles[next] = this->AddVertex(mesh.Origin(h));
      lengths[next] = mesh.Length(h);
      twins[next] = this->FindTwin(h);
    }
  }
  SubMesh taken = this->Selected;
  taken.Triangles = std::move(triangles);
  taken.Lengths = std::move(lengths);
  taken.Twins = std::move(twins);
  this->Clear();
  return taken;
}

void FaceSelector::Clear()
{
  for (const Id f : this->Selected.Faces)
  {
    this->FaceIds[f] = NoId;
  }
  for (const SurfacePoint& point : this->Selected.Points)
  {
    this->VertexIds[point.Vertex] = NoId;
  }
  this->Selected.Faces.clear();
  this->Selected.Points.clear();
}

SubMesh FaceSelector::Select(const std::vector<Id>& faces)
{
  this->Clear();
  for (const Id f : faces)
  {
    this->AddFace(f);
  }
  return this->Take();
}

/// Returns the next half-edge of an edge within the selected faces, as a half-edge of the submesh.
Id FaceSelector::FindTwin(Id h) const
{
  for (Id e = this->Parent.Twin(h); e != NoId && e != h; e = this->Parent.Twin(e))
  {
    const Id f = SurfaceMesh::Face(e);
    if (this->FaceIds[f] != NoId)
    {
      return e + 3 * (this->FaceIds[f] - f);
    }
  }
  return NoId;
}

std::vector<std::vector<Id>> FindComponentFaces(const SurfaceMesh& mesh)
{
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  std::vector<std::vector<Id>> faces(static_cast<std::size_t>(count));
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (!mesh.IsDropped(f))
    {
      faces[components[mesh.Origin(3 * f)]].push_back(f);
    }
  }
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                [](const std::vector<Id>& component) { return component.empty(); }),
    faces.end());
  return faces;
}
}
