// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Noise is removed where it is, and nothing else is.
#include "CloudShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphStatistics;

/// Move all points that are chosen, along each axis.
template <typename Choice>
void AddNoise(Cloud& cloud, double noise, Choice&& isChosen)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> number(0.0, noise);
  for (Id i = 0; i < cloud.GetSize(); ++i)
  {
    for (Id k = 3 * i; k < 3 * i + 3; ++k)
    {
      const double error = number(generator);
      cloud.Points[k] += isChosen(i) ? error : 0.0;
    }
  }
}

bool IsAny(Id)
{
  return true;
}

/// Whether an edge leads from the first points to the others.
bool AreConnected(const CloudGraph& graph, Id first)
{
  const dgg::GraphView view = graph.Graph.View();
  for (Id v = 0; v < first; ++v)
  {
    for (dgg::Offset e = view.Offsets[v]; e < view.Offsets[v + 1]; ++e)
    {
      if (view.Targets[e] >= first)
      {
        return true;
      }
    }
  }
  return false;
}
}

TEST(CloudNoise, SheetsStayApart)
{
  struct Case
  {
    double Gap; ///< in spacings, as the noise
    double Noise;
  };
  constexpr Id count = 2000;
  const double spacing = 1.0 / std::sqrt(count);
  for (const Case& c : { Case{ 3.5, 0.05 }, Case{ 3.5, 0.1 }, Case{ 5.0, 0.1 }, Case{ 5.0, 0.2 } })
  {
    Cloud cloud = Square(count, 3);
    const Cloud other = Square(count, 4);
    for (Id i = 0; i < count; ++i)
    {
      cloud.Add(other.At(i) + Point3{ 0.0, 0.0, c.Gap * spacing });
    }
    AddNoise(cloud, c.Noise * spacing, IsAny);
    CloudGraphStatistics statistics;
    const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
    EXPECT_NEAR(statistics.Noise, c.Noise * spacing, 0.2 * c.Noise * spacing);
    EXPECT_FALSE(AreConnected(graph, count)) << c.Gap << " " << c.Noise;
    EXPECT_EQ(graph.ComponentSizes, (std::vector<Id>{ count, count })) << c.Gap << " " << c.Noise;
  }
}

TEST(CloudNoise, PointsFarOffAreNotMoved)
{
  constexpr Id count = 2000;
  const double spacing = 1.0 / std::sqrt(count);
  for (const double noise : { 0.1, 0.3, 0.6 })
  {
    Cloud cloud = Square(count, 8);
    AddNoise(cloud, noise * spacing, IsAny);
    cloud.Add({ 0.5, 0.5, 8.0 * spacing });
    cloud.Add({ 0.2, 0.3, 20.0 * spacing });
    cloud.Add({ 0.7, 0.7, 6.0 * spacing });
    CloudGraphStatistics statistics;
    const CloudGraph graph = BuildGraph(cloud, nullptr, &statistics);
    EXPECT_GT(statistics.Noise, 0.7 * noise * spacing);
    EXPECT_FALSE(AreConnected(graph, count)) << noise;
    EXPECT_EQ(graph.ComponentSizes[0], count) << noise;
  }
}

TEST(CloudNoise, CreasesBesideItStaySharp)
{
  // A roof of which most is noisy: what is clean, crease included, must be as if all were.
  constexpr Id count = 5000;
  const double spacing = 1.0 / std::sqrt(count);
  const double part = 0.35;
  const Cloud flat = Square(count, 9);
  Cloud clean;
  for (Id i = 0; i < count; ++i)
  {
    const Point3 p = flat.At(i);
    clean.Add(std::sqrt(0.5) * Point3{ std::sqrt(2.0) * p.X, p.Y, 0.5 - std::abs(p.Y - 0.5) });
  }
  Cloud noisy = clean;
  AddNoise(noisy, 0.3 * spacing, [&](Id i) { return flat.At(i).X > part; });
  CloudGraphStatistics statistics;
  const CloudGraph graphs[2] = { BuildGraph(clean), BuildGraph(noisy, nullptr, &statistics) };
  EXPECT_GT(statistics.Noise, 0.2 * spacing);
  double errors[2] = { 0.0, 0.0 };
  int sources = 0;
  for (Id source = 0; sources < 4; ++source)
  {
    if (flat.At(source).X > 0.6 * part)
    {
      continue;
    }
    ++sources;
    for (int k = 0; k < 2; ++k)
    {
      const std::vector<double> found = DistancesFrom(graphs[k].Graph.View(), source);
      for (Id v = 0; v < count; ++v)
      {
        const double truth = dgg::Norm(flat.At(v) - flat.At(source));
        if (flat.At(v).X < 0.6 * part && truth > 0.1)
        {
          errors[k] += std::abs(found[v] - truth) / truth;
        }
      }
    }
  }
  EXPECT_LT(errors[1], 1.1 * errors[0]);
}
