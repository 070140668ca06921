// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances from many sources.
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggBucketQueue.h"
#include "dggDistanceRows.h"
#include "dggHeap.h"
#include "dggSourceGroups.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::GraphSeed;
using dgg::Offset;

/// Distances of all vertices from each of many, row by row.
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
    // Not a multiple of what is searched together, some twice.
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

TEST(GraphPairs, ManyFarApart)
{
  // So far that they are searched one by one.
  const SearchCase c("plane", Plane(70, 70, 0.2, 2), 0.1);
  ExpectRows(c, { 0, 2500, 4999, 70 }, dgg::Infinity, nullptr);
  ExpectRows(c, { 0, 2500, 4999, 70 }, 20.0, WithThreads(2));
}

TEST(GraphPairs, ManyWithinARadius)
{
  const SearchCase c("sphere", NoisySphere(3, 0.2, 4), 0.02);
  std::vector<Id> sources(40);
  for (Id i = 0; i < 40; ++i)
  {
    sources[i] = 16 * i;
  }
  for (double radius : { 0.0, 0.4, 1.5, -1.0 })
  {
    ExpectRows(c, sources, radius, nullptr);
  }
}

TEST(GraphPairs, ManySetsOfSeeds)
{
  // Each source a few vertices close together with distances to start with, as for points of the
  // surface.
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
  sources.insert(sources.end(), 20, 7); // one vertex over and over
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
  // Eight sources take about 6 x 6 edges.
  EXPECT_LT(spread, 16.0);
  EXPECT_LE(groups.size(), sources.size() / 8 + 3);
}

TEST(SearchQueues, HeapSorts)
{
  Random random(1);
  dgg::MinimumHeap heap;
  std::vector<double> keys;
  for (Id i = 0; i < 500; ++i)
  {
    keys.push_back(std::floor(random.Uniform(0.0, 100.0)));
    heap.Push(keys.back(), i);
    if (i % 3 == 2)
    {
      const auto smallest = std::min_element(keys.begin(), keys.end());
      EXPECT_EQ(heap.Pop().Key, *smallest);
      keys.erase(smallest);
    }
  }
  std::sort(keys.begin(), keys.end());
  for (double key : keys)
  {
    ASSERT_FALSE(heap.IsEmpty());
    EXPECT_EQ(heap.Top().Key, key);
    EXPECT_EQ(heap.Pop().Key, key);
  }
  EXPECT_TRUE(heap.IsEmpty());
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
}
