// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Solutions of Poisson equations at any point, by Green's functions.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "GraphChecks.h"
#include "SplineTestTools.h"

#include "dggPoissonIntegral.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dggtest
{
namespace
{
constexpr dgg::GreensMethod Smooth = dgg::GreensMethod::SingularitySubtraction;
constexpr dgg::GreensMethod Linear = dgg::GreensMethod::Interpolated;

using Values = std::vector<std::vector<double>>;

Values Solutions(const dgg::PoissonSolver& solver, const std::vector<dgg::SurfacePoint>& points,
  const Values& rightHandSides, dgg::GreensMethod method)
{
  const dgg::PoissonIntegral integral(solver);
  Values solutions;
  const dgg::Status status =
    integral.Run(points, rightHandSides, method, nullptr, nullptr, solutions);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return solutions;
}

std::vector<dgg::SurfacePoint> InsideFaces(const dgg::SurfaceMesh& mesh, int count)
{
  Random random(77);
  std::vector<dgg::SurfacePoint> points;
  for (int k = 0; k < count; ++k)
  {
    points.push_back(InsideFace(mesh, random));
  }
  return points;
}
}

TEST(PoissonIntegral, IsTheSparseSolutionAtVertices)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  for (const auto weights : { dgg::PoissonWeights::Area, dgg::PoissonWeights::Uniform })
  {
    for (const bool delaunay : { false, true })
    {
      dgg::PoissonOptions options = With(dgg::PoissonBoundary::Neumann, delaunay);
      options.Weights = weights;
      const Greens greens(mesh, options);
      Random random(5);
      Values sources(3, std::vector<double>(mesh.GetNumberOfVertices()));
      Values expected;
      for (std::vector<double>& source : sources)
      {
        for (double& value : source)
        {
          value = random.Uniform(-1.0, 1.0);
        }
        expected.push_back(source);
        ASSERT_TRUE(greens.Solver.Solve(expected.back()).IsOk());
      }
      std::vector<dgg::SurfacePoint> points;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); v += 7)
      {
        points.push_back(dgg::SurfacePoint::AtVertex(v));
      }
      const Values found = Solutions(greens.Solver, points, sources, Linear);
      for (std::size_t r = 0; r < sources.size(); ++r)
      {
        for (std::size_t k = 0; k < points.size(); ++k)
        {
          ASSERT_NEAR(found[r][k], expected[r][points[k].Vertex], 1e-9);
        }
      }
    }
  }
}

TEST(PoissonIntegral, IsTheSparseSolutionWithGivenValues)
{
  const dgg::SurfaceMesh mesh = Build(Scaled(Plane(14, 10, 0.25), 0.1));
  const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
  Random random(6);
  std::vector<double> sources(mesh.GetNumberOfVertices());
  for (double& value : sources)
  {
    value = random.Uniform(-1.0, 1.0);
  }
  std::vector<double> expected = sources;
  ASSERT_TRUE(greens.Solver.Solve(expected).IsOk());
  std::vector<dgg::SurfacePoint> points;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    points.push_back(dgg::SurfacePoint::AtVertex(v));
  }
  const Values found = Solutions(greens.Solver, points, { sources }, Linear);
  ExpectSameField(expected, found[0], 1e-9, "vertices");
}

TEST(PoissonIntegral, SphericalHarmonicsConverge)
{
  // -Laplace Y = l (l + 1) Y, with l = 2 and l = 3, at points inside of faces.
  const auto second = [](double x, double, double z) { return x * z; };
  const auto third = [](double, double, double z) { return z * (5.0 * z * z - 3.0); };
  for (const dgg::GreensMethod method : { Smooth, Linear })
  {
    double first[] = { 0.0, 0.0 };
    double errors[] = { 0.0, 0.0 };
    for (const int level : { 3, 4, 5 })
    {
      const TestMesh sphere = Icosphere(level);
      const dgg::SurfaceMesh mesh = Build(sphere);
      const Greens greens(mesh);
      const auto at = [&](const auto& function, Id v) {
        return function(sphere.Point(v)[0], sphere.Point(v)[1], sphere.Point(v)[2]);
      };
      const Values sources = { Integrated(greens.Solver, [&](Id v) { return 6.0 * at(second, v); }),
        Integrated(greens.Solver, [&](Id v) { return 12.0 * at(third, v); }) };
      const std::vector<dgg::SurfacePoint> points = InsideFaces(mesh, 24);
      const Values found = Solutions(greens.Solver, points, sources, method);
      double squares[] = { 0.0, 0.0 };
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        std::array<double, 3> x = PositionOf(sphere, mesh, points[k]);
        const double norm = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        const double truths[] = { second(x[0] / norm, x[1] / norm, x[2] / norm),
          third(x[0] / norm, x[1] / norm, x[2] / norm) };
        for (int r = 0; r < 2; ++r)
        {
          const double difference = found[r][k] - truths[r];
          squares[r] += difference * difference / static_cast<double>(points.size());
        }
      }
      for (int r = 0; r < 2; ++r)
      {
        errors[r] = std::sqrt(squares[r]);
        first[r] = level == 3 ? errors[r] : first[r];
      }
    }
    EXPECT_GT(0.5 * std::log2(first[0] / errors[0]), 1.8);
    EXPECT_GT(0.5 * std::log2(first[1] / errors[1]), 1.8);
    EXPECT_LT(errors[0], 2e-4);
    EXPECT_LT(errors[1], 1.5e-3);
  }
}

