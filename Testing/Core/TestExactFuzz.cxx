// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Random broken meshes: no crash, no hang, and the bounds hold.
#include "EdgeGraph.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include "dggMeshReport.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace dggtest
{
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
    EXPECT_NE(status.GetMessage().find("single points"), std::string::npos) << status.GetMessage();
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
