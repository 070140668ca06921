// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The heat method: convergence, sources, boundaries, what is kept.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggHeatMethod.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
/// A method that is ready.
class Heat
{
public:
  explicit Heat(const dgg::SurfaceMesh& mesh, const dgg::HeatOptions& options = {})
    : Method(mesh)
  {
    EXPECT_TRUE(Ok(this->Method.Prepare(options, nullptr)));
  }

  dgg::HeatResult Run(
    const std::vector<dgg::GeodesicSource>& sources, const dgg::HeatQuery& query = {}) const
  {
    dgg::HeatResult result;
    EXPECT_TRUE(Ok(this->Method.Run(sources, query, result)));
    return result;
  }

  dgg::HeatMethod Method;
};

dgg::HeatOptions Direct()
{
  dgg::HeatOptions options;
  options.IntrinsicDelaunay = false;
  return options;
}

dgg::HeatOptions WithBoundary(dgg::HeatBoundary boundary)
{
  dgg::HeatOptions options;
  options.Boundary = boundary;
  return options;
}

double MeanError(const std::vector<double>& actual, const std::vector<double>& expected)
{
  return Compare(actual, expected).Mean;
}

/// A strip that is longer than heat can be reported in doubles.
constexpr Id StripColumns = 1500;
TestMesh LongStrip()
{
  return Plane(StripColumns, 2);
}
}

TEST(HeatMethod, Sphere)
{
  const TestMesh sphere = Icosphere(4);
  const dgg::SurfaceMesh mesh = Build(sphere);
  std::vector<double> expected;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double* p = sphere.Point(0);
    const double* q = sphere.Point(v);
    expected.push_back(
      std::acos(std::min(1.0, std::max(-1.0, p[0] * q[0] + p[1] * q[1] + p[2] * q[2]))));
  }
  for (const dgg::HeatOptions& options : { dgg::HeatOptions(), Direct() })
  {
    const auto distances = Heat(mesh, options).Run({ VertexSource(0) }).Distances;
    EXPECT_EQ(distances[0], 0.0);
    EXPECT_LT(MeanError(distances, expected), 0.015);
  }
}

TEST(HeatMethod, ConvergesInThePlane)
{
  double previous = 1.0;
  for (const Id n : { 10, 20, 40, 80 })
  {
    const TestMesh plane = Plane(n, n, 0.2, 3);
    const Id source = (n / 2) * (n + 1) + n / 2;
    const double error = MeanError(Heat(Build(plane)).Run({ VertexSource(source) }).Distances,
      EuclideanDistances(plane, source));
    EXPECT_LT(error, 0.75 * previous) << n;
    previous = error;
  }
  EXPECT_LT(previous, 0.012);
}

TEST(HeatMethod, FlipsHelpOnLongTriangles)
{
  const dgg::SurfaceMesh mesh = Build(Ellipsoid(4, 20.0));
  const auto exact = DistancesFrom(mesh, dgg::ExactEngine::Triangle, 7);
  const double flipped = MeanError(Heat(mesh).Run({ VertexSource(7) }).Distances, exact);
  const double direct = MeanError(Heat(mesh, Direct()).Run({ VertexSource(7) }).Distances, exact);
  EXPECT_LT(flipped, direct);
  EXPECT_LT(flipped, 0.08);
}

TEST(HeatMethod, AnotherComponentChangesNothing)
{
  const TestMesh input = NoisySphere(3, 0.2, 9);
  const dgg::SurfaceMesh alone = Build(input);
  const auto expected = Heat(alone).Run({ VertexSource(5) }).Distances;
  TestMesh both = input;
  Append(both, Translated(Scaled(Icosphere(2), 1000.0), 5000.0, 0.0, 0.0));
  both.AddPoint(1.0, 2.0, 3.0); // isolated
  const dgg::SurfaceMesh mesh = Build(both);
  const Heat heat(mesh);
  const auto distances = heat.Run({ VertexSource(5) }).Distances;
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    if (v < expected.size())
    {
      EXPECT_NEAR(distances[v], expected[v], 1e-9);
    }
    else
    {
      EXPECT_EQ(distances[v], dgg::Infinity);
    }
  }
  // An isolated source reaches itself.
  const Id last = mesh.GetNumberOfVertices() - 1;
  const auto fromLast = heat.Run({ VertexSource(last, 0.5) }).Distances;
  EXPECT_EQ(fromLast[last], 0.5);
  EXPECT_EQ(fromLast[0], dgg::Infinity);
}

TEST(HeatMethod, FartherThanHeatReaches)
{
  const TestMesh strip = LongStrip();
  const dgg::SurfaceMesh mesh = Build(strip);
  for (const dgg::HeatOptions& options : { dgg::HeatOptions(),
         WithBoundary(dgg::HeatBoundary::Average), WithBoundary(dgg::HeatBoundary::Dirichlet) })
  {
    const Id source = StripColumns + 1 + 3; // in the middle row
    const auto distances = Heat(mesh, options).Run({ VertexSource(source) }).Distances;
    double slope = 0.0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      ASSERT_TRUE(std::isfinite(distances[v])) << v;
      const double expected = EuclideanDistance(strip, source, v);
      // In a strip like this a cooled rim turns all gradients to it; there are numbers at least.
      if (expected > 20.0 && options.Boundary != dgg::HeatBoundary::Dirichlet)
      {
        EXPECT_NEAR(distances[v] / expected, 1.0, 0.05) << v;
      }
      slope = std::max(slope, distances[v]);
    }
    EXPECT_GT(slope, options.Boundary == dgg::HeatBoundary::Dirichlet ? 100.0 : 1400.0);
  }
}

