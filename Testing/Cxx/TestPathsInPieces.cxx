// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths that several processes find together. Run under mpiexec; a single process is valid, too.
#include "PieceGraphFixture.h"

#include "vtkDGGPath.h"

using namespace dggtest;

namespace
{
/// Returns the points, the point ids of lines, and the values of all arrays of an output.
std::vector<std::pair<std::string, std::vector<double>>> GetContents(vtkPolyData* output)
{
  std::vector<std::pair<std::string, std::vector<double>>> contents;
  const auto add = [&](vtkDataArray* array) {
    auto& [name, values] = contents.emplace_back();
    name = array->GetName() ? array->GetName() : "";
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      values.push_back(array->GetVariantValue(i).ToDouble());
    }
  };
  add(output->GetPoints()->GetData());
  add(output->GetLines()->GetOffsetsArray());
  add(output->GetLines()->GetConnectivityArray());
  for (vtkFieldData* data : { static_cast<vtkFieldData*>(output->GetPointData()),
         static_cast<vtkFieldData*>(output->GetCellData()), output->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      add(data->GetArray(i));
    }
  }
  return contents;
}

/// Expects equal contents, bit by bit.
void ExpectSameContents(vtkPolyData* output, vtkPolyData* expected)
{
  const auto contents = GetContents(output);
  const auto values = GetContents(expected);
  ASSERT_EQ(contents.size(), values.size());
  for (std::size_t i = 0; i < contents.size(); ++i)
  {
    EXPECT_EQ(contents[i].first, values[i].first);
    EXPECT_TRUE(contents[i].second == values[i].second) << contents[i].first;
  }
}

class PathsInPieces : public DividedSurface
{
protected:
  /// Expects that paths and warnings are those of a single process, bit by bit, and that the pieces
  /// are not gathered.
  template <typename Prepare>
  void ExpectPaths(vtkPolyData* piece, vtkPolyData* surface, const Prepare& prepare)
  {
    vtkNew<vtkDGGPath> together;
    together->SetInputData(piece);
    prepare(together.Get());
    const Listener listener(together);
    this->Update(together);
    EXPECT_TRUE(listener.Errors.empty()) << listener.Errors[0];
    const bool hasGraph = together->GetNumberOfGraphEdges() > 0;
    EXPECT_GT(this->Sum(hasGraph ? 1 : 0), 1);
    if (!this->IsFirst())
    {
      EXPECT_TRUE(listener.Warnings.empty());
      EXPECT_EQ(together->GetOutput()->GetNumberOfPoints(), 0);
      return;
    }
    vtkNew<vtkDGGPath> alone;
    alone->SetController(nullptr);
    alone->SetInputData(surface);
    prepare(alone.Get());
    const Listener expected(alone);
    alone->Update();
    EXPECT_EQ(StripAddresses(listener.Warnings), StripAddresses(expected.Warnings));
    ExpectSameContents(together->GetOutput(), alone->GetOutput());
    EXPECT_EQ(together->GetNumberOfFallbacks(), alone->GetNumberOfFallbacks());
  }
};
}

//------------------------------------------------------------------------------
/// Paths are those of a single process, bit by bit: over several pieces, along their borders,
/// between neighbors, with equal starts, from a point to itself and, with a warning, between
/// components. They are found in pieces also with wide corridors and on coarse graphs.
TEST_P(PathsInPieces, AreTheSame)
{
  const auto surface = Beside(this->Surface, MakeTerrain(15), 2.0);
  const vtkIdType last = surface->GetNumberOfPoints() - 1;
  const auto piece = this->TakePiece(surface);
  for (const bool straighten : { true, false })
  {
    for (const double detour : { 0.0, 1e-4, 0.05 })
    {
      this->ExpectPaths(piece, surface, [&](vtkDGGPath* filter) {
        filter->SetAccuracy(detour > 0.01 ? 0.2 : 0.02);
        filter->SetStraighten(straighten);
        filter->SetDetour(detour);
        for (const vtkIdType to :
          { vtkIdType(1088), vtkIdType(1), vtkIdType(500), last, vtkIdType(0) })
        {
          filter->AddPair(0, to);
        }
        filter->AddPair(500, 700);
        filter->AddPair(32, 1056);
        filter->AddPair(last, last - 200);
      });
    }
  }
}

//------------------------------------------------------------------------------
/// Of equally short paths, of which a plane has many, the same one is found.
TEST_P(PathsInPieces, AreTheSameOnPlanes)
{
  const auto plane = MakeGrid(30, 20, GridCells::Triangles);
  this->ExpectPaths(this->TakePiece(plane), plane, [&](vtkDGGPath* filter) {
    filter->SetAccuracy(0.3);
    filter->StraightenOff();
    for (vtkIdType i = 0; i < 40; ++i)
    {
      filter->AddPair(7 * i, plane->GetNumberOfPoints() - 1 - 5 * i);
    }
  });
}

//------------------------------------------------------------------------------
/// If no pair is connected, there are no paths, and the first process has the warning of a single
/// process.
TEST_P(PathsInPieces, AreTheSameBetweenComponents)
{
  const auto surface = Beside(this->Surface, MakeTerrain(15), 2.0);
  const vtkIdType last = surface->GetNumberOfPoints() - 1;
  this->ExpectPaths(this->TakePiece(surface), surface, [&](vtkDGGPath* filter) {
    filter->SetAccuracy(0.1);
    filter->AddPair(0, last);
    filter->AddPair(last - 7, 500);
  });
}

INSTANTIATE_TEST_SUITE_P(Divisions, PathsInPieces, testing::ValuesIn(divisions),
  [](const auto& tested) { return tested.param.Name; });

//------------------------------------------------------------------------------
/// An abort or a failure of one process ends the update of all, and the next update gives the paths
/// of a single process.
TEST_F(PieceGraph, PathsAfterFailures)
{
  const auto prepare = [](vtkDGGPath* filter) {
    filter->SetAccuracy(0.05);
    filter->AddPair(0, 1088);
    filter->AddPair(500, 700);
  };
  const auto alone = Alone<vtkDGGPath>(this->Surface, prepare);
  const auto together =
    this->Together<vtkDGGPath>(this->TakeStrip(this->Surface, PartIds::Global), prepare);
  EXPECT_EQ(this->Sum(together->GetNumberOfGraphEdges()), alone->GetNumberOfGraphEdges());
  this->ExpectRecovery(together.Get(), { 0.2, 0.5 }, [&] {
    if (this->IsFirst())
    {
      ExpectSameContents(together->GetOutput(), alone->GetOutput());
    }
  });
}
