// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFieldTest.h"

#include "dggSteepestDescent.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace dgg
{
namespace
{
/// A slope within this part of the expected one is as expected.
constexpr double SlopeTolerance = 0.1;
/// Least part of the vertices with the expected slope. Measured: 0.83 and more for exact distances
/// and those of graphs, fast marching and heat on scans, 0.70 for paths along edges of the mesh,
/// 0.65 for exact ones on a terrain as rough as its cells are wide; a coordinate on a sphere has
/// 0.43, the square of a distance 0.11.
constexpr double SmallestShare = 0.5;
/// Most of the edges that may be steeper than that. Measured: 0.009 for heat.
constexpr double LargestSteepShare = 0.05;
/// Differences below this part of the values are rounding, as of floats.
constexpr double Rounding = 1e-6;

/// Slopes along edges and down from vertices.
struct Slopes
{
  std::vector<double> OfEdges;
  std::vector<double> FromVertices;

  /// The part of the vertices whose slope is about that.
  double ShareNear(double slope) const
  {
    return Share(
      this->FromVertices, [=](double s) { return std::abs(s - slope) <= SlopeTolerance * slope; });
  }
  /// The part of the edges that are clearly steeper.
  double ShareAbove(double slope) const
  {
    return Share(this->OfEdges, [=](double s) { return s > (1.0 + SlopeTolerance) * slope; });
  }

private:
  template <typename Predicate>
  static double Share(const std::vector<double>& slopes, const Predicate& predicate)
  {
    return slopes.empty()
      ? 0.0
      : static_cast<double>(std::count_if(slopes.begin(), slopes.end(), predicate)) /
        static_cast<double>(slopes.size());
  }
};

Slopes CollectSlopes(const SurfaceMesh& mesh, const double* values)
{
  double largest = 0.0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (std::isfinite(values[v]))
    {
      largest = std::max(largest, std::abs(values[v]));
    }
  }
  Slopes slopes;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const double difference = std::abs(values[mesh.Destination(h)] - values[mesh.Origin(h)]);
    if (!mesh.IsDropped(SurfaceMesh::Face(h)) && std::isfinite(difference))
    {
      slopes.OfEdges.push_back(std::max(0.0, difference - Rounding * largest) / mesh.Length(h));
    }
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const SteepestDescent descent = FindSteepestDescent(mesh, values, v);
    if (descent.IsKnown)
    {
      slopes.FromVertices.push_back(descent.Slope);
    }
  }
  return slopes;
}

std::string WithNumber(const char* format, double number)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, number);
  return text;
}
}

FieldReport TestField(const SurfaceMesh& mesh, const double* values)
{
  Slopes slopes = CollectSlopes(mesh, values);
  FieldReport report;
  report.NumberOfEdges = static_cast<Offset>(slopes.OfEdges.size());
  report.NumberOfVertices = static_cast<Offset>(slopes.FromVertices.size());
  if (slopes.FromVertices.empty())
  {
    report.Sentence = "The field is not known at any two neighbouring points: pass finite values.";
    return report;
  }
  const auto middle = slopes.FromVertices.begin() + report.NumberOfVertices / 2;
  std::nth_element(slopes.FromVertices.begin(), middle, slopes.FromVertices.end());
  report.MedianSlope = *middle;
  report.WorstSlope = *std::max_element(slopes.OfEdges.begin(), slopes.OfEdges.end());
  report.ShareOfSteepEdges = slopes.ShareAbove(1.0);
  report.ShareOfUnitSlopes = slopes.ShareNear(1.0);
  const double scale = report.MedianSlope;
  if (report.ShareOfUnitSlopes >= SmallestShare && report.ShareOfSteepEdges <= LargestSteepShare)
  {
    report.Verdict = FieldVerdict::Distance;
  }
  else if (scale > 0.0 && slopes.ShareNear(scale) >= SmallestShare &&
    slopes.ShareAbove(scale) <= LargestSteepShare)
  {
    report.Verdict = FieldVerdict::Scaled;
    report.Sentence = WithNumber("The field seems to be a distance in other units than those of "
                                 "the points: divide it by about %.3g.",
      scale);
  }
  else
  {
    report.Verdict = FieldVerdict::NotADistance;
    report.Sentence = WithNumber(
      "The field is hardly a distance: it should change by 1 per unit of length nearly everywhere, "
      "and does so on %.0f %% of the points only. Pass the distance itself, in the units of the "
      "points.",
      100.0 * report.ShareOfUnitSlopes);
  }
  return report;
}
}
