// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: outputs, properties, what is kept, bad input.
#include "CloudTestTools.h"
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkDGGPath.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkElevationFilter.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

namespace dggtest
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

class PointCloudDGG : public ::testing::Test
{
protected:
  void Use(const Points& points) { this->Filter->SetInputData(MakeCloud(points)); }
  vtkPolyData* GetOutput() { return this->Filter->GetOutput(); }

  vtkNew<vtkPointCloudDGG> Filter;
};
}

TEST_F(PointCloudDGG, AddsTheGraphAndComponents)
{
  const Points points = MakeFlatPoints(30, 0.3);
  this->Use(points);
  vtkPolyData* input = vtkPolyData::SafeDownCast(this->Filter->GetInput());
  vtkNew<vtkFloatArray> weights;
  weights->SetName("weights");
  weights->SetNumberOfTuples(900);
  weights->Fill(2.0);
  input->GetPointData()->AddArray(weights);
  ExpectSuccess(this->Filter);

  vtkPolyData* output = this->GetOutput();
  EXPECT_EQ(output->GetPoints(), input->GetPoints());
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  EXPECT_EQ(output->GetPointData()->GetArray("weights"), weights);
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
  EXPECT_EQ(info->GetTuple1(1), 1); // cloud
  EXPECT_EQ(info->GetTuple1(2), 6); // scheme C
  EXPECT_EQ(field->GetArray("DGG.Angles"), nullptr);

  EXPECT_GT(this->Filter->GetMeanDegree(), 4.0);
  EXPECT_NEAR(this->Filter->GetMeanDegree(), edges / 900.0, 1e-12);
  EXPECT_GE(this->Filter->GetMemorySize(), 8u * edges);
}

TEST_F(PointCloudDGG, TellsWhatItUsed)
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

  this->Filter->SetSchemeToB();
  this->Filter->SetOffsetInVoxels(2.5);
  this->Filter->SetResolution(100);
  this->Filter->SetAlpha(3.5);
  ExpectSuccess(this->Filter);
  EXPECT_NEAR(this->Filter->GetUsedOffsetInVoxels(), 2.5, 1e-6);
  EXPECT_EQ(this->Filter->GetUsedResolution(), 100);
  EXPECT_EQ(this->Filter->GetUsedAlpha(), 3.5);
  EXPECT_NEAR(this->Filter->GetReach(), 6.0 * this->Filter->GetVoxelSize(), 1e-6);
}

TEST_F(PointCloudDGG, AllSchemesAreClose)
{
  const Points points = MakeSpherePoints(2000);
  std::vector<double> exact;
  for (const auto& p : points)
  {
    exact.push_back(SphereDistance(points[0], p));
  }
  this->Use(points);
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(this->Filter->GetOutputPort());
  distance->SetSourceIds({ 0 });
  std::vector<double> fields[3];
  for (const int scheme : { vtkPointCloudDGG::A, vtkPointCloudDGG::B, vtkPointCloudDGG::C })
  {
    this->Filter->SetScheme(scheme);
    distance->Update();
    EXPECT_EQ(distance->GetErrorCode(), 0u);
    EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
    fields[scheme] = GetDistances(distance);
    EXPECT_LT(GetMeanCloudError(fields[scheme], exact), scheme == vtkPointCloudDGG::C ? 3e-3 : 0.03)
      << this->Filter->GetSchemeAsString();
  }
  EXPECT_NE(fields[0], fields[2]);
  EXPECT_NE(fields[1], fields[2]);
}

TEST_F(PointCloudDGG, ArcsAreLonger)
{
  const Points points = MakeSpherePoints(1500);
  this->Use(points);
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(this->Filter->GetOutputPort());
  distance->SetSourceIds({ 0 });
  distance->Update();
  const std::vector<double> arcs = GetDistances(distance);
  this->Filter->ArcLengthWeightsOff();
  distance->Update();
  const std::vector<double> chords = GetDistances(distance);
  double more = 0.0;
  for (std::size_t i = 0; i < arcs.size(); ++i)
  {
    more += arcs[i] - chords[i];
  }
  EXPECT_GT(more / static_cast<double>(arcs.size()), 1e-3);
}

