// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Mean and quantiles of a sample.
#ifndef SampleStatistics_h
#define SampleStatistics_h

#include <cstddef> // for std::size_t
#include <vector>  // for the numbers

class SampleStatistics
{
public:
  void Add(double value) { this->Values.push_back(value); }
  std::size_t GetCount() const { return this->Values.size(); }

  /// Returns the mean; 0 for an empty sample, as all functions below.
  double GetMean() const;
  /// Returns the smallest value that at least this fraction of the values does not exceed.
  double GetQuantile(double share) const;
  double GetMinimum() const { return this->GetQuantile(0.0); }
  double GetMaximum() const { return this->GetQuantile(1.0); }
  /// Returns the fraction of values that are at most `limit`.
  double GetShareUpTo(double limit) const;

private:
  std::vector<double> Values;
};

#endif
