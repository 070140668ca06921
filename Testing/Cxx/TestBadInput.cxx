// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Wrong input through the filter: what it says, what it leaves, and that a later correct call
/// works.
#include "FilterTestTools.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkElevationFilter.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace dggtest;

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Inf = std::numeric_limits<double>::infinity();

/// A filter on a small grid that works as it is.
class BadInput : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Grid = MakeGrid(3, 3);
    this->Filter->SetInputData(this->Grid);
    this->Filter->AddSourceId(0);
    ExpectSuccess(this->Filter);
    this->Expected = GetDistances(this->Filter);
    ASSERT_EQ(this->Expected.size(), 16u);
  }

  /// After the error has been repaired.
  void ExpectRecovery()
  {
    ExpectSuccess(this->Filter);
    EXPECT_EQ(GetDistances(this->Filter), this->Expected);
  }

  /// The error, then a correct input.
  void ExpectErrorOn(vtkPolyData* input, const std::vector<std::string>& parts)
  {
    this->Filter->SetInputData(input);
    ExpectError(this->Filter, parts);
    EXPECT_EQ(this->Filter->GetMeshReport(), "no surface\n");
    this->Filter->SetInputData(this->Grid);
    this->ExpectRecovery();
  }

  vtkSmartPointer<vtkPolyData> Grid;
  vtkNew<vtkExactGeodesicDistance> Filter;
  std::vector<double> Expected;
};
}

TEST_F(BadInput, NoSource)
{
  this->Filter->RemoveAllSources();
  ExpectError(this->Filter, { "there is no source", "AddSourceId()", "port 1" });
  this->Filter->SetSourceData(MakeSourcePoints({}));
  ExpectError(this->Filter, { "there is no source", "port 1 has no points" });
  this->Filter->AddSourceId(0);
  this->ExpectRecovery();
}

TEST_F(BadInput, SourceIdOutOfRange)
{
  for (const vtkIdType id :
    { vtkIdType(-1), vtkIdType(16), vtkIdType(VTK_ID_MAX), vtkIdType(VTK_ID_MIN) })
  {
    this->Filter->SetSourceIds(std::vector<vtkIdType>{ 3, id });
    ExpectError(this->Filter,
      { "source id " + std::to_string(id) + " ", "number 1 of", "[0, 15]", "out of range" });
  }
  this->Filter->SetSourceIds(std::vector<vtkIdType>{ 0 });
  this->ExpectRecovery();
}

TEST_F(BadInput, ErrorsAreReportedAgainWhenSomethingHasChanged)
{
  this->Filter->SetSourceIds(std::vector<vtkIdType>{ 99 });
  ExpectError(this->Filter, { "99" });
  {
    const Listener listener(this->Filter);
    this->Filter->Update();
    EXPECT_TRUE(listener.Errors.empty());
    EXPECT_NE(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  }
  this->Filter->Modified();
  ExpectError(this->Filter, { "99" });
  this->Grid->Modified();
  ExpectError(this->Filter, { "99" });
  this->Filter->SetSourceIds(std::vector<vtkIdType>{ 0 });
  this->ExpectRecovery();
  this->Filter->SetSourceIds(std::vector<vtkIdType>{ 99 });
  ExpectError(this->Filter, { "99" });
}

TEST_F(BadInput, TheInputIsUntouched)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Values");
  array->SetNumberOfTuples(16);
  array->Fill(1.0);
  this->Grid->GetPointData()->AddArray(array);
  this->Filter->AddSourceId(99);
  const vtkMTimeType before = this->Grid->GetMTime();
  ExpectError(this->Filter, { "99" });
  EXPECT_EQ(this->Grid->GetMTime(), before);
  EXPECT_EQ(this->Grid->GetNumberOfPoints(), 16);
  EXPECT_EQ(this->Grid->GetPointData()->GetNumberOfArrays(), 1);
}

