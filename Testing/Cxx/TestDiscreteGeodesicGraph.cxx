// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkDiscreteGeodesicGraph: outputs, conditions for building a graph, invalid input.
#include "GraphTestTools.h"

#include "vtkDiscreteGeodesicGraph.h"

#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"

#include <cstring>

using namespace dggtest;

namespace
{
vtkDataArray* GetFieldArray(vtkPolyData* data, const char* name)
{
  return data->GetFieldData()->GetArray(name);
}

class DiscreteGeodesicGraph : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Terrain);
    this->Filter->SetAccuracy(0.05);
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(20);
  vtkNew<vtkDiscreteGeodesicGraph> Filter;
};
}

TEST_F(DiscreteGeodesicGraph, ArraysAreAsDocumented)
{
  ExpectSuccess(this->Filter);
  vtkPolyData* output = this->Filter->GetOutput();
  const vtkIdType n = this->Terrain->GetNumberOfPoints();
  const vtkIdType m = this->Filter->GetNumberOfGraphEdges();
  const std::vector<std::pair<const char*, vtkIdType>> sizes = { { "DGG.Offsets", n + 1 },
    { "DGG.Targets", m }, { "DGG.Lengths", m }, { "DGG.Angles", m }, { "DGG.ArrivalAngles", m },
    { "DGG.Info", 12 } };
  for (const auto& nameAndSize : sizes)
  {
    vtkDataArray* array = GetFieldArray(output, nameAndSize.first);
    ASSERT_NE(array, nullptr) << nameAndSize.first;
    EXPECT_EQ(array->GetNumberOfComponents(), 1) << nameAndSize.first;
    EXPECT_EQ(array->GetNumberOfTuples(), nameAndSize.second) << nameAndSize.first;
  }
  EXPECT_EQ(GetFieldArray(output, "DGG.Offsets")->GetDataTypeSize(), 8);
  EXPECT_EQ(GetFieldArray(output, "DGG.Targets")->GetDataType(), VTK_TYPE_INT32);
  EXPECT_EQ(GetFieldArray(output, "DGG.Lengths")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(GetFieldArray(output, "DGG.Angles")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(GetFieldArray(output, "DGG.ArrivalAngles")->GetDataType(), VTK_FLOAT);

  EXPECT_EQ(GetFieldArray(output, "DGG.Offsets")->GetComponent(n, 0), static_cast<double>(m));
  EXPECT_DOUBLE_EQ(this->Filter->GetMeanDegree(), static_cast<double>(m) / n);
  EXPECT_GT(this->Filter->GetMeanDegree(), 10.0);
  EXPECT_LT(this->Filter->GetMeanDegree(), 60.0);
  EXPECT_EQ(this->Filter->GetMemorySize(), static_cast<vtkTypeUInt64>(16 * m + 8 * (n + 1)));
}

TEST_F(DiscreteGeodesicGraph, LengthsAreDoublesForHighAccuracy)
{
  this->Filter->SetInputData(MakeTerrain(6));
  this->Filter->SetAccuracy(1e-5);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetFieldArray(this->Filter->GetOutput(), "DGG.Lengths")->GetDataType(), VTK_FLOAT);
  this->Filter->SetAccuracy(9e-6);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetFieldArray(this->Filter->GetOutput(), "DGG.Lengths")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(this->Filter->GetMemorySize(),
    static_cast<vtkTypeUInt64>(20 * this->Filter->GetNumberOfGraphEdges() + 8 * 37));
}

TEST_F(DiscreteGeodesicGraph, GraphLines)
{
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphLines()->GetNumberOfCells(), 0);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  this->Filter->GenerateGraphLinesOn();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);

  vtkPolyData* lines = this->Filter->GetGraphLines();
  EXPECT_EQ(lines, this->Filter->GetOutput(1));
  EXPECT_EQ(lines->GetPoints(), this->Terrain->GetPoints());
  EXPECT_EQ(2 * lines->GetNumberOfLines(), this->Filter->GetNumberOfGraphEdges());
  vtkDataArray* lengths = lines->GetCellData()->GetArray("Length");
  ASSERT_NE(lengths, nullptr);
  EXPECT_EQ(lengths->GetDataType(), VTK_DOUBLE);
  ASSERT_EQ(lengths->GetNumberOfTuples(), lines->GetNumberOfLines());
  for (vtkIdType c = 0; c < lines->GetNumberOfLines(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetLines()->GetCellAtId(c, size, ids);
    ASSERT_EQ(size, 2);
    EXPECT_GE(
      lengths->GetComponent(c, 0), EuclideanDistance(this->Terrain, ids[0], ids[1]) * (1 - 1e-12));
  }
  this->Filter->GenerateGraphLinesOff();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphLines()->GetNumberOfPoints(), 0);
}

