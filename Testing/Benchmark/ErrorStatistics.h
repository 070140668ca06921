// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Relative errors of a distance field compared with the exact field.
#ifndef ErrorStatistics_h
#define ErrorStatistics_h

#include <cstddef> // for std::size_t
#include <vector>  // for the fields

struct ErrorStatistics
{
  // NaN if no vertex has both distances, so that an empty comparison does not look like a zero
  // error.
  double Mean;          ///< mean of |a - d| / d
  double Percentile999; ///< 99.9 % of the vertices are no worse
  double Maximum;
  std::size_t Unreached = 0; ///< vertices with an exact distance but no approximate one
  std::size_t Beyond = 0;    ///< unreachable vertices with an approximate distance

  bool IsEmpty() const;
  /// Returns the statistics. Vertices with exact distance 0 or infinity are not counted.
  static ErrorStatistics Of(
    const std::vector<double>& approximate, const std::vector<double>& exact);
};

#endif
