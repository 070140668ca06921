// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Eight labels of a vertex, one per source, handled together. Internal.
#ifndef dggLanes_h
#define dggLanes_h

#include "dggTypes.h" // for Infinity

#include <algorithm> // for std::min
#include <cstdint>   // for the masks

namespace dgg
{
/// Place of the lowest bit that is set; there has to be one.
inline int LowestBit(std::uint32_t bits)
{
#if defined(__GNUC__)
  return __builtin_ctz(bits);
#else
  int place = 0;
  for (; (bits & 1u) == 0; bits >>= 1)
  {
    ++place;
  }
  return place;
#endif
}

/// A cache line of labels. Which of them an edge lowers is as good as random, so nothing here
/// branches on it.
struct alignas(64) Lanes
{
  static constexpr int Size = 8;

  double Values[Size];

  static Lanes Unreached()
  {
    return { { Infinity, Infinity, Infinity, Infinity, Infinity, Infinity, Infinity, Infinity } };
  }

#if defined(__GNUC__)
  // Compilers do not find out by themselves that two lanes fit into a register.

  /// Whether an edge of this length from a vertex with these labels lowers any of `labels`.
  bool Lowers(double length, const Lanes& labels) const
  {
    const Pair step = { length, length };
    const auto isLower = (this->At(0) + step < labels.At(0)) | (this->At(1) + step < labels.At(1)) |
      (this->At(2) + step < labels.At(2)) | (this->At(3) + step < labels.At(3));
    return (isLower[0] | isLower[1]) != 0;
  }

  /// Lower `labels` where an edge of this length from a vertex with these labels does. Returns a
  /// bit for each label that was lowered; `smallest` is set to the smallest of them.
  std::uint32_t Lower(double length, Lanes& labels, double& smallest) const
  {
    const Pair step = { length, length };
    const Pair infinity = { Infinity, Infinity };
    Pair least = infinity;
    std::int64_t lowered = 0;
    for (int i = 0; i < Size / 2; ++i)
    {
      const Pair sum = this->At(i) + step;
      Pair& old = labels.At(i);
      const auto isLower = sum < old;
      const Pair gained = isLower ? sum : infinity;
      old = isLower ? sum : old;
      least = gained < least ? gained : least;
      lowered |= ((isLower[0] & 1) | (isLower[1] & 2)) << (2 * i);
    }
    smallest = std::min(least[0], least[1]);
    return static_cast<std::uint32_t>(lowered);
  }

private:
  using Pair = double __attribute__((vector_size(16), may_alias));
  const Pair& At(int i) const
  {
    return reinterpret_cast<const Pair*>(this->Values)[i];
  }
  Pair& At(int i)
  {
    return reinterpret_cast<Pair*>(this->Values)[i];
  }
#else
  bool Lowers(double length, const Lanes& labels) const
  {
    bool isLower = false;
    for (int k = 0; k < Size; ++k)
    {
      isLower |= this->Values[k] + length < labels.Values[k];
    }
    return isLower;
  }

  std::uint32_t Lower(double length, Lanes& labels, double& smallest) const
  {
    std::uint32_t lowered = 0;
    smallest = Infinity;
    for (int k = 0; k < Size; ++k)
    {
      const double sum = this->Values[k] + length;
      const bool isLower = sum < labels.Values[k];
      lowered |= (isLower ? 1u : 0u) << k;
      smallest = isLower ? std::min(smallest, sum) : smallest;
      labels.Values[k] = isLower ? sum : labels.Values[k];
    }
    return lowered;
  }
#endif
};
}

#endif
