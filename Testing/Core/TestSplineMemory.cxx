// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Harmonic B-splines take no more memory than is predicted.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "MemoryChecks.h"
#include "SplineTestTools.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace dggtest
{
TEST(SplineMemory, IsPredicted)
{
  const std::vector<NamedMesh> meshes = { { "sphere", NoisySphere(4, 0.03, 3) },
    { "plane", Scaled(Plane(50, 50, 0.3), 0.1) }, { "terrain", Terrain(50, 0.8, 5) } };
  for (const NamedMesh& named : meshes)
  {
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    for (const Id count :
      { 3, 40, 600, mesh.GetNumberOfVertices() - 1, mesh.GetNumberOfVertices() })
    {
      const std::string context = named.Name + " " + std::to_string(count);
      Splines splines(mesh);
      std::vector<Id> sites;
      ASSERT_TRUE(dgg::ChooseSplineSites(splines.Solver, count, nullptr, sites).IsOk());
      dgg::HarmonicSplines& functions = splines.Functions;
      const std::size_t prepared = functions.GetPreparationMemory(sites.size(), 1);
      {
        const MemoryProbe probe;
        splines.Prepare(sites);
        ExpectPrediction(probe.GetHeapPeak(), prepared, 3.0, "cells of " + context);
      }
      if (count == 40)
      {
        const MemoryProbe probe;
        ASSERT_TRUE(
          functions.FindBasis(nullptr, nullptr, [](Id, const std::vector<double>&) {}).IsOk());
        ExpectPrediction(
          probe.GetHeapPeak(), functions.GetBasisMemory(sites.size()), 1.6, "basis of " + context);
      }
      const std::vector<double> sources = Integrated(splines.Solver, [](Id v) { return v % 7; });
      std::vector<double> coefficients;
      const MemoryProbe probe;
      ASSERT_TRUE(functions.Solve(sources, {}, coefficients).IsOk());
      ExpectPrediction(probe.GetHeapPeak(), functions.GetSolutionMemory(sites.size()), 6.0,
        "equations of " + context);
    }
  }
}
}
