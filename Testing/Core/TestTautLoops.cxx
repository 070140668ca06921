// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Closed geodesics that lie side by side, all of the same length, next to others that slip off:
// around the walls of prisms and of cubes, whose corners hold nothing.
#include "LoopWorld.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dggtest
{
namespace
{
using dgg::FoundLoop;
using dgg::SurfacePoint;

/// Where the edges of a convex surface cross a plane across an axis, in order around the axis.
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
      // With kinks, which go.
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

/// The way around is far from all vertices.
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

/// What only leans on corners slips off.
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
