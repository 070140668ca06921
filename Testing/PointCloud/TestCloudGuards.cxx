// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudShapes.h"

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphOptions;
using dgg::CloudGraphStatistics;
using dgg::CloudScheme;

/// Returns the number of edges of which exactly one end satisfies `first`.
template <typename Test>
int EdgesBetween(const CloudGraph& graph, Test&& first)
{
  int count = 0;
  const dgg::GraphView view = graph.Graph.View();
  for (Id v = 0; v < view.NumberOfVertices; ++v)
  {
    for (dgg::Offset e = view.Offsets[v]; e < view.Offsets[v + 1]; ++e)
    {
      count += first(v) != first(view.Targets[e]) ? 1 : 0;
    }
  }
  return count;
}

Cloud TwoSheets(int count, double gap, unsigned seed)
{
  Cloud cloud = Square(count, seed);
  const Cloud other = Square(count, seed + 1);
  for (Id i = 0; i < count; ++i)
  {
    cloud.Add(other.At(i) + Point3{ 0.0, 0.0, gap });
  }
  return cloud;
}
}

TEST(CloudGuards, SheetsThreeOffsetsApart)
{
  // With h given: two planes at a distance of 3 h voxels, in each scheme.
  for (const CloudScheme scheme :
    { CloudScheme::Curvature, CloudScheme::Constant, CloudScheme::Spacing })
  {
    const double h = 3.0;
    const double voxel = 1.0 / 90.0;
    const Cloud cloud = TwoSheets(4000, 3.0 * h * voxel, 1);
    CloudGraphStatistics statistics;
    const CloudGraph graph = BuildGraph(
      cloud,
      [&](CloudGraphOptions& options) {
        options.Scheme = scheme;
        options.OffsetInVoxels = h;
        options.Resolution = 90;
      },
      &statistics);
    EXPECT_NEAR(statistics.VoxelSize, voxel, 0.01 * voxel);
    EXPECT_EQ(EdgesBetween(graph, [](Id v) { return v < 4000; }), 0);
    ASSERT_GE(graph.ComponentSizes.size(), 2U);
    EXPECT_GT(graph.ComponentSizes[1], 3900);
  }
}

TEST(CloudGuards, SheetsCloserThanTwoBalls)
{
  // The balls overlap, but points near segments between the layers have inconsistent positions.
  const double spacing = 1.0 / std::sqrt(1500.0);
  for (const double gap : { 3.2, 3.5, 4.5 })
  {
    CloudGraphStatistics statistics;
    const CloudGraph graph = BuildGraph(TwoSheets(1500, gap * spacing, 3), nullptr, &statistics);
    EXPECT_EQ(EdgesBetween(graph, [](Id v) { return v < 1500; }), 0) << gap;
    EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 1500, 1500 })) << gap;
  }
}

TEST(CloudGuards, SheetsTwoSpacingsApart)
{
  // At this distance, random points leave no room for balls of the default size. With balls of a
  // third of the gap, or with oriented normals, layers stay separate, and each remains connected.
  const double spacing = 1.0 / 30.0;
  for (const double gap : { 2.2, 2.5, 2.8 })
  {
    Cloud cloud;
    for (int side = 0; side < 2; ++side)
    {
      const Cloud shifts = Square(900, 20 + side);
      for (Id i = 0; i < 900; ++i)
      {
        const Point3 p{ i % 30 + 0.8 * shifts.At(i).X, i / 30 + 0.8 * shifts.At(i).Y, gap * side };
        cloud.Add(spacing * p);
      }
    }
    const auto first = [](Id v) { return v < 900; };
    const double h = 4.0;
    const CloudGraph given = BuildGraph(cloud, [&](CloudGraphOptions& options) {
      options.OffsetInVoxels = h;
      options.Resolution = static_cast<Id>(std::ceil(3.0 * h / (gap * spacing)));
    });
    EXPECT_EQ(EdgesBetween(given, first), 0) << gap;
    ASSERT_GE(given.ComponentSizes.size(), 2U) << gap;
    EXPECT_GT(given.ComponentSizes[1], 870) << gap;

    std::vector<double> normals;
    for (Id i = 0; i < cloud.GetSize(); ++i)
    {
      normals.insert(normals.end(), { 0.0, 0.0, first(i) ? -1.0 : 1.0 });
    }
    const CloudGraph oriented = BuildGraph(cloud, [&](CloudGraphOptions& options) {
      options.Normals = normals.data();
      options.HasOrientedNormals = true;
    });
    EXPECT_EQ(EdgesBetween(oriented, first), 0) << gap;
    EXPECT_EQ(oriented.ComponentSizes, (std::vector<Id>{ 900, 900 })) << gap;
  }
}

