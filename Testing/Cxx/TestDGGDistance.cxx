// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances by a graph: the promise, seen through the filter; which graph is used; what is
/// refused.
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkExactGeodesicDistance.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkElevationFilter.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

using namespace dggtest;

namespace
{
std::vector<double> GetComponent(vtkDGGDistance* filter, const char* name, int component = 0)
{
  std::vector<double> values;
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, component));
  }
  return values;
}

/// Places at vertices, on edges, inside of faces and at the rim of a sheet.
Points GetPlaces(vtkPolyData* surface)
{
  Points places;
  for (vtkIdType cell = 3; cell < surface->GetNumberOfCells(); cell += 97)
  {
    vtkNew<vtkIdList> ids;
    surface->GetCellPoints(cell, ids);
    std::array<double, 3> corners[3];
    for (int k = 0; k < 3; ++k)
    {
      surface->GetPoint(ids->GetId(k), corners[k].data());
    }
    for (const std::array<double, 3>& weights : { std::array<double, 3>{ { 0.2, 0.3, 0.5 } },
           std::array<double, 3>{ { 0.01, 0.01, 0.98 } }, std::array<double, 3>{ { 0.5, 0.5, 0 } },
           std::array<double, 3>{ { 0.9, 0.0999, 0.0001 } } })
    {
      std::array<double, 3> place{ { 0, 0, 0 } };
      for (int k = 0; k < 3; ++k)
      {
        for (int i = 0; i < 3; ++i)
        {
          place[i] += weights[k] * corners[k][i];
        }
      }
      places.push_back(place);
    }
  }
  return places;
}

class DGGDistance : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Terrain);
    this->Filter->AddSourceId(40);
  }

  void ExpectBuilt(const char* what)
  {
    ExpectSuccess(this->Filter);
    EXPECT_GT(this->Filter->GetGraphBuildTime(), this->Built) << what;
    this->Built = this->Filter->GetGraphBuildTime();
  }

  void ExpectKept(const char* what)
  {
    ExpectSuccess(this->Filter);
    EXPECT_EQ(this->Filter->GetGraphBuildTime(), this->Built) << what;
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(24);
  vtkNew<vtkDGGDistance> Filter;
  vtkMTimeType Built = 0;
};
}

TEST_F(DGGDistance, Defaults)
{
  vtkNew<vtkDGGDistance> filter;
  EXPECT_EQ(filter->GetAccuracy(), 0.01);
  EXPECT_TRUE(filter->GetCorrection());
  EXPECT_EQ(filter->GetSearch(), vtkDGGDistance::Certified);
  EXPECT_STREQ(filter->GetSearchAsString(), "Certified");
  EXPECT_FALSE(filter->GetAcceptCoarserGraph());
  EXPECT_EQ(filter->GetMemoryLimit(), 0u);
  EXPECT_FALSE(filter->GetGenerateUpperBound());
  EXPECT_FALSE(filter->GetGenerateVirtualSource());
  EXPECT_STREQ(filter->GetUpperBoundArrayName(), "GeodesicUpperBound");
  EXPECT_STREQ(filter->GetVirtualSourceArrayName(), "GeodesicVirtualSource");
  EXPECT_FALSE(filter->GetUsedInputGraph());
  EXPECT_EQ(filter->GetGraphAccuracy(), 0.0);
  EXPECT_EQ(filter->GetNumberOfGraphEdges(), 0);
  EXPECT_EQ(filter->GetMemorySize(), 0u);
  EXPECT_FALSE(filter->GetGraphIsGuaranteed());
  EXPECT_EQ(filter->GetGraphBuildTime(), 0u);
  // What all distance filters have in common is tested elsewhere.
  EXPECT_EQ(filter->GetNumberOfInputPorts(), 2);
  EXPECT_TRUE(std::isnan(filter->GetUnreachedValue()));
}

