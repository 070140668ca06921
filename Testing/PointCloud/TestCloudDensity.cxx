// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds with much sparser parts: voxels that are large enough for the sparse parts are larger than
// the balls of the dense parts.
#include "CloudShapes.h"

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphOptions;
using dgg::CloudGraphStatistics;

/// Returns the points of a scanner above flat ground, in equal angular steps, from a circle of
/// radius 1 to a circle of radius `farthest`.
Cloud FlatScan(int rings, int perRing, double height, double farthest)
{
  Cloud cloud;
  const double first = std::atan2(height, 1.0);
  const double last = std::atan2(height, farthest);
  for (int ring = 0; ring < rings; ++ring)
  {
    const double radius = height / std::tan(first + ring * (last - first) / (rings - 1));
    for (int i = 0; i < perRing; ++i)
    {
      const double angle = 2.0 * dgg::Pi * i / perRing;
      cloud.Add({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
    }
  }
  return cloud;
}

/// Returns the memory of the band and its tables, bytes per point.
double BandPerPoint(const Cloud& cloud, const CloudGraphStatistics& statistics)
{
  return static_cast<double>(statistics.BandMemory) / cloud.GetSize();
}

/// Returns the mean relative error of distances from the first point to points of a sphere, which
/// come first in the cloud.
double ErrorOnSphere(const Cloud& sphere, const CloudGraph& graph)
{
  const std::vector<double> found = GraphDistances(graph.Graph.View(), 0);
  double sum = 0.0;
  for (Id i = 1; i < sphere.GetSize(); ++i)
  {
    const double truth = sphere.Distance(0, i);
    sum += std::abs(found[static_cast<std::size_t>(i)] - truth) / truth;
  }
  return sum / (sphere.GetSize() - 1);
}

double Sqr(double x)
{
  return x * x;
}
}

TEST(CloudDensity, ScansOfFlatGround)
{
  // The density near the scanner is hundreds of times the density at the rim.
  const Cloud cloud = FlatScan(20, 64, 1.8, 200.0);
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
  EXPECT_LT(BandPerPoint(cloud, statistics), 20e3);
  EXPECT_GT(statistics.VoxelSize, statistics.Spacing); // otherwise nothing is tested
  // Distant rings fall apart; paths between connected rings turn around the middle.
  EXPECT_GT(graph.ComponentSizes[0], 14 * 64);
  const std::vector<double> found = GraphDistances(graph.Graph.View(), 0);
  double worst = 0.0;
  double sum = 0.0;
  int count = 0;
  for (Id i = 1; i < cloud.GetSize(); ++i)
  {
    // The circle around the empty middle is an obstacle: beyond the tangent point, paths first
    // follow the circle.
    const Point3 p = cloud.At(i);
    const double radius = dgg::Norm(p);
    const double angle = std::acos(std::min(1.0, p.X / radius));
    const double toTangent = std::acos(std::min(1.0, 1.0 / radius));
    const double truth = angle <= toTangent ? dgg::Norm(p - cloud.At(0))
                                            : angle - toTangent + std::sqrt(Sqr(radius) - 1.0);
    if (graph.Components[i] == graph.Components[0] && truth > 0.3)
    {
      const double error = std::abs(found[i] - truth) / truth;
      worst = std::max(worst, error);
      sum += error;
      ++count;
    }
  }
  EXPECT_LT(sum / count, 2e-2); // there are few points
  EXPECT_LT(worst, 0.1);
}

TEST(CloudDensity, HolesOfDensePartsAreGoneAround)
{
  // A dense square with a hole that is narrower than a voxel, and a sparse square next to it.
  Cloud cloud;
  const Cloud dense = Square(1000, 4);
  const auto isHole = [](const Point3& p) {
    return std::abs(p.X - 0.5) < 0.1 && std::abs(p.Y - 0.5) < 0.3;
  };
  for (Id i = 0; i < dense.GetSize(); ++i)
  {
    if (!isHole(dense.At(i)))
    {
      cloud.Add(dense.At(i));
    }
  }
  const Id count = cloud.GetSize();
  const Cloud sparse = Square(200, 5);
  for (Id i = 0; i < sparse.GetSize(); ++i)
  {
    cloud.Add(Point3{ 50.0, 0.0, 0.0 } + 300.0 * sparse.At(i));
  }
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
  EXPECT_GT(statistics.VoxelSize, 0.2); // otherwise nothing is tested
  EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ count, 200 }));
  const dgg::GraphView view = graph.Graph.View();
  for (Id v = 0; v < count; ++v)
  {
    for (dgg::Offset e = view.Offsets[v]; e < view.Offsets[v + 1]; ++e)
    {
      const Point3 p = cloud.At(v);
      const Point3 q = cloud.At(view.Targets[e]);
      const bool isAcross =
        (p.X < 0.4 && q.X > 0.6) && std::abs(p.Y - 0.5) < 0.2 && std::abs(q.Y - 0.5) < 0.2;
      ASSERT_FALSE(isAcross) << v << ' ' << view.Targets[e];
    }
  }
}

TEST(CloudDensity, ManyPointsFarOff)
{
  // The distant points are too many to be outliers, and their balls are larger than the rest of the
  // cloud.
  const Cloud clean = Sphere(1000, 22);
  Cloud cloud = clean;
  const Cloud off = Sphere(25, 23);
  for (Id i = 0; i < off.GetSize(); ++i)
  {
    cloud.Add((1e4 + 300.0 * i) * off.At(i));
  }
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
  EXPECT_GT(statistics.VoxelSize, 2.0); // otherwise nothing is tested
  EXPECT_LT(BandPerPoint(cloud, statistics), 60e3);
  ASSERT_EQ(graph.ComponentSizes[0], 1000);
  EXPECT_LT(ErrorOnSphere(clean, graph), 1.2 * ErrorOnSphere(clean, BuildGraph(clean)));
}

TEST(CloudDensity, VoxelsThatAreTooLargeDoNotMatter)
{
  const Cloud cloud = Sphere(1000, 24);
  const double error = ErrorOnSphere(cloud, BuildGraph(cloud));
  for (const Id resolution : { 1, 2, 5 })
  {
    const CloudGraph graph =
      BuildGraph(cloud, [&](CloudGraphOptions& options) { options.Resolution = resolution; });
    EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 1000 })) << resolution;
    EXPECT_LT(ErrorOnSphere(cloud, graph), 1.2 * error) << resolution;
  }
}

TEST(CloudDensity, RefusedBandsAreReportedInNumbers)
{
  const Cloud cloud = Sphere(1000, 25);
  const auto build = [&](Id resolution, std::size_t limit) {
    CloudGraphOptions options;
    options.Resolution = resolution;
    options.MemoryLimit = limit;
    return GetRefusal(cloud, options);
  };
  const std::string given = build(4000, 50U << 20);
  for (const char* text : { "4000 voxels along the longest side", "of size 0.000",
         "GiB, more than the limit of 50 MiB", "Use a Resolution below 4000", "raise MemoryLimit" })
  {
    EXPECT_NE(given.find(text), std::string::npos) << text << " in: " << given;
  }
  const std::string automatic = build(0, 400U << 10);
  for (const char* text :
    { "40 (automatic) voxels", "more than the limit of 400 KiB", "Use a Resolution below " })
  {
    EXPECT_NE(automatic.find(text), std::string::npos) << text << " in: " << automatic;
  }
}
