// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Comparison of the two engines with each other and with brute force, and invariants on every mesh:
// bounds, symmetry, and changes of the mesh that preserve distances.
#include "BruteForceGeodesics.h"
#include "EdgeGraph.h"
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggMeshReport.h"

#include <chrono>

namespace dggtest
{
namespace
{
std::string MeshName(const testing::TestParamInfo<NamedMesh>& info)
{
  std::string name = info.param.Name;
  for (char& c : name)
  {
    c = c == '-' ? 'm' : c;
  }
  return name;
}

/// Returns small meshes for which brute force is fast.
std::vector<NamedMesh> SmallMeshes()
{
  std::vector<Id> sheetOf;
  std::vector<bool> isBack;
  Id unused = 0;
  std::vector<NamedMesh> meshes;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    const std::string s = std::to_string(seed);
    meshes.push_back({ "Sphere10_" + s, NoisySphere(1, 0.1, seed) });
    meshes.push_back({ "Sphere50_" + s, NoisySphere(1, 0.5, seed) });
    meshes.push_back({ "Terrain_" + s, Terrain(6, 1.5, seed) });
  }
  meshes.push_back({ "Ellipsoid", Ellipsoid(1, 5.0) });
  meshes.push_back({ "Torus", WithNoise(Torus(8, 5), 0.05, 3) });
  meshes.push_back({ "TwoHoles", WithNoise(TwoHoledBlock(), 0.1, 4) });
  meshes.push_back({ "CubeRegular", Cube(3) });
  meshes.push_back({ "CubeJittered", Cube(3, 0.25, 2) });
  meshes.push_back({ "Grid", Plane(6, 5) });
  // Domains with corners, obstacles, and point contacts; regular domains have many ties.
  struct Domain
  {
    const char* Name;
    bool (*Keep)(Id i, Id j);
  };
  for (const Domain& domain : { Domain{ "LShape", [](Id i, Id j) { return i < 3 || j < 3; } },
         Domain{ "Slot", [](Id i, Id j) { return i != 4 || j == 0; } },
         Domain{ "Annulus", [](Id i, Id j) { return i < 3 || i > 5 || j < 3 || j > 5; } },
         Domain{ "Maze", [](Id i, Id j) { return i % 4 != 2 || (i % 8 == 2 ? j == 0 : j == 8); } },
         Domain{ "ManyHoles", [](Id i, Id j) { return i % 3 != 1 || j % 3 != 1; } },
         Domain{ "TouchingCells", [](Id i, Id j) { return i / 2 == j / 2; } } })
  {
    meshes.push_back({ domain.Name, Plate(9, 9, domain.Keep) });
    meshes.push_back({ std::string(domain.Name) + "Jittered", Plate(9, 9, domain.Keep, 0.25, 5) });
  }
  // A ray that hits a flat vertex exactly illuminates neither child, so flat vertices emit windows
  // again. Two windows may illuminate an apex by the same ray: both children of both are needed.
  meshes.push_back({ "Cube4", Cube(4) });
  meshes.push_back({ "Cube5", Cube(5) });
  meshes.push_back({ "Octahedron", Subdivided(Octahedron(), 4) });
  meshes.push_back({ "TwoHolesRegular", Subdivided(TwoHoledBlock(), 2) });
  meshes.push_back({ "PinchedPlates", PinchedPlates(3) });
  meshes.push_back({ "TouchingSpheres", TouchingSpheres(0) });
  meshes.push_back({ "ThreeSheets", Book(3, 3, sheetOf, 0.2, 2) });
  meshes.push_back({ "ThreeCrumpledSheets", WithNoise(Book(3, 3, sheetOf, 0.2, 2), 0.2, 3) });
  meshes.push_back({ "FourCrumpledSheets", WithNoise(Book(4, 3, sheetOf, 0.2, 5), 0.3, 6) });
  meshes.push_back({ "CrumpledFin", WithNoise(PlaneWithFin(3, unused, 0.2, 4), 0.2, 5) });
  meshes.push_back(
    { "CubesOnEdge", Subdivided(VoxelSurface(2, 2, 1, [](Id i, Id j, Id) { return i == j; }), 2) });
  meshes.push_back({ "DuplicateFaces", DuplicateFaceCube(2) });
  meshes.push_back({ "Misoriented", MisorientedSphere(1, 8) });
  meshes.push_back({ "Moebius", MoebiusStrip(7, 4) });
  meshes.push_back({ "KleinBottle", KleinBottle(6, 4) });
  return meshes;
}
}