TEST_F(PointCloudDGG, KeepsTheGraph)
{
  const Points points = MakeFlatPoints(25, 0.2);
  const auto cloud = MakeCloud(points);
  vtkNew<vtkElevationFilter> elevation; // changes something upstream, but not the points
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

TEST_F(PointCloudDGG, TellsOfTheKeptGraphAfterAnError)
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

TEST_F(PointCloudDGG, SeveralComponents)
{
  const Points large = MakeFlatPoints(20, 0.2);
  const Points small = Move(MakeFlatPoints(10, 0.2), { { 5.0, 0.0, 0.0 } });
  this->Use(Join(small, large));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 2);
  EXPECT_EQ(this->Filter->GetComponentSize(0), 400);
  EXPECT_EQ(this->Filter->GetComponentSize(1), 100);
  std::vector<int> expected(500, 0);
  std::fill(expected.begin(), expected.begin() + 100, 1);
  EXPECT_EQ(GetComponents(this->GetOutput()), expected);
}

TEST_F(PointCloudDGG, PointsThatAreNotFinite)
{
  Points points = MakeFlatPoints(15, 0.1);
  points[7][1] = NaN;
  points[100][0] = std::numeric_limits<double>::infinity();
  this->Use(points);
  ExpectWarning(this->Filter, { "2 points that are not finite" });
  EXPECT_EQ(this->Filter->GetNumberOfUnusedPoints(), 2);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  const std::vector<int> components = GetComponents(this->GetOutput());
  EXPECT_EQ(this->GetOutput()->GetNumberOfPoints(), 225);
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    EXPECT_EQ(components[i], i == 7 || i == 100 ? -1 : 0) << i;
  }
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(this->GetOutput());
  distance->SetSourceIds({ 0 });
  ExpectSuccess(distance);
  const std::vector<double> distances = GetDistances(distance);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    EXPECT_EQ(std::isnan(distances[i]), i == 7 || i == 100) << i;
  }
  distance->SetSourceIds({ 7 });
  ExpectWarning(distance, { "first of them 7", "not finite", "reach no other point" });
  const std::vector<double> nowhere = GetDistances(distance);
  EXPECT_EQ(nowhere[7], 0.0);
  EXPECT_TRUE(std::isnan(nowhere[8]));
}

TEST_F(PointCloudDGG, NoPointIsFinite)
{
  this->Use(Points(5, { { NaN, 0.0, NaN } }));
  ExpectWarning(this->Filter, { "5 points that are not finite" });
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
  EXPECT_EQ(GetComponents(this->GetOutput()), std::vector<int>(5, -1));
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(this->GetOutput());
  distance->SetSourceIds({ 1 });
  ExpectWarning(distance, { "not finite", "reach no other point" });
  const std::vector<double> distances = GetDistances(distance);
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_EQ(std::isnan(distances[i]), i != 1) << i;
  }
  for (const bool smooth : { false, true })
  {
    vtkNew<vtkDGGPath> path;
    path->SetInputData(this->GetOutput());
    path->SetStraighten(smooth);
    path->AddPair(0, 1);
    path->AddPair(2, 2); // not connected to itself either
    ExpectWarning(path, { "2 of 2 pairs", "not connected by the graph of the cloud" });
    EXPECT_EQ(path->GetOutput()->GetNumberOfLines(), 0);
    vtkDataArray* status = path->GetOutput()->GetFieldData()->GetArray("PathStatus");
    ASSERT_NE(status, nullptr);
    EXPECT_EQ(status->GetTuple1(0), 1);
    EXPECT_EQ(status->GetTuple1(1), 1);
  }
}

