// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces split along paths, and surfaces cut open: the metric is preserved.
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggFaceTriangulation.h"
#include "dggSurfaceCut.h"
#include "dggSurfaceRefinement.h"

namespace dggtest
{
namespace
{
using dgg::GridPoint;
using dgg::SubMesh;
using dgg::SurfacePath;
using dgg::SurfacePoint;

SubMesh Refine(
  const dgg::SurfaceMesh& mesh, const std::vector<SurfacePath>& paths, bool insertCrossings = false)
{
  SubMesh refined;
  dgg::RefinementOptions options;
  options.InsertCrossings = insertCrossings;
  EXPECT_TRUE(Ok(dgg::RefineAlongPaths(mesh, paths, options, refined)));
  return refined;
}

double AreaOf(const std::vector<double>& lengths, Id f)
{
  return dgg::TriangleArea(lengths[3 * f], lengths[3 * f + 1], lengths[3 * f + 2]);
}

/// Checks the invariants of a refined surface: old faces are covered exactly, chains are edges with
/// the lengths of their paths, and distances do not change.
void ExpectSound(const dgg::SurfaceMesh& mesh, const std::vector<SurfacePath>& paths,
  const SubMesh& refined, double tolerance)
{
  ASSERT_EQ(refined.Triangles.size(), 3 * refined.Faces.size());
  ASSERT_EQ(refined.Paths.size(), paths.size());
  std::vector<double> areas(mesh.GetNumberOfFaces(), 0.0);
  std::map<std::pair<Id, Id>, double> edges;
  for (Id f = 0; f < refined.GetNumberOfFaces(); ++f)
  {
    areas[refined.Faces[f]] += AreaOf(refined.Lengths, f);
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Id a = refined.Triangles[h];
      const Id b = refined.Triangles[dgg::SurfaceMesh::Next(h)];
      edges[{ std::min(a, b), std::max(a, b) }] = refined.Lengths[h];
      std::array<double, 3> coordinates{};
      EXPECT_TRUE(dgg::FindInFace(mesh, refined.Points[a], refined.Faces[f], coordinates));
      EXPECT_TRUE(refined.Points[a].Check(mesh).IsOk());
    }
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const double area = mesh.IsDropped(f)
      ? 0.0
      : dgg::TriangleArea(mesh.Length(3 * f), mesh.Length(3 * f + 1), mesh.Length(3 * f + 2));
    EXPECT_NEAR(areas[f], area, 1e-7 * mesh.GetMaximumEdgeLength() * mesh.GetMaximumEdgeLength());
  }
  for (std::size_t p = 0; p < paths.size(); ++p)
  {
    const std::vector<Id>& chain = refined.Paths[p];
    ASSERT_EQ(chain.empty(), paths[p].IsEmpty());
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    {
      const auto edge =
        edges.find({ std::min(chain[i], chain[i + 1]), std::max(chain[i], chain[i + 1]) });
      ASSERT_NE(edge, edges.end())
        << "path " << p << ", vertices " << chain[i] << ", " << chain[i + 1];
      length += edge->second;
    }
    EXPECT_NEAR(length, paths[p].Length, 1e-7 * mesh.GetMaximumEdgeLength() + tolerance);
  }
  dgg::SurfaceMesh fine;
  ASSERT_TRUE(Ok(refined.Build(mesh, fine)));
  for (const Id source : SomeVertices(mesh, 3, 91))
  {
    const auto before = DistancesFrom(mesh, dgg::ExactEngine::Triangle, source);
    auto after = DistancesFrom(fine, dgg::ExactEngine::Triangle, source);
    after.resize(before.size());
    ExpectSameField(before, after, tolerance, "distances");
  }
}

std::vector<SurfacePath> Star(const dgg::SurfaceMesh& mesh, Id count, std::uint64_t seed)
{
  return FindPaths(
    mesh, RandomSurfacePoints(mesh, 1, seed + 2)[0], SomePoints(mesh, count, count, seed));
}
}