TEST_F(DGGDistance, EveryPropertyCountsAsAChange)
{
  vtkMTimeType before = this->Filter->GetMTime();
  auto expectChange = [&](const char* what) {
    EXPECT_GT(this->Filter->GetMTime(), before) << what;
    before = this->Filter->GetMTime();
  };
  this->Filter->SetAccuracy(0.02);
  expectChange("Accuracy");
  this->Filter->CorrectionOff();
  expectChange("Correction");
  this->Filter->SetSearchToDijkstra();
  expectChange("Search");
  EXPECT_EQ(this->Filter->GetSearch(), vtkDGGDistance::Dijkstra);
  EXPECT_STREQ(this->Filter->GetSearchAsString(), "Dijkstra");
  this->Filter->SetSearchToLabelCorrecting();
  expectChange("Search");
  EXPECT_EQ(this->Filter->GetSearch(), vtkDGGDistance::LabelCorrecting);
  EXPECT_STREQ(this->Filter->GetSearchAsString(), "LabelCorrecting");
  this->Filter->SetSearchToCertified();
  expectChange("Search");
  this->Filter->SetMemoryLimit(5);
  expectChange("MemoryLimit");
  this->Filter->AcceptCoarserGraphOn();
  expectChange("AcceptCoarserGraph");
  this->Filter->GenerateUpperBoundOn();
  expectChange("GenerateUpperBound");
  this->Filter->GenerateVirtualSourceOn();
  expectChange("GenerateVirtualSource");
  this->Filter->SetUpperBoundArrayName("u");
  expectChange("UpperBoundArrayName");
  this->Filter->SetVirtualSourceArrayName("v");
  expectChange("VirtualSourceArrayName");
}

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

TEST_F(DGGDistance, MaximumDistance)
{
  this->Filter->SetAccuracy(0.1);
  ExpectSuccess(this->Filter);
  const auto all = GetDistances(this->Filter);
  this->Filter->CorrectionOff();
  ExpectSuccess(this->Filter);
  const auto raw = GetDistances(this->Filter);
  const auto exact = GetExactDistances(this->Terrain, { 40 });
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

TEST_F(DGGDistance, OnAPlaneTheVirtualSourceIsTheSource)
{
  this->Filter->SetInputData(MakeGrid(8, 8));
  this->Filter->SetAccuracy(0.1);
  this->Filter->SetSourceIds({ 30 });
  this->Filter->GenerateVirtualSourceOn();
  ExpectSuccess(this->Filter);
  const auto offset = GetComponent(this->Filter, "GeodesicVirtualSource", 0);
  const auto length = GetComponent(this->Filter, "GeodesicVirtualSource", 1);
  for (vtkIdType i = 0; i < 81; ++i)
  {
    const double expected = std::hypot(i % 9 - 3, i / 9 - 3);
    EXPECT_EQ(offset[i], 0.0) << i;
    EXPECT_NEAR(length[i], expected, 1e-5) << i;
  }
}

TEST_F(DGGDistance, SearchesAgree)
{
  this->Filter->SetAccuracy(0.02);
  this->Filter->CorrectionOff();
  ExpectSuccess(this->Filter);
  const auto expected = GetDistances(this->Filter);
  for (const int search : { vtkDGGDistance::LabelCorrecting, vtkDGGDistance::Dijkstra })
  {
    this->Filter->SetSearch(search);
    ExpectSuccess(this->Filter);
    const auto distances = GetDistances(this->Filter);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_NEAR(distances[i], expected[i], 1e-9 * expected[i]) << i;
    }
  }
}

TEST_F(DGGDistance, BuildsOnce)
{
  this->Filter->SetAccuracy(0.05);
  this->ExpectBuilt("first update");
  const vtkIdType edges = this->Filter->GetNumberOfGraphEdges();
  EXPECT_GT(edges, 0);
  EXPECT_EQ(this->Filter->GetGraphAccuracy(), 0.05);
  EXPECT_TRUE(this->Filter->GetGraphIsGuaranteed());
  EXPECT_GE(this->Filter->GetMemorySize(), static_cast<vtkTypeUInt64>(16 * edges));
  this->Filter->SetSourceIds({ 1, 7 });
  this->ExpectKept("source ids");
  this->Filter->SetSourceData(MakeSourcePoints(GetPlaces(this->Terrain)));
  this->ExpectKept("source points");
  this->Filter->CorrectionOff();
  this->ExpectKept("Correction");
  this->Filter->SetSearchToDijkstra();
  this->ExpectKept("Search");
  this->Filter->SetMaximumDistance(0.5);
  this->ExpectKept("MaximumDistance");
  this->Filter->GenerateVirtualSourceOn();
  this->ExpectKept("GenerateVirtualSource");
  this->Filter->SetMemoryLimit(1);
  this->ExpectKept("MemoryLimit");
  this->Filter->SetMemoryLimit(0);
  this->Filter->AddSourceId(100000);
  ExpectError(this->Filter, { "100000" });
  this->Filter->SetSourceIds({ 1 });
  this->ExpectKept("after an error");
  // The graph is our own: it does not go into the output.
  EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);

  this->Filter->SetAccuracy(0.04);
  this->ExpectBuilt("Accuracy");
  EXPECT_GT(this->Filter->GetNumberOfGraphEdges(), edges);
  double p[3];
  this->Terrain->GetPoint(9, p);
  this->Terrain->GetPoints()->SetPoint(9, p[0], p[1], p[2] + 0.1);
  this->Terrain->GetPoints()->Modified();
  this->ExpectBuilt("a point");
  this->Filter->MergeCoincidentPointsOn();
  this->ExpectBuilt("MergeCoincidentPoints");
}

