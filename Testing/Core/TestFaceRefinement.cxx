// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Refinement of faces in a region of a surface.
#include "CurveChecks.h"
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggBorderRefinement.h"
#include "dggCapSplitting.h"
#include "dggCentroidal.h"
#include "dggEdgeCuts.h"
#include "dggFaceRefinement.h"
#include "dggVoronoi.h"

namespace dggtest
{
namespace
{
using dgg::SubMesh;
using dgg::SurfaceCurve;

std::vector<Id> Refine(
  const dgg::SurfaceMesh& mesh, const std::vector<Id>& faces, int levels, SubMesh& surface)
{
  std::vector<Id> parents;
  EXPECT_TRUE(Ok(dgg::RefineFaces(mesh, faces, levels, nullptr, surface, parents)));
  return parents;
}

double AreaOf(const SubMesh& surface, Id f)
{
  return dgg::TriangleArea(
    surface.Lengths[3 * f], surface.Lengths[3 * f + 1], surface.Lengths[3 * f + 2]);
}

/// Expects faces to be parts of their parents, and the parts of the chosen faces to have equal
/// size.
void ExpectParts(const SubMesh& before, const SubMesh& after, const std::vector<Id>& parents,
  const std::vector<Id>& chosen, int levels)
{
  ASSERT_EQ(parents.size(), after.Faces.size());
  std::vector<double> areas(before.Faces.size(), 0.0);
  std::vector<Id> counts(before.Faces.size(), 0);
  for (Id f = 0; f < after.GetNumberOfFaces(); ++f)
  {
    ASSERT_EQ(after.Faces[f], before.Faces[parents[f]]);
    areas[parents[f]] += AreaOf(after, f);
    ++counts[parents[f]];
  }
  const Id parts = 1 << (2 * levels);
  for (Id f = 0; f < before.GetNumberOfFaces(); ++f)
  {
    EXPECT_NEAR(areas[f], AreaOf(before, f), 1e-9 * areas[f]);
  }
  for (const Id f : chosen)
  {
    EXPECT_EQ(counts[f], parts);
  }
  for (Id f = 0; f < after.GetNumberOfFaces(); ++f)
  {
    if (std::find(chosen.begin(), chosen.end(), parents[f]) != chosen.end())
    {
      EXPECT_NEAR(parts * AreaOf(after, f), AreaOf(before, parents[f]), 1e-9 * areas[parents[f]]);
    }
  }
}

/// Returns a plane of equilateral triangles with sheared rows.
TestMesh EquilateralPlane(Id n)
{
  TestMesh mesh = Plane(n, n);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double* p = mesh.Points.data() + 3 * static_cast<std::size_t>(v);
    p[0] -= 0.5 * p[1];
    p[1] *= std::sqrt(0.75);
  }
  return mesh;
}

double SmallestAngle(const SubMesh& surface)
{
  double smallest = dgg::Pi;
  for (Id h = 0; h < static_cast<Id>(surface.Triangles.size()); ++h)
  {
    const double a = surface.Lengths[h];
    const double b = surface.Lengths[dgg::SurfaceMesh::Previous(h)];
    const double c = surface.Lengths[dgg::SurfaceMesh::Next(h)];
    smallest = std::min(smallest, std::acos((a * a + b * b - c * c) / (2.0 * a * b)));
  }
  return smallest;
}
}

