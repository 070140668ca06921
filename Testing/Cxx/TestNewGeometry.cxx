// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Properties common to all outputs with new geometry on a surface: field data and the precision of
/// points.
#include "FilterCases.h"
#include "GraphTestTools.h"

#include "vtkDGGLoop.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicPatchBoundaries.h"

using namespace dggtest;

namespace
{
using Coordinates = std::vector<double>;

Coordinates GetCoordinates(vtkPolyData* output)
{
  Coordinates values;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    values.insert(values.end(), p, p + 3);
  }
  return values;
}

std::vector<double> GetValues(vtkFieldData* data)
{
  std::vector<double> values;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.insert(
        values.end(), array->GetTuple(i), array->GetTuple(i) + array->GetNumberOfComponents());
    }
  }
  return values;
}

FilterCase GetFilter(const std::string& name)
{
  const std::vector<FilterCase> filters = GetCurveFilters();
  return *std::find_if(
    filters.begin(), filters.end(), [&](const FilterCase& filter) { return filter.Name == name; });
}

class NewGeometry : public ::testing::TestWithParam<FilterCase>
{
protected:
  /// Updates the filter and returns all coordinates. Expects that they have the given type.
  Coordinates Run(vtkGeodesicAlgorithm* filter, int dataType)
  {
    ExpectSuccess(filter);
    Coordinates all;
    for (const int port : this->GetParam().Ports)
    {
      vtkPolyData* output = filter->GetOutput(port);
      EXPECT_GT(output->GetNumberOfPoints(), 0) << port;
      EXPECT_EQ(output->GetPoints()->GetDataType(), dataType) << port;
      const Coordinates part = GetCoordinates(output);
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  /// Returns all values of all point and cell arrays.
  std::vector<double> GetData(vtkGeodesicAlgorithm* filter)
  {
    std::vector<double> all;
    for (const int port : this->GetParam().Ports)
    {
      vtkPolyData* output = filter->GetOutput(port);
      for (vtkFieldData* data :
        std::vector<vtkFieldData*>{ output->GetPointData(), output->GetCellData() })
      {
        const std::vector<double> part = GetValues(data);
        all.insert(all.end(), part.begin(), part.end());
      }
    }
    return all;
  }
};
}

TEST_P(NewGeometry, FieldDataIsPassedWithoutGraphsAndWindows)
{
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputData(MakeSurfaceWithGraph(MakeRelief(VTK_DOUBLE)));
  distance->AddSourceId(0);
  distance->SetDistanceArrayName("d");
  distance->GenerateWindowsOn();
  distance->Update();
  vtkPolyData* surface = distance->GetOutput();
  AddNote(surface, "d.Note");
  vtkFieldData* before = surface->GetFieldData();
  ASSERT_EQ(before->GetNumberOfArrays(), 11); // arrays of a graph and of windows, and the note
  const auto filter = this->GetParam().Make(surface);
  ExpectSuccess(filter);
  for (const int port : this->GetParam().Ports)
  {
    SCOPED_TRACE(port);
    vtkPolyData* output = filter->GetOutput(port);
    for (int a = 0; a < before->GetNumberOfArrays(); ++a)
    {
      const std::string name = before->GetAbstractArray(a)->GetName();
      EXPECT_EQ(output->GetFieldData()->HasArray(name.c_str()), name == "d.Note") << name;
    }
    for (const char* name : this->GetParam().Arrays)
    {
      EXPECT_NE(output->GetPointData()->GetArray(name), nullptr) << name;
    }
  }
  EXPECT_EQ(before->GetNumberOfArrays(), 11);
}

TEST_P(NewGeometry, PrecisionIsDoubleUnlessSet)
{
  const auto filter = this->GetParam().Make(MakeRelief(VTK_FLOAT));
  EXPECT_EQ(filter->GetOutputPointsPrecision(), vtkAlgorithm::DOUBLE_PRECISION);
  EXPECT_FALSE(this->Run(filter, VTK_DOUBLE).empty());
  filter->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION); // precision of the input
  const Coordinates floats = this->Run(filter, VTK_FLOAT);
  const std::vector<double> data = this->GetData(filter);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  const Coordinates doubles = this->Run(filter, VTK_DOUBLE);
  // Only the coordinates are rounded, not the measured values.
  EXPECT_EQ(this->GetData(filter), data);
  ASSERT_EQ(floats.size(), doubles.size());
  bool isRounded = false;
  for (std::size_t i = 0; i < floats.size(); ++i)
  {
    EXPECT_EQ(floats[i], static_cast<float>(doubles[i]));
    isRounded = isRounded || floats[i] != doubles[i];
  }
  EXPECT_TRUE(isRounded);
  filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  EXPECT_EQ(this->Run(filter, VTK_FLOAT), floats);

