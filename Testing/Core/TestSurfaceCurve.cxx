// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves through points of a surface: straight in faces, chains of edges after embedding, and their
// left and right sides after the surface is cut open.
#include "CurveChecks.h"
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggFaceRefinement.h"
#include "dggMeshReport.h"

namespace dggtest
{
namespace
{
using dgg::NoId;
using dgg::SubMesh;
using dgg::SurfaceCurve;
using dgg::SurfacePoint;
}

TEST(SurfaceCurve, IsStraightInThePlane)
{
  const TestMesh input = Plane(9, 7, 0.25, 3);
  const dgg::SurfaceMesh mesh = Build(input);
  const std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 30, 5);
  const SurfaceCurve curve = Curve(mesh, points, true);
  ExpectSoundCurve(mesh, points, curve);
  EXPECT_GT(curve.Path.Points.size(), 100u);
  auto positionOf = [&](const SurfacePoint& point) {
    return dgg::PositionOf(mesh, point, input.Points.data());
  };
  for (std::size_t i = 0; i < curve.Path.Points.size(); ++i)
  {
    const auto leg = static_cast<std::size_t>(curve.Parameters[i]) % points.size();
    const double t = curve.Parameters[i] - std::floor(curve.Parameters[i]);
    const auto from = positionOf(points[leg]);
    const auto to = positionOf(points[(leg + 1) % points.size()]);
    const auto at = positionOf(curve.Path.Points[i]);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(at[c], (1.0 - t) * from[c] + t * to[c], 1e-9) << i;
    }
  }
}

TEST(SurfaceCurve, IsAsLongAsTheDistancesBetweenItsPoints)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    std::vector<SurfacePoint> points;
    Id count = 0;
    const std::vector<Id> components = mesh.ComputeComponents(count);
    for (const SurfacePoint& point : RandomSurfacePoints(mesh, 40, 8))
    {
      if (components[mesh.Origin(3 * point.Face)] == 0 && points.size() < 6)
      {
        points.push_back(point);
      }
    }
    points.push_back(SurfacePoint::AtVertex(0));
    const SurfaceCurve curve = Curve(mesh, points);
    ExpectSoundCurve(mesh, points, curve);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      length += DistancesTo(mesh, dgg::ExactEngine::Reference, points[i], { points[i + 1] })[0];
    }
    EXPECT_NEAR(curve.Path.Length, length, 1e-9 * length);
  }
}

TEST(SurfaceCurve, FindsCommonFaces)
{
  const dgg::SurfaceMesh mesh = Build(Plane(2, 1)); // faces 0, 1: left cell; 2, 3: right cell
  const auto at = [](Id v) { return SurfacePoint::AtVertex(v); };
  for (Id f = 0; f < 4; ++f)
  {
    const SurfacePoint inside = SurfacePoint::InFace(mesh, f, { { 0.2, 0.3, 0.5 } });
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const SurfacePoint onSide = SurfacePoint::OnEdge(mesh, h, 0.25);
      EXPECT_EQ(dgg::FindCommonFace(mesh, inside, onSide), f);
      EXPECT_EQ(dgg::FindCommonFace(mesh, onSide, inside), f);
      EXPECT_EQ(dgg::FindCommonFace(mesh, inside, at(mesh.Origin(h))), f);
      EXPECT_EQ(dgg::FindCommonFace(mesh, at(mesh.Origin(h)), inside), f);
      const Id twin = mesh.Twin(h);
      const Id smallest = twin == NoId ? f : std::min(f, twin / 3);
      EXPECT_EQ(dgg::FindCommonFace(mesh, at(mesh.Origin(h)), at(mesh.Destination(h))), smallest);
      EXPECT_EQ(dgg::FindCommonFace(mesh, onSide, SurfacePoint::OnEdge(mesh, h, 0.5)), smallest);
      EXPECT_EQ(dgg::FindCommonFace(mesh, onSide, at(mesh.Apex(h))), f);
    }
  }
  EXPECT_EQ(dgg::FindCommonFace(mesh, at(0), at(2)), NoId);
  EXPECT_EQ(dgg::FindCommonFace(mesh, SurfacePoint::InFace(mesh, 0, { { 0.2, 0.3, 0.5 } }),
              SurfacePoint::InFace(mesh, 1, { { 0.2, 0.3, 0.5 } })),
    NoId);
}

// Meshes in which curves are chains of edges.

