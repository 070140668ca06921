// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Closed geodesics: known lengths where available, and local geodesic checks elsewhere.
#include "GeodesicChecks.h"
#include "LoopWorld.h"
#include "PathChecks.h"
#include "TestMeshes.h"

namespace dggtest
{
namespace
{
using dgg::FoundLoop;
using dgg::SurfacePoint;

/// Returns, modulo 2, how often a closed chain turns around the hole with this center, and how
/// often it crosses the square inside the plate whose sides run around the hole within the bars.
std::array<char, 2> CountCrossings(
  const std::vector<std::array<double, 3>>& points, double x, double y)
{
  constexpr double Off = 0.0123; // offset that avoids all vertices
  std::array<char, 2> counts{ { 0, 0 } };
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const std::array<double, 3>& a = points[i];
    const std::array<double, 3>& b = points[i + 1];
    const auto cross = [&](int axis, double place, int other) {
      const double t = (place - a[axis]) / (b[axis] - a[axis]);
      return a[other] + t * (b[other] - a[other]);
    };
    if ((a[1] > y + Off) != (b[1] > y + Off) && cross(1, y + Off, 0) > x)
    {
      counts[0] ^= 1;
    }
    if ((a[2] > 0.5 + Off) != (b[2] > 0.5 + Off) && std::abs(cross(2, 0.5 + Off, 0) - x) < 1.0 &&
      std::abs(cross(2, 0.5 + Off, 1) - y) < 1.0)
    {
      counts[1] ^= 1;
    }
  }
  return counts;
}

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
    // The loop through any point is closed and as long as the circumference of the prism.
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

/// Paths of coarse graphs have kinks that are as large as those of contractible loops. On this
/// prism, more contractible candidates are shorter than the loop than the finder tries: candidates
/// with small kinks must come first.
TEST(LoopFinder, InCoarseGraphs)
{
  const TestMesh prism = PrismSide(30, 1, 17);
  for (const double accuracy : { 0.1, 0.3, 0.5 })
  {
    SCOPED_TRACE(accuracy);
    const LoopWorld world(prism, accuracy);
    for (const Id v : { 90, 270, 432 })
    {
      EXPECT_NEAR(world.ThroughPoint(At(v)).Loop.Length, 30.0, 1e-9);
    }
  }
}

TEST(LoopFinder, OnTheTorus)
{
  const Id nu = 30;
  const Id nv = 14;
  const LoopWorld world(Torus(nu, nv));
  // Around the tube: between the vertices, at the narrowest section of the tube.
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
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    // The start of the search does not matter.
    const TestMesh torus = Torus(nu, nv);
    const LoopWorld renumbered(
      Renumbered(torus, RandomPermutation(torus.GetNumberOfVertices(), seed), seed));
    const std::vector<FoundLoop> loops = renumbered.AroundHandles();
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
  const std::vector<FoundLoop> loops = world.AroundHandles();
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_NEAR(loops[0].Loop.Length, shortest, 1e-10);
  EXPECT_NEAR(loops[1].Loop.Length, ux, 1e-10);
  EXPECT_NEAR(world.ThroughPoint(At(11)).Loop.Length, shortest, 1e-10);
  EXPECT_NEAR(world.ThroughPoint(At(11), true).Loop.Length, shortest, 1e-10);
}

TEST(LoopFinder, OneSidedSurfaces)
{
  // Along the center line of a Moebius strip, and twice around along any other line.
  const LoopWorld strip(MoebiusStrip(12, 4));
  const std::vector<FoundLoop> loops = strip.AroundHandles();
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(loops[0].Loop.Length, 12.0, 1e-10);
  const LoopWorld bottle(KleinBottle(9, 6));
  const std::vector<FoundLoop> both = bottle.AroundHandles();
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

TEST(LoopFinder, HandlesOfSeveralComponents)
{
  const LoopWorld world(SeveralComponents()); // sphere, torus, plane
  EXPECT_EQ(world.AroundHandles().size(), 2u);
  TestMesh mesh = Torus(12, 8);
  const LoopWorld one(mesh);
  Append(mesh, Scaled(mesh, 0.5));
  Append(mesh, Icosphere(1));
  mesh.AddPoint(0.0, 0.0, 0.0); // isolated
  const std::vector<FoundLoop> expected = one.AroundHandles();
  ASSERT_EQ(expected.size(), 2u);
  const std::vector<FoundLoop> loops = LoopWorld(mesh).AroundHandles();
  ASSERT_EQ(loops.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double scale = i < 2 ? 1.0 : 0.5;
    EXPECT_NEAR(loops[i].Loop.Length, scale * expected[i % 2].Loop.Length, 1e-9);
  }
}

/// Where layers touch in a vertex, loops avoid the vertex if possible.
TEST(LoopFinder, HandlesOfSheetsThatTouch)
{
  TestMesh tori = Torus(12, 8);
  const std::vector<FoundLoop> expected = LoopWorld(tori).AroundHandles();
  ASSERT_EQ(expected.size(), 2u);
  const Id first = tori.GetNumberOfVertices();
  Append(tori, MovedRigidly(tori, 1.0, { { 3.0, 0.0, 0.0 } }));
  // Vertex 0 of one torus replaces the corresponding vertex of the other torus, which becomes
  // unused.
  TestMesh touching = tori;
  std::replace(touching.Triangles.begin(), touching.Triangles.end(), first, 0);
  std::copy(tori.Points.begin(), tori.Points.begin() + 3, touching.Points.begin());
  const LoopWorld world(touching);
  const std::vector<FoundLoop> loops = world.AroundHandles();
  ASSERT_EQ(loops.size(), 4u);
  EXPECT_NEAR(loops[0].Loop.Length, expected[0].Loop.Length, 1e-9);
  for (const FoundLoop& loop : loops)
  {
    EXPECT_FALSE(loop.Loop.IsEmpty());
    ExpectLocallyShortest(world.Mesh, loop.Loop, true);
  }
  // A sphere pinched at one vertex: its only loop would pass through that vertex.
  TestMesh sphere = Icosphere(2);
  std::replace(sphere.Triangles.begin(), sphere.Triangles.end(), 100, 0);
  const std::vector<FoundLoop> pinned = LoopWorld(sphere).AroundHandles();
  ASSERT_EQ(pinned.size(), 1u);
  EXPECT_TRUE(pinned[0].Loop.IsEmpty());
}

/// More handles than a machine word has bits. Loops through a hole and around a hole distinguish
/// independent loops.
TEST(LoopFinder, LoopsOfManyHandlesAreIndependent)
{
  constexpr int Holes = 6; // in each direction
  const TestMesh plate = VoxelSurface(
    2 * Holes + 1, 2 * Holes + 1, 1, [](Id i, Id j, Id) { return i % 2 == 0 || j % 2 == 0; });
  const LoopWorld world(plate, 0.2);
  const std::vector<FoundLoop> loops = world.AroundHandles();
  ASSERT_EQ(loops.size(), 2u * Holes * Holes);
  std::vector<std::vector<char>> rows;
  for (const FoundLoop& loop : loops)
  {
    ASSERT_FALSE(loop.Loop.IsEmpty());
    std::vector<std::array<double, 3>> points;
    for (const SurfacePoint& point : loop.Loop.Points)
    {
      points.push_back(dgg::PositionOf(world.Mesh, point, plate.Points.data()));
    }
    std::vector<char> row;
    for (int i = 0; i < Holes; ++i)
    {
      for (int j = 0; j < Holes; ++j)
      {
        const auto counts = CountCrossings(points, 2.0 * i + 1.5, 2.0 * j + 1.5);
        row.insert(row.end(), counts.begin(), counts.end());
      }
    }
    for (const std::vector<char>& other : rows)
    {
      const auto pivot = std::find(other.begin(), other.end(), 1) - other.begin();
      if (row[pivot])
      {
        std::transform(row.begin(), row.end(), other.begin(), row.begin(),
          [](char a, char b) { return static_cast<char>(a ^ b); });
      }
    }
    EXPECT_NE(std::find(row.begin(), row.end(), 1), row.end());
    rows.push_back(row);
  }
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

/// On any input, all loops lie on the surface.
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
    }
    std::vector<FoundLoop> loops;
    const dgg::Status status = dgg::FindHandleLoops(world.Mesh, {}, loops);
    if (!status.IsOk())
    {
      EXPECT_TRUE(Says(status, "more than two triangles"));
      EXPECT_TRUE(loops.empty());
    }
    for (const FoundLoop& loop : loops)
    {
      EXPECT_TRUE(Ok(dgg::CheckPath(world.Mesh, loop.Loop)));
    }
  }
}

