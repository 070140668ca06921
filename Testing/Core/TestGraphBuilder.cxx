// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Guarantees of each construction, limits, options, and independence of threads.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

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

dgg::GeodesicGraph BuildNearest(const dgg::SurfaceMesh& mesh, Id neighbors)
{
  return BuildGraph(mesh, 0.01, [&](dgg::GraphOptions& options) {
    options.Construction = GraphConstruction::SaddleVertexGraph;
    options.NumberOfNeighbors = neighbors;
  });
}

/// Expects graph distances to be finite exactly within the components of the mesh.
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
      // Distances are never below the exact ones, and their error is at most ten times the
      // accuracy.
      ExpectWithin(exact, table, 10.0 * accuracy, SlackOf(mesh));
      const RelativeError error = MeasureError(exact, table);
      EXPECT_LT(error.Mean, accuracy);
      worst = std::max(worst, error.Largest / accuracy);
      EXPECT_LE(
        graph.View().GetNumberOfEdges(), BuildGraph(mesh, accuracy).View().GetNumberOfEdges());
    }
  }
  // Errors accumulate from relay to relay; the progress rule of Guaranteed prevents this.
  EXPECT_GT(worst, 1.0);
}

TEST(GraphBuilderConstructions, IndirectKeepsTheBound)
{
  // Not a theorem, but the bound holds on all of these meshes.
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
  // Most of the illuminated vertices are superfluous; the remaining edges are far fewer than those
  // of the direct rule.
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

TEST(GraphBuilderConstructions, MeshEdgesAreThere)
{
  for (const NamedMesh& named : AllMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const double accuracy : { 0.5, 1e-3 })
    {
      const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy);
      for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
      {
        if (!mesh.IsDropped(dgg::SurfaceMesh::Face(h)))
        {
          const dgg::Offset e = FindEdge(graph.View(), mesh.Origin(h), mesh.Destination(h));
          ASSERT_GE(e, 0) << h;
          ASSERT_LE(graph.View().Length(e), mesh.Length(h) * (1.0 + 2e-7)) << h;
        }
      }
    }
  }
}

TEST(GraphBuilderConstructions, AllNeighborsAreExact)
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

TEST(GraphBuilderConstructions, DegreeIsTheNumberOfNeighbors)
{
  // On a convex surface all shortest paths are straight. Each vertex has an edge to each of its
  // nearest vertices, and the union with the reverse edges adds more.
  const dgg::SurfaceMesh mesh = Build(Icosphere(3));
  for (const Id neighbors : { 6, 12, 30, 80 })
  {
    dgg::GraphStatistics statistics;
    const dgg::GeodesicGraph graph = BuildGraph(
      mesh, 0.01,
      [&](dgg::GraphOptions& options) {
        options.Construction = GraphConstruction::SaddleVertexGraph;
        options.NumberOfNeighbors = neighbors;
      },
      &statistics);
    const double found = static_cast<double>(statistics.OutEdges) / mesh.GetNumberOfVertices();
    EXPECT_GE(found, 0.9 * neighbors);
    EXPECT_LE(found, 1.25 * neighbors + 2.0);
    const double degree =
      static_cast<double>(graph.View().GetNumberOfEdges()) / mesh.GetNumberOfVertices();
    EXPECT_GE(degree, found);
    EXPECT_LE(degree, 1.5 * neighbors + 2.0);
  }
}

