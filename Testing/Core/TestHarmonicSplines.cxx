// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Harmonic B-splines: cells, coefficients, the basis, Poisson equations on sites.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GraphChecks.h"
#include "SplineTestTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
std::vector<NamedMesh> SmallMeshes()
{
  return { { "sphere", NoisySphere(2, 0.02, 3) }, { "plane", Scaled(Plane(9, 7, 0.3), 0.1) },
    { "torus", Torus(14, 9) }, { "several", SeveralComponents() } };
}

/// L, vertex by vertex, as columns.
std::vector<double> LaplacianOf(const dgg::PoissonSolver& solver, Id vertex)
{
  std::vector<double> unit(solver.GetAreas().size(), 0.0);
  unit[vertex] = 1.0;
  std::vector<double> product;
  EXPECT_TRUE(solver.Multiply(unit, product).IsOk());
  return product;
}

/// What sums of basis functions may be off: 1e-10, or more where large coefficients cancel, as
/// among triangles that are next to flat.
double ToleranceOfSums(const Splines& splines)
{
  double largest = 0.0;
  for (Id j = 0; j < static_cast<Id>(splines.Functions.GetSites().size()); ++j)
  {
    largest = std::max(largest, std::abs(splines.Functions.GetCoefficient(j, j)));
  }
  return largest < 1e3 ? 1e-10 : 1e-10 * largest;
}

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
}

TEST(HarmonicSplines, AllVerticesAsSitesGiveTheKroneckerDelta)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const auto boundary : { dgg::PoissonBoundary::Neumann, dgg::PoissonBoundary::Dirichlet })
    {
      for (const bool delaunay : { false, true })
      {
        Splines splines(mesh, With(boundary, delaunay));
        splines.PrepareAll();
        const std::vector<Id>& sites = splines.Functions.GetSites();
        const auto basis = splines.Basis();
        double worst = 0.0;
        for (std::size_t i = 0; i < sites.size(); ++i)
        {
          for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
          {
            worst = std::max(worst, std::abs(basis[i][v] - (v == sites[i] ? 1.0 : 0.0)));
          }
        }
        EXPECT_LT(worst, 1e-10) << named.Name;
      }
    }
  }
}

TEST(HarmonicSplines, CoefficientsOfSingleVerticesAreTheirCotangents)
{
  // One vertex is no site, so that borders are measured; away from its cell nothing changes.
  for (const NamedMesh& named : SmallMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const bool delaunay : { false, true })
    {
      Splines splines(mesh, With(dgg::PoissonBoundary::Neumann, delaunay));
      std::vector<Id> sites = AllFreeVertices(splines.Solver);
      const Id left = sites[sites.size() / 2];
      sites.erase(sites.begin() + static_cast<std::ptrdiff_t>(sites.size() / 2));
      splines.Prepare(sites);
      const Id large = splines.Functions.GetCells()[left];
      int compared = 0;
      for (std::size_t i = 0; i < sites.size(); ++i)
      {
        const std::vector<double> column = LaplacianOf(splines.Solver, sites[i]);
        for (std::size_t j = 0; j < sites.size() && static_cast<Id>(i) != large; ++j)
        {
          if (static_cast<Id>(j) != large && (i != j || column[left] == 0.0))
          {
            ASSERT_NEAR(splines.Functions.GetCoefficient(static_cast<Id>(i), static_cast<Id>(j)),
              column[sites[j]], 1e-10)
              << named.Name;
            compared += column[sites[j]] != 0.0 ? 1 : 0;
          }
        }
      }
      EXPECT_GT(compared, 100) << named.Name;
    }
  }
}

TEST(HarmonicSplines, CoefficientsAreLengthsOfBordersOverDistances)
{
  // Squares around 16 sites: borders are as long as the sites are far from each other. The dual
  // edges that they are made of are longer by a quarter.
  for (const Id n : { 32, 64, 128 })
  {
    const TestMesh plane = Scaled(Plane(n, n, 0.25, 5), 1.0 / n);
    const dgg::SurfaceMesh mesh = Build(plane);
    Splines splines(mesh);
    std::vector<Id> sites;
    for (Id j = n / 8; j < n; j += n / 4)
    {
      for (Id i = n / 8; i < n; i += n / 4)
      {
        sites.push_back(j * (n + 1) + i);
      }
    }
    splines.Prepare(sites);
    double mean = 0.0;
    double farthest = 0.0;
    for (Id j = 0; j < 4; ++j)
    {
      for (Id i = 0; i < 3; ++i)
      {
        const double across = -splines.Functions.GetCoefficient(4 * j + i, 4 * j + i + 1);
        const double along = -splines.Functions.GetCoefficient(4 * i + j, 4 * i + 4 + j);
        mean += (across + along) / 24.0;
        farthest = std::max({ farthest, std::abs(across - 1.0), std::abs(along - 1.0) });
      }
    }
    EXPECT_NEAR(mean, 1.0, 1.5 / n) << n;
    EXPECT_LT(farthest, 7.0 / n) << n; // an edge at each end of a border
  }
}

