// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Progress grows to 1; a run that is stopped leaves nothing, and the next one works.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkErrorCode.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

using namespace dggtest;

namespace
{
class ProgressAndAbort : public ::testing::TestWithParam<int>
{
protected:
  void SetUp() override
  {
    // Large enough to take a while with either engine.
    const bool reference = this->GetParam() == vtkExactGeodesicDistance::Reference;
    this->Surface = MakeTerrain(reference ? 40 : 130);
    this->Filter->SetInputData(this->Surface);
    this->Filter->AddSourceId(0);
    this->Filter->SetEngine(this->GetParam());
  }

  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkExactGeodesicDistance> Filter;
  ProgressWatch Watcher{ this->Filter };
};
}

TEST_P(ProgressAndAbort, ProgressGrowsToOne)
{
  ExpectSuccess(this->Filter);
  EXPECT_GT(this->Watcher.Progress.size(), 10u);
  this->Watcher.ExpectGrowth();
}

TEST_P(ProgressAndAbort, AStoppedRunLeavesNothing)
{
  ExpectSuccess(this->Filter);
  const auto expected = GetDistances(this->Filter);
  for (const double stop : { 0.05, 0.3, 0.6 })
  {
    this->Watcher.StopAt = stop;
    this->Watcher.Progress.clear();
    this->Filter->Modified();
    ExpectSuccess(this->Filter); // not an error
    EXPECT_LT(this->Watcher.Progress.back(), 1.0);
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);

    this->Watcher.StopAt = 2.0;
    ExpectSuccess(this->Filter); // nothing has changed, yet it runs
    EXPECT_EQ(GetDistances(this->Filter), expected);
  }
}

TEST_P(ProgressAndAbort, AStopRequestedBeforeTheRunIsForgotten)
{
  this->Filter->AbortExecuteOn();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), this->Surface->GetNumberOfPoints());
}

INSTANTIATE_TEST_SUITE_P(Engines, ProgressAndAbort,
  ::testing::Values(vtkExactGeodesicDistance::Reference, vtkExactGeodesicDistance::Triangle),
  [](const ::testing::TestParamInfo<int>& engine) {
    return engine.param == vtkExactGeodesicDistance::Reference ? "Reference" : "Triangle";
  });
