// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The smallest key first: a heap with four children per node. Internal.
#ifndef dggMinimumHeap_h
#define dggMinimumHeap_h

#include "dggTypes.h" // for Id

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t
#include <vector>    // for the entries

namespace dgg
{
/// Keys are never changed: a vertex whose key drops is pushed again, and the one who pops sees that
/// the older entry is out of date. Four children make the heap half as high as two, and they share
/// a cache line.
class MinimumHeap
{
public:
  struct Entry
  {
    double Key;
    Id Vertex;
  };

  bool IsEmpty() const { return this->Entries.empty(); }
  void Clear() { this->Entries.clear(); }
  const Entry& Top() const { return this->Entries.front(); }

  void Push(double key, Id vertex)
  {
    std::size_t place = this->Entries.size();
    this->Entries.push_back({ key, vertex });
    while (place > 0)
    {
      const std::size_t parent = (place - 1) / 4;
      if (this->Entries[parent].Key <= key)
      {
        break;
      }
      this->Entries[place] = this->Entries[parent];
      place = parent;
    }
    this->Entries[place] = { key, vertex };
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
  /// Put an entry into the gap at the top.
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
        smallest = this->Entries[other].Key < this->Entries[smallest].Key ? other : smallest;
      }
      if (this->Entries[smallest].Key >= entry.Key)
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
}

#endif
