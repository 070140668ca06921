// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Sources of every kind, several at once, with initial distances; what is said of the nearest one.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
/// Meshes of different kinds, for tests that need no truth.
std::vector<NamedMesh> Zoo()
{
  std::vector<Id> sheetOf;
  return { { "sphere", NoisySphere(2, 0.3, 3) }, { "torus", WithNoise(Torus(14, 9), 0.06, 4) },
    { "terrain", Terrain(10, 1.5, 5) }, { "grid", Plane(8, 8) }, { "cube", Cube(4) },
    { "components", SeveralComponents() },
    { "book", WithNoise(Book(3, 4, sheetOf, 0.2, 6), 0.1, 7) }, { "Moebius", MoebiusStrip(9, 4) } };
}

std::vector<dgg::GeodesicSource> MixedSources(const dgg::SurfaceMesh& mesh, double spread)
{
  Random random(41);
  std::vector<dgg::GeodesicSource> sources;
  for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 5, 37))
  {
    sources.push_back({ point, random.Uniform(0.0, spread) });
  }
  for (int i = 0; i < 3; ++i)
  {
    sources.push_back(
      VertexSource(random.Index(mesh.GetNumberOfVertices()), random.Uniform(0.0, spread)));
  }
  return sources;
}
}

class ExactSources : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactSources);

TEST_P(ExactSources, SeveralAreThePointwiseMinimum)
{
  const auto expectMinimum = [](const std::vector<std::vector<double>>& single,
                               const std::vector<double>& together,
                               const std::vector<Id>& nearest) {
    std::vector<double> expected(together.size(), dgg::Infinity);
    for (const std::vector<double>& one : single)
    {
      ASSERT_EQ(one.size(), expected.size());
      std::transform(one.begin(), one.end(), expected.begin(), expected.begin(),
        [](double a, double b) { return std::min(a, b); });
    }
    const double tolerance = 1e-10 * LargestFinite(expected);
    ExpectSameField(expected, together, tolerance, "together");
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      ASSERT_EQ(nearest[i] == dgg::NoId, expected[i] == dgg::Infinity);
      if (nearest[i] != dgg::NoId)
      {
        ASSERT_LT(static_cast<std::size_t>(nearest[i]), single.size());
        EXPECT_NEAR(single[nearest[i]][i], expected[i], tolerance) << i;
      }
    }
  };
  for (const NamedMesh& named : Zoo())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const double spread : { 0.0, mesh.GetMeanEdgeLength(), 2.0 * mesh.GetMeanEdgeLength() })
    {
      const auto sources = MixedSources(mesh, spread);
      auto targets = RandomSurfacePoints(mesh, 25, 43);
      targets.push_back(dgg::SurfacePoint::AtVertex(1));
      targets.push_back(sources[0].Point); // a target on a source
      auto want = [&](dgg::ExactOptions& options) { options.Targets = targets; };
      const dgg::ExactResult together = Solve(mesh, this->Engine(), sources, want);
      std::vector<std::vector<double>> fields;
      std::vector<std::vector<double>> atTargets;
      for (const dgg::GeodesicSource& source : sources)
      {
        const dgg::ExactResult single = Solve(mesh, this->Engine(), { source }, want);
        fields.push_back(single.Distances);
        atTargets.push_back(single.TargetDistances);
      }
      expectMinimum(fields, together.Distances, together.NearestSource);
      expectMinimum(atTargets, together.TargetDistances, together.TargetNearestSource);
    }
  }
}

TEST_P(ExactSources, PointsAreAsGoodAsVertices)
{
  // A source inside a face or an edge against the same point inserted as a vertex, and the distance
  // to a target against that to the vertex.
  for (const NamedMesh& named : Zoo())
  {
    if (named.Mesh.Points.empty())
    {
      continue;
    }
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 10, 47))
    {
      TestMesh refined = named.Mesh;
      Id vertex = dgg::NoId;
      const auto triangle = mesh.GetTriangle(point.Face);
      if (point.On == dgg::SurfacePoint::Support::Face)
      {
        // The refined mesh keeps the corners in the order of the input.
        std::array<double, 3> b = point.Barycentric;
        if (mesh.IsFlipped(point.Face))
        {
          std::swap(b[1], b[2]);
        }
        vertex = SplitFace(refined, point.Face, b);
      }
      else
      {
        const Id k = point.HalfEdge % 3;
        vertex =
          SplitEdge(refined, triangle[k], triangle[(k + 1) % 3], point.Barycentric[(k + 1) % 3]);
      }
      auto want = [&](dgg::ExactOptions& options) { options.Targets = { point }; };
      auto expected = DistancesFrom(Build(refined), this->Engine(), vertex);
      expected.resize(mesh.GetNumberOfVertices());
      const double tolerance = 1e-9 * LargestFinite(expected);
      const auto distances = Solve(mesh, this->Engine(), { { point, 0.0 } }).Distances;
      ExpectSameField(expected, distances, tolerance, "as a source");
      for (const Id v : SomeVertices(mesh, 5, 53))
      {
        const dgg::ExactResult result = Solve(mesh, this->Engine(), { VertexSource(v) }, want);
        if (expected[v] == dgg::Infinity)
        {
          EXPECT_EQ(result.TargetDistances[0], dgg::Infinity);
          continue;
        }
        EXPECT_NEAR(result.TargetDistances[0], expected[v], tolerance) << "as a target";
      }
    }
  }
}

