// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Tests of what solvers are expected to take: enough, and at most twice what they do.
#include "dggGreensFunction.h"
#include "dggHeatMethod.h"
#include "dggPoissonSolver.h"

#include "CurvedMeshes.h"
#include "MemoryChecks.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
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

/// Checks what a solver predicts against the most that it takes. That of the analysis, before the
/// prediction, does not count.
template <typename Solver, typename Options>
void CheckFactorization(
  const dgg::SurfaceMesh& mesh, const Options& options, const std::string& what)
{
  Solver solver(mesh);
  MemoryProbe probe;
  std::size_t held = 0;
  double estimated = 0.0;
  std::optional<MemoryProbe> later;
  const auto check = [&](double bytes, auto...) {
    estimated = bytes;
    held = probe.GetHeapGrowth();
    later.emplace();
    return dgg::Status::Success();
  };
  ASSERT_TRUE(solver.Prepare(options, nullptr, check).IsOk());
  EXPECT_EQ(solver.GetEstimatedMemory(), estimated);
  const std::size_t peak = later->GetHeapPeak();
  ExpectPrediction(peak > 0 ? held + peak : 0, static_cast<std::size_t>(estimated), 2.0, what);
}
}

TEST(SpectralMemory, OfFactorizations)
{
  for (const NamedMesh& named : Meshes())
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    CheckFactorization<dgg::PoissonSolver>(mesh, dgg::PoissonOptions(), "Poisson " + named.Name);
    for (const dgg::HeatBoundary boundary :
      { dgg::HeatBoundary::Neumann, dgg::HeatBoundary::Average })
    {
      dgg::HeatOptions options;
      options.Boundary = boundary;
      CheckFactorization<dgg::HeatMethod>(mesh, options, "heat " + named.Name);
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
