// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances are told from other fields.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include "dggFastMarching.h"
#include "dggFieldTest.h"
#include "dggGraphSearch.h"
#include "dggHeatMethod.h"

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

FieldReport Tested(const SurfaceMesh& mesh, const std::vector<double>& values)
{
  FieldReport report;
  const Status status = TestField(mesh, values.data(), {}, report);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return report;
}

/// Few and large faces.
std::vector<NamedMesh> CoarseMeshes()
{
  std::vector<NamedMesh> meshes{ { "cube", Cube(1) }, { "tetrahedron", Tetrahedron() },
    { "octahedron", Octahedron() }, { "dodecahedron", Dodecahedron() },
    { "triangle", SingleTriangle() }, { "fold", TwoTriangles(1.0) }, { "block", TwoHoledBlock() },
    { "box", Box(1, 1, 1, 1.0, 2.0, 30.0) } };
  for (const Id sides : { 3, 5, 12 })
  {
    meshes.push_back({ "prism" + std::to_string(sides), PrismSide(sides, sides, 1) });
  }
  const std::size_t count = meshes.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (const int times : { 1, 2 })
    {
      meshes.push_back(
        { meshes[i].Name + std::to_string(times), Subdivided(meshes[i].Mesh, times) });
    }
  }
  return meshes;
}

std::vector<double> Coordinate(const TestMesh& test, int axis)
{
  std::vector<double> values;
  for (Id v = 0; v < test.GetNumberOfVertices(); ++v)
  {
    values.push_back(test.Point(v)[axis]);
  }
  return values;
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
    const FieldReport report = Tested(mesh, d);
    EXPECT_TRUE(report.IsDistance()) << named.Name << ": " << report.Sentence;
    EXPECT_TRUE(report.Sentence.empty());
    EXPECT_LE(report.WorstSlope, 1.0 + 1e-9) << named.Name;
    EXPECT_EQ(report.ShareOfSteepEdges, 0.0);
    EXPECT_GT(report.NumberOfEdges, 0);
  }
}

TEST(FieldTest, DistancesThatAreNearlyNothingAreTold)
{
  for (const NamedMesh& named : SomeMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> d = DistancesFrom(mesh, ExactEngine::Triangle, 0);
    for (const double factor : { 1e-16, 1e-100, 1e-300, 1e-310, 1e-320, 5e-324 })
    {
      const FieldReport report = Tested(mesh, Changed(d, [=](double v) { return factor * v; }));
      EXPECT_FALSE(report.IsDistance()) << named.Name << " " << factor;
      EXPECT_FALSE(report.Sentence.empty()) << named.Name << " " << factor;
    }
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
  EXPECT_TRUE(Tested(mesh, result.Distances).IsDistance());
}

TEST(FieldTest, ExactDistancesOnCoarseMeshesPass)
{
  Random random(5);
  for (const NamedMesh& named : CoarseMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    for (const Id count : { 1, 2, 5, 40 })
    {
      for (int kind = 0; kind < 4; ++kind) // at vertices and not, with initial distances and not
      {
        std::vector<GeodesicSource> sources;
        if (kind < 2)
        {
          for (Id i = 0; i < count; ++i)
          {
            sources.push_back(VertexSource(random.Index(mesh.GetNumberOfVertices())));
          }
        }
        else
        {
          for (const SurfacePoint& point : RandomSurfacePoints(mesh, count, 7 * count + kind))
          {
            sources.push_back({ point, 0.0 });
          }
        }
        for (GeodesicSource& source : sources)
        {
          source.InitialDistance =
            kind % 2 == 0 ? 0.0 : random.Uniform(-1.0, 1.0) * mesh.GetMeanEdgeLength();
        }
        const ExactResult result = Solve(mesh, ExactEngine::Triangle, sources);
        const FieldReport report = Tested(mesh, result.Distances);
        EXPECT_TRUE(report.IsDistance()) << named.Name << ' ' << count << ' ' << kind << ": "
                                         << report.ShareOfShortcuts << ' ' << report.Sentence;
      }
    }
  }
}

TEST(FieldTest, ExactDistancesFromVerySparseAndVeryDenseSourcesPass)
{
  for (const NamedMesh& named : SomeMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const Id n = mesh.GetNumberOfVertices();
    for (const Id count : { Id(1), n / 10, n / 2, n, 4 * n })
    {
      for (const double spread : { 0.0, 0.5, 3.0 })
      {
        Random random(count);
        std::vector<GeodesicSource> sources;
        for (const SurfacePoint& point : RandomSurfacePoints(mesh, count, 11))
        {
          sources.push_back({ point, spread * random.Uniform() * mesh.GetMeanEdgeLength() });
        }
        const ExactResult result = Solve(mesh, ExactEngine::Triangle, sources);
        const FieldReport report = Tested(mesh, result.Distances);
        EXPECT_TRUE(report.IsDistance())
          << named.Name << ' ' << count << ' ' << spread << ": " << report.Sentence;
      }
    }
  }
}

TEST(FieldTest, PartsOfDistancesPass)
{
  // Only what is near, and only what is far away: the distance comes in from what is not known.
  for (const NamedMesh& named : SomeMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> exact = DistancesFrom(mesh, ExactEngine::Triangle, 7);
    const double limit = 0.4 * LargestFinite(exact);
    for (const bool isNear : { true, false })
    {
      const FieldReport report = Tested(
        mesh, Changed(exact, [=](double d) { return (d < limit) == isNear ? d : Infinity; }));
      EXPECT_TRUE(report.IsDistance()) << named.Name << ": " << report.Sentence;
      EXPECT_LT(report.NumberOfVertices, mesh.GetNumberOfVertices());
    }
  }
}

TEST(FieldTest, CoordinatesFail)
{
  // Half and more of the points of a block are on sides along which a coordinate grows as a
  // distance does; the top is flat.
  const std::vector<NamedMesh> meshes{ { "cube", Cube(12) },
    { "flat", Box(16, 16, 8, 2.0, 2.0, 1.0) }, { "sphere", Icosphere(3) },
    { "ellipsoid", Ellipsoid(4, 0.5) }, { "torus", Torus(100, 60) } };
  for (const NamedMesh& named : meshes)
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    for (int axis = 0; axis < 3; ++axis)
    {
      const FieldReport report = Tested(mesh, Coordinate(named.Mesh, axis));
      EXPECT_EQ(report.Verdict, FieldVerdict::NotADistance)
        << named.Name << ' ' << axis << ' ' << report.ShareOfShortcuts;
      EXPECT_EQ(report.ShareOfSteepEdges, 0.0);
    }
  }
}

