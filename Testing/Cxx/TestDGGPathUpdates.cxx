// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Updates of vtkDGGPath: what is kept between them, wrong input, threads, progress.
#include "GraphTestTools.h"
#include "PathFixture.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

using namespace dggtest;

namespace
{
class DGGPathUpdates : public PathFixture
{
};
}

TEST_F(DGGPathUpdates, TakesTheGraphOnItsInputOrBuildsOnce)
{
  AddPairs(this->Filter, { { 0, 399 } });
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  EXPECT_GT(built, 0u);
  EXPECT_FALSE(this->Filter->GetUsedInputGraph());
  EXPECT_TRUE(this->Filter->GetGraphIsGuaranteed());
  const auto expected = GetPaths(this->Filter);
  this->Filter->AddPair(7, 200);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_EQ(GetPaths(this->Filter).size(), 2u);
  this->Filter->RemoveAllPairs();
  this->Filter->AddPair(0, 399);
  auto surface = MakeSurfaceWithGraph(this->Terrain, 0.05);
  vtkNew<vtkStringArray> note;
  note->SetName("note");
  note->InsertNextValue("kept");
  surface->GetFieldData()->AddArray(note);
  this->Filter->SetInputData(surface);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(this->Filter->GetGraphAccuracy(), 0.05);
  EXPECT_EQ(GetPaths(this->Filter), expected);
  EXPECT_GE(this->Filter->GetMemorySize(),
    static_cast<vtkTypeUInt64>(16 * this->Filter->GetNumberOfGraphEdges()));
  // Polylines are another surface: they do not have its graph. The input still has.
  EXPECT_EQ(GetGraphBytes(this->Filter->GetOutput()), std::vector<std::string>(6));
  EXPECT_NE(GetGraphBytes(surface)[0], "");
  EXPECT_NE(this->Filter->GetOutput()->GetFieldData()->GetAbstractArray("note"), nullptr);
  this->Filter->SetAccuracy(0.01);
  ExpectWarning(this->Filter, { "Accuracy 0.01 is asked for" });
  this->Filter->AcceptCoarserGraphOn();
  this->Filter->SetAccuracy(0.02);
  ExpectSuccess(this->Filter);
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

TEST_F(DGGPathUpdates, MemoryIsThatOfGraphAndSearches)
{
  AddPairs(this->Filter, { { 0, 399 } });
  ExpectSuccess(this->Filter);
  const vtkTypeUInt64 size = this->Filter->GetMemorySize();
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetMemorySize(), size);
  // The graph alone. What is left is a search, the corridor of a path, and coordinates.
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputData(this->Terrain);
  graph->SetAccuracy(0.05);
  ExpectSuccess(graph);
  ASSERT_EQ(graph->GetNumberOfGraphEdges(), this->Filter->GetNumberOfGraphEdges());
  const vtkTypeUInt64 rest = size - graph->GetMemorySize();
  // About 88, 39 and 24 bytes for each point: none of them may be missing.
  EXPECT_GT(rest, 140u * this->Terrain->GetNumberOfPoints());
  EXPECT_LT(rest, 170u * this->Terrain->GetNumberOfPoints());
}