TEST_F(PointCloudDGG, StrayPoints)
{
  const Points clean = MakeSpherePoints(600);
  vtkNew<vtkDGGPath> path;
  path->SetInputConnection(this->Filter->GetOutputPort());
  path->StraightenOn();
  path->AddPair(0, 400);
  const auto getLength = [&] {
    EXPECT_EQ(path->GetOutput()->GetNumberOfLines(), 1);
    return path->GetOutput()->GetCellData()->GetArray("Length")->GetTuple1(0);
  };
  for (const bool byPlanes : { false, true })
  {
    this->Filter->SetEstimateNormals(byPlanes);
    this->Use(clean);
    ExpectSuccess(path);
    const double length = getLength();
    const double voxel = this->Filter->GetVoxelSize();
    for (const double off : { 2e3, 1e6, 1e9 })
    {
      this->Use(Join(clean, { { { off, 0.5 * off, -off } } }));
      ExpectWarning(this->Filter, { "1 point that is more than 1000 times as far off" });
      EXPECT_EQ(this->Filter->GetNumberOfStrayPoints(), 1);
      EXPECT_EQ(this->Filter->GetNumberOfComponents(), 2);
      EXPECT_EQ(this->Filter->GetComponentSize(0), 600);
      EXPECT_EQ(GetComponents(this->GetOutput())[600], 1);
      EXPECT_EQ(this->Filter->GetVoxelSize(), voxel);
      ExpectSuccess(path);
      EXPECT_EQ(getLength(), length) << off;
    }
  }
  path->RemoveAllPairs();
  path->AddPair(0, 600);
  ExpectWarning(path, { "not connected by the graph of the cloud" });
}

TEST_F(PointCloudDGG, WarnsOfPointsOnNoSurface)
{
  // A volume.
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> number;
  Points points;
  for (int i = 0; i < 1500; ++i)
  {
    const double x = number(generator);
    const double y = number(generator);
    points.push_back({ x, y, number(generator) });
  }
  this->Use(points);
  ExpectWarning(this->Filter,
    { "% of the points do not lie on a surface", "times their spacing", "Thin the cloud out" });
  EXPECT_GT(this->Filter->GetOffSurfaceShare(), 0.5);
  EXPECT_EQ(this->Filter->GetNoise(), 0.0);
  this->Use(MakeSpherePoints(600));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetOffSurfaceShare(), 0.0);
}

TEST_F(PointCloudDGG, PartsThatAreTooFarApart)
{
  const Points part = MakeSpherePoints(300);
  this->Use(Join(part, Move(part, { { 1e9, 0.0, 0.0 } })));
  ExpectError(
    this->Filter, { "too far apart", "1e+09 from the middle", "one graph for each part" });
  ExpectEmptyOutput(this->Filter);
  this->Use(Join(part, Move(part, { { 1e4, 0.0, 0.0 } })));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 2);
  EXPECT_EQ(this->Filter->GetComponentSize(1), 300);
}

TEST_F(PointCloudDGG, VoxelsLargerThanTheSpacing)
{
  const Points clean = MakeSpherePoints(400);
  this->Use(clean);
  this->Filter->SetResolution(4);
  ExpectWarning(this->Filter,
    { "(Resolution 4), are larger than the spacing", "vtkDGGPath straightens",
      "Use a larger Resolution" });
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  this->Filter->SetOffsetInVoxels(1.0);
  ExpectWarning(this->Filter, { "(Resolution 4), are larger", "The graph bridges gaps" });
  this->Filter->SetOffsetInVoxels(0.0);
  this->Filter->SetResolution(0);
  ExpectSuccess(this->Filter);
  vtkNew<vtkDGGPath> path;
  path->SetInputConnection(this->Filter->GetOutputPort());
  path->StraightenOn();
  path->AddPair(0, 300);
  ExpectSuccess(path);
  const auto getLength = [&] {
    return path->GetOutput()->GetCellData()->GetArray("Length")->GetTuple1(0);
  };
  const double length = getLength();

  // Points far off that are too many to be stray.
  Points few = MakeSpherePoints(30);
  for (auto& point : few)
  {
    point = { { 5e3 + 2e3 * point[0], 2e3 * point[1], 2e3 * point[2] } };
  }
  this->Use(Join(clean, few));
  ExpectWarning(
    this->Filter, { ", automatic), are larger than the spacing", "sparser than others" });
  EXPECT_EQ(this->Filter->GetComponentSize(0), 400);
  ExpectSuccess(path);
  EXPECT_NEAR(getLength(), length, 0.01 * length); // not through the sphere
}