TEST(FaceTriangulation, OrientationIsExact)
{
  const std::int64_t one = GridPoint::One;
  EXPECT_EQ(dgg::Orientation({ 0, 0 }, { one, 0 }, { 0, one }), 1);
  EXPECT_EQ(dgg::Orientation({ 0, 0 }, { 0, one }, { one, 0 }), -1);
  EXPECT_EQ(dgg::Orientation({ one, 0 }, { one / 2, one / 2 }, { 0, one }), 0);
  EXPECT_EQ(dgg::Orientation({ one - 1, 0 }, { one / 2, one / 2 }, { 0, one }), 1);
  EXPECT_EQ(dgg::Orientation({ one - 1, 1 }, { one / 2, one / 2 - 1 }, { 0, one - 1 }), -1);
  // Collinear points with coordinates of all magnitudes, and points one unit beside the line.
  Random random(3);
  for (int i = 0; i < 1000; ++i)
  {
    const std::int64_t x = random.Index(1 << 20);
    const std::int64_t y = random.Index(1 << 20);
    const std::int64_t factor = std::int64_t(1) << random.Index(28);
    const std::int64_t more = 1 + random.Index(3);
    const GridPoint a{ 5, 7 };
    const GridPoint b{ 5 + x * factor, 7 + y * factor };
    const GridPoint c{ 5 + x * factor * more, 7 + y * factor * more };
    EXPECT_EQ(dgg::Orientation(a, b, c), 0);
    EXPECT_EQ(dgg::Orientation(a, b, { c.X, c.Y + 1 }), x > 0 ? 1 : 0);
    EXPECT_EQ(dgg::Orientation(a, b, { c.X + 1, c.Y }), y > 0 ? -1 : 0);
  }
}

TEST(FaceTriangulation, RandomPointsAndSegments)
{
  const std::array<dgg::Point2, 3> corners{ { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.5, 1.0 } } };
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
  {
    Random random(seed);
    dgg::FaceTriangulation triangulation(corners);
    std::vector<GridPoint> points{ { 0, 0 }, { GridPoint::One, 0 }, { 0, GridPoint::One } };
    const Id count = random.Index(30);
    for (Id i = 0; i < count; ++i)
    {
      double a = random.Uniform();
      double b = random.Uniform();
      const Id side = random.Index(5);
      const bool swap = a + b > 1.0;
      std::array<double, 3> w{ { 0.0, swap ? 1.0 - a : a, swap ? 1.0 - b : b } };
      w[0] = 1.0 - w[1] - w[2];
      if (side < 3)
      {
        w[side] = 0.0;
      }
      points.push_back(GridPoint::FromBarycentric(w));
      triangulation.AddPoint(points.back());
    }
    std::set<std::pair<int, int>> segments;
    const int n = static_cast<int>(points.size());
    for (int i = 0; i < 3 * n; ++i)
    {
      const int a = random.Index(n);
      const int b = random.Index(n);
      bool isFree = a < b;
      for (int c = 0; c < n && isFree; ++c)
      {
        isFree = c == a || c == b || dgg::Orientation(points[a], points[b], points[c]) != 0;
      }
      for (const std::pair<int, int>& s : segments)
      {
        isFree =
          isFree && !dgg::CrossProperly(points[a], points[b], points[s.first], points[s.second]);
      }
      if (isFree)
      {
        EXPECT_TRUE(triangulation.AddSegment(a, b)) << a << " " << b;
        segments.emplace(a, b);
      }
    }
    triangulation.MakeDelaunay();
    std::set<std::pair<int, int>> edges;
    double doubleArea = 0.0;
    for (const std::array<int, 3>& t : triangulation.GetTriangles())
    {
      EXPECT_EQ(dgg::Orientation(points[t[0]], points[t[1]], points[t[2]]), 1);
      const double x1 = static_cast<double>(points[t[1]].X - points[t[0]].X);
      const double y1 = static_cast<double>(points[t[1]].Y - points[t[0]].Y);
      const double x2 = static_cast<double>(points[t[2]].X - points[t[0]].X);
      const double y2 = static_cast<double>(points[t[2]].Y - points[t[0]].Y);
      doubleArea += x1 * y2 - x2 * y1;
      for (int k = 0; k < 3; ++k)
      {
        edges.emplace(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]));
      }
    }
    const auto one = static_cast<double>(GridPoint::One);
    EXPECT_NEAR(doubleArea / (one * one), 1.0, 1e-12);
    EXPECT_TRUE(std::includes(edges.begin(), edges.end(), segments.begin(), segments.end()));
  }
}

