// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Memory use of graphs of clouds, its prediction, and limits.
#include "../Benchmark/MemoryProbe.h"
#include "CloudShapes.h"

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphEstimate;
using dgg::CloudGraphOptions;
using dgg::CloudScheme;
using dgg::Status;
}

TEST(CloudGraph, PredictsWhatItTakes)
{
  const Cloud cloud = Sphere(5000, 7);
  const CloudGraphEstimate estimate = Predict(cloud);
  const CloudGraph graph = BuildGraph(cloud);
  const auto edges = static_cast<double>(graph.Graph.Targets.Size());
  EXPECT_NEAR(estimate.Edges, edges, 0.15 * edges);
  EXPECT_NEAR(
    estimate.Memory, static_cast<double>(graph.Graph.GetMemorySize()), 0.15 * estimate.Memory);
  EXPECT_GT(estimate.Peak, estimate.Memory);

  CloudGraphOptions options;
  options.MemoryLimit = static_cast<std::size_t>(0.7 * estimate.Peak);
  CloudGraph refused;
  Status status = MakeBuilder(cloud).Build(options, refused);
  EXPECT_FALSE(status.IsOk());
  EXPECT_NE(status.GetMessage().find("limit"), std::string::npos) << status.GetMessage();
  EXPECT_TRUE(refused.Graph.Offsets.IsEmpty());
  options.MemoryLimit = 1000;
  EXPECT_FALSE(MakeBuilder(cloud).Build(options, refused).IsOk());
  options.MemoryLimit = static_cast<std::size_t>(1.5 * estimate.Peak);
  status = MakeBuilder(cloud).Build(options, refused);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
}

TEST(CloudGraph, EstimateIsWithinAFactorOfTwo)
{
  // MemoryProbe replaces the allocator and measures all blocks. The number of points is slightly
  // above a power of two, where arrays that grow by doubling take the most memory.
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
    const CloudGraphEstimate estimate = Predict(cloud, options);
    const double given = 24.0 * cloud.GetSize(); // memory of the input
    const MemoryProbe probe;
    CloudGraph graph;
    ASSERT_TRUE(MakeBuilder(cloud).Build(options, graph).IsOk());
    const auto peak = static_cast<double>(probe.GetHeapPeak()); // 0 if it cannot be measured
    SCOPED_TRACE(std::to_string(static_cast<int>(test.Scheme)) + " " +
      std::to_string(test.Accuracy) + " " + std::to_string(test.Noise));
    EXPECT_LE(peak, estimate.Peak - given);
    EXPECT_GE(2.0 * peak, peak > 0.0 ? estimate.Peak - given : 0.0);
  }
}

TEST(CloudGraph, LimitsMayLeaveNextToNothingForTheBand)
{
  // Limits from the smallest one that suffices for the steps before the band. A remainder of 0 must
  // not mean "no limit".
  const Cloud cloud = Sphere(500, 20);
  const auto refusal = [&](std::size_t limit) {
    CloudGraphOptions options;
    options.MemoryLimit = limit;
    return GetRefusal(cloud, options);
  };
  const std::string before = "The preparation of the points";
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
    EXPECT_NE(message.find("with a band of"), std::string::npos) << message;
    // The suggested remedy is possible.
    EXPECT_NE(message.find("Use a Resolution below "), std::string::npos) << message;
  }
}

TEST(CloudGraph, HugeReachesTakeNoMoreThanPredicted)
{
  // Each row examines all points, in each of several threads.
  const Cloud cloud = Sphere(600, 30);
  for (const double accuracy : { 0.5, 0.0 })
  {
    CloudGraphOptions options;
    options.Accuracy = accuracy;
    options.Alpha = accuracy > 0.0 ? 1e6 : 12.0;
    options.Parallel = WithThreads(6);
    options.NumberOfThreads = 6;
    const CloudGraphEstimate estimate = Predict(cloud, options);
    const MemoryProbe probe;
    CloudGraph graph;
    ASSERT_TRUE(MakeBuilder(cloud).Build(options, graph).IsOk());
    EXPECT_LE(static_cast<double>(probe.GetHeapPeak()), estimate.Peak) << accuracy;
  }
}

TEST(CloudGraph, LimitsAreKeptByFewerThreads)
{
  const Cloud cloud = Sphere(400, 31);
  CloudGraphOptions options;
  options.Accuracy = 0.5;
  options.Alpha = 1e6;
  const CloudGraphEstimate one = Predict(cloud, options);
  options.NumberOfThreads = 16;
  const CloudGraphEstimate many = Predict(cloud, options);
  EXPECT_GT(many.Peak, 1.2 * one.Peak); // otherwise nothing is tested
  const CloudGraph expected =
    BuildGraph(cloud, [](CloudGraphOptions& o) { o.Accuracy = 0.5, o.Alpha = 1e6; });

  // All threads together would exceed the limit, but a single thread does not.
  options.Parallel = WithThreads(16);
  options.MemoryLimit = static_cast<std::size_t>(one.Peak) + 1;
  const MemoryProbe probe;
  CloudGraph graph;
  const Status status = MakeBuilder(cloud).Build(options, graph);
  ASSERT_TRUE(status.IsOk()) << status.GetMessage();
  EXPECT_LE(probe.GetHeapPeak(), options.MemoryLimit);
  EXPECT_TRUE(std::equal(graph.Graph.Targets.begin(), graph.Graph.Targets.end(),
    expected.Graph.Targets.begin(), expected.Graph.Targets.end()));
}

TEST(CloudGraph, RefusesRowsThatDoNotFit)
{
  // The steps before the rows just fit, but the selection of a single row does not.
  const Cloud cloud = Sphere(1500, 32);
  CloudGraphOptions options;
  options.Alpha = 1e6;
  options.MemoryLimit = 200000;
  ASSERT_NE(GetRefusal(cloud, options).find("The preparation of the points"), std::string::npos);
  const auto isBefore = [](const std::string& message) {
    return message.find("The preparation of the points") != std::string::npos ||
      message.find("with a band of") != std::string::npos;
  };
  while (isBefore(GetRefusal(cloud, options)))
  {
    options.MemoryLimit += options.MemoryLimit / 25;
  }
  const MemoryProbe probe;
  const std::string message = GetRefusal(cloud, options);
  EXPECT_NE(message.find("Building the graph of the cloud"), std::string::npos) << message;
  EXPECT_LE(probe.GetHeapPeak(), options.MemoryLimit);
}