TEST_F(DGGDistance, TakesTheGraphOnItsInput)
{
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputData(this->Terrain);
  graph->SetAccuracy(0.05);
  this->Filter->SetInputConnection(graph->GetOutputPort());
  ExpectSuccess(this->Filter); // Accuracy has not been set: nothing to complain about
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(this->Filter->GetGraphAccuracy(), 0.05);
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(), graph->GetNumberOfGraphEdges());
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), 0u);
  const auto fromInput = GetDistances(this->Filter);

  vtkNew<vtkDGGDistance> other;
  other->SetInputData(this->Terrain);
  other->AddSourceId(40);
  other->SetAccuracy(0.05);
  ExpectSuccess(other);
  EXPECT_FALSE(other->GetUsedInputGraph());
  EXPECT_EQ(GetDistances(other), fromInput);

  // A new graph upstream.
  graph->SetAccuracy(0.2);
  ExpectSuccess(this->Filter);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(this->Filter->GetGraphAccuracy(), 0.2);
  EXPECT_NE(GetDistances(this->Filter), fromInput);
  // None any more, and one again.
  this->Filter->SetInputData(this->Terrain);
  this->Filter->SetAccuracy(0.05);
  this->ExpectBuilt("no graph on the input");
  EXPECT_FALSE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(GetDistances(this->Filter), fromInput);
  graph->SetAccuracy(0.05);
  this->Filter->SetInputConnection(graph->GetOutputPort());
  this->ExpectKept("graph on the input");
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(GetDistances(this->Filter), fromInput);
}

TEST_F(DGGDistance, SaysWhenTheGraphIsCoarserThanAskedFor)
{
  this->Filter->SetInputData(MakeSurfaceWithGraph(this->Terrain, 0.1));
  this->Filter->SetAccuracy(0.01);
  ExpectWarning(this->Filter,
    { "the graph on the input is used", "its accuracy is 0.1", "Accuracy 0.01 is asked for" });
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(this->Filter->GetGraphAccuracy(), 0.1);
  this->Filter->SetSourceIds({ 3 });
  ExpectSuccess(this->Filter); // once
  this->Filter->SetAccuracy(0.02);
  ExpectWarning(this->Filter, { "Accuracy 0.02 is asked for" });
  this->Filter->SetAccuracy(0.1);
  ExpectSuccess(this->Filter);
  this->Filter->SetAccuracy(0.3); // coarser would do
  ExpectSuccess(this->Filter);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  this->Filter->AcceptCoarserGraphOn();
  this->Filter->SetAccuracy(0.01);
  ExpectSuccess(this->Filter);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
}

