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
UnfoldingTable::UnfoldingTable(
  const SurfaceMesh& mesh, std::vector<Id> order, const std::vector<std::uint8_t>& isRim)
  : Mesh(mesh)
  , Count(this->Measure())
  , Rim(isRim)
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
  this->Mirrors = this->Count.NeedsMirrors ? mesh.GetNumberOfHalfEdges() : 0;
  this->ListBranches();
  this->MeasureLastAngles();
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

void UnfoldingTable::MeasureLastAngles()
{
  this->LastAngles.resize(this->Order.size());
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    const double total = this->Mesh.TotalAngle(this->Order[i]);
    const auto last = static_cast<float>(total);
    const bool isBeyond = last > 0.0F && static_cast<double>(last) >= total;
    this->LastAngles[i] = isBeyond ? std::nextafter(last, 0.0F) : last;
  }
}

/// Moves an angle by the total angle of a vertex into the range of stored angles. On the boundary,
/// rounding errors are clamped at both ends instead of wrapping around.
double UnfoldingTable::Wrap(Id v, double angle) const
{
  const Id old = this->Order[v];
  const double turn =
    this->Mesh.Kind(old) == VertexKind::Boundary ? 0.0 : this->Mesh.TotalAngle(old);
  return angle + (angle < 0.0 ? turn : angle >= turn ? -turn : 0.0);
}

/// Orders the faces by their first vertex.
void UnfoldingTable::OrderFaces()
{
  this->FaceRank.assign(this->Mesh.GetNumberOfFaces(), NoId);
  Id next = 0;
  for (Id v = 0; v < this->GetNumberOfVertices(); ++v)
  {
    const Id old = this->Order[v];
    for (const Id* g = this->Mesh.FanBegin(old); g != this->Mesh.FanEnd(old); ++g)
    {
      Id& rank = this->FaceRank[SurfaceMesh::Face(*g)];
      if (rank == NoId)
      {
        rank = next++;
        if (static_cast<Offset>(this->FirstVertices.size()) * CrossingBlock::Size <
          3 * Offset(next))
        {
          this->FirstVertices.push_back(v);
        }
      }
    }
  }
}

std::size_t UnfoldingTable::GetMemorySize() const
{
  return this->Rim.capacity() + this->LastAngles.capacity() * sizeof(float) +
    sizeof(Id) *
    (this->Order.capacity() + this->Rank.capacity() + this->FaceRank.capacity() +
      this->FirstVertices.capacity() + this->Branches.capacity() +
      this->BranchPositions.capacity());
}

void UnfoldingTable::Fill(std::size_t index, CrossingBlock& block) const
{
  const Offset first = static_cast<Offset>(index) * CrossingBlock::Size;
  this->FillEntries(first, false, block);
  if (this->Mirrors > 0)
  {
    this->FillEntries(first - this->Mirrors, true, block);
  }
}

/// Fills the entries of a block that are mirrored or not; `first` is the number of such entries
/// before the block. Visits faces as OrderFaces() does, to find them by their rank.
void UnfoldingTable::FillEntries(Offset first, bool mirrored, CrossingBlock& block) const
{
  const Offset end = first + CrossingBlock::Size;
  const auto part = static_cast<std::size_t>(std::max<Offset>(0, first) / CrossingBlock::Size);
  Offset rank = static_cast<Offset>(part) * CrossingBlock::Size / 3;
  for (std::size_t v = part < this->FirstVertices.size() ? this->FirstVertices[part]
                                                         : this->Order.size();
       v < this->Order.size() && 3 * rank < end; ++v)
  {
    const Id old = this->Order[v];
    for (const Id* g = this->Mesh.FanBegin(old); g != this->Mesh.FanEnd(old); ++g)
    {
      const Id face = SurfaceMesh::Face(*g);
      if (this->FaceRank[face] != rank)
      {
        continue;
      }
      for (Id k = 0; k < 3; ++k)
      {
        const Offset i = 3 * rank + k - first;
        if (i >= 0 && i < CrossingBlock::Size)
        {
          block.Crossings[i] = this->MakeCrossing(3 * face + k, mirrored);
          block.PolarAngles[i] = this->Mesh.PolarAngle(3 * face + k);
        }
      }
      ++rank;
    }
  }
}

FaceCrossing UnfoldingTable::MakeCrossing(Id h, bool mirrored) const
{
  const EnteredFace entered(this->Mesh, h, mirrored);
  const FaceUnfolding& face = entered.Plane;
  FaceCrossing crossing;
  crossing.Apex = face.GetApex();
  crossing.Direction[FaceCrossing::Left] = { face.GetLeftCosine(), face.GetLeftSine() };
  crossing.Direction[FaceCrossing::Right] = { face.GetRightCosine(), -face.GetRightSine() };
  crossing.Behind[FaceCrossing::Left] = this->FindCodeBehind(entered.LeftEdge, mirrored);
  crossing.Behind[FaceCrossing::Right] = this->FindCodeBehind(entered.RightEdge, mirrored);
  crossing.ApexVertex = this->Rank[this->Mesh.Apex(h)];
  crossing.HalfEdge = mirrored ? ~h : h;
  return crossing;
}

/// Lists the faces around every non-manifold edge.
void UnfoldingTable::ListBranches()
{
  if (this->Count.BranchHalfEdges == 0)
  {
    return;
  }
  this->BranchPositions.assign(this->Mesh.GetNumberOfHalfEdges(), NoId);
  this->Branches.reserve(
    static_cast<std::size_t>(2 * (this->Count.BranchHalfEdges + this->Count.BranchEdges)));
  for (Id first = 0; first < this->Mesh.GetNumberOfHalfEdges(); ++first)
  {
    if (!this->Mesh.IsNonManifold(first) || this->BranchPositions[first] != NoId)
    {
      continue;
    }
    const std::size_t begin = this->Branches.size();
    ForEachHalfEdge(this->Mesh, first, [&](Id h) {
      this->BranchPositions[h] = static_cast<Id>(this->Branches.size());
      const bool ascends = this->Mesh.Origin(h) <= this->Mesh.Destination(h);
      this->Branches.push_back(this->Entry(h, !ascends));
      this->Branches.push_back(this->Entry(h, ascends));
    });
    const Id back = -static_cast<Id>(this->Branches.size() - begin);
    this->Branches.insert(this->Branches.end(), 2, back);
  }
}

/// Returns true if a face behind `exit` has a vertex on the rim.
bool UnfoldingTable::LeadsToRim(Id exit) const
{
  bool leadsToRim = false;
  ForEachTwin(this->Mesh, exit, [&](Id h) {
    for (const Id v : this->Mesh.GetTriangle(SurfaceMesh::Face(h)))
    {
      leadsToRim = leadsToRim || this->Rim[v] != 0;
    }
  });
  return leadsToRim;
}

/// Returns the code of the faces behind `exit`. The edge is left from its face or, if `mirrored`,
/// from the mirror image of the face. A neighbor of opposite orientation is unfolded as its mirror
/// image if this face is not.
Id UnfoldingTable::FindCodeBehind(Id exit, bool mirrored) const
{
  const Id twin = this->Mesh.Twin(exit);
  if (twin == NoId)
  {
    return NoId;
  }
  if (!this->Rim.empty() && this->LeadsToRim(exit))
  {
    return RimCode;
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
  return FirstBranch - (this->BranchPositions[exit] + (mirrored == descends ? 1 : 0));
}
}