/// Not even numbers are read from a mesh that is gone.
TEST_F(DGGPathUpdates, MemoryIsThatOfTheLastGraph)
{
  AddPairs(this->Filter, { { 0, 399 } });
  ExpectSuccess(this->Filter);
  const vtkTypeUInt64 size = this->Filter->GetMemorySize();
  this->Filter->SetMethodToExact();
  this->Filter->RemoveAllPairs();
  this->Filter->AddPair(0, 24);
  for (const int n : { 5, 90 })
  {
    this->Filter->SetInputData(MakeTerrain(n));
    ExpectSuccess(this->Filter);
    EXPECT_EQ(this->Filter->GetMemorySize(), size);
  }
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

TEST_F(DGGPathUpdates, WrongPairs)
{
  ExpectError(this->Filter, { "there is no pair", "AddPair()", "input port 1" });
  vtkNew<vtkPolyData> empty;
  this->Filter->SetPairData(empty);
  ExpectError(this->Filter, { "there is no pair", "port 1 is empty" });
  this->Filter->AddPair(0, 5);
  ExpectSuccess(this->Filter); // that will do
  this->Filter->SetPairData(MakeSourcePoints({ { { 0, 0, 0 } }, { { 1, 1, 0 } } }));
  ExpectError(this->Filter, { "port 1 has points but no lines", "by a line" });
  this->Filter->SetPairData(nullptr);
  this->Filter->AddPair(3, 400);
  ExpectError(this->Filter, { "path end id 400 ", "number 3 of the path end ids", "[0, 399]" });
  this->Filter->RemoveAllPairs();
  this->Filter->AddPair(-1, 3);
  ExpectError(this->Filter, { "path end id -1 " });
  this->Filter->RemoveAllPairs();
  auto lines = MakePairs({ { { 0.0, 0.0, 0.05 } }, { { 0.5, 0.5, 9.0 } } });
  this->Filter->SetPairData(lines);
  ExpectError(this->Filter,
    { "path end point 1 of input port 1", "(0.5, 0.5, 9)", "farther than", "ProjectionTolerance" });
  this->Filter->SetPairData(MakePairs({ { { 0.5, std::nan(""), 0.0 } }, { { 0, 0, 0 } } }));
  ExpectError(this->Filter, { "path end point 0 of input port 1", "not finite" });
  lines = MakePairs({ { { 0.5, 0.5, 0.0 } }, { { 0.5, 0.6, 0.0 } } });
  lines->SetLines(MakeCells({ { 0, 1 }, { 1, 7 } }));
  this->Filter->SetPairData(lines);
  ExpectError(this->Filter, { "line 1 of input port 1 names point 7", "there are 2" });
  lines->SetLines(MakeCells({ { 0, 1 }, {} }));
  lines->Modified();
  ExpectError(this->Filter, { "line 1 of input port 1 has no points" });
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  for (const vtkIdType value : { 0, 1 })
  {
    offsets->InsertNextValue(100000000 * value);
    connectivity->InsertNextValue(value);
  }
  vtkNew<vtkCellArray> broken;
  broken->SetData(offsets, connectivity);
  lines->SetLines(broken);
  lines->Modified();
  ExpectError(this->Filter, { "lines of input port 1 contradict each other" });
  this->Filter->SetPairData(nullptr);
  this->Filter->AddPair(0, 5);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetPaths(this->Filter).size(), 1u);
}

TEST_F(DGGPathUpdates, WrongProperties)
{
  this->Filter->AddPair(0, 5);
  this->Filter->SetProjectionTolerance(-1.0);
  ExpectError(this->Filter, { "ProjectionTolerance" });
  this->Filter->SetProjectionTolerance(0.01);
  this->Filter->SetDetour(std::nan(""));
  ExpectError(this->Filter, { "Detour" });
  this->Filter->SetDetour(1e-3);
  for (const double accuracy : { 0.0, 0.6, std::numeric_limits<double>::quiet_NaN() })
  {
    this->Filter->SetAccuracy(accuracy);
    ExpectError(this->Filter, { "ccuracy", "1e-06", "0.5" });
  }
  this->Filter->SetAccuracy(0.05);
  this->Filter->SetMemoryLimit(10000);
  ExpectError(this->Filter, { "the graph would take" });
  this->Filter->SetMethodToExact(); // needs none
  ExpectSuccess(this->Filter);
  this->Filter->SetMethodToGraph();
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(10000); // the graph is there
  this->Filter->SetProjectionTolerance(1.0);
  this->Filter->SetPairData(MakePairs({ { { 0.51, 0.52, 0.0 } }, { { 0.6, 0.1, 0.0 } } }));
  ExpectError(this->Filter, { "linking points that are not vertices" });
}

