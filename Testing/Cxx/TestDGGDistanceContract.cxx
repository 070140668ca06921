// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances by a graph: properties, what is refused, progress and abort.
#include "DGGDistanceFixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

using namespace dggtest;

TEST_F(DGGDistance, Defaults)
{
  vtkNew<vtkDGGDistance> filter;
  EXPECT_EQ(filter->GetAccuracy(), 0.01);
  EXPECT_TRUE(filter->GetCorrection());
  EXPECT_EQ(filter->GetSearch(), vtkDGGDistance::Certified);
  EXPECT_STREQ(filter->GetSearchAsString(), "Certified");
  EXPECT_FALSE(filter->GetAcceptCoarserGraph());
  EXPECT_EQ(filter->GetMemoryLimit(), 0);
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