TEST_P(ExactSources, OnEdgesAreTheSameFromEachFace)
{
  std::vector<Id> sheetOf;
  for (const TestMesh& input : { NoisySphere(1, 0.3, 3), MisorientedSphere(1, 8),
         WithNoise(Book(3, 3, sheetOf, 0.2, 6), 0.1, 7), MoebiusStrip(7, 4) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); h += 7)
    {
      const auto expected =
        Solve(mesh, this->Engine(), { { dgg::SurfacePoint::OnEdge(mesh, h, 0.3), 0.0 } }).Distances;
      for (Id e = mesh.Twin(h); e != dgg::NoId && e != h; e = mesh.Twin(e))
      {
        const double t = mesh.Origin(e) == mesh.Origin(h) ? 0.3 : 0.7;
        const auto distances =
          Solve(mesh, this->Engine(), { { dgg::SurfacePoint::OnEdge(mesh, e, t), 0.0 } }).Distances;
        ExpectSameField(expected, distances, 1e-10 * LargestFinite(expected), "edge");
      }
    }
  }
}

TEST_P(ExactSources, OnSeamsWithoutArea)
{
  // A triangle and a strip of two triangles without area along one of its edges: as close to that
  // edge as a source on any edge of the strip is, it is on it.
  const std::vector<std::vector<Id>> strips{ { 0, 1, 2, 1, 3, 2 }, { 1, 3, 2, 0, 1, 2 },
    { 0, 1, 3, 0, 3, 2 } };
  for (const double scale : { 1e-3, 1.0, 1e6 })
  {
    for (const std::vector<Id>& strip : strips)
    {
      TestMesh mesh;
      mesh.Points = { 0, 0, 0, 0, 0, 0, 0, scale, 0, 0, scale, 0, scale, 0, 0 };
      mesh.Triangles = strip;
      mesh.AddTriangle(1, 4, 3);
      const dgg::SurfaceMesh surface = Build(mesh);
      for (int i = 1; i < 1000; i += 7)
      {
        for (Id h = 0; h < 6; ++h)
        {
          const double t = 1e-3 * i;
          dgg::GeodesicSource source;
          source.Point = dgg::SurfacePoint::OnEdge(surface, h, t);
          const double from = mesh.Points[3 * surface.Origin(h) + 1];
          const double to = mesh.Points[3 * surface.Destination(h) + 1];
          const double expected = std::hypot(scale, from + t * (to - from));
          const double distance = Solve(surface, this->Engine(), { source }).Distances[4];
          ASSERT_NEAR(distance, expected, 1e-11 * scale) << "edge " << h << " at " << t;
        }
      }
    }
  }
}

TEST_P(ExactSources, OffsetsShiftTheField)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.3, 3));
  const auto plain = DistancesFrom(mesh, this->Engine(), 7);
  for (const double offset : { 0.5, -0.5, 100.0, -100.0 })
  {
    std::vector<double> expected = plain;
    for (double& d : expected)
    {
      d += offset;
    }
    const dgg::ExactResult result = Solve(mesh, this->Engine(), { VertexSource(7, offset) },
      [](dgg::ExactOptions& options) { options.Targets = { dgg::SurfacePoint::AtVertex(3) }; });
    ExpectSameField(expected, result.Distances, 1e-12 * (std::abs(offset) + 3.0), "field");
    EXPECT_NEAR(result.TargetDistances[0], expected[3], 1e-12 * (std::abs(offset) + 3.0));
  }
}

TEST_P(ExactSources, DuplicatesKeepTheSmallestOffset)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.3, 3));
  const auto plain = DistancesFrom(mesh, this->Engine(), 7);
  for (const std::array<double, 3>& offsets :
    std::vector<std::array<double, 3>>{ { 0.4, 0.0, 0.2 }, { 0.4, 0.2, 0.0 }, { 0.0, 0.2, 0.4 } })
  {
    const std::vector<dgg::GeodesicSource> sources{ VertexSource(7, offsets[0]),
      VertexSource(7, offsets[1]), VertexSource(7, offsets[2]) };
    const dgg::ExactResult result = Solve(mesh, this->Engine(), sources);
    ExpectSameField(plain, result.Distances, 0.0, "field");
    for (const Id nearest : result.NearestSource)
    {
      EXPECT_EQ(sources[nearest].InitialDistance, 0.0);
    }
  }
  // Two equal ones inside a face.
  const auto point = dgg::SurfacePoint::InFace(mesh, 5, { { 0.3, 0.3, 0.4 } });
  ExpectSameField(Solve(mesh, this->Engine(), { { point, 0.0 } }).Distances,
    Solve(mesh, this->Engine(), { { point, 0.5 }, { point, 0.0 } }).Distances, 1e-14, "face");
}

}
