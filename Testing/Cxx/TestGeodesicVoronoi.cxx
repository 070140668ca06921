// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi diagrams by the filter.
#include "GraphTestTools.h"

#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include "vtkPolygon.h"
#include "vtkTriangleFilter.h"

using namespace dggtest;

namespace
{
std::vector<double> ToVector(vtkDataArray* array, int component = 0)
{
  std::vector<double> values;
  EXPECT_NE(array, nullptr);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, component));
  }
  return values;
}

std::vector<double> GetSiteOfPoints(vtkGeodesicVoronoi* filter)
{
  return ToVector(filter->GetOutput()->GetPointData()->GetArray("GeodesicSource"));
}

double AreaOf(vtkPolyData* surface, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  double normal[3];
  return vtkPolygon::ComputeArea(
    surface->GetPoints(), ids->GetNumberOfIds(), ids->GetPointer(0), normal);
}

double AreaOf(vtkPolyData* surface)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    sum += AreaOf(surface, i);
  }
  return sum;
}

class GeodesicVoronoi : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Terrain);
    this->Filter->SetAccuracy(0.05);
    this->Filter->SetSiteIds({ 21, 130, 250, 377 });
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(20);
  vtkNew<vtkGeodesicVoronoi> Filter;
};
}

/// Without cells, the labels come from a single search, or from virtual sources without a graph.
TEST_F(GeodesicVoronoi, LabelsAlone)
{
  ExpectSuccess(this->Filter);
  const std::vector<double> sites = GetSiteOfPoints(this->Filter);
  const std::vector<double> distances =
    ToVector(this->Filter->GetOutput()->GetPointData()->GetArray("GeodesicDistance"));
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  this->Filter->GenerateCellsOff();
  for (const bool isPreview : { false, true })
  {
    this->Filter->SetPreview(isPreview);
    this->Filter->SetAccuracy(isPreview ? 0.0123 : 0.05);
    ExpectSuccess(this->Filter);
    EXPECT_EQ(this->Filter->GetGraphBuildTime(), built); // no other graph has been built
    for (const int port : { 1, 2 })
    {
      EXPECT_EQ(this->Filter->GetOutput(port)->GetNumberOfPoints(), 0);
      EXPECT_EQ(this->Filter->GetOutput(port)->GetNumberOfCells(), 0);
    }
    EXPECT_EQ(this->Filter->GetOutput(3)->GetNumberOfPoints(), 4);
    EXPECT_FALSE(this->Filter->GetOutput(3)->GetPointData()->HasArray("CellArea"));
    const std::vector<double> labels = GetSiteOfPoints(this->Filter);
    const std::vector<double> estimates =
      ToVector(this->Filter->GetOutput()->GetPointData()->GetArray("GeodesicDistance"));
    ASSERT_EQ(labels.size(), sites.size());
    int same = 0;
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      EXPECT_NEAR(estimates[i], distances[i], 0.1 * distances[i]);
      same += labels[i] == sites[i] ? 1 : 0;
    }
    EXPECT_GT(same, 390); // of 400; ties within the accuracy may be resolved either way
  }
  this->Filter->SetInputData(MakePlateWithHole());
  this->Filter->SetSiteIds({ 0, 4 });
  ExpectWarning(this->Filter, { "long triangles", "Turn off Preview" });
  this->Filter->CentroidalOn();
  ExpectError(this->Filter, { "Preview", "Centroidal" });
}

