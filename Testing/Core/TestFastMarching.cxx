// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Fast marching against closed forms and exact distances.
#include "ApproximationChecks.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"

#include "dggFastMarching.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dggtest
{
namespace
{
dgg::MarchingResult March(const dgg::SurfaceMesh& mesh,
  const std::vector<dgg::GeodesicSource>& sources,
  const std::function<void(dgg::MarchingOptions&)>& change = nullptr)
{
  dgg::MarchingOptions options;
  if (change)
  {
    change(options);
  }
  dgg::MarchingResult result;
  const dgg::Status status = dgg::FastMarching(mesh).Run(sources, options, result);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return result;
}

void Planar(dgg::MarchingOptions& options)
{
  options.Update = dgg::MarchingUpdate::Planar;
}
void WithVirtual(dgg::MarchingOptions& options)
{
  options.WantVirtualSource = true;
}

/// Plane of triangles that are about equilateral: without obtuse corners up to a jitter of 0.1.
TestMesh AcutePlane(Id columns, Id rows, double jitter, std::uint64_t seed)
{
  TestMesh mesh;
  Random random(seed);
  for (Id j = 0; j <= rows; ++j)
  {
    for (Id i = 0; i <= columns; ++i)
    {
      const bool onRim = i == 0 || j == 0 || i == columns || j == rows;
      const double dx = onRim ? 0.0 : random.Uniform(-jitter, jitter);
      const double dy = onRim ? 0.0 : random.Uniform(-jitter, jitter);
      mesh.AddPoint(i + 0.5 * j + dx, std::sqrt(0.75) * j + dy, 0.0);
    }
  }
  for (Id j = 0; j < rows; ++j)
  {
    for (Id i = 0; i < columns; ++i)
    {
      const Id a = j * (columns + 1) + i;
      mesh.AddQuad(a + 1, a + columns + 2, a + columns + 1, a);
    }
  }
  return mesh;
}

/// Sources at all vertices of a plane with y = 0.
std::vector<dgg::GeodesicSource> BottomRow(const TestMesh& plane)
{
  std::vector<dgg::GeodesicSource> sources;
  for (Id v = 0; v < plane.GetNumberOfVertices(); ++v)
  {
    if (plane.Point(v)[1] == 0.0)
    {
      sources.push_back(VertexSource(v));
    }
  }
  return sources;
}
}

TEST(FastMarching, SphericalFrontsAreExactInThePlane)
{
  for (const double jitter : { 0.0, 0.05, 0.1, 0.25 })
  {
    for (const bool isAcute : { true, false })
    {
      SCOPED_TRACE(jitter);
      const TestMesh plane =
        isAcute ? AcutePlane(14, 11, std::min(jitter, 0.1), 3) : Plane(14, 11, jitter, 3);
      const dgg::SurfaceMesh mesh = Build(plane);
      const bool isExact = isAcute || jitter == 0.0; // nearly, with obtuse corners
      for (const Id source : { 0, 50, 97, mesh.GetNumberOfVertices() - 1 })
      {
        const Errors errors = Compare(
          March(mesh, { VertexSource(source) }).Distances, EuclideanDistances(plane, source));
        EXPECT_LT(errors.Mean, isExact ? 1e-13 : 0.002);
        EXPECT_LT(errors.Largest, isExact ? 1e-12 : 0.05);
      }
    }
  }
}

TEST(FastMarching, PlanarFrontsAreExactFromALine)
{
  const TestMesh plane = AcutePlane(14, 11, 0.1, 3);
  const auto distances = March(Build(plane), BottomRow(plane), Planar).Distances;
  for (Id v = 0; v < plane.GetNumberOfVertices(); ++v)
  {
    // Beyond the end of the bottom row fronts are round.
    if (plane.Point(v)[0] < 14.0 - 0.7 * plane.Point(v)[1])
    {
      EXPECT_NEAR(distances[v], plane.Point(v)[1], 1e-12) << v;
    }
  }
}

TEST(FastMarching, Cylinder)
{
  const Id sides = 12;
  const Id columns = 2;
  const Id around = sides * columns;
  const dgg::SurfaceMesh mesh = Build(PrismSide(sides, columns, 16));
  const auto distances = March(mesh, { VertexSource(0) }).Distances;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double x = std::min(v % around, around - v % around) / static_cast<double>(columns);
    const double expected = std::hypot(x, static_cast<double>(v / around));
    // The fronts from both sides meet opposite the source.
    const double tolerance = x < 0.5 * sides - 1.0 ? 1e-12 * 20.0 : 0.02 * expected;
    EXPECT_NEAR(distances[v], expected, tolerance) << v;
  }
}

TEST(FastMarching, ObtuseTrianglesAreSplit)
{
  // Rows of points that are sheared against each other: corners of 150 degrees.
  TestMesh strip;
  const Id n = 30;
  for (Id v = 0; v < 20 * n; ++v)
  {
    strip.AddPoint(v % n + 1.6 * (v / n), 0.9 * (v / n), 0.0);
  }
  for (Id a = 0; a < 19 * n; ++a)
  {
    if (a % n + 1 < n)
    {
      strip.AddQuad(a, a + 1, a + n + 1, a + n);
    }
  }
  for (const NamedMesh& named :
    { NamedMesh{ "slivers", SliverPlane(12, 0.1) }, NamedMesh{ "needles", NeedlePlane(12, 0.05) },
      NamedMesh{ "caps", CapPlane(12, 0.1) }, NamedMesh{ "strip", strip } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const Id source : SomeVertices(mesh, 5, 3))
    {
      const Errors errors = Compare(
        March(mesh, { VertexSource(source) }).Distances, EuclideanDistances(named.Mesh, source));
      EXPECT_LT(errors.Mean, named.Name == "strip" ? 0.01 : 0.005);
      EXPECT_LT(errors.Largest, 0.1);
    }
  }
}

