// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Connectivity, lengths, angles and vertex kinds of SurfaceMesh.
#include "TestMeshes.h"

#include "dggSurfaceMesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace dggtest
{
namespace
{
using dgg::NoId;
using dgg::SurfaceMesh;
using dgg::VertexKind;

std::pair<Id, Id> EndsOf(const SurfaceMesh& mesh, Id h)
{
  return std::minmax(mesh.Origin(h), mesh.Destination(h));
}

/// Everything that holds on any mesh.
void ExpectConsistent(const TestMesh& input, const SurfaceMesh& mesh)
{
  ASSERT_EQ(mesh.GetNumberOfVertices(), input.GetNumberOfVertices());
  ASSERT_EQ(mesh.GetNumberOfFaces(), input.GetNumberOfFaces());
  std::map<std::pair<Id, Id>, std::set<Id>> edges;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id f = SurfaceMesh::Face(h);
    // Faces keep their ids, and their corners up to orientation.
    std::multiset<Id> before(input.Triangles.begin() + 3 * f, input.Triangles.begin() + 3 * f + 3);
    const auto triangle = mesh.GetTriangle(f);
    ASSERT_EQ(before, std::multiset<Id>(triangle.begin(), triangle.end()));
    ASSERT_EQ(triangle[0], input.Triangles[3 * f]);
    ASSERT_EQ(triangle[mesh.IsFlipped(f) ? 2 : 1], input.Triangles[3 * f + 1]);
    ASSERT_EQ(SurfaceMesh::Next(SurfaceMesh::Previous(h)), h);
    ASSERT_EQ(mesh.Destination(h), mesh.Origin(SurfaceMesh::Next(h)));
    ASSERT_EQ(mesh.Apex(h), mesh.Origin(SurfaceMesh::Previous(h)));
    if (mesh.IsDropped(f))
    {
      ASSERT_EQ(mesh.Twin(h), NoId);
      continue;
    }
    edges[EndsOf(mesh, h)].insert(h);
    // The layout of the face has the lengths of its edges.
    const double tolerance = 1e-12 * mesh.GetMaximumEdgeLength();
    ASSERT_GT(mesh.Length(h), 0.0);
    ASSERT_GT(mesh.ApexY(h), 0.0);
    ASSERT_NEAR(
      std::hypot(mesh.ApexX(h), mesh.ApexY(h)), mesh.Length(SurfaceMesh::Previous(h)), tolerance);
    ASSERT_NEAR(std::hypot(mesh.Length(h) - mesh.ApexX(h), mesh.ApexY(h)),
      mesh.Length(SurfaceMesh::Next(h)), tolerance);
    if (!input.Points.empty())
    {
      ASSERT_NEAR(mesh.Length(h), EuclideanDistance(input, mesh.Origin(h), mesh.Destination(h)),
        mesh.GetMollification() + 1e-15 * mesh.GetMaximumEdgeLength());
    }
  }
  // Twins link exactly the half-edges of an edge, in one circle, with one length.
  for (const auto& edge : edges)
  {
    const Id first = *edge.second.begin();
    if (edge.second.size() == 1)
    {
      ASSERT_EQ(mesh.Twin(first), NoId);
      continue;
    }
    std::set<Id> circle;
    Id h = first;
    do
    {
      ASSERT_NE(h, NoId);
      ASSERT_TRUE(circle.insert(h).second);
      ASSERT_EQ(mesh.Length(h), mesh.Length(first));
      h = mesh.Twin(h);
    } while (h != first);
    ASSERT_EQ(circle, edge.second);
  }
  // The fans hold every usable corner once; angles add up.
  std::set<Id> corners;
  double sum = 0.0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double angle = 0.0;
    for (const Id* h = mesh.FanBegin(v); h != mesh.FanEnd(v); ++h)
    {
      ASSERT_EQ(mesh.Origin(*h), v);
      ASSERT_TRUE(corners.insert(*h).second);
      ASSERT_NEAR(mesh.PolarAngle(*h), angle, 1e-12);
      angle += mesh.CornerAngle(*h);
    }
    ASSERT_NEAR(mesh.TotalAngle(v), angle, 1e-12);
    ASSERT_EQ(mesh.Kind(v) == VertexKind::Isolated, mesh.FanBegin(v) == mesh.FanEnd(v));
    ASSERT_EQ(mesh.Kind(v) == VertexKind::Irregular, mesh.IsIrregular(v));
    sum += angle;
  }
  Id usable = 0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    usable += mesh.IsDropped(f) ? 0 : 1;
  }
  EXPECT_EQ(static_cast<Id>(corners.size()), 3 * usable);
  if (mesh.GetMollification() == 0.0) // else the angles of degenerate faces are noise
  {
    EXPECT_NEAR(sum, usable * dgg::Pi, 1e-9 * (usable + 1));
  }
  EXPECT_GE(mesh.GetMemorySize(), 3 * mesh.GetNumberOfFaces() * 4 * sizeof(double));
}

