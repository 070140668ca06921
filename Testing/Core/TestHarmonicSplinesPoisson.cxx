// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Harmonic B-splines: Poisson equations on sites.
#include "EdgeGraph.h"
#include "SplineTestTools.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
/// Relative error over all vertices.
double RelativeL2(const dgg::PoissonSolver& solver, const std::vector<double>& values,
  const std::function<double(Id)>& truth)
{
  Comparison comparison;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    comparison.Add(solver.GetAreas()[v], values[v], truth(static_cast<Id>(v)));
  }
  return comparison.Relative();
}

TestMesh UnitSquare()
{
  const Id n = 48;
  return Scaled(Plane(n, n, 0.2), 1.0 / n);
}

/// Solutions for an eigenfunction of the Laplacian, with ever more sites: the error falls with the
/// number of vertices per cell at such an order, to a fiftieth. Returns the last solution.
std::vector<double> ExpectErrorsToFall(Splines& splines, const std::vector<Id>& counts,
  double eigenvalue, const std::function<double(Id)>& truth, double order)
{
  const std::vector<double> sources =
    Integrated(splines.Solver, [&](Id v) { return eigenvalue * truth(v); });
  std::vector<double> solution;
  Convergence errors(order);
  for (const Id count : counts)
  {
    splines.PrepareSome(count);
    solution = splines.Combine(splines.SolveSites(sources));
    const double error = RelativeL2(splines.Solver, solution, truth);
    ::testing::Test::RecordProperty("error" + std::to_string(count), std::to_string(error));
    errors.Add(error);
  }
  EXPECT_LT(errors.Last, 0.02);
  return solution;
}
}

TEST(HarmonicSplines, AllVerticesAsSitesSolveAsFiniteElementsDo)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const auto boundary : Boundaries)
    {
      Splines splines(mesh, With(boundary));
      splines.PrepareAll();
      const std::vector<double> sources = RandomValues(mesh.GetNumberOfVertices(), 9);
      std::vector<double> solution = sources;
      ASSERT_TRUE(splines.Solver.Solve(solution).IsOk());
      const std::vector<double> coefficients = splines.SolveSites(sources);
      for (std::size_t i = 0; i < coefficients.size(); ++i)
      {
        ASSERT_NEAR(coefficients[i], solution[splines.Sites[i]], 1e-9) << named.Name;
      }
      ExpectSameField(solution, splines.Combine(coefficients, sources), 1e-9, named.Name);
    }
  }
}

TEST(HarmonicSplines, CombinationsAreSumsOfTheBasis)
{
  for (const auto boundary : Boundaries)
  {
    const dgg::SurfaceMesh mesh = Build(SeveralComponents());
    Splines splines(mesh, With(boundary));
    splines.PrepareSome(11);
    const auto basis = splines.Basis();
    std::vector<double> expected(mesh.GetNumberOfVertices(), 0.0);
    const std::vector<double> coefficients = RandomValues(basis.size(), 4);
    for (std::size_t j = 0; j < basis.size(); ++j)
    {
      for (std::size_t v = 0; v < expected.size(); ++v)
      {
        expected[v] += coefficients[j] * basis[j][v];
      }
    }
    ExpectSameField(expected, splines.Combine(coefficients), 1e-10, "sum");
  }
}

TEST(HarmonicSplines, ErrorsFallLikeTheSquareOfTheCells)
{
  // On a closed surface, and on one with a boundary that nothing flows through.
  const TestMesh meshes[] = { Icosphere(4), UnitSquare() };
  for (const bool isSquare : { false, true })
  {
    const TestMesh& points = meshes[isSquare];
    const dgg::SurfaceMesh mesh = Build(points);
    Splines splines(mesh);
    const auto truth = [&](Id v) {
      const double* p = points.Point(v);
      return isSquare ? std::cos(dgg::Pi * p[0]) * std::cos(dgg::Pi * p[1]) : p[0] * p[2];
    };
    const std::vector<Id> counts =
      isSquare ? std::vector<Id>{ 12, 48, 192 } : std::vector<Id>{ 24, 96, 384 };
    ExpectErrorsToFall(splines, counts, isSquare ? 2.0 * dgg::Pi * dgg::Pi : 6.0, truth, 1.7);
  }
}

