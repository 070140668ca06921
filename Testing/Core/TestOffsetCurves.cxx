// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Offset curves of a curve.
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggOffsetCurves.h"

namespace dggtest
{
namespace
{
using dgg::SurfacePath;
using dgg::SurfacePoint;

std::vector<SurfacePath> Tape(const dgg::SurfaceMesh& mesh, const SurfacePath& path, double width)
{
  std::vector<SurfacePath> rims;
  EXPECT_TRUE(Ok(dgg::MakeOffsetCurves(mesh, path, width, nullptr, rims)));
  for (const SurfacePath& rim : rims)
  {
    EXPECT_TRUE(Ok(dgg::CheckPath(mesh, rim)));
  }
  return rims;
}

/// Returns points on a path with a spacing of at most `spacing`.
std::vector<dgg::GeodesicSource> PointsAlong(
  const dgg::SurfaceMesh& mesh, const SurfacePath& path, double spacing)
{
  std::vector<dgg::GeodesicSource> sources{ { path.Points.front(), 0.0 } };
  for (std::size_t i = 0; i < path.Faces.size(); ++i)
  {
    const Id face = path.Faces[i];
    std::array<double, 3> from{};
    std::array<double, 3> to{};
    EXPECT_TRUE(dgg::FindInFace(mesh, path.Points[i], face, from));
    EXPECT_TRUE(dgg::FindInFace(mesh, path.Points[i + 1], face, to));
    const auto pieces =
      static_cast<int>(std::ceil(dgg::DistanceInFace(mesh, face, from, to) / spacing));
    for (int k = 1; k < pieces; ++k)
    {
      const double t = static_cast<double>(k) / pieces;
      std::array<double, 3> between{};
      for (int c = 0; c < 3; ++c)
      {
        between[c] = (1.0 - t) * from[c] + t * to[c];
      }
      if (mesh.IsFlipped(face))
      {
        std::swap(between[1], between[2]); // to the order of the corners in the input
      }
      sources.push_back({ SurfacePoint::InFace(mesh, face, between), 0.0 });
    }
    sources.push_back({ path.Points[i + 1], 0.0 });
  }
  return sources;
}

/// Expects all points of the rims to lie at the given distance from the path.
void ExpectAtDistance(const dgg::SurfaceMesh& mesh, const SurfacePath& path,
  const std::vector<SurfacePath>& rims, double distance, double tolerance)
{
  // Between two sample points the path is nearer by at most 1e-6 of the distance.
  const std::vector<dgg::GeodesicSource> sources = PointsAlong(mesh, path, 2e-3 * distance);
  dgg::ExactOptions options;
  for (const SurfacePath& rim : rims)
  {
    options.Targets.insert(options.Targets.end(), rim.Points.begin(), rim.Points.end());
  }
  dgg::ExactResult result;
  ASSERT_TRUE(dgg::ExactGeodesics(mesh).Run(sources, options, result).IsOk());
  for (const double d : result.TargetDistances)
  {
    EXPECT_GT(d, distance * (1.0 - tolerance));
    EXPECT_LT(d, distance * (1.0 + tolerance));
  }
}
}

TEST(Tape, AroundAPrism)
{
  const Id sides = 6;
  const Id around = 4 * sides;
  const dgg::SurfaceMesh mesh = Build(PrismSide(sides, 4, 8, 0.0));
  SurfacePath loop; // along the edges of the middle row
  for (Id i = 0; i <= around; ++i)
  {
    loop.Points.push_back(SurfacePoint::AtVertex(4 * around + i % around));
    if (i > 0)
    {
      const Id a = loop.Points[i - 1].Vertex;
      const Id b = loop.Points[i].Vertex;
      for (const Id* g = mesh.FanBegin(a); g != mesh.FanEnd(a); ++g)
      {
        if (mesh.Destination(*g) == b || mesh.Apex(*g) == b)
        {
          loop.Faces.push_back(dgg::SurfaceMesh::Face(*g));
          break;
        }
      }
      loop.Length += dgg::MeasurePiece(mesh, loop, i - 1);
    }
  }
  for (const double width : { 0.3, 1.5, 6.0 })
  {
    const std::vector<SurfacePath> rims = Tape(mesh, loop, width);
    ASSERT_EQ(rims.size(), 2u);
    for (const SurfacePath& rim : rims)
    {
      EXPECT_NEAR(rim.Length, sides, 1e-4 * sides);
      EXPECT_EQ(rim.Points.front().HalfEdge, rim.Points.back().HalfEdge);
    }
  }
  EXPECT_TRUE(Tape(mesh, loop, 20.0).empty()); // wider than the surface
}

TEST(Tape, AroundASegment)
{
  // The offset curve is a stadium: two straight sides, two half circles.
  const Id n = 40;
  const dgg::SurfaceMesh mesh = Build(Plane(n, n, 0.2, 3));
  const Id row = (n / 2) * (n + 1);
  const SurfacePath path = PathBetween(mesh, row + 10, row + 30);
  const double width = 12.0;
  const std::vector<SurfacePath> rims = Tape(mesh, path, width);
  ASSERT_EQ(rims.size(), 1u);
  EXPECT_NEAR(rims[0].Length / (2.0 * path.Length + dgg::Pi * width), 1.0, 2e-3);
  ExpectAtDistance(mesh, path, rims, 0.5 * width, 1e-4);
}

TEST(Tape, OfAPathThatCrossesItself)
{
  // A bow tie has one rim around it, and one in each of its two triangles.
  const Id n = 20;
  const dgg::SurfaceMesh mesh = Build(Plane(n, n, 0.2, 3));
  const Id corners[] = { 5, 15, 5, 15 };
  const Id rows[] = { 5, 15, 15, 5 };
  SurfacePath path;
  for (int k = 0; k < 4; ++k)
  {
    const int next = (k + 1) % 4;
    AppendPath(
      PathBetween(mesh, rows[k] * (n + 1) + corners[k], rows[next] * (n + 1) + corners[next]),
      path);
  }
  const std::vector<SurfacePath> rims = Tape(mesh, path, 1.0);
  ASSERT_EQ(rims.size(), 3u);
  ExpectAtDistance(mesh, path, rims, 0.5, 1e-4);
  EXPECT_GT(std::max({ rims[0].Length, rims[1].Length, rims[2].Length }), path.Length);
}

/// Returns the distance between a point and a segment in the plane.
double DistanceToSegment(
  const std::array<double, 3>& p, const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  const double x = b[0] - a[0];
  const double y = b[1] - a[1];
  const double along = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y);
  const double t = std::max(0.0, std::min(1.0, along));
  return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}

