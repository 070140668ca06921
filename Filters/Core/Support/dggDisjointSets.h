// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Things that are joined step by step. Internal.
#ifndef dggDisjointSets_h
#define dggDisjointSets_h

#include "dggTypes.h" // for Id

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t
#include <numeric>   // for std::iota
#include <vector>    // for the parents

namespace dgg
{
/// Disjoint sets of the numbers from 0 on, each number in a set of its own at first. The smallest
/// number of a set represents it.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  /// The number that represents the set of a number.
  Id Find(Id i)
  {
    while (this->Parents[i] != i)
    {
      this->Parents[i] = this->Parents[this->Parents[i]];
      i = this->Parents[i];
    }
    return i;
  }

  /// False when they are in the same set already.
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
