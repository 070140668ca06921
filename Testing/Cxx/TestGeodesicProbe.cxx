// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances inside faces through the filters: windows and virtual sources between distance filters
/// and vtkGeodesicProbe.
#include "FilterTestTools.h"
#include "SpectralTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicProbe.h"

#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstring>

using namespace dggtest;

namespace
{
/// A grid with a source in its middle, and positions far from its points.
class GeodesicProbe : public testing::Test
{
protected:
  GeodesicProbe()
  {
    this->Distance->SetInputData(MakeGrid(8, 8));
    this->Distance->AddSourceId(40);
    Points places;
    for (int i = 0; i < 60; ++i)
    {
      const double t = 0.137 * i;
      places.push_back(
        { { 8.0 * (t - std::floor(t)), 8.0 * (std::sqrt(t) - std::floor(std::sqrt(t))), 0.0 } });
    }
    this->Places = MakeSourcePoints(places);
    this->Probe->SetInputConnection(this->Distance->GetOutputPort());
    this->Probe->SetProbeData(this->Places);
  }

  /// Returns the largest error relative to the distance in the plane.
  double GetError()
  {
    vtkDataArray* found = this->Probe->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
    EXPECT_NE(found, nullptr);
    double largest = 0.0;
    for (vtkIdType i = 0; found && i < this->Places->GetNumberOfPoints(); ++i)
    {
      double p[3];
      this->Places->GetPoint(i, p);
      const double d = std::hypot(p[0] - 4.0, p[1] - 4.0);
      largest = std::max(largest, std::abs(found->GetComponent(i, 0) - d) / d);
    }
    return largest;
  }

  vtkNew<vtkExactGeodesicDistance> Distance;
  vtkSmartPointer<vtkPolyData> Places;
  vtkNew<vtkGeodesicProbe> Probe;
};
}

TEST_F(GeodesicProbe, UsesTheMostExactFieldOfItsInput)
{
  const auto expectError = [this](double tolerance) {
    ExpectSuccess(this->Probe);
    EXPECT_EQ(this->Probe->GetOutput()->GetNumberOfPoints(), this->Places->GetNumberOfPoints());
    EXPECT_LT(this->GetError(), tolerance);
  };
  expectError(1e-6); // sources fitted to distances alone
  this->Distance->GenerateVirtualSourceOn();
  expectError(1e-12);
  this->Distance->GenerateWindowsOn();
  expectError(1e-12);
  vtkNew<vtkDGGDistance> graph;
  graph->SetInputData(this->Distance->GetInput());
  graph->AddSourceId(40);
  graph->GenerateVirtualSourceOn();
  this->Probe->SetInputConnection(graph->GetOutputPort());
  expectError(1e-4);
}

TEST_F(GeodesicProbe, PointsOfTheSurfaceNeedNoTolerance)
{
  // The surface is not flat and lies far from the origin.
  auto terrain = MakeTerrain(12);
  MovePoints(terrain, [&](double* p) {
    p[0] = p[0] + 1000.0;
    p[1] = p[1] / 3.0;
    p[2] = p[2] - 700.0;
  });
  Points places;
  for (vtkIdType cell = 0; cell < terrain->GetNumberOfCells(); ++cell)
  {
    places.push_back(PointInCell(terrain, cell, { { 0.3, 0.6, 0.1 } }));
  }
  this->Distance->SetInputData(terrain);
  this->Probe->SetProjectionTolerance(0.0);
  this->Probe->SetProbeData(MakeSourcePoints(places));
  ExpectSuccess(this->Probe);
  places[7][2] += 1e-9;
  this->Probe->SetProbeData(MakeSourcePoints(places));
  ExpectError(this->Probe, { "probe point 7", "farther than 0 (" });
}

TEST_F(GeodesicProbe, WindowsSurviveAFile)
{
  this->Distance->GenerateWindowsOn();
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(this->Distance->GetOutputPort());
  writer->WriteToOutputStringOn();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  this->Probe->SetInputConnection(reader->GetOutputPort());
  ExpectSuccess(this->Probe);
  EXPECT_LT(this->GetError(), 1e-12);
}

