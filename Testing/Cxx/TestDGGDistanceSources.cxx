// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances by a graph: several sources, where they start, and how they are linked.
#include "DGGDistanceFixture.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

using namespace dggtest;

TEST_F(DGGDistance, SeveralSourcesWithInitialDistances)
{
  auto sources =
    MakeSourcePoints({ { { 0.1, 0.2, 0.0 } }, { { 0.8, 0.7, 0.0 } }, { { 0.5, 0.1, 0.0 } } });
  vtkNew<vtkDoubleArray> offsets;
  offsets->SetName("InitialDistance");
  for (const double offset : { 0.2, -0.1, 0.0 })
  {
    offsets->InsertNextValue(offset);
  }
  sources->GetPointData()->AddArray(offsets);
  this->Filter->SetProjectionTolerance(1.0);
  this->Filter->SetSourceData(sources);
  this->Filter->SetAccuracy(0.02);
  this->Filter->GenerateNearestSourceOn();
  vtkNew<vtkExactGeodesicDistance> exactFilter;
  exactFilter->SetInputData(this->Terrain);
  exactFilter->SetSourceIds({ 40 });
  exactFilter->SetSourceData(sources);
  exactFilter->SetProjectionTolerance(1.0);
  exactFilter->GenerateNearestSourceOn();
  ExpectSuccess(exactFilter);
  const auto exact = GetDistances(exactFilter);
  const auto exactSources = GetNearestSources(exactFilter);
  for (const bool correct : { false, true })
  {
    this->Filter->SetCorrection(correct);
    ExpectSuccess(this->Filter);
    const auto distances = GetDistances(this->Filter);
    const auto nearest = GetNearestSources(this->Filter);
    ASSERT_EQ(nearest.size(), exact.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
      const double error = 0.020002 * (exact[i] + 0.1) + 1e-9; // the least offset is -0.1
      EXPECT_GE(distances[i], exact[i] - (correct ? error : 1e-9)) << i;
      EXPECT_LE(distances[i], exact[i] + error) << i;
      different += nearest[i] != exactSources[i] ? 1 : 0;
    }
    EXPECT_LT(different, exact.size() / 20); // ties within the error
    EXPECT_EQ(nearest[40], 0);
  }
}

TEST_F(DGGDistance, SourcesInSeveralComponents)
{
  auto surface = MakeSurface(
    { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 5, 0, 0 } }, { { 6, 0, 0 } },
      { { 5, 1, 0 } }, { { 9, 0, 0 } }, { { 9, 1, 0 } }, { { 8, 1, 0 } } },
    { { 0, 1, 2 }, { 3, 4, 5 }, { 6, 7, 8 } });
  this->Filter->SetInputData(surface);
  this->Filter->SetSourceIds({ 1, 3 });
  this->Filter->GenerateNearestSourceOn();
  this->Filter->GenerateUpperBoundOn();
  this->Filter->GenerateVirtualSourceOn();
  ExpectSuccess(this->Filter);
  const auto distances = GetDistances(this->Filter);
  EXPECT_NEAR(distances[2], std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(distances[5], 1.0, 1e-6);
  EXPECT_TRUE(std::isnan(distances[7]));
  EXPECT_EQ(GetNearestSources(this->Filter), (std::vector<int>{ 0, 0, 0, 1, 1, 1, -1, -1, -1 }));
  EXPECT_TRUE(std::isnan(GetComponent(this->Filter, "GeodesicUpperBound")[7]));
  EXPECT_TRUE(std::isnan(GetComponent(this->Filter, "GeodesicVirtualSource", 2)[7]));
  this->Filter->SetUnreachedValue(-2.0);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetDistances(this->Filter)[7], -2.0);
  EXPECT_EQ(GetComponent(this->Filter, "GeodesicUpperBound")[7], -2.0);
  EXPECT_EQ(GetComponent(this->Filter, "GeodesicVirtualSource", 1)[7], -2.0);
}