class EnginesAgree : public testing::TestWithParam<NamedMesh>
{
};

TEST_P(EnginesAgree, OnDistancesBetweenPointsAnywhere)
{
  const dgg::SurfaceMesh mesh = Build(this->GetParam().Mesh);
  const auto points = RandomSurfacePoints(mesh, 12, 23);
  auto wantTargets = [&](dgg::ExactOptions& options) { options.Targets = points; };
  std::vector<std::vector<dgg::GeodesicSource>> runs;
  for (std::size_t i = 0; i < 6; ++i)
  {
    runs.push_back({ { points[i], 0.0 } });
  }
  Random random(31);
  runs.push_back({ VertexSource(mesh.GetNumberOfVertices() / 2, mesh.GetMeanEdgeLength()) });
  for (std::size_t i = 6; i < 10; ++i)
  {
    runs.back().push_back({ points[i], random.Uniform(0.0, 2.0 * mesh.GetMeanEdgeLength()) });
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    SCOPED_TRACE(i);
    const auto reference = Solve(mesh, dgg::ExactEngine::Reference, runs[i], wantTargets);
    const auto triangle = Solve(mesh, dgg::ExactEngine::Triangle, runs[i], wantTargets);
    const double tolerance = 1e-9 * LargestFinite(reference.Distances);
    ExpectSameField(reference.Distances, triangle.Distances, tolerance, "vertices");
    ExpectSameField(reference.TargetDistances, triangle.TargetDistances, tolerance, "targets");
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, EnginesAgree, testing::ValuesIn(AllMeshes()), MeshName);

class EnginesAgainstBruteForce : public testing::TestWithParam<NamedMesh>
{
};

TEST_P(EnginesAgainstBruteForce, AllPairs)
{
  const dgg::SurfaceMesh mesh = Build(this->GetParam().Mesh);
  const std::vector<double> truth = BruteForceDistances(mesh);
  const Id n = mesh.GetNumberOfVertices();
  for (const auto engine : { dgg::ExactEngine::Reference, dgg::ExactEngine::Triangle })
  {
    SCOPED_TRACE(engine == dgg::ExactEngine::Reference ? "Reference" : "Triangle");
    ExpectAllPairs(
      mesh, engine, [&](Id a, Id b) { return truth[static_cast<std::size_t>(a) * n + b]; }, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Meshes, EnginesAgainstBruteForce, testing::ValuesIn(SmallMeshes()), MeshName);

// Random broken meshes: no crash, no hang, and the bounds hold.

namespace
{
/// Returns distances; a run that takes five seconds instead of milliseconds fails the test instead
/// of hanging.
std::vector<double> SolveInTime(
  const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine, const dgg::GeodesicSource& source)
{
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  return Solve(mesh, engine, { source }, [&](dgg::ExactOptions& options) {
    options.Progress = [&](double) { return std::chrono::steady_clock::now() < limit; };
  }).Distances;
}

/// Runs both engines from two vertices and two arbitrary points. Expects the fields to lie between
/// the Euclidean distance and the edge graph, and to agree with each other.
void ExpectSane(const TestMesh& input, double agreement)
{
  dgg::SurfaceMesh mesh;
  const dgg::Status status = dgg::SurfaceMesh::FromPoints(input.Points.data(),
    input.GetNumberOfVertices(), input.Triangles.data(), input.GetNumberOfFaces(), mesh);
  if (!status.IsOk())
  {
    // No other error is possible on these meshes.
    EXPECT_TRUE(Says(status, "single points"));
    return;
  }
  const dgg::MeshReport report = dgg::InspectMesh(mesh, input.Points.data());
  EXPECT_EQ(report.Faces, input.GetNumberOfFaces());
  EXPECT_GE(report.Genus, -1);
  std::vector<dgg::GeodesicSource> sources{ VertexSource(0),
    VertexSource(input.GetNumberOfVertices() - 1) };
  if (report.Faces > report.RepeatedVertexFaces)
  {
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 2, 5))
    {
      sources.push_back({ point, 0.0 });
    }
  }
  for (const dgg::GeodesicSource& source : sources)
  {
    const auto bound = dggtest::EdgeGraphDistances(mesh, { source });
    const double diameter = LargestFinite(bound);
    const auto reference = SolveInTime(mesh, dgg::ExactEngine::Reference, source);
    const auto triangle = SolveInTime(mesh, dgg::ExactEngine::Triangle, source);
    ASSERT_EQ(reference.size(), bound.size());
    ASSERT_EQ(triangle.size(), bound.size());
    ExpectSameField(reference, triangle, agreement * diameter, "engines");
    for (const auto& distances : { reference, triangle })
    {
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        ASSERT_GE(distances[v], 0.0);
        ASSERT_EQ(distances[v] < dgg::Infinity, bound[v] < dgg::Infinity);
        ASSERT_LE(distances[v], bound[v] * (1.0 + 1e-14));
        if (source.Point.On == dgg::SurfacePoint::Support::Vertex && distances[v] < dgg::Infinity)
        {
          ASSERT_GE(distances[v],
            EuclideanDistance(input, source.Point.Vertex, v) - 1e-9 * (diameter + 1.0));
        }
      }
    }
  }
}
}

