// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The constructions to compare with: what each of them promises.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::GraphConstruction;

std::vector<NamedMesh> AllMeshes(Id largest)
{
  std::vector<NamedMesh> meshes;
  for (const std::vector<NamedMesh>& some : { SoundMeshes(), DefectMeshes() })
  {
    for (const NamedMesh& named : some)
    {
      if (named.Mesh.GetNumberOfVertices() <= largest)
      {
        meshes.push_back(named);
      }
    }
  }
  return meshes;
}

dgg::GeodesicGraph BuildNearest(const dgg::SurfaceMesh& mesh, Id neighbours)
{
  return BuildGraph(mesh, 0.01, [&](dgg::GraphOptions& options) {
    options.Construction = GraphConstruction::SaddleVertexGraph;
    options.NumberOfNeighbors = neighbours;
  });
}

double SlackOf(const dgg::SurfaceMesh& mesh)
{
  return 10.0 * mesh.GetNumberOfMollifiedFaces() * mesh.GetMollification();
}

/// Expect graph distances to be finite exactly within the components of the mesh.
void ExpectConnected(const dgg::SurfaceMesh& mesh, const dgg::GraphView& graph)
{
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  std::vector<bool> isSeen(count, false);
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    if (isSeen[components[v]])
    {
      continue;
    }
    isSeen[components[v]] = true;
    const std::vector<double> distances = GraphDistances(graph, v);
    for (Id w = 0; w < graph.NumberOfVertices; ++w)
    {
      ASSERT_EQ(distances[w] < dgg::Infinity, components[w] == components[v]) << v << " to " << w;
    }
  }
}
}

TEST(GraphBuilderConstructions, OneRelayIsSmallerButBoundsOnlyTheMean)
{
  double worst = 0.0;
  for (const NamedMesh& named : AllMeshes(600))
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const DistanceTable exact = ExactTable(mesh);
    for (const double accuracy : { 0.1, 0.01 })
    {
      const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy, GraphConstruction::OneRelay);
      EXPECT_FALSE(graph.Info.IsGuaranteed());
      ExpectConnected(mesh, graph.View());
      const DistanceTable table = GraphTable(graph.View());
      // Never below the exact distance, and not absurdly above.
      ExpectWithin(exact, table, 10.0 * accuracy, SlackOf(mesh));
      const RelativeError error = MeasureError(exact, table);
      EXPECT_LT(error.Mean, accuracy);
      worst = std::max(worst, error.Largest / accuracy);
      EXPECT_LE(
        graph.View().GetNumberOfEdges(), BuildGraph(mesh, accuracy).View().GetNumberOfEdges());
    }
  }
  EXPECT_GT(worst, 1.0); // on some of these meshes, not only where one looks for it
}

TEST(GraphBuilderConstructions, OneRelayBreaksTheBound)
{
  // What the progress rule is for: errors that add up from relay to relay. If this no longer fails,
  // the two rules have become one.
  const dgg::SurfaceMesh mesh = Build(Plane(24, 24, 0.25, 1));
  const double accuracy = 0.02;
  const auto measure = [&](GraphConstruction construction) {
    const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy, construction);
    return MeasureError(ExactTable(mesh), GraphTable(graph.View())).Largest / accuracy;
  };
  EXPECT_LE(measure(GraphConstruction::Guaranteed), 1.0 + 1e-4);
  EXPECT_GT(measure(GraphConstruction::OneRelay), 1.05);
}

TEST(GraphBuilderConstructions, IndirectKeepsTheBound)
{
  // Not a theorem, but so it is on all of these.
  for (const NamedMesh& named : AllMeshes(600))
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const DistanceTable exact = ExactTable(mesh);
    for (const double accuracy : { 0.5, 0.1, 0.01, 1e-3 })
    {
      const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy, GraphConstruction::Indirect);
      ExpectWithin(exact, GraphTable(graph.View()), accuracy, SlackOf(mesh));
    }
  }
}

TEST(GraphBuilderConstructions, IndirectPrunes)
{
  // Of the vertices lit, most are superfluous; what is left is no more than the direct rule keeps,
  // by much.
  const dgg::SurfaceMesh mesh = Build(Plane(30, 30, 0.25, 1));
  dgg::GraphStatistics statistics;
  const dgg::GeodesicGraph indirect = BuildGraph(
    mesh, 0.02,
    [](dgg::GraphOptions& options) { options.Construction = GraphConstruction::Indirect; },
    &statistics);
  const auto edges = static_cast<double>(indirect.View().GetNumberOfEdges());
  const auto direct = static_cast<double>(BuildGraph(mesh, 0.02).View().GetNumberOfEdges());
  EXPECT_LT(edges, 0.5 * static_cast<double>(statistics.OutEdges));
  EXPECT_NEAR(edges / direct, 1.0, 0.3);
}

