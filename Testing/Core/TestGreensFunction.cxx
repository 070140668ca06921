// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Green's functions: identities, closed forms on spheres, tori, squares, disks and cones.
#include "GeodesicChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggGreensInterpolation.h"
#include "dggPoissonSystem.h"
#include "dggSingularPart.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
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
      const std::vector<double> f = RandomValues(n, 4);
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
  // Second order with poles inside, at a corner and on the rim; first order within an edge of it.
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
    errors.Add(all.Relative());
  }
  EXPECT_LT(errors.Last, 3e-3);
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

// The logarithm of Green's functions and its integrals.

namespace
{
/// Of the second kind: Simpson's rule after a substitution that is flat at both ends, for what is
/// singular there.
double Integrate(const std::function<double(double)>& f, double begin, double end)
{
  const int steps = 4000;
  double sum = 0.0;
  for (int k = 1; k < steps; ++k)
  {
    const double t = static_cast<double>(k) / steps;
    const double x = begin + (end - begin) * t * t * t * (10.0 - t * (15.0 - 6.0 * t));
    const double slope = 30.0 * t * t * (1.0 - t) * (1.0 - t);
    sum += (k % 2 ? 4.0 : 2.0) * f(x) * slope;
  }
  return sum * (end - begin) / (3.0 * steps);
}
}

TEST(Logarithm, IsSmoothAtItsEndAndLogarithmicAtThePole)
{
  const double radius = 0.7;
  const double angle = 5.0;
  const dgg::Logarithm s(radius, angle);
  EXPECT_EQ(s.At(radius), 0.0);
  EXPECT_EQ(s.At(2.0 * radius), 0.0);
  EXPECT_EQ(s.At(0.0), dgg::Infinity);
  // Value and three derivatives are 0: it goes down like the fourth power.
  const double h = 1e-2;
  EXPECT_NEAR(s.At(radius - 2.0 * h) / s.At(radius - h), 16.0, 0.5);
  // One unit flows out of every small circle.
  const double d = 1e-4;
  EXPECT_NEAR(-(s.At(d * 1.001) - s.At(d * 0.999)) / (0.002 * d) * angle * d, 1.0, 1e-5);
  // Mean over a disk.
  for (const double r : { 0.1, 0.5, 0.7 })
  {
    const double mean = Integrate([&](double t) { return s.At(t) * t; }, 0.0, r) * 2.0 / (r * r);
    EXPECT_NEAR(s.MeanOverDisk(r), mean, 1e-9);
  }
}

TEST(Logarithm, IntegralsAlongSegments)
{
  const dgg::Logarithm s(1.0, 2.0 * dgg::Pi);
  Random random(2);
  for (int k = 0; k < 200; ++k)
  {
    // On the x axis, seen from (px, py): now and then through the pole, or beyond the disk.
    const double length = random.Uniform(0.05, 1.5);
    const double px = random.Uniform(-1.0, 2.0);
    const double py = k % 10 == 0 ? 0.0 : random.Uniform(0.0, 1.3);
    const auto at = [&](double t) { return std::hypot(t - px, py); };
    const double half = py < 1.0 ? std::sqrt(1.0 - py * py) : 0.0;
    // In parts, so that what is not smooth is at ends of them.
    std::vector<double> ends{ 0.0, length, px, px - half, px + half };
    std::sort(ends.begin(), ends.end());
    const auto integrate = [&](const std::function<double(double)>& f) {
      double sum = 0.0;
      for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      {
        const double begin = std::max(0.0, ends[i]);
        const double end = std::min(length, ends[i + 1]);
        sum += begin < end ? Integrate(f, begin, end) : 0.0;
      }
      return sum;
    };
    const double expected = integrate([&](double t) { return s.At(at(t)); });
    EXPECT_NEAR(s.IntegrateAlong(length, at(0.0), at(length)), expected, 1e-8) << k;
    if (py > 0.0)
    {
      // Over the triangle with the pole: by the angle, of what is up to each distance.
      const double moment = 1.0 / (32.0 * dgg::Pi); // of s(t) t up to the radius
      const double sector = integrate([&](double t) {
        const double r = at(t);
        const double up = r < 1.0 ? s.MeanOverDisk(r) * r * r / 2.0 : moment;
        return up * py / (r * r);
      });
      EXPECT_NEAR(s.IntegrateSector(length, at(0.0), at(length)), sector, 1e-8) << k;
    }
  }
}

TEST(SingularPart, SumsAreThoseOfTheDisk)
{
  // On flat surfaces: loads sum to 0, integrals to R^2 / 16, whatever the triangles.
  const TestMesh plane = Plane(16, 16, 0.25);
  const dgg::SurfaceMesh mesh = Build(plane);
  dgg::PoissonSystem system(mesh);
  ASSERT_TRUE(system.Analyze({}, nullptr).IsOk());
  const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, 270, { { 0.2, 0.5, 0.3 } });
  dgg::ExactOptions options;
  dgg::ExactResult exact;
  ASSERT_TRUE(dgg::ExactGeodesics(mesh).Run({ { pole, 0.0 } }, options, exact).IsOk());
  dgg::PoleFace face{ 270, pole.Barycentric, {} };
  for (int k = 0; k < 3; ++k)
  {
    face.Distances[k] = dgg::DistanceToCorner(mesh, 270, pole.Barycentric, k);
  }
  for (const double radius : { 3.0, 5.5 })
  {
    dgg::SingularPart part(system);
    part.Assemble(dgg::Logarithm(radius, 2.0 * dgg::Pi), exact.Distances, { face });
    const auto& loads = part.GetLoads();
    const auto& integrals = part.GetIntegrals();
    EXPECT_NEAR(std::accumulate(loads.begin(), loads.end(), 0.0), 0.0, 1e-13);
    // Closed forms near the pole, three nodes per face away from it.
    EXPECT_NEAR(std::accumulate(integrals.begin(), integrals.end(), 0.0) / (radius * radius / 16.0),
      1.0, 2e-3);
    // Against a function that is linear: the integral of grad s is 0, as s is even.
    double first = 0.0;
    double second = 0.0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      first += loads[v] * plane.Point(v)[0];
      second += loads[v] * plane.Point(v)[1];
    }
    EXPECT_NEAR(first, 0.0, 1e-12);
    EXPECT_NEAR(second, 0.0, 1e-12);
  }
}

// Green's functions of many points from those of vertices.

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
