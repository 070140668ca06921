// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The promise of the graph, for all pairs of vertices of every kind of mesh: a theorem, so that a
// single pair beyond the bound is a bug.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
struct TheoremCase
{
  std::string Name;
  std::function<TestMesh()> Make;
};

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

std::vector<TheoremCase> TheoremCases()
{
  std::vector<TheoremCase> cases = {
    { "PlaneJittered", [] { return Plane(18, 16, 0.28, 1); } },
    { "PlaneRegular", [] { return Plane(15, 15); } },
    { "PlaneStretched20", [] { return Stretched(Plane(14, 14, 0.25, 2), 20.0); } },
    { "PlateWithHoles",
      [] {
        return Plate(
          20, 16, [](Id i, Id j) { return i % 5 < 2 || j % 6 < 3; }, 0.2, 3);
      } },
    { "PlateLShaped", [] { return Plate(14, 14, [](Id i, Id j) { return i < 5 || j < 6; }); } },
    { "SlitPlane",
      [] {
        std::vector<bool> unused;
        return SlitPlane(8, unused, 0.2, 4);
      } },
    { "PrismSide", [] { return PrismSide(5, 4, 10, 0.2, 5); } },
    { "PrismSideRegular", [] { return PrismSide(4, 4, 9); } },
    { "ConeSharp", [] { return FlatCone(0.7); } },
    { "ConeConvex", [] { return FlatCone(4.4); } },
    { "ConeSaddle", [] { return FlatCone(8.5); } },
    { "ConeSaddleWide", [] { return FlatCone(23.0); } },
    { "BoxRegular", [] { return Box(4, 5, 6, 1.0, 1.0, 2.0); } },
    { "BoxLong", [] { return Box(3, 3, 8, 1.0, 1.0, 20.0, 0.2, 6); } },
    { "CubeJittered", [] { return Cube(7, 0.25, 7); } },
    { "Tetrahedron", [] { return Subdivided(Tetrahedron(), 6); } },
    { "Octahedron", [] { return Subdivided(Octahedron(), 5); } },
    { "Icosahedron", [] { return Subdivided(Icosahedron(), 4); } },
    { "Dodecahedron", [] { return RandomlyRefined(Dodecahedron(), 150, 8, 1e-3); } },
    { "Icosphere", [] { return Icosphere(2); } },
    { "NoisySphere", [] { return NoisySphere(2, 0.5, 9); } },
    { "Ellipsoid20", [] { return Ellipsoid(2, 20.0); } },
    { "TerrainGentle", [] { return Terrain(16, 0.5, 10); } },
    { "TerrainRough", [] { return Terrain(16, 3.0, 11); } },
    { "Torus", [] { return WithNoise(Torus(18, 10), 0.05, 12); } },
    { "TwoHoles", [] { return WithNoise(Subdivided(TwoHoledBlock(), 2), 0.15, 13); } },
    { "FlatTorus", [] { return FlatTorus(3.0, 0.7, 2.0, 11, 8, false); } },
    { "FlatTorusThin", [] { return FlatTorus(9.0, 1.0, 0.5, 16, 2, true); } },
    { "FlatTorusTiny", [] { return FlatTorus(1.0, 0.5, std::sqrt(0.75), 2, 2, true); } },
    { "DoublyCoveredTriangle",
      [] {
        std::vector<bool> unused;
        return DoublyCoveredPolygon(3, 5, unused);
      } },
    { "DoublyCoveredHexagon",
      [] {
        std::vector<bool> unused;
        return DoublyCoveredPolygon(6, 5, unused);
      } },
    { "SeveralComponents", [] { return SeveralComponents(); } },
    { "TwoTriangles", [] { return TwoTriangles(0.8); } },
    { "SingleTriangle", [] { return SingleTriangle(); } },
    { "BookFine",
      [] {
        std::vector<Id> unused;
        return Book(4, 7, unused, 0.2, 14);
      } },
    { "PlaneWithFinFine",
      [] {
        Id unused = 0;
        return PlaneWithFin(8, unused, 0.2, 15);
      } },
    { "MoebiusFine", [] { return MoebiusStrip(20, 8); } },
    { "KleinBottleFine", [] { return KleinBottle(12, 9); } },
    { "SliversFine", [] { return SliverPlane(12, 1e-4); } },
    { "NeedlesFine", [] { return NeedlePlane(10, 1e-4); } },
    { "CapsFine", [] { return CapPlane(14, 1e-4); } },
    { "CollapsedFine", [] { return CollapsedSphere(2, 40, 16); } },
  };
  for (NamedMesh& named : DefectMeshes())
  {
    std::string name = "Defect" + named.Name;
    name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
    cases.push_back({ name, [mesh = named.Mesh] { return mesh; } });
  }
  return cases;
}

class GraphTheorem : public testing::TestWithParam<TheoremCase>
{
};
}

TEST_P(GraphTheorem, HoldsForAllPairs)
{
  const dgg::SurfaceMesh mesh = Build(GetParam().Make());
  ASSERT_LE(mesh.GetNumberOfVertices(), 600);
  const DistanceTable exact = ExactTable(mesh);
  // Faces without area are lengthened by a little, and exact distances are off by as much a face.
  const double slack = 10.0 * mesh.GetNumberOfMollifiedFaces() * mesh.GetMollification();
  for (const double accuracy : { 0.5, 0.1, 0.01, 1e-3, 1e-4 })
  {
    const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy);
    EXPECT_TRUE(graph.Info.IsGuaranteed());
    ExpectWithin(exact, GraphTable(graph.View()), accuracy, slack);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, GraphTheorem, testing::ValuesIn(TheoremCases()),
  [](const testing::TestParamInfo<TheoremCase>& info) { return info.param.Name; });
}
