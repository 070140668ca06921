// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Updates of vtkDGGLoop: what is kept between them, wrong input, threads, progress.
#include "GraphTestTools.h"
#include "LoopFixture.h"

#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

using namespace dggtest;

namespace
{
class DGGLoopUpdates : public LoopFixture
{
};
}

TEST_F(DGGLoopUpdates, TakesTheGraphOnItsInputOrBuildsOnce)
{
  this->Filter->SetInputData(this->Torus);
  this->Filter->SetAccuracy(0.05);
  this->Filter->SetPointIds({ 7, 100 });
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  EXPECT_GT(built, 0u);
  EXPECT_FALSE(this->Filter->GetUsedInputGraph());
  EXPECT_TRUE(this->Filter->GetGraphIsGuaranteed());
  const auto expected = GetLoops(this->Filter);
  ASSERT_EQ(expected.size(), 2u);
  this->Filter->SetModeToRope();
  this->Filter->AddPointId(200);
  ExpectSuccess(this->Filter);
  this->Filter->SetModeToAroundHandles();
  ExpectSuccess(this->Filter);
  this->Filter->SetModeToThroughPoint();
  this->Filter->SetPointIds({ 7, 100 });
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_EQ(GetLoops(this->Filter), expected);
  auto surface = MakeSurfaceWithGraph(this->Torus, 0.05);
  vtkNew<vtkStringArray> note;
  note->SetName("note");
  note->InsertNextValue("kept");
  surface->GetFieldData()->AddArray(note);
  this->Filter->SetInputData(surface);
  this->Filter->SetTapeWidth(0.4);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(this->Filter->GetGraphAccuracy(), 0.05);
  EXPECT_EQ(GetLoops(this->Filter), expected);
  // Polylines are another surface: they do not have its graph. The input still has.
  for (vtkPolyData* output : { this->Filter->GetOutput(), this->Filter->GetTape() })
  {
    EXPECT_EQ(GetGraphBytes(output), std::vector<std::string>(6));
    EXPECT_NE(output->GetFieldData()->GetAbstractArray("note"), nullptr);
  }
  EXPECT_NE(GetGraphBytes(surface)[0], "");
  this->Filter->SetAccuracy(0.01);
  ExpectWarning(this->Filter, { "Accuracy 0.01 is asked for" });
}

TEST_F(DGGLoopUpdates, GraphsOfAllConstructions)
{
  const double tube = GetTubeLength(Nu, Nv);
  this->Filter->SetPointIds({ 5, 300 });
  this->Filter->TautOn();
  this->Filter->AcceptCoarserGraphOn();
  this->Filter->SetProjectionTolerance(0.1);
  this->Filter->SetPointData(MakeSourcePoints({ { { 1.0, 0.1, 0.4 } } }));
  for (const int construction :
    { vtkDiscreteGeodesicGraph::Guaranteed, vtkDiscreteGeodesicGraph::OneRelay,
      vtkDiscreteGeodesicGraph::Indirect, vtkDiscreteGeodesicGraph::SaddleVertexGraph })
  {
    SCOPED_TRACE(construction);
    this->Filter->SetInputData(MakeSurfaceWithGraph(this->Torus, 0.05, construction));
    ExpectSuccess(this->Filter);
    EXPECT_TRUE(this->Filter->GetUsedInputGraph());
    const auto loops = GetLoops(this->Filter);
    ASSERT_EQ(loops.size(), 3u);
    for (const LoopLine& loop : loops)
    {
      EXPECT_NEAR(loop.Line.Length, tube, 1e-9);
    }
    // A rope once around the tube, by way of places in faces.
    this->Filter->SetModeToRope();
    this->Filter->TautOff();
    this->Filter->RemoveAllPointIds();
    this->Filter->SetPointData(MakeSourcePoints({ { { 1.38, 0.1, 0.05 } }, { { 1.0, 0.1, 0.38 } },
      { { 0.62, 0.1, 0.0 } }, { { 1.0, 0.1, -0.38 } } }));
    ExpectSuccess(this->Filter);
    const auto ropes = GetLoops(this->Filter);
    ASSERT_EQ(ropes.size(), 1u);
    EXPECT_GE(ropes[0].Line.Length, tube * (1.0 - 1e-9));
    EXPECT_LE(ropes[0].Line.Length, tube * 1.2);
    this->Filter->SetModeToThroughPoint();
    this->Filter->TautOn();
    this->Filter->SetPointIds({ 5, 300 });
    this->Filter->SetPointData(MakeSourcePoints({ { { 1.0, 0.1, 0.4 } } }));
  }
}

