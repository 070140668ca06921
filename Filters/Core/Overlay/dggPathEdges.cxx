// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPathEdges.h"

#include <algorithm>
#include <cstddef>

namespace dgg
{
PathEdges::PathEdges(const SubMesh& surface, const std::vector<std::vector<Id>>& paths)
  : Surface(surface)
  , IsPassed(surface.Points.size(), 0)
{
  std::vector<Edge> edges;
  for (const std::vector<Id>& path : paths)
  {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      edges.push_back(std::minmax(path[i], path[i + 1]));
      this->IsPassed[path[i]] = 1;
      this->IsPassed[path[i + 1]] = 1;
    }
  }
  std::sort(edges.begin(), edges.end());
  for (Id h = 0; h < surface.GetNumberOfHalfEdges(); ++h)
  {
    const Edge edge = std::minmax(surface.Origin(h), surface.Destination(h));
    if (this->IsPassed[edge.first] && this->IsPassed[edge.second] &&
      std::binary_search(edges.begin(), edges.end(), edge))
    {
      this->HalfEdges.emplace_back(edge, h);
    }
  }
  std::sort(this->HalfEdges.begin(), this->HalfEdges.end());
}

bool PathEdges::IsOnPath(Id h) const
{
  const Edge edge = std::minmax(this->Surface.Origin(h), this->Surface.Destination(h));
  return this->IsPassed[edge.first] && this->IsPassed[edge.second] &&
    std::binary_search(this->HalfEdges.begin(), this->HalfEdges.end(), std::make_pair(edge, h));
}

std::vector<Id> PathEdges::Find(Id a, Id b) const
{
  const Edge edge = std::minmax(a, b);
  std::vector<Id> found;
  for (auto i = std::lower_bound(
         this->HalfEdges.begin(), this->HalfEdges.end(), std::make_pair(edge, Id(0)));
       i != this->HalfEdges.end() && i->first == edge; ++i)
  {
    found.push_back(i->second);
  }
  return found;
}
}
