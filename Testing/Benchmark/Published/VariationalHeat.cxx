// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VariationalHeat.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Weight of the difference of p and grad u relative to that of |p| and 1; a larger weight requires
/// more steps. With this value, ten steps reduce the error on spheres and on terrain; with 8, a
/// hundred do not. On scans and long triangles errors may increase although the energy decreases.
constexpr double Penalty = 0.5;

/// Returns the best p for v = grad u + w: the minimum of (|p| - 1)^2 + r/2 |p - v|^2, parallel to
/// v.
dgg::Point2 Shrunk(const dgg::Point2& v)
{
  const double norm = dgg::Norm(v.X, v.Y);
  const double scale = norm > 0.0 ? (2.0 + Penalty * norm) / ((2.0 + Penalty) * norm) : 0.0;
  return { scale * v.X, scale * v.Y };
}
}

VariationalHeat::VariationalHeat(const dgg::SurfaceMesh& mesh)
  : LaplaceSystem(mesh)
{
}

dgg::Status VariationalHeat::Prepare(bool isDelaunay)
{
  DGG_RETURN_IF_ERROR(this->Build(isDelaunay, dgg::Infinity, nullptr));
  this->Frames.clear();
  for (dgg::Id f = 0; f < this->Triangulation.GetNumberOfFaces(); ++f)
  {
    const dgg::Point2 apex = this->Triangulation.Apex(f);
    if (apex.Y > 0.0)
    {
      const dgg::Id h = 3 * f;
      this->Frames.push_back({ { { this->Triangulation.Origin(h), this->Triangulation.Origin(h + 1),
                                 this->Triangulation.Origin(h + 2) } },
        this->Triangulation.Length(h), apex });
    }
  }
  std::vector<std::uint8_t> isPinned(this->Components.size(), 0);
  for (const dgg::Id v : this->Pinned)
  {
    isPinned[v] = 1;
  }
  return this->Factor.Compute(this->Order, this->Stiffness, isPinned);
}

dgg::Point2 VariationalHeat::Gradient(const Frame& frame, const std::vector<double>& values)
{
  const double first = values[frame.Corners[0]];
  const double x = (values[frame.Corners[1]] - first) / frame.Length;
  return { x, (values[frame.Corners[2]] - first - x * frame.Apex.X) / frame.Apex.Y };
}

/// Adds the integrals of a flow against the gradients of the basis functions.
void VariationalHeat::AddDivergence(
  const Frame& frame, const dgg::Point2& flow, std::vector<double>& sums)
{
  const double atSecond = 0.5 * (frame.Apex.Y * flow.X - frame.Apex.X * flow.Y);
  const double atThird = 0.5 * frame.Length * flow.Y;
  sums[frame.Corners[0]] -= atSecond + atThird;
  sums[frame.Corners[1]] += atSecond;
  sums[frame.Corners[2]] += atThird;
}

void VariationalHeat::Improve(dgg::Id source, int iterations, std::vector<double>& distances) const
{
  // Unreached vertices have a constant value.
  std::vector<double> values = distances;
  for (double& value : values)
  {
    value = value < dgg::Infinity ? value : 0.0;
  }
  std::vector<double> straight(values.size(), 0.0); // at corners of faces at the source
  const auto isAtSource = [&](const Frame& frame) {
    return std::find(frame.Corners.begin(), frame.Corners.end(), source) != frame.Corners.end();
  };
  for (dgg::Id h = 0; h < this->Triangulation.GetNumberOfHalfEdges(); ++h)
  {
    const dgg::Id from = this->Triangulation.Origin(h);
    const dgg::Id to = this->Triangulation.Destination(h);
    if ((from == source) != (to == source))
    {
      straight[from == source ? to : from] = this->Triangulation.Length(h);
    }
  }
  std::vector<dgg::Point2> multipliers(this->Frames.size());
  for (int k = 0; k < iterations; ++k)
  {
    std::vector<double> sums(values.size(), 0.0);
    for (std::size_t f = 0; f < this->Frames.size(); ++f)
    {
      const Frame& frame = this->Frames[f];
      dgg::Point2& w = multipliers[f];
      if (isAtSource(frame))
      {
        AddDivergence(frame, Gradient(frame, straight), sums);
        continue;
      }
      const dgg::Point2 gradient = Gradient(frame, values);
      const dgg::Point2 v{ gradient.X + w.X, gradient.Y + w.Y };
      const dgg::Point2 p = Shrunk(v);
      w = dgg::Difference(v, p);
      AddDivergence(frame, dgg::Difference(p, w), sums);
    }
    for (const dgg::Id v : this->Pinned)
    {
      sums[v] = 0.0;
    }
    this->Factor.Solve(sums);
    values.swap(sums);
  }
  // The solution is unique up to a constant.
  const double shift = iterations > 0 ? values[source] : 0.0;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    distances[v] = distances[v] < dgg::Infinity ? values[v] - shift : dgg::Infinity;
  }
}

double VariationalHeat::Energy(const std::vector<double>& distances) const
{
  double energy = 0.0;
  for (const Frame& frame : this->Frames)
  {
    if (distances[frame.Corners[0]] < dgg::Infinity)
    {
      const dgg::Point2 gradient = Gradient(frame, distances);
      const double off = dgg::Norm(gradient.X, gradient.Y) - 1.0;
      energy += 0.5 * frame.Length * frame.Apex.Y * off * off;
    }
  }
  return energy;
}
