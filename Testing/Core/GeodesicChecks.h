// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of the exact engines share.
#ifndef GeodesicChecks_h
#define GeodesicChecks_h

#include "TestMeshes.h"

#include "dggExactGeodesics.h"

#include <functional>
#include <string>
#include <vector>

namespace dggtest
{
/// A test of this kind runs once with each engine.
class EngineTest : public testing::TestWithParam<dgg::ExactEngine>
{
protected:
  dgg::ExactEngine Engine() const { return this->GetParam(); }
};

std::string EngineName(const testing::TestParamInfo<dgg::ExactEngine>& info);

/// Instantiate an EngineTest.
#define DGG_WITH_BOTH_ENGINES(Suite)       \
  INSTANTIATE_TEST_SUITE_P(Engines, Suite, \
    testing::Values(dgg::ExactEngine::Reference, dgg::ExactEngine::Triangle), dggtest::EngineName)

/// One run; a failure fails the test. `change` may adjust the options.
dgg::ExactResult Solve(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const std::vector<dgg::GeodesicSource>& sources,
  const std::function<void(dgg::ExactOptions&)>& change = nullptr);
/// Distances of all vertices from one vertex.
std::vector<double> DistancesFrom(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine, Id source);
/// Distances from one vertex to points anywhere.
std::vector<double> DistancesTo(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const dgg::SurfacePoint& source, const std::vector<dgg::SurfacePoint>& targets);

/// Largest difference of two fields, unreached vertices being equal only to each other; `where` is
/// set to its index.
double LargestDifference(
  const std::vector<double>& a, const std::vector<double>& b, std::size_t& where);
/// Expect two fields to agree to an absolute tolerance.
void ExpectSameField(const std::vector<double>& expected, const std::vector<double>& actual,
  double tolerance, const std::string& what);
/// Expect every pair of vertices to be at the distance that `truth` says, up to a part of it or an
/// absolute length.
void ExpectAllPairs(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const std::function<double(Id, Id)>& truth, double tolerance = 1e-12, double absolute = 0.0);
/// The same of the vertices of a mesh in the plane.
void ExpectEuclid(
  const TestMesh& plane, dgg::ExactEngine engine, double tolerance = 1e-12, double absolute = 0.0);
/// Relative comparison with a message.
void ExpectClose(double expected, double actual, double tolerance, const std::string& what);

/// Largest finite value, 0 when there is none.
double LargestFinite(const std::vector<double>& values);
/// A few vertices of a mesh, the first and the last among them.
std::vector<Id> SomeVertices(const dgg::SurfaceMesh& mesh, Id count, std::uint64_t seed);
/// Random points inside faces and on edges.
std::vector<dgg::SurfacePoint> RandomSurfacePoints(
  const dgg::SurfaceMesh& mesh, Id count, std::uint64_t seed);
dgg::GeodesicSource VertexSource(Id vertex, double initialDistance = 0.0);

/// Relative to the expected distance, where that is not 0.
struct Errors
{
  double Mean = 0.0;
  double Largest = 0.0;
};

inline Errors Compare(const std::vector<double>& actual, const std::vector<double>& expected)
{
  EXPECT_EQ(actual.size(), expected.size());
  Errors errors;
  double count = 0.0;
  for (std::size_t v = 0; v < actual.size(); ++v)
  {
    EXPECT_EQ(actual[v] < dgg::Infinity, expected[v] < dgg::Infinity) << v;
    if (expected[v] > 0.0 && expected[v] < dgg::Infinity)
    {
      const double error = std::abs(actual[v] / expected[v] - 1.0);
      errors.Mean += error;
      errors.Largest = std::max(errors.Largest, error);
      count += 1.0;
    }
  }
  errors.Mean /= std::max(1.0, count);
  return errors;
}

/// Distances in the plane.
inline std::vector<double> EuclideanDistances(const TestMesh& plane, Id source)
{
  std::vector<double> distances;
  for (Id v = 0; v < plane.GetNumberOfVertices(); ++v)
  {
    distances.push_back(EuclideanDistance(plane, source, v));
  }
  return distances;
}
}

#endif
