// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines that several processes trace together. Run under mpiexec; a single process is valid,
/// too.
#include "PieceGeometry.h"
#include "PieceGraphFixture.h"

#include "vtkApolloniusIsolines.h"
#include "vtkDGGDistance.h"

using namespace dggtest;

namespace
{
/// Returns the points of lines except the ends of open ones, each with its values in arrays.
std::set<Numbers> GetInnerPoints(vtkPolyData* output, const std::vector<const char*>& arrays)
{
  std::set<Numbers> inner;
  ForEachLine(output, [&](vtkIdType, vtkIdList* points) {
    const vtkIdType size = points->GetNumberOfIds();
    const bool isClosed = points->GetId(0) == points->GetId(size - 1);
    for (vtkIdType k = isClosed ? 0 : 1; k + 1 < size; ++k)
    {
      Numbers point = GetPoint(output, points->GetId(k));
      for (const char* name : arrays)
      {
        vtkDataArray* array = output->GetPointData()->GetArray(name);
        for (int i = 0; i < array->GetNumberOfComponents(); ++i)
        {
          point.push_back(array->GetComponent(points->GetId(k), i));
        }
      }
      inner.insert(point);
    }
  });
  return inner;
}

class IsolinesInPieces : public DividedSurface
{
protected:
  /// Expects that the lines of all processes are those of a single one, cut between pieces.
  template <typename Prepare>
  void ExpectLines(vtkPolyData* piece, vtkPolyData* surface, const Prepare& prepare)
  {
    const auto alone = Alone<vtkApolloniusIsolines>(surface, prepare);
    const auto together = this->Together<vtkApolloniusIsolines>(piece, prepare);
    this->ExpectLines(together->GetOutput(), alone->GetOutput(),
      { "vtkOriginalPointIds", "FaceId", "Barycentric" });
    // The cell of a point on an edge depends on the direction of a ridge.
    this->ExpectLines(together->GetRidges(), alone->GetRidges(), { "vtkOriginalPointIds" });
    this->ExpectAll(GetPolygons(together->GetBands()), GetPolygons(alone->GetBands()));
    EXPECT_EQ(together->GetUsedVirtualSources(), alone->GetUsedVirtualSources());
    EXPECT_EQ(this->Sum(together->GetNumberOfFallbacks()), alone->GetNumberOfFallbacks());
    const bool hasLines = together->GetOutput()->GetNumberOfLines() > 0;
    EXPECT_GT(this->Sum(hasLines ? 1 : 0), 1); // not gathered
  }

private:
  void ExpectLines(
    vtkPolyData* here, vtkPolyData* entire, const std::vector<const char*>& arrays) const
  {
    this->ExpectAll(GetSegments(here), GetSegments(entire));
    const auto all = GetInnerPoints(entire, arrays);
    const auto inner = GetInnerPoints(here, arrays);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), inner.begin(), inner.end()));
  }
};
}

//------------------------------------------------------------------------------
/// Segments are those of a single process, bit by bit.
TEST_P(IsolinesInPieces, AreTheSame)
{
  const auto surface = Beside(this->Surface, MakeTerrain(15), 2.0);
  const auto search = [&](auto* filter) {
    filter->SetAccuracy(0.1);
    filter->SetInputData(1, this->MakeSources());
    filter->SetSourceIds({ surface->GetNumberOfPoints() - 1 });
    filter->SetMaximumDistance(0.7);
    filter->GenerateVirtualSourceOn();
    filter->SetUnreachedValue(-1.0);
  };
  const auto alone = Alone<vtkDGGDistance>(surface, search);
  const auto distance = this->Together<vtkDGGDistance>(this->TakePiece(surface), search);
  const auto prepare = [](auto* filter) {
    filter->GenerateValues(7, 0.02, 0.65);
    filter->SetValue(7, 0.1);
    filter->GenerateBandsOn();
  };
  this->ExpectLines(distance->GetOutput(), alone->GetOutput(), [&](auto* filter) {
    prepare(filter);
    filter->GenerateRidgesOn();
  });
  this->ExpectLines(distance->GetOutput(), alone->GetOutput(), [&](auto* filter) {
    prepare(filter);
    filter->SetMethodToLinear();
  });
}

