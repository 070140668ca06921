// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkDGGDistance: distances and other arrays, sources and their links, conditions for building a
/// graph.
#include "GraphTestTools.h"
#include "SpectralTestTools.h"

#include "vtkDGGDistance.h"

#include <sstream>

using namespace dggtest;

namespace
{
/// A terrain, and a filter that computes distances from one of its points.
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

  /// Returns one component of a point array of the output; empty if there is no array of that name.
  static std::vector<double> GetComponent(
    vtkDGGDistance* filter, const char* name, int component = 0)
  {
    std::vector<double> values;
    vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, component));
    }
    return values;
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(24);
  vtkNew<vtkDGGDistance> Filter;
  vtkMTimeType Built = 0;
};
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
  // Without correction, the distances equal the upper bounds.
  this->Filter->CorrectionOff();
  this->Filter->SetUpperBoundArrayName("Bound");
  this->Filter->SetVirtualSourceArrayName("Image");
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetDistances(this->Filter), upper);
  EXPECT_EQ(GetComponent(this->Filter, "Bound"), upper);
  EXPECT_EQ(GetComponent(this->Filter, "Image", 1), length);
  // Points beyond the maximum distance have no upper bound.
  const double limit = 0.5 * upper.back();
  this->Filter->SetMaximumDistance(limit);
  ExpectSuccess(this->Filter);
  const auto bounds = GetComponent(this->Filter, "Bound");
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    EXPECT_EQ(std::isnan(bounds[i]), upper[i] > limit) << i;
  }
  // An empty input also yields the arrays.
  this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  ExpectWarning(this->Filter, { "input is empty" });
  ASSERT_NE(this->Filter->GetOutput()->GetPointData()->GetArray("Image"), nullptr);
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetArray("Image")->GetNumberOfTuples(), 0);
}

TEST_F(DGGDistance, BuildsOnce)
{
  this->Filter->SetAccuracy(0.05);
  this->ExpectBuilt("first update");
  const vtkIdType edges = this->Filter->GetNumberOfGraphEdges();
  EXPECT_GT(edges, 0);
  this->Filter->SetSourceIds({ 1, 7 });
  this->ExpectKept("source ids");
  this->Filter->SetSourceData(MakeSourcePoints({ { { 0.5, 0.5, GetTerrainHeight(0.5, 0.5) } } }));
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
  // The graph of the filter is not added to the output.
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

TEST_F(DGGDistance, AbortedUpdatesKeepTheGraphThatIsThere)
{
  this->Filter->SetInputData(MakeTerrain(90));
  this->Filter->SetAccuracy(0.001);
  ProgressWatch watch(this->Filter);
  ExpectSuccess(this->Filter);
  const auto expected = GetDistances(this->Filter);
  // Aborting a search keeps the graph.
  this->Built = this->Filter->GetGraphBuildTime();
  watch.StopAt = 0.1;
  this->Filter->Modified();
  ExpectSuccess(this->Filter); // an abort is not an error
  ExpectEmptyOutput(this->Filter);
  watch.StopAt = 2.0;
  this->ExpectKept("after an abort");
  EXPECT_EQ(GetDistances(this->Filter), expected);
  // Abort while the graph is built.
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
  EXPECT_EQ(nearest[500], 1);
  const vtkMTimeType before = this->Filter->GetMTime();
  this->Filter->SetSourceIds({ 40, 500 }, { 0.0, -0.25 });
  EXPECT_EQ(this->Filter->GetMTime(), before); // the value is unchanged
  std::ostringstream os;
  this->Filter->Print(os);
  EXPECT_NE(os.str().find("SourceIds: 40 500 (from -0.25)\n"), std::string::npos) << os.str();

  this->Filter->SetSourceIds({ 40, 500 }, { 0.0, std::nan("") });
  ExpectError(this->Filter, { "source id 500", "initial distance nan", "finite" });
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
  ExpectSuccess(this->Filter); // the graph exists
  this->Filter->SetSourceData(MakeSourcePoints(places));
  ProgressWatch watch(this->Filter);
  ExpectSuccess(this->Filter);
  watch.ExpectGrowth(20); // progress of linking
  const auto expected = GetDistances(this->Filter);
  // Links are kept, so that only the search remains.
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
  ExpectSuccess(this->Filter); // an abort is not an error
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
  // The builder needs at least 64 bytes per half-edge.
  const vtkTypeUInt64 linked = this->Filter->GetMemorySize();
  EXPECT_GT(linked, before + 64 * 3 * 1058);
  this->Filter->SetSourceData(nullptr);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetMemorySize(), linked); // kept for the next point
  this->Filter->SetMemoryLimit(10000);              // also applies to an existing builder
  this->Filter->SetSourceData(MakeSourcePoints({ { { 0.61, 0.53, 0.1 } } }));
  ExpectError(this->Filter, { "linking points that are not vertices", "9.766 KiB", "MemoryLimit" });
  this->Filter->SetSourceData(nullptr);
  ExpectSuccess(this->Filter);
  EXPECT_LT(this->Filter->GetMemorySize(), before + 64 * 3 * 1058); // limit allows no builder
}