TEST(CurveEmbedding, ParametersAreLengthsAlongTheCurve)
{
  const TestMesh input = Plane(6, 6);
  const dgg::SurfaceMesh mesh = Build(input);
  // A curve with a corner at (5, 3.3), and another curve that crosses both legs.
  const std::vector<SurfaceCurve> curves{ Curve(mesh,
                                            { PointInPlane(input, mesh, 0.3, 3.3),
                                              PointInPlane(input, mesh, 5.0, 3.3),
                                              PointInPlane(input, mesh, 5.0, 0.7) }),
    Curve(mesh,
      { PointInPlane(input, mesh, 1.9, 5.3), PointInPlane(input, mesh, 2.1, 1.2),
        PointInPlane(input, mesh, 5.9, 1.4) }) };
  const SubMesh surface = Embed(mesh, curves);
  ExpectSoundEmbedding(input, mesh, curves, surface);
  const dgg::CurveChain chain = dgg::FollowCurve(surface, curves, 0);
  ASSERT_GT(chain.Vertices.size(), 15u);
  Id crossings = 0;
  for (std::size_t i = 0; i < chain.Vertices.size(); ++i)
  {
    const auto p = dgg::PositionOf(mesh, surface.Points[chain.Vertices[i]], input.Points.data());
    const double expected = p[0] < 5.0 - 1e-9 ? (p[0] - 0.3) / 4.7 : 1.0 + (3.3 - p[1]) / 2.6;
    EXPECT_NEAR(chain.Parameters[i], expected, 1e-9) << p[0] << " " << p[1];
    const std::vector<Id>& other = surface.Paths[1];
    crossings += std::find(other.begin(), other.end(), chain.Vertices[i]) != other.end() ? 1 : 0;
  }
  EXPECT_EQ(crossings, 2);
}

TEST(CurveEmbedding, CrossingsAndTouchesAreShared)
{
  // In one face: a cross, a curve that ends on the cross, and a curve along a part of the cross.
  const TestMesh input = SingleTriangle();
  const dgg::SurfaceMesh mesh = Build(input);
  const auto at = [&](double b, double c) { return PointIn(mesh, 0, { { 1.0 - b - c, b, c } }); };
  const std::vector<SurfaceCurve> curves{ Curve(mesh, { at(0.125, 0.25), at(0.625, 0.25) }),
    Curve(mesh, { at(0.25, 0.125), at(0.25, 0.5) }), Curve(mesh, { at(0.5, 0.25), at(0.5, 0.375) }),
    Curve(mesh, { at(0.25, 0.25), at(0.375, 0.25) }) };
  const SubMesh surface = Embed(mesh, curves);
  ExpectSoundEmbedding(input, mesh, curves, surface);
  // The fourth curve adds one vertex. The third and fourth curves would have a single edge, which
  // gets a midpoint.
  EXPECT_EQ(surface.GetNumberOfVertices(), 3 + 2 + 2 + 2 + 2 + 2);
  EXPECT_EQ(surface.Paths[0].size(), 6u);
  EXPECT_EQ(surface.Paths[1].size(), 3u);
  EXPECT_EQ(surface.Paths[2].size(), 3u);
  EXPECT_EQ(surface.Paths[0][1], surface.Paths[1][1]);
  EXPECT_EQ(surface.Paths[0][4], surface.Paths[2][0]);
  EXPECT_EQ(surface.Paths[3],
    (std::vector<Id>{ surface.Paths[0][1], surface.Paths[0][2], surface.Paths[0][3] }));
}

