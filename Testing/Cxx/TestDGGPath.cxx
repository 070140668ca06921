// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths on surfaces: what they are.
#include "GraphTestTools.h"
#include "PathFixture.h"

#include "vtkGeodesicDistanceMatrix.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace dggtest;

namespace
{
/// Lengths in a graph, by the filter that tests of the graph look at.
double GetMatrixEntry(vtkPolyData* surface, double accuracy, vtkPolyData* ends, vtkIdType pair)
{
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  matrix->SetInputData(surface);
  matrix->SetAccuracy(accuracy);
  matrix->SetProjectionTolerance(1.0);
  Points from(1);
  Points to(1);
  ends->GetPoint(2 * pair, from[0].data());
  ends->GetPoint(2 * pair + 1, to[0].data());
  matrix->SetRowData(MakeSourcePoints(from));
  matrix->SetColumnData(MakeSourcePoints(to));
  matrix->Update();
  return matrix->GetMatrix()->GetNumberOfTuples() > 0 ? matrix->GetMatrix()->GetComponent(0, 0)
                                                      : -1.0;
}

/// A sheet bent around an axis, with `columns` flat strips of the given width that turn by the same
/// angle each; a point of it in terms of the flat sheet.
constexpr double StripAngle = 0.35;
std::array<double, 3> Bend(double x, double y)
{
  const double column = std::floor(x);
  std::array<double, 3> p{ { 0.0, y, 0.0 } };
  for (int i = 0; i <= static_cast<int>(column); ++i)
  {
    const double width = i < static_cast<int>(column) ? 1.0 : x - column;
    p[0] += width * std::cos(i * StripAngle);
    p[2] += width * std::sin(i * StripAngle);
  }
  return p;
}

vtkSmartPointer<vtkPolyData> MakeBentSheet(int columns, int rows)
{
  auto surface = MakeGrid(columns, rows);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, Bend(p[0], p[1]).data());
  }
  return surface;
}

class DGGPath : public PathFixture
{
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

TEST_F(DGGPath, KeepsItsPromise)
{
  const Points places = GetPlaces(this->Terrain);
  Points ends;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    ends.insert(ends.end(), { places[i], places[(5 * i + 3) % places.size()] });
  }
  auto pairs = MakePairs(ends);
  this->Filter->SetPairData(pairs);
  this->Filter->SetMethodToExact();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(), 0); // no graph has been built
  const auto shortest = GetPaths(this->Filter);
  ASSERT_EQ(shortest.size(), places.size());
  this->Filter->SetMethodToGraph();
  int bent = 0;
  for (const double accuracy : { 0.2, 0.02 })
  {
    this->Filter->SetAccuracy(accuracy);
    this->Filter->StraightenOff();
    ExpectSuccess(this->Filter);
    const auto rough = GetPaths(this->Filter);
    this->Filter->StraightenOn();
    ExpectSuccess(this->Filter);
    EXPECT_EQ(this->Filter->GetNumberOfFallbacks(), 0);
    const auto paths = GetPaths(this->Filter);
    ASSERT_EQ(paths.size(), places.size());
    ASSERT_EQ(rough.size(), places.size());
    for (std::size_t i = 0; i < paths.size(); ++i)
    {
      SCOPED_TRACE(i);
      const auto index = static_cast<vtkIdType>(i);
      const double d = shortest[i].Length;
      for (const PathLine* path : { &paths[i], &rough[i], &shortest[i] })
      {
        ExpectOnSurface(*path, this->Terrain);
        EXPECT_EQ(path->Pair, index);
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(path->Positions.front()[c], ends[2 * i][c], 1e-9);
          EXPECT_NEAR(path->Positions.back()[c], ends[2 * i + 1][c], 1e-9);
        }
        EXPECT_GE(path->Length, d * (1.0 - 1e-9));
      }
      const double inGraph = GetMatrixEntry(this->Terrain, accuracy, pairs, index);
      EXPECT_NEAR(paths[i].GraphLength, inGraph, 1e-9);
      EXPECT_EQ(rough[i].GraphLength, paths[i].GraphLength);
      EXPECT_TRUE(std::isnan(shortest[i].GraphLength));
      EXPECT_LE(inGraph, (1.0 + accuracy) * d * (1.0 + 1e-6));
      EXPECT_LE(rough[i].Length, inGraph * (1.0 + 1e-9));
      EXPECT_LE(paths[i].Length, rough[i].Length * (1.0 + 1e-9));
      EXPECT_EQ(paths[i].Straightened, 1);
      EXPECT_EQ(rough[i].Straightened, 0);
      EXPECT_EQ(shortest[i].Straightened, 1);
      bent += rough[i].Length > paths[i].Length * (1.0 + 1e-9) ? 1 : 0;
    }
  }
  EXPECT_GT(bent, 4);
}

