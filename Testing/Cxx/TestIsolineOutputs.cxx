// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ridges and bands, the additional outputs of vtkApolloniusIsolines.
#include "FilterTestTools.h"

#include "vtkApolloniusIsolines.h"
#include "vtkDGGDistance.h"
#include "vtkExactGeodesicDistance.h"

#include "vtkTriangle.h"

using namespace dggtest;

namespace
{
/// The square [0, 8] x [0, 8] with one source in the middle of its left part and one in the right
/// part.
class IsolineOutputs : public testing::Test
{
protected:
  IsolineOutputs()
  {
    this->Distance->SetInputData(MakeGrid(8, 8));
    this->Distance->SetSourceIds({ 4 * 9 + 2, 4 * 9 + 6 });
    this->Distance->GenerateWindowsOn();
    this->Isolines->SetInputConnection(this->Distance->GetOutputPort());
    this->Isolines->GenerateValues(3, 0.5, 1.5);
  }

  static double GetArea(vtkPolyData* bands, vtkIdType triangle)
  {
    vtkNew<vtkIdList> ids;
    bands->GetCellPoints(triangle, ids);
    double p[3][3];
    for (int k = 0; k < 3; ++k)
    {
      bands->GetPoint(ids->GetId(k), p[k]);
    }
    return vtkTriangle::TriangleArea(p[0], p[1], p[2]);
  }

  vtkNew<vtkExactGeodesicDistance> Distance;
  vtkNew<vtkApolloniusIsolines> Isolines;
};
}

TEST_F(IsolineOutputs, AreEmptyUnlessAskedFor)
{
  EXPECT_FALSE(this->Isolines->GetGenerateRidges());
  EXPECT_FALSE(this->Isolines->GetGenerateBands());
  EXPECT_EQ(this->Isolines->GetMinimumRidgeAngle(), 20.0);
  ExpectSuccess(this->Isolines);
  EXPECT_GT(this->Isolines->GetOutput()->GetNumberOfLines(), 0);
  EXPECT_EQ(this->Isolines->GetRidges()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Isolines->GetBands()->GetNumberOfPoints(), 0);
  EXPECT_NE(this->Isolines->GetRidges()->GetCellData()->GetArray("RidgeAngle"), nullptr);
  EXPECT_NE(this->Isolines->GetBands()->GetCellData()->GetArray("Band"), nullptr);
}

TEST_F(IsolineOutputs, RidgesHaveAtLeastTheMinimumAngle)
{
  this->Isolines->GenerateRidgesOn();
  for (const double degrees : { 20.0, 120.0 })
  {
    this->Isolines->SetMinimumRidgeAngle(degrees);
    ExpectSuccess(this->Isolines);
    vtkPolyData* ridges = this->Isolines->GetRidges();
    ASSERT_GT(ridges->GetNumberOfLines(), 0);
    EXPECT_NEAR(ridges->GetPoint(0)[0], 4.0, 1e-12);
    vtkDataArray* angles = ridges->GetCellData()->GetArray("RidgeAngle");
    EXPECT_GE(angles->GetRange()[0], degrees);
    EXPECT_LE(angles->GetRange()[1], 180.0);
  }
}

TEST_F(IsolineOutputs, RidgesNeedMoreThanDistances)
{
  this->Isolines->GenerateRidgesOn();
  this->Isolines->SetMethodToLinear();
  ExpectWarning(this->Isolines, { "ridges" });
  EXPECT_EQ(this->Isolines->GetRidges()->GetNumberOfLines(), 0);
  EXPECT_GT(this->Isolines->GetOutput()->GetNumberOfLines(), 0);
  this->Isolines->SetMethodToLocalSources();
  for (const double bad : { -1.0, 181.0, std::nan("") })
  {
    this->Isolines->SetMinimumRidgeAngle(bad);
    ExpectError(this->Isolines, { "MinimumRidgeAngle" });
  }
}

TEST_F(IsolineOutputs, RidgesOfFittedSourcesAreNotReliedOn)
{
  this->Distance->SetSourceIds({ 4 * 9 + 2, 4 * 9 + 5 });
  this->Distance->GenerateWindowsOff();
  this->Isolines->GenerateRidgesOn();
  ExpectWarning(
    this->Isolines, { "ridges", "fitted", "Turn on GenerateWindows", "GenerateVirtualSource" });
  EXPECT_TRUE(this->Isolines->GetUsedVirtualSources());
  this->Isolines->GenerateRidgesOff();
  ExpectSuccess(this->Isolines);
  this->Isolines->GenerateRidgesOn();
  this->Distance->GenerateVirtualSourceOn();
  ExpectSuccess(this->Isolines);
  this->Distance->GenerateVirtualSourceOff();
  this->Distance->GenerateWindowsOn();
  ExpectSuccess(this->Isolines);
}

TEST_F(IsolineOutputs, BandsAreRings)
{
  this->Isolines->GenerateBandsOn();
  this->Isolines->SetChordTolerance(1e-5);
  ExpectSuccess(this->Isolines);
  vtkPolyData* bands = this->Isolines->GetBands();
  vtkDataArray* numbers = bands->GetCellData()->GetArray("Band");
  vtkDataArray* lower = bands->GetCellData()->GetArray("BandMinimum");
  vtkDataArray* upper = bands->GetCellData()->GetArray("BandMaximum");
  vtkDataArray* distances = bands->GetPointData()->GetArray("GeodesicDistance");
  ASSERT_TRUE(numbers && lower && upper && distances);
  double areas[4] = { 0.0, 0.0, 0.0, 0.0 };
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < bands->GetNumberOfCells(); ++i)
  {
    const int band = static_cast<int>(numbers->GetComponent(i, 0));
    ASSERT_GE(band, 0);
    ASSERT_LE(band, 3);
    areas[band] += GetArea(bands, i);
    bands->GetCellPoints(i, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const double d = distances->GetComponent(ids->GetId(k), 0);
      EXPECT_GE(d, lower->GetComponent(i, 0));
      EXPECT_LE(d, upper->GetComponent(i, 0));
    }
  }
  EXPECT_NEAR(areas[1], 2.0 * vtkMath::Pi() * (1.0 - 0.25), 1e-3);
  EXPECT_NEAR(areas[0] + areas[1] + areas[2] + areas[3], 64.0, 1e-10);
}