TEST(HarmonicSplines, GivenValuesOnTheBoundary)
{
  // sin sin vanishes on the boundary, functions of sites do.
  const TestMesh plane = UnitSquare();
  const dgg::SurfaceMesh mesh = Build(plane);
  Splines splines(mesh, With(dgg::PoissonBoundary::Dirichlet));
  const auto truth = [&](Id v) {
    return std::sin(dgg::Pi * plane.Point(v)[0]) * std::sin(dgg::Pi * plane.Point(v)[1]);
  };
  const std::vector<double> solution =
    ExpectErrorsToFall(splines, { 12, 48, 192 }, 2.0 * dgg::Pi * dgg::Pi, truth, 1.5);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (splines.Solver.IsFixed(v))
    {
      ASSERT_EQ(solution[v], 0.0);
      ASSERT_EQ(splines.Functions.GetCells()[v], dgg::NoId);
    }
  }

  // Away from the boundary the functions sum to 1.
  const auto basis = splines.Basis();
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double sum = 0.0;
    for (const std::vector<double>& function : basis)
    {
      sum += function[v];
    }
    const double x = plane.Point(v)[0];
    const double y = plane.Point(v)[1];
    const double inside = std::min({ x, y, 1.0 - x, 1.0 - y });
    ASSERT_LT(sum, 1.35);
    if (inside > 0.3)
    {
      ASSERT_NEAR(sum, 1.0, 0.06) << x << " " << y;
    }
  }
}

TEST(HarmonicSplines, GivenSitesOfLinearFunctionsAreContinuedLinearly)
{
  // Natural conditions; values are given at sites on the boundary.
  const TestMesh plane = Plane(11, 8, 0.25);
  const dgg::SurfaceMesh mesh = Build(plane);
  Splines splines(mesh);
  splines.PrepareAll();
  const auto linear = [&](Id v) { return 1.0 + 2.0 * plane.Point(v)[0] - 3.0 * plane.Point(v)[1]; };
  std::vector<double> coefficients(mesh.GetNumberOfVertices(), 0.0);
  std::vector<Id> given;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.Kind(v) == dgg::VertexKind::Boundary)
    {
      given.push_back(v);
      coefficients[v] = linear(v);
    }
  }
  const std::vector<double> nothing(mesh.GetNumberOfVertices(), 0.0);
  ASSERT_TRUE(Ok(splines.Functions.Solve(nothing, given, coefficients)));
  const std::vector<double> values = splines.Combine(coefficients);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_NEAR(coefficients[v], linear(v), 1e-10);
    EXPECT_NEAR(values[v], linear(v), 1e-10);
  }
}

// Which vertices become sites of harmonic B-splines.

TEST(SplineSites, AreFarthestPointsAlongEdges)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.02, 6));
  const Greens greens(mesh);
  std::vector<Id> sites;
  ASSERT_TRUE(dgg::ChooseSplineSites(greens.Solver, 12, nullptr, sites).IsOk());
  ASSERT_EQ(sites.size(), 12u);
  std::vector<dgg::GeodesicSource> sources{ { dgg::SurfacePoint::AtVertex(sites[0]), 0.0 } };
  for (std::size_t k = 1; k < sites.size(); ++k)
  {
    const std::vector<double> distances = dggtest::EdgeGraphDistances(mesh, sources);
    const double farthest = *std::max_element(distances.begin(), distances.end());
    EXPECT_NEAR(distances[sites[k]], farthest, 1e-12 * farthest) << k;
    sources.push_back({ dgg::SurfacePoint::AtVertex(sites[k]), 0.0 });
  }
}

TEST(SplineSites, EveryComponentHasOne)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  for (const auto boundary : Boundaries)
  {
    const Greens greens(mesh, With(boundary));
    EXPECT_EQ(dgg::CountSplineComponents(greens.Solver), count);
    for (const Id wanted : { 0, 1, 5 })
    {
      std::vector<Id> sites;
      ASSERT_TRUE(dgg::ChooseSplineSites(greens.Solver, wanted, nullptr, sites).IsOk());
      EXPECT_EQ(static_cast<Id>(sites.size()), std::max(wanted, count));
      std::set<Id> seen;
      for (const Id site : sites)
      {
        seen.insert(components[site]);
      }
      EXPECT_EQ(static_cast<Id>(seen.size()), count);
      EXPECT_TRUE(dgg::CheckSplineSites(greens.Solver, sites).IsOk());
    }
  }
}

TEST(SplineSites, AreNotMoreThanVerticesThatAreFree)
{
  for (const TestMesh& input : { Plane(5, 4), SphereWithIsolatedPoints(1) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    for (const auto boundary : Boundaries)
    {
      const Greens greens(mesh, With(boundary));
      std::vector<Id> sites;
      ASSERT_TRUE(dgg::ChooseSplineSites(greens.Solver, 1000, nullptr, sites).IsOk());
      std::sort(sites.begin(), sites.end());
      EXPECT_EQ(sites, AllFreeVertices(greens.Solver));
    }
  }
}

TEST(SplineSites, AreFarFromGivenValues)
{
  const TestMesh points = Plane(20, 20);
  const dgg::SurfaceMesh mesh = Build(points);
  const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
  std::vector<Id> sites;
  ASSERT_TRUE(dgg::ChooseSplineSites(greens.Solver, 1, nullptr, sites).IsOk());
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_EQ(points.Point(sites[0])[0], 10.0);
  EXPECT_EQ(points.Point(sites[0])[1], 10.0);
}
}
