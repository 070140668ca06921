// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Harmonic B-splines: cells, basis, Poisson equations, choice of sites.
#include "EdgeGraph.h"
#include "GraphChecks.h"
#include "GreensTestTools.h"
#include "SplineTestTools.h"
#include "TestMeshes.h"

#include "dggPoissonSystem.h"

#include <iterator>

namespace dggtest
{
namespace
{
/// Returns the tolerance of sums of basis functions: 1e-10, or more where large coefficients
/// cancel, as among nearly flat triangles.
double ToleranceOfSums(const Splines& splines)
{
  double largest = 0.0;
  for (Id j = 0; j < static_cast<Id>(splines.Sites.size()); ++j)
  {
    largest = std::max(largest, std::abs(splines.Cells.Stiffness.coeff(j, j)));
  }
  return largest < 1e3 ? 1e-10 : 1e-10 * largest;
}
}

TEST(HarmonicSplines, CellsAreThoseOfTheNearestSites)
{
  const TestMesh bumpy = NoisySphere(3, 0.03, 8);
  const dgg::SurfaceMesh mesh = Build(bumpy);
  Splines splines(mesh);
  splines.PrepareSome(15);
  const std::vector<Id>& sites = splines.Sites;
  std::vector<std::vector<double>> distances;
  double weight = 0.0;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    distances.push_back(DistancesFrom(mesh, dgg::ExactEngine::Triangle, sites[i]));
    weight += splines.Cells.Weights[i];
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Id cell = splines.Functions.GetCells()[v];
    for (const std::vector<double>& others : distances)
    {
      ASSERT_LE(distances[cell][v], others[v] * (1.0 + 1e-12)) << v;
    }
  }
  EXPECT_NEAR(weight, 1.0, 1e-12);
}

TEST(HarmonicSplines, BasisSumsToOne)
{
  for (const NamedMesh& named : AllMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const bool delaunay : { false, true })
    {
      dgg::PoissonOptions options = With(dgg::PoissonBoundary::Neumann, delaunay);
      options.Weights = delaunay ? dgg::PoissonWeights::Uniform : dgg::PoissonWeights::Area;
      Splines splines(mesh, options);
      splines.PrepareSome(9);
      const auto basis = splines.Basis();
      const double tolerance = ToleranceOfSums(splines);
      Id count = 0;
      const std::vector<Id> components = mesh.ComputeComponents(count);
      std::vector<double> means(basis.size(), 0.0);
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const bool hasFace = mesh.FanBegin(v) != mesh.FanEnd(v);
        EXPECT_EQ(splines.Functions.GetCells()[v] == dgg::NoId, !hasFace);
        double sum = 0.0;
        for (std::size_t j = 0; j < basis.size(); ++j)
        {
          const bool isHere = components[splines.Sites[j]] == components[v];
          sum += basis[j][v];
          means[j] += isHere ? splines.Solver.GetWeight(v) * basis[j][v] : 0.0;
          if (!isHere)
          {
            EXPECT_EQ(basis[j][v], 0.0);
          }
        }
        ASSERT_NEAR(sum, hasFace ? 1.0 : 0.0, tolerance) << named.Name << " " << v;
      }
      for (std::size_t j = 0; j < basis.size(); ++j)
      {
        EXPECT_NEAR(means[j], splines.Cells.Weights[j], tolerance) << named.Name;
      }
    }
  }
}

TEST(HarmonicSplines, BasisIsMadeOfGreensFunctionsOfCells)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.02, 4));
  for (const auto weights : { dgg::PoissonWeights::Area, dgg::PoissonWeights::Uniform })
  {
    dgg::PoissonOptions options;
    options.Weights = weights;
    Splines splines(mesh, options);
    splines.PrepareSome(7);
    const dgg::HarmonicSplines& functions = splines.Functions;
    std::vector<std::vector<double>> means(7, std::vector<double>(mesh.GetNumberOfVertices(), 0.0));
    for (Id y = 0; y < mesh.GetNumberOfVertices(); ++y)
    {
      const Id cell = functions.GetCells()[y];
      const std::vector<double> column =
        splines.Run(dgg::SurfacePoint::AtVertex(y), dgg::GreensMethod::Vertex).Values;
      for (std::size_t v = 0; v < column.size(); ++v)
      {
        means[cell][v] += splines.Solver.GetWeight(y) / splines.Cells.Weights[cell] * column[v];
      }
    }
    const auto basis = splines.Basis();
    for (Id j = 0; j < 7; ++j)
    {
      std::vector<double> sum(means[j].size(), splines.Cells.Weights[j]);
      for (Id i = 0; i < 7; ++i)
      {
        for (std::size_t v = 0; v < sum.size(); ++v)
        {
          sum[v] +=
            i == j ? 0.0 : -splines.Cells.Stiffness.coeff(i, j) * (means[j][v] - means[i][v]);
        }
      }
      ExpectSameField(sum, basis[j], 1e-12, "basis");
    }
  }
}