TEST(HeatMethod, LittleHeatIsAsGoodAsMuch)
{
  // The same field in doubles and in numbers with a larger range: a source with an initial distance
  // that makes it unimportant brings the latter into play.
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.2, 9));
  const Heat heat(mesh);
  const auto doubles = heat.Run({ VertexSource(5) }).Distances;
  const double far = 1000.0 * mesh.GetMeanEdgeLength();
  const auto wide = heat.Run({ VertexSource(5), VertexSource(60, far) }).Distances;
  ExpectSameField(doubles, wide, 1e-9, "field");
  // A little less unimportant: still in doubles.
  const double near = 50.0 * mesh.GetMeanEdgeLength();
  ExpectSameField(
    doubles, heat.Run({ VertexSource(5), VertexSource(60, near) }).Distances, 1e-9, "field");
}

TEST(HeatMethod, InitialDistances)
{
  const TestMesh plane = Plane(60, 20, 0.1, 4);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Heat heat(mesh);
  const Id a = 10 * 61 + 8;
  const Id b = 10 * 61 + 52;
  dgg::HeatQuery query;
  query.WantNearestSource = true;
  for (const double offset : { 0.0, 8.0, -16.0, 100.0 })
  {
    SCOPED_TRACE(offset);
    const std::vector<dgg::GeodesicSource> sources{ VertexSource(a, 3.0),
      VertexSource(b, 3.0 + offset) };
    const dgg::HeatResult result = heat.Run(sources, query);
    const auto exact = Solve(mesh, dgg::ExactEngine::Triangle, sources);
    Id agreeing = 0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      EXPECT_NEAR(result.Distances[v], exact.Distances[v], 1.5) << v;
      agreeing += result.NearestSource[v] == exact.NearestSource[v] ? 1 : 0;
    }
    EXPECT_GT(agreeing, 0.93 * mesh.GetNumberOfVertices());
    EXPECT_LE(result.Distances[a], 3.0);
    EXPECT_LE(result.Distances[b], 3.0 + offset);
    EXPECT_EQ(*std::min_element(result.Distances.begin(), result.Distances.end()),
      std::min(3.0, 3.0 + offset));
  }
}

TEST(HeatMethod, SourcesAnywhere)
{
  const TestMesh plane = Plane(30, 30, 0.2, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Heat heat(mesh);
  std::vector<dgg::SurfacePoint> points = RandomSurfacePoints(mesh, 6, 3);
  points.push_back(dgg::SurfacePoint::OnEdge(mesh, 1000, 0.3));
  for (const dgg::SurfacePoint& point : points)
  {
    const auto exact = Solve(mesh, dgg::ExactEngine::Triangle, { { point, 0.25 } }).Distances;
    const auto distances = heat.Run({ { point, 0.25 } }).Distances;
    EXPECT_LT(MeanError(distances, exact), 0.06);
    for (std::size_t v = 0; v < distances.size(); ++v)
    {
      EXPECT_NEAR(distances[v], exact[v], 3.0) << v;
    }
  }
}

TEST(HeatMethod, Boundaries)
{
  const TestMesh plane = Plane(24, 24, 0.2, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Id middle = 12 * 25 + 12;
  const auto exact = DistancesFrom(mesh, dgg::ExactEngine::Triangle, middle);
  const Heat neumann(mesh);
  const Heat dirichlet(mesh, WithBoundary(dgg::HeatBoundary::Dirichlet));
  const Heat average(mesh, WithBoundary(dgg::HeatBoundary::Average));
  std::vector<double> means;
  for (const Heat* heat : { &neumann, &dirichlet, &average })
  {
    const auto distances = heat->Run({ VertexSource(middle) }).Distances;
    EXPECT_LT(MeanError(distances, exact), 0.12);
    means.push_back(distances[0]);
  }
  // At a corner the flow slows down with one condition and not with the other.
  EXPECT_NE(means[0], means[1]);
  EXPECT_GT(means[2], std::min(means[0], means[1]));
  EXPECT_LT(means[2], std::max(means[0], means[1]));

  // No heat is left of a source on the boundary.
  dgg::HeatResult result;
  const dgg::Status status =
    dirichlet.Method.Run({ VertexSource(middle), VertexSource(3) }, {}, result);
  EXPECT_FALSE(status.IsOk());
  EXPECT_TRUE(Says(status, "source 1 lies on the boundary"));
  EXPECT_LT(MeanError(average.Run({ VertexSource(3) }).Distances,
              DistancesFrom(mesh, dgg::ExactEngine::Triangle, 3)),
    0.12);
}

TEST(HeatMethod, VirtualSources)
{
  const TestMesh plane = Plane(30, 30, 0.15, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Id source = 15 * 31 + 12;
  dgg::HeatQuery query;
  query.WantVirtualSource = true;
  const dgg::HeatResult result = Heat(mesh).Run({ VertexSource(source, 2.0) }, query);
  EXPECT_TRUE(result.NearestSource.empty());
  double worst = 0.0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_NEAR(result.Virtual[v].Offset + result.Virtual[v].Length, result.Distances[v], 1e-11);
    EXPECT_NEAR(result.Virtual[v].Offset, 2.0, 1e-12);
    if (EuclideanDistance(plane, source, v) > 3.0 && mesh.Kind(v) == dgg::VertexKind::Flat)
    {
      const double turn = std::remainder(
        FanAngle(plane, mesh, v) + result.Virtual[v].Angle - DirectionOf(plane, v, source),
        2.0 * dgg::Pi);
      worst = std::max(worst, std::abs(turn));
    }
  }
  EXPECT_LT(worst, 0.4);
}

}
