// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CandidateGraph.h"
#include "GeneratedMesh.h"
#include "LabelQueue.h"
#include "MergingEngine.h"
#include "PseudoVertices.h"
#include "Statistics.h"
#include "TestMeshes.h"
#include "TriangleUnfolding.h"
#include "VariationalHeat.h"
#include "dggExactGeodesics.h"
#include "dggGraphBuilder.h"
#include "dggGraphSearch.h"
#include "dggHeatMethod.h"

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

  dgg::ExactResult Exact(dgg::Id source)
  {
    dgg::ExactResult result;
    EXPECT_TRUE(dgg::ExactGeodesics(this->Surface)
                  .Run({ { dgg::SurfacePoint::AtVertex(source), 0.0 } }, {}, result)
                  .IsOk());
    return result;
  }

  dgg::SurfaceMesh Surface;
};

constexpr QueueRule AllQueues[] = { QueueRule::FirstInFirstOut, QueueRule::SmallLabelFirst,
  QueueRule::LargeLabelLast, QueueRule::SmallAndLarge };

MeshArrays ToArrays(const dggtest::TestMesh& mesh)
{
  return { mesh.Points, mesh.Triangles };
}

MeshArrays Stretched(MeshArrays mesh, double factor)
{
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] *= factor;
  }
  return mesh;
}

double MeanError(const std::vector<double>& distances, const std::vector<double>& exact)
{
  return ErrorStatistics(distances, exact).Errors.GetMean();
}
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
  this->Use(Stretched(BumpySphere(2), 8.0));
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
  // Vertices keep their distances, within the accuracy of both graphs.
  const std::vector<double> before =
    Distances(this->Build(this->Surface, dgg::GraphConstruction::Guaranteed));
  const std::vector<double> after =
    Distances(this->Build(refined, dgg::GraphConstruction::Guaranteed));
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    EXPECT_NEAR(after[v], before[v], Accuracy * before[v] + 1e-12);
  }
}

TEST_F(Published, VariationalHeatLowersTheEnergy)
{
  // Largest ratio of the errors: the error decreases on regular triangles and may increase on
  // others.
  const std::pair<MeshArrays, double> cases[] = { { Icosphere(3), 0.5 }, { Icosphere(4), 0.3 },
    { BumpySphere(3), 1.5 }, { Torus(40, 20), 1.5 } };
  for (const auto& mesh : cases)
  {
    this->Use(mesh.first);
    const std::vector<double> exact = this->Exact(0).Distances;
    for (const bool isDelaunay : { false, true })
    {
      dgg::HeatOptions options;
      options.IntrinsicDelaunay = isDelaunay;
      dgg::HeatMethod heat(this->Surface);
      ASSERT_TRUE(heat.Prepare(options, nullptr).IsOk());
      dgg::HeatResult result;
      ASSERT_TRUE(heat.Run({ { dgg::SurfacePoint::AtVertex(0), 0.0 } }, {}, result).IsOk());
      VariationalHeat variational(this->Surface);
      ASSERT_TRUE(variational.Prepare(isDelaunay).IsOk());
      std::vector<double> distances = result.Distances;
      variational.Improve(0, 0, distances);
      EXPECT_EQ(distances, result.Distances);
      variational.Improve(0, 10, distances);
      EXPECT_LT(variational.Energy(distances), variational.Energy(result.Distances));
      EXPECT_LT(MeanError(distances, exact), mesh.second * MeanError(result.Distances, exact));
    }
  }
}

TEST_F(Published, VariationalHeatOfSeveralComponents)
{
  MeshArrays two = Icosphere(1);
  const auto n = static_cast<dgg::Id>(two.GetNumberOfVertices());
  const MeshArrays one = two;
  two.Points.insert(two.Points.end(), one.Points.begin(), one.Points.end());
  for (const dgg::Id v : one.Triangles)
  {
    two.Triangles.push_back(v + n);
  }
  this->Use(two);
  VariationalHeat variational(this->Surface);
  ASSERT_TRUE(variational.Prepare(true).IsOk());
  std::vector<double> distances = this->Exact(3).Distances;
  variational.Improve(3, 5, distances);
  EXPECT_DOUBLE_EQ(distances[3], 0.0);
  EXPECT_GT(distances[0], 0.0);
  EXPECT_EQ(distances[n], dgg::Infinity);
}

