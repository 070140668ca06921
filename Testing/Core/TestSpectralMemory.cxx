// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Tests of what solvers are expected to take: enough, and at most twice what they do.
#include "dggEarthMovers.h"
#include "dggGreensFunction.h"
#include "dggHeatMethod.h"
#include "dggPoissonSolver.h"

#include "CurvedMeshes.h"
#include "MemoryChecks.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace dggtest
{
namespace
{
/// Results, and parts of the code that allocate once.
constexpr std::size_t Small = 400000;

std::vector<NamedMesh> Meshes()
{
  return { { "sphere", NoisySphere(5, 0.01, 3) }, { "terrain", Terrain(110, 0.8, 5) },
    { "needles", NarrowPlane(150, 80, 1e-3) } };
}

/// What is held after the analysis, and the most that is added then.
template <typename Solver, typename Options>
std::size_t MeasureFactorization(Solver& solver, const Options& options, double& estimated)
{
  const MemoryProbe probe;
  EXPECT_TRUE(solver.Analyze(options, nullptr).IsOk());
  estimated = solver.GetEstimatedMemory();
  const std::size_t held = probe.GetHeapGrowth();
  const MemoryProbe later;
  EXPECT_TRUE(solver.Factorize(nullptr).IsOk());
  EXPECT_EQ(solver.GetEstimatedMemory(), estimated);
  const std::size_t peak = later.GetHeapPeak();
  return peak > 0 ? held + peak : 0;
}
}

TEST(SpectralMemory, OfFactorizations)
{
  for (const NamedMesh& named : Meshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    double estimated = 0.0;
    dgg::PoissonSolver solver(mesh);
    std::size_t peak = MeasureFactorization(solver, dgg::PoissonOptions(), estimated);
    ExpectPrediction(peak, static_cast<std::size_t>(estimated), 2.0, "Poisson " + named.Name);
    for (const dgg::HeatBoundary boundary :
      { dgg::HeatBoundary::Neumann, dgg::HeatBoundary::Average })
    {
      dgg::HeatMethod heat(mesh);
      dgg::HeatOptions options;
      options.Boundary = boundary;
      peak = MeasureFactorization(heat, options, estimated);
      ExpectPrediction(peak, static_cast<std::size_t>(estimated), 2.0, "heat " + named.Name);
    }
  }
}

TEST(SpectralMemory, OfGreensFunctions)
{
  for (const NamedMesh& named : Meshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    dgg::PoissonSolver solver(mesh);
    ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
    const dgg::GreensFunction function(solver);
    const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
    std::vector<dgg::SurfacePoint> poles;
    for (std::size_t k = 0; k < dgg::GreensFunction::PolesInBlock; ++k)
    {
      poles.push_back(dgg::SurfacePoint::AtVertex(static_cast<dgg::Id>(k * (n / 9) + 7)));
    }
    dgg::GreensQuery query;
    query.Radius = named.Name == "needles" ? 1.2 : 0.0; // or no distances would be found
    std::vector<dgg::GreensResult> results;
    const MemoryProbe probe;
    ASSERT_TRUE(function.Run(poles, query, results).IsOk());
    const std::size_t peak = probe.GetHeapPeak();
    const double estimated = dgg::GreensFunction::BytesPerVertex * static_cast<double>(n);
    ExpectPrediction(
      peak - std::min(peak, Small), static_cast<std::size_t>(estimated), 2.0, named.Name);
  }
}
}
