// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Updates of vtkDGGPath: what is kept between them, wrong input, threads, progress.
#include "GraphTestTools.h"
#include "PathFixture.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"

#include <gtest/gtest.h>

using namespace dggtest;

namespace
{
class DGGPathUpdates : public PathFixture
{
};
}

TEST_F(DGGPathUpdates, WhatIsKeptBetweenUpdatesFollowsEveryChange)
{
  // After each change, the filter gives what a new one gives.
  const auto expectTheSameAsNew = [&](const char* what) {
    SCOPED_TRACE(what);
    ExpectSuccess(this->Filter);
    vtkNew<vtkDGGPath> fresh;
    fresh->SetInputData(this->Filter->GetInput());
    fresh->SetAccuracy(this->Filter->GetAccuracy());
    fresh->SetMergeCoincidentPoints(this->Filter->GetMergeCoincidentPoints());
    fresh->SetMethod(this->Filter->GetMethod());
    fresh->SetProjectionTolerance(1.0);
    fresh->AcceptCoarserGraphOn();
    for (vtkIdType i = 0; i < this->Filter->GetNumberOfPairs(); ++i)
    {
      fresh->AddPair(this->Filter->GetPairStart(i), this->Filter->GetPairEnd(i));
    }
    fresh->SetPairData(vtkPolyData::SafeDownCast(this->Filter->GetInputDataObject(1, 0)));
    ExpectSuccess(fresh);
    const auto paths = GetPaths(this->Filter);
    EXPECT_EQ(paths.size(), static_cast<std::size_t>(fresh->GetOutput()->GetNumberOfLines()));
    EXPECT_FALSE(paths.empty());
    EXPECT_EQ(paths, GetPaths(fresh));
    return paths;
  };
  this->Filter->SetProjectionTolerance(1.0);
  this->Filter->AcceptCoarserGraphOn();
  AddPairs(this->Filter, { { 0, 399 } });
  const auto first = expectTheSameAsNew("one pair");
  this->Filter->AddPair(5, 310);
  EXPECT_EQ(expectTheSameAsNew("another pair")[0], first[0]);
  this->Filter->SetPairData(MakePairs({ { { 0.21, 0.13, 0.0 } }, { { 0.83, 0.72, 0.0 } } }));
  EXPECT_EQ(expectTheSameAsNew("pairs that need links")[0], first[0]);
  this->Filter->SetPairData(nullptr);
  EXPECT_EQ(expectTheSameAsNew("no links again")[0], first[0]);
  this->Filter->SetAccuracy(0.2);
  expectTheSameAsNew("another graph");
  this->Filter->SetMethodToExact();
  expectTheSameAsNew("no graph");
  this->Filter->SetMethodToGraph();
  expectTheSameAsNew("a graph again");
  this->Terrain->GetPoints()->SetPoint(210, 0.5, 0.52, 0.7);
  this->Terrain->GetPoints()->Modified();
  EXPECT_FALSE(expectTheSameAsNew("another surface")[0] == first[0]);
  this->Filter->SetInputData(MakeSurfaceWithGraph(this->Terrain, 0.05));
  expectTheSameAsNew("a graph on the input");
  this->Filter->SetInputData(MakeSurfaceWithGraph(this->Terrain, 0.1));
  expectTheSameAsNew("another graph on the input");
  this->Filter->SetInputData(MakeTerrain(20));
  EXPECT_EQ(this->Filter->GetAccuracy(), 0.2);
  this->Filter->SetAccuracy(0.05);
  EXPECT_EQ(expectTheSameAsNew("the first surface")[0], first[0]);
  this->Filter->MergeCoincidentPointsOn();
  EXPECT_EQ(expectTheSameAsNew("the same mesh, prepared anew")[0], first[0]);
}

TEST_F(DGGPathUpdates, GraphsOfAllConstructions)
{
  const Points ends = { { { 0.21, 0.13, 0.0 } }, { { 0.83, 0.72, 0.0 } }, { { 0.5, 0.5, 0.0 } },
    { { 0.9, 0.1, 0.0 } } };
  this->Filter->SetProjectionTolerance(1.0);
  this->Filter->SetPairData(MakePairs(ends));
  this->Filter->AddPair(0, 399);
  this->Filter->AcceptCoarserGraphOn();
  this->Filter->SetMethodToExact();
  ExpectSuccess(this->Filter);
  const auto exact = GetPaths(this->Filter);
  this->Filter->SetMethodToGraph();
  for (const int construction :
    { vtkDiscreteGeodesicGraph::Guaranteed, vtkDiscreteGeodesicGraph::OneRelay,
      vtkDiscreteGeodesicGraph::Indirect, vtkDiscreteGeodesicGraph::SaddleVertexGraph })
  {
    SCOPED_TRACE(construction);
    this->Filter->SetInputData(MakeSurfaceWithGraph(this->Terrain, 0.05, construction));
    ExpectSuccess(this->Filter);
    EXPECT_TRUE(this->Filter->GetUsedInputGraph());
    const auto paths = GetPaths(this->Filter);
    ASSERT_EQ(paths.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
    {
      ExpectOnSurface(paths[i], this->Terrain);
      EXPECT_GE(paths[i].Length, exact[i].Length * (1.0 - 1e-9));
      EXPECT_LE(paths[i].Length, exact[i].Length * 1.1);
      EXPECT_LE(paths[i].Length, paths[i].GraphLength * (1.0 + 1e-9));
    }
  }
}

/// Also where the thread that waits for the others has no propagation of its own.
TEST_F(DGGPathUpdates, PropagationsReportTheirProgressInAllThreads)
{
  this->Filter->SetInputData(MakeTerrain(100));
  this->Filter->SetMethodToExact();
  AddPairs(this->Filter, { { 0, 100 * 100 - 1 }, { 1, 100 * 100 - 2 } });
  ForEachThreading([&](const std::string& threading) {
    SCOPED_TRACE(threading);
    ProgressWatch watch(this->Filter);
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    watch.ExpectGrowth(2);
    watch.Progress.clear();
    watch.StopAt = 0.101; // the start is at 0.1
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    ExpectEmptyOutput(this->Filter);
    EXPECT_LT(watch.Progress.back(), 0.9);
    this->Filter->RemoveAllObservers();
  });
}