TEST_F(BadInput, FiltersDownstreamBecomeEmpty)
{
  vtkNew<vtkElevationFilter> downstream;
  downstream->SetInputConnection(this->Filter->GetOutputPort());
  downstream->Update();
  EXPECT_EQ(downstream->GetOutput()->GetNumberOfPoints(), 16);
  this->Filter->AddSourceId(99);
  {
    Listener listener(this->Filter);
    downstream->Update();
    EXPECT_EQ(listener.Errors.size(), 1u);
  }
  EXPECT_EQ(downstream->GetOutput()->GetNumberOfPoints(), 0);
  this->Filter->SetSourceIds(std::vector<vtkIdType>{ 0 });
  downstream->Update();
  EXPECT_EQ(downstream->GetOutput()->GetNumberOfPoints(), 16);
}

TEST_F(BadInput, WhatFollowsFromAFailureIsNotReported)
{
  ProgressWatch watch(this->Filter);
  vtkNew<vtkElevationFilter> between;
  between->SetInputConnection(this->Filter->GetOutputPort());
  vtkNew<vtkExactGeodesicDistance> downstream;
  downstream->SetInputConnection(between->GetOutputPort());
  downstream->SetSourceConnection(between->GetOutputPort());
  const auto expectEmpty = [&](std::size_t errors, bool isSecondInput) {
    this->Filter->Modified();
    // Else an empty surface is a warning, and no sources are an error.
    if (isSecondInput)
    {
      downstream->SetInputData(this->Grid);
    }
    else
    {
      downstream->SetInputConnection(between->GetOutputPort());
    }
    const Listener upstream(this->Filter);
    const Listener listener(downstream);
    downstream->Update();
    EXPECT_EQ(upstream.Errors.size(), errors);
    EXPECT_TRUE(listener.Errors.empty());
    EXPECT_TRUE(listener.Warnings.empty());
    EXPECT_EQ(downstream->GetErrorCode(), vtkErrorCode::NoError);
    EXPECT_EQ(downstream->GetOutput()->GetNumberOfPoints(), 0);
  };
  this->Filter->AddSourceId(99);
  expectEmpty(1, false);
  expectEmpty(1, true);
  this->Filter->SetSourceIds({ 0 });
  watch.StopAt = 0.0;
  expectEmpty(0, false);
  expectEmpty(0, true);
  watch.StopAt = 2.0;
  this->Filter->Modified();
  ExpectSuccess(downstream);
  EXPECT_EQ(downstream->GetOutput()->GetNumberOfPoints(), 16);
}

TEST_F(BadInput, MissingInput)
{
  this->Filter->SetInputConnection(nullptr);
  ExpectError(this->Filter, { "there is no input", "SetInputData()" });
  this->Filter->SetInputData(this->Grid);
  this->ExpectRecovery();
}

TEST_F(BadInput, InputOfAnotherType)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputDataObject(vtkSmartPointer<vtkImageData>::New());
  filter->AddSourceId(0);
  ExpectError(filter, { "vtkImageData", "vtkPolyData is required", "vtkDataSetSurfaceFilter" });
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInputData(this->Grid);
  ExpectSuccess(filter);
  EXPECT_EQ(GetDistances(filter), this->Expected);
}

TEST_F(BadInput, EmptyInputIsAWarning)
{
  this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  this->Filter->GenerateNearestSourceOn();
  ExpectWarning(this->Filter, { "input is empty" });
  vtkPolyData* output = this->Filter->GetOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  ASSERT_NE(output->GetPointData()->GetArray("GeodesicDistance"), nullptr);
  EXPECT_EQ(output->GetPointData()->GetArray("GeodesicDistance")->GetNumberOfTuples(), 0);
  ASSERT_NE(output->GetPointData()->GetArray("GeodesicSource"), nullptr);
  EXPECT_EQ(this->Filter->GetMeshReport(), "no surface\n");
  this->Filter->SetInputData(this->Grid);
  this->ExpectRecovery();
}

TEST_F(BadInput, PointsWithoutPolygons)
{
  auto cloud = MakeSourcePoints({ { { 0, 0, 0 } }, { { 1, 0, 0 } } });
  this->ExpectErrorOn(cloud, { "2 points", "no polygons" });
  cloud->SetVerts(MakeCells({ { 0 }, { 1 } }));
  cloud->SetLines(MakeCells({ { 0, 1 } }));
  this->ExpectErrorOn(cloud, { "2 points", "no polygons" });
}

