// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The graph does not depend on how its caller runs loops: the same bytes for any number of threads,
// any ranges, in any order.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace dggtest
{
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
  // More rows than are built in one go, so that rows meet those of earlier ones.
  ExpectSameForAllLoops(Plane(45, 40, 0.25, 1), 0.05, dgg::GraphConstruction::Guaranteed);
  ExpectSameForAllLoops(NoisySphere(3, 0.4, 2), 0.01, dgg::GraphConstruction::Guaranteed);
  ExpectSameForAllLoops(NoisySphere(3, 0.4, 2), 1e-6, dgg::GraphConstruction::Guaranteed);
}

TEST(GraphBuilderThreads, SameGraphWithTies)
{
  ExpectSameForAllLoops(Plane(40, 40), 0.02, dgg::GraphConstruction::Guaranteed);
  ExpectSameForAllLoops(Cube(12), 0.02, dgg::GraphConstruction::Guaranteed);
  ExpectSameForAllLoops(Icosphere(3), 0.02, dgg::GraphConstruction::Guaranteed);
}

TEST(GraphBuilderThreads, SameGraphWithDefects)
{
  for (const NamedMesh& named : DefectMeshes())
  {
    SCOPED_TRACE(named.Name);
    ExpectSameForAllLoops(named.Mesh, 0.03, dgg::GraphConstruction::Guaranteed);
  }
}

TEST(GraphBuilderThreads, SameGraphOfOtherConstructions)
{
  for (const auto rule : { dgg::GraphConstruction::OneRelay, dgg::GraphConstruction::Indirect,
         dgg::GraphConstruction::SaddleVertexGraph })
  {
    SCOPED_TRACE(static_cast<int>(rule));
    ExpectSameForAllLoops(NoisySphere(3, 0.4, 3), 0.05, rule);
    ExpectSameForAllLoops(Plane(36, 36), 0.1, rule);
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