TEST(CloudGuards, OrientedNormalsSeparateSheetsAtAnyReach)
{
  // With the default reach, chords between layers are up to 13 gaps long.
  const double spacing = 1.0 / std::sqrt(3000.0);
  const Cloud cloud = TwoSheets(3000, 0.8 * spacing, 5);
  std::vector<double> normals;
  for (Id i = 0; i < cloud.GetSize(); ++i)
  {
    normals.insert(normals.end(), { 0.0, 0.0, i < 3000 ? -1.0 : 1.0 });
  }
  const auto build = [&](bool oriented, double alpha) {
    return BuildGraph(cloud, [&](CloudGraphOptions& options) {
      options.Normals = normals.data();
      options.HasOrientedNormals = oriented;
      options.Alpha = alpha;
    });
  };
  const auto first = [](Id v) { return v < 3000; };
  EXPECT_GT(EdgesBetween(build(false, 4.0), first), 0);
  for (const double alpha : { 0.0, 4.0 })
  {
    const CloudGraph graph = build(true, alpha);
    EXPECT_EQ(EdgesBetween(graph, first), 0);
    EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 3000, 3000 }));
  }
}

TEST(CloudGuards, PointsWithoutAnOrientedNormalAreConnectedAsUsual)
{
  // Normals fitted to these points have an arbitrary sign.
  const Cloud cloud = Sphere(3000, 15);
  std::vector<double> normals = cloud.Points;
  for (Id i = 0; i < cloud.GetSize(); ++i)
  {
    if (i % 3 != 0)
    {
      std::fill_n(normals.begin() + 3 * i, 3, i % 3 == 1 ? 0.0 : std::nan(""));
    }
  }
  const auto build = [&](bool oriented) {
    return BuildGraph(cloud, [&](CloudGraphOptions& options) {
      options.Normals = normals.data();
      options.HasOrientedNormals = oriented;
    });
  };
  const CloudGraph oriented = build(true);
  EXPECT_EQ(oriented.ComponentSizes, (std::vector<Id>{ 3000 }));
  EXPECT_EQ(GraphDistances(oriented.Graph.View(), 0), GraphDistances(build(false).Graph.View(), 0));
}

TEST(CloudGuards, PathsGoAroundHoles)
{
  // A square without a disk: paths around the disk consist of tangents and arcs.
  const Cloud whole = Square(9000, 6);
  Cloud cloud;
  cloud.Add({ 0.15, 0.5, 0.0 });
  cloud.Add({ 0.85, 0.5, 0.0 });
  const double radius = 0.2;
  for (Id i = 0; i < whole.GetSize(); ++i)
  {
    const Point3 p = whole.At(i);
    if (std::hypot(p.X - 0.5, p.Y - 0.5) > radius)
    {
      cloud.Add(p);
    }
  }
  const CloudGraph graph = BuildGraph(cloud);
  EXPECT_EQ(graph.ComponentSizes.size(), 1U);
  const double tangent = std::sqrt(0.35 * 0.35 - radius * radius);
  const double truth = 2.0 * tangent + radius * (dgg::Pi - 2.0 * std::acos(radius / 0.35));
  const double found = GraphDistances(graph.Graph.View(), 0)[1];
  EXPECT_GT(found, 0.75); // not straight through the disk
  EXPECT_NEAR(found, truth, 0.015 * truth);
}

TEST(CloudGuards, GapsAreNotCrossed)
{
  const Cloud whole = Square(5000, 7);
  const double spacing = 1.0 / std::sqrt(5000.0);
  Cloud cloud;
  for (Id i = 0; i < whole.GetSize(); ++i)
  {
    if (std::abs(whole.At(i).X - 0.5) > 3.0 * spacing)
    {
      cloud.Add(whole.At(i));
    }
  }
  const CloudGraph graph = BuildGraph(cloud);
  EXPECT_EQ(EdgesBetween(graph, [&](Id v) { return cloud.At(v).X < 0.5; }), 0);
  EXPECT_EQ(graph.ComponentSizes.size(), 2U);
}

TEST(CloudGuards, PointsFarOffStayAlone)
{
  // Points above a square must not create bridges.
  Cloud cloud = Square(3000, 8);
  const double spacing = 1.0 / std::sqrt(3000.0);
  cloud.Add({ 0.5, 0.5, 8.0 * spacing });
  cloud.Add({ 0.52, 0.5, 9.0 * spacing });
  cloud.Add({ 0.2, 0.3, 20.0 * spacing });
  const CloudGraph graph = BuildGraph(cloud);
  EXPECT_EQ(graph.ComponentSizes[0], 3000);
  EXPECT_EQ(EdgesBetween(graph, [](Id v) { return v < 3000; }), 0);
}
