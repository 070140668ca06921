// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics.h"

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
  const double count = static_cast<double>(this->Values.size());
  const double rank = std::max(1.0, std::ceil(share * count - 1e-9)); // 99 % of 100: rank 99
  return this->GetSorted(static_cast<std::size_t>(rank) - 1);
}

double SampleStatistics::GetShareUpTo(double limit) const
{
  const auto count = std::count_if(
    this->Values.begin(), this->Values.end(), [limit](double value) { return value <= limit; });
  return this->Values.empty()
    ? 0.0
    : static_cast<double>(count) / static_cast<double>(this->Values.size());
}

ErrorStatistics::ErrorStatistics(
  const std::vector<double>& approximate, const std::vector<double>& exact)
{
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const bool isReached = std::isfinite(approximate[i]) && approximate[i] >= 0.0;
    if (!std::isfinite(exact[i]) || exact[i] <= 0.0)
    {
      this->Beyond += isReached && exact[i] > 0.0 ? 1 : 0;
    }
    else if (isReached)
    {
      this->Errors.Add(std::abs(approximate[i] - exact[i]) / exact[i]);
    }
    else
    {
      ++this->Unreached;
    }
  }
}

double SampleStatistics::GetSorted(std::size_t index) const
{
  std::vector<double> sorted = this->Values;
  std::sort(sorted.begin(), sorted.end());
  return sorted[index];
}

double ErrorStatistics::GetPercentile999() const
{
  return this->Errors.GetSorted(
    static_cast<std::size_t>(0.999 * static_cast<double>(this->Errors.GetCount() - 1)));
}
