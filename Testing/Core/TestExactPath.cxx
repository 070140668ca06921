// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact shortest paths: they lie on the surface, and their length equals the distance.
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggExactPath.h"

#include <cstddef>

namespace dggtest
{
namespace
{
using dgg::SurfacePath;
using dgg::SurfacePoint;
using Support = SurfacePoint::Support;

/// Compares paths between points of every kind with the distances of the other engine. `failures`,
/// if given, counts the sources from which a path could not be traced back, which may happen across
/// stacks of degenerate faces.
void ExpectShortest(
  const dgg::SurfaceMesh& mesh, Id sources, Id targets, double tolerance, int* failures = nullptr)
{
  const std::vector<SurfacePoint> from = SomePoints(mesh, sources, sources, 71);
  std::vector<SurfacePoint> to = SomePoints(mesh, targets, targets, 73);
  to.push_back(from.front());
  for (const SurfacePoint& source : from)
  {
    const std::vector<double> distances =
      DistancesTo(mesh, dgg::ExactEngine::Reference, source, to);
    if (failures && mesh.GetNumberOfDegenerateFaces() > 0)
    {
      dgg::ExactPathFinder finder(mesh);
      std::vector<SurfacePath> unused;
      const dgg::Status status = finder.Find(source, to, nullptr, unused);
      if (!status.IsOk())
      {
        EXPECT_TRUE(Says(status, "cannot be traced"));
        EXPECT_TRUE(unused.empty());
        ++*failures;
        continue;
      }
    }
    const std::vector<SurfacePath> paths = FindPaths(mesh, source, to);
    ASSERT_EQ(paths.size(), to.size());
    for (std::size_t t = 0; t < to.size(); ++t)
    {
      const SurfacePath& path = paths[t];
      SCOPED_TRACE(t);
      ASSERT_EQ(path.IsEmpty(), distances[t] == dgg::Infinity);
      if (path.IsEmpty())
      {
        continue;
      }
      ASSERT_TRUE(Ok(dgg::CheckPath(mesh, path)));
      ASSERT_NEAR(
        path.Length, distances[t], tolerance * distances[t] + 1e-14 * mesh.GetMaximumEdgeLength());
      EXPECT_TRUE(IsSamePoint(path.Points.back(), to[t]));
      EXPECT_TRUE(path.Points.size() == 1 || IsSamePoint(path.Points.front(), source));
      for (std::size_t i = 1; i + 1 < path.Points.size(); ++i)
      {
        EXPECT_NE(path.Points[i].On, Support::Face);
        EXPECT_TRUE(path.Points[i].Check(mesh).IsOk());
      }
    }
  }
}

/// Returns the distance of a point from the line through two others, in the plane z = 0.
double OffLine(
  const std::array<double, 3>& p, const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  const double x = b[0] - a[0];
  const double y = b[1] - a[1];
  return std::abs(x * (p[1] - a[1]) - y * (p[0] - a[0])) / std::hypot(x, y);
}
}

TEST(ExactPath, IsAsLongAsTheDistance)
{
  std::vector<ConePoint> coordinates;
  std::vector<bool> isBack;
  std::vector<Id> sheetOf;
  Id unused = 0;
  // If a window does not determine the faces that it has crossed, as at spines, the tracer tries
  // the candidates.
  const std::vector<NamedMesh> more{ { "sharp cone", Cone(2.2, 9, 4, coordinates, 0.2) },
    { "saddle", Cone(9.7, 17, 4, coordinates, 0.2) },
    { "glued torus", FlatTorus(1.0, 0.3, 0.8, 2, 2, true) },
    { "torus", FlatTorus(3.0, 0.5, 2.0, 5, 4, false) },
    { "pentagon", DoublyCoveredPolygon(5, 3, isBack) }, { "triangle", SingleTriangle() },
    { "two triangles", TwoTriangles(0.4) }, { "slit", SlitPlane(6, isBack, 0.2, 3) },
    { "cube", Cube(1) }, { "three sheets", Book(3, 6, sheetOf, 0.2, 2) },
    { "six sheets", Book(6, 5, sheetOf, 0.2, 3) }, { "fin", PlaneWithFin(6, unused, 0.2, 4) } };
  for (const NamedMesh& named : Joined(AllMeshes(), more))
  {
    SCOPED_TRACE(named.Name);
    // Windows illuminate up to 1e-9 edges beyond their ends. Next to faces of that width, a path
    // can be shorter by a fraction of this length.
    const bool isNarrow = named.Name.find("1e-9") != std::string::npos;
    ExpectShortest(Build(named.Mesh), 5, 40, isNarrow ? 1e-9 : 1e-10);
  }
}

TEST(ExactPath, OfOnePoint)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(1, 0.2, 3));
  // The same point of an edge, given on the opposite half-edge.
  const SurfacePoint point = SurfacePoint::OnEdge(mesh, 12, 0.3);
  const auto path = FindPaths(mesh, point, { SurfacePoint::OnEdge(mesh, mesh.Twin(12), 0.7) })[0];
  EXPECT_EQ(path.Points.size(), 1u);
  EXPECT_TRUE(path.Faces.empty());
  EXPECT_EQ(path.Length, 0.0);
}

