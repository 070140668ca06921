// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The accuracy guarantee of the graph for all pairs of vertices of every kind of mesh. The
// guarantee is a theorem, so a single pair beyond the bound is a bug. Includes adversarial and
// random meshes.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

#include <chrono>

namespace dggtest
{
namespace
{
/// Stretches a mesh along x: faces of anisotropy about `ratio`.
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

/// Returns a plane with a tip of small total angle: windows that pass the tip cross the faces
/// around it repeatedly, the more often the higher the tip.
TestMesh Spike(double height)
{
  TestMesh mesh = Plane(5, 5, 0.2);
  const Id tip = SplitFace(mesh, 24, { { 0.3, 0.3, 0.4 } });
  mesh.Points[3 * tip + 2] = height;
  return mesh;
}

/// Returns a long strip of edges between two sides, with no vertex inside the strip.
TestMesh Ladder(double lean)
{
  TestMesh mesh;
  constexpr Id count = 150;
  for (Id i = 0; i < count; ++i)
  {
    mesh.AddPoint(i, 0.0, 0.0);
    mesh.AddPoint(i + lean, 20.0, 0.0);
  }
  for (Id i = 0; i + 1 < count; ++i)
  {
    mesh.AddQuad(2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  }
  return mesh;
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
    { "Spike10", Spike(10.0) },
    { "Spike1e5", Spike(1e5) },
    { "LadderStraight", Ladder(0.0) },
    { "LadderZigzag", Ladder(0.4) },
    { "LadderLeaning", Ladder(30.0) },
  };
  // Mesh edges connect a vertex to itself, and windows meet their own source.
  for (const Id nx : { 1, 2, 3, 5 })
  {
    for (const Id ny : { 1, 2, 4 })
    {
      for (const double shear : { 0.0, 0.25 })
      {
        meshes.push_back({ "Torus" + std::to_string(nx) + "x" + std::to_string(ny) +
            (shear > 0.0 ? "Sheared" : ""),
          FlatTorus(1.0, shear, nx == ny ? 4.0 : std::sqrt(0.75), nx, ny, true) });
      }
    }
  }
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
    EXPECT_EQ(graph.Info.Accuracy, accuracy);
    ExpectWithin(exact, GraphTable(graph.View()), accuracy, SlackOf(mesh));
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, GraphTheorem, testing::ValuesIn(TheoremMeshes()),
  [](const testing::TestParamInfo<NamedMesh>& info) { return info.param.Name; });

TEST(GraphTheoremInvariance, Scale)
{
  // A float cannot represent the square or a fraction of the small lengths, or the largest length.
  const std::pair<double, bool> factors[] = { { 1e-69, true }, { 1e-36, true }, { 1e-30, true },
    { 1e30, false }, { 1e36, true }, { 1e68, true } };
  for (const TestMesh& input : { Terrain(14, 2.0, 1), NoisySphere(2, 0.4, 2) })
  {
    const dgg::GeodesicGraph original = BuildGraph(Build(input), 0.02);
    for (const auto& [factor, isWide] : factors)
    {
      SCOPED_TRACE(factor);
      const dgg::GeodesicGraph scaled = BuildGraph(Build(Scaled(input, factor)), 0.02);
      ASSERT_EQ(scaled.View().GetNumberOfEdges(), original.View().GetNumberOfEdges());
      EXPECT_EQ(scaled.WideLengths.IsEmpty(), !isWide);
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
    const std::vector<Id> ids = RandomPermutation(mesh.GetNumberOfVertices(), 1);
    const dgg::SurfaceMesh renumbered = Build(Renumbered(named.Mesh, ids, 1));
    for (const double accuracy : { 0.1, 0.01 })
    {
      const dgg::GeodesicGraph after = BuildGraph(renumbered, accuracy);
      ExpectWithin(ExactTable(renumbered), GraphTable(after.View()), accuracy, 0.0);
      // The order decides only which of two equally good relays is found first.
      const auto before = static_cast<double>(BuildGraph(mesh, accuracy).View().GetNumberOfEdges());
      EXPECT_NEAR(static_cast<double>(after.View().GetNumberOfEdges()) / before, 1.0, 0.01);
    }
  }
}

TEST(GraphBuilderTraps, CostEqualToDistance)
{
  // From s, the mesh edge to r covers the vertex x with no margin: as a relay, x can cover only
  // points straight behind it, and this must not be mistaken for covering everything. The mesh is
  // symmetric under a half turn that exchanges s and t, so that an edge from s to t that is missed
  // from one end cannot be found from the other.
  const double accuracy = 0.25;
  const double cost = 5.0 / (1.0 + accuracy);
  const double halfAxis = 0.5 * cost;
  const double otherAxis = std::sqrt(2.5 * 2.5 - halfAxis * halfAxis);
  const Id s = 0;
  const Id t = 5;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed)
  {
    Random random(seed);
    const double at = random.Uniform(0.05, 0.75);
    const double x = 2.5 + halfAxis * std::cosh(at); // |sx| - |rx| = cost
    const double y = otherAxis * std::sinh(at);
    const double points[5][2] = { { 0.0, 0.0 }, { 5.0, 0.0 }, { x, y }, { -7.0, 4.0 },
      { 9.0, 0.9 * y } };
    TestMesh input;
    for (const auto& p : points)
    {
      input.AddPoint(p[0], p[1], 0.0);
    }
    for (const auto& p : points)
    {
      input.AddPoint(2.0 - p[0], 11.0 - p[1], 0.0);
    }
    for (const Id half : { 0, 5 })
    {
      input.AddTriangle(half, half + 1, half + 3);
      input.AddTriangle(half + 1, half + 2, half + 3);
      input.AddTriangle(half + 2, half + 4, half + 3);
      input.AddTriangle(half + 4, 8 - half, half + 3);
    }
    // The result depends on rounding, which differs between rotations.
    const dgg::SurfaceMesh mesh =
      Build(MovedRigidly(input, random.Uniform(0.0, 6.0), { { 0.0, 0.0, 0.0 } }));
    const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy);
    ASSERT_GE(FindEdge(graph.View(), s, t), 0) << "seed " << seed;
  }
}

TEST(GraphBuilderTraps, HiddenRelay)
{
  // From s, the relay o covers v, and would cover x if x were visible. But v is a reflex corner
  // where the path from o to x bends; this path does not cover x.
  const double accuracy = 0.5;
  TestMesh input;
  const Id s = input.AddPoint(0.0, 0.0, 0.0);
  const Id o = input.AddPoint(0.3, 0.9, 0.0);
  const Id v = input.AddPoint(0.0, 1.0, 0.0);
  const Id x = input.AddPoint(-5.0, 10.0, 0.0);
  const Id m = input.AddPoint(-3.0, 0.5, 0.0);
  input.AddTriangle(s, o, m);
  input.AddTriangle(o, v, m);
  input.AddTriangle(v, x, m);
  const auto length = [&](Id a, Id b) { return EuclideanDistance(input, a, b); };
  const double cost = length(s, o) / (1.0 + accuracy);
  ASSERT_LT(cost + length(o, v), length(s, v));
  ASSERT_LT(cost + length(o, x), length(s, x));
  ASSERT_GT(cost + length(o, v) + length(v, x), length(s, x));
  const dgg::GeodesicGraph graph = BuildGraph(Build(input), accuracy);
  EXPECT_GE(FindEdge(graph.View(), s, x), 0);
}

// Random broken and sound meshes: no crash, no hang, the guarantee holds.

namespace
{
using dgg::GraphConstruction;

/// Returns a graph; a build that takes five seconds instead of milliseconds fails the test instead
/// of hanging.
dgg::GeodesicGraph BuildInTime(
  const dgg::SurfaceMesh& mesh, double accuracy, GraphConstruction construction)
{
  const auto start = std::chrono::steady_clock::now();
  const auto limit = start + std::chrono::seconds(5);
  dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy, [&](dgg::GraphOptions& options) {
    options.Construction = construction;
    options.NumberOfNeighbors = 15;
    options.Progress = [&](double) { return std::chrono::steady_clock::now() < limit; };
  });
  EXPECT_LT(std::chrono::steady_clock::now(), limit + std::chrono::seconds(5));
  return graph;
}

/// Checks every construction on an arbitrary mesh: the same vertices are reached as by exact
/// distances, and distances are within the bound. `tolerance` is the error of the exact distances
/// relative to the diameter.
void ExpectSane(const TestMesh& input, double tolerance)
{
  dgg::SurfaceMesh mesh;
  const dgg::Status status = dgg::SurfaceMesh::FromPoints(input.Points.data(),
    input.GetNumberOfVertices(), input.Triangles.data(), input.GetNumberOfFaces(), mesh);
  if (!status.IsOk())
  {
    return; // the mesh consists of single points only
  }
  const DistanceTable exact = ExactTable(mesh);
  double diameter = 0.0;
  for (Id v = 0; v < exact.GetSize(); ++v)
  {
    for (Id w = 0; w < exact.GetSize(); ++w)
    {
      diameter = exact(v, w) < dgg::Infinity ? std::max(diameter, exact(v, w)) : diameter;
    }
  }
  for (const double accuracy : { 0.5, 0.1, 0.01, 1e-4 })
  {
    const dgg::GeodesicGraph graph = BuildInTime(mesh, accuracy, GraphConstruction::Guaranteed);
    ExpectWithin(exact, GraphTable(graph.View()), accuracy, tolerance * diameter);
  }
  const dgg::GeodesicGraph indirect = BuildInTime(mesh, 0.1, GraphConstruction::Indirect);
  ExpectWithin(exact, GraphTable(indirect.View()), 0.1, tolerance * diameter);
  for (const GraphConstruction construction :
    { GraphConstruction::OneRelay, GraphConstruction::SaddleVertexGraph })
  {
    const dgg::GeodesicGraph graph = BuildInTime(mesh, 0.1, construction);
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const std::vector<double> distances = GraphDistances(graph.View(), v);
      for (Id w = 0; w < mesh.GetNumberOfVertices(); ++w)
      {
        ASSERT_GE(distances[w], exact(v, w) * (1.0 - 1e-9) - tolerance * diameter);
      }
    }
  }
  // The links of a point lead to everything that the point reaches.
  const bool hasFace = std::any_of(input.Triangles.begin(), input.Triangles.end(),
    [&](const Id& v) { return mesh.Kind(v) != dgg::VertexKind::Isolated; });
  if (hasFace)
  {
    const dgg::GraphBuilder builder(mesh);
    const dgg::GeodesicGraph graph = BuildGraph(mesh, 0.1);
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 3, 5))
    {
      const std::vector<double> distances =
        ReferenceDistances(graph.View(), SeedsOf(builder, point, 0.1));
      const std::vector<double> truth =
        Solve(mesh, dgg::ExactEngine::Triangle, { { point, 0.0 } }).Distances;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        ASSERT_EQ(distances[v] < dgg::Infinity, truth[v] < dgg::Infinity) << v;
        if (truth[v] < dgg::Infinity)
        {
          ASSERT_GE(distances[v], truth[v] * (1.0 - 1e-9) - tolerance * diameter) << v;
          ASSERT_LE(distances[v], 1.1 * (1.0 + 1e-6) * (truth[v] + tolerance * diameter)) << v;
        }
      }
    }
  }
}

