// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The promise of the graph, for all pairs of vertices of every kind of mesh: a theorem, so that a
// single pair beyond the bound is a bug.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace dggtest
{
namespace
{
/// Longest edges along x: faces of anisotropy about `ratio`.
TestMesh Stretched(TestMesh mesh, double ratio)
{
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] *= ratio;
  }
  return mesh;
}

TestMesh FlatCone(double total)
{
  std::vector<ConePoint> unused;
  return Cone(total, 13, 8, unused, 0.25, 3);
}

std::vector<NamedMesh> TheoremMeshes()
{
  std::vector<bool> isBack;
  std::vector<Id> sheetOf;
  Id fin = 0;
  std::vector<NamedMesh> meshes = {
    { "PlaneJittered", Plane(18, 16, 0.28, 1) },
    { "PlaneRegular", Plane(15, 15) },
    { "PlaneStretched20", Stretched(Plane(14, 14, 0.25, 2), 20.0) },
    { "PlateWithHoles",
      Plate(
        20, 16, [](Id i, Id j) { return i % 5 < 2 || j % 6 < 3; }, 0.2, 3) },
    { "PlateLShaped", Plate(14, 14, [](Id i, Id j) { return i < 5 || j < 6; }) },
    { "SlitPlane", SlitPlane(8, isBack, 0.2, 4) },
    { "PrismSide", PrismSide(5, 4, 10, 0.2, 5) },
    { "PrismSideRegular", PrismSide(4, 4, 9) },
    { "ConeSharp", FlatCone(0.7) },
    { "ConeConvex", FlatCone(4.4) },
    { "ConeSaddle", FlatCone(8.5) },
    { "ConeSaddleWide", FlatCone(23.0) },
    { "BoxRegular", Box(4, 5, 6, 1.0, 1.0, 2.0) },
    { "BoxLong", Box(3, 3, 8, 1.0, 1.0, 20.0, 0.2, 6) },
    { "CubeJittered", Cube(7, 0.25, 7) },
    { "Tetrahedron", Subdivided(Tetrahedron(), 6) },
    { "Octahedron", Subdivided(Octahedron(), 5) },
    { "Icosahedron", Subdivided(Icosahedron(), 4) },
    { "Dodecahedron", RandomlyRefined(Dodecahedron(), 150, 8, 1e-3) },
    { "Icosphere", Icosphere(2) },
    { "NoisySphere", NoisySphere(2, 0.5, 9) },
    { "Ellipsoid20", Ellipsoid(2, 20.0) },
    { "TerrainGentle", Terrain(16, 0.5, 10) },
    { "TerrainRough", Terrain(16, 3.0, 11) },
    { "Torus", WithNoise(Torus(18, 10), 0.05, 12) },
    { "TwoHoles", WithNoise(Subdivided(TwoHoledBlock(), 2), 0.15, 13) },
    { "FlatTorus", FlatTorus(3.0, 0.7, 2.0, 11, 8, false) },
    { "FlatTorusThin", FlatTorus(9.0, 1.0, 0.5, 16, 2, true) },
    { "FlatTorusTiny", FlatTorus(1.0, 0.5, std::sqrt(0.75), 2, 2, true) },
    { "DoublyCoveredTriangle", DoublyCoveredPolygon(3, 5, isBack) },
    { "DoublyCoveredHexagon", DoublyCoveredPolygon(6, 5, isBack) },
    { "SeveralComponents", SeveralComponents() },
    { "TwoTriangles", TwoTriangles(0.8) },
    { "SingleTriangle", SingleTriangle() },
    { "BookFine", Book(4, 7, sheetOf, 0.2, 14) },
    { "PlaneWithFinFine", PlaneWithFin(8, fin, 0.2, 15) },
    { "MoebiusFine", MoebiusStrip(20, 8) },
    { "KleinBottleFine", KleinBottle(12, 9) },
    { "SliversFine", SliverPlane(12, 1e-4) },
    { "NeedlesFine", NeedlePlane(10, 1e-4) },
    { "CapsFine", CapPlane(14, 1e-4) },
    { "CollapsedFine", CollapsedSphere(2, 40, 16) },
  };
  for (NamedMesh& named : DefectMeshes())
  {
    named.Name.erase(std::remove(named.Name.begin(), named.Name.end(), '-'), named.Name.end());
    meshes.push_back({ "Defect" + named.Name, named.Mesh });
  }
  return meshes;
}

class GraphTheorem : public testing::TestWithParam<NamedMesh>
{
};
}

TEST_P(GraphTheorem, HoldsForAllPairs)
{
  const dgg::SurfaceMesh mesh = Build(GetParam().Mesh);
  ASSERT_LE(mesh.GetNumberOfVertices(), 600);
  const DistanceTable exact = ExactTable(mesh);
  for (const double accuracy : { 0.5, 0.25, 0.1, 0.01, 1e-3, 1e-4, 1e-6 })
  {
    const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy);
    EXPECT_TRUE(graph.Info.IsGuaranteed());
    ExpectWithin(exact, GraphTable(graph.View()), accuracy, SlackOf(mesh));
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, GraphTheorem, testing::ValuesIn(TheoremMeshes()),
  [](const testing::TestParamInfo<NamedMesh>& info) { return info.param.Name; });

// What may be done to a mesh without touching the promise of its graph.

