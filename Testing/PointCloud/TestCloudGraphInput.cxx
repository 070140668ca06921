// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudShapes.h"

#include <sstream>

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
  // The other points are connected as if the invalid points did not exist.
  const std::vector<double> truth = GraphDistances(BuildGraph(whole).Graph.View(), 0);
  const std::vector<double> found = GraphDistances(graph.Graph.View(), places[0]);
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
  const std::vector<double> distances = GraphDistances(graph.Graph.View(), 1501);
  EXPECT_LT(distances[5], 1e-11);
  EXPECT_LT(distances[1502], 1e-11);
  EXPECT_GT(distances[5], 0.0);
  const std::vector<double> truth = GraphDistances(single.Graph.View(), 5);
  for (Id i = 0; i < 1500; ++i)
  {
    EXPECT_NEAR(distances[i], truth[i], 1e-10);
  }
  // A cloud of copies of a single point.
  Cloud copies;
  for (int i = 0; i < 100; ++i)
  {
    copies.Add({ 3.0, 3.0, 3.0 });
  }
  EXPECT_EQ(BuildGraph(copies).ComponentSizes, (std::vector<Id>{ 100 }));
  // Many copies of each point have no effect either.
  Cloud tenfold;
  const Cloud few = Sphere(400, 3);
  for (int copy = 0; copy < 30; ++copy)
  {
    for (Id i = 0; i < few.GetSize(); ++i)
    {
      tenfold.Add(few.At(i));
    }
  }
  const std::vector<double> a = GraphDistances(BuildGraph(few).Graph.View(), 0);
  const std::vector<double> b = GraphDistances(BuildGraph(tenfold).Graph.View(), 0);
  for (Id i = 0; i < 400; ++i)
  {
    EXPECT_NEAR(a[i], b[i], 1e-9);
  }
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
    const std::vector<double> distances = GraphDistances(graph.Graph.View(), 0);
    for (Id i = 0; i <= 200; ++i)
    {
      EXPECT_NEAR(distances[i], 0.03 * i, 1e-6);
    }
  }
}

TEST(CloudGraphInput, ScaleAndPlaceDoNotMatter)
{
  const Cloud cloud = Sphere(1200, 5);
  const std::vector<double> truth = GraphDistances(BuildGraph(cloud).Graph.View(), 0);
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
    const std::vector<double> found = GraphDistances(graph.Graph.View(), 0);
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
  const std::vector<double> found = GraphDistances(BuildGraph(far).Graph.View(), 0);
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    EXPECT_NEAR(found[i], truth[i], 5e-3 * truth[i]);
  }
}

TEST(CloudGraphInput, OutliersChangeNothing)
{
  // At such distances, outliers would leave no digits, no voxels and no short edges for the other
  // points.
  const Cloud clean = Sphere(800, 21);
  const CloudGraph expected = BuildGraph(clean);
  const std::vector<double> truth = GraphDistances(expected.Graph.View(), 7);
  const auto check = [&](const std::vector<Point3>& outliers, std::size_t places) {
    Cloud cloud;
    const auto half = static_cast<Id>(outliers.size() / 2);
    for (Id i = 0; i < half; ++i)
    {
      cloud.Add(outliers[i]);
    }
    cloud.Points.insert(cloud.Points.end(), clean.Points.begin(), clean.Points.end());
    for (std::size_t i = half; i < outliers.size(); ++i)
    {
      cloud.Add(outliers[i]);
    }
    CloudGraphStatistics statistics;
    const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
    EXPECT_EQ(statistics.Outliers, static_cast<Id>(outliers.size()));
    EXPECT_EQ(statistics.CoincidentPoints, static_cast<Id>(outliers.size() - places));
    EXPECT_EQ(graph.ComponentSizes.size(), 1 + places);
    EXPECT_EQ(graph.ComponentSizes[0], 800);
    EXPECT_EQ(graph.VoxelSize, expected.VoxelSize);
    const std::vector<double> found = GraphDistances(graph.Graph.View(), half + 7);
    for (Id i = 0; i < 800; ++i)
    {
      ASSERT_EQ(found[half + i], truth[i]) << i;
    }
    for (Id i = 0; i < cloud.GetSize(); ++i)
    {
      const bool isStray = i < half || i >= half + 800;
      EXPECT_EQ(graph.Components[i] != 0, isStray);
      EXPECT_EQ(graph.Radii[i] == 0.0, isStray);
    }
  };
  for (const double off : { 2e3, 2e6, 2e9, 1e200 })
  {
    check({ { off, 0.3, -0.2 } }, 1);
    check({ { -0.1, off, -off }, { -off, off, -off }, { -off, off, -off } }, 2);
  }
  check({ { 0.0, 0.0, 2e3 }, { 0.0, 4e6, 0.0 }, { 8e9, 0.0, 0.0 }, { 0.0, -2e13, 0.0 } }, 4);
  // The value by which scanners mark missing points, many times.
  check(std::vector<Point3>(500, { -9999.0, -9999.0, -9999.0 }), 1);
}

