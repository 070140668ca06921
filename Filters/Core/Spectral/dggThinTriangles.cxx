// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggThinTriangles.h"

#include "dggPoissonSystem.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <vector>

namespace dgg
{
namespace
{
constexpr double LargestPart = 0.01;

/// 1 or -1, as a hash of the vertex has it (the finalizer of MurmurHash3).
double RandomSign(Id v)
{
  auto bits = static_cast<std::uint64_t>(v) + 1;
  bits = (bits ^ (bits >> 33)) * 0xff51afd7ed558ccdULL;
  bits = (bits ^ (bits >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return (bits ^ (bits >> 33)) & 1 ? 1.0 : -1.0;
}

/// Sums of two quantities in each component, of which the first is a part of the second.
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

  /// `whole` of a component of which nothing is known counts as lost.
  template <typename Function>
  double GetMean(Function&& partOf) const
  {
    double mean = 0.0;
    double area = 0.0;
    for (std::size_t c = 0; c < this->Sums.size(); ++c)
    {
      const double a = this->System.GetComponentArea(static_cast<Id>(c));
      if (this->Wholes[c] != 0.0)
      {
        const double part = partOf(this->Sums[c] / this->Wholes[c]);
        mean += a * (part <= 1.0 ? part : 1.0);
      }
      area += a;
    }
    return area > 0.0 ? mean / area : 0.0;
  }

private:
  const PoissonSystem& System;
  std::vector<double> Sums;
  std::vector<double> Wholes;
};

/// What the conductances of a triangle were multiplied with: 1 for most.
double GetSoftness(const IntrinsicTriangulation& triangles, Id f)
{
  double largest = PoissonSystem::LargestCotangent;
  for (Id h = 3 * f; h < 3 * f + 3; ++h)
  {
    largest = std::max(largest, std::abs(triangles.Cotangent(h)));
  }
  return PoissonSystem::LargestCotangent / largest;
}

double MeasureSoftenedEnergy(const PoissonSystem& system, const std::vector<double>& u)
{
  const IntrinsicTriangulation& triangles = system.GetTriangulation();
  Parts parts(system);
  for (Id f = 0; 3 * f < triangles.GetNumberOfHalfEdges(); ++f)
  {
    double energy = 0.0;
    const std::array<double, 3> cotangents = system.GetCotangents(f);
    for (int k = 0; k < 3; ++k)
    {
      const Id h = 3 * f + (k + 1) % 3; // opposite of the corner at the origin of 3 f + k
      const double change = u[triangles.Destination(h)] - u[triangles.Origin(h)];
      energy += cotangents[k] * change * change;
    }
    parts.Add(triangles.Origin(3 * f), (1.0 - GetSoftness(triangles, f)) * energy, energy);
  }
  return parts.GetMean([](double ratio) { return std::abs(ratio); });
}

double MeasureRounding(const PoissonSystem& system, const std::vector<double>& u)
{
  constexpr double lastBit = std::numeric_limits<double>::epsilon();
  std::vector<double> change(u.size());
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    const double flow = system.GetStiffness().coeff(v, v) * u[v];
    change[v] = system.IsFixed(v) ? 0.0 : RandomSign(v) * lastBit * flow;
  }
  system.Solve(change);
  Parts parts(system);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    parts.Add(v, system.GetArea(v) * change[v] * change[v], system.GetArea(v) * u[v] * u[v]);
  }
  return parts.GetMean([](double ratio) { return std::sqrt(ratio); });
}
}

double MeasureThinTriangles(const PoissonSystem& system)
{
  std::vector<double> u(static_cast<std::size_t>(system.GetNumberOfVertices()));
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    u[v] = system.IsFixed(v) ? 0.0 : RandomSign(v) * system.GetArea(v);
  }
  system.Solve(u);
  return std::max(MeasureSoftenedEnergy(system, u), MeasureRounding(system, u));
}

Status CheckThinTriangles(const PoissonSystem& system)
{
  const double part = MeasureThinTriangles(system);
  if (part <= LargestPart)
  {
    return Status::Success();
  }
  std::ostringstream message;
  message.precision(2);
  message << "the triangles are too thin: about " << 100.0 * part
          << " % of a solution would be lost. Make a surface of better triangles, less than some "
             "100 000 times as long as high, or scale it by the same factor in all directions";
  return Status::Invalid(message.str());
}
}