  const auto wide = this->GetParam().Make(MakeRelief(VTK_DOUBLE));
  EXPECT_EQ(this->Run(wide, VTK_DOUBLE), doubles);
  wide->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  EXPECT_EQ(this->Run(wide, VTK_FLOAT), floats);
  // New points do not have integer coordinates.
  const auto whole = this->GetParam().Make(MakeRelief(VTK_INT));
  EXPECT_EQ(this->Run(whole, VTK_DOUBLE), doubles);
}

TEST_P(NewGeometry, OutOfTheRangeOfFloats)
{
  for (const double unit : { 1e45, 1e-45 })
  {
    auto surface = MakeRelief(VTK_DOUBLE);
    MovePoints(surface, [&](double* p) {
      p[0] *= unit;
      p[1] *= unit;
      p[2] *= unit;
    });
    const auto filter = this->GetParam().Make(surface);
    if (auto* loop = vtkDGGLoop::SafeDownCast(filter))
    {
      loop->SetTapeWidth(unit * loop->GetTapeWidth());
    }
    this->Run(filter, VTK_DOUBLE);
    filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    ExpectError(filter, { "OutputPointsPrecision is single", "to double" });
    filter->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
    this->Run(filter, VTK_DOUBLE);
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, NewGeometry, ::testing::ValuesIn(GetCurveFilters()),
  [](const ::testing::TestParamInfo<FilterCase>& tested) { return tested.param.Name; });

TEST(NewGeometryOfTwoSurfaces, EachHasItsOwn)
{
  auto first = MakeRelief(VTK_FLOAT);
  auto second = MakeSurfaceWithGraph(MakeRelief(VTK_DOUBLE));
  AddNote(first, "first");
  AddNote(second, "second");
  const auto filter = GetFilter("PatchBoundaries").Make(first);
  vtkGeodesicPatchBoundaries::SafeDownCast(filter)->SetSecondSurfaceData(second);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION); // precision of each surface
  ExpectSuccess(filter);
  vtkPolyData* outputs[2] = { filter->GetOutput(0), filter->GetOutput(1) };
  EXPECT_EQ(outputs[0]->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(outputs[1]->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NE(outputs[0]->GetFieldData()->GetAbstractArray("first"), nullptr);
  EXPECT_EQ(outputs[0]->GetFieldData()->GetNumberOfArrays(), 1);
  EXPECT_NE(outputs[1]->GetFieldData()->GetAbstractArray("second"), nullptr);
  EXPECT_EQ(outputs[1]->GetFieldData()->GetNumberOfArrays(), 1);
}

TEST(OldGeometry, StaysAsItIs)
{
  auto surface = MakeSurfaceWithGraph(MakeRelief(VTK_FLOAT));
  const auto filter = GetFilter("Voronoi").Make(surface);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  ExpectSuccess(filter);
  EXPECT_EQ(filter->GetOutput(0)->GetPoints(), surface->GetPoints());
  EXPECT_EQ(GetGraphBytes(filter->GetOutput(0)), GetGraphBytes(surface));
  // The points of the input come first in the cells, with unchanged coordinates.
  const Coordinates before = GetCoordinates(surface);
  Coordinates cells = GetCoordinates(filter->GetOutput(2));
  ASSERT_GT(cells.size(), before.size());
  cells.resize(before.size());
  EXPECT_EQ(cells, before);
}

TEST(OldGeometry, WindowsGoWithTheDistancesThatAreReplaced)
{
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputData(MakeRelief(VTK_DOUBLE));
  distance->AddSourceId(0);
  distance->GenerateWindowsOn();
  distance->Update();
  const auto filter = GetFilter("Voronoi").Make(distance->GetOutput());
  ExpectSuccess(filter);
  vtkFieldData* data = filter->GetOutput(0)->GetFieldData();
  EXPECT_EQ(data->GetAbstractArray("GeodesicDistance.WindowInfo"), nullptr);
  EXPECT_EQ(data->GetAbstractArray("GeodesicDistance.Windows"), nullptr);
  // Windows of other distances on the surface remain valid.
  distance->SetDistanceArrayName("d");
  distance->Update();
  ExpectSuccess(filter);
  data = filter->GetOutput(0)->GetFieldData();
  EXPECT_NE(data->GetAbstractArray("d.Windows"), nullptr);
}
