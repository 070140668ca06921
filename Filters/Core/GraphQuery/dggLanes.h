// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Eight labels of a vertex, one per source, processed together. Internal.
#ifndef dggLanes_h
#define dggLanes_h

#include "dggTypes.h" // for Infinity

namespace dgg
{
/// Two labels. With GCC and Clang they share a register; these compilers do not vectorize the
/// generic code.
#if defined(__GNUC__)
using LanePair = double __attribute__((vector_size(16)));

inline LanePair SmallerOf(LanePair a, LanePair b)
{
  return a < b ? a : b;
}

inline bool AnyIsLess(const LanePair (&a)[4], const LanePair (&b)[4])
{
  const auto isLess = (a[0] < b[0]) | (a[1] < b[1]) | (a[2] < b[2]) | (a[3] < b[3]);
  return (isLess[0] | isLess[1]) != 0;
}
#else
struct alignas(16) LanePair
{
  double Values[2];
  double& operator[](int k) { return this->Values[k]; }
  double operator[](int k) const { return this->Values[k]; }
};

inline LanePair operator+(LanePair a, LanePair b)
{
  return { { a[0] + b[0], a[1] + b[1] } };
}

inline LanePair SmallerOf(LanePair a, LanePair b)
{
  return { { a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1] } };
}

inline bool AnyIsLess(const LanePair (&a)[4], const LanePair (&b)[4])
{
  bool isLess = false;
  for (int k = 0; k < 4; ++k)
  {
    isLess |= a[k][0] < b[k][0];
    isLess |= a[k][1] < b[k][1];
  }
  return isLess;
}
#endif

/// A cache line of labels. The set of labels that an edge lowers is unpredictable, so that the
/// operations performed for every edge are branchless.
class alignas(64) Lanes
{
public:
  static constexpr int Size = 8;

  double Get(int lane) const { return this->Pairs[lane / 2][lane % 2]; }
  void Set(int lane, double label) { this->Pairs[lane / 2][lane % 2] = label; }

  /// Relaxes an edge of the given length from a vertex with the labels `from`.
  void Pull(const Lanes& from, double length)
  {
    const LanePair step = { length, length };
    // The operations are unrolled, so that the labels stay in registers over many edges.
    this->Pairs[0] = SmallerOf(from.Pairs[0] + step, this->Pairs[0]);
    this->Pairs[1] = SmallerOf(from.Pairs[1] + step, this->Pairs[1]);
    this->Pairs[2] = SmallerOf(from.Pairs[2] + step, this->Pairs[2]);
    this->Pairs[3] = SmallerOf(from.Pairs[3] + step, this->Pairs[3]);
  }

  /// Returns true if any label is below the corresponding label of `old`.
  bool AreBelow(const Lanes& old) const { return AnyIsLess(this->Pairs, old.Pairs); }

  /// Returns the smallest label below the corresponding label of `old`; Infinity if there is none.
  double SmallestBelow(const Lanes& old) const
  {
    double smallest = Infinity;
    for (int k = 0; k < Size; ++k)
    {
      const bool isSmallest = this->Get(k) < old.Get(k) && this->Get(k) < smallest;
      smallest = isSmallest ? this->Get(k) : smallest;
    }
    return smallest;
  }

private:
  LanePair Pairs[Size / 2] = { { Infinity, Infinity }, { Infinity, Infinity },
    { Infinity, Infinity }, { Infinity, Infinity } };
};
}

#endif
