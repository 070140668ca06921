// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Harmonic B-splines: cells, coefficients, the basis.
#include "GraphChecks.h"
#include "GreensTestTools.h"
#include "SplineTestTools.h"
#include "TestMeshes.h"

#include "dggPoissonSystem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace dggtest
{
namespace
{
/// What sums of basis functions may be off: 1e-10, or more where large coefficients cancel, as
/// among triangles that are next to flat.
double ToleranceOfSums(const Splines& splines)
{
  double largest = 0.0;
  for (Id j = 0; j < static_cast<Id>(splines.Sites.size()); ++j)
  {
    largest = std::max(largest, std::abs(splines.Cells.Stiffness.coeff(j, j)));
  }
  return largest < 1e3 ? 1e-10 : 1e-10 * largest;
}
}

TEST(HarmonicSplines, AllVerticesAsSitesGiveTheKroneckerDelta)
{
  for (const NamedMesh& named : SmallMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const dgg::PoissonOptions& options : AllPoissonOptions())
    {
      Splines splines(mesh, options);
      splines.PrepareAll();
      const std::vector<Id>& sites = splines.Sites;
      const auto basis = splines.Basis();
      double worst = 0.0;
      for (std::size_t i = 0; i < sites.size(); ++i)
      {
        for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
        {
          worst = std::max(worst, std::abs(basis[i][v] - (v == sites[i] ? 1.0 : 0.0)));
        }
      }
      EXPECT_LT(worst, 1e-10) << named.Name;
    }
  }
}

TEST(HarmonicSplines, CoefficientsAreLengthsOfBordersOverDistances)
{
  // Squares around 16 sites: borders are as long as the sites are far from each other. The dual
  // edges that they are made of are longer by a quarter.
  for (const Id n : { 32, 64, 128 })
  {
    const TestMesh plane = Scaled(Plane(n, n, 0.25, 5), 1.0 / n);
    const dgg::SurfaceMesh mesh = Build(plane);
    Splines splines(mesh);
    std::vector<Id> sites;
    for (Id j = n / 8; j < n; j += n / 4)
    {
      for (Id i = n / 8; i < n; i += n / 4)
      {
        sites.push_back(j * (n + 1) + i);
      }
    }
    splines.Prepare(sites);
    double mean = 0.0;
    double farthest = 0.0;
    for (Id j = 0; j < 4; ++j)
    {
      for (Id i = 0; i < 3; ++i)
      {
        const double across = -splines.Cells.Stiffness.coeff(4 * j + i, 4 * j + i + 1);
        const double along = -splines.Cells.Stiffness.coeff(4 * i + j, 4 * i + 4 + j);
        mean += (across + along) / 24.0;
        farthest = std::max({ farthest, std::abs(across - 1.0), std::abs(along - 1.0) });
      }
    }
    EXPECT_NEAR(mean, 1.0, 1.5 / n) << n;
    EXPECT_LT(farthest, 7.0 / n) << n; // an edge at each end of a border
  }
}

TEST(HarmonicSplines, CellsAreThoseOfTheNearestSites)
{
  const TestMesh bumpy = NoisySphere(3, 0.03, 8);
  const dgg::SurfaceMesh mesh = Build(bumpy);
  Splines splines(mesh);
  splines.PrepareSome(15);
  const std::vector<Id>& sites = splines.Sites;
  std::vector<std::vector<double>> distances;
  double weight = 0.0;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    distances.push_back(DistancesFrom(mesh, dgg::ExactEngine::Triangle, sites[i]));
    weight += splines.Cells.Weights[i];
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Id cell = splines.Functions.GetCells()[v];
    for (const std::vector<double>& others : distances)
    {
      ASSERT_LE(distances[cell][v], others[v] * (1.0 + 1e-12)) << v;
    }
  }
  EXPECT_NEAR(weight, 1.0, 1e-12);
}