TEST_F(PointCloudDGG, CoincidentPoints)
{
  const Points once = MakeFlatPoints(12, 0.2);
  this->Use(Join(once, once));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfCoincidentPoints(), 144);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(this->Filter->GetOutputPort());
  distance->SetSourceIds({ 0 });
  ExpectSuccess(distance);
  const std::vector<double> distances = GetDistances(distance);
  EXPECT_NEAR(distances[144], 0.0, 1e-9);
  for (std::size_t i = 1; i < 144; ++i)
  {
    EXPECT_NEAR(distances[i], distances[i + 144], 1e-9) << i;
  }
}

TEST_F(PointCloudDGG, TinyClouds)
{
  for (const Points& points :
    { Points{ { { 1.0, 2.0, 3.0 } } }, Points{ { { 1.0, 2.0, 3.0 } }, { { 1.0, 2.0, 3.0 } } },
      Points{ { { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } } },
      Points{ { { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 2.0, 0.0, 0.0 } } } })
  {
    this->Use(points);
    ExpectSuccess(this->Filter);
    EXPECT_EQ(GetComponents(this->GetOutput()).size(), points.size());
    EXPECT_GE(this->Filter->GetNumberOfComponents(), 1);
  }
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
  ExpectWarning(graph, { "is that of a point cloud", "A new one takes its place" });
  EXPECT_EQ(graph->GetOutput()->GetFieldData()->GetArray("DGG.Radii"), nullptr);
  EXPECT_EQ(graph->GetOutput()->GetFieldData()->GetNumberOfArrays(), 6);
}

TEST_F(PointCloudDGG, NormalsByPlanes)
{
  const Points points = MakeSpherePoints(1000);
  this->Use(points);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->GetOutput()->GetPointData()->GetNormals(), nullptr);
  this->Filter->EstimateNormalsOn();
  ExpectSuccess(this->Filter);
  vtkDataArray* normals = this->GetOutput()->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  EXPECT_STREQ(normals->GetName(), "Normals");
  ASSERT_EQ(normals->GetNumberOfTuples(), 1000);
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1.0, 1e-6);
    const double along = n[0] * points[i][0] + n[1] * points[i][1] + n[2] * points[i][2];
    EXPECT_GT(std::abs(along), 0.99) << i;
  }
  // The same wherever the cloud is and however large.
  for (const double scale : { 1e-6, 1e6 })
  {
    Points moved = points;
    for (auto& p : moved)
    {
      p = { { scale * (p[0] + 100.0), scale * p[1], scale * p[2] } };
    }
    this->Use(moved);
    ExpectSuccess(this->Filter);
    vtkDataArray* others = this->GetOutput()->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < 1000; ++i)
    {
      double n[3];
      others->GetTuple(i, n);
      const double along = n[0] * points[i][0] + n[1] * points[i][1] + n[2] * points[i][2];
      EXPECT_GT(std::abs(along), 0.99) << scale << " " << i;
    }
  }
}

TEST_F(PointCloudDGG, NoNormalsByPlanesWhereThereAreNone)
{
  // A square, and a line far from it that leans to no plane. Rounded to floats, too.
  Points points = MakeFlatPoints(20, 0.2);
  for (int i = 0; i < 60; ++i)
  {
    points.push_back({ { 3.0 + 0.01 * i, 0.3 + 0.007 * i, 0.013 * i } });
  }
  this->Use(points);
  this->Filter->EstimateNormalsOn();
  ExpectSuccess(this->Filter);
  vtkDataArray* normals = this->GetOutput()->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (vtkIdType i = 0; i < 460; ++i)
  {
    double n[3];
    normals->GetTuple(i, n);
    EXPECT_NEAR(std::abs(n[2]), i < 400 ? 1.0 : 0.0, 1e-6) << i;
    EXPECT_NEAR(std::abs(n[0]) + std::abs(n[1]), 0.0, 1e-5) << i;
  }
}

