// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Radius limit, early exit at targets, reuse of a solver; parts of the exact engines.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggWindowEnvelope.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace dggtest
{
namespace
{
std::vector<NamedMesh> LimitMeshes()
{
  return { { "sphere", NoisySphere(3, 0.3, 3) }, { "terrain", Terrain(14, 2.0, 5) },
    { "grid", Plane(14, 14) }, { "ellipsoid", Ellipsoid(2, 20.0) },
    { "components", SeveralComponents() }, { "one triangle", SingleTriangle() } };
}
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
              continue; // on the limit itself rounding decides
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
      // What is reported for the vertices is final as well.
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
  // Images over one half-edge, those of later windows anywhere before the others.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<dgg::Window> windows(300);
  for (dgg::Window& w : windows)
  {
    w.Root = static_cast<Id>(&w - windows.data());
    w.Image = { 3.0 * unit(random) - 1.0, -0.1 - unit(random) };
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
  // A strip with one side, a million times as long as high: windows run around it again and again.
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