Id CountKind(const SurfaceMesh& mesh, VertexKind kind)
{
  Id count = 0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    count += mesh.Kind(v) == kind ? 1 : 0;
  }
  return count;
}
}

TEST(SurfaceMesh, IsConsistent)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    ExpectConsistent(named.Mesh, mesh);
    EXPECT_EQ(CountKind(mesh, VertexKind::Irregular), 0);
    EXPECT_EQ(mesh.GetMollification(), 0.0);
  }
  for (const NamedMesh& named : DefectMeshesAndSoups(100))
  {
    SCOPED_TRACE(named.Name);
    ExpectConsistent(named.Mesh, Build(named.Mesh));
  }
}

TEST(SurfaceMesh, ClassifiesVertices)
{
  const SurfaceMesh cube = Build(Cube(3));
  EXPECT_EQ(CountKind(cube, VertexKind::Convex), 8);
  EXPECT_EQ(CountKind(cube, VertexKind::Flat), 48); // edges of the cube are flat too
  const SurfaceMesh block = Build(TwoHoledBlock());
  EXPECT_EQ(CountKind(block, VertexKind::Convex), 8);
  EXPECT_EQ(CountKind(block, VertexKind::Saddle), 16); // corners of the holes: 5 pi / 2
  const SurfaceMesh plane = Build(Plane(3, 3, 0.2, 1));
  EXPECT_EQ(CountKind(plane, VertexKind::Flat), 4);
  EXPECT_EQ(CountKind(plane, VertexKind::Boundary), 12);
  EXPECT_NEAR(plane.TotalAngle(0), 0.5 * dgg::Pi, 1e-14);
  EXPECT_NEAR(cube.TotalAngle(0), 1.5 * dgg::Pi, 1e-14);

  std::vector<ConePoint> unused;
  EXPECT_EQ(Build(Cone(2.0 * dgg::Pi * (1.0 - 1e-10), 6, 2, unused)).Kind(0), VertexKind::Flat);
  EXPECT_EQ(Build(Cone(2.0 * dgg::Pi * (1.0 - 1e-8), 6, 2, unused)).Kind(0), VertexKind::Convex);
  EXPECT_EQ(Build(Cone(2.0 * dgg::Pi * (1.0 + 1e-8), 6, 2, unused)).Kind(0), VertexKind::Saddle);
}