TEST_F(DGGLoopUpdates, WrongPoints)
{
  ExpectError(this->Filter, { "there is no loop point", "AddPointId()", "input port 1" });
  vtkNew<vtkPolyData> empty;
  this->Filter->SetPointData(empty);
  ExpectError(this->Filter, { "there is no loop point", "port 1 has no points" });
  this->Filter->AddPointId(3 * Sides);
  ExpectSuccess(this->Filter); // that will do
  this->Filter->SetPointData(nullptr);
  this->Filter->AddPointId(63);
  ExpectError(this->Filter, { "loop point id 63 ", "number 1 of the loop point ids", "[0, 62]" });
  this->Filter->SetPointIds({ -1 });
  ExpectError(this->Filter, { "loop point id -1 " });
  this->Filter->SetPointIds({ 21 });
  this->Filter->SetPointData(MakeSourcePoints({ { { 0.0, 0.0, 99.0 } } }));
  ExpectError(this->Filter,
    { "loop point 0 of input port 1", "(0, 0, 99)", "farther than", "ProjectionTolerance" });
  this->Filter->SetPointData(MakeSourcePoints({ { { 0.5, std::nan(""), 0.0 } } }));
  ExpectError(this->Filter, { "loop point 0 of input port 1", "not finite" });
  this->Filter->SetPointData(nullptr);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetLoops(this->Filter).size(), 1u);
}

TEST_F(DGGLoopUpdates, WrongProperties)
{
  this->Filter->AddPointId(3 * Sides);
  this->Filter->SetProjectionTolerance(-1.0);
  ExpectError(this->Filter, { "ProjectionTolerance" });
  this->Filter->SetProjectionTolerance(0.01);
  for (const double width :
    { -0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    this->Filter->SetTapeWidth(width);
    ExpectError(this->Filter, { "TapeWidth is " });
  }
  this->Filter->SetTapeWidth(0.0);
  for (const double accuracy : { 0.0, 0.6, std::numeric_limits<double>::quiet_NaN() })
  {
    this->Filter->SetAccuracy(accuracy);
    ExpectError(this->Filter, { "ccuracy", "1e-06", "0.5" });
  }
  this->Filter->SetAccuracy(0.05);
  this->Filter->SetMemoryLimit(1000);
  ExpectError(this->Filter, { "the graph would take" });
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(1000); // the graph is there
  this->Filter->SetProjectionTolerance(1.0);
  this->Filter->SetPointData(MakeSourcePoints({ { { 1.0, 0.1, 3.14 } } }));
  ExpectError(this->Filter, { "linking points that are not vertices" });
}

TEST_F(DGGLoopUpdates, WrongSurfaces)
{
  this->Filter->AddPointId(3 * Sides);
  this->Filter->SetTapeWidth(0.5);
  ExpectSuccess(this->Filter);
  this->Filter->SetInputConnection(nullptr);
  ExpectError(this->Filter, { "there is no input" });
  for (const int mode : { vtkDGGLoop::ThroughPoint, vtkDGGLoop::AroundHandles, vtkDGGLoop::Rope })
  {
    this->Filter->SetMode(mode);
    this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
    ExpectWarning(this->Filter, { "input is empty" });
    EXPECT_TRUE(GetLoops(this->Filter).empty());
    EXPECT_TRUE(GetRims(this->Filter).empty());
    EXPECT_TRUE(GetLoopStatus(this->Filter).empty());
  }
  this->Filter->SetModeToAroundHandles();
  this->Filter->SetInputData(MakeSourcePoints({ { { 0, 0, 0 } }, { { 1, 0, 0 } } }));
  ExpectError(this->Filter, { "polygon" });
  auto broken = MakeGrid(3, 3);
  broken->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  this->Filter->SetInputData(broken);
  ExpectError(this->Filter, { "point 5", "not finite" });
  this->Filter->SetInputData(this->Prism);
  ExpectSuccess(this->Filter);
}

TEST_F(DGGLoopUpdates, IsTheSameForAnyThreads)
{
  auto make = [&] {
    vtkNew<vtkDGGLoop> filter;
    filter->SetInputData(this->Torus);
    filter->SetAccuracy(0.05);
    for (vtkIdType i = 0; i < 20; ++i)
    {
      filter->AddPointId(i * 19);
    }
    ExpectSuccess(filter);
    auto loops = GetLoops(filter);
    EXPECT_EQ(loops.size(), 20u);
    filter->SetPointIds({ 7 });
    filter->SetTapeWidth(0.5);
    ExpectSuccess(filter);
    const auto rims = GetRims(filter);
    EXPECT_GE(rims.size(), 2u);
    loops.insert(loops.end(), rims.begin(), rims.end());
    return loops;
  };
  const auto expected = make();
  ForEachThreading(
    [&](const std::string& threading) { EXPECT_TRUE(make() == expected) << threading; });
}

TEST_F(DGGLoopUpdates, ProgressAndAbort)
{
  this->Filter->SetInputData(this->Torus);
  for (vtkIdType i = 0; i < 40; ++i)
  {
    this->Filter->AddPointId(i * 10);
  }
  for (const int mode : { vtkDGGLoop::ThroughPoint, vtkDGGLoop::AroundHandles, vtkDGGLoop::Rope })
  {
    SCOPED_TRACE(mode);
    this->Filter->SetMode(mode);
    this->Filter->SetTapeWidth(mode == vtkDGGLoop::ThroughPoint ? 0.0 : 0.5);
    ExpectSuccess(this->Filter);
    const auto expected = GetLoops(this->Filter);
    ASSERT_FALSE(expected.empty());
    ProgressWatch watch(this->Filter);
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    watch.ExpectGrowth(3);
    for (const double stop : { 0.2, 0.7 })
    {
      watch.StopAt = stop;
      this->Filter->Modified();
      ExpectSuccess(this->Filter);
      ExpectEmptyOutput(this->Filter);
    }
    watch.StopAt = 2.0;
    ExpectSuccess(this->Filter);
    EXPECT_TRUE(GetLoops(this->Filter) == expected);
    this->Filter->RemoveAllObservers();
  }
}

/// Several ways around are tried, one after the other.
TEST_F(DGGLoopUpdates, OneLoopTellsItsProgress)
{
  this->Filter->SetInputData(this->Torus);
  this->Filter->SetPointIds({ 5 });
  ExpectSuccess(this->Filter); // the graph is there
  const auto expected = GetLoops(this->Filter);
  ProgressWatch watch(this->Filter);
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  ASSERT_GT(watch.Progress.size(), 6u);
  const double early = watch.Progress[4];
  EXPECT_LT(early, 0.9);
  watch.StopAt = early;
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  ExpectEmptyOutput(this->Filter);
  watch.StopAt = 2.0;
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetLoops(this->Filter), expected);
}

