// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces cut open along curves, and what is left and right of these.
#include "CurveChecks.h"
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggFaceRefinement.h"

#include <algorithm>
#include <array>
#include <set>

namespace dggtest
{
namespace
{
using dgg::CurveCut;
using dgg::NoId;
using dgg::RefinedSurface;
using dgg::SurfaceCurve;
using dgg::SurfacePoint;

/// The copies of a vertex of a chain on one side: where the edge before it arrives, and where the
/// one after it leaves. They differ when another curve comes in on this side. NoId where there is
/// no edge or no side. The chain of a closed curve goes on from its last vertex to its first.
std::array<Id, 2> FindCopies(
  const std::vector<dgg::EdgeSide>& side, std::size_t vertex, bool isClosed)
{
  const std::size_t edges = side.size();
  std::array<Id, 2> copies{ { NoId, NoId } };
  if (edges > 0 && (vertex > 0 || isClosed))
  {
    copies[0] = side[(vertex + edges - 1) % edges].To;
  }
  if (edges > 0 && (vertex < edges || isClosed))
  {
    copies[1] = side[vertex % edges].From;
  }
  return copies;
}

RefinedSurface EmbedVertices(
  const dgg::SurfaceMesh& mesh, const std::vector<std::vector<Id>>& curves, bool isClosed = false)
{
  std::vector<SurfaceCurve> joined;
  joined.reserve(curves.size());
  for (const std::vector<Id>& vertices : curves)
  {
    joined.push_back(Curve(mesh, AtVertices(vertices), isClosed));
  }
  return Embed(mesh, joined);
}

Id CountCopies(const CurveCut& cut, Id vertex)
{
  const std::vector<Id>& of = cut.Surface.VertexOf;
  return static_cast<Id>(std::count(of.begin(), of.end(), vertex));
}

/// Positive where a face lies to the left of the edge on whose side it is.
double SideInPlane(const TestMesh& input, const dgg::SurfaceMesh& mesh, const CurveCut& cut,
  const dgg::EdgeSide& side)
{
  auto positionOf = [&](Id v) {
    return dgg::PositionOf(mesh, cut.Surface.Points[v], input.Points.data());
  };
  const auto from = positionOf(side.From);
  const auto to = positionOf(side.To);
  double sum = 0.0;
  for (Id h = 3 * side.Face; h < 3 * side.Face + 3; ++h)
  {
    const auto p = positionOf(cut.Surface.Triangles[h]);
    sum += (to[0] - from[0]) * (p[1] - from[1]) - (to[1] - from[1]) * (p[0] - from[0]);
  }
  return sum;
}

CurveCut SoundCut(const RefinedSurface& surface)
{
  CurveCut cut = CutOpen(surface);
  ExpectSoundCut(surface, cut);
  return cut;
}

void ExpectTopology(const CurveCut& cut, Id parts, Id characteristic, Id boundaryLoops)
{
  EXPECT_EQ(CountParts(cut.Surface.Triangles), parts);
  EXPECT_EQ(EulerCharacteristic(cut.Surface.Triangles), characteristic);
  EXPECT_EQ(CountBoundaryLoops(cut.Surface.Triangles), boundaryLoops);
}
}

TEST(CurveCut, SlitHasOneRim)
{
  // Points 6, 7 and 8 of a plane of 4 x 4 cells are inside.
  const dgg::SurfaceMesh mesh = Build(Plane(4, 4));
  const RefinedSurface surface = EmbedVertices(mesh, { { 6, 7, 8 } });
  const CurveCut cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, 6), 1);
  EXPECT_EQ(CountCopies(cut, 7), 2);
  EXPECT_EQ(CountCopies(cut, 8), 1);
  ExpectTopology(cut, 1, 0, 2);
  const dgg::CurveSides& sides = cut.Sides[0];
  EXPECT_EQ(FindCopies(sides.Left, 0, false), (std::array<Id, 2>{ { NoId, 6 } }));
  EXPECT_EQ(FindCopies(sides.Right, 0, false), (std::array<Id, 2>{ { NoId, 6 } }));
  EXPECT_EQ(FindCopies(sides.Left, 2, false), (std::array<Id, 2>{ { 8, NoId } }));
  const std::array<Id, 2> left = FindCopies(sides.Left, 1, false);
  const std::array<Id, 2> right = FindCopies(sides.Right, 1, false);
  EXPECT_EQ(left[0], left[1]);
  EXPECT_EQ(right[0], right[1]);
  EXPECT_NE(left[0], right[0]);
}

TEST(CurveCut, CrossingHasFourCopies)
{
  // A cross in the middle of a plane: 12 is its center.
  const dgg::SurfaceMesh mesh = Build(Plane(4, 4));
  const RefinedSurface surface = EmbedVertices(mesh, { { 11, 12, 13 }, { 7, 12, 17 } });
  const CurveCut cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, 12), 4);
  EXPECT_EQ(CountBoundaryLoops(cut.Surface.Triangles), 2);
  // To the left of the first curve there is a copy before the second curve and one after it.
  std::set<Id> copies;
  for (const dgg::CurveSides& sides : cut.Sides)
  {
    for (const std::vector<dgg::EdgeSide>& side : { sides.Left, sides.Right })
    {
      const std::array<Id, 2> found = FindCopies(side, 1, false);
      EXPECT_NE(found[0], found[1]);
      copies.insert(found.begin(), found.end());
    }
  }
  EXPECT_EQ(copies.size(), 4u);
  // Ahead of it and on the left of the first curve is what is ahead and right of the second one.
  EXPECT_EQ(
    FindCopies(cut.Sides[0].Left, 1, false)[1], FindCopies(cut.Sides[1].Right, 1, false)[1]);
}