TEST(HarmonicSplines, BasisSumsToOne)
{
  for (const NamedMesh& named : AllMeshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const bool delaunay : { false, true })
    {
      dgg::PoissonOptions options = With(dgg::PoissonBoundary::Neumann, delaunay);
      options.Weights = delaunay ? dgg::PoissonWeights::Uniform : dgg::PoissonWeights::Area;
      Splines splines(mesh, options);
      splines.PrepareSome(9);
      const auto basis = splines.Basis();
      const double tolerance = ToleranceOfSums(splines);
      Id count = 0;
      const std::vector<Id> components = mesh.ComputeComponents(count);
      std::vector<double> means(basis.size(), 0.0);
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        const bool hasFace = mesh.FanBegin(v) != mesh.FanEnd(v);
        EXPECT_EQ(splines.Functions.GetCells()[v] == dgg::NoId, !hasFace);
        double sum = 0.0;
        for (std::size_t j = 0; j < basis.size(); ++j)
        {
          const bool isHere = components[splines.Sites[j]] == components[v];
          sum += basis[j][v];
          means[j] += isHere ? splines.Solver.GetWeight(v) * basis[j][v] : 0.0;
          if (!isHere)
          {
            EXPECT_EQ(basis[j][v], 0.0);
          }
        }
        ASSERT_NEAR(sum, hasFace ? 1.0 : 0.0, tolerance) << named.Name << " " << v;
      }
      for (std::size_t j = 0; j < basis.size(); ++j)
      {
        EXPECT_NEAR(means[j], splines.Cells.Weights[j], tolerance) << named.Name;
      }
    }
  }
}

TEST(HarmonicSplines, BasisIsMadeOfGreensFunctionsOfCells)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(2, 0.02, 4));
  for (const auto weights : { dgg::PoissonWeights::Area, dgg::PoissonWeights::Uniform })
  {
    dgg::PoissonOptions options;
    options.Weights = weights;
    Splines splines(mesh, options);
    splines.PrepareSome(7);
    const dgg::HarmonicSplines& functions = splines.Functions;
    std::vector<std::vector<double>> means(7, std::vector<double>(mesh.GetNumberOfVertices(), 0.0));
    for (Id y = 0; y < mesh.GetNumberOfVertices(); ++y)
    {
      const Id cell = functions.GetCells()[y];
      const std::vector<double> column =
        splines.Run(dgg::SurfacePoint::AtVertex(y), dgg::GreensMethod::Vertex).Values;
      for (std::size_t v = 0; v < column.size(); ++v)
      {
        means[cell][v] += splines.Solver.GetWeight(y) / splines.Cells.Weights[cell] * column[v];
      }
    }
    const auto basis = splines.Basis();
    for (Id j = 0; j < 7; ++j)
    {
      std::vector<double> sum(means[j].size(), splines.Cells.Weights[j]);
      for (Id i = 0; i < 7; ++i)
      {
        for (std::size_t v = 0; v < sum.size(); ++v)
        {
          sum[v] +=
            i == j ? 0.0 : -splines.Cells.Stiffness.coeff(i, j) * (means[j][v] - means[i][v]);
        }
      }
      ExpectSameField(sum, basis[j], 1e-12, "basis");
    }
  }
}

TEST(HarmonicSplines, BasisPeaksAtItsSiteAndDiesAway)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(4));
  Splines splines(mesh);
  splines.PrepareSome(40);
  const std::vector<Id>& sites = splines.Sites;
  const auto basis = splines.Basis();
  for (std::size_t j = 0; j < sites.size(); ++j)
  {
    const std::vector<double> distances = DistancesFrom(mesh, dgg::ExactEngine::Triangle, sites[j]);
    // Cells are about 0.3 in radius.
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      ASSERT_LT(basis[j][v], basis[j][sites[j]] * 1.2);
      if (distances[v] > 1.2)
      {
        ASSERT_LT(std::abs(basis[j][v]), 0.05);
      }
    }
    EXPECT_GT(basis[j][sites[j]], 0.5);
    EXPECT_LT(basis[j][sites[j]], 0.85);
  }
}

