// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Distributions of the same mass, for the earth mover's distance.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include "dggEarthMovers.h"

#include <cmath>
#include <numeric>

namespace dggtest
{
namespace
{
double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}
}

TEST(MassBalance, BothSumToOne)
{
  const dgg::SurfaceMesh mesh = Build(Plane(3, 2, 0.0));
  for (const double size : { 1.0, 1e-200, 1e300 })
  {
    std::vector<double> from(mesh.GetNumberOfVertices(), 0.0);
    from[2] = 3.0 * size;
    from[5] = size;
    std::vector<double> to(mesh.GetNumberOfVertices(), 7.0 / size);
    double total = 0.0;
    ASSERT_TRUE(dgg::BalanceMasses(mesh, true, from, to, total).IsOk());
    EXPECT_EQ(total, 1.0);
    EXPECT_NEAR(Sum(from), 1.0, 1e-14);
    EXPECT_NEAR(Sum(to), 1.0, 1e-14);
    EXPECT_NEAR(from[2], 0.75, 1e-14);
  }
  std::vector<double> from(mesh.GetNumberOfVertices(), 2.0);
  std::vector<double> to(from);
  to[0] += 1e-7;
  double total = 0.0;
  ASSERT_TRUE(dgg::BalanceMasses(mesh, false, from, to, total).IsOk());
  EXPECT_NEAR(total, 2.0 * mesh.GetNumberOfVertices(), 1e-6);
  EXPECT_NEAR(Sum(from), Sum(to), 1e-15);
}

TEST(MassBalance, SmallDifferencesOfPartsAreTakenOff)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  ASSERT_GT(count, 1);
  for (const double first : { 1.0, 0.0 }) // one part may be all but empty in one of them
  {
    std::vector<double> from(components.size(), 1.0);
    std::vector<double> to(components.size(), 1.0);
    for (std::size_t v = 0; v < components.size(); ++v)
    {
      from[v] = components[v] == 0 ? first : 1.0;
      to[v] = components[v] == 0 ? first + 1e-8 : 1.0;
    }
    double total = 0.0;
    ASSERT_TRUE(dgg::BalanceMasses(mesh, true, from, to, total).IsOk());
    double difference = 0.0;
    for (std::size_t v = 0; v < components.size(); ++v)
    {
      difference += components[v] == 0 ? from[v] - to[v] : 0.0;
    }
    EXPECT_NEAR(difference, 0.0, 1e-15);
    std::swap(from, to);
    EXPECT_TRUE(dgg::BalanceMasses(mesh, true, from, to, total).IsOk());
  }
}

TEST(MassBalance, SaysWhatIsWrong)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  const std::vector<double> ones(mesh.GetNumberOfVertices(), 1.0);
  const auto expect = [&](const char* part, bool normalize, std::vector<double> from,
                        std::vector<double> to) {
    double total = 0.0;
    const dgg::Status status = dgg::BalanceMasses(mesh, normalize, from, to, total);
    EXPECT_NE(status.GetMessage().find(part), std::string::npos) << status.GetMessage();
  };
  std::vector<double> others(ones);
  others[0] = 2.0;
  expect("one mass for each vertex", true, ones, {});
  expect("nothing can get there", true, ones, others);
  expect("give both the same", false, ones, others);
  expect("second distribution has no mass", true, ones, std::vector<double>(ones.size(), 0.0));
  expect("first distribution has no mass", true, std::vector<double>(ones.size(), 0.0), ones);
  expect("not finite", true, std::vector<double>(ones.size(), 1.7e308), ones);
  others[0] = -1.0;
  expect("vertex 0 is -1", true, ones, others);
  others[0] = std::nan("");
  expect("vertex 0 is nan", true, ones, others);
}
}
