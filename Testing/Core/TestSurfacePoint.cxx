// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Points at vertices, on edges and inside faces: snapping, checks, distances.
#include "TestMeshes.h"

#include "dggSurfacePath.h"
#include "dggSurfacePoint.h"

namespace dggtest
{
namespace
{
using dgg::NoId;
using dgg::SurfacePoint;
using Support = SurfacePoint::Support;

void ExpectBad(const SurfacePoint& point, const dgg::SurfaceMesh& mesh, const std::string& message)
{
  const dgg::Status status = point.Check(mesh);
  EXPECT_FALSE(status.IsOk());
  EXPECT_TRUE(Says(status, message));
}
}

TEST(SurfacePoint, SnapsToVertices)
{
  const dgg::SurfaceMesh mesh = Build(TwoTriangles(0.3));
  for (int k = 0; k < 3; ++k)
  {
    for (const double off : { 0.0, 1e-10, -1e-10 })
    {
      std::array<double, 3> b{ { 0.0, 0.0, 0.0 } };
      b[k] = 1.0 - off;
      b[(k + 1) % 3] = off;
      const SurfacePoint point = SurfacePoint::InFace(mesh, 1, b);
      EXPECT_EQ(point.On, Support::Vertex);
      EXPECT_EQ(point.Vertex, mesh.Origin(3 + k));
      EXPECT_TRUE(point.Check(mesh).IsOk());
    }
  }
  EXPECT_EQ(SurfacePoint::OnEdge(mesh, 4, 0.0).Vertex, mesh.Origin(4));
  EXPECT_EQ(SurfacePoint::OnEdge(mesh, 4, 1.0).Vertex, mesh.Destination(4));
  EXPECT_EQ(SurfacePoint::OnEdge(mesh, 4, 1e-10).Vertex, mesh.Origin(4));
}

TEST(SurfacePoint, SnapsToEdges)
{
  const dgg::SurfaceMesh mesh = Build(TwoTriangles(0.3));
  for (int k = 0; k < 3; ++k)
  {
    for (const double off : { 0.0, 1e-10, -1e-10 })
    {
      std::array<double, 3> b{ { 0.5, 0.5, 0.5 } };
      b[k] = 0.25;
      b[(k + 1) % 3] = 0.75 - off;
      b[(k + 2) % 3] = off;
      const SurfacePoint point = SurfacePoint::InFace(mesh, 0, b);
      ASSERT_EQ(point.On, Support::Edge);
      EXPECT_EQ(point.HalfEdge, k);
      EXPECT_EQ(point.Face, 0);
      EXPECT_EQ(point.Barycentric[(k + 2) % 3], 0.0);
      EXPECT_NEAR(point.Barycentric[k], 0.25, 1e-9);
      const SurfacePoint same = SurfacePoint::OnEdge(mesh, k, 0.75);
      EXPECT_EQ(same.On, Support::Edge);
      EXPECT_EQ(same.HalfEdge, k);
      EXPECT_NEAR(same.Barycentric[(k + 1) % 3], 0.75, 1e-15);
    }
  }
}

TEST(SurfacePoint, StaysInsideFaces)
{
  const dgg::SurfaceMesh mesh = Build(TwoTriangles(0.3));
  const SurfacePoint point = SurfacePoint::InFace(mesh, 0, { { 0.2, 0.3, 0.5 } });
  EXPECT_EQ(point.On, Support::Face);
  EXPECT_EQ(point.Face, 0);
  EXPECT_EQ(point.Barycentric, (std::array<double, 3>{ { 0.2, 0.3, 0.5 } }));
  // Coordinates slightly outside, and with a slightly wrong sum, are corrected.
  const SurfacePoint rough = SurfacePoint::InFace(mesh, 0, { { 0.2, 0.3, 0.5 + 1e-7 } });
  EXPECT_TRUE(rough.Check(mesh).IsOk());
  EXPECT_NEAR(rough.Barycentric[0] + rough.Barycentric[1] + rough.Barycentric[2], 1.0, 1e-15);
  // Two orders of magnitude above the tolerance nothing snaps.
  EXPECT_EQ(SurfacePoint::InFace(mesh, 0, { { 0.5, 0.5 - 1e-7, 1e-7 } }).On, Support::Face);
}

TEST(SurfacePoint, RefersToTheCornersOfTheInput)
{
  TestMesh input = Plane(2, 1);
  std::swap(input.Triangles[3], input.Triangles[4]); // one face of four is reversed
  const dgg::SurfaceMesh mesh = Build(input);
  ASSERT_TRUE(mesh.IsFlipped(1));
  const std::array<double, 3> b{ { 0.2, 0.3, 0.5 } };
  const SurfacePoint point = SurfacePoint::InFace(mesh, 1, b);
  for (int k = 0; k < 3; ++k)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (mesh.GetTriangle(1)[i] == input.Triangles[3 + k])
      {
        EXPECT_EQ(point.Barycentric[i], b[k]);
      }
    }
  }
}

