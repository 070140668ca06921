// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Voronoi diagrams: complete and without gaps on any surface, and correct where borders are known.
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "SearchChecks.h"
#include "TaskTestTools.h"
#include "TestMeshes.h"

#include "dggCentroidal.h"
#include "dggExactGeodesics.h"
#include "dggMeshQuality.h"
#include "dggSurfacePath.h"
#include "dggVoronoi.h"
#include "dggVoronoiTask.h"
#include "dggWindowCells.h"

namespace dggtest
{
namespace
{
using dgg::GraphSeed;
using dgg::SurfaceMesh;
using dgg::SurfacePoint;
using dgg::VoronoiDiagram;
using Sites = std::vector<SurfacePoint>;
using Place = std::array<double, 3>;

std::vector<GraphSeed> SeedsOf(const SearchCase& c, const Sites& sites, double accuracy)
{
  const dgg::GraphBuilder builder(c.GetMesh());
  dgg::LinkedSites linked;
  EXPECT_TRUE(dgg::LinkSites(sites, &builder, accuracy, linked).IsOk());
  return linked.Seeds;
}

/// How cells are computed.
enum class Cells
{
  Plain,
  Refined,
  OfWindows
};
constexpr double Chord = 1e-4; // of OfWindows, in mean edges

/// Returns the diagram of exact distances.
VoronoiDiagram DiagramOfWindows(const SurfaceMesh& mesh, const Sites& sites)
{
  std::vector<dgg::GeodesicSource> sources;
  for (const SurfacePoint& site : sites)
  {
    sources.push_back({ site, 0.0 });
  }
  dgg::ExactOptions options;
  options.KeepWindows = true;
  dgg::ExactResult exact;
  EXPECT_TRUE(dgg::ExactGeodesics(mesh).Run(sources, options, exact).IsOk());
  const dgg::DistanceField field{ &mesh, exact.Distances.data(), &exact.Windows, nullptr,
    exact.NearestSource.data() };
  VoronoiDiagram diagram;
  const dgg::Status status =
    dgg::ComputeWindowCells(field, Chord * mesh.GetMeanEdgeLength(), nullptr, nullptr, diagram);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return diagram;
}

VoronoiDiagram DiagramOf(
  const SearchCase& c, const Sites& sites, double accuracy, Cells kind = Cells::Refined)
{
  if (kind == Cells::OfWindows)
  {
    return DiagramOfWindows(c.GetMesh(), sites);
  }
  const dgg::GraphBuilder builder(c.GetMesh());
  VoronoiDiagram diagram;
  dgg::VoronoiInput input;
  input.Seeds = SeedsOf(c, sites, accuracy);
  input.Accuracy = accuracy;
  if (kind == Cells::Refined)
  {
    input.Builder = &builder;
    input.Places = sites;
  }
  const dgg::Status status =
    dgg::ComputeVoronoi(c.GetSearch(), c.GetMesh(), input, nullptr, diagram);
  EXPECT_TRUE(status.IsOk()) << c.GetName() << ": " << status.GetMessage();
  return diagram;
}

dgg::VoronoiInput InputOf(const std::vector<GraphSeed>& seeds)
{
  dgg::VoronoiInput input;
  input.Seeds = seeds;
  return input;
}

SurfacePoint PointOf(const VoronoiDiagram& diagram, Id point)
{
  const auto n = static_cast<Id>(diagram.Distances.size());
  return point < n ? SurfacePoint::AtVertex(point) : diagram.BorderPoints[point - n];
}

double DistanceAt(const VoronoiDiagram& diagram, Id point)
{
  const auto n = static_cast<Id>(diagram.Distances.size());
  return point < n ? diagram.Distances[point] : diagram.BorderDistances[point - n];
}

double AreaOf(const SurfaceMesh& mesh, Id face)
{
  return 0.5 * mesh.Length(3 * face) * mesh.ApexY(3 * face);
}

/// Calls `use(polygon, from, to)` for every side of every polygon.
void ForEachSide(const VoronoiDiagram& diagram, const std::function<void(std::size_t, Id, Id)>& use)
{
  for (std::size_t p = 0; p < diagram.GetNumberOfPolygons(); ++p)
  {
    const dgg::Offset begin = diagram.PolygonOffsets[p];
    const dgg::Offset end = diagram.PolygonOffsets[p + 1];
    for (dgg::Offset i = begin; i < end; ++i)
    {
      use(p, diagram.PolygonPoints[i], diagram.PolygonPoints[i + 1 < end ? i + 1 : begin]);
    }
  }
}

std::pair<Id, Id> Pair(Id a, Id b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Expects polygons that cover the faces without gaps, and curves that separate the cells that they
/// name.
void ExpectWellFormed(
  const SurfaceMesh& mesh, const VoronoiDiagram& diagram, Id numberOfSites, const std::string& what)
{
  const Id n = mesh.GetNumberOfVertices();
  ASSERT_EQ(diagram.NearestSites.size(), static_cast<std::size_t>(n)) << what;
  ASSERT_EQ(diagram.BorderPoints.size(), diagram.BorderDistances.size()) << what;
  ASSERT_EQ(diagram.PolygonOffsets.size(), diagram.GetNumberOfPolygons() + 1) << what;
  ASSERT_EQ(diagram.CurveOffsets.size(), diagram.GetNumberOfCurves() + 1) << what;
  for (const SurfacePoint& point : diagram.BorderPoints)
  {
    EXPECT_TRUE(point.Check(mesh).IsOk()) << what << ": " << point.Check(mesh).GetMessage();
    EXPECT_NE(point.On, SurfacePoint::Support::Vertex) << what;
  }
  // The areas of the polygons sum to the areas of the faces.
  std::vector<double> area(mesh.GetNumberOfFaces(), 0.0);
  for (std::size_t p = 0; p < diagram.GetNumberOfPolygons(); ++p)
  {
    area[diagram.PolygonFaces[p]] += diagram.PolygonAreas[p];
    EXPECT_GE(diagram.PolygonAreas[p], -1e-12 * AreaOf(mesh, diagram.PolygonFaces[p])) << what;
    EXPECT_LT(diagram.PolygonSites[p], numberOfSites) << what;
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const double expected = mesh.IsDropped(f) ? 0.0 : AreaOf(mesh, f);
    EXPECT_NEAR(area[f], expected, 1e-9 * expected) << what << " face " << f;
  }
  // Inside a face both sides of a segment are polygons; on an edge, all faces have the same
  // segments.
  std::map<std::pair<Id, Id>, std::vector<std::size_t>> sides;
  ForEachSide(diagram, [&](std::size_t p, Id a, Id b) {
    EXPECT_NE(a, b) << what;
    sides[Pair(a, b)].push_back(p);
    for (const Id point : { a, b })
    {
      Place place{};
      EXPECT_TRUE(dgg::FindInFace(mesh, PointOf(diagram, point), diagram.PolygonFaces[p], place))
        << what;
    }
  });
  std::map<std::pair<Id, Id>, std::size_t> facesOfEdge;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    facesOfEdge[Pair(mesh.Origin(h), mesh.Destination(h))] +=
      mesh.IsDropped(SurfaceMesh::Face(h)) ? 0 : 1;
  }
  std::map<std::pair<Id, Id>, std::set<Id>> sitesOfSide;
  for (const auto& side : sides)
  {
    std::map<Id, int> faces;
    for (const std::size_t p : side.second)
    {
      ++faces[diagram.PolygonFaces[p]];
      sitesOfSide[side.first].insert(diagram.PolygonSites[p]);
    }
    if (faces.begin()->second == 2) // inside a face
    {
      for (const auto& face : faces)
      {
        EXPECT_EQ(face.second, 2) << what << " face " << face.first;
      }
      continue;
    }
    const SurfacePoint a = PointOf(diagram, side.first.first);
    const SurfacePoint b = PointOf(diagram, side.first.second);
    const SurfacePoint& inner = a.On == SurfacePoint::Support::Edge ? a : b;
    const std::size_t expected = inner.On == SurfacePoint::Support::Edge
      ? facesOfEdge[Pair(mesh.Origin(inner.HalfEdge), mesh.Destination(inner.HalfEdge))]
      : facesOfEdge[side.first];
    EXPECT_EQ(side.second.size(), expected) << what;
  }
  // Curves run along segments between different cells, and every such segment is in a curve.
  std::set<std::pair<Id, Id>> inCurves;
  for (std::size_t k = 0; k < diagram.GetNumberOfCurves(); ++k)
  {
    EXPECT_LT(diagram.CurveSites[k][0], diagram.CurveSites[k][1]) << what;
    ASSERT_GE(diagram.CurveOffsets[k + 1] - diagram.CurveOffsets[k], 2) << what;
    for (dgg::Offset i = diagram.CurveOffsets[k]; i + 1 < diagram.CurveOffsets[k + 1]; ++i)
    {
      const auto side = Pair(diagram.CurvePoints[i], diagram.CurvePoints[i + 1]);
      inCurves.insert(side);
      for (const Id site : diagram.CurveSites[k])
      {
        EXPECT_EQ(sitesOfSide[side].count(site), 1u) << what;
      }
    }
  }
  for (const auto& side : sitesOfSide)
  {
    if (side.second.size() > 1)
    {
      EXPECT_EQ(inCurves.count(side.first), 1u) << what;
    }
  }
}

/// Calls `use(sites, point)` for every point of every curve.
void ForEachCurvePoint(
  const VoronoiDiagram& diagram, const std::function<void(const std::array<Id, 2>&, Id)>& use)
{
  for (std::size_t k = 0; k < diagram.GetNumberOfCurves(); ++k)
  {
    for (dgg::Offset i = diagram.CurveOffsets[k]; i < diagram.CurveOffsets[k + 1]; ++i)
    {
      use(diagram.CurveSites[k], diagram.CurvePoints[i]);
    }
  }
}

/// Expects borders at equal distances from their sites. `distance(point, site)` returns the
/// distance of a point of the diagram.
void ExpectBorders(const std::string& what, const VoronoiDiagram& diagram,
  std::size_t numberOfSites, double tolerance,
  const std::function<double(Id, std::size_t)>& distance)
{
  ForEachCurvePoint(diagram, [&](const std::array<Id, 2>& sites, Id point) {
    const double a = distance(point, sites[0]);
    EXPECT_NEAR(a, distance(point, sites[1]), tolerance * a) << what;
    EXPECT_NEAR(DistanceAt(diagram, point), a, tolerance * a) << what;
    for (std::size_t s = 0; s < numberOfSites; ++s)
    {
      EXPECT_GE(distance(point, s), a * (1.0 - tolerance)) << what;
    }
  });
}

/// Expects polygons and borders to agree with known distances `distance(place, site)`. Polygons are
/// tested at their center.
void ExpectKnown(const SearchCase& c, const VoronoiDiagram& diagram, std::size_t numberOfSites,
  double tolerance, const std::function<double(const Place&, std::size_t)>& distance)
{
  const auto placeOf = [&](Id point) {
    return dgg::PositionOf(c.GetMesh(), PointOf(diagram, point), c.GetPoints().Points.data());
  };
  ExpectBorders(c.GetName(), diagram, numberOfSites, tolerance,
    [&](Id point, std::size_t site) { return distance(placeOf(point), site); });
  for (std::size_t q = 0; q < diagram.GetNumberOfPolygons(); ++q)
  {
    Place middle{};
    const dgg::Offset begin = diagram.PolygonOffsets[q];
    const dgg::Offset end = diagram.PolygonOffsets[q + 1];
    for (dgg::Offset i = begin; i < end; ++i)
    {
      const Place p = placeOf(diagram.PolygonPoints[i]);
      for (int k = 0; k < 3; ++k)
      {
        middle[k] += p[k] / static_cast<double>(end - begin);
      }
    }
    const double own = distance(middle, diagram.PolygonSites[q]);
    for (std::size_t s = 0; s < numberOfSites; ++s)
    {
      EXPECT_GE(distance(middle, s), own * (1.0 - tolerance)) << c.GetName();
    }
  }
}

/// Returns the distances of all points of a diagram from each site separately.
std::vector<std::vector<double>> ExactDistances(
  const SurfaceMesh& mesh, const VoronoiDiagram& diagram, const Sites& sites)
{
  Sites targets;
  for (std::size_t i = 0; i < diagram.Distances.size() + diagram.BorderPoints.size(); ++i)
  {
    targets.push_back(PointOf(diagram, static_cast<Id>(i)));
  }
  std::vector<std::vector<double>> distances;
  for (const SurfacePoint& site : sites)
  {
    distances.push_back(DistancesTo(mesh, dgg::ExactEngine::Triangle, site, targets));
  }
  return distances;
}

/// Returns the largest relative difference between the distances from two sites in the middle of a
/// segment between their cells.
double LargestDifference(const SurfaceMesh& mesh, const VoronoiDiagram& diagram, const Sites& sites)
{
  std::map<std::pair<Id, Id>, std::size_t> polygons; // by the ends of their sides
  ForEachSide(diagram, [&](std::size_t q, Id from, Id to) { polygons[{ from, to }] = q; });
  double largest = 0.0;
  ForEachSide(diagram, [&](std::size_t q, Id from, Id to) {
    const auto neighbor = polygons.find({ to, from });
    const Id face = diagram.PolygonFaces[q];
    if (from > to || neighbor == polygons.end() || diagram.PolygonFaces[neighbor->second] != face)
    {
      return;
    }
    Place middle{};
    for (const Id point : { from, to })
    {
      dgg::ForEachFaceAround(mesh, PointOf(diagram, point), [&](Id f, const Place& b) {
        for (int k = 0; k < 3 && f == face; ++k)
        {
          middle[k] += 0.5 * b[k];
        }
      });
    }
    const auto distanceFrom = [&](Id site) {
      return DistancesTo(mesh, dgg::ExactEngine::Triangle, sites[site],
        { SurfacePoint::InTriangle(mesh, face, middle) })[0];
    };
    const double a = distanceFrom(diagram.PolygonSites[q]);
    const double b = distanceFrom(diagram.PolygonSites[neighbor->second]);
    largest = std::max(largest, std::abs(a - b) / std::max(a, b));
  });
  return largest;
}

/// Expects the diagram of Euclidean distances in the plane.
void ExpectPlane(
  const SearchCase& c, const VoronoiDiagram& diagram, const Sites& sites, double tolerance)
{
  std::vector<Place> places;
  for (const SurfacePoint& site : sites)
  {
    places.push_back(dgg::PositionOf(c.GetMesh(), site, c.GetPoints().Points.data()));
  }
  ExpectKnown(c, diagram, sites.size(), tolerance, [&](const Place& p, std::size_t site) {
    return std::hypot(p[0] - places[site][0], p[1] - places[site][1]);
  });
}
}

TEST(Voronoi, OnAnySurface)
{
  for (const NamedMesh& named : AllMeshes())
  {
    const SearchCase c(named.Name, named.Mesh, 0.05);
    Sites sites = AtVertices(SomeVertices(c.GetMesh(), 8, 5));
    const Sites inFaces = RandomSurfacePoints(c.GetMesh(), 8, 3);
    sites.insert(sites.end(), inFaces.begin(), inFaces.end());
    for (const Cells kind : { Cells::Plain, Cells::Refined, Cells::OfWindows })
    {
      const VoronoiDiagram diagram = DiagramOf(c, sites, 0.05, kind);
      ExpectWellFormed(c.GetMesh(), diagram, static_cast<Id>(sites.size()), named.Name);
    }
  }
}

TEST(Voronoi, ThePlane)
{
  for (double jitter : { 0.0, 0.25 })
  {
    const SearchCase c("plane " + std::to_string(jitter), Plane(16, 12, jitter, 8), 0.01);
    const Sites sites = RandomSurfacePoints(c.GetMesh(), 9, 12);
    for (const Cells kind : { Cells::Refined, Cells::OfWindows })
    {
      const VoronoiDiagram diagram = DiagramOf(c, sites, 0.01, kind);
      ExpectWellFormed(c.GetMesh(), diagram, 9, c.GetName());
      ExpectPlane(c, diagram, sites, kind == Cells::Refined ? 0.005 : 1e-6);
      // Cells are convex, so there is one curve per pair.
      const std::set<std::array<Id, 2>> pairs(diagram.CurveSites.begin(), diagram.CurveSites.end());
      EXPECT_EQ(pairs.size(), diagram.GetNumberOfCurves());
      EXPECT_GE(pairs.size(), 9u);
    }
  }
}

TEST(Voronoi, BordersAlongEdgesAndThroughVertices)
{
  // Sites mirrored in a grid line, and in its diagonals: all borders have ties.
  const TestMesh points = Plane(8, 8);
  const SearchCase c("grid", points, 0.01);
  const double unit = points.Point(points.GetNumberOfVertices() - 1)[0] / 8.0;
  const auto at = [&](int x, int y) { return VertexAt(points, x * unit, y * unit, 0.0); };
  for (const std::vector<Id>& vertices : { std::vector<Id>{ at(2, 4), at(6, 4) },
         std::vector<Id>{ at(2, 2), at(6, 2), at(2, 6), at(6, 6) },
         std::vector<Id>{ at(4, 2), at(2, 4), at(6, 4), at(4, 6) },
         std::vector<Id>{ at(4, 4), at(3, 4), at(5, 4), at(4, 3), at(4, 5) } })
  {
    const Sites sites = AtVertices(vertices);
    for (const Cells kind : { Cells::Refined, Cells::OfWindows })
    {
      const VoronoiDiagram diagram = DiagramOf(c, sites, 0.01, kind);
      ExpectWellFormed(c.GetMesh(), diagram, static_cast<Id>(sites.size()), "grid");
      ExpectPlane(c, diagram, sites, kind == Cells::Refined ? 0.003 : 1e-5);
    }
  }
}

TEST(Voronoi, SitesAtTheCornersOfAGrid)
{
  // Distances along edges tie up to rounding, in many intervals.
  const TestMesh points = Plane(10, 10);
  const SearchCase c("grid", points, 0.01);
  const Id last = c.GetNumberOfVertices() - 1;
  const VoronoiDiagram diagram =
    DiagramOf(c, AtVertices({ 0, 10, last - 10, last }), 0.01, Cells::OfWindows);
  ExpectWellFormed(c.GetMesh(), diagram, 4, "grid");
  EXPECT_EQ(diagram.GetNumberOfCurves(), 4u);
}

TEST(Voronoi, ManySitesInAFace)
{
  // A face contains whole cells, and its corners are far away.
  TestMesh triangle;
  triangle.AddPoint(0.0, 0.0, 0.0);
  triangle.AddPoint(3.0, 0.0, 0.0);
  triangle.AddPoint(1.0, 2.0, 0.0);
  triangle.AddTriangle(0, 1, 2);
  const SearchCase c("triangle", triangle, 0.01);
  const Sites sites = RandomSurfacePoints(c.GetMesh(), 25, 4);
  for (const Cells kind : { Cells::Refined, Cells::OfWindows })
  {
    const VoronoiDiagram diagram = DiagramOf(c, sites, 0.01, kind);
    ExpectWellFormed(c.GetMesh(), diagram, 25, "triangle");
    EXPECT_EQ(diagram.GetNumberOfPolygons(), 25u);
    ExpectPlane(c, diagram, sites, kind == Cells::Refined ? 1e-9 : 1e-6);
  }
}

TEST(Voronoi, AConeAndASphere)
{
  const double accuracy = 0.01;
  std::vector<ConePoint> coordinates;
  for (const NamedMesh& named : { NamedMesh{ "sharp cone", Cone(4.0, 30, 12, coordinates, 0.1, 2) },
         NamedMesh{ "saddle cone", Cone(8.0, 40, 12, coordinates, 0.1, 2) },
         NamedMesh{ "sphere", Icosphere(4) }, NamedMesh{ "torus", Torus(40, 24) } })
  {
    const SearchCase c(named.Name, named.Mesh, accuracy);
    const Sites sites = RandomSurfacePoints(c.GetMesh(), 10, 21);
    for (const Cells kind : { Cells::Refined, Cells::OfWindows })
    {
      const double tolerance = kind == Cells::Refined ? accuracy : 1e-6;
      const VoronoiDiagram diagram = DiagramOf(c, sites, accuracy, kind);
      ExpectWellFormed(c.GetMesh(), diagram, 10, named.Name);
      // Exact distances of all border points from each site separately.
      const std::vector<std::vector<double>> exact = ExactDistances(c.GetMesh(), diagram, sites);
      ASSERT_GT(diagram.GetNumberOfCurves(), 9u);
      ExpectBorders(named.Name, diagram, sites.size(), 2.0 * tolerance,
        [&](Id point, std::size_t site) { return exact[site][point]; });
      for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
      {
        double nearest = dgg::Infinity;
        for (const auto& field : exact)
        {
          nearest = std::min(nearest, field[v]);
        }
        EXPECT_LE(exact[diagram.NearestSites[v]][v], nearest * (1.0 + 2.0 * tolerance));
        EXPECT_NEAR(diagram.Distances[v], nearest, tolerance * nearest * (1.0 + 1e-6));
      }
    }
  }
}

TEST(Voronoi, RefinedWhereFacesAreLarge)
{
  // Paths to the corners of a face pass on different sides of obstacles: the corners alone do not
  // determine the borders, so refinement is needed.
  const double accuracy = 0.01;
  const SearchCase c("box", Box(5, 5, 5, 1.0, 1.3, 0.8), accuracy);
  const Sites sites = RandomSurfacePoints(c.GetMesh(), 12, 5);
  std::map<Cells, double> largest;
  std::map<Cells, double> inside; // in the middle of segments
  for (const Cells kind : { Cells::Plain, Cells::Refined, Cells::OfWindows })
  {
    const VoronoiDiagram diagram = DiagramOf(c, sites, accuracy, kind);
    ExpectWellFormed(c.GetMesh(), diagram, 12, "box");
    const std::vector<std::vector<double>> exact = ExactDistances(c.GetMesh(), diagram, sites);
    double& error = largest[kind];
    ForEachCurvePoint(diagram, [&](const std::array<Id, 2>& pair, Id point) {
      const double a = exact[pair[0]][point];
      const double b = exact[pair[1]][point];
      error = std::max(error, std::abs(a - b) / std::max(a, b));
    });
    inside[kind] = LargestDifference(c.GetMesh(), diagram, sites);
    EXPECT_EQ(diagram.AreBordersWrong, kind == Cells::Refined);
  }
  EXPECT_GT(largest[Cells::Plain], 4.0 * accuracy);
  EXPECT_LT(largest[Cells::Refined], 2.0 * accuracy);
  EXPECT_GT(inside[Cells::Refined], 2.0 * accuracy);
  EXPECT_LT(largest[Cells::OfWindows], 1e-6);
  EXPECT_LT(inside[Cells::OfWindows], Chord);

  const double coarse = 0.1;
  const SearchCase fine("box", Box(5, 5, 5, 1.0, 1.3, 0.8), coarse);
  const VoronoiDiagram diagram = DiagramOf(fine, sites, coarse);
  EXPECT_LT(LargestDifference(fine.GetMesh(), diagram, sites), 2.0 * coarse);
  EXPECT_FALSE(diagram.AreBordersWrong);
}

/// Cells are exact where borders of the graph are wrong although no triangles are coarse.
TEST(Voronoi, ExactWhereBordersAreWrong)
{
  const double accuracy = 0.03;
  const TestMesh box = Box(8, 8, 8, 1.0, 1.3, 0.8);
  const SearchCase c("box", box, accuracy);
  const Sites sites = RandomSurfacePoints(c.GetMesh(), 3, 1);
  const VoronoiDiagram diagram = DiagramOf(c, sites, accuracy);
  const GraphWorld world(box, accuracy);
  ASSERT_TRUE(diagram.AreBordersWrong);
  ASSERT_FALSE(
    dgg::HasCoarseTriangles(*world.Surface, accuracy, diagram.Distances, dgg::ErrorAtBorders));
  dgg::VoronoiResult result;
  for (const SurfacePoint& site : sites)
  {
    result.Sites.push_back({ site, 0.0 });
  }
  dgg::VoronoiOptions options;
  options.IsRefined = true;
  dgg::GraphSession session = StartSession(world);
  ASSERT_TRUE(Ok(dgg::FindVoronoiCells(world.MakeContext(), session, options, result)));
  EXPECT_TRUE(result.QualityWarning.empty());
  ExpectWellFormed(c.GetMesh(), result.Diagram, 3, "box");
  EXPECT_GT(LargestDifference(c.GetMesh(), diagram, sites), accuracy);
  EXPECT_LT(LargestDifference(c.GetMesh(), result.Diagram, sites), 1e-4);
}

TEST(Voronoi, AroundACylinder)
{
  // A tube has one closed border between one pair of sites.
  const TestMesh tube = PrismSide(24, 1, 20, 0.0, 1);
  const SearchCase c("tube", tube, 0.01);
  const double low = tube.Point(0)[2];
  const double high = tube.Point(tube.GetNumberOfVertices() - 1)[2];
  ASSERT_LT(low, high);
  // Rings of sites at both ends: the border between the rings is a closed curve around the tube.
  std::vector<GraphSeed> seeds;
  for (Id v = 0; v < tube.GetNumberOfVertices(); ++v)
  {
    const double z = tube.Point(v)[2];
    if (z == low || z == high)
    {
      seeds.push_back(SeedAt(v, 0.0, z == low ? 0 : 1));
    }
  }
  VoronoiDiagram diagram;
  ASSERT_TRUE(
    dgg::ComputeVoronoi(c.GetSearch(), c.GetMesh(), InputOf(seeds), nullptr, diagram).IsOk());
  ExpectWellFormed(c.GetMesh(), diagram, 2, "tube");
  ASSERT_EQ(diagram.GetNumberOfCurves(), 1u);
  EXPECT_EQ(diagram.CurvePoints.front(), diagram.CurvePoints.back());
  EXPECT_GE(diagram.CurvePoints.size(), 25u);
  for (const Id point : diagram.CurvePoints)
  {
    const Place p = dgg::PositionOf(c.GetMesh(), PointOf(diagram, point), tube.Points.data());
    EXPECT_NEAR(p[2], 0.5 * (low + high), 0.01 * (high - low));
  }
}

TEST(Voronoi, UnreachedComponents)
{
  const SearchCase c("several components", SeveralComponents(), 0.05);
  for (const Cells kind : { Cells::Refined, Cells::OfWindows })
  {
    const VoronoiDiagram diagram = DiagramOf(c, AtVertices({ 0 }), 0.05, kind);
    ExpectWellFormed(c.GetMesh(), diagram, 1, "several components");
    Id count = 0;
    const std::vector<Id> component = c.GetMesh().ComputeComponents(count);
    for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
    {
      const bool isReached = component[v] == component[0];
      EXPECT_EQ(diagram.NearestSites[v], isReached ? 0 : dgg::NoId);
      EXPECT_EQ(diagram.Distances[v] < dgg::Infinity, isReached);
    }
    const std::set<Id> sites(diagram.PolygonSites.begin(), diagram.PolygonSites.end());
    EXPECT_EQ(sites, (std::set<Id>{ dgg::NoId, 0 }));
    EXPECT_EQ(diagram.GetNumberOfCurves(), 0u);
  }
}

TEST(Voronoi, EveryVertexIsASite)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const SearchCase c(named.Name, named.Mesh, 0.1);
    std::vector<Id> all(c.GetNumberOfVertices());
    for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
    {
      all[v] = v;
    }
    for (const Cells kind : { Cells::Refined, Cells::OfWindows })
    {
      const VoronoiDiagram diagram = DiagramOf(c, AtVertices(all), 0.1, kind);
      ExpectWellFormed(c.GetMesh(), diagram, c.GetNumberOfVertices(), named.Name);
      EXPECT_EQ(diagram.NearestSites, all) << named.Name;
    }
  }
}

