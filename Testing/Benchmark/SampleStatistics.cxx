// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleStatistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

double SampleStatistics::GetMean() const
{
  return this->Values.empty() ? 0.0
                              : std::accumulate(this->Values.begin(), this->Values.end(), 0.0) /
      static_cast<double>(this->Values.size());
}

double SampleStatistics::GetQuantile(double share) const
{
  if (this->Values.empty())
  {
    return 0.0;
  }
  std::vector<double> sorted = this->Values;
  std::sort(sorted.begin(), sorted.end());
  const double count = static_cast<double>(sorted.size());
  const double rank = std::max(1.0, std::ceil(share * count - 1e-9)); // 99 % of 100: rank 99
  return sorted[static_cast<std::size_t>(rank) - 1];
}

double SampleStatistics::GetShareUpTo(double limit) const
{
  const auto count = std::count_if(
    this->Values.begin(), this->Values.end(), [limit](double value) { return value <= limit; });
  return this->Values.empty()
    ? 0.0
    : static_cast<double>(count) / static_cast<double>(this->Values.size());
}
