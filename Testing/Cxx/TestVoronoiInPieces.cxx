// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi cells that several processes find together. Run under mpiexec; a single process is
/// valid, too.
#include "PieceGeometry.h"
#include "PieceGraphFixture.h"

#include "vtkGeodesicVoronoi.h"

#include "vtkIdTypeArray.h"

using namespace dggtest;

namespace
{
/// Expects equal points with equal arrays in the same order. Areas are sums over pieces, which may
/// be rounded differently.
void ExpectSamePoints(vtkPolyData* output, vtkPolyData* expected)
{
  ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  ASSERT_EQ(output->GetNumberOfVerts(), expected->GetNumberOfVerts());
  ASSERT_EQ(
    output->GetPointData()->GetNumberOfArrays(), expected->GetPointData()->GetNumberOfArrays());
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(output->GetPoint(i)[axis], expected->GetPoint(i)[axis]) << "point " << i;
    }
    for (int a = 0; a < expected->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* values = expected->GetPointData()->GetArray(a);
      vtkDataArray* array = output->GetPointData()->GetArray(a);
      ASSERT_STREQ(array->GetName(), values->GetName());
      for (int k = 0; k < values->GetNumberOfComponents(); ++k)
      {
        const double value = values->GetComponent(i, k);
        const bool isArea = std::string(values->GetName()) == "CellArea";
        EXPECT_NEAR(array->GetComponent(i, k), value, isArea ? 1e-12 * value : 0.0)
          << values->GetName() << " of point " << i;
      }
    }
  }
}

class VoronoiInPieces : public DividedSurface
{
protected:
  /// Expects the labels, cells and sites of a single process, and that the surface is not gathered.
  void ExpectSame(vtkGeodesicVoronoi* together, vtkGeodesicVoronoi* alone)
  {
    for (const char* name : { "GeodesicSource", "GeodesicDistance", "GeodesicDistance.Unreached" })
    {
      ExpectArray(together->GetOutput(), alone->GetOutput(), name, 0.0);
    }
    this->ExpectAll(GetSegments(together->GetBoundaries()), GetSegments(alone->GetBoundaries()));
    EXPECT_EQ(together->GetBoundaries()->GetPointData()->GetNumberOfArrays(),
      alone->GetGenerateCells() ? 1 : 0);
    this->ExpectAll(
      GetPolygons(together->GetCells(), "CellArea"), GetPolygons(alone->GetCells(), "CellArea"));
    const bool hasCells = together->GetCells()->GetNumberOfCells() > 0;
    EXPECT_EQ(this->Sum(hasCells ? 1 : 0) > 1, alone->GetGenerateCells()); // not gathered
    vtkDataArray* sites = together->GetCells()->GetCellData()->GetArray("SiteId");
    vtkDataArray* areas = together->GetCells()->GetCellData()->GetArray("CellArea");
    vtkDataArray* expected = alone->GetSites()->GetPointData()->GetArray("CellArea");
    for (vtkIdType i = 0; sites && i < sites->GetNumberOfTuples(); ++i)
    {
      const auto site = static_cast<vtkIdType>(sites->GetComponent(i, 0));
      if (site >= 0)
      {
        const double area = expected->GetComponent(site, 0);
        EXPECT_NEAR(areas->GetComponent(i, 0), area, 1e-12 * area);
      }
    }
    if (this->IsFirst())
    {
      ExpectSamePoints(together->GetSites(), alone->GetSites());
    }
    EXPECT_GT(this->Sum(this->IsFirst() ? 0 : together->GetNumberOfGraphEdges()), 0);
  }
};
}

