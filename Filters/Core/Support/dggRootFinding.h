// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Roots of functions of one variable. Internal.
#ifndef dggRootFinding_h
#define dggRootFinding_h

#include <cmath> // for std::abs

namespace dgg
{
/// Returns the abscissa at which `isBefore(x)` turns from true to false, by bisection. Stops at the
/// relative precision, at neighboring doubles, or after `maximumSteps`.
template <typename IsBefore>
double Bisect(
  double begin, double end, double precision, int maximumSteps, const IsBefore& isBefore)
{
  double middle = 0.5 * (begin + end);
  for (int step = 0; step < maximumSteps && end - begin > precision * std::abs(end) &&
       middle > begin && middle < end;
       ++step)
  {
    (isBefore(middle) ? begin : end) = middle;
    middle = 0.5 * (begin + end);
  }
  return middle;
}

/// Returns the probe with the smallest absolute value that the search for a root has evaluated. The
/// values at both ends of the interval have different signs. A probe has an abscissa X and a value
/// Height; `evaluate(x)` makes one. Stops when the absolute value is at most `tolerance`, or after
/// `maximumSteps`.
///
/// Regula falsi with the Illinois rule, which converges at kinks as well.
template <typename Probe, typename Evaluate>
Probe FindRoot(Probe begin, Probe end, double tolerance, int maximumSteps, const Evaluate& evaluate)
{
  const bool beginIsAbove = begin.Height >= 0.0;
  Probe best = std::abs(begin.Height) < std::abs(end.Height) ? begin : end;
  int lastSide = 0;
  for (int step = 0; step < maximumSteps && std::abs(best.Height) > tolerance; ++step)
  {
    double x = begin.X - begin.Height * ((end.X - begin.X) / (end.Height - begin.Height));
    x = x > begin.X && x < end.X ? x : 0.5 * (begin.X + end.X);
    if (!(x > begin.X && x < end.X))
    {
      break; // neighboring doubles
    }
    const Probe probe = evaluate(x);
    if (std::abs(probe.Height) < std::abs(best.Height))
    {
      best = probe;
    }
    const int side = (probe.Height < 0.0) != beginIsAbove ? -1 : 1;
    (side < 0 ? begin : end) = probe;
    if (side == lastSide)
    {
      (side < 0 ? end : begin).Height *= 0.5;
    }
    lastSide = side;
  }
  return best;
}
}

#endif
