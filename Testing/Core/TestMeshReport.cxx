// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Known answers of MeshReport, on every generator.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"

#include "dggMeshReport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace dggtest
{
namespace
{
using dgg::MeshReport;

/// What the report should say; what a case does not mention is zero, or one component.
struct Expected
{
  std::string Name;
  TestMesh Mesh;
  std::function<void(MeshReport&)> Change;
};

MeshReport Inspect(const TestMesh& mesh)
{
  return dgg::InspectMesh(Build(mesh), mesh.Points.empty() ? nullptr : mesh.Points.data());
}

std::vector<Expected> Cases()
{
  std::vector<Expected> cases;
  std::vector<Id> sheetOf;
  std::vector<bool> flags;
  std::vector<ConePoint> polar;
  Id count = 0;
  auto add = [&](const std::string& name, const TestMesh& mesh,
               const std::function<void(MeshReport&)>& change) {
    cases.push_back({ name, mesh, change });
  };
  auto closed = [](MeshReport&) {};
  auto disc = [](dgg::Offset edges) {
    return [edges](MeshReport& r) {
      r.BoundaryEdges = edges;
      r.BoundaryLoops = 1;
    };
  };
  // Sound meshes.
  add("plane", Plane(5, 4, 0.2, 1), disc(18));
  add("L", Plate(4, 4, [](Id i, Id j) { return i < 2 || j < 2; }), disc(16));
  add("annulus", Plate(5, 5, [](Id i, Id j) { return i != 2 || j != 2; }), [](MeshReport& r) {
    r.BoundaryEdges = 24;
    r.BoundaryLoops = 2;
  });
  add("slit", SlitPlane(3, flags), [](MeshReport& r) {
    r.BoundaryEdges = 30;
    r.BoundaryLoops = 1;
    r.CoincidentPoints = 3;
  });
  add("prism", PrismSide(5, 2, 3), [](MeshReport& r) {
    r.BoundaryEdges = 20;
    r.BoundaryLoops = 2;
  });
  add("cone", Cone(7.0, 9, 3, polar), disc(9));
  add("cube", Cube(4), closed);
  add("box", Box(2, 3, 5, 1.0, 1.0, 1.0), closed);
  add("tetrahedron", Tetrahedron(), closed);
  add("octahedron", Octahedron(), closed);
  add("icosahedron", Icosahedron(), closed);
  add("dodecahedron", Dodecahedron(), closed);
  add("icosphere", Icosphere(2), closed);
  add("subdivided", Subdivided(Tetrahedron(), 3), closed);
  add("torus", Torus(12, 8), [](MeshReport& r) { r.Genus = 1; });
  add("flat torus", FlatTorus(4.0, 0.5, 3.0, 4, 3, false), [](MeshReport& r) { r.Genus = 1; });
  add("two-face torus", FlatTorus(2.0, 0.0, 1.0, 1, 1, true), [](MeshReport& r) { r.Genus = 1; });
  add("two holes", TwoHoledBlock(), [](MeshReport& r) { r.Genus = 2; });
  add("doubly covered", DoublyCoveredPolygon(5, 2, flags),
    [](MeshReport& r) { r.CoincidentPoints = 6; });
  add("triangle", SingleTriangle(), disc(3));
  add("two triangles", TwoTriangles(0.5), disc(4));
  add("several components", SeveralComponents(), [](MeshReport& r) {
    r.Components = 3;
    r.BoundaryEdges = 14;
    r.BoundaryLoops = 1;
    r.Genus = 1;
  });
  // Defects.
  add("pinched plates", PinchedPlates(3), [](MeshReport& r) {
    r.BoundaryEdges = 36;
    r.BoundaryLoops = 3;
    r.NonManifoldVertices = 2;
  });
  add("touching spheres", TouchingSpheres(1), [](MeshReport& r) { r.NonManifoldVertices = 1; });
  add("three sheets", Book(3, 4, sheetOf), [](MeshReport& r) {
    r.NonManifoldEdges = 4;
    r.BoundaryEdges = 36;
    r.BoundaryLoops = 3;
    r.Genus = -1;
  });
  add("fin", PlaneWithFin(4, count, 0.2, 4), [](MeshReport& r) {
    r.NonManifoldEdges = 4;
    r.BoundaryEdges = 36;
    r.BoundaryLoops = 3;
    r.Genus = -1;
  });
  add("cubes on an edge", VoxelSurface(2, 2, 1, [](Id i, Id j, Id) { return i == j; }),
    [](MeshReport& r) {
      r.NonManifoldEdges = 1;
      r.Genus = -1;
    });
  add("cubes at a corner", VoxelSurface(2, 2, 2, [](Id i, Id j, Id k) { return i == j && j == k; }),
    [](MeshReport& r) { r.NonManifoldVertices = 1; });
  add("slivers", SliverPlane(6, 1e-9), disc(26));
  add("needles", NeedlePlane(4, 1e-9), disc(26));
  add("caps", CapPlane(6, 1e-3), disc(24));
  add("seam", SeamPlane(6), [](MeshReport& r) {
    r.Components = 2;
    r.BoundaryEdges = 36;
    r.BoundaryLoops = 2;
    r.CoincidentPoints = 7;
  });
  add("zipped", ZippedPlane(6), [](MeshReport& r) {
    r.BoundaryEdges = 26;
    r.BoundaryLoops = 1;
    r.CoincidentPoints = 7;
    r.DegenerateFaces = 12;
  });
  add("collinear", CollinearPlane(6), [](MeshReport& r) {
    r.BoundaryEdges = 24;
    r.BoundaryLoops = 1;
    r.DegenerateFaces = 15;
  });
  add("repeated vertices", RepeatedVertexPlane(5), [](MeshReport& r) {
    r.BoundaryEdges = 20;
    r.BoundaryLoops = 1;
    r.RepeatedVertexFaces = 3;
  });
  add(
    "isolated points", SphereWithIsolatedPoints(1), [](MeshReport& r) { r.IsolatedVertices = 3; });
  add("Moebius", MoebiusStrip(9, 4), [](MeshReport& r) {
    r.BoundaryEdges = 18;
    r.BoundaryLoops = 1;
    r.Orientable = false;
    r.Genus = -1;
  });
  add("Klein bottle", KleinBottle(7, 5), [](MeshReport& r) {
    r.Orientable = false;
    r.Genus = -1;
  });
  add("nothing", TestMesh(), [](MeshReport& r) { r.Components = 0; });
  return cases;
}
}

TEST(MeshReport, KnowsTheGenerators)
{
  for (const Expected& c : Cases())
  {
    SCOPED_TRACE(c.Name);
    MeshReport expected;
    expected.Components = 1;
    c.Change(expected);
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

TEST(MeshReport, CountsDuplicateFaces)
{
  const TestMesh cube = Cube(2);
  const TestMesh mesh = DuplicateFaceCube(2);
  const MeshReport report = Inspect(mesh);
  EXPECT_EQ(report.DuplicateFaces, mesh.GetNumberOfFaces() - cube.GetNumberOfFaces());
  EXPECT_EQ(report.NonManifoldEdges, 0); // they take no part
  EXPECT_EQ(report.Genus, 0);
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
  mesh.AddPoint(0.0, -0.0, 0.0);  // signed zeros are the same place
  mesh.AddPoint(0.0, 1e-30, 0.0); // near is not the same
  mesh.AddPoint(4.0, 0.0, 0.0);
  mesh.AddPoint(4.0, 0.0, 0.0);
  mesh.AddPoint(NAN, 0.0, 0.0);
  mesh.AddPoint(NAN, 0.0, 0.0);
  EXPECT_EQ(Inspect(mesh).CoincidentPoints, 3);
  EXPECT_EQ(dgg::InspectMesh(Build(mesh)).CoincidentPoints, 0); // without points
}

TEST(MeshReport, MeasuresAnisotropy)
{
  const MeshReport equilateral = Inspect(Octahedron());
  EXPECT_NEAR(equilateral.MeanAnisotropy, 1.0, 1e-14);
  EXPECT_NEAR(equilateral.MedianAnisotropy, 1.0, 1e-14);
  // Right isosceles: sqrt(2) (2 + sqrt(2)) / (2 sqrt(3)).
  const double right = std::sqrt(2.0) * (2.0 + std::sqrt(2.0)) / (2.0 * std::sqrt(3.0));
  EXPECT_NEAR(Inspect(Plane(3, 3)).MeanAnisotropy, right, 1e-14);
  // The median is not moved by a few slivers, the mean is.
  const MeshReport slivers = Inspect(SliverPlane(6, 1e-6));
  EXPECT_NEAR(slivers.MedianAnisotropy, right, 1e-12);
  EXPECT_GT(slivers.MeanAnisotropy, 1e4);
  EXPECT_EQ(Inspect(TestMesh()).MeanAnisotropy, 0.0);
}
}
