// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// What may be done to a mesh without touching the promise of its graph.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include <cmath>
#include <string>
#include <vector>

namespace dggtest
{
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
  for (Id i = 0; i < count; ++i)
  {
    ids[i] = i;
  }
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

TEST(GraphTheoremInvariance, RigidMotion)
{
  const TestMesh input = NoisySphere(2, 0.3, 6);
  const DistanceTable exact = ExactTable(Build(input));
  const dgg::SurfaceMesh moved = Build(MovedRigidly(input, 1.1, { { 1.0, -2.0, 0.5 } }));
  for (const double accuracy : { 0.1, 0.01 })
  {
    ExpectWithinOf(exact, moved, Identity(exact.GetSize()), accuracy);
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