//------------------------------------------------------------------------------
/// Bands without a vertex, around a ridge between two sources, may be in two pieces.
TEST_P(IsolinesInPieces, AreTheSameWithoutVertices)
{
  const auto surface = MakeGrid(29, 12);
  const auto search = [](auto* filter) {
    filter->SetAccuracy(0.1);
    filter->SetSourceIds({ 180, 209 }); // (0, 6) and (29, 6)
    filter->GenerateVirtualSourceOn();
  };
  const auto alone = Alone<vtkDGGDistance>(surface, search);
  const auto distance = this->Together<vtkDGGDistance>(this->TakePiece(surface), search);
  this->ExpectLines(distance->GetOutput(), alone->GetOutput(), [](auto* filter) {
    filter->GenerateValues(4, 3.0, 12.0);
    filter->SetValue(4, 15.45);
    filter->GenerateRidgesOn();
    filter->GenerateBandsOn();
  });
}

//------------------------------------------------------------------------------
/// Windows are on the first process, even if its piece is empty.
TEST_P(IsolinesInPieces, AreTheSameWithWindows)
{
  const auto search = [](auto* filter) {
    filter->SetAccuracy(0.001);
    filter->SetSourceIds({ 5 });
    filter->GenerateVirtualSourceOn();
  };
  const auto prepare = [](auto* filter) { filter->GenerateValues(5, 0.1, 0.9); };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, search);
  const auto distance = this->Together<vtkDGGDistance>(this->TakePiece(this->Surface), search);
  const auto expected = Alone<vtkApolloniusIsolines>(alone->GetOutput(), prepare);
  ASSERT_TRUE(expected->GetUsedWindows());
  const auto gathered = this->Together<vtkApolloniusIsolines>(distance->GetOutput(), prepare);
  if (this->IsFirst())
  {
    EXPECT_EQ(GetSegments(gathered->GetOutput()), GetSegments(expected->GetOutput()));
  }
}

INSTANTIATE_TEST_SUITE_P(Divisions, IsolinesInPieces, testing::ValuesIn(divisions),
  [](const auto& tested) { return tested.param.Name; });

//------------------------------------------------------------------------------
/// One warning says that no process has a line. Distances without virtual sources are gathered.
TEST_F(PieceGraph, IsolinesThatAreMissingOrGathered)
{
  const auto search = [&](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetSourceIds({ 5 });
    filter->GenerateVirtualSourceOn();
  };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, search);
  const auto distance =
    this->Together<vtkDGGDistance>(this->TakeStrip(this->Surface, PartIds::Global), search);
  vtkNew<vtkApolloniusIsolines> isolines;
  isolines->SetInputData(distance->GetOutput());
  isolines->SetValue(0, 50.0);
  const Listener listener(isolines);
  this->Update(isolines);
  ASSERT_EQ(listener.Warnings.size(), this->IsFirst() ? 1u : 0u);
  if (this->IsFirst())
  {
    EXPECT_NE(listener.Warnings[0].find("There are no isolines"), std::string::npos);
  }
  const auto expectGathered = [&](const auto& prepare) {
    const auto expected = Alone<vtkApolloniusIsolines>(alone->GetOutput(), prepare);
    const auto gathered = this->Together<vtkApolloniusIsolines>(distance->GetOutput(), prepare);
    EXPECT_EQ(GetSegments(gathered->GetOutput()),
      this->IsFirst() ? GetSegments(expected->GetOutput()) : std::multiset<Numbers>());
  };
  expectGathered([](auto* filter) {
    filter->SetValue(0, 0.4);
    filter->SetMethodToApollonius();
  });
  expectGathered([](auto* filter) {
    filter->SetValue(0, 0.4);
    filter->SetVirtualSourceArrayName("None");
  });
}

//------------------------------------------------------------------------------
/// An abort or a failure of one process ends the update of all, and the next update gives the
/// outputs of a single process.
TEST_F(PieceGraph, IsolinesAfterFailures)
{
  const auto search = [](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetSourceIds({ 5 });
    filter->GenerateVirtualSourceOn();
  };
  const auto prepare = [](auto* filter) {
    filter->GenerateValues(4, 0.2, 0.8);
    filter->GenerateRidgesOn();
    filter->GenerateBandsOn();
  };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, search);
  const auto distance =
    this->Together<vtkDGGDistance>(this->TakeStrip(this->Surface, PartIds::Global), search);
  const auto expected = Alone<vtkApolloniusIsolines>(alone->GetOutput(), prepare);
  const auto isolines = this->Together<vtkApolloniusIsolines>(distance->GetOutput(), prepare);
  this->ExpectRecovery(isolines.Get(), { 0.5, 0.7, 0.9 }, [&] {
    EXPECT_EQ(this->Sum(isolines->GetBands()->GetNumberOfCells()),
      expected->GetBands()->GetNumberOfCells());
  });
}
