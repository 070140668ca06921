// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Disjoint sets (union-find). Internal.
#ifndef dggDisjointSets_h
#define dggDisjointSets_h

#include "dggTypes.h" // for Id

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t
#include <numeric>   // for std::iota
#include <vector>    // for the parents

namespace dgg
{
/// Disjoint sets of the integers from 0 on, initially singletons. A set is represented by its
/// smallest element.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  /// Returns the representative of the set of an element.
  Id Find(Id i)
  {
    while (this->Parents[i] != i)
    {
      this->Parents[i] = this->Parents[this->Parents[i]];
      i = this->Parents[i];
    }
    return i;
  }

  /// Merges two sets. Returns false if the elements are already in the same set.
  bool Join(Id i, Id j)
  {
    i = this->Find(i);
    j = this->Find(j);
    this->Parents[std::max(i, j)] = std::min(i, j);
    return i != j;
  }

private:
  std::vector<Id> Parents;
};
}

#endif
