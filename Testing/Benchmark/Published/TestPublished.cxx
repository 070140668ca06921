// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CandidateGraph.h"
#include "GeneratedMesh.h"
#include "LabelQueue.h"
#include "PseudoVertices.h"
#include "dggGraphBuilder.h"
#include "dggGraphSearch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr double Accuracy = 0.01;

class Published : public ::testing::Test
{
protected:
  void SetUp() override { this->Use(BumpySphere(3)); }

  void Use(const MeshArrays& arrays)
  {
    const dgg::Status status =
      dgg::SurfaceMesh::FromPoints(arrays.Points.data(), arrays.GetNumberOfVertices(),
        arrays.Triangles.data(), arrays.GetNumberOfFaces(), this->Surface);
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();
  }

  dgg::GeodesicGraph Build(const dgg::SurfaceMesh& surface, dgg::GraphConstruction rule)
  {
    dgg::GraphOptions options;
    options.Construction = rule;
    options.Accuracy = Accuracy;
    dgg::GeodesicGraph graph;
    EXPECT_TRUE(dgg::GraphBuilder(surface).Build(options, graph).IsOk());
    return graph;
  }

  static std::vector<double> Distances(const dgg::GeodesicGraph& graph)
  {
    dgg::SearchOptions options;
    options.Method = dgg::SearchMethod::Dijkstra;
    dgg::GraphSeed seed;
    seed.Vertex = 0;
    dgg::SearchResult result;
    EXPECT_TRUE(dgg::GraphSearch(graph.View(), nullptr).Run({ seed }, options, result).IsOk());
    return result.Distances;
  }

  dgg::SurfaceMesh Surface;
};

constexpr QueueRule AllQueues[] = { QueueRule::FirstInFirstOut, QueueRule::SmallLabelFirst,
  QueueRule::LargeLabelLast, QueueRule::SmallAndLarge };
}

TEST_F(Published, AllQueuesFindTheShortestPaths)
{
  const dgg::GeodesicGraph graph = this->Build(this->Surface, dgg::GraphConstruction::OneRelay);
  const std::vector<double> expected = Distances(graph);
  for (const QueueRule rule : AllQueues)
  {
    const LabelResult result = SearchByLabels(graph.View(), this->Surface, 0, rule, 0.0);
    ASSERT_EQ(result.Distances.size(), expected.size());
    for (std::size_t v = 0; v < expected.size(); ++v)
    {
      EXPECT_NEAR(result.Distances[v], expected[v], 1e-9 * expected[v]);
    }
    EXPECT_GE(result.Pops, expected.size());
  }
}

TEST_F(Published, SmallAndLargeLabelsSavePops)
{
  const dgg::GeodesicGraph graph = this->Build(this->Surface, dgg::GraphConstruction::OneRelay);
  const auto pops = [&](QueueRule rule) {
    return SearchByLabels(graph.View(), this->Surface, 0, rule, 0.0).Pops;
  };
  EXPECT_LT(pops(QueueRule::SmallAndLarge), pops(QueueRule::FirstInFirstOut));
}

TEST_F(Published, FansRelaxFewerEdgesAndNeverShorten)
{
  const dgg::GeodesicGraph graph = this->Build(this->Surface, dgg::GraphConstruction::OneRelay);
  const std::vector<double> expected = Distances(graph);
  const auto search = [&](double tolerance) {
    return SearchByLabels(graph.View(), this->Surface, 0, QueueRule::SmallAndLarge, tolerance);
  };
  const LabelResult all = search(0.0);
  const LabelResult narrow = search(std::asin(std::sqrt(Accuracy)));
  EXPECT_LT(narrow.Relaxations, all.Relaxations / 2);
  for (std::size_t v = 0; v < expected.size(); ++v)
  {
    EXPECT_GE(narrow.Distances[v], expected[v] * (1.0 - 1e-9));
  }
}

TEST_F(Published, PruningByProgressIsTheIndirectConstruction)
{
  dgg::GeodesicGraph graph;
  CandidateStatistics statistics;
  ASSERT_TRUE(
    BuildFromCandidates(this->Surface, Accuracy, PruningRule::Progress, graph, statistics).IsOk());
  EXPECT_EQ(dgg::ComputeChecksum(graph.View()),
    dgg::ComputeChecksum(this->Build(this->Surface, dgg::GraphConstruction::Indirect).View()));
}

TEST_F(Published, PrunedByTheConditionAsPrinted)
{
  dgg::GeodesicGraph all;
  dgg::GeodesicGraph pruned;
  CandidateStatistics statistics;
  ASSERT_TRUE(
    BuildFromCandidates(this->Surface, Accuracy, PruningRule::None, all, statistics).IsOk());
  EXPECT_GT(statistics.CandidatesPerVertex, 50.0);
  ASSERT_TRUE(
    BuildFromCandidates(this->Surface, Accuracy, PruningRule::Published, pruned, statistics)
      .IsOk());
  EXPECT_LT(pruned.View().GetNumberOfEdges(), all.View().GetNumberOfEdges() / 2);
  const std::vector<double> longer = Distances(pruned);
  const std::vector<double> shorter = Distances(all);
  for (std::size_t v = 0; v < longer.size(); ++v)
  {
    EXPECT_GE(longer[v], shorter[v] * (1.0 - 1e-6));
  }
}

TEST_F(Published, PseudoVerticesLeaveTheSurfaceAsItIs)
{
  MeshArrays stretched = BumpySphere(2);
  for (std::size_t i = 0; i < stretched.Points.size(); i += 3)
  {
    stretched.Points[i] *= 8.0;
  }
  this->Use(stretched);
  dgg::GeodesicGraph candidates;
  CandidateStatistics statistics;
  ASSERT_TRUE(
    BuildFromCandidates(this->Surface, Accuracy, PruningRule::None, candidates, statistics).IsOk());
  dgg::SurfaceMesh refined;
  dgg::Id added = 0;
  const dgg::Status status =
    AddPseudoVertices(this->Surface, candidates.View(), Accuracy, refined, added);
  ASSERT_TRUE(status.IsOk()) << status.GetMessage();
  EXPECT_GT(added, this->Surface.GetNumberOfVertices());
  EXPECT_EQ(refined.GetNumberOfVertices(), this->Surface.GetNumberOfVertices() + added);
  // Vertices keep their distances, within what both graphs promise.
  const std::vector<double> before =
    Distances(this->Build(this->Surface, dgg::GraphConstruction::Guaranteed));
  const std::vector<double> after =
    Distances(this->Build(refined, dgg::GraphConstruction::Guaranteed));
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    EXPECT_NEAR(after[v], before[v], Accuracy * before[v] + 1e-12);
  }
}