TEST_F(DGGDistance, KeepsItsGraphWhenNothingChangesUpstream)
{
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputData(this->Terrain);
  this->Filter->SetInputConnection(elevation->GetOutputPort());
  this->ExpectBuilt("first update");
  const vtkMTimeType mesh = this->Filter->GetMeshBuildTime();
  const auto expected = GetDistances(this->Filter);
  elevation->SetLowPoint(0.0, 0.0, 0.3); // other scalars, the same surface
  this->ExpectKept("elevation");
  EXPECT_EQ(this->Filter->GetMeshBuildTime(), mesh);
  EXPECT_EQ(GetDistances(this->Filter), expected);
  // The same points and polygons in other memory.
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(this->Terrain);
  this->Filter->SetInputData(copy);
  this->ExpectKept("a deep copy");
  // And stored in another way: the mesh is another one, the graph is that of the same surface.
  copy->GetPolys()->ConvertTo32BitStorage();
  copy->Modified();
  this->ExpectKept("other storage");
  EXPECT_GT(this->Filter->GetMeshBuildTime(), mesh);
  EXPECT_EQ(GetDistances(this->Filter), expected);
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

TEST_F(DGGDistance, HugeInitialDistances)
{
  for (const double offset : { 1e300, -1e300, 1e18 })
  {
    this->Filter->SetSourceIds({ 40 }, { offset });
    for (const int search :
      { vtkDGGDistance::Certified, vtkDGGDistance::LabelCorrecting, vtkDGGDistance::Dijkstra })
    {
      this->Filter->SetSearch(search);
      ExpectSuccess(this->Filter);
      for (const double distance : GetDistances(this->Filter))
      {
        EXPECT_NEAR(distance, offset, 1e-12 * std::abs(offset));
      }
    }
  }
  // Together with one that is nearer everywhere.
  this->Filter->SetSourceIds({ 40, 41 }, { 1e300, 0.0 });
  ExpectSuccess(this->Filter);
  const auto distances = GetDistances(this->Filter);
  EXPECT_LT(*std::max_element(distances.begin(), distances.end()), 10.0);
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
  EXPECT_GT(this->Filter->GetMemorySize(), before + 64 * 3 * 1058);
  this->Filter->SetSourceData(nullptr);
  ExpectSuccess(this->Filter);
  EXPECT_LT(this->Filter->GetMemorySize(), before + 64 * 3 * 1058); // let go
  this->Filter->SetSourceData(MakeSourcePoints({ { { 0.51, 0.53, 0.1 } } }));
  this->Filter->SetMemoryLimit(10000);
  ExpectError(this->Filter, { "linking points that are not vertices", "9.766 KiB", "MemoryLimit" });
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
}

TEST_F(DGGDistance, GraphsWithoutAGuarantee)
{
  const auto exact = GetExactDistances(this->Terrain, { 40 });
  for (const int construction : { vtkDiscreteGeodesicGraph::OneRelay,
         vtkDiscreteGeodesicGraph::Indirect, vtkDiscreteGeodesicGraph::SaddleVertexGraph })
  {
    auto surface = MakeSurfaceWithGraph(this->Terrain, 0.02, construction);
    vtkNew<vtkDGGDistance> filter;
    filter->SetInputData(surface);
    filter->AddSourceId(40);
    ExpectSuccess(filter);
    EXPECT_TRUE(filter->GetUsedInputGraph());
    EXPECT_FALSE(filter->GetGraphIsGuaranteed());
    EXPECT_LT(GetMeanError(GetDistances(filter), exact), 0.02);
    // From inside of a face.
    auto place = MakeSourcePoints({ GetPlaces(surface)[0] });
    filter->RemoveAllSources();
    filter->SetSourceData(place);
    ExpectSuccess(filter);
    EXPECT_LT(GetMeanError(GetDistances(filter), GetExactDistances(surface, place)), 0.02);
    filter->SetAccuracy(0.02);
    ExpectWarning(filter, { "guarantees no accuracy" });
  }
}

TEST_F(DGGDistance, CoincidentPointsThatAreMergedHaveEqualDistances)
{
  auto surface = MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } },
                               { { 1, 0, 0 } }, { { 0, 1, 0 } } },
    { { 0, 1, 2 }, { 3, 5, 4 } });
  this->Filter->SetInputData(surface);
  this->Filter->SetSourceIds({ 0 });
  this->Filter->MergeCoincidentPointsOn();
  this->Filter->GenerateUpperBoundOn();
  ExpectSuccess(this->Filter);
  const auto distances = GetDistances(this->Filter);
  EXPECT_NEAR(distances[3], std::sqrt(2.0), 1e-6);
  EXPECT_EQ(distances[4], distances[1]);
  EXPECT_EQ(distances[5], distances[2]);
  EXPECT_EQ(GetComponent(this->Filter, "GeodesicUpperBound")[4], distances[1]);
}

TEST_F(DGGDistance, AccuracyOutOfRange)
{
  ExpectSuccess(this->Filter);
  const auto expected = GetDistances(this->Filter);
  const double NaN = std::numeric_limits<double>::quiet_NaN();
  for (const double accuracy : { 0.0, -1.0, 9e-7, 0.51, NaN })
  {
    this->Filter->SetAccuracy(accuracy);
    ExpectError(this->Filter, { "ccuracy", "1e-06", "0.5" });
  }
  this->Filter->SetAccuracy(0.01);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetDistances(this->Filter), expected);
}

TEST_F(DGGDistance, RefusesWhatTakesTooMuchMemory)
{
  this->Filter->SetMemoryLimit(10000);
  ExpectError(
    this->Filter, { "the graph would take about", "9.766 KiB", "Accuracy", "MemoryLimit" });
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
}

