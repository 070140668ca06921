// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggUnfoldingTable.h"

#include "dggEdges.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dgg
{
UnfoldingTable::UnfoldingTable(const SurfaceMesh& mesh, std::vector<Id> order)
  : Mesh(mesh)
  , Count(this->Measure())
  , Order(std::move(order))
  , Rank(this->Order.size())
{
  if (!this->Check().IsOk())
  {
    return;
  }
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    this->Rank[this->Order[i]] = static_cast<Id>(i);
  }
  this->OrderFaces();
  const bool mirrors = this->Count.NeedsMirrors;
  this->Mirrors = mirrors ? mesh.GetNumberOfHalfEdges() : 0;
  this->Crossings.resize(static_cast<std::size_t>(mesh.GetNumberOfHalfEdges()) * (mirrors ? 2 : 1));
  const std::vector<Id> places = this->ListBranches();
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsDropped(SurfaceMesh::Face(h)))
    {
      this->Fill(h, false, places);
      if (mirrors)
      {
        this->Fill(h, true, places);
      }
    }
  }
  this->FillAngles();
}

UnfoldingTable::Extent UnfoldingTable::Measure() const
{
  Extent count;
  count.HalfEdges = this->Mesh.GetNumberOfHalfEdges();
  for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id twin = this->Mesh.Twin(h);
    if (this->Mesh.IsNonManifold(h))
    {
      count.NeedsMirrors = true;
      ++count.BranchHalfEdges;
    }
    else if (twin != NoId && this->Mesh.Origin(twin) != this->Mesh.Destination(h))
    {
      count.NeedsMirrors = true;
    }
  }
  // Every such edge has at least three faces.
  count.BranchEdges = count.BranchHalfEdges / 3;
  return count;
}

Status UnfoldingTable::CheckSize(const Extent& count)
{
  // Every entry is an Id, and so is every code, down to FirstBranch minus the last position.
  constexpr Offset limit = std::numeric_limits<Id>::max();
  const Offset crossings = (count.NeedsMirrors ? 2 : 1) * count.HalfEdges;
  const Offset places = 2 * (count.BranchHalfEdges + count.BranchEdges);
  if (crossings <= limit && places <= limit)
  {
    return Status::Success();
  }
  return InvalidInput("The mesh has ", count.HalfEdges / 3, " triangles",
    count.BranchHalfEdges > 0
      ? JoinText(" and non-manifold edges of ", count.BranchHalfEdges, " triangles in all")
      : "",
    ", too many for a graph")
    .Fix(count.NeedsMirrors ? "Make it an oriented manifold, or simplify it" : "Simplify it");
}

void UnfoldingTable::FillAngles()
{
  this->PolarAngles.resize(this->Mesh.GetNumberOfHalfEdges());
  for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
  {
    this->PolarAngles[this->EntryOf(h)] = this->Mesh.PolarAngle(h);
  }
  this->Ranges.resize(this->Order.size());
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    const double total = this->Mesh.TotalAngle(this->Order[i]);
    AngleRange& range = this->Ranges[i];
    // On the boundary, rounding errors are clamped at both ends instead of wrapping around.
    range.Turn = this->Mesh.Kind(this->Order[i]) == VertexKind::Boundary ? 0.0 : total;
    range.Last = static_cast<float>(total);
    if (range.Last > 0.0F && static_cast<double>(range.Last) >= total)
    {
      range.Last = std::nextafter(range.Last, 0.0F);
    }
  }
}

/// Orders the faces by their first vertex.
void UnfoldingTable::OrderFaces()
{
  const Id m = this->Mesh.GetNumberOfFaces();
  this->FaceRank.assign(m, NoId);
  Id next = 0;
  for (const Id v : this->Order)
  {
    for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
    {
      Id& rank = this->FaceRank[SurfaceMesh::Face(*g)];
      if (rank == NoId)
      {
        rank = next++;
      }
    }
  }
  for (Id& rank : this->FaceRank) // dropped faces
  {
    if (rank == NoId)
    {
      rank = next++;
    }
  }
}

void UnfoldingTable::Fill(Id h, bool mirrored, const std::vector<Id>& places)
{
  const EnteredFace entered(this->Mesh, h, mirrored);
  const FaceUnfolding& face = entered.Plane;
  FaceCrossing& crossing = this->Crossings[this->Entry(h, mirrored)];
  crossing.Apex = face.GetApex();
  crossing.Direction[FaceCrossing::Left] = { face.GetLeftCosine(), face.GetLeftSine() };
  crossing.Direction[FaceCrossing::Right] = { face.GetRightCosine(), -face.GetRightSine() };
  crossing.Behind[FaceCrossing::Left] = this->FindCodeBehind(entered.LeftEdge, mirrored, places);
  crossing.Behind[FaceCrossing::Right] = this->FindCodeBehind(entered.RightEdge, mirrored, places);
  crossing.ApexVertex = this->Rank[this->Mesh.Apex(h)];
  crossing.HalfEdge = mirrored ? ~h : h;
}

/// Lists the faces around every non-manifold edge. Returns the position of each half-edge of such
/// an edge in the first of the two lists of the edge; empty if all edges are manifold.
std::vector<Id> UnfoldingTable::ListBranches()
{
  std::vector<Id> places;
  if (this->Count.BranchHalfEdges == 0)
  {
    return places;
  }
  places.assign(this->Mesh.GetNumberOfHalfEdges(), NoId);
  this->Branches.reserve(
    static_cast<std::size_t>(2 * (this->Count.BranchHalfEdges + this->Count.BranchEdges)));
  for (Id first = 0; first < this->Mesh.GetNumberOfHalfEdges(); ++first)
  {
    if (!this->Mesh.IsNonManifold(first) || places[first] != NoId)
    {
      continue;
    }
    const std::size_t begin = this->Branches.size();
    ForEachHalfEdge(this->Mesh, first, [&](Id h) {
      places[h] = static_cast<Id>(this->Branches.size());
      const bool ascends = this->Mesh.Origin(h) <= this->Mesh.Destination(h);
      this->Branches.push_back(this->Entry(h, !ascends));
      this->Branches.push_back(this->Entry(h, ascends));
    });
    const Id back = -static_cast<Id>(this->Branches.size() - begin);
    this->Branches.insert(this->Branches.end(), 2, back);
  }
  return places;
}

/// Returns the code of the faces behind `exit`. The edge is left from its face or, if `mirrored`,
/// from the mirror image of the face. A neighbor of opposite orientation is unfolded as its mirror
/// image if this face is not.
Id UnfoldingTable::FindCodeBehind(Id exit, bool mirrored, const std::vector<Id>& places) const
{
  const Id twin = this->Mesh.Twin(exit);
  if (twin == NoId)
  {
    return NoId;
  }
  if (!this->Mesh.IsNonManifold(exit))
  {
    const bool alike = this->Mesh.Origin(twin) == this->Mesh.Destination(exit);
    return this->Entry(twin, mirrored == alike);
  }
  // An unmirrored window that leaves through a descending half-edge enters ascending half-edges
  // unmirrored and descending half-edges mirrored: this is the first list. If the window is
  // mirrored or the half-edge ascending, the roles are swapped.
  const bool descends = this->Mesh.Destination(exit) <= this->Mesh.Origin(exit);
  return FirstBranch - (places[exit] + (mirrored == descends ? 1 : 0));
}
}
