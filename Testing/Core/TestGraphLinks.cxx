// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Links: they connect any surface point to the graph like a vertex, with the same guarantee.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

namespace dggtest
{
namespace
{
using dgg::GraphLink;
using dgg::SurfaceMesh;
using dgg::SurfacePoint;

struct Linked
{
  std::vector<GraphLink> Links;
  std::vector<double> Direct;
};

Linked LinksOf(const SurfaceMesh& mesh, const dgg::GraphBuilder& builder, const SurfacePoint& point,
  double accuracy, const std::vector<SurfacePoint>& targets)
{
  Linked linked;
  EXPECT_TRUE(Ok(builder.Link(point, accuracy, targets, linked.Links, linked.Direct)));
  EXPECT_EQ(linked.Direct.size(), targets.size());
  linked.Direct.resize(targets.size(), dgg::Infinity);
  const bool isVertex = point.On == SurfacePoint::Support::Vertex;
  EXPECT_TRUE(!isVertex || linked.Links.size() == 1u);
  Id before = dgg::NoId;
  for (const GraphLink& link : linked.Links)
  {
    EXPECT_LT(before, link.Vertex);
    EXPECT_TRUE(isVertex ? link.Vertex == point.Vertex && link.Length == 0.0 : link.Length > 0.0);
    EXPECT_TRUE(
      isVertex || (link.ArrivalAngle >= 0.0 && link.ArrivalAngle < mesh.TotalAngle(link.Vertex)));
    before = link.Vertex;
  }
  return linked;
}

/// Returns points of every kind: random points in faces and on edges, points close to each other
/// and to vertices, midpoints of every kind of edge, and vertices.
std::vector<SurfacePoint> PointsOfAllKinds(const SurfaceMesh& mesh, Id count, std::uint64_t seed)
{
  std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, count, seed);
  Random random(seed);
  Id boundaryEdges = 0;
  Id nonManifoldEdges = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (mesh.IsDropped(SurfaceMesh::Face(h)))
    {
      continue;
    }
    const Id twin = mesh.Twin(h);
    const bool isBoundary = twin == dgg::NoId;
    const bool isNonManifold = !isBoundary && mesh.Twin(twin) != h;
    if ((isBoundary && random.Index(4) == 0 && ++boundaryEdges <= 3) ||
      (isNonManifold && ++nonManifoldEdges <= 4))
    {
      points.push_back(SurfacePoint::OnEdge(mesh, h, random.Uniform(0.1, 0.9)));
      points.push_back(SurfacePoint::OnEdge(mesh, h, random.Uniform(0.1, 0.9)));
    }
  }
  Id f = random.Index(mesh.GetNumberOfFaces());
  while (mesh.IsDropped(f))
  {
    f = (f + 1) % mesh.GetNumberOfFaces();
  }
  std::vector<std::array<double, 3>> places = { { { 0.3, 0.3, 0.4 } }, { { 0.3001, 0.2999, 0.4 } },
    { { 0.999, 0.0005, 0.0005 } }, { { 0.0, 0.4, 0.6 } }, { { 0.0, 0.4001, 0.5999 } },
    { { 0.0, 1.0, 0.0 } } };
  if (mesh.ApexY(3 * f + 1) > 0.01 * mesh.Length(3 * f + 1))
  {
    // The smallest distance from an edge without being on the edge. In a sliver, exact distances
    // from such a point are not available: windows seen edge-on are discarded.
    places.push_back({ { 2e-9, 0.5, 0.5 } });
  }
  for (const std::array<double, 3>& b : places)
  {
    points.push_back(SurfacePoint::InFace(mesh, f, b));
  }
  points.push_back(SurfacePoint::AtVertex(mesh.GetTriangle(f)[0]));
  points.push_back(SurfacePoint::AtVertex(mesh.GetNumberOfVertices() - 1));
  return points;
}

/// Expects the path between any two of the points, by links and graph or direct, to be within the
/// accuracy and equally long from both ends.
void ExpectLinksKeepTheBound(
  const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points, double accuracy)
{
  const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy);
  const dgg::GraphBuilder builder(mesh);
  const double slack = SlackOf(mesh);
  std::vector<Linked> linked;
  for (const SurfacePoint& point : points)
  {
    linked.push_back(LinksOf(mesh, builder, point, accuracy, points));
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const std::vector<double> exact =
      DistancesTo(mesh, dgg::ExactEngine::Triangle, points[p], points);
    std::vector<std::pair<Id, double>> sources;
    for (const GraphLink& link : linked[p].Links)
    {
      sources.emplace_back(link.Vertex, link.Length);
    }
    const std::vector<double> distances = GraphDistances(graph.View(), sources);
    for (std::size_t q = 0; q < points.size(); ++q)
    {
      double way = std::min(linked[p].Direct[q], linked[q].Direct[p]);
      for (const GraphLink& link : linked[q].Links)
      {
        way = std::min(way, distances[link.Vertex] + link.Length);
      }
      const double d = exact[q];
      const double largest = LargestFinite(exact);
      ASSERT_GE(linked[p].Direct[q], d * (1.0 - 1e-9) - slack) << p << " to " << q;
      if (d == dgg::Infinity)
      {
        ASSERT_EQ(way, dgg::Infinity) << p << " to " << q;
        continue;
      }
      // Between adjacent points, the rounding error is relative to the length of an edge.
      const double rounding = slack + 1e-12 * largest;
      ASSERT_GE(way, d * (1.0 - 1e-9) - rounding) << p << " to " << q;
      ASSERT_LE(way, (1.0 + accuracy) * d * (1.0 + 1e-6) + rounding)
        << p << " to " << q << ", exact " << d;
    }
  }
}
}

TEST(GraphLinks, KeepTheBound)
{
  std::vector<bool> unused;
  const std::vector<NamedMesh> more{ { "Slit", SlitPlane(6, unused, 0.2, 1) },
    { "Doubled", DoublyCoveredPolygon(4, 3, unused) }, { "OneTriangle", SingleTriangle() },
    { "TwoTriangles", TwoTriangles(0.5) }, { "Tetrahedron", Tetrahedron() },
    { "TorusOfTwoFaces", FlatTorus(2.0, 0.3, 1.0, 1, 1, true) },
    { "TorusOfFew", FlatTorus(2.0, 0.3, 1.0, 2, 1, true) } };
  for (const NamedMesh& named : Joined(AllMeshes(), more))
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<SurfacePoint> points = PointsOfAllKinds(mesh, 20, 7);
    for (const double accuracy : { 0.5, 0.1, 0.01, 1e-4 })
    {
      SCOPED_TRACE(accuracy);
      ExpectLinksKeepTheBound(mesh, points, accuracy);
    }
  }
}
}
