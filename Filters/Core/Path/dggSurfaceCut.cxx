// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceCut.h"

#include "dggDisjointSets.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

namespace dgg
{
Status CutAlongChains(const RefinedSurface& surface, const std::vector<std::vector<Id>>& chains,
  CutSurface& cut, PinchedVertices pinched)
{
  cut = CutSurface();
  const auto halfEdges = static_cast<Id>(surface.Triangles.size());
  const Id vertices = surface.GetNumberOfVertices();

  // Where the chains run.
  std::vector<std::pair<Id, Id>> edges;
  for (const std::vector<Id>& chain : chains)
  {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    {
      edges.emplace_back(std::min(chain[i], chain[i + 1]), std::max(chain[i], chain[i + 1]));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<char> isFound(edges.size(), 0);
  static_cast<RefinedSurface&>(cut) = surface;
  cut.Paths.clear();
  for (Id h = 0; h < halfEdges; ++h)
  {
    const Id a = surface.Triangles[h];
    const Id b = surface.Triangles[SurfaceMesh::Next(h)];
    const auto edge = std::make_pair(std::min(a, b), std::max(a, b));
    const auto place = std::lower_bound(edges.begin(), edges.end(), edge);
    if (place != edges.end() && *place == edge)
    {
      isFound[place - edges.begin()] = 1;
      cut.Twins[h] = NoId;
    }
  }
  const auto missing = std::find(isFound.begin(), isFound.end(), 0);
  if (missing != isFound.end())
  {
    const std::pair<Id, Id>& edge = edges[missing - isFound.begin()];
    std::ostringstream message;
    message << "vertices " << edge.first << " and " << edge.second
            << " of a chain are not neighbours";
    cut = CutSurface();
    return Status::Invalid(message.str());
  }

  // Corners that are still joined by an edge at their vertex are of one sector.
  DisjointSets sectors(halfEdges);
  for (Id h = 0; h < halfEdges; ++h)
  {
    const Id t = cut.Twins[h];
    if (t == NoId)
    {
      continue;
    }
    const Id hNext = SurfaceMesh::Next(h);
    const Id tNext = SurfaceMesh::Next(t);
    const bool along = surface.Triangles[h] == surface.Triangles[t];
    sectors.Join(h, along ? t : tNext);
    sectors.Join(hNext, along ? tNext : t);
  }
  std::vector<char> isPassed(vertices, pinched == PinchedVertices::Split ? 1 : 0);
  for (const std::pair<Id, Id>& edge : edges)
  {
    isPassed[edge.first] = 1;
    isPassed[edge.second] = 1;
  }
  cut.VertexOf.resize(vertices);
  std::iota(cut.VertexOf.begin(), cut.VertexOf.end(), 0);
  std::vector<Id> copyOf(halfEdges, NoId); // per corner that is the root of a sector
  std::vector<char> hasCopy(vertices, 0);
  for (Id h = 0; h < halfEdges; ++h)
  {
    const Id v = surface.Triangles[h];
    if (!isPassed[v])
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
        cut.Points.push_back(surface.Points[v]);
      }
      hasCopy[v] = 1;
    }
    cut.Triangles[h] = copy;
  }
  return Status::Success();
}
}
