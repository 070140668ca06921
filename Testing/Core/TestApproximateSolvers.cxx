// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Common properties of the heat method, fast marching and the propagation of virtual sources:
// accuracy, several sources, virtual sources, robustness, invariances. Fast marching against closed
// forms.
#include "EdgeGraph.h"
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggFastMarching.h"
#include "dggHeatMethod.h"
#include "dggSourcePropagation.h"
#include "dggSurfacePath.h"

namespace dggtest
{
namespace
{
struct Field
{
  std::vector<double> Distances;
  std::vector<Id> NearestSource;
  dgg::VirtualSources Virtual;
};

using Sources = std::vector<dgg::GeodesicSource>;

struct Approximation
{
  std::string Name;
  std::function<Field(const dgg::SurfaceMesh&, const Sources&)> Run;
  bool IsHeat;
  double Rounding; ///< relative rounding error; propagation uses single precision
};

Field March(const dgg::SurfaceMesh& mesh, const Sources& sources, dgg::MarchingUpdate update)
{
  dgg::MarchingOptions options;
  options.Update = update;
  options.WantVirtualSource = true;
  dgg::MarchingResult result;
  EXPECT_TRUE(Ok(dgg::FastMarching(mesh).Run(sources, options, result)));
  return { result.Distances, result.NearestSource, result.Virtual };
}

Field Heat(
  const dgg::SurfaceMesh& mesh, const Sources& sources, dgg::HeatBoundary boundary, bool isDelaunay)
{
  dgg::HeatMethod heat(mesh);
  dgg::HeatOptions options;
  options.Boundary = boundary;
  options.IntrinsicDelaunay = isDelaunay;
  EXPECT_TRUE(Ok(heat.Prepare(options, nullptr)));
  dgg::HeatQuery query;
  query.WantNearestSource = true;
  query.WantVirtualSource = true;
  dgg::HeatResult result;
  EXPECT_TRUE(Ok(heat.Run(sources, query, result)));
  return { result.Distances, result.NearestSource, result.Virtual };
}

Field Propagate(
  const dgg::SurfaceMesh& mesh, const Sources& sources, dgg::PropagationQuality quality)
{
  dgg::PropagationOptions options;
  options.Quality = quality;
  options.WantNearestSource = true;
  options.WantVirtualSource = true;
  dgg::PropagationResult result;
  EXPECT_TRUE(Ok(dgg::SourcePropagation(mesh).Run(sources, options, result)));
  return { result.Distances, result.NearestSource, result.Virtual };
}

std::vector<Approximation> Approximations()
{
  using Mesh = dgg::SurfaceMesh;
  using Boundary = dgg::HeatBoundary;
  using Quality = dgg::PropagationQuality;
  using Update = dgg::MarchingUpdate;
  const auto marching = [](Update update) {
    return [update](const Mesh& mesh, const Sources& s) { return March(mesh, s, update); };
  };
  const auto heat = [](Boundary boundary, bool isDelaunay) {
    return [=](const Mesh& mesh, const Sources& s) { return Heat(mesh, s, boundary, isDelaunay); };
  };
  const auto propagation = [](Quality quality) {
    return [quality](const Mesh& mesh, const Sources& s) { return Propagate(mesh, s, quality); };
  };
  return { { "spherical", marching(Update::Spherical), false, 1e-9 },
    { "planar", marching(Update::Planar), false, 1e-9 },
    { "heat, no flips", heat(Boundary::Neumann, false), true, 1e-9 },
    { "heat, average", heat(Boundary::Average, true), true, 1e-9 },
    { "heat", heat(Boundary::Neumann, true), true, 1e-9 },
    { "propagation", propagation(Quality::Fast), false, 1e-5 },
    { "propagation, high quality", propagation(Quality::High), false, 1e-5 } };
}

/// Returns a plane of nearly equilateral triangles, without obtuse corners up to a jitter of 0.1.
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
}

TEST(ApproximateSolvers, SeveralSourcesWithInitialDistances)
{
  const dgg::SurfaceMesh mesh = Build(Plane(24, 24, 0.1, 5));
  // Source 3 is never the nearest one.
  const Sources sources{ VertexSource(20, -3.0), VertexSource(200, 1.0), VertexSource(580, 0.5),
    VertexSource(201, 9.0), { dgg::SurfacePoint::InFace(mesh, 600, { { 0.2, 0.3, 0.5 } }), 2.0 },
    { dgg::SurfacePoint::OnEdge(mesh, 2200, 0.3), 1.5 }, VertexSource(580, 0.75) };
  const dgg::ExactResult exact = Solve(mesh, dgg::ExactEngine::Triangle, sources);
  for (const Approximation& approximation : Approximations())
  {
    SCOPED_TRACE(approximation.Name);
    const Field field = approximation.Run(mesh, sources);
    const double tolerance = approximation.IsHeat ? 2.0
      : approximation.Name == "planar"            ? 0.6
                                                  : 0.1;
    Id agreeing = 0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      EXPECT_NEAR(field.Distances[v], exact.Distances[v], tolerance) << v;
      EXPECT_NE(field.NearestSource[v], 3) << v;
      agreeing += field.NearestSource[v] == exact.NearestSource[v] ? 1 : 0;
    }
    EXPECT_GT(agreeing, 0.93 * mesh.GetNumberOfVertices());
    EXPECT_EQ(field.Distances[20], -3.0);
  }
}

