// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which meshes the Poisson equation is refused on.
#ifndef ThinTriangleChecks_h
#define ThinTriangleChecks_h

#include "dggPoissonSolver.h"

#include <gtest/gtest.h>

#include <string>

namespace dggtest
{
/// Whether its triangles are too thin. Fails where something else is wrong.
inline bool IsTooThin(const dgg::SurfaceMesh& mesh, const dgg::PoissonOptions& options = {})
{
  dgg::PoissonSolver solver(mesh);
  const dgg::Status status = solver.Prepare(options, nullptr);
  EXPECT_EQ(status.IsOk(), solver.IsReady());
  if (!status.IsOk())
  {
    EXPECT_NE(status.GetMessage().find("too thin"), std::string::npos) << status.GetMessage();
  }
  return !status.IsOk();
}

/// The same, for meshes of all kinds: of those with names only soups may be.
inline bool IsThinSoup(
  const dgg::SurfaceMesh& mesh, const std::string& name, const dgg::PoissonOptions& options)
{
  const bool isThin = IsTooThin(mesh, options);
  EXPECT_TRUE(!isThin || name.compare(0, 4, "soup") == 0) << name;
  return isThin;
}
}

#endif
