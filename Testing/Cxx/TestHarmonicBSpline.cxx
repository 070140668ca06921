// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkHarmonicBSpline: sites, cells, functions, Poisson equations.
#include "SpectralTestTools.h"

#include "vtkHarmonicBSpline.h"

using namespace dggtest;

namespace
{
constexpr const char* Name = "HarmonicBSpline";

void AddArray(vtkPolyData* surface, const char* name, const std::function<double(vtkIdType)>& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(value(i));
  }
  surface->GetPointData()->AddArray(array);
}

class HarmonicBSpline : public ::testing::Test
{
protected:
  void SetUp() override { this->Filter->SetInputData(this->Surface); }
  std::vector<double> Values(int site, int port = 0)
  {
    return GetValues(this->Filter->GetOutput(port), Name, site);
  }
  std::vector<double> Solution(int port = 0)
  {
    return GetValues(this->Filter->GetOutput(port), "PoissonSolution");
  }
  vtkIdType CellOf(vtkIdType point, int port = 0)
  {
    return vtkIdTypeArray::SafeDownCast(
      this->Filter->GetOutput(port)->GetPointData()->GetArray("Cell"))
      ->GetValue(point);
  }
  vtkSmartPointer<vtkPolyData> Surface = MakeTerrain(20);
  vtkNew<vtkHarmonicBSpline> Filter;
};
}

TEST_F(HarmonicBSpline, SitesAreChosen)
{
  ExpectSuccess(this->Filter);
  ASSERT_EQ(this->Filter->GetNumberOfUsedSites(), 20);
  vtkDataArray* array = this->Filter->GetOutput()->GetPointData()->GetArray(Name);
  EXPECT_EQ(array->GetNumberOfComponents(), 20);
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetScalars(), array);
  std::set<vtkIdType> sites;
  for (vtkIdType site = 0; site < 20; ++site)
  {
    sites.insert(this->Filter->GetUsedSite(site));
    EXPECT_EQ(this->CellOf(this->Filter->GetUsedSite(site)), site);
  }
  EXPECT_EQ(sites.size(), 20u);
  EXPECT_EQ(this->Filter->GetUsedSite(20), -1);
  EXPECT_FALSE(this->Filter->GetOutput()->GetPointData()->HasArray("PoissonSolution"));
  // The number of sites is clamped to the range from 1 to the number of points.
  this->Filter->SetNumberOfSites(-4);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfUsedSites(), 1);
  for (const double value : this->Values(0))
  {
    EXPECT_NEAR(value, 1.0, 1e-12);
  }
  this->Filter->SetNumberOfSites(100000);
  ExpectSuccess(this->Filter);
  ASSERT_EQ(this->Filter->GetNumberOfUsedSites(), 400);
  for (const int site : { 0, 17, 399 })
  {
    const std::vector<double> values = this->Values(site);
    for (vtkIdType i = 0; i < 400; ++i)
    {
      EXPECT_NEAR(values[i], i == this->Filter->GetUsedSite(site) ? 1.0 : 0.0, 1e-9);
    }
  }
  EXPECT_EQ(this->Filter->GetNumberOfFactorizations(), 1);
}

TEST_F(HarmonicBSpline, SitesMoveToCorners)
{
  this->Filter->SetSourceIds({ 300 });
  double corners[3][3];
  vtkIdType ids[3];
  for (int k = 0; k < 3; ++k)
  {
    ids[k] = this->Surface->GetCell(70)->GetPointId(k);
    this->Surface->GetPoint(ids[k], corners[k]);
  }
  this->Filter->SetSourceData(
    MakeSourcePoints({ PointInCell(this->Surface, 70, { 0.1, 0.15, 0.75 }) }));
  ExpectSuccess(this->Filter);
  ASSERT_EQ(this->Filter->GetNumberOfUsedSites(), 2);
  EXPECT_EQ(this->Filter->GetUsedSite(0), 300);
  EXPECT_EQ(this->Filter->GetUsedSite(1), ids[2]);
  EXPECT_EQ(this->CellOf(ids[2]), 1);
}

TEST_F(HarmonicBSpline, EvaluationPoints)
{
  AddArray(this->Surface, "f", [](vtkIdType i) { return i % 20 - 9.5; });
  this->Filter->SetRightHandSideArrayName("f");
  this->Filter->SetRightHandSideMeaningToIntegrated();
  this->Filter->SetNumberOfSites(10);
  double place[3];
  this->Surface->GetPoint(33, place);
  this->Filter->SetEvaluationData(MakeSourcePoints(
    { { place[0], place[1], place[2] }, PointInCell(this->Surface, 70, { 0.2, 0.3, 0.5 }) }));
  ExpectSuccess(this->Filter);
  vtkCell* cell = this->Surface->GetCell(70);
  EXPECT_EQ(this->CellOf(0, 1), this->CellOf(33));
  EXPECT_EQ(this->CellOf(1, 1), this->CellOf(cell->GetPointId(2)));
  EXPECT_NEAR(this->Solution(1)[0], this->Solution()[33], 1e-12);
  const std::vector<double> values = this->Values(3);
  const std::vector<double> linear = this->Values(3, 1);
  ASSERT_EQ(linear.size(), 2u);
  EXPECT_NEAR(linear[0], values[33], 1e-12);
  EXPECT_NEAR(linear[1],
    0.2 * values[cell->GetPointId(0)] + 0.3 * values[cell->GetPointId(1)] +
      0.5 * values[cell->GetPointId(2)],
    1e-9);
  this->Filter->SmoothEvaluationOn();
  ExpectSuccess(this->Filter);
  EXPECT_NE(this->Values(3, 1), linear);
  EXPECT_NEAR(this->Values(3, 1)[1], linear[1], 0.1);
}

TEST_F(HarmonicBSpline, SitesOnADirichletBoundaryAreRefused)
{
  this->Filter->SetBoundaryToDirichlet();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->CellOf(0), -1);
  this->Filter->SetSourceIds({ 3 });
  ExpectError(this->Filter, { "site 0", "boundary", "Neumann" });
}

TEST_F(HarmonicBSpline, UnbalancedSourcesAreBalanced)
{
  AddArray(this->Surface, "one", [](vtkIdType) { return 1.0; });
  this->Filter->SetRightHandSideArrayName("one");
  ExpectWarning(this->Filter, { "balanced", "sum 0" });
  for (const double value : this->Solution())
  {
    EXPECT_NEAR(value, 0.0, 1e-12);
  }
}

TEST_F(HarmonicBSpline, ArrayNames)
{
  AddArray(this->Surface, "f", [](vtkIdType i) { return i == 50 ? 1.0 : (i == 90 ? -1.0 : 0.0); });
  this->Filter->SetRightHandSideArrayName("f");
  this->Filter->SetRightHandSideMeaningToIntegrated();
  ExpectSuccess(this->Filter);
  const std::vector<double> expected = this->Solution();
  this->Filter->SetCellArrayName("Site");
  this->Filter->SetSolutionArrayName("Heat");
  ExpectSuccess(this->Filter);
  vtkPointData* data = this->Filter->GetOutput()->GetPointData();
  EXPECT_TRUE(data->HasArray("Site"));
  EXPECT_FALSE(data->HasArray("Cell"));
  EXPECT_FALSE(data->HasArray("PoissonSolution"));
  EXPECT_EQ(GetValues(this->Filter->GetOutput(), "Heat"), expected);
}
