// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Straight geodesics: end points on surfaces that unfold to the plane, and tracing back along
// links.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggPathTracer.h"
#include "dggStraightWalk.h"

namespace dggtest
{
namespace
{
using dgg::SurfaceMesh;
using dgg::SurfacePath;
using dgg::SurfacePoint;

SurfacePath WalkFrom(
  const SurfaceMesh& mesh, const SurfacePoint& start, double angle, double length)
{
  SurfacePath path;
  EXPECT_TRUE(Ok(dgg::WalkStraight(mesh, start, angle, length, path)));
  EXPECT_TRUE(Ok(dgg::CheckPath(mesh, path)));
  return path;
}

std::array<double, 3> PlaceOf(
  const SurfaceMesh& mesh, const TestMesh& points, const SurfacePoint& point)
{
  return dgg::PositionOf(mesh, point, points.Points.data());
}

double DistanceBetween(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return std::hypot(std::hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
}

/// Returns the angle in the plane of the x axis to which a direction at the point refers.
double AxisOf(const SurfaceMesh& mesh, const TestMesh& points, const SurfacePoint& point)
{
  const Id h =
    point.On == SurfacePoint::Support::Vertex ? *mesh.FanBegin(point.Vertex) : 3 * point.Face;
  const double* a = points.Point(mesh.Origin(h));
  const double* b = points.Point(mesh.Destination(h));
  return std::atan2(b[1] - a[1], b[0] - a[0]);
}

/// Returns the mesh with edge lengths changed by up to 10 %.
TestMesh WithOtherLengths(TestMesh mesh)
{
  Random random(9);
  std::map<std::pair<Id, Id>, double> factors;
  for (std::size_t k = 0; k < mesh.Lengths.size(); ++k)
  {
    const Id a = mesh.Triangles[k];
    const Id b = mesh.Triangles[k % 3 == 2 ? k - 2 : k + 1];
    mesh.Lengths[k] *= factors.emplace(std::minmax(a, b), random.Uniform(0.9, 1.1)).first->second;
  }
  return mesh;
}

/// Returns true if a path ends at a vertex, up to the rounding of its direction to a float.
bool EndsAt(const SurfaceMesh& mesh, const SurfacePath& path, Id vertex, double tolerance)
{
  const SurfacePoint& end = path.Points.back();
  const SurfacePoint target = SurfacePoint::AtVertex(vertex);
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  return dgg::IsSamePoint(end, target) ||
    (!path.Faces.empty() && dgg::FindInFace(mesh, end, path.Faces.back(), p) &&
      dgg::FindInFace(mesh, target, path.Faces.back(), q) &&
      dgg::DistanceInFace(mesh, path.Faces.back(), p, q) < tolerance);
}

/// Expects every edge to lead to its target, from either end. Edges that pass another vertex
/// closely may miss the target, because the rounding of an angle to a float makes them pass on the
/// other side of the vertex. Such edges must be few.
void ExpectEdgesLeadToTargets(const SurfaceMesh& mesh, const dgg::GraphView& graph)
{
  dgg::Offset followed = 0;
  dgg::Offset astray = 0;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    // The angles of irregular vertices are not ordered.
    const bool isRegular = mesh.Kind(v) != dgg::VertexKind::Irregular;
    for (dgg::Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1] && isRegular; ++e)
    {
      SurfacePath path;
      ASSERT_TRUE(Ok(dgg::WalkStraight(
        mesh, SurfacePoint::AtVertex(v), graph.Angles[e], graph.Length(e), path)));
      ++followed;
      astray += EndsAt(mesh, path, graph.Targets[e], 1e-5 * graph.Length(e)) ? 0 : 1;
    }
  }
  EXPECT_GT(followed, 100);
  EXPECT_LE(astray, graph.GetNumberOfEdges() / 1000);
}
}