TEST(FastMarching, BendsAtSaddlesAndRims)
{
  // Behind the tip of a slit the way leads round the tip.
  std::vector<bool> isLower;
  const TestMesh slit = SlitPlane(8, isLower, 0.1);
  const dgg::SurfaceMesh mesh = Build(slit);
  const Id source = VertexAt(slit, 6.0, 0.0, 0.0);
  const auto exact = DistancesFrom(mesh, dgg::ExactEngine::Triangle, source);
  const Errors errors = Compare(March(mesh, { VertexSource(source) }).Distances, exact);
  EXPECT_LT(errors.Mean, 0.005);
  // Around a saddle of four right angles more, through the apex.
  std::vector<ConePoint> places;
  const dgg::SurfaceMesh cone = Build(Cone(4.0 * dgg::Pi, 24, 6, places, 0.1));
  const Id start = 40;
  const auto distances = March(cone, { VertexSource(start) }).Distances;
  for (Id v = 0; v < cone.GetNumberOfVertices(); ++v)
  {
    const double expected = ConeDistance(4.0 * dgg::Pi, places[start], places[v]);
    EXPECT_NEAR(distances[v], expected, 0.03 * expected + 1e-12) << v;
  }
}

TEST(FastMarching, SourcesAnywhere)
{
  const TestMesh plane = AcutePlane(10, 10, 0.1, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  std::vector<dgg::SurfacePoint> points = RandomSurfacePoints(mesh, 6, 3);
  points.push_back(dgg::SurfacePoint::OnEdge(mesh, 100, 0.3));
  for (const dgg::SurfacePoint& point : points)
  {
    const auto distances = March(mesh, { { point, 0.25 } }).Distances;
    double place[2] = { 0.0, 0.0 };
    const auto corners = mesh.GetTriangle(point.Face);
    for (int k = 0; k < 3; ++k)
    {
      place[0] += point.Barycentric[k] * plane.Point(corners[k])[0];
      place[1] += point.Barycentric[k] * plane.Point(corners[k])[1];
    }
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const double expected =
        std::hypot(plane.Point(v)[0] - place[0], plane.Point(v)[1] - place[1]);
      // Exact but for corners that are obtuse as seen with the source.
      EXPECT_NEAR(distances[v], 0.25 + expected, 2e-3) << v;
    }
  }
}

TEST(FastMarching, SeveralSourcesAndInitialDistances)
{
  const TestMesh plane = Plane(16, 16, 0.1, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  const std::vector<dgg::GeodesicSource> sources{ VertexSource(20, -3.0), VertexSource(200, 1.0),
    VertexSource(280, 0.5), VertexSource(201, 9.0) };
  const dgg::MarchingResult result = March(mesh, sources);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    std::vector<double> single;
    for (const dgg::GeodesicSource& source : sources)
    {
      single.push_back(source.InitialDistance + EuclideanDistance(plane, source.Point.Vertex, v));
    }
    const double expected = *std::min_element(single.begin(), single.end());
    // Within the triangles where fronts meet one of them is taken for both.
    EXPECT_NEAR(result.Distances[v], expected, 0.05) << v;
    ASSERT_GE(result.NearestSource[v], 0);
    EXPECT_NEAR(single[result.NearestSource[v]], expected, 0.5) << v;
    EXPECT_NE(result.NearestSource[v], 3) << "a source that is never the nearest";
  }
  EXPECT_EQ(result.Distances[20], -3.0);
}

TEST(FastMarching, VirtualSourcesInThePlane)
{
  const TestMesh plane = AcutePlane(12, 12, 0.1, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Id source = 80;
  const dgg::MarchingResult result = March(mesh, { VertexSource(source, 2.0) }, WithVirtual);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_NEAR(
      result.Virtual.Offsets[v] + result.Virtual.Lengths[v], result.Distances[v], 1e-12 * 20.0);
    if (v == source)
    {
      continue;
    }
    EXPECT_NEAR(result.Virtual.Offsets[v], 2.0, 1e-12) << v;
    // The first half-edge of the fan has angle 0.
    const Id first = mesh.Destination(*mesh.FanBegin(v));
    const double start = std::atan2(
      plane.Point(first)[1] - plane.Point(v)[1], plane.Point(first)[0] - plane.Point(v)[0]);
    const double angle = start + result.Virtual.Angles[v];
    EXPECT_NEAR(
      plane.Point(v)[0] + result.Virtual.Lengths[v] * std::cos(angle), plane.Point(source)[0], 1e-6)
      << v;
    EXPECT_NEAR(
      plane.Point(v)[1] + result.Virtual.Lengths[v] * std::sin(angle), plane.Point(source)[1], 1e-6)
      << v;
  }
}

TEST(FastMarching, WrongInputAndAbort)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(4));
  const dgg::FastMarching marching(mesh);
  dgg::MarchingOptions options;
  dgg::MarchingResult result;
  EXPECT_FALSE(marching.Run({}, options, result).IsOk());
  EXPECT_FALSE(marching.Run({ VertexSource(-1) }, options, result).IsOk());
  EXPECT_FALSE(marching.Run({ VertexSource(0, dgg::Infinity) }, options, result).IsOk());
  options.MaximumDistance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(marching.Run({ VertexSource(0) }, options, result).IsOk());
  options.MaximumDistance = dgg::Infinity;
  int calls = 0;
  options.Progress = [&](double fraction) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    return ++calls < 2;
  };
  EXPECT_TRUE(marching.Run({ VertexSource(0) }, options, result).IsAborted());
  EXPECT_EQ(calls, 2);
  EXPECT_TRUE(result.Distances.empty());
}
}