TEST_F(PointCloudDGG, ExtentsOutOfRange)
{
  // Also where the extent itself is below the normal range of double.
  for (const double scale : { 1e-320, 1e-200, 1e200, 1e308 })
  {
    Points points = MakeSpherePoints(100);
    for (auto& p : points)
    {
      p = { { scale * p[0], scale * p[1], scale * p[2] } };
    }
    this->Use(points);
    for (const bool byPlanes : { false, true })
    {
      this->Filter->SetEstimateNormals(byPlanes);
      ExpectError(this->Filter, { "scale them" });
    }
  }
}

TEST_F(PointCloudDGG, NormalsOfTheInput)
{
  const Points points = MakeSpherePoints(800);
  const auto cloud = MakeCloud(points);
  this->Filter->SetInputData(cloud);
  ExpectSuccess(this->Filter);
  const std::vector<std::string> fitted = GetCloudBytes(this->GetOutput());

  vtkNew<vtkDoubleArray> normals;
  normals->SetName("mine");
  normals->SetNumberOfComponents(3);
  for (const auto& p : points)
  {
    normals->InsertNextTuple(p.data());
  }
  cloud->GetPointData()->SetNormals(normals);
  this->Filter->EstimateNormalsOn(); // there is nothing to estimate
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  EXPECT_NE(GetCloudBytes(this->GetOutput()), fitted);
  EXPECT_EQ(this->GetOutput()->GetPointData()->GetNormals(), normals);
  EXPECT_EQ(this->GetOutput()->GetPointData()->GetArray("Normals"), nullptr);

  normals->SetTuple3(5, 1.0, 1.0, 1.0);
  normals->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_GT(this->Filter->GetGraphBuildTime(), built);

  this->Filter->EstimateNormalsOff();
  this->Filter->UseInputNormalsOff();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetCloudBytes(this->GetOutput()), fitted);
  EXPECT_EQ(this->GetOutput()->GetPointData()->GetNormals(), normals);
}

TEST_F(PointCloudDGG, OrientedNormalsTellSheetsApart)
{
  // Two sides of a thin plate.
  const Points top = MakeFlatPoints(30);
  const Points bottom = Move(top, { { 0.0, 0.0, -0.02 } });
  const auto cloud = MakeCloud(Join(top, bottom));
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 1800; ++i)
  {
    normals->InsertNextTuple3(0.0, 0.0, i < 900 ? 1.0 : -1.0);
  }
  cloud->GetPointData()->SetNormals(normals);
  this->Filter->SetInputData(cloud);
  this->Filter->SetSchemeToB();
  this->Filter->SetOffsetInVoxels(3.0);
  this->Filter->SetAlpha(3.0);
  this->Filter->SetResolution(80);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  this->Filter->OrientedNormalsOn();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 2);
}

TEST_F(PointCloudDGG, OrientedNormalsThatAreNotThere)
{
  this->Use(MakeFlatPoints(15, 0.2));
  this->Filter->OrientedNormalsOn();
  ExpectWarning(this->Filter, { "OrientedNormals", "no effect" });
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  // The graph is the same: it is kept, but the warning is not less true.
  this->Filter->OrientedNormalsOff();
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  this->Filter->OrientedNormalsOn();
  ExpectWarning(this->Filter, { "OrientedNormals", "no effect" });
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  // What is estimated points to either side.
  this->Filter->EstimateNormalsOn();
  ExpectWarning(this->Filter, { "OrientedNormals", "no effect" });
  this->Filter->OrientedNormalsOff();
  ExpectSuccess(this->Filter);
}

TEST_F(PointCloudDGG, ThreadsDoNotMatter)
{
  this->Use(MakeSpherePoints(700));
  this->Filter->EstimateNormalsOn();
  std::vector<std::string> first;
  ForEachThreading([&](const std::string& name) {
    this->Filter->ReleaseGraph();
    this->Filter->Modified();
    ExpectSuccess(this->Filter);
    const std::vector<std::string> bytes = GetCloudBytes(this->GetOutput());
    first = first.empty() ? bytes : first;
    EXPECT_EQ(bytes, first) << name;
  });
}

