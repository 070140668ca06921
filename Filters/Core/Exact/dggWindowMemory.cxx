// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggWindowMemory.h"

#include <algorithm>
#include <iterator>

namespace dgg
{
void WindowMemory::KeepNews(Id h, double length, WindowList& list)
{
  WindowList& known = this->Known[h];
  MergeEnvelopes(known, list, length, this->Merged);
  list.clear();
  std::copy_if(this->Merged.begin(), this->Merged.end(), std::back_inserter(list),
    [](const Window& w) { return !w.IsKnown; });
  WindowList passed = list;
  for (Window& w : passed)
  {
    // Made a little shorter, so that an equal one that comes later loses.
    const double bias = LengthTolerance * std::max(w.DistanceAtBegin, w.DistanceAtEnd);
    w.Sigma -= bias;
    w.DistanceAtBegin -= bias;
    w.DistanceAtEnd -= bias;
    w.IsKnown = true;
  }
  MergeEnvelopes(known, passed, length, this->Merged);
  known.swap(this->Merged);
}

std::size_t WindowMemory::GetMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& known : this->Known)
  {
    bytes += sizeof(known) + known.second.capacity() * sizeof(Window);
  }
  return bytes;
}
}
