// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: outputs, properties, reuse between updates.
#include "GraphTestTools.h"
#include "PointCloudDGGFixture.h"

#include "vtkDGGDistance.h"

#include "vtkElevationFilter.h"

namespace dggtest
{
TEST_F(PointCloudDGG, AddsTheGraphAndComponents)
{
  const Points points = MakeFlatPoints(30, 0.3);
  this->Use(points);
  vtkPolyData* input = vtkPolyData::SafeDownCast(this->Filter->GetInput());
  AddArray(input->GetPointData(), "weights", std::vector<double>(900, 2.0));
  ExpectSuccess(this->Filter);

  vtkPolyData* output = this->GetOutput();
  EXPECT_EQ(output->GetPoints(), input->GetPoints());
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  EXPECT_EQ(
    output->GetPointData()->GetArray("weights"), input->GetPointData()->GetArray("weights"));
  EXPECT_EQ(GetComponents(output), std::vector<int>(900, 0));
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  EXPECT_EQ(this->Filter->GetComponentSize(0), 900);
  EXPECT_EQ(this->Filter->GetComponentSize(1), 0);
  EXPECT_EQ(input->GetFieldData()->GetNumberOfArrays(), 0);

  vtkFieldData* field = output->GetFieldData();
  EXPECT_EQ(field->GetNumberOfArrays(), 5);
  vtkDataArray* offsets = field->GetArray("DGG.Offsets");
  ASSERT_NE(offsets, nullptr);
  EXPECT_EQ(offsets->GetNumberOfTuples(), 901);
  const vtkIdType edges = this->Filter->GetNumberOfGraphEdges();
  EXPECT_EQ(offsets->GetTuple1(900), edges);
  EXPECT_EQ(field->GetArray("DGG.Targets")->GetNumberOfTuples(), edges);
  EXPECT_EQ(field->GetArray("DGG.Lengths")->GetNumberOfTuples(), edges);
  EXPECT_EQ(field->GetArray("DGG.Radii")->GetNumberOfTuples(), 900);
  vtkDataArray* info = field->GetArray("DGG.Info");
  EXPECT_EQ(info->GetTuple1(1), 1); // kind: cloud
  EXPECT_EQ(info->GetTuple1(2), 6); // scheme C
  EXPECT_EQ(field->GetArray("DGG.Angles"), nullptr);

  EXPECT_GT(this->Filter->GetMeanDegree(), 4.0);
  EXPECT_NEAR(this->Filter->GetMeanDegree(), edges / 900.0, 1e-12);
  EXPECT_GE(this->Filter->GetMemorySize(), 8u * edges);
}

TEST_F(PointCloudDGG, ReportsWhatItUsed)
{
  const int n = 40;
  this->Use(MakeFlatPoints(n, 0.2));
  ExpectSuccess(this->Filter);
  const double spacing = 1.0 / (n - 1);
  EXPECT_NEAR(this->Filter->GetSpacing(), spacing, 0.3 * spacing);
  EXPECT_LT(this->Filter->GetNoise(), 1e-6);
  EXPECT_GT(this->Filter->GetUsedOffsetInVoxels(), 0.0);
  EXPECT_NEAR(this->Filter->GetUsedOffset(),
    this->Filter->GetUsedOffsetInVoxels() * this->Filter->GetVoxelSize(), 1e-12);
  EXPECT_GT(this->Filter->GetUsedOffset(), 0.5 * spacing);
  EXPECT_LT(this->Filter->GetUsedOffset(), 4.0 * spacing);
  EXPECT_GT(this->Filter->GetUsedResolution(), n / 2);
  EXPECT_GT(this->Filter->GetUsedAlpha(), 0.0);
  EXPECT_GT(this->Filter->GetReach(), 2.0 * spacing);

  this->Filter->SetComponentArrayName("part");
  this->Filter->SetSchemeToB();
  this->Filter->SetOffsetInVoxels(2.5);
  this->Filter->SetResolution(100);
  this->Filter->SetAlpha(3.5);
  ExpectSuccess(this->Filter);
  EXPECT_NEAR(this->Filter->GetUsedOffsetInVoxels(), 2.5, 1e-6);
  EXPECT_EQ(this->Filter->GetUsedResolution(), 100);
  EXPECT_EQ(this->Filter->GetUsedAlpha(), 3.5);
  EXPECT_NE(this->GetOutput()->GetPointData()->GetArray("part"), nullptr);
  EXPECT_NEAR(this->Filter->GetReach(), 6.0 * this->Filter->GetVoxelSize(), 1e-6);
}

TEST_F(PointCloudDGG, UsesThePointsOfAMesh)
{
  const auto mesh = MakeTerrain(25);
  this->Filter->SetInputData(mesh);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->GetOutput()->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  const std::vector<std::string> bytes = GetCloudBytes(this->GetOutput());
  vtkNew<vtkPolyData> points;
  points->SetPoints(mesh->GetPoints());
  this->Filter->SetInputData(points);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetCloudBytes(this->GetOutput()), bytes);
}

