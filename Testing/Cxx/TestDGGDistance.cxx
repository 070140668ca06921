// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances by a graph: the promise, seen through the filter; what the outputs hold.
#include "DGGDistanceFixture.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace dggtest;

TEST_F(DGGDistance, KeepsThePromiseFromPoints)
{
  for (const double accuracy : { 0.2, 0.05, 0.01, 0.001 })
  {
    this->Filter->SetAccuracy(accuracy);
    for (const vtkIdType source : { 0, 23, 300, 575 })
    {
      SCOPED_TRACE(::testing::Message() << accuracy << " from " << source);
      const auto exact = GetExactDistances(this->Terrain, { source });
      this->Filter->SetSourceIds({ source });
      this->Filter->CorrectionOff();
      ExpectSuccess(this->Filter);
      const auto raw = GetDistances(this->Filter);
      ExpectUpperBounds(raw, exact, accuracy);
      this->Filter->CorrectionOn();
      ExpectSuccess(this->Filter);
      const auto corrected = GetDistances(this->Filter);
      ExpectWithin(corrected, exact, accuracy);
      EXPECT_LT(GetMeanError(corrected, exact), 0.6 * GetMeanError(raw, exact));
    }
  }
}

TEST_F(DGGDistance, KeepsThePromiseFromPlacesInsideOfFacesAndOnEdges)
{
  this->Filter->RemoveAllSources();
  for (const auto& surface : { this->Terrain, MakeCube() })
  {
    this->Filter->SetInputData(surface);
    for (const double accuracy : { 0.1, 0.01 })
    {
      this->Filter->SetAccuracy(accuracy);
      for (const auto& place : GetPlaces(surface))
      {
        SCOPED_TRACE(::testing::PrintToString(place));
        auto source = MakeSourcePoints({ place });
        const auto exact = GetExactDistances(surface, source);
        this->Filter->SetSourceData(source);
        this->Filter->CorrectionOff();
        ExpectSuccess(this->Filter);
        const auto raw = GetDistances(this->Filter);
        // Next to the source, rounding of the projection counts.
        for (std::size_t i = 0; i < exact.size(); ++i)
        {
          EXPECT_GE(raw[i], exact[i] - 1e-9) << i;
          EXPECT_LE(raw[i], exact[i] * (1.0 + accuracy) * (1.0 + 1e-6) + 1e-9) << i;
        }
        this->Filter->CorrectionOn();
        ExpectSuccess(this->Filter);
        const auto corrected = GetDistances(this->Filter);
        for (std::size_t i = 0; i < exact.size(); ++i)
        {
          EXPECT_NEAR(corrected[i], exact[i], exact[i] * (accuracy + 2e-6) + 1e-9) << i;
        }
      }
    }
  }
}

TEST_F(DGGDistance, CornersOfTheFaceOfASourceAreExact)
{
  this->Filter->RemoveAllSources();
  this->Filter->SetAccuracy(0.3);
  auto grid = MakeGrid(6, 6);
  this->Filter->SetInputData(grid);
  this->Filter->SetSourceData(MakeSourcePoints({ { { 2.7, 3.2, 0.0 } } }));
  for (const bool correct : { false, true })
  {
    this->Filter->SetCorrection(correct);
    ExpectSuccess(this->Filter);
    const auto distances = GetDistances(this->Filter);
    EXPECT_NEAR(distances[3 * 7 + 2], std::hypot(0.7, 0.2), 1e-12);
    EXPECT_NEAR(distances[3 * 7 + 3], std::hypot(0.3, 0.2), 1e-12);
    EXPECT_NEAR(distances[4 * 7 + 2], std::hypot(0.7, 0.8), 1e-12);
  }
}