TEST_F(Published, UnfoldedTrianglesAreExactInThePlane)
{
  const MeshArrays square = ToArrays(dggtest::Plane(19, 19, 0.2));
  this->Use(square);
  TriangleUnfolding unfolding(this->Surface);
  ASSERT_TRUE(unfolding.Prepare(30).IsOk());
  EXPECT_GT(unfolding.GetNumberOfTriangles(), 30u);
  const dgg::Id n = this->Surface.GetNumberOfVertices();
  for (dgg::Id p = 0; p < n; p += 7)
  {
    for (dgg::Id q = 0; q < n; ++q)
    {
      const double x = square.Points[3 * p] - square.Points[3 * q];
      const double y = square.Points[3 * p + 1] - square.Points[3 * q + 1];
      EXPECT_NEAR(unfolding.GetDistance(p, q), dgg::Norm(x, y), 2e-5);
    }
  }
}

TEST_F(Published, UnfoldedTrianglesKeepTheTriangleInequality)
{
  double before = dgg::Infinity;
  for (const int count : { 20, 80, 320 })
  {
    TriangleUnfolding unfolding(this->Surface);
    ASSERT_TRUE(unfolding.Prepare(count).IsOk());
    ASSERT_EQ(unfolding.GetSamples().size(), static_cast<std::size_t>(count));
    double sum = 0.0;
    for (const dgg::Id p : { 3, 100, 377 })
    {
      const std::vector<double> exact = this->Exact(p).Distances;
      std::vector<double> found;
      for (dgg::Id q = 0; q < this->Surface.GetNumberOfVertices(); ++q)
      {
        const TriangleUnfolding::Bounds bounds = unfolding.GetBounds(p, q);
        found.push_back(unfolding.GetDistance(p, q));
        EXPECT_LE(bounds.Lower, exact[q] + 1e-9);
        EXPECT_GE(bounds.Upper, exact[q] - 1e-9);
        EXPECT_LE(std::abs(found.back() - exact[q]), bounds.Upper - bounds.Lower + 1e-9);
      }
      sum += MeanError(found, exact);
    }
    EXPECT_LT(sum, 0.5 * before);
    before = sum;
    const dgg::Id sample = unfolding.GetSamples()[count / 2];
    const std::vector<double> exact = this->Exact(sample).Distances;
    for (const dgg::Id other : unfolding.GetSamples())
    {
      EXPECT_NEAR(unfolding.GetDistance(sample, other), exact[other], 1e-9);
    }
  }
}

TEST_F(Published, MergedWindowsStayWithinTheirTolerance)
{
  for (const MeshArrays& mesh :
    { BumpySphere(4), Stretched(BumpySphere(4), 8.0), Torus(60, 30),
      ToArrays(dggtest::Terrain(25, 0.3, 1)), ToArrays(dggtest::Box(12, 8, 6, 1.0, 1.0, 1.0, 0.2)),
      ToArrays(dggtest::Plane(29, 29, 0.2)) })
  {
    this->Use(mesh);
    for (const dgg::Id source : { 0, 400 })
    {
      const dgg::ExactResult exact = this->Exact(source);
      for (const double tolerance : { 0.1, 0.01, 0.001 })
      {
        MergingEngine engine(this->Surface, tolerance);
        dgg::ExactResult result;
        const dgg::Status status =
          engine.Run({ { dgg::SurfacePoint::AtVertex(source), 0.0 } }, {}, result, false);
        ASSERT_TRUE(status.IsOk()) << status.GetMessage();
        const ErrorStatistics errors(result.Distances, exact.Distances);
        EXPECT_EQ(errors.Unreached, 0u);
        EXPECT_LE(errors.Errors.GetMaximum(), tolerance);
        EXPECT_LE(result.NumberOfWindows, exact.NumberOfWindows);
      }
    }
  }
}

TEST_F(Published, MergingSavesWindows)
{
  this->Use(BumpySphere(4));
  MergingEngine engine(this->Surface, 0.01);
  dgg::ExactResult result;
  ASSERT_TRUE(engine.Run({ { dgg::SurfacePoint::AtVertex(0), 0.0 } }, {}, result, false).IsOk());
  EXPECT_GT(engine.GetNumberOfMerged(), 1000u);
  EXPECT_LT(result.NumberOfWindows, this->Exact(0).NumberOfWindows / 2);
}
