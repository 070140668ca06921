// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Consistent layouts on two surfaces: corresponding curves, and patches that are disks.
#include "GeodesicChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggPatchBoundaries.h"
#include "dggSurfaceCut.h"
#include "dggSurfaceRefinement.h"

namespace dggtest
{
namespace
{
using dgg::PatchBoundaries;
using dgg::PatchLayout;
using dgg::SurfacePoint;
using Points = std::vector<SurfacePoint>;

/// Returns the vertex nearest to a position.
Id Nearest(const TestMesh& mesh, double x, double y, double z)
{
  Id best = 0;
  double shortest = dgg::Infinity;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double* p = mesh.Point(v);
    const double d = std::hypot(p[0] - x, std::hypot(p[1] - y, p[2] - z));
    if (d < shortest)
    {
      shortest = d;
      best = v;
    }
  }
  return best;
}

/// Returns a sphere with bumps and dents.
TestMesh BumpySphere(int level)
{
  TestMesh mesh = Icosphere(level);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double* p = mesh.Points.data() + 3 * v;
    const double r =
      1.0 + 0.3 * std::sin(4.0 * p[0] + 1.0) * std::cos(3.0 * p[1]) + 0.2 * std::sin(5.0 * p[2]);
    for (int c = 0; c < 3; ++c)
    {
      p[c] *= r;
    }
  }
  return mesh;
}

/// Returns the mesh with all faces reversed.
TestMesh TurnedOver(TestMesh mesh)
{
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    std::swap(mesh.Triangles[3 * f], mesh.Triangles[3 * f + 1]);
  }
  return mesh;
}

PatchLayout Octahedral()
{
  // Landmarks in the order +x -x +y -y +z -z.
  return { {},
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } } };
}

PatchLayout Tetrahedral()
{
  return { {}, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } } };
}

std::vector<Id> AxisVertices(const TestMesh& mesh)
{
  return { Nearest(mesh, 2, 0, 0), Nearest(mesh, -2, 0, 0), Nearest(mesh, 0, 2, 0),
    Nearest(mesh, 0, -2, 0), Nearest(mesh, 0, 0, 2), Nearest(mesh, 0, 0, -2) };
}

/// Checks the curves of one surface: correct ends, disjoint interiors, and one landmark for each
/// corner of the remaining submeshes. Returns the sorted numbers of boundary edges of the submeshes
/// that are disks.
std::vector<std::size_t> ExpectCurves(const dgg::SurfaceMesh& mesh, const Points& landmarks,
  const PatchBoundaries& boundaries, int side)
{
  const std::vector<dgg::SurfacePath>& curves = boundaries.Curves[side];
  EXPECT_EQ(curves.size(), boundaries.Edges.size());
  std::vector<dgg::SurfacePath> paths(landmarks.size());
  for (std::size_t l = 0; l < landmarks.size(); ++l)
  {
    paths[l].Points.push_back(landmarks[l]);
  }
  paths.insert(paths.end(), curves.begin(), curves.end());
  for (const dgg::SurfacePath& curve : curves)
  {
    EXPECT_TRUE(Ok(dgg::CheckPath(mesh, curve)));
  }
  dgg::SubMesh refined;
  dgg::Status status = dgg::RefineAlongPaths(mesh, paths, {}, refined); // fails at crossings
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  if (!status.IsOk())
  {
    return {};
  }
  std::set<Id> taken;
  std::set<std::pair<Id, Id>> edges;
  for (std::size_t e = 0; e < curves.size(); ++e)
  {
    const std::vector<Id>& chain = refined.Paths[landmarks.size() + e];
    EXPECT_EQ(chain.front(), refined.Paths[boundaries.Edges[e][0]][0]);
    EXPECT_EQ(chain.back(), refined.Paths[boundaries.Edges[e][1]][0]);
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
    {
      EXPECT_TRUE(taken.insert(chain[i]).second) << "curve " << e << " touches another one";
    }
  }
  for (std::size_t l = 0; l < landmarks.size(); ++l)
  {
    EXPECT_EQ(taken.count(refined.Paths[l][0]), 0u) << "a curve runs through landmark " << l;
  }
  // Count the corners of each submesh.
  dgg::SubMesh cut;
  EXPECT_TRUE(dgg::CutAlongChains(refined, refined.Paths, cut).IsOk());
  dgg::SurfaceMesh opened;
  EXPECT_TRUE(cut.Build(mesh, opened).IsOk());
  Id count = 0;
  const auto parts = opened.ComputeComponents(count);
  std::vector<Id> characteristic(count, 0);
  std::vector<std::size_t> corners(count, 0);
  for (Id v = 0; v < opened.GetNumberOfVertices(); ++v)
  {
    characteristic[parts[v]] += opened.FanBegin(v) != opened.FanEnd(v) ? 1 : 0;
    for (std::size_t l = 0; l < landmarks.size(); ++l)
    {
      corners[parts[v]] += cut.VertexOf[v] == refined.Paths[l][0] ? 1 : 0;
    }
  }
  for (Id h = 0; h < opened.GetNumberOfHalfEdges(); ++h)
  {
    characteristic[parts[opened.Origin(h)]] -= opened.Twin(h) < h ? 1 : 0;
    characteristic[parts[opened.Origin(h)]] += h % 3 == 0 ? 1 : 0;
  }
  std::vector<std::size_t> disks;
  for (Id part = 0; part < count; ++part)
  {
    if (characteristic[part] == 1)
    {
      disks.push_back(corners[part]);
    }
  }
  std::sort(disks.begin(), disks.end());
  return disks;
}