TEST_F(DGGDistance, WrongInputs)
{
  ExpectSuccess(this->Filter);
  const auto expected = GetDistances(this->Filter);
  this->Filter->RemoveAllSources();
  ExpectError(this->Filter, { "there is no source" });
  this->Filter->AddSourceId(40);
  this->Filter->SetSourceData(MakeSourcePoints({ { { 0.5, 0.5, 9.0 } } }));
  ExpectError(this->Filter, { "source point 0 of input port 1", "ProjectionTolerance" });
  this->Filter->SetSourceData(nullptr);
  auto broken = MakeTerrain(5);
  broken->GetPoints()->SetPoint(7, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->Filter->SetInputData(broken);
  ExpectError(this->Filter, { "out of range" });
  this->Filter->SetSourceIds({ 0 });
  ExpectError(this->Filter, { "point 7 of cell", "not finite" });
  this->Filter->SetSourceIds({ 40 });
  this->Filter->SetInputData(MakeSourcePoints(Points(50, { { 0, 0, 0 } })));
  ExpectError(this->Filter, { "no polygons" });
  this->Filter->SetInputData(this->Terrain);
  this->Filter->GenerateUpperBoundOn();
  this->Filter->SetUpperBoundArrayName("");
  ExpectError(this->Filter, { "SetUpperBoundArrayName()" });
  this->Filter->SetUpperBoundArrayName("GeodesicDistance");
  ExpectError(this->Filter, { "'GeodesicDistance'", "UpperBoundArrayName" });
  this->Filter->GenerateUpperBoundOff();
  this->Filter->GenerateVirtualSourceOn();
  this->Filter->SetVirtualSourceArrayName(nullptr);
  ExpectError(this->Filter, { "SetVirtualSourceArrayName()" });
  this->Filter->GenerateVirtualSourceOff();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetDistances(this->Filter), expected);
}

TEST_F(DGGDistance, IsTheSameForAnyThreads)
{
  this->Filter->SetSourceData(MakeSourcePoints(GetPlaces(this->Terrain)));
  ExpectSuccess(this->Filter);
  const auto expected = GetDistances(this->Filter);
  ForEachThreading([&](const std::string& threading) {
    vtkNew<vtkDGGDistance> filter;
    filter->SetInputData(this->Terrain);
    filter->SetSourceIds({ 40 });
    filter->SetSourceData(MakeSourcePoints(GetPlaces(this->Terrain)));
    ExpectSuccess(filter);
    EXPECT_EQ(GetDistances(filter), expected) << threading;
  });
}

TEST_F(DGGDistance, ProgressAndAbort)
{
  this->Filter->SetInputData(MakeTerrain(90));
  this->Filter->SetAccuracy(0.001);
  ProgressWatch watch(this->Filter);
  ExpectSuccess(this->Filter);
  watch.ExpectGrowth(1);
  const auto expected = GetDistances(this->Filter);
  // While searching: the graph is kept.
  this->Built = this->Filter->GetGraphBuildTime();
  watch.StopAt = 0.1;
  this->Filter->Modified();
  ExpectSuccess(this->Filter); // not an error
  ExpectEmptyOutput(this->Filter);
  watch.StopAt = 2.0;
  this->ExpectKept("after an abort");
  EXPECT_EQ(GetDistances(this->Filter), expected);
  // While building.
  watch.StopAt = 0.11;
  this->Filter->SetAccuracy(0.0011);
  ExpectSuccess(this->Filter);
  ExpectEmptyOutput(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(), 0);
  watch.StopAt = 2.0;
  this->Filter->SetAccuracy(0.001);
  this->ExpectBuilt("after an abort");
  EXPECT_EQ(GetDistances(this->Filter), expected);
}

TEST_F(DGGDistance, PrintSelf)
{
  this->Filter->SetAccuracy(0.05);
  ExpectSuccess(this->Filter);
  std::ostringstream os;
  this->Filter->Print(os);
  for (const char* text :
    { "SourceIds: 40\n", "Accuracy: 0.05\n", "Correction: On\n", "Search: Certified\n",
      "MemoryLimit: 0\n", "AcceptCoarserGraph: Off\n", "Accuracy has been set: yes\n",
      "GenerateUpperBound: Off\n", "GenerateVirtualSource: Off\n", "UsedInputGraph: no\n",
      "GraphAccuracy: 0.05\n", "NumberOfGraphEdges: ", "MemorySize: ", "GraphBuildTime: " })
  {
    EXPECT_NE(os.str().find(text), std::string::npos) << text << " is missing in:\n" << os.str();
  }
}
