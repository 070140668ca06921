// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sources, failures and inputs of distances that several processes compute together. Run under
/// mpiexec; a single process is valid, too.
#include "PieceGraphFixture.h"

#include "vtkDGGDistance.h"
#include "vtkVirtualSourceGeodesicDistance.h"
#include "vtkDiscreteGeodesicGraph.h"

#include "vtkIdTypeArray.h"

using namespace dggtest;

//------------------------------------------------------------------------------
/// Sources that are missing or far from the surface, and points without cells, are reported as by
/// one process.
TEST_F(PieceGraph, ReportsSources)
{
  const auto surface = MakeTerrain(12);
  const auto part = this->TakeStrip(surface, PartIds::Global);
  if (this->Here == this->Count - 1)
  {
    part->GetPoints()->InsertNextPoint(0.5, 0.5, 3.0);
    for (const char* name : { "Whole", "GlobalPointIds" })
    {
      vtkIdTypeArray::SafeDownCast(part->GetPointData()->GetArray(name))->InsertNextValue(144);
    }
  }
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(part);
  distance->SetAccuracy(0.1);
  const Listener listener(distance);
  const auto expectError = [&](const char* text) {
    this->Update(distance);
    ASSERT_FALSE(listener.Errors.empty());
    EXPECT_NE(listener.Errors.back().find(text), std::string::npos) << listener.Errors.back();
    ExpectEmptyOutput(distance);
  };
  expectError("There is no source");
  distance->SetSourceIds({ 3, 145 });
  expectError("Source id 145 is out of range: the input has 145 points");
  distance->RemoveAllSourceIds();
  const double* const p = surface->GetPoint(70);
  distance->SetSourceData(MakeSourcePoints({ { { p[0], p[1], p[2] } }, { { 0.5, 0.5, 9.0 } } }));
  expectError("Source 1, at (0.5, 0.5, 9), is ");
  distance->RemoveAllSources();
  distance->SetSourceIds({ 3, 144 });
  const std::size_t errors = listener.Errors.size();
  this->Update(distance);
  EXPECT_EQ(listener.Errors.size(), errors);
  ASSERT_EQ(listener.Warnings.size(), this->IsFirst() ? 1u : 0u);
  if (this->IsFirst())
  {
    EXPECT_NE(
      listener.Warnings[0].find("Source id 144 is a point that no polygon uses"), std::string::npos)
      << listener.Warnings[0];
  }
}

//------------------------------------------------------------------------------
/// An update after a failure or an abort gives the distances of one process, and getters describe
/// the last update.
TEST_F(PieceGraph, DistancesAfterFailures)
{
  const auto search = [](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetSourceData(MakeSources());
  };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, search);
  const auto distance =
    this->Together<vtkDGGDistance>(this->TakeStrip(this->Surface, PartIds::Global), search);
  this->ExpectRecovery(distance.Get(), { 0.3, 0.6, 0.75, 0.9 }, [&] {
    EXPECT_EQ(this->Sum(distance->GetNumberOfGraphEdges()), alone->GetNumberOfGraphEdges());
    ExpectArray(distance->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  });
  distance->PassSourceArraysOn(); // gathers
  this->Update(distance);
  EXPECT_EQ(
    distance->GetNumberOfGraphEdges(), this->IsFirst() ? alone->GetNumberOfGraphEdges() : 0);
}

//------------------------------------------------------------------------------
/// An id out of range is an error on all processes. After failures, propagation gives the distances
/// of a single process.
TEST_F(PieceGraph, PropagationAfterFailures)
{
  const auto search = [](auto* filter) { filter->SetSourceIds({ 5, 700 }); };
  const auto alone = Alone<vtkVirtualSourceGeodesicDistance>(this->Surface, search);
  const auto distance = this->Together<vtkVirtualSourceGeodesicDistance>(
    this->TakeStrip(this->Surface, PartIds::Global), search);
  {
    const Listener listener(distance);
    distance->SetSourceIds({ this->Surface->GetNumberOfPoints() });
    this->Update(distance);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find("out of range"), std::string::npos) << listener.Errors[0];
    search(distance.Get());
  }
  this->ExpectRecovery(distance.Get(), { 0.2, 0.9 },
    [&] { ExpectArray(distance->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0); });
}