TEST_F(DiscreteGeodesicGraph, IsBuiltOnceForTheSameMeshAndParameters)
{
  ExpectSuccess(this->Filter);
  vtkMTimeType built = this->Filter->GetGraphBuildTime();
  EXPECT_GT(built, 0u);
  const auto bytes = GetGraphBytes(this->Filter->GetOutput());
  auto expectKept = [&](const char* what) {
    ExpectSuccess(this->Filter);
    EXPECT_EQ(this->Filter->GetGraphBuildTime(), built) << what;
  };
  auto expectRebuilt = [&](const char* what) {
    ExpectSuccess(this->Filter);
    EXPECT_GT(this->Filter->GetGraphBuildTime(), built) << what;
    built = this->Filter->GetGraphBuildTime();
  };
  this->Filter->Modified();
  expectKept("Modified()");
  this->Filter->SetMemoryLimit(vtkTypeInt64(1) << 40);
  expectKept("MemoryLimit");
  this->Filter->SetNumberOfNeighbors(12);
  expectKept("NumberOfNeighbors, which this construction does not use");
  AddArray(this->Terrain->GetPointData(), "Values", std::vector<double>(400, 0.0));
  expectKept("point array");
  EXPECT_EQ(GetGraphBytes(this->Filter->GetOutput()), bytes);
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(this->Terrain);
  copy->GetPolys()->ConvertTo32BitStorage();
  this->Filter->SetInputData(copy);
  expectKept("a copy of the same points and cells");

  this->Filter->SetAccuracy(0.1);
  expectRebuilt("Accuracy");
  EXPECT_NE(GetGraphBytes(this->Filter->GetOutput()), bytes);
  this->Filter->SetAccuracy(0.05);
  expectRebuilt("Accuracy");
  EXPECT_EQ(GetGraphBytes(this->Filter->GetOutput()), bytes);
  this->Filter->SetConstructionToSaddleVertexGraph();
  expectRebuilt("Construction");
  this->Filter->SetNumberOfNeighbors(9);
  expectRebuilt("NumberOfNeighbors");
  this->Filter->SetAccuracy(0.1);
  expectKept("Accuracy, which this construction does not use");
  this->Filter->SetConstructionToGuaranteed();
  expectRebuilt("Construction");
  double p[3];
  copy->GetPoint(7, p);
  copy->GetPoints()->SetPoint(7, p[0], p[1], p[2] + 0.01);
  copy->GetPoints()->Modified();
  expectRebuilt("a point");
  this->Filter->MergeCoincidentPointsOn();
  expectRebuilt("MergeCoincidentPoints");
  // External code modifies the arrays that are shared with the filter.
  GetFieldArray(this->Filter->GetOutput(), "DGG.Lengths")->SetComponent(0, 0, 77.0);
  GetFieldArray(this->Filter->GetOutput(), "DGG.Lengths")->Modified();
  this->Filter->Modified();
  expectRebuilt("altered output");
}

TEST_F(DiscreteGeodesicGraph, AGraphOnTheInputIsPassedOn)
{
  auto surface = MakeSurfaceWithGraph(this->Terrain, 0.05);
  this->Filter->SetInputData(surface);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), 0u);
  vtkPolyData* output = this->Filter->GetOutput();
  for (const std::string& name : GetGraphArrayNames())
  {
    EXPECT_EQ(output->GetFieldData()->GetArray(name.c_str()),
      surface->GetFieldData()->GetArray(name.c_str()));
  }
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(),
    surface->GetFieldData()->GetArray("DGG.Targets")->GetNumberOfTuples());

  // A graph with other parameters is replaced without a warning.
  this->Filter->SetAccuracy(0.1);
  ExpectSuccess(this->Filter);
  EXPECT_GT(this->Filter->GetGraphBuildTime(), 0u);
  EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), 6);
  EXPECT_NE(output->GetFieldData()->GetArray("DGG.Targets"),
    surface->GetFieldData()->GetArray("DGG.Targets"));

  // An outdated graph is replaced with a warning.
  surface->GetPoints()->SetPoint(0, 0.0, 0.0, 0.01);
  surface->GetPoints()->Modified();
  ExpectWarning(this->Filter, { "the graph on the input is out of date", "replaces it" });
  this->Filter->Modified();
  ExpectSuccess(this->Filter); // reported only once
  EXPECT_EQ(
    GetGraphBytes(this->Filter->GetOutput()), GetGraphBytes(MakeSurfaceWithGraph(surface, 0.1)));
}

TEST_F(DiscreteGeodesicGraph, EstimatesReportWhatIsWrong)
{
  this->Filter->SetAccuracy(0.7);
  {
    const Listener listener(this->Filter);
    EXPECT_EQ(this->Filter->EstimateMemory(), 0u);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find("0.7"), std::string::npos);
  }
  this->Filter->SetAccuracy(0.1);
  EXPECT_GT(this->Filter->EstimateMemory(), 0u);
  this->Filter->SetInputConnection(nullptr);
  const Listener listener(this->Filter);
  EXPECT_EQ(this->Filter->EstimateMemory(), 0u);
  ASSERT_EQ(listener.Errors.size(), 1u);
  EXPECT_NE(listener.Errors[0].find("There is no input"), std::string::npos);
}

