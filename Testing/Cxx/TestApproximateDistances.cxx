// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Heat method, fast marching and virtual sources: the contract of all distance filters, and the
/// warnings and statistics of each method.
#include "FilterTestTools.h"
#include "GraphTestTools.h"
#include "SpectralTestTools.h"
#include "TestMeshes.h"

#include "vtkDGGFastMarchingDistance.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkHeatGeodesicDistance.h"
#include "vtkVirtualSourceGeodesicDistance.h"

#include "dggStatus.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace dggtest;

template <typename Filter>
class ApproximateDistances : public ::testing::Test
{
protected:
  vtkNew<Filter> Distance;
};
using Filters = ::testing::Types<vtkDGGFastMarchingDistance, vtkHeatGeodesicDistance,
  vtkVirtualSourceGeodesicDistance>;
TYPED_TEST_SUITE(ApproximateDistances, Filters);

/// Filters that are not suitable for long triangles.
template <typename Filter>
class QualityWarnings : public ApproximateDistances<Filter>
{
};
TYPED_TEST_SUITE(QualityWarnings, Filters);

TYPED_TEST(QualityWarnings, WarnOfLongTrianglesOnceForEachMesh)
{
  auto* filter = this->Distance.Get();
  filter->AddSourceId(0);
  EXPECT_FALSE(filter->GetQualityWarning());
  for (const double stretch : { 1.0, 10.0, 2.0 })
  {
    auto grid = MakeGrid(12, 12);
    MovePoints(grid, [&](double* p) {
      p[0] *= stretch;
      p[2] = 0.0;
    });
    // A single sliver does not cause a warning.
    const vtkIdType corners[] = { 0, 1, grid->GetNumberOfPoints() };
    grid->GetPoints()->InsertNextPoint(0.5 * stretch, -1e-4, 0.0);
    grid->GetPolys()->InsertNextCell(3, corners);
    filter->SetInputData(grid);
    if (stretch == 10.0)
    {
      ExpectWarning(filter, { "covered by long triangles", "exact distances" });
      filter->SetSourceIds({ 3 });
    }
    ExpectSuccess(filter);
    EXPECT_EQ(filter->GetQualityWarning(), stretch == 10.0);
    EXPECT_EQ(filter->GetMeanAnisotropy() > 2.0, stretch == 10.0);
  }
}

/// On this plate the median of the anisotropy is small, but propagated distances are too short by
/// 45 %.
TYPED_TEST(QualityWarnings, WarnOfLongTrianglesThatAreFewer)
{
  auto* filter = this->Distance.Get();
  filter->SetInputData(MakePlateWithHole());
  filter->AddSourceId(4);
  ExpectWarning(filter, { "covered by long triangles", "more than 2" });
  EXPECT_LT(GetReported(filter, "MedianAnisotropy"), 1.4);
}

TYPED_TEST(QualityWarnings, NoneOnOrdinaryMeshes)
{
  auto* filter = this->Distance.Get();
  auto sphere = MakeSphere(2);
  auto speck = MakeGrid(1, 1);
  for (const vtkSmartPointer<vtkPolyData>& surface : { MakeGrid(6, 6), MakeGrid(40, 3),
         MakeTerrain(20), MakeTerrain(40), sphere, MakeSphere(3), Beside(sphere, speck, 4.0) })
  {
    SCOPED_TRACE(surface->GetNumberOfPoints());
    filter->SetInputData(surface);
    filter->SetSourceIds({ 9 });
    ExpectSuccess(filter);
    EXPECT_FALSE(filter->GetQualityWarning());
  }
}

TEST(VirtualSourceGeodesicDistance, Quality)
{
  using Type = vtkVirtualSourceGeodesicDistance;
  vtkNew<Type> filter;
  EXPECT_EQ(filter->GetQuality(), Type::Automatic);
  auto terrain = MakeTerrain(40);
  filter->SetInputData(terrain);
  filter->AddSourceId(820);
  ExpectSuccess(filter);
  const auto automatic = GetDistances(filter);
  filter->SetQualityToFast();
  ExpectSuccess(filter);
  const auto fast = GetDistances(filter);
  EXPECT_EQ(fast, automatic);
  filter->SetQualityToHigh();
  EXPECT_STREQ(filter->GetQualityAsString(), "High");
  ExpectSuccess(filter);
  const auto high = GetDistances(filter);
  const auto exact = GetExactDistances(terrain, std::vector<vtkIdType>{ 820 });
  EXPECT_LT(GetMeanError(fast, exact), 0.004);
  EXPECT_LT(GetMeanError(high, exact), 0.003);
  EXPECT_NE(fast, high);
  // On a mesh of mostly long triangles, the default is more accurate.
  MovePoints(terrain, [&](double* p) { p[0] *= 10.0; });
  ExpectWarning(filter, { "long triangles" });
  const auto best = GetDistances(filter);
  filter->SetQualityToAutomatic();
  ExpectSuccess(filter);
  EXPECT_GT(GetReported(filter, "MedianAnisotropy"), 3.0);
  EXPECT_EQ(GetDistances(filter), best);
}

