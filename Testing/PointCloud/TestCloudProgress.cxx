// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress of graphs of clouds, and abort requests.
#include "CloudShapes.h"

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphOptions;

/// Returns a callback that records progress and continues until `end` is reached.
dgg::ProgressCallback Keep(std::vector<double>& reported, double end = dgg::Infinity)
{
  return [&reported, end](double done) {
    reported.push_back(done);
    return done < end;
  };
}

/// Expects that `work` stops when call `calls` of the progress callback requests an abort, without
/// any further call.
void ExpectStop(std::size_t calls, CloudGraphOptions options,
  const std::function<dgg::Status(const CloudGraphOptions&)>& work)
{
  std::size_t called = 0;
  options.Progress = [&](double) { return ++called < calls; };
  EXPECT_TRUE(work(options).IsAborted());
  EXPECT_EQ(called, calls);
}
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
