// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Output of the isoline filter.
#include "FilterTestTools.h"

#include "vtkApolloniusIsolines.h"
#include "vtkDGGDistance.h"
#include "vtkExactGeodesicDistance.h"

#include "vtkContourFilter.h"

using namespace dggtest;

namespace
{
/// A grid with a source in its middle.
class ApolloniusIsolines : public testing::Test
{
protected:
  ApolloniusIsolines()
  {
    this->Distance->SetInputData(MakeGrid(8, 8));
    this->Distance->AddSourceId(40);
    this->Isolines->SetInputConnection(this->Distance->GetOutputPort());
    this->Isolines->GenerateValues(6, 0.55, 3.55);
  }

  /// Returns the surface with its distances as a copy that may be modified.
  vtkSmartPointer<vtkPolyData> TakeSurface()
  {
    this->Distance->Update();
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->DeepCopy(this->Distance->GetOutput());
    this->Isolines->SetInputData(surface);
    return surface;
  }

  /// Returns the largest error of points and of midpoints of segments, and the mean of the latter
  /// along lines.
  std::array<double, 3> GetErrors()
  {
    vtkPolyData* output = this->Isolines->GetOutput();
    vtkDataArray* values = output->GetCellData()->GetArray("IsoValue");
    EXPECT_NE(values, nullptr);
    std::array<double, 3> largest{ { 0.0, 0.0, 0.0 } };
    double length = 0.0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; values && cell < output->GetNumberOfCells(); ++cell)
    {
      const double value = values->GetComponent(cell, 0);
      output->GetCellPoints(cell, ids);
      for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
      {
        double p[3];
        double q[3];
        output->GetPoint(ids->GetId(i), p);
        output->GetPoint(ids->GetId(i + 1), q);
        const double atPoint = std::hypot(p[0] - 4.0, p[1] - 4.0);
        const double atMiddle = std::hypot(0.5 * (p[0] + q[0]) - 4.0, 0.5 * (p[1] + q[1]) - 4.0);
        largest[0] = std::max(largest[0], std::abs(atPoint - value));
        largest[1] = std::max(largest[1], std::abs(atMiddle - value));
        const double piece = std::hypot(p[0] - q[0], p[1] - q[1]);
        largest[2] += piece * std::abs(atMiddle - value);
        length += piece;
      }
    }
    largest[2] /= length;
    return largest;
  }

  vtkNew<vtkExactGeodesicDistance> Distance;
  vtkNew<vtkApolloniusIsolines> Isolines;
};
}

TEST_F(ApolloniusIsolines, ValuesAreThoseOfContourFilters)
{
  vtkNew<vtkContourFilter> contours;
  vtkNew<vtkApolloniusIsolines> isolines;
  const auto expectSame = [&] {
    ASSERT_EQ(isolines->GetNumberOfContours(), contours->GetNumberOfContours());
    std::vector<double> copy(isolines->GetNumberOfContours(), -1.0);
    isolines->GetValues(copy.data());
    for (int i = 0; i < contours->GetNumberOfContours(); ++i)
    {
      EXPECT_EQ(isolines->GetValue(i), contours->GetValue(i));
      EXPECT_EQ(isolines->GetValues()[i], contours->GetValue(i));
      EXPECT_EQ(copy[i], contours->GetValue(i));
    }
  };
  expectSame();
  const vtkMTimeType before = isolines->GetMTime();
  isolines->SetValue(1, 2.5);
  EXPECT_GT(isolines->GetMTime(), before);
  contours->SetValue(1, 2.5);
  expectSame();
  isolines->SetValue(4, 1.0);
  EXPECT_EQ(isolines->GetNumberOfContours(), 5);
  EXPECT_EQ(isolines->GetValue(2), 0.0) << "left out";
  EXPECT_EQ(isolines->GetValue(3), 0.0) << "left out";
  isolines->SetNumberOfContours(9);
  EXPECT_EQ(isolines->GetValue(1), 2.5);
  EXPECT_EQ(isolines->GetValue(7), 0.0);
  isolines->SetNumberOfContours(2);
  expectSame();
  isolines->SetNumberOfContours(0);
  contours->SetNumberOfContours(0);
  expectSame();
  isolines->GenerateValues(5, 1.0, 3.0);
  contours->GenerateValues(5, 1.0, 3.0);
  expectSame();
  double range[2] = { -1.0, 7.0 };
  isolines->GenerateValues(4, range);
  contours->GenerateValues(4, range);
  expectSame();
}

