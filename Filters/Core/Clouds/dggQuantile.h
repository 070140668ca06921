// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Quantiles of values. Internal.
#ifndef dggQuantile_h
#define dggQuantile_h

#include <algorithm> // for std::nth_element
#include <cstddef>   // for std::size_t
#include <vector>    // for values

namespace dgg
{
/// Returns the value below which the fraction `part` of the values lies. Reorders the values.
template <typename T>
T Quantile(std::vector<T>& values, double part)
{
  const auto place = static_cast<std::size_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(
    values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
  return values[place];
}
}

#endif