TEST(GraphBuilderConstructions, EdgesGoToTheNearest)
{
  // Every vertex closer than the K-th nearest one with a straight path is an edge. On a plane
  // without a reflex corner these are all vertices that no other vertex hides.
  const TestMesh input = Plane(12, 12, 0.25, 4);
  const dgg::SurfaceMesh mesh = Build(input);
  constexpr Id neighbors = 20;
  const dgg::GeodesicGraph graph = BuildNearest(mesh, neighbors);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    std::vector<double> distances;
    for (Id w = 0; w < mesh.GetNumberOfVertices(); ++w)
    {
      distances.push_back(EuclideanDistance(input, v, w));
    }
    std::vector<double> sorted = distances;
    std::sort(sorted.begin(), sorted.end());
    const double reach = sorted[neighbors]; // the first distance is that of v itself
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

// Limits of work and memory.

namespace
{
using dgg::SurfaceMesh;

SurfaceMesh ManyPages()
{
  std::vector<Id> unused;
  return Build(Book(6, 5, unused, 0.2, 1));
}

/// Expects an error whose message names the effective remedies and no others.
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

/// Returns the sides of a prism without inner points, `factor` times as tall as PrismSide().
TestMesh TallPrism(Id sides, double factor)
{
  TestMesh prism = PrismSide(sides, 1, 1);
  for (std::size_t z = 2; z < prism.Points.size(); z += 3)
  {
    prism.Points[z] *= factor;
  }
  return prism;
}

constexpr std::size_t Unlimited = dgg::DefaultWindowLimit;

/// A mesh that exceeds the limits of work or memory, and its error message.
struct Refusal
{
  SurfaceMesh Mesh;
  std::size_t WindowLimit;
  GraphConstruction Construction;
  std::vector<std::string> Has;
  std::vector<std::string> HasNot;
};
}

TEST(GraphBuilderLimits, RefusalsNameTheRemedy)
{
  std::vector<Id> unused;
  const SurfaceMesh pages = ManyPages();
  const SurfaceMesh sphere = Build(NoisySphere(3, 0.2, 1));
  const std::string accuracy = "larger Accuracy (now 0.004)";
  const std::string neighbors = "smaller NumberOfNeighbors (now 77)";
  for (const Refusal& refusal : {
         Refusal{ pages, 40, GraphConstruction::Guaranteed, { "vertex", "non-manifold", accuracy },
           { "NumberOfNeighbors" } },
         Refusal{ pages, 40, GraphConstruction::OneRelay, { "vertex", "non-manifold", accuracy },
           { "NumberOfNeighbors" } },
         Refusal{ pages, 40, GraphConstruction::Indirect, { "vertex", "non-manifold", accuracy },
           { "NumberOfNeighbors" } },
         Refusal{ pages, 40, GraphConstruction::SaddleVertexGraph,
           { "vertex", "non-manifold", neighbors }, { "Accuracy" } },
         Refusal{ sphere, 100, GraphConstruction::Guaranteed, { "vertex", accuracy },
           { "manifold", "NumberOfNeighbors" } },
         Refusal{ sphere, 100, GraphConstruction::SaddleVertexGraph, { "vertex", neighbors },
           { "manifold", "Accuracy" } },
         // Windows turn around the spine, or run along such long triangles, so often that no rule
         // helps.
         Refusal{ Build(Book(800, 3, unused)), Unlimited, GraphConstruction::Guaranteed,
           { "non-manifold edges", "twenty times", "inner walls", accuracy }, {} },
         Refusal{ Build(TallPrism(8000, 8000)), Unlimited, GraphConstruction::Guaranteed,
           { "long triangles", "twenty times", "Split", accuracy }, { "manifold" } },
       })
  {
    dgg::GraphOptions options;
    options.Construction = refusal.Construction;
    options.Accuracy = 0.004;
    options.NumberOfNeighbors = 77;
    const dgg::GraphBuilder builder(refusal.Mesh, refusal.WindowLimit);
    dgg::GraphEstimate estimate;
    ExpectMessage(builder.Estimate(options, estimate), refusal.Has, refusal.HasNot);
    EXPECT_EQ(estimate.Edges, 0.0);
    EXPECT_EQ(estimate.Peak, 0.0);
    if (refusal.WindowLimit < Unlimited)
    {
      dgg::GeodesicGraph graph = BuildGraph(Build(SingleTriangle()), 0.1);
      ExpectMessage(builder.Build(options, graph), refusal.Has, refusal.HasNot);
      EXPECT_EQ(graph.GetMemorySize(), 0u);
    }
  }
}

// Propagation ends for windows that run over two layers in the same position or around a tall tube:
// the work for a vertex is a few windows per face, and the theorem holds.
TEST(GraphBuilderLimits, WorkIsBounded)
{
  struct Case
  {
    TestMesh Input;
    double Accuracy;
    double WindowsPerFace;
  };
  for (const Case& c : { Case{ WeldedPlates(3, 12, 40, 3), 0.01, 8.0 },
         Case{ WeldedPlates(4, 8, 24, 1), 0.01, 8.0 }, Case{ TallPrism(150, 900.0), 0.1, 2.5 } })
  {
    const SurfaceMesh mesh = Build(c.Input);
    dgg::GraphStatistics statistics;
    const dgg::GeodesicGraph graph = BuildGraph(mesh, c.Accuracy, nullptr, &statistics);
    const double size = static_cast<double>(mesh.GetNumberOfVertices()) * mesh.GetNumberOfFaces();
    EXPECT_LT(static_cast<double>(statistics.Windows), c.WindowsPerFace * size);
    ExpectWithin(ExactTable(mesh), GraphTable(graph.View()), c.Accuracy, 0.0);
  }
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
        ExpectMessage(status, { "surface point", "larger Accuracy" }, { "NumberOfNeighbors" });
        EXPECT_NE(bool(Says(status, "manifold")), isManifold);
      }
    }
    EXPECT_GT(refused, 10);
    EXPECT_GT(complete, 5);
  }
}

