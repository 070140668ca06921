// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Eight labels of a vertex, one per source, handled together. Internal.
#ifndef dggLanes_h
#define dggLanes_h

#include "dggTypes.h" // for Infinity

#include <algorithm> // for std::min

namespace dgg
{
/// A cache line of labels.
struct alignas(64) Lanes
{
  static constexpr int Size = 8;

  double Values[Size];

  static Lanes Unreached()
  {
    return { { Infinity, Infinity, Infinity, Infinity, Infinity, Infinity, Infinity, Infinity } };
  }

  /// Whether an edge of this length from a vertex with these labels lowers any of `labels`.
  bool Lowers(double length, const Lanes& labels) const
  {
#if defined(__GNUC__)
    // Compilers do not find out by themselves that two lanes fit into a register.
    using Pair = double __attribute__((vector_size(16), may_alias));
    const auto* from = reinterpret_cast<const Pair*>(this->Values);
    const auto* to = reinterpret_cast<const Pair*>(labels.Values);
    const Pair step = { length, length };
    const auto isLower = (from[0] + step < to[0]) | (from[1] + step < to[1]) |
      (from[2] + step < to[2]) | (from[3] + step < to[3]);
    return (isLower[0] | isLower[1]) != 0;
#else
    bool isLower = false;
    for (int k = 0; k < Size; ++k)
    {
      isLower |= this->Values[k] + length < labels.Values[k];
    }
    return isLower;
#endif
  }

  /// Lower `labels` where an edge of this length from a vertex with these labels does. Returns the
  /// smallest label that was lowered; Infinity if none.
  double Lower(double length, Lanes& labels) const
  {
    double smallest = Infinity;
    for (int k = 0; k < Size; ++k)
    {
      const double label = this->Values[k] + length;
      smallest = label < labels.Values[k] ? std::min(smallest, label) : smallest;
      labels.Values[k] = std::min(labels.Values[k], label);
    }
    return smallest;
  }
};
}

#endif
