// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Mean and quantiles of some numbers.
#ifndef SampleStatistics_h
#define SampleStatistics_h

#include <cstddef> // for std::size_t
#include <vector>  // for the numbers

class SampleStatistics
{
public:
  void Add(double value) { this->Values.push_back(value); }
  std::size_t GetCount() const { return this->Values.size(); }

  /// 0 without numbers, as all of these.
  double GetMean() const;
  /// The smallest of the numbers that at least this share of them does not exceed.
  double GetQuantile(double share) const;
  double GetMinimum() const { return this->GetQuantile(0.0); }
  double GetMaximum() const { return this->GetQuantile(1.0); }
  /// Which share of the numbers is no larger than `limit`.
  double GetShareUpTo(double limit) const;

private:
  std::vector<double> Values;
};

#endif