TEST(FieldTest, CanBeStopped)
{
  // Exact ways, and those of fast marching; in other units, so that they are looked at twice.
  for (const int level : { 3, 4 })
  {
    const SurfaceMesh mesh = Build(Icosphere(level));
    const std::vector<double> values =
      Changed(DistancesFrom(mesh, ExactEngine::Triangle, 7), [](double d) { return 3.0 * d; });
    double last = 0.0;
    FieldReport report;
    const ProgressCallback watch = [&](double done) {
      EXPECT_GE(done, last);
      EXPECT_LE(done, 1.0);
      last = done;
      return true;
    };
    EXPECT_TRUE(TestField(mesh, values.data(), watch, report).IsOk());
    EXPECT_EQ(report.Verdict, FieldVerdict::Scaled);
    EXPECT_GT(last, 0.8);
    for (const double stop : { 0.0, 0.4, 0.8 })
    {
      EXPECT_TRUE(TestField(
        mesh, values.data(), [=](double done) { return done < stop; }, report)
                    .IsAborted())
        << level << ' ' << stop;
    }
  }
}

/// A constant that is large beside what changes along edges, as temperatures and pressures have.
TEST(FieldTest, ConstantsAreNoMatter)
{
  const std::vector<NamedMesh> meshes = { { "sphere", Icosphere(4) },
    { "ellipsoid", Ellipsoid(4, 0.4) }, { "torus", Torus(60, 30) }, { "cube", Cube(4) },
    { "prism", PrismSide(12, 12, 6) } };
  for (const NamedMesh& named : meshes)
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> exact = DistancesFrom(mesh, ExactEngine::Triangle, 7);
    const std::vector<double> height = Coordinate(named.Mesh, 2);
    for (const double constant : { 300.0, 3.8e4, 4.5e5, -1e6, 1e9 })
    {
      const FieldReport far = Tested(mesh, Changed(exact, [=](double d) { return d + constant; }));
      EXPECT_TRUE(far.IsDistance()) << named.Name << ' ' << constant << ": " << far.Sentence;
      for (const double slope : { 0.5, 3.0 })
      {
        const FieldReport other =
          Tested(mesh, Changed(height, [=](double z) { return constant + slope * z; }));
        EXPECT_FALSE(other.IsDistance()) << named.Name << ' ' << constant << ' ' << slope;
        EXPECT_FALSE(other.Sentence.empty());
      }
    }
    // As floats, far from 0: what is left of the slopes tells it still.
    const FieldReport rounded =
      Tested(mesh, Changed(exact, [](double d) { return static_cast<float>(d + 1000.0); }));
    EXPECT_TRUE(rounded.IsDistance()) << named.Name << ": " << rounded.Sentence;
  }
}

