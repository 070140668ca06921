// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Green's functions: identities, closed forms on spheres, tori, squares, disks and cones.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GreensTestTools.h"

#include "dggPoissonSystem.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

namespace dggtest
{
TEST(GreensFunction, DiscreteIdentities)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const Id n = mesh.GetNumberOfVertices();
    for (const auto weights : { dgg::PoissonWeights::Area, dgg::PoissonWeights::Uniform })
    {
      dgg::PoissonOptions options;
      options.Weights = weights;
      const Greens greens(mesh, options);
      Id count = 0;
      const std::vector<Id> components = mesh.ComputeComponents(count);
      Random random(4);
      std::vector<double> f(n);
      for (double& value : f)
      {
        value = random.Uniform(-1.0, 1.0);
      }
      const std::vector<double> laplacian = greens.Solver.GetSystem().Multiply(f);
      const std::vector<Id> poles = SomeVertices(mesh, 6, 3);
      std::vector<std::vector<double>> columns;
      for (const Id j : poles)
      {
        const auto g = greens.Run(dgg::SurfacePoint::AtVertex(j), dgg::GreensMethod::Vertex).Values;
        const std::vector<double> product = greens.Solver.GetSystem().Multiply(g);
        double mean = 0.0;
        double meanOfF = 0.0;
        double sum = 0.0;
        for (Id v = 0; v < n; ++v)
        {
          const double weight = components[v] == components[j] ? greens.Solver.GetWeight(v) : 0.0;
          ASSERT_NEAR(product[v], (v == j ? 1.0 : 0.0) - weight, 1e-9) << named.Name;
          mean += weight * g[v];
          meanOfF += weight * f[v];
          sum += g[v] * laplacian[v];
          if (components[v] != components[j])
          {
            ASSERT_EQ(g[v], 0.0);
          }
        }
        EXPECT_NEAR(mean, 0.0, 1e-12) << named.Name;
        EXPECT_NEAR(meanOfF + sum, f[j], 1e-9) << named.Name;
        columns.push_back(g);
      }
      for (std::size_t a = 0; a < poles.size(); ++a)
      {
        for (std::size_t b = 0; b < a; ++b)
        {
          EXPECT_NEAR(columns[a][poles[b]], columns[b][poles[a]], 1e-10) << named.Name;
        }
      }
    }
  }
}

TEST(GreensFunction, SphereConverges)
{
  // Relative L2 error within 0.2 of the pole and everywhere, mean over random points in faces.
  double first = 0.0;
  double last = 0.0;
  double firstGlobal = 0.0;
  double lastGlobal = 0.0;
  for (const int level : { 3, 4, 5, 6 })
  {
    const TestMesh sphere = Icosphere(level);
    const dgg::SurfaceMesh mesh = Build(sphere);
    const Greens greens(mesh);
    const int poles = 10;
    double local = 0.0;
    double global = 0.0;
    Random random(7);
    for (int k = 0; k < poles; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      const dgg::GreensResult result = greens.Run(pole);
      EXPECT_EQ(result.Method, dgg::GreensMethod::SingularitySubtraction);
      EXPECT_EQ(result.Remark, dgg::GreensRemark::None);
      EXPECT_GT(result.Radius, 0.85);
      const SphereErrors errors = CompareOnSphere(sphere, greens, pole, result.Values, 0.2);
      local += errors.Near / poles;
      global += errors.All / poles;
    }
    RecordProperty("level" + std::to_string(level), std::to_string(local));
    if (level == 3)
    {
      first = local;
      firstGlobal = global;
    }
    if (level == 5)
    {
      EXPECT_LT(local, 1e-4);
    }
    last = local;
    lastGlobal = global;
  }
  EXPECT_GT(std::log2(first / last) / 3.0, 1.8);
  EXPECT_GT(std::log2(firstGlobal / lastGlobal) / 3.0, 1.9);
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
  // Second order with poles inside, at a corner and on the rim; first order within an edge of it.
  for (const bool delaunay : { false, true })
  {
    double previous[2] = { 0.0, 0.0 };
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
        const std::array<double, 3> x = PositionOf(square, mesh, pole);
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
          const std::array<double, 3> x = PositionOf(square, mesh, pole);
          dgg::GreensQuery query;
          query.Radius = 0.28; // the same on all meshes
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
        if (n > 20)
        {
          EXPECT_GT(std::log2(previous[kind] / all.Relative()), kind == 0 ? 1.7 : 0.7)
            << n << " " << delaunay;
        }
        previous[kind] = all.Relative();
        EXPECT_LT(all.Relative(), (kind == 0 ? 0.15 : 1.5) * plain.Relative());
      }
    }
    EXPECT_LT(previous[0], 2e-4);
  }
}

TEST(GreensFunction, DiskWithZeroOnItsRim)
{
  double previous = 0.0;
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
      query.Radius = 0.5; // the same on all meshes
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
    if (n > 12)
    {
      EXPECT_GT(std::log2(previous / all.Relative()), 1.6) << n;
    }
    previous = all.Relative();
  }
  EXPECT_LT(previous, 3e-3);
}

TEST(GreensFunction, ConesByTheirTotalAngle)
{
  // Apex at the pole, 0 on the rim: -log(r) / Theta, whether the apex is sharp or a saddle.
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
    // Interpolated is far off next to the pole.
    const auto plain = greens.Run(dgg::SurfacePoint::AtVertex(0), dgg::GreensMethod::Vertex).Values;
    EXPECT_GT(std::abs(plain[1] + std::log(points[1].Radius) / total), 5e-3) << total;
  }
}
}