TEST(LoopFinder, Ropes)
{
  const LoopWorld world(Icosphere(3));
  // A rope on a sphere contracts if it may slide off the points.
  EXPECT_TRUE(world.Rope({ At(12), At(20), At(31) }, true).Loop.IsEmpty());
  // A rope fixed at its points remains.
  const FoundLoop slack = world.Rope({ At(12), At(20), At(31) }, false);
  EXPECT_LT(slack.Angle, 3.0);
  EXPECT_GT(slack.Loop.Length, 0.5);
  // From one point to another and back.
  const FoundLoop twice = world.Rope({ At(12), At(20) }, false);
  EXPECT_LT(twice.Angle, 0.2);
  EXPECT_TRUE(world.Rope({ At(12), At(20) }, true).Loop.IsEmpty());
  // A single point yields no rope.
  EXPECT_TRUE(world.Rope({ At(12) }, false).Loop.IsEmpty());
  FoundLoop loop;
  bool isConnected = false;
  EXPECT_FALSE(world.Finder->Rope({}, true, loop, isConnected).IsOk());
  EXPECT_FALSE(world.Finder->Rope({ At(0), At(100000) }, true, loop, isConnected).IsOk());
  EXPECT_TRUE(world.Finder->Rope({ At(12), At(20), At(31) }, true, loop, isConnected).IsOk());
  EXPECT_TRUE(isConnected);
  const LoopWorld several(SeveralComponents());
  const std::vector<SurfacePoint> apart = { At(0), At(several.Mesh.GetNumberOfVertices() - 1) };
  EXPECT_TRUE(several.Finder->Rope(apart, true, loop, isConnected).IsOk());
  EXPECT_TRUE(loop.Loop.IsEmpty());
  EXPECT_FALSE(isConnected);
}