TEST_F(PointCloudDGG, MakesVerticesOnRequest)
{
  this->Use(MakeFlatPoints(15));
  this->Filter->GenerateVerticesOn();
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(this->Filter->GetOutputPort());
  distance->AddSourceId(0);
  ExpectSuccess(distance);
  EXPECT_TRUE(distance->GetUsedInputGraph());
  vtkPolyData* output = distance->GetOutput();
  ASSERT_EQ(output->GetNumberOfCells(), 1);
  ASSERT_EQ(output->GetCell(0)->GetNumberOfPoints(), 225);
  for (int i = 0; i < 225; ++i)
  {
    EXPECT_EQ(output->GetCell(0)->GetPointId(i), i);
  }
  EXPECT_EQ(vtkPolyData::SafeDownCast(this->Filter->GetInput())->GetNumberOfCells(), 0);
  // Cells of the input are passed unchanged, and empty input remains empty.
  this->Filter->SetInputData(MakeGrid(10, 10));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->GetOutput()->GetNumberOfVerts(), 0);
  EXPECT_EQ(this->GetOutput()->GetNumberOfPolys(), 200);
  this->Filter->SetNumberOfNeighbors(2);
  ExpectError(this->Filter, { "NumberOfNeighbors" });
}

TEST_F(PointCloudDGG, TakesThePlaceOfAnotherGraph)
{
  this->Filter->SetInputData(MakeSurfaceWithGraph(MakeTerrain(15)));
  ExpectSuccess(this->Filter);
  vtkFieldData* field = this->GetOutput()->GetFieldData();
  EXPECT_EQ(field->GetArray("DGG.Angles"), nullptr);
  EXPECT_EQ(field->GetArray("DGG.ArrivalAngles"), nullptr);
  EXPECT_EQ(field->GetNumberOfArrays(), 5);
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputConnection(this->Filter->GetOutputPort());
  ExpectWarning(graph, { "is that of a point cloud", "replaces it" });
  EXPECT_EQ(graph->GetOutput()->GetFieldData()->GetArray("DGG.Radii"), nullptr);
  EXPECT_EQ(graph->GetOutput()->GetFieldData()->GetNumberOfArrays(), 6);
}

TEST_F(PointCloudDGG, KeepsTheGraph)
{
  const Points points = MakeFlatPoints(25, 0.2);
  const auto cloud = MakeCloud(points);
  vtkNew<vtkElevationFilter> elevation; // changes the pipeline upstream, but not the points
  elevation->SetInputData(cloud);
  this->Filter->SetInputConnection(elevation->GetOutputPort());
  ExpectSuccess(this->Filter);
  const vtkMTimeType first = this->Filter->GetGraphBuildTime();
  elevation->SetHighPoint(0.0, 0.0, 3.0);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), first);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  EXPECT_GT(this->Filter->GetSpacing(), 0.0);
  this->Filter->SetMemoryLimit(1u << 30);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), first);

  this->Filter->SetAccuracy(0.01);
  ExpectSuccess(this->Filter);
  const vtkMTimeType second = this->Filter->GetGraphBuildTime();
  EXPECT_GT(second, first);

  cloud->GetPoints()->SetPoint(3, 0.1, 0.02, 0.001);
  cloud->GetPoints()->Modified();
  ExpectSuccess(this->Filter);
  const vtkMTimeType third = this->Filter->GetGraphBuildTime();
  EXPECT_GT(third, second);

  this->Filter->ReleaseGraph();
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_GT(this->Filter->GetGraphBuildTime(), third);
}

TEST_F(PointCloudDGG, ReportsTheKeptGraphAfterAnError)
{
  this->Use(MakeFlatPoints(25, 0.2));
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  const double spacing = this->Filter->GetSpacing();
  this->Filter->SetAlpha(-1.0);
  ExpectError(this->Filter, { "Alpha" });
  EXPECT_EQ(this->Filter->GetSpacing(), 0.0);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
  this->Filter->SetAlpha(0.0);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_EQ(this->Filter->GetSpacing(), spacing);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  EXPECT_GT(this->Filter->GetNumberOfGraphEdges(), 0);
}

TEST_F(PointCloudDGG, WarnsOncePerGraph)
{
  this->Use(MakeVolumePoints(1500));
  ExpectWarning(this->Filter, { "do not lie on a surface" });
  const double scatter = this->Filter->GetScatter();
  EXPECT_GT(scatter, 1.0);
  // The graph is kept, and the statistics behind the warning remain available.
  this->Filter->SetMemoryLimit(1u << 30);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetScatter(), scatter);
  EXPECT_GT(this->Filter->GetOffSurfaceShare(), 0.5);
  this->Filter->ReleaseGraph();
  this->Filter->Modified();
  ExpectWarning(this->Filter, { "do not lie on a surface" });
}

TEST_F(PointCloudDGG, EstimatesMemory)
{
  EXPECT_EQ(this->Filter->GetEstimatedMemory(), 0u);
  this->Use(MakeFlatPoints(30, 0.3));
  const vtkTypeUInt64 estimate = this->Filter->EstimateMemory();
  EXPECT_EQ(this->Filter->GetErrorCode(), 0u);
  EXPECT_EQ(estimate, this->Filter->GetEstimatedMemory());
  ExpectSuccess(this->Filter);
  const auto size = static_cast<double>(this->Filter->GetMemorySize());
  EXPECT_NEAR(static_cast<double>(estimate), size, 0.8 * size);
  EXPECT_GE(this->Filter->GetEstimatedPeakMemory(), estimate);
  this->Filter->SetMemoryLimit(10000);
  this->Filter->SetAccuracy(0.002);
  ExpectError(this->Filter, { "limit" });
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
}
}