TEST(ExactFuzz, BrokenMeshes)
{
  for (const NamedMesh& named : BrokenMeshes(600, 60))
  {
    SCOPED_TRACE(named.Name);
    ExpectSane(named.Mesh, 1e-6);
  }
  ExpectSane(RandomSoup(150, 400, 1), 1e-6);
}

TEST(ExactFuzz, PairOfFlatFaces)
{
  // Two degenerate faces on the same three collinear vertices, and a third face on their long edge:
  // windows that enter between the two must not circulate forever.
  TestMesh mesh;
  mesh.Points = { 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.5, 0.5, 0.0, -1.0, 1.5, 0.5, 2.0,
    2.0, 0.3 };
  mesh.Triangles = { 0, 3, 1, 2, 0, 1, 0, 1, 2, 3, 5, 4, 4, 3, 0 };
  ExpectSane(mesh, 1e-6);
  const dgg::SurfaceMesh built = Build(mesh);
  for (const std::array<double, 3>& b : { std::array<double, 3>{ { 0.7, 0.15, 0.15 } },
         std::array<double, 3>{ { 0.3, 0.3, 0.4 } }, std::array<double, 3>{ { 0.1, 0.1, 0.8 } } })
  {
    for (const Id face : { 0, 3, 4 })
    {
      const dgg::GeodesicSource source{ dgg::SurfacePoint::InFace(built, face, b), 0.0 };
      ExpectSameField(SolveInTime(built, dgg::ExactEngine::Reference, source),
        SolveInTime(built, dgg::ExactEngine::Triangle, source), 1e-6, "engines");
    }
  }
}

class ExactInvariance : public EngineTest
{
protected:
  using Check = std::function<void(const TestMesh&, const dgg::SurfaceMesh&)>;

  static void ForEachMesh(const std::vector<NamedMesh>& meshes, const Check& check)
  {
    for (const NamedMesh& named : meshes)
    {
      SCOPED_TRACE(named.Name);
      check(named.Mesh, Build(named.Mesh));
    }
  }

  /// Expects the distances from a vertex to equal those of a changed mesh up to a scale factor.
  /// Vertex v has the id `ids[v]` in the changed mesh, or v if `ids` is empty.
  void ExpectUnchanged(const dgg::SurfaceMesh& mesh, const dgg::SurfaceMesh& changed, Id source,
    const std::vector<Id>& ids = {}, double factor = 1.0, double tolerance = 1e-9)
  {
    const auto idOf = [&](Id v) { return ids.empty() ? v : ids[v]; };
    const auto expected = DistancesFrom(mesh, this->Engine(), source);
    const auto there = DistancesFrom(changed, this->Engine(), idOf(source));
    std::vector<double> distances;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      distances.push_back(there[idOf(v)] / factor);
    }
    ExpectSameField(expected, distances, tolerance * LargestFinite(expected), "changed");
  }
};
DGG_WITH_BOTH_ENGINES(ExactInvariance);

TEST_P(ExactInvariance, IsOneLipschitzAndAtLeastEuclidean)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    for (const Id source : SomeVertices(mesh, 4, 5))
    {
      const auto distances = DistancesFrom(mesh, this->Engine(), source);
      const double diameter = LargestFinite(distances);
      for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
      {
        const double a = distances[mesh.Origin(h)];
        const double b = distances[mesh.Destination(h)];
        if (!mesh.IsDropped(h / 3) && (a < dgg::Infinity || b < dgg::Infinity))
        {
          ASSERT_LE(std::abs(a - b), mesh.Length(h) + 1e-13 * diameter) << h;
        }
      }
      for (Id v = 0; v < mesh.GetNumberOfVertices() && !input.Points.empty(); ++v)
      {
        ASSERT_GE(distances[v], EuclideanDistance(input, source, v) - 1e-9 * diameter) << v;
      }
    }
  });
}

