// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "../Benchmark/MemoryProbe.h"
#include "CloudShapes.h"

#include "dggCloudNodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphBuilder;
using dgg::CloudGraphEstimate;
using dgg::CloudGraphOptions;
using dgg::CloudGraphStatistics;
using dgg::CloudScheme;
using dgg::Status;

template <typename T>
bool AreSame(const dgg::Buffer<T>& a, const dgg::Buffer<T>& b)
{
  return a.Size() == b.Size() && std::equal(a.begin(), a.end(), b.begin());
}

void ExpectSameForAnyThreads(
  const Cloud& cloud, const std::function<void(CloudGraphOptions&)>& change, bool isNoisy)
{
  CloudGraphStatistics statistics;
  const auto build = [&](const dgg::ParallelFor& loop) {
    return BuildGraph(
      cloud,
      [&](CloudGraphOptions& options) {
        change(options);
        options.Parallel = loop;
      },
      &statistics);
  };
  const CloudGraph one = build({});
  const CloudGraph many = build(WithThreads(5));
  EXPECT_EQ(statistics.Noise > 0.0, isNoisy);
  EXPECT_TRUE(AreSame(one.Graph.Offsets, many.Graph.Offsets));
  EXPECT_TRUE(AreSame(one.Graph.Targets, many.Graph.Targets));
  EXPECT_TRUE(AreSame(one.Graph.Lengths, many.Graph.Lengths));
  EXPECT_TRUE(AreSame(one.Graph.WideLengths, many.Graph.WideLengths));
  EXPECT_EQ(one.Components, many.Components);
  EXPECT_EQ(one.Radii, many.Radii);
}
}

TEST(CloudGraph, SameForAnyThreads)
{
  // A clean sphere and a noisy one; in each way that a graph is built.
  for (const double noise : { 0.0, 0.02 })
  {
    Cloud cloud = Sphere(1000, 1, noise);
    cloud.Add(cloud.At(17));
    cloud.Add(cloud.At(17));
    const std::vector<std::pair<const char*, std::function<void(CloudGraphOptions&)>>> changes = {
      { "A", [](CloudGraphOptions& options) { options.Scheme = CloudScheme::Curvature; } },
      { "B", [](CloudGraphOptions& options) { options.Scheme = CloudScheme::Constant; } },
      { "C", [](CloudGraphOptions& options) { options.Scheme = CloudScheme::Spacing; } },
      { "oriented normals",
        [&](CloudGraphOptions& options) {
          options.Normals = cloud.Points.data(); // of a sphere around the origin
          options.HasOrientedNormals = true;
        } },
      { "all edges", [](CloudGraphOptions& options) { options.Accuracy = 0.0; } },
    };
    for (const auto& change : changes)
    {
      SCOPED_TRACE(change.first);
      ExpectSameForAnyThreads(cloud, change.second, noise > 0.0);
    }
  }
}

TEST(CloudGraph, NumberingDoesNotMatter)
{
  const Cloud cloud = Sphere(2000, 2);
  Cloud reversed;
  for (Id i = cloud.GetSize(); i-- > 0;)
  {
    reversed.Add(cloud.At(i));
  }
  const CloudGraph a = BuildGraph(cloud);
  const CloudGraph b = BuildGraph(reversed);
  ASSERT_EQ(a.Graph.Targets.Size(), b.Graph.Targets.Size());
  const std::vector<double> there = DistancesFrom(a.Graph.View(), 0);
  const std::vector<double> back = DistancesFrom(b.Graph.View(), cloud.GetSize() - 1);
  for (Id i = 0; i < cloud.GetSize(); ++i)
  {
    EXPECT_DOUBLE_EQ(there[i], back[cloud.GetSize() - 1 - i]);
  }
}