/// The angle of a rope that passes its points is the smallest angle at any of the points.
TEST(LoopFinder, KinksOfRopes)
{
  const LoopWorld plane(Plane(8, 8));
  const auto at = [](Id i, Id j) { return At(9 * j + i); };
  // A triangle with angles of 90, 45 and 45 degrees, and a square with an additional point on a
  // side.
  for (int first = 0; first < 3; ++first)
  {
    std::vector<SurfacePoint> points = { at(1, 1), at(6, 1), at(1, 6) };
    std::rotate(points.begin(), points.begin() + first, points.end());
    EXPECT_NEAR(plane.Rope(points, false).Angle, 0.25 * dgg::Pi, 1e-9);
    points.insert(points.begin() + 1, points[0]); // duplicate point
    EXPECT_NEAR(plane.Rope(points, false).Angle, 0.25 * dgg::Pi, 1e-9);
  }
  EXPECT_NEAR(plane.Rope({ at(1, 1), at(4, 1), at(6, 1), at(6, 6), at(1, 6) }, false).Angle,
    0.5 * dgg::Pi, 1e-9);
  // Points in faces and on edges.
  const LoopWorld prism(PrismSide(7, 3, 8, 0.2, 4));
  const std::vector<SurfacePoint> anywhere = { SurfacePoint::InFace(
                                                 prism.Mesh, 150, { { 0.3, 0.5, 0.2 } }),
    SurfacePoint::OnEdge(prism.Mesh, 301, 0.3), At(140) };
  const FoundLoop loop = prism.Rope(anywhere, false);
  ASSERT_FALSE(loop.Loop.IsEmpty());
  std::vector<SurfacePoint> turned = anywhere;
  std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  EXPECT_NEAR(prism.Rope(turned, false).Angle, loop.Angle, 1e-9);
  EXPECT_LT(loop.Angle, dgg::Pi - 0.01);
}

/// A prism of long thin strips with flat caps: every loop is moved over a cap strip by strip and
/// contracts. The number of trials is limited to a number that suffices on ordinary meshes.
TEST(LoopFinder, EndsWhereAllWaysTakeLong)
{
  const Id sides = 400;
  const LoopWorld world(CappedPrism(sides, 2, Cap::Fan, 1), 0.05);
  for (const Id v : { 7, sides + 100, 2 * sides + 250 })
  {
    dgg::FoundLoop loop;
    int trials = 0;
    const auto count = [&](double) { return ++trials > 0; };
    ASSERT_TRUE(world.Finder->ThroughPoint(At(v), false, loop, count).IsOk());
    EXPECT_LE(trials, 256) << v;
  }
}

