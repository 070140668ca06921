// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBandBorder.h"

#include "dggDisjointSets.h"
#include "dggEdges.h"
#include "dggFaceTriangulation.h"
#include "dggProcessGroup.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace dgg
{
Status BandBorder::Connect(const std::vector<Id>& undecided)
{
  if (!this->Pieces)
  {
    return Status::Success();
  }
  std::vector<EdgeKey> open;
  for (const Id f : undecided)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (this->IsOnBorder(h))
      {
        open.push_back(this->MakeKey(h));
      }
    }
  }
  DGG_RETURN_IF_ERROR(this->Pieces->Group.JoinLists(open));
  const std::set<EdgeKey> all(open.begin(), open.end());
  this->HasEdges = !all.empty();
  const Id size = this->HasEdges ? this->Lines.GetSurface().GetNumberOfHalfEdges() : 0;
  for (Id h = 0; h < size; ++h)
  {
    if (this->IsOnBorder(h))
    {
      const EdgeKey key = this->MakeKey(h);
      if (all.count(key) > 0)
      {
        this->HalfEdges.emplace(key, h);
      }
    }
  }
  return Status::Success();
}

Status BandBorder::Exchange(const std::vector<Id>& front, const std::vector<Id>& bandOf,
  const std::function<void(Id face, Id band)>& offer) const
{
  struct Offered
  {
    EdgeKey Edge;
    Id Band;
  };
  if (!this->HasEdges)
  {
    return Status::Success();
  }
  std::vector<Offered> offers;
  for (const auto& [key, h] : this->HalfEdges)
  {
    const Id f = SurfaceMesh::Face(h);
    if (std::binary_search(front.begin(), front.end(), f))
    {
      offers.push_back({ key, bandOf[f] });
    }
  }
  DGG_RETURN_IF_ERROR(this->Pieces->Group.JoinLists(offers));
  for (const Offered& offered : offers)
  {
    const auto found = this->HalfEdges.find(offered.Edge);
    if (found != this->HalfEdges.end())
    {
      offer(SurfaceMesh::Face(found->second), offered.Band);
    }
  }
  return Status::Success();
}

Status BandBorder::Require(bool& condition) const
{
  return this->HasEdges ? this->Pieces->Group.Require(condition) : Status::Success();
}

Status BandBorder::SelectFirst(
  const std::vector<Id>& faces, const std::vector<Id>& firstOf, std::vector<Id>& selected) const
{
  struct Touch
  {
    EdgeKey Edge;
    FaceKey First; // of the component on the process
  };
  selected = firstOf;
  std::sort(selected.begin(), selected.end());
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  if (!this->HasEdges)
  {
    return Status::Success();
  }
  std::vector<Touch> all;
  for (const auto& [key, h] : this->HalfEdges)
  {
    const auto found = std::lower_bound(faces.begin(), faces.end(), SurfaceMesh::Face(h));
    if (found != faces.end() && *found == SurfaceMesh::Face(h))
    {
      all.push_back({ key, this->MakeFaceKey(firstOf[found - faces.begin()]) });
    }
  }
  DGG_RETURN_IF_ERROR(this->Pieces->Group.JoinLists(all));
  // Join components at common edges. The representative of a set is its first component, because
  // components are sorted.
  std::sort(
    all.begin(), all.end(), [](const Touch& a, const Touch& b) { return a.First < b.First; });
  DisjointSets sets(all.size());
  std::map<EdgeKey, Id> atEdge;
  std::map<FaceKey, Id> ofComponent;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Id touch = static_cast<Id>(i);
    sets.Join(touch, atEdge.emplace(all[i].Edge, touch).first->second);
    sets.Join(touch, ofComponent.emplace(all[i].First, touch).first->second);
  }
  const auto isLater = [&](Id face) {
    const auto found = ofComponent.find(this->MakeFaceKey(face));
    return found != ofComponent.end() && sets.Find(found->second) != found->second;
  };
  selected.erase(std::remove_if(selected.begin(), selected.end(), isLater), selected.end());
  return Status::Success();
}

/// Returns true if the face of a half-edge is in the piece of this process, the face behind is not,
/// and no line runs along the edge.
bool BandBorder::IsOnBorder(Id h) const
{
  const SubMesh& surface = this->Lines.GetSurface();
  const Id twin = surface.Twins[h];
  return twin != NoId && this->Field.IsTraced(surface.Faces[SurfaceMesh::Face(h)]) &&
    this->Field.IsReached(surface.Faces[SurfaceMesh::Face(twin)]) &&
    !this->Field.IsTraced(surface.Faces[SurfaceMesh::Face(twin)]) && !this->Lines.IsOnPath(h);
}

BandBorder::EdgeKey BandBorder::MakeKey(Id h) const
{
  const SubMesh& surface = this->Lines.GetSurface();
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const SurfacePoint& a = surface.Points[surface.Origin(h)];
  const SurfacePoint& b = surface.Points[surface.Destination(h)];
  // Parameter of a point on an edge; -1 if the point is not on the edge.
  const auto find = [&](const SurfacePoint& point, Id edge) {
    return IsVertex(point) ? (point.Vertex == mesh.Origin(edge)           ? 0.0
                                 : point.Vertex == mesh.Destination(edge) ? 1.0
                                                                          : -1.0)
      : point.On == SurfacePoint::Support::Edge && point.HalfEdge == edge
      ? point.Barycentric[(edge + 1) % 3]
      : -1.0;
  };
  const Id f = surface.Faces[SurfaceMesh::Face(h)];
  Id edge = NoId;
  double begin = -1.0;
  for (Id e = 3 * f; e < 3 * f + 3 && begin < 0.0; ++e)
  {
    edge = FindEdge(mesh, e);
    begin = std::min(find(a, edge), find(b, edge));
  }
  return { { this->Pieces->GetPointId(mesh.Origin(edge)),
    this->Pieces->GetPointId(mesh.Destination(edge)),
    std::llround(begin * static_cast<double>(GridPoint::One)) } };
}

BandBorder::FaceKey BandBorder::MakeFaceKey(Id face) const
{
  const std::vector<Id>& faces = this->Lines.GetSurface().Faces;
  const Offset cell = this->Pieces->GetCellId(faces[face]);
  Id first = face;
  while (first > 0 && this->Pieces->GetCellId(faces[first - 1]) == cell)
  {
    --first;
  }
  return { { cell, face - first } };
}
}
