// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Closed geodesics: where their lengths are known, and that they are geodesics everywhere else.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "PathChecks.h"

#include "dggLoopFinder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace dggtest
{
namespace
{
using dgg::FoundLoop;
using dgg::SurfacePath;
using dgg::SurfacePoint;

/// A mesh, its graph, and loops on it.
class LoopWorld
{
public:
  explicit LoopWorld(const TestMesh& mesh, double accuracy = 0.02)
    : Mesh(Build(mesh))
    , Builder(Mesh)
  {
    dgg::GraphOptions options;
    options.Accuracy = accuracy;
    const dgg::Status status = this->Builder.Build(options, this->Graph);
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
    this->Search = std::make_unique<dgg::GraphSearch>(this->Graph.View(), &this->Mesh);
    this->Finder =
      std::make_unique<dgg::LoopFinder>(this->Mesh, *this->Search, &this->Builder, nullptr);
  }

  FoundLoop ThroughPoint(const SurfacePoint& point, bool taut = false) const
  {
    FoundLoop loop;
    this->Expect(this->Finder->ThroughPoint(point, taut, loop), loop);
    return loop;
  }

  FoundLoop Rope(const std::vector<SurfacePoint>& points, bool taut) const
  {
    FoundLoop loop;
    this->Expect(this->Finder->Rope(points, taut, loop), loop);
    return loop;
  }

  std::vector<FoundLoop> AroundHandles(Id base = 0) const
  {
    std::vector<FoundLoop> loops;
    const dgg::Status status = this->Finder->AroundHandles(base, loops);
    for (const FoundLoop& loop : loops)
    {
      this->Expect(status, loop);
    }
    return loops;
  }

  dgg::SurfaceMesh Mesh;
  dgg::GraphBuilder Builder;
  dgg::GeodesicGraph Graph;
  std::unique_ptr<dgg::GraphSearch> Search;
  std::unique_ptr<dgg::LoopFinder> Finder;

private:
  /// A closed path on the surface.
  void Expect(const dgg::Status& status, const FoundLoop& loop) const
  {
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();
    const dgg::Status path = dgg::CheckPath(this->Mesh, loop.Loop);
    EXPECT_TRUE(path.IsOk()) << path.GetMessage();
    if (!loop.Loop.IsEmpty())
    {
      const SurfacePoint& first = loop.Loop.Points.front();
      const SurfacePoint& last = loop.Loop.Points.back();
      EXPECT_EQ(first.On, last.On);
      EXPECT_EQ(first.Vertex, last.Vertex);
      EXPECT_GT(loop.Loop.Length, 0.0);
      EXPECT_LE(loop.Angle, dgg::Pi);
    }
  }
};

SurfacePoint At(Id vertex)
{
  return SurfacePoint::AtVertex(vertex);
}
}

TEST(LoopFinder, AroundAPrism)
{
  for (const double jitter : { 0.0, 0.2 })
  {
    const Id sides = 7;
    const LoopWorld world(PrismSide(sides, 3, 8, jitter, 4));
    const Id around = 3 * sides;
    // Through any point the loop is closed, and as long as the prism is around.
    for (const SurfacePoint& point :
      { At(4 * around + 5), SurfacePoint::InFace(world.Mesh, 150, { { 0.3, 0.5, 0.2 } }),
        SurfacePoint::OnEdge(world.Mesh, 301, 0.3) })
    {
      for (const bool taut : { false, true })
      {
        const FoundLoop loop = world.ThroughPoint(point, taut);
        EXPECT_NEAR(loop.Loop.Length, sides, 1e-10);
        EXPECT_NEAR(loop.Angle, dgg::Pi, 1e-6);
      }
    }
    const std::vector<FoundLoop> handles = world.AroundHandles();
    ASSERT_EQ(handles.size(), 1u);
    EXPECT_NEAR(handles[0].Loop.Length, sides, 1e-10);
    const FoundLoop slack =
      world.Rope({ At(around), At(5 * around + 7), At(2 * around + 14) }, false);
    EXPECT_GT(slack.Loop.Length, sides + 0.1);
    const FoundLoop rope =
      world.Rope({ At(around), At(5 * around + 7), At(2 * around + 14) }, true);
    EXPECT_NEAR(rope.Loop.Length, sides, 1e-10);
  }
}

TEST(LoopFinder, OnTheTorus)
{
  const Id nu = 30;
  const Id nv = 14;
  const LoopWorld world(Torus(nu, nv));
  // Around the tube: between the vertices, where the section of the tube is narrowest.
  double tube = 0.0;
  for (Id j = 0; j < nv; ++j)
  {
    const double a = 2.0 * dgg::Pi * j / nv;
    const double b = 2.0 * dgg::Pi * (j + 1) / nv;
    tube += std::hypot(0.4 * (std::cos(b) - std::cos(a)) * std::cos(dgg::Pi / nu),
      0.4 * (std::sin(b) - std::sin(a)));
  }
  // Along the edges around the hole.
  const double hole = nu * 2.0 * 0.6 * std::sin(dgg::Pi / nu);
  for (const Id base : { 0, 100, 310 })
  {
    const std::vector<FoundLoop> loops = world.AroundHandles(base);
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_NEAR(loops[0].Loop.Length, tube, 1e-9);
    EXPECT_NEAR(loops[1].Loop.Length, hole, 1e-9);
    EXPECT_EQ(loops[0].Angle, dgg::Pi);
  }
  for (const Id v : { 0, 5, 33, 207 })
  {
    const FoundLoop kinked = world.ThroughPoint(At(v));
    EXPECT_GE(kinked.Loop.Length, tube - 1e-9);
    EXPECT_LE(kinked.Loop.Length, 1.02 * tube);
    const FoundLoop taut = world.ThroughPoint(At(v), true);
    EXPECT_NEAR(taut.Loop.Length, tube, 1e-9);
  }
}

TEST(LoopFinder, OnFlatTori)
{
  const double ux = 3.0;
  const double vx = 0.7;
  const double vy = 2.0;
  const LoopWorld world(FlatTorus(ux, vx, vy, 9, 7, false));
  const double shortest = std::hypot(vx, vy);
  const std::vector<FoundLoop> loops = world.AroundHandles(3);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_NEAR(loops[0].Loop.Length, shortest, 1e-10);
  EXPECT_NEAR(loops[1].Loop.Length, ux, 1e-10);
  EXPECT_NEAR(world.ThroughPoint(At(11)).Loop.Length, shortest, 1e-10);
  EXPECT_NEAR(world.ThroughPoint(At(11), true).Loop.Length, shortest, 1e-10);
}

TEST(LoopFinder, OneSidedSurfaces)
{
  // Along the middle of a Moebius strip, and twice around along any other line.
  const LoopWorld strip(MoebiusStrip(12, 4));
  const std::vector<FoundLoop> loops = strip.AroundHandles();
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(loops[0].Loop.Length, 12.0, 1e-10);
  const LoopWorld bottle(KleinBottle(9, 6));
  const std::vector<FoundLoop> both = bottle.AroundHandles(5);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NEAR(both[0].Loop.Length, 6.0, 1e-10);
  EXPECT_NEAR(both[1].Loop.Length, 9.0, 1e-10);
}

TEST(LoopFinder, AsManyAsThereAreHandles)
{
  const LoopWorld block(TwoHoledBlock());
  EXPECT_EQ(block.AroundHandles().size(), 4u);
  const LoopWorld sphere(Icosphere(2));
  EXPECT_TRUE(sphere.AroundHandles().empty());
  const LoopWorld plane(Plane(5, 5));
  EXPECT_TRUE(plane.AroundHandles().empty());
  EXPECT_TRUE(plane.ThroughPoint(At(12)).Loop.IsEmpty());
  EXPECT_TRUE(plane.ThroughPoint(At(12), true).Loop.IsEmpty());
}

TEST(LoopFinder, GeodesicsOnSoundMeshes)
{
  int found = 0;
  for (const NamedMesh& named : SoundMeshes())
  {
    SCOPED_TRACE(named.Name);
    const LoopWorld world(named.Mesh);
    if (world.Mesh.GetNumberOfVertices() > 600)
    {
      continue;
    }
    for (const FoundLoop& loop : world.AroundHandles())
    {
      ExpectLocallyShortest(world.Mesh, loop.Loop, true);
      ++found;
    }
    for (const SurfacePoint& point : RandomSurfacePoints(world.Mesh, 2, 7))
    {
      const FoundLoop kinked = world.ThroughPoint(point);
      const FoundLoop taut = world.ThroughPoint(point, true);
      if (!kinked.Loop.IsEmpty())
      {
        ExpectLocallyShortest(world.Mesh, kinked.Loop);
        ++found;
      }
      if (!taut.Loop.IsEmpty())
      {
        SCOPED_TRACE("taut");
        ExpectLocallyShortest(world.Mesh, taut.Loop, true);
      }
    }
  }
  EXPECT_GT(found, 20);
}

/// Whatever comes in, no loop leaves the surface.
TEST(LoopFinder, DefectMeshes)
{
  for (const NamedMesh& named : DefectMeshes())
  {
    SCOPED_TRACE(named.Name);
    const LoopWorld world(named.Mesh, 0.05);
    for (const Id v : SomeVertices(world.Mesh, 3, 5))
    {
      world.ThroughPoint(At(v));
      world.ThroughPoint(At(v), true);
      world.Rope({ At(v), At(0), At(world.Mesh.GetNumberOfVertices() / 2) }, true);
      std::vector<FoundLoop> loops;
      const dgg::Status status = world.Finder->AroundHandles(v, loops);
      if (!status.IsOk())
      {
        EXPECT_NE(status.GetMessage().find("more than two triangles"), std::string::npos);
        EXPECT_TRUE(loops.empty());
      }
    }
  }
}

TEST(LoopFinder, Ropes)
{
  const LoopWorld world(Icosphere(3));
  // A rope on a sphere slips off, or stays around it.
  EXPECT_TRUE(world.Rope({ At(12), At(20), At(31) }, true).Loop.IsEmpty());
  // Through points it stays.
  const FoundLoop slack = world.Rope({ At(12), At(20), At(31) }, false);
  EXPECT_LT(slack.Angle, 3.0);
  EXPECT_GT(slack.Loop.Length, 0.5);
  // There and back.
  const FoundLoop twice = world.Rope({ At(12), At(20) }, false);
  EXPECT_LT(twice.Angle, 0.2);
  EXPECT_TRUE(world.Rope({ At(12), At(20) }, true).Loop.IsEmpty());
  // One point is no rope.
  EXPECT_TRUE(world.Rope({ At(12) }, false).Loop.IsEmpty());
  FoundLoop loop;
  EXPECT_FALSE(world.Finder->Rope({}, true, loop).IsOk());
  EXPECT_FALSE(world.Finder->Rope({ At(0), At(100000) }, true, loop).IsOk());
  const LoopWorld several(SeveralComponents());
  EXPECT_TRUE(
    several.Rope({ At(0), At(several.Mesh.GetNumberOfVertices() - 1) }, true).Loop.IsEmpty());
}
}
