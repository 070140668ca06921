// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches by tasks: sessions, paths of pairs, and matrices. Distances in the plane are known.
#include "GeodesicChecks.h"
#include "TaskTestTools.h"

#include "dggDistanceOutput.h"
#include "dggExactGeodesics.h"
#include "dggFaceEnvelope.h"
#include "dggGraphDistances.h"
#include "dggGraphSession.h"
#include "dggMatrixSearch.h"
#include "dggPathSearch.h"
#include "dggVoronoiTask.h"

namespace dggtest
{
namespace
{
using dgg::GraphSession;
using dgg::PathSearch;
using dgg::SurfacePoint;
using Points = std::vector<SurfacePoint>;

constexpr double Accuracy = 0.01;

/// Returns two disjoint rectangles in the plane.
TestMesh TwoPlanes()
{
  TestMesh mesh = Plane(5, 4, 0.2, 3);
  Append(mesh, Translated(Plane(1, 1), 20, 0, 0));
  return mesh;
}

/// Returns vertices of both rectangles, and points inside faces and on edges of the first one.
Points MakePoints(const dgg::SurfaceMesh& mesh)
{
  return { SurfacePoint::AtVertex(0), SurfacePoint::InFace(mesh, 3, { { 0.2, 0.3, 0.5 } }),
    SurfacePoint::AtVertex(29), SurfacePoint::OnEdge(mesh, 40, 0.25),
    SurfacePoint::InFace(mesh, 3, { { 0.6, 0.3, 0.1 } }), SurfacePoint::AtVertex(31) };
}

/// Returns the distance between two points of the rectangles.
double TrueDistance(
  const dgg::PreparedSurface& surface, const SurfacePoint& a, const SurfacePoint& b)
{
  const auto p = PositionOf(surface.GetMesh(), a, surface.GetPositions());
  const auto q = PositionOf(surface.GetMesh(), b, surface.GetPositions());
  return (p[0] < 10.0) == (q[0] < 10.0) ? std::hypot(p[0] - q[0], p[1] - q[1]) : dgg::Infinity;
}
}

TEST(GraphSession, KeepsTheGraphOfEqualSurfacesOnly)
{
  const GraphWorld world(TwoPlanes(), Accuracy);
  EXPECT_EQ(MakeGraph(world), MakeGraph(world, 1));
  GraphSession session;
  EXPECT_EQ(session.GetSummary().NumberOfVertices, 0);
  EXPECT_EQ(session.GetMemorySize(), 0u);
  session = StartSession(world);
  session.Start(*world.Surface);
  ASSERT_TRUE(session.HasGraph());
  EXPECT_EQ(session.GetSummary().NumberOfVertices, 34);
  EXPECT_GE(session.GetMemorySize(), world.Graph.GetMemorySize());
  // The merged surface has the same triangles, but distances on it are those of another domain.
  session.Start(*Prepare(TwoPlanes(), { dgg::Domain::MergedSurface, 0.0 }));
  EXPECT_FALSE(session.HasGraph());
}

TEST(GraphSession, SeedsOfVerticesAndLinks)
{
  const GraphWorld world(TwoPlanes(), Accuracy);
  GraphSession session = StartSession(world);
  const dgg::SurfaceMesh& mesh = world.Surface->GetMesh();
  const SurfacePoint inside = SurfacePoint::InFace(mesh, 3, { { 0.2, 0.3, 0.5 } });
  std::vector<dgg::GraphSeed> seeds;
  ASSERT_TRUE(Ok(session.MakeSeeds(
    world.MakeContext(), { { SurfacePoint::AtVertex(7), 2.0 }, { inside, 0.5 } }, seeds)));
  ASSERT_GE(seeds.size(), 4u);
  EXPECT_EQ(seeds[0].Vertex, 7);
  EXPECT_EQ(seeds[0].Distance, 2.0);
  EXPECT_LT(seeds[0].ArrivalAngle, 0.0);
  for (std::size_t i = 1; i < seeds.size(); ++i)
  {
    const double distance =
      TrueDistance(*world.Surface, inside, SurfacePoint::AtVertex(seeds[i].Vertex));
    EXPECT_NEAR(seeds[i].Distance, 0.5 + distance, 1e-6);
    EXPECT_EQ(seeds[i].InitialDistance, 0.5);
    EXPECT_EQ(seeds[i].Source, 1);
    EXPECT_GE(seeds[i].ArrivalAngle, 0.0);
  }
  EXPECT_TRUE(Says(session.PrepareBuilder(world.MakeContext(1)), "Use vertices only"));
  EXPECT_TRUE(Ok(session.PrepareBuilder(world.MakeContext(1), false)));
}

/// Inside triangles that are large for the accuracy, distances are exact if memory permits.
TEST(GraphDistances, InsideCoarseTriangles)
{
  const GraphWorld world(Box(4, 4, 1, 1.0, 1.3, 0.8), Accuracy);
  const dgg::SurfaceMesh& mesh = world.Surface->GetMesh();
  const std::vector<dgg::GeodesicSource> sources = { { SurfacePoint::AtVertex(0), 0.0 } };
  const Points places = RandomSurfacePoints(mesh, 100, 3);
  const std::vector<double> exact =
    DistancesTo(mesh, dgg::ExactEngine::Triangle, sources[0].Point, places);
  const auto find = [&](bool correct, std::uint64_t memoryLimit) {
    GraphSession session = StartSession(world);
    dgg::DistanceTask task{ {}, sources };
    task.WantVirtualSource = true;
    EXPECT_TRUE(Ok(dgg::FindGraphDistances(
      world.MakeContext(memoryLimit), session, dgg::SearchMethod::Certified, correct, task)));
    EXPECT_EQ(task.VirtualSource.size(), task.Distances.size());
    return task;
  };
  const dgg::DistanceTask found = find(true, 0);
  const dgg::DistanceField field{ &mesh, found.Distances.data(), &found.Windows, nullptr };
  ASSERT_TRUE(field.HasWindows());
  dgg::FaceEnvelope envelope(field);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double distance = dgg::Infinity;
    ForEachFaceAround(mesh, places[i], [&](Id f, const std::array<double, 3>& barycentric) {
      envelope.Enter(f);
      distance = std::min(distance, envelope.At(envelope.PlaceOf(barycentric)));
    });
    EXPECT_NEAR(distance, exact[i], 1e-9 * exact[i]);
  }
  EXPECT_TRUE(found.QualityWarning.empty());
  // Lengths of paths in the graph are not exact, and have no windows.
  EXPECT_TRUE(find(false, 0).Windows.IsEmpty());
  const dgg::DistanceTask limited = find(true, 1);
  EXPECT_TRUE(limited.Windows.IsEmpty());
  EXPECT_NE(limited.QualityWarning.find("MemoryLimit"), std::string::npos);
  EXPECT_NE( // all triangles are coarse; these are on the long sides of the box
    limited.QualityWarning.find("inside 96 triangles (largest cells: 36, 37, 44)"),
    std::string::npos)
    << limited.QualityWarning;
}

