// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Predecessors, radius limit, early exit at targets, reuse of a solver; components of the exact
// engines.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggWindowEnvelope.h"

namespace dggtest
{
namespace
{
/// Follows the roots from v to a source and checks the length of each straight piece. Returns the
/// index of the source.
Id FollowRoots(const dgg::SurfaceMesh& mesh, const std::vector<dgg::GeodesicSource>& sources,
  const dgg::ExactResult& result, Id v)
{
  for (Id steps = 0; steps <= mesh.GetNumberOfVertices(); ++steps)
  {
    const dgg::Predecessor& p = result.Predecessors[v];
    const double scale = result.Distances[v];
    // Length of the last straight piece.
    double piece = 0.0;
    if (p.HalfEdge != dgg::NoId)
    {
      EXPECT_EQ(mesh.Apex(p.HalfEdge), v);
      EXPECT_LT(p.ImageY, 0.0);
      piece = std::hypot(mesh.ApexX(p.HalfEdge) - p.ImageX, mesh.ApexY(p.HalfEdge) - p.ImageY);
      // Parameter at which the piece crosses the half-edge.
      const double t = -p.ImageY / (mesh.ApexY(p.HalfEdge) - p.ImageY);
      const double x = p.ImageX + t * (mesh.ApexX(p.HalfEdge) - p.ImageX);
      EXPECT_GE(x, -1e-9 * mesh.Length(p.HalfEdge));
      EXPECT_LE(x, (1.0 + 1e-9) * mesh.Length(p.HalfEdge));
    }
    else if (p.Root >= 0 && p.Root != v)
    {
      piece = dgg::Infinity; // along a mesh edge
      for (const Id* h = mesh.FanBegin(v); h != mesh.FanEnd(v); ++h)
      {
        const Id incoming = dgg::SurfaceMesh::Previous(*h);
        if (mesh.Destination(*h) == p.Root)
        {
          piece = std::min(piece, mesh.Length(*h));
        }
        if (mesh.Origin(incoming) == p.Root)
        {
          piece = std::min(piece, mesh.Length(incoming));
        }
      }
    }
    if (p.Root < 0)
    {
      const Id k = ~p.Root;
      EXPECT_GE(k, 0);
      EXPECT_LT(k, static_cast<Id>(sources.size()));
      if (p.HalfEdge == dgg::NoId)
      {
        // The source lies in a face of v.
        double straight = dgg::Infinity;
        const dgg::SurfacePoint& point = sources[k].Point;
        for (int c = 0; c < 3; ++c)
        {
          if (mesh.Origin(3 * point.Face + c) == v)
          {
            straight = dgg::DistanceToCorner(mesh, point.Face, point.Barycentric, c);
          }
        }
        piece = straight < dgg::Infinity ? straight : scale - sources[k].InitialDistance;
      }
      EXPECT_NEAR(scale, sources[k].InitialDistance + piece, 1e-12 * (scale + 1.0));
      return k;
    }
    if (p.Root == v)
    {
      const Id k = result.NearestSource[v];
      EXPECT_EQ(sources[k].Point.Vertex, v);
      EXPECT_EQ(scale, sources[k].InitialDistance);
      return k;
    }
    EXPECT_NEAR(scale, result.Distances[p.Root] + piece, 1e-11 * (scale + 1.0)) << v;
    EXPECT_EQ(result.NearestSource[v], result.NearestSource[p.Root]);
    v = p.Root;
  }
  ADD_FAILURE() << "the roots form a cycle";
  return dgg::NoId;
}

std::vector<NamedMesh> LimitMeshes()
{
  return { { "sphere", NoisySphere(3, 0.3, 3) }, { "terrain", Terrain(14, 2.0, 5) },
    { "grid", Plane(14, 14) }, { "ellipsoid", Ellipsoid(2, 20.0) },
    { "components", SeveralComponents() }, { "one triangle", SingleTriangle() } };
}
}

class ExactResults : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactResults);

