// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// What is asked of Green's functions: points, integrals, signs, many poles, any triangles; errors.
#include "GeodesicChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggPoissonSystem.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
TEST(GreensFunction, AnyPointSeesAnyOther)
{
  // Both arguments anywhere: the truth, and symmetry.
  const TestMesh sphere = Icosphere(5);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  Random random(9);
  std::vector<dgg::SurfacePoint> points;
  for (int k = 0; k < 8; ++k)
  {
    points.push_back(InsideFace(mesh, random));
  }
  // Two in the same face, and one on an edge of it.
  points.push_back(dgg::SurfacePoint::InFace(mesh, 5, { { 0.6, 0.2, 0.2 } }));
  points.push_back(dgg::SurfacePoint::InFace(mesh, 5, { { 0.2, 0.2, 0.6 } }));
  points.push_back(dgg::SurfacePoint::OnEdge(mesh, 15, 0.3));
  points.push_back(dgg::SurfacePoint::AtVertex(40));
  dgg::GreensQuery query;
  query.Targets = points;
  std::vector<dgg::GreensResult> results;
  ASSERT_TRUE(greens.Function.Run(points, query, results).IsOk());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const std::array<double, 3> x = dgg::PositionOf(mesh, points[i], sphere.Points.data());
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      if (i == j)
      {
        EXPECT_TRUE(std::isfinite(results[i].TargetValues[j]));
        EXPECT_GT(results[i].TargetValues[j], 0.5);
        continue;
      }
      const std::array<double, 3> y = dgg::PositionOf(mesh, points[j], sphere.Points.data());
      double chord = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        chord += (x[k] - y[k]) * (x[k] - y[k]);
      }
      // In terms of the chord, as the points are a little inside of the sphere.
      EXPECT_NEAR(results[i].TargetValues[j], SphereGreens(1.0 - 0.5 * chord), 2e-3)
        << i << " " << j;
      EXPECT_NEAR(results[i].TargetValues[j], results[j].TargetValues[i], 3e-4) << i << " " << j;
    }
  }
  // One at a time it is the same.
  for (const std::size_t i : { std::size_t(0), std::size_t(9) })
  {
    const dgg::GreensResult one = greens.Run(points[i], query);
    ExpectSameField(one.Values, results[i].Values, 1e-12, "block");
    ExpectSameField(one.TargetValues, results[i].TargetValues, 1e-12, "block");
  }
}

TEST(GreensFunction, SolvesPoissonEquations)
{
  // u = mean(u) + sum of integrals of g against f, at vertices with the sparse solve and anywhere
  // with the truth.
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  const Id n = mesh.GetNumberOfVertices();
  const auto harmonic = [](const double* p) { return p[0] * p[1] - 0.5 * p[1] * p[2]; }; // l = 2
  std::vector<double> density(n);
  std::vector<double> u(n);
  for (Id v = 0; v < n; ++v)
  {
    density[v] = 6.0 * harmonic(sphere.Point(v));
    u[v] = density[v] * greens.Solver.GetAreas()[v];
  }
  ASSERT_TRUE(greens.Solver.Solve(u).IsOk());
  dgg::GreensQuery query;
  query.WantIntegrals = true;
  const auto at = [&](const dgg::SurfacePoint& pole, dgg::GreensMethod method) {
    query.Method = method;
    const dgg::GreensResult result = greens.Run(pole, query);
    double sum = 0.0;
    double total = 0.0;
    for (Id v = 0; v < n; ++v)
    {
      sum += result.Integrals[v] * density[v];
      total += result.Integrals[v];
    }
    EXPECT_NEAR(total, 0.0, 1e-12);
    return sum;
  };
  for (const Id v : SomeVertices(mesh, 6, 4))
  {
    EXPECT_NEAR(at(dgg::SurfacePoint::AtVertex(v), dgg::GreensMethod::Vertex), u[v], 1e-9);
    EXPECT_NEAR(
      at(dgg::SurfacePoint::AtVertex(v), dgg::GreensMethod::SingularitySubtraction), u[v], 2e-3);
  }
  Random random(8);
  for (int k = 0; k < 6; ++k)
  {
    const dgg::SurfacePoint pole = InsideFace(mesh, random);
    std::array<double, 3> x = dgg::PositionOf(mesh, pole, sphere.Points.data());
    EXPECT_NEAR(at(pole, dgg::GreensMethod::SingularitySubtraction), harmonic(x.data()), 4e-3);
  }
}

