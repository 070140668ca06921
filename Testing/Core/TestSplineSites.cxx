// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Which vertices become sites of harmonic B-splines.
#include "EdgeGraph.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "SplineTestTools.h"

#include <algorithm>
#include <set>
#include <vector>

namespace dggtest
{
TEST(SplineSites, AreFarthestPointsAlongEdges)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.02, 6));
  const Greens greens(mesh);
  std::vector<Id> sites;
  ASSERT_TRUE(dgg::ChooseSplineSites(greens.Solver, 12, nullptr, sites).IsOk());
  ASSERT_EQ(sites.size(), 12u);
  std::vector<dgg::GeodesicSource> sources{ { dgg::SurfacePoint::AtVertex(sites[0]), 0.0 } };
  for (std::size_t k = 1; k < sites.size(); ++k)
  {
    const std::vector<double> distances = dggtest::EdgeGraphDistances(mesh, sources);
    const double farthest = *std::max_element(distances.begin(), distances.end());
    EXPECT_NEAR(distances[sites[k]], farthest, 1e-12 * farthest) << k;
    sources.push_back({ dgg::SurfacePoint::AtVertex(sites[k]), 0.0 });
  }
}

TEST(SplineSites, EveryComponentHasOne)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  for (const auto boundary : { dgg::PoissonBoundary::Neumann, dgg::PoissonBoundary::Dirichlet })
  {
    const Greens greens(mesh, With(boundary));
    EXPECT_EQ(dgg::CountSplineComponents(greens.Solver), count);
    for (const Id wanted : { 0, 1, 5 })
    {
      std::vector<Id> sites;
      ASSERT_TRUE(dgg::ChooseSplineSites(greens.Solver, wanted, nullptr, sites).IsOk());
      EXPECT_EQ(static_cast<Id>(sites.size()), std::max(wanted, count));
      std::set<Id> seen;
      for (const Id site : sites)
      {
        seen.insert(components[site]);
      }
      EXPECT_EQ(static_cast<Id>(seen.size()), count);
      EXPECT_TRUE(dgg::CheckSplineSites(greens.Solver, sites).IsOk());
    }
  }
}

TEST(SplineSites, AreNotMoreThanVerticesThatAreFree)
{
  for (const TestMesh& input : { Plane(5, 4), SphereWithIsolatedPoints(1) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    for (const auto boundary : { dgg::PoissonBoundary::Neumann, dgg::PoissonBoundary::Dirichlet })
    {
      const Greens greens(mesh, With(boundary));
      std::vector<Id> sites;
      ASSERT_TRUE(dgg::ChooseSplineSites(greens.Solver, 1000, nullptr, sites).IsOk());
      std::sort(sites.begin(), sites.end());
      EXPECT_EQ(sites, AllFreeVertices(greens.Solver));
    }
  }
}

TEST(SplineSites, AreFarFromGivenValues)
{
  const TestMesh points = Plane(20, 20);
  const dgg::SurfaceMesh mesh = Build(points);
  const Greens greens(mesh, With(dgg::PoissonBoundary::Dirichlet));
  std::vector<Id> sites;
  ASSERT_TRUE(dgg::ChooseSplineSites(greens.Solver, 1, nullptr, sites).IsOk());
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_EQ(points.Point(sites[0])[0], 10.0);
  EXPECT_EQ(points.Point(sites[0])[1], 10.0);
}
}
