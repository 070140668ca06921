// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkHarmonicBSpline with values given at sites, and with order Biharmonic.
#include "SpectralTestTools.h"

#include "vtkHarmonicBSpline.h"

#include "vtkSMPTools.h"

using namespace dggtest;

namespace
{
constexpr const char* Result = "Interpolation";

/// Returns a smooth function with values from 0 to about 3.
double Truth(const double p[3])
{
  return 1.5 + std::sin(2.0 * p[0]) + 0.5 * p[1] * p[2];
}

void AddValues(vtkPolyData* data, const std::string& name,
  const std::function<std::vector<double>(vtkIdType)>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(values(0).size()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    array->InsertNextTuple(values(i).data());
  }
  data->GetPointData()->AddArray(array);
}

void AddTruth(vtkPolyData* data)
{
  AddValues(data, "v", [data](vtkIdType i) {
    double p[3];
    data->GetPoint(i, p);
    return std::vector<double>{ Truth(p), 7.0 };
  });
}

class BiharmonicBSpline : public ::testing::Test
{
protected:
  void SetUp() override
  {
    AddTruth(this->Surface);
    this->Filter->SetInputData(this->Surface);
    this->Filter->SetOrderToBiharmonic();
    this->Filter->SetSiteValuesArrayName("v");
  }
  std::vector<double> Values(int component = 0, int port = 0)
  {
    return GetValues(this->Filter->GetOutput(port), Result, component);
  }
  std::vector<double> Basis(int site)
  {
    return GetValues(this->Filter->GetOutput(), "HarmonicBSpline", site);
  }
  vtkSmartPointer<vtkPolyData> Surface = MakeSphere(3);
  vtkNew<vtkHarmonicBSpline> Filter;
};
}

TEST_F(BiharmonicBSpline, ChosenSitesTakeTheValuesOfTheSurface)
{
  this->Filter->SetNumberOfSites(160);
  ExpectSuccess(this->Filter);
  ASSERT_EQ(this->Filter->GetNumberOfUsedSites(), 160);
  for (vtkIdType k = 0; k < 160; ++k)
  {
    const vtkIdType site = this->Filter->GetUsedSite(k);
    EXPECT_NEAR(this->Values()[site], Truth(this->Surface->GetPoint(site)), 1e-9);
    EXPECT_NEAR(this->Basis(static_cast<int>(k))[site], 1.0, 1e-9);
  }
  for (const double value : this->Values(1))
  {
    EXPECT_EQ(value, 7.0);
  }
  vtkPointData* data = this->Filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetScalars(), data->GetArray("HarmonicBSpline"));
  EXPECT_FALSE(data->HasArray("Cell"));
  this->Filter->SetOrderToHarmonic();
  ExpectSuccess(this->Filter);
  EXPECT_TRUE(this->Filter->GetOutput()->GetPointData()->HasArray("Cell"));
}

TEST_F(BiharmonicBSpline, SitesAnywhere)
{
  auto places = MakeSourcePoints({ PointInCell(this->Surface, 70, { { 0.1, 0.15, 0.75 } }),
    PointInCell(this->Surface, 700, { { 0.3, 0.3, 0.4 } }),
    PointInCell(this->Surface, 1100, { { 0.5, 0.5, 0.0 } }) });
  AddValues(places, "v", [](vtkIdType i) { return std::vector<double>{ 2.0 * i, -1.0 }; });
  this->Filter->SetSourceIds({ 300, 9 });
  this->Filter->SetSourceData(places);
  this->Filter->SetEvaluationData(places);
  ExpectSuccess(this->Filter);
  ASSERT_EQ(this->Filter->GetNumberOfUsedSites(), 5);
  EXPECT_EQ(this->Filter->GetUsedSite(1), 9);
  EXPECT_EQ(this->Filter->GetUsedSite(2), -1);
  const std::vector<double> there = this->Values(0, 1);
  ASSERT_EQ(there.size(), 3u);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(there[i], 2.0 * i, 1e-9);
    EXPECT_NEAR(GetValues(this->Filter->GetEvaluation(), "HarmonicBSpline", 2 + i)[i], 1.0, 1e-9);
  }
  EXPECT_NEAR(this->Values()[300], Truth(this->Surface->GetPoint(300)), 1e-9);
  EXPECT_NEAR(this->Values(1)[300], 7.0, 1e-9);
  // With source points only, the surface needs no such array.
  this->Surface->GetPointData()->RemoveArray("v");
  this->Filter->SetSourceIds({});
  ExpectSuccess(this->Filter);
  EXPECT_NEAR(this->Values(0, 1)[2], 4.0, 1e-9);
}

TEST_F(BiharmonicBSpline, WithoutTheBasis)
{
  this->Filter->SetNumberOfSites(30);
  ExpectSuccess(this->Filter);
  const std::vector<double> expected = this->Values();
  this->Filter->GenerateBasisOff();
  for (const bool isBiharmonic : { true, false })
  {
    this->Filter->SetOrder(
      isBiharmonic ? vtkHarmonicBSpline::Biharmonic : vtkHarmonicBSpline::Harmonic);
    ExpectSuccess(this->Filter);
    vtkPointData* data = this->Filter->GetOutput()->GetPointData();
    EXPECT_FALSE(data->HasArray("HarmonicBSpline"));
    EXPECT_EQ(data->GetScalars(), data->GetArray(Result));
    EXPECT_EQ(data->GetArray(Result)->GetNumberOfComponents(), 2);
    EXPECT_EQ(this->Values() == expected, isBiharmonic);
  }
  this->Filter->SetInputData(vtkNew<vtkPolyData>());
  ExpectWarning(this->Filter, { "empty" });
  EXPECT_FALSE(this->Filter->GetOutput()->GetPointData()->HasArray("HarmonicBSpline"));
  EXPECT_TRUE(this->Filter->GetOutput()->GetPointData()->HasArray(Result));
}

TEST_F(BiharmonicBSpline, ManyComponentsCountInMemory)
{
  // 2000 components take 20 MB as functions and in the array.
  this->Filter->SetNumberOfSites(10);
  this->Filter->GenerateBasisOff();
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(
    this->Filter->GetMemorySize() + 15000000 + 300000 * vtkSMPTools::GetEstimatedNumberOfThreads());
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  AddValues(this->Surface, "v",
    [](vtkIdType i) { return std::vector<double>(2000, i % 3 == 0 ? 1.0 : 2.0); });
  ExpectError(this->Filter, { "MemoryLimit" });
}