/// Edges along which a field changes by less than its rounding join points to one flat region,
/// which may be all of the surface: then it is no distance, and that is told.
TEST(FieldTest, FieldsOfGentleSlopesAreTold)
{
  const TestMesh test = Icosphere(5);
  const SurfaceMesh mesh = Build(test);
  for (const double constant : { 300.0, 101325.0, 1e12 })
  {
    const std::vector<double> values =
      Changed(Coordinate(test, 2), [=](double z) { return static_cast<float>(constant + z); });
    const FieldReport report = Tested(mesh, values);
    EXPECT_EQ(report.Verdict, FieldVerdict::NotADistance) << constant;
    EXPECT_FALSE(report.Sentence.empty());
  }
}

TEST(FieldTest, HugeDifferencesAreNoDistance)
{
  const SurfaceMesh mesh = Build(Icosphere(3));
  for (const double size : { 1e200, std::numeric_limits<double>::max() })
  {
    std::vector<double> values(mesh.GetNumberOfVertices(), 0.0);
    values[3] = -size;
    values[30] = size;
    const FieldReport report = Tested(mesh, values);
    EXPECT_EQ(report.Verdict, FieldVerdict::NotADistance);
    EXPECT_FALSE(report.Sentence.empty());
  }
}

TEST(FieldTest, DistancesOfHeatAndFastMarchingPass)
{
  for (const NamedMesh& named : SomeMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    GeodesicSource source;
    source.Point = SurfacePoint::AtVertex(5);
    for (const double constant : { 0.0, 1000.0 })
    {
      source.InitialDistance = constant;
      MarchingResult marched;
      ASSERT_TRUE(FastMarching(mesh).Run({ source }, MarchingOptions(), marched).IsOk());
      const FieldReport march = Tested(mesh, marched.Distances);
      EXPECT_TRUE(march.IsDistance()) << named.Name << ' ' << constant << ": " << march.Sentence;
    }
    source.InitialDistance = 0.0;
    HeatMethod heat(mesh);
    ASSERT_TRUE(heat.Prepare(HeatOptions(), ProgressCallback()).IsOk());
    HeatResult heated;
    ASSERT_TRUE(heat.Run({ source }, HeatQuery(), heated).IsOk());
    const FieldReport warm = Tested(mesh, heated.Distances);
    EXPECT_TRUE(warm.IsDistance()) << named.Name << ": " << warm.Sentence;
  }
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
      const FieldReport raw = Tested(mesh, result.Distances);
      EXPECT_TRUE(raw.IsDistance()) << named.Name << ' ' << accuracy << ": " << raw.Sentence;
      const FieldReport corrected = Tested(mesh, result.Corrected);
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
  EXPECT_TRUE(Tested(mesh, values).IsDistance());
}

TEST(FieldTest, UnitsAreNoticed)
{
  for (const NamedMesh& named : SomeMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> exact = DistancesFrom(mesh, ExactEngine::Triangle, 7);
    for (const double factor : { 3.0, 0.001 })
    {
      const FieldReport report = Tested(mesh, Changed(exact, [=](double d) { return factor * d; }));
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
      const FieldReport report = Tested(mesh, field.second);
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
    EXPECT_EQ(Tested(mesh, values).IsDistance(), isPlane);
  }
}

TEST(FieldTest, WhatIsNotReachedIsLeftOut)
{
  const SurfaceMesh mesh = Build(SeveralComponents());
  const std::vector<double> exact = DistancesFrom(mesh, ExactEngine::Triangle, 0);
  ASSERT_EQ(*std::max_element(exact.begin(), exact.end()), Infinity);
  const FieldReport known = Tested(mesh, exact);
  EXPECT_TRUE(known.IsDistance());
  const FieldReport same = Tested(mesh, Changed(exact, [](double d) {
    return d < Infinity ? d : std::numeric_limits<double>::quiet_NaN();
  }));
  EXPECT_TRUE(same.IsDistance());
  EXPECT_EQ(same.NumberOfVertices, known.NumberOfVertices);
  EXPECT_LT(known.NumberOfVertices, mesh.GetNumberOfVertices());

  const FieldReport nothing = Tested(mesh, Changed(exact, [](double) { return Infinity; }));
  EXPECT_EQ(nothing.Verdict, FieldVerdict::NothingKnown);
  EXPECT_FALSE(nothing.Sentence.empty());
}

TEST(FieldTest, DefectMeshesDoNotMatter)
{
  for (const NamedMesh& named : DefectMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<double> d = DistancesFrom(mesh, ExactEngine::Triangle, 0);
    const FieldReport report = Tested(mesh, d);
    const bool isNothing = named.Name == "IsolatedPoints";
    EXPECT_EQ(report.Verdict, isNothing ? FieldVerdict::NothingKnown : FieldVerdict::Distance)
      << named.Name << ": " << report.Sentence;
    EXPECT_LE(report.WorstSlope, 1.0 + 1e-9) << named.Name;
  }
}
