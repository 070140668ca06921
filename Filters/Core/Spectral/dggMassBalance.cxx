// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMassBalance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace dgg
{
namespace
{
/// Make masses sum to 1, in two steps since their sum may be too large for a number. `total` is
/// what they summed to; with 0, nothing is done.
Status ScaleToOne(std::vector<double>& masses, double& total)
{
  double largest = 0.0;
  for (std::size_t v = 0; v < masses.size(); ++v)
  {
    if (!(masses[v] >= 0.0) || !std::isfinite(masses[v]))
    {
      std::ostringstream message;
      message << "the mass of vertex " << v << " is " << masses[v]
              << ": masses are finite and not negative";
      return Status::Invalid(message.str());
    }
    largest = std::max(largest, masses[v]);
  }
  double sum = 0.0;
  for (double& mass : masses)
  {
    mass = largest > 0.0 ? mass / largest : 0.0;
    sum += mass;
  }
  for (double& mass : masses)
  {
    mass = largest > 0.0 ? mass / sum : 0.0;
  }
  total = largest * sum;
  return std::isfinite(total) ? Status::Success()
                              : Status::Invalid("the sum of the masses is not finite: scale them");
}

/// Differences within the tolerance are taken off the second distribution.
Status BalanceComponents(
  const SurfaceMesh& mesh, std::vector<double>& from, std::vector<double>& to)
{
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  std::vector<double> fromSums(count, 0.0);
  std::vector<double> toSums(count, 0.0);
  for (std::size_t v = 0; v < from.size(); ++v)
  {
    fromSums[components[v]] += from[v];
    toSums[components[v]] += to[v];
  }
  for (std::size_t v = 0; v < from.size(); ++v)
  {
    const double a = fromSums[components[v]];
    const double b = toSums[components[v]];
    if (std::abs(a - b) > MassTolerance)
    {
      std::ostringstream message;
      message << "in the part of the surface with vertex " << v << " there is a fraction of " << a
              << " of the first distribution and " << b
              << " of the second one: nothing can get there from other parts, so give both the "
                 "same mass in each part";
      return Status::Invalid(message.str());
    }
    const double ratio = a / b;
    from[v] = b > 0.0 && std::isfinite(ratio) ? from[v] : 0.0;
    to[v] = b > 0.0 && std::isfinite(ratio) ? to[v] * ratio : 0.0;
  }
  return Status::Success();
}
}

Status BalanceMasses(const SurfaceMesh& mesh, bool normalize, std::vector<double>& from,
  std::vector<double>& to, double& total)
{
  const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  if (from.size() != n || to.size() != n)
  {
    return Status::Invalid("both distributions need one mass for each vertex");
  }
  double totals[2] = { 0.0, 0.0 };
  Status status = ScaleToOne(from, totals[0]);
  if (status.IsOk())
  {
    status = ScaleToOne(to, totals[1]);
  }
  if (!status.IsOk())
  {
    return status;
  }
  std::ostringstream message;
  if (normalize && !(std::min(totals[0], totals[1]) > 0.0))
  {
    message << "the " << (totals[0] > 0.0 ? "second" : "first")
            << " distribution has no mass: it cannot be normalized";
    return Status::Invalid(message.str());
  }
  if (!normalize &&
    std::abs(totals[0] - totals[1]) > MassTolerance * std::max(totals[0], totals[1]))
  {
    message << "the first distribution has the mass " << totals[0] << " and the second one "
            << totals[1] << ": give both the same, or have them normalized";
    return Status::Invalid(message.str());
  }
  total = normalize ? 1.0 : totals[0];
  return BalanceComponents(mesh, from, to);
}
}
