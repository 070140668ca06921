// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves through points of a surface: straight in faces, shortest paths between them.
#include "CurveChecks.h"
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace dggtest
{
namespace
{
using dgg::NoId;
using dgg::SurfaceCurve;
using dgg::SurfacePoint;

dgg::Status ErrorOf(
  const dgg::SurfaceMesh& mesh, const std::vector<SurfacePoint>& points, bool isClosed = false)
{
  SurfaceCurve curve;
  curve.Path.Points.resize(2); // something to be cleared
  curve.Parameters.resize(2);
  const dgg::Status status = dgg::JoinPoints(mesh, points, isClosed, nullptr, curve);
  EXPECT_FALSE(status.IsOk());
  EXPECT_TRUE(curve.Path.IsEmpty());
  EXPECT_TRUE(curve.Parameters.empty());
  EXPECT_TRUE(curve.GivenPoints.empty());
  return status;
}
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

TEST(SurfaceCurve, DoesWhatIsAsked)
{
  Random random(17);
  for (const TestMesh& input :
    { Plane(3, 3), NoisySphere(1, 0.3, 3), Torus(8, 5), MisorientedSphere(1, 8) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    for (int i = 0; i < 100; ++i)
    {
      const std::vector<SurfacePoint> points =
        RandomCurvePoints(mesh, 1 + random.Index(12), random);
      ExpectSoundCurve(mesh, points, Curve(mesh, points, i % 2 == 1));
      ASSERT_FALSE(HasFailure()) << i;
    }
  }
}

TEST(SurfaceCurve, FewPoints)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(1));
  const SurfacePoint point = SurfacePoint::InFace(mesh, 7, { { 0.2, 0.3, 0.5 } });
  for (const bool isClosed : { false, true })
  {
    EXPECT_TRUE(Curve(mesh, {}, isClosed).Path.IsEmpty());
    const SurfaceCurve single = Curve(mesh, { point }, isClosed);
    ExpectSoundCurve(mesh, { point }, single);
    EXPECT_EQ(single.Path.Points.size(), 1u);
    const SurfaceCurve twice = Curve(mesh, { point, point }, isClosed);
    ExpectSoundCurve(mesh, { point, point }, twice);
    EXPECT_EQ(twice.Path.Points.size(), isClosed ? 3u : 2u);
    EXPECT_EQ(twice.Path.Length, 0.0);
  }
  // There and back.
  const SurfacePoint other = SurfacePoint::AtVertex(3);
  const SurfaceCurve open = Curve(mesh, { point, other });
  const SurfaceCurve closed = Curve(mesh, { point, other }, true);
  EXPECT_NEAR(closed.Path.Length, 2.0 * open.Path.Length, 1e-12);
}

TEST(SurfaceCurve, FindsCommonFaces)
{
  const dgg::SurfaceMesh mesh = Build(Plane(2, 1)); // faces 0 and 1 of the left cell, 2 and 3
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

TEST(SurfaceCurve, SaysWhatIsWrong)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  Id components = 0;
  const std::vector<Id> componentOf = mesh.ComputeComponents(components);
  ASSERT_EQ(components, 3);
  const Id other = mesh.GetNumberOfVertices() - 1;
  ASSERT_NE(componentOf[other], componentOf[0]);
  const auto at = [](Id v) { return SurfacePoint::AtVertex(v); };
  EXPECT_TRUE(Says(
    ErrorOf(mesh, { at(0), at(1), at(other) }), "points 1 and 2 of the curve are not connected"));
  EXPECT_TRUE(Says(ErrorOf(mesh, { at(0), at(1), at(mesh.GetNumberOfVertices()) }),
    "point 2 of the curve: vertex"));
  SurfacePoint outside = SurfacePoint::InFace(mesh, 0, { { 0.7, 0.7, -0.4 } });
  EXPECT_TRUE(Says(ErrorOf(mesh, { outside, at(0) }), "point 0 of the curve: the barycentric"));
  outside = SurfacePoint::InFace(mesh, 0, { { std::nan(""), 0.5, 0.5 } });
  EXPECT_TRUE(Says(ErrorOf(mesh, { at(0), outside }, true), "point 1 of the curve"));
  const dgg::SurfaceMesh isolated = Build(SphereWithIsolatedPoints(1));
  Id alone = 0;
  while (isolated.Kind(alone) != dgg::VertexKind::Isolated)
  {
    ++alone;
  }
  EXPECT_TRUE(Says(ErrorOf(isolated, { at(alone), at(alone + 1) }), "not connected"));
}

TEST(SurfaceCurve, StopsWhenAsked)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.3, 2));
  const std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 10, 3);
  SurfaceCurve curve;
  const ProgressListener whole = ExpectStops(
    [&](const dgg::ProgressCallback& progress) {
      return dgg::JoinPoints(mesh, points, true, progress, curve);
    },
    [&] { EXPECT_TRUE(curve.Path.IsEmpty()); });
  EXPECT_GT(whole.Calls, 1);
}