TEST(StraightWalk, IsALineInThePlane)
{
  const Id n = 12;
  for (double jitter : { 0.0, 0.25 })
  {
    const TestMesh points = Plane(n, n, jitter, 3);
    const SurfaceMesh mesh = Build(points);
    const double size = points.Point(mesh.GetNumberOfVertices() - 1)[0];
    Random random(5);
    std::vector<SurfacePoint> starts = RandomSurfacePoints(mesh, 60, 9);
    for (Id v = 0; v < mesh.GetNumberOfVertices(); v += 5)
    {
      if (mesh.Kind(v) == dgg::VertexKind::Flat)
      {
        starts.push_back(SurfacePoint::AtVertex(v));
      }
    }
    int stopped = 0;
    for (const SurfacePoint& start : starts)
    {
      const std::array<double, 3> from = PlaceOf(mesh, points, start);
      const double angle = random.Uniform(0.0, 2.0 * dgg::Pi);
      const double length = size * random.Uniform(0.0, 0.7);
      const SurfacePath path = WalkFrom(mesh, start, angle, length);
      const double direction = AxisOf(mesh, points, start) + angle;
      const std::array<double, 3> end = PlaceOf(mesh, points, path.Points.back());
      const std::array<double, 3> expected{ { from[0] + path.Length * std::cos(direction),
        from[1] + path.Length * std::sin(direction), 0.0 } };
      EXPECT_LT(DistanceBetween(end, expected), 1e-7 * size);
      EXPECT_LE(path.Length, length * (1.0 + 1e-9));
      if (path.Length < length * (1.0 - 1e-9))
      {
        ++stopped;
        const double rim =
          std::min(std::min(end[0], end[1]), std::min(size - end[0], size - end[1]));
        EXPECT_LT(rim, 1e-7 * size) << "stopped inside";
      }
    }
    EXPECT_GT(stopped, 5);
  }
}

TEST(StraightWalk, LeavesEqualAnglesAtTheApexOfACone)
{
  for (double total : { 4.0, 2.0 * dgg::Pi, 8.0 })
  {
    std::vector<ConePoint> coordinates;
    const TestMesh points = Cone(total, 12, 6, coordinates, 0.1, 4);
    const SurfaceMesh mesh = Build(points);
    Id apex = 0;
    while (coordinates[apex].Radius > 0.0)
    {
      ++apex;
    }
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      // Walk along a mesh edge into the apex and beyond it.
      Id edge = dgg::NoId;
      for (const Id* h = mesh.FanBegin(v); h != mesh.FanEnd(v); ++h)
      {
        edge = mesh.Destination(*h) == apex ? *h : edge;
      }
      if (edge == dgg::NoId)
      {
        continue;
      }
      const double radius = mesh.Length(edge);
      const SurfacePath path =
        WalkFrom(mesh, SurfacePoint::AtVertex(v), mesh.PolarAngle(edge), 1.5 * radius);
      ASSERT_GE(path.Points.size(), 3u);
      EXPECT_EQ(path.Points[1].On, SurfacePoint::Support::Vertex);
      EXPECT_EQ(path.Points[1].Vertex, apex);
      // The end lies on the opposite side of the apex, at half the radius.
      std::array<double, 3> b{};
      ASSERT_TRUE(dgg::FindInFace(mesh, path.Points.back(), path.Faces.back(), b));
      Id out = 3 * path.Faces.back();
      while (mesh.Origin(out) != apex)
      {
        ++out;
      }
      const dgg::Point2 place = dgg::PlaceInFrame(mesh, out, b);
      EXPECT_NEAR(dgg::Norm(place.X, place.Y), 0.5 * radius, 1e-9 * radius);
      Id back = dgg::NoId;
      for (const Id* h = mesh.FanBegin(apex); h != mesh.FanEnd(apex); ++h)
      {
        back = mesh.Destination(*h) == v ? *h : back;
      }
      double turn = mesh.PolarAngle(out) + std::atan2(place.Y, place.X) - mesh.PolarAngle(back);
      turn -= total * std::floor(turn / total);
      EXPECT_NEAR(turn, 0.5 * total, 1e-7);
    }
  }
}

