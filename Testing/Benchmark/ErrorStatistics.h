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
  double Mean = 0.0;          ///< mean of |a - d| / d
  double Percentile999 = 0.0; ///< 99.9 % of the vertices are no worse
  double Maximum = 0.0;
  std::size_t Unreached = 0; ///< vertices with an exact distance but no approximate one

  /// Vertices with exact distance 0 or infinity are left out.
  static ErrorStatistics Of(
    const std::vector<double>& approximate, const std::vector<double>& exact);
};

#endif
