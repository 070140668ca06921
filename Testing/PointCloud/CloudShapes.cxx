// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudShapes.h"

namespace cloudtest
{
Cloud Sphere(int count, unsigned seed, double noise)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> number;
  Cloud cloud;
  auto clean = std::make_shared<std::vector<Point3>>();
  for (int i = 0; i < count; ++i)
  {
    const Point3 p{ number(generator), number(generator), number(generator) };
    clean->push_back((1.0 / dgg::Norm(p)) * p);
    const Point3 error{ number(generator), number(generator), number(generator) };
    cloud.Add(clean->back() + noise * error);
  }
  cloud.Distance = [clean](Id a, Id b) {
    const Point3& p = (*clean)[a];
    const Point3& q = (*clean)[b];
    return std::atan2(dgg::Norm(dgg::Cross(p, q)), dgg::Dot(p, q));
  };
  return cloud;
}

namespace
{
void MeasureStraight(Cloud& cloud)
{
  auto points = std::make_shared<std::vector<double>>(cloud.Points);
  cloud.Distance = [points](Id a, Id b) {
    const double* p = points->data() + 3 * static_cast<std::size_t>(a);
    const double* q = points->data() + 3 * static_cast<std::size_t>(b);
    return dgg::Norm(Point3{ p[0] - q[0], p[1] - q[1], p[2] - q[2] });
  };
}
}

Cloud Square(int count, unsigned seed, double gradient)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  Cloud cloud;
  while (cloud.GetSize() < count)
  {
    const double x = place(generator);
    const double y = place(generator);
    if (place(generator) * gradient <= 1.0 + (gradient - 1.0) * x)
    {
      cloud.Add({ x, y, 0.0 });
    }
  }
  MeasureStraight(cloud);
  return cloud;
}

Cloud Grid(int n)
{
  Cloud cloud;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      cloud.Add({ static_cast<double>(i) / (n - 1), static_cast<double>(j) / (n - 1), 0.0 });
    }
  }
  MeasureStraight(cloud);
  return cloud;
}

Cloud Cylinder(int count, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  Cloud cloud;
  auto flat = std::make_shared<std::vector<std::pair<double, double>>>();
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * dgg::Pi * part(generator);
    const double height = 3.0 * part(generator);
    flat->emplace_back(angle, height);
    cloud.Add({ std::cos(angle), std::sin(angle), height });
  }
  cloud.Distance = [flat](Id a, Id b) {
    const double turn = std::abs((*flat)[a].first - (*flat)[b].first);
    return std::hypot(std::min(turn, 2.0 * dgg::Pi - turn), (*flat)[a].second - (*flat)[b].second);
  };
  return cloud;
}

dgg::CloudGraphBuilder MakeBuilder(const Cloud& cloud)
{
  return { cloud.Points.data(), cloud.GetSize() };
}

dgg::CloudGraphEstimate Predict(const Cloud& cloud, const dgg::CloudGraphOptions& options)
{
  dgg::CloudGraphEstimate estimate;
  const dgg::Status status = MakeBuilder(cloud).Estimate(options, estimate);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return estimate;
}

std::string GetRefusal(const Cloud& cloud, const dgg::CloudGraphOptions& options)
{
  dgg::CloudGraph graph;
  return dgg::Render(MakeBuilder(cloud).Build(options, graph).GetMessage());
}

dgg::CloudGraph BuildGraph(const Cloud& cloud,
  const std::function<void(dgg::CloudGraphOptions&)>& change, dgg::CloudGraphStatistics* statistics)
{
  dgg::CloudGraphOptions options;
  if (change)
  {
    change(options);
  }
  dgg::CloudGraph graph;
  dgg::Status status = MakeBuilder(cloud).Build(options, graph, statistics);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  const dgg::GraphView view = graph.Graph.View();
  status = dgg::CheckGraph(view, static_cast<dgg::Offset>(graph.Graph.Targets.Size()));
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  EXPECT_EQ(view.NumberOfVertices, status.IsOk() ? cloud.GetSize() : view.NumberOfVertices);
  EXPECT_EQ(view.Info.Kind, dgg::GraphKind::Cloud);
  // Edges must be symmetric, and every row sorted by target.
  for (Id v = 0; v < view.NumberOfVertices; ++v)
  {
    for (dgg::Offset e = view.Offsets[v]; e < view.Offsets[v + 1]; ++e)
    {
      EXPECT_TRUE(e == view.Offsets[v] || view.Targets[e - 1] < view.Targets[e]);
      const Id t = view.Targets[e];
      const Id* begin = view.Targets + view.Offsets[t];
      const Id* end = view.Targets + view.Offsets[t + 1];
      const Id* back = std::lower_bound(begin, end, v);
      if (back == end || *back != v || view.Length(back - view.Targets) != view.Length(e))
      {
        ADD_FAILURE() << "edge " << v << " " << t << " is not the same both ways round";
        return graph;
      }
    }
  }
  return graph;
}

Errors MeasureErrors(const Cloud& cloud, const dgg::GraphView& graph, double least)
{
  Errors errors;
  int count = 0;
  for (Id source = 0; source < 3 && source < cloud.GetSize(); ++source)
  {
    const std::vector<double> distances = GraphDistances(graph, source);
    for (Id v = 0; v < cloud.GetSize(); ++v)
    {
      const double truth = cloud.Distance(source, v);
      if (!(truth > least) || v == source)
      {
        continue;
      }
      if (distances[v] == dgg::Infinity)
      {
        ++errors.Unreached;
        continue;
      }
      const double error = (distances[v] - truth) / truth;
      errors.Mean += std::abs(error);
      errors.Bias += error;
      errors.Max = std::max(errors.Max, std::abs(error));
      ++count;
    }
  }
  errors.Mean /= std::max(1, count);
  errors.Bias /= std::max(1, count);
  return errors;
}
}