TEST(HarmonicSplines, CellsAreThoseOfTheNearestSites)
{
  const TestMesh bumpy = NoisySphere(3, 0.03, 8);
  const dgg::SurfaceMesh mesh = Build(bumpy);
  Splines splines(mesh);
  splines.PrepareSome(15);
  const std::vector<Id>& sites = splines.Functions.GetSites();
  std::vector<std::vector<double>> distances;
  double area = 0.0;
  double weight = 0.0;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    distances.push_back(DistancesFrom(mesh, dgg::ExactEngine::Triangle, sites[i]));
    area += splines.Functions.GetCellArea(static_cast<Id>(i));
    weight += splines.Functions.GetCellWeight(static_cast<Id>(i));
  }
  double total = 0.0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    total += splines.Solver.GetAreas()[v];
    const Id cell = splines.Functions.GetCells()[v];
    for (const std::vector<double>& others : distances)
    {
      ASSERT_LE(distances[cell][v], others[v] * (1.0 + 1e-12)) << v;
    }
  }
  EXPECT_NEAR(area, total, 1e-12 * total);
  EXPECT_NEAR(weight, 1.0, 1e-12);
}

TEST(HarmonicSplines, BasisSumsToOne)
{
  std::vector<NamedMesh> meshes = SoundMeshes();
  for (const NamedMesh& named : DefectMeshes())
  {
    meshes.push_back(named);
  }
  for (const NamedMesh& named : meshes)
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
          const bool isHere = components[splines.Functions.GetSites()[j]] == components[v];
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
        EXPECT_NEAR(means[j], splines.Functions.GetCellWeight(static_cast<Id>(j)), tolerance)
          << named.Name;
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
    std::vector<std::vector<double>> greens(7);
    ASSERT_TRUE(functions
                  .FindGreens(nullptr, nullptr,
                    [&](Id site, const std::vector<double>& values) { greens[site] = values; })
                  .IsOk());
    std::vector<std::vector<double>> means(7, std::vector<double>(mesh.GetNumberOfVertices(), 0.0));
    for (Id y = 0; y < mesh.GetNumberOfVertices(); ++y)
    {
      const Id cell = functions.GetCells()[y];
      const std::vector<double> column =
        splines.Run(dgg::SurfacePoint::AtVertex(y), dgg::GreensMethod::Vertex).Values;
      for (std::size_t v = 0; v < column.size(); ++v)
      {
        means[cell][v] += splines.Solver.GetWeight(y) / functions.GetCellWeight(cell) * column[v];
      }
    }
    const auto basis = splines.Basis();
    for (Id j = 0; j < 7; ++j)
    {
      ExpectSameField(means[j], greens[j], 1e-12, "mean Green's function");
      std::vector<double> sum(greens[j].size(), functions.GetCellWeight(j));
      for (Id i = 0; i < 7; ++i)
      {
        for (std::size_t v = 0; v < sum.size(); ++v)
        {
          sum[v] += i == j ? 0.0 : -functions.GetCoefficient(i, j) * (greens[j][v] - greens[i][v]);
        }
      }
      ExpectSameField(sum, basis[j], 1e-12, "basis");
    }
  }
}

TEST(HarmonicSplines, BasisPeaksAtItsSiteAndDiesAway)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(4));
  Splines splines(mesh);
  splines.PrepareSome(40);
  const std::vector<Id>& sites = splines.Functions.GetSites();
  const auto basis = splines.Basis();
  for (std::size_t j = 0; j < sites.size(); ++j)
  {
    const std::vector<double> distances = DistancesFrom(mesh, dgg::ExactEngine::Triangle, sites[j]);
    // Cells are about 0.3 in radius.
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      ASSERT_LT(basis[j][v], basis[j][sites[j]] * 1.2);
      if (distances[v] > 1.2)
      {
        ASSERT_LT(std::abs(basis[j][v]), 0.05);
      }
    }
    EXPECT_GT(basis[j][sites[j]], 0.5);
    EXPECT_LT(basis[j][sites[j]], 0.85);
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

