// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkDGGLoop: closed geodesics, ropes and tapes, their arrays, points without a loop, progress.
#include "GraphTestTools.h"
#include "LoopTestTools.h"

#include "vtkDGGLoop.h"

using namespace dggtest;

namespace
{
const double Pi = vtkMath::Pi();

/// A prism, a torus, and a filter that finds loops on the prism.
class DGGLoop : public ::testing::Test
{
protected:
  static constexpr int Sides = 7;
  static constexpr int Rows = 8;
  static constexpr int Nu = 30;
  static constexpr int Nv = 14;

  void SetUp() override
  {
    this->Filter->SetInputData(this->Prism);
    this->Filter->SetAccuracy(0.02);
  }

  vtkSmartPointer<vtkPolyData> Prism = MakePrism(Sides, Rows);
  vtkSmartPointer<vtkPolyData> Torus = MakeTorus(Nu, Nv);
  vtkNew<vtkDGGLoop> Filter;
};
}

TEST_F(DGGLoop, PointIds)
{
  this->Filter->SetMode(17);
  EXPECT_STREQ(this->Filter->GetModeAsString(), "Rope");
  EXPECT_EQ(this->Filter->GetTape(), this->Filter->GetOutput(1));
  this->Filter->AddPointId(3);
  const vtkMTimeType time = this->Filter->GetMTime();
  this->Filter->AddPointId(5);
  EXPECT_GT(this->Filter->GetMTime(), time);
  EXPECT_EQ(this->Filter->GetNumberOfPointIds(), 2);
  EXPECT_EQ(this->Filter->GetPointId(1), 5);
  EXPECT_EQ(this->Filter->GetPointId(2), -1);
  EXPECT_EQ(this->Filter->GetPointId(-1), -1);
  vtkNew<vtkIdList> list;
  list->InsertNextId(9);
  this->Filter->SetPointIds(list);
  EXPECT_EQ(this->Filter->GetNumberOfPointIds(), 1);
  EXPECT_EQ(this->Filter->GetPointId(0), 9);
  this->Filter->SetPointIds({ 1, 2, 3 });
  EXPECT_EQ(this->Filter->GetNumberOfPointIds(), 3);
  this->Filter->SetPointIds(nullptr);
  EXPECT_EQ(this->Filter->GetNumberOfPointIds(), 0);
  this->Filter->SetPointIds({ 1 });
  this->Filter->SetPointData(MakeSourcePoints({ { { 0, 0, 0 } } }));
  this->Filter->RemoveAllPointIds();
  EXPECT_EQ(this->Filter->GetNumberOfPointIds(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfInputConnections(1), 1);
  this->Filter->SetPointIds({ 1 });
  this->Filter->RemoveAllPoints();
  EXPECT_EQ(this->Filter->GetNumberOfPointIds(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfInputConnections(1), 0);
}

TEST_F(DGGLoop, AroundAPrism)
{
  // Points at vertices, on edges and inside faces.
  this->Filter->SetPointIds({ 4 * Sides + 3, 2 * Sides });
  double a[3];
  double b[3];
  this->Prism->GetPoint(3 * Sides + 1, a);
  this->Prism->GetPoint(3 * Sides + 2, b);
  const std::array<double, 3> onEdge{ { 0.7 * a[0] + 0.3 * b[0], 0.7 * a[1] + 0.3 * b[1], a[2] } };
  const std::array<double, 3> inFace{ { onEdge[0], onEdge[1], onEdge[2] + 0.1 } };
  this->Filter->SetPointData(MakeSourcePoints({ onEdge, inFace }));
  for (const bool taut : { false, true })
  {
    this->Filter->SetTaut(taut);
    ExpectSuccess(this->Filter);
    const auto loops = GetLoops(this->Filter);
    ASSERT_EQ(loops.size(), 4u);
    EXPECT_EQ(GetLoopStatus(this->Filter), (std::vector<int>{ 0, 0, 0, 0 }));
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      SCOPED_TRACE(i);
      EXPECT_EQ(loops[i].Loop, static_cast<vtkIdType>(i));
      EXPECT_NEAR(loops[i].Line.Length, Sides, 1e-10);
      EXPECT_NEAR(loops[i].Angle, Pi, 1e-6);
      EXPECT_EQ(loops[i].Kinked, 0);
      ExpectOnSurface(loops[i].Line, this->Prism);
    }
    if (!taut)
    {
      EXPECT_EQ(loops[0].Line.PointIds.front(), 4 * Sides + 3);
      EXPECT_EQ(loops[1].Line.PointIds.front(), 2 * Sides);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(loops[2].Line.Positions.front()[c], onEdge[c], 1e-9);
        EXPECT_NEAR(loops[3].Line.Positions.front()[c], inFace[c], 1e-9);
      }
    }
  }
}

TEST_F(DGGLoop, Handles)
{
  this->Filter->SetModeToAroundHandles();
  this->Filter->SetPointIds({ 100000 }); // ignored in this mode
  this->Filter->SetMemoryLimit(1);       // no graph is needed
  this->Filter->SetInputData(Beside(this->Torus, this->Prism, 5.0));
  this->Filter->SetTapeWidth(0.3);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), 0u);
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(), 0);
  const auto loops = GetLoops(this->Filter);
  ASSERT_EQ(loops.size(), 3u);
  const double lengths[] = { GetTubeLength(Nu, Nv), GetHoleLength(Nu), Sides };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(loops[i].Line.Length, lengths[i], 1e-9);
    EXPECT_EQ(loops[i].Loop, i);
    EXPECT_EQ(loops[i].Kinked, 0);
  }
  EXPECT_EQ(GetLoopStatus(this->Filter), (std::vector<int>{ 0, 0, 0 }));
  EXPECT_EQ(GetRims(this->Filter).size(), 6u);
}

