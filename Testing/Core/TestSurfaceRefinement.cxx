// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces split along paths, and surfaces cut open: the metric stays what it was.
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggFaceTriangulation.h"
#include "dggSurfaceCut.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace dggtest
{
namespace
{
using dgg::GridPoint;
using dgg::RefinedSurface;
using dgg::SurfacePath;
using dgg::SurfacePoint;

RefinedSurface Refine(
  const dgg::SurfaceMesh& mesh, const std::vector<SurfacePath>& paths, bool insertCrossings = false)
{
  RefinedSurface refined;
  dgg::RefinementOptions options;
  options.InsertCrossings = insertCrossings;
  EXPECT_TRUE(Ok(dgg::RefineAlongPaths(mesh, paths, options, refined)));
  return refined;
}

double AreaOf(const std::vector<double>& lengths, Id f)
{
  return dgg::TriangleArea(lengths[3 * f], lengths[3 * f + 1], lengths[3 * f + 2]);
}

/// Everything that must hold of a refined surface: old faces are covered exactly, chains are edges
/// and as long as their paths, and distances do not change.
void ExpectSound(const dgg::SurfaceMesh& mesh, const std::vector<SurfacePath>& paths,
  const RefinedSurface& refined, double tolerance)
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
  // In line, with coordinates of all magnitudes; and one unit beside the line.
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

TEST(FaceTriangulation, ManyPointsAndSegments)
{
  // Chains side by side, and so many points on a side that a fan to the corner would be slow.
  const std::array<dgg::Point2, 3> corners{ { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.5, 1.0 } } };
  std::vector<GridPoint> points;
  const int lines = 400;
  const int steps = 50;
  for (int i = 1; i <= lines; ++i)
  {
    const double radius = 0.9 * i / lines;
    for (int k = 0; k <= steps; ++k)
    {
      const double t = static_cast<double>(k) / steps;
      const double bend = 1.0 + 0.1 * t * (1.0 - t);
      const double b = radius * t * bend;
      const double c = radius * (1.0 - t) * bend;
      points.push_back(GridPoint::FromBarycentric({ { 1.0 - b - c, b, c } }));
    }
  }
  std::vector<std::size_t> order = dgg::MakeInsertionOrder(points);
  dgg::FaceTriangulation triangulation(corners);
  std::vector<GridPoint> places{ { 0, 0 }, { GridPoint::One, 0 }, { 0, GridPoint::One } };
  std::vector<int> numbers(points.size());
  for (const std::size_t i : order)
  {
    numbers[i] = triangulation.AddPoint(points[i]);
    places.push_back(points[i]);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ASSERT_EQ(order[i], i);
  }
  const auto isSegment = [&](std::size_t i) { return i % (steps + 1) < steps; };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_TRUE(!isSegment(i) || triangulation.AddSegment(numbers[i], numbers[i + 1]));
  }
  triangulation.MakeDelaunay();
  const std::vector<std::array<int, 3>>& triangles = triangulation.GetTriangles();
  // Euler: two sides carry points.
  const std::size_t onSides = 3 + 2 * lines;
  EXPECT_EQ(triangles.size(), 2 * places.size() - 2 - onSides);
  std::map<std::pair<int, int>, int> edges; // and the corners opposite
  for (const std::array<int, 3>& t : triangles)
  {
    EXPECT_EQ(dgg::Orientation(places[t[0]], places[t[1]], places[t[2]]), 1);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(edges.emplace(std::make_pair(t[k], t[(k + 1) % 3]), t[(k + 2) % 3]).second);
    }
  }
  std::set<std::pair<int, int>> segments;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (isSegment(i))
    {
      const std::pair<int, int> ends = std::minmax(numbers[i], numbers[i + 1]);
      segments.insert(ends);
      EXPECT_EQ(edges.count(ends) + edges.count({ ends.second, ends.first }), 2u);
    }
  }
  // All other edges are Delaunay.
  auto angleAt = [&](int apex, int a, int b) {
    auto way = [&](int to) {
      const double x = static_cast<double>(places[to].X - places[apex].X);
      const double y = static_cast<double>(places[to].Y - places[apex].Y);
      return dgg::Point2{ 2.0 * x + 0.5 * y, y };
    };
    const dgg::Point2 u = way(a);
    const dgg::Point2 v = way(b);
    return std::atan2(dgg::Cross(u, v), dgg::Dot(u, v));
  };
  for (const auto& edge : edges)
  {
    const int a = edge.first.first;
    const int b = edge.first.second;
    const auto twin = edges.find({ b, a });
    if (twin != edges.end() && segments.count(std::minmax(a, b)) == 0)
    {
      EXPECT_LE(angleAt(edge.second, a, b) + angleAt(twin->second, b, a), dgg::Pi + 1e-8);
    }
  }
}