TEST_F(DGGPathUpdates, WrongSurfaces)
{
  this->Filter->AddPair(0, 5);
  ExpectSuccess(this->Filter);
  this->Filter->SetInputConnection(nullptr);
  ExpectError(this->Filter, { "there is no input" });
  this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  ExpectWarning(this->Filter, { "input is empty" });
  EXPECT_TRUE(GetPaths(this->Filter).empty());
  EXPECT_NE(this->Filter->GetOutput()->GetFieldData()->GetArray("PathStatus"), nullptr);
  this->Filter->SetInputData(MakeSourcePoints({ { { 0, 0, 0 } }, { { 1, 0, 0 } } }));
  this->Filter->RemoveAllPairs();
  this->Filter->AddPair(0, 1);
  ExpectError(this->Filter, { "polygon" });
  auto broken = MakeGrid(3, 3);
  broken->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  this->Filter->SetInputData(broken);
  ExpectError(this->Filter, { "point 5", "not finite" });
  this->Filter->SetInputData(this->Terrain);
  ExpectSuccess(this->Filter);
}

TEST_F(DGGPathUpdates, IsTheSameForAnyThreads)
{
  const Points places = GetPlaces(this->Terrain);
  Points ends;
  Pairs pairs;
  for (int i = 0; i < 60; ++i)
  {
    pairs.emplace_back((i % 5) * 79, (i * 131 + 17) % 400);
    ends.insert(ends.end(), { places[i % 3], places[(7 * i + 5) % 16] });
  }
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    auto make = [&] {
      vtkNew<vtkDGGPath> filter;
      filter->SetInputData(this->Terrain);
      filter->SetAccuracy(0.05);
      filter->SetMethod(method);
      AddPairs(filter, pairs);
      filter->SetPairData(MakePairs(ends));
      ExpectSuccess(filter);
      return GetPaths(filter);
    };
    const auto expected = make();
    ASSERT_EQ(expected.size(), 120u);
    ForEachThreading(
      [&](const std::string& threading) { EXPECT_TRUE(make() == expected) << threading; });
  }
}

TEST_F(DGGPathUpdates, ProgressAndAbort)
{
  this->Filter->SetInputData(MakeTerrain(40));
  for (int i = 0; i < 150; ++i)
  {
    this->Filter->AddPair(i * 7, 1599 - i * 5);
  }
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    this->Filter->SetMethod(method);
    ExpectSuccess(this->Filter);
    const auto expected = GetPaths(this->Filter);
    ASSERT_EQ(expected.size(), 150u);
    ProgressWatch watch(this->Filter);
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    watch.ExpectGrowth(3);
    watch.StopAt = 0.4;
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    ExpectEmptyOutput(this->Filter);
    watch.StopAt = 2.0;
    ExpectSuccess(this->Filter);
    EXPECT_TRUE(GetPaths(this->Filter) == expected);
    this->Filter->RemoveAllObservers();
  }
}

/// Also where the thread that waits for the others has no propagation of its own.
TEST_F(DGGPathUpdates, PropagationsTellTheirProgressInAllThreads)
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

TEST_F(DGGPathUpdates, OneLongPropagationTellsItsProgress)
{
  this->Filter->SetInputData(MakeTerrain(120));
  this->Filter->AddPair(0, 120 * 120 - 1);
  this->Filter->SetMethodToExact();
  ProgressWatch watch(this->Filter);
  ExpectSuccess(this->Filter);
  watch.ExpectGrowth(3);
  watch.Progress.clear();
  watch.StopAt = 0.5;
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  ExpectEmptyOutput(this->Filter);
  EXPECT_LT(watch.Progress.back(), 0.9);
}

TEST_F(DGGPathUpdates, PrintSelf)
{
  this->Filter->AddPair(1, 2);
  ExpectSuccess(this->Filter);
  std::ostringstream os;
  this->Filter->Print(os);
  for (const char* text : { "Method: Graph\n", "NumberOfPairs: 1\n", "Straighten: On\n",
         "Detour: 0.0001\n", "ProjectionTolerance: 0.01\n", "NumberOfFallbacks: 0\n",
         "Accuracy: 0.05\n", "GraphAccuracy: 0.05\n" })
  {
    EXPECT_NE(os.str().find(text), std::string::npos) << text << " is missing in:\n" << os.str();
  }
}
