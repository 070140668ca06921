// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A heap of indices, the nearest first. Internal.
#ifndef dggDistanceHeap_h
#define dggDistanceHeap_h

#include "dggTypes.h" // for Id

#include <algorithm> // for heaps
#include <vector>    // for the keys

namespace dgg
{
/// Of equal distances the smaller index comes first, whatever else is in the heap: what windows
/// find does not depend on ties.
class DistanceHeap
{
public:
  struct Key
  {
    double Distance;
    Id Index;
  };

  bool IsEmpty() const { return this->Keys.empty(); }
  const Key& Top() const { return this->Keys.front(); }
  void Clear() { this->Keys.clear(); }

  void Push(double distance, Id index)
  {
    this->Keys.push_back({ distance, index });
    std::push_heap(this->Keys.begin(), this->Keys.end(), ComesAfter);
  }
  Key Pop()
  {
    const Key key = this->Keys.front();
    std::pop_heap(this->Keys.begin(), this->Keys.end(), ComesAfter);
    this->Keys.pop_back();
    return key;
  }

private:
  static bool ComesAfter(const Key& a, const Key& b)
  {
    return a.Distance != b.Distance ? a.Distance > b.Distance : a.Index > b.Index;
  }

  std::vector<Key> Keys;
};
}

#endif