TEST_F(DiscreteGeodesicGraph, APieceOfTheLinesIsRefusedAsWell)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputConnection(sphere->GetOutputPort());
  graph->GenerateGraphLinesOn();
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(graph->GetOutputPort(1));
  {
    const Listener listener(graph);
    const Listener mute(tube);
    tube->UpdatePiece(0, 4, 0);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find("One of 4 pieces"), std::string::npos);
    EXPECT_NE(graph->GetErrorCode(), 0u);
    ExpectEmptyOutput(graph);
  }
  // The previous request on one port does not affect the other port.
  ExpectSuccess(graph);
  EXPECT_EQ(graph->GetOutput()->GetNumberOfPoints(), 24 * 22 + 2);
  EXPECT_GT(graph->GetGraphLines()->GetNumberOfLines(), 0);
}

TEST_F(DiscreteGeodesicGraph, CanBeReleased)
{
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  const auto bytes = GetGraphBytes(this->Filter->GetOutput());
  vtkDataArray* targets = GetFieldArray(this->Filter->GetOutput(), "DGG.Targets");
  const int references = targets->GetReferenceCount();
  this->Filter->ReleaseGraph();
  EXPECT_LT(targets->GetReferenceCount(), references);
  ExpectSuccess(this->Filter); // no execution is needed
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_EQ(GetGraphBytes(this->Filter->GetOutput()), bytes);
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_GT(this->Filter->GetGraphBuildTime(), built);
  EXPECT_EQ(GetGraphBytes(this->Filter->GetOutput()), bytes);
}

TEST_F(DiscreteGeodesicGraph, LinesKeepToTheMemoryLimitAndCanBeStopped)
{
  this->Filter->SetInputData(MakeTerrain(100));
  this->Filter->SetAccuracy(0.2);
  ExpectSuccess(this->Filter);
  this->Filter->GenerateGraphLinesOn();
  this->Filter->SetMemoryLimit(1000);
  ExpectError(
    this->Filter, { "as lines", "1000 bytes", "turn off GenerateGraphLines", "MemoryLimit" });
  this->Filter->SetMemoryLimit(0);
  ProgressWatch watch(this->Filter);
  watch.StopAt = 0.93; // the graph is kept; only the lines are generated
  ExpectSuccess(this->Filter);
  ExpectEmptyOutput(this->Filter);
  EXPECT_LT(watch.Progress.back(), 1.0);
  watch.StopAt = 2.0;
  ExpectSuccess(this->Filter);
  EXPECT_GT(this->Filter->GetGraphLines()->GetNumberOfLines(), 0);
}

TEST_F(DiscreteGeodesicGraph, AnEmptyInputHasNoGraph)
{
  vtkNew<vtkPolyData> empty;
  empty->SetFieldData(MakeSurfaceWithGraph(this->Terrain)->GetFieldData());
  this->Filter->SetInputData(empty);
  ExpectWarning(this->Filter, { "input is empty" });
  EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(empty->GetFieldData()->GetNumberOfArrays(), 6); // the input is unchanged
}

TEST_F(DiscreteGeodesicGraph, EstimatesLeaveTheUpdateAlone)
{
  // An empty input causes a warning, as in an update.
  this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  {
    const Listener listener(this->Filter);
    EXPECT_EQ(this->Filter->EstimateMemory(), 0u);
    EXPECT_EQ(listener.Errors, std::vector<std::string>());
    EXPECT_EQ(listener.Warnings.size(), 1u);
  }
  // The error code of a failed update is kept.
  this->Filter->SetInputData(this->Terrain);
  this->Filter->SetMemoryLimit(1000);
  ExpectError(this->Filter, { "MemoryLimit" });
  EXPECT_GT(this->Filter->EstimateMemory(), 0u);
  EXPECT_NE(this->Filter->GetErrorCode(), 0u);
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
  EXPECT_GT(this->Filter->GetEstimatedMemory(), 0u);
  this->Filter->Modified();
  ExpectSuccess(this->Filter); // the graph and its estimate are kept
  EXPECT_GT(this->Filter->GetEstimatedMemory(), 0u);
  // No estimate exists for a graph that is passed through.
  this->Filter->SetInputData(MakeSurfaceWithGraph(MakeTerrain(12), 0.05));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetEstimatedMemory(), 0u);
  EXPECT_EQ(this->Filter->GetEstimatedPeakMemory(), 0u);
  // The estimate can be aborted.
  ProgressWatch watch(this->Filter);
  watch.StopAt = 0.05;
  EXPECT_EQ(this->Filter->EstimateMemory(), 0u);
  watch.StopAt = 2.0;
  EXPECT_GT(this->Filter->EstimateMemory(), 0u);
}

TEST_F(DiscreteGeodesicGraph, PointsWithoutPolygonsHaveEmptyRows)
{
  this->Terrain->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0);
  this->Terrain->GetPoints()->InsertNextPoint(std::nan(""), 0.0, 0.0);
  ExpectSuccess(this->Filter);
  vtkDataArray* offsets = GetFieldArray(this->Filter->GetOutput(), "DGG.Offsets");
  ASSERT_EQ(offsets->GetNumberOfTuples(), 403);
  EXPECT_LT(offsets->GetComponent(399, 0), offsets->GetComponent(400, 0));
  EXPECT_EQ(offsets->GetComponent(400, 0), offsets->GetComponent(402, 0));
}
