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
#include <numeric>
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

dgg::Status ErrorOf(const RefinedSurface& surface)
{
  CurveCut cut;
  const dgg::Status status = dgg::CutAlongCurves(surface, surface.Paths, cut);
  EXPECT_FALSE(status.IsOk());
  EXPECT_TRUE(cut.Surface.Points.empty());
  EXPECT_TRUE(cut.Sides.empty());
  return status;
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

TEST(CurveCut, NothingToCut)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(1));
  const std::vector<SurfaceCurve> curves{ Curve(mesh, {}), Curve(mesh, AtVertices({ 4 })),
    Curve(mesh, AtVertices({ 4, 4 }), true) };
  const RefinedSurface surface = Embed(mesh, curves);
  const CurveCut cut = SoundCut(surface);
  EXPECT_EQ(cut.Surface.Triangles, surface.Triangles);
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

TEST(CurveCut, SingleEdgeOpens)
{
  // Along an edge, and inside a face; the third curve starts at the end of the second one.
  const TestMesh input = Plane(4, 4);
  const dgg::SurfaceMesh mesh = Build(input);
  const auto at = [&](double b, double c) { return PointIn(mesh, 20, { { 1.0 - b - c, b, c } }); };
  std::vector<SurfaceCurve> curves{ Curve(mesh, AtVertices({ 6, 7 })),
    Curve(mesh, { at(0.25, 0.25), at(0.5, 0.25) }) };
  RefinedSurface surface = Embed(mesh, curves);
  ExpectSoundEmbedding(input, mesh, curves, surface);
  CurveCut cut = SoundCut(surface);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const dgg::CurveChain chain = dgg::FollowCurve(surface, curves, c);
    EXPECT_EQ(chain.Parameters, (std::vector<double>{ 0.0, 0.5, 1.0 }));
    EXPECT_EQ(chain.GivenPoints, (std::vector<dgg::Offset>{ 0, 2 }));
    EXPECT_EQ(CountCopies(cut, chain.Vertices[1]), 2);
  }
  curves.push_back(Curve(mesh, { at(0.5, 0.25), at(0.5, 0.375) }));
  surface = Embed(mesh, curves);
  for (const std::vector<Id>& path : surface.Paths) // each may be cut along without the others
  {
    EXPECT_EQ(path.size(), 3u);
  }
  cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, surface.Paths[2][0]), 2);
}

TEST(CurveCut, FromTheRim)
{
  // From the middle to the rim: no new loop. From rim to rim: two parts.
  const dgg::SurfaceMesh mesh = Build(Plane(4, 4));
  RefinedSurface surface = EmbedVertices(mesh, { { 12, 13, 14 } });
  CurveCut cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, 14), 2);
  EXPECT_EQ(CountBoundaryLoops(cut.Surface.Triangles), 1);
  EXPECT_EQ(EulerCharacteristic(cut.Surface.Triangles), 1);
  surface = EmbedVertices(mesh, { { 10, 11, 12, 13, 14 } });
  cut = SoundCut(surface);
  ExpectTopology(cut, 2, 2, 2);
}

