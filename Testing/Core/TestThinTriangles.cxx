// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// Poisson equations on thin triangles: correct results, or an error.
#include "GeodesicChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggEarthMovers.h"
#include "dggHarmonicSplines.h"
#include "dggPoissonSystem.h"
#include "dggSpectralDistance.h"
#include "dggSplineSites.h"
#include "dggThinTriangles.h"

namespace dggtest
{
namespace
{
/// Returns the unit square compressed to a strip of the given height.
TestMesh Strip(Id n, double height)
{
  TestMesh mesh = Plane(n, n);
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] /= n;
    mesh.Points[i + 1] *= height / n;
  }
  return mesh;
}

/// Returns the mesh with a point next to the midpoint of an edge of every 20th face.
TestMesh WithSlivers(const TestMesh& mesh, double height)
{
  TestMesh result;
  result.Points = mesh.Points;
  for (std::size_t f = 0; f < mesh.Triangles.size() / 3; ++f)
  {
    const Id a = mesh.Triangles[3 * f];
    const Id b = mesh.Triangles[3 * f + 1];
    const Id c = mesh.Triangles[3 * f + 2];
    if (f % 20 != 0)
    {
      result.Triangles.insert(result.Triangles.end(), { a, b, c });
      continue;
    }
    const auto p = static_cast<Id>(result.Points.size() / 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double middle = 0.5 * (mesh.Points[3 * a + axis] + mesh.Points[3 * b + axis]);
      result.Points.push_back((1.0 - height) * middle + height * mesh.Points[3 * c + axis]);
    }
    result.Triangles.insert(result.Triangles.end(), { a, b, p, b, c, p, c, a, p });
  }
  return result;
}

double Measure(const dgg::SurfaceMesh& mesh)
{
  dgg::PoissonSystem system(mesh);
  EXPECT_TRUE(system.Analyze({}, nullptr).IsOk());
  EXPECT_TRUE(system.Factorize().IsOk());
  return dgg::MeasureThinTriangles(system).front();
}

/// Returns both meshes as one, not connected.
TestMesh Beside(TestMesh first, const TestMesh& second)
{
  Append(first, second);
  return first;
}

/// A compressed square beside a well-shaped one: all results on the well-shaped square are correct,
/// and no wrong results are returned on the other.
struct TwoSquares
{
  dgg::SurfaceMesh Mesh = Build(Beside(Strip(12, 1.0), Strip(12, 1e-8)));
  Id FirstBad = Mesh.GetNumberOfVertices() / 2;
  dgg::PoissonSolver Solver{ Mesh };
};

void ExpectThin(const dgg::Status& status, const std::string& where)
{
  ASSERT_FALSE(status.IsOk());
  EXPECT_TRUE(Says(status, where));
  EXPECT_TRUE(Says(status, "too thin"));
}
}

/// -u'' = cos(pi x) with zero flux at the ends has the solution u = cos(pi x) / pi^2 for any height
/// of the strip.
TEST(ThinTriangles, StripsAreSolvedOnOrRefused)
{
  int solved = 0;
  for (int digits = 0; digits <= 14; ++digits)
  {
    SCOPED_TRACE(digits);
    const TestMesh strip = Strip(16, std::pow(10.0, -digits));
    const dgg::SurfaceMesh mesh = Build(strip);
    for (const bool delaunay : { false, true })
    {
      dgg::PoissonOptions options;
      options.IntrinsicDelaunay = delaunay;
      if (IsTooThin(mesh, options))
      {
        EXPECT_GT(digits, 5);
        continue;
      }
      ++solved;
      dgg::PoissonSolver solver(mesh);
      ASSERT_TRUE(solver.Prepare(options, nullptr).IsOk());
      std::vector<double> values(static_cast<std::size_t>(mesh.GetNumberOfVertices()));
      for (std::size_t v = 0; v < values.size(); ++v)
      {
        values[v] = solver.GetAreas()[v] * std::cos(dgg::Pi * strip.Points[3 * v]);
      }
      ASSERT_TRUE(solver.Solve(values).IsOk());
      for (std::size_t v = 0; v < values.size(); ++v)
      {
        EXPECT_NEAR(values[v] * dgg::Pi * dgg::Pi, std::cos(dgg::Pi * strip.Points[3 * v]), 0.03);
      }
    }
  }
  EXPECT_GE(solved, 12);
  EXPECT_LT(solved, 20);
}

TEST(ThinTriangles, FewOfThemDoNoHarm)
{
  EXPECT_LT(Measure(Build(Icosphere(3))), 1e-12);
  for (int digits = 1; digits <= 14; ++digits)
  {
    SCOPED_TRACE(digits);
    EXPECT_LT(Measure(Build(WithSlivers(Icosphere(3), std::pow(10.0, -digits)))), 1e-3);
  }
}

