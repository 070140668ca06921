// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Options, limits, progress, and what the builder says about its memory.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::GraphConstruction;

}

TEST(GraphBuilderOptions, AccuracyAtTheLimits)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(1, 0.3, 1));
  for (const double accuracy : { dgg::MinimumAccuracy, dgg::MaximumAccuracy })
  {
    const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy);
    EXPECT_EQ(graph.Info.Accuracy, accuracy);
  }
}

TEST(GraphBuilderOptions, IsolatedPointsHaveEmptyRows)
{
  TestMesh input = Icosphere(2);
  const Id first = input.AddPoint(0.5, 0.5, 0.5);
  input.AddPoint(0.0, 0.0, 0.0);
  const dgg::GeodesicGraph graph = BuildGraph(Build(input), 0.05);
  const dgg::GeodesicGraph without = BuildGraph(Build(Icosphere(2)), 0.05);
  EXPECT_EQ(graph.View().GetNumberOfEdges(), without.View().GetNumberOfEdges());
  EXPECT_EQ(graph.Offsets[first], graph.Offsets[first + 1]);
  EXPECT_EQ(graph.Offsets[first + 1], graph.Offsets[first + 2]);
}

TEST(GraphBuilderOptions, WideLengths)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.3, 1));
  EXPECT_TRUE(BuildGraph(mesh, 1e-5).WideLengths.IsEmpty());
  const dgg::GeodesicGraph wide = BuildGraph(mesh, 0.9e-5);
  EXPECT_TRUE(wide.Lengths.IsEmpty());
  EXPECT_FALSE(wide.WideLengths.IsEmpty());
  // Without the rounding to floats, distances are the exact ones up to the accuracy.
  const DistanceTable exact = ExactTable(mesh);
  const RelativeError error = MeasureError(exact, GraphTable(BuildGraph(mesh, 1e-6).View()));
  EXPECT_LE(error.Largest, 1.0001e-6);
  // Floats are rounded up by up to 2^-23.
  const dgg::GeodesicGraph narrow = BuildGraph(mesh, 1e-5);
  EXPECT_GT(MeasureError(exact, GraphTable(narrow.View())).Largest, 1e-8);
}

TEST(GraphBuilderOptions, WideLengthsWhereFloatsEnd)
{
  const TestMesh input = NoisySphere(2, 0.3, 1);
  for (const double factor : { 1e-69, 1e-36, 1e36, 1e69 })
  {
    SCOPED_TRACE(factor);
    const dgg::SurfaceMesh mesh = Build(Scaled(input, factor));
    const dgg::GeodesicGraph graph = BuildGraph(mesh, 0.05);
    EXPECT_FALSE(graph.WideLengths.IsEmpty());
    ExpectWithin(ExactTable(mesh), GraphTable(graph.View()), 0.05, 0.0);
  }
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
        // How many candidates are pruned differs much from mesh to mesh.
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
  // The expected number of edges found from a vertex among vertices at random is 4.17 by the square
  // root of the accuracy, as long as the mesh has many more.
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

// The graph does not depend on how its caller runs loops: the same bytes for any number of threads,
// any ranges, in any order.

namespace
{
using dgg::Offset;
using Body = std::function<void(Offset, Offset)>;

/// Ranges from the last to the first.
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
  // More rows than are built in one go, so that rows meet those of earlier ones.
  ExpectSameForAllLoops(Plane(45, 40, 0.25, 1), 0.05, guaranteed);
  ExpectSameForAllLoops(NoisySphere(3, 0.4, 2), 0.01, guaranteed);
  ExpectSameForAllLoops(NoisySphere(3, 0.4, 2), 1e-6, guaranteed);
  // Ties.
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
  // Other accuracies and links in between leave no trace.
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