TEST(CloudGraph, ComponentsAreThoseOfTheGraph)
{
  // Two spheres, the second one smaller, and a point far off.
  Cloud cloud = Sphere(800, 3);
  const Cloud small = Sphere(1500, 4);
  for (Id i = 0; i < small.GetSize(); ++i)
  {
    cloud.Add(0.5 * small.At(i) + Point3{ 5.0, 0.0, 0.0 });
  }
  cloud.Add({ 0.0, 40.0, 0.0 });
  const CloudGraph graph = BuildGraph(cloud);
  ASSERT_EQ(graph.ComponentSizes, (std::vector<Id>{ 1500, 800, 1 }));
  EXPECT_EQ(graph.Components[0], 1);
  EXPECT_EQ(graph.Components[800], 0);
  EXPECT_EQ(graph.Components[2300], 2);
  const std::vector<double> distances = DistancesFrom(graph.Graph.View(), 0);
  for (Id i = 0; i < cloud.GetSize(); ++i)
  {
    EXPECT_EQ(distances[i] < dgg::Infinity, graph.Components[i] == 1) << i;
  }
}

TEST(CloudGraph, SaysWhatItIs)
{
  const Cloud cloud = Sphere(1000, 5);
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(
    cloud,
    [](CloudGraphOptions& options) {
      options.Accuracy = 0.01;
      options.Scheme = CloudScheme::Constant;
    },
    &statistics);
  EXPECT_EQ(graph.Graph.Info.Construction, dgg::GraphConstruction::CloudConstant);
  EXPECT_EQ(graph.Graph.Info.Accuracy, 0.01);
  EXPECT_FALSE(graph.Graph.Info.IsGuaranteed());
  EXPECT_TRUE(graph.Graph.Angles.IsEmpty());
  const double spacing = std::sqrt(4.0 * dgg::Pi / 1000.0);
  EXPECT_NEAR(statistics.Spacing, spacing, 0.1 * spacing);
  EXPECT_GT(statistics.Candidates, statistics.OutEdges);
  EXPECT_GT(statistics.PeakMemory, graph.Graph.GetMemorySize());
  EXPECT_EQ(graph.VoxelSize, statistics.VoxelSize);
  EXPECT_FALSE(graph.Graph.Lengths.IsEmpty());
  const CloudGraph wide =
    BuildGraph(cloud, [](CloudGraphOptions& options) { options.Accuracy = 2e-6; });
  EXPECT_TRUE(wide.Graph.Lengths.IsEmpty());
  EXPECT_FALSE(wide.Graph.WideLengths.IsEmpty());
}

TEST(CloudGraph, OptionsAreUsedAsGiven)
{
  const Cloud cloud = Sphere(2000, 6);
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(
    cloud,
    [](CloudGraphOptions& options) {
      options.Scheme = CloudScheme::Constant;
      options.Resolution = 100;
      options.OffsetInVoxels = 3.0;
      options.Alpha = 12.0;
    },
    &statistics);
  // Of two units.
  const double voxel = 2.0 / 100.0;
  EXPECT_NEAR(statistics.VoxelSize, voxel, 0.01 * voxel);
  EXPECT_EQ(statistics.Resolution, 100);
  EXPECT_NEAR(statistics.OffsetInVoxels, 3.0, 1e-6);
  EXPECT_NEAR(statistics.Reach, 15.0 * statistics.VoxelSize, 1e-6);
  EXPECT_EQ(statistics.Alpha, 12.0);
  for (const double radius : graph.Radii)
  {
    EXPECT_NEAR(radius, 3.0 * statistics.VoxelSize, 1e-6);
  }
  const dgg::GraphView view = graph.Graph.View();
  for (Id v = 0; v < view.NumberOfVertices; ++v)
  {
    for (dgg::Offset e = view.Offsets[v]; e < view.Offsets[v + 1]; ++e)
    {
      EXPECT_LE(
        dgg::Norm(cloud.At(v) - cloud.At(view.Targets[e])), statistics.Reach * (1.0 + 1e-5));
    }
  }
}