TEST_P(ExactResults, RootsLeadToTheNearestSource)
{
  std::vector<Id> sheetOf;
  for (const TestMesh& input : { NoisySphere(2, 0.4, 3), Cube(4), Plane(8, 8), Terrain(10, 2.0, 4),
         Plate(
           8, 8, [](Id i, Id j) { return i < 3 || j < 3; }, 0.2),
         SeveralComponents(), WithNoise(Book(3, 4, sheetOf, 0.2, 2), 0.1, 3), MoebiusStrip(9, 4),
         Ellipsoid(2, 20.0) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    const auto points = RandomSurfacePoints(mesh, 3, 5);
    const std::vector<dgg::GeodesicSource> sources{ VertexSource(0, 0.1), { points[0], 0.0 },
      { points[1], 0.2 }, VertexSource(mesh.GetNumberOfVertices() - 1) };
    for (const auto& chosen : { std::vector<dgg::GeodesicSource>{ sources[0] },
           std::vector<dgg::GeodesicSource>{ sources[1] }, sources })
    {
      const dgg::ExactResult result = Solve(mesh, this->Engine(), chosen);
      ASSERT_EQ(static_cast<Id>(result.Predecessors.size()), mesh.GetNumberOfVertices());
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        if (result.Distances[v] < dgg::Infinity)
        {
          EXPECT_EQ(FollowRoots(mesh, chosen, result, v), result.NearestSource[v]) << v;
        }
        else
        {
          EXPECT_EQ(result.Predecessors[v].Root, dgg::NoId);
        }
      }
    }
  }
}

TEST_P(ExactResults, RootsAreWherePathsBend)
{
  // In an L, all paths to the far arm bend at the reflex corner.
  const TestMesh input = Plate(
    6, 6, [](Id i, Id j) { return i < 2 || j < 2; }, 0.2, 3);
  const dgg::SurfaceMesh mesh = Build(input);
  const Id corner = VertexAt(input, 2.0, 2.0, 0.0);
  const Id source = VertexAt(input, 6.0, 0.0, 0.0);
  const dgg::ExactResult result = Solve(mesh, this->Engine(), { VertexSource(source) });
  const Id far = VertexAt(input, 0.0, 6.0, 0.0);
  Id v = far;
  bool bends = false;
  while (result.Predecessors[v].Root != v)
  {
    v = result.Predecessors[v].Root;
    bends = bends || v == corner;
  }
  EXPECT_TRUE(bends);
  EXPECT_EQ(v, source);
}

class ExactLimits : public EngineTest
{
};
DGG_WITH_BOTH_ENGINES(ExactLimits);

TEST_P(ExactLimits, RadiusCutsTheFullField)
{
  for (const NamedMesh& named : LimitMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const auto point = dgg::SurfacePoint::InFace(mesh, 0, { { 0.2, 0.3, 0.5 } });
    const auto targets = RandomSurfacePoints(mesh, 10, 3);
    for (const dgg::GeodesicSource& source :
      { VertexSource(0), VertexSource(0, 0.7), dgg::GeodesicSource{ point, -0.3 } })
    {
      auto want = [&](dgg::ExactOptions& options) { options.Targets = targets; };
      const dgg::ExactResult full = Solve(mesh, this->Engine(), { source }, want);
      const double diameter = LargestFinite(full.Distances);
      for (const double fraction : { -1.0, 0.0, 0.01, 0.2, 0.5, 0.9, 1.1 })
      {
        const double radius = fraction * diameter;
        const dgg::ExactResult cut =
          Solve(mesh, this->Engine(), { source }, [&](dgg::ExactOptions& options) {
            options.Targets = targets;
            options.MaximumDistance = radius;
          });
        auto expectCut = [&](const std::vector<double>& whole, const std::vector<double>& part) {
          for (std::size_t i = 0; i < whole.size(); ++i)
          {
            if (std::abs(whole[i] - radius) <= 1e-11 * diameter)
            {
              continue; // at the limit itself, rounding errors decide
            }
            if (whole[i] > radius)
            {
              EXPECT_EQ(part[i], dgg::Infinity) << i << " at " << whole[i] << " of " << radius;
            }
            else
            {
              EXPECT_NEAR(part[i], whole[i], 1e-12 * diameter) << i;
            }
          }
        };
        expectCut(full.Distances, cut.Distances);
        expectCut(full.TargetDistances, cut.TargetDistances);
        for (std::size_t v = 0; v < cut.Distances.size(); ++v)
        {
          const bool reached = cut.Distances[v] < dgg::Infinity;
          EXPECT_EQ(cut.NearestSource[v], reached ? 0 : dgg::NoId);
        }
      }
    }
  }
}