TEST(PoissonIntegral, NeumannSquareConverges)
{
  const auto mode = [](const double* p) {
    return std::cos(dgg::Pi * p[0]) * std::cos(dgg::Pi * p[1]);
  };
  for (const dgg::GreensMethod method : { Smooth, Linear })
  {
    double first = 0.0;
    double error = 0.0;
    for (const Id n : { 16, 32, 64 })
    {
      const TestMesh plane = Scaled(Plane(n, n, 0.2), 1.0 / n);
      const dgg::SurfaceMesh mesh = Build(plane);
      const Greens greens(mesh);
      const Values sources = { Integrated(
        greens.Solver, [&](Id v) { return 2.0 * dgg::Pi * dgg::Pi * mode(plane.Point(v)); }) };
      const std::vector<dgg::SurfacePoint> points = InsideFaces(mesh, 24);
      const Values found = Solutions(greens.Solver, points, sources, method);
      double square = 0.0;
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        const double difference = found[0][k] - mode(PositionOf(plane, mesh, points[k]).data());
        square += difference * difference / static_cast<double>(points.size());
      }
      error = std::sqrt(square);
      first = n == 16 ? error : first;
    }
    EXPECT_GT(0.5 * std::log2(first / error), 1.7);
    EXPECT_LT(error, 5e-4);
  }
}

TEST(PoissonIntegral, LinearFunctionsAreContinuedLinearly)
{
  const TestMesh plane = Plane(12, 9, 0.25);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
  const auto linear = [](const double* p) { return 1.0 + 2.0 * p[0] - 3.0 * p[1]; };
  std::vector<double> given(mesh.GetNumberOfVertices(), 0.0);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    given[v] = greens.Solver.IsFixed(v) ? linear(plane.Point(v)) : 0.0;
  }
  std::vector<dgg::SurfacePoint> points = InsideFaces(mesh, 30);
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (mesh.Twin(h) == dgg::NoId)
    {
      points.push_back(dgg::SurfacePoint::OnEdge(mesh, h, 0.4)); // no place for a pole
    }
  }
  for (const dgg::GreensMethod method : { Smooth, Linear })
  {
    const Values found = Solutions(greens.Solver, points, { given }, method);
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      EXPECT_NEAR(found[0][k], linear(PositionOf(plane, mesh, points[k]).data()), 1e-9);
    }
  }
}

TEST(PoissonIntegral, ThreadsDoNotMatter)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.01, 2));
  const Greens greens(mesh);
  const dgg::PoissonIntegral integral(greens.Solver);
  const Values sources = { Integrated(greens.Solver, [](Id v) { return std::sin(0.1 * v); }) };
  const std::vector<dgg::SurfacePoint> points = InsideFaces(mesh, 21);
  Values found;
  ASSERT_TRUE(integral.Run(points, sources, Smooth, WithThreads(3), nullptr, found).IsOk());
  EXPECT_EQ(Solutions(greens.Solver, points, sources, Smooth), found);
}

TEST(PoissonIntegral, RefusesWhatMakesNoSenseAndStopsWhenAsked)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(2));
  dgg::PoissonSolver solver(mesh);
  const dgg::PoissonIntegral integral(solver);
  std::vector<double> sources(mesh.GetNumberOfVertices(), 1.0);
  Values found(5);
  EXPECT_FALSE(
    integral.Run({ dgg::SurfacePoint::AtVertex(0) }, {}, Smooth, nullptr, nullptr, found).IsOk());
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  const std::vector<dgg::SurfacePoint> points = InsideFaces(mesh, 3);
  const auto messageOf = [&](const std::vector<dgg::SurfacePoint>& any) {
    const dgg::Status status = integral.Run(any, { sources }, Smooth, nullptr, nullptr, found);
    EXPECT_TRUE(status.IsOk() || found.empty());
    return status.GetMessage();
  };
  EXPECT_EQ(messageOf(points), "");
  EXPECT_EQ(messageOf({}), "");
  EXPECT_NE(
    messageOf({ points[0], dgg::SurfacePoint::AtVertex(1000) }).find("point 1"), std::string::npos);
  sources[4] = std::numeric_limits<double>::infinity();
  EXPECT_NE(messageOf(points).find("vertex 4"), std::string::npos);
  sources.pop_back();
  EXPECT_NE(messageOf(points).find("right-hand side 0"), std::string::npos);
  // A closed surface with given values.
  ASSERT_TRUE(solver.Prepare(With(dgg::PoissonBoundary::Dirichlet), nullptr).IsOk());
  sources.assign(mesh.GetNumberOfVertices(), 1.0);
  EXPECT_NE(messageOf(points).find("without a boundary"), std::string::npos);

  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  int calls = 0;
  double last = 0.0;
  const auto count = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
    ++calls;
    return true;
  };
  ASSERT_TRUE(integral.Run(points, { sources }, Smooth, nullptr, count, found).IsOk());
  EXPECT_EQ(last, 1.0);
  for (int stop = 0; stop < calls; ++stop)
  {
    int left = stop;
    EXPECT_TRUE(integral
                  .Run(
                    points, { sources }, Smooth, nullptr, [&](double) { return left-- > 0; }, found)
                  .IsAborted());
    EXPECT_TRUE(found.empty());
  }
}
}
