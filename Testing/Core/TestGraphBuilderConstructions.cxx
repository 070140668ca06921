// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The constructions to compare with: what each of them promises.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::GraphConstruction;

std::vector<NamedMesh> MeshesUpTo(Id largest)
{
  std::vector<NamedMesh> meshes = AllMeshes();
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(),
                 [=](const NamedMesh& m) { return m.Mesh.GetNumberOfVertices() > largest; }),
    meshes.end());
  return meshes;
}

dgg::GeodesicGraph BuildNearest(const dgg::SurfaceMesh& mesh, Id neighbours)
{
  return BuildGraph(mesh, 0.01, [&](dgg::GraphOptions& options) {
    options.Construction = GraphConstruction::SaddleVertexGraph;
    options.NumberOfNeighbors = neighbours;
  });
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
  for (const NamedMesh& named : MeshesUpTo(600))
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
  for (const NamedMesh& named : MeshesUpTo(600))
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
  for (const NamedMesh& named : MeshesUpTo(200))
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

// Where building ends: light that goes on and on, and memory, which is to be known beforehand.

namespace
{
using dgg::GraphConstruction;
using dgg::SurfaceMesh;

/// Expect a refusal that names the remedies, and none that does not help.
void ExpectMessage(const dgg::Status& status, const std::vector<std::string>& has,
  const std::vector<std::string>& hasNot)
{
  EXPECT_EQ(status.GetCode(), dgg::Status::Code::InvalidInput);
  for (const std::string& part : has)
  {
    EXPECT_TRUE(Says(status, part));
  }
  for (const std::string& part : hasNot)
  {
    EXPECT_FALSE(Says(status, part));
  }
}

/// Expect that neither a graph nor an estimate comes out of a mesh with so few cones.
void ExpectRefused(const SurfaceMesh& mesh, std::size_t windowLimit,
  const dgg::GraphOptions& options, const std::vector<std::string>& has,
  const std::vector<std::string>& hasNot)
{
  const dgg::GraphBuilder builder(mesh, windowLimit);
  dgg::GraphEstimate estimate;
  ExpectMessage(builder.Estimate(options, estimate), has, hasNot);
  EXPECT_EQ(estimate.Edges, 0.0);
  EXPECT_EQ(estimate.Peak, 0.0);
  dgg::GeodesicGraph graph = BuildGraph(Build(SingleTriangle()), 0.1);
  ExpectMessage(builder.Build(options, graph), has, hasNot);
  EXPECT_EQ(graph.GetMemorySize(), 0u);
}

SurfaceMesh ManyPages()
{
  std::vector<Id> unused;
  return Build(Book(6, 5, unused, 0.2, 1));
}

/// The sides of a prism without points inside, so many times as tall as PrismSide().
TestMesh TallPrism(Id sides, double factor)
{
  TestMesh prism = PrismSide(sides, 1, 1);
  for (std::size_t z = 2; z < prism.Points.size(); z += 3)
  {
    prism.Points[z] *= factor;
  }
  return prism;
}

dgg::GraphOptions OptionsOf(GraphConstruction construction)
{
  dgg::GraphOptions options;
  options.Construction = construction;
  options.Accuracy = 0.004;
  options.NumberOfNeighbors = 77;
  return options;
}
}

TEST(GraphBuilderLimits, WindowsAmongNonManifoldEdges)
{
  const SurfaceMesh mesh = ManyPages();
  for (const auto construction :
    { GraphConstruction::Guaranteed, GraphConstruction::OneRelay, GraphConstruction::Indirect })
  {
    ExpectRefused(mesh, 40, OptionsOf(construction),
      { "vertex", "non-manifold edges", "larger accuracy (it is 0.004)" }, { "neighbours" });
  }
  ExpectRefused(mesh, 40, OptionsOf(GraphConstruction::SaddleVertexGraph),
    { "vertex", "non-manifold edges", "smaller number of neighbours (it is 77)" }, { "accuracy" });
}

// Copies of a cone that run over two sheets in one place do not add up: the work for a vertex stays
// that of a few windows a face, and the theorem holds.
TEST(GraphBuilderLimits, WorkAmongNonManifoldEdgesIsBounded)
{
  for (const auto& plates : { WeldedPlates(3, 12, 40, 3), WeldedPlates(4, 8, 24, 1) })
  {
    const SurfaceMesh mesh = Build(plates);
    dgg::GraphOptions options;
    options.Accuracy = 0.01;
    dgg::GeodesicGraph graph;
    dgg::GraphStatistics statistics;
    ASSERT_TRUE(dgg::GraphBuilder(mesh).Build(options, graph, &statistics).IsOk());
    const double size = static_cast<double>(mesh.GetNumberOfVertices()) * mesh.GetNumberOfFaces();
    EXPECT_LT(static_cast<double>(statistics.Windows), 8.0 * size);
    ExpectWithin(ExactTable(mesh), GraphTable(graph.View()), options.Accuracy, 0.0);
  }
}

// So many ways around that no rule helps: refused after a bounded amount of work.
TEST(GraphBuilderLimits, RefusesAfterBoundedWork)
{
  std::vector<Id> unused;
  const SurfaceMesh mesh = Build(Book(800, 3, unused));
  dgg::GraphOptions options;
  options.Accuracy = 0.01;
  const dgg::GraphBuilder builder(mesh);
  dgg::GraphEstimate estimate;
  ExpectMessage(builder.Estimate(options, estimate),
    { "non-manifold edges", "twenty times", "inner walls", "larger accuracy (it is 0.01)" }, {});
}

// A wall of long triangles, of which each vertex sees half.
TEST(GraphBuilderLimits, RefusesManyLongTriangles)
{
  dgg::GraphOptions options;
  options.Accuracy = 0.01;
  for (const Id sides : { 800, 8000 })
  {
    const SurfaceMesh mesh = Build(TallPrism(sides, sides));
    dgg::GraphEstimate estimate;
    const dgg::Status status = dgg::GraphBuilder(mesh).Estimate(options, estimate);
    EXPECT_EQ(status.IsOk(), sides < 8000);
    if (sides == 8000)
    {
      ExpectMessage(status,
        { "long triangles", "twenty times", "split", "larger accuracy (it is 0.01)" },
        { "manifold" });
    }
  }
}

// Windows around a tall tube without points inside meet themselves after a turn, and end there.
TEST(GraphBuilderLimits, WindowsAroundATube)
{
  constexpr Id sides = 150;
  const SurfaceMesh mesh = Build(TallPrism(sides, 6.0 * sides));
  dgg::GraphOptions options;
  options.Accuracy = 0.1;
  dgg::GeodesicGraph graph;
  dgg::GraphStatistics statistics;
  ASSERT_TRUE(dgg::GraphBuilder(mesh).Build(options, graph, &statistics).IsOk());
  const double size = static_cast<double>(mesh.GetNumberOfVertices()) * mesh.GetNumberOfFaces();
  EXPECT_LT(static_cast<double>(statistics.Windows), 2.5 * size);
  ExpectWithin(ExactTable(mesh), GraphTable(graph.View()), options.Accuracy, 0.0);
}

TEST(GraphBuilderLimits, WindowsOnManifoldMeshes)
{
  // Nothing there is the fault of non-manifold edges.
  const SurfaceMesh mesh = Build(NoisySphere(3, 0.2, 1));
  ExpectRefused(mesh, 100, OptionsOf(GraphConstruction::Guaranteed),
    { "vertex", "larger accuracy (it is 0.004)" }, { "manifold", "neighbours" });
  ExpectRefused(mesh, 100, OptionsOf(GraphConstruction::SaddleVertexGraph),
    { "vertex", "smaller number of neighbours (it is 77)" }, { "manifold", "accuracy" });
}

TEST(GraphBuilderLimits, LinksAreCompleteOrRefused)
{
  for (const SurfaceMesh& mesh : { ManyPages(), Build(NoisySphere(3, 0.2, 1)) })
  {
    const bool isManifold = mesh.GetNumberOfVertices() > 400;
    const dgg::GraphBuilder unlimited(mesh);
    const dgg::GraphBuilder limited(mesh, 60);
    int refused = 0;
    int complete = 0;
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 30, 2))
    {
      for (const double accuracy : { 0.5, 0.004 })
      {
        std::vector<dgg::GraphLink> expected;
        std::vector<double> direct;
        ASSERT_TRUE(unlimited.Link(point, accuracy, { point }, expected, direct).IsOk());
        std::vector<dgg::GraphLink> links(3);
        const dgg::Status status = limited.Link(point, accuracy, { point }, links, direct);
        if (status.IsOk())
        {
          ++complete;
          EXPECT_EQ(links.size(), expected.size());
          continue;
        }
        ++refused;
        EXPECT_TRUE(links.empty());
        EXPECT_TRUE(direct.empty());
        ExpectMessage(status, { "surface point", "larger accuracy" }, { "neighbours" });
        EXPECT_NE(bool(Says(status, "manifold")), isManifold);
      }
    }
    EXPECT_GT(refused, 10);
    EXPECT_GT(complete, 5);
  }
}

TEST(GraphBuilderLimits, EveryThreadCounts)
{
  // What is known of all vertices, once a thread.
  const SurfaceMesh mesh = Build(Plane(100, 100, 0.2, 1));
  const dgg::GraphBuilder builder(mesh);
  dgg::GraphOptions options;
  options.Accuracy = 0.1;
  const auto peakOf = [&](int threads) {
    options.NumberOfThreads = threads;
    dgg::GraphEstimate estimate;
    EXPECT_TRUE(builder.Estimate(options, estimate).IsOk());
    return estimate.Peak;
  };
  EXPECT_GE(peakOf(17) - peakOf(1), 16 * 24.0 * mesh.GetNumberOfVertices());
  EXPECT_EQ(peakOf(1), peakOf(0));
  EXPECT_EQ(peakOf(1), peakOf(-5));
}
}
