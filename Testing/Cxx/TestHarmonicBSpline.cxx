// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkHarmonicBSpline: sites, cells, functions, Poisson equations.
#include "SpectralTestTools.h"

#include "vtkHarmonicBSpline.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

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

/// Returns the spherical harmonic x z, whose negative Laplacian is 6 times the function.
double Harmonic(vtkPolyData* sphere, vtkIdType i)
{
  const double* p = sphere->GetPoint(i);
  return p[0] * p[2];
}

/// Returns the relative L2 error of a solution on the unit sphere.
double ErrorOnSphere(vtkPolyData* sphere, const std::vector<double>& values)
{
  const std::vector<double> areas = GetPointAreas(sphere);
  double difference = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    const double truth = Harmonic(sphere, static_cast<vtkIdType>(i));
    difference += areas[i] * (values[i] - truth) * (values[i] - truth);
    size += areas[i] * truth * truth;
  }
  return std::sqrt(difference / size);
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
  std::vector<double> Sums(int port = 0)
  {
    std::vector<double> sums(this->Filter->GetOutput(port)->GetNumberOfPoints(), 0.0);
    for (vtkIdType site = 0; site < this->Filter->GetNumberOfUsedSites(); ++site)
    {
      const std::vector<double> values = this->Values(static_cast<int>(site), port);
      for (std::size_t i = 0; i < sums.size(); ++i)
      {
        sums[i] += values[i];
      }
    }
    return sums;
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
  for (const double sum : this->Sums())
  {
    EXPECT_NEAR(sum, 1.0, 1e-10);
  }
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

TEST_F(HarmonicBSpline, PoissonEquationOnTheSphere)
{
  auto sphere = MakeSphere(4);
  AddArray(sphere, "f", [&](vtkIdType i) { return 6.0 * Harmonic(sphere, i); });
  const std::vector<double> areas = GetPointAreas(sphere);
  AddArray(sphere, "b", [&](vtkIdType i) { return 6.0 * areas[i] * Harmonic(sphere, i); });
  this->Filter->SetInputData(sphere);
  this->Filter->SetRightHandSideArrayName("f");
  this->Filter->SetNumberOfSites(480);
  ExpectSuccess(this->Filter);
  EXPECT_LT(ErrorOnSphere(sphere, this->Solution()), 0.015);
  const std::vector<double> densities = this->Solution();
  this->Filter->SetRightHandSideArrayName("b");
  this->Filter->SetRightHandSideMeaningToIntegrated();
  ExpectSuccess(this->Filter);
  const std::vector<double> integrated = this->Solution();
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    EXPECT_NEAR(densities[i], integrated[i], 1e-12);
  }
}

TEST_F(HarmonicBSpline, EvaluationPoints)
{
  auto sphere = MakeSphere(3);
  AddArray(sphere, "f", [&](vtkIdType i) { return 6.0 * Harmonic(sphere, i); });
  this->Filter->SetInputData(sphere);
  this->Filter->SetRightHandSideArrayName("f");
  this->Filter->SetNumberOfSites(10);
  double place[3];
  sphere->GetPoint(33, place);
  this->Filter->SetEvaluationData(MakeSourcePoints({ { place[0], place[1], place[2] },
    PointInCell(sphere, 70, { 0.2, 0.3, 0.5 }), PointInCell(sphere, 400, { 0.0, 0.3, 0.7 }) }));
  ExpectSuccess(this->Filter);
  ASSERT_EQ(this->Values(0, 1).size(), 3u);
  EXPECT_EQ(this->CellOf(0, 1), this->CellOf(33));
  EXPECT_EQ(this->CellOf(1, 1), this->CellOf(sphere->GetCell(70)->GetPointId(2)));
  std::vector<std::vector<double>> linear;
  for (int site = 0; site < 10; ++site)
  {
    const std::vector<double> values = this->Values(site);
    linear.push_back(this->Values(site, 1));
    EXPECT_NEAR(linear.back()[0], values[33], 1e-12);
    double expected = 0.0;
    const double weights[] = { 0.2, 0.3, 0.5 };
    for (int k = 0; k < 3; ++k)
    {
      expected += weights[k] * values[sphere->GetCell(70)->GetPointId(k)];
    }
    EXPECT_NEAR(linear.back()[1], expected, 1e-9);
  }
  const std::vector<double> solution = this->Solution(1);
  EXPECT_NEAR(solution[0], this->Solution()[33], 1e-12);
  this->Filter->SmoothEvaluationOn();
  ExpectSuccess(this->Filter);
  bool isOther = false;
  for (int site = 0; site < 10; ++site)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(this->Values(site, 1)[k], linear[site][k], 0.02); // cells have 64 points
      isOther = isOther || std::abs(this->Values(site, 1)[k] - linear[site][k]) > 1e-3;
    }
  }
  EXPECT_TRUE(isOther);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(this->Sums(1)[k], 1.0, 1e-10);
    EXPECT_NEAR(this->Solution(1)[k], solution[k], 0.02);
  }
}

TEST_F(HarmonicBSpline, DirichletBoundary)
{
  auto grid = MakeTerrain(24);
  const auto isOnRim = [](vtkIdType i) {
    return std::min(i / 24, i % 24) == 0 || std::max(i / 24, i % 24) == 23;
  };
  AddArray(grid, "f", [](vtkIdType) { return 1.0; });
  // Source values on the boundary have no effect.
  AddArray(grid, "other", [&](vtkIdType i) { return isOnRim(i) ? 1e4 : 1.0; });
  this->Filter->SetInputData(grid);
  this->Filter->SetBoundaryToDirichlet();
  this->Filter->SetRightHandSideArrayName("f");
  this->Filter->SetNumberOfSites(100000);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfUsedSites(), 22 * 22);
  const std::vector<double> fine = this->Solution();
  this->Filter->SetNumberOfSites(80);
  ExpectSuccess(this->Filter);
  const std::vector<double> coarse = this->Solution();
  const double highest = *std::max_element(fine.begin(), fine.end());
  EXPECT_GT(highest, 0.0);
  for (vtkIdType i = 0; i < 24 * 24; ++i)
  {
    const bool onRim = isOnRim(i);
    EXPECT_EQ(this->CellOf(i) == -1, onRim);
    if (onRim)
    {
      EXPECT_EQ(fine[i], 0.0);
      EXPECT_EQ(coarse[i], 0.0);
      EXPECT_EQ(this->Values(3)[i], 0.0);
    }
    EXPECT_NEAR(coarse[i], fine[i], 0.02 * highest);
  }
  this->Filter->SetRightHandSideArrayName("other");
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Solution(), coarse);
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
  // Integrals of densities may deviate from 0 by a thousandth.
  AddArray(
    this->Surface, "few", [](vtkIdType i) { return i == 50 ? 1.001 : (i == 90 ? -1.0 : 0.0); });
  const std::vector<double> areas = GetPointAreas(this->Surface);
  AddArray(this->Surface, "even",
    [&](vtkIdType i) { return i == 50 ? 1.001 / areas[50] : (i == 90 ? -1.0 / areas[90] : 0.0); });
  this->Filter->SetRightHandSideArrayName("even");
  ExpectSuccess(this->Filter);
  const std::vector<double> expected = this->Solution();
  this->Filter->SetRightHandSideArrayName("few");
  this->Filter->SetRightHandSideMeaningToIntegrated();
  ExpectWarning(this->Filter, { "fraction of 0.0004997" });
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(this->Solution()[i], expected[i], 1e-12);
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
