// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceCut.h"

#include "dggDisjointSets.h"
#include "dggInvalidInput.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace dgg
{
namespace
{
/// Opens the edges of chains, finds the resulting sectors around each vertex, and gives each of
/// them a vertex of its own.
class ChainCutter
{
public:
  ChainCutter(const RefinedSurface& surface, CutSurface& cut)
    : Surface(surface)
    , Cut(cut)
    , HalfEdges(static_cast<Id>(surface.Triangles.size()))
    , Sectors(surface.Triangles.size())
  {
  }

  Status Run(const std::vector<std::vector<Id>>& chains, PinchedVertices pinched)
  {
    this->Cut = CutSurface();
    static_cast<RefinedSurface&>(this->Cut) = this->Surface;
    this->Cut.Paths.clear();
    this->Cut.Places.clear();
    this->CollectEdges(chains);
    Status status = this->OpenEdges();
    if (!status.IsOk())
    {
      this->Cut = CutSurface();
      return status;
    }
    this->JoinCorners();
    this->CopyVertices(pinched);
    return status;
  }

private:
  static std::pair<Id, Id> Unordered(Id a, Id b) { return { std::min(a, b), std::max(a, b) }; }

  void CollectEdges(const std::vector<std::vector<Id>>& chains)
  {
    for (const std::vector<Id>& chain : chains)
    {
      for (std::size_t i = 0; i + 1 < chain.size(); ++i)
      {
        this->Edges.push_back(Unordered(chain[i], chain[i + 1]));
      }
    }
    std::sort(this->Edges.begin(), this->Edges.end());
    this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
  }

  /// Unglues the half-edges on the chains. Fails if an edge does not exist.
  Status OpenEdges()
  {
    std::vector<char> isFound(this->Edges.size(), 0);
    for (Id h = 0; h < this->HalfEdges; ++h)
    {
      const std::pair<Id, Id> edge =
        Unordered(this->Surface.Triangles[h], this->Surface.Triangles[SurfaceMesh::Next(h)]);
      const auto place = std::lower_bound(this->Edges.begin(), this->Edges.end(), edge);
      if (place != this->Edges.end() && *place == edge)
      {
        isFound[place - this->Edges.begin()] = 1;
        this->Cut.Twins[h] = NoId;
      }
    }
    const auto missing = std::find(isFound.begin(), isFound.end(), 0);
    if (missing == isFound.end())
    {
      return Status::Success();
    }
    const std::pair<Id, Id>& edge = this->Edges[missing - isFound.begin()];
    return InvalidInput(
      "vertices ", edge.first, " and ", edge.second, " of a chain are not neighbours");
  }

  /// Joins corners that still share an edge at their vertex into one sector.
  void JoinCorners()
  {
    for (Id h = 0; h < this->HalfEdges; ++h)
    {
      const Id t = this->Cut.Twins[h];
      if (t == NoId)
      {
        continue;
      }
      const Id hNext = SurfaceMesh::Next(h);
      const Id tNext = SurfaceMesh::Next(t);
      const bool along = this->Surface.Triangles[h] == this->Surface.Triangles[t];
      this->Sectors.Join(h, along ? t : tNext);
      this->Sectors.Join(hNext, along ? tNext : t);
    }
  }

  /// Creates one copy per sector of the vertices on chains.
  void CopyVertices(PinchedVertices pinched)
  {
    const Id vertices = this->Surface.GetNumberOfVertices();
    std::vector<char> isPassed(vertices, pinched == PinchedVertices::Split ? 1 : 0);
    for (const std::pair<Id, Id>& edge : this->Edges)
    {
      isPassed[edge.first] = 1;
      isPassed[edge.second] = 1;
    }
    this->Cut.VertexOf.resize(vertices);
    std::iota(this->Cut.VertexOf.begin(), this->Cut.VertexOf.end(), 0);
    std::vector<Id> copyOf(this->HalfEdges, NoId); // per corner that represents a sector
    std::vector<char> hasCopy(vertices, 0);
    for (Id h = 0; h < this->HalfEdges; ++h)
    {
      const Id v = this->Surface.Triangles[h];
      if (!isPassed[v])
      {
        continue;
      }
      Id& copy = copyOf[this->Sectors.Find(h)];
      if (copy == NoId)
      {
        copy = v;
        if (hasCopy[v])
        {
          copy = static_cast<Id>(this->Cut.VertexOf.size());
          this->Cut.VertexOf.push_back(v);
          this->Cut.Points.push_back(this->Surface.Points[v]);
        }
        hasCopy[v] = 1;
      }
      this->Cut.Triangles[h] = copy;
    }
  }

  const RefinedSurface& Surface;
  CutSurface& Cut;
  const Id HalfEdges;
  std::vector<std::pair<Id, Id>> Edges; // edges of the chains, sorted
  DisjointSets Sectors;                 // sectors as sets of corners
};
}

Status CutAlongChains(const RefinedSurface& surface, const std::vector<std::vector<Id>>& chains,
  CutSurface& cut, PinchedVertices pinched)
{
  return ChainCutter(surface, cut).Run(chains, pinched);
}
}
