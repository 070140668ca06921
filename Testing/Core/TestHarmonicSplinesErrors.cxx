// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Harmonic B-splines: wrong input, progress and abort.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "GraphChecks.h"
#include "SplineTestTools.h"

#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace dggtest
{
TEST(HarmonicSplines, RefusesWhatMakesNoSense)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  dgg::PoissonSolver solver(mesh);
  dgg::HarmonicSplines splines(solver);
  const auto messageOf = [&](const std::vector<Id>& sites) {
    return splines.Prepare(sites, nullptr, nullptr).GetMessage();
  };
  const auto says = [](const std::string& message, const std::string& part) {
    return message.find(part) != std::string::npos;
  };
  const auto ignore = [](Id, const std::vector<double>&) {};
  EXPECT_TRUE(says(messageOf({ 0 }), "has not been prepared"));
  std::vector<Id> sites{ 1 };
  EXPECT_FALSE(dgg::ChooseSplineSites(solver, 3, nullptr, sites).IsOk());
  EXPECT_TRUE(sites.empty());
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  EXPECT_TRUE(says(splines.FindBasis(nullptr, nullptr, ignore).GetMessage(), "no sites"));
  EXPECT_TRUE(says(messageOf({}), "there is no site"));
  EXPECT_TRUE(says(messageOf({ 0, -1 }), "site 1 (vertex -1) does not exist"));
  EXPECT_TRUE(says(messageOf({ mesh.GetNumberOfVertices() }), "does not exist"));
  EXPECT_TRUE(says(messageOf({ 5, 7, 5 }), "site 2 (vertex 5) is the same as site 0"));
  EXPECT_TRUE(says(messageOf({ 0 }), "has no site"));
  std::vector<double> values;
  EXPECT_FALSE(splines.Solve({}, {}, values).IsOk());

  ASSERT_TRUE(dgg::ChooseSplineSites(solver, 6, nullptr, sites).IsOk());
  ASSERT_EQ(messageOf(sites), "");
  std::vector<double> sources(mesh.GetNumberOfVertices(), 0.0);
  EXPECT_TRUE(says(splines.Solve({ 1.0 }, {}, values).GetMessage(), "1 values"));
  EXPECT_FALSE(splines.Solve(sources, { 0 }, values).IsOk()); // no value for it
  values.assign(6, 0.0);
  EXPECT_FALSE(splines.Solve(sources, { 6 }, values).IsOk());
  EXPECT_FALSE(splines.Solve(sources, { -1 }, values).IsOk());
  sources[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(splines.Solve(sources, {}, values).GetMessage(), "vertex 3"));
  EXPECT_FALSE(splines.Combine({ 1.0 }, {}, values).IsOk());
  EXPECT_FALSE(splines.Combine(std::vector<double>(6, 0.0), sources, values).IsOk());
  EXPECT_TRUE(says(splines
                     .Evaluate({ dgg::SurfacePoint::AtVertex(-3) }, dgg::GreensMethod::Interpolated,
                       nullptr, nullptr, values)
                     .GetMessage(),
    "point 0"));
  // Another system.
  ASSERT_TRUE(solver.Prepare(With(dgg::PoissonBoundary::Dirichlet), nullptr).IsOk());
  EXPECT_TRUE(says(splines.FindBasis(nullptr, nullptr, ignore).GetMessage(), "anew"));
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (solver.IsFixed(v))
    {
      EXPECT_TRUE(says(messageOf({ v }), "lies on the boundary"));
      break;
    }
  }

  const dgg::SurfaceMesh isolated = Build(SphereWithIsolatedPoints(1));
  dgg::PoissonSolver other(isolated);
  ASSERT_TRUE(other.Prepare({}, nullptr).IsOk());
  for (Id v = 0; v < isolated.GetNumberOfVertices(); ++v)
  {
    if (isolated.FanBegin(v) == isolated.FanEnd(v))
    {
      EXPECT_TRUE(says(dgg::CheckSplineSites(other, { v }).GetMessage(), "has no face"));
    }
  }
}

TEST(HarmonicSplines, StopsWhenAsked)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.02, 3));
  Splines splines(mesh);
  std::vector<Id> sites;
  const auto ignore = [](Id, const std::vector<double>&) {};
  const std::vector<std::function<dgg::Status(const dgg::ProgressCallback&)>> steps = {
    [&](const dgg::ProgressCallback& progress) {
      return dgg::ChooseSplineSites(splines.Solver, 100, progress, sites);
    },
    [&](const dgg::ProgressCallback& progress) {
      return splines.Functions.Prepare(sites, nullptr, progress);
    },
    [&](const dgg::ProgressCallback& progress) {
      return splines.Functions.FindBasis(nullptr, progress, ignore);
    }
  };
  for (std::size_t k = 0; k < steps.size(); ++k)
  {
    int calls = 0;
    double last = 0.0;
    EXPECT_TRUE(steps[k]([&](double done) {
      EXPECT_GE(done, last);
      last = done;
      ++calls;
      return true;
    }).IsOk());
    EXPECT_EQ(last, 1.0) << k;
    for (int stop = 0; stop < calls; stop += 1 + calls / 5)
    {
      int left = stop;
      EXPECT_TRUE(steps[k]([&](double) { return left-- > 0; }).IsAborted()) << k;
    }
    EXPECT_TRUE(steps[k](nullptr).IsOk());
  }
}
}
