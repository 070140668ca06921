// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Sites on a cloud that move to the center of their cells.
#include "PathChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggCentroidal.h"
#include "dggOutliers.h"

namespace dggtest
{
namespace
{
using dgg::CentroidalOptions;
using dgg::Id;
using dgg::SurfacePoint;
using Sites = std::vector<SurfacePoint>;

/// The vertices of a mesh as a cloud: the edges of its graph without directions.
class CloudCase
{
public:
  CloudCase(const TestMesh& mesh, double accuracy)
    : Positions(mesh.Points)
    , Case("cloud", mesh, accuracy)
    , View(AsCloud(Case.GetGraph()))
  {
    this->Search = std::make_unique<dgg::GraphSearch>(this->View, nullptr);
  }

  dgg::Status Move(const CentroidalOptions& options, Sites& sites)
  {
    return dgg::MoveToCloudCenters(
      *this->Search, this->Positions.data(), options, sites, this->Energies);
  }
  double Get(Id v, int axis) const
  {
    return this->Positions[3 * static_cast<std::size_t>(v) + axis];
  }

  std::vector<double> Positions;
  SearchCase Case;
  dgg::GraphView View;
  std::unique_ptr<dgg::GraphSearch> Search;
  std::vector<double> Energies;
};

}

TEST(CloudCenters, ASingleSiteGoesToTheMiddle)
{
  // In a cloud of 21 x 15 points, every corner must move to row 7, column 10.
  CloudCase c(Plane(20, 14), 0.01);
  for (const Id start : { 0, 20, 314, 294 })
  {
    Sites sites = AtVertices({ start });
    CentroidalOptions options;
    options.NumberOfIterations = 100;
    ASSERT_TRUE(c.Move(options, sites).IsOk());
    EXPECT_NEAR(c.Get(sites[0].Vertex, 0), 0.5 * (c.Get(0, 0) + c.Get(314, 0)), 1e-9) << start;
    EXPECT_NEAR(c.Get(sites[0].Vertex, 1), 0.5 * (c.Get(0, 1) + c.Get(314, 1)), 1e-9) << start;
    for (std::size_t i = 1; i < c.Energies.size(); ++i)
    {
      EXPECT_LT(c.Energies[i], c.Energies[i - 1]);
    }
  }
}

TEST(CloudCenters, TheEnergyIsThatOfTheSites)
{
  CloudCase c(Icosphere(3), 0.02);
  Sites sites = AtVertices({ 0, 1, 2, 3, 4, 5 });
  ASSERT_TRUE(c.Move({}, sites).IsOk());
  ASSERT_GE(c.Energies.size(), 3u);
  EXPECT_LT(c.Energies.back(), 0.85 * c.Energies.front());
  std::vector<dgg::GraphSeed> seeds;
  for (const SurfacePoint& site : sites)
  {
    seeds.push_back({ site.Vertex, 0.0, 0.0, 0, -1.0 });
  }
  dgg::SearchResult result;
  ASSERT_TRUE(c.Search->Run(seeds, {}, result).IsOk());
  double sum = 0.0;
  for (const double d : result.Distances)
  {
    sum += d * d;
  }
  EXPECT_NEAR(c.Energies.back(), sum, 1e-9 * sum);
}

TEST(CloudCenters, ScaleDoesNotMatter)
{
  // Scaling by powers of two changes no digit.
  Sites expected = AtVertices({ 0, 7, 30 });
  CloudCase original(Icosphere(3), 0.02);
  ASSERT_TRUE(original.Move({}, expected).IsOk());
  for (const double scale : { std::ldexp(1.0, -40), std::ldexp(1.0, 40) })
  {
    CloudCase c(Scaled(Icosphere(3), scale), 0.02);
    Sites sites = AtVertices({ 0, 7, 30 });
    ASSERT_TRUE(c.Move({}, sites).IsOk());
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      EXPECT_EQ(sites[i].Vertex, expected[i].Vertex) << scale;
    }
    const double energy = original.Energies.back();
    EXPECT_NEAR(c.Energies.back() / scale / scale, energy, 1e-6 * energy) << scale;
  }
}

TEST(CloudCenters, SitesWithoutACell)
{
  CloudCase c(Plane(12, 9), 0.05);
  Sites sites = AtVertices({ 5, 5, 40 });
  ASSERT_TRUE(c.Move({}, sites).IsOk());
  EXPECT_LT(c.Energies.back(), c.Energies.front());
  for (const SurfacePoint& site : sites)
  {
    EXPECT_GE(site.Vertex, 0);
    EXPECT_LT(site.Vertex, 130);
  }
  Sites none;
  EXPECT_FALSE(c.Move({}, none).IsOk());
  Sites bad = AtVertices({ 100000 });
  EXPECT_FALSE(c.Move({}, bad).IsOk());
}
}

namespace
{
using dgg::Id;
using dgg::Outliers;
using dgg::Point3;

constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Returns an 11 x 11 grid over [-1, 1] x [-1, 1] with the origin as its center.
std::vector<double> Grid()
{
  std::vector<double> points;
  for (int i = -5; i <= 5; ++i)
  {
    for (int j = -5; j <= 5; ++j)
    {
      points.insert(points.end(), { 0.2 * i, 0.2 * j, 0.0 });
    }
  }
  return points;
}

void Add(std::vector<double>& points, const Point3& p)
{
  points.insert(points.end(), { p.X, p.Y, p.Z });
}

Id CountStray(const std::vector<double>& points)
{
  return Outliers(points.data(), static_cast<Id>(points.size() / 3)).GetNumberOfPoints();
}
}