TEST(SurfaceMesh, KnowsWhereGeodesicsMayBend)
{
  const SurfaceMesh cube = Build(Cube(2));
  for (Id v = 0; v < cube.GetNumberOfVertices(); ++v)
  {
    EXPECT_EQ(cube.IsPassThrough(v), cube.Kind(v) == VertexKind::Flat);
  }
  // An L: three convex corners, one reflex one, straight rims.
  const TestMesh l = Plate(2, 2, [](Id i, Id j) { return !(i == 1 && j == 1); });
  const SurfaceMesh plate = Build(l);
  EXPECT_TRUE(plate.IsPassThrough(VertexAt(l, 1.0, 1.0, 0.0)));
  EXPECT_TRUE(plate.IsPassThrough(VertexAt(l, 1.0, 0.0, 0.0))); // straight
  EXPECT_FALSE(plate.IsPassThrough(VertexAt(l, 0.0, 0.0, 0.0)));
  EXPECT_FALSE(plate.IsPassThrough(VertexAt(l, 2.0, 1.0, 0.0)));
  const SurfaceMesh spheres = Build(TouchingSpheres(1));
  EXPECT_EQ(spheres.Kind(0), VertexKind::Irregular);
  EXPECT_TRUE(spheres.IsPassThrough(0));
}

TEST(SurfaceMesh, KeepsIrregularVerticesApart)
{
  std::vector<Id> sheetOf;
  const TestMesh book = Book(3, 4, sheetOf);
  const SurfaceMesh mesh = Build(book);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_EQ(mesh.Kind(v) == VertexKind::Irregular, sheetOf[v] == NoId) << v;
  }
  // Each edge of the spine has three half-edges in its circle.
  Id spineHalfEdges = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id twin = mesh.Twin(h);
    spineHalfEdges += twin != NoId && mesh.Twin(twin) != h ? 1 : 0;
  }
  EXPECT_EQ(spineHalfEdges, 12);
}

TEST(SurfaceMesh, TurnsFacesOver)
{
  const TestMesh input = MisorientedSphere(2, 8);
  const SurfaceMesh mesh = Build(input);
  Id flipped = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    EXPECT_EQ(mesh.Origin(mesh.Twin(h)), mesh.Destination(h));
    flipped += h % 3 == 0 && mesh.IsFlipped(h / 3) ? 1 : 0;
  }
  EXPECT_GT(flipped, mesh.GetNumberOfFaces() / 4);
  EXPECT_LE(flipped, mesh.GetNumberOfFaces() / 2); // the smaller half is turned
  // Consistent meshes stay as they are, the inside-out ones too.
  TestMesh inside = Icosphere(1);
  for (Id f = 0; f < inside.GetNumberOfFaces(); ++f)
  {
    std::swap(inside.Triangles[3 * f], inside.Triangles[3 * f + 1]);
  }
  const SurfaceMesh kept = Build(inside);
  for (Id f = 0; f < kept.GetNumberOfFaces(); ++f)
  {
    EXPECT_FALSE(kept.IsFlipped(f));
  }
}

TEST(SurfaceMesh, FindsWhatCannotBeOriented)
{
  for (const TestMesh& input : { MoebiusStrip(9, 4), KleinBottle(7, 5) })
  {
    const SurfaceMesh mesh = Build(input);
    Id inconsistent = 0;
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Id twin = mesh.Twin(h);
      if (twin != NoId && mesh.Origin(twin) == mesh.Origin(h))
      {
        ++inconsistent;
        EXPECT_EQ(mesh.Kind(mesh.Origin(h)), VertexKind::Irregular);
      }
    }
    EXPECT_GT(inconsistent, 0);
  }
}

TEST(SurfaceMesh, ComputesComponents)
{
  const TestMesh input = SphereWithIsolatedPoints(1);
  Id count = 0;
  std::vector<Id> component = Build(input).ComputeComponents(count);
  EXPECT_EQ(count, 4);
  EXPECT_EQ(component[0], 0);
  EXPECT_EQ(component[1], 1);
  EXPECT_TRUE(std::all_of(component.begin() + 2, component.end() - 1, [](Id c) { return c == 2; }));
  EXPECT_EQ(component.back(), 3);

  // A point contact connects.
  component = Build(TouchingSpheres(1)).ComputeComponents(count);
  EXPECT_EQ(count, 1);
  Build(SeveralComponents()).ComputeComponents(count);
  EXPECT_EQ(count, 3);
  Build(SeamPlane(6)).ComputeComponents(count);
  EXPECT_EQ(count, 2);
}

}
