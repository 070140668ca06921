// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Corrected labels: always within the accuracy, and much closer on average.
#include "GeodesicChecks.h"
#include "SearchChecks.h"
#include "TestMeshes.h"

namespace dggtest
{
namespace
{
using dgg::GraphConstruction;
using dgg::GraphSeed;
using dgg::SearchOptions;
using dgg::SearchResult;

SearchResult RunCorrected(const SearchCase& c, const std::vector<GraphSeed>& seeds)
{
  return c.Run(seeds, [](SearchOptions& options) { options.Correct = true; });
}

/// Mean errors over all vertices from several sources.
struct MeanErrors
{
  double Raw = 0.0;
  double Corrected = 0.0;
};

MeanErrors MeasureErrors(const SearchCase& c, Id numberOfSources)
{
  MeanErrors errors;
  std::size_t count = 0;
  for (Id source : SomeVertices(c.GetMesh(), numberOfSources, 5))
  {
    const std::vector<double> exact =
      DistancesFrom(c.GetMesh(), dgg::ExactEngine::Triangle, source);
    const SearchResult result = RunCorrected(c, { SeedAt(source) });
    for (std::size_t v = 0; v < exact.size(); ++v)
    {
      if (exact[v] > 0.0 && exact[v] < dgg::Infinity)
      {
        errors.Raw += std::abs(result.Distances[v] / exact[v] - 1.0);
        errors.Corrected += std::abs(result.Corrected[v] / exact[v] - 1.0);
        ++count;
      }
    }
  }
  errors.Raw /= static_cast<double>(count);
  errors.Corrected /= static_cast<double>(count);
  return errors;
}

/// Expects the same corrections, up to the rounding of graphs, on a scaled mesh.
void ExpectScaled(int exponent)
{
  const TestMesh mesh = Terrain(12, 0.4, 5);
  const SearchResult usual = RunCorrected(SearchCase("terrain", mesh, 0.02), { SeedAt(3) });
  const double scale = std::ldexp(1.0, exponent);
  const SearchResult scaled =
    RunCorrected(SearchCase("scaled terrain", Scaled(mesh, scale), 0.02), { SeedAt(3) });
  for (std::size_t v = 0; v < usual.Corrected.size(); ++v)
  {
    EXPECT_NEAR(scaled.Corrected[v] / scale, usual.Corrected[v], 1e-6 * usual.Corrected[v]) << v;
  }
}

void ExpectImproved(
  const std::string& name, const TestMesh& mesh, double accuracy, double expectedFactor)
{
  const SearchCase c(name, mesh, accuracy);
  const MeanErrors errors = MeasureErrors(c, 5);
  EXPECT_GT(errors.Raw, expectedFactor * errors.Corrected)
    << c.GetName() << ": raw " << errors.Raw << ", corrected " << errors.Corrected;
}

/// Expects corrected distances within the accuracy, relative to the smallest offset, and much
/// smaller mean errors than those of the labels.
void ExpectCorrected(const SearchCase& c, const std::vector<GraphSeed>& seeds,
  const std::vector<dgg::GeodesicSource>& sources)
{
  double offset = dgg::Infinity;
  for (const dgg::GeodesicSource& source : sources)
  {
    offset = std::min(offset, source.InitialDistance);
  }
  const dgg::ExactResult exact = Solve(c.GetMesh(), dgg::ExactEngine::Triangle, sources);
  const SearchResult result = RunCorrected(c, seeds);
  double raw = 0.0;
  double corrected = 0.0;
  for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
  {
    const double d = exact.Distances[v];
    EXPECT_GE(result.Distances[v], d - 1e-9 * std::abs(d));
    EXPECT_LE(std::abs(result.Corrected[v] - d), 0.05 * (d - offset) * (1.0 + 1e-6) + 1e-9);
    raw += std::abs(result.Distances[v] - d);
    corrected += std::abs(result.Corrected[v] - d);
  }
  EXPECT_GT(raw, 2.5 * corrected);
}
}

TEST(GraphCorrection, DoesNotDependOnTheScale)
{
  ExpectScaled(-200);
  ExpectScaled(200);
}

TEST(GraphCorrection, WithinTheAccuracyWithoutException)
{
  for (const auto& c : SearchCases())
  {
    if (!c->GetGraph().Info.IsGuaranteed())
    {
      continue;
    }
    const double accuracy = c->GetGraph().Info.Accuracy;
    const double slack = 100.0 * c->GetMesh().GetMollification();
    for (Id source : SomeVertices(c->GetMesh(), 3, 9))
    {
      const std::vector<double> exact =
        DistancesFrom(c->GetMesh(), dgg::ExactEngine::Triangle, source);
      const SearchResult result = RunCorrected(*c, { SeedAt(source) });
      for (std::size_t v = 0; v < exact.size(); ++v)
      {
        ASSERT_EQ(result.Corrected[v] == dgg::Infinity, exact[v] == dgg::Infinity) << c->GetName();
        if (exact[v] < dgg::Infinity)
        {
          ASSERT_LE(std::abs(result.Corrected[v] - exact[v]),
            accuracy * exact[v] * (1.0 + 1e-6) + 1e-9 * exact[v] + slack)
            << c->GetName() << ", from " << source << " to " << v;
        }
      }
    }
  }
}

TEST(GraphCorrection, SourcesAnywhereWithOffsets)
{
  for (const auto& mesh : { Plane(14, 14, 0.2, 3), NoisySphere(3, 0.2, 4), Terrain(16, 0.3, 2) })
  {
    const SearchCase c("offsets", mesh, 0.05);
    const Id n = c.GetNumberOfVertices();
    ExpectCorrected(c, { SeedAt(0, 0.3), SeedAt(n / 2, -0.4), SeedAt(n - 1, 0.1) },
      { VertexSource(0, 0.3), VertexSource(n / 2, -0.4), VertexSource(n - 1, 0.1) });
    const dgg::GraphBuilder builder(c.GetMesh());
    for (const dgg::SurfacePoint& point : RandomSurfacePoints(c.GetMesh(), 6, 8))
    {
      ExpectCorrected(c, SeedsOf(builder, point, 0.05, 0.7), { { point, 0.7 } });
    }
  }
}

TEST(GraphCorrection, ExactWhereTheSurfaceIsFlat)
{
  // The only error is the rounding of angles to floats.
  const SearchCase c("plane", Plane(25, 25, 0.25, 3), 0.05);
  for (Id source : { 0, 13, 340 })
  {
    const SearchResult result = RunCorrected(c, { SeedAt(source) });
    for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
    {
      const double d = EuclideanDistance(c.GetPoints(), source, v);
      EXPECT_NEAR(result.Corrected[v], d, 1e-5 * d);
      EXPECT_NEAR(result.Virtual[v].Offset + result.Virtual[v].Length, d, 1e-5 * d);
      if (v != source && c.GetMesh().Kind(v) == dgg::VertexKind::Flat)
      {
        const double angle =
          DirectionOf(c.GetPoints(), v, source) - FanAngle(c.GetPoints(), c.GetMesh(), v);
        EXPECT_NEAR(std::cos(result.Virtual[v].Angle), std::cos(angle), 1e-4);
        EXPECT_NEAR(std::sin(result.Virtual[v].Angle), std::sin(angle), 1e-4);
      }
    }
  }
}

TEST(GraphCorrection, MuchBetterThanTheLabels)
{
  for (double accuracy : { 0.05, 0.01 })
  {
    ExpectImproved("sphere", Icosphere(4), accuracy, 8.0);
    ExpectImproved("noisy sphere", NoisySphere(4, 0.1, 3), accuracy, 5.0);
    ExpectImproved("torus", Torus(60, 25), accuracy, 8.0);
    ExpectImproved("terrain", Terrain(40, 0.15, 3), accuracy, 5.0);
    ExpectImproved("cube", Cube(16, 0.2, 3), accuracy, 5.0);
    ExpectImproved("L",
      Plate(
        20, 20, [](Id i, Id j) { return i < 10 || j < 10; }, 0.2, 4),
      accuracy, 6.0);
    ExpectImproved("annulus",
      Plate(
        40, 40, [](Id i, Id j) { return i < 12 || i >= 28 || j < 12 || j >= 28; }, 0.2, 5),
      accuracy, 5.0);
  }
}

TEST(GraphCorrection, NoLowerBoundWithoutAGuarantee)
{
  // Without a guarantee an estimate may be below the bound of the accuracy, but never above the
  // label.
  for (GraphConstruction construction :
    { GraphConstruction::OneRelay, GraphConstruction::SaddleVertexGraph })
  {
    const SearchCase c("sphere", NoisySphere(4, 0.1, 3), 0.02, construction);
    const SearchResult result = RunCorrected(c, { SeedAt(0) });
    for (Id v = 0; v < c.GetNumberOfVertices(); ++v)
    {
      EXPECT_LE(result.Corrected[v], result.Distances[v]);
    }
    const MeanErrors errors = MeasureErrors(c, 3);
    EXPECT_LT(errors.Corrected, errors.Raw) << c.GetName();
  }
}
}
