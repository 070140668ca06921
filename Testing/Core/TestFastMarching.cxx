// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Fast marching against closed forms, exact distances and invariants.
#include "EdgeGraph.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

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

struct Errors
{
  double Mean = 0.0;
  double Largest = 0.0;
};

Errors Compare(const std::vector<double>& actual, const std::vector<double>& expected)
{
  Errors errors;
  double count = 0.0;
  for (std::size_t v = 0; v < actual.size(); ++v)
  {
    EXPECT_EQ(actual[v] < dgg::Infinity, expected[v] < dgg::Infinity) << v;
    if (expected[v] > 0.0 && expected[v] < dgg::Infinity)
    {
      const double error = std::abs(actual[v] / expected[v] - 1.0);
      errors.Mean += error;
      errors.Largest = std::max(errors.Largest, error);
      count += 1.0;
    }
  }
  errors.Mean /= std::max(1.0, count);
  return errors;
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
  for (const double jitter : { 0.0, 0.05, 0.1 })
  {
    SCOPED_TRACE(jitter);
    const TestMesh plane = AcutePlane(14, 11, jitter, 3);
    const dgg::SurfaceMesh mesh = Build(plane);
    for (const Id source : { 0, 50, 97, mesh.GetNumberOfVertices() - 1 })
    {
      const auto distances = March(mesh, { VertexSource(source) }).Distances;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        EXPECT_NEAR(distances[v], EuclideanDistance(plane, source, v), 1e-12 * 20.0)
          << source << " to " << v;
      }
    }
  }
}

TEST(FastMarching, NearlyExactInThePlaneWithObtuseCorners)
{
  for (const double jitter : { 0.0, 0.1, 0.25 })
  {
    SCOPED_TRACE(jitter);
    const TestMesh plane = Plane(14, 11, jitter, 3);
    const dgg::SurfaceMesh mesh = Build(plane);
    for (const Id source : { 0, 50, 97, mesh.GetNumberOfVertices() - 1 })
    {
      std::vector<double> expected;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        expected.push_back(EuclideanDistance(plane, source, v));
      }
      const Errors errors = Compare(March(mesh, { VertexSource(source) }).Distances, expected);
      EXPECT_LT(errors.Mean, jitter == 0.0 ? 1e-13 : 0.002);
      EXPECT_LT(errors.Largest, jitter == 0.0 ? 1e-12 : 0.05);
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

TEST(FastMarching, PlanarFrontsFromAPointAreWorse)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(4));
  const auto exact = DistancesFrom(mesh, dgg::ExactEngine::Triangle, 0);
  const Errors spherical = Compare(March(mesh, { VertexSource(0) }).Distances, exact);
  const Errors planar = Compare(March(mesh, { VertexSource(0) }, Planar).Distances, exact);
  EXPECT_LT(spherical.Mean, 0.003);
  EXPECT_LT(planar.Mean, 0.03);
  EXPECT_GT(planar.Mean, 2.0 * spherical.Mean);
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
  for (const NamedMesh& named : { NamedMesh{ "slivers", SliverPlane(12, 0.1) },
         NamedMesh{ "needles", NeedlePlane(12, 0.05) }, NamedMesh{ "caps", CapPlane(12, 0.1) } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const Id source : SomeVertices(mesh, 5, 3))
    {
      std::vector<double> expected;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        expected.push_back(EuclideanDistance(named.Mesh, source, v));
      }
      const Errors errors = Compare(March(mesh, { VertexSource(source) }).Distances, expected);
      EXPECT_LT(errors.Mean, 0.005);
      EXPECT_LT(errors.Largest, 0.1);
    }
  }
}

TEST(FastMarching, ObtuseStrip)
{
  // Rows of points that are sheared against each other: corners of 150 degrees.
  TestMesh strip;
  const Id n = 30;
  for (Id j = 0; j < 20; ++j)
  {
    for (Id i = 0; i < n; ++i)
    {
      strip.AddPoint(i + 1.6 * j, 0.9 * j, 0.0);
    }
  }
  for (Id j = 0; j + 1 < 20; ++j)
  {
    for (Id i = 0; i + 1 < n; ++i)
    {
      const Id a = j * n + i;
      strip.AddQuad(a, a + 1, a + n + 1, a + n);
    }
  }
  const dgg::SurfaceMesh mesh = Build(strip);
  const Id source = 10 * n + 12;
  const auto exact = DistancesFrom(mesh, dgg::ExactEngine::Triangle, source);
  const Errors errors = Compare(March(mesh, { VertexSource(source) }).Distances, exact);
  EXPECT_LT(errors.Mean, 0.01);
  EXPECT_LT(errors.Largest, 0.1);
}

