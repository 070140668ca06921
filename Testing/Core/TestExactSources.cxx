// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Sources at vertices, on edges and in faces, multiple sources with initial distances, and cases in
// which rules of window propagation matter: each case fails without the rule that it tests.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggSurfacePath.h"

namespace dggtest
{
namespace
{
/// Returns meshes of different kinds, for tests without reference distances.
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
  // Compares a source inside a face or an edge with the same point inserted as a vertex, and the
  // distance to a target with the distance to that vertex.
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
        // The refined mesh has the corners in the order of the input.
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

TEST_P(ExactSources, OffsetsShiftTheField)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.3, 3));
  for (const auto& point :
    { dgg::SurfacePoint::AtVertex(7), dgg::SurfacePoint::InFace(mesh, 5, { { 0.3, 0.3, 0.4 } }) })
  {
    std::vector<double> expected = Solve(mesh, this->Engine(), { { point, 0.0 } }).Distances;
    for (const double offset : { 0.5, -0.5, 100.0, -100.0 })
    {
      // The smallest initial distance of a point is used.
      const auto distances = Solve(mesh, this->Engine(),
        { { point, offset + 0.4 }, { point, offset },
          { point,
            offset + 0.2 } }).Distances;
      std::vector<double> shifted = expected;
      for (double& d : shifted)
      {
        d += offset;
      }
      ExpectSameField(shifted, distances, 1e-12 * (std::abs(offset) + 3.0), "field");
    }
  }
}

TEST_P(ExactSources, OnSeamsWithoutArea)
{
  // A triangle, and a strip of two degenerate triangles along one of its edges. A source on any
  // edge of the strip is within tolerance of that edge and hence lies on the edge.
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

class ExactTraps : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactTraps);

// Only the nearest of the windows that illuminate an apex needs both children. The rule does not
// hold if the nearest window comes from a source inside a face, which may lie within the cone of
// the other window.
TEST_P(ExactTraps, OneChildRuleNeedsAVertexAsRoot)
{
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    const TestMesh input = Plane(7, 7, 0.29, seed);
    const dgg::SurfaceMesh mesh = Build(input);
    const auto points = RandomSurfacePoints(mesh, 2, seed);
    const std::array<double, 3> places[] = { dgg::PositionOf(mesh, points[0], input.Points.data()),
      dgg::PositionOf(mesh, points[1], input.Points.data()) };
    // The second source starts slightly before the first wavefront arrives. It is nearest in a
    // narrow strip behind itself, and the first source is nearest on both sides of the strip.
    const double between = std::hypot(places[0][0] - places[1][0], places[0][1] - places[1][1]);
    for (const double lead : { 0.3, 0.1, 0.03, 0.01 })
    {
      const double offset = (1.0 - lead) * between;
      const auto distances =
        Solve(mesh, this->Engine(), { { points[0], 0.0 }, { points[1], offset } }).Distances;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const double* p = input.Point(v);
        const double truth = std::min(std::hypot(p[0] - places[0][0], p[1] - places[0][1]),
          offset + std::hypot(p[0] - places[1][0], p[1] - places[1][1]));
        worst = std::max(worst, std::abs(distances[v] - truth) / truth);
      }
    }
  }
  EXPECT_LE(worst, 1e-12);
}

// On an edge with three faces the windows come from different sides: one table of winners for all
// sides is wrong. Any two pages of a book unfold to a plane.
TEST_P(ExactTraps, SheetsOfABookArePlanes)
{
  for (const Id sheets : { 3, 5 })
  {
    for (const double jitter : { 0.0, 0.25 })
    {
      std::vector<Id> sheetOf;
      const TestMesh input = Book(sheets, 5, sheetOf, jitter, 3);
      auto place = [&](Id v) { // distance from the spine, and position along the spine
        return std::array<double, 2>{ { std::hypot(input.Point(v)[0], input.Point(v)[2]),
          input.Point(v)[1] } };
      };
      ExpectAllPairs(Build(input), this->Engine(), [&](Id a, Id b) {
        const auto p = place(a);
        const auto q = place(b);
        const bool same = sheetOf[a] == sheetOf[b];
        return std::hypot(same ? p[0] - q[0] : p[0] + q[0], p[1] - q[1]);
      });
    }
  }
}

// Sources on two pages compete on the third page. One source may lie within the cone of the other
// one when the pages are folded together, although the window of that cone never passed there.
TEST_P(ExactTraps, SheetsOfABookCompete)
{
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    std::vector<Id> sheetOf;
    const TestMesh input = Book(3, 6, sheetOf, 0.25, seed);
    const dgg::SurfaceMesh mesh = Build(input);
    auto away = [&](Id v) { return std::hypot(input.Point(v)[0], input.Point(v)[2]); };
    auto between = [&](Id a, Id b) {
      const double x = sheetOf[a] == sheetOf[b] ? away(a) - away(b) : away(a) + away(b);
      return std::hypot(x, input.Point(a)[1] - input.Point(b)[1]);
    };
    std::array<std::vector<Id>, 3> sheets;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      // On the third page only vertices close to the spine.
      if (sheetOf[v] >= 0 && (sheetOf[v] < 2 || away(v) < 1.5))
      {
        sheets[sheetOf[v]].push_back(v);
      }
    }
    Random random(seed);
    auto pick = [&](const std::vector<Id>& ids) {
      return ids[random.Index(static_cast<Id>(ids.size()))];
    };
    for (int trial = 0; trial < 4000; ++trial)
    {
      const Id far = pick(sheets[0]);
      const Id near = pick(sheets[1]);
      const Id prize = pick(sheets[2]);
      // The near source is nearest at the vertex `prize` by a small margin, and in a narrow strip
      // around this vertex. With the pages folded together the near source lies almost on the path
      // of the far source.
      const double offset =
        between(far, prize) - between(near, prize) - random.Uniform(0.0001, 0.02);
      const double folded =
        std::hypot(away(far) - away(near), input.Point(far)[1] - input.Point(near)[1]);
      if (away(near) > 0.8 * away(far) || offset < 0.9 * folded)
      {
        continue;
      }
      const auto distances =
        Solve(mesh, this->Engine(), { VertexSource(far), VertexSource(near, offset) }).Distances;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const double truth = std::min(between(far, v), offset + between(near, v));
        worst = std::max(worst, std::abs(distances[v] - truth)); // distances are a few edges long
      }
    }
  }
  EXPECT_LE(worst, 1e-12);
}
}
