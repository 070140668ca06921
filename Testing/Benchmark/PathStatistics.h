// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Statistics of many paths: time, and length compared with the exact distance.
#ifndef PathStatistics_h
#define PathStatistics_h

#include "SampleStatistics.h" // for times and excesses

#include <benchmark/benchmark.h> // for State

class PathStatistics
{
public:
  /// Adds a length without a path; both lengths are Infinity if there is no path.
  void AddLength(double seconds, double length, double exact);

  /// Reports all statistics as counters. The excess of a path is its length divided by that of the
  /// shortest path, minus 1.
  void Report(benchmark::State& state) const;

private:
  SampleStatistics Seconds;
  SampleStatistics Excess;
  SampleStatistics Outside; // excesses due to another homotopy class, not rounding
};

#endif