TEST_P(ExactInvariance, IsSymmetricBetweenPointsAnywhere)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh&, const dgg::SurfaceMesh& mesh) {
    const auto points = RandomSurfacePoints(mesh, 8, 9);
    std::vector<std::vector<double>> table;
    for (const dgg::SurfacePoint& point : points)
    {
      table.push_back(DistancesTo(mesh, this->Engine(), point, points));
    }
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_NEAR(table[i][i], 0.0, 1e-13 * mesh.GetMaximumEdgeLength());
      for (std::size_t j = 0; j < i; ++j)
      {
        if (table[i][j] != table[j][i])
        {
          ASSERT_NEAR(table[i][j], table[j][i], 1e-10 * LargestFinite(table[i])) << i << " " << j;
        }
      }
    }
  });
}

TEST_P(ExactInvariance, InsertedVerticesChangeNothing)
{
  std::vector<Id> sheetOf;
  Id unused = 0;
  const std::vector<NamedMesh> spines{ { "Book", WithNoise(Book(3, 4, sheetOf, 0.2, 2), 0.15, 3) },
    { "Fin", WithNoise(PlaneWithFin(4, unused, 0.2, 4), 0.15, 5) },
    { "CubesOnEdge", VoxelSurface(2, 2, 1, [](Id i, Id j, Id) { return i == j; }) },
    { "PinchedPlates", PinchedPlates(3) } };
  this->ForEachMesh(
    Joined(SoundMeshes(), spines), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
      const double area = 1e-4 * mesh.GetMeanEdgeLength() * mesh.GetMeanEdgeLength();
      const dgg::SurfaceMesh refined = Build(RandomlyRefined(input, 60, 13, area));
      for (const Id source : SomeVertices(mesh, 4, 13))
      {
        this->ExpectUnchanged(mesh, refined, source);
      }
    });
}

TEST_P(ExactInvariance, ScalesWithTheMesh)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    for (const double factor : { 1e6, 1e-6, 1024.0 })
    {
      // Faces that are degenerate up to rounding are lengthened by their rounding error.
      const double tolerance = mesh.GetNumberOfDegenerateFaces() > 0 ? 1e-6 : 1e-9;
      this->ExpectUnchanged(mesh, Build(Scaled(input, factor)), 0, {}, factor, tolerance);
    }
  });
}

TEST_P(ExactInvariance, DoesNotDependOnNumbering)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    const auto newIds = RandomPermutation(mesh.GetNumberOfVertices(), 19);
    const dgg::SurfaceMesh renumbered = Build(Renumbered(input, newIds, 20));
    for (const Id source : SomeVertices(mesh, 3, 21))
    {
      this->ExpectUnchanged(mesh, renumbered, source, newIds);
    }
  });
}

TEST_P(ExactInvariance, DoesNotDependOnOrientation)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    if (input.Points.empty())
    {
      return;
    }
    TestMesh turned = input;
    Random random(23);
    for (Id f = 0; f < turned.GetNumberOfFaces(); ++f)
    {
      if (random.Uniform() < 0.5)
      {
        std::swap(turned.Triangles[3 * f + 1], turned.Triangles[3 * f + 2]);
      }
    }
    this->ExpectUnchanged(mesh, Build(turned), 1);
  });
}

TEST_P(ExactInvariance, DoesNotDependOnThePlaceInSpace)
{
  this->ForEachMesh(SoundMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    for (const double angle : { 0.3, 2.0 })
    {
      this->ExpectUnchanged(mesh, Build(MovedRigidly(input, angle, { { 3.0, -7.0, 11.0 } })), 0);
    }
  });
}

TEST_P(ExactInvariance, SeamsAndUnusedPointsChangeNothing)
{
  // Isolated points and unused faces beside the mesh.
  const TestMesh sphere = NoisySphere(2, 0.2, 3);
  TestMesh crowded = sphere;
  crowded.AddPoint(9.0, 9.0, 9.0);
  crowded.AddTriangle(0, 0, 5);
  crowded.AddTriangle(3, 4, 3);
  const auto expected = DistancesFrom(Build(sphere), this->Engine(), 0);
  auto distances = DistancesFrom(Build(crowded), this->Engine(), 0);
  EXPECT_EQ(distances.back(), dgg::Infinity);
  distances.pop_back();
  EXPECT_EQ(distances, expected);
}
}
