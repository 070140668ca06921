// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances are told from other fields.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include "dggFieldTest.h"
#include "dggGraphSearch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace dgg;
using namespace dggtest;

namespace
{
std::vector<NamedMesh> SomeMeshes()
{
  return { { "sphere", Icosphere(3) }, { "ellipsoid", Ellipsoid(3, 0.4) },
    { "torus", Torus(24, 14) }, { "terrain", Terrain(16, 0.4, 3) },
    { "plane", Plane(12, 12, 0.2) } };
}

template <typename Change>
std::vector<double> Changed(std::vector<double> values, const Change& change)
{
  std::transform(values.begin(), values.end(), values.begin(), change);
  return values;
}
}

TEST(FieldTest, ExactDistancesPass)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> d = DistancesFrom(mesh, ExactEngine::Triangle, 0);
    const FieldReport report = TestField(mesh, d.data());
    EXPECT_TRUE(report.IsDistance()) << named.Name << ": " << report.Sentence;
    EXPECT_TRUE(report.Sentence.empty());
    EXPECT_LE(report.WorstSlope, 1.0 + 1e-9) << named.Name;
    EXPECT_EQ(report.ShareOfSteepEdges, 0.0);
    EXPECT_GT(report.NumberOfEdges, 0);
  }
}

TEST(FieldTest, DistancesFromManySourcesAndWithinFacesPass)
{
  const SurfaceMesh mesh = Build(Icosphere(3));
  std::vector<GeodesicSource> sources;
  for (const SurfacePoint& point : RandomSurfacePoints(mesh, 8, 3))
  {
    sources.push_back({ point, -0.5 });
  }
  const ExactResult result = Solve(mesh, ExactEngine::Triangle, sources);
  EXPECT_TRUE(TestField(mesh, result.Distances.data()).IsDistance());
}

TEST(FieldTest, DistancesOfGraphsPass)
{
  for (const NamedMesh& named : SomeMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    for (const double accuracy : { 0.01, 0.1 })
    {
      const GeodesicGraph graph = BuildGraph(mesh, accuracy, GraphConstruction::Guaranteed);
      const GraphSearch search(graph.View(), &mesh);
      SearchOptions options;
      options.Correct = true;
      SearchResult result;
      GraphSeed seed;
      seed.Vertex = 5;
      ASSERT_TRUE(search.Run({ seed }, options, result).IsOk());
      const FieldReport raw = TestField(mesh, result.Distances.data());
      EXPECT_TRUE(raw.IsDistance()) << named.Name << ' ' << accuracy << ": " << raw.Sentence;
      const FieldReport corrected = TestField(mesh, result.Corrected.data());
      EXPECT_TRUE(corrected.IsDistance()) << named.Name << ' ' << accuracy;
    }
  }
}

TEST(FieldTest, DistancesWithNoisePass)
{
  const SurfaceMesh mesh = Build(Icosphere(4));
  const std::vector<double> exact = DistancesFrom(mesh, ExactEngine::Triangle, 7);
  Random random(3);
  const double h = mesh.GetMeanEdgeLength();
  // As of fast marching and heat: too long or short by some percent, a little rough.
  const std::vector<double> values =
    Changed(exact, [&](double d) { return 1.03 * d + random.Uniform(-0.02, 0.02) * h; });
  EXPECT_TRUE(TestField(mesh, values.data()).IsDistance());
}

TEST(FieldTest, UnitsAreNoticed)
{
  for (const NamedMesh& named : SomeMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> exact = DistancesFrom(mesh, ExactEngine::Triangle, 7);
    for (const double factor : { 3.0, 0.001 })
    {
      const FieldReport report =
        TestField(mesh, Changed(exact, [=](double d) { return factor * d; }).data());
      EXPECT_EQ(report.Verdict, FieldVerdict::Scaled) << named.Name;
      EXPECT_NEAR(report.MedianSlope, factor, 0.05 * factor) << named.Name;
      EXPECT_FALSE(report.Sentence.empty());
    }
  }
}

TEST(FieldTest, OtherFieldsFail)
{
  for (const NamedMesh& named : SomeMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> exact = DistancesFrom(mesh, ExactEngine::Triangle, 7);
    Random random(3);
    const double farthest = LargestFinite(exact);
    const std::vector<std::pair<std::string, std::vector<double>>> fields = {
      { "constant", Changed(exact, [](double) { return 2.5; }) },
      { "random", Changed(exact, [&](double) { return random.Uniform(0.0, farthest); }) },
      { "squared", Changed(exact, [](double d) { return d * d; }) },
      { "root", Changed(exact, [](double d) { return std::sqrt(d); }) },
      { "waves", Changed(exact, [=](double d) { return std::cos(6.0 * d / farthest); }) },
    };
    for (const auto& field : fields)
    {
      const FieldReport report = TestField(mesh, field.second.data());
      EXPECT_EQ(report.Verdict, FieldVerdict::NotADistance) << named.Name << ' ' << field.first;
      EXPECT_FALSE(report.Sentence.empty());
    }
  }
}

TEST(FieldTest, ACoordinateIsADistanceInThePlaneOnly)
{
  for (const bool isPlane : { true, false })
  {
    const TestMesh test = isPlane ? Plane(12, 12, 0.2) : Icosphere(3);
    const SurfaceMesh mesh = Build(test);
    std::vector<double> values;
    for (Id v = 0; v < test.GetNumberOfVertices(); ++v)
    {
      values.push_back(test.Point(v)[0]);
    }
    EXPECT_EQ(TestField(mesh, values.data()).IsDistance(), isPlane);
  }
}

TEST(FieldTest, WhatIsNotReachedIsLeftOut)
{
  const SurfaceMesh mesh = Build(SeveralComponents());
  const std::vector<double> exact = DistancesFrom(mesh, ExactEngine::Triangle, 0);
  ASSERT_EQ(*std::max_element(exact.begin(), exact.end()), Infinity);
  const FieldReport known = TestField(mesh, exact.data());
  EXPECT_TRUE(known.IsDistance());
  const FieldReport same = TestField(mesh, Changed(exact, [](double d) {
    return d < Infinity ? d : std::numeric_limits<double>::quiet_NaN();
  }).data());
  EXPECT_TRUE(same.IsDistance());
  EXPECT_EQ(same.NumberOfVertices, known.NumberOfVertices);
  EXPECT_LT(known.NumberOfVertices, mesh.GetNumberOfVertices());

  const FieldReport nothing =
    TestField(mesh, Changed(exact, [](double) { return Infinity; }).data());
  EXPECT_EQ(nothing.Verdict, FieldVerdict::NothingKnown);
  EXPECT_FALSE(nothing.Sentence.empty());
}

TEST(FieldTest, DefectMeshesDoNotMatter)
{
  for (const NamedMesh& named : DefectMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> d = DistancesFrom(mesh, ExactEngine::Triangle, 0);
    const FieldReport report = TestField(mesh, d.data());
    EXPECT_NE(report.Verdict, FieldVerdict::Scaled) << named.Name;
    EXPECT_LE(report.WorstSlope, 1.0 + 1e-9) << named.Name;
  }
}
