// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of memory share.
#ifndef MemoryChecks_h
#define MemoryChecks_h

#include "FlatMeshes.h"

#include "../Benchmark/MemoryProbe.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace dggtest
{
/// Unit cells made that high: cotangents so large that solutions may be refined, which takes more.
inline TestMesh NarrowPlane(Id nx, Id ny, double height)
{
  TestMesh plane = Plane(nx, ny);
  for (std::size_t i = 1; i < plane.Points.size(); i += 3)
  {
    plane.Points[i] *= height;
  }
  return plane;
}

/// What was predicted is enough, and not far too much. A peak of 0 could not be measured.
inline void ExpectPrediction(
  std::size_t peak, std::size_t predicted, double slack, const std::string& context)
{
  EXPECT_LE(peak, predicted) << context;
  if (peak > 0)
  {
    EXPECT_LE(predicted, slack * static_cast<double>(peak)) << context << ": " << peak;
  }
}
}

#endif