TEST(SurfaceRefinement, NothingToDo)
{
  for (const NamedMesh& named : DefectMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const RefinedSurface refined = Refine(mesh, {});
    EXPECT_EQ(refined.GetNumberOfVertices(), mesh.GetNumberOfVertices());
    ExpectSound(mesh, {}, refined, 1e-9 * mesh.GetMaximumEdgeLength());
  }
}

TEST(SurfaceRefinement, Stars)
{
  const auto expectSound = [](const NamedMesh& named, double tolerance) {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const auto paths = Star(mesh, 8, 5);
    ExpectSound(mesh, paths, Refine(mesh, paths, true), tolerance * mesh.GetMaximumEdgeLength());
  };
  for (const NamedMesh& named : SoundMeshes())
  {
    expectSound(named, 1e-8);
  }
  for (const NamedMesh& named : DefectMeshes())
  {
    // Parts of narrow faces are made wider, to some 1e-7 edges, when they become degenerate.
    expectSound(named, 1e-6);
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
    RefinedSurface refined;
    const dgg::Status status = dgg::RefineAlongPaths(mesh, paths, {}, refined);
    EXPECT_TRUE(Says(status, "cross in face"));
    EXPECT_TRUE(refined.Points.empty());
    ExpectSound(mesh, paths, Refine(mesh, paths, true), 1e-8 * mesh.GetMaximumEdgeLength());
  }
}

TEST(SurfaceRefinement, CrossingsBecomeVertices)
{
  // Two diagonals of a square of one cell: one along the mesh edge, one across it.
  const dgg::SurfaceMesh mesh = Build(Plane(1, 1));
  std::vector<SurfacePath> paths =
    FindPaths(mesh, SurfacePoint::AtVertex(0), { SurfacePoint::AtVertex(3) });
  paths.push_back(FindPaths(mesh, SurfacePoint::AtVertex(1), { SurfacePoint::AtVertex(2) })[0]);
  const RefinedSurface refined = Refine(mesh, paths); // they touch: the edge is crossed at a node
  EXPECT_EQ(refined.GetNumberOfVertices(), 5);
  EXPECT_EQ(refined.GetNumberOfFaces(), 4);
  EXPECT_EQ(refined.Paths[0].size(), 3u);
  EXPECT_EQ(refined.Paths[1].size(), 3u);
  EXPECT_EQ(refined.Paths[0][1], refined.Paths[1][1]);
  // Inside one face.
  const dgg::SurfaceMesh single = Build(SingleTriangle());
  auto inFace = [&](double a, double b) {
    return SurfacePoint::InFace(single, 0, { { a, b, 1.0 - a - b } });
  };
  paths = FindPaths(single, inFace(0.2, 0.2), { inFace(0.5, 0.3) });
  paths.push_back(FindPaths(single, inFace(0.3, 0.5), { inFace(0.4, 0.1) })[0]);
  const RefinedSurface crossed = Refine(single, paths, true);
  EXPECT_EQ(crossed.GetNumberOfVertices(), 8);
  EXPECT_EQ(crossed.Paths[0][1], crossed.Paths[1][1]);
  ExpectSound(single, paths, crossed, 1e-12);
  RefinedSurface none;
  EXPECT_FALSE(dgg::RefineAlongPaths(single, paths, {}, none).IsOk());
}