TEST(CloudGraphInput, PartsThatAreFarApart)
{
  // Too many points to be outliers: each part has the same result as alone, up to the accuracy.
  const Cloud clean = Sphere(1000, 22);
  const std::vector<double> truth = GraphDistances(BuildGraph(clean).Graph.View(), 0);
  const auto add = [&](double off, Id count) {
    Cloud cloud = clean;
    for (Id i = 0; i < count; ++i)
    {
      cloud.Add(clean.At(i) + Point3{ off, 0.0, 0.0 });
    }
    return cloud;
  };
  for (const double off : { 10.0, 1e3, 1e5 })
  {
    const CloudGraph graph = BuildGraph(add(off, 1000));
    EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 1000, 1000 })) << off;
    const std::vector<double> found = GraphDistances(graph.Graph.View(), 0);
    for (Id i = 1; i < 1000; ++i)
    {
      EXPECT_NEAR(found[i], truth[i], 2e-3 * truth[i]) << off;
    }
  }
  for (const double off : { 1e8, 1e12 })
  {
    const Cloud cloud = add(off, 500);
    CloudGraph graph;
    const dgg::Status status = MakeBuilder(cloud).Build(CloudGraphOptions(), graph);
    EXPECT_FALSE(status.IsOk());
    std::ostringstream distance;
    distance << off;
    EXPECT_NE(status.GetMessage().find("too far apart"), std::string::npos);
    EXPECT_NE(status.GetMessage().find(distance.str()), std::string::npos) << status.GetMessage();
    EXPECT_TRUE(graph.Components.empty());
  }
}

TEST(CloudGraphInput, PartsThatAreFarApartHaveTheirDigits)
{
  // At any resolution, edges equal those of each part alone, or an error is reported.
  const Cloud clean = Square(300, 26);
  const auto change = [](CloudGraphOptions& options) {
    options.Resolution = 1000;
    options.Accuracy = 0.0;
  };
  const auto add = [&](double off) {
    Cloud cloud = clean;
    for (Id i = 0; i < clean.GetSize(); ++i)
    {
      cloud.Add(clean.At(i) + Point3{ off, 0.0, 0.0 });
    }
    return cloud;
  };
  const CloudGraph graph = BuildGraph(add(1e7), change);
  const dgg::GraphView view = graph.Graph.View();
  int edges = 0;
  for (Id v = 0; v < clean.GetSize(); ++v)
  {
    for (dgg::Offset e = view.Offsets[v]; e < view.Offsets[v + 1]; ++e)
    {
      const double length = dgg::Norm(clean.At(v) - clean.At(view.Targets[e]));
      EXPECT_NEAR(view.Length(e), length, 2e-7 * length + 1e-9);
      ++edges;
    }
  }
  EXPECT_GT(edges, 300);
  for (const double off : { 1e9, 1e12, 1e14 })
  {
    const Cloud cloud = add(off);
    CloudGraphOptions options;
    change(options);
    CloudGraph refused;
    const dgg::Status status = MakeBuilder(cloud).Build(options, refused);
    EXPECT_FALSE(status.IsOk()) << off;
    EXPECT_NE(status.GetMessage().find("too far apart for the precision"), std::string::npos);
    EXPECT_EQ(status.GetMessage().find("esolution"), std::string::npos) << status.GetMessage();
  }
}

TEST(CloudGraphInput, AFewPointsTogetherOffTheOthers)
{
  // Each of these points has more neighbors within its group than outside. Their balls must not
  // grow to the distance of the other points, and must not enlarge all voxels.
  const Cloud clean = Square(1500, 23);
  const double spacing = 1.0 / std::sqrt(1500.0);
  CloudGraphStatistics expected;
  const std::vector<double> truth =
    GraphDistances(BuildGraph(clean, nullptr, &expected).Graph.View(), 0);
  for (const Id count : { 3, 9, 12, 16 })
  {
    Cloud cloud = clean;
    for (Id i = 0; i < count; ++i)
    {
      cloud.Add({ 0.5 + spacing * (i % 4), 0.5 + spacing * (i / 4), 1.2 });
    }
    CloudGraphStatistics statistics;
    const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
    EXPECT_EQ(statistics.Outliers, 0);
    EXPECT_NEAR(statistics.VoxelSize, expected.VoxelSize, 0.01 * expected.VoxelSize) << count;
    EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ 1500, count }));
    const std::vector<double> found = GraphDistances(graph.Graph.View(), 0);
    for (Id i = 1; i < 1500; ++i)
    {
      EXPECT_NEAR(found[i], truth[i], 2e-3 * truth[i]) << count; // both have this accuracy
    }
  }
}

TEST(CloudGraphInput, ShortEdgesAreAsLongAsTheyAre)
{
  // Edges shorter than those that connect coincident points. Outliers do not lengthen the latter.
  Cloud cloud = Sphere(1000, 24);
  cloud.Points[0] = cloud.Points[1] = cloud.Points[2] = 0.0;
  cloud.Points[3] = 1e-14;
  cloud.Points[4] = cloud.Points[5] = 0.0;
  const CloudGraph graph = BuildGraph(cloud);
  const dgg::GraphView view = graph.Graph.View();
  double found = 0.0;
  for (dgg::Offset e = view.Offsets[0]; e < view.Offsets[1]; ++e)
  {
    found = view.Targets[e] == 1 ? view.Length(e) : found;
  }
  EXPECT_NEAR(found, 1e-14, 1e-19);
}
