// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Where building ends: light that goes on and on, and memory, which is to be known beforehand.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include <string>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::GraphConstruction;
using dgg::SurfaceMesh;

/// Expect a refusal that names the remedies, and none that does not help.
void ExpectMessage(const dgg::Status& status, const std::vector<std::string>& has,
  const std::vector<std::string>& hasNot)
{
  const std::string& message = status.GetMessage();
  EXPECT_EQ(status.GetCode(), dgg::Status::Code::InvalidInput);
  for (const std::string& part : has)
  {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  for (const std::string& part : hasNot)
  {
    EXPECT_EQ(message.find(part), std::string::npos) << message;
  }
}

/// Expect that neither a graph nor an estimate comes out of a mesh with so few windows.
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

dgg::GraphOptions OptionsOf(GraphConstruction construction)
{
  dgg::GraphOptions options;
  options.Construction = construction;
  options.Accuracy = 0.004;
  options.NumberOfNeighbors = 77;
  return options;
}
}

TEST(GraphBuilderLimits, LightAmongNonManifoldEdges)
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

// Copies of a window that run over two sheets in one place do not add up: the work for a vertex
// stays that of a few windows a face, and the theorem holds.
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
    TestMesh wall = PrismSide(sides, 1, 1);
    for (std::size_t z = 2; z < wall.Points.size(); z += 3)
    {
      wall.Points[z] *= sides;
    }
    const SurfaceMesh mesh = Build(wall);
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

TEST(GraphBuilderLimits, LightOnManifoldMeshes)
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
        EXPECT_EQ(status.GetMessage().find("manifold") == std::string::npos, isManifold);
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
