// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Green's functions of the bi-Laplacian: identities, the series on the sphere, queries.
#include "GeodesicChecks.h"
#include "GreensTestTools.h"
#include "TestMeshes.h"

#include "dggGreensInterpolation.h"
#include "dggPoissonSystem.h"
#include "dggSpectralDistance.h"

namespace dggtest
{
namespace
{
dgg::GreensQuery Twofold(dgg::GreensMethod method = dgg::GreensMethod::SingularitySubtraction)
{
  dgg::GreensQuery query;
  query.Order = dgg::GreensOrder::BiLaplace;
  query.Method = method;
  return query;
}

/// Returns the value on the unit sphere: the sum over l of (2 l + 1) / (4 pi) P_l(cosine) / (l (l +
/// 1))^2.
double SphereSeries(double cosine)
{
  double previous = 1.0;
  double legendre = cosine;
  double sum = 0.0;
  for (int l = 1; l < 1500; ++l) // the remainder is below 1 / (4 pi l^2)
  {
    const double eigenvalue = l * (l + 1.0);
    sum += (2.0 * l + 1.0) / (4.0 * dgg::Pi) * legendre / (eigenvalue * eigenvalue);
    const double next = ((2.0 * l + 1.0) * cosine * legendre - l * previous) / (l + 1.0);
    previous = legendre;
    legendre = next;
  }
  return sum;
}

struct Deviation
{
  double Largest = 0.0; // largest at vertices
  double AtTargets = 0.0;
  double Mean = 0.0; // root mean square over area
};

/// Returns the deviations relative to the range.
Deviation DeviationOnSphere(const TestMesh& sphere, const Greens& greens,
  const dgg::SurfacePoint& pole, const dgg::GreensResult& result,
  const std::vector<dgg::SurfacePoint>& targets)
{
  const double range = SphereSeries(1.0) - SphereSeries(-1.0);
  const dgg::SurfaceMesh& mesh = greens.Solver.GetMesh();
  const auto x = dgg::PositionOf(mesh, pole, sphere.Points.data());
  const auto differenceAt = [&](const double* y, double value) {
    const double norms = std::sqrt(
      (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) * (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]));
    const double cosine = (x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) / norms;
    return std::abs(value - SphereSeries(std::min(1.0, cosine))) / range;
  };
  Deviation deviation;
  double area = 0.0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double difference = differenceAt(sphere.Point(v), result.Values[v]);
    deviation.Largest = std::max(deviation.Largest, difference);
    deviation.Mean += greens.Solver.GetAreas()[v] * difference * difference;
    area += greens.Solver.GetAreas()[v];
  }
  deviation.Mean = std::sqrt(deviation.Mean / area);
  for (std::size_t k = 0; k < targets.size(); ++k)
  {
    const auto y = dgg::PositionOf(mesh, targets[k], sphere.Points.data());
    deviation.AtTargets =
      std::max(deviation.AtTargets, differenceAt(y.data(), result.TargetValues[k]));
  }
  return deviation;
}
}

TEST(BiharmonicGreens, SphereConverges)
{
  // Meshes of 2562, 10 242 and 40 962 vertices; the pole is included.
  EXPECT_NEAR(SphereSeries(1.0), 1.0 / (4.0 * dgg::Pi), 1e-6);
  EXPECT_NEAR(SphereSeries(-1.0), (1.0 - dgg::Pi * dgg::Pi / 6.0) / (4.0 * dgg::Pi), 1e-6);
  Convergence largest(1.7);
  Convergence mean(1.8);
  Convergence atTargets(1.6);
  Convergence interpolated(1.9);
  for (const int level : { 4, 5, 6 })
  {
    const TestMesh sphere = Icosphere(level);
    const dgg::SurfaceMesh mesh = Build(sphere);
    const Greens greens(mesh);
    Random random(7);
    Deviation all;
    double plain = 0.0;
    for (const bool atVertex : { true, false, false })
    {
      const dgg::SurfacePoint pole =
        atVertex ? dgg::SurfacePoint::AtVertex(3) : InsideFace(mesh, random);
      dgg::GreensQuery query = Twofold();
      query.Targets = { pole, InsideFace(mesh, random), dgg::SurfacePoint::AtVertex(5) };
      const dgg::GreensResult result = greens.Run(pole, query);
      EXPECT_EQ(result.Method, dgg::GreensMethod::SingularitySubtraction);
      const Deviation deviation = DeviationOnSphere(sphere, greens, pole, result, query.Targets);
      all.Largest = std::max(all.Largest, deviation.Largest);
      all.AtTargets = std::max(all.AtTargets, deviation.AtTargets);
      all.Mean = std::max(all.Mean, deviation.Mean);
      const dgg::GreensResult simple = greens.Run(pole, Twofold(dgg::GreensMethod::Interpolated));
      plain = std::max(plain, DeviationOnSphere(sphere, greens, pole, simple, {}).Mean);
    }
    RecordProperty("largest" + std::to_string(level), std::to_string(all.Largest));
    RecordProperty("mean" + std::to_string(level), std::to_string(all.Mean));
    largest.Add(all.Largest);
    mean.Add(all.Mean);
    atTargets.Add(all.AtTargets);
    interpolated.Add(plain);
    if (level == 5)
    {
      EXPECT_LT(all.Largest, 1e-4);
      EXPECT_LT(all.AtTargets, 2e-4); // interpolated linearly in faces
      EXPECT_LT(plain, 1.2e-4);
    }
  }
}

