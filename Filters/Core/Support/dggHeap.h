// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A min-heap with four children per node. Internal.
#ifndef dggHeap_h
#define dggHeap_h

#include "dggTypes.h" // for Id

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t
#include <vector>    // for the entries

namespace dgg
{
/// Keys are never changed: a vertex whose key drops is pushed again, and callers have to skip
/// outdated entries. Four children make the heap half as high as two, and they share a cache line.
///
/// With `BreaksTies`, the smaller index comes first among equal keys, independent of the other
/// contents of the heap, so that results of window propagation do not depend on ties.
template <bool BreaksTies>
class Heap
{
public:
  struct Entry
  {
    double Key;
    Id Index;
  };

  bool IsEmpty() const { return this->Entries.empty(); }
  void Clear() { this->Entries.clear(); }
  const Entry& Top() const { return this->Entries.front(); }

  void Push(double key, Id index)
  {
    const Entry entry{ key, index };
    std::size_t place = this->Entries.size();
    this->Entries.push_back(entry);
    while (place > 0)
    {
      const std::size_t parent = (place - 1) / 4;
      if (!IsBefore(entry, this->Entries[parent]))
      {
        break;
      }
      this->Entries[place] = this->Entries[parent];
      place = parent;
    }
    this->Entries[place] = entry;
  }

  Entry Pop()
  {
    const Entry top = this->Entries.front();
    const Entry last = this->Entries.back();
    this->Entries.pop_back();
    if (!this->Entries.empty())
    {
      this->SiftDown(last);
    }
    return top;
  }

private:
  static bool IsBefore(const Entry& a, const Entry& b)
  {
    return a.Key < b.Key || (BreaksTies && a.Key == b.Key && a.Index < b.Index);
  }

  /// Moves an entry from the gap at the top to its position.
  void SiftDown(const Entry& entry)
  {
    const std::size_t size = this->Entries.size();
    std::size_t place = 0;
    for (std::size_t child = 1; child < size; child = 4 * place + 1)
    {
      const std::size_t end = std::min(child + 4, size);
      std::size_t smallest = child;
      for (std::size_t other = child + 1; other < end; ++other)
      {
        smallest = IsBefore(this->Entries[other], this->Entries[smallest]) ? other : smallest;
      }
      if (!IsBefore(this->Entries[smallest], entry))
      {
        break;
      }
      this->Entries[place] = this->Entries[smallest];
      place = smallest;
    }
    this->Entries[place] = entry;
  }

  std::vector<Entry> Entries;
};

using MinimumHeap = Heap<false>;
using DistanceHeap = Heap<true>;
}

#endif
