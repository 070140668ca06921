// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Known results of MeshReport on every generator.
#include "TestMeshes.h"

#include "dggDisjointSets.h"
#include "dggEdges.h"
#include "dggMeshReport.h"

namespace dggtest
{
namespace
{
using dgg::MeshReport;

/// Expected report; fields that a case does not mention are zero, or one component.
struct Expected
{
  std::string Name;
  TestMesh Mesh;
  MeshReport Report;

  Expected& With(dgg::Offset MeshReport::*value, dgg::Offset expected)
  {
    this->Report.*value = expected;
    return *this;
  }
  Expected& Rims(dgg::Offset edges, dgg::Offset loops)
  {
    return this->With(&MeshReport::BoundaryEdges, edges).With(&MeshReport::BoundaryLoops, loops);
  }
  Expected& NotOrientable()
  {
    this->Report.Orientable = false;
    return this->With(&MeshReport::Genus, -1);
  }
};

MeshReport Inspect(const TestMesh& mesh)
{
  return dgg::InspectMesh(Build(mesh), mesh.Points.empty() ? nullptr : mesh.Points.data());
}

std::vector<Expected> Cases()
{
  std::vector<Expected> cases;
  cases.reserve(100);
  std::vector<Id> sheetOf;
  std::vector<bool> flags;
  std::vector<ConePoint> polar;
  Id count = 0;
  const auto add = [&](const std::string& name, const TestMesh& mesh) -> Expected& {
    cases.push_back({ name, mesh, {} });
    cases.back().Report.Components = 1;
    return cases.back();
  };
  // Sound meshes.
  add("plane", Plane(5, 4, 0.2, 1)).Rims(18, 1);
  add("L", Plate(4, 4, [](Id i, Id j) { return i < 2 || j < 2; })).Rims(16, 1);
  add("annulus", Plate(5, 5, [](Id i, Id j) { return i != 2 || j != 2; })).Rims(24, 2);
  add("slit", SlitPlane(3, flags)).Rims(30, 1).With(&MeshReport::CoincidentPoints, 3);
  add("prism", PrismSide(5, 2, 3)).Rims(20, 2);
  add("cone", Cone(7.0, 9, 3, polar)).Rims(9, 1);
  add("cube", Cube(4));
  add("box", Box(2, 3, 5, 1.0, 1.0, 1.0));
  add("tetrahedron", Tetrahedron());
  add("octahedron", Octahedron());
  add("icosahedron", Icosahedron());
  add("dodecahedron", Dodecahedron());
  add("icosphere", Icosphere(2));
  add("subdivided", Subdivided(Tetrahedron(), 3));
  add("torus", Torus(12, 8)).With(&MeshReport::Genus, 1);
  add("flat torus", FlatTorus(4.0, 0.5, 3.0, 4, 3, false)).With(&MeshReport::Genus, 1);
  add("two-face torus", FlatTorus(2.0, 0.0, 1.0, 1, 1, true)).With(&MeshReport::Genus, 1);
  add("two holes", TwoHoledBlock()).With(&MeshReport::Genus, 2);
  add("doubly covered", DoublyCoveredPolygon(5, 2, flags)).With(&MeshReport::CoincidentPoints, 6);
  add("triangle", SingleTriangle()).Rims(3, 1);
  add("two triangles", TwoTriangles(0.5)).Rims(4, 1);
  add("several components", SeveralComponents())
    .Rims(14, 1)
    .With(&MeshReport::Components, 3)
    .With(&MeshReport::Genus, 1);
  // Defects.
  add("pinched plates", PinchedPlates(3)).Rims(36, 3).With(&MeshReport::NonManifoldVertices, 2);
  add("touching spheres", TouchingSpheres(1)).With(&MeshReport::NonManifoldVertices, 1);
  add("three sheets", Book(3, 4, sheetOf))
    .Rims(36, 3)
    .With(&MeshReport::NonManifoldEdges, 4)
    .With(&MeshReport::Genus, -1);
  add("fin", PlaneWithFin(4, count, 0.2, 4))
    .Rims(36, 3)
    .With(&MeshReport::NonManifoldEdges, 4)
    .With(&MeshReport::Genus, -1);
  add("cubes on an edge", VoxelSurface(2, 2, 1, [](Id i, Id j, Id) { return i == j; }))
    .With(&MeshReport::NonManifoldEdges, 1)
    .With(&MeshReport::Genus, -1);
  add("cubes at a corner", VoxelSurface(2, 2, 2, [](Id i, Id j, Id k) { return i == j && j == k; }))
    .With(&MeshReport::NonManifoldVertices, 1);
  add("slivers", SliverPlane(6, 1e-9)).Rims(26, 1);
  add("needles", NeedlePlane(4, 1e-9)).Rims(26, 1);
  add("caps", CapPlane(6, 1e-3)).Rims(24, 1);
  add("seam", SeamPlane(6))
    .Rims(36, 2)
    .With(&MeshReport::Components, 2)
    .With(&MeshReport::CoincidentPoints, 7);
  add("zipped", ZippedPlane(6))
    .Rims(26, 1)
    .With(&MeshReport::CoincidentPoints, 7)
    .With(&MeshReport::DegenerateFaces, 12);
  add("collinear", CollinearPlane(6)).Rims(24, 1).With(&MeshReport::DegenerateFaces, 15);
  add("repeated vertices", RepeatedVertexPlane(5))
    .Rims(20, 1)
    .With(&MeshReport::RepeatedVertexFaces, 3);
  add("isolated points", SphereWithIsolatedPoints(1)).With(&MeshReport::IsolatedVertices, 3);
  add("duplicate faces", DuplicateFaceCube(2)).With(&MeshReport::DuplicateFaces, 16);
  add("Moebius", MoebiusStrip(9, 4)).Rims(18, 1).NotOrientable();
  add("Klein bottle", KleinBottle(7, 5)).NotOrientable();
  add("nothing", TestMesh()).With(&MeshReport::Components, 0);
  return cases;
}
}

TEST(MeshReport, KnowsTheGenerators)
{
  for (const Expected& c : Cases())
  {
    SCOPED_TRACE(c.Name);
    const MeshReport& expected = c.Report;
    const MeshReport report = Inspect(c.Mesh);
    EXPECT_EQ(report.Vertices, c.Mesh.GetNumberOfVertices());
    EXPECT_EQ(report.Faces, c.Mesh.GetNumberOfFaces());
    EXPECT_EQ(report.IsolatedVertices, expected.IsolatedVertices);
    EXPECT_EQ(report.Components, expected.Components);
    EXPECT_EQ(report.BoundaryEdges, expected.BoundaryEdges);
    EXPECT_EQ(report.BoundaryLoops, expected.BoundaryLoops);
    EXPECT_EQ(report.NonManifoldEdges, expected.NonManifoldEdges);
    EXPECT_EQ(report.NonManifoldVertices, expected.NonManifoldVertices);
    EXPECT_EQ(report.RepeatedVertexFaces, expected.RepeatedVertexFaces);
    EXPECT_EQ(report.DegenerateFaces, expected.DegenerateFaces);
    EXPECT_EQ(report.DuplicateFaces, expected.DuplicateFaces);
    EXPECT_EQ(report.CoincidentPoints, expected.CoincidentPoints);
    EXPECT_EQ(report.Orientable, expected.Orientable);
    EXPECT_EQ(report.Genus, expected.Genus);
    EXPECT_EQ(report.InconsistentEdges > 0, !expected.Orientable);
    EXPECT_EQ(report.Mollification > 0.0, expected.DegenerateFaces > 0);
  }
}

TEST(MeshReport, CountsTurnedFaces)
{
  const MeshReport report = Inspect(MisorientedSphere(2, 8));
  EXPECT_GT(report.ReorientedFaces, 80);
  EXPECT_LE(report.ReorientedFaces, 160);
  EXPECT_TRUE(report.Orientable);
  EXPECT_EQ(report.InconsistentEdges, 0);
  EXPECT_EQ(report.Genus, 0);
  EXPECT_EQ(Inspect(Icosphere(2)).ReorientedFaces, 0);
}

TEST(MeshReport, CountsCoincidentPoints)
{
  TestMesh mesh = SingleTriangle();
  mesh.AddPoint(0.0, -0.0, 0.0);  // signed zeros are the same position
  mesh.AddPoint(0.0, 1e-30, 0.0); // close positions are distinct
  mesh.AddPoint(4.0, 0.0, 0.0);
  mesh.AddPoint(4.0, 0.0, 0.0);
  mesh.AddPoint(NAN, 0.0, 0.0);
  mesh.AddPoint(NAN, 0.0, 0.0);
  EXPECT_EQ(Inspect(mesh).CoincidentPoints, 3);
  EXPECT_EQ(dgg::InspectMesh(Build(mesh)).CoincidentPoints, 0); // mesh without points
}

TEST(MeshReport, MeasuresAnisotropy)
{
  const MeshReport equilateral = Inspect(Octahedron());
  EXPECT_NEAR(equilateral.MeanAnisotropy, 1.0, 1e-14);
  EXPECT_NEAR(equilateral.MedianAnisotropy, 1.0, 1e-14);
  // Right isosceles: sqrt(2) (2 + sqrt(2)) / (2 sqrt(3)).
  const double right = std::sqrt(2.0) * (2.0 + std::sqrt(2.0)) / (2.0 * std::sqrt(3.0));
  EXPECT_NEAR(Inspect(Plane(3, 3)).MeanAnisotropy, right, 1e-14);
  // A few slivers change neither value; long triangles are weighted by their area.
  const MeshReport slivers = Inspect(SliverPlane(6, 1e-6));
  EXPECT_NEAR(slivers.MedianAnisotropy, right, 1e-12);
  EXPECT_NEAR(slivers.MeanAnisotropy, right, 0.1);
  TestMesh plates = Plane(3, 3);
  const Id first = plates.AddPoint(0.0, 5.0, 0.0);
  plates.AddTriangle(first, plates.AddPoint(30.0, 5.0, 0.0), plates.AddPoint(0.0, 6.0, 0.0));
  EXPECT_NEAR(Inspect(plates).MedianAnisotropy, right, 1e-12);
  const double length = std::hypot(30.0, 1.0);
  const double product = length * (31.0 + length) / (4.0 * std::sqrt(3.0));
  EXPECT_NEAR(Inspect(plates).MeanAnisotropy, (9.0 * right + product) / (9.0 + 15.0), 1e-12);
  EXPECT_NEAR(Inspect(plates).Area, 9.0 + 15.0, 1e-12);
  EXPECT_EQ(Inspect(TestMesh()).MeanAnisotropy, 0.0);
}

// Disjoint sets of ids, and representative half-edges of edges.

TEST(DisjointSets, AreThoseOfLabels)
{
  const Id count = 300;
  dgg::DisjointSets sets(count);
  std::vector<Id> labels(count); // reference: relabel one of the two sets
  for (Id i = 0; i < count; ++i)
  {
    labels[i] = i;
    EXPECT_EQ(sets.Find(i), i);
  }
  std::mt19937 random(7);
  int joined = 0;
  for (int k = 0; k < 600; ++k)
  {
    const Id i = static_cast<Id>(random() % count);
    const Id j = static_cast<Id>(random() % count);
    const Id from = std::max(labels[i], labels[j]);
    const Id to = std::min(labels[i], labels[j]);
    EXPECT_EQ(sets.Join(i, j), from != to);
    joined += from != to ? 1 : 0;
    std::replace(labels.begin(), labels.end(), from, to);
  }
  EXPECT_GT(joined, 200);
  EXPECT_LT(joined, 299);
  for (Id i = 0; i < count; ++i)
  {
    EXPECT_EQ(sets.Find(i), labels[i]) << i;
  }
}

TEST(Edges, AllHalfEdgesOfAnEdgeHaveTheSame)
{
  std::vector<NamedMesh> meshes = DefectMeshes();
  meshes.push_back({ "cube", Cube(2) });
  meshes.push_back({ "plane", Plane(4, 3) });
  for (const NamedMesh& named : meshes)
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Id edge = dgg::FindEdge(mesh, h);
      EXPECT_LE(edge, h);
      EXPECT_EQ(dgg::FindEdge(mesh, edge), edge);
      EXPECT_EQ(std::minmax(mesh.Origin(edge), mesh.Destination(edge)),
        std::minmax(mesh.Origin(h), mesh.Destination(h)));
      if (mesh.Twin(h) == dgg::NoId)
      {
        EXPECT_EQ(edge, h);
      }
      else
      {
        EXPECT_EQ(dgg::FindEdge(mesh, mesh.Twin(h)), edge);
      }
    }
  }
}
}