PatchBoundaries Trace(const dgg::SurfaceMesh& first, const Points& firstLandmarks,
  const dgg::SurfaceMesh& second, const Points& secondLandmarks, const PatchLayout& layout)
{
  PatchBoundaries boundaries;
  EXPECT_TRUE(Ok(dgg::TracePatchBoundaries(
    { first, firstLandmarks }, { second, secondLandmarks }, layout, nullptr, boundaries)));
  return boundaries;
}

void ExpectDisks(const dgg::SurfaceMesh& first, const Points& firstLandmarks,
  const dgg::SurfaceMesh& second, const Points& secondLandmarks, const PatchLayout& layout,
  const std::vector<std::size_t>& disks)
{
  const PatchBoundaries boundaries = Trace(first, firstLandmarks, second, secondLandmarks, layout);
  EXPECT_EQ(ExpectCurves(first, firstLandmarks, boundaries, 0), disks);
  EXPECT_EQ(ExpectCurves(second, secondLandmarks, boundaries, 1), disks);
}

}

TEST(PatchBoundaries, OctahedronOnSpheres)
{
  const TestMesh first = Icosphere(3);
  const TestMesh second = BumpySphere(3);
  const std::vector<std::size_t> disks(8, 3);
  const Points a = AtVertices(AxisVertices(first));
  const Points b = AtVertices(AxisVertices(second));
  const dgg::SurfaceMesh surface = Build(first);
  const dgg::SurfaceMesh bumpy = Build(second);
  const dgg::SurfaceMesh turned = Build(TurnedOver(second));
  ExpectDisks(surface, a, bumpy, b, Octahedral(), disks);
  // Reverse the orientation of either surface, or of the patches.
  ExpectDisks(Build(TurnedOver(first)), a, bumpy, b, Octahedral(), disks);
  ExpectDisks(surface, a, turned, b, Octahedral(), disks);
  PatchLayout mirrored = Octahedral();
  for (std::vector<Id>& patch : mirrored.Patches)
  {
    std::reverse(patch.begin(), patch.end());
  }
  ExpectDisks(surface, a, bumpy, b, mirrored, disks);
  ExpectDisks(surface, a, turned, b, mirrored, disks);
}

TEST(PatchBoundaries, OfTheSameSurfaceAreTheSame)
{
  const TestMesh mesh = BumpySphere(3);
  const dgg::SurfaceMesh surface = Build(mesh);
  const Points landmarks = AtVertices(AxisVertices(mesh));
  const PatchBoundaries boundaries = Trace(surface, landmarks, surface, landmarks, Octahedral());
  for (std::size_t e = 0; e < boundaries.Edges.size(); ++e)
  {
    const double length = boundaries.Curves[0][e].Length;
    EXPECT_EQ(length, boundaries.Curves[1][e].Length);
    // Curves without obstacles are shortest paths.
    const double shortest = DistancesFrom(surface, dgg::ExactEngine::Reference,
      landmarks[boundaries.Edges[e][0]].Vertex)[landmarks[boundaries.Edges[e][1]].Vertex];
    EXPECT_GE(length, shortest * (1.0 - 1e-12));
    EXPECT_LE(length, 1.2 * shortest);
  }
}

TEST(PatchBoundaries, LinesAlone)
{
  // The order found on the first surface is imposed on the second one.
  const TestMesh first = Icosphere(3);
  const TestMesh second = BumpySphere(3);
  PatchLayout lines;
  for (const std::vector<Id>& patch : Octahedral().Patches)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::array<Id, 2> edge{ { patch[k], patch[(k + 1) % 3] } };
      if (edge[0] < edge[1])
      {
        lines.Edges.push_back(edge);
      }
    }
  }
  ASSERT_EQ(lines.Edges.size(), 12u);
  const std::vector<std::size_t> disks(8, 3);
  const dgg::SurfaceMesh surface = Build(first);
  const Points a = AtVertices(AxisVertices(first));
  const Points b = AtVertices(AxisVertices(second));
  ExpectDisks(surface, a, Build(second), b, lines, disks);
  ExpectDisks(surface, a, Build(TurnedOver(second)), b, lines, disks);
}