TEST(BiharmonicGreens, MakesTheBiharmonicDistance)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.02, 3));
  const Greens greens(mesh);
  Random random(5);
  const std::vector<dgg::SurfacePoint> points{ dgg::SurfacePoint::AtVertex(17),
    InsideFace(mesh, random), InsideFace(mesh, random), dgg::SurfacePoint::OnEdge(mesh, 8, 0.3) };
  dgg::GreensQuery query = Twofold(dgg::GreensMethod::Interpolated);
  query.Targets = points;
  std::vector<dgg::GreensResult> results;
  ASSERT_TRUE(Ok(greens.Function.Run(points, query, results)));
  dgg::SpectralDistance distance(greens.Solver);
  dgg::SpectralOptions options;
  options.Method = dgg::SpectralMethod::Exact;
  ASSERT_TRUE(Ok(distance.Prepare(options, nullptr, nullptr)));
  std::vector<double> distances;
  ASSERT_TRUE(Ok(distance.Between(points, points, nullptr, nullptr, distances)));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = 0; j < points.size(); ++j)
    {
      const double square = results[i].TargetValues[i] + results[j].TargetValues[j] -
        results[i].TargetValues[j] - results[j].TargetValues[i];
      EXPECT_NEAR(
        square, distances[i * points.size() + j] * distances[i * points.size() + j], 1e-12);
    }
  }
}

TEST(BiharmonicGreens, SolvesTheBiLaplaceEquation)
{
  // Integrals are the response to a density; at the pole, the integral is the value of the
  // solution.
  const TestMesh points = Icosphere(3);
  const dgg::SurfaceMesh mesh = Build(points);
  const Greens greens(mesh);
  const auto harmonic = [&](Id v) { return points.Point(v)[0] * points.Point(v)[2]; };
  std::vector<std::vector<double>> columns(1);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    columns[0].push_back(36.0 * harmonic(v) * greens.Solver.GetAreas()[v]);
  }
  const std::vector<double> sources = columns[0];
  ASSERT_TRUE(Ok(greens.Solver.SolveBiLaplace(columns)));
  dgg::GreensQuery query = Twofold(dgg::GreensMethod::Interpolated);
  query.WantIntegrals = true;
  const dgg::GreensResult result = greens.Run(dgg::SurfacePoint::AtVertex(7), query);
  double response = 0.0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_NEAR(columns[0][v], harmonic(v), 0.01);
    response += result.Integrals[v] * sources[v] / greens.Solver.GetAreas()[v];
  }
  EXPECT_NEAR(response, columns[0][7], 1e-12);
}

TEST(BiharmonicGreens, InterpolationIsCloseToASolvePerPoint)
{
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  const Greens greens(mesh);
  dgg::GreensInterpolation interpolation(greens.Solver);
  Random random(21);
  for (int k = 0; k < 4; ++k)
  {
    const dgg::SurfacePoint pole = InsideFace(mesh, random);
    dgg::GreensQuery query = Twofold();
    query.Targets = { pole };
    dgg::GreensResult result;
    ASSERT_TRUE(Ok(interpolation.Run(pole, query, result)));
    EXPECT_LT(DeviationOnSphere(sphere, greens, pole, result, query.Targets).Largest, 2e-3);
    EXPECT_TRUE(result.Integrals.empty());
  }
}

TEST(BiharmonicGreens, BoundariesHaveTheirConditions)
{
  // On the unit square the truth is a sum of products of cosines, or of sines for Dirichlet
  // conditions.
  const Id n = 40;
  const TestMesh square = Scaled(Plane(n, n, 0.2), 1.0 / n);
  const dgg::SurfaceMesh mesh = Build(square);
  const dgg::SurfacePoint pole = dgg::SurfacePoint::InFace(mesh, n * n + n, { { 0.2, 0.5, 0.3 } });
  const auto x = dgg::PositionOf(mesh, pole, square.Points.data());
  for (const auto boundary : Boundaries)
  {
    const bool isFree = boundary == dgg::PoissonBoundary::Neumann;
    const Greens greens(mesh, With(boundary));
    const auto wave = [&](int k, double t) {
      return isFree ? (k == 0 ? 1.0 : std::sqrt(2.0) * std::cos(k * dgg::Pi * t))
                    : std::sqrt(2.0) * std::sin(k * dgg::Pi * t);
    };
    constexpr int count = 50;
    const auto products = [&](double a, double b) {
      std::vector<double> found;
      for (int k = 0; k < count; ++k)
      {
        found.push_back(wave(k, a) * wave(k, b));
      }
      return found;
    };
    const auto truth = [&](const double* y) {
      const std::vector<double> across = products(x[0], y[0]);
      const std::vector<double> along = products(x[1], y[1]);
      double sum = 0.0;
      for (int i = 0; i < count; ++i)
      {
        for (int j = i == 0 ? 1 : 0; j < count; ++j)
        {
          const double eigenvalue = dgg::Pi * dgg::Pi * (i * i + j * j);
          sum += across[i] * along[j] / (eigenvalue * eigenvalue);
        }
      }
      return sum;
    };
    const dgg::GreensResult result = greens.Run(pole, Twofold());
    EXPECT_EQ(result.Method, dgg::GreensMethod::SingularitySubtraction);
    const double top = truth(x.data());
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      ASSERT_NEAR(result.Values[v], truth(square.Point(v)), 5e-3 * top) << v;
      ASSERT_TRUE(!greens.Solver.IsFixed(v) || std::abs(result.Values[v]) < 1e-15);
    }
  }
}

}