TEST(CloudGraph, RefusesOptionsOutOfRange)
{
  const auto refuses = [](const std::function<void(CloudGraphOptions&)>& change) {
    CloudGraphOptions options;
    change(options);
    const double point[3] = { 0.0, 0.0, 0.0 };
    CloudGraph graph;
    const Status status = CloudGraphBuilder(point, 1).Build(options, graph);
    EXPECT_TRUE(graph.Graph.Offsets.IsEmpty());
    return !status.IsOk() && !status.GetMessage().empty() &&
      !CloudGraphBuilder::Check(options).IsOk();
  };
  const double nan = std::nan("");
  EXPECT_TRUE(refuses([](CloudGraphOptions& o) { o.OffsetInVoxels = -1.0; }));
  EXPECT_TRUE(refuses([&](CloudGraphOptions& o) { o.OffsetInVoxels = nan; }));
  EXPECT_TRUE(refuses([](CloudGraphOptions& o) { o.Resolution = -5; }));
  EXPECT_TRUE(refuses([](CloudGraphOptions& o) { o.Resolution = 1 << 25; }));
  EXPECT_TRUE(refuses([](CloudGraphOptions& o) { o.Alpha = -1.0; }));
  EXPECT_TRUE(refuses([&](CloudGraphOptions& o) { o.Alpha = nan; }));
  EXPECT_TRUE(refuses([](CloudGraphOptions& o) { o.Accuracy = 0.7; }));
  EXPECT_TRUE(refuses([](CloudGraphOptions& o) { o.Accuracy = 1e-9; }));
  EXPECT_TRUE(refuses([](CloudGraphOptions& o) { o.HasOrientedNormals = true; }));
}

TEST(CloudGraph, PredictsWhatItTakes)
{
  const Cloud cloud = Sphere(5000, 7);
  const CloudGraphBuilder builder(cloud.Points.data(), cloud.GetSize());
  CloudGraphEstimate estimate;
  ASSERT_TRUE(builder.Estimate(CloudGraphOptions(), estimate).IsOk());
  const CloudGraph graph = BuildGraph(cloud);
  const auto edges = static_cast<double>(graph.Graph.Targets.Size());
  EXPECT_NEAR(estimate.Edges, edges, 0.15 * edges);
  EXPECT_NEAR(
    estimate.Memory, static_cast<double>(graph.Graph.GetMemorySize()), 0.15 * estimate.Memory);
  EXPECT_GT(estimate.Peak, estimate.Memory);

  CloudGraphOptions options;
  options.MemoryLimit = static_cast<std::size_t>(0.7 * estimate.Peak);
  CloudGraph refused;
  Status status = builder.Build(options, refused);
  EXPECT_FALSE(status.IsOk());
  EXPECT_NE(status.GetMessage().find("limit"), std::string::npos) << status.GetMessage();
  EXPECT_TRUE(refused.Graph.Offsets.IsEmpty());
  options.MemoryLimit = 1000;
  EXPECT_FALSE(builder.Build(options, refused).IsOk());
  options.MemoryLimit = static_cast<std::size_t>(1.5 * estimate.Peak);
  status = builder.Build(options, refused);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
}

TEST(CloudGraph, AllPointsWithinReachAreNeighbours)
{
  // A spot of the square has 200 times as many points as the rest per area: points there have far
  // more neighbours than others.
  Cloud cloud = Square(2000, 9);
  const Cloud spot = Square(1000, 10);
  for (Id i = 0; i < spot.GetSize(); ++i)
  {
    cloud.Add(Point3{ 0.5, 0.5, 0.0 } + 0.05 * spot.At(i));
  }
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(
    cloud,
    [](CloudGraphOptions& options) {
      options.Scheme = CloudScheme::Constant;
      options.ArcLengthWeights = false;
      options.Accuracy = 0.0;
      options.Resolution = 100;
      options.OffsetInVoxels = 4.0;
      options.Alpha = 6.0;
    },
    &statistics);
  const double reach = 10.0 * statistics.VoxelSize;
  std::size_t pairs = 0;
  for (Id p = 0; p < cloud.GetSize(); ++p)
  {
    for (Id q = 0; q < cloud.GetSize(); ++q)
    {
      pairs += p != q && dgg::Norm(cloud.At(p) - cloud.At(q)) <= reach ? 1 : 0;
    }
  }
  // All but some that would leave the band at the border.
  EXPECT_GT(static_cast<double>(graph.Graph.Targets.Size()), 0.99 * static_cast<double>(pairs));
}

