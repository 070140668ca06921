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

TEST_F(DGGDistance, AbortedUpdatesKeepTheGraphThatIsThere)
{
  this->Filter->SetInputData(MakeTerrain(90));
  this->Filter->SetAccuracy(0.001);
  ProgressWatch watch(this->Filter);
  ExpectSuccess(this->Filter);
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
