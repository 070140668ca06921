// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The two engines against each other on many meshes, and against brute force on small ones.
#include "BruteForceGeodesics.h"
#include "EdgeGraph.h"
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggMeshReport.h"

#include <algorithm>
#include <chrono>
#include <vector>

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

/// Small meshes on which brute force ends soon.
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
  meshes.push_back({ "Plate",
    Plate(
      6, 6, [](Id i, Id j) { return !(i == 2 && j > 0); }, 0.2) });
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

TEST_P(EnginesAgree, FromAndToPointsAnywhere)
{
  const dgg::SurfaceMesh mesh = Build(this->GetParam().Mesh);
  const auto points = RandomSurfacePoints(mesh, 12, 23);
  auto wantTargets = [&](dgg::ExactOptions& options) { options.Targets = points; };
  for (std::size_t i = 0; i < 6; ++i)
  {
    const auto reference =
      Solve(mesh, dgg::ExactEngine::Reference, { { points[i], 0.0 } }, wantTargets);
    const auto triangle =
      Solve(mesh, dgg::ExactEngine::Triangle, { { points[i], 0.0 } }, wantTargets);
    const double diameter = LargestFinite(reference.Distances);
    const std::string what = "from point " + std::to_string(i);
    ExpectSameField(reference.Distances, triangle.Distances, 1e-9 * diameter, what);
    ExpectSameField(
      reference.TargetDistances, triangle.TargetDistances, 1e-9 * diameter, what + ", targets");
  }
}

TEST_P(EnginesAgree, FromSeveralSourcesWithOffsets)
{
  const dgg::SurfaceMesh mesh = Build(this->GetParam().Mesh);
  const double scale = mesh.GetMeanEdgeLength();
  std::vector<dgg::GeodesicSource> sources;
  Random random(31);
  for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 4, 29))
  {
    sources.push_back({ point, random.Uniform(0.0, 2.0 * scale) });
  }
  sources.push_back(VertexSource(mesh.GetNumberOfVertices() / 2, scale));
  const auto reference = Solve(mesh, dgg::ExactEngine::Reference, sources);
  const auto triangle = Solve(mesh, dgg::ExactEngine::Triangle, sources);
  ExpectSameField(
    reference.Distances, triangle.Distances, 1e-9 * LargestFinite(reference.Distances), "field");
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
/// Distances; a failure after five seconds instead of a hang, where milliseconds do.
std::vector<double> SolveInTime(
  const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine, const dgg::GeodesicSource& source)
{
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  return Solve(mesh, engine, { source }, [&](dgg::ExactOptions& options) {
    options.Progress = [&](double) { return std::chrono::steady_clock::now() < limit; };
  }).Distances;
}

/// Both engines from two vertices and two points anywhere; the fields lie between Euclid and the
/// edge graph and agree with each other.
void ExpectSane(const TestMesh& input, double agreement)
{
  dgg::SurfaceMesh mesh;
  const dgg::Status status = dgg::SurfaceMesh::FromPoints(input.Points.data(),
    input.GetNumberOfVertices(), input.Triangles.data(), input.GetNumberOfFaces(), mesh);
  if (!status.IsOk())
  {
    // The only complaint that these meshes can cause.
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

TEST(ExactFuzz, SmallSoups)
{
  for (std::uint64_t seed = 1; seed <= 600; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Id vertices = 3 + random.Index(20);
    const Id faces = 1 + random.Index(50);
    ExpectSane(RandomSoup(vertices, faces, seed), 1e-6);
  }
}

TEST(ExactFuzz, PairOfFlatFaces)
{
  // Two faces of no area on the same three vertices, in line, and a third face on their long edge:
  // light that gets between the two must not go round for ever.
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

TEST(ExactFuzz, LargeSoups)
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectSane(RandomSoup(150, 400, seed), 1e-6);
  }
}

TEST(ExactFuzz, DamagedMeshes)
{
  for (std::uint64_t seed = 1; seed <= 150; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    TestMesh mesh = seed % 3 == 0 ? Cube(4)
      : seed % 3 == 1             ? NoisySphere(2, 0.3, seed)
                                  : Torus(14, 9);
    for (int damage = 0; damage < 12; ++damage)
    {
      const Id v = random.Index(mesh.GetNumberOfVertices());
      const Id w = random.Index(mesh.GetNumberOfVertices());
      const Id f = random.Index(mesh.GetNumberOfFaces());
      switch (random.Index(6))
      {
        case 0: // a face more, anywhere
          mesh.AddTriangle(v, w, mesh.Triangles[3 * f]);
          break;
        case 1: // a face less
          mesh.Triangles.erase(mesh.Triangles.begin() + 3 * f, mesh.Triangles.begin() + 3 * f + 3);
          break;
        case 2: // two points on one place
          std::copy_n(mesh.Points.begin() + 3 * w, 3, mesh.Points.begin() + 3 * v);
          break;
        case 3: // a corner moved to another vertex
          mesh.Triangles[3 * f + random.Index(3)] = v;
          break;
        case 4: // a face turned over
          std::swap(mesh.Triangles[3 * f], mesh.Triangles[3 * f + 1]);
          break;
        default: // a point far away
          mesh.Points[3 * v + random.Index(3)] += random.Uniform(-3.0, 3.0);
          break;
      }
    }
    ExpectSane(mesh, 1e-6);
  }
}

TEST(ExactFuzz, CollapsedMeshes)
{
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectSane(CollapsedSphere(2, 1 + static_cast<Id>(seed), seed), 1e-6);
  }
}

TEST(ExactFuzz, FlattenedMeshes)
{
  for (const TestMesh& mesh : FlattenedMeshes())
  {
    ExpectSane(mesh, 1e-6);
  }
}
}
