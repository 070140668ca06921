// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared tools for tests of the exact engines.
#ifndef GeodesicChecks_h
#define GeodesicChecks_h

#include "TestMeshes.h"

#include "dggExactGeodesics.h"

namespace dggtest
{
/// Base of tests that run once with each engine.
class EngineTest : public testing::TestWithParam<dgg::ExactEngine>
{
protected:
  dgg::ExactEngine Engine() const { return this->GetParam(); }
};

std::string EngineName(const testing::TestParamInfo<dgg::ExactEngine>& info);

/// Instantiates an EngineTest.
#define DGG_WITH_BOTH_ENGINES(Suite)       \
  INSTANTIATE_TEST_SUITE_P(Engines, Suite, \
    testing::Values(dgg::ExactEngine::Reference, dgg::ExactEngine::Triangle), dggtest::EngineName)

/// Runs the solver once; a failure fails the test. `change` may adjust the options.
dgg::ExactResult Solve(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const std::vector<dgg::GeodesicSource>& sources,
  const std::function<void(dgg::ExactOptions&)>& change = nullptr);
/// Returns the distances of all vertices from one vertex.
std::vector<double> DistancesFrom(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine, Id source);
/// Returns the distances from one vertex to arbitrary surface points.
std::vector<double> DistancesTo(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const dgg::SurfacePoint& source, const std::vector<dgg::SurfacePoint>& targets);

/// Returns the largest difference of two fields and its index in `where`. An unreached vertex
/// equals only an unreached vertex.
double LargestDifference(
  const std::vector<double>& a, const std::vector<double>& b, std::size_t& where);
/// Expects two fields to agree up to an absolute tolerance.
void ExpectSameField(const std::vector<double>& expected, const std::vector<double>& actual,
  double tolerance, const std::string& what);
/// Expects the distances of all pairs of vertices to equal `truth` up to a relative or an absolute
/// tolerance.
void ExpectAllPairs(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const std::function<double(Id, Id)>& truth, double tolerance = 1e-12, double absolute = 0.0);
/// Expects the distances of all pairs of vertices of a planar mesh to be Euclidean.
void ExpectEuclid(
  const TestMesh& plane, dgg::ExactEngine engine, double tolerance = 1e-12, double absolute = 0.0);
/// Expects two values to agree up to a relative tolerance.
void ExpectClose(double expected, double actual, double tolerance, const std::string& what);

/// Returns the largest finite value; 0 if there is none.
double LargestFinite(const std::vector<double>& values);
/// Returns `count` vertices of a mesh, including the first and the last one.
std::vector<Id> SomeVertices(const dgg::SurfaceMesh& mesh, Id count, std::uint64_t seed);
/// Returns random points inside faces and on edges.
std::vector<dgg::SurfacePoint> RandomSurfacePoints(
  const dgg::SurfaceMesh& mesh, Id count, std::uint64_t seed);
dgg::GeodesicSource VertexSource(Id vertex, double initialDistance = 0.0);

/// Errors relative to the expected distance; expected distances of 0 are skipped.
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

/// Returns the planar distances of all vertices from one vertex.
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