TEST(ThinTriangles, PointsOnALineAreRefused)
{
  const TestMesh line = Strip(6, 0.0);
  EXPECT_TRUE(IsTooThin(Build(line)));
  // The line is accepted beside a surface, relative to which its area is negligible.
  EXPECT_FALSE(IsTooThin(Build(Beside(Icosphere(2), line))));
}

TEST(ThinTriangles, PartsOfASurfaceAreRefused)
{
  TwoSquares squares;
  const Id n = squares.FirstBad;
  dgg::PoissonSolver& solver = squares.Solver;
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  const Id good = n / 2;
  const Id bad = n + n / 2;
  EXPECT_TRUE(solver.CheckPole(dgg::SurfacePoint::AtVertex(good)).IsOk());
  ExpectThin(solver.CheckPole(dgg::SurfacePoint::AtVertex(bad)), std::to_string(bad));
  const Id face = squares.Mesh.GetNumberOfFaces() - 1;
  ExpectThin(solver.CheckPole(dgg::SurfacePoint::InFace(squares.Mesh, face, { 0.3, 0.3, 0.4 })),
    "face " + std::to_string(face));
  // Sources of uniform density, which is negligible on the thin square; then point sources.
  std::vector<double> sources = solver.GetAreas();
  EXPECT_TRUE(solver.Solve(sources).IsOk());
  sources.assign(sources.size(), 0.0);
  sources[good] = 1.0;
  sources[bad] = 1e-4;
  EXPECT_TRUE(solver.CheckValues(sources).IsOk());
  sources[bad] = 1.0;
  ExpectThin(solver.Solve(sources), "source at vertex " + std::to_string(bad));
  // With Dirichlet conditions, sources on the thin square are refused as well.
  dgg::PoissonOptions held;
  held.Boundary = dgg::PoissonBoundary::Dirichlet;
  ASSERT_TRUE(solver.Prepare(held, nullptr).IsOk());
  ExpectThin(solver.CheckPole(dgg::SurfacePoint::AtVertex(bad)), std::to_string(bad));
  ExpectThin(solver.Solve(sources), "source at vertex " + std::to_string(bad));
  // With a prescribed value in its interior, the thin square is accepted.
  held.Boundary = dgg::PoissonBoundary::Neumann;
  held.DirichletVertices = { bad };
  ASSERT_TRUE(solver.Prepare(held, nullptr).IsOk());
  EXPECT_TRUE(solver.CheckValues(sources).IsOk());
}

TEST(ThinTriangles, WhatSolvesRefusesSourcesInThinParts)
{
  TwoSquares squares;
  const Id n = squares.FirstBad;
  dgg::PoissonSolver& solver = squares.Solver;
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  std::vector<double> from(2 * n, 0.0);
  std::vector<double> to(from);
  dgg::EarthMoversResult moved;
  from[3] = to[n - 3] = 1.0;
  EXPECT_TRUE(dgg::EarthMovers(solver).Run(from, to, {}, moved).IsOk());
  from[n + 3] = to[n + 3] = 1.0; // this mass does not move
  EXPECT_TRUE(dgg::EarthMovers(solver).Run(from, to, {}, moved).IsOk());
  to[n + 3] = 0.0;
  to[2 * n - 3] = 1.0;
  ExpectThin(
    dgg::EarthMovers(solver).Run(from, to, {}, moved), "mass at vertex " + std::to_string(n + 3));

  dgg::SpectralDistance distance(solver);
  const dgg::SurfacePoint good = dgg::SurfacePoint::AtVertex(3);
  const dgg::SurfacePoint bad = dgg::SurfacePoint::AtVertex(n + 3);
  EXPECT_TRUE(distance.CheckSource(good).IsOk());
  ExpectThin(distance.CheckSource(bad), "vertex " + std::to_string(n + 3));
  dgg::SpectralOptions options;
  options.Method = dgg::SpectralMethod::Exact;
  ASSERT_TRUE(distance.Prepare(options, nullptr, nullptr).IsOk());
  std::vector<double> between;
  ASSERT_TRUE(
    distance.Between({ good }, { good, bad }, dgg::ParallelFor(), nullptr, between).IsOk());
  EXPECT_EQ(between, (std::vector<double>{ 0.0, dgg::Infinity }));
  ExpectThin(distance.Between({ bad }, { good }, dgg::ParallelFor(), nullptr, between), "Point 0");
}

