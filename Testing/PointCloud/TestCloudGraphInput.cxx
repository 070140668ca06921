// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphOptions;
using dgg::CloudGraphStatistics;
using dgg::CloudScheme;
using dgg::NoId;

constexpr CloudScheme AllSchemes[] = { CloudScheme::Curvature, CloudScheme::Constant,
  CloudScheme::Spacing };
}

TEST(CloudGraphInput, VeryFewPoints)
{
  for (const CloudScheme scheme : AllSchemes)
  {
    const auto choose = [&](CloudGraphOptions& options) { options.Scheme = scheme; };
    Cloud cloud;
    EXPECT_TRUE(BuildGraph(cloud, choose).ComponentSizes.empty());
    cloud.Add({ 1.0, 2.0, 3.0 });
    const CloudGraph one = BuildGraph(cloud, choose);
    EXPECT_EQ(one.ComponentSizes, (std::vector<Id>{ 1 }));
    EXPECT_TRUE(one.Graph.Targets.IsEmpty());
    cloud.Add({ 2.0, 2.0, 3.0 });
    const CloudGraph two = BuildGraph(cloud, choose);
    EXPECT_EQ(two.ComponentSizes, (std::vector<Id>{ 2 }));
    ASSERT_EQ(two.Graph.Targets.Size(), 2U);
    EXPECT_EQ(two.Graph.Lengths[0], 1.0f);
    cloud.Add({ 1.5, 3.0, 3.0 });
    EXPECT_EQ(BuildGraph(cloud, choose).ComponentSizes, (std::vector<Id>{ 3 }));
  }
}

TEST(CloudGraphInput, PointsThatAreNotFiniteAreLeftOut)
{
  const Cloud whole = Sphere(1500, 1);
  Cloud cloud;
  const double bad[3] = { std::nan(""), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  std::vector<Id> places;
  for (Id i = 0; i < whole.GetSize(); ++i)
  {
    if (i % 500 == 3)
    {
      Point3 p = whole.At(i);
      (i / 500 == 0 ? p.X : i / 500 == 1 ? p.Y : p.Z) = bad[i / 500];
      cloud.Add(p);
    }
    places.push_back(cloud.GetSize());
    cloud.Add(whole.At(i));
  }
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
  EXPECT_EQ(statistics.UnusedPoints, 3);
  EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 1500 }));
  for (const Id v : { 3, 504, 1005 })
  {
    EXPECT_EQ(graph.Components[v], NoId);
    EXPECT_EQ(graph.Radii[v], 0.0);
    EXPECT_EQ(graph.Graph.Offsets[v], graph.Graph.Offsets[v + 1]);
  }
  // The others are connected as if there were nothing else.
  const std::vector<double> truth = DistancesFrom(BuildGraph(whole).Graph.View(), 0);
  const std::vector<double> found = DistancesFrom(graph.Graph.View(), places[0]);
  for (Id i = 0; i < whole.GetSize(); ++i)
  {
    EXPECT_EQ(found[places[i]], truth[i]);
  }
  Cloud nothing;
  nothing.Add({ std::nan(""), 0.0, 0.0 });
  nothing.Add({ 0.0, bad[1], 0.0 });
  const CloudGraph empty = BuildGraph(nothing);
  EXPECT_EQ(empty.Components, (std::vector<Id>{ NoId, NoId }));
  EXPECT_TRUE(empty.ComponentSizes.empty());
}

TEST(CloudGraphInput, CoincidentPointsAreJoined)
{
  Cloud cloud = Sphere(1500, 2);
  const CloudGraph single = BuildGraph(cloud);
  for (const Id i : { 5, 5, 5, 700 })
  {
    cloud.Add(cloud.At(i));
  }
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
  EXPECT_EQ(statistics.CoincidentPoints, 4);
  EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 1504 }));
  const std::vector<double> distances = DistancesFrom(graph.Graph.View(), 1501);
  EXPECT_LT(distances[5], 1e-11);
  EXPECT_LT(distances[1502], 1e-11);
  EXPECT_GT(distances[5], 0.0);
  const std::vector<double> truth = DistancesFrom(single.Graph.View(), 5);
  for (Id i = 0; i < 1500; ++i)
  {
    EXPECT_NEAR(distances[i], truth[i], 1e-10);
  }
  // Nothing but copies.
  Cloud copies;
  for (int i = 0; i < 100; ++i)
  {
    copies.Add({ 3.0, 3.0, 3.0 });
  }
  EXPECT_EQ(BuildGraph(copies).ComponentSizes, (std::vector<Id>{ 100 }));
  // Many copies of each point change nothing either.
  Cloud tenfold;
  const Cloud few = Sphere(400, 3);
  for (int copy = 0; copy < 30; ++copy)
  {
    for (Id i = 0; i < few.GetSize(); ++i)
    {
      tenfold.Add(few.At(i));
    }
  }
  const std::vector<double> a = DistancesFrom(BuildGraph(few).Graph.View(), 0);
  const std::vector<double> b = DistancesFrom(BuildGraph(tenfold).Graph.View(), 0);
  for (Id i = 0; i < 400; ++i)
  {
    EXPECT_NEAR(a[i], b[i], 1e-9);
  }
}