TEST_F(GeodesicProbe, WindowsMayBeOfAnyTypeOf64BitIntegers)
{
  this->Distance->GenerateWindowsOn();
  this->Distance->Update();
  for (const int type : { VTK_LONG, VTK_LONG_LONG, VTK_ID_TYPE })
  {
    vtkNew<vtkPolyData> surface;
    surface->ShallowCopy(this->Distance->GetOutput());
    for (const char* name : { "GeodesicDistance.WindowOffsets", "GeodesicDistance.WindowInfo" })
    {
      vtkDataArray* old = surface->GetFieldData()->GetArray(name);
      const auto other = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
      ASSERT_EQ(other->GetDataTypeSize(), 8);
      other->SetName(name);
      other->SetNumberOfTuples(old->GetNumberOfTuples());
      // Copied as bytes, because doubles cannot represent all 64-bit integers.
      std::memcpy(other->GetVoidPointer(0), old->GetVoidPointer(0), 8 * old->GetNumberOfValues());
      surface->GetFieldData()->AddArray(other);
    }
    this->Probe->SetInputData(surface);
    ExpectSuccess(this->Probe);
    EXPECT_LT(this->GetError(), 1e-12) << type;
  }
}

TEST_F(GeodesicProbe, WhatDoesNotBelongIsIgnoredWithAWarning)
{
  this->Distance->GenerateWindowsOn();
  this->Distance->GenerateVirtualSourceOn();
  this->Distance->Update();
  vtkNew<vtkPolyData> changed;
  changed->DeepCopy(this->Distance->GetOutput());
  this->Probe->SetInputData(changed);
  ExpectSuccess(this->Probe);
  EXPECT_LT(this->GetError(), 1e-12);

  // With modified distances, windows are refused; virtual sources still fit.
  vtkDataArray* distances = changed->GetPointData()->GetArray("GeodesicDistance");
  distances->SetComponent(3, 0, distances->GetComponent(3, 0) * (1.0 + 1e-15) + 1e-13);
  distances->Modified();
  changed->Modified();
  ExpectWarning(this->Probe, { "windows", "GeodesicDistance" });
  EXPECT_LT(this->GetError(), 1e-9);

  // Virtual sources that belong to other distances.
  changed->GetFieldData()->Initialize();
  vtkDataArray* sources = changed->GetPointData()->GetArray("GeodesicVirtualSource");
  for (vtkIdType i = 0; i < sources->GetNumberOfTuples(); ++i)
  {
    sources->SetComponent(i, 0, sources->GetComponent(i, 0) + 1.5);
  }
  sources->Modified();
  changed->Modified();
  ExpectWarning(this->Probe, { "virtual sources", "GeodesicVirtualSource" });
  EXPECT_LT(this->GetError(), 1e-6); // fitted again
}

TEST_F(GeodesicProbe, DamagedWindowsAreIgnoredWithAWarning)
{
  this->Distance->GenerateWindowsOn();
  this->Distance->SetSourceData(MakeSourcePoints({ { { 2.3, 1.4, 0.0 } } }));
  this->Distance->Update();
  const auto expectIgnored = [&](const std::vector<std::string>& parts, const auto& change) {
    SCOPED_TRACE(::testing::PrintToString(parts));
    vtkNew<vtkPolyData> changed;
    changed->DeepCopy(this->Distance->GetOutput());
    change(changed);
    this->Probe->SetInputData(changed);
    ExpectWarning(this->Probe, parts);
  };
  for (const char* name : { "GeodesicDistance.Windows", "GeodesicDistance.WindowOffsets",
         "GeodesicDistance.WindowSources", "GeodesicDistance.WindowInfo" })
  {
    SCOPED_TRACE(name);
    expectIgnored({ "windows", "missing" },
      [name](vtkPolyData* changed) { changed->GetFieldData()->RemoveArray(name); });
    if (std::string(name) == "GeodesicDistance.WindowInfo")
    {
      continue;
    }
    expectIgnored({ "windows" }, [name](vtkPolyData* changed) {
      vtkDataArray* array = changed->GetFieldData()->GetArray(name);
      array->SetComponent(array->GetNumberOfTuples() / 3, 0, 1e9);
    });
    // A change so small that the values are still valid.
    expectIgnored({ "windows", "damaged", "written" }, [name](vtkPolyData* changed) {
      vtkDataArray* array = changed->GetFieldData()->GetArray(name);
      const int last = array->GetNumberOfComponents() - 1;
      const vtkIdType row = array->GetNumberOfTuples() / 2;
      array->SetComponent(row, last, array->GetComponent(row, last) + (last > 0 ? 1e-3 : 1.0));
    });
  }
  expectIgnored({ "windows", "format version 1" }, [](vtkPolyData* changed) {
    changed->GetFieldData()->GetArray("GeodesicDistance.WindowInfo")->SetComponent(0, 0, 1.0);
  });
  expectIgnored({ "windows", "'GeodesicDistance'", "float" }, [](vtkPolyData* changed) {
    vtkNew<vtkFloatArray> rounded;
    rounded->DeepCopy(changed->GetPointData()->GetArray("GeodesicDistance"));
    changed->GetPointData()->AddArray(rounded);
  });
}

