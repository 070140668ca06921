// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCurveCut.h"

#include "dggDisjointSets.h"
#include "dggInvalidInput.h"

#include <algorithm>
#include <set>
#include <utility>

namespace dgg
{
namespace
{
/// An edge of a path in its direction.
using DirectedEdge = std::pair<Id, Id>;

/// Looks up the half-edges of the edges of paths, before and after the cut.
class SideFinder
{
public:
  SideFinder(const RefinedSurface& surface, const std::vector<std::vector<Id>>& paths)
    : Surface(surface)
    , Paths(paths)
  {
  }

  Status CheckEdges() const;
  void Run(CurveCut& cut);

private:
  enum class Defect
  {
    None,
    Crowded, ///< more than two faces
    Twisted  ///< two faces of opposite orientation
  };

  Defect FindDefect(Id h) const;
  Offset CountDefects(Defect defect, const std::vector<char>& isPassed) const;
  std::vector<char> MarkVertices() const;
  void CollectHalfEdges();
  EdgeSide FindSide(const CutSurface& cut, const DirectedEdge& edge, bool isLeft) const;

  Id Origin(Id h) const { return this->Surface.Triangles[h]; }
  Id Destination(Id h) const { return this->Surface.Triangles[SurfaceMesh::Next(h)]; }

  const RefinedSurface& Surface;
  const std::vector<std::vector<Id>>& Paths;
  std::vector<std::pair<DirectedEdge, Id>> HalfEdges; // at vertices of paths, sorted
};

std::vector<char> SideFinder::MarkVertices() const
{
  std::vector<char> isPassed(this->Surface.GetNumberOfVertices(), 0);
  for (const std::vector<Id>& path : this->Paths)
  {
    for (std::size_t i = 0; i < path.size() && path.size() > 1; ++i)
    {
      isPassed[path[i]] = 1;
    }
  }
  return isPassed;
}

/// Returns the defect of the edge of a half-edge.
SideFinder::Defect SideFinder::FindDefect(Id h) const
{
  const Id twin = this->Surface.Twins[h];
  if (twin == NoId)
  {
    return Defect::None;
  }
  if (this->Surface.Twins[twin] != h)
  {
    return Defect::Crowded;
  }
  return this->Origin(h) == this->Origin(twin) ? Defect::Twisted : Defect::None;
}

/// Returns the number of edges of the old mesh that have a defect and a part touched by a path.
/// Parts of one edge meet in interior points, which are on no other edge.
Offset SideFinder::CountDefects(Defect defect, const std::vector<char>& isPassed) const
{
  const auto halfEdges = static_cast<Id>(this->Surface.Triangles.size());
  DisjointSets edges(this->Surface.Triangles.size());
  std::vector<Id> partAt(this->Surface.Points.size(), NoId);
  for (Id h = 0; h < halfEdges; ++h)
  {
    if (this->FindDefect(h) != defect)
    {
      continue;
    }
    edges.Join(h, this->Surface.Twins[h]);
    for (const Id v : { this->Origin(h), this->Destination(h) })
    {
      if (this->Surface.Points[v].On == SurfacePoint::Support::Edge)
      {
        edges.Join(h, partAt[v] == NoId ? h : partAt[v]);
        partAt[v] = h;
      }
    }
  }
  std::set<Id> touched;
  for (Id h = 0; h < halfEdges; ++h)
  {
    if (this->FindDefect(h) == defect &&
      (isPassed[this->Origin(h)] || isPassed[this->Destination(h)]))
    {
      touched.insert(edges.Find(h));
    }
  }
  return static_cast<Offset>(touched.size());
}

/// Checks that there are two sides wherever a path passes.
Status SideFinder::CheckEdges() const
{
  const std::vector<char> isPassed = this->MarkVertices();
  bool isSound = true;
  for (Id h = 0; h < static_cast<Id>(this->Surface.Twins.size()) && isSound; ++h)
  {
    isSound = (!isPassed[this->Origin(h)] && !isPassed[this->Destination(h)]) ||
      this->FindDefect(h) == Defect::None;
  }
  if (isSound)
  {
    return Status::Success();
  }
  return InvalidInput("curves have no sides where they meet ",
    this->CountDefects(Defect::Crowded, isPassed), " edges of more than two faces and ",
    this->CountDefects(Defect::Twisted, isPassed),
    " edges of two faces that are oriented differently. Remove sheets that stand on"
    " others, orient the faces alike, and do not draw curves across the seam"
    " of a one-sided surface");
}

void SideFinder::CollectHalfEdges()
{
  const std::vector<char> isPassed = this->MarkVertices();
  for (Id h = 0; h < static_cast<Id>(this->Surface.Triangles.size()); ++h)
  {
    if (isPassed[this->Origin(h)] && isPassed[this->Destination(h)])
    {
      this->HalfEdges.push_back({ { this->Origin(h), this->Destination(h) }, h });
    }
  }
  std::sort(this->HalfEdges.begin(), this->HalfEdges.end());
}

/// The face to the left of an edge contains it in the same direction.
EdgeSide SideFinder::FindSide(const CutSurface& cut, const DirectedEdge& edge, bool isLeft) const
{
  const DirectedEdge inFace = isLeft ? edge : DirectedEdge(edge.second, edge.first);
  const auto found =
    std::lower_bound(this->HalfEdges.begin(), this->HalfEdges.end(), std::make_pair(inFace, Id(0)));
  EdgeSide side;
  if (found != this->HalfEdges.end() && found->first == inFace)
  {
    const Id h = found->second;
    side.Face = SurfaceMesh::Face(h);
    side.From = cut.Triangles[isLeft ? h : SurfaceMesh::Next(h)];
    side.To = cut.Triangles[isLeft ? SurfaceMesh::Next(h) : h];
  }
  return side;
}

void SideFinder::Run(CurveCut& cut)
{
  this->CollectHalfEdges();
  cut.Sides.resize(this->Paths.size());
  for (std::size_t p = 0; p < cut.Sides.size(); ++p)
  {
    const std::vector<Id>& path = this->Paths[p];
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const DirectedEdge edge{ path[i], path[i + 1] };
      cut.Sides[p].Left.push_back(this->FindSide(cut.Surface, edge, true));
      cut.Sides[p].Right.push_back(this->FindSide(cut.Surface, edge, false));
    }
  }
}
}

Status CutAlongCurves(
  const RefinedSurface& surface, const std::vector<std::vector<Id>>& paths, CurveCut& cut)
{
  cut = CurveCut();
  SideFinder finder(surface, paths);
  DGG_RETURN_IF_ERROR(finder.CheckEdges());
  DGG_RETURN_IF_ERROR(CutAlongChains(surface, paths, cut.Surface));
  finder.Run(cut);
  return Status::Success();
}

Status CheckSides(const RefinedSurface& surface, const std::vector<std::vector<Id>>& paths)
{
  return SideFinder(surface, paths).CheckEdges();
}
}
