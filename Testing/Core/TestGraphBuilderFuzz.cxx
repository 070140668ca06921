// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Random meshes, broken and sound: no crash, no hang, the promise kept.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::GraphConstruction;

/// A graph; a failure after five seconds instead of a hang, where milliseconds do.
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

/// Every construction on a mesh that may be anything. Distances are reached where the exact ones
/// are, and within the bound; `tolerance` is that of the exact distances, in diameters.
void ExpectSane(const TestMesh& input, double tolerance)
{
  dgg::SurfaceMesh mesh;
  const dgg::Status status = dgg::SurfaceMesh::FromPoints(input.Points.data(),
    input.GetNumberOfVertices(), input.Triangles.data(), input.GetNumberOfFaces(), mesh);
  if (!status.IsOk())
  {
    return; // nothing but single points
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
  // Links of any point lead to all that the point reaches.
  const bool hasFace = std::any_of(input.Triangles.begin(), input.Triangles.end(),
    [&](const Id& v) { return mesh.Kind(v) != dgg::VertexKind::Isolated; });
  if (hasFace)
  {
    const dgg::GraphBuilder builder(mesh);
    const dgg::GeodesicGraph graph = BuildGraph(mesh, 0.1);
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 3, 5))
    {
      std::vector<dgg::GraphLink> links;
      std::vector<double> direct;
      ASSERT_TRUE(builder.Link(point, 0.1, {}, links, direct).IsOk());
      std::vector<std::pair<Id, double>> sources;
      for (const dgg::GraphLink& link : links)
      {
        sources.emplace_back(link.Vertex, link.Length);
      }
      const std::vector<double> distances = GraphDistances(graph.View(), sources);
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

/// Sound but unpleasant: stretched, rough, refined at random.
TestMesh RandomMesh(std::uint64_t seed)
{
  Random random(seed);
  TestMesh mesh;
  switch (random.Index(7))
  {
    case 0:
      mesh = Plane(3 + random.Index(6), 3 + random.Index(6), 0.29, seed);
      break;
    case 1:
      mesh = NoisySphere(1, random.Uniform(0.0, 0.8), seed);
      break;
    case 2:
      mesh = Terrain(3 + random.Index(6), random.Uniform(0.1, 5.0), seed);
      break;
    case 3:
      mesh = Cube(1 + random.Index(3), 0.29, seed);
      break;
    case 4:
      mesh = Ellipsoid(1, random.Uniform(1.0, 40.0));
      break;
    case 5:
      mesh = PrismSide(3 + random.Index(3), 1 + random.Index(3), 2 + random.Index(4), 0.29, seed);
      break;
    default:
      mesh = WithNoise(Torus(6 + random.Index(4), 4 + random.Index(3)), 0.1, seed);
      break;
  }
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

TEST(GraphBuilderFuzz, SmallSoups)
{
  for (std::uint64_t seed = 1; seed <= 400; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Id vertices = 3 + random.Index(20);
    ExpectSane(RandomSoup(vertices, 1 + random.Index(50), seed), 1e-6);
  }
}

TEST(GraphBuilderFuzz, LargeSoups)
{
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectSane(RandomSoup(80, 200, seed), 1e-6);
  }
}

TEST(GraphBuilderFuzz, CollapsedMeshes)
{
  for (std::uint64_t seed = 1; seed <= 25; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectSane(CollapsedSphere(2, 1 + static_cast<Id>(2 * seed), seed), 1e-6);
  }
}

TEST(GraphBuilderFuzz, FlattenedMeshes)
{
  for (const TestMesh& mesh : FlattenedMeshes())
  {
    ExpectSane(mesh, 1e-6);
  }
}
}