TEST_P(ExactLimits, RadiusIncludesTheLimit)
{
  const dgg::SurfaceMesh mesh = Build(Plane(4, 4));
  const auto distances =
    Solve(mesh, this->Engine(), { VertexSource(0) }, [](dgg::ExactOptions& options) {
      options.MaximumDistance = 2.0;
    }).Distances;
  EXPECT_EQ(distances[2], 2.0);
  EXPECT_EQ(distances[3], dgg::Infinity);
  EXPECT_EQ(distances[7], dgg::Infinity); // (2,1)
}

TEST_P(ExactLimits, EarlyExitGivesTheFullAnswer)
{
  for (const NamedMesh& named : LimitMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    auto candidates = RandomSurfacePoints(mesh, 6, 3);
    for (const Id v : SomeVertices(mesh, 5, 4))
    {
      candidates.push_back(dgg::SurfacePoint::AtVertex(v));
    }
    const auto source = dgg::SurfacePoint::InFace(mesh, 0, { { 0.2, 0.3, 0.5 } });
    for (const std::size_t count : { std::size_t(1), std::size_t(3), candidates.size() })
    {
      const std::vector<dgg::SurfacePoint> targets(candidates.end() - count, candidates.end());
      auto run = [&](bool stop) {
        return Solve(mesh, this->Engine(), { { source, 0.5 } }, [&](dgg::ExactOptions& options) {
          options.Targets = targets;
          options.StopAtTargets = stop;
        });
      };
      const dgg::ExactResult full = run(false);
      const dgg::ExactResult early = run(true);
      const double tolerance = 1e-12 * LargestFinite(full.Distances);
      ExpectSameField(full.TargetDistances, early.TargetDistances, tolerance, "targets");
      EXPECT_EQ(full.TargetNearestSource, early.TargetNearestSource);
      // Distances reported at vertices are final as well.
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        if (early.Distances[v] < dgg::Infinity)
        {
          EXPECT_NEAR(early.Distances[v], full.Distances[v], tolerance) << v;
        }
      }
    }
  }
}

TEST_P(ExactLimits, ReuseChangesNothing)
{
  for (const NamedMesh& named : LimitMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    dgg::ExactGeodesics solver(mesh);
    const auto points = RandomSurfacePoints(mesh, 3, 8);
    std::vector<dgg::ExactOptions> runs(5);
    runs[1].MaximumDistance = mesh.GetMeanEdgeLength();
    runs[2].Targets = points;
    runs[2].StopAtTargets = true;
    runs[3].Engine = this->Engine() == dgg::ExactEngine::Triangle ? dgg::ExactEngine::Reference
                                                                  : dgg::ExactEngine::Triangle;
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
      if (i != 3)
      {
        runs[i].Engine = this->Engine();
      }
      const std::vector<dgg::GeodesicSource> sources{ { points[i % 3], 0.1 },
        VertexSource(0, 0.2) };
      dgg::ExactResult reused;
      ASSERT_TRUE(solver.Run(sources, runs[i], reused).IsOk());
      dgg::ExactGeodesics fresh(mesh);
      dgg::ExactResult expected;
      ASSERT_TRUE(fresh.Run(sources, runs[i], expected).IsOk());
      EXPECT_EQ(reused.Distances, expected.Distances);
      EXPECT_EQ(reused.NearestSource, expected.NearestSource);
      EXPECT_EQ(reused.TargetDistances, expected.TargetDistances);
      EXPECT_EQ(reused.NumberOfWindows, expected.NumberOfWindows);
      ASSERT_EQ(reused.Predecessors.size(), expected.Predecessors.size());
      for (std::size_t v = 0; v < reused.Predecessors.size(); ++v)
      {
        EXPECT_EQ(reused.Predecessors[v].Root, expected.Predecessors[v].Root);
        EXPECT_EQ(reused.Predecessors[v].HalfEdge, expected.Predecessors[v].HalfEdge);
      }
    }
  }
}

