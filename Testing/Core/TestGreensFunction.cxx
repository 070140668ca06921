// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Green's functions: identities, closed forms on spheres, tori, squares, disks and cones.
#include "GeodesicChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggGreensInterpolation.h"
#include "dggPoissonSystem.h"

#include <complex>

namespace dggtest
{
TEST(GreensFunction, DiscreteIdentities)
{
  // L g and L M^-1 L q equal the unit load minus the balancing load; both functions are symmetric,
  // with mean 0.
  std::vector<dgg::PoissonOptions> all(3);
  all[1].Weights = dgg::PoissonWeights::Uniform;
  all[2].Boundary = dgg::PoissonBoundary::Dirichlet;
  for (const NamedMesh& named : SoundMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const Id n = mesh.GetNumberOfVertices();
    for (const dgg::PoissonOptions& options : all)
    {
      const Greens greens(mesh, options);
      const dgg::PoissonSystem& system = greens.Solver.GetSystem();
      std::vector<Id> poles = SomeVertices(mesh, 6, 3);
      poles.erase(
        std::remove_if(poles.begin(), poles.end(),
          [&](Id v) { return !greens.Solver.CheckPole(dgg::SurfacePoint::AtVertex(v)).IsOk(); }),
        poles.end());
      for (const auto order : { dgg::GreensOrder::Laplace, dgg::GreensOrder::BiLaplace })
      {
        const bool isTwofold = order == dgg::GreensOrder::BiLaplace;
        if (isTwofold && options.Weights == dgg::PoissonWeights::Uniform)
        {
          continue;
        }
        std::vector<std::vector<double>> columns;
        for (const Id pole : poles)
        {
          dgg::GreensQuery query;
          query.Order = order;
          query.Method = dgg::GreensMethod::Vertex;
          const auto g = greens.Run(dgg::SurfacePoint::AtVertex(pole), query).Values;
          std::vector<double> product = system.Multiply(g);
          double mean = 0.0;
          for (Id v = 0; v < n; ++v)
          {
            mean += system.GetWeight(v) * g[v];
            product[v] *= !isTwofold                            ? 1.0
              : system.IsFixed(v) || !(system.GetArea(v) > 0.0) ? 0.0
                                                                : 1.0 / system.GetArea(v);
          }
          product = isTwofold ? system.Multiply(product) : product;
          const bool isFree = system.IsFree(system.GetComponent(pole));
          EXPECT_TRUE(!isFree || std::abs(mean) < 1e-12 * std::max(1.0, g[pole]));
          for (Id v = 0; v < n; ++v)
          {
            const bool isHere = system.GetComponent(v) == system.GetComponent(pole);
            const double flow = isFree && isHere ? system.GetWeight(v) : 0.0;
            ASSERT_TRUE((isHere && !system.IsFixed(v)) || g[v] == 0.0);
            ASSERT_TRUE(system.IsFixed(v) ||
              std::abs(product[v] - (v == pole ? 1.0 : 0.0) + flow) < (isTwofold ? 1e-7 : 1e-9));
          }
          columns.push_back(g);
        }
        for (std::size_t a = 0; a < poles.size(); ++a)
        {
          for (std::size_t b = 0; b < a; ++b)
          {
            EXPECT_NEAR(columns[a][poles[b]], columns[b][poles[a]],
              1e-10 * std::max(1.0, columns[a][poles[a]]));
          }
        }
      }
    }
  }
}

TEST(GreensFunction, SphereConverges)
{
  // Relative L2 errors within 0.2 of the pole and over all vertices, averaged over random points in
  // faces.
  std::vector<SphereErrors> means;
  for (const int level : { 3, 4, 5, 6 })
  {
    const TestMesh sphere = Icosphere(level);
    const dgg::SurfaceMesh mesh = Build(sphere);
    const Greens greens(mesh);
    const int poles = 10;
    SphereErrors mean{ 0.0, 0.0 };
    Random random(7);
    for (int k = 0; k < poles; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      const dgg::GreensResult result = greens.Run(pole);
      EXPECT_EQ(result.Method, dgg::GreensMethod::SingularitySubtraction);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      EXPECT_GT(result.Radius, 0.85);
      const SphereErrors errors = CompareOnSphere(sphere, greens, pole, result.Values, 0.2);
      mean.Near += errors.Near / poles;
      mean.All += errors.All / poles;
    }
    RecordProperty("level" + std::to_string(level), std::to_string(mean.Near));
    means.push_back(mean);
  }
  EXPECT_LT(means[2].Near, 1e-4);
  EXPECT_GT(std::log2(means[0].Near / means[3].Near) / 3.0, 1.8);
  EXPECT_GT(std::log2(means[0].All / means[3].All) / 3.0, 1.9);
}

TEST(GreensFunction, RadiiBeyondTheSurface)
{
  const TestMesh sphere = Icosphere(3);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  const dgg::SurfacePoint pole = dgg::SurfacePoint::AtVertex(0);
  for (const double radius : { 10.0, 1e150, 1e300 })
  {
    dgg::GreensQuery query;
    query.Radius = radius;
    const dgg::GreensResult result = greens.Run(pole, query);
    EXPECT_LT(CompareOnSphere(sphere, greens, pole, result.Values, 4.0).Near, 0.05) << radius;
    EXPECT_LT(result.Radius, 1e7);
  }
}

TEST(GreensFunction, SquareWithNothingFlowingOut)
{
  // Second order with poles inside, at a corner and on the rim; first order with poles within an
  // edge of the rim.
  for (const bool delaunay : { false, true })
  {
    Convergence errors[2] = { Convergence(1.7), Convergence(0.7) };
    for (const Id n : { 20, 40, 80 })
    {
      const TestMesh square = Scaled(Plane(n, n, 0.2), 1.0 / n);
      const dgg::SurfaceMesh mesh = Build(square);
      const Greens greens(mesh, With(dgg::PoissonBoundary::Neumann, delaunay));
      std::vector<dgg::SurfacePoint> poles[2];
      Random random(3);
      while (poles[0].size() < 6)
      {
        const dgg::SurfacePoint pole = InsideFace(mesh, random);
        const std::array<double, 3> x = dgg::PositionOf(mesh, pole, square.Points.data());
        if (std::abs(x[0] - 0.5) < 0.3 && std::abs(x[1] - 0.5) < 0.3)
        {
          poles[0].push_back(pole);
        }
      }
      poles[0].push_back(dgg::SurfacePoint::AtVertex(0));
      poles[0].push_back(dgg::SurfacePoint::AtVertex(n / 2));
      poles[0].push_back(dgg::SurfacePoint::OnEdge(mesh, 3 * (n * n + n / 2) + 1, 0.4));
      poles[1].push_back(dgg::SurfacePoint::OnEdge(mesh, 0, 0.3));
      poles[1].push_back(dgg::SurfacePoint::InFace(mesh, n, { { 0.4, 0.3, 0.3 } }));
      for (int kind = 0; kind < 2; ++kind)
      {
        Comparison all;
        Comparison plain;
        for (const dgg::SurfacePoint& pole : poles[kind])
        {
          const std::array<double, 3> x = dgg::PositionOf(mesh, pole, square.Points.data());
          dgg::GreensQuery query;
          query.Radius = 0.28; // equal on all meshes
          const dgg::GreensResult result = greens.Run(pole, query);
          EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
          const auto interpolated = greens.Run(pole, dgg::GreensMethod::Interpolated).Values;
          for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
          {
            const double area = greens.Solver.GetAreas()[v];
            const double expected = SquareGreens(x, square.Point(v));
            all.Add(area, result.Values[v], expected);
            plain.Add(area, interpolated[v], expected);
          }
        }
        errors[kind].Add(all.Relative());
        EXPECT_LT(all.Relative(), (kind == 0 ? 0.15 : 1.5) * plain.Relative());
      }
    }
    EXPECT_LT(errors[0].Last, 2e-4);
  }
}

TEST(GreensFunction, DiskWithZeroOnItsRim)
{
  Convergence errors(1.6);
  for (const Id n : { 12, 24, 48 })
  {
    std::vector<ConePoint> points;
    const dgg::SurfaceMesh mesh = Build(Cone(2.0 * dgg::Pi, 3 * n, n, points, 0.2));
    const auto placeOf = [&](Id v) { return std::polar(points[v].Radius, points[v].Angle); };
    const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
    Random random(5);
    Comparison all;
    for (int k = 0; k < 8; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      std::complex<double> x = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        x += pole.Barycentric[c] * placeOf(mesh.Origin(3 * pole.Face + c));
      }
      if (std::abs(x) > 0.8)
      {
        continue;
      }
      dgg::GreensQuery query;
      query.Radius = 0.5; // equal on all meshes
      const dgg::GreensResult result = greens.Run(pole, query);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        if (greens.Solver.IsFixed(v))
        {
          EXPECT_NEAR(result.Values[v], 0.0, 1e-12);
          continue;
        }
        all.Add(greens.Solver.GetAreas()[v], result.Values[v], DiskGreens(x, placeOf(v)));
      }
    }
    ASSERT_GT(all.Size, 0.0);
    errors.Add(all.Relative());
  }
  EXPECT_LT(errors.Last, 3e-3);
}

