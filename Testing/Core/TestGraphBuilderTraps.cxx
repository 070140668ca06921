// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes made to catch the builder at its tests of what is covered: ties, costs without progress,
// light that comes back to where it started, tips that it turns around for long.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

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

TEST(GraphBuilderTraps, AccuracyOfTies)
{
  // Regular meshes, where rays pass through vertices and many ways are equally long.
  for (const double accuracy : { 0.5, 0.25, 0.125, 1.0 / 3.0, 1e-6 })
  {
    SCOPED_TRACE(accuracy);
    ExpectTheorem(Build(Plane(12, 12)), accuracy);
    ExpectTheorem(Build(Cube(5)), accuracy);
    ExpectTheorem(Build(PrismSide(4, 3, 6)), accuracy);
    ExpectTheorem(Build(Subdivided(Octahedron(), 4)), accuracy);
    ExpectTheorem(Build(FlatTorus(6.0, 0.0, 6.0, 6, 6, false)), accuracy);
    std::vector<bool> unused;
    ExpectTheorem(Build(DoublyCoveredPolygon(4, 4, unused)), accuracy);
  }
}

TEST(GraphBuilderTraps, SmallestAccuracyIsExact)
{
  for (const NamedMesh& named : { NamedMesh{ "Terrain", Terrain(10, 2.0, 1) },
         NamedMesh{ "Sphere", NoisySphere(2, 0.4, 2) }, NamedMesh{ "Cube", Cube(4, 0.2, 3) },
         NamedMesh{ "Prism", PrismSide(5, 2, 6, 0.2, 4) }, NamedMesh{ "Torus", Torus(14, 9) } })
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const DistanceTable exact = ExactTable(mesh);
    const RelativeError error = MeasureError(exact, GraphTable(BuildGraph(mesh, 1e-6).View()));
    EXPECT_LE(error.Largest, 2e-6);
    ExpectTheorem(mesh, 1e-6);
  }
}
}