TEST_F(DGGDistance, MaximumDistance)
{
  this->Filter->SetAccuracy(0.1);
  this->Filter->AddSourceId(300);
  this->Filter->GenerateNearestSourceOn();
  this->Filter->GenerateUpperBoundOn();
  ExpectSuccess(this->Filter);
  const auto all = GetDistances(this->Filter);
  vtkNew<vtkPointData> whole;
  whole->DeepCopy(this->Filter->GetOutput()->GetPointData());
  this->Filter->CorrectionOff();
  ExpectSuccess(this->Filter);
  const auto raw = GetDistances(this->Filter);
  for (const double limit : { 0.0, 0.2, 0.55, 5.0 })
  {
    this->Filter->SetMaximumDistance(limit);
    this->Filter->CorrectionOn();
    ExpectSuccess(this->Filter);
    const auto near = GetDistances(this->Filter);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      EXPECT_EQ(std::isnan(near[i]), all[i] > limit) << i << " " << limit;
      if (!std::isnan(near[i]))
      {
        EXPECT_EQ(near[i], all[i]) << i;
      }
      vtkPointData* data = this->Filter->GetOutput()->GetPointData();
      const auto point = static_cast<vtkIdType>(i);
      const auto get = [&](vtkPointData* from, const char* name) {
        return from->GetArray(name)->GetComponent(point, 0);
      };
      EXPECT_EQ(
        get(data, "GeodesicSource"), std::isnan(near[i]) ? -1.0 : get(whole, "GeodesicSource"));
      const double bound = get(data, "GeodesicUpperBound");
      EXPECT_TRUE(
        std::isnan(near[i]) ? std::isnan(bound) : bound == get(whole, "GeodesicUpperBound"));
    }
    this->Filter->CorrectionOff();
    ExpectSuccess(this->Filter);
    const auto nearRaw = GetDistances(this->Filter);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      EXPECT_EQ(std::isnan(nearRaw[i]), raw[i] > limit) << i << " " << limit;
    }
  }
}

TEST_F(DGGDistance, UpperBoundAndVirtualSource)
{
  this->Filter->SetAccuracy(0.05);
  this->Filter->GenerateUpperBoundOn();
  this->Filter->GenerateVirtualSourceOn();
  ExpectSuccess(this->Filter);
  vtkPointData* data = this->Filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetNumberOfArrays(), 3);
  EXPECT_STREQ(data->GetScalars()->GetName(), "GeodesicDistance");
  EXPECT_EQ(data->GetArray("GeodesicUpperBound")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(data->GetArray("GeodesicVirtualSource")->GetNumberOfComponents(), 3);
  const auto distances = GetDistances(this->Filter);
  const auto upper = GetComponent(this->Filter, "GeodesicUpperBound");
  const auto offset = GetComponent(this->Filter, "GeodesicVirtualSource", 0);
  const auto length = GetComponent(this->Filter, "GeodesicVirtualSource", 1);
  const auto direction = GetComponent(this->Filter, "GeodesicVirtualSource", 2);
  const auto exact = GetExactDistances(this->Terrain, { 40 });
  ExpectUpperBounds(upper, exact, 0.05);
  for (std::size_t i = 0; i < upper.size(); ++i)
  {
    EXPECT_LE(distances[i], upper[i]) << i;
    EXPECT_GE(distances[i] * 1.05 * (1.0 + 1e-6), upper[i]) << i;
    const double estimate = offset[i] + length[i];
    const double confined = std::min(std::max(estimate, upper[i] / 1.05), upper[i]);
    EXPECT_NEAR(distances[i], confined, 1e-5 * distances[i]) << i;
    EXPECT_TRUE(std::isfinite(direction[i])) << i;
  }
  // The same without correction, where the distances are the upper bounds.
  this->Filter->CorrectionOff();
  this->Filter->SetUpperBoundArrayName("Bound");
  this->Filter->SetVirtualSourceArrayName("Image");
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetDistances(this->Filter), upper);
  EXPECT_EQ(GetComponent(this->Filter, "Bound"), upper);
  EXPECT_EQ(GetComponent(this->Filter, "Image", 1), length);
  // On an empty input the arrays are there as well.
  this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  ExpectWarning(this->Filter, { "input is empty" });
  ASSERT_NE(this->Filter->GetOutput()->GetPointData()->GetArray("Image"), nullptr);
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetArray("Image")->GetNumberOfTuples(), 0);
}