TEST(VirtualSourceGeodesicDistance, NotShorterThanTheStraightLine)
{
  auto shaft = MakeSurface(Shaft(100));
  for (const std::vector<vtkIdType>& sources :
    { std::vector<vtkIdType>{ 250 }, std::vector<vtkIdType>{ 250, 30 } })
  {
    vtkNew<vtkVirtualSourceGeodesicDistance> filter;
    filter->SetInputData(shaft);
    filter->SetSourceIds(sources);
    ExpectWarning(filter, { "long triangles" });
    const auto distances = GetDistances(filter);
    filter->GenerateNearestSourceOn();
    ExpectSuccess(filter);
    EXPECT_EQ(GetDistances(filter), distances);
    for (vtkIdType i = 0; i < shaft->GetNumberOfPoints(); ++i)
    {
      double straight = std::numeric_limits<double>::infinity();
      for (const vtkIdType source : sources)
      {
        const double* p = shaft->GetPoint(source);
        const std::array<double, 3> place{ { p[0], p[1], p[2] } };
        straight = std::min(
          straight, std::sqrt(vtkMath::Distance2BetweenPoints(place.data(), shaft->GetPoint(i))));
      }
      EXPECT_GE(distances[i], (1.0 - 1e-12) * straight) << i;
    }
  }
}

/// The initial distances differ by more than single precision can represent.
TEST(VirtualSourceGeodesicDistance, InitialDistancesTooFarApart)
{
  vtkNew<vtkVirtualSourceGeodesicDistance> filter;
  filter->SetInputData(MakeGrid(8, 8));
  filter->SetSourceIds({ 0, 5 }, { 0.0, 1e31 });
  ExpectError(filter, { "source 1", "1e30" });
  filter->SetSourceIds({ 0, 5 }, { 1e31, 1e31 });
  ExpectSuccess(filter);
}

/// An extruded disk of a thousand corners, whose needles exceed single precision.
TEST(VirtualSourceGeodesicDistance, EndsWhereDistancesDoNotSettle)
{
  constexpr vtkIdType n = 1000;
  Points points;
  Cells cells;
  for (vtkIdType i = 0; i < 2 * n; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * static_cast<double>(i) / n;
    points.push_back({ { std::cos(angle), std::sin(angle), i < n ? 0.0 : 1e-4 } });
  }
  for (vtkIdType i = 0; i < n; ++i)
  {
    cells.push_back({ i, (i + 1) % n, (i + 1) % n + n, i + n });
  }
  for (vtkIdType first = 0, last = n - 1; last - first > 1;)
  {
    const vtkIdType middle = (first + last) % 2 == 1 ? first + 1 : last - 1;
    cells.push_back({ first, last, middle });
    cells.push_back({ first + n, middle + n, last + n });
    (middle < (first + last) / 2 ? first : last) = middle;
  }
  auto disc = MakeSurface(points, cells);
  vtkNew<vtkVirtualSourceGeodesicDistance> filter;
  filter->SetInputData(disc);
  filter->SetQualityToFast();
  filter->SetSourceIds({ 250 });
  ExpectWarning(filter, { "long triangles", "did not settle", "exact distances" });
  const auto exact = GetExactDistances(disc, std::vector<vtkIdType>{ 250 });
  EXPECT_LT(GetMeanError(GetDistances(filter), exact), 0.1);
}

TEST(FastMarchingGeodesicDistance, FrontShape)
{
  vtkNew<vtkDGGFastMarchingDistance> filter;
  EXPECT_EQ(filter->GetFrontShape(), vtkDGGFastMarchingDistance::Spherical);
  auto terrain = MakeTerrain(40);
  filter->SetInputData(terrain);
  filter->AddSourceId(820);
  ExpectSuccess(filter);
  const auto exact = GetExactDistances(terrain, std::vector<vtkIdType>{ 820 });
  const double spherical = GetMeanError(GetDistances(filter), exact);
  filter->SetFrontShapeToPlanar();
  EXPECT_STREQ(filter->GetFrontShapeAsString(), "Planar");
  ExpectSuccess(filter);
  const double planar = GetMeanError(GetDistances(filter), exact);
  EXPECT_LT(spherical, 0.01);
  EXPECT_LT(planar, 0.06);
  EXPECT_LT(2.0 * spherical, planar);
  filter->SetFrontShape(77);
  EXPECT_EQ(filter->GetFrontShape(), vtkDGGFastMarchingDistance::Planar);
}

