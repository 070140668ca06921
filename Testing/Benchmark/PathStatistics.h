// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What many paths have in common: time, and length against the exact distances.
#ifndef PathStatistics_h
#define PathStatistics_h

#include "SampleStatistics.h" // for times and excesses

#include <benchmark/benchmark.h> // for State

class PathStatistics
{
public:
  /// A length in place of a path; both are Infinity where there is no way.
  void AddLength(double seconds, double length, double exact);

  /// Everything as counters. The excess of a path is how much longer it is than the shortest one,
  /// relative to that.
  void Report(benchmark::State& state) const;

private:
  SampleStatistics Seconds;
  SampleStatistics Excess;
  SampleStatistics Outside; // excesses that another class of homotopy explains, not rounding
};

#endif