TEST(PatchBoundaries, LandmarksAnywhere)
{
  // A tetrahedral layout with landmarks in faces and on edges.
  const dgg::SurfaceMesh a = Build(Icosphere(2));
  const dgg::SurfaceMesh b = Build(BumpySphere(2));
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    // The landmarks lie at equal positions in the same faces of both surfaces, so that a nearly
    // straight layout exists.
    const Points landmarks = RandomSurfacePoints(a, 4, seed);
    SCOPED_TRACE(seed);
    ExpectDisks(a, landmarks, b, landmarks, Tetrahedral(), std::vector<std::size_t>(4, 3));
  }
}

TEST(PatchBoundaries, AllInOneFace)
{
  const dgg::SurfaceMesh a = Build(Icosphere(1));
  const dgg::SurfaceMesh b = Build(BumpySphere(2));
  const Points inOne{ SurfacePoint::InFace(a, 7, { { 0.3, 0.3, 0.4 } }),
    SurfacePoint::InFace(a, 7, { { 0.8, 0.1, 0.1 } }),
    SurfacePoint::InFace(a, 7, { { 0.1, 0.8, 0.1 } }),
    SurfacePoint::InFace(a, 7, { { 0.0, 0.1, 0.9 } }) };
  const Points inTwo = RandomSurfacePoints(b, 4, 5);
  ExpectDisks(a, inOne, b, inTwo, Tetrahedral(), std::vector<std::size_t>(4, 3));
}

TEST(PatchBoundaries, UnrelatedLandmarks)
{
  // Every planar layout can be drawn on a sphere, for any positions of the landmarks.
  const dgg::SurfaceMesh a = Build(NoisySphere(2, 0.3, 3));
  const dgg::SurfaceMesh b = Build(BumpySphere(2));
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    const Points from = RandomSurfacePoints(a, 6, seed);
    const Points to = RandomSurfacePoints(b, 6, seed + 100);
    SCOPED_TRACE(seed);
    ExpectDisks(a, from, b, to, Octahedral(), std::vector<std::size_t>(8, 3));
  }
}

TEST(PatchBoundaries, QuadsOnATorus)
{
  const dgg::SurfaceMesh first = Build(Torus(24, 16));
  const dgg::SurfaceMesh second = Build(WithNoise(Torus(24, 16), 0.03, 5));
  std::vector<Id> vertices;
  PatchLayout layout;
  const Id nu = 4;
  const Id nv = 4;
  for (Id j = 0; j < nv; ++j)
  {
    for (Id i = 0; i < nu; ++i)
    {
      vertices.push_back(j * (16 / nv) * 24 + i * (24 / nu));
      const Id right = (i + 1) % nu;
      const Id up = (j + 1) % nv;
      layout.Patches.push_back({ j * nu + i, j * nu + right, up * nu + right, up * nu + i });
    }
  }
  ExpectDisks(first, AtVertices(vertices), second, AtVertices(vertices), layout,
    std::vector<std::size_t>(16, 4));
}

TEST(PatchBoundaries, PlanesWithRims)
{
  // A square of four patches: corners, midpoints of sides, and center.
  const std::vector<Id> vertices{ 0, 4, 8, 36, 40, 44, 72, 76, 80 };
  const PatchLayout layout{ {},
    { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 3, 4, 7, 6 }, { 4, 5, 8, 7 } } };
  const dgg::SurfaceMesh a = Build(Plane(8, 8));
  const dgg::SurfaceMesh b = Build(Terrain(8, 1.0, 4));
  const Points landmarks = AtVertices(vertices);
  const PatchBoundaries boundaries = Trace(a, landmarks, b, landmarks, layout);
  EXPECT_EQ(ExpectCurves(a, landmarks, boundaries, 0), std::vector<std::size_t>(4, 4));
  // On the terrain the rim is not straight: curves may leave a remainder outside.
  const auto parts = ExpectCurves(b, landmarks, boundaries, 1);
  EXPECT_GE(std::count(parts.begin(), parts.end(), 4u), 4);
  // Collinear landmarks in the interior: a straight line between the outer two would pass over the
  // middle one.
  const PatchLayout row{ { { 0, 1 }, { 1, 2 }, { 0, 2 } }, {} };
  const Points inRow = AtVertices({ 38, 40, 42 });
  ExpectDisks(a, inRow, b, inRow, row, { 3 });
}

TEST(PatchBoundaries, ManyIntoOne)
{
  // A wheel on a plane with a wall: many curves pass around the same corner.
  const TestMesh mesh = Plate(
    16, 10, [](Id i, Id j) { return !(i == 8 && j < 8); }, 0.2, 3);
  const dgg::SurfaceMesh surface = Build(mesh);
  std::vector<Id> vertices{ Nearest(mesh, 13, 2, 0) };
  PatchLayout layout;
  for (Id k = 0; k < 6; ++k)
  {
    vertices.push_back(Nearest(mesh, 1.0 + k, 1.0, 0));
    layout.Edges.push_back({ { 0, k + 1 } });
  }
  const Points landmarks = AtVertices(vertices);
  const PatchBoundaries boundaries = Trace(surface, landmarks, surface, landmarks, layout);
  ExpectCurves(surface, landmarks, boundaries, 0);
  ExpectCurves(surface, landmarks, boundaries, 1);
}

}