TEST(Voronoi, OneSiteAndDuplicates)
{
  const SearchCase c("sphere", Icosphere(3), 0.05);
  for (const Cells kind : { Cells::Refined, Cells::OfWindows })
  {
    VoronoiDiagram diagram = DiagramOf(c, AtVertices({ 40 }), 0.05, kind);
    ExpectWellFormed(c.GetMesh(), diagram, 1, "one site");
    EXPECT_EQ(diagram.GetNumberOfCurves(), 0u);
    EXPECT_EQ(
      diagram.GetNumberOfPolygons(), static_cast<std::size_t>(c.GetMesh().GetNumberOfFaces()));

    const auto inner = SurfacePoint::InFace(c.GetMesh(), 100, { { 0.2, 0.3, 0.5 } });
    const VoronoiDiagram expected =
      DiagramOf(c, { SurfacePoint::AtVertex(7), inner, SurfacePoint::AtVertex(90) }, 0.05, kind);
    diagram = DiagramOf(c,
      { SurfacePoint::AtVertex(7), inner, SurfacePoint::AtVertex(90), inner,
        SurfacePoint::AtVertex(7), inner },
      0.05, kind);
    EXPECT_EQ(diagram.PolygonSites, expected.PolygonSites);
    EXPECT_EQ(diagram.PolygonPoints, expected.PolygonPoints);
    EXPECT_EQ(diagram.CurveSites, expected.CurveSites);
  }
}

