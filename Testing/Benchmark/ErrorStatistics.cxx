// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorStatistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

ErrorStatistics ErrorStatistics::Of(
  const std::vector<double>& approximate, const std::vector<double>& exact)
{
  ErrorStatistics statistics;
  std::vector<double> errors;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    if (!std::isfinite(exact[i]) || exact[i] <= 0.0)
    {
      continue;
    }
    if (std::isfinite(approximate[i]) && approximate[i] >= 0.0)
    {
      errors.push_back(std::abs(approximate[i] - exact[i]) / exact[i]);
    }
    else
    {
      ++statistics.Unreached;
    }
  }
  if (errors.empty())
  {
    return statistics;
  }
  std::sort(errors.begin(), errors.end());
  const auto count = errors.size();
  statistics.Mean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(count);
  statistics.Percentile999 =
    errors[static_cast<std::size_t>(0.999 * static_cast<double>(count - 1))];
  statistics.Maximum = errors.back();
  return statistics;
}
