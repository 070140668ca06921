// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Updates of vtkDGGLoop: what is kept between them, wrong input, threads, progress.
#include "GraphTestTools.h"
#include "LoopFixture.h"

#include "vtkFieldData.h"

#include <gtest/gtest.h>

using namespace dggtest;

namespace
{
class DGGLoopUpdates : public LoopFixture
{
};
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
    EXPECT_TRUE(mode != vtkDGGLoop::Rope || watch.Progress.size() > 40u); // leg by leg
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
