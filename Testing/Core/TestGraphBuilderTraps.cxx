// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes made to catch the builder at its tests of what is covered: ties, costs without progress,
// light that comes back to where it started, tips that it turns around for long.
#include "GeodesicChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <vector>

namespace dggtest
{
namespace
{
void ExpectTheorem(const dgg::SurfaceMesh& mesh, double accuracy)
{
  ExpectWithin(ExactTable(mesh), GraphTable(BuildGraph(mesh, accuracy).View()), accuracy, 0.0);
}

double SecondsOf(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}

TEST(GraphBuilderTraps, CostEqualToDistance)
{
  // From s, the mesh edge to r covers the vertex x with nothing to spare: as a relay, x can cover
  // nothing but what is straight behind it, and this must not be mistaken for covering everything.
  // The mesh is the same seen from t, half a turn away, so that the edge from s to t cannot be
  // found from either end if it is missed from one.
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
    // Rounding decides what happens: turned, it differs.
    const dgg::SurfaceMesh mesh =
      Build(MovedRigidly(input, random.Uniform(0.0, 6.0), { { 0.0, 0.0, 0.0 } }));
    const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy);
    ASSERT_GE(FindEdge(graph.View(), s, t), 0) << "seed " << seed;
  }
}

TEST(GraphBuilderTraps, HiddenRelay)
{
  // From s, the relay o covers v, and it would cover x if it saw it: but v is a reflex corner, and
  // the way from o to x has a bend there. With that, x is not covered.
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

TEST(GraphBuilderTraps, EdgesBackToTheSource)
{
  // Glued so that mesh edges lead from a vertex to itself, and light meets its own source: a vertex
  // is no relay of its own and no edge of its own.
  for (Id nx = 1; nx <= 5; ++nx)
  {
    for (Id ny = 1; ny <= 4; ++ny)
    {
      for (const double shear : { 0.0, 0.25, 0.5 })
      {
        SCOPED_TRACE(nx);
        SCOPED_TRACE(ny);
        SCOPED_TRACE(shear);
        for (const double height : { std::sqrt(0.75), 1.0, 4.0 })
        {
          const dgg::SurfaceMesh mesh = Build(FlatTorus(1.0, shear, height, nx, ny, true));
          for (const double accuracy : { 0.5, 0.1, 1e-3 })
          {
            ExpectTheorem(mesh, accuracy);
          }
        }
      }
    }
  }
}

TEST(GraphBuilderTraps, Spikes)
{
  // Windows that pass a tip of a small total angle cross the faces around it again and again, in
  // numbers that grow with the height of the tip: no hang, and no wrong distance.
  for (const double height : { 10.0, 1e3, 1e5 })
  {
    TestMesh input = Plane(5, 5, 0.2);
    const Id tip = SplitFace(input, 24, { { 0.3, 0.3, 0.4 } });
    input.Points[3 * tip + 2] = height;
    const dgg::SurfaceMesh mesh = Build(input);
    const double seconds = SecondsOf([&] {
      ExpectTheorem(mesh, 0.1);
      ExpectTheorem(mesh, 1e-3);
    });
    EXPECT_LT(seconds, 60.0) << "height " << height;
  }
}

TEST(GraphBuilderTraps, LongStrips)
{
  // Thousands of edges without a vertex between them: ladders, straight and zigzag.
  for (const double lean : { 0.0, 0.4, 30.0 })
  {
    TestMesh input;
    constexpr Id count = 150;
    for (Id i = 0; i < count; ++i)
    {
      input.AddPoint(i, 0.0, 0.0);
      input.AddPoint(i + lean, 20.0, 0.0);
    }
    for (Id i = 0; i + 1 < count; ++i)
    {
      input.AddQuad(2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
    }
    const dgg::SurfaceMesh mesh = Build(input);
    for (const double accuracy : { 0.5, 0.05, 1e-3 })
    {
      ExpectTheorem(mesh, accuracy);
    }
  }
}

// Random meshes, broken and sound: no crash, no hang, the promise kept.

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

/// Sound but unpleasant: stretched, rough, refined at random.
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

TEST(GraphBuilderFuzz, Soups)
{
  for (std::uint64_t seed = 1; seed <= 400; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Id vertices = 3 + random.Index(20);
    ExpectSane(RandomSoup(vertices, 1 + random.Index(50), seed), 1e-6);
  }
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectSane(RandomSoup(80, 200, seed), 1e-6);
  }
}

TEST(GraphBuilderFuzz, CollapsedAndFlattenedMeshes)
{
  std::vector<TestMesh> meshes = FlattenedMeshes();
  for (std::uint64_t seed = 1; seed <= 25; ++seed)
  {
    meshes.push_back(CollapsedSphere(2, 1 + static_cast<Id>(2 * seed), seed));
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    SCOPED_TRACE(i);
    ExpectSane(meshes[i], 1e-6);
  }
}

}