TEST(HeatGeodesicDistance, PropertiesAndFactorizations)
{
  vtkNew<vtkHeatGeodesicDistance> filter;
  EXPECT_EQ(filter->GetMemorySize(), 0u);
  auto terrain = MakeTerrain(30);
  filter->SetInputData(terrain);
  filter->AddSourceId(40);
  int expected = 0;
  const auto expectWork = [&](int factorizations, const char* what) {
    ExpectSuccess(filter);
    expected += factorizations;
    EXPECT_EQ(filter->GetNumberOfFactorizations(), expected) << what;
  };
  expectWork(2, "first");
  EXPECT_GT(filter->GetMemorySize(), 100000u);
  filter->SetSourceIds({ 100, 200 });
  expectWork(0, "sources");
  filter->SetMaximumDistance(0.3);
  expectWork(0, "maximum distance");
  filter->SetMaximumDistance(VTK_DOUBLE_MAX);
  filter->SetTimeStepFactor(4.0);
  expectWork(1, "time");
  filter->SetBoundaryToAverage();
  EXPECT_STREQ(filter->GetBoundaryAsString(), "Average");
  expectWork(1, "boundary");
  filter->IntrinsicDelaunayOff();
  expectWork(3, "triangles");
  terrain->GetPoints()->SetPoint(5, 0.2, 0.0, 0.0);
  terrain->GetPoints()->Modified();
  expectWork(3, "points");
}

/// The warning is given once for each mesh, component and factor.
TEST(HeatGeodesicDistance, WarnsWhereItIsFarOff)
{
  vtkNew<vtkHeatGeodesicDistance> filter;
  filter->SetInputData(MakeGrid(1, 1)); // two triangles
  filter->AddSourceId(0);
  ExpectWarning(filter, { "component of 2 triangles", "fewer than 50", "exact distances" });
  EXPECT_NEAR(GetDistances(filter)[1], 1.0 - 0.293, 1e-3);
  EXPECT_TRUE(filter->GetQualityWarning());
  filter->SetSourceIds({ 2 });
  ExpectSuccess(filter);
  EXPECT_TRUE(filter->GetQualityWarning());
  // A source at a point without triangles.
  auto isolated = MakeGrid(3, 3);
  filter->SetSourceIds({ isolated->GetPoints()->InsertNextPoint(5.0, 0.0, 0.0) });
  filter->SetInputData(isolated);
  ExpectWarning(filter, { "no polygon" });
  EXPECT_FALSE(filter->GetQualityWarning());
  // A component of five triangles next to a large component.
  auto surface = MakeTerrain(20);
  const vtkIdType large = surface->GetNumberOfPoints();
  Points points;
  Cells cells;
  for (vtkIdType i = 0; i < 7; ++i)
  {
    points.push_back({ { 0.5 * static_cast<double>(i), i % 2 * 0.9, 0.0 } });
    if (i > 1)
    {
      cells.push_back({ i - 2, i - 1, i });
    }
  }
  filter->SetInputData(Beside(surface, MakeSurface(points, cells), 5.0));
  filter->SetSourceIds({ 0, large });
  ExpectWarning(filter, { "component of 5 triangles" });
  filter->SetSourceIds({ large / 2 });
  ExpectSuccess(filter);
  EXPECT_FALSE(filter->GetQualityWarning());
  for (const double factor : { 1e-2, 1e-6, 1e6 })
  {
    filter->SetTimeStepFactor(factor);
    ExpectWarning(filter, { dgg::JoinText("TimeStepFactor is ", factor), "0.1 to 100" });
    EXPECT_TRUE(filter->GetQualityWarning());
  }
  filter->SetTimeStepFactor(1e-2); // the same warning was given above
  ExpectSuccess(filter);
  EXPECT_TRUE(filter->GetQualityWarning());
  for (const double factor : { 0.1, 1.0, 100.0 })
  {
    filter->SetTimeStepFactor(factor);
    ExpectSuccess(filter);
    EXPECT_FALSE(filter->GetQualityWarning());
  }
}

TEST(HeatGeodesicDistance, NoMemoryIsHeldWithoutFactorizations)
{
  vtkNew<vtkHeatGeodesicDistance> filter;
  filter->SetInputData(MakeTerrain(20));
  filter->AddSourceId(60);
  filter->SetMemoryLimit(1000);
  ExpectError(filter, { "MemoryLimit", "heat" });
  EXPECT_EQ(filter->GetNumberOfFactorizations(), 0);
  EXPECT_EQ(filter->GetMemorySize(), 0u);
  filter->SetMemoryLimit(0);
  ExpectSuccess(filter);
  EXPECT_EQ(filter->GetNumberOfFactorizations(), 2);
  const vtkTypeUInt64 size = filter->GetMemorySize();
  EXPECT_GT(size, 0u);
  // Existing factorizations are kept and do not count toward the limit.
  filter->SetMemoryLimit(1000);
  filter->SetSourceIds({ 70 });
  ExpectSuccess(filter); // no new factorization is needed
  filter->SetBoundaryToAverage();
  ExpectError(filter, { "MemoryLimit", "heat" });
  EXPECT_GE(filter->GetMemorySize(), size);
}
