// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorStatistics.h"

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
  const auto errors = ErrorStatistics::Of({ 0.0, 1.1, 3.0, Far }, { 0.0, 1.0, 4.0, 5.0 });
  EXPECT_FALSE(errors.IsEmpty());
  EXPECT_NEAR(errors.Mean, 0.175, 1e-12);
  EXPECT_NEAR(errors.Maximum, 0.25, 1e-12);
  EXPECT_EQ(errors.Unreached, 1U);
  EXPECT_EQ(errors.Beyond, 0U);
}

TEST(ErrorStatistics, NothingReachedIsNotNoError)
{
  const auto errors = ErrorStatistics::Of({ 0.0, Far, NaN }, { 0.0, 1.0, 4.0 });
  EXPECT_TRUE(errors.IsEmpty());
  EXPECT_FALSE(errors.Mean >= 0.0 || errors.Percentile999 >= 0.0 || errors.Maximum >= 0.0);
  EXPECT_EQ(errors.Unreached, 2U);
  EXPECT_TRUE(ErrorStatistics::Of({}, {}).IsEmpty());
}

TEST(ErrorStatistics, WhatCannotBeReached)
{
  const auto errors = ErrorStatistics::Of({ 0.0, 1.0, 7.0, Far }, { 0.0, 1.0, Far, Far });
  EXPECT_EQ(errors.Mean, 0.0);
  EXPECT_EQ(errors.Beyond, 1U);
  EXPECT_EQ(errors.Unreached, 0U);
}
