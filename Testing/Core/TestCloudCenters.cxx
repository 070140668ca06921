// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Sites on a cloud that move to the middle of their cells.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "PathChecks.h"
#include "SearchChecks.h"

#include "dggCentroidal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::CentroidalOptions;
using dgg::Id;
using dgg::SurfacePoint;
using Sites = std::vector<SurfacePoint>;

/// The vertices of a mesh as a cloud: the edges of its graph without their directions.
class CloudCase
{
public:
  CloudCase(const TestMesh& mesh, double accuracy)
    : Positions(mesh.Points)
    , Case("cloud", mesh, accuracy)
    , View(Case.GetGraph())
  {
    this->View.Info.Kind = dgg::GraphKind::Cloud;
    this->View.Angles = nullptr;
    this->View.ArrivalAngles = nullptr;
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
  // Of 21 x 15 points: that in row 7, column 10, from any corner.
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
  // Powers of two change no digit, where lengths are floats at all scales.
  std::vector<Id> first;
  std::vector<double> energies;
  for (const double scale : { 1.0, std::ldexp(1.0, -40), std::ldexp(1.0, 40), 1e-30, 1e30 })
  {
    TestMesh mesh = Icosphere(3);
    for (double& x : mesh.Points)
    {
      x *= scale;
    }
    CloudCase c(mesh, 0.02);
    Sites sites = AtVertices({ 0, 7, 30 });
    ASSERT_TRUE(c.Move({}, sites).IsOk());
    std::vector<Id> found;
    for (const SurfacePoint& site : sites)
    {
      found.push_back(site.Vertex);
    }
    if (scale == 1.0)
    {
      first = found;
      energies = c.Energies;
      EXPECT_NE(first, (std::vector<Id>{ 0, 7, 30 }));
      continue;
    }
    EXPECT_TRUE(std::isfinite(c.Energies.back()));
    EXPECT_LT(c.Energies.back(), c.Energies.front());
    if (scale < 1e-20 || scale > 1e20)
    {
      continue; // lengths are doubles there, and ties another way round
    }
    EXPECT_EQ(found, first) << scale;
    ASSERT_EQ(c.Energies.size(), energies.size()) << scale;
    for (std::size_t i = 0; i < energies.size(); ++i)
    {
      EXPECT_NEAR(c.Energies[i] / scale / scale, energies[i], 1e-6 * energies[i]) << scale;
    }
  }
}

TEST(CloudCenters, IterationsAndAbort)
{
  CloudCase c(Plane(20, 14), 0.01);
  Sites sites = AtVertices({ 0, 1 });
  CentroidalOptions options;
  options.NumberOfIterations = 0;
  ASSERT_TRUE(c.Move(options, sites).IsOk());
  EXPECT_EQ(c.Energies.size(), 1u);
  EXPECT_EQ(sites[0].Vertex, 0);

  options.NumberOfIterations = 3;
  ASSERT_TRUE(c.Move(options, sites).IsOk());
  EXPECT_LE(c.Energies.size(), 4u);
  EXPECT_NE(sites[0].Vertex, 0);

  sites = AtVertices({ 0, 1 });
  options.Progress = [](double done) { return done < 0.3; };
  EXPECT_TRUE(c.Move(options, sites).IsAborted());
  EXPECT_EQ(sites[0].Vertex, 0);
  EXPECT_TRUE(c.Energies.empty());
}

TEST(CloudCenters, ProgressDoesNotGoBack)
{
  CloudCase c(Plane(20, 14), 0.01);
  Sites sites = AtVertices({ 0, 1, 2, 3, 4 });
  std::vector<double> told;
  CentroidalOptions options;
  options.NumberOfIterations = 50;
  options.Progress = [&](double done) {
    told.push_back(done);
    return true;
  };
  ASSERT_TRUE(c.Move(options, sites).IsOk());
  EXPECT_GT(told.size(), 10u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);
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