TEST(FaceRefinement, AllFaces)
{
  std::vector<Id> sheetOf;
  for (const TestMesh& input :
    { NoisySphere(1, 0.3, 3), Plane(4, 3, 0.2, 5), Tetrahedron(), Book(5, 3, sheetOf) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    const SubMesh before = Embed(mesh, {});
    SubMesh surface = before;
    std::vector<Id> all(before.Faces.size());
    std::iota(all.begin(), all.end(), 0);
    const std::vector<Id> parents = Refine(mesh, all, 3, surface);
    ExpectParts(before, surface, parents, all, 3);
    ExpectSoundEmbedding(input, mesh, {}, surface);
    EXPECT_EQ(surface.GetNumberOfVertices(), Subdivided(input, 8).GetNumberOfVertices());
  }
}

TEST(FaceRefinement, GreenFacesAreSplitOnce)
{
  const TestMesh input = EquilateralPlane(12);
  const dgg::SurfaceMesh mesh = Build(input);
  const SubMesh before = Embed(mesh, {});
  ASSERT_NEAR(SmallestAngle(before), dgg::Pi / 3.0, 1e-12);
  for (int levels = 1; levels <= 4; ++levels)
  {
    SubMesh surface = before;
    const std::vector<Id> chosen{ 130, 131, 155 };
    const std::vector<Id> parents = Refine(mesh, chosen, levels, surface);
    ExpectParts(before, surface, parents, chosen, levels);
    ExpectSoundEmbedding(input, mesh, {}, surface);
    EXPECT_NEAR(SmallestAngle(surface), dgg::Pi / 6.0, 1e-9) << levels;
  }
}

TEST(FaceRefinement, ParametersBetweenPointsInOnePlace)
{
  // Points 1 to 3 are one vertex; the midpoint of the next edge is halfway between points 3 and 4.
  const dgg::SurfaceMesh mesh = Build(Plane(1, 1));
  const dgg::SurfacePoint start = dgg::SurfacePoint::AtVertex(0);
  const dgg::SurfacePoint stop = dgg::SurfacePoint::AtVertex(1);
  const std::vector<SurfaceCurve> curves{ Curve(
    mesh, { start, stop, stop, stop, dgg::SurfacePoint::AtVertex(3) }) };
  SubMesh surface = Embed(mesh, curves);
  Refine(mesh, { 0, 1 }, 1, surface);
  const dgg::CurveChain chain = dgg::FollowCurve(surface, curves, 0);
  EXPECT_EQ(chain.Parameters, (std::vector<double>{ 0.0, 0.5, 1.0, 3.5, 4.0 }));
  EXPECT_EQ(chain.GivenPoints, (std::vector<dgg::Offset>{ 0, 2, 2, 2, 4 }));
}

// Triangles of zero area are removed, and the surface does not change.

namespace
{
/// A mesh without its caps, the number of caps, and the parent of each triangle.
struct Split
{
  TestMesh Mesh;
  std::vector<Id> Parents;
  dgg::Offset Caps = 0;
  double Height = 0.0;
};

Split SplitMesh(const TestMesh& mesh)
{
  Split split;
  split.Mesh = mesh;
  const dgg::CapSplitting done =
    dgg::SplitCaps(mesh.Points.data(), split.Mesh.Triangles, split.Parents);
  split.Caps = done.NumberOfCaps;
  split.Height = done.LargestHeight;
  return split;
}

double AreaOf(const TestMesh& mesh, Id f)
{
  const auto at = [&](int corner, int axis) {
    return mesh.Points[3 * mesh.Triangles[3 * f + corner] + axis];
  };
  double cross[3];
  for (int k = 0; k < 3; ++k)
  {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    cross[k] =
      (at(1, i) - at(0, i)) * (at(2, j) - at(0, j)) - (at(1, j) - at(0, j)) * (at(2, i) - at(0, i));
  }
  return 0.5 * std::hypot(cross[0], cross[1], cross[2]);
}

/// Expects the pieces of each input triangle to have the same total area as the triangle.
void ExpectSameAreas(const TestMesh& before, const Split& after)
{
  ASSERT_EQ(after.Parents.size(), static_cast<std::size_t>(after.Mesh.GetNumberOfFaces()));
  std::vector<double> areas(before.GetNumberOfFaces(), 0.0);
  for (Id f = 0; f < after.Mesh.GetNumberOfFaces(); ++f)
  {
    areas[after.Parents[f]] += AreaOf(after.Mesh, f);
  }
  for (Id f = 0; f < before.GetNumberOfFaces(); ++f)
  {
    EXPECT_NEAR(areas[f], AreaOf(before, f), 1e-14) << f;
  }
}

/// Returns the unit square as two rectangles that meet at x = 1/2. The left one has an edge there,
/// the right one has `points` additional points on the edge; caps fill the gap as a fan or a
/// zigzag.
TestMesh Seam(Id points, bool isFan, std::uint64_t seed)
{
  Random random(seed);
  TestMesh mesh;
  const Id a = mesh.AddPoint(0.5, 0.0, 0.0);
  const Id b = mesh.AddPoint(0.5, 1.0, 0.0);
  std::vector<Id> seam{ a };
  std::vector<double> heights;
  for (Id i = 0; i < points; ++i)
  {
    heights.push_back(random.Uniform(0.05, 0.95));
  }
  std::sort(heights.begin(), heights.end());
  for (const double y : heights)
  {
    seam.push_back(mesh.AddPoint(0.5, y, 0.0));
  }
  seam.push_back(b);
  const Id low = mesh.AddPoint(1.0, 0.0, 0.0);
  const Id high = mesh.AddPoint(1.0, 1.0, 0.0);
  const Id left = mesh.AddPoint(0.0, 0.0, 0.0);
  const Id top = mesh.AddPoint(0.0, 1.0, 0.0);
  mesh.AddTriangle(left, a, b);
  mesh.AddTriangle(left, b, top);
  mesh.AddTriangle(low, high, b);
  for (std::size_t i = 0; i + 1 < seam.size(); ++i)
  {
    mesh.AddTriangle(low, seam[i + 1], seam[i]);
  }
  std::size_t begin = 0;
  std::size_t end = seam.size() - 1;
  while (end - begin > 1)
  {
    const bool fromEnd = !isFan && (end + begin) % 2 == 0;
    const std::size_t apex = fromEnd ? end - 1 : begin + 1;
    mesh.AddTriangle(seam[begin], seam[apex], seam[end]);
    (fromEnd ? end : begin) = apex;
  }
  return mesh;
}
}

TEST(CapSplitting, SeamsOfAPlaneVanish)
{
  for (const bool isFan : { false, true })
  {
    for (const Id points : { 1, 2, 5, 40 })
    {
      const TestMesh mesh = Seam(points, isFan, points);
      const Split split = SplitMesh(mesh);
      EXPECT_GE(split.Caps, points);
      EXPECT_EQ(split.Height, 0.0);
      ExpectSameAreas(mesh, split);
      // The result is a plane again, and all distances are planar up to rounding.
      const dgg::SurfaceMesh plane = Build(split.Mesh);
      EXPECT_EQ(plane.GetNumberOfDegenerateFaces(), 0);
      EXPECT_EQ(plane.GetMollification(), 0.0);
      EXPECT_EQ(split.Mesh.GetNumberOfFaces(), mesh.GetNumberOfFaces());
      ExpectAllPairs(
        plane, dgg::ExactEngine::Triangle,
        [&](Id p, Id q) {
          return std::hypot(mesh.Points[3 * p] - mesh.Points[3 * q],
            mesh.Points[3 * p + 1] - mesh.Points[3 * q + 1]);
        },
        1e-13);
    }
  }
}

TEST(CapSplitting, HeightsAreReported)
{
  TestMesh mesh;
  const Id a = mesh.AddPoint(0.0, 0.0, 0.0);
  const Id b = mesh.AddPoint(2.0, 0.0, 0.0);
  const Id c = mesh.AddPoint(0.7, 0.0, 3e-8);
  mesh.AddTriangle(a, b, c);
  mesh.AddTriangle(b, a, mesh.AddPoint(1.0, 1.0, 0.0));
  const Split split = SplitMesh(mesh);
  EXPECT_EQ(split.Caps, 1);
  EXPECT_NEAR(split.Height, 3e-8, 1e-20);
}

TEST(CapSplitting, AnyNumberOfSheetsOnTheLongEdge)
{
  // Three faces share an edge with a cap, and another face is on each of the short edges of the
  // cap.
  TestMesh mesh;
  const Id a = mesh.AddPoint(0.0, 0.0, 0.0);
  const Id b = mesh.AddPoint(2.0, 0.0, 0.0);
  const Id c = mesh.AddPoint(0.7, 0.0, 0.0);
  mesh.AddTriangle(a, b, c);
  for (const double angle : { 0.3, 1.4, 2.8 })
  {
    mesh.AddTriangle(a, b, mesh.AddPoint(1.0, std::cos(angle), std::sin(angle)));
  }
  const Id below = mesh.AddPoint(1.0, -1.0, 0.0);
  mesh.AddTriangle(a, c, below);
  mesh.AddTriangle(c, b, below);
  const Split split = SplitMesh(mesh);
  EXPECT_EQ(split.Caps, 1);
  EXPECT_EQ(split.Mesh.GetNumberOfFaces(), 3 * 2 + 2);
  ExpectSameAreas(mesh, split);
  EXPECT_EQ(
    std::set<Id>(split.Parents.begin(), split.Parents.end()), (std::set<Id>{ 1, 2, 3, 4, 5 }));
}

TEST(CapSplitting, NothingComesApart)
{
  // A cap on the boundary is removed if both of its short edges have another triangle ...
  TestMesh mesh;
  const Id a = mesh.AddPoint(0.0, 0.0, 0.0);
  const Id b = mesh.AddPoint(2.0, 0.0, 0.0);
  const Id c = mesh.AddPoint(1.0, 0.0, 0.0);
  const Id d = mesh.AddPoint(1.0, 1.0, 0.0);
  mesh.AddTriangle(a, b, c);
  mesh.AddTriangle(a, c, d);
  EXPECT_EQ(SplitMesh(mesh).Caps, 0);
  mesh.AddTriangle(c, b, d);
  EXPECT_EQ(SplitMesh(mesh).Caps, 1);
  // ... and kept if the cap alone connects the edges ...
  TestMesh line;
  line.Points = mesh.Points;
  line.AddTriangle(a, b, c);
  EXPECT_EQ(SplitMesh(line).Caps, 0);
  EXPECT_NEAR(DistancesFrom(Build(line), dgg::ExactEngine::Triangle, a)[b], 2.0, 1e-12);
  // ... regardless of the number of copies.
  line.AddTriangle(c, b, a);
  line.AddTriangle(c, b, d);
  line.AddTriangle(b, c, d);
  EXPECT_EQ(SplitMesh(line).Caps, 0);
  // Copies of a cap are removed with the cap.
  mesh.AddTriangle(b, a, c);
  mesh.AddTriangle(a, b, c);
  const Split split = SplitMesh(mesh);
  EXPECT_EQ(split.Mesh.GetNumberOfFaces(), 2);
  EXPECT_EQ(split.Parents, (std::vector<Id>{ 1, 2 }));
}

// Many collinear points in random triangles: the number of triangles is bounded, and distances
// along the line do not change.
TEST(CapSplitting, HeapsOfCapsEnd)
{
  Random random(7);
  TestMesh mesh;
  for (Id i = 0; i < 60; ++i)
  {
    mesh.AddPoint(i * 0.25, 0.0, 0.0);
  }
  for (Id i = 0; i + 2 < 60; ++i)
  {
    mesh.AddTriangle(i, i + 1, i + 2);
  }
  for (int i = 0; i < 3000; ++i)
  {
    mesh.AddTriangle(random.Index(60), random.Index(60), random.Index(60));
  }
  const Split split = SplitMesh(mesh);
  EXPECT_LE(split.Mesh.GetNumberOfFaces(), 4 * mesh.GetNumberOfFaces());
  const auto distances = DistancesFrom(Build(split.Mesh), dgg::ExactEngine::Triangle, 0);
  for (Id i = 0; i < 60; ++i)
  {
    EXPECT_NEAR(distances[i], i * 0.25, 1e-9);
  }
}
/// A cap on an edge that was created by removing another cap: the heights add up.
TEST(CapSplitting, HeightsAddUp)
{
  TestMesh mesh;
  const Id a = mesh.AddPoint(0.0, 0.0, 0.0);
  const Id b = mesh.AddPoint(1.0, 0.0, 0.0);
  const Id c = mesh.AddPoint(0.5, 1.0, 0.0);
  const Id d = mesh.AddPoint(0.5, -1.0, 0.0);
  const Id p = mesh.AddPoint(0.5, 0.0, 1e-7);
  const Id q = mesh.AddPoint(0.3, 0.0, 1.4e-7);
  mesh.AddTriangle(a, b, c);
  mesh.AddTriangle(b, a, p);
  mesh.AddTriangle(p, a, q);
  mesh.AddTriangle(d, p, q);
  mesh.AddTriangle(d, q, a);
  mesh.AddTriangle(d, b, p);
  const Split split = SplitMesh(mesh);
  EXPECT_EQ(split.Caps, 2);
  EXPECT_GE(split.Height, 1.4e-7); // height of q above the first triangle, whose corner q is
  EXPECT_LE(split.Height, 2e-7);
}

// Borders of Voronoi cells within large faces: bounded cost of finding the borders.

namespace
{
/// Returns upright walls along the lines of a grid of columns x rows cells, with `height` rows of
/// quads.
TestMesh Honeycomb(Id columns, Id rows, Id height)
{
  TestMesh mesh;
  const auto at = [&](Id i, Id j, Id k) { return (k * (rows + 1) + j) * (columns + 1) + i; };
  for (Id k = 0; k <= height; ++k)
  {
    for (Id j = 0; j <= rows; ++j)
    {
      for (Id i = 0; i <= columns; ++i)
      {
        mesh.AddPoint(i, j, 0.3 * k);
      }
    }
  }
  for (Id k = 0; k < height; ++k)
  {
    for (Id j = 0; j <= rows; ++j)
    {
      for (Id i = 0; i <= columns; ++i)
      {
        if (i < columns)
        {
          mesh.AddQuad(at(i, j, k), at(i + 1, j, k), at(i + 1, j, k + 1), at(i, j, k + 1));
        }
        if (j < rows)
        {
          mesh.AddQuad(at(i, j, k), at(i, j + 1, k), at(i, j + 1, k + 1), at(i, j, k + 1));
        }
      }
    }
  }
  return mesh;
}

}

/// Links are expensive where windows multiply. The refinement stops before links cost many times as
/// much as the rest.
TEST(BorderRefinement, IsBounded)
{
  const SearchCase c("honeycomb", Honeycomb(5, 5, 40), 0.05);
  const dgg::GraphBuilder builder(c.GetMesh());
  const std::vector<dgg::SurfacePoint> sites = AtVertices({ 0, 50, 100, 140 });
  dgg::LinkedSites linked;
  ASSERT_TRUE(dgg::LinkSites(sites, &builder, 0.05, linked).IsOk());
  dgg::SiteDistances distances;
  ASSERT_TRUE(distances.Run(c.GetSearch(), c.GetMesh(), linked.Seeds, nullptr).IsOk());
  const dgg::BorderRefinement refinement(c.GetMesh(), distances, builder, 0.05, sites);
  dgg::VoronoiDiagram diagram;
  for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
  {
    diagram.NearestSites.push_back(distances.Nearest(v)->Site);
    diagram.Distances.push_back(distances.Nearest(v)->Distance);
  }
  dgg::EdgeCuts cuts(c.GetMesh());
  ASSERT_TRUE(Ok(cuts.Run(distances, &refinement, nullptr, diagram)));
  EXPECT_GT(refinement.GetWork(), 0u);
  EXPECT_LE(refinement.GetWork(), refinement.GetMostWork() + refinement.GetMostWork() / 8);
}
}