TEST(GraphEdges, LeadToTargets)
{
  // Vertices are moved off regular positions, where paths would pass through vertices. On the
  // Moebius strip and the Klein bottle faces are mirrored behind some edges.
  std::vector<ConePoint> unused;
  for (const NamedMesh& named : { NamedMesh{ "Plane", WithNoise(Plane(16, 14, 0.25, 1), 0.05, 1) },
         NamedMesh{ "Convex", Cone(4.0, 12, 10, unused, 0.2, 2) },
         NamedMesh{ "Saddle", Cone(9.0, 18, 10, unused, 0.2, 3) },
         NamedMesh{ "Terrain", Terrain(18, 2.0, 4) }, NamedMesh{ "Sphere", NoisySphere(3, 0.3, 5) },
         NamedMesh{ "Ellipsoid", WithNoise(Ellipsoid(2, 10.0), 0.02, 6) },
         NamedMesh{ "Cube", WithNoise(Cube(6, 0.25, 7), 0.01, 7) },
         NamedMesh{ "Torus", WithNoise(Torus(20, 12), 0.03, 8) },
         NamedMesh{ "Components", WithNoise(SeveralComponents(), 0.02, 9) },
         NamedMesh{ "Moebius", WithOtherLengths(MoebiusStrip(11, 6)) },
         NamedMesh{ "KleinBottle", WithOtherLengths(KleinBottle(9, 7)) } })
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    for (const double accuracy : { 0.1, 1e-3, 1e-4 })
    {
      ExpectEdgesLeadToTargets(mesh, BuildGraph(mesh, accuracy).View());
    }
    for (const dgg::GraphConstruction construction : AllConstructions())
    {
      ExpectEdgesLeadToTargets(mesh, BuildGraph(mesh, 0.01, construction).View());
    }
  }
}

TEST(StraightWalk, FollowsLinksToTheirVerticesAndBack)
{
  for (const NamedMesh& named :
    Joined(SoundMeshes(), { { "misoriented sphere", MisorientedSphere(2, 7) } }))
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const dgg::GraphBuilder builder(mesh);
    int count = 0;
    for (const SurfacePoint& point : RandomSurfacePoints(mesh, 20, 17))
    {
      std::vector<dgg::GraphLink> links;
      std::vector<double> direct;
      ASSERT_TRUE(builder.Link(point, 0.05, {}, links, direct).IsOk());
      for (const dgg::GraphLink& link : links)
      {
        if (point.On == SurfacePoint::Support::Vertex)
        {
          continue;
        }
        const SurfacePath path = WalkFrom(mesh, point, link.DepartureAngle, link.Length);
        const double missed = DistanceBetween(PlaceOf(mesh, named.Mesh, path.Points.back()),
          PlaceOf(mesh, named.Mesh, SurfacePoint::AtVertex(link.Vertex)));
        EXPECT_LT(missed, 1e-6 * link.Length) << named.Name;
        const SurfacePath back =
          WalkFrom(mesh, SurfacePoint::AtVertex(link.Vertex), link.ArrivalAngle, link.Length);
        const double missedBack = DistanceBetween(
          PlaceOf(mesh, named.Mesh, back.Points.back()), PlaceOf(mesh, named.Mesh, point));
        EXPECT_LT(missedBack, 1e-6 * link.Length) << named.Name;
        ++count;
      }
    }
    EXPECT_GT(count, 40) << named.Name;
  }
}