TEST(Voronoi, GraphsWithoutDirections)
{
  const SearchCase c("plane", Plane(10, 10, 0.2, 5), 0.02);
  dgg::GraphView graph = c.GetGraph();
  graph.Angles = nullptr;
  graph.ArrivalAngles = nullptr;
  const dgg::GraphSearch search(graph, &c.GetMesh());
  VoronoiDiagram diagram;
  const Sites sites = AtVertices({ 5, 60, 100 });
  ASSERT_TRUE(
    dgg::ComputeVoronoi(search, c.GetMesh(), InputOf(SeedsOf(c, sites, 0.02)), nullptr, diagram)
      .IsOk());
  ExpectWellFormed(c.GetMesh(), diagram, 3, "without directions");
  ExpectPlane(c, diagram, sites, 0.04);
}

/// A graph that reaches a vertex but not its neighbor.
TEST(Voronoi, GraphsOfTooFewEdges)
{
  TestMesh plane = Plane(12, 12);
  for (std::size_t i = 0; i < plane.Points.size(); i += 3)
  {
    const double x = plane.Points[i] - 6.0;
    plane.Points[i] = std::abs(x) * x * x;
  }
  const SurfaceMesh mesh = Build(plane);
  dgg::GraphOptions options;
  options.Construction = dgg::GraphConstruction::SaddleVertexGraph;
  options.NumberOfNeighbors = 1;
  dgg::GeodesicGraph graph;
  ASSERT_TRUE(dgg::GraphBuilder(mesh).Build(options, graph).IsOk());
  const dgg::GraphSearch search(graph.View(), &mesh);
  VoronoiDiagram diagram;
  const dgg::Status status =
    dgg::ComputeVoronoi(search, mesh, InputOf({ SeedAt(0) }), nullptr, diagram);
  EXPECT_FALSE(status.IsOk());
  EXPECT_TRUE(Says(status, "too few edges"));
  EXPECT_TRUE(diagram.NearestSites.empty());
  dgg::VoronoiInput labels = InputOf({ SeedAt(0) });
  labels.LabelsOnly = true;
  EXPECT_TRUE(dgg::ComputeVoronoi(search, mesh, labels, nullptr, diagram).IsOk());
  EXPECT_EQ(diagram.NearestSites[0], 0);
}
}