TEST(GraphBuilderLimits, EveryThreadCounts)
{
  // Each thread stores a search state of all vertices.
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

TEST(GraphBuilderOptions, WideLengths)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.3, 1));
  EXPECT_TRUE(BuildGraph(mesh, 1e-5).WideLengths.IsEmpty());
  const dgg::GeodesicGraph wide = BuildGraph(mesh, 0.9e-5);
  EXPECT_TRUE(wide.Lengths.IsEmpty());
  EXPECT_FALSE(wide.WideLengths.IsEmpty());
  // Without rounding to floats, distances are exact up to the accuracy.
  const DistanceTable exact = ExactTable(mesh);
  const RelativeError error = MeasureError(exact, GraphTable(BuildGraph(mesh, 1e-6).View()));
  EXPECT_LE(error.Largest, 1.0001e-6);
  // Floats are rounded up by at most 2^-23.
  const dgg::GeodesicGraph narrow = BuildGraph(mesh, 1e-5);
  EXPECT_GT(MeasureError(exact, GraphTable(narrow.View())).Largest, 1e-8);
}

TEST(GraphBuilderOptions, EstimateIsClose)
{
  for (const NamedMesh& named : { NamedMesh{ "Plane", Plane(60, 50, 0.25, 1) },
         NamedMesh{ "Sphere", NoisySphere(4, 0.2, 2) }, NamedMesh{ "Rough", Terrain(50, 2.0, 3) },
         NamedMesh{ "Torus", WithNoise(Torus(80, 40), 0.01, 4) },
         NamedMesh{ "Ellipsoid", Ellipsoid(4, 6.0) }, NamedMesh{ "Grid", Plane(55, 55) },
         NamedMesh{ "Box", Box(16, 18, 22, 1.0, 1.0, 1.0, 0.2, 5) } })
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    ASSERT_GE(mesh.GetNumberOfVertices(), 2000);
    const dgg::GraphBuilder builder(mesh);
    for (const auto construction : AllConstructions())
    {
      for (const double accuracy : { 0.1, 0.01, 1e-3 })
      {
        if (construction == GraphConstruction::Indirect && accuracy < 0.01)
        {
          continue; // too many candidates for a test
        }
        dgg::GraphOptions options;
        options.Construction = construction;
        options.Accuracy = accuracy;
        dgg::GraphEstimate estimate;
        ASSERT_TRUE(builder.Estimate(options, estimate).IsOk());
        dgg::GeodesicGraph graph;
        ASSERT_TRUE(builder.Build(options, graph).IsOk());
        const auto edges = static_cast<double>(graph.View().GetNumberOfEdges());
        const std::string what = named.Name + ", construction " +
          std::to_string(static_cast<int>(construction)) + ", accuracy " + std::to_string(accuracy);
        // The fraction of pruned candidates varies strongly between meshes.
        const double tolerance = construction == GraphConstruction::Indirect ? 0.5 : 0.25;
        EXPECT_NEAR(estimate.Edges / edges, 1.0, tolerance) << what;
        EXPECT_NEAR(estimate.Memory / static_cast<double>(graph.GetMemorySize()), 1.0, tolerance)
          << what;
      }
    }
  }
}

TEST(GraphBuilderOptions, DegreeFollowsTheLaw)
{
  // The expected number of edges found from a vertex among random vertices is 4.17 divided by the
  // square root of the accuracy, if the mesh has many more vertices.
  for (const double accuracy : { 0.05, 0.02, 0.01, 0.004 })
  {
    for (const NamedMesh& named :
      { NamedMesh{ "Plane", Plane(90, 90, 0.28, 1) }, NamedMesh{ "Terrain", Terrain(80, 0.2, 2) } })
    {
      SCOPED_TRACE(named.Name);
      const dgg::SurfaceMesh mesh = Build(named.Mesh);
      dgg::GraphStatistics statistics;
      BuildGraph(mesh, accuracy, nullptr, &statistics);
      const double degree = static_cast<double>(statistics.OutEdges) / mesh.GetNumberOfVertices();
      const double law = 4.17 / std::sqrt(accuracy);
      EXPECT_NEAR(degree / law, 1.0, 0.4) << "accuracy " << accuracy;
    }
  }
}