TEST(StraightWalk, OnAnySurface)
{
  for (const NamedMesh& named :
    Joined(DefectMeshes(), { { "moebius strip", MoebiusStrip(12, 3) } }))
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    Random random(3);
    std::vector<SurfacePoint> starts = RandomSurfacePoints(mesh, 30, 5);
    for (Id v = 0; v < mesh.GetNumberOfVertices(); v += 3)
    {
      starts.push_back(SurfacePoint::AtVertex(v));
    }
    for (const SurfacePoint& start : starts)
    {
      const double length = 10.0 * mesh.GetMeanEdgeLength();
      const SurfacePath path = WalkFrom(mesh, start, random.Uniform(-7.0, 7.0), length);
      EXPECT_FALSE(path.IsEmpty()) << named.Name;
      EXPECT_LE(path.Length, length * (1.0 + 1e-9)) << named.Name;
    }
  }
}

// Tracing edges of a graph over the mesh takes little work, on thin triangles as well.

namespace
{
/// Returns the mesh stretched along one axis.
TestMesh Stretched(TestMesh mesh, double factor)
{
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] *= factor;
  }
  return mesh;
}

struct TraceWork
{
  std::size_t GraphEdges = 0;
  std::size_t Missed = 0;
  std::size_t Beams = 0;
};

/// Traces every `step`-th edge of the graph of a mesh.
TraceWork TraceEdges(const TestMesh& mesh, dgg::Offset step)
{
  const SearchCase c("mesh", mesh, 0.05);
  const dgg::GraphView graph = c.GetGraph();
  dgg::GraphEdgeTracer tracer(c.GetMesh());
  TraceWork work;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    for (dgg::Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; e += step)
    {
      Id face = dgg::NoId;
      std::vector<dgg::EdgeCrossing> crossings;
      const bool isFound = tracer.Trace(
        { v, graph.Angles[e], dgg::SurfacePoint::AtVertex(graph.Targets[e]), graph.Length(e) },
        face, crossings);
      ++work.GraphEdges;
      work.Missed += isFound ? 0 : 1;
      work.Beams += tracer.GetNumberOfBeams();
    }
  }
  return work;
}

TEST(GraphEdgeTracer, WorkDoesNotGrowWithTheLengthOfTriangles)
{
  const std::vector<NamedMesh> meshes = { { "sphere", NoisySphere(3, 0.05, 1) },
    { "plane", Plane(20, 20, 0.2) }, { "torus", Torus(20, 20) },
    { "box", Box(8, 8, 8, 1.0, 1.0, 1.0, 0.2) } };
  for (const NamedMesh& named : meshes)
  {
    SCOPED_TRACE(named.Name);
    const TraceWork clean = TraceEdges(named.Mesh, 7);
    EXPECT_EQ(clean.Missed, 0u);
    EXPECT_LE(clean.Beams, 10 * clean.GraphEdges);
    for (const double factor : { 1e3, 1e5, 1e7 })
    {
      SCOPED_TRACE(factor);
      const TraceWork work = TraceEdges(Stretched(named.Mesh, factor), 7);
      EXPECT_LE(work.Missed, work.GraphEdges / 50);
      EXPECT_LE(work.Beams, 500 * work.GraphEdges);
    }
  }
}

/// More faces than the tracer tries at first, along a planar strip one quad high.
TEST(GraphEdgeTracer, LinesThroughThousandsOfFacesAreFound)
{
  const Id columns = 3000;
  const dgg::SurfaceMesh mesh = Build(Plane(columns, 1));
  dgg::GraphEdgeTracer tracer(mesh);
  const double length = std::hypot(columns, 1.0);
  Id face = dgg::NoId;
  std::vector<dgg::EdgeCrossing> crossings;
  ASSERT_TRUE(tracer.Trace(
    { 0, std::atan2(1.0, columns), SurfacePoint::AtVertex(mesh.GetNumberOfVertices() - 1), length },
    face, crossings));
  // All inner edges, except the diagonals of the first and the last quad.
  EXPECT_EQ(crossings.size(), 2 * static_cast<std::size_t>(columns) - 3);
}

}
}