/// On such triangles cells are exact as well, unless borders are not refined.
TEST(VoronoiCells, OnCoarseTriangles)
{
  for (const bool isLong : { false, true })
  {
    const GraphWorld world(
      isLong ? Box(2, 2, 2, 10.0, 1.0, 0.3) : Box(4, 4, 4, 1.0, 1.3, 0.8), Accuracy);
    const dgg::SurfaceMesh& mesh = world.Surface->GetMesh();
    const Points sites = RandomSurfacePoints(mesh, 5, 7);
    const auto find = [&](bool isRefined) {
      GraphSession session = StartSession(world);
      dgg::VoronoiOptions options;
      options.IsRefined = isRefined;
      dgg::VoronoiResult result;
      for (const SurfacePoint& site : sites)
      {
        result.Sites.push_back({ site, 0.0 });
      }
      EXPECT_TRUE(Ok(dgg::FindVoronoiCells(world.MakeContext(), session, options, result)));
      return result;
    };
    const auto measure = [&](const dgg::VoronoiDiagram& diagram) {
      std::vector<std::vector<double>> exact;
      for (const SurfacePoint& site : sites)
      {
        exact.push_back(DistancesTo(mesh, dgg::ExactEngine::Triangle, site, diagram.BorderPoints));
      }
      double worst = 0.0;
      for (std::size_t i = 0; i < diagram.BorderPoints.size(); ++i)
      {
        double nearest = dgg::Infinity;
        for (const std::vector<double>& distances : exact)
        {
          nearest = std::min(nearest, distances[i]);
        }
        worst = std::max(worst, std::abs(diagram.BorderDistances[i] - nearest) / nearest);
      }
      return worst;
    };
    const dgg::VoronoiResult found = find(true);
    EXPECT_LT(measure(found.Diagram), 1e-6);
    EXPECT_TRUE(found.QualityWarning.empty());
    EXPECT_GT(measure(find(false).Diagram), 1e-4);
  }
}