TEST_F(ApolloniusIsolines, ValuesThatAreTooSteepForDistancesAreLinear)
{
  auto surface = this->TakeSurface();
  vtkDataArray* distances = surface->GetPointData()->GetArray("GeodesicDistance");
  const auto scale = [&](double factor) {
    for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
    {
      distances->SetComponent(i, 0, factor * distances->GetComponent(i, 0));
    }
    distances->Modified();
  };
  scale(5.0);
  this->Isolines->GenerateValues(6, 2.75, 17.75);
  ExpectWarning(this->Isolines, { "by more than the length of the edge", "linear" });
  EXPECT_FALSE(this->Isolines->GetUsedVirtualSources());
  EXPECT_EQ(this->Isolines->GetOutput()->GetNumberOfLines(), 6);
  this->Isolines->SetMethodToLinear();
  ExpectSuccess(this->Isolines);
  // LocalSources does not check that other arrays are distances.
  this->Isolines->SetMethodToLocalSources();
  scale(0.04);
  this->Isolines->GenerateValues(6, 0.11, 0.71);
  ExpectSuccess(this->Isolines);
  EXPECT_TRUE(this->Isolines->GetUsedVirtualSources());
}

TEST_F(ApolloniusIsolines, UseTheMostExactFieldOfTheInput)
{
  const auto expectFields = [this](bool windows, bool virtualSources) {
    ExpectSuccess(this->Isolines);
    EXPECT_EQ(this->Isolines->GetUsedWindows(), windows);
    EXPECT_EQ(this->Isolines->GetUsedVirtualSources(), virtualSources);
    return this->GetErrors();
  };
  const double fitted = expectFields(false, true)[2]; // sources fitted to distances alone
  this->Isolines->SetMethodToLinear();
  const double linear = expectFields(false, false)[2];
  EXPECT_LT(4.0 * fitted, linear);
  this->Isolines->SetMethodToApollonius();
  EXPECT_STREQ(this->Isolines->GetMethodAsString(), "Apollonius");
  this->Isolines->SetSteinerPoints(4);
  EXPECT_LT(expectFields(false, true)[2], 0.5 * linear);
  this->Isolines->SetMethodToLocalSources();
  this->Distance->GenerateVirtualSourceOn();
  EXPECT_LT(expectFields(false, true)[0], 1e-12);
  this->Distance->GenerateWindowsOn();
  std::array<double, 3> errors = expectFields(true, false);
  EXPECT_LT(errors[0], 1e-12);
  EXPECT_LT(errors[1], 1.3e-3); // mean edge length: 1.14
  vtkPolyData* output = this->Isolines->GetOutput();
  EXPECT_EQ(output->GetNumberOfLines(), 6);
  EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), 0) << "windows are those of the surface";
  EXPECT_GT(this->Distance->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  const vtkIdType points = output->GetNumberOfPoints();
  this->Isolines->SetChordTolerance(1e-6); // the smallest valid tolerance
  EXPECT_LT(expectFields(true, false)[1], 1.3e-6);
  EXPECT_EQ(this->Isolines->GetNumberOfFallbacks(), 0);
  EXPECT_GT(output->GetNumberOfPoints(), 3 * points);
}

/// Rings around a point, each 17 % smaller than the next: most edges are shorter than the error
/// bound of the graph for the distance to the source, which is on the outermost ring.
TEST_F(ApolloniusIsolines, TakeSourcesOfGraphsWithShortEdges)
{
  constexpr int sides = 24;
  constexpr int rings = 100;
  Points points = { { { 0.0, 0.0, 0.3 * std::sin(1.0) } } };
  Cells cells;
  for (vtkIdType ring = 0; ring < rings; ++ring)
  {
    const double radius = std::pow(0.83, rings - 1 - ring);
    for (vtkIdType i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * (i + 0.5 * ring) / sides;
      const double x = radius * std::cos(angle);
      const double y = radius * std::sin(angle);
      points.push_back({ { x, y, 0.3 * std::sin(3.0 * x) * std::cos(2.0 * y + 1.0) } });
      const vtkIdType a = 1 + sides * (ring - 1) + i;
      const vtkIdType b = 1 + sides * (ring - 1) + (i + 1) % sides;
      if (ring == 0)
      {
        cells.push_back({ 0, 1 + i, 1 + (i + 1) % sides });
      }
      else
      {
        cells.push_back({ a, a + sides, b });
        cells.push_back({ b, a + sides, b + sides });
      }
    }
  }
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(MakeSurface(points, cells));
  distance->AddSourceId(static_cast<vtkIdType>(points.size()) - 5);
  distance->GenerateVirtualSourceOn();
  this->Isolines->SetInputConnection(distance->GetOutputPort());
  for (const double accuracy : { 0.01, 0.1, 0.5 })
  {
    for (const bool correct : { false, true })
    {
      SCOPED_TRACE(accuracy);
      distance->SetAccuracy(accuracy);
      distance->SetCorrection(correct);
      ExpectSuccess(this->Isolines);
      // These triangles are large for an accuracy of 0.01.
      EXPECT_EQ(this->Isolines->GetUsedWindows(), correct && accuracy == 0.01);
      EXPECT_NE(this->Isolines->GetUsedVirtualSources(), this->Isolines->GetUsedWindows());
    }
  }
}