TEST(HarmonicSplines, AllVerticesAsSitesSolveAsFiniteElementsDo)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const auto boundary : { dgg::PoissonBoundary::Neumann, dgg::PoissonBoundary::Dirichlet })
    {
      Splines splines(mesh, With(boundary));
      splines.PrepareAll();
      Random random(9);
      std::vector<double> sources(mesh.GetNumberOfVertices());
      for (double& source : sources)
      {
        source = random.Uniform(-1.0, 1.0);
      }
      std::vector<double> solution = sources;
      ASSERT_TRUE(splines.Solver.Solve(solution).IsOk());
      const std::vector<double> coefficients = splines.SolveSites(sources);
      for (std::size_t i = 0; i < coefficients.size(); ++i)
      {
        ASSERT_NEAR(coefficients[i], solution[splines.Functions.GetSites()[i]], 1e-9) << named.Name;
      }
      ExpectSameField(solution, splines.Combine(coefficients, sources), 1e-9, named.Name);
    }
  }
}

TEST(HarmonicSplines, CombinationsAreSumsOfTheBasis)
{
  for (const auto boundary : { dgg::PoissonBoundary::Neumann, dgg::PoissonBoundary::Dirichlet })
  {
    const dgg::SurfaceMesh mesh = Build(SeveralComponents());
    Splines splines(mesh, With(boundary));
    splines.PrepareSome(11);
    const auto basis = splines.Basis();
    std::vector<double> expected(mesh.GetNumberOfVertices(), 0.0);
    std::vector<double> coefficients(basis.size());
    Random random(4);
    for (std::size_t j = 0; j < basis.size(); ++j)
    {
      coefficients[j] = random.Uniform(-1.0, 1.0);
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
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  Splines splines(mesh);
  const auto truth = [&](Id v) { return sphere.Point(v)[0] * sphere.Point(v)[2]; }; // l = 2
  const std::vector<double> sources =
    Integrated(splines.Solver, [&](Id v) { return 6.0 * truth(v); });
  double previous = 0.0;
  for (const Id count : { 24, 96, 384 })
  {
    splines.PrepareSome(count);
    const std::vector<double> solution = splines.Combine(splines.SolveSites(sources));
    const double error = RelativeL2(splines.Solver, solution, truth);
    RecordProperty("error" + std::to_string(count), std::to_string(error));
    if (count > 24)
    {
      EXPECT_GT(std::log2(previous / error), 1.7) << count;
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.02);
}

TEST(HarmonicSplines, GivenValuesOnTheBoundary)
{
  // sin sin vanishes on the boundary, functions of sites do.
  const Id n = 48;
  const TestMesh plane = Scaled(Plane(n, n, 0.2), 1.0 / n);
  const dgg::SurfaceMesh mesh = Build(plane);
  Splines splines(mesh, With(dgg::PoissonBoundary::Dirichlet));
  const auto truth = [&](Id v) {
    return std::sin(dgg::Pi * plane.Point(v)[0]) * std::sin(dgg::Pi * plane.Point(v)[1]);
  };
  const std::vector<double> sources =
    Integrated(splines.Solver, [&](Id v) { return 2.0 * dgg::Pi * dgg::Pi * truth(v); });
  double previous = 0.0;
  for (const Id count : { 12, 48, 192 })
  {
    splines.PrepareSome(count);
    const std::vector<double> solution = splines.Combine(splines.SolveSites(sources));
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (splines.Solver.IsFixed(v))
      {
        ASSERT_EQ(solution[v], 0.0);
        ASSERT_EQ(splines.Functions.GetCells()[v], dgg::NoId);
      }
    }
    const double error = RelativeL2(splines.Solver, solution, truth);
    RecordProperty("error" + std::to_string(count), std::to_string(error));
    if (count > 12)
    {
      EXPECT_GT(std::log2(previous / error), 1.5) << count;
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.02);

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
    ASSERT_NEAR(sum, 1.0, inside > 0.3 ? 0.06 : 1.0) << x << " " << y;
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
  const dgg::Status status = splines.Functions.Solve(nothing, given, coefficients);
  ASSERT_TRUE(status.IsOk()) << status.GetMessage();
  const std::vector<double> values = splines.Combine(coefficients);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_NEAR(coefficients[v], linear(v), 1e-10);
    EXPECT_NEAR(values[v], linear(v), 1e-10);
  }
}

TEST(HarmonicSplines, GivenSitesOfCellsContinueLinearFunctions)
{
  // 81 sites in a lattice, 32 of them on the boundary with given values. The error is that of the
  // coefficients, which borders along edges of the mesh make.
  double previous = 0.0;
  for (const Id n : { 32, 128 })
  {
    const TestMesh plane = Scaled(Plane(n, n, 0.25, 5), 1.0 / n);
    const dgg::SurfaceMesh mesh = Build(plane);
    const auto linear = [&](
                          Id v) { return 1.0 + 2.0 * plane.Point(v)[0] - 3.0 * plane.Point(v)[1]; };
    Splines splines(mesh);
    std::vector<Id> sites;
    std::vector<Id> given;
    std::vector<double> coefficients;
    for (Id k = 0; k < 81; ++k)
    {
      sites.push_back((k / 9) * (n / 8) * (n + 1) + (k % 9) * (n / 8));
      const bool onRim = k % 9 == 0 || k % 9 == 8 || k / 9 == 0 || k / 9 == 8;
      coefficients.push_back(onRim ? linear(sites.back()) : 0.0);
      given.resize(given.size() + (onRim ? 1 : 0), k);
    }
    splines.Prepare(sites);
    const std::vector<double> nothing(mesh.GetNumberOfVertices(), 0.0);
    ASSERT_TRUE(splines.Functions.Solve(nothing, given, coefficients).IsOk());
    double error = 0.0;
    for (Id k = 0; k < 81; ++k)
    {
      error = std::max(error, std::abs(coefficients[k] - linear(sites[k])));
    }
    EXPECT_LT(error, 4.0 / n); // of a range of 5
    previous = n == 32 ? error : previous;
    EXPECT_TRUE(n == 32 || error < 0.5 * previous);
  }
}

TEST(HarmonicSplines, AnyTrianglesWillDo)
{
  // Among triangles that are next to flat, equations may be singular up to rounding: then results
  // are finite, and that is all.
  int sound = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    Random random(seed);
    const dgg::SurfaceMesh mesh =
      Build(RandomSoup(3 + random.Index(30), 1 + random.Index(60), seed));
    for (const auto boundary : { dgg::PoissonBoundary::Neumann, dgg::PoissonBoundary::Dirichlet })
    {
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
        largest = std::max(largest, LaplacianOf(splines.Solver, v)[v]);
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
}

TEST(HarmonicSplines, UnitsDoNotMatter)
{
  const TestMesh bumpy = NoisySphere(2, 0.02, 3);
  std::vector<std::vector<double>> first;
  for (const double factor : { 1.0, 1e-6, 1e6 })
  {
    const dgg::SurfaceMesh mesh = Build(Scaled(bumpy, factor));
    Splines splines(mesh);
    splines.PrepareSome(10);
    const auto basis = splines.Basis();
    first = first.empty() ? basis : first;
    for (std::size_t j = 0; j < basis.size(); ++j)
    {
      ExpectSameField(first[j], basis[j], 1e-9, std::to_string(factor));
    }
  }
}

TEST(HarmonicSplines, ThreadsDoNotMatter)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.02, 3));
  Splines alone(mesh);
  alone.PrepareSome(30);
  Splines together(mesh);
  together.Prepare(alone.Functions.GetSites(), WithThreads(3));
  EXPECT_EQ(alone.Functions.GetCells(), together.Functions.GetCells());
  EXPECT_EQ(alone.Basis(), together.Basis(WithThreads(3)));
  Random random(3);
  const std::vector<dgg::SurfacePoint> points(20, InsideFace(mesh, random));
  std::vector<double> values;
  ASSERT_TRUE(
    together.Functions
      .Evaluate(points, dgg::GreensMethod::SingularitySubtraction, WithThreads(3), nullptr, values)
      .IsOk());
  EXPECT_EQ(alone.Evaluate(points, dgg::GreensMethod::SingularitySubtraction), values);
}