TEST(CloudGraph, TakesNoMoreThanPredicted)
{
  // All blocks of the allocator: MemoryProbe replaces it. A little more points than a power of two:
  // what grows by doubling would take most then.
  struct Case
  {
    CloudScheme Scheme;
    double Accuracy;
    double Noise;
  };
  for (const Case& test : { Case{ CloudScheme::Curvature, 0.001, 0.0 },
         Case{ CloudScheme::Constant, 0.001, 0.0 }, Case{ CloudScheme::Spacing, 0.001, 0.0 },
         Case{ CloudScheme::Spacing, 0.001, 0.01 }, Case{ CloudScheme::Spacing, 0.0, 0.0 } })
  {
    const Cloud cloud = Sphere(2100, 17, test.Noise);
    const std::vector<double> normals = cloud.Points;
    CloudGraphOptions options;
    options.Normals = normals.data();
    options.Scheme = test.Scheme;
    options.Accuracy = test.Accuracy;
    const CloudGraphBuilder builder(cloud.Points.data(), cloud.GetSize());
    CloudGraphEstimate estimate;
    ASSERT_TRUE(builder.Estimate(options, estimate).IsOk());
    const double given = 24.0 * cloud.GetSize(); // there already
    const MemoryProbe probe;
    CloudGraph graph;
    ASSERT_TRUE(builder.Build(options, graph).IsOk());
    const auto peak = static_cast<double>(probe.GetHeapPeak()); // 0 where it cannot be measured
    EXPECT_LE(peak, estimate.Peak - given)
      << static_cast<int>(test.Scheme) << " " << test.Accuracy << " " << test.Noise;
    if (peak > 0.0)
    {
      EXPECT_GE(peak, 0.8 * (estimate.Peak - given))
        << static_cast<int>(test.Scheme) << " " << test.Accuracy << " " << test.Noise;
    }
  }
}

TEST(CloudGraph, FindingNodesTakesNoMoreThanPredicted)
{
  // No two in one place, pairs, one place, and a number that stands for no reading: the predicted
  // memory is all that is taken, before anything else is built.
  const Cloud few = Sphere(4200, 19);
  for (const Id places : { 4200, 2100, 1, -1 })
  {
    Cloud cloud;
    for (Id i = 0; i < few.GetSize(); ++i)
    {
      cloud.Add(places > 0 ? few.At(i % places) : i < 100 ? few.At(i) : Point3{ -1e4, 0.0, 0.0 });
    }
    const MemoryProbe probe;
    dgg::CloudNodes nodes;
    std::vector<Point3> found;
    ASSERT_TRUE(dgg::FindNodes(cloud.Points.data(), cloud.GetSize(), nodes, found).IsOk());
    EXPECT_EQ(static_cast<Id>(found.size()), places > 0 ? places : 101);
    EXPECT_LE(probe.GetHeapPeak(), dgg::CloudNodes::PredictMemory(cloud.GetSize())) << places;
  }
}

TEST(CloudGraph, LimitsMayLeaveNextToNothingForTheBand)
{
  // From the least limit on that what comes before the band fits into: none of them is no limit.
  const Cloud cloud = Sphere(500, 20);
  const CloudGraphBuilder builder(cloud.Points.data(), cloud.GetSize());
  const auto refusal = [&](std::size_t limit) {
    CloudGraphOptions options;
    options.MemoryLimit = limit;
    CloudGraph graph;
    return builder.Build(options, graph).GetMessage();
  };
  const std::string before = "what has to be known";
  std::size_t low = 1;
  std::size_t high = 1000000;
  ASSERT_NE(refusal(low).find(before), std::string::npos);
  while (high - low > 1)
  {
    const std::size_t middle = (low + high) / 2;
    (refusal(middle).find(before) != std::string::npos ? low : high) = middle;
  }
  for (std::size_t limit = high; limit < high + 5; ++limit)
  {
    const std::string message = refusal(limit);
    EXPECT_NE(message.find("the band of voxels"), std::string::npos) << message;
    // What is told to do can be done.
    EXPECT_NE(message.find("set a Resolution below "), std::string::npos) << message;
  }
}

