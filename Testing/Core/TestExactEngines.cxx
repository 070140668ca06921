// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The two engines against each other on many meshes, and against brute force on small ones.
#include "BruteForceGeodesics.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include <cmath>
#include <vector>

namespace dggtest
{
namespace
{
std::vector<NamedMesh> AllMeshes()
{
  std::vector<NamedMesh> meshes = SoundMeshes();
  for (NamedMesh& mesh : DefectMeshes())
  {
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

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
}