TEST(GraphSession, WidensTheRadiusByTheAccuracy)
{
  const GraphWorld world(TwoPlanes(), Accuracy);
  const GraphSession session = StartSession(world);
  const std::vector<dgg::GeodesicSource> sources = { { SurfacePoint::AtVertex(0), 3.0 },
    { SurfacePoint::AtVertex(1), 1.0 } };
  EXPECT_EQ(session.WidenLimit(dgg::Infinity, sources), dgg::Infinity);
  EXPECT_NEAR(session.WidenLimit(5.0, sources), 5.0 + 4.0 * Accuracy, 1e-5);
  EXPECT_EQ(session.WidenLimit(0.5, sources), 0.5);
}

TEST(GraphSession, LandmarksAfterManyPairs)
{
  const GraphWorld world(TwoPlanes(), Accuracy);
  GraphSession session = StartSession(world);
  ASSERT_TRUE(Ok(session.PrepareForPairs(world.MakeContext(), 255)));
  EXPECT_FALSE(session.GetSearch().HasLandmarks());
  ASSERT_TRUE(Ok(session.PrepareForPairs(world.MakeContext(), 1)));
  EXPECT_TRUE(session.GetSearch().HasLandmarks());
}

TEST(PathSearch, PathsInThePlane)
{
  const GraphWorld world(TwoPlanes(), Accuracy);
  GraphSession session = StartSession(world);
  const Points points = MakePoints(world.Surface->GetMesh());
  PathSearch::Pairs pairs;
  for (const SurfacePoint& from : points)
  {
    for (const SurfacePoint& to : points)
    {
      pairs.push_back({ from, to });
    }
  }
  const dgg::TaskContext context = world.MakeContext();
  const PathSearch search(context, pairs);
  PathSearch::Paths inGraph;
  PathSearch::Paths exact;
  ASSERT_TRUE(Ok(search.RunInGraph(session, {}, inGraph)));
  ASSERT_TRUE(Ok(search.RunExact(exact)));
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    SCOPED_TRACE(i);
    const double distance = TrueDistance(*world.Surface, pairs[i].From, pairs[i].To);
    EXPECT_TRUE(std::isnan(exact[i].GraphLength));
    if (distance == dgg::Infinity)
    {
      EXPECT_EQ(inGraph[i].GraphLength, dgg::Infinity);
      EXPECT_TRUE(inGraph[i].Path.IsEmpty());
      EXPECT_TRUE(exact[i].Path.IsEmpty());
      continue;
    }
    EXPECT_NEAR(inGraph[i].Path.Length, distance, 1e-9);
    EXPECT_NEAR(exact[i].Path.Length, distance, 1e-9);
    EXPECT_GE(inGraph[i].GraphLength, distance * (1.0 - 1e-9));
    EXPECT_LE(inGraph[i].GraphLength, distance * (1.0 + Accuracy) + 1e-6);
    EXPECT_TRUE(inGraph[i].IsStraightened && exact[i].IsStraightened);
  }
}

TEST(PathSearch, RefusesAndStops)
{
  const GraphWorld world(TwoPlanes(), Accuracy);
  GraphSession session = StartSession(world);
  PathSearch::Pairs pairs(3, { SurfacePoint::AtVertex(0), SurfacePoint::AtVertex(29) });
  dgg::TaskContext context = world.MakeContext();
  context.Progress = [](double) { return false; };
  PathSearch::Paths paths;
  EXPECT_TRUE(PathSearch(context, pairs).RunInGraph(session, {}, paths).IsAborted());
  EXPECT_TRUE(PathSearch(context, pairs).RunExact(paths).IsAborted());
  context.Progress = nullptr;
  pairs[1].To = SurfacePoint::AtVertex(34);
  EXPECT_TRUE(Says(PathSearch(context, pairs).RunInGraph(session, {}, paths), "Pair 1"));
  pairs[1].From = SurfacePoint::AtVertex(5);
  EXPECT_TRUE(Says(PathSearch(context, pairs).RunExact(paths), "Pair 1 has no exact path: "));
}