TEST(HarmonicSplines, RefusesWhatMakesNoSense)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  dgg::PoissonSolver solver(mesh);
  dgg::HarmonicSplines splines(solver);
  const auto messageOf = [&](const std::vector<Id>& sites) {
    return splines.Prepare(sites, nullptr, nullptr).GetMessage();
  };
  const auto says = [](const std::string& message, const std::string& part) {
    return message.find(part) != std::string::npos;
  };
  const auto ignore = [](Id, const std::vector<double>&) {};
  EXPECT_TRUE(says(messageOf({ 0 }), "has not been prepared"));
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  EXPECT_TRUE(says(splines.FindBasis(nullptr, nullptr, ignore).GetMessage(), "no sites"));
  EXPECT_TRUE(says(messageOf({}), "there is no site"));
  EXPECT_TRUE(says(messageOf({ 0, -1 }), "site 1 (vertex -1) does not exist"));
  EXPECT_TRUE(says(messageOf({ mesh.GetNumberOfVertices() }), "does not exist"));
  EXPECT_TRUE(says(messageOf({ 5, 7, 5 }), "site 2 (vertex 5) is the same as site 0"));
  EXPECT_TRUE(says(messageOf({ 0 }), "has no site"));
  std::vector<double> values;
  EXPECT_FALSE(splines.Solve({}, {}, values).IsOk());

  std::vector<Id> sites;
  ASSERT_TRUE(dgg::ChooseSplineSites(solver, 6, nullptr, sites).IsOk());
  ASSERT_EQ(messageOf(sites), "");
  std::vector<double> sources(mesh.GetNumberOfVertices(), 0.0);
  EXPECT_TRUE(says(splines.Solve({ 1.0 }, {}, values).GetMessage(), "1 values"));
  EXPECT_FALSE(splines.Solve(sources, { 0 }, values).IsOk()); // no value for it
  values.assign(6, 0.0);
  EXPECT_FALSE(splines.Solve(sources, { 6 }, values).IsOk());
  EXPECT_FALSE(splines.Solve(sources, { -1 }, values).IsOk());
  sources[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(splines.Solve(sources, {}, values).GetMessage(), "vertex 3"));
  EXPECT_FALSE(splines.Combine({ 1.0 }, {}, values).IsOk());
  EXPECT_FALSE(splines.Combine(std::vector<double>(6, 0.0), sources, values).IsOk());
  EXPECT_TRUE(says(splines
                     .Evaluate({ dgg::SurfacePoint::AtVertex(-3) }, dgg::GreensMethod::Interpolated,
                       nullptr, nullptr, values)
                     .GetMessage(),
    "point 0"));
  // Another system.
  ASSERT_TRUE(solver.Prepare(With(dgg::PoissonBoundary::Dirichlet), nullptr).IsOk());
  EXPECT_TRUE(says(splines.FindBasis(nullptr, nullptr, ignore).GetMessage(), "anew"));
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (solver.IsFixed(v))
    {
      EXPECT_TRUE(says(messageOf({ v }), "lies on the boundary"));
      break;
    }
  }

  const dgg::SurfaceMesh isolated = Build(SphereWithIsolatedPoints(1));
  dgg::PoissonSolver other(isolated);
  ASSERT_TRUE(other.Prepare({}, nullptr).IsOk());
  for (Id v = 0; v < isolated.GetNumberOfVertices(); ++v)
  {
    if (isolated.FanBegin(v) == isolated.FanEnd(v))
    {
      EXPECT_TRUE(says(dgg::CheckSplineSites(other, { v }).GetMessage(), "has no face"));
    }
  }
}