TEST(HarmonicSplines, PointsInsideFaces)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.01, 2));
  Splines splines(mesh);
  splines.PrepareSome(12);
  const auto basis = splines.Basis();
  Random random(31);
  std::vector<dgg::SurfacePoint> points{ dgg::SurfacePoint::AtVertex(70),
    dgg::SurfacePoint::OnEdge(mesh, 44, 0.3) };
  for (int k = 0; k < 12; ++k)
  {
    points.push_back(InsideFace(mesh, random));
  }
  const std::vector<double> linear = splines.Evaluate(points, dgg::GreensMethod::Interpolated);
  const std::vector<double> smooth =
    splines.Evaluate(points, dgg::GreensMethod::SingularitySubtraction);
  ASSERT_EQ(linear.size(), 12 * points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    double sums[] = { 0.0, 0.0 };
    for (std::size_t j = 0; j < 12; ++j)
    {
      double expected = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        expected += dgg::IsVertex(points[k])
          ? basis[j][points[k].Vertex] / 3.0
          : points[k].Barycentric[c] * basis[j][mesh.Origin(3 * points[k].Face + c)];
      }
      sums[0] += linear[12 * k + j];
      sums[1] += smooth[12 * k + j];
      EXPECT_NEAR(linear[12 * k + j], expected, 1e-10);
      EXPECT_NEAR(smooth[12 * k + j], expected, 0.02); // cells have 50 vertices
    }
    EXPECT_NEAR(sums[0], 1.0, 1e-10);
    EXPECT_NEAR(sums[1], 1.0, 1e-10);
  }
}

TEST(HarmonicSplines, AnyTrianglesWillDo)
{
  // Among nearly flat triangles the equations may be singular up to rounding; then only finite
  // results are required.
  int sound = 0;
  int thin = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    Random random(seed);
    const dgg::SurfaceMesh mesh =
      Build(RandomSoup(3 + random.Index(30), 1 + random.Index(60), seed));
    for (const auto boundary : Boundaries)
    {
      if (IsTooThin(mesh, With(boundary, true)))
      {
        ++thin;
        continue;
      }
      Splines splines(mesh, With(boundary, true));
      std::vector<Id> sites;
      ASSERT_TRUE(dgg::ChooseSplineSites(splines.Solver, 4, nullptr, sites).IsOk());
      if (sites.empty())
      {
        continue;
      }
      splines.Prepare(sites);
      const auto basis = splines.Basis();
      double largest = 0.0;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        largest = std::max(largest, splines.Solver.GetSystem().GetStiffness().coeff(v, v));
      }
      const bool isSound = boundary == dgg::PoissonBoundary::Neumann && largest < 1e3;
      sound += isSound ? 1 : 0;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        double sum = 0.0;
        for (const std::vector<double>& function : basis)
        {
          ASSERT_TRUE(std::isfinite(function[v])) << seed;
          sum += function[v];
        }
        if (isSound)
        {
          ASSERT_NEAR(sum, splines.Functions.GetCells()[v] == dgg::NoId ? 0.0 : 1.0, 1e-10) << seed;
        }
      }
    }
  }
  EXPECT_GT(sound, 10);
  EXPECT_LT(thin, 10);
}

TEST(HarmonicSplines, SmoothOnesHaveNoKinksAtEdges)
{
  // Second differences across edges; for piecewise linear functions they measure only the kinks.
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.01, 2));
  Splines splines(mesh);
  splines.PrepareSome(40);
  std::vector<dgg::SurfacePoint> points;
  const double off = 0.1;
  for (Id h = 7; h < mesh.GetNumberOfHalfEdges() && points.size() < 60; h += 97)
  {
    points.push_back(dgg::SurfacePoint::OnEdge(mesh, h, 0.5));
    for (const Id side : { h, mesh.Twin(h) })
    {
      std::array<double, 3> weights;
      weights.fill(0.5 * (1.0 - off));
      weights[(side + 2) % 3] = off;
      points.push_back(dgg::SurfacePoint::InFace(mesh, side / 3, weights));
    }
  }
  double kinks[] = { 0.0, 0.0 };
  for (const bool isSmooth : { false, true })
  {
    const std::vector<double> values = splines.Evaluate(points,
      isSmooth ? dgg::GreensMethod::SingularitySubtraction : dgg::GreensMethod::Interpolated);
    for (std::size_t k = 0; k < points.size(); k += 3)
    {
      for (std::size_t j = 0; j < 40; ++j)
      {
        kinks[isSmooth ? 1 : 0] +=
          std::abs(values[(k + 1) * 40 + j] + values[(k + 2) * 40 + j] - 2.0 * values[k * 40 + j]);
      }
    }
  }
  EXPECT_LT(kinks[1], 0.2 * kinks[0]);
}

namespace
{
/// Returns the relative L2 error over all vertices.
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

/// Solves for an eigenfunction of the Laplacian with increasing numbers of sites. Expects the error
/// to fall with the number of vertices per cell at the given order, down to a fiftieth. Returns the
/// last solution.
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
    for (const dgg::PoissonOptions& options : AllPoissonOptions())
    {
      Splines splines(mesh, options);
      splines.PrepareAll();
      const auto basis = splines.Basis();
      for (std::size_t i = 0; i < basis.size(); ++i)
      {
        std::vector<double> unit(mesh.GetNumberOfVertices(), 0.0);
        unit[splines.Sites[i]] = 1.0;
        ExpectSameField(unit, basis[i], 1e-10, named.Name);
      }
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
  // A closed surface, and a surface with Neumann boundary conditions.
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
  // The eigenfunction sin(pi x) sin(pi y) vanishes on the boundary, where values are given.
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
}

TEST(HarmonicSplines, GivenSitesOfLinearFunctionsAreContinuedLinearly)
{
  // Natural boundary conditions; values are given at sites on the boundary.
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

// Choice of vertices as sites of harmonic B-splines.

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