TEST(GreensFunction, ConesByTheirTotalAngle)
{
  // The pole is the apex, and values on the rim are 0: -log(r) / Theta, for a sharp apex and for a
  // saddle.
  for (const double total : { 2.0, 4.5, 2.0 * dgg::Pi, 9.0 })
  {
    std::vector<ConePoint> points;
    const dgg::SurfaceMesh mesh = Build(Cone(total, 24, 24, points));
    const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
    const dgg::GreensResult result = greens.Run(dgg::SurfacePoint::AtVertex(0));
    EXPECT_EQ(result.Remark, dgg::GreensRemark::None) << total;
    for (Id v = 1; v < mesh.GetNumberOfVertices(); ++v)
    {
      EXPECT_NEAR(result.Values[v], -std::log(points[v].Radius) / total, 3e-3) << total << " " << v;
    }
    // The method Vertex has large errors next to the pole.
    const auto plain = greens.Run(dgg::SurfacePoint::AtVertex(0), dgg::GreensMethod::Vertex).Values;
    EXPECT_GT(std::abs(plain[1] + std::log(points[1].Radius) / total), 5e-3) << total;
  }
}

// Green's functions of many points from Green's functions of vertices.

TEST(GreensInterpolation, IsCloseToASolvePerPoint)
{
  Convergence errors(1.5);
  for (const int level : { 3, 4, 5 })
  {
    const TestMesh sphere = Icosphere(level);
    const dgg::SurfaceMesh mesh = Build(sphere);
    const Greens greens(mesh);
    dgg::GreensInterpolation interpolation(greens.Solver);
    double error = 0.0;
    double plain = 0.0;
    Random random(21);
    const int poles = 8;
    for (int k = 0; k < poles; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      dgg::GreensResult result;
      dgg::GreensQuery query;
      query.Targets = { dgg::SurfacePoint::AtVertex(4) };
      ASSERT_TRUE(interpolation.Run(pole, query, result).IsOk());
      EXPECT_EQ(result.TargetValues[0], result.Values[4]);
      const auto simple = greens.Run(pole, dgg::GreensMethod::Interpolated).Values;
      error += CompareOnSphere(sphere, greens, pole, result.Values, 0.2).Near / poles;
      plain += CompareOnSphere(sphere, greens, pole, simple, 0.2).Near / poles;
    }
    RecordProperty("level" + std::to_string(level), std::to_string(error));
    EXPECT_LT(error, plain / 8.0) << level;
    errors.Add(error);
  }
  EXPECT_LT(errors.Last, 1e-3);
}

TEST(GreensInterpolation, ForgetsColumnsOfOtherSystems)
{
  const dgg::SurfaceMesh mesh = Build(Plane(30, 30, 0.28, 6));
  dgg::PoissonSolver solver(mesh);
  dgg::GreensInterpolation interpolation(solver);
  const auto pole = dgg::SurfacePoint::InFace(mesh, 930, { { 0.2, 0.3, 0.5 } });
  std::vector<dgg::PoissonOptions> several(4);
  several[1].Weights = dgg::PoissonWeights::Uniform;
  several[2].IntrinsicDelaunay = true;
  several[3].Boundary = dgg::PoissonBoundary::Dirichlet;
  std::vector<double> previous;
  for (const dgg::PoissonOptions& options : several)
  {
    ASSERT_TRUE(solver.Prepare(options, nullptr).IsOk());
    dgg::GreensResult result;
    ASSERT_TRUE(interpolation.Run(pole, {}, result).IsOk());
    dgg::GreensInterpolation fresh(solver);
    dgg::GreensResult expected;
    ASSERT_TRUE(fresh.Run(pole, {}, expected).IsOk());
    EXPECT_EQ(result.Values, expected.Values);
    EXPECT_NE(result.Values, previous);
    previous = result.Values;
  }
}
}
