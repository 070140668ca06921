// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Statistics.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
constexpr double Far = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
}

TEST(ErrorStatistics, OfVerticesThatAreReached)
{
  // The source, two reached vertices and an unreached one.
  const ErrorStatistics errors({ 0.0, 1.1, 3.0, Far }, { 0.0, 1.0, 4.0, 5.0 });
  EXPECT_EQ(errors.Errors.GetCount(), 2U);
  EXPECT_NEAR(errors.Errors.GetMean(), 0.175, 1e-12);
  EXPECT_NEAR(errors.Errors.GetMaximum(), 0.25, 1e-12);
  EXPECT_EQ(errors.Unreached, 1U);
  EXPECT_EQ(errors.Beyond, 0U);
}

TEST(ErrorStatistics, CountsUnreachedVertices)
{
  const ErrorStatistics errors({ 0.0, Far, NaN }, { 0.0, 1.0, 4.0 });
  EXPECT_EQ(errors.Errors.GetCount(), 0U);
  EXPECT_EQ(errors.Unreached, 2U);
}

TEST(ErrorStatistics, CountsVerticesReachedBeyond)
{
  const ErrorStatistics errors({ 0.0, 1.0, 7.0, Far }, { 0.0, 1.0, Far, Far });
  EXPECT_EQ(errors.Errors.GetMaximum(), 0.0);
  EXPECT_EQ(errors.Beyond, 1U);
  EXPECT_EQ(errors.Unreached, 0U);
}

TEST(SampleStatistics, Quantiles)
{
  SampleStatistics sample;
  EXPECT_EQ(sample.GetMean(), 0.0);
  for (int i = 1; i <= 100; ++i)
  {
    sample.Add(i);
  }
  EXPECT_EQ(sample.GetQuantile(0.99), 99.0);
  EXPECT_EQ(sample.GetMinimum(), 1.0);
  EXPECT_EQ(sample.GetMaximum(), 100.0);
  EXPECT_EQ(sample.GetShareUpTo(25.0), 0.25);
}