TEST(Outliers, AreAThousandTimesAsFarAsAllOthers)
{
  // The corners are the farthest regular points, at distance sqrt(2).
  std::vector<double> points = Grid();
  EXPECT_EQ(CountStray(points), 0);
  Add(points, { 0.0, 0.0, 1410.0 });
  EXPECT_EQ(CountStray(points), 0);
  points.back() = 1420.0;
  const Outliers outliers(points.data(), static_cast<Id>(points.size() / 3));
  EXPECT_EQ(outliers.GetNumberOfPoints(), 1);
  EXPECT_TRUE(outliers.IsOutlier({ 0.0, 0.0, 1420.0 }));
  EXPECT_TRUE(outliers.IsOutlier({ -1420.0, 0.0, 0.0 }));
  EXPECT_FALSE(outliers.IsOutlier({ 1.0, -1.0, 0.0 }));
  // All points beyond the gap are outliers, even if they are close to each other.
  Add(points, { 0.0, 0.0, 1500.0 });
  Add(points, { 0.0, -1e300, 5.0 });
  EXPECT_EQ(CountStray(points), 3);
  // A point between the outliers and the other points closes the gap.
  Add(points, { 30.0, 0.0, 0.0 });
  EXPECT_EQ(CountStray(points), 1);
}

TEST(Outliers, RatioCanBeGiven)
{
  std::vector<double> points = Grid();
  Add(points, { 0.0, 0.0, 6.0 });
  const auto count = [&](double ratio) {
    return Outliers(points.data(), static_cast<Id>(points.size() / 3), ratio).GetNumberOfPoints();
  };
  EXPECT_EQ(count(Outliers::RatioOfFar), 1);
  EXPECT_EQ(count(4.3), 0);
}

TEST(Outliers, AreThoseOfATurnedCloud)
{
  // The criterion does not depend on direction: the largest distance along an axis would be shorter
  // along a diagonal.
  for (const double length : { 1410.0, 1420.0 })
  {
    for (int i = 0; i < 24; ++i)
    {
      const double angle = 0.3 * i;
      std::vector<double> points = Grid();
      Add(points, { length * std::cos(angle), length * std::sin(angle), 0.0 });
      EXPECT_EQ(CountStray(points), length > 1415.0 ? 1 : 0) << angle;
      points.end()[-3] = length * std::cos(angle) / std::sqrt(2.0);
      points.end()[-2] = length * std::cos(angle) / std::sqrt(2.0);
      points.end()[-1] = length * std::sin(angle);
      EXPECT_EQ(CountStray(points), length > 1415.0 ? 1 : 0) << angle;
    }
  }
}

TEST(Outliers, AreNoSmallObjectsNorEvenlySpread)
{
  // 16 distinct positions at a distance of 8 sides of the square.
  std::vector<double> points = Grid();
  for (int i = 0; i < 16; ++i)
  {
    Add(points, { 16.0 + 0.1 * (i % 4), 0.1 * (i / 4), 0.0 });
  }
  EXPECT_EQ(CountStray(points), 0);
  for (const int count : { 18, 25, 40 })
  {
    std::vector<double> spread;
    for (int i = 0; i < count; ++i)
    {
      const double radius = std::pow(5.0, i);
      Add(spread, { radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), 0.0 });
    }
    EXPECT_EQ(CountStray(spread), 0) << count;
  }
}

TEST(Outliers, AreInFewPlaces)
{
  std::vector<double> points = Grid();
  for (int i = 0; i < 16; ++i)
  {
    Add(points, { 1e6, 1.0 * i, 0.0 });
  }
  EXPECT_EQ(CountStray(points), 16);
  for (int i = 0; i < 40; ++i)
  {
    Add(points, { 1e6, 3.0, 0.0 });
  }
  EXPECT_EQ(CountStray(points), 56);
  Add(points, { 1e6, -1.0, 0.0 });
  EXPECT_EQ(CountStray(points), 0);
}

TEST(Outliers, NeedACloudToBeFarFrom)
{
  std::vector<double> points;
  EXPECT_EQ(CountStray(points), 0);
  for (int i = 0; i < 16; ++i)
  {
    Add(points, { 0.1 * i, 0.0, 0.0 });
  }
  Add(points, { 1e6, 0.0, 0.0 });
  Add(points, { 2e6, 0.0, 0.0 });
  EXPECT_EQ(CountStray(points), 0); // 16 distinct positions
  for (int i = 0; i < 30; ++i)
  {
    Add(points, { 0.5, 0.0, 0.0 });
  }
  EXPECT_EQ(CountStray(points), 0); // still 16 distinct positions
  Add(points, { 0.55, 0.0, 0.0 });
  EXPECT_EQ(CountStray(points), 2);
  // The nearest gap with enough points inside it counts.
  std::vector<double> few;
  for (int i = 0; i < 16; ++i)
  {
    Add(few, { 0.1 * i, 0.0, 0.0 });
  }
  Add(few, { 1e4, 0.0, 0.0 });
  Add(few, { 1e8, 0.0, 0.0 });
  EXPECT_EQ(CountStray(few), 1);
}

TEST(Outliers, PointsThatAreNotFiniteDoNotCount)
{
  std::vector<double> points = Grid();
  for (int i = 0; i < 200; ++i)
  {
    Add(points, { std::nan(""), 0.0, 0.0 });
    Add(points, { 0.0, i % 2 == 0 ? Infinite : -Infinite, 0.0 });
  }
  EXPECT_EQ(CountStray(points), 0);
  Add(points, { 0.0, 1e308, -1e308 });
  EXPECT_EQ(CountStray(points), 1);
  const double most = std::numeric_limits<double>::max();
  Add(points, { -most, most, -most });
  EXPECT_EQ(CountStray(points), 2);
}