TEST_F(ApolloniusIsolines, WarnOfSourcesInLongTriangles)
{
  this->Distance->SetInputData(MakePlateWithHole());
  this->Distance->SetSourceIds({ 4 });
  this->Distance->GenerateVirtualSourceOn();
  this->Isolines->GenerateValues(6, 0.1, 2.0);
  ExpectWarning(this->Isolines, { "covered by long triangles", "exact distances with windows" });
  this->Isolines->GenerateValues(3, 0.1, 2.0); // warned once for each mesh
  ExpectSuccess(this->Isolines);
  this->Distance->GenerateWindowsOn();
  ExpectSuccess(this->Isolines);
}

TEST_F(ApolloniusIsolines, LinearOnesAreThoseOfContourFilters)
{
  this->Isolines->SetMethodToLinear();
  ExpectSuccess(this->Isolines);
  vtkNew<vtkContourFilter> contours;
  contours->SetInputConnection(this->Distance->GetOutputPort());
  contours->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "GeodesicDistance");
  contours->GenerateValues(6, 0.55, 3.55);
  contours->Update();
  vtkPolyData* output = this->Isolines->GetOutput();
  ASSERT_GT(output->GetNumberOfPoints(), 0);
  ASSERT_EQ(output->GetNumberOfPoints(), contours->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    output->GetPoint(i, p);
    contours->GetOutput()->GetPoint(contours->GetOutput()->FindPoint(p), q);
    EXPECT_NEAR(std::hypot(p[0] - q[0], p[1] - q[1]), 0.0, 1e-6);
  }
}

TEST_F(ApolloniusIsolines, PointsAndCellsSayWhereTheyAre)
{
  this->Distance->GenerateWindowsOn();
  this->Isolines->SetNumberOfContours(2);
  this->Isolines->SetValue(0, 2.0);
  this->Isolines->SetValue(1, 1.0); // passes through four points
  ExpectSuccess(this->Isolines);
  vtkPolyData* output = this->Isolines->GetOutput();
  ASSERT_EQ(output->GetNumberOfCells(), 2);
  vtkDataArray* values = output->GetCellData()->GetScalars();
  ASSERT_NE(values, nullptr);
  EXPECT_STREQ(values->GetName(), "IsoValue");
  EXPECT_EQ(values->GetComponent(0, 0), 1.0);
  EXPECT_EQ(values->GetComponent(1, 0), 2.0);
  vtkDataArray* originals = output->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* faces = output->GetPointData()->GetArray("FaceId");
  vtkDataArray* lengths = output->GetPointData()->GetArray("ArcLength");
  ASSERT_TRUE(originals && faces && lengths);
  vtkNew<vtkIdList> ids;
  output->GetCellPoints(0, ids);
  EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1)) << "closed";
  std::set<double> found;
  for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
  {
    const vtkIdType id = ids->GetId(i);
    EXPECT_GE(faces->GetComponent(id, 0), 0.0);
    EXPECT_LT(faces->GetComponent(id, 0), 128.0);
    EXPECT_TRUE(i == 0 || lengths->GetComponent(id, 0) > lengths->GetComponent(id - 1, 0));
    if (originals->GetComponent(id, 0) >= 0.0)
    {
      found.insert(originals->GetComponent(id, 0));
    }
  }
  EXPECT_EQ(found, (std::set<double>{ 31.0, 39.0, 41.0, 49.0 }));
}

TEST_F(ApolloniusIsolines, NoValueInRangeIsAWarningOnce)
{
  const auto expectEmpty = [this](bool isWarned) {
    if (isWarned)
    {
      ExpectWarning(this->Isolines, { "no isolines", "from 0 to 5.65685," });
    }
    else
    {
      ExpectSuccess(this->Isolines);
    }
    EXPECT_EQ(this->Isolines->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_NE(this->Isolines->GetOutput()->GetCellData()->GetArray("IsoValue"), nullptr);
  };
  this->Isolines->GenerateValues(3, 100.0, 200.0);
  expectEmpty(true);
  this->Isolines->SetNumberOfContours(0);
  expectEmpty(false);
  this->Isolines->SetValue(0, 1.0);
  ExpectSuccess(this->Isolines);
  this->Isolines->SetValue(0, 0.0); // the default; only the source has this distance
  expectEmpty(true);
  // No warning is given if other outputs are requested.
  this->Isolines->GenerateBandsOn();
  expectEmpty(false);
  this->Isolines->GenerateBandsOff();
  expectEmpty(true);
  // No warning is given if no point is reached, as the range is empty then.
  vtkNew<vtkApolloniusIsolines> unreached;
  unreached->SetMethodToLinear();
  auto surface = this->TakeSurface();
  surface->GetPointData()->GetArray("GeodesicDistance")->Fill(std::nan(""));
  unreached->SetInputData(surface);
  ExpectSuccess(unreached);
  surface->GetPointData()->GetArray("GeodesicDistance")->Fill(1.0);
  surface->GetPointData()->GetArray("GeodesicDistance")->Modified();
  ExpectWarning(unreached, { "no isolines", "from 1 to 1," });
}
