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

class PathsInPieces : public DividedSurface
{
protected:
  /// Expects that the paths are those of a single process, bit by bit, and that the pieces are
  /// not gathered.
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
    const auto alone = Alone<vtkDGGPath>(surface, prepare);
    const auto expected = GetContents(alone->GetOutput());
    const auto contents = GetContents(together->GetOutput());
    ASSERT_EQ(contents.size(), expected.size());
    for (std::size_t i = 0; i < contents.size(); ++i)
    {
      EXPECT_EQ(contents[i].first, expected[i].first);
      EXPECT_TRUE(contents[i].second == expected[i].second) << contents[i].first;
    }
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

INSTANTIATE_TEST_SUITE_P(Divisions, PathsInPieces, testing::ValuesIn(divisions),
  [](const auto& tested) { return tested.param.Name; });