TEST_F(PointCloudDGG, EstimatesMemory)
{
  EXPECT_EQ(this->Filter->GetEstimatedMemory(), 0u);
  this->Use(MakeFlatPoints(60, 0.3));
  const vtkTypeUInt64 estimate = this->Filter->EstimateMemory();
  EXPECT_EQ(this->Filter->GetErrorCode(), 0u);
  EXPECT_EQ(estimate, this->Filter->GetEstimatedMemory());
  ExpectSuccess(this->Filter);
  const auto taken = static_cast<double>(this->Filter->GetMemorySize());
  EXPECT_GT(static_cast<double>(estimate), 0.6 * taken);
  EXPECT_LT(static_cast<double>(estimate), 1.8 * taken);
  EXPECT_GE(this->Filter->GetEstimatedPeakMemory(), estimate);

  this->Filter->EstimateMemory();
  this->Filter->SetMemoryLimit(this->Filter->GetEstimatedPeakMemory());
  this->Filter->ReleaseGraph();
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(10000);
  this->Filter->SetAccuracy(0.002);
  ExpectError(this->Filter, { "limit" });
  EXPECT_EQ(this->Filter->GetNumberOfGraphEdges(), 0);
  EXPECT_EQ(this->Filter->GetSpacing(), 0.0);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
  this->Filter->SetMemoryLimit(0);
  ExpectSuccess(this->Filter);
}

TEST_F(PointCloudDGG, EstimatesTellOfProgressAndStop)
{
  const auto cloud = MakeCloud(MakeSpherePoints(20000));
  for (const double stop : { 2.0, 0.2, 0.9 })
  {
    vtkNew<vtkPointCloudDGG> filter; // outlived by its observer
    filter->SetInputData(cloud);
    ProgressWatch watch(filter);
    watch.StopAt = stop;
    const vtkTypeUInt64 estimate = filter->EstimateMemory();
    EXPECT_EQ(filter->GetErrorCode(), 0u);
    if (stop > 1.0)
    {
      EXPECT_GT(watch.Progress.size(), 10u);
      EXPECT_TRUE(std::is_sorted(watch.Progress.begin(), watch.Progress.end()));
      EXPECT_EQ(watch.Progress.back(), 1.0);
      EXPECT_GT(estimate, 0u);
    }
    else
    {
      EXPECT_EQ(estimate, 0u);
      EXPECT_LT(watch.Progress.back(), stop + 0.1);
    }
  }
}

TEST_F(PointCloudDGG, ExtremeExtents)
{
  // Radii are within the range of double, not of float.
  for (const double scale : { 1e-60, 1e60 })
  {
    Points points = MakeSpherePoints(500);
    const double exact = SphereDistance(points[0], points[400]);
    for (auto& p : points)
    {
      for (double& x : p)
      {
        x *= scale;
      }
    }
    this->Use(points);
    vtkNew<vtkDGGPath> path;
    path->SetInputConnection(this->Filter->GetOutputPort());
    path->AddPair(0, 400);
    ExpectSuccess(path);
    ASSERT_EQ(path->GetOutput()->GetNumberOfLines(), 1);
    const double length = path->GetOutput()->GetCellData()->GetArray("Length")->GetTuple1(0);
    EXPECT_NEAR(length / scale, exact, 0.02) << scale;
    vtkDataArray* radii = this->Filter->GetOutput()->GetFieldData()->GetArray("DGG.Radii");
    EXPECT_GT(radii->GetTuple1(0) / scale, 0.1);
    EXPECT_LT(radii->GetTuple1(0) / scale, 0.5);
  }
}