// Meshes in which curves are chains of edges.

namespace
{
using dgg::RefinedSurface;
using dgg::SurfaceCurve;
using dgg::SurfacePoint;

std::vector<SurfaceCurve> RandomCurves(
  const dgg::SurfaceMesh& mesh, Id count, Id points, Random& random)
{
  std::vector<SurfaceCurve> curves;
  for (Id c = 0; c < count; ++c)
  {
    const std::vector<SurfacePoint> given =
      RandomCurvePoints(mesh, 1 + random.Index(points), random);
    curves.push_back(Curve(mesh, given, random.Index(2) == 0));
  }
  return curves;
}
}

TEST(CurveEmbedding, NothingToDo)
{
  const TestMesh input = Icosphere(1);
  const dgg::SurfaceMesh mesh = Build(input);
  const RefinedSurface surface = Embed(mesh, {});
  ExpectSoundEmbedding(input, mesh, {}, surface);
  EXPECT_EQ(surface.Triangles, input.Triangles);
  const std::vector<SurfaceCurve> curves{ Curve(mesh, {}), Curve(mesh, {}, true) };
  EXPECT_TRUE(dgg::FollowCurve(Embed(mesh, curves), curves, 1).Vertices.empty());
}

TEST(CurveEmbedding, EdgesNeedNoVertices)
{
  // Around a cell, along its diagonal and back.
  const TestMesh input = Plane(3, 3);
  const dgg::SurfaceMesh mesh = Build(input);
  const std::vector<SurfaceCurve> curves{ Curve(mesh, AtVertices({ 5, 6, 10, 9, 5, 10 }), true) };
  const RefinedSurface surface = Embed(mesh, curves);
  ExpectSoundEmbedding(input, mesh, curves, surface);
  EXPECT_EQ(surface.Triangles, input.Triangles);
  const dgg::CurveChain chain = dgg::FollowCurve(surface, curves, 0);
  EXPECT_EQ(chain.Vertices, (std::vector<Id>{ 5, 6, 10, 9, 5, 10, 5 }));
  EXPECT_EQ(chain.Parameters, (std::vector<double>{ 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(chain.GivenPoints, (std::vector<dgg::Offset>{ 0, 1, 2, 3, 4, 5 }));
}

TEST(CurveEmbedding, ParametersAreLengthsAlongTheCurve)
{
  const TestMesh input = Plane(6, 6);
  const dgg::SurfaceMesh mesh = Build(input);
  // A corner at (5, 3.3), and another curve that crosses each leg.
  const std::vector<SurfaceCurve> curves{ Curve(mesh,
                                            { PointInPlane(input, mesh, 0.3, 3.3),
                                              PointInPlane(input, mesh, 5.0, 3.3),
                                              PointInPlane(input, mesh, 5.0, 0.7) }),
    Curve(mesh,
      { PointInPlane(input, mesh, 1.9, 5.3), PointInPlane(input, mesh, 2.1, 1.2),
        PointInPlane(input, mesh, 5.9, 1.4) }) };
  const RefinedSurface surface = Embed(mesh, curves);
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

TEST(CurveEmbedding, PointsInOnePlace)
{
  // Points 1 to 4 are one vertex: repeated, and closer together than vertices may be.
  const TestMesh input = Plane(2, 2);
  const dgg::SurfaceMesh mesh = Build(input);
  const SurfacePoint middle = PointInPlane(input, mesh, 0.6, 0.3);
  const std::vector<SurfaceCurve> curves{ Curve(mesh,
    { PointInPlane(input, mesh, 0.5, 0.1), middle, middle,
      PointInPlane(input, mesh, 0.6 + 1e-11, 0.3), middle, PointInPlane(input, mesh, 0.8, 0.3) }) };
  const RefinedSurface surface = Embed(mesh, curves);
  ExpectSoundEmbedding(input, mesh, curves, surface);
  const dgg::CurveChain chain = dgg::FollowCurve(surface, curves, 0);
  EXPECT_EQ(chain.Vertices.size(), 3u);
  EXPECT_EQ(chain.Parameters, (std::vector<double>{ 0.0, 1.0, 5.0 }));
  EXPECT_EQ(chain.GivenPoints, (std::vector<dgg::Offset>{ 0, 1, 1, 1, 1, 2 }));
  // All of it in one place.
  const std::vector<SurfaceCurve> still{ Curve(mesh, { middle, middle }, true) };
  const dgg::CurveChain single = dgg::FollowCurve(Embed(mesh, still), still, 0);
  EXPECT_EQ(single.Vertices.size(), 1u);
  EXPECT_EQ(single.Parameters, std::vector<double>{ 0.0 });
  EXPECT_EQ(single.GivenPoints, (std::vector<dgg::Offset>{ 0, 0 }));
}

TEST(CurveEmbedding, CrossingsAndTouchesAreShared)
{
  // In one face: a cross, a curve that ends on it, one along a part of it.
  const TestMesh input = SingleTriangle();
  const dgg::SurfaceMesh mesh = Build(input);
  const auto at = [&](double b, double c) { return PointIn(mesh, 0, { { 1.0 - b - c, b, c } }); };
  const std::vector<SurfaceCurve> curves{ Curve(mesh, { at(0.125, 0.25), at(0.625, 0.25) }),
    Curve(mesh, { at(0.25, 0.125), at(0.25, 0.5) }), Curve(mesh, { at(0.5, 0.25), at(0.5, 0.375) }),
    Curve(mesh, { at(0.25, 0.25), at(0.375, 0.25) }) };
  const RefinedSurface surface = Embed(mesh, curves);
  ExpectSoundEmbedding(input, mesh, curves, surface);
  // The fourth curve adds one; it and the third one have a single edge, which gets a middle.
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
  // The second curve passes the foot of the first one, and the fourth its end, at less than
  // 1e-9: they run through them, rather than to cross just beside them. The third one stays.
  const TestMesh input = SingleTriangle();
  const dgg::SurfaceMesh mesh = Build(input);
  const auto at = [&](double b, double c) { return PointIn(mesh, 0, { { 1.0 - b - c, b, c } }); };
  const std::vector<SurfaceCurve> curves{ Curve(mesh, { at(0.5, 0.0), at(0.5, 0.375) }),
    Curve(mesh, { at(0.25, 1.5e-9), at(0.75, 0.0) }), Curve(mesh, { at(0.0, 3e-9), at(0.25, 0.0) }),
    Curve(mesh, { at(0.25, 0.375 + 5e-10), at(0.625, 0.375) }) };
  const RefinedSurface surface = Embed(mesh, curves);
  ExpectSoundEmbedding(input, mesh, curves, surface);
  EXPECT_EQ(surface.GetNumberOfVertices(), 3 + 2 + 2 + 2 + 2);
  ASSERT_EQ(surface.Paths[1].size(), 3u);
  EXPECT_EQ(surface.Paths[1][1], surface.Paths[0][0]);
  ASSERT_EQ(surface.Paths[3].size(), 3u);
  EXPECT_EQ(surface.Paths[3][1], surface.Paths[0][1]);
  // Across a corner, closer to it than to both of its ends.
  const std::vector<SurfaceCurve> corner{ Curve(mesh, { at(1.2e-9, 0.0), at(0.0, 1.2e-9) }) };
  const RefinedSurface around = Embed(mesh, corner);
  ExpectSoundEmbedding(input, mesh, corner, around);
  EXPECT_EQ(around.GetNumberOfVertices(), 5);
  ASSERT_EQ(around.Paths[0].size(), 3u);
  EXPECT_EQ(around.Paths[0][1], mesh.Origin(0));
}

TEST(CurveEmbedding, SoundMeshes)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    SCOPED_TRACE(named.Name);
    if (named.Name == "SeveralComponents")
    {
      continue; // curves of random points are not connected
    }
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    Random random(23);
    const std::vector<SurfaceCurve> curves = RandomCurves(mesh, 6, 6, random);
    ExpectSoundEmbedding(named.Mesh, mesh, curves, Embed(mesh, curves));
  }
}

TEST(CurveEmbedding, MeshesWithDefects)
{
  // Curves within faces and along their sides: most of these meshes have several components.
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

TEST(CurveEmbedding, EdgesWithManyFaces)
{
  std::vector<Id> sheetOf;
  const TestMesh input = Book(5, 3, sheetOf);
  const dgg::SurfaceMesh mesh = Build(input);
  std::vector<SurfaceCurve> curves;
  Random random(3);
  for (int i = 0; i < 20; ++i)
  {
    curves.push_back(Curve(mesh, RandomCurvePoints(mesh, 5, random)));
  }
  ExpectSoundEmbedding(input, mesh, curves, Embed(mesh, curves));
}

TEST(CurveEmbedding, Fuzz)
{
  Id total = 0;
  std::uint64_t seed = 1;
  for (const TestMesh& input : { SingleTriangle(), Plane(2, 2), Plane(4, 3, 0.25, 7), Octahedron(),
         NoisySphere(1, 0.4, 3), WithNoise(Torus(7, 4), 0.1, 5), Ellipsoid(1, 30.0),
         NeedlePlane(2, 1e-5), CapPlane(2, 1e-5), MisorientedSphere(1, 8) })
  {
    SCOPED_TRACE(seed);
    const dgg::SurfaceMesh mesh = Build(input);
    Random random(++seed);
    for (int i = 0; i < 50; ++i)
    {
      SCOPED_TRACE(i);
      const std::vector<SurfaceCurve> curves = RandomCurves(mesh, 1 + random.Index(8), 8, random);
      total += static_cast<Id>(curves.size());
      ExpectSoundEmbedding(input, mesh, curves, Embed(mesh, curves));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(total, 2000);
}

TEST(CurveEmbedding, IsTheSameAtEveryScale)
{
  const TestMesh input = NoisySphere(1, 0.3, 4);
  const dgg::SurfaceMesh mesh = Build(input);
  Random random(5);
  const std::vector<SurfaceCurve> curves = RandomCurves(mesh, 8, 8, random);
  const RefinedSurface surface = Embed(mesh, curves);
  for (const int exponent : { -220, -30, 30, 220 }) // 6e-67 to 2e66: meshes end at 1e70
  {
    const dgg::SurfaceMesh scaled = Build(Scaled(input, std::ldexp(1.0, exponent)));
    std::vector<SurfaceCurve> same;
    for (const SurfaceCurve& curve : curves)
    {
      std::vector<SurfacePoint> points;
      for (const dgg::Offset place : curve.GivenPoints)
      {
        points.push_back(curve.Path.Points[place]);
      }
      same.push_back(Curve(scaled, points, curve.IsClosed));
    }
    const RefinedSurface other = Embed(scaled, same);
    EXPECT_EQ(other.Triangles, surface.Triangles) << exponent;
    EXPECT_EQ(other.Paths, surface.Paths) << exponent;
    EXPECT_EQ(other.Places, surface.Places) << exponent;
  }
}

TEST(CurveEmbedding, SaysWhatIsWrong)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(1));
  std::vector<SurfaceCurve> curves{ Curve(
    mesh, { SurfacePoint::AtVertex(0), SurfacePoint::AtVertex(5) }) };
  curves.push_back(curves[0]);
  curves[1].Path.Faces[0] = 99999;
  RefinedSurface surface;
  dgg::Status status = dgg::EmbedCurves(mesh, curves, nullptr, surface);
  EXPECT_TRUE(Says(status, "path 1"));
  EXPECT_TRUE(surface.Points.empty());
  curves[1] = curves[0];
  curves[1].Parameters.pop_back();
  status = dgg::EmbedCurves(mesh, curves, nullptr, surface);
  EXPECT_TRUE(Says(status, "curve 1 has"));
  status = dgg::EmbedCurves(
    mesh, { curves[0] }, [](double) { return false; }, surface);
  EXPECT_TRUE(status.IsAborted());
  EXPECT_TRUE(surface.Points.empty());
}
}
