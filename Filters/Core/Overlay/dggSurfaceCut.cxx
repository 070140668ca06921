// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceCut.h"

#include "dggCounted.h"
#include "dggDisjointSets.h"
#include "dggPathEdges.h"
#include "dggStatus.h"

#include <cstddef>
#include <numeric>
#include <set>

namespace dgg
{
namespace
{
/// Opens the edges of paths, finds the sectors that they leave around each vertex, and gives each
/// sector a vertex of its own.
class PathCutter
{
public:
  PathCutter(const SubMesh& surface, const std::vector<std::vector<Id>>& paths)
    : Surface(surface)
    , Paths(paths)
    , Edges(surface, paths)
  {
  }

  Status CheckSides() const;
  Status Run(PinchedVertices pinched, SubMesh& cut) const;
  std::vector<CurveSides> FindSides(const SubMesh& cut) const;

private:
  enum class Defect
  {
    None,
    Crowded, ///< more than two faces
    Twisted  ///< two faces of opposite orientation
  };

  Defect FindDefect(Id h) const;
  bool IsAtPath(Id h) const
  {
    return this->Edges.IsVertexOnPath(this->Surface.Origin(h)) ||
      this->Edges.IsVertexOnPath(this->Surface.Destination(h));
  }
  Offset CountDefects(Defect defect) const;
  Status OpenEdges(SubMesh& cut) const;
  DisjointSets FindSectors(const SubMesh& cut) const;
  void CopyVertices(PinchedVertices pinched, SubMesh& cut) const;
  EdgeSide FindSide(const SubMesh& cut, Id from, Id to, bool isLeft) const;