TEST(GreensFunction, SolvesPoissonEquationsWithGivenValues)
{
  // u_j = sum of g b inside - sum of given values times the flux of g there.
  const dgg::SurfaceMesh mesh = Build(Plane(14, 11, 0.25));
  const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
  const Id n = mesh.GetNumberOfVertices();
  const std::vector<double> values = RandomValues(n, 6);
  std::vector<double> u = values;
  ASSERT_TRUE(greens.Solver.Solve(u).IsOk());
  for (Id j = 0; j < n; ++j)
  {
    if (greens.Solver.IsFixed(j))
    {
      continue;
    }
    const auto g = greens.Run(dgg::SurfacePoint::AtVertex(j), dgg::GreensMethod::Vertex).Values;
    const std::vector<double> flux = greens.Solver.GetSystem().Multiply(g);
    double sum = 0.0;
    for (Id v = 0; v < n; ++v)
    {
      sum += greens.Solver.IsFixed(v) ? -values[v] * flux[v] : values[v] * g[v];
    }
    EXPECT_NEAR(sum, u[j], 1e-10) << j;
  }
}

TEST(GreensFunction, ValueAtThePoleAndSigns)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(3));
  const Greens greens(mesh);
  dgg::GreensQuery query;
  query.Targets = { dgg::SurfacePoint::AtVertex(3) };
  const dgg::GreensResult average = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  EXPECT_TRUE(std::isfinite(average.Values[3]));
  EXPECT_EQ(average.TargetValues[0], average.Values[3]);
  // The mean over a disk of a logarithm is that half a unit inside.
  const double radius = std::sqrt(2.0 * greens.Solver.GetAreas()[3] / mesh.TotalAngle(3));
  EXPECT_NEAR(average.Values[3], SphereGreens(std::cos(radius)) + 0.5 / mesh.TotalAngle(3), 0.01);
  query.Sign = dgg::GreensSign::Negative;
  const dgg::GreensResult negative = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  for (std::size_t v = 0; v < negative.Values.size(); ++v)
  {
    EXPECT_EQ(negative.Values[v], -average.Values[v]);
  }
  query.Pole = dgg::GreensPole::Infinite;
  const dgg::GreensResult infinite = greens.Run(dgg::SurfacePoint::AtVertex(3), query);
  EXPECT_EQ(infinite.Values[3], -dgg::Infinity);
  EXPECT_EQ(infinite.TargetValues[0], -dgg::Infinity);
  EXPECT_EQ(infinite.Values[4], negative.Values[4]);
}

TEST(GreensFunction, AnyTriangles)
{
  int thin = 0;
  for (const NamedMesh& named : DefectMeshesAndSoups(40))
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const bool delaunay : { false, true })
    {
      const dgg::PoissonOptions options = With(dgg::PoissonBoundary::Neumann, delaunay);
      if (IsThinSoup(mesh, named.Name, options))
      {
        ++thin;
        continue;
      }
      const Greens greens(mesh, options);
      const std::vector<double>& areas = greens.Solver.GetAreas();
      if (!(*std::max_element(areas.begin(), areas.end()) > 0.0))
      {
        continue; // there are no points inside of faces
      }
      for (const dgg::SurfacePoint& pole : RandomSurfacePoints(mesh, 3, 2))
      {
        if (!greens.Solver.CheckPole(pole).IsOk())
        {
          continue;
        }
        for (const dgg::GreensMethod method : Methods)
        {
          dgg::GreensQuery query;
          query.Method = method;
          query.Targets = RandomSurfacePoints(mesh, 4, 9);
          query.Targets.push_back(pole);
          query.WantIntegrals = true;
          query.Radius =
            method == dgg::GreensMethod::SingularitySubtraction && delaunay ? 0.0 : 3.0;
          const dgg::GreensResult result = greens.Run(pole, query);
          double largest = 1.0;
          for (const double value : result.Values)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
            largest = std::max(largest, std::abs(value));
          }
          for (const double value : result.TargetValues)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
          }
          double sum = 0.0;
          double size = 0.0;
          for (const double value : result.Integrals)
          {
            ASSERT_TRUE(std::isfinite(value)) << named.Name;
            sum += value;
            size += std::abs(value);
          }
          EXPECT_NEAR(sum, 0.0, 1e-6 * size + 1e-9) << named.Name;
        }
      }
    }
  }
  EXPECT_LT(thin, 10);
}

}