TEST(Tape, InTrianglesOfAnySize)
{
  // Around a triangle: the outer rim consists of its sides and three arcs that sum to a circle; the
  // inner rim is a smaller triangle. All may lie within two faces, or even in one.
  using Corner = std::array<double, 2>;
  const std::array<std::array<Corner, 3>, 2> triangles{ {
    { { { { 0.2, 0.2 } }, { { 0.8, 0.25 } }, { { 0.7, 0.8 } } } },
    { { { { 0.5, 0.1 } }, { { 0.9, 0.15 } }, { { 0.85, 0.4 } } } },
  } };
  for (const std::array<Corner, 3>& triangle : triangles)
  {
    for (const Id n : { 1, 2, 19 })
    {
      const TestMesh points = Scaled(Plane(n, n), 1.0 / n);
      const dgg::SurfaceMesh mesh = Build(points);
      SurfacePath loop;
      double room = 0.0; // length that the inner sides lose, in units of the distance
      for (int k = 0; k < 3; ++k)
      {
        const Corner& a = triangle[k];
        const Corner& b = triangle[(k + 1) % 3];
        const Corner& c = triangle[(k + 2) % 3];
        AppendPath(FindPaths(mesh, PointInPlane(points, mesh, a[0], a[1]),
                     { PointInPlane(points, mesh, b[0], b[1]) })[0],
          loop);
        const double ab = std::atan2(b[1] - a[1], b[0] - a[0]);
        const double ac = std::atan2(c[1] - a[1], c[0] - a[0]);
        room += 2.0 / std::tan(0.5 * std::abs(std::remainder(ac - ab, 2.0 * dgg::Pi)));
      }
      loop.Points.back() = loop.Points.front();
      for (const double distance : { 0.04, 0.015 })
      {
        const std::vector<SurfacePath> rims = Tape(mesh, loop, 2.0 * distance);
        ASSERT_EQ(rims.size(), 2u) << n;
        const double outside = loop.Length + 2.0 * dgg::Pi * distance;
        const double inside = loop.Length - room * distance;
        EXPECT_NEAR(std::max(rims[0].Length, rims[1].Length), outside, 1e-3 * outside) << n;
        EXPECT_NEAR(std::min(rims[0].Length, rims[1].Length), inside, 1e-3 * inside) << n;
        for (const SurfacePath& rim : rims)
        {
          EXPECT_TRUE(dgg::IsSamePoint(rim.Points.front(), rim.Points.back()));
          for (const SurfacePoint& point : rim.Points)
          {
            const auto p = dgg::PositionOf(mesh, point, points.Points.data());
            double nearest = dgg::Infinity;
            for (int k = 0; k < 3; ++k)
            {
              nearest = std::min(nearest, DistanceToSegment(p, triangle[k], triangle[(k + 1) % 3]));
            }
            EXPECT_NEAR(nearest, distance, 5e-5 * distance);
          }
        }
      }
    }
  }
}

TEST(Tape, EndsAtTheBoundary)
{
  const dgg::SurfaceMesh mesh = Build(Plane(10, 10));
  const std::vector<SurfacePath> rims = Tape(mesh, PathBetween(mesh, 55, 65), 3.0);
  ASSERT_EQ(rims.size(), 2u); // the path is straight
  EXPECT_NEAR(rims[0].Length, rims[1].Length, 1e-3);
}

TEST(Tape, OnAllKindsOfMeshes)
{
  for (const NamedMesh& named : AllMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    if (mesh.GetNumberOfVertices() > 1000)
    {
      continue;
    }
    const std::vector<Id> ends = SomeVertices(mesh, 4, 9);
    const SurfacePath path = PathBetween(mesh, ends[1], ends[2]);
    if (path.Faces.empty())
    {
      continue;
    }
    const double width = 0.3 * path.Length;
    ExpectAtDistance(mesh, path, Tape(mesh, path, width), 0.5 * width, 1e-3);
  }
}

}