TEST(CloudGraph, PredictsCoincidentPoints)
{
  Cloud cloud;
  const Cloud few = Sphere(300, 11);
  for (Id i = 0; i < 100 * few.GetSize(); ++i)
  {
    cloud.Add(few.At(i % few.GetSize()));
  }
  const CloudGraphBuilder builder(cloud.Points.data(), cloud.GetSize());
  CloudGraphEstimate estimate;
  ASSERT_TRUE(builder.Estimate(CloudGraphOptions(), estimate).IsOk());
  const CloudGraph graph = BuildGraph(cloud);
  const auto edges = static_cast<double>(graph.Graph.Targets.Size());
  EXPECT_NEAR(estimate.Edges, edges, 0.2 * edges);
  // Each point is copied and sorted before it is known which are in the same place.
  EXPECT_GT(estimate.Peak, 64.0 * cloud.GetSize());
  CloudGraphOptions options;
  options.MemoryLimit = 40 * static_cast<std::size_t>(cloud.GetSize());
  CloudGraph refused;
  EXPECT_FALSE(builder.Build(options, refused).IsOk());
}

TEST(CloudGraph, PredictionsTellOfProgressAndStop)
{
  const Cloud cloud = Sphere(20000, 12);
  const CloudGraphBuilder builder(cloud.Points.data(), cloud.GetSize());
  CloudGraphOptions options;
  std::vector<double> told;
  options.Progress = [&](double done) {
    told.push_back(done);
    return true;
  };
  CloudGraphEstimate estimate;
  ASSERT_TRUE(builder.Estimate(options, estimate).IsOk());
  EXPECT_GT(told.size(), 20U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.back(), 0.9);
  EXPECT_LE(told.back(), 1.0);
  for (std::size_t calls = 1; calls < told.size(); calls += 3)
  {
    std::size_t called = 0;
    options.Progress = [&](double) { return ++called < calls; };
    EXPECT_TRUE(builder.Estimate(options, estimate).IsAborted());
    EXPECT_EQ(called, calls);
  }
}

TEST(CloudGraph, ProgressGrowsWhileNoiseIsRemoved)
{
  const Cloud cloud = Sphere(20000, 12, 0.01);
  CloudGraphOptions options;
  std::vector<double> told;
  options.Progress = [&](double done) {
    told.push_back(done);
    return done < 0.3; // fits come first
  };
  CloudGraphEstimate estimate;
  EXPECT_TRUE(CloudGraphBuilder(cloud.Points.data(), cloud.GetSize())
                .Estimate(options, estimate)
                .IsAborted());
  EXPECT_GT(told.size(), 12U); // five of each of three fits
  for (std::size_t i = 3; i < told.size(); ++i)
  {
    EXPECT_GT(told[i], told[i - 1]) << i;
  }
}

TEST(CloudGraph, TellsOfProgressAndStops)
{
  const Cloud cloud = Sphere(20000, 8);
  const CloudGraphBuilder builder(cloud.Points.data(), cloud.GetSize());
  CloudGraphOptions options;
  options.Accuracy = 0.1;
  options.Alpha = 4.0;
  std::vector<double> told;
  options.Progress = [&](double done) {
    told.push_back(done);
    return true;
  };
  CloudGraph graph;
  ASSERT_TRUE(builder.Build(options, graph).IsOk());
  EXPECT_GT(told.size(), 6U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_EQ(told.back(), 1.0);
  for (const std::size_t calls : { 1, 3, 6 })
  {
    std::size_t called = 0;
    options.Progress = [&](double) { return ++called < calls; };
    EXPECT_TRUE(builder.Build(options, graph).IsAborted());
    EXPECT_EQ(called, calls);
    EXPECT_TRUE(graph.Graph.Offsets.IsEmpty());
  }
}