TEST(SurfaceRefinement, TangledPaths)
{
  for (const TestMesh& input :
    { NoisySphere(1, 0.3, 3), Cube(1), Cube(3), WithNoise(Torus(10, 7), 0.05, 4), Plane(5, 5),
      Terrain(6, 2.0, 3), MisorientedSphere(1, 8) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    std::vector<SurfacePath> paths;
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      for (const SurfacePath& path : Star(mesh, 4, 10 * seed))
      {
        paths.push_back(path);
      }
    }
    SubMesh refined;
    const dgg::Status status = dgg::RefineAlongPaths(mesh, paths, {}, refined);
    EXPECT_TRUE(Says(status, "cross in face"));
    EXPECT_TRUE(refined.Points.empty());
    ExpectSound(mesh, paths, Refine(mesh, paths, true), 1e-8 * mesh.GetMaximumEdgeLength());
  }
}

TEST(SurfaceRefinement, CrossingsBecomeVertices)
{
  // Two diagonals of a square of one cell: one along the mesh edge, one across the edge.
  const dgg::SurfaceMesh mesh = Build(Plane(1, 1));
  std::vector<SurfacePath> paths =
    FindPaths(mesh, SurfacePoint::AtVertex(0), { SurfacePoint::AtVertex(3) });
  paths.push_back(FindPaths(mesh, SurfacePoint::AtVertex(1), { SurfacePoint::AtVertex(2) })[0]);
  const SubMesh refined = Refine(mesh, paths); // the paths touch: the edge is crossed at a node
  EXPECT_EQ(refined.GetNumberOfVertices(), 5);
  EXPECT_EQ(refined.GetNumberOfFaces(), 4);
  EXPECT_EQ(refined.Paths[0].size(), 3u);
  EXPECT_EQ(refined.Paths[1].size(), 3u);
  EXPECT_EQ(refined.Paths[0][1], refined.Paths[1][1]);
  // A path inside one face.
  const dgg::SurfaceMesh single = Build(SingleTriangle());
  auto inFace = [&](double a, double b) {
    return SurfacePoint::InFace(single, 0, { { a, b, 1.0 - a - b } });
  };
  paths = FindPaths(single, inFace(0.2, 0.2), { inFace(0.5, 0.3) });
  paths.push_back(FindPaths(single, inFace(0.3, 0.5), { inFace(0.4, 0.1) })[0]);
  const SubMesh crossed = Refine(single, paths, true);
  EXPECT_EQ(crossed.GetNumberOfVertices(), 8);
  EXPECT_EQ(crossed.Paths[0][1], crossed.Paths[1][1]);
  ExpectSound(single, paths, crossed, 1e-12);
  SubMesh none;
  EXPECT_FALSE(dgg::RefineAlongPaths(single, paths, {}, none).IsOk());
}

TEST(SurfaceRefinement, PointsGoBackToTheOldMesh)
{
  for (const TestMesh& input : { NoisySphere(1, 0.3, 3), MisorientedSphere(1, 8) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    const SubMesh refined = Refine(mesh, Star(mesh, 8, 5), true);
    for (Id f = 0; f < refined.GetNumberOfFaces(); f += 3)
    {
      const SurfacePoint middle = refined.ToParent(mesh, f, { { 0.2, 0.3, 0.5 } });
      ASSERT_TRUE(middle.Check(mesh).IsOk());
      const auto p = dgg::PositionOf(mesh, middle, input.Points.data());
      for (int c = 0; c < 3; ++c)
      {
        double expected = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          expected += std::array<double, 3>{ { 0.2, 0.3, 0.5 } }[k] *
            dgg::PositionOf(
              mesh, refined.Points[refined.Triangles[3 * f + k]], input.Points.data())[c];
        }
        EXPECT_NEAR(p[c], expected, 1e-9);
      }
    }
  }
}

TEST(SurfaceCut, SplitsPinchedVertices)
{
  const dgg::SurfaceMesh mesh = Build(TouchingSpheres(1));
  const SubMesh refined = Refine(mesh, {});
  for (const auto pinched : { dgg::PinchedVertices::Stay, dgg::PinchedVertices::Split })
  {
    dgg::SubMesh cut;
    ASSERT_TRUE(dgg::CutAlongChains(refined, {}, cut, pinched).IsOk());
    dgg::SurfaceMesh opened;
    ASSERT_TRUE(cut.Build(mesh, opened).IsOk());
    Id components = 0;
    opened.ComputeComponents(components);
    const Id more = pinched == dgg::PinchedVertices::Split ? 1 : 0;
    EXPECT_EQ(components, 1 + more);
    EXPECT_EQ(opened.GetNumberOfVertices(), mesh.GetNumberOfVertices() + more);
    EXPECT_EQ(cut.VertexOf.back(), more == 1 ? 0 : mesh.GetNumberOfVertices() - 1);
  }
}
}
