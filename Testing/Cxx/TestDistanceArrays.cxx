// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Choice of the distance array in isolines and probes, and detection of unreached points.
#include "FilterTestTools.h"

#include "vtkApolloniusIsolines.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicProbe.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"

#include <sstream>
#include <type_traits>

using namespace dggtest;

namespace
{
const double NaN = std::numeric_limits<double>::quiet_NaN();

void Prepare(vtkApolloniusIsolines* filter)
{
  filter->GenerateValues(6, 0.55, 3.55);
  filter->GenerateBandsOn();
}

void Prepare(vtkGeodesicProbe* filter)
{
  Points places;
  for (int i = 0; i < 60; ++i)
  {
    const double t = 0.137 * i;
    places.push_back(
      { { 8.0 * (t - std::floor(t)), 8.0 * (std::sqrt(t) - std::floor(std::sqrt(t))), 0.0 } });
  }
  filter->SetProbeData(MakeSourcePoints(places));
}

/// Returns all points and the scalars of all outputs as text.
std::string Describe(vtkPolyDataAlgorithm* filter)
{
  std::ostringstream os;
  os.precision(17);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* output = filter->GetOutput(port);
    vtkDataArray* scalars = output->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const double* p = output->GetPoint(i);
      os << p[0] << " " << p[1] << " " << p[2] << " "
         << (scalars ? scalars->GetComponent(i, 0) : 0.0) << "\n";
    }
    os << output->GetNumberOfCells() << "\n";
  }
  return os.str();
}

vtkSmartPointer<vtkPolyData> Copy(vtkGeodesicDistanceAlgorithm* filter)
{
  filter->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(filter->GetOutput());
  return copy;
}
}

/// A grid with a source in its middle, and a filter that reads the distances.
template <typename FilterType>
class DistanceArrays : public ::testing::Test
{
protected:
  DistanceArrays()
  {
    this->Distance->SetInputData(MakeGrid(8, 8));
    this->Distance->AddSourceId(40);
    this->Filter->SetInputConnection(this->Distance->GetOutputPort());
    Prepare(this->Filter.Get());
  }

  /// Returns the result for unreached points with the value NaN.
  std::string GetExpected()
  {
    this->Distance->SetUnreachedValue(NaN);
    ExpectSuccess(this->Filter);
    return Describe(this->Filter);
  }

  vtkNew<vtkExactGeodesicDistance> Distance;
  vtkNew<FilterType> Filter;
};
using Readers = ::testing::Types<vtkApolloniusIsolines, vtkGeodesicProbe>;
TYPED_TEST_SUITE(DistanceArrays, Readers);

TYPED_TEST(DistanceArrays, AreThoseThatAreNamed)
{
  auto* filter = this->Filter.Get();
  const std::string expected = this->GetExpected();
  auto surface = Copy(this->Distance);
  vtkPointData* data = surface->GetPointData();
  data->GetArray("GeodesicDistance")->SetName("mine");
  AddArray(data, "other", std::vector<double>(surface->GetNumberOfPoints(), 1.0));
  data->SetActiveScalars("mine");
  filter->SetInputData(surface);

  // The active scalars or other arrays are not used instead.
  ExpectError(filter, { "'GeodesicDistance'", "'mine'", "'other'", "DistanceArrayName" });
  filter->SetDistanceArrayName("Mine");
  ExpectError(filter, { "'Mine'", "'mine'", "'other'" });
  filter->SetDistanceArrayName("mine");
  ExpectSuccess(filter);
  EXPECT_EQ(Describe(filter), expected) << "by name";

  filter->SetDistanceArrayName("");
  ExpectSuccess(filter);
  EXPECT_EQ(Describe(filter), expected) << "active scalars";
  data->SetActiveScalars(nullptr);
  surface->Modified();
  ExpectError(filter, { "active point scalars", "'mine'" });
}

TYPED_TEST(DistanceArrays, MayBeSetToBeProcessed)
{
  auto* filter = this->Filter.Get();
  const std::string expected = this->GetExpected();
  auto surface = Copy(this->Distance);
  vtkPointData* data = surface->GetPointData();
  vtkNew<vtkDoubleArray> mine;
  mine->DeepCopy(data->GetArray("GeodesicDistance"));
  mine->SetName("mine");
  data->AddArray(mine);
  data->GetArray("GeodesicDistance")->Fill(0.5);
  filter->SetInputData(surface);

  // SetInputArrayToProcess() takes precedence over the name of the property.
  const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  filter->SetInputArrayToProcess(0, 0, 0, points, "mine");
  ExpectSuccess(filter);
  EXPECT_EQ(Describe(filter), expected) << "by name";
  if (std::is_same<TypeParam, vtkGeodesicProbe>::value)
  {
    EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("mine"), nullptr);
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("GeodesicDistance"), nullptr);
  }
  // No other array is used instead.
  filter->SetInputArrayToProcess(0, 0, 0, points, "Mine");
  ExpectError(filter, { "'Mine'", "'mine'", "'GeodesicDistance'", "DistanceArrayName" });

  data->SetActiveScalars("mine");
  surface->Modified();
  filter->SetInputArrayToProcess(0, 0, 0, points, vtkDataSetAttributes::SCALARS);
  ExpectSuccess(filter);
  EXPECT_EQ(Describe(filter), expected) << "scalars";
  filter->SetInputArrayToProcess(0, 0, 0, points, vtkDataSetAttributes::VECTORS);
  ExpectError(filter, { "SetInputArrayToProcess()", "SCALARS" });
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "mine");
  ExpectError(filter, { "FIELD_ASSOCIATION_POINTS" });
  filter->SetInputArrayToProcess(0, 1, 0, points, "mine");
  ExpectError(filter, { "SetInputArrayToProcess()", "port 0" });
  filter->SetInputArrayToProcess(0, 0, 0, points, "mine");
  ExpectSuccess(filter);
}