TEST(SurfacePoint, MeasuresWithinFaces)
{
  // triangle (0,0) (4,0) (1,3)
  const dgg::SurfaceMesh mesh = Build(SingleTriangle());
  const std::array<double, 3> p{ { 0.25, 0.5, 0.25 } }; // (2.25, 0.75)
  const std::array<double, 3> q{ { 0.5, 0.25, 0.25 } }; // (1.25, 0.75)
  EXPECT_NEAR(dgg::DistanceInFace(mesh, 0, p, q), 1.0, 1e-15);
  EXPECT_EQ(dgg::DistanceInFace(mesh, 0, p, p), 0.0);
  EXPECT_NEAR(dgg::DistanceToCorner(mesh, 0, p, 0), std::hypot(2.25, 0.75), 1e-15);
  EXPECT_NEAR(dgg::DistanceToCorner(mesh, 0, p, 1), std::hypot(1.75, 0.75), 1e-15);
  EXPECT_NEAR(dgg::DistanceToCorner(mesh, 0, p, 2), std::hypot(1.25, 2.25), 1e-15);
  // The position in the frame of each half-edge.
  const dgg::Point2 along = dgg::PlaceInFrame(mesh, 0, p);
  EXPECT_NEAR(along.X, 2.25, 1e-15);
  EXPECT_NEAR(along.Y, 0.75, 1e-15);
  for (Id h = 0; h < 3; ++h)
  {
    const dgg::Point2 place = dgg::PlaceInFrame(mesh, h, p);
    EXPECT_NEAR(std::hypot(place.X, place.Y), dgg::DistanceToCorner(mesh, 0, p, h), 1e-14);
  }
}

TEST(SurfacePoint, SamePoints)
{
  const dgg::SurfaceMesh mesh = Build(TwoTriangles(0.5));
  const std::array<double, 3> middle{ { 0.2, 0.3, 0.5 } };
  const SurfacePoint inside = SurfacePoint::InFace(mesh, 0, middle);
  EXPECT_TRUE(dgg::IsSamePoint(inside, SurfacePoint::InFace(mesh, 0, middle)));
  EXPECT_FALSE(dgg::IsSamePoint(inside, SurfacePoint::InFace(mesh, 1, middle)));
  EXPECT_FALSE(dgg::IsSamePoint(inside, SurfacePoint::InFace(mesh, 0, { { 0.3, 0.2, 0.5 } })));
  const SurfacePoint onEdge = SurfacePoint::OnEdge(mesh, 0, 0.25);
  EXPECT_TRUE(dgg::IsSamePoint(onEdge, SurfacePoint::InFace(mesh, 0, { { 0.75, 0.25, 0.0 } })));
  EXPECT_FALSE(dgg::IsSamePoint(onEdge, SurfacePoint::OnEdge(mesh, 0, 0.5)));
  // A point at a vertex is the same, in whichever way it is given.
  const dgg::Id v = mesh.Origin(0);
  EXPECT_TRUE(dgg::IsSamePoint(SurfacePoint::AtVertex(v), SurfacePoint::OnEdge(mesh, 0, 0.0)));
  EXPECT_TRUE(dgg::IsSamePoint(SurfacePoint::OnEdge(mesh, 0, 0.0), SurfacePoint::AtVertex(v)));
  EXPECT_FALSE(dgg::IsSamePoint(SurfacePoint::AtVertex(v), SurfacePoint::OnEdge(mesh, 0, 1.0)));
  EXPECT_FALSE(dgg::IsSamePoint(SurfacePoint::AtVertex(v), onEdge));
  EXPECT_TRUE(dgg::IsVertex(SurfacePoint::OnEdge(mesh, 0, 0.0)));
  EXPECT_FALSE(dgg::IsVertex(onEdge));
}