TEST(CloudGraphInput, NearlyCoincidentPoints)
{
  // Each point twice, a millionth of the spacing apart.
  Cloud cloud = Sphere(1000, 4);
  for (Id i = 0; i < 1000; ++i)
  {
    cloud.Add(cloud.At(i) + Point3{ 1e-7, -1e-7, 1e-7 });
  }
  const CloudGraph graph = BuildGraph(cloud);
  EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 2000 }));
  EXPECT_NEAR(DistancesFrom(graph.Graph.View(), 0)[1000], std::sqrt(3.0) * 1e-7, 1e-9);
}

TEST(CloudGraphInput, PointsInALine)
{
  for (const CloudScheme scheme : AllSchemes)
  {
    Cloud cloud;
    for (int i = 0; i <= 200; ++i)
    {
      cloud.Add({ 0.01 * i, 0.02 * i, -0.02 * i });
    }
    const CloudGraph graph =
      BuildGraph(cloud, [&](CloudGraphOptions& options) { options.Scheme = scheme; });
    EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 201 }));
    const std::vector<double> distances = DistancesFrom(graph.Graph.View(), 0);
    for (Id i = 0; i <= 200; ++i)
    {
      EXPECT_NEAR(distances[i], 0.03 * i, 1e-6);
    }
  }
}

TEST(CloudGraphInput, ScaleAndPlaceDoNotMatter)
{
  const Cloud cloud = Sphere(1200, 5);
  const std::vector<double> truth = DistancesFrom(BuildGraph(cloud).Graph.View(), 0);
  const CloudGraph unscaled = BuildGraph(cloud);
  for (const double scale : { 1e-70, 1e-40, 1e-30, 1e-6, 1e6, 1e30, 1e40, 1e70 })
  {
    Cloud scaled;
    for (Id i = 0; i < cloud.GetSize(); ++i)
    {
      scaled.Add(scale * cloud.At(i));
    }
    CloudGraphStatistics statistics;
    const CloudGraph graph = BuildGraph(scaled, nullptr, &statistics);
    const std::vector<double> found = DistancesFrom(graph.Graph.View(), 0);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      EXPECT_NEAR(found[i] / scale, truth[i], 5e-3 * truth[i]) << scale;
    }
    EXPECT_NEAR(statistics.Spacing / scale, 0.1023, 0.01);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      EXPECT_NEAR(graph.Radii[i] / scale, unscaled.Radii[i], 0.01 * unscaled.Radii[i]) << scale;
    }
  }
  Cloud far;
  for (Id i = 0; i < cloud.GetSize(); ++i)
  {
    far.Add(cloud.At(i) + Point3{ 1e6, -1e6, 2e6 });
  }
  const std::vector<double> found = DistancesFrom(BuildGraph(far).Graph.View(), 0);
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    EXPECT_NEAR(found[i], truth[i], 5e-3 * truth[i]);
  }
}

TEST(CloudGraphInput, CoordinatesOutOfRange)
{
  for (const double scale : { 1e200, 1e-200 })
  {
    Cloud cloud = Sphere(50, 6);
    for (double& x : cloud.Points)
    {
      x *= scale;
    }
    CloudGraph graph;
    const dgg::Status status = dgg::CloudGraphBuilder(cloud.Points.data(), cloud.GetSize())
                                 .Build(CloudGraphOptions(), graph);
    EXPECT_FALSE(status.IsOk());
    EXPECT_NE(status.GetMessage().find("scale them"), std::string::npos);
  }
}
