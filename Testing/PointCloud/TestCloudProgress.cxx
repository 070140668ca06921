// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress of graphs of clouds, and requests to stop.
#include "CloudShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphEstimate;
using dgg::CloudGraphOptions;

/// Keeps what it is reported, and goes on until `end` is reached.
dgg::ProgressCallback Keep(std::vector<double>& reported, double end = dgg::Infinity)
{
  return [&reported, end](double done) {
    reported.push_back(done);
    return done < end;
  };
}

/// Looks never show less than the one before, and at least every third shows more.
void ExpectGrowth(std::vector<double> reported)
{
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  const std::size_t looks = reported.size();
  reported.erase(std::unique(reported.begin(), reported.end()), reported.end());
  EXPECT_GT(3 * reported.size(), looks);
}

/// Asked to stop at look number `calls`, `work` does, and looks no more.
void ExpectStop(std::size_t calls, CloudGraphOptions options,
  const std::function<dgg::Status(const CloudGraphOptions&)>& work)
{
  std::size_t called = 0;
  options.Progress = [&](double) { return ++called < calls; };
  EXPECT_TRUE(work(options).IsAborted());
  EXPECT_EQ(called, calls);
}

void ExpectStopOfPrediction(std::size_t calls, const Cloud& cloud)
{
  CloudGraphEstimate estimate;
  ExpectStop(calls, CloudGraphOptions(), [&](const CloudGraphOptions& options) {
    return MakeBuilder(cloud).Estimate(options, estimate);
  });
}
}

TEST(CloudGraph, PredictionsReportProgressAndStop)
{
  const Cloud cloud = Sphere(8000, 12);
  CloudGraphOptions options;
  std::vector<double> reported;
  options.Progress = Keep(reported);
  CloudGraphEstimate estimate;
  ASSERT_TRUE(MakeBuilder(cloud).Estimate(options, estimate).IsOk());
  EXPECT_GT(reported.size(), 20U);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_GT(reported.back(), 0.9);
  EXPECT_LE(reported.back(), 1.0);
  for (std::size_t calls = 1; calls < reported.size(); calls += 1 + reported.size() / 8)
  {
    ExpectStopOfPrediction(calls, cloud);
  }
}

TEST(CloudGraph, ProgressGrowsWhileNoiseIsRemoved)
{
  const Cloud cloud = Sphere(20000, 12, 0.01);
  CloudGraphOptions options;
  std::vector<double> reported;
  options.Progress = Keep(reported, 0.3); // fits come first
  CloudGraphEstimate estimate;
  EXPECT_TRUE(MakeBuilder(cloud).Estimate(options, estimate).IsAborted());
  EXPECT_GT(reported.size(), 12U); // five of each of three fits
  ExpectGrowth(reported);
}

TEST(CloudGraph, ReportsProgressAndStops)
{
  const Cloud cloud = Sphere(20000, 8);
  CloudGraphOptions options;
  options.Accuracy = 0.1;
  options.Alpha = 4.0;
  std::vector<double> reported;
  options.Progress = Keep(reported);
  CloudGraph graph;
  ASSERT_TRUE(MakeBuilder(cloud).Build(options, graph).IsOk());
  EXPECT_GT(reported.size(), 6U);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_GE(reported.front(), 0.0);
  EXPECT_EQ(reported.back(), 1.0);
  for (const std::size_t calls : { 1, 3, 6 })
  {
    ExpectStop(calls, options,
      [&](const CloudGraphOptions& stopping) { return MakeBuilder(cloud).Build(stopping, graph); });
    EXPECT_TRUE(graph.Graph.Offsets.IsEmpty());
  }
}

TEST(CloudGraph, ProgressGrowsWhileMuchNoiseIsRemoved)
{
  // More neighbours take longer: there are as many looks at each of them.
  const double spacing = std::sqrt(4.0 * dgg::Pi / 6000.0);
  const Cloud cloud = Sphere(6000, 13, 1.3 * spacing);
  CloudGraphOptions options;
  std::vector<double> reported;
  options.Progress = Keep(reported, 0.3);
  CloudGraphEstimate estimate;
  EXPECT_TRUE(MakeBuilder(cloud).Estimate(options, estimate).IsAborted());
  EXPECT_GT(reported.size(), 25U);
  ExpectGrowth(reported);
  for (std::size_t calls = 1; calls < reported.size(); calls += 1 + reported.size() / 8)
  {
    ExpectStopOfPrediction(calls, cloud);
  }
}

TEST(CloudGraph, ProgressOfHugeReaches)
{
  // Each row looks at all points: there are few of them between two looks.
  const Cloud cloud = Sphere(2000, 14);
  CloudGraphOptions options;
  options.Accuracy = 0.5;
  options.Alpha = 1e6;
  double first = 0.0; // after some rows
  options.Progress = [&](double done) {
    first = done;
    return done < 0.17;
  };
  CloudGraph graph;
  EXPECT_TRUE(MakeBuilder(cloud).Build(options, graph).IsAborted());
  EXPECT_LT(first, 0.3);
}