/// Returns a sound but difficult mesh: stretched, rough, or refined at random.
TestMesh RandomMesh(std::uint64_t seed)
{
  Random random(seed);
  const std::function<TestMesh()> kinds[] = {
    [&] { return Plane(3 + random.Index(6), 3 + random.Index(6), 0.29, seed); },
    [&] { return NoisySphere(1, random.Uniform(0.0, 0.8), seed); },
    [&] { return Terrain(3 + random.Index(6), random.Uniform(0.1, 5.0), seed); },
    [&] { return Cube(1 + random.Index(3), 0.29, seed); },
    [&] { return Ellipsoid(1, random.Uniform(1.0, 40.0)); },
    [&] {
      return PrismSide(3 + random.Index(3), 1 + random.Index(3), 2 + random.Index(4), 0.29, seed);
    },
    [&] { return WithNoise(Torus(6 + random.Index(4), 4 + random.Index(3)), 0.1, seed); }
  };
  TestMesh mesh = kinds[random.Index(7)]();
  const double stretch = std::exp(random.Uniform(-3.0, 3.0));
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] *= stretch;
  }
  mesh = RandomlyRefined(mesh, random.Index(50), seed, random.Index(2) == 0 ? 1e-2 : 1e-5);
  return random.Index(3) == 0 ? WithNoise(mesh, random.Uniform(0.0, 0.4) * MeanEdge(mesh), seed)
                              : mesh;
}
}

TEST(GraphBuilderFuzz, SoundMeshes)
{
  for (std::uint64_t seed = 1; seed <= 150; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const dgg::SurfaceMesh mesh = Build(RandomMesh(seed));
    const DistanceTable exact = ExactTable(mesh);
    for (const double accuracy : { 0.5, 0.01, random.Uniform(1e-3, 0.5) })
    {
      ExpectWithin(exact, GraphTable(BuildGraph(mesh, accuracy).View()), accuracy, 0.0);
    }
  }
}
TEST(GraphBuilderFuzz, BrokenMeshes)
{
  for (const NamedMesh& named : BrokenMeshes(400, 50))
  {
    SCOPED_TRACE(named.Name);
    ExpectSane(named.Mesh, 1e-6);
  }
  ExpectSane(RandomSoup(80, 200, 1), 1e-6);
}
}