TEST_F(DGGDistance, InitialDistancesOfSourceIds)
{
  this->Filter->GenerateNearestSourceOn();
  this->Filter->SetSourceIds({ 40 });
  this->Filter->AddSourceId(500, -0.25);
  EXPECT_EQ(this->Filter->GetSourceInitialDistance(0), 0.0);
  EXPECT_EQ(this->Filter->GetSourceInitialDistance(1), -0.25);
  ExpectSuccess(this->Filter);
  const auto distances = GetDistances(this->Filter);
  const auto nearest = GetNearestSources(this->Filter);
  EXPECT_EQ(distances[500], -0.25);
  const auto first = GetExactDistances(this->Terrain, { 40 });
  const auto second = GetExactDistances(this->Terrain, { 500 });
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    const double exact = std::min(first[i], second[i] - 0.25);
    EXPECT_NEAR(distances[i], exact, 0.0100021 * (exact + 0.25)) << i;
  }
  EXPECT_EQ(nearest[500], 1);
  const vtkMTimeType before = this->Filter->GetMTime();
  this->Filter->SetSourceIds({ 40, 500 }, { 0.0, -0.25 });
  EXPECT_EQ(this->Filter->GetMTime(), before); // the same
  std::ostringstream os;
  this->Filter->Print(os);
  EXPECT_NE(os.str().find("SourceIds: 40 500 (from -0.25)\n"), std::string::npos) << os.str();

  this->Filter->SetSourceIds({ 40, 500 }, { 0.0, std::nan("") });
  ExpectError(this->Filter, { "source id 500 (number 1", "initial distance nan", "finite" });
  {
    const Listener listener(this->Filter);
    this->Filter->SetSourceIds({ 40, 500 }, { 0.0 });
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find("1 initial distances for 2 source ids"), std::string::npos);
  }
  EXPECT_EQ(this->Filter->GetNumberOfSourceIds(), 2);
  this->Filter->SetSourceIds({ 40 });
  EXPECT_EQ(this->Filter->GetSourceInitialDistance(0), 0.0);
}

TEST_F(DGGDistance, ManySourcesAnywhere)
{
  Points places;
  for (int i = 0; i < 4000; ++i)
  {
    places.push_back({ { 0.011 * (i % 90), 0.0111 * (i / 90 * 2 % 90), 0.1 } });
  }
  this->Filter->RemoveAllSources();
  this->Filter->SetProjectionTolerance(1.0);
  this->Filter->SetSourceData(MakeSourcePoints({ places[7] }));
  ExpectSuccess(this->Filter); // the graph is there
  this->Filter->SetSourceData(MakeSourcePoints(places));
  ProgressWatch watch(this->Filter);
  ExpectSuccess(this->Filter);
  watch.ExpectGrowth(20); // while they are linked
  const auto expected = GetDistances(this->Filter);
  // Kept: then nothing is left to do but the search.
  watch.Progress.clear();
  this->Filter->CorrectionOff();
  ExpectSuccess(this->Filter);
  EXPECT_LT(watch.Progress.size(), 20u);
  this->Filter->CorrectionOn();
  this->Filter->SetSourceData(MakeSourcePoints({ places[7] }));
  ExpectSuccess(this->Filter);
  this->Filter->SetSourceData(MakeSourcePoints(places));
  watch.Progress.clear();
  watch.StopAt = 0.3;
  ExpectSuccess(this->Filter); // stopped, which is no error
  ExpectEmptyOutput(this->Filter);
  EXPECT_LT(watch.Progress.back(), 0.4);
  watch.StopAt = 2.0;
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetDistances(this->Filter), expected);
}

TEST_F(DGGDistance, MemoryOfLinks)
{
  this->Filter->SetInputData(MakeSurfaceWithGraph(this->Terrain, 0.05));
  ExpectSuccess(this->Filter);
  const vtkTypeUInt64 before = this->Filter->GetMemorySize();
  this->Filter->SetProjectionTolerance(1.0);
  this->Filter->SetSourceData(MakeSourcePoints({ { { 0.51, 0.53, 0.1 } } }));
  ExpectSuccess(this->Filter);
  // The builder has 64 bytes and more for each half-edge.
  const vtkTypeUInt64 linked = this->Filter->GetMemorySize();
  EXPECT_GT(linked, before + 64 * 3 * 1058);
  this->Filter->SetSourceData(nullptr);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetMemorySize(), linked); // kept for the next point
  vtkNew<vtkDGGDistance> other;
  other->SetInputData(this->Filter->GetInput());
  other->SetProjectionTolerance(1.0);
  for (vtkDGGDistance* filter : { this->Filter.Get(), other.Get() })
  {
    filter->SetMemoryLimit(10000); // also applies to a builder that exists
    filter->SetSourceData(MakeSourcePoints({ { { 0.61, 0.53, 0.1 } } }));
    ExpectError(filter, { "linking points that are not vertices", "9.766 KiB", "MemoryLimit" });
  }
  this->Filter->SetSourceData(nullptr);
  ExpectSuccess(this->Filter);
  EXPECT_LT(this->Filter->GetMemorySize(), before + 64 * 3 * 1058); // the limit does not allow it
  this->Filter->SetSourceData(MakeSourcePoints({ { { 0.61, 0.53, 0.1 } } }));
  ExpectError(this->Filter, { "linking points that are not vertices", "9.766 KiB", "MemoryLimit" });
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
}
