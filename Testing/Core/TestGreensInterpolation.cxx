// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Green's functions of many points from those of vertices.
#include "CurvedMeshes.h"
#include "GeodesicChecks.h"
#include "FlatMeshes.h"
#include "GreensTestTools.h"

#include "dggGreensInterpolation.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dggtest
{
TEST(GreensInterpolation, IsCloseToASolvePerPoint)
{
  double previous = 0.0;
  for (const int level : { 3, 4, 5 })
  {
    const TestMesh sphere = Icosphere(level);
    const dgg::SurfaceMesh mesh = Build(sphere);
    const Greens greens(mesh);
    dgg::GreensInterpolation interpolation(greens.Solver);
    double error = 0.0;
    double plain = 0.0;
    Random random(21);
    const int poles = 8;
    for (int k = 0; k < poles; ++k)
    {
      const dgg::SurfacePoint pole = InsideFace(mesh, random);
      dgg::GreensResult result;
      dgg::GreensQuery query;
      query.Targets = { dgg::SurfacePoint::AtVertex(4) };
      ASSERT_TRUE(interpolation.Run(pole, query, result).IsOk());
      EXPECT_EQ(result.TargetValues[0], result.Values[4]);
      const auto simple = greens.Run(pole, dgg::GreensMethod::Interpolated).Values;
      error += CompareOnSphere(sphere, greens, pole, result.Values, 0.2).Near / poles;
      plain += CompareOnSphere(sphere, greens, pole, simple, 0.2).Near / poles;
    }
    RecordProperty("level" + std::to_string(level), std::to_string(error));
    EXPECT_LT(error, plain / 8.0) << level;
    if (level > 3)
    {
      EXPECT_GT(std::log2(previous / error), 1.5) << level;
    }
    previous = error;
  }
  EXPECT_LT(previous, 1e-3);
}

TEST(GreensInterpolation, KeepsColumns)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(3));
  const Greens greens(mesh);
  const dgg::SurfacePoint inside = dgg::SurfacePoint::InFace(mesh, 8, { { 0.2, 0.3, 0.5 } });
  const dgg::SurfacePoint beside = dgg::SurfacePoint::InFace(mesh, 8, { { 0.6, 0.3, 0.1 } });
  const dgg::SurfacePoint away = dgg::SurfacePoint::InFace(mesh, 900, { { 0.6, 0.3, 0.1 } });
  dgg::GreensInterpolation interpolation(greens.Solver);
  dgg::GreensResult result;
  const auto columnsAfter = [&](dgg::GreensInterpolation& any, const dgg::SurfacePoint& pole) {
    EXPECT_TRUE(any.Run(pole, {}, result).IsOk());
    return any.GetNumberOfColumns();
  };
  EXPECT_EQ(columnsAfter(interpolation, inside), 3);
  const std::vector<double> first = result.Values;
  EXPECT_EQ(columnsAfter(interpolation, beside), 3);
  EXPECT_EQ(columnsAfter(interpolation, away), 6);
  EXPECT_EQ(columnsAfter(interpolation, inside), 6);
  EXPECT_EQ(result.Values, first);
  EXPECT_EQ(interpolation.GetMemorySize(), 6u * 642u * sizeof(float));
  // At a vertex it is the column itself, to the precision of floats.
  EXPECT_EQ(columnsAfter(interpolation, dgg::SurfacePoint::AtVertex(mesh.Origin(24))), 6);
  dgg::GreensQuery query;
  query.Radius = result.Radius;
  ExpectSameField(greens.Run(dgg::SurfacePoint::AtVertex(mesh.Origin(24)), query).Values,
    result.Values, 1e-6, "vertex");
  // Little memory: columns come and go, results are the same.
  dgg::GreensInterpolation small(greens.Solver, 1);
  EXPECT_EQ(columnsAfter(small, inside), 3);
  EXPECT_EQ(columnsAfter(small, away), 6);
  EXPECT_EQ(columnsAfter(small, inside), 9);
  EXPECT_EQ(result.Values, first);
  EXPECT_LE(small.GetMemorySize(), 3u * 642u * sizeof(float));
  // Where columns will not do, it is the Green's function.
  const dgg::SurfaceMesh coarse = Build(Icosahedron());
  const Greens onCoarse(coarse);
  dgg::GreensInterpolation other(onCoarse.Solver);
  EXPECT_TRUE(
    other.Run(dgg::SurfacePoint::InFace(coarse, 1, { { 0.2, 0.3, 0.5 } }), {}, result).IsOk());
  EXPECT_EQ(result.Remark, dgg::GreensRemark::TooCoarse);
  dgg::GreensQuery vertex; // whose method plays no part
  vertex.Method = dgg::GreensMethod::Vertex;
  EXPECT_TRUE(
    other.Run(dgg::SurfacePoint::InFace(coarse, 1, { { 0.2, 0.3, 0.5 } }), vertex, result).IsOk());
  EXPECT_EQ(result.Method, dgg::GreensMethod::Interpolated);
  EXPECT_EQ(result.Remark, dgg::GreensRemark::TooCoarse);
  EXPECT_FALSE(other.Run(dgg::SurfacePoint::AtVertex(99), {}, result).IsOk());
}

TEST(GreensInterpolation, ForgetsColumnsOfOtherSystems)
{
  const dgg::SurfaceMesh mesh = Build(Plane(30, 30, 0.28, 6));
  dgg::PoissonSolver solver(mesh);
  dgg::GreensInterpolation interpolation(solver);
  const auto pole = dgg::SurfacePoint::InFace(mesh, 930, { { 0.2, 0.3, 0.5 } });
  std::vector<dgg::PoissonOptions> several(4);
  several[1].Weights = dgg::PoissonWeights::Uniform;
  several[2].IntrinsicDelaunay = true;
  several[3].Boundary = dgg::PoissonBoundary::Dirichlet;
  std::vector<double> previous;
  for (const dgg::PoissonOptions& options : several)
  {
    ASSERT_TRUE(solver.Prepare(options, nullptr).IsOk());
    dgg::GreensResult result;
    ASSERT_TRUE(interpolation.Run(pole, {}, result).IsOk());
    dgg::GreensInterpolation fresh(solver);
    dgg::GreensResult expected;
    ASSERT_TRUE(fresh.Run(pole, {}, expected).IsOk());
    EXPECT_EQ(result.Values, expected.Values);
    EXPECT_NE(result.Values, previous);
    previous = result.Values;
  }
}

TEST(GreensInterpolation, ProgressGrowsAndStops)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(4));
  const Greens greens(mesh);
  dgg::GreensInterpolation interpolation(greens.Solver);
  const auto pole = dgg::SurfacePoint::InFace(mesh, 930, { { 0.2, 0.3, 0.5 } });
  std::vector<double> told;
  double stopAt = 0.5;
  dgg::GreensQuery query;
  query.Progress = [&](double done) {
    told.push_back(done);
    return done < stopAt;
  };
  dgg::GreensResult result;
  EXPECT_TRUE(interpolation.Run(pole, query, result).IsAborted());
  stopAt = 2.0;
  told.clear();
  EXPECT_TRUE(interpolation.Run(pole, query, result).IsOk());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.size(), 2u);
}
}
