// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of zero area are taken out, and the surface stays what it is.
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include "dggCapSplitting.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace dggtest
{
namespace
{
/// A mesh without its caps, how many there were, and where its triangles come from.
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

/// Each triangle of the input has the area that it had, in the pieces that come from it.
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

/// The unit square in two rectangles that meet in x = 1/2, the left one with an edge there, the
/// right one with `points` more points on it; caps fill the gap, in a fan or in a zigzag.
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

TEST(CapSplitting, LeavesOthersAlone)
{
  for (const TestMesh& mesh : { Cube(3, 0.2, 1), DuplicateFaceCube(2), TwoTriangles(0.5) })
  {
    const Split split = SplitMesh(mesh);
    EXPECT_EQ(split.Caps, 0);
    EXPECT_EQ(split.Mesh.Triangles, mesh.Triangles);
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      EXPECT_EQ(split.Parents[f], f);
    }
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
      // A plane again, in which all distances are those of the plane, to the last digits.
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
  // Three sheets on an edge, a cap on it, and a sheet on each of its short edges.
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
  // A cap on the boundary goes where both of its short edges have another triangle ...
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
  // ... and not where it alone holds them together.
  TestMesh line;
  line.Points = mesh.Points;
  line.AddTriangle(a, b, c);
  EXPECT_EQ(SplitMesh(line).Caps, 0);
  EXPECT_NEAR(DistancesFrom(Build(line), dgg::ExactEngine::Triangle, a)[b], 2.0, 1e-12);
  // ... however often it is there.
  line.AddTriangle(c, b, a);
  line.AddTriangle(c, b, d);
  line.AddTriangle(b, c, d);
  EXPECT_EQ(SplitMesh(line).Caps, 0);
  // Copies of a cap go with it.
  mesh.AddTriangle(b, a, c);
  mesh.AddTriangle(a, b, c);
  const Split split = SplitMesh(mesh);
  EXPECT_EQ(split.Mesh.GetNumberOfFaces(), 2);
  EXPECT_EQ(split.Parents, (std::vector<Id>{ 1, 2 }));
}

// Many points on one line, joined at random: the number of triangles stays bounded, and distances
// along the line stay what they are.
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
/// A cap on the edge that another one has left: the surface has moved by both.
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
  EXPECT_GE(split.Height, 1.4e-7); // of q above the first triangle, which has it as a corner now
  EXPECT_LE(split.Height, 2e-7);
}
}
