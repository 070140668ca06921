// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggUnfoldingTable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
UnfoldingTable::UnfoldingTable(const SurfaceMesh& mesh, std::vector<Id> order)
  : Mesh(mesh)
  , Order(std::move(order))
  , Rank(this->Order.size())
{
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    this->Rank[this->Order[i]] = static_cast<Id>(i);
  }
  this->OrderFaces();
  const bool mirrors = this->NeedsMirrors();
  this->Mirrors = mirrors ? mesh.GetNumberOfHalfEdges() : 0;
  this->Crossings.resize(static_cast<std::size_t>(mesh.GetNumberOfHalfEdges()) * (mirrors ? 2 : 1));
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsDropped(SurfaceMesh::Face(h)))
    {
      this->Fill(h, false);
      if (mirrors)
      {
        this->Fill(h, true);
      }
    }
  }
  this->FillAngles();
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
    // On the boundary rounding is cut off at either end, nothing goes around.
    range.Turn = this->Mesh.Kind(this->Order[i]) == VertexKind::Boundary ? 0.0 : total;
    range.Last = static_cast<float>(total);
    if (range.Last > 0.0F && static_cast<double>(range.Last) >= total)
    {
      range.Last = std::nextafter(range.Last, 0.0F);
    }
  }
}

/// Faces in the order of their first vertex.
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

bool UnfoldingTable::NeedsMirrors() const
{
  for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id twin = this->Mesh.Twin(h);
    if (twin != NoId &&
      (this->Mesh.Twin(twin) != h || this->Mesh.Origin(twin) != this->Mesh.Destination(h)))
    {
      return true;
    }
  }
  return false;
}

void UnfoldingTable::Fill(Id h, bool mirrored)
{
  const Id previous = SurfaceMesh::Previous(h);
  const Id next = SurfaceMesh::Next(h);
  const double length = this->Mesh.Length(h);
  const Id leftExit = mirrored ? next : previous;
  const Id rightExit = mirrored ? previous : next;
  const double left = this->Mesh.Length(leftExit);
  const double right = this->Mesh.Length(rightExit);
  // Not length - ApexX for the mirror image: that is inaccurate for needles.
  const double x = mirrored ? FootOnEdge(length, left, right) : this->Mesh.ApexX(h);
  const FaceUnfolding face(length, { x, this->Mesh.ApexY(h) }, left, right);

  FaceCrossing& crossing = this->Crossings[this->Entry(h, mirrored)];
  crossing.Apex = { x, this->Mesh.ApexY(h) };
  crossing.Direction[FaceCrossing::Left] = { face.GetLeftCosine(), face.GetLeftSine() };
  crossing.Direction[FaceCrossing::Right] = { face.GetRightCosine(), -face.GetRightSine() };
  crossing.Behind[FaceCrossing::Left] = this->AddCodeBehind(leftExit, mirrored);
  crossing.Behind[FaceCrossing::Right] = this->AddCodeBehind(rightExit, mirrored);
  crossing.ApexVertex = this->Rank[this->Mesh.Apex(h)];
  crossing.HalfEdge = mirrored ? ~h : h;
}

/// The faces behind `exit`, left from its face or, if that is `mirrored`, from its mirror image. A
/// neighbour that is not oriented alike is seen in its mirror image if this face is not.
Id UnfoldingTable::AddCodeBehind(Id exit, bool mirrored)
{
  const auto entry = [&](Id e) {
    const bool alike = this->Mesh.Origin(e) == this->Mesh.Destination(exit);
    return this->Entry(e, mirrored == alike);
  };
  const Id twin = this->Mesh.Twin(exit);
  if (twin == NoId)
  {
    return NoId;
  }
  if (this->Mesh.Twin(twin) == exit)
  {
    return entry(twin);
  }
  const std::size_t begin = this->Branches.size();
  this->Branches.push_back(0);
  for (Id e = twin; e != exit; e = this->Mesh.Twin(e))
  {
    this->Branches.push_back(entry(e));
    ++this->Branches[begin];
  }
  return FirstBranch - static_cast<Id>(begin);
}

std::size_t UnfoldingTable::GetMemorySize() const
{
  return this->Crossings.size() * sizeof(FaceCrossing) + this->PolarAngles.size() * sizeof(double) +
    this->Ranges.size() * sizeof(AngleRange) +
    (this->Order.size() + this->Rank.size() + this->FaceRank.size() + this->Branches.size()) *
    sizeof(Id);
}
}