TEST_F(BadInput, CellThatNamesAPointThatDoesNotExist)
{
  const Points points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } };
  auto surface = MakeSurface(points, { { 0, 1, 2 }, { 0, 1, 3 } });
  this->ExpectErrorOn(surface, { "cell 1 ", "point 3,", "3 points" });
  surface = MakeSurface(points, { { 0, -5, 2 } });
  this->ExpectErrorOn(surface, { "cell 0 ", "point -5," });
  // The ids of cells are those of the input: verts and lines come first.
  surface = MakeSurface(points, { { 0, 1, 2 } });
  surface->SetVerts(MakeCells({ { 0 }, { 1 } }));
  surface->SetLines(MakeCells({ { 0, 1 } }));
  surface->SetStrips(MakeCells({ { 0, 1, 2, 77 } }));
  this->ExpectErrorOn(surface, { "cell 4 ", "point 77," });
}

TEST_F(BadInput, CellsThatContradictThemselves)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  for (const vtkIdType value : { 0, 3, 90 })
  {
    offsets->InsertNextValue(value);
  }
  for (const vtkIdType value : { 0, 1, 2, 0, 2, 3 })
  {
    connectivity->InsertNextValue(value);
  }
  auto surface = MakeGrid(1, 1);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  surface->SetPolys(cells);
  this->ExpectErrorOn(surface, { "contradict" });
}

TEST_F(BadInput, CoordinatesThatAreNotFinite)
{
  for (const double value : { NaN, Inf, -Inf })
  {
    for (int k = 0; k < 3; ++k)
    {
      auto surface = MakeGrid(3, 3);
      double p[3];
      surface->GetPoint(5, p);
      p[k] = value;
      surface->GetPoints()->SetPoint(5, p);
      this->ExpectErrorOn(surface, { "point 5 of cell ", "not finite" });
    }
  }
}

TEST_F(BadInput, PointsThatAreNotFiniteAndNotUsed)
{
  for (const bool merge : { false, true })
  {
    auto surface = MakeGrid(3, 3);
    surface->GetPoints()->InsertNextPoint(NaN, Inf, 0.0);
    this->Filter->SetInputData(surface);
    this->Filter->SetMergeCoincidentPoints(merge);
    ExpectSuccess(this->Filter);
    auto distances = GetDistances(this->Filter);
    ASSERT_EQ(distances.size(), 17u);
    EXPECT_TRUE(std::isnan(distances.back()));
    EXPECT_EQ(this->Filter->GetNumberOfIsolatedPoints(), 1);
    distances.pop_back();
    EXPECT_EQ(distances, this->Expected);
    // Sources on port 1 are not led astray.
    this->Filter->SetSourceData(MakeSourcePoints({ { { 0, 0, 0 } } }));
    ExpectSuccess(this->Filter);
    this->Filter->SetSourceData(nullptr);
  }
}

TEST_F(BadInput, ExtentsBeyondTheRangeOfDoubles)
{
  this->ExpectErrorOn(MakeGrid(3, 3, GridCells::Triangles, 1e100), { "scale the mesh" });
  this->ExpectErrorOn(MakeGrid(3, 3, GridCells::Triangles, 1e-100), { "scale the mesh" });
}

TEST_F(BadInput, OnlyPolygonsWithFewerThanThreePoints)
{
  const Points points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } };
  auto surface =
    MakeSurface(points, { { 0, 0, 0 }, { 0, 1 }, { 2 }, { 0, 1, 0, 1 }, { 1, 2, 2, 1 } });
  this->ExpectErrorOn(surface, { "none of the 5 polygons", "three distinct points" });
}

TEST_F(BadInput, AllPointsInOnePlace)
{
  const std::array<double, 3> p = { { 1.0, 2.0, 3.0 } };
  this->ExpectErrorOn(MakeSurface({ p, p, p }, { { 0, 1, 2 } }), { "single points" });
}

