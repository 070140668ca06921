// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Roots of functions of one number. Internal.
#ifndef dggRootFinding_h
#define dggRootFinding_h

#include <cmath> // for std::abs

namespace dgg
{
/// Where a function is 0, between two places where it has different signs: the place closest to
/// that at which it was looked at. A probe has an abscissa X and a value Height, and `look(x)`
/// makes one. Ends when the value is no more than `close`, or after `mostSteps`.
///
/// Regula falsi in its Illinois form, which a kink does not harm.
template <typename Probe, typename Look>
Probe FindRoot(Probe begin, Probe end, double close, int mostSteps, const Look& look)
{
  const bool beginIsAbove = begin.Height >= 0.0;
  Probe best = std::abs(begin.Height) < std::abs(end.Height) ? begin : end;
  int lastSide = 0;
  for (int step = 0; step < mostSteps && std::abs(best.Height) > close; ++step)
  {
    double x = begin.X - begin.Height * ((end.X - begin.X) / (end.Height - begin.Height));
    x = x > begin.X && x < end.X ? x : 0.5 * (begin.X + end.X);
    if (!(x > begin.X && x < end.X))
    {
      break; // neighbours among the doubles
    }
    const Probe probe = look(x);
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