TEST_F(GeodesicProbe, WindowsGoWithTheirDistances)
{
  this->Distance->GenerateWindowsOn();
  this->Distance->SetDistanceArrayName("d");
  this->Distance->Update();
  vtkFieldData* data = this->Distance->GetOutput()->GetFieldData();
  EXPECT_EQ(data->GetNumberOfArrays(), 4);
  EXPECT_NE(data->GetArray("d.Windows"), nullptr);
  this->Probe->SetDistanceArrayName("d");
  ExpectSuccess(this->Probe);
  EXPECT_NE(this->Probe->GetOutput()->GetPointData()->GetArray("d"), nullptr);
  // Another filter that replaces the distances removes the windows.
  vtkNew<vtkExactGeodesicDistance> again;
  again->SetInputConnection(this->Distance->GetOutputPort());
  again->SetDistanceArrayName("d");
  again->AddSourceId(3);
  again->Update();
  EXPECT_EQ(again->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(this->Distance->GetOutput()->GetFieldData()->GetNumberOfArrays(), 4);
}

TEST_F(GeodesicProbe, SourcesGoWithTheirDistances)
{
  this->Distance->GenerateNearestSourceOn();
  this->Distance->GenerateVirtualSourceOn();
  vtkNew<vtkExactGeodesicDistance> again;
  again->SetInputConnection(this->Distance->GetOutputPort());
  again->SetSourceIds({ 40, 50 }); // so close that old virtual sources seem valid
  this->Probe->SetInputConnection(again->GetOutputPort());
  again->Update();
  vtkPointData* data = again->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 1);
  EXPECT_NE(data->GetArray("GeodesicDistance"), nullptr);
  vtkPointData* before = this->Distance->GetOutput()->GetPointData();
  EXPECT_NE(before->GetArray("GeodesicSource"), nullptr);
  EXPECT_NE(before->GetArray("GeodesicVirtualSource"), nullptr);
  // Requested arrays are present and belong to the new distances.
  again->GenerateNearestSourceOn();
  again->Update();
  EXPECT_EQ(data->GetNumberOfArrays(), 2);
  ASSERT_NE(data->GetArray("GeodesicSource"), nullptr);
  EXPECT_EQ(data->GetArray("GeodesicSource")->GetComponent(50, 0), 1.0);
  // Distances with another name replace no arrays.
  again->GenerateNearestSourceOff();
  again->SetDistanceArrayName("other");
  again->Update();
  EXPECT_EQ(data->GetNumberOfArrays(), 4);
  // The name of an array that is not requested may be used for the distances.
  again->SetDistanceArrayName("GeodesicVirtualSource");
  again->Update();
  ASSERT_NE(data->GetArray("GeodesicVirtualSource"), nullptr);
  EXPECT_EQ(data->GetArray("GeodesicVirtualSource")->GetNumberOfComponents(), 1);
}

TEST_F(GeodesicProbe, UnreachedIsNaN)
{
  this->Distance->GenerateWindowsOn();
  this->Distance->SetMaximumDistance(2.0);
  this->Probe->SetProbeData(MakeSourcePoints({ { { 4.3, 4.2, 0 } }, { { 0.3, 0.2, 0 } } }));
  ExpectSuccess(this->Probe);
  vtkDataArray* found = this->Probe->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
  EXPECT_NEAR(found->GetComponent(0, 0), std::hypot(0.3, 0.2), 1e-12);
  EXPECT_TRUE(std::isnan(found->GetComponent(1, 0)));
}
