// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredPairs.h"

#include "RandomNumbers.h"
#include "dggExactGeodesics.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr unsigned int StartSeed = 20190521u;
constexpr unsigned int EndSeed = 20190522u;

dgg::SurfacePoint RandomVertex(const dgg::SurfaceMesh& surface, RandomNumbers& random)
{
  const dgg::Id count = surface.GetNumberOfVertices();
  auto vertex = static_cast<dgg::Id>(random() * count);
  while (surface.Kind(vertex) == dgg::VertexKind::Isolated)
  {
    vertex = (vertex + 1) % count;
  }
  return dgg::SurfacePoint::AtVertex(vertex);
}

/// Returns the cumulative area per face, including the face.
std::vector<double> SumAreas(const dgg::SurfaceMesh& surface)
{
  std::vector<double> sums;
  double sum = 0.0;
  for (dgg::Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    const dgg::Id h = 3 * f;
    sum += surface.IsDropped(f)
      ? 0.0
      : dgg::TriangleArea(surface.Length(h), surface.Length(h + 1), surface.Length(h + 2));
    sums.push_back(sum);
  }
  return sums;
}

dgg::SurfacePoint RandomPoint(
  const dgg::SurfaceMesh& surface, const std::vector<double>& areas, RandomNumbers& random)
{
  const auto found = std::upper_bound(areas.begin(), areas.end(), random() * areas.back());
  const double root = std::sqrt(random());
  const double t = random();
  return dgg::SurfacePoint::InFace(surface, static_cast<dgg::Id>(found - areas.begin()),
    { { 1.0 - root, root * (1.0 - t), root * t } });
}
}

std::vector<dgg::SurfacePoint> RandomPoints(
  const dgg::SurfaceMesh& surface, int count, bool atVertices, unsigned int seed)
{
  RandomNumbers random(seed);
  const std::vector<double> areas = atVertices ? std::vector<double>() : SumAreas(surface);
  std::vector<dgg::SurfacePoint> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(
      atVertices ? RandomVertex(surface, random) : RandomPoint(surface, areas, random));
  }
  return points;
}

MeasuredPairs::MeasuredPairs(const dgg::SurfaceMesh& surface, const PairRecipe& recipe)
  : Surface(surface)
  , PerStart(static_cast<std::size_t>(recipe.PerStart))
  , Starts(RandomPoints(surface, (recipe.Count + recipe.PerStart - 1) / recipe.PerStart,
      recipe.AtVertices, StartSeed))
  , Ends(RandomPoints(surface, recipe.Count, recipe.AtVertices, EndSeed))
{
}

const std::vector<double>& MeasuredPairs::GetExactDistances()
{
  if (!this->ExactDistances.empty())
  {
    return this->ExactDistances;
  }
  dgg::ExactGeodesics solver(this->Surface);
  for (std::size_t begin = 0; begin < this->Ends.size(); begin += this->PerStart)
  {
    const std::size_t end = std::min(begin + this->PerStart, this->Ends.size());
    dgg::ExactOptions options;
    options.Targets.assign(this->Ends.begin() + static_cast<std::ptrdiff_t>(begin),
      this->Ends.begin() + static_cast<std::ptrdiff_t>(end));
    options.StopAtTargets = true;
    dgg::ExactResult result;
    // Cannot fail for points of the surface.
    solver.Run({ { this->GetStart(begin), 0.0 } }, options, result);
    this->ExactDistances.insert(
      this->ExactDistances.end(), result.TargetDistances.begin(), result.TargetDistances.end());
  }
  return this->ExactDistances;
}