TEST(PathSearch, PolylinesOnClouds)
{
  const GraphWorld world = CornerWorld();
  GraphSession session = StartSession(world);
  const auto at = &SurfacePoint::AtVertex;
  const PathSearch::Pairs pairs = { { at(0), at(2) }, { at(2), at(2) }, { at(0), at(3) } };
  const dgg::TaskContext context = world.MakeContext();
  PathSearch::Paths paths;
  ASSERT_TRUE(Ok(PathSearch(context, pairs).RunOnCloud(session, false, paths)));
  EXPECT_EQ(paths[0].Path.Length, 2.0);
  EXPECT_EQ(paths[0].GraphLength, 2.0);
  EXPECT_EQ(paths[0].Path.Points.size(), 3u);
  EXPECT_FALSE(paths[0].IsStraightened);
  EXPECT_EQ(paths[1].GraphLength, 0.0);
  EXPECT_EQ(paths[2].GraphLength, dgg::Infinity);
  EXPECT_TRUE(paths[2].Path.IsEmpty());
  // The straight path leaves the band only at its corner, which the balls of radius 1 contain.
  ASSERT_TRUE(Ok(PathSearch(context, pairs).RunOnCloud(session, true, paths)));
  EXPECT_TRUE(paths[0].IsStraightened);
  EXPECT_LT(paths[0].Path.Length, 2.0);
  EXPECT_GE(paths[0].Path.Length, std::sqrt(2.0) - 1e-9);
}

TEST(MatrixSearch, DistancesInACloud)
{
  // Vertices, and points close to the ends of the chain.
  const GraphWorld world = CornerWorld();
  GraphSession session = StartSession(world);
  const Points points = { SurfacePoint::AtVertex(0), SurfacePoint::AtVertex(2),
    SurfacePoint::AtVertex(3), SurfacePoint::NearVertex(0, { { -0.5, 0.0, 0.0 } }),
    SurfacePoint::NearVertex(2, { { 0.0, 0.5, 0.0 } }) };
  const std::vector<double> expected = { 0.0, 2.0, 0.5, 2.5, 2.0, 0.0, 2.5, 0.5 };
  std::vector<double> values(25, dgg::Infinity);
  const auto matrix = [&](std::size_t i, std::size_t j) { return values[5 * i + j]; };
  ASSERT_TRUE(Ok(dgg::FindMatrix(
    world.MakeContext(), session, points, nullptr, dgg::Infinity, dgg::Infinity, values.data())));
  const std::vector<std::size_t> connected = { 0, 1, 3, 4 };
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    EXPECT_NEAR(matrix(connected[k / 4], connected[k % 4]), expected[k], 1e-9);
  }
  EXPECT_EQ(matrix(2, 0), dgg::Infinity);
  EXPECT_EQ(matrix(2, 2), 0.0);
}

TEST(MatrixSearch, DistancesInThePlane)
{
  const GraphWorld world(TwoPlanes(), Accuracy);
  const Points points = MakePoints(world.Surface->GetMesh());
  const Points targets(points.begin() + 1, points.end());
  const dgg::TaskContext context = world.MakeContext();
  constexpr double radius = 3.0;
  for (const bool isSymmetric : { false, true })
  {
    for (const bool areRows : { false, true })
    {
      for (const double limit : { dgg::Infinity, radius })
      {
        GraphSession session = StartSession(world);
        const Points& others = isSymmetric ? points : targets;
        std::vector<double> values(points.size() * others.size(), dgg::Infinity);
        const auto matrix = [&](std::size_t i, std::size_t j) {
          return values[areRows ? i * others.size() + j : j * points.size() + i];
        };
        const Points* columns = areRows ? &others : &points;
        ASSERT_TRUE(Ok(dgg::FindMatrix(context, session, areRows ? points : others,
          isSymmetric ? nullptr : columns, limit, dgg::Infinity, values.data())));
        for (std::size_t i = 0; i < points.size(); ++i)
        {
          for (std::size_t j = 0; j < others.size(); ++j)
          {
            const double distance = TrueDistance(*world.Surface, points[i], others[j]);
            const double found = matrix(i, j);
            EXPECT_GE(found, distance * (1.0 - 1e-9));
            EXPECT_TRUE(found <= distance * (1.0 + Accuracy) + 1e-6 || distance > limit / 1.02);
            EXPECT_TRUE(!isSymmetric || found == matrix(j, i));
            EXPECT_TRUE(!IsSamePoint(points[i], others[j]) || found == 0.0);
          }
        }
      }
    }
  }
}
}
