// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Farthest point samples: against all distances, computed anew.
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggFarthestPoints.h"

#include <set>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::FarthestPoints;
using dgg::FarthestVertex;
using dgg::GraphSeed;
using dgg::GraphView;

/// The farthest vertex with edges, by looking at all of them.
FarthestVertex LookForFarthest(const GraphView& graph, const std::vector<double>& distances)
{
  FarthestVertex farthest;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    if (graph.Offsets[v] < graph.Offsets[v + 1] && distances[v] > farthest.Distance)
    {
      farthest = { v, distances[v] };
    }
  }
  return farthest;
}

void AddVertex(FarthestPoints& points, Id vertex)
{
  EXPECT_TRUE(Ok(points.Add({ SeedAt(vertex) }, nullptr)));
}

/// Samples until there are `count` or no more.
std::vector<Id> Sample(FarthestPoints& points, Id first, std::size_t count)
{
  std::vector<Id> samples;
  for (Id next = first; next != dgg::NoId && samples.size() < count; next = points.Find().Vertex)
  {
    samples.push_back(next);
    AddVertex(points, next);
  }
  return samples;
}
}

TEST(FarthestPoints, EverySampleIsFarthest)
{
  for (const auto& c : SearchCases())
  {
    const GraphView graph = c->GetGraph();
    FarthestPoints points(graph, &c->GetMesh());
    std::vector<GraphSeed> seeds;
    double radius = dgg::Infinity;
    FarthestVertex next = points.Find();
    EXPECT_EQ(next.Distance, dgg::Infinity) << c->GetName();
    for (int i = 0; i < 25 && next.Vertex != dgg::NoId; ++i)
    {
      seeds.push_back(SeedAt(next.Vertex));
      AddVertex(points, next.Vertex);
      ExpectSameDistances(ReferenceDistances(graph, seeds), points.GetDistances(), c->GetName());
      next = points.Find();
      const FarthestVertex expected = LookForFarthest(graph, points.GetDistances());
      EXPECT_EQ(next.Vertex, expected.Vertex) << c->GetName();
      EXPECT_EQ(next.Distance, expected.Distance) << c->GetName();
      EXPECT_LE(next.Distance, radius) << c->GetName();
      radius = next.Distance;
    }
  }
}

TEST(FarthestPoints, EveryComponentGetsASampleFirst)
{
  const SearchCase c("several components", SeveralComponents(), 0.05);
  Id count = 0;
  const std::vector<Id> component = c.GetMesh().ComputeComponents(count);
  std::set<Id> withEdges;
  for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
  {
    if (c.GetMesh().Kind(v) != dgg::VertexKind::Isolated)
    {
      withEdges.insert(component[v]);
    }
  }
  ASSERT_GT(withEdges.size(), 1u);
  FarthestPoints points(c.GetGraph(), &c.GetMesh());
  std::set<Id> sampled;
  for (const Id v : Sample(points, points.Find().Vertex, withEdges.size()))
  {
    sampled.insert(component[v]);
  }
  EXPECT_EQ(sampled, withEdges);
  EXPECT_LT(points.Find().Distance, dgg::Infinity);
}

TEST(FarthestPoints, AllVerticesButIsolatedOnes)
{
  const SearchCase c("isolated points", SphereWithIsolatedPoints(1), 0.05);
  FarthestPoints points(c.GetGraph(), &c.GetMesh());
  const std::vector<Id> samples = Sample(points, points.Find().Vertex, 100000);
  const std::set<Id> different(samples.begin(), samples.end());
  EXPECT_EQ(different.size(), samples.size());
  Id expected = 0;
  for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
  {
    const bool isIsolated = c.GetMesh().Kind(v) == dgg::VertexKind::Isolated;
    EXPECT_EQ(different.count(v), isIsolated ? 0u : 1u);
    expected += isIsolated ? 0 : 1;
  }
  EXPECT_EQ(samples.size(), static_cast<std::size_t>(expected));
  EXPECT_EQ(points.Find().Vertex, dgg::NoId);
  EXPECT_EQ(points.Find().Distance, 0.0);
}

TEST(FarthestPoints, TiesGoToTheSmallestId)
{
  // On a path of equal edges, both ends are as far from the middle.
  const std::vector<dgg::Offset> offsets{ 0, 1, 3, 5, 7, 8 };
  const std::vector<Id> targets{ 1, 0, 2, 1, 3, 2, 4, 3 };
  const std::vector<float> lengths(8, 1.0f);
  GraphView graph;
  graph.Info.Kind = dgg::GraphKind::Cloud;
  graph.NumberOfVertices = 5;
  graph.Offsets = offsets.data();
  graph.Targets = targets.data();
  graph.Lengths = lengths.data();
  FarthestPoints points(graph, nullptr);
  EXPECT_EQ(Sample(points, 2, 10), (std::vector<Id>{ 2, 0, 4, 1, 3 }));
}

TEST(FarthestPoints, CloudsAndMeshesGiveTheSame)
{
  const SearchCase c("sphere", Icosphere(3), 0.02);
  FarthestPoints onMesh(c.GetGraph(), &c.GetMesh());
  FarthestPoints onCloud(AsCloud(c.GetGraph()), nullptr);
  EXPECT_EQ(Sample(onMesh, 5, 50), Sample(onCloud, 5, 50));
}

TEST(FarthestPoints, SurfacePointsAreSamplesByTheirLinks)
{
  const SearchCase c("plane", Plane(10, 10, 0.2), 0.01);
  const dgg::GraphBuilder builder(c.GetMesh());
  const auto point = dgg::SurfacePoint::InFace(c.GetMesh(), 77, { { 0.5, 0.3, 0.2 } });
  std::vector<GraphSeed> seeds = SeedsOf(builder, point, 0.01);
  FarthestPoints points(c.GetGraph(), &c.GetMesh());
  AddVertex(points, 0);
  ASSERT_TRUE(points.Add(seeds, nullptr).IsOk());
  seeds.push_back(SeedAt(0));
  ExpectSameDistances(ReferenceDistances(c.GetGraph(), seeds), points.GetDistances(), "links");
}

}
