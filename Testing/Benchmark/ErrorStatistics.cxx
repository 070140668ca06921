// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
}

bool ErrorStatistics::IsEmpty() const
{
  return std::isnan(this->Mean);
}

ErrorStatistics ErrorStatistics::Of(
  const std::vector<double>& approximate, const std::vector<double>& exact)
{
  ErrorStatistics statistics{ NaN, NaN, NaN };
  std::vector<double> errors;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const bool isReached = std::isfinite(approximate[i]) && approximate[i] >= 0.0;
    if (!std::isfinite(exact[i]) || exact[i] <= 0.0)
    {
      statistics.Beyond += isReached && exact[i] > 0.0 ? 1 : 0;
      continue;
    }
    if (isReached)
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
