// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSearchTree.h"

namespace dgg
{
void FinishTree(const SearchLabels& labels, SearchResult& result, std::vector<TreeStep>& steps)
{
  const std::size_t n = labels.Distances.size();
  result.Seeds.assign(n, NoId);
  result.Edges.assign(n, -1);
  result.Tails.assign(n, NoId);
  steps.clear();
  steps.reserve(n);
  std::vector<Id> climbed;
  for (std::size_t first = 0; first < n; ++first)
  {
    if (!labels.IsReached(static_cast<Id>(first)))
    {
      result.Distances[first] = Infinity;
      continue;
    }
    // Up the tree to a vertex whose seed is known, and down again.
    auto v = static_cast<Id>(first);
    while (result.Seeds[v] == NoId && !labels.Origins[v].IsSeed())
    {
      climbed.push_back(v);
      v = labels.Origins[v].Tail;
    }
    if (result.Seeds[v] == NoId)
    {
      result.Seeds[v] = labels.Origins[v].Tail;
      steps.push_back({ -1, v, NoId });
    }
    const Id seed = result.Seeds[v];
    for (; !climbed.empty(); climbed.pop_back())
    {
      v = climbed.back();
      result.Seeds[v] = seed;
      const LabelOrigin& origin = labels.Origins[v];
      result.Edges[v] = origin.Edge;
      result.Tails[v] = origin.Tail;
      steps.push_back({ origin.Edge, v, origin.Tail });
    }
  }
}
}