TEST(HarmonicSplines, PointsInsideFaces)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.01, 2));
  Splines splines(mesh);
  splines.PrepareSome(12);
  const auto basis = splines.Basis();
  Random random(31);
  std::vector<dgg::SurfacePoint> points{ dgg::SurfacePoint::AtVertex(70),
    dgg::SurfacePoint::OnEdge(mesh, 44, 0.3) };
  for (int k = 0; k < 12; ++k)
  {
    points.push_back(InsideFace(mesh, random));
  }
  const std::vector<double> linear = splines.Evaluate(points, dgg::GreensMethod::Interpolated);
  const std::vector<double> smooth =
    splines.Evaluate(points, dgg::GreensMethod::SingularitySubtraction);
  ASSERT_EQ(linear.size(), 12 * points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    double sums[] = { 0.0, 0.0 };
    for (std::size_t j = 0; j < 12; ++j)
    {
      double expected = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        expected += dgg::IsVertex(points[k])
          ? basis[j][points[k].Vertex] / 3.0
          : points[k].Barycentric[c] * basis[j][mesh.Origin(3 * points[k].Face + c)];
      }
      sums[0] += linear[12 * k + j];
      sums[1] += smooth[12 * k + j];
      EXPECT_NEAR(linear[12 * k + j], expected, 1e-10);
      EXPECT_NEAR(smooth[12 * k + j], expected, 0.02); // cells have 50 vertices
    }
    EXPECT_NEAR(sums[0], 1.0, 1e-10);
    EXPECT_NEAR(sums[1], 1.0, 1e-10);
  }
}

TEST(HarmonicSplines, AnyTrianglesWillDo)
{
  // Among triangles that are next to flat, equations may be singular up to rounding: then results
  // are finite, and that is all.
  int sound = 0;
  int thin = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    Random random(seed);
    const dgg::SurfaceMesh mesh =
      Build(RandomSoup(3 + random.Index(30), 1 + random.Index(60), seed));
    for (const auto boundary : Boundaries)
    {
      if (IsTooThin(mesh, With(boundary, true)))
      {
        ++thin;
        continue;
      }
      Splines splines(mesh, With(boundary, true));
      std::vector<Id> sites;
      ASSERT_TRUE(dgg::ChooseSplineSites(splines.Solver, 4, nullptr, sites).IsOk());
      if (sites.empty())
      {
        continue;
      }
      splines.Prepare(sites);
      const auto basis = splines.Basis();
      double largest = 0.0;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        largest = std::max(largest, splines.Solver.GetSystem().GetStiffness().coeff(v, v));
      }
      const bool isSound = boundary == dgg::PoissonBoundary::Neumann && largest < 1e3;
      sound += isSound ? 1 : 0;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        double sum = 0.0;
        for (const std::vector<double>& function : basis)
        {
          ASSERT_TRUE(std::isfinite(function[v])) << seed;
          sum += function[v];
        }
        if (isSound)
        {
          ASSERT_NEAR(sum, splines.Functions.GetCells()[v] == dgg::NoId ? 0.0 : 1.0, 1e-10) << seed;
        }
      }
    }
  }
  EXPECT_GT(sound, 10);
  EXPECT_LT(thin, 10);
}

TEST(HarmonicSplines, SmoothOnesHaveNoKinksAtEdges)
{
  // Second differences across edges: of piecewise linear functions they are kinks alone.
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.01, 2));
  Splines splines(mesh);
  splines.PrepareSome(40);
  std::vector<dgg::SurfacePoint> points;
  const double off = 0.1;
  for (Id h = 7; h < mesh.GetNumberOfHalfEdges() && points.size() < 60; h += 97)
  {
    points.push_back(dgg::SurfacePoint::OnEdge(mesh, h, 0.5));
    for (const Id side : { h, mesh.Twin(h) })
    {
      std::array<double, 3> weights;
      weights.fill(0.5 * (1.0 - off));
      weights[(side + 2) % 3] = off;
      points.push_back(dgg::SurfacePoint::InFace(mesh, side / 3, weights));
    }
  }
  double kinks[] = { 0.0, 0.0 };
  for (const bool isSmooth : { false, true })
  {
    const std::vector<double> values = splines.Evaluate(points,
      isSmooth ? dgg::GreensMethod::SingularitySubtraction : dgg::GreensMethod::Interpolated);
    for (std::size_t k = 0; k < points.size(); k += 3)
    {
      for (std::size_t j = 0; j < 40; ++j)
      {
        kinks[isSmooth ? 1 : 0] +=
          std::abs(values[(k + 1) * 40 + j] + values[(k + 2) * 40 + j] - 2.0 * values[k * 40 + j]);
      }
    }
  }
  EXPECT_LT(kinks[1], 0.2 * kinks[0]);
}

// Harmonic B-splines: wrong input, progress and abort.

}
