// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Equations on cells whose coefficients are given, so that they may be bad ones.
#include "FlatMeshes.h"
#include "GreensTestTools.h"

#include "dggPoissonSystem.h"
#include "dggSplineCells.h"

#include <gtest/gtest.h>

#include <vector>

namespace dggtest
{
namespace
{
struct Link
{
  int From;
  int To;
  double Coefficient; // c_ij
};

/// The first vertices of a mesh are cells that conduct as the links say; others are in no cell.
dgg::SplineCells CellsOf(const dgg::SurfaceMesh& mesh, int count, const std::vector<Link>& links)
{
  dgg::SplineCells cells;
  cells.Cells.assign(mesh.GetNumberOfVertices(), dgg::NoId);
  for (Id i = 0; i < count; ++i)
  {
    cells.Cells[i] = i;
  }
  cells.Components.assign(count, 0);
  cells.Weights.assign(count, 1.0 / count);
  std::vector<Eigen::Triplet<double, int>> entries;
  for (const Link& link : links)
  {
    entries.emplace_back(link.From, link.From, link.Coefficient);
    entries.emplace_back(link.To, link.To, link.Coefficient);
    entries.emplace_back(link.From, link.To, -link.Coefficient);
    entries.emplace_back(link.To, link.From, -link.Coefficient);
  }
  cells.Stiffness.resize(count, count);
  cells.Stiffness.setFromTriplets(entries.begin(), entries.end());
  return cells;
}
}

TEST(SiteEquations, SmallPivotsAreNoMatter)
{
  // With cell 0 held, the equations are next to (0 -1; -1 0), which has no pivots at all.
  const dgg::SurfaceMesh mesh = Build(Plane(3, 3));
  const Greens greens(mesh);
  const dgg::PoissonSystem& system = greens.Solver.GetSystem();
  for (const double little : { 1e-12, 1e-20, -1e-14 })
  {
    dgg::SplineCells cells = CellsOf(mesh, 3, { { 0, 1, -1.0 }, { 0, 2, -1.0 }, { 1, 2, 1.0 } });
    cells.Stiffness.coeffRef(1, 1) = little;
    cells.Stiffness.coeffRef(2, 2) = little;
    std::vector<double> sources(mesh.GetNumberOfVertices(), 0.0);
    sources[1] = 1.0;
    sources[2] = 2.0;
    std::vector<double> values(3, 0.0);
    ASSERT_TRUE(dgg::SolveSiteEquations(system, cells, sources, { 0 }, values)) << little;
    EXPECT_NEAR(values[1], -2.0, 1e-8) << little;
    EXPECT_NEAR(values[2], -1.0, 1e-8) << little;
  }
}

TEST(SiteEquations, SingularOnesAreRefused)
{
  // Ways from 1 and 2 to the held cell, and one between them that undoes both: singular up to
  // rounding, which leaves a pivot that is not quite 0.
  const dgg::SurfaceMesh mesh = Build(Plane(3, 3));
  const Greens greens(mesh);
  const dgg::PoissonSystem& system = greens.Solver.GetSystem();
  for (int k = 1; k < 30; ++k)
  {
    const double a = 0.1 * k;
    const double b = 0.3;
    const dgg::SplineCells cells =
      CellsOf(mesh, 3, { { 0, 1, a }, { 0, 2, b }, { 1, 2, -a * b / (a + b) } });
    std::vector<double> sources(mesh.GetNumberOfVertices(), 0.0);
    sources[1] = 1.0;
    sources[2] = 0.7;
    std::vector<double> values(3, 0.0);
    EXPECT_FALSE(dgg::SolveSiteEquations(system, cells, sources, { 0 }, values)) << k;
  }
}
}
