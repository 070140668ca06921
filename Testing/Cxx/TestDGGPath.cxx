// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkDGGPath: paths by both methods, arrays, pairs that are not connected, reuse between updates.
#include "GraphTestTools.h"
#include "PathTestTools.h"
#include "SpectralTestTools.h"

#include "vtkDGGPath.h"

#include "vtkCellType.h"

using namespace dggtest;

namespace
{
/// A terrain, and a filter that finds paths on it.
class DGGPath : public ::testing::Test
{
protected:
  using Pairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

  void SetUp() override
  {
    this->Filter->SetInputData(this->Terrain);
    this->Filter->SetAccuracy(0.05);
  }

  static void AddPairs(vtkDGGPath* filter, const Pairs& pairs)
  {
    for (const auto& pair : pairs)
    {
      filter->AddPair(pair.first, pair.second);
    }
  }

  /// Returns positions on the surface: in faces, on edges, at vertices.
  static Points GetPlaces(vtkPolyData* surface)
  {
    const std::array<double, 3> weights[] = { { 0.2, 0.3, 0.5 }, { 0.6, 0.4, 0.0 },
      { 1.0, 0.0, 0.0 }, { 0.98, 0.01, 0.01 } };
    Points places;
    for (int i = 0; i < 16; ++i)
    {
      const vtkIdType cell = (i * 7919 + 31) % surface->GetNumberOfCells();
      places.push_back(PointInCell(surface, cell, weights[i % 4]));
    }
    return places;
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(20);
  vtkNew<vtkDGGPath> Filter;
};
}

TEST_F(DGGPath, PairsOfIds)
{
  this->Filter->SetDetour(7.0);
  EXPECT_EQ(this->Filter->GetDetour(), 0.1);
  this->Filter->SetDetour(-1.0);
  EXPECT_EQ(this->Filter->GetDetour(), 0.0);
  this->Filter->AddPair(3, 5);
  const vtkMTimeType time = this->Filter->GetMTime();
  this->Filter->AddPair(7, 9);
  EXPECT_GT(this->Filter->GetMTime(), time);
  EXPECT_EQ(this->Filter->GetNumberOfPairs(), 2);
  EXPECT_EQ(this->Filter->GetPairStart(1), 7);
  EXPECT_EQ(this->Filter->GetPairEnd(1), 9);
  EXPECT_EQ(this->Filter->GetPairStart(2), -1);
  EXPECT_EQ(this->Filter->GetPairEnd(-1), -1);
  this->Filter->RemoveAllPairs();
  EXPECT_EQ(this->Filter->GetNumberOfPairs(), 0);
}

TEST_F(DGGPath, GraphAndExactPaths)
{
  const Points places = GetPlaces(this->Terrain);
  Points ends;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    ends.insert(ends.end(), { places[i], places[(5 * i + 3) % places.size()] });
  }
  this->Filter->SetPairData(MakePairs(ends));
  this->Filter->SetMethodToExact();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(), 0); // no graph has been built
  const auto shortest = GetPaths(this->Filter);
  this->Filter->SetMethodToGraph();
  this->Filter->StraightenOff();
  ExpectSuccess(this->Filter);
  const auto rough = GetPaths(this->Filter);
  this->Filter->StraightenOn();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfFallbacks(), 0);
  const auto paths = GetPaths(this->Filter);
  ASSERT_EQ(shortest.size(), places.size());
  ASSERT_EQ(rough.size(), places.size());
  ASSERT_EQ(paths.size(), places.size());
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    SCOPED_TRACE(i);
    const double d = shortest[i].Length;
    for (const PathLine* path : { &paths[i], &rough[i], &shortest[i] })
    {
      ExpectOnSurface(*path, this->Terrain);
      EXPECT_EQ(path->Pair, static_cast<vtkIdType>(i));
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(path->Positions.front()[c], ends[2 * i][c], 1e-9);
        EXPECT_NEAR(path->Positions.back()[c], ends[2 * i + 1][c], 1e-9);
      }
      EXPECT_GE(path->Length, d * (1.0 - 1e-9));
    }
    EXPECT_LE(paths[i].GraphLength, 1.05 * d * (1.0 + 1e-6));
    EXPECT_EQ(rough[i].GraphLength, paths[i].GraphLength);
    EXPECT_TRUE(std::isnan(shortest[i].GraphLength));
    EXPECT_LE(rough[i].Length, paths[i].GraphLength * (1.0 + 1e-9));
    EXPECT_LE(paths[i].Length, rough[i].Length * (1.0 + 1e-9));
    EXPECT_EQ(paths[i].Straightened, 1);
    EXPECT_EQ(rough[i].Straightened, 0);
    EXPECT_EQ(shortest[i].Straightened, 1);
  }
}

