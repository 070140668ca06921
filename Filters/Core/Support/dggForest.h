// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Order of the vertices of a forest. Internal.
#ifndef dggForest_h
#define dggForest_h

#include "dggTypes.h" // for Id

#include <algorithm> // for std::reverse
#include <cstddef>   // for std::size_t
#include <vector>    // for the vertices

namespace dgg
{
/// Returns the vertices of a forest, each after its parent (NoId for roots).
inline std::vector<Id> SortForest(const std::vector<Id>& parents)
{
  std::vector<Id> order;
  order.reserve(parents.size());
  std::vector<char> isSorted(parents.size(), 0);
  for (std::size_t v = 0; v < parents.size(); ++v)
  {
    const std::size_t first = order.size();
    for (Id u = static_cast<Id>(v); u != NoId && isSorted[u] == 0; u = parents[u])
    {
      isSorted[u] = 1;
      order.push_back(u);
    }
    std::reverse(order.begin() + static_cast<std::ptrdiff_t>(first), order.end());
  }
  return order;
}
}

#endif