TEST(CurveEmbedding, CurvesThatPassVerticesClosely)
{
  // The second curve passes the foot of the first one within 1e-9, and the fourth curve passes its
  // end. Both curves are moved to these points instead of crossing next to them. The third curve is
  // unchanged.
  const TestMesh input = SingleTriangle();
  const dgg::SurfaceMesh mesh = Build(input);
  const auto at = [&](double b, double c) { return PointIn(mesh, 0, { { 1.0 - b - c, b, c } }); };
  const std::vector<SurfaceCurve> curves{ Curve(mesh, { at(0.5, 0.0), at(0.5, 0.375) }),
    Curve(mesh, { at(0.25, 1.5e-9), at(0.75, 0.0) }), Curve(mesh, { at(0.0, 3e-9), at(0.25, 0.0) }),
    Curve(mesh, { at(0.25, 0.375 + 5e-10), at(0.625, 0.375) }) };
  const SubMesh surface = Embed(mesh, curves);
  ExpectSoundEmbedding(input, mesh, curves, surface);
  EXPECT_EQ(surface.GetNumberOfVertices(), 3 + 2 + 2 + 2 + 2);
  ASSERT_EQ(surface.Paths[1].size(), 3u);
  EXPECT_EQ(surface.Paths[1][1], surface.Paths[0][0]);
  ASSERT_EQ(surface.Paths[3].size(), 3u);
  EXPECT_EQ(surface.Paths[3][1], surface.Paths[0][1]);
  // A curve across a corner, closer to the corner than to both ends of the curve.
  const std::vector<SurfaceCurve> corner{ Curve(mesh, { at(1.2e-9, 0.0), at(0.0, 1.2e-9) }) };
  const SubMesh around = Embed(mesh, corner);
  ExpectSoundEmbedding(input, mesh, corner, around);
  EXPECT_EQ(around.GetNumberOfVertices(), 5);
  ASSERT_EQ(around.Paths[0].size(), 3u);
  EXPECT_EQ(around.Paths[0][1], mesh.Origin(0));
}

TEST(CurveEmbedding, MeshesWithDefects)
{
  // Curves within faces and along their sides; most of these meshes have several components.
  for (const NamedMesh& named : DefectMeshes())
  {
    if (named.Mesh.Points.empty())
    {
      continue;
    }
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    std::vector<SurfaceCurve> curves;
    const std::vector<SurfacePoint> starts = RandomSurfacePoints(mesh, 12, 31);
    for (const SurfacePoint& start : starts)
    {
      std::vector<SurfacePoint> points{ start };
      for (int i = 0; i < 4; ++i)
      {
        const Id face = dgg::FindFaceOf(mesh, points.back());
        points.push_back(SurfacePoint::OnEdge(mesh, 3 * face + i % 3, 0.3));
        points.push_back(SurfacePoint::AtVertex(mesh.Origin(3 * face + (i + 1) % 3)));
      }
      curves.push_back(Curve(mesh, points, true));
    }
    ExpectSoundEmbedding(named.Mesh, mesh, curves, Embed(mesh, curves));
  }
}

namespace
{
using dgg::CurveCut;
using dgg::NoId;
using dgg::SubMesh;
using dgg::SurfaceCurve;
using dgg::SurfacePoint;

/// Returns the copies of a chain vertex on one side: at the end of the edge before and at the start
/// of the edge after the vertex. The copies differ if another curve meets the chain on this side.
/// NoId where there is no edge or no side. The chain of a closed curve continues from its last
/// vertex to its first.
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

SubMesh EmbedVertices(
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

/// Returns a positive value if the face lies to the left of the edge on whose side it is.
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

CurveCut SoundCut(const SubMesh& surface)
{
  CurveCut cut = CutOpen(surface);
  ExpectSoundCut(surface, cut);
  return cut;
}

void ExpectTopology(
  const dgg::SurfaceMesh& mesh, const CurveCut& cut, Id components, Id boundaryLoops, Id genus = 0)
{
  dgg::SurfaceMesh opened;
  ASSERT_TRUE(Ok(cut.Surface.Build(mesh, opened)));
  const dgg::MeshReport report = dgg::InspectMesh(opened);
  EXPECT_EQ(report.Components, components);
  EXPECT_EQ(report.BoundaryLoops, boundaryLoops);
  EXPECT_EQ(report.Genus, genus);
}
}

TEST(CurveCut, SlitHasOneRim)
{
  // Points 6, 7 and 8 of a plane of 4 x 4 cells are in the interior.
  const dgg::SurfaceMesh mesh = Build(Plane(4, 4));
  const SubMesh surface = EmbedVertices(mesh, { { 6, 7, 8 } });
  const CurveCut cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, 6), 1);
  EXPECT_EQ(CountCopies(cut, 7), 2);
  EXPECT_EQ(CountCopies(cut, 8), 1);
  ExpectTopology(mesh, cut, 1, 2);
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
  // A cross in the middle of a plane with center 12.
  const dgg::SurfaceMesh mesh = Build(Plane(4, 4));
  const SubMesh surface = EmbedVertices(mesh, { { 11, 12, 13 }, { 7, 12, 17 } });
  const CurveCut cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, 12), 4);
  ExpectTopology(mesh, cut, 1, 2);
  // To the left of the first curve there is a copy before the second curve and one after the second
  // curve.
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
  // The sector ahead and to the left of the first curve is ahead and to the right of the second
  // curve.
  EXPECT_EQ(
    FindCopies(cut.Sides[0].Left, 1, false)[1], FindCopies(cut.Sides[1].Right, 1, false)[1]);
}