//------------------------------------------------------------------------------
/// Labels, cells and sites are those of a single process, bit by bit. Sites are at a point of two
/// pieces, at the same position, and in cells. Points of one component are not reached. Links of
/// borders need more layers of cells than there are at first.
TEST_P(VoronoiInPieces, AreTheSame)
{
  const auto surface = Beside(this->Surface, MakeTerrain(12), 2.0);
  const Labels labels = this->GetParam().Label(surface, this->Count);
  const auto piece = TakePart(surface, labels, this->Here, PartIds::Global, this->Count % 2 == 0);
  const vtkIdType shared = FindSharedPoint(surface, labels);
  const auto points = MakePointsOfCells(this->Surface);
  for (const bool hasPoints : { false, true })
  {
    for (const int cells : { 0, 1, 2 })
    {
      const auto prepare = [&](auto* filter) {
        filter->SetAccuracy(0.03);
        filter->SetGenerateCells(cells > 0);
        filter->SetRefineBoundaries(cells > 1);
        filter->SetSiteIds({ 100, shared, 100 });
        filter->SetSiteData(hasPoints ? points.Get() : nullptr);
        filter->SetUnreachedValue(-1.0);
      };
      const auto alone = Alone<vtkGeodesicVoronoi>(surface, prepare);
      const auto together = this->Together<vtkGeodesicVoronoi>(piece, prepare);
      this->ExpectSame(together, alone);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Divisions, VoronoiInPieces, testing::ValuesIn(divisions),
  [](const auto& tested) { return tested.param.Name; });

//------------------------------------------------------------------------------
/// Sites on a surface of quads, one of them at a point without cells.
TEST_F(PieceGraph, ReportsSitesWithoutCells)
{
  const auto surface = MakeGrid(24, 10, GridCells::Quads);
  const auto piece = this->TakeStrip(surface, PartIds::Global);
  const vtkIdType isolated = surface->GetPoints()->InsertNextPoint(0.5, 0.5, 3.0);
  if (this->Here == this->Count - 1)
  {
    piece->GetPoints()->InsertNextPoint(surface->GetPoint(isolated));
    for (const char* name : { "Whole", "GlobalPointIds" })
    {
      vtkIdTypeArray::SafeDownCast(piece->GetPointData()->GetArray(name))
        ->InsertNextValue(isolated);
    }
  }
  const auto prepare = [&](auto* filter) {
    filter->SetAccuracy(0.1);
    filter->SetSiteIds({ isolated, 3 });
    filter->SetUnreachedValue(-1.0);
  };
  const auto alone = Alone<vtkGeodesicVoronoi>(surface, prepare);
  vtkNew<vtkGeodesicVoronoi> voronoi;
  voronoi->SetInputData(piece);
  prepare(voronoi.Get());
  const Listener listener(voronoi);
  this->Update(voronoi);
  EXPECT_TRUE(listener.Errors.empty());
  ASSERT_EQ(listener.Warnings.size(), this->IsFirst() ? 1u : 0u);
  ExpectArray(voronoi->GetOutput(), alone->GetOutput(), "GeodesicSource", 0.0);
  if (this->IsFirst())
  {
    EXPECT_NE(listener.Warnings[0].find("Site id"), std::string::npos) << listener.Warnings[0];
    ExpectSamePoints(voronoi->GetSites(), alone->GetSites());
  }
}

//------------------------------------------------------------------------------
/// On triangles that are coarse for the accuracy, exact cells are computed on the first process.
TEST_F(PieceGraph, GathersExactCells)
{
  const auto prepare = [](auto* filter) {
    filter->SetAccuracy(0.001);
    filter->SetSiteIds({ 5, 700, 1000 });
  };
  const auto alone = Alone<vtkGeodesicVoronoi>(this->Surface, prepare);
  const auto together =
    this->Together<vtkGeodesicVoronoi>(this->TakeStrip(this->Surface, PartIds::Global), prepare);
  EXPECT_EQ(GetPolygons(together->GetCells()),
    this->IsFirst() ? GetPolygons(alone->GetCells()) : std::multiset<Numbers>());
}

//------------------------------------------------------------------------------
/// An abort or a failure of one process ends the update of all, and the next update gives the
/// outputs of a single process.
TEST_F(PieceGraph, CellsAfterFailures)
{
  const auto prepare = [](auto* filter) {
    filter->SetAccuracy(0.05);
    filter->SetSiteIds({ 5, 700, 1000 });
  };
  const auto alone = Alone<vtkGeodesicVoronoi>(this->Surface, prepare);
  const auto together =
    this->Together<vtkGeodesicVoronoi>(this->TakeStrip(this->Surface, PartIds::Global), prepare);
  this->ExpectRecovery(together.Get(), { 0.3, 0.55, 0.7 }, [&] {
    this->ExpectAll(
      GetPolygons(together->GetCells(), "CellArea"), GetPolygons(alone->GetCells(), "CellArea"));
  });
}
