// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How far approximate distances are off.
#ifndef ApproximationChecks_h
#define ApproximationChecks_h

#include "GeodesicChecks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dggtest
{
/// Relative to the expected distance, where that is not 0.
struct Errors
{
  double Mean = 0.0;
  double Largest = 0.0;
};

inline Errors Compare(const std::vector<double>& actual, const std::vector<double>& expected)
{
  EXPECT_EQ(actual.size(), expected.size());
  Errors errors;
  double count = 0.0;
  for (std::size_t v = 0; v < actual.size(); ++v)
  {
    EXPECT_EQ(actual[v] < dgg::Infinity, expected[v] < dgg::Infinity) << v;
    if (expected[v] > 0.0 && expected[v] < dgg::Infinity)
    {
      const double error = std::abs(actual[v] / expected[v] - 1.0);
      errors.Mean += error;
      errors.Largest = std::max(errors.Largest, error);
      count += 1.0;
    }
  }
  errors.Mean /= std::max(1.0, count);
  return errors;
}

/// Distances in the plane.
inline std::vector<double> EuclideanDistances(const TestMesh& plane, Id source)
{
  std::vector<double> distances;
  for (Id v = 0; v < plane.GetNumberOfVertices(); ++v)
  {
    distances.push_back(EuclideanDistance(plane, source, v));
  }
  return distances;
}
}

#endif