TEST(ExactPath, Soups)
{
  int failures = 0;
  for (const NamedMesh& soup : SmallSoups(200))
  {
    SCOPED_TRACE(soup.Name);
    const dgg::SurfaceMesh mesh = Build(soup.Mesh);
    bool hasFaces = false;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      hasFaces = hasFaces || !mesh.IsDropped(f);
    }
    if (hasFaces)
    {
      // With degenerate faces the engines agree only to this tolerance.
      ExpectShortest(mesh, 2, 10, 1e-6, &failures);
    }
  }
  EXPECT_LE(failures, 8); // of 800 sources
}

TEST(ExactPath, IsStraightInThePlane)
{
  for (const double jitter : { 0.0, 0.25 })
  {
    const TestMesh input = Plane(12, 9, jitter, 5);
    const dgg::SurfaceMesh mesh = Build(input);
    const std::vector<SurfacePoint> points = SomePoints(mesh, 30, 20, 6);
    for (std::size_t s = 0; s < points.size(); s += 7)
    {
      const auto a = dgg::PositionOf(mesh, points[s], input.Points.data());
      const auto paths = FindPaths(mesh, points[s], points);
      for (std::size_t t = 0; t < points.size(); ++t)
      {
        const auto b = dgg::PositionOf(mesh, points[t], input.Points.data());
        EXPECT_NEAR(paths[t].Length, std::hypot(b[0] - a[0], b[1] - a[1]), 1e-12);
        double before = -1.0;
        for (const SurfacePoint& point : paths[t].Points)
        {
          const auto p = dgg::PositionOf(mesh, point, input.Points.data());
          EXPECT_TRUE(paths[t].Points.size() == 1 || OffLine(p, a, b) < 1e-12);
          const double along = std::hypot(p[0] - a[0], p[1] - a[1]);
          EXPECT_GT(along, before); // points advance from start to end without repetition
          before = along;
        }
      }
    }
  }
}

/// Results do not depend on earlier queries of a finder.
TEST(ExactPath, MayBeAskedAgain)
{
  std::vector<NamedMesh> meshes = DefectMeshes();
  meshes.push_back({ "parts", SeveralComponents() });
  meshes.push_back({ "sphere", NoisySphere(3, 0.1, 3) });
  meshes.push_back({ "terrain", Terrain(20, 0.8, 5) });
  for (const NamedMesh& named : meshes)
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<SurfacePoint> points = SomePoints(mesh, 30, 10, 5);
    dgg::ExactPathFinder again(mesh);
    const double limits[] = { dgg::Infinity, 3.0 * mesh.GetMaximumEdgeLength(), 0.0 };
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      // Vary the queries: many targets, a stop, a point that does not exist.
      const auto end = points.begin() + static_cast<std::ptrdiff_t>(k % 7 == 0 ? points.size() : 1);
      std::vector<SurfacePoint> to(points.begin(), end);
      to.push_back(points[(7 * k + 1) % points.size()]);
      const double limit = limits[k % 5 == 3 ? 1 : (k % 11 == 5 ? 2 : 0)];
      std::vector<SurfacePath> found;
      if (k % 4 == 1)
      {
        again.Find(
          points[k], to, [](double) { return false; }, found, limit);
      }
      else if (k % 4 == 2)
      {
        EXPECT_FALSE(again.Find(points[k], { SurfacePoint::AtVertex(-4) }, nullptr, found).IsOk());
      }
      dgg::ExactPathFinder fresh(mesh);
      std::vector<SurfacePath> expected;
      ASSERT_EQ(again.Find(points[k], to, nullptr, found, limit).GetMessage(),
        fresh.Find(points[k], to, nullptr, expected, limit).GetMessage());
      ASSERT_EQ(again.GetNumberOfWindows(), fresh.GetNumberOfWindows()) << k;
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t t = 0; t < found.size(); ++t)
      {
        ASSERT_EQ(found[t].Length, expected[t].Length) << k << " " << t;
        ASSERT_EQ(found[t].Faces, expected[t].Faces);
        ASSERT_EQ(found[t].Points.size(), expected[t].Points.size());
        for (std::size_t i = 0; i < found[t].Points.size(); ++i)
        {
          const SurfacePoint& a = found[t].Points[i];
          const SurfacePoint& b = expected[t].Points[i];
          ASSERT_TRUE(a.On == b.On && a.Vertex == b.Vertex && a.Face == b.Face &&
            a.Barycentric == b.Barycentric);
        }
      }
    }
  }
}

}
