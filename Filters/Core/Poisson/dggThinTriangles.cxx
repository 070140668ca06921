// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggThinTriangles.h"

#include "dggPoissonSystem.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace dgg
{
namespace
{
constexpr double LargestLoss = 0.01;
/// Maximum fraction of the sources in components that exceed the loss.
constexpr double LargestThinSources = 1e-3;

/// Returns a pseudo-random number in [-1, 1), a hash of the vertex (the finalizer of MurmurHash3).
/// Random signs alone might be equal all over a small component, where sources in proportion to the
/// area have no effect.
double RandomNumber(Id v)
{
  auto bits = static_cast<std::uint64_t>(v) + 1;
  bits = (bits ^ (bits >> 33)) * 0xff51afd7ed558ccdULL;
  bits = (bits ^ (bits >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  bits ^= bits >> 33;
  return static_cast<double>(bits >> 11) * 0x1p-52 - 1.0; // 53 bits
}

/// Returns the share of a vertex in the area of its component, which is invariant under scaling.
double ShareOf(const PoissonSystem& system, Id v)
{
  const double area = system.GetComponentArea(system.GetComponent(v));
  return area > 0.0 ? system.GetArea(v) / area : 1.0;
}

/// Sums of two quantities per component, where the first is a fraction of the second.
class Parts
{
public:
  explicit Parts(const PoissonSystem& system)
    : System(system)
    , Sums(static_cast<std::size_t>(system.GetNumberOfComponents()))
    , Wholes(Sums)
  {
  }

  void Add(Id v, double part, double whole)
  {
    const auto c = static_cast<std::size_t>(this->System.GetComponent(v));
    this->Sums[c] += part;
    this->Wholes[c] += whole;
  }

  /// Returns the fraction of a component; NaN counts as 1.
  double Get(std::size_t c) const
  {
    const double part = this->Wholes[c] != 0.0 ? std::abs(this->Sums[c] / this->Wholes[c]) : 0.0;
    return part <= 1.0 ? part : 1.0;
  }

private:
  const PoissonSystem& System;
  std::vector<double> Sums;
  std::vector<double> Wholes;
};

/// Returns the factor by which the conductances of a triangle were scaled; 1 for most.
double GetSoftness(const IntrinsicTriangulation& triangles, Id f)
{
  double largest = PoissonSystem::LargestCotangent;
  for (Id h = 3 * f; h < 3 * f + 3; ++h)
  {
    largest = std::max(largest, std::abs(triangles.Cotangent(h)));
  }
  return PoissonSystem::LargestCotangent / largest;
}

Parts MeasureSoftenedEnergy(const PoissonSystem& system, const std::vector<double>& u)
{
  const IntrinsicTriangulation& triangles = system.GetTriangulation();
  Parts parts(system);
  for (Id f = 0; 3 * f < triangles.GetNumberOfHalfEdges(); ++f)
  {
    double energy = 0.0;
    const std::array<double, 3> cotangents = system.GetCotangents(f);
    for (int k = 0; k < 3; ++k)
    {
      const Id h = 3 * f + (k + 1) % 3; // opposite to the corner at the origin of 3 f + k
      const double change = u[triangles.Destination(h)] - u[triangles.Origin(h)];
      energy += cotangents[k] * change * change;
    }
    parts.Add(triangles.Origin(3 * f), (1.0 - GetSoftness(triangles, f)) * energy, energy);
  }
  return parts;
}

/// Measures rounding errors; the sums are squares.
Parts MeasureRounding(const PoissonSystem& system, const std::vector<double>& u)
{
  constexpr double lastBit = std::numeric_limits<double>::epsilon();
  std::vector<double> change(u.size());
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    const double flow = system.GetStiffness().coeff(v, v) * u[v];
    change[v] = system.IsFixed(v) ? 0.0 : RandomNumber(v) * lastBit * flow;
  }
  system.Solve(change);
  Parts parts(system);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    const double share = ShareOf(system, v);
    parts.Add(v, share * change[v] * change[v], share * u[v] * u[v]);
  }
  return parts;
}
}

std::vector<double> MeasureThinTriangles(const PoissonSystem& system)
{
  std::vector<double> u(static_cast<std::size_t>(system.GetNumberOfVertices()));
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    u[v] = system.IsFixed(v) ? 0.0 : RandomNumber(v) * ShareOf(system, v);
  }
  system.Solve(u);
  const Parts softened = MeasureSoftenedEnergy(system, u);
  const Parts rounding = MeasureRounding(system, u);
  std::vector<double> losses(static_cast<std::size_t>(system.GetNumberOfComponents()));
  for (std::size_t c = 0; c < losses.size(); ++c)
  {
    losses[c] = std::max(softened.Get(c), std::sqrt(rounding.Get(c)));
  }
  return losses;
}

Status CheckThinTriangles(const PoissonSystem& system, std::vector<std::uint8_t>& isThin)
{
  const std::vector<double> losses = MeasureThinTriangles(system);
  isThin.assign(losses.size(), 0);
  double lost = 0.0;
  double area = 0.0;
  double largest = 0.0;
  for (std::size_t c = 0; c < losses.size(); ++c)
  {
    const double a = system.GetComponentArea(static_cast<Id>(c));
    isThin[c] = losses[c] > LargestLoss ? 1 : 0;
    lost += a * losses[c];
    area += a;
    largest = std::max(largest, losses[c]);
  }
  const double mean = area > 0.0 ? lost / area : largest;
  if (mean <= LargestLoss)
  {
    return Status::Success();
  }
  return InvalidInput("The triangles are too thin: about ", std::lround(100.0 * mean),
    " % of a solution would be lost")
    .Fix("Use triangles with an aspect ratio below 100 000, or scale the surface equally in all "
         "directions");
}

Status CheckThinPlace(const PoissonSystem& system, Id component, const std::string& where)
{
  return system.IsThin(component)
    ? InvalidInput(where, " lies in a component whose triangles are too thin to solve equations")
        .Fix("Improve or exclude this component")
    : Status::Success();
}

Status CheckThinSources(
  const PoissonSystem& system, const std::vector<double>& sources, const std::string& noun)
{
  std::vector<std::uint8_t> isHeld(static_cast<std::size_t>(system.GetNumberOfComponents()), 0);
  for (const Id v : system.GetOptions().DirichletVertices)
  {
    isHeld[system.GetComponent(v)] = 1;
  }
  double thin = 0.0;
  double all = 0.0;
  Id largest = NoId;
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const auto v = static_cast<Id>(k);
    const Id c = system.GetComponent(v);
    const double size = system.IsFixed(v) ? 0.0 : std::abs(sources[k]);
    all += size;
    if (system.IsThin(c) && !isHeld[c])
    {
      thin += size;
      largest = largest == NoId || size > std::abs(sources[largest]) ? v : largest;
    }
  }
  return thin > LargestThinSources * all ? CheckThinPlace(system, system.GetComponent(largest),
                                             JoinText("The ", noun, " at vertex ", largest))
                                         : Status::Success();
}
}