namespace
{
using dgg::FoundLoop;
using dgg::SurfacePoint;

/// Returns the points where the edges of a convex surface cross a plane perpendicular to an axis,
/// ordered around the axis.
std::vector<SurfacePoint> Section(
  const dgg::SurfaceMesh& mesh, const TestMesh& points, int axis, double height)
{
  std::vector<std::pair<double, SurfacePoint>> found;
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  std::array<double, 3> middle{};
  for (Id v = 0; v < points.GetNumberOfVertices(); ++v)
  {
    for (int k = 0; k < 3; ++k)
    {
      middle[k] += points.Point(v)[k] / points.GetNumberOfVertices();
    }
  }
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const double* a = points.Point(mesh.Origin(h));
    const double* b = points.Point(mesh.Destination(h));
    if (a[axis] < height && b[axis] > height)
    {
      const double t = (height - a[axis]) / (b[axis] - a[axis]);
      const double angle =
        std::atan2(a[y] + t * (b[y] - a[y]) - middle[y], a[x] + t * (b[x] - a[x]) - middle[x]);
      found.emplace_back(angle, SurfacePoint::OnEdge(mesh, h, t));
    }
  }
  std::sort(
    found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<SurfacePoint> section;
  for (const auto& entry : found)
  {
    section.push_back(entry.second);
  }
  return section;
}

void ExpectTaut(const LoopWorld& world, const std::vector<SurfacePoint>& rope, double length)
{
  const FoundLoop loop = world.Rope(rope, true);
  ASSERT_FALSE(loop.Loop.IsEmpty());
  EXPECT_NEAR(loop.Loop.Length, length, 1e-9 * length);
  EXPECT_FALSE(loop.IsKinked());
  ExpectLocallyShortest(world.Mesh, loop.Loop, true);
}

class TautLoops : public testing::TestWithParam<Cap>
{
};
}

TEST_P(TautLoops, AroundPrisms)
{
  for (Id sides = 3; sides <= 72; sides += sides < 12 ? 1 : 5)
  {
    SCOPED_TRACE(sides);
    for (const Id rows : { 1, 2 })
    {
      const TestMesh prism = CappedPrism(sides, rows, this->GetParam(), sides);
      const LoopWorld world(prism, 0.05);
      const double around = 2.0 * sides * std::sin(dgg::Pi / sides);
      std::vector<SurfacePoint> rope = Section(world.Mesh, prism, 2, 0.43 * PrismHeight);
      std::rotate(rope.begin(), rope.begin() + sides / 2, rope.end());
      const FoundLoop loop = world.Rope(rope, false);
      EXPECT_FALSE(loop.IsKinked());
      EXPECT_NEAR(loop.Loop.Length, around, 1e-9);
      ExpectTaut(world, rope, around);
      // Start with kinks, which must disappear.
      const std::vector<SurfacePoint> higher = Section(world.Mesh, prism, 2, 0.48 * PrismHeight);
      ASSERT_EQ(higher.size(), 2u * sides);
      for (std::size_t i = 0; i < rope.size(); i += 3)
      {
        rope[i] = higher[(i + sides / 2) % higher.size()];
      }
      EXPECT_TRUE(world.Rope(rope, false).IsKinked());
      ExpectTaut(world, rope, around);
    }
  }
}

/// The loop is far from all vertices.
TEST_P(TautLoops, ThroughAPointOfAPrism)
{
  for (Id sides = 12; sides <= 36; sides += 6)
  {
    SCOPED_TRACE(sides);
    const TestMesh prism = CappedPrism(sides, 1, this->GetParam(), sides);
    const LoopWorld world(prism, 0.02);
    for (const SurfacePoint& point : Section(world.Mesh, prism, 2, 0.61 * PrismHeight))
    {
      for (const bool isTaut : { false, true })
      {
        const FoundLoop loop = world.ThroughPoint(point, isTaut);
        EXPECT_NEAR(loop.Loop.Length, 2.0 * sides * std::sin(dgg::Pi / sides), 1e-9);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Caps, TautLoops, testing::Values(Cap::Fan, Cap::Strip, Cap::Spokes));

TEST(TautRopes, AroundCubes)
{
  for (const Id cells : { 1, 2, 5 })
  {
    for (const double jitter : { 0.0, 0.2 })
    {
      SCOPED_TRACE(testing::Message() << cells << " cells, jitter " << jitter);
      const TestMesh cube = Cube(cells, jitter);
      const LoopWorld world(cube, 0.05);
      for (int axis = 0; axis < 3; ++axis)
      {
        for (const double height : { 0.13, 0.37, 0.77 })
        {
          ExpectTaut(world, Section(world.Mesh, cube, axis, height), 4.0);
        }
      }
    }
  }
}

/// A rope that only touches corners slides off.
TEST(TautRopes, RimsOfPrisms)
{
  for (const Id sides : { 3, 4, 12, 40 })
  {
    const LoopWorld world(CappedPrism(sides, 1, Cap::Fan, 1), 0.05);
    std::vector<SurfacePoint> rim;
    for (Id i = 0; i < sides; ++i)
    {
      rim.push_back(SurfacePoint::AtVertex(i));
    }
    EXPECT_TRUE(world.Rope(rim, false).IsKinked());
    EXPECT_TRUE(world.Rope(rim, true).Loop.IsEmpty());
  }
}
}