// The graph does not depend on the execution of loops by the caller: it is identical byte by byte
// for any number of threads and any ranges, in any order.

namespace
{
using dgg::Offset;
using Body = std::function<void(Offset, Offset)>;

/// Runs ranges from the last to the first.
void Backwards(Offset total, Offset /*grain*/, const Body& body)
{
  constexpr Offset step = 7;
  for (Offset end = total; end > 0; end -= std::min(end, step))
  {
    body(std::max<Offset>(0, end - step), end);
  }
}

struct Loop
{
  std::string Name;
  dgg::ParallelFor Run;
};

std::vector<Loop> Loops()
{
  return { { "one thread", WithThreads(1, 0) }, { "two threads", WithThreads(2, 0) },
    { "seven threads", WithThreads(7, 0) }, { "ranges of one", WithThreads(3, 1) },
    { "ranges of 37", WithThreads(2, 37) }, { "one range", WithThreads(2, 1 << 30) },
    { "backwards", Backwards } };
}

void ExpectSameForAllLoops(const TestMesh& input, double accuracy, dgg::GraphConstruction rule)
{
  const dgg::SurfaceMesh mesh = Build(input);
  const auto build = [&](const dgg::ParallelFor& loop) {
    return BuildGraph(mesh, accuracy, [&](dgg::GraphOptions& options) {
      options.Construction = rule;
      options.NumberOfNeighbors = 20;
      options.Parallel = loop;
    });
  };
  const dgg::GeodesicGraph expected = build(nullptr);
  ASSERT_GT(expected.View().GetNumberOfEdges(), 0);
  for (const Loop& loop : Loops())
  {
    SCOPED_TRACE(loop.Name);
    ExpectSameGraph(expected, build(loop.Run));
  }
}
}

TEST(GraphBuilderThreads, SameGraph)
{
  constexpr auto guaranteed = dgg::GraphConstruction::Guaranteed;
  // More rows than are built in one batch, so that rows meet rows of earlier batches.
  ExpectSameForAllLoops(Plane(45, 40, 0.25, 1), 0.05, guaranteed);
  ExpectSameForAllLoops(NoisySphere(3, 0.4, 2), 0.01, guaranteed);
  ExpectSameForAllLoops(NoisySphere(3, 0.4, 2), 1e-6, guaranteed);
  // Regular meshes with ties.
  ExpectSameForAllLoops(Plane(40, 40), 0.02, guaranteed);
  ExpectSameForAllLoops(Cube(12), 0.02, guaranteed);
  ExpectSameForAllLoops(Icosphere(3), 0.02, guaranteed);
  for (const NamedMesh& named : DefectMeshes())
  {
    SCOPED_TRACE(named.Name);
    ExpectSameForAllLoops(named.Mesh, 0.03, guaranteed);
  }
}

TEST(GraphBuilderThreads, BuilderMayBeUsedAgain)
{
  // Builds with other accuracies and link queries in between have no effect.
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.4, 2));
  const dgg::GraphBuilder builder(mesh);
  dgg::GraphOptions options;
  dgg::GeodesicGraph first;
  ASSERT_TRUE(builder.Build(options, first).IsOk());
  dgg::GeodesicGraph other;
  options.Accuracy = 0.2;
  ASSERT_TRUE(builder.Build(options, other).IsOk());
  EXPECT_LT(other.View().GetNumberOfEdges(), first.View().GetNumberOfEdges());
  std::vector<dgg::GraphLink> links;
  std::vector<double> direct;
  for (const dgg::SurfacePoint& point : RandomSurfacePoints(mesh, 10, 4))
  {
    ASSERT_TRUE(builder.Link(point, 0.3, {}, links, direct).IsOk());
  }
  options.Accuracy = 0.01;
  dgg::GeodesicGraph again;
  ASSERT_TRUE(builder.Build(options, again).IsOk());
  ExpectSameGraph(first, again);
}
}
