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
  const std::vector<double> there = GraphDistances(a.Graph.View(), 0);
  const std::vector<double> back = GraphDistances(b.Graph.View(), cloud.GetSize() - 1);
  for (Id i = 0; i < cloud.GetSize(); ++i)
  {
    EXPECT_DOUBLE_EQ(there[i], back[cloud.GetSize() - 1 - i]);
  }
}

TEST(CloudGraph, ComponentsAreThoseOfTheGraph)
{
  // Two spheres, the second one smaller, and a distant point.
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
  const std::vector<double> distances = GraphDistances(graph.Graph.View(), 0);
  for (Id i = 0; i < cloud.GetSize(); ++i)
  {
    EXPECT_EQ(distances[i] < dgg::Infinity, graph.Components[i] == 1) << i;
  }
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
  // The extent is two units.
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

TEST(CloudGraph, AllPointsWithinReachAreNeighbors)
{
  // A small region of the square has 200 times the density of the rest: points there have far more
  // neighbors than others.
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
  // Almost all pairs have an edge; the others would leave the band at the border.
  EXPECT_GT(static_cast<double>(graph.Graph.Targets.Size()), 0.99 * static_cast<double>(pairs));
}