TEST(ApproximateSolvers, VirtualSourcesInThePlane)
{
  const TestMesh plane = AcutePlane(24, 24, 0.1, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Id source = 12 * 25 + 10;
  for (const Approximation& approximation : Approximations())
  {
    SCOPED_TRACE(approximation.Name);
    const Field field = approximation.Run(mesh, { VertexSource(source, 2.0) });
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const dgg::VirtualSource& image = field.Virtual[v];
      EXPECT_NEAR(image.Offset + image.Length, field.Distances[v], 1e-9) << v;
      if (v == source || approximation.Name == "planar")
      {
        continue;
      }
      EXPECT_NEAR(image.Offset, 2.0, 10.0 * approximation.Rounding) << v;
      // Heat gives only approximate directions, away from the source and from the boundary.
      const double far = EuclideanDistance(plane, source, v);
      if (!approximation.IsHeat || (far > 3.0 && mesh.Kind(v) == dgg::VertexKind::Flat))
      {
        const double turn = std::remainder(
          FanAngle(plane, mesh, v) + image.Angle - DirectionOf(plane, v, source), 2.0 * dgg::Pi);
        EXPECT_LT(std::abs(turn), approximation.IsHeat ? 0.4 : 1e-3) << v;
      }
    }
  }
}

TEST(ApproximateSolvers, CloseToExactOnSoundMeshes)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    // Fronts are inaccurate in triangles of aspect ratio 1:20.
    const bool isLong = named.Name.find("Ellipsoid20") != std::string::npos;
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const auto point = dgg::SurfacePoint::InFace(mesh, 1, { { 0.2, 0.3, 0.5 } });
    for (const dgg::GeodesicSource& source : { VertexSource(0), dgg::GeodesicSource{ point, 0.0 } })
    {
      const auto exact = Solve(mesh, dgg::ExactEngine::Triangle, { source }).Distances;
      for (const Approximation& approximation : Approximations())
      {
        if (approximation.Name != "spherical" && approximation.Name != "heat")
        {
          continue;
        }
        SCOPED_TRACE(named.Name + ", " + approximation.Name);
        const Errors errors = Compare(approximation.Run(mesh, { source }).Distances, exact);
        EXPECT_LT(errors.Mean, approximation.IsHeat ? 0.25 : isLong ? 0.15 : 0.03);
        EXPECT_TRUE(approximation.IsHeat || errors.Largest < (isLong ? 5.0 : 0.3));
      }
    }
  }
}