  const SubMesh& Surface;
  const std::vector<std::vector<Id>>& Paths;
  const PathEdges Edges;
};

/// Returns the defect of the edge of a half-edge.
PathCutter::Defect PathCutter::FindDefect(Id h) const
{
  const Id twin = this->Surface.Twin(h);
  if (twin == NoId)
  {
    return Defect::None;
  }
  if (this->Surface.Twin(twin) != h)
  {
    return Defect::Crowded;
  }
  return this->Surface.Origin(h) == this->Surface.Origin(twin) ? Defect::Twisted : Defect::None;
}

/// Returns the number of edges of the parent that have a defect and a piece that touches a path.
/// Pieces of one edge meet in points inside the edge, which are on no other edge.
Offset PathCutter::CountDefects(Defect defect) const
{
  const Id halfEdges = this->Surface.GetNumberOfHalfEdges();
  DisjointSets edges(this->Surface.Triangles.size());
  std::vector<Id> pieceAt(this->Surface.Points.size(), NoId);
  for (Id h = 0; h < halfEdges; ++h)
  {
    if (this->FindDefect(h) != defect)
    {
      continue;
    }
    edges.Join(h, this->Surface.Twin(h));
    for (const Id v : { this->Surface.Origin(h), this->Surface.Destination(h) })
    {
      if (this->Surface.Points[v].On == SurfacePoint::Support::Edge)
      {
        edges.Join(h, pieceAt[v] == NoId ? h : pieceAt[v]);
        pieceAt[v] = h;
      }
    }
  }
  std::set<Id> touched;
  for (Id h = 0; h < halfEdges; ++h)
  {
    if (this->FindDefect(h) == defect && this->IsAtPath(h))
    {
      touched.insert(edges.Find(h));
    }
  }
  return static_cast<Offset>(touched.size());
}

Status PathCutter::CheckSides() const
{
  bool isSound = true;
  for (Id h = 0; h < this->Surface.GetNumberOfHalfEdges() && isSound; ++h)
  {
    isSound = !this->IsAtPath(h) || this->FindDefect(h) == Defect::None;
  }
  if (isSound)
  {
    return Status::Success();
  }
  return InvalidInput("Curves have no sides where they meet ",
    Counted(this->CountDefects(Defect::Crowded), "edge"), " of more than two faces and ",
    Counted(this->CountDefects(Defect::Twisted), "edge"),
    " of two faces with opposite orientations")
    .Fix("Make the surface an oriented manifold, and draw no curves across the seam of a one-sided "
         "surface");
}

Status PathCutter::Run(PinchedVertices pinched, SubMesh& cut) const
{
  cut = this->Surface;
  cut.Paths.clear();
  cut.Places.clear();
  Status status = this->OpenEdges(cut);
  if (status.IsOk())
  {
    this->CopyVertices(pinched, cut);
  }
  else
  {
    cut = SubMesh();
  }
  return status;
}

/// Separates the half-edges of the paths from their twins. Fails for an edge without half-edges.
Status PathCutter::OpenEdges(SubMesh& cut) const
{
  for (const std::vector<Id>& path : this->Paths)
  {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const std::vector<Id> halfEdges = this->Edges.Find(path[i], path[i + 1]);
      if (halfEdges.empty())
      {
        return InvalidInput(
          "Vertices ", path[i], " and ", path[i + 1], " of a chain are not neighbors");
      }
      for (const Id h : halfEdges)
      {
        cut.Twins[h] = NoId;
      }
    }
  }
  return Status::Success();
}

/// Returns the sectors as sets of corners: an edge that is not cut joins the corners at each end.
DisjointSets PathCutter::FindSectors(const SubMesh& cut) const
{
  DisjointSets sectors(cut.Triangles.size());
  for (Id h = 0; h < cut.GetNumberOfHalfEdges(); ++h)
  {
    const Id t = cut.Twin(h);
    if (t == NoId)
    {
      continue;
    }
    const Id hNext = SurfaceMesh::Next(h);
    const Id tNext = SurfaceMesh::Next(t);
    const bool along = this->Surface.Origin(h) == this->Surface.Origin(t);
    sectors.Join(h, along ? t : tNext);
    sectors.Join(hNext, along ? tNext : t);
  }
  return sectors;
}

/// Makes one copy per sector of the vertices that paths pass.
void PathCutter::CopyVertices(PinchedVertices pinched, SubMesh& cut) const
{
  DisjointSets sectors = this->FindSectors(cut);
  const Id vertices = this->Surface.GetNumberOfVertices();
  cut.VertexOf.resize(vertices);
  std::iota(cut.VertexOf.begin(), cut.VertexOf.end(), 0);
  std::vector<Id> copyOf(cut.Triangles.size(), NoId); // per corner that represents a sector
  std::vector<char> hasCopy(vertices, 0);
  for (Id h = 0; h < cut.GetNumberOfHalfEdges(); ++h)
  {
    const Id v = this->Surface.Origin(h);
    if (pinched == PinchedVertices::Stay && !this->Edges.IsVertexOnPath(v))
    {
      continue;
    }
    Id& copy = copyOf[sectors.Find(h)];
    if (copy == NoId)
    {
      copy = v;
      if (hasCopy[v])
      {
        copy = static_cast<Id>(cut.VertexOf.size());
        cut.VertexOf.push_back(v);
        cut.Points.push_back(this->Surface.Points[v]);
      }
      hasCopy[v] = 1;
    }
    cut.Triangles[h] = copy;
  }
}

/// Returns one side of an edge of a path. The half-edge of the face on the left runs along the
/// path, the half-edge of the face on the right against the path.
EdgeSide PathCutter::FindSide(const SubMesh& cut, Id from, Id to, bool isLeft) const
{
  EdgeSide side;
  for (const Id h : this->Edges.Find(from, to))
  {
    if (side.Face == NoId && this->Surface.Origin(h) == (isLeft ? from : to))
    {
      side.Face = SurfaceMesh::Face(h);
      side.From = isLeft ? cut.Origin(h) : cut.Destination(h);
      side.To = isLeft ? cut.Destination(h) : cut.Origin(h);
    }
  }
  return side;
}

std::vector<CurveSides> PathCutter::FindSides(const SubMesh& cut) const
{
  std::vector<CurveSides> sides(this->Paths.size());
  for (std::size_t p = 0; p < sides.size(); ++p)
  {
    const std::vector<Id>& path = this->Paths[p];
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      sides[p].Left.push_back(this->FindSide(cut, path[i], path[i + 1], true));
      sides[p].Right.push_back(this->FindSide(cut, path[i], path[i + 1], false));
    }
  }
  return sides;
}
}

Status CutAlongChains(const SubMesh& surface, const std::vector<std::vector<Id>>& chains,
  SubMesh& cut, PinchedVertices pinched)
{
  return PathCutter(surface, chains).Run(pinched, cut);
}

Status CutAlongCurves(
  const SubMesh& surface, const std::vector<std::vector<Id>>& paths, CurveCut& cut)
{
  cut = CurveCut();
  const PathCutter cutter(surface, paths);
  DGG_RETURN_IF_ERROR(cutter.CheckSides());
  DGG_RETURN_IF_ERROR(cutter.Run(PinchedVertices::Stay, cut.Surface));
  cut.Sides = cutter.FindSides(cut.Surface);
  return Status::Success();
}

Status CheckSides(const SubMesh& surface, const std::vector<std::vector<Id>>& paths)
{
  return PathCutter(surface, paths).CheckSides();
}
}