TEST(SurfacePoint, PlacesNearPointsOfACloud)
{
  const SurfacePoint near = SurfacePoint::NearVertex(2, { { 0.5, 0.0, -1.0 } });
  EXPECT_EQ(near.On, Support::Near);
  EXPECT_EQ(near.Vertex, 2);
  EXPECT_FALSE(dgg::IsVertex(near));
  EXPECT_TRUE(dgg::IsVertex(SurfacePoint::NearVertex(2, { { 0.0, 0.0, 0.0 } })));
  EXPECT_TRUE(dgg::IsSamePoint(near, SurfacePoint::NearVertex(2, { { 0.5, 0.0, -1.0 } })));
  EXPECT_FALSE(dgg::IsSamePoint(near, SurfacePoint::NearVertex(1, { { 0.5, 0.0, -1.0 } })));
  EXPECT_FALSE(dgg::IsSamePoint(near, SurfacePoint::NearVertex(2, { { 0.5, 0.0, 1.0 } })));
  EXPECT_FALSE(dgg::IsSamePoint(near, SurfacePoint::AtVertex(2)));

  const std::vector<double> cloud{ 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 3.0, 4.0 };
  dgg::SurfaceMesh mesh;
  ASSERT_TRUE(dgg::SurfaceMesh::FromPoints(cloud.data(), 3, nullptr, 0, mesh).IsOk());
  EXPECT_EQ(mesh.GetNumberOfVertices(), 3);
  const std::array<double, 3> expected{ { 2.5, 3.0, 3.0 } };
  EXPECT_EQ(dgg::PositionOf(mesh, near, cloud.data()), expected);
  EXPECT_EQ(dgg::FindFaceOf(mesh, near), NoId);
  ExpectBad(near, mesh, "clouds only");
}

TEST(SurfacePoint, TangentPlanesOfInteriorVerticesAreUnrolled)
{
  const dgg::SurfaceMesh cube = Build(Cube(2));
  const auto factorAt = [&](double x, double y, double z) {
    return dgg::UnrollFactor(cube, SurfacePoint::AtVertex(VertexAt(Cube(2), x, y, z)));
  };
  EXPECT_NEAR(factorAt(0.0, 0.0, 0.0), 4.0 / 3.0, 1e-14); // three right angles
  EXPECT_NEAR(factorAt(0.5, 0.0, 0.0), 1.0, 1e-14);
  EXPECT_EQ(dgg::UnrollFactor(cube, SurfacePoint::InFace(cube, 0, { { 0.2, 0.3, 0.5 } })), 1.0);
  EXPECT_EQ(dgg::UnrollFactor(cube, SurfacePoint::OnEdge(cube, 0, 0.5)), 1.0);
  const dgg::SurfaceMesh triangle = Build(SingleTriangle());
  EXPECT_EQ(dgg::UnrollFactor(triangle, SurfacePoint::AtVertex(0)), 1.0); // boundary
  const TestMesh lonely = SphereWithIsolatedPoints(1);
  const dgg::SurfaceMesh sphere = Build(lonely);
  int isolated = 0;
  for (dgg::Id v = 0; v < sphere.GetNumberOfVertices(); ++v)
  {
    const bool isIsolated = sphere.FanBegin(v) == sphere.FanEnd(v);
    isolated += isIsolated ? 1 : 0;
    const double factor = dgg::UnrollFactor(sphere, SurfacePoint::AtVertex(v));
    EXPECT_EQ(factor == 1.0, isIsolated) << v;
  }
  EXPECT_GT(isolated, 0);
}
}