TEST(CurveCut, ClosedCurves)
{
  // A curve around a vertex of a sphere leaves a small and a large component.
  const dgg::SurfaceMesh sphere = Build(Icosphere(2));
  std::vector<Id> ring;
  for (const Id* h = sphere.FanBegin(0); h != sphere.FanEnd(0); ++h)
  {
    ring.push_back(sphere.Destination(*h));
  }
  SubMesh surface = EmbedVertices(sphere, { ring }, true);
  CurveCut cut = SoundCut(surface);
  ExpectTopology(sphere, cut, 2, 2);
  // Fans turn counter-clockwise, so the vertex is on the left everywhere.
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
  // One closed curve around a torus leaves it connected. Two curves in both directions make it a
  // disk.
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
  ExpectTopology(torus, cut, 1, 2);
  surface = EmbedVertices(torus, { parallel, meridian }, true);
  cut = SoundCut(surface);
  EXPECT_EQ(CountCopies(cut, 0), 4);
  ExpectTopology(torus, cut, 1, 1);
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
    const SubMesh surface = Embed(mesh, curves);
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

TEST(CurveCut, SheetsThatTouchInAPoint)
{
  // A curve through the vertex shared by two spheres, on one of them.
  const dgg::SurfaceMesh mesh = Build(TouchingSpheres(1));
  const Id* h = mesh.FanBegin(0);
  const Id before = mesh.Destination(h[0]);
  const Id after = mesh.Destination(h[2]); // in the same fan
  const SubMesh surface = EmbedVertices(mesh, { { before, 0, after } });
  const CurveCut cut = CutOpen(surface);
  EXPECT_EQ(CountCopies(cut, 0), 3); // left side, right side, and the other sphere
  ExpectTopology(mesh, cut, 2, 1);
}

/// Random curves of all kinds: the surface with embedded curves, cut along curves, and with refined
/// faces.
TEST(CurveFuzz, EmbeddedCutAndRefined)
{
  Id total = 0;
  std::uint64_t seed = 1;
  std::vector<Id> sheetOf;
  for (const TestMesh& input : { Book(5, 3, sheetOf), SingleTriangle(), Plane(2, 2),
         Plane(4, 3, 0.25, 7), Octahedron(), NoisySphere(1, 0.4, 3), WithNoise(Torus(7, 4), 0.1, 5),
         Ellipsoid(1, 30.0), NeedlePlane(2, 1e-5), CapPlane(2, 1e-5), MisorientedSphere(1, 8) })
  {
    SCOPED_TRACE(seed);
    const dgg::SurfaceMesh mesh = Build(input);
    const bool isManifold = seed > 1;
    Random random(++seed);
    for (int i = 0; i < 50; ++i)
    {
      SCOPED_TRACE(i);
      std::vector<SurfaceCurve> curves;
      const Id count = 1 + random.Index(8);
      for (Id c = 0; c < count; ++c)
      {
        const Id points = 1 + random.Index(8);
        curves.push_back(
          Curve(mesh, RandomCurvePoints(mesh, points, random), isManifold && random.Index(2) == 0));
      }
      total += count;
      SubMesh surface = Embed(mesh, curves);
      ExpectSoundEmbedding(input, mesh, curves, surface);
      std::vector<Id> faces;
      for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
      {
        if (random.Index(20) == 0)
        {
          faces.push_back(f);
        }
      }
      for (const bool isRefined : { false, true })
      {
        if (isRefined)
        {
          std::vector<Id> parents;
          ASSERT_TRUE(Ok(dgg::RefineFaces(mesh, faces, 1 + i % 2, nullptr, surface, parents)));
          EXPECT_TRUE(std::is_sorted(parents.begin(), parents.end()));
          EXPECT_TRUE(faces.empty() || surface.GetNumberOfFaces() > parents.back() + 1);
          ExpectSoundEmbedding(input, mesh, curves, surface);
        }
        if (isManifold)
        {
          ExpectSoundCut(surface, CutOpen(surface));
        }
      }
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(total, 2000);
}
}
