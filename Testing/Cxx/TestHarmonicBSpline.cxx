// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkHarmonicBSpline: sites, cells, functions, Poisson equations, wrong input.
#include "SpectralTestTools.h"

#include "vtkHarmonicBSpline.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <sstream>
#include <string>

using namespace dggtest;

namespace
{
constexpr const char* Name = "HarmonicBSpline";
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

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

/// The spherical harmonic x z, which is 6 times its negative Laplacian.
double Harmonic(vtkPolyData* sphere, vtkIdType i)
{
  const double* p = sphere->GetPoint(i);
  return p[0] * p[2];
}

/// Relative L2 error of a solution on the unit sphere.
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
  /// A correct call works afterwards, as if nothing had happened.
  void ExpectUnharmed()
  {
    this->Filter->RemoveAllSources();
    this->Filter->SetSourceIds({ 45, 200, 321 });
    this->Filter->SetRightHandSideArrayName(nullptr);
    this->Filter->SetBoundaryToNeumann();
    this->Filter->SetInputData(this->Surface);
    ExpectSuccess(this->Filter);
    const std::vector<double> values = this->Values(1);
    this->Expected = this->Expected.empty() ? values : this->Expected;
    EXPECT_EQ(values, this->Expected);
  }

  vtkSmartPointer<vtkPolyData> Surface = MakeTerrain(20);
  vtkNew<vtkHarmonicBSpline> Filter;
  std::vector<double> Expected;
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
  // Fewer than one are one, more than points are points.
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
  double previous = 0.0;
  for (const int count : { 30, 120, 480 })
  {
    this->Filter->SetNumberOfSites(count);
    ExpectSuccess(this->Filter);
    const double error = ErrorOnSphere(sphere, this->Solution());
    if (count > 30)
    {
      EXPECT_GT(std::log2(previous / error), 1.7) << count;
    }
    previous = error;
  }
  EXPECT_LT(previous, 0.015);
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

TEST_F(HarmonicBSpline, ComponentsDoNotKnowOfEachOther)
{
  auto pair = MakePair(MakeSphere(2), MakeTerrain(12), 5.0);
  const vtkIdType alone = pair->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  this->Filter->SetInputData(pair);
  this->Filter->SetNumberOfSites(3);
  ExpectSuccess(this->Filter);
  this->Filter->SetNumberOfSites(1); // one in each
  ExpectWarning(this->Filter, { "2 components, each with a single site", "SetNumberOfSites()" });
  ASSERT_EQ(this->Filter->GetNumberOfUsedSites(), 2);
  for (vtkIdType i = 0; i < pair->GetNumberOfPoints(); ++i)
  {
    const vtkIdType part = i < 162 ? 0 : 1;
    EXPECT_EQ(this->CellOf(i), i == alone ? -1 : part);
    for (int site = 0; site < 2; ++site)
    {
      EXPECT_NEAR(this->Values(site)[i], i != alone && site == part ? 1.0 : 0.0, 1e-12);
    }
  }
  this->Filter->SetSourceIds({ 0, 1 });
  ExpectError(this->Filter, { "vertex 162", "no site" });
  this->Filter->SetSourceIds({ 0, 200, alone });
  ExpectError(this->Filter, { "site 2", "no face" });
  this->ExpectUnharmed();
}

TEST_F(HarmonicBSpline, DirichletBoundary)
{
  auto grid = MakeTerrain(24);
  const auto isOnRim = [](vtkIdType i) {
    return std::min(i / 24, i % 24) == 0 || std::max(i / 24, i % 24) == 23;
  };
  AddArray(grid, "f", [](vtkIdType) { return 1.0; });
  // What sources on the boundary are does not matter.
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
  this->ExpectUnharmed();
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
  // A thousandth is what integrals of densities may be off.
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

TEST_F(HarmonicBSpline, NonManifoldEdgesConduct)
{
  // Three sheets that are the same, with a site on each, and two on the edge that they share.
  auto book = MakeSurface({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 },
                            { -1, 1, 0 }, { 0, 0, 1 }, { 0, 1, 1 } },
    { { 0, 2, 3 }, { 0, 3, 1 }, { 0, 4, 5 }, { 0, 5, 1 }, { 0, 6, 7 }, { 0, 7, 1 } });
  this->Filter->SetInputData(book);
  this->Filter->SetSourceIds({ 0, 1, 2, 4, 6 });
  ExpectWarning(this->Filter, { "edge" });
  for (const double sum : this->Sums())
  {
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
  for (const vtkIdType sheet : { 0, 1, 2 })
  {
    const std::vector<double> values = this->Values(2 + static_cast<int>(sheet));
    for (vtkIdType point = 2; point < 8; ++point)
    {
      const bool isOwn = point / 2 - 1 == sheet;
      EXPECT_NEAR(values[point], this->Values(2)[(isOwn ? 2 : 4) + point % 2], 1e-12) << point;
    }
  }
  EXPECT_GT(this->Values(2)[2], 0.5);
}

TEST_F(HarmonicBSpline, WrongInput)
{
  this->ExpectUnharmed();
  this->Filter->SetSourceIds({ 45, 200, 45 });
  ExpectError(this->Filter, { "site 2 (vertex 45)", "site 0" });
  this->ExpectUnharmed();
  this->Filter->AddSourceId(400);
  ExpectError(this->Filter, { "source id 400", "out of range" });
  this->ExpectUnharmed();
  this->Filter->SetRightHandSideArrayName("missing");
  ExpectError(this->Filter, { "no point array 'missing'", "SetRightHandSideArrayName()" });
  this->ExpectUnharmed();
  AddArray(this->Surface, "f", [](vtkIdType i) { return i == 7 ? NaN : 0.0; });
  this->Filter->SetRightHandSideArrayName("f");
  ExpectError(this->Filter, { "'f'", "point 7", "finite" });
  this->ExpectUnharmed();
  AddArray(this->Surface, "huge", [](vtkIdType i) { return i < 200 ? 1.7e308 : -1.7e308; });
  this->Filter->SetRightHandSideArrayName("huge");
  ExpectError(this->Filter, { "right-hand side", "1e290" });
  this->ExpectUnharmed();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(400);
  vectors->Fill(0.0);
  this->Surface->GetPointData()->AddArray(vectors);
  this->Filter->SetRightHandSideArrayName("v");
  ExpectError(this->Filter, { "3 components", "one number per point" });
  this->ExpectUnharmed();
  this->Filter->SetInputData(nullptr);
  ExpectError(this->Filter, { "no input" });
  vtkNew<vtkPolyData> none;
  this->Filter->SetInputData(none);
  ExpectWarning(this->Filter, { "empty" });
  this->ExpectUnharmed();
  // All points of a triangle are on its boundary.
  this->Filter->SetInputData(
    MakeSurface({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }));
  this->Filter->RemoveAllSources();
  this->Filter->SetBoundaryToDirichlet();
  ExpectError(this->Filter, { "no place for a site", "Neumann" });
  this->ExpectUnharmed();
  this->Filter->SetMemoryLimit(this->Filter->GetMemorySize() + 1000000);
  ExpectSuccess(this->Filter);
  this->Filter->RemoveAllSources();
  this->Filter->SetNumberOfSites(400);
  ExpectError(this->Filter, { "MemoryLimit", "fewer sources" });
  std::ostringstream os;
  this->Filter->Print(os);
  EXPECT_NE(os.str().find("NumberOfSites: 400"), std::string::npos);
}

TEST_F(HarmonicBSpline, ProgressGrowsAndStops)
{
  this->Filter->SetNumberOfSites(80);
  ExpectProgressAndStops(this->Filter, { 0.05, 0.4, 0.7 }, [this] { return this->Values(30); });
}

TEST_F(HarmonicBSpline, CoincidentPointsMayBeOne)
{
  // The same grid twice, point by point: with merging, sources of both count.
  auto whole = MakeGrid(6, 6);
  const vtkIdType n = whole->GetNumberOfPoints();
  AddArray(whole, "b", [&](vtkIdType i) { return i == 0 ? 2.0 : (i == n - 1 ? -2.0 : 0.0); });
  this->Filter->SetInputData(whole);
  this->Filter->SetRightHandSideArrayName("b");
  this->Filter->SetRightHandSideMeaningToIntegrated();
  this->Filter->SetNumberOfSites(1000);
  ExpectSuccess(this->Filter);
  const std::vector<double> expected = this->Solution();
  auto doubled = MakePair(MakeGrid(6, 6), MakeGrid(6, 6), 0.0);
  AddArray(
    doubled, "b", [&](vtkIdType i) { return i % n == 0 ? 1.0 : (i % n == n - 1 ? -1.0 : 0.0); });
  this->Filter->SetInputData(doubled);
  this->Filter->MergeCoincidentPointsOn();
  ExpectWarning(this->Filter, { "triangles on the same three points as an earlier one" });
  const std::vector<double> values = this->Solution();
  for (vtkIdType i = 0; i < 2 * n; ++i)
  {
    EXPECT_NEAR(values[i], expected[i % n], 1e-9); // each triangle counts once
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
  this->Filter->SetCellArrayName("Heat");
  ExpectError(this->Filter, { "'Heat'", "different" });
  EXPECT_EQ(this->Filter->GetNumberOfUsedSites(), 0); // not those of the update before
  this->Filter->SetCellArrayName("Cell");
  for (const char* name : { "Cell", "Heat" })
  {
    this->Filter->SetResultArrayName(name);
    ExpectError(this->Filter, { "ResultArrayName", "different" });
  }
  this->Filter->SetResultArrayName(Name);
  this->Filter->SetSolutionArrayName("");
  ExpectError(this->Filter, { "SolutionArrayName is empty" });
  this->Filter->SetSolutionArrayName("Heat");
  this->Filter->SetCellArrayName("");
  ExpectError(this->Filter, { "CellArrayName", "is empty", "SetCellArrayName()" });
  this->Filter->SetCellArrayName("Cell");
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfUsedSites(), 20);
  this->Filter->SetRightHandSideArrayName("missing");
  ExpectError(this->Filter, { "no point array" });
  EXPECT_EQ(this->Filter->GetNumberOfUsedSites(), 0);
  this->ExpectUnharmed();
}

TEST_F(HarmonicBSpline, EmptyOutputsHaveAllArrays)
{
  vtkNew<vtkPolyData> none;
  this->Filter->SetInputData(none);
  this->Filter->SetCellArrayName("Site");
  this->Filter->SetSolutionArrayName("Heat");
  this->Filter->SetResultArrayName("Basis");
  for (const char* source : { "f", "" }) // without one there is no solution
  {
    this->Filter->SetRightHandSideArrayName(source);
    ExpectWarning(this->Filter, { "empty" });
    const bool hasSolution = *source != '\0';
    for (int port = 0; port < 2; ++port)
    {
      vtkPointData* data = this->Filter->GetOutput(port)->GetPointData();
      EXPECT_EQ(data->GetNumberOfArrays(), hasSolution ? 3 : 2);
      EXPECT_NE(vtkIdTypeArray::SafeDownCast(data->GetArray("Site")), nullptr);
      EXPECT_NE(vtkDoubleArray::SafeDownCast(data->GetArray("Basis")), nullptr);
      EXPECT_EQ(vtkDoubleArray::SafeDownCast(data->GetArray("Heat")) != nullptr, hasSolution);
    }
  }
}