TEST_F(DGGPath, DetourPays)
{
  this->Filter->SetInputData(MakeTerrain(50));
  // Paths on both sides of the bump.
  AddPairs(this->Filter, { { 835, 1015 }, { 885, 965 }, { 1035, 815 }, { 935, 915 }, { 0, 2499 } });
  this->Filter->SetAccuracy(0.2);
  this->Filter->SetMethodToExact();
  ExpectSuccess(this->Filter);
  const auto exact = GetPaths(this->Filter);
  this->Filter->SetMethodToGraph();
  this->Filter->SetDetour(0.0);
  ExpectSuccess(this->Filter);
  const auto first = GetPaths(this->Filter);
  this->Filter->SetDetour(0.01);
  ExpectSuccess(this->Filter);
  const auto paths = GetPaths(this->Filter);
  ASSERT_EQ(paths.size(), exact.size());
  ASSERT_EQ(first.size(), exact.size());
  int shortened = 0;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    EXPECT_NEAR(paths[i].Length, exact[i].Length, 1e-9) << i;
    EXPECT_GE(first[i].Length, exact[i].Length * (1.0 - 1e-9)) << i;
    shortened += first[i].Length > exact[i].Length * (1.0 + 1e-6) ? 1 : 0;
  }
  EXPECT_GT(shortened, 0);
}

TEST_F(DGGPath, IdsComeBeforeLinesAndCellDataIsPassed)
{
  this->Filter->SetInputData(MakeGrid(8, 8));
  AddPairs(this->Filter, { { 0, 80 }, { 8, 8 } });
  // Lines of several points, of which only the ends are used; verts, whose cells come first.
  const double none = std::nan("");
  auto lines = MakeSourcePoints(
    { { { 1, 1, 0 } }, { { none, 9, 9 } }, { { 4, 5, 0 } }, { { 50, 50, 50 } }, { { 7, 1, 0 } } });
  lines->SetVerts(MakeCells({ { 3 } }));
  lines->SetLines(MakeCells({ { 0, 1, 2 }, { 4, 3, 1, 0 }, { 2 } }));
  vtkNew<vtkStringArray> names;
  names->SetName("name");
  vtkNew<vtkIntArray> weights;
  weights->SetName("weight");
  weights->SetNumberOfComponents(2);
  weights->SetComponentName(1, "second");
  for (int i = 0; i < 4; ++i)
  {
    names->InsertNextValue("line " + std::to_string(i));
    weights->InsertNextTuple2(10 * i, 10 * i + 1);
  }
  lines->GetCellData()->AddArray(names);
  lines->GetCellData()->AddArray(weights);
  AddArray(lines->GetCellData(), "Length", { -5, -5, -5, -5 }); // replaced by the filter
  this->Filter->SetPairData(lines);
  ExpectSuccess(this->Filter);
  const auto paths = GetPaths(this->Filter);
  ASSERT_EQ(paths.size(), 5u);
  const double expected[] = { 8.0 * std::sqrt(2.0), 0.0, 5.0, 6.0, 0.0 };
  const char* expectedNames[] = { "", "", "line 1", "line 2", "line 3" };
  const double expectedWeights[] = { 0, 0, 11, 21, 31 };
  vtkCellData* data = this->Filter->GetOutput()->GetCellData();
  auto* passed = vtkStringArray::SafeDownCast(data->GetAbstractArray("name"));
  ASSERT_NE(passed, nullptr);
  vtkDataArray* numbers = data->GetArray("weight");
  ASSERT_TRUE(numbers && numbers->IsA("vtkIntArray") && numbers->GetNumberOfComponents() == 2);
  EXPECT_STREQ(numbers->GetComponentName(1), "second");
  EXPECT_EQ(data->GetNumberOfArrays(), 6);
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(i);
    EXPECT_NEAR(paths[i].Length, expected[i], 1e-9) << i;
    EXPECT_EQ(paths[i].Pair, cell);
    EXPECT_EQ(passed->GetValue(cell), expectedNames[i]);
    EXPECT_EQ(numbers->GetComponent(cell, 1), expectedWeights[i]);
  }
}

