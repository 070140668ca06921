// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources that several processes compute together. Run under mpiexec; a single process is
/// valid, too.
#include "PieceGraphFixture.h"

#include "vtkDGGDistance.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkVirtualSourceGeodesicDistance.h"

using namespace dggtest;

namespace
{
/// A terrain with round holes. Shortest paths bend around the holes, so that relays are merged.
vtkSmartPointer<vtkPolyData> MakePerforatedTerrain()
{
  const auto terrain = MakeTerrain(41);
  Labels labels;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < terrain->GetNumberOfCells(); ++cell)
  {
    terrain->GetCellPoints(cell, corners);
    double p[3];
    terrain->GetPoint(corners->GetId(0), p);
    const double x = std::remainder(3.0 * p[0] - 0.5, 1.0);
    const double y = std::remainder(3.0 * p[1] - 0.5, 1.0);
    labels.push_back(std::hypot(x, y) < 0.3 ? 1 : 0);
  }
  const auto rest = TakePart(terrain, labels, 0);
  rest->GetPointData()->Initialize();
  rest->GetCellData()->Initialize();
  return rest;
}

using Search = std::function<void(vtkDGGDistance*)>;

class VirtualSourcesInPieces : public DividedSurface
{
protected:
  /// Expects that searches in a graph give the arrays of a single process, and that the pieces are
  /// gathered or not.
  void ExpectSources(
    vtkPolyData* surface, double accuracy, const std::vector<Search>& searches, bool areGathered)
  {
    const auto build = [&](auto* graph) { graph->SetAccuracy(accuracy); };
    const auto piece = TakePart(surface, this->GetParam().Label(surface, this->Count), this->Here,
      PartIds::Global, this->Count % 2 == 0);
    const auto graph = this->Together<vtkDiscreteGeodesicGraph>(piece, build);
    const auto alone = Alone<vtkDiscreteGeodesicGraph>(surface, build);
    for (const Search& search : searches)
    {
      const auto setUp = [&](vtkDGGDistance* filter) {
        filter->SetUnreachedValue(-1.0);
        filter->GenerateVirtualSourceOn();
        filter->GenerateNearestSourceOn();
        filter->GenerateUpperBoundOn();
        search(filter);
      };
      const auto expected = Alone<vtkDGGDistance>(alone->GetOutput(), setUp);
      const auto distance = this->Together<vtkDGGDistance>(graph->GetOutput(), setUp);
      for (const char* name :
        { "GeodesicDistance", "GeodesicSource", "GeodesicUpperBound", "GeodesicVirtualSource" })
      {
        ExpectArray(distance->GetOutput(), expected->GetOutput(), name, 0.0);
      }
      EXPECT_EQ(distance->GetUsedInputGraph(), !areGathered || this->IsFirst());
    }
  }
};
}

//------------------------------------------------------------------------------
/// Virtual sources are those of a single process, bit by bit.
TEST_P(VirtualSourcesInPieces, AreTheSame)
{
  const auto terrain = MakePerforatedTerrain();
  const auto surface = Beside(terrain, this->Surface, 2.0);
  const vtkIdType n = terrain->GetNumberOfPoints();
  const vtkIdType shared = FindSharedPoint(surface, this->GetParam().Label(surface, this->Count));
  const std::vector<Search> searches = { [](auto* filter) {
                                          filter->SetSourceIds({ 3 }); // reaches one component
                                        },
    [&](auto* filter) {
      filter->SetSourceIds({ shared, n - 5, n + 7 }, { 0.1, 0.0, 0.05 });
    },
    [&](auto* filter) { filter->SetInputData(1, MakePointsOfCells(surface)); },
    [&](auto* filter) {
      filter->SetSourceIds({ 3, n + 7 });
      filter->SetMaximumDistance(0.8);
    },
    [&](auto* filter) {
      filter->SetSourceIds({ 3, n + 7 });
      filter->CorrectionOff();
    } };
  this->ExpectSources(surface, 0.05, searches, false);
}

//------------------------------------------------------------------------------
/// Where triangles are large for the accuracy, pieces are gathered, and windows determine the
/// virtual sources.
TEST_P(VirtualSourcesInPieces, OfCoarseTriangles)
{
  const Search search = [](auto* filter) { filter->SetSourceIds({ 3 }); };
  this->ExpectSources(MakeTerrain(12), 0.02, { search }, true);
  this->ExpectSources(MakePlateWithHole(), 0.1, { search }, true);
}

//------------------------------------------------------------------------------
/// Propagation from triangle to triangle gives the distances of a single process, bit by bit.
/// Pieces are gathered for nearest sources.
TEST_P(VirtualSourcesInPieces, PropagateFromPieceToPiece)
{
  using Filter = vtkVirtualSourceGeodesicDistance;
  const auto terrain = MakePerforatedTerrain();
  const auto surface = Beside(terrain, this->Surface, 2.0);
  const vtkIdType n = terrain->GetNumberOfPoints();
  const vtkIdType shared = FindSharedPoint(surface, this->GetParam().Label(surface, this->Count));
  struct Case
  {
    std::function<void(Filter*)> SetUp;
    bool IsGathered;
  };
  const Case cases[] = {
    { [](Filter* filter) { filter->SetSourceIds({ 3 }); }, false },
    { [&](Filter* filter) {
       filter->SetSourceIds({ shared, n - 5, n + 7 }, { 0.1, 0.0, 0.05 });
     },
      false },
    { [&](Filter* filter) {
       filter->SetSourceIds({ 3, n + 7, shared });
       filter->SetMaximumDistance(0.6);
     },
      false },
    { [](Filter* filter) { filter->GenerateNearestSourceOn(); }, true },
    { [&](Filter* filter) { filter->SetInputData(1, MakePointsOfCells(surface)); }, false },
    { [&](Filter* filter) {
       filter->SetSourceIds({ shared }, { 0.2 });
       filter->SetInputData(1, MakeSources());
     },
      false },
  };
  for (const Case& tested : cases)
  {
    for (const int quality : { Filter::Fast, Filter::High })
    {
      const auto setUp = [&](Filter* filter) {
        filter->SetSourceIds({ 0 });
        tested.SetUp(filter);
        filter->SetQuality(quality);
        filter->SetUnreachedValue(-1.0);
      };
      const auto piece = TakePart(surface, this->GetParam().Label(surface, this->Count), this->Here,
        PartIds::Global, this->Count % 2 == 0);
      const auto expected = Alone<Filter>(surface, setUp);
      const auto found = this->Together<Filter>(piece, setUp);
      ExpectArray(found->GetOutput(), expected->GetOutput(), "GeodesicDistance", 0.0);
      const bool isWhole = tested.IsGathered && this->IsFirst();
      EXPECT_EQ(found->GetMeanAnisotropy() > 0.0, isWhole) << &tested - cases;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Divisions, VirtualSourcesInPieces, testing::ValuesIn(divisions),
  [](const auto& tested) { return tested.param.Name; });