TEST_F(GeodesicVoronoi, CellsCoverTheSurface)
{
  ExpectSuccess(this->Filter);
  vtkPolyData* cells = this->Filter->GetCells();
  const double area = AreaOf(this->Terrain);
  EXPECT_NEAR(AreaOf(cells), area, 1e-9 * area);
  const std::vector<double> sites = ToVector(cells->GetCellData()->GetArray("SiteId"));
  const std::vector<double> areas = ToVector(cells->GetCellData()->GetArray("CellArea"));
  const std::vector<double> faces = ToVector(cells->GetCellData()->GetArray("FaceId"));
  std::map<double, double> sums;
  std::map<double, double> reported;
  std::map<vtkIdType, double> ofFace;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    sums[sites[i]] += AreaOf(cells, i);
    ofFace[static_cast<vtkIdType>(faces[i])] += AreaOf(cells, i);
    reported[sites[i]] = areas[i];
  }
  ASSERT_EQ(sums.size(), 4u);
  for (const auto& sum : sums)
  {
    EXPECT_NEAR(reported[sum.first], sum.second, 1e-9 * area);
    const auto site = static_cast<vtkIdType>(sum.first);
    EXPECT_EQ(this->Filter->GetSites()->GetPointData()->GetArray("CellArea")->GetComponent(site, 0),
      reported[sum.first]);
  }
  for (vtkIdType f = 0; f < this->Terrain->GetNumberOfCells(); ++f)
  {
    const double expected = AreaOf(this->Terrain, f);
    EXPECT_NEAR(ofFace[f], expected, 1e-9 * expected);
  }
}

/// On regular grids borders pass through points of the mesh, up to rounding. Slivers there must be
/// tiny, because filters downstream lose them.
TEST_F(GeodesicVoronoi, CellsCanBeTriangulated)
{
  for (const int n : { 7, 19 })
  {
    for (const double unit : { 1.0, 1.0 / 19.0 })
    {
      const double whole = n * n * unit * unit;
      const vtkSmartPointer<vtkPolyData> grid = MakeGrid(n, n, GridCells::Triangles, unit);
      for (const vtkIdType count : { 2, 4, 5, 9, 16 })
      {
        vtkNew<vtkGeodesicSampler> sampler;
        sampler->SetInputData(grid);
        sampler->SetNumberOfSamples(count);
        this->Filter->SetInputData(grid);
        this->Filter->RemoveAllSites();
        this->Filter->SetSiteConnection(sampler->GetOutputPort());
        ExpectSuccess(this->Filter);
        EXPECT_NEAR(AreaOf(this->Filter->GetCells()), whole, 1e-9 * whole);
        vtkNew<vtkTriangleFilter> triangles;
        triangles->SetInputConnection(this->Filter->GetCellsPort());
        triangles->Update();
        EXPECT_NEAR(AreaOf(triangles->GetOutput()), whole, 1e-6 * whole) << n << ", " << count;
      }
    }
  }
}

TEST_F(GeodesicVoronoi, IdsComeBeforePoints)
{
  const auto sheet = MakeGrid(8, 6);
  this->Filter->SetInputData(sheet);
  this->Filter->SetSiteIds({ 10, 40 });
  this->Filter->SetSiteData(MakeSourcePoints({ { { 6.3, 5.2, 0.01 } } }));
  ExpectSuccess(this->Filter);
  vtkPolyData* sites = this->Filter->GetSites();
  ASSERT_EQ(sites->GetNumberOfPoints(), 3);
  EXPECT_EQ(sites->GetNumberOfVerts(), 3);
  EXPECT_EQ(ToVector(sites->GetPointData()->GetArray("vtkOriginalPointIds")),
    (std::vector<double>{ 10, 40, -1 }));
  EXPECT_EQ(ToVector(sites->GetPointData()->GetArray("SiteId")), (std::vector<double>{ 0, 1, 2 }));
  EXPECT_NEAR(sites->GetPoint(2)[0], 6.3, 1e-9);
  EXPECT_NEAR(sites->GetPoint(2)[2], 0.0, 1e-9);
  EXPECT_EQ(GetSiteOfPoints(this->Filter)[10], 0.0);
  EXPECT_EQ(GetSiteOfPoints(this->Filter)[40], 1.0);
  EXPECT_EQ(GetSiteOfPoints(this->Filter)[62], 2.0);
}

