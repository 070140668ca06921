// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathStatistics.h"

#include <cmath>

namespace
{
/// Relative difference of lengths up to which a path counts as the shortest one.
constexpr double SameLength = 1e-6;
/// Relative difference of lengths that rounding explains.
constexpr double Rounding = 1e-9;
}

void PathStatistics::AddLength(double seconds, double length, double exact)
{
  this->Seconds.Add(seconds);
  this->Mismatches += std::isfinite(length) == std::isfinite(exact) ? 0 : 1;
  this->Unconnected += std::isfinite(exact) ? 0 : 1;
  if (!std::isfinite(length) || !std::isfinite(exact) || exact <= 0.0)
  {
    return;
  }
  const double excess = length / exact - 1.0;
  this->Excess.Add(excess);
  this->TooShort += excess < -Rounding ? 1 : 0;
  if (excess > SameLength)
  {
    this->Outside.Add(excess);
  }
}

void PathStatistics::AddPath(
  const dgg::SurfaceMesh& mesh, double seconds, const dgg::FoundPath& found, double exact)
{
  const bool exists = !found.Path.IsEmpty();
  this->AddLength(seconds, exists ? found.Path.Length : dgg::Infinity, exact);
  this->Invalid += dgg::CheckPath(mesh, found.Path).IsOk() ? 0 : 1;
  this->Longer += exists && found.Path.Length > found.GraphLength * (1.0 + Rounding) ? 1 : 0;
  this->Unstraightened += exists && !found.IsStraightened ? 1 : 0;
  this->Fallbacks += found.NumberOfFallbacks;
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
  set("unconnected", this->Unconnected);
  set("mismatches", this->Mismatches);
  set("too_short", this->TooShort);
  set("longer", this->Longer);
  set("invalid", this->Invalid);
  set("unstraightened", this->Unstraightened);
  set("fallbacks", this->Fallbacks);
}
