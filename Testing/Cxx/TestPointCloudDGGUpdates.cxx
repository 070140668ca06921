// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: what is kept between updates, memory, progress.
#include "GraphTestTools.h"
#include "PointCloudDGGFixture.h"

#include "vtkElevationFilter.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dggtest
{
TEST_F(PointCloudDGG, KeepsTheGraph)
{
  const Points points = MakeFlatPoints(25, 0.2);
  const auto cloud = MakeCloud(points);
  vtkNew<vtkElevationFilter> elevation; // changes something upstream, but not the points
  elevation->SetInputData(cloud);
  this->Filter->SetInputConnection(elevation->GetOutputPort());
  ExpectSuccess(this->Filter);
  const vtkMTimeType first = this->Filter->GetGraphBuildTime();
  elevation->SetHighPoint(0.0, 0.0, 3.0);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), first);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  EXPECT_GT(this->Filter->GetSpacing(), 0.0);
  this->Filter->SetMemoryLimit(1u << 30);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), first);

  this->Filter->SetAccuracy(0.01);
  ExpectSuccess(this->Filter);
  const vtkMTimeType second = this->Filter->GetGraphBuildTime();
  EXPECT_GT(second, first);

  cloud->GetPoints()->SetPoint(3, 0.1, 0.02, 0.001);
  cloud->GetPoints()->Modified();
  ExpectSuccess(this->Filter);
  const vtkMTimeType third = this->Filter->GetGraphBuildTime();
  EXPECT_GT(third, second);

  this->Filter->ReleaseGraph();
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_GT(this->Filter->GetGraphBuildTime(), third);
}

TEST_F(PointCloudDGG, ReportsTheKeptGraphAfterAnError)
{
  this->Use(MakeFlatPoints(25, 0.2));
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  const double spacing = this->Filter->GetSpacing();
  this->Filter->SetAlpha(-1.0);
  ExpectError(this->Filter, { "Alpha" });
  EXPECT_EQ(this->Filter->GetSpacing(), 0.0);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
  this->Filter->SetAlpha(0.0);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_EQ(this->Filter->GetSpacing(), spacing);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  EXPECT_GT(this->Filter->GetNumberOfGraphEdges(), 0);
}

TEST_F(PointCloudDGG, WarnsOncePerGraph)
{
  this->Use(MakeVolumePoints(1500));
  ExpectWarning(this->Filter, { "do not lie on a surface" });
  const double scatter = this->Filter->GetScatter();
  EXPECT_GT(scatter, 1.0);
  // The graph is kept: what there was to warn of can be asked.
  this->Filter->SetMemoryLimit(1u << 30);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetScatter(), scatter);
  EXPECT_GT(this->Filter->GetOffSurfaceShare(), 0.5);
  this->Filter->ReleaseGraph();
  this->Filter->Modified();
  ExpectWarning(this->Filter, { "do not lie on a surface" });
}

TEST_F(PointCloudDGG, ThreadsDoNotMatter)
{
  this->Use(MakeSpherePoints(700));
  this->Filter->EstimateNormalsOn();
  std::vector<std::string> first;
  ForEachThreading([&](const std::string& name) {
    this->Filter->ReleaseGraph();
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    const std::vector<std::string> bytes = GetCloudBytes(this->GetOutput());
    first = first.empty() ? bytes : first;
    EXPECT_EQ(bytes, first) << name;
  });
}

TEST_F(PointCloudDGG, EstimatesMemory)
{
  EXPECT_EQ(this->Filter->GetEstimatedMemory(), 0u);
  this->Use(MakeFlatPoints(60, 0.3));
  const vtkTypeUInt64 estimate = this->Filter->EstimateMemory();
  EXPECT_EQ(this->Filter->GetErrorCode(), 0u);
  EXPECT_EQ(estimate, this->Filter->GetEstimatedMemory());
  ExpectSuccess(this->Filter);
  const auto taken = static_cast<double>(this->Filter->GetMemorySize());
  EXPECT_GT(static_cast<double>(estimate), 0.6 * taken);
  EXPECT_LT(static_cast<double>(estimate), 1.8 * taken);
  EXPECT_GE(this->Filter->GetEstimatedPeakMemory(), estimate);

  this->Filter->EstimateMemory();
  this->Filter->SetMemoryLimit(this->Filter->GetEstimatedPeakMemory());
  this->Filter->ReleaseGraph();
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(10000);
  this->Filter->SetAccuracy(0.002);
  ExpectError(this->Filter, { "limit" });
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(), 0);
  EXPECT_EQ(this->Filter->GetSpacing(), 0.0);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
}

TEST_F(PointCloudDGG, ProgressAndAbort)
{
  const auto cloud = MakeCloud(MakeSpherePoints(8000));
  for (const double stop : { 2.0, 0.12, 0.5 })
  {
    vtkNew<vtkPointCloudDGG> filter; // outlived by its observer
    filter->SetInputData(cloud);
    filter->EstimateNormalsOn();
    ProgressWatch watch(filter);
    watch.StopAt = stop;
    filter->Update();
    EXPECT_EQ(filter->GetErrorCode(), 0u);
    if (stop > 1.0)
    {
      watch.ExpectGrowth();
      EXPECT_GT(filter->GetNumberOfGraphEdges(), 0);
      continue;
    }
    ExpectEmptyOutput(filter);
    EXPECT_EQ(filter->GetNumberOfGraphEdges(), 0);
    EXPECT_EQ(filter->GetNumberOfComponents(), 0);
    watch.StopAt = 2.0;
    ExpectSuccess(filter);
    EXPECT_GT(filter->GetNumberOfGraphEdges(), 0);
  }
}
}