TEST(FastMarching, CloseToExactOnSoundMeshes)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    SCOPED_TRACE(named.Name);
    // Fronts lose their way in triangles of 1:20.
    const bool isLong = named.Name.find("Ellipsoid20") != std::string::npos;
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const auto point = dgg::SurfacePoint::InFace(mesh, 1, { { 0.2, 0.3, 0.5 } });
    for (const dgg::GeodesicSource& source : { VertexSource(0), dgg::GeodesicSource{ point, 0.0 } })
    {
      const auto exact = Solve(mesh, dgg::ExactEngine::Triangle, { source }).Distances;
      const Errors errors = Compare(March(mesh, { source }).Distances, exact);
      EXPECT_LT(errors.Mean, isLong ? 0.15 : 0.03);
      EXPECT_LT(errors.Largest, isLong ? 5.0 : 0.3);
    }
  }
}

TEST(FastMarching, AnyTrianglesWillDo)
{
  std::vector<NamedMesh> meshes = DefectMeshes();
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    Random random(seed);
    const Id vertices = 3 + random.Index(20);
    meshes.push_back(
      { "soup " + std::to_string(seed), RandomSoup(vertices, 1 + random.Index(50), seed) });
  }
  for (const NamedMesh& named : meshes)
  {
    SCOPED_TRACE(named.Name);
    dgg::SurfaceMesh mesh;
    if (named.Mesh.Points.empty())
    {
      mesh = Build(named.Mesh);
    }
    else if (!dgg::SurfaceMesh::FromPoints(named.Mesh.Points.data(),
               named.Mesh.GetNumberOfVertices(), named.Mesh.Triangles.data(),
               named.Mesh.GetNumberOfFaces(), mesh)
                .IsOk())
    {
      continue; // single points
    }
    for (const Id v : { 0, mesh.GetNumberOfVertices() - 1 })
    {
      const dgg::GeodesicSource source = VertexSource(v);
      const auto bound = dggtest::EdgeGraphDistances(mesh, { source });
      const double diameter = LargestFinite(bound);
      for (const auto& update : { dgg::MarchingUpdate::Spherical, dgg::MarchingUpdate::Planar })
      {
        const auto distances = March(mesh, { source }, [&](dgg::MarchingOptions& options) {
          options.Update = update;
        }).Distances;
        for (Id u = 0; u < mesh.GetNumberOfVertices(); ++u)
        {
          ASSERT_EQ(distances[u] < dgg::Infinity, bound[u] < dgg::Infinity) << u;
          if (bound[u] < dgg::Infinity)
          {
            ASSERT_GE(distances[u], 0.0);
            ASSERT_LE(distances[u], bound[u] + 1e-9 * diameter) << u;
          }
        }
      }
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

TEST(FastMarching, Invariance)
{
  const TestMesh input = NoisySphere(3, 0.2, 9);
  const auto base = March(Build(input), { VertexSource(5) }).Distances;
  for (const double factor : { 1e-6, 1e6 })
  {
    const auto scaled = March(Build(Scaled(input, factor)), { VertexSource(5) }).Distances;
    for (std::size_t v = 0; v < base.size(); ++v)
    {
      EXPECT_NEAR(scaled[v] / factor, base[v], 1e-9);
    }
  }
  const auto moved =
    March(Build(MovedRigidly(input, 1.1, { { 3.0, -2.0, 1.0 } })), { VertexSource(5) }).Distances;
  ExpectSameField(base, moved, 1e-9, "moved");
  const auto newIds = RandomPermutation(input.GetNumberOfVertices(), 4);
  const auto renumbered =
    March(Build(Renumbered(input, newIds, 6)), { VertexSource(newIds[5]) }).Distances;
  for (std::size_t v = 0; v < base.size(); ++v)
  {
    EXPECT_NEAR(renumbered[newIds[v]], base[v], 1e-9);
  }
}

TEST(FastMarching, MaximumDistance)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.2, 9));
  const auto whole = March(mesh, { VertexSource(5, 0.5) }).Distances;
  for (const double limit : { 0.0, 0.5, 1.0, 2.5 })
  {
    const dgg::MarchingResult cut = March(mesh, { VertexSource(5, 0.5) },
      [&](dgg::MarchingOptions& options) { options.MaximumDistance = limit; });
    for (std::size_t v = 0; v < whole.size(); ++v)
    {
      EXPECT_EQ(cut.Distances[v], whole[v] <= limit ? whole[v] : dgg::Infinity);
      EXPECT_EQ(cut.NearestSource[v], whole[v] <= limit ? 0 : dgg::NoId);
    }
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