TEST_F(DGGPath, PointsThatAreNotConnected)
{
  auto surface = MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 5, 0, 0 } },
                               { { 6, 0, 0 } }, { { 5, 1, 0 } }, { { 7, 7, 7 } } },
    { { 0, 1, 2 }, { 3, 4, 5 } });
  this->Filter->SetInputData(surface);
  AddPairs(this->Filter, { { 0, 1 }, { 1, 3 }, { 6, 0 }, { 6, 6 }, { 4, 5 } });
  auto lines = MakePairs(
    { { { 0.2, 0.2, 0.0 } }, { { 5.2, 0.2, 0.0 } }, { { 5.2, 0.2, 0.0 } }, { { 5.2, 0.5, 0.0 } } });
  AddArray(lines->GetCellData(), "number", { 100, 200 });
  this->Filter->SetPairData(lines);
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    this->Filter->SetMethod(method);
    ExpectWarning(this->Filter, { "3 of 7 pairs", "the first is pair 1", "PathStatus" });
    EXPECT_EQ(GetPathStatus(this->Filter), (std::vector<int>{ 0, 1, 1, 0, 0, 1, 0 }));
    const auto paths = GetPaths(this->Filter);
    ASSERT_EQ(paths.size(), 4u);
    const vtkIdType pairs[] = { 0, 3, 4, 6 };
    const double expected[] = { 1.0, 0.0, std::sqrt(2.0), 0.3 };
    const double passed[] = { 0, 0, 0, 200 };
    for (std::size_t i = 0; i < 4; ++i)
    {
      EXPECT_EQ(paths[i].Pair, pairs[i]);
      EXPECT_NEAR(paths[i].Length, expected[i], 1e-9);
      ExpectOnSurface(paths[i], surface);
      EXPECT_EQ(this->Filter->GetOutput()->GetCellData()->GetArray("number")->GetComponent(
                  static_cast<vtkIdType>(i), 0),
        passed[i]);
    }
    EXPECT_EQ(paths[1].Faces, (std::vector<vtkIdType>{ -1, -1 })); // no cell uses this point
    EXPECT_EQ(paths[1].PointIds, (std::vector<vtkIdType>{ 6, 6 }));
  }
  // Output without any polyline.
  this->Filter->SetPairData(nullptr);
  this->Filter->RemoveAllPairs();
  this->Filter->AddPair(0, 3);
  ExpectWarning(this->Filter, { "1 of 1 pairs", "the first is pair 0", "no polyline" });
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(GetPathStatus(this->Filter), std::vector<int>{ 1 });
  EXPECT_TRUE(GetPaths(this->Filter).empty());
}

TEST_F(DGGPath, CoincidentEnds)
{
  this->Filter->SetInputData(MakeGrid(4, 4));
  AddPairs(this->Filter, { { 7, 7 } });
  // Pairs at a vertex, on an edge and in a face, and a line of one point.
  auto lines = MakePairs({ { { 2, 1, 0 } }, { { 2, 1, 0 } }, { { 2.5, 1, 0 } }, { { 2.5, 1, 0 } },
    { { 2.2, 1.3, 0 } }, { { 2.2, 1.3, 0 } } });
  lines->GetLines()->InsertNextCell({ 4 });
  this->Filter->SetPairData(lines);
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    this->Filter->SetMethod(method);
    for (const bool straighten : { true, false })
    {
      this->Filter->SetStraighten(straighten);
      ExpectSuccess(this->Filter);
      const auto paths = GetPaths(this->Filter);
      ASSERT_EQ(paths.size(), 5u);
      for (const PathLine& path : paths)
      {
        ASSERT_EQ(path.Positions.size(), 2u);
        EXPECT_EQ(path.Positions[0], path.Positions[1]);
        EXPECT_EQ(path.Length, 0.0);
        EXPECT_EQ(path.GraphLength == 0.0, method == vtkDGGPath::Graph);
        EXPECT_EQ(path.Straightened, straighten || method == vtkDGGPath::Exact ? 1 : 0);
        EXPECT_GE(path.Faces[0], 0);
        ExpectOnSurface(path, MakeGrid(4, 4));
      }
      EXPECT_EQ(paths[1].PointIds[0], 7);
      EXPECT_EQ(paths[2].PointIds[0], -1);
      // All of them are valid VTK cells of one point each.
      vtkPolyData* output = this->Filter->GetOutput();
      EXPECT_EQ(output->GetNumberOfPoints(), 5);
      output->BuildCells();
      for (vtkIdType i = 0; i < 5; ++i)
      {
        vtkCell* cell = output->GetCell(i);
        EXPECT_EQ(cell->GetCellType(), VTK_LINE);
        ASSERT_EQ(cell->GetNumberOfPoints(), 2);
        EXPECT_EQ(cell->GetPointId(0), i);
        EXPECT_EQ(cell->GetPointId(1), i);
      }
    }
  }
}

TEST_F(DGGPath, WhatIsKeptBetweenUpdatesFollowsEveryChange)
{
  // After each change, the output equals the output of a new filter.
  const auto expectTheSameAsNew = [&](const char* what) {
    SCOPED_TRACE(what);
    ExpectSuccess(this->Filter);
    vtkNew<vtkDGGPath> fresh;
    fresh->SetInputData(this->Filter->GetInput());
    fresh->SetAccuracy(this->Filter->GetAccuracy());
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
}

/// Progress is also reported if the waiting thread has no propagation of its own.
TEST_F(DGGPath, PropagationsReportTheirProgressInAllThreads)
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
    watch.StopAt = 0.101; // the search starts at 0.1
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    ExpectEmptyOutput(this->Filter);
    EXPECT_LT(watch.Progress.back(), 0.9);
    this->Filter->RemoveAllObservers();
  });
}