TEST_F(PointCloudDGG, ProgressAndAbort)
{
  const auto cloud = MakeCloud(MakeSpherePoints(20000));
  for (const double stop : { 2.0, 0.12, 0.5 })
  {
    vtkNew<vtkPointCloudDGG> filter; // outlived by its observer
    filter->SetInputData(cloud);
    filter->EstimateNormalsOn();
    ProgressWatch watch(filter);
    watch.StopAt = stop;
    filter->Update();
    EXPECT_EQ(filter->GetErrorCode(), 0u);
    if (stop > 1.0)
    {
      watch.ExpectGrowth();
      EXPECT_GT(filter->GetNumberOfGraphEdges(), 0);
      continue;
    }
    ExpectEmptyOutput(filter);
    EXPECT_EQ(filter->GetNumberOfGraphEdges(), 0);
    EXPECT_EQ(filter->GetNumberOfComponents(), 0);
    watch.StopAt = 2.0;
    ExpectSuccess(filter);
    EXPECT_GT(filter->GetNumberOfGraphEdges(), 0);
  }
}

TEST_F(PointCloudDGG, EmptyInput)
{
  this->Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  ExpectWarning(this->Filter, { "input is empty" });
  EXPECT_EQ(this->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 0);
}

TEST_F(PointCloudDGG, BadProperties)
{
  ExpectError(this->Filter, { "vtkPointCloudDGG", "there is no input" });
  this->Use(MakeFlatPoints(10));
  this->Filter->SetOffsetInVoxels(-1.0);
  ExpectError(this->Filter, { "OffsetInVoxels", "-1" });
  this->Filter->SetOffsetInVoxels(NaN);
  ExpectError(this->Filter, { "OffsetInVoxels", "nan" });
  this->Filter->SetOffsetInVoxels(1000.5);
  ExpectError(this->Filter, { "offset is 1000.5 voxels", "at most 1000" });
  this->Filter->SetOffsetInVoxels(1e-300);
  ExpectError(this->Filter, { "offset is 1e-300 voxels", "at least 0.5" });
  this->Filter->SetOffsetInVoxels(0.0);
  this->Filter->SetResolution(-5);
  ExpectError(this->Filter, { "Resolution", "-5" });
  this->Filter->SetResolution(2000000);
  ExpectError(this->Filter, { "esolution", "2000000" });
  this->Filter->SetResolution(0);
  this->Filter->SetAlpha(-0.5);
  ExpectError(this->Filter, { "Alpha", "-0.5" });
  this->Filter->SetAlpha(2e6);
  ExpectError(this->Filter, { "alpha is 2e+06", "at most 1e6" });
  this->Filter->SetAlpha(1e-300);
  ExpectError(this->Filter, { "alpha is 1e-300", "at least 1e-3" });
  this->Filter->SetAlpha(0.0);
  for (const double accuracy : { -0.1, 1e-7, 0.6, NaN })
  {
    this->Filter->SetAccuracy(accuracy);
    ExpectError(this->Filter, { "ccuracy" });
  }
  this->Filter->SetAccuracy(0.001);
  this->Filter->SetNumberOfNeighbors(2);
  ExpectError(this->Filter, { "NumberOfNeighbors", "2" });
  this->Filter->SetNumberOfNeighbors(8);
  this->Filter->SetComponentArrayName(nullptr);
  ExpectError(this->Filter, { "ComponentArrayName is empty" });
  this->Filter->SetComponentArrayName("part");
  ExpectSuccess(this->Filter);
  EXPECT_NE(this->GetOutput()->GetPointData()->GetArray("part"), nullptr);
}

TEST_F(PointCloudDGG, BadNormals)
{
  const auto cloud = MakeCloud(MakeFlatPoints(10));
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(99);
  normals->Fill(1.0);
  cloud->GetPointData()->SetNormals(normals);
  this->Filter->SetInputData(cloud);
  ExpectError(this->Filter, { "normals", "99 tuples for 100 points", "UseInputNormals" });
  this->Filter->UseInputNormalsOff();
  ExpectSuccess(this->Filter);
}

TEST_F(PointCloudDGG, PrintsItself)
{
  this->Use(MakeFlatPoints(10));
  ExpectSuccess(this->Filter);
  std::ostringstream text;
  this->Filter->PrintSelf(text, vtkIndent());
  for (const char* part : { "Scheme: C\n", "OffsetInVoxels: 0\n", "Accuracy: 0.001\n",
         "ArcLengthWeights: On\n", "NumberOfComponents: 1\n", "UsedResolution: ", "Spacing: " })
  {
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
  }
}
}
