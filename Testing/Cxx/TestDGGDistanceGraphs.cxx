// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances by a graph: which graph is used, and when it is built.
#include "DGGDistanceFixture.h"

#include "vtkDiscreteGeodesicGraph.h"

#include "vtkCellArray.h"
#include "vtkElevationFilter.h"
#include "vtkFieldData.h"

#include <gtest/gtest.h>

using namespace dggtest;

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
  // And stored in another way.
  copy->GetPolys()->ConvertTo32BitStorage();
  copy->Modified();
  this->ExpectKept("other storage");
  EXPECT_EQ(this->Filter->GetMeshBuildTime(), mesh);
  EXPECT_EQ(GetDistances(this->Filter), expected);
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