TEST(CurveCut, ClosedCurves)
{
  // Around a vertex of a sphere: a small part and a large one.
  const dgg::SurfaceMesh sphere = Build(Icosphere(2));
  std::vector<Id> ring;
  for (const Id* h = sphere.FanBegin(0); h != sphere.FanEnd(0); ++h)
  {
    ring.push_back(sphere.Destination(*h));
  }
  RefinedSurface surface = EmbedVertices(sphere, { ring }, true);
  CurveCut cut = SoundCut(surface);
  ExpectTopology(cut, 2, 2, 2);
  // Fans turn counter-clockwise: the vertex is on the left, all around.
  for (std::size_t i = 0; i <= ring.size(); ++i)
  {
    const std::array<Id, 2> left = FindCopies(cut.Sides[0].Left, i, true);
    const std::array<Id, 2> right = FindCopies(cut.Sides[0].Right, i, true);
    EXPECT_EQ(left[0], left[1]);
    EXPECT_EQ(right[0], right[1]);
    EXPECT_NE(left[0], right[0]);
    EXPECT_EQ(cut.Surface.VertexOf[left[0]], ring[i % ring.size()]);
  }
  for (const dgg::EdgeSide& left : cut.Sides[0].Left)
  {
    const Id* corners = cut.Surface.Triangles.data() + 3 * left.Face;
    EXPECT_NE(std::find(corners, corners + 3, 0), corners + 3);
  }
  // Around a torus: it stays in one part. Both ways around: it becomes a disk.
  const dgg::SurfaceMesh torus = Build(Torus(8, 5));
  std::vector<Id> parallel;
  std::vector<Id> meridian;
  for (Id i = 0; i < 8; ++i)
  {
    parallel.push_back(i);
  }
  for (Id j = 0; j < 5; ++j)
  {
    meridian.push_back(8 * j);
  }
  surface = EmbedVertices(torus, { parallel }, true);
  cut = SoundCut(surface);
  ExpectTopology(cut, 1, 0, 2);
  surface = EmbedVertices(torus, { parallel, meridian }, true);
  cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, 0), 4);
  EXPECT_EQ(EulerCharacteristic(cut.Surface.Triangles), 1);
  EXPECT_EQ(CountBoundaryLoops(cut.Surface.Triangles), 1);
}

TEST(CurveCut, LeftIsLeft)
{
  const TestMesh input = Plane(5, 5, 0.25, 3);
  const dgg::SurfaceMesh mesh = Build(input);
  Random random(11);
  for (int i = 0; i < 50; ++i)
  {
    const std::vector<SurfaceCurve> curves{ Curve(mesh, RandomCurvePoints(mesh, 6, random), true),
      Curve(mesh, RandomCurvePoints(mesh, 6, random)) };
    const RefinedSurface surface = Embed(mesh, curves);
    const CurveCut cut = SoundCut(surface);
    for (const dgg::CurveSides& sides : cut.Sides)
    {
      for (std::size_t e = 0; e < sides.Left.size(); ++e)
      {
        const dgg::EdgeSide& left = sides.Left[e];
        const dgg::EdgeSide& right = sides.Right[e];
        EXPECT_TRUE(left.Face == NoId || SideInPlane(input, mesh, cut, left) > 0.0);
        EXPECT_TRUE(right.Face == NoId || SideInPlane(input, mesh, cut, right) < 0.0);
      }
    }
    ASSERT_FALSE(HasFailure()) << i;
  }
}

TEST(CurveCut, Fuzz)
{
  Id total = 0;
  std::uint64_t seed = 100;
  for (const TestMesh& input :
    { SingleTriangle(), Plane(2, 2), Plane(4, 3, 0.25, 7), Octahedron(), NoisySphere(1, 0.4, 3),
      WithNoise(Torus(7, 4), 0.1, 5), Ellipsoid(1, 30.0), MisorientedSphere(1, 8) })
  {
    SCOPED_TRACE(seed);
    const dgg::SurfaceMesh mesh = Build(input);
    Random random(++seed);
    for (int i = 0; i < 50; ++i)
    {
      SCOPED_TRACE(i);
      std::vector<SurfaceCurve> curves;
      const Id count = 1 + random.Index(8);
      for (Id c = 0; c < count; ++c)
      {
        const std::vector<SurfacePoint> points =
          RandomCurvePoints(mesh, 1 + random.Index(8), random);
        curves.push_back(Curve(mesh, points, random.Index(2) == 0));
      }
      total += count;
      const RefinedSurface surface = Embed(mesh, curves);
      ExpectSoundCut(surface, CutOpen(surface));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(total, 1500);
}

TEST(CurveCut, SheetsThatTouchInAPoint)
{
  // A curve through the point that two spheres share, on one of them.
  const dgg::SurfaceMesh mesh = Build(TouchingSpheres(1));
  const Id* h = mesh.FanBegin(0);
  const Id before = mesh.Destination(h[0]);
  const Id after = mesh.Destination(h[2]); // of the same fan
  const RefinedSurface surface = EmbedVertices(mesh, { { before, 0, after } });
  const CurveCut cut = CutOpen(surface);
  EXPECT_EQ(CountCopies(cut, 0), 3); // left, right, and the other sphere
  EXPECT_EQ(CountParts(cut.Surface.Triangles), 2);
}

}
