// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudNeighbors.h"

#include "CloudShapes.h"

namespace
{
using dgg::CloudNeighbor;
using dgg::CloudNeighbors;
using dgg::Id;
using dgg::Point3;

std::vector<CloudNeighbor> Sorted(const std::vector<Point3>& points, const Point3& place)
{
  std::vector<CloudNeighbor> all;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point3 d = points[i] - place;
    all.push_back({ static_cast<Id>(i), dgg::Dot(d, d) });
  }
  std::sort(all.begin(), all.end(), [](const CloudNeighbor& a, const CloudNeighbor& b) {
    return a.SquaredDistance != b.SquaredDistance ? a.SquaredDistance < b.SquaredDistance
                                                  : a.Point < b.Point;
  });
  return all;
}

void ExpectSame(const std::vector<CloudNeighbor>& found, const std::vector<CloudNeighbor>& truth,
  std::size_t count)
{
  ASSERT_EQ(found.size(), count);
  for (std::size_t i = 0; i < count; ++i)
  {
    EXPECT_EQ(found[i].Point, truth[i].Point) << i;
    EXPECT_DOUBLE_EQ(found[i].SquaredDistance, truth[i].SquaredDistance) << i;
  }
}
}

TEST(CloudNeighbors, AreTheNearest)
{
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  std::vector<Point3> points;
  for (int i = 0; i < 800; ++i)
  {
    points.push_back({ place(generator), place(generator), 0.1 * place(generator) });
  }
  const CloudNeighbors tree(points);
  std::vector<CloudNeighbor> found;
  for (int trial = 0; trial < 50; ++trial)
  {
    const Point3 p =
      trial % 2 == 0 ? points[trial] : Point3{ place(generator), place(generator), 0.5 };
    const std::vector<CloudNeighbor> truth = Sorted(points, p);
    tree.FindNearest(p, 17, found);
    ExpectSame(found, truth, 17);
    tree.FindWithin(p, 0.3, found);
    const auto within = static_cast<std::size_t>(std::count_if(truth.begin(), truth.end(),
      [](const CloudNeighbor& n) { return n.SquaredDistance <= 0.3 * 0.3; }));
    ExpectSame(found, truth, within);
    EXPECT_EQ(tree.CountWithin(p, 0.3), within);
  }
}

TEST(CloudNeighbors, TiesOfRegularPoints)
{
  // On a grid many points are equidistant: the radius includes points exactly on it.
  std::vector<Point3> points;
  for (int i = 0; i < 20; ++i)
  {
    for (int j = 0; j < 20; ++j)
    {
      points.push_back({ 1.0 * i, 1.0 * j, 0.0 });
    }
  }
  const CloudNeighbors tree(points);
  std::vector<CloudNeighbor> found;
  tree.FindWithin(points[10 * 20 + 10], 2.0, found);
  ExpectSame(found, Sorted(points, points[10 * 20 + 10]), 13);
  EXPECT_EQ(tree.CountWithin(points[10 * 20 + 10], 2.0), 13U);
}

TEST(CloudNeighbors, FewPoints)
{
  std::vector<CloudNeighbor> found(3);
  const std::vector<Point3> none;
  CloudNeighbors(none).FindNearest({ 0.0, 0.0, 0.0 }, 4, found);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(CloudNeighbors(none).CountWithin({ 0.0, 0.0, 0.0 }, 4.0), 0U);
  const std::vector<Point3> one{ { 1.0, 0.0, 0.0 } };
  const CloudNeighbors tree(one);
  tree.FindNearest({ 0.0, 0.0, 0.0 }, 4, found);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].SquaredDistance, 1.0);
  tree.FindNearest({ 0.0, 0.0, 0.0 }, 0, found);
  EXPECT_TRUE(found.empty());
  tree.FindWithin({ 0.0, 0.0, 0.0 }, 0.5, found);
  EXPECT_TRUE(found.empty());
}