TEST_F(BadInput, MaximumDistanceNegativeOrNaN)
{
  for (const double value : { -1.0, -Inf, NaN })
  {
    this->Filter->SetMaximumDistance(value);
    ExpectError(this->Filter, { "MaximumDistance", "must not be negative or NaN" });
  }
  this->Filter->SetMaximumDistance(Inf);
  this->ExpectRecovery();
}

TEST_F(BadInput, ProjectionToleranceNegativeOrNaN)
{
  for (const double value : { -1e-9, NaN })
  {
    this->Filter->SetProjectionTolerance(value);
    ExpectError(this->Filter, { "ProjectionTolerance", "must not be negative or NaN" });
  }
  this->Filter->SetProjectionTolerance(0.0);
  this->ExpectRecovery();
}

TEST_F(BadInput, NamesOfArrays)
{
  for (const char* name : { "", static_cast<const char*>(nullptr) })
  {
    this->Filter->SetDistanceArrayName(name);
    this->Filter->Modified();
    ExpectError(this->Filter, { "SetDistanceArrayName()" });
  }
  this->Filter->SetDistanceArrayName("GeodesicDistance");
  this->Filter->SetSourceArrayName(nullptr);
  this->ExpectRecovery(); // not needed
  this->Filter->GenerateNearestSourceOn();
  ExpectError(this->Filter, { "SetSourceArrayName()" });
  this->Filter->SetSourceArrayName("GeodesicDistance");
  ExpectError(this->Filter, { "'GeodesicDistance'", "SetSourceArrayName()" });
  this->Filter->SetSourceArrayName("Other");
  this->ExpectRecovery();
}

TEST_F(BadInput, SourcePointsThatAreNotFinite)
{
  this->Filter->SetSourceData(MakeSourcePoints({ { { 0, 0, 0 } }, { { 1, NaN, 0 } } }));
  ExpectError(this->Filter, { "source point 1 of input port 1", "not finite" });
  this->Filter->SetSourceData(nullptr);
  this->ExpectRecovery();
}

TEST_F(BadInput, InitialDistancesThatAreNotOneFiniteNumberEach)
{
  auto sources = MakeSourcePoints({ { { 0, 0, 0 } }, { { 1, 1, 0 } } });
  vtkNew<vtkDoubleArray> values;
  values->SetName("InitialDistance");
  values->InsertNextValue(0.0);
  for (const double value : { NaN, Inf, -Inf })
  {
    values->InsertValue(1, value);
    values->Modified();
    sources->GetPointData()->AddArray(values);
    sources->Modified();
    this->Filter->SetSourceData(sources);
    ExpectError(this->Filter, { "'InitialDistance'", "source point 1", "finite" });
  }
  values->SetNumberOfTuples(1);
  sources->Modified();
  ExpectError(this->Filter, { "'InitialDistance'", "1 tuples for 2 source points" });
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("InitialDistance");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(2);
  vectors->Fill(0.0);
  sources->GetPointData()->AddArray(vectors);
  ExpectError(this->Filter, { "'InitialDistance'", "3 components" });
  vtkNew<vtkStringArray> words;
  words->SetName("InitialDistance");
  words->SetNumberOfValues(2);
  sources->GetPointData()->RemoveArray("InitialDistance");
  sources->GetPointData()->AddArray(words);
  ExpectError(this->Filter, { "'InitialDistance'", "not numeric" });
  this->Filter->SetSourceData(nullptr);
  this->ExpectRecovery();
}

TEST_F(BadInput, OnePieceOfSeveral)
{
  Listener listener(this->Filter);
  this->Filter->UpdatePiece(0, 2, 0);
  ASSERT_EQ(listener.Errors.size(), 1u);
  EXPECT_NE(listener.Errors[0].find("one of 2 pieces"), std::string::npos);
  EXPECT_NE(listener.Errors[0].find("gather"), std::string::npos);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_NE(this->Filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  this->Filter->UpdatePiece(0, 1, 0);
  EXPECT_EQ(listener.Errors.size(), 1u);
  EXPECT_EQ(GetDistances(this->Filter), this->Expected);
}