//------------------------------------------------------------------------------
/// A propagation is prepared again if processes exchange their pieces, and gathered if a piece has
/// points that only cells of other processes use.
TEST_F(PieceGraph, PropagationInOtherPieces)
{
  const auto search = [](auto* filter) { filter->SetSourceIds({ 5, 700 }); };
  const auto alone = Alone<vtkVirtualSourceGeodesicDistance>(this->Surface, search);
  const auto take = [this](int index) {
    return TakePart(this->Surface, LabelStrips(this->Surface, this->Count), index, PartIds::Global);
  };
  auto piece = take(this->Here);
  const auto distance = this->Together<vtkVirtualSourceGeodesicDistance>(piece, search);
  const auto expectDistances = [&] {
    distance->SetInputData(piece);
    this->Update(distance);
    ExpectArray(distance->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  };
  piece = take((this->Here + 1) % this->Count);
  expectDistances();
  const auto other = take(this->Here);
  auto* ids = vtkIdTypeArray::SafeDownCast(piece->GetPointData()->GetArray("Whole"));
  for (vtkIdType i = 0; i < other->GetNumberOfPoints(); i += 30)
  {
    const auto id =
      static_cast<vtkIdType>(other->GetPointData()->GetArray("Whole")->GetComponent(i, 0));
    if (ids->LookupValue(id) < 0)
    {
      piece->GetPoints()->InsertNextPoint(other->GetPoint(i));
      for (const char* name : { "Whole", "GlobalPointIds" })
      {
        vtkIdTypeArray::SafeDownCast(piece->GetPointData()->GetArray(name))->InsertNextValue(id);
      }
      ids->ClearLookup();
    }
  }
  piece->Modified();
  expectDistances();
}

//------------------------------------------------------------------------------
/// Ids of sources are numbers of points, whatever global ids the points have. Offsets may be so
/// large that lengths are lost.
TEST_F(PieceGraph, IdsAndOffsetsOfSources)
{
  const auto search = [](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetSourceIds({ 0, 77 }, { 0.1, 0.0 });
  };
  const auto alone = Alone<vtkDGGDistance>(this->Surface, search);
  using Rule = vtkIdType (*)(vtkIdType);
  for (const Rule rule : { Rule([](vtkIdType id) { return id + 1; }),
         Rule([](vtkIdType id) { return 2 * id; }), Rule([](vtkIdType id) { return id - 5; }) })
  {
    const auto piece = this->TakeStrip(this->Surface, PartIds::Global);
    auto* ids = vtkIdTypeArray::SafeDownCast(piece->GetPointData()->GetGlobalIds());
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      ids->SetValue(i, rule(ids->GetValue(i)));
    }
    const auto distance = this->Together<vtkDGGDistance>(piece, search);
    ExpectArray(distance->GetOutput(), alone->GetOutput(), "GeodesicDistance", 0.0);
  }
  const auto far = [&](auto* filter) {
    search(filter);
    filter->SetSourceIds({ 0, 77 }, { 1e17, 1e17 });
  };
  ExpectArray(this->Together<vtkDGGDistance>(this->TakeStrip(this->Surface, PartIds::Global), far)
                ->GetOutput(),
    Alone<vtkDGGDistance>(this->Surface, far)->GetOutput(), "GeodesicDistance", 0.0);
}

//------------------------------------------------------------------------------
/// A graph belongs to its piece: pieces that have exchanged their graphs do not use them.
TEST_F(PieceGraph, BelongsToItsPiece)
{
  const auto surface = Beside(MakeTerrain(12), MakeTerrain(12), 3.0);
  MovePoints(surface, [](double* p) { p[2] *= p[0] > 2.0 ? 5.0 : 1.0; });
  const Labels labels = LabelStrips(surface, 2);
  const auto take = [&](int label) {
    return TakePart(surface, labels, label, PartIds::Global, false); // may be empty
  };
  const auto prepare = [](auto* graph) { graph->SetAccuracy(0.1); };
  const auto graph = this->Together<vtkDiscreteGeodesicGraph>(take(this->Here), prepare);
  vtkNew<vtkPolyData> moved;
  moved->ShallowCopy(take(this->Here < 2 ? 1 - this->Here : this->Here));
  moved->SetFieldData(graph->GetOutput()->GetFieldData());
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(moved);
  distance->SetSourceIds({ 0, 200 });
  const Listener listener(distance);
  this->Update(distance);
  this->Update(distance);
  EXPECT_EQ(listener.Warnings.size(), this->Here < 2 ? 1u : 0u);
  EXPECT_FALSE(distance->GetUsedInputGraph());
  ExpectArray(distance->GetOutput(),
    Alone<vtkDGGDistance>(surface,
      [](auto* filter) {
        filter->SetSourceIds({ 0, 200 });
      })
      ->GetOutput(),
    "GeodesicDistance", 0.0);
}

//------------------------------------------------------------------------------
/// One warning says that the graph on the input is coarser than requested.
TEST_F(PieceGraph, WarnsOnceAboutACoarserGraph)
{
  const auto graph =
    this->Together<vtkDiscreteGeodesicGraph>(this->TakeStrip(this->Surface, PartIds::Global),
      [](auto* filter) { filter->SetAccuracy(0.3); });
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(graph->GetOutputPort());
  distance->SetAccuracy(0.05);
  distance->SetSourceIds({ 0 });
  const Listener listener(distance);
  this->Update(distance);
  EXPECT_TRUE(distance->GetUsedInputGraph());
  EXPECT_EQ(listener.Warnings.size(), this->IsFirst() ? 1u : 0u);
}

//------------------------------------------------------------------------------
/// Global ids number the points, also if one process has all of them.
TEST_F(PieceGraph, IdsNumberThePointsOfOneProcess)
{
  const auto piece = TakePart(this->Surface, Labels(this->Surface->GetNumberOfCells(), 0),
    this->Here, PartIds::Global, false);
  if (this->IsFirst())
  {
    vtkNew<vtkPolyData> turned; // the points in reversed order
    const vtkIdType n = piece->GetNumberOfPoints();
    turned->DeepCopy(piece);
    for (vtkIdType i = 0; i < n; ++i)
    {
      turned->GetPoints()->SetPoint(i, piece->GetPoint(n - 1 - i));
      for (const char* name : { "Whole", "GlobalPointIds" })
      {
        turned->GetPointData()->GetArray(name)->SetTuple(
          i, n - 1 - i, piece->GetPointData()->GetArray(name));
      }
    }
    vtkDataArray* corners = turned->GetPolys()->GetConnectivityArray();
    for (vtkIdType k = 0; k < corners->GetNumberOfTuples(); ++k)
    {
      corners->SetTuple1(k, static_cast<double>(n - 1) - corners->GetTuple1(k));
    }
    piece->DeepCopy(turned);
  }
  const auto search = [](auto* filter) {
    filter->SetSourceIds({ 5, 77 });
    filter->PassSourceArraysOn(); // gathers
  };
  ExpectArray(this->Together<vtkDGGDistance>(piece, search)->GetOutput(),
    Alone<vtkDGGDistance>(this->Surface, search)->GetOutput(), "GeodesicDistance", 0.0);
}