TEST_F(DGGLoop, NoHandles)
{
  this->Filter->SetModeToAroundHandles();
  for (const auto& surface : { MakeCube(), MakeTerrain(6) })
  {
    this->Filter->SetInputData(surface);
    ExpectWarning(this->Filter, { "no handle", "contracted" });
    EXPECT_TRUE(GetLoops(this->Filter).empty());
    EXPECT_TRUE(GetRims(this->Filter).empty());
    EXPECT_TRUE(GetLoopStatus(this->Filter).empty());
  }
  // Three layers that share one edge.
  this->Filter->SetInputData(MakeSurface(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, -1, 0 } }, { { 0, 0, 1 } } },
    { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } }));
  Listener listener(this->Filter);
  this->Filter->Update();
  ASSERT_EQ(listener.Errors.size(), 1u);
  EXPECT_NE(listener.Errors[0].find("more than two triangles"), std::string::npos);
  ExpectEmptyOutput(this->Filter);
}

TEST_F(DGGLoop, Ropes)
{
  this->Filter->SetModeToRope();
  this->Filter->SetPointIds({ Sides, 5 * Sides + 2, 2 * Sides + 4 });
  ExpectSuccess(this->Filter);
  auto loops = GetLoops(this->Filter);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].Loop, 0);
  EXPECT_EQ(loops[0].Kinked, 1);
  // The sharpest kink is at the second point.
  EXPECT_NEAR(loops[0].Angle, std::atan2(2.0, 4.0) + std::atan2(2.0, 3.0), 1e-9);
  ExpectOnSurface(loops[0].Line, this->Prism);
  for (int i = 0; i < 3; ++i)
  {
    const std::vector<vtkIdType>& ids = loops[0].Line.PointIds;
    EXPECT_NE(std::find(ids.begin(), ids.end(), this->Filter->GetPointId(i)), ids.end());
  }
  // All points lie on one side, so that the taut rope contracts.
  this->Filter->TautOn();
  this->Filter->SetPointIds({ Sides, 5 * Sides + 1, 2 * Sides + 2 });
  ExpectWarning(this->Filter, { "rope contracts to a point", "LoopStatus is 1" });
  EXPECT_TRUE(GetLoops(this->Filter).empty());
  EXPECT_EQ(GetLoopStatus(this->Filter), std::vector<int>{ 1 });
}

TEST_F(DGGLoop, RopesThatDoNotHold)
{
  this->Filter->SetModeToRope();
  this->Filter->SetInputData(Beside(this->Torus, this->Prism, 5.0));
  this->Filter->SetPointIds({ 0, 7, Nu * Nv + 3 });
  ExpectWarning(this->Filter, { "not connected", "LoopStatus is 2" });
  EXPECT_TRUE(GetLoops(this->Filter).empty());
  EXPECT_EQ(GetLoopStatus(this->Filter), std::vector<int>{ 2 });
  const std::vector<vtkIdType> few[] = { { 5 }, { 4, 4, 4 }, { 4, 7 }, { 4, 4, 7, 4 } };
  for (const std::vector<vtkIdType>& ids : few)
  {
    this->Filter->SetPointIds(ids);
    ExpectError(this->Filter, { "rope through ", "three different points" });
  }
}

TEST_F(DGGLoop, PointsWithoutALoop)
{
  auto surface = Beside(this->Prism, MakeTerrain(8), 10.0);
  this->Filter->SetInputData(surface);
  const vtkIdType flat = this->Prism->GetNumberOfPoints();
  this->Filter->SetPointIds({ flat + 10, 2 * Sides, flat + 20 });
  this->Filter->SetTapeWidth(0.5);
  ExpectWarning(this->Filter,
    { "through 2 of 3 points", "the first is point 0", "contract to the point", "LoopStatus" });
  const auto loops = GetLoops(this->Filter);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].Loop, 1);
  EXPECT_EQ(GetLoopStatus(this->Filter), (std::vector<int>{ 1, 0, 1 }));
  const auto rims = GetRims(this->Filter);
  ASSERT_EQ(rims.size(), 2u);
  EXPECT_EQ(rims[0].Loop, 1);
  EXPECT_EQ(rims[1].Loop, 1);
}

TEST_F(DGGLoop, Tapes)
{
  this->Filter->SetPointIds({ 4 * Sides + 3, Sides });
  ExpectSuccess(this->Filter);
  EXPECT_TRUE(GetRims(this->Filter).empty());
  this->Filter->SetTapeWidth(1.4);
  ExpectSuccess(this->Filter);
  auto rims = GetRims(this->Filter);
  ASSERT_EQ(rims.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    SCOPED_TRACE(i);
    const double middle = i < 2 ? 4.0 : 1.0;
    EXPECT_EQ(rims[i].Loop, i < 2 ? 0 : 1);
    EXPECT_TRUE(rims[i].IsClosed);
    ExpectOnSurface(rims[i].Line, this->Prism);
    const double side = rims[i].Line.Positions[0][2] > middle ? 1.0 : -1.0;
    for (const auto& p : rims[i].Line.Positions)
    {
      EXPECT_NEAR(p[2], middle + side * 0.7, 1e-5);
    }
  }
  EXPECT_LT((rims[0].Line.Positions[0][2] - 4.0) * (rims[1].Line.Positions[0][2] - 4.0), 0.0);
}

TEST_F(DGGLoop, ProgressAndAbort)
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
    EXPECT_TRUE(mode != vtkDGGLoop::Rope || watch.Progress.size() > 40u); // reported per leg
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