TEST(HarmonicSplines, StopsWhenAsked)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.02, 3));
  Splines splines(mesh);
  std::vector<Id> sites;
  const auto ignore = [](Id, const std::vector<double>&) {};
  const std::vector<std::function<dgg::Status(const dgg::ProgressCallback&)>> steps = {
    [&](const dgg::ProgressCallback& progress) {
      return dgg::ChooseSplineSites(splines.Solver, 100, progress, sites);
    },
    [&](const dgg::ProgressCallback& progress) {
      return splines.Functions.Prepare(sites, nullptr, progress);
    },
    [&](const dgg::ProgressCallback& progress) {
      return splines.Functions.FindBasis(nullptr, progress, ignore);
    }
  };
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    int calls = 0;
    double last = 0.0;
    EXPECT_TRUE(steps[k]([&](double done) {
      EXPECT_GE(done, last);
      last = done;
      ++calls;
      return true;
    }).IsOk());
    EXPECT_EQ(last, 1.0) << k;
    for (int stop = 0; stop < calls; stop += 1 + calls / 5)
    {
      int left = stop;
      EXPECT_TRUE(steps[k]([&](double) { return left-- > 0; }).IsAborted()) << k;
    }
    EXPECT_TRUE(steps[k](nullptr).IsOk());
  }
}
}