TYPED_TEST(DistanceArrays, UnreachedPointsMayHaveAnyValue)
{
  this->Distance->SetMaximumDistance(3.2);
  for (const int extra : { 0, 1, 2 })
  {
    this->Distance->SetGenerateVirtualSource(extra == 1);
    this->Distance->SetGenerateWindows(extra == 2);
    const std::string expected = this->GetExpected();
    EXPECT_EQ(
      this->Distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance.Unreached"), nullptr);
    // Includes values that are also distances of points: 0 at the source, 1 at four points.
    for (const double value : { -1.0, 0.0, -0.0, 1.0, 1e9, -std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity() })
    {
      this->Distance->SetUnreachedValue(value);
      ExpectSuccess(this->Filter);
      EXPECT_EQ(Describe(this->Filter), expected) << extra << " " << value;
    }
  }
}

TYPED_TEST(DistanceArrays, UnreachedValueIsAProperty)
{
  auto* filter = this->Filter.Get();
  EXPECT_TRUE(std::isnan(filter->GetUnreachedValue()));
  this->Distance->SetMaximumDistance(3.2);
  const std::string expected = this->GetExpected();
  this->Distance->SetUnreachedValue(-0.1);
  auto surface = Copy(this->Distance);
  surface->GetPointData()->RemoveArray("GeodesicDistance.Unreached"); // from another program
  filter->SetInputData(surface);
  Listener listener(filter);
  filter->Update();
  EXPECT_NE(Describe(filter), expected) << "taken for distances";
  filter->SetUnreachedValue(-0.1);
  ExpectSuccess(filter);
  EXPECT_EQ(Describe(filter), expected);
  const vtkMTimeType before = filter->GetMTime();
  filter->SetUnreachedValue(-0.1);
  EXPECT_EQ(filter->GetMTime(), before);

  // The UnreachedValue of the filter takes precedence over the mask and is rounded like the
  // distances.
  surface = Copy(this->Distance);
  vtkNew<vtkFloatArray> rounded;
  rounded->DeepCopy(surface->GetPointData()->GetArray("GeodesicDistance"));
  surface->GetPointData()->AddArray(rounded);
  filter->SetInputData(surface);
  ExpectSuccess(filter);
  const std::string ofFloats = Describe(filter);
  filter->SetUnreachedValue(NaN);
  ExpectSuccess(filter);
  EXPECT_EQ(Describe(filter), ofFloats);
  filter->SetUnreachedValue(-5.0);
  filter->Update();
  EXPECT_NE(Describe(filter), ofFloats);
}

TYPED_TEST(DistanceArrays, UnreachedValueGoesWithItsDistances)
{
  const char* name = "GeodesicDistance.Unreached";
  this->Distance->SetMaximumDistance(3.2);
  this->Distance->SetUnreachedValue(0.0);
  ExpectSuccess(this->Filter);
  vtkDataArray* mask = this->Distance->GetOutput()->GetPointData()->GetArray(name);
  ASSERT_NE(mask, nullptr);
  EXPECT_EQ(mask->GetComponent(40, 0), 0.0);
  EXPECT_EQ(mask->GetComponent(0, 0), 1.0);
  // The mask is also absent if every point is reached, or if other distances replace these.
  vtkNew<vtkExactGeodesicDistance> again;
  again->SetInputConnection(this->Distance->GetOutputPort());
  again->AddSourceId(3);
  again->SetUnreachedValue(0.0);
  again->Update();
  EXPECT_EQ(again->GetOutput()->GetPointData()->GetArray(name), nullptr);
  again->SetDistanceArrayName("other");
  again->Update();
  EXPECT_NE(again->GetOutput()->GetPointData()->GetArray(name), nullptr);
}

TYPED_TEST(DistanceArrays, AMaskOfAnotherLayoutIsNotRead)
{
  this->Distance->SetMaximumDistance(3.2);
  this->Distance->SetUnreachedValue(0.0);
  auto surface = Copy(this->Distance);
  AddArray(surface->GetPointData(), "GeodesicDistance.Unreached",
    std::vector<double>(2 * surface->GetNumberOfPoints(), 1.0), 2);
  this->Filter->SetInputData(surface);
  Listener listener(this->Filter.Get());
  this->Filter->Update();
  EXPECT_TRUE(listener.Errors.empty());
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

/// Field arrays of port 1 of the probe, which describe another array of this name, are not passed
/// to the result.
TEST(GeodesicProbeArrays, ProbePointsMayHaveDistances)
{
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputData(MakeGrid(8, 8));
  distance->AddSourceId(40);
  distance->SetMaximumDistance(3.2);
  distance->SetUnreachedValue(1.0);
  distance->GenerateWindowsOn();
  vtkNew<vtkGeodesicProbe> probe;
  probe->SetInputConnection(distance->GetOutputPort());
  probe->SetProbeConnection(distance->GetOutputPort());
  ExpectSuccess(probe);
  EXPECT_EQ(probe->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(distance->GetOutput()->GetFieldData()->GetNumberOfArrays(), 4);
  vtkDataArray* found = probe->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->GetComponent(41, 0), 1.0);
  EXPECT_TRUE(std::isnan(found->GetComponent(0, 0)));
}