TEST(SurfaceRefinement, PointsGoBackToTheOldMesh)
{
  for (const TestMesh& input : { NoisySphere(1, 0.3, 3), MisorientedSphere(1, 8) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    const RefinedSurface refined = Refine(mesh, Star(mesh, 8, 5), true);
    for (Id f = 0; f < refined.GetNumberOfFaces(); f += 3)
    {
      const SurfacePoint middle = refined.ToOldMesh(mesh, f, { { 0.2, 0.3, 0.5 } });
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

TEST(SurfaceRefinement, ProgressGrows)
{
  // A straight line, one that goes back and forth to points of it, and one that crosses it often:
  // pieces are split at nodes and at crossings, both more than once.
  const dgg::SurfaceMesh mesh = Build(SingleTriangle());
  constexpr int Count = 600;
  std::vector<SurfacePath> paths(3);
  auto at = [&](double x, double y) {
    return SurfacePoint::InFace(mesh, 0, { { 1.0 - x - y, x, y } });
  };
  paths[0].Points = { at(0.1, 0.3), at(0.6, 0.3) };
  for (int i = 0; i < Count; ++i)
  {
    const double x = 0.1 + 0.5 * (i + 0.5) / Count;
    paths[1].Points.push_back(at(x, 0.3));
    paths[2].Points.push_back(at(x + 0.1 / Count, i % 2 == 0 ? 0.2 : 0.4));
  }
  for (SurfacePath& path : paths)
  {
    path.Faces.assign(path.Points.size() - 1, 0);
    for (std::size_t i = 0; i < path.Faces.size(); ++i)
    {
      path.Length += dgg::MeasurePiece(mesh, path, i);
    }
  }
  ProgressListener listener;
  dgg::RefinementOptions options;
  options.InsertCrossings = true;
  options.Progress = std::ref(listener);
  RefinedSurface refined;
  ASSERT_TRUE(Ok(dgg::RefineAlongPaths(mesh, paths, options, refined)));
  EXPECT_GT(refined.GetNumberOfVertices(), 3 + 2 + 3 * (Count - 1));
  EXPECT_GT(listener.Calls, 10);
  // Without a listener the result is the same.
  EXPECT_EQ(Refine(mesh, paths, true).Triangles, refined.Triangles);
}

TEST(SurfaceRefinement, SaysWhatIsWrong)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(1));
  std::vector<SurfacePath> paths(2);
  paths[0] = FindPaths(mesh, SurfacePoint::AtVertex(0), { SurfacePoint::AtVertex(3) })[0];
  paths[1] = paths[0];
  paths[1].Faces[0] = 99999;
  RefinedSurface refined;
  dgg::Status status = dgg::RefineAlongPaths(mesh, paths, {}, refined);
  EXPECT_TRUE(Says(status, "path 1"));
  paths[1] = paths[0];
  paths[1].Points[0].Vertex = -3;
  status = dgg::RefineAlongPaths(mesh, paths, {}, refined);
  EXPECT_TRUE(Says(status, "vertex -3"));
}

TEST(SurfaceCut, OpensAlongASlit)
{
  // A plane cut from the middle to the rim: the way round the tip.
  const TestMesh input = Plane(6, 6, 0.2, 4);
  const dgg::SurfaceMesh mesh = Build(input);
  const SurfacePoint tip = SurfacePoint::InFace(mesh, 31, { { 0.3, 0.3, 0.4 } });
  const Id rim = VertexAt(input, 6, 3, 0);
  const auto paths = FindPaths(mesh, tip, { SurfacePoint::AtVertex(rim) });
  const RefinedSurface refined = Refine(mesh, paths);
  dgg::CutSurface cut;
  ASSERT_TRUE(dgg::CutAlongChains(refined, refined.Paths, cut).IsOk());
  // All but the tip are there twice.
  EXPECT_EQ(cut.VertexOf.size(), refined.Points.size() + refined.Paths[0].size() - 1);
  dgg::SurfaceMesh opened;
  ASSERT_TRUE(cut.Build(mesh, opened).IsOk());
  Id components = 0;
  opened.ComputeComponents(components);
  EXPECT_EQ(components, 1);
  const auto other =
    std::find(cut.VertexOf.begin() + refined.GetNumberOfVertices(), cut.VertexOf.end(), rim);
  ASSERT_NE(other, cut.VertexOf.end());
  const double around =
    DistancesFrom(opened, dgg::ExactEngine::Triangle, rim)[other - cut.VertexOf.begin()];
  EXPECT_NEAR(around, 2.0 * paths[0].Length, 1e-9);
}

TEST(SurfaceCut, SplitsPinchedVertices)
{
  const dgg::SurfaceMesh mesh = Build(TouchingSpheres(1));
  const RefinedSurface refined = Refine(mesh, {});
  for (const auto pinched : { dgg::PinchedVertices::Stay, dgg::PinchedVertices::Split })
  {
    dgg::CutSurface cut;
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

TEST(SurfaceCut, SeparatesAndDoesNot)
{
  // A closed path round a torus does not separate it; the boundary of an octant of a sphere does.
  const dgg::SurfaceMesh torus = Build(Torus(16, 10));
  std::vector<std::vector<Id>> ring(1);
  for (Id i = 0; i <= 16; ++i)
  {
    ring[0].push_back(i % 16);
  }
  RefinedSurface refined = Refine(torus, {});
  dgg::CutSurface cut;
  ASSERT_TRUE(dgg::CutAlongChains(refined, ring, cut).IsOk());
  dgg::SurfaceMesh opened;
  ASSERT_TRUE(cut.Build(torus, opened).IsOk());
  Id components = 0;
  opened.ComputeComponents(components);
  EXPECT_EQ(components, 1);
  EXPECT_EQ(opened.GetNumberOfVertices(), torus.GetNumberOfVertices() + 16);

  const dgg::SurfaceMesh sphere = Build(Icosphere(2));
  std::vector<SurfacePath> paths;
  const std::vector<Id> corners{ 0, 7, 20 };
  for (int k = 0; k < 3; ++k)
  {
    paths.push_back(FindPaths(sphere, SurfacePoint::AtVertex(corners[k]),
      { SurfacePoint::AtVertex(corners[(k + 1) % 3]) })[0]);
  }
  refined = Refine(sphere, paths);
  ASSERT_TRUE(dgg::CutAlongChains(refined, refined.Paths, cut).IsOk());
  ASSERT_TRUE(cut.Build(sphere, opened).IsOk());
  opened.ComputeComponents(components);
  EXPECT_EQ(components, 2);
  ASSERT_FALSE(dgg::CutAlongChains(refined, { { 0, 11 } }, cut).IsOk());
}
}
