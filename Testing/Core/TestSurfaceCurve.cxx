// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves through points of a surface: straight in faces, shortest paths between them.
#include "CurveChecks.h"
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
using dgg::NoId;
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

}