TEST(WindowEnvelope, IsTheLeastOfWindowsInAnyOrder)
{
  // Images over one half-edge; later windows start anywhere relative to earlier ones.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<dgg::Window> windows(300);
  for (dgg::Window& w : windows)
  {
    w.Root = static_cast<Id>(&w - windows.data());
    w.Image = { 3.0 * unit(random) - 1.0, -0.1 - unit(random) };
    w.Sigma = w.Root % 2 == 0 ? 0.0 : 0.2 * unit(random); // ties on lines and on hyperbolas
    const double begin = 0.9 * unit(random);
    w.SetInterval(begin, begin + (1.0 - begin) * unit(random));
  }
  const auto envelope = dgg::MakeEnvelope(windows.data(), windows.data() + windows.size(), 1.0);
  EXPECT_TRUE(std::is_sorted(envelope.begin(), envelope.end(),
    [](const dgg::Window& a, const dgg::Window& b) { return a.End < b.End; }));
  for (int k = 0; k < 1000; ++k)
  {
    const double x = unit(random);
    auto leastOf = [&](const std::vector<dgg::Window>& list) {
      double least = dgg::Infinity;
      for (const dgg::Window& w : list)
      {
        least = x >= w.Begin && x <= w.End ? std::min(least, w.DistanceAt(x)) : least;
      }
      return least;
    };
    const double expected = leastOf(windows);
    const double found = leastOf(envelope);
    EXPECT_TRUE(found == expected || std::abs(found - expected) < 1e-12) << x;
  }
  dgg::WindowList scratch;
  dgg::WindowList list = envelope;
  dgg::Window wide;
  wide.Image = { 0.5, -10.0 };
  wide.SetInterval(0.0, 1.0);
  EXPECT_FALSE(dgg::InsertIntoEnvelope(list, wide, 1.0, scratch, 3));
  EXPECT_EQ(list.size(), envelope.size());
}

TEST(WindowPropagation, EndsWhereStretchedTrianglesMultiplyWindows)
{
  // A one-sided strip, a million times as long as high, around which windows run again and again.
  TestMesh mesh;
  constexpr Id columns = 600;
  constexpr Id rows = 3;
  for (Id i = 0; i < columns; ++i)
  {
    const double angle = 2.0 * dgg::Pi * i / columns;
    for (Id j = 0; j <= rows; ++j)
    {
      const double across = 0.3 * (static_cast<double>(j) / rows - 0.5);
      const double radius = 1.0 + across * std::cos(0.5 * angle);
      mesh.AddPoint(
        radius * std::cos(angle), 1e6 * radius * std::sin(angle), across * std::sin(0.5 * angle));
    }
  }
  auto at = [&](Id i, Id j) { return i < columns ? i * (rows + 1) + j : rows - j; };
  for (Id i = 0; i < columns; ++i)
  {
    for (Id j = 0; j < rows; ++j)
    {
      mesh.AddQuad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  const dgg::SurfaceMesh surface = Build(mesh);
  dgg::ExactGeodesics solver(surface);
  dgg::ExactResult result;
  const dgg::Status status = solver.Run({ VertexSource(500) }, {}, result);
  EXPECT_TRUE(Says(status, "long triangles of little area"));
  EXPECT_TRUE(result.Distances.empty());
}
}
