// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeodesicChecks.h"

#include <sstream>

namespace dggtest
{
std::string EngineName(const testing::TestParamInfo<dgg::ExactEngine>& info)
{
  return info.param == dgg::ExactEngine::Reference ? "Reference" : "Triangle";
}

dgg::ExactResult Solve(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const std::vector<dgg::GeodesicSource>& sources,
  const std::function<void(dgg::ExactOptions&)>& change)
{
  dgg::ExactOptions options;
  options.Engine = engine;
  if (change)
  {
    change(options);
  }
  dgg::ExactGeodesics solver(mesh);
  dgg::ExactResult result;
  EXPECT_TRUE(Ok(solver.Run(sources, options, result)));
  return result;
}

std::vector<double> DistancesFrom(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine, Id source)
{
  return Solve(mesh, engine, { VertexSource(source) }).Distances;
}

std::vector<double> DistancesTo(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const dgg::SurfacePoint& source, const std::vector<dgg::SurfacePoint>& targets)
{
  return Solve(mesh, engine, { { source, 0.0 } }, [&](dgg::ExactOptions& options) {
    options.Targets = targets;
  }).TargetDistances;
}

double LargestDifference(
  const std::vector<double>& a, const std::vector<double>& b, std::size_t& where)
{
  double largest = 0.0;
  where = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    const double difference = a[i] == b[i] ? 0.0 : std::abs(a[i] - b[i]);
    if (!(difference <= largest)) // true for NaN
    {
      largest = difference;
      where = i;
    }
  }
  return largest;
}

void ExpectSameField(const std::vector<double>& expected, const std::vector<double>& actual,
  double tolerance, const std::string& what)
{
  ASSERT_EQ(expected.size(), actual.size()) << what;
  std::size_t where = 0;
  const double difference = LargestDifference(expected, actual, where);
  EXPECT_LE(difference, tolerance)
    << what << ": at " << where << " expected " << expected[where] << ", got " << actual[where];
}

void ExpectAllPairs(const dgg::SurfaceMesh& mesh, dgg::ExactEngine engine,
  const std::function<double(Id, Id)>& truth, double tolerance, double absolute)
{
  for (Id a = 0; a < mesh.GetNumberOfVertices(); ++a)
  {
    const std::vector<double> distances = DistancesFrom(mesh, engine, a);
    for (Id b = 0; b < mesh.GetNumberOfVertices(); ++b)
    {
      const double expected = truth(a, b);
      if (!(std::abs(distances[b] - expected) <= std::max(absolute, tolerance * expected)))
      {
        ADD_FAILURE() << "from " << a << " to " << b << ": expected " << expected << ", got "
                      << distances[b] << ", relative error "
                      << (distances[b] - expected) / expected;
        return;
      }
    }
  }
}

void ExpectEuclid(const TestMesh& plane, dgg::ExactEngine engine, double tolerance, double absolute)
{
  ExpectAllPairs(
    Build(plane), engine, [&](Id a, Id b) { return EuclideanDistance(plane, a, b); }, tolerance,
    absolute);
}

void ExpectClose(double expected, double actual, double tolerance, const std::string& what)
{
  EXPECT_LE(std::abs(actual - expected), tolerance * std::abs(expected))
    << what << ": expected " << expected << ", got " << actual;
}

double LargestFinite(const std::vector<double>& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = value < dgg::Infinity ? std::max(largest, value) : largest;
  }
  return largest;
}

std::vector<Id> SomeVertices(const dgg::SurfaceMesh& mesh, Id count, std::uint64_t seed)
{
  Random random(seed);
  const Id n = mesh.GetNumberOfVertices();
  std::vector<Id> vertices{ 0, n - 1 };
  while (static_cast<Id>(vertices.size()) < count)
  {
    vertices.push_back(random.Index(n));
  }
  return vertices;
}

std::vector<dgg::SurfacePoint> RandomSurfacePoints(
  const dgg::SurfaceMesh& mesh, Id count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<dgg::SurfacePoint> points;
  while (static_cast<Id>(points.size()) < count)
  {
    const Id f = random.Index(mesh.GetNumberOfFaces());
    if (mesh.IsDropped(f))
    {
      continue;
    }
    if (random.Uniform() < 0.6)
    {
      const double a = random.Uniform(0.05, 1.0);
      const double b = random.Uniform(0.05, 1.0);
      const double c = random.Uniform(0.05, 1.0);
      const double sum = a + b + c;
      points.push_back(dgg::SurfacePoint::InFace(mesh, f, { { a / sum, b / sum, c / sum } }));
    }
    else
    {
      const Id h = 3 * f + random.Index(3);
      points.push_back(dgg::SurfacePoint::OnEdge(mesh, h, random.Uniform(0.1, 0.9)));
    }
  }
  return points;
}

dgg::GeodesicSource VertexSource(Id vertex, double initialDistance)
{
  return { dgg::SurfacePoint::AtVertex(vertex), initialDistance };
}
}