TEST(CurveCut, AlongTheRim)
{
  const dgg::SurfaceMesh mesh = Build(Plane(3, 3));
  const RefinedSurface surface = EmbedVertices(mesh, { { 0, 1, 2, 3, 7 }, { 7, 3 } });
  const CurveCut cut = SoundCut(surface);
  EXPECT_EQ(cut.Surface.Triangles, surface.Triangles);
  for (const dgg::EdgeSide& right : cut.Sides[0].Right)
  {
    EXPECT_EQ(right.Face, NoId);
    EXPECT_EQ(right.From, NoId);
    EXPECT_EQ(right.To, NoId);
  }
  EXPECT_EQ(cut.Sides[0].Left[0].From, 0);
  EXPECT_EQ(cut.Sides[0].Left[0].To, 1);
  EXPECT_EQ(cut.Sides[1].Left[0].Face, NoId);
  EXPECT_EQ(cut.Sides[1].Right[0].Face, cut.Sides[0].Left[3].Face);
  EXPECT_EQ(cut.Sides[1].Right[0].From, 7);
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

TEST(CurveCut, EndOnACurve)
{
  // A T: the end has a copy on each side of the curve that comes in, and one beyond.
  const dgg::SurfaceMesh mesh = Build(Plane(4, 4));
  const RefinedSurface surface = EmbedVertices(mesh, { { 11, 12, 13 }, { 7, 12 } });
  const CurveCut cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, 12), 3);
  const std::array<Id, 2> left = FindCopies(cut.Sides[0].Left, 1, false);
  EXPECT_EQ(left[0], left[1]);
  const std::array<Id, 2> right = FindCopies(cut.Sides[0].Right, 1, false);
  EXPECT_NE(right[0], right[1]);
  ASSERT_EQ(surface.Paths[1].size(), 3u); // with a middle
  EXPECT_EQ(right[0], FindCopies(cut.Sides[1].Left, 2, false)[0]);
  EXPECT_EQ(right[1], FindCopies(cut.Sides[1].Right, 2, false)[0]);
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

TEST(CurveCut, RefusesWhatHasNoSides)
{
  // Across the line in which sheets meet, along it, and up to it; elsewhere is no matter.
  std::vector<Id> sheetOf;
  const dgg::SurfaceMesh book = Build(Book(3, 4, sheetOf));
  const Id spine = static_cast<Id>(std::find(sheetOf.begin(), sheetOf.end(), -1) - sheetOf.begin());
  Id inside = NoId;
  for (Id v = 0; v < book.GetNumberOfVertices(); ++v)
  {
    inside = book.Kind(v) != dgg::VertexKind::Boundary && sheetOf[v] >= 0 ? v : inside;
  }
  ASSERT_NE(inside, NoId);
  EXPECT_TRUE(Says(ErrorOf(EmbedVertices(book, { { spine, inside } })),
    "edges of more than two faces and 0 edges"));
  const RefinedSurface beside = Embed(book,
    { Curve(book,
      { SurfacePoint::InFace(book, 0, { { 0.3, 0.3, 0.4 } }),
        SurfacePoint::InFace(book, 0, { { 0.4, 0.4, 0.2 } }) }) });
  CurveCut cut;
  EXPECT_TRUE(dgg::CutAlongCurves(beside, beside.Paths, cut).IsOk());
  // Edges of the mesh are counted, not the parts that they were split into.
  RefinedSurface along = EmbedVertices(book, { { spine, inside } });
  const std::string message = ErrorOf(along).GetMessage();
  std::vector<Id> parents;
  std::vector<Id> all(along.Faces.size());
  std::iota(all.begin(), all.end(), 0);
  along.Paths.push_back({ spine, spine + 1, spine + 2 });
  const std::string whole = ErrorOf(along).GetMessage();
  EXPECT_NE(whole, message);
  along.Places.push_back({ 0.0, 1.0, 2.0 });
  ASSERT_TRUE(dgg::RefineFaces(book, all, 2, nullptr, along, parents).IsOk());
  EXPECT_EQ(ErrorOf(along).GetMessage(), whole);
  // Once around a strip with one side: left becomes right somewhere.
  const dgg::SurfaceMesh strip = Build(MoebiusStrip(6, 4));
  std::vector<Id> around;
  for (Id i = 0; i < 6; ++i)
  {
    around.push_back(2 * 6 + i);
  }
  EXPECT_TRUE(
    Says(ErrorOf(EmbedVertices(strip, { around }, true)), "0 edges of more than two faces and"));
  // A path that is no chain.
  RefinedSurface broken = EmbedVertices(Build(Plane(3, 3)), { { 0, 1 } });
  broken.Paths[0] = { 0, 15 };
  EXPECT_TRUE(Says(ErrorOf(broken), "not neighbours"));
}
}