TEST_F(DGGPath, DetourPays)
{
  this->Filter->SetInputData(MakeTerrain(50));
  // Ways on both sides of the bump.
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

TEST_F(DGGPath, ClosedForms)
{
  // A plane; a sheet bent around an axis, which is flat in itself; a cube.
  const double flat[][4] = { { 2.3, 1.1, 6.7, 5.2 }, { 0.0, 0.0, 7.0, 6.0 },
    { 0.4, 3.0, 6.6, 2.95 }, { 5.0, 0.25, 1.0, 4.75 }, { 2.31, 2.12, 2.32, 2.11 } };
  Points plane;
  Points bent;
  for (const auto& pair : flat)
  {
    plane.insert(plane.end(), { { { pair[0], pair[1], 0.0 } }, { { pair[2], pair[3], 0.0 } } });
    bent.insert(bent.end(), { Bend(pair[0], pair[1]), Bend(pair[2], pair[3]) });
  }
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    this->Filter->SetMethod(method);
    for (const bool isBent : { false, true })
    {
      this->Filter->SetInputData(isBent ? MakeBentSheet(8, 7) : MakeGrid(8, 7));
      this->Filter->SetPairData(MakePairs(isBent ? bent : plane));
      ExpectSuccess(this->Filter);
      const auto paths = GetPaths(this->Filter);
      ASSERT_EQ(paths.size(), std::size(flat));
      for (std::size_t i = 0; i < paths.size(); ++i)
      {
        const double length = std::hypot(flat[i][2] - flat[i][0], flat[i][3] - flat[i][1]);
        EXPECT_NEAR(paths[i].Length, length, 1e-9 * length) << i;
        ExpectOnSurface(paths[i], vtkPolyData::SafeDownCast(this->Filter->GetInput()));
      }
    }
    auto cube = MakeCube();
    this->Filter->SetInputData(cube);
    this->Filter->SetPairData(nullptr);
    this->Filter->RemoveAllPairs();
    AddPairs(this->Filter, { { 0, 7 }, { 0, 3 }, { 0, 1 }, { 6, 0 }, { 1, 6 } });
    const double expected[] = { std::sqrt(5.0), std::sqrt(2.0), 1.0, std::sqrt(2.0),
      std::sqrt(5.0) };
    ExpectSuccess(this->Filter);
    const auto paths = GetPaths(this->Filter);
    ASSERT_EQ(paths.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
    {
      EXPECT_NEAR(paths[i].Length, expected[i], 1e-9) << i;
      ExpectOnSurface(paths[i], cube);
    }
    this->Filter->RemoveAllPairs();
  }
}

TEST_F(DGGPath, FaceIdsAreCellsOfTheInput)
{
  // Verts and lines come before polygons, and strips after them. A walk along y = 0.25.
  const double y = 0.25;
  for (const GridCells kind : { GridCells::Triangles, GridCells::Quads, GridCells::Strips })
  {
    auto surface = MakeGrid(4, 2, kind);
    surface->SetVerts(MakeCells({ { 0 }, { 3 } }));
    surface->SetLines(MakeCells({ { 5, 2 } }));
    this->Filter->SetInputData(surface);
    this->Filter->SetPairData(MakePairs({ { { 0.1, y, 0.0 } }, { { 3.9, y, 0.0 } } }));
    ExpectSuccess(this->Filter);
    const auto paths = GetPaths(this->Filter);
    ASSERT_EQ(paths.size(), 1u);
    const PathLine& path = paths[0];
    EXPECT_NEAR(path.Length, 3.8, 1e-9);
    ExpectOnSurface(path, surface);
    for (std::size_t i = 0; i < path.Positions.size(); ++i)
    {
      const std::size_t piece = std::min(i, path.Positions.size() - 2);
      const double middle = 0.5 * (path.Positions[piece][0] + path.Positions[piece + 1][0]);
      const auto column = static_cast<vtkIdType>(middle);
      vtkIdType expected = 3; // the first strip
      if (kind == GridCells::Quads)
      {
        expected = 3 + column;
      }
      else if (kind == GridCells::Triangles)
      {
        expected = 3 + 2 * column + (middle - static_cast<double>(column) + y > 1.0 ? 1 : 0);
      }
      EXPECT_EQ(path.Faces[i], expected) << i;
      EXPECT_EQ(path.PointIds[i], -1) << i;
    }
    EXPECT_EQ(path.Positions.size(), 9u); // two ends, four diagonals, three sides
  }
}

TEST_F(DGGPath, VerticesByCoordinates)
{
  AddPairs(this->Filter, { { 21, 377 } });
  Points ends(2);
  this->Terrain->GetPoint(21, ends[0].data());
  this->Terrain->GetPoint(377, ends[1].data());
  this->Filter->SetPairData(MakePairs(ends));
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    this->Filter->SetMethod(method);
    ExpectSuccess(this->Filter);
    auto paths = GetPaths(this->Filter);
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_EQ(paths[1].PointIds.front(), 21);
    EXPECT_EQ(paths[1].PointIds.back(), 377);
    paths[1].Pair = 0;
    EXPECT_TRUE(paths[0] == paths[1]);
  }
}

