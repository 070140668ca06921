// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Relative errors of a distance field against the exact one.
#ifndef ErrorStatistics_h
#define ErrorStatistics_h

#include <cstddef> // for std::size_t
#include <vector>  // for the fields

struct ErrorStatistics
{
  // NaN when there is no vertex with both distances, so that nothing looks like no error.
  double Mean;          ///< mean of |a - d| / d
  double Percentile999; ///< 99.9 % of the vertices are no worse
  double Maximum;
  std::size_t Unreached = 0; ///< vertices with an exact distance but no approximate one
  std::size_t Beyond = 0;    ///< vertices with an approximate distance that cannot be reached

  bool IsEmpty() const;
  /// Vertices with exact distance 0 or infinity have no error.
  static ErrorStatistics Of(
    const std::vector<double>& approximate, const std::vector<double>& exact);
};

#endif
