// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Statistics of samples, and of relative errors of a distance field.
#ifndef Statistics_h
#define Statistics_h

#include <cstddef> // for std::size_t
#include <vector>  // for the values

/// Mean and quantiles of a sample; 0 for an empty sample.
class SampleStatistics
{
public:
  void Add(double value) { this->Values.push_back(value); }
  std::size_t GetCount() const { return this->Values.size(); }

  double GetMean() const;
  /// Returns the smallest value that at least this fraction of the values does not exceed.
  double GetQuantile(double share) const;
  double GetMinimum() const { return this->GetQuantile(0.0); }
  double GetMaximum() const { return this->GetQuantile(1.0); }
  /// Returns the fraction of values that are at most `limit`.
  double GetShareUpTo(double limit) const;
  /// Returns the value at an index of the sorted sample, which must not be empty.
  double GetSorted(std::size_t index) const;

private:
  std::vector<double> Values;
};

/// Relative errors of a distance field compared with the exact field. Vertices with exact distance
/// 0 or infinity are not counted.
struct ErrorStatistics
{
  ErrorStatistics(const std::vector<double>& approximate, const std::vector<double>& exact);

  /// Returns the 99.9th percentile of a sample that is not empty, rounded down to a vertex.
  double GetPercentile999() const;

  SampleStatistics Errors;   ///< |a - d| / d
  std::size_t Unreached = 0; ///< vertices with an exact distance but no approximate one
  std::size_t Beyond = 0;    ///< unreachable vertices with an approximate distance
};

#endif