TEST_F(DGGPath, IdsComeBeforeLinesAndCellDataIsPassed)
{
  this->Filter->SetInputData(MakeGrid(8, 8));
  AddPairs(this->Filter, { { 0, 80 }, { 8, 8 } });
  // Lines of several points, of which only the ends count; verts, whose cells come first.
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
  vtkNew<vtkDoubleArray> lengths; // of the user; ours takes its place
  lengths->SetName("Length");
  for (int i = 0; i < 4; ++i)
  {
    names->InsertNextValue("line " + std::to_string(i));
    weights->InsertNextTuple2(10 * i, 10 * i + 1);
    lengths->InsertNextValue(-5.0);
  }
  lines->GetCellData()->AddArray(names);
  lines->GetCellData()->AddArray(weights);
  lines->GetCellData()->AddArray(lengths);
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
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  numbers->InsertNextValue(100);
  numbers->InsertNextValue(200);
  lines->GetCellData()->AddArray(numbers);
  this->Filter->SetPairData(lines);
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    this->Filter->SetMethod(method);
    ExpectWarning(
      this->Filter, { "3 of 7 pairs", "first of them pair 1", "not connected", "PathStatus" });
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
    EXPECT_EQ(paths[1].Faces, (std::vector<vtkIdType>{ -1, -1 })); // no cell has this point
    EXPECT_EQ(paths[1].PointIds, (std::vector<vtkIdType>{ 6, 6 }));
  }
  // None at all.
  this->Filter->SetPairData(nullptr);
  this->Filter->RemoveAllPairs();
  this->Filter->AddPair(0, 3);
  ExpectWarning(
    this->Filter, { "1 of 1 pair of points, pair 0, is not connected", "it has no polyline" });
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(GetPathStatus(this->Filter), std::vector<int>{ 1 });
  EXPECT_TRUE(GetPaths(this->Filter).empty());
}

TEST_F(DGGPath, CoincidentEnds)
{
  this->Filter->SetInputData(MakeGrid(4, 4));
  AddPairs(this->Filter, { { 7, 7 } });
  // At a vertex; on an edge; in a face; a line of one point.
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
      // All of them are cells that VTK can work with, of one point each.
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

TEST_F(DGGPath, CoincidentPointsOfTheSurface)
{
  // Two squares along a common side whose points exist twice.
  auto surface = MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } },
                               { { 1, 0, 0 } }, { { 2, 0, 0 } }, { { 1, 1, 0 } }, { { 2, 1, 0 } } },
    { { 0, 1, 3, 2 }, { 4, 5, 7, 6 } });
  this->Filter->SetInputData(surface);
  AddPairs(this->Filter, { { 0, 7 }, { 4, 2 }, { 4, 1 } });
  Listener listener(this->Filter);
  this->Filter->Update();
  ASSERT_EQ(listener.Warnings.size(), 2u); // of the seam, and of the pairs
  EXPECT_EQ(GetPathStatus(this->Filter), (std::vector<int>{ 1, 1, 1 }));
  this->Filter->MergeCoincidentPointsOn();
  for (const int method : { vtkDGGPath::Graph, vtkDGGPath::Exact })
  {
    this->Filter->SetMethod(method);
    ExpectSuccess(this->Filter);
    const auto paths = GetPaths(this->Filter);
    ASSERT_EQ(paths.size(), 3u);
    EXPECT_NEAR(paths[0].Length, std::sqrt(5.0), 1e-9);
    EXPECT_NEAR(paths[1].Length, std::sqrt(2.0), 1e-9);
    EXPECT_EQ(paths[1].PointIds.front(), 1); // the first one of those that are merged
    EXPECT_EQ(paths[2].Length, 0.0);
    EXPECT_EQ(paths[2].PointIds, (std::vector<vtkIdType>{ 1, 1 }));
    for (const PathLine& path : paths)
    {
      ExpectOnSurface(path, surface);
    }
  }
}