TEST(GraphBuilderConstructions, AllNeighboursAreExact)
{
  for (const NamedMesh& named : AllMeshes(200))
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    const dgg::GeodesicGraph graph = BuildNearest(mesh, mesh.GetNumberOfVertices());
    EXPECT_FALSE(graph.Info.IsGuaranteed());
    ExpectWithin(ExactTable(mesh), GraphTable(graph.View()), 1e-9, SlackOf(mesh));
  }
}

TEST(GraphBuilderConstructions, DegreeIsTheNumberOfNeighbours)
{
  // On a convex surface everything is seen straight, so that a vertex has an edge to each of its
  // nearest vertices, and the union with the edges that others have to it adds some.
  const dgg::SurfaceMesh mesh = Build(Icosphere(3));
  for (const Id neighbours : { 6, 12, 30, 80 })
  {
    dgg::GraphStatistics statistics;
    const dgg::GeodesicGraph graph = BuildGraph(
      mesh, 0.01,
      [&](dgg::GraphOptions& options) {
        options.Construction = GraphConstruction::SaddleVertexGraph;
        options.NumberOfNeighbors = neighbours;
      },
      &statistics);
    const double found = static_cast<double>(statistics.OutEdges) / mesh.GetNumberOfVertices();
    EXPECT_GE(found, 0.9 * neighbours);
    EXPECT_LE(found, 1.25 * neighbours + 2.0);
    const double degree =
      static_cast<double>(graph.View().GetNumberOfEdges()) / mesh.GetNumberOfVertices();
    EXPECT_GE(degree, found);
    EXPECT_LE(degree, 1.5 * neighbours + 2.0);
  }
}

TEST(GraphBuilderConstructions, EdgesGoToTheNearest)
{
  // Whatever is nearer than the K-th nearest vertex and seen straight is an edge: on a plane
  // without a reflex corner, that is everything that no vertex hides.
  const TestMesh input = Plane(12, 12, 0.25, 4);
  const dgg::SurfaceMesh mesh = Build(input);
  constexpr Id neighbours = 20;
  const dgg::GeodesicGraph graph = BuildNearest(mesh, neighbours);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    std::vector<double> distances;
    for (Id w = 0; w < mesh.GetNumberOfVertices(); ++w)
    {
      distances.push_back(EuclideanDistance(input, v, w));
    }
    std::vector<double> sorted = distances;
    std::sort(sorted.begin(), sorted.end());
    const double reach = sorted[neighbours]; // the first one is v itself
    const bool isInside = mesh.Kind(v) != dgg::VertexKind::Boundary;
    for (Id w = 0; w < mesh.GetNumberOfVertices(); ++w)
    {
      const bool isOnRim = mesh.Kind(w) == dgg::VertexKind::Boundary;
      if (w != v && distances[w] < reach * (1.0 - 1e-9) && (isInside || !isOnRim))
      {
        EXPECT_GE(FindEdge(graph.View(), v, w), 0) << v << " to " << w;
      }
    }
  }
}

TEST(GraphBuilderConstructions, FewNeighboursMayNotConnect)
{
  // One neighbour each: pairs of vertices, not a connected graph. Enough neighbours to hold those
  // around a vertex connect everything.
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.2, 5));
  const dgg::GeodesicGraph one = BuildNearest(mesh, 1);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_GT(one.Offsets[v + 1], one.Offsets[v]) << v;
  }
  const std::vector<double> distances = GraphDistances(one.View(), 0);
  EXPECT_EQ(*std::max_element(distances.begin(), distances.end()), dgg::Infinity);

  const DistanceTable exact = ExactTable(mesh);
  double last = dgg::Infinity;
  for (const Id neighbours : { 12, 25, 50, 100 })
  {
    const dgg::GeodesicGraph graph = BuildNearest(mesh, neighbours);
    ExpectConnected(mesh, graph.View());
    const DistanceTable table = GraphTable(graph.View());
    ExpectWithin(exact, table, 0.5, 0.0);
    const double mean = MeasureError(exact, table).Mean;
    EXPECT_LT(mean, last);
    last = mean;
  }
  EXPECT_LT(last, 1e-3);
}
}
