// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances from many sources, and farthest point sampling.
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggBucketQueue.h"
#include "dggDistanceRows.h"
#include "dggFarthestPoints.h"
#include "dggHeap.h"
#include "dggSourceGroups.h"

namespace dggtest
{
namespace
{
using dgg::GraphSeed;
using dgg::Offset;

/// Returns the distances of all vertices from each of many sources, row by row.
dgg::Status FindRows(const SearchCase& c, const std::vector<Id>& sources, double radius,
  const dgg::ParallelFor& parallel, std::vector<double>& rows)
{
  std::vector<std::vector<GraphSeed>> seeds;
  for (Id source : sources)
  {
    seeds.push_back({ SeedAt(source) });
  }
  const auto n = static_cast<std::size_t>(c.GetNumberOfVertices());
  rows.assign(n * sources.size(), -1.0);
  dgg::ManyOptions options;
  options.MaximumDistance = radius;
  return c.GetSearch().Many(seeds, options, parallel, nullptr,
    [&](std::size_t source, const double* distances, const std::vector<Id>&) {
      std::copy(distances, distances + n, rows.begin() + static_cast<std::ptrdiff_t>(source * n));
    });
}

void ExpectRows(const SearchCase& c, const std::vector<Id>& sources, double radius,
  const dgg::ParallelFor& parallel)
{
  const auto n = static_cast<std::size_t>(c.GetNumberOfVertices());
  std::vector<double> distances;
  ASSERT_TRUE(FindRows(c, sources, radius, parallel, distances).IsOk());
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    std::vector<double> expected = ReferenceDistances(c.GetGraph(), { SeedAt(sources[i]) });
    const double* row = distances.data() + i * n;
    for (std::size_t v = 0; v < n; ++v)
    {
      const bool isAtRim = std::abs(expected[v] - radius) < 1e-12 * radius;
      expected[v] = isAtRim ? row[v] : expected[v];
      expected[v] = expected[v] <= radius ? expected[v] : dgg::Infinity;
    }
    ExpectSameDistances(expected, { row, row + n }, c.GetName() + ", row " + std::to_string(i));
  }
}
}

TEST(GraphPairs, ManyAgreeWithDijkstra)
{
  for (const auto& c : SearchCases())
  {
    const Id n = c->GetNumberOfVertices();
    // The number of sources is not a multiple of the batch size, and some occur twice.
    std::vector<Id> sources{ 0, n - 1, n / 2, n / 2 };
    Random random(17);
    for (int i = 0; i < 9; ++i)
    {
      sources.push_back(random.Index(n));
    }
    ExpectRows(*c, sources, dgg::Infinity, nullptr);
    ExpectRows(*c, { n / 3 }, dgg::Infinity, nullptr);
  }
}

TEST(GraphPairs, ManyFarApartAndWithinARadius)
{
  // The sources are so far apart that they are searched one by one.
  const SearchCase plane("plane", Plane(70, 70, 0.2, 2), 0.1);
  ExpectRows(plane, { 0, 2500, 4999, 70 }, dgg::Infinity, nullptr);
  ExpectRows(plane, { 0, 2500, 4999, 70 }, 20.0, WithThreads(2));
  const SearchCase sphere("sphere", NoisySphere(3, 0.2, 4), 0.02);
  std::vector<Id> sources;
  for (Id v = 0; v < 640; v += 16)
  {
    sources.push_back(v);
  }
  for (double radius : { 0.0, 0.4, 1.5, -1.0 })
  {
    ExpectRows(sphere, sources, radius, nullptr);
  }
}

TEST(GraphPairs, ManySetsOfSeeds)
{
  // Each source is a set of neighboring vertices with initial distances, like a surface point.
  const SearchCase c("sphere", NoisySphere(4, 0.1, 4), 0.05);
  const Id n = c.GetNumberOfVertices();
  Random random(5);
  std::vector<std::vector<GraphSeed>> sources;
  for (int i = 0; i < 200; ++i)
  {
    const Id v = random.Index(n);
    const double start = random.Uniform(-0.3, 0.3);
    sources.push_back({ SeedAt(v, start) });
    const Offset row = c.GetGraph().Offsets[v];
    for (Offset e = row; e < row + 3; ++e)
    {
      sources.back().push_back(SeedAt(c.GetGraph().Targets[e], start - 0.01));
    }
  }
  std::vector<int> visits(sources.size(), 0);
  ProgressListener listener;
  ASSERT_TRUE(c.GetSearch()
                .Many(sources, dgg::ManyOptions(), nullptr, std::ref(listener),
                  [&](std::size_t source, const double* distances, const std::vector<Id>&) {
                    ++visits[source];
                    ExpectSameDistances(ReferenceDistances(c.GetGraph(), sources[source]),
                      { distances, distances + n }, "source " + std::to_string(source));
                  })
                .IsOk());
  EXPECT_EQ(listener.Done, 1.0);
  EXPECT_EQ(visits, std::vector<int>(sources.size(), 1));
}

TEST(GraphPairs, GroupsOfSourcesAreCloseTogether)
{
  const SearchCase c("plane", Plane(40, 40), 0.1);
  std::vector<Id> sources;
  for (Id v = 0; v < c.GetNumberOfVertices(); v += 4)
  {
    sources.push_back(v);
  }
  sources.insert(sources.end(), 20, 7); // repeat one vertex
  const auto groups = dgg::GroupSources(c.GetMesh(), sources, 8);
  std::vector<int> places(sources.size(), 0);
  double spread = 0.0;
  for (const dgg::SourceGroup& group : groups)
  {
    EXPECT_FALSE(group.empty());
    EXPECT_LE(group.size(), 8u);
    const std::vector<double> distances =
      ReferenceDistances(c.GetGraph(), { SeedAt(sources[group.front()]) });
    for (std::size_t place : group)
    {
      ++places[place];
      spread = std::max(spread, distances[sources[place]]);
    }
  }
  EXPECT_EQ(places, std::vector<int>(sources.size(), 1));
  // Eight sources cover about 6 x 6 edges.
  EXPECT_LT(spread, 16.0);
  EXPECT_LE(groups.size(), sources.size() / 8 + 3);
}

TEST(SearchQueues, BucketsGiveEverythingBackRoughlySorted)
{
  for (double width : { 1e-3, 1.0, 50.0, 1e-30 })
  {
    Random random(2);
    dgg::BucketQueue queue;
    queue.Reset(-7.0, width);
    std::vector<int> seen(2000, 0);
    for (Id i = 0; i < 1000; ++i)
    {
      queue.Push(random.Uniform(-7.0, 400.0) * (i % 10 == 0 ? 1e6 : 1.0) + 7e6 * (i % 10 == 0), i);
    }
    float last = 0.0f;
    Id next = 1000;
    while (queue.Advance())
    {
      for (std::size_t i = 0; i < queue.Current().size(); ++i)
      {
        const dgg::BucketQueue::Entry entry = queue.Current()[i];
        ++seen[entry.Vertex];
        EXPECT_GE(entry.Key, last - 1.001f - 1e-6f * last);
        last = std::max(last, entry.Key);
        if (next < 2000)
        {
          queue.Push(entry.Key * width - 7.0 + random.Uniform(0.0, 3.0 * width), next++);
        }
      }
      queue.ClearCurrent();
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 2000) << "width " << width;
  }
}

namespace
{
using dgg::FarthestPoints;
using dgg::FarthestVertex;
using dgg::GraphSeed;
using dgg::GraphView;

/// Returns the farthest vertex with edges by linear search.
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

/// Samples until there are `count` samples or no more vertices.
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
  // On a path of equal edges, both ends have the same distance from the middle.
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