/// Leg by leg.
TEST_F(DGGLoopUpdates, ARopeTellsItsProgress)
{
  this->Filter->SetInputData(this->Torus);
  this->Filter->SetMode(vtkDGGLoop::Rope);
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < 20; ++i)
  {
    ids.push_back(i * 10);
  }
  this->Filter->SetPointIds(ids);
  ExpectSuccess(this->Filter); // the graph is there
  const auto expected = GetLoops(this->Filter);
  ASSERT_FALSE(expected.empty());
  ProgressWatch watch(this->Filter);
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  watch.ExpectGrowth();
  ASSERT_GT(watch.Progress.size(), ids.size());
  for (const std::size_t leg : { 5, 12 })
  {
    const double stop = watch.Progress[leg];
    EXPECT_LT(stop, 1.0);
    watch.StopAt = stop;
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    ExpectEmptyOutput(this->Filter);
    watch.StopAt = 2.0;
    ExpectSuccess(this->Filter);
    EXPECT_EQ(GetLoops(this->Filter), expected);
  }
}

TEST_F(DGGLoopUpdates, PrintSelf)
{
  this->Filter->SetPointIds({ 3 * Sides, 4 * Sides });
  ExpectSuccess(this->Filter);
  std::ostringstream os;
  this->Filter->Print(os);
  for (const char* text :
    { "Mode: ThroughPoint\n", "PointIds: 21 28\n", "Taut: Off\n", "TapeWidth: 0\n",
      "ProjectionTolerance: 0.01\n", "Accuracy: 0.02\n", "GraphAccuracy: 0.02\n" })
  {
    EXPECT_NE(os.str().find(text), std::string::npos) << text << " is missing in:\n" << os.str();
  }
}