TEST_F(GeodesicVoronoi, SiteArraysArePassed)
{
  this->Filter->SetInputData(MakeGrid(8, 6));
  this->Filter->SetSiteIds({ 10 });
  const auto places = MakeSourcePoints({ { { 6.3, 5.2, 0.0 } }, { { 0.2, 5.9, 0.0 } } });
  AddArray<vtkIntArray>(places->GetPointData(), "Label", { 7, 9 });
  this->Filter->SetSiteData(places);
  ExpectSuccess(this->Filter);
  EXPECT_FALSE(this->Filter->GetOutput()->GetPointData()->HasArray("Label"));
  this->Filter->PassSiteArraysOn();
  ExpectSuccess(this->Filter);
  const std::vector<double> expected = { 0.0, 7.0, 9.0 }; // of the id, then of the points
  const auto expectLabels = [&](const std::vector<double>& sites, vtkDataSetAttributes* data) {
    const auto found = ToVector(data->GetArray("Label"));
    ASSERT_EQ(found.size(), sites.size());
    ASSERT_FALSE(found.empty());
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      EXPECT_EQ(found[i], expected[static_cast<std::size_t>(sites[i])]);
    }
  };
  expectLabels(GetSiteOfPoints(this->Filter), this->Filter->GetOutput()->GetPointData());
  vtkCellData* cells = this->Filter->GetCells()->GetCellData();
  expectLabels(ToVector(cells->GetArray("SiteId")), cells);
  expectLabels({ 0.0, 1.0, 2.0 }, this->Filter->GetSites()->GetPointData());
}

TEST_F(GeodesicVoronoi, QuadsAndReorientedFaces)
{
  for (const GridCells kind : { GridCells::Quads, GridCells::Strips })
  {
    this->Filter->SetInputData(MakeGrid(8, 6, kind));
    this->Filter->SetSiteIds({ 10, 40 });
    ExpectSuccess(this->Filter);
    EXPECT_NEAR(AreaOf(this->Filter->GetCells()), 48.0, 1e-9);
  }
  // Polygons keep the orientation of the input if it changes between faces.
  const auto mixed =
    MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } }, { { 0, 1, 0 } } },
      { { 0, 1, 2 }, { 0, 3, 2 } });
  this->Filter->SetInputData(mixed);
  this->Filter->SetSiteIds({ 1, 3, 0 });
  ExpectSuccess(this->Filter);
  vtkPolyData* cells = this->Filter->GetCells();
  const std::vector<double> faces = ToVector(cells->GetCellData()->GetArray("FaceId"));
  vtkNew<vtkIdList> ids;
  ASSERT_GE(cells->GetNumberOfCells(), 4);
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellPoints(i, ids);
    double normal[3];
    vtkPolygon::ComputeNormal(
      cells->GetPoints(), ids->GetNumberOfIds(), ids->GetPointer(0), normal);
    EXPECT_NEAR(normal[2], faces[i] == 0.0 ? 1.0 : -1.0, 1e-6);
  }
}

TEST_F(GeodesicVoronoi, Centroidal)
{
  this->Filter->SetSiteIds({ 0, 1, 2, 20, 21 });
  this->Filter->CentroidalOn();
  this->Filter->SetNumberOfIterations(15);
  ExpectSuccess(this->Filter);
  vtkDataArray* energies = this->Filter->GetOutput()->GetFieldData()->GetArray("Energy");
  ASSERT_NE(energies, nullptr);
  const std::vector<double> values = ToVector(energies);
  ASSERT_GT(values.size(), 5u);
  EXPECT_LE(values.size(), 16u);
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    EXPECT_LT(values[i], values[i - 1]);
  }
  EXPECT_EQ(this->Terrain->GetFieldData()->GetArray("Energy"), nullptr);
  // Without iterations the sites do not move.
  this->Filter->SetNumberOfIterations(0);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(ToVector(this->Filter->GetOutput()->GetFieldData()->GetArray("Energy")).size(), 1u);
  EXPECT_EQ(ToVector(this->Filter->GetSites()->GetPointData()->GetArray("vtkOriginalPointIds")),
    (std::vector<double>{ 0, 1, 2, 20, 21 }));
}
