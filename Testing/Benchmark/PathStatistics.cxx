// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathStatistics.h"

#include <cmath>

namespace
{
/// Relative difference of lengths up to which a path counts as the shortest one.
constexpr double SameLength = 1e-6;
}

void PathStatistics::AddLength(double seconds, double length, double exact)
{
  this->Seconds.Add(seconds);
  if (!std::isfinite(length) || !std::isfinite(exact) || exact <= 0.0)
  {
    return;
  }
  const double excess = length / exact - 1.0;
  this->Excess.Add(excess);
  if (excess > SameLength)
  {
    this->Outside.Add(excess);
  }
}

void PathStatistics::Report(benchmark::State& state) const
{
  const auto set = [&state](const char* name, double value) { state.counters[name] = value; };
  set("pairs", static_cast<double>(this->Seconds.GetCount()));
  set("ms_median", 1e3 * this->Seconds.GetQuantile(0.5));
  set("ms_p90", 1e3 * this->Seconds.GetQuantile(0.9));
  set("ms_p99", 1e3 * this->Seconds.GetQuantile(0.99));
  set("ms_mean", 1e3 * this->Seconds.GetMean());
  set("within_1e6", this->Excess.GetShareUpTo(1e-6));
  set("within_1e5", this->Excess.GetShareUpTo(1e-5));
  set("within_1e4", this->Excess.GetShareUpTo(1e-4));
  set("excess_median", this->Excess.GetQuantile(0.5));
  set("excess_mean", this->Excess.GetMean());
  set("excess_p99", this->Excess.GetQuantile(0.99));
  set("excess_max", this->Excess.GetMaximum());
  set("outside", static_cast<double>(this->Outside.GetCount()));
  set("outside_median", this->Outside.GetQuantile(0.5));
  set("outside_max", this->Outside.GetMaximum());
}
