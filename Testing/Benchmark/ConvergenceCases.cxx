// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ConvergenceCases.h"

#include "BenchmarkTools.h"
#include "OpenedSolver.h"
#include "RandomNumbers.h"
#include "dggHarmonicSplines.h"
#include "dggSplineSites.h"
#include "dggSurfacePath.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr unsigned int PoleSeed = 20190526u;
constexpr double LocalRadius = 0.2;
/// Barycentric coordinates of poles: not next to corners or sides, where all that is interpolated
/// is better.
constexpr double LeastCoordinate = 0.05;

/// The Green's function of the sphere, mean 0.
double ClosedForm(double cosine)
{
  return -(std::log(1.0 - cosine) + 1.0 - std::log(2.0)) / (4.0 * dgg::Pi);
}

std::vector<dgg::SurfacePoint> PolesOf(const dgg::SurfaceMesh& surface, int count)
{
  RandomNumbers random(PoleSeed);
  std::vector<dgg::SurfacePoint> poles;
  while (static_cast<int>(poles.size()) < count)
  {
    const double place = random();
    const double a = random();
    const double b = random();
    const double c = 1.0 - a - b;
    if (std::min({ a, b, c }) > LeastCoordinate)
    {
      const auto face = static_cast<dgg::Id>(place * surface.GetNumberOfFaces());
      poles.push_back(dgg::SurfacePoint::InFace(surface, face, { { a, b, c } }));
    }
  }
  return poles;
}

MeshRecipe SphereOf(int level)
{
  MeshRecipe recipe;
  recipe.Name = "icosphere-" + std::to_string(level);
  recipe.Level = level;
  recipe.IsRound = true;
  return recipe;
}

/// Squares of differences and of values, weighted with areas.
struct SquareError
{
  double Difference = 0.0;
  double Size = 0.0;

  void Add(double area, double value, double truth)
  {
    this->Difference += area * (value - truth) * (value - truth);
    this->Size += area * truth * truth;
  }
  double GetRelative() const { return std::sqrt(this->Difference / this->Size); }
};
}

void MeasureConvergence(benchmark::State& state, int level, const GreensWay& way, int poles)
{
  const OpenedSolver opened = OpenSolver(SphereOf(level));
  const dgg::SurfaceMesh& surface = opened.Mesh->GetSurface();
  const std::vector<double>& points = opened.Mesh->GetArrays().Points;
  const std::vector<dgg::SurfacePoint> places = PolesOf(surface, poles);
  std::vector<dgg::GreensResult> results(places.size());
  dgg::Status status;
  Measure(
    state, [] {},
    [&] {
      MeasuredGreens greens(*opened.Solver, way);
      for (std::size_t k = 0; k < places.size() && status.IsOk(); ++k)
      {
        status = greens.Run(places[k], results[k]);
      }
    });
  Require(status);
  double local = 0.0;
  double global = 0.0;
  double largest = 0.0;
  int others = 0;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const auto x = dgg::PositionOf(surface, places[k], points.data());
    const double norm = std::hypot(x[0], x[1], x[2]);
    SquareError near;
    SquareError all;
    for (dgg::Id v = 0; v < surface.GetNumberOfVertices(); ++v)
    {
      const double* y = points.data() + 3 * static_cast<std::size_t>(v);
      const double cosine = (x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) / norm;
      const double area = opened.Solver->GetAreas()[v];
      const double value = results[k].Values[v];
      const double truth = ClosedForm(cosine);
      all.Add(area, value, truth);
      if (cosine > std::cos(LocalRadius))
      {
        near.Add(area, value, truth);
      }
      largest = std::max(largest, std::abs(value - truth));
    }
    local += near.GetRelative() / poles;
    global += all.GetRelative() / poles;
    others += results[k].Method == way.Method ? 0 : 1;
  }
  ReportMesh(state, *opened.Mesh);
  state.counters["mean_edge"] = surface.GetMeanEdgeLength();
  state.counters["poles"] = poles;
  state.counters["other_method"] = others;
  state.counters["error_local"] = local;
  state.counters["error_global"] = global;
  state.counters["error_largest"] = largest;
}

void MeasureSplines(benchmark::State& state, int level, int sites)
{
  const OpenedSolver opened = OpenSolver(SphereOf(level));
  const std::vector<double>& points = opened.Mesh->GetArrays().Points;
  const std::vector<double>& areas = opened.Solver->GetAreas();
  std::vector<double> truth;
  std::vector<double> sources;
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    truth.push_back(points[3 * v] * points[3 * v + 2]);
    sources.push_back(6.0 * areas[v] * truth.back());
  }
  dgg::HarmonicSplines splines(*opened.Solver);
  std::vector<double> solution;
  dgg::Status status;
  std::vector<dgg::Id> places;
  Measure(
    state, [] {},
    [&] {
      std::vector<double> coefficients;
      status = dgg::ChooseSplineSites(*opened.Solver, sites, nullptr, places);
      status = status.IsOk() ? splines.Prepare(places, nullptr, nullptr) : status;
      status = status.IsOk() ? splines.Solve(sources, {}, coefficients) : status;
      status = status.IsOk() ? splines.Combine(coefficients, {}, solution) : status;
    });
  Require(status);
  SquareError error;
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    error.Add(areas[v], solution[v], truth[v]);
  }
  ReportMesh(state, *opened.Mesh);
  state.counters["sites"] = static_cast<double>(places.size());
  state.counters["error"] = error.GetRelative();
}
