// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Poisson equations on thin triangles: right, or refused.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "TestMeshes.h"
#include "ThinTriangleChecks.h"

#include "dggPoissonSystem.h"
#include "dggThinTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dggtest
{
namespace
{
/// The unit square, squashed to a strip of that height.
TestMesh Strip(Id n, double height)
{
  TestMesh mesh = Plane(n, n);
  double width = 0.0;
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    width = std::max(width, mesh.Points[i]);
  }
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] /= width;
    mesh.Points[i + 1] *= height / width;
  }
  return mesh;
}

/// Every 20th face gets a point next to the middle of an edge of it.
TestMesh WithSlivers(const TestMesh& mesh, double height)
{
  TestMesh result;
  result.Points = mesh.Points;
  for (std::size_t f = 0; f < mesh.Triangles.size() / 3; ++f)
  {
    const Id a = mesh.Triangles[3 * f];
    const Id b = mesh.Triangles[3 * f + 1];
    const Id c = mesh.Triangles[3 * f + 2];
    if (f % 20 != 0)
    {
      result.Triangles.insert(result.Triangles.end(), { a, b, c });
      continue;
    }
    const auto p = static_cast<Id>(result.Points.size() / 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double middle = 0.5 * (mesh.Points[3 * a + axis] + mesh.Points[3 * b + axis]);
      result.Points.push_back((1.0 - height) * middle + height * mesh.Points[3 * c + axis]);
    }
    result.Triangles.insert(result.Triangles.end(), { a, b, p, b, c, p, c, a, p });
  }
  return result;
}

double Measure(const dgg::SurfaceMesh& mesh)
{
  dgg::PoissonSystem system(mesh);
  EXPECT_TRUE(system.Analyze({}, nullptr).IsOk());
  EXPECT_TRUE(system.Factorize().IsOk());
  return dgg::MeasureThinTriangles(system);
}
}

/// -u'' = cos(pi x) without flow through the ends has u = cos(pi x) / pi^2, however low the strip.
TEST(ThinTriangles, StripsAreSolvedOnOrRefused)
{
  int solved = 0;
  for (int digits = 0; digits <= 14; ++digits)
  {
    SCOPED_TRACE(digits);
    const TestMesh strip = Strip(16, std::pow(10.0, -digits));
    const dgg::SurfaceMesh mesh = Build(strip);
    for (const bool delaunay : { false, true })
    {
      dgg::PoissonOptions options;
      options.IntrinsicDelaunay = delaunay;
      if (IsTooThin(mesh, options))
      {
        EXPECT_GT(digits, 5);
        continue;
      }
      ++solved;
      dgg::PoissonSolver solver(mesh);
      ASSERT_TRUE(solver.Prepare(options, nullptr).IsOk());
      std::vector<double> values(static_cast<std::size_t>(mesh.GetNumberOfVertices()));
      for (std::size_t v = 0; v < values.size(); ++v)
      {
        values[v] = solver.GetAreas()[v] * std::cos(dgg::Pi * strip.Points[3 * v]);
      }
      ASSERT_TRUE(solver.Solve(values).IsOk());
      for (std::size_t v = 0; v < values.size(); ++v)
      {
        EXPECT_NEAR(values[v] * dgg::Pi * dgg::Pi, std::cos(dgg::Pi * strip.Points[3 * v]), 0.03);
      }
    }
  }
  EXPECT_GE(solved, 12);
  EXPECT_LT(solved, 20);
}

TEST(ThinTriangles, FewOfThemDoNoHarm)
{
  EXPECT_LT(Measure(Build(Icosphere(3))), 1e-12);
  for (int digits = 1; digits <= 14; ++digits)
  {
    SCOPED_TRACE(digits);
    EXPECT_LT(Measure(Build(WithSlivers(Icosphere(3), std::pow(10.0, -digits)))), 1e-3);
  }
}

TEST(ThinTriangles, PointsOnALineAreRefused)
{
  const TestMesh line = Strip(6, 0.0);
  EXPECT_TRUE(IsTooThin(Build(line)));
  // But not where there is a surface besides, of which such a part is next to nothing.
  TestMesh both = Icosphere(2);
  const auto first = static_cast<Id>(both.Points.size() / 3);
  both.Points.insert(both.Points.end(), line.Points.begin(), line.Points.end());
  for (const Id v : line.Triangles)
  {
    both.Triangles.push_back(first + v);
  }
  EXPECT_FALSE(IsTooThin(Build(both)));
}
}