namespace
{
/// Expect distances in the graph of one mesh to be those of another one, of whose vertex v
/// `places[v]` is the new id.
void ExpectWithinOf(const DistanceTable& exact, const dgg::SurfaceMesh& mesh,
  const std::vector<Id>& places, double accuracy)
{
  const DistanceTable all = GraphTable(BuildGraph(mesh, accuracy).View());
  DistanceTable some(exact.GetSize());
  std::vector<double> row(exact.GetSize());
  for (Id a = 0; a < exact.GetSize(); ++a)
  {
    for (Id b = 0; b < exact.GetSize(); ++b)
    {
      row[b] = all(places[a], places[b]);
    }
    some.SetRow(a, row);
  }
  ExpectWithin(exact, some, accuracy, 0.0);
}

std::vector<Id> Identity(Id count)
{
  std::vector<Id> ids(count);
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}
}

TEST(GraphTheoremInvariance, FlatVertices)
{
  // Vertices that change nothing: on edges, in faces, regular and at random, needles among them.
  for (const NamedMesh& named :
    { NamedMesh{ "Terrain", Terrain(7, 2.0, 1) }, NamedMesh{ "Sphere", NoisySphere(1, 0.4, 2) },
      NamedMesh{ "Cube", Cube(2, 0.2, 3) }, NamedMesh{ "Holes", TwoHoledBlock() },
      NamedMesh{ "Prism", PrismSide(3, 2, 4, 0.2, 4) }, NamedMesh{ "Icosahedron", Icosahedron() } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const DistanceTable exact = ExactTable(mesh);
    const std::vector<Id> places = Identity(mesh.GetNumberOfVertices());
    const dgg::SurfaceMesh regular = Build(Subdivided(named.Mesh, 3));
    const dgg::SurfaceMesh random = Build(RandomlyRefined(named.Mesh, 250, 5, 1e-4));
    for (const double accuracy : { 0.5, 0.1, 0.01, 1e-3, 1e-6 })
    {
      ExpectWithinOf(exact, mesh, places, accuracy);
      ExpectWithinOf(exact, regular, places, accuracy);
      ExpectWithinOf(exact, random, places, accuracy);
    }
  }
}

TEST(GraphTheoremInvariance, FlatVertexAfterFlatVertex)
{
  // The same face and the same edge cut again and again.
  TestMesh input = TwoTriangles(0.7);
  const DistanceTable exact = ExactTable(Build(input));
  const std::vector<Id> places = Identity(input.GetNumberOfVertices());
  for (int i = 0; i < 12; ++i)
  {
    SplitFace(input, i % input.GetNumberOfFaces(), { { 0.2, 0.3, 0.5 } });
    SplitEdge(input, input.Triangles[0], input.Triangles[1], 0.4);
    const dgg::SurfaceMesh mesh = Build(input);
    for (const double accuracy : { 0.3, 0.05, 1e-3 })
    {
      ExpectWithinOf(exact, mesh, places, accuracy);
    }
  }
}

TEST(GraphTheoremInvariance, Scale)
{
  for (const NamedMesh& named :
    { NamedMesh{ "Terrain", Terrain(14, 2.0, 1) }, NamedMesh{ "Sphere", NoisySphere(2, 0.4, 2) } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::GeodesicGraph original = BuildGraph(Build(named.Mesh), 0.02);
    for (const double factor : { 1e-30, 1e-6, 1e6, 1e30 })
    {
      SCOPED_TRACE(factor);
      const dgg::GeodesicGraph scaled = BuildGraph(Build(Scaled(named.Mesh, factor)), 0.02);
      ASSERT_EQ(scaled.View().GetNumberOfEdges(), original.View().GetNumberOfEdges());
      // A float holds neither the square of the small lengths nor a fraction of them.
      EXPECT_EQ(scaled.WideLengths.IsEmpty(), factor != 1e-30);
      for (dgg::Offset e = 0; e < original.View().GetNumberOfEdges(); ++e)
      {
        ASSERT_EQ(scaled.Targets[e], original.Targets[e]) << e;
        ASSERT_NEAR(scaled.View().Length(e) / factor / original.View().Length(e), 1.0, 2e-7) << e;
        ASSERT_NEAR(scaled.Angles[e], original.Angles[e], 2e-6) << e;
        ASSERT_NEAR(scaled.ArrivalAngles[e], original.ArrivalAngles[e], 2e-6) << e;
      }
    }
  }
}

TEST(GraphTheoremInvariance, Numbering)
{
  for (const NamedMesh& named :
    { NamedMesh{ "Terrain", Terrain(15, 2.0, 1) }, NamedMesh{ "Sphere", NoisySphere(2, 0.4, 2) },
      NamedMesh{ "Grid", Plane(14, 13) }, NamedMesh{ "Components", SeveralComponents() },
      NamedMesh{ "Isolated", SphereWithIsolatedPoints(2) } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const DistanceTable exact = ExactTable(mesh);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      const std::vector<Id> ids = RandomPermutation(mesh.GetNumberOfVertices(), seed);
      const dgg::SurfaceMesh renumbered = Build(Renumbered(named.Mesh, ids, seed));
      for (const double accuracy : { 0.1, 0.01 })
      {
        ExpectWithinOf(exact, renumbered, ids, accuracy);
        // Which of two equally good relays is met first depends on the order, and little else.
        const auto before = BuildGraph(mesh, accuracy).View().GetNumberOfEdges();
        const auto after = BuildGraph(renumbered, accuracy).View().GetNumberOfEdges();
        EXPECT_NEAR(static_cast<double>(after), static_cast<double>(before), 0.01 * before);
      }
    }
  }
}
}