TEST(ThinTriangles, SplinesHaveOneSiteInThinParts)
{
  TwoSquares squares;
  const Id n = squares.FirstBad;
  dgg::PoissonSolver& solver = squares.Solver;
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  // One site is allowed in any component.
  EXPECT_TRUE(dgg::CheckSplineSites(solver, { 3, 20, n + 3 }).IsOk());
  ExpectThin(dgg::CheckSplineSites(solver, { 3, n + 20, n + 3 }), "Site 2");
  std::vector<Id> sites;
  ASSERT_TRUE(dgg::ChooseSplineSites(solver, 10, nullptr, sites).IsOk());
  EXPECT_EQ(sites.size(), 10u);
  EXPECT_EQ(std::count_if(sites.begin(), sites.end(), [&](Id v) { return v >= n; }), 1);

  dgg::HarmonicSplines splines(solver);
  ASSERT_TRUE(splines.Prepare({ 3, 20, n + 3 }, dgg::ParallelFor(), nullptr).IsOk());
  std::vector<double> values;
  ASSERT_TRUE(splines
                .Evaluate({ dgg::SurfacePoint::AtVertex(n + 5), dgg::SurfacePoint::AtVertex(5) },
                  dgg::GreensMethod::Vertex, dgg::ParallelFor(), nullptr, values)
                .IsOk());
  EXPECT_EQ((std::vector<double>(values.begin(), values.begin() + 3)),
    (std::vector<double>{ 0.0, 0.0, 1.0 }));
  EXPECT_NEAR(values[3] + values[4], 1.0, 1e-12);
  EXPECT_EQ(values[5], 0.0);
}

/// All vertices of a small component may have values of the same sign.
TEST(ThinTriangles, SmallPartsAreKnown)
{
  TestMesh mesh = Icosphere(2);
  const auto n = static_cast<Id>(mesh.Points.size() / 3);
  for (int k = 0; k < 40; ++k)
  {
    const double y = 3.0 + k;
    TestMesh sliver;
    sliver.Points = { 0.0, y, 0.0, 0.3, y, 0.0, 0.1, y + 1e-7, 0.0 };
    sliver.Triangles = { 0, 1, 2 };
    mesh = Beside(mesh, sliver);
  }
  const dgg::SurfaceMesh surface = Build(mesh);
  dgg::PoissonSolver solver(surface);
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  EXPECT_TRUE(solver.CheckPole(dgg::SurfacePoint::AtVertex(0)).IsOk());
  for (Id v = n; v < n + 120; v += 3)
  {
    ExpectThin(solver.CheckPole(dgg::SurfacePoint::AtVertex(v)), std::to_string(v));
  }
}

TEST(ThinTriangles, ScaleDoesNotMatter)
{
  for (const double scale : { 1e-68, 1e-54, 1.0, 1e54, 1e68 })
  {
    SCOPED_TRACE(scale);
    EXPECT_LT(Measure(Build(Scaled(WithSlivers(Plane(8, 8), 1e-9), scale))), 1e-3);
    EXPECT_TRUE(IsTooThin(Build(Scaled(Strip(8, 1e-9), scale))));
  }
}

// Distributions of equal mass for the earth mover's distance.

namespace
{
double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}
}

TEST(MassBalance, BothSumToOne)
{
  const dgg::SurfaceMesh mesh = Build(Plane(3, 2, 0.0));
  for (const double size : { 1.0, 1e-200, 1e300 })
  {
    std::vector<double> from(mesh.GetNumberOfVertices(), 0.0);
    from[2] = 3.0 * size;
    from[5] = size;
    std::vector<double> to(mesh.GetNumberOfVertices(), 7.0 / size);
    double total = 0.0;
    ASSERT_TRUE(dgg::BalanceMasses(mesh, true, from, to, total).IsOk());
    EXPECT_EQ(total, 1.0);
    EXPECT_NEAR(Sum(from), 1.0, 1e-14);
    EXPECT_NEAR(Sum(to), 1.0, 1e-14);
    EXPECT_NEAR(from[2], 0.75, 1e-14);
  }
  std::vector<double> from(mesh.GetNumberOfVertices(), 2.0);
  std::vector<double> to(from);
  to[0] += 1e-7;
  double total = 0.0;
  ASSERT_TRUE(dgg::BalanceMasses(mesh, false, from, to, total).IsOk());
  EXPECT_NEAR(total, 2.0 * mesh.GetNumberOfVertices(), 1e-6);
  EXPECT_NEAR(Sum(from), Sum(to), 1e-15);
}

TEST(MassBalance, SmallDifferencesOfPartsAreTakenOff)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  ASSERT_GT(count, 1);
  // A component may be nearly empty in one of the distributions.
  for (const double first : { 1.0, 0.0 })
  {
    std::vector<double> from(components.size(), 1.0);
    std::vector<double> to(components.size(), 1.0);
    for (std::size_t v = 0; v < components.size(); ++v)
    {
      from[v] = components[v] == 0 ? first : 1.0;
      to[v] = components[v] == 0 ? first + 1e-8 : 1.0;
    }
    double total = 0.0;
    ASSERT_TRUE(dgg::BalanceMasses(mesh, true, from, to, total).IsOk());
    double difference = 0.0;
    for (std::size_t v = 0; v < components.size(); ++v)
    {
      difference += components[v] == 0 ? from[v] - to[v] : 0.0;
    }
    EXPECT_NEAR(difference, 0.0, 1e-15);
    std::swap(from, to);
    EXPECT_TRUE(dgg::BalanceMasses(mesh, true, from, to, total).IsOk());
  }
}

}