TEST(ApproximateSolvers, AnyTrianglesWillDo)
{
  for (const NamedMesh& named : DefectMeshesAndSoups(100))
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const Id v : { 0, mesh.GetNumberOfVertices() - 1 })
    {
      const auto bound = EdgeGraphDistances(mesh, { VertexSource(v) });
      const double diameter = LargestFinite(bound);
      for (const Approximation& approximation : Approximations())
      {
        SCOPED_TRACE(named.Name + ", " + approximation.Name);
        const Field field = approximation.Run(mesh, { VertexSource(v) });
        ASSERT_EQ(field.Distances.size(), bound.size());
        for (std::size_t u = 0; u < bound.size(); ++u)
        {
          const bool isReached = bound[u] < dgg::Infinity;
          ASSERT_EQ(field.Distances[u] < dgg::Infinity, isReached) << u;
          ASSERT_EQ(field.NearestSource[u], isReached ? 0 : dgg::NoId) << u;
          ASSERT_GE(field.Distances[u], 0.0); // false for NaN
          ASSERT_LE(field.Distances[u],
            approximation.IsHeat && isReached ? 20.0 * diameter
                                              : bound[u] + approximation.Rounding * diameter);
          ASSERT_TRUE(!isReached || std::isfinite(field.Virtual[u].Angle)) << u;
        }
      }
    }
  }
}

TEST(ApproximateSolvers, Invariance)
{
  const TestMesh input = NoisySphere(3, 0.2, 9);
  for (const Approximation& approximation : Approximations())
  {
    SCOPED_TRACE(approximation.Name);
    const auto run = [&](const TestMesh& mesh, Id source) {
      return approximation.Run(Build(mesh), { VertexSource(source) }).Distances;
    };
    const auto base = run(input, 5);
    for (const double factor : { 1e-60, 1e-6, 1e6, 1e60 })
    {
      const auto scaled = run(Scaled(input, factor), 5);
      for (std::size_t v = 0; v < base.size(); ++v)
      {
        EXPECT_NEAR(scaled[v] / factor, base[v], approximation.Rounding) << factor;
      }
    }
    const auto moved = run(MovedRigidly(input, 1.1, { { 3.0, -2.0, 1.0 } }), 5);
    ExpectSameField(base, moved, approximation.Rounding, "moved");
    const auto newIds = RandomPermutation(input.GetNumberOfVertices(), 4);
    const auto renumbered = run(Renumbered(input, newIds, 6), newIds[5]);
    for (std::size_t v = 0; v < base.size(); ++v)
    {
      EXPECT_NEAR(renumbered[newIds[v]], base[v], approximation.Rounding);
    }
  }
}

// Fast marching against closed forms and exact distances.

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
  EXPECT_TRUE(Ok(dgg::FastMarching(mesh).Run(sources, options, result)));
  return result;
}

void Planar(dgg::MarchingOptions& options)
{
  options.Update = dgg::MarchingUpdate::Planar;
}
/// Returns sources at all vertices of a plane with y = 0.
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
      const bool isExact = isAcute || jitter == 0.0; // approximately exact with obtuse corners
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
    // Fronts are circular beyond the end of the bottom row.
    if (plane.Point(v)[0] < 14.0 - 0.7 * plane.Point(v)[1])
    {
      EXPECT_NEAR(distances[v], plane.Point(v)[1], 1e-12) << v;
    }
  }
}

TEST(FastMarching, ObtuseTrianglesAreSplit)
{
  // Rows of points sheared against each other: corners of 150 degrees.
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
  // Shortest paths behind a slit pass through the tip of the slit.
  std::vector<bool> isLower;
  const TestMesh slit = SlitPlane(8, isLower, 0.1);
  const dgg::SurfaceMesh mesh = Build(slit);
  const Id source = VertexAt(slit, 6.0, 0.0, 0.0);
  const auto exact = DistancesFrom(mesh, dgg::ExactEngine::Triangle, source);
  const Errors errors = Compare(March(mesh, { VertexSource(source) }).Distances, exact);
  EXPECT_LT(errors.Mean, 0.005);
  // Shortest paths behind a saddle of total angle 4 pi pass through its apex.
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
    const auto place = dgg::PositionOf(mesh, point, plane.Points.data());
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const double expected =
        std::hypot(plane.Point(v)[0] - place[0], plane.Point(v)[1] - place[1]);
      // Exact except in triangles that are obtuse as seen from the source.
      EXPECT_NEAR(distances[v], 0.25 + expected, 2e-3) << v;
    }
  }
}

}
