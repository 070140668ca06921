// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The filters that search a graph, behind vtkPointCloudDGG.
#include "CloudTestTools.h"
#include "GraphTestTools.h"

#include "vtkApolloniusIsolines.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDGGDistance.h"
#include "vtkDGGLoop.h"
#include "vtkDGGPath.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkFieldData.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicProbe.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkHeatGeodesicDistance.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace dggtest
{
namespace
{
class CloudConsumers : public ::testing::Test
{
protected:
  void Use(const Points& points)
  {
    this->Cloud = points;
    this->Graph->SetInputData(MakeCloud(points));
  }
  template <typename Filter>
  void Connect(Filter& filter)
  {
    filter->SetInputConnection(this->Graph->GetOutputPort());
  }
  static std::array<double, 3> At(vtkPolyData* data, vtkIdType i)
  {
    std::array<double, 3> p;
    data->GetPoint(i, p.data());
    return p;
  }
  static double Value(vtkDataSetAttributes* data, const char* name, vtkIdType i)
  {
    vtkDataArray* array = data->GetArray(name);
    EXPECT_NE(array, nullptr) << name;
    return array ? array->GetTuple1(i) : NAN;
  }

  Points Cloud;
  vtkNew<vtkPointCloudDGG> Graph;
};

/// The polyline of a path as points.
Points GetPolyline(vtkPolyData* paths, vtkIdType line)
{
  vtkNew<vtkIdList> ids;
  paths->GetLines()->GetCellAtId(line, ids);
  Points points;
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    points.emplace_back();
    paths->GetPoint(ids->GetId(i), points.back().data());
  }
  return points;
}
}

//------------------------------------------------------------------------------
TEST_F(CloudConsumers, DistanceInThePlane)
{
  this->Use(MakeFlatPoints(50, 0.25));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 1275 });
  ExpectSuccess(distance);
  EXPECT_TRUE(distance->GetUsedInputGraph());
  EXPECT_FALSE(distance->GetGraphIsGuaranteed());
  EXPECT_EQ(distance->GetNumberOfGraphEdges(), this->Graph->GetNumberOfGraphEdges());
  const std::vector<double> values = GetDistances(distance);
  std::vector<double> exact;
  for (const auto& p : this->Cloud)
  {
    exact.push_back(Distance(p, this->Cloud[1275]));
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_GE(values[i], exact[i] * (1.0 - 1e-6)) << i;
    EXPECT_LE(values[i], exact[i] * 1.02 + 1e-12) << i;
  }
  EXPECT_LT(GetMeanCloudError(values, exact), 2e-3);
}

TEST_F(CloudConsumers, DistanceOnTheSphere)
{
  this->Use(MakeSpherePoints(5000));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 17, 3000 });
  distance->GenerateNearestSourceOn();
  ExpectSuccess(distance);
  std::vector<double> exact;
  const std::vector<int> nearest = GetNearestSources(distance);
  const std::vector<double> values = GetDistances(distance);
  for (std::size_t i = 0; i < this->Cloud.size(); ++i)
  {
    const double first = SphereDistance(this->Cloud[i], this->Cloud[17]);
    const double second = SphereDistance(this->Cloud[i], this->Cloud[3000]);
    exact.push_back(std::min(first, second));
    if (std::abs(first - second) > 0.02)
    {
      EXPECT_EQ(nearest[i], first < second ? 0 : 1) << i;
    }
  }
  EXPECT_LT(GetMeanCloudError(values, exact), 1e-3);
}

TEST_F(CloudConsumers, AllSearchesAgree)
{
  this->Use(MakeSpherePoints(1500));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->AddSourceId(5, 0.25);
  distance->AddSourceId(900);
  distance->GenerateUpperBoundOn();
  std::vector<double> first;
  for (const int search :
    { vtkDGGDistance::Dijkstra, vtkDGGDistance::LabelCorrecting, vtkDGGDistance::Certified })
  {
    for (const bool correction : { false, true })
    {
      distance->SetSearch(search);
      distance->SetCorrection(correction);
      ExpectSuccess(distance);
      const std::vector<double> values = GetDistances(distance);
      first = first.empty() ? values : first;
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        EXPECT_NEAR(values[i], first[i], 1e-9) << i;
        EXPECT_NEAR(
          Value(distance->GetOutput()->GetPointData(), "GeodesicUpperBound", i), values[i], 1e-12);
      }
    }
  }
}

TEST_F(CloudConsumers, MaximumDistanceAndComponents)
{
  const Points part = MakeFlatPoints(20, 0.2);
  this->Use(Join(part, Move(part, { { 3.0, 0.0, 0.0 } })));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 0 });
  distance->GenerateNearestSourceOn();
  distance->SetMaximumDistance(0.5);
  distance->SetUnreachedValue(-7.0);
  ExpectSuccess(distance);
  const std::vector<double> values = GetDistances(distance);
  const std::vector<int> nearest = GetNearestSources(distance);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double exact = Distance(this->Cloud[i], this->Cloud[0]);
    EXPECT_EQ(values[i] == -7.0, nearest[i] == -1);
    if (exact < 0.49)
    {
      EXPECT_GE(values[i], 0.0) << i;
    }
    if (exact > 0.5)
    {
      EXPECT_EQ(values[i], -7.0) << i;
    }
  }
}

TEST_F(CloudConsumers, AccuracyIsNotUsed)
{
  this->Use(MakeFlatPoints(15, 0.2));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 0 });
  distance->SetAccuracy(1e-5);
  distance->MergeCoincidentPointsOn();
  ExpectSuccess(distance);
}

TEST_F(CloudConsumers, SourcesNearTheCloud)
{
  this->Use(MakeFlatPoints(40, 0.2));
  const std::array<double, 3> place{ { 0.4321, 0.5678, 0.0 } };
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceData(MakeSourcePoints({ place }));
  ExpectSuccess(distance);
  std::vector<double> exact;
  for (const auto& p : this->Cloud)
  {
    exact.push_back(Distance(p, place));
  }
  const std::vector<double> values = GetDistances(distance);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_GE(values[i], exact[i] * (1.0 - 1e-6)) << i;
    EXPECT_LE(values[i], exact[i] * 1.02 + 1e-12) << i;
  }
  EXPECT_LT(GetMeanCloudError(values, exact), 2e-3);

  // At a point of the cloud it is that point.
  distance->SetSourceData(MakeSourcePoints({ this->Cloud[77] }));
  ExpectSuccess(distance);
  const std::vector<double> atPoint = GetDistances(distance);
  distance->RemoveAllSources();
  distance->SetSourceIds({ 77 });
  ExpectSuccess(distance);
  EXPECT_EQ(GetDistances(distance), atPoint);
}

TEST_F(CloudConsumers, SourcesFarFromTheCloud)
{
  this->Use(MakeFlatPoints(20, 0.2));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceData(MakeSourcePoints({ { { 0.5, 0.5, 0.0 } }, { { 0.5, 0.5, 0.3 } } }));
  ExpectError(distance,
    { "source point 1 of input port 1", "away from the cloud", "0.3", "ProjectionTolerance" });
  // Between the points of a sparse cloud, but a little above it.
  distance->SetProjectionTolerance(0.0);
  distance->SetSourceData(MakeSourcePoints({ { { 0.5, 0.5, 0.01 } } }));
  ExpectSuccess(distance);
  distance->SetSourceData(MakeSourcePoints({ { { 0.5, 0.5, 0.1 } } }));
  ExpectError(distance, { "source point 0", "ProjectionTolerance 0 times" });
  distance->SetSourceData(MakeSourcePoints({ { { 0.5, 0.5, 0.0 } }, { { 0.5, 0.5, 0.3 } } }));
  distance->SetProjectionTolerance(0.5);
  ExpectSuccess(distance);
}

TEST_F(CloudConsumers, NearestPointsAreTheNearest)
{
  // Against a search of all points, also far outside and with points in the same place.
  Points points = MakeSpherePoints(300);
  points = Join(points, { points[10], points[20], points[10] });
  this->Use(points);
  vtkNew<vtkGeodesicSampler> sampler;
  this->Connect(sampler);
  sampler->SetProjectionTolerance(10.0);
  sampler->SetNumberOfSamples(1);
  Points places = { points[302], points[301], { { 3.0, 0.1, 0.2 } }, { { -2.0, -2.5, 4.0 } },
    { { 0.0, 0.01, 0.02 } }, { { 0.3, -0.8, 0.4 } } };
  for (const auto& place : places)
  {
    sampler->SetStartData(MakeSourcePoints({ place }));
    ExpectSuccess(sampler);
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      nearest = Distance(points[i], place) < Distance(points[nearest], place) ? i : nearest;
    }
    EXPECT_EQ(
      Value(sampler->GetOutput()->GetPointData(), "vtkOriginalPointIds", 0), double(nearest));
  }
}

TEST_F(CloudConsumers, VirtualSourcesNeedASurface)
{
  this->Use(MakeFlatPoints(10));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 0 });
  distance->GenerateVirtualSourceOn();
  ExpectError(distance, { "point cloud", "turn GenerateVirtualSource off" });
}

//------------------------------------------------------------------------------
TEST_F(CloudConsumers, PathsInThePlane)
{
  this->Use(MakeFlatPoints(40, 0.2));
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->AddPair(0, 1599);
  path->AddPair(39, 800);
  path->AddPair(5, 5);
  ExpectSuccess(path);
  vtkPolyData* output = path->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 3);
  const vtkIdType ends[3][2] = { { 0, 1599 }, { 39, 800 }, { 5, 5 } };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    const Points line = GetPolyline(output, i);
    const auto& from = this->Cloud[ends[i][0]];
    const auto& to = this->Cloud[ends[i][1]];
    EXPECT_EQ(Distance(line.front(), from), 0.0);
    EXPECT_EQ(Distance(line.back(), to), 0.0);
    double length = 0.0;
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
    {
      length += Distance(line[k], line[k + 1]);
    }
    const double exact = Distance(from, to);
    EXPECT_NEAR(Value(output->GetCellData(), "Length", i), length, 1e-12);
    EXPECT_GE(length, exact - 1e-12);
    EXPECT_LE(length, 1.02 * exact + 1e-12);
    EXPECT_NEAR(Value(output->GetCellData(), "GraphLength", i), exact, 0.02 * exact + 1e-12);
    EXPECT_EQ(Value(output->GetCellData(), "PairId", i), static_cast<double>(i));
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Value(output->GetPointData(), "FaceId", i), -1.0);
  }
  EXPECT_EQ(output->GetFieldData()->GetAbstractArray("DGG.Info"), nullptr);
  EXPECT_EQ(output->GetFieldData()->GetAbstractArray("DGG.Radii"), nullptr);
}

TEST_F(CloudConsumers, PathLengthsAreDistances)
{
  this->Use(MakeSpherePoints(2000));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 3 });
  ExpectSuccess(distance);
  const std::vector<double> distances = GetDistances(distance);
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  for (vtkIdType id = 10; id < 2000; id += 5) // enough of them for landmarks
  {
    path->AddPair(3, id);
  }
  ExpectSuccess(path);
  vtkPolyData* output = path->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), path->GetNumberOfPairs());
  for (vtkIdType i = 0; i < path->GetNumberOfPairs(); ++i)
  {
    EXPECT_NEAR(Value(output->GetCellData(), "GraphLength", i), distances[path->GetPairEnd(i)],
      1e-6 * distances[path->GetPairEnd(i)]);
    EXPECT_LE(Value(output->GetCellData(), "Length", i),
      Value(output->GetCellData(), "GraphLength", i) * (1.0 + 1e-6));
  }
}

TEST_F(CloudConsumers, PathsBetweenPlacesNearTheCloud)
{
  this->Use(MakeFlatPoints(40, 0.2));
  const Points ends = { { { 0.111, 0.222, 0.0 } }, { { 0.9, 0.8, 0.0 } }, // far from each other
    { { 0.501, 0.5, 0.0 } }, { { 0.506, 0.504, 0.0 } } };                 // within a spacing
  const auto lines = MakeSourcePoints(ends);
  lines->SetLines(MakeCells({ { 0, 1 }, { 2, 3 } }));
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->SetPairData(lines);
  ExpectSuccess(path);
  vtkPolyData* output = path->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 2);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    const double exact = Distance(ends[2 * i], ends[2 * i + 1]);
    const Points line = GetPolyline(output, i);
    EXPECT_NEAR(Distance(line.front(), ends[2 * i]), 0.0, 1e-12);
    EXPECT_NEAR(Distance(line.back(), ends[2 * i + 1]), 0.0, 1e-12);
    EXPECT_NEAR(Value(output->GetCellData(), "Length", i), exact, 0.02 * exact);
    EXPECT_NEAR(Value(output->GetCellData(), "GraphLength", i), exact, 0.02 * exact);
  }
  EXPECT_EQ(GetPolyline(output, 1).size(), 2u);
  EXPECT_EQ(Value(output->GetPointData(), "vtkOriginalPointIds", 0), -1.0);
}

TEST_F(CloudConsumers, SmoothPaths)
{
  this->Use(MakeSpherePoints(3000));
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->AddPair(10, 1700);
  path->AddPair(2500, 400);
  double errors[2] = { 0.0, 0.0 };
  double turns[2] = { 0.0, 0.0 };
  for (const bool smooth : { false, true })
  {
    path->SetStraighten(smooth);
    ExpectSuccess(path);
    vtkPolyData* output = path->GetOutput();
    ASSERT_EQ(output->GetNumberOfLines(), 2);
    for (vtkIdType i = 0; i < 2; ++i)
    {
      const Points line = GetPolyline(output, i);
      const auto& from = this->Cloud[path->GetPairStart(i)];
      const auto& to = this->Cloud[path->GetPairEnd(i)];
      EXPECT_EQ(Distance(line.front(), from), 0.0);
      EXPECT_EQ(Distance(line.back(), to), 0.0);
      const double exact = SphereDistance(from, to);
      errors[smooth] += std::abs(Value(output->GetCellData(), "Length", i) / exact - 1.0);
      EXPECT_EQ(Value(output->GetCellData(), "Straightened", i), smooth ? 1.0 : 0.0);
      for (const auto& p : line)
      {
        EXPECT_NEAR(Distance(p, { { 0.0, 0.0, 0.0 } }), 1.0, 2e-3);
      }
      // How far it goes to and fro beside the great circle.
      for (std::size_t k = 1; k + 1 < line.size(); ++k)
      {
        const double side = from[0] * (to[1] * line[k][2] - to[2] * line[k][1]) +
          from[1] * (to[2] * line[k][0] - to[0] * line[k][2]) +
          from[2] * (to[0] * line[k][1] - to[1] * line[k][0]);
        turns[smooth] = std::max(turns[smooth], std::abs(side));
      }
    }
    for (vtkIdType i = 0; i < output->GetNumberOfPoints() && !smooth; ++i)
    {
      EXPECT_GE(Value(output->GetPointData(), "vtkOriginalPointIds", i), 0.0);
    }
  }
  EXPECT_LT(errors[1], 0.5 * errors[0]);
  EXPECT_LT(errors[1], 2e-3);
  EXPECT_LT(turns[1], 0.5 * turns[0]);
}

TEST_F(CloudConsumers, SmoothPathsAreBoundedAndStop)
{
  this->Use(MakeSpherePoints(3000));
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->AddPair(10, 1700);
  path->SetMemoryLimit(100000);
  ExpectError(path, { "limit" });
  path->StraightenOff(); // takes no band
  ExpectSuccess(path);
  path->StraightenOn();
  path->SetMemoryLimit(0);
  this->Graph->Update();
  for (const double stop : { 0.1, 0.25 }) // while the band is made, and the path is moved
  {
    vtkNew<vtkDGGPath> stopped; // outlived by its observer
    stopped->SetInputData(this->Graph->GetOutput());
    stopped->AddPair(10, 1700);
    ProgressWatch watch(stopped);
    watch.StopAt = stop;
    stopped->Update();
    EXPECT_EQ(stopped->GetErrorCode(), 0u);
    EXPECT_EQ(stopped->GetOutput()->GetNumberOfLines(), 0);
    EXPECT_LT(watch.Progress.back(), stop + 0.1);
    watch.StopAt = 2.0;
    ExpectSuccess(stopped);
    EXPECT_EQ(stopped->GetOutput()->GetNumberOfLines(), 1);
  }
  ExpectSuccess(path);
}

TEST_F(CloudConsumers, PathsThatDoNotExist)
{
  const Points part = MakeFlatPoints(12, 0.2);
  this->Use(Join(part, Move(part, { { 3.0, 0.0, 0.0 } })));
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->AddPair(0, 200);
  path->AddPair(0, 100);
  ExpectWarning(path, { "not connected by the graph of the cloud" });
  EXPECT_EQ(path->GetOutput()->GetNumberOfLines(), 1);
  path->SetMethodToExact();
  ExpectError(path, { "no exact path on a point cloud", "SetMethodToGraph" });
}

//------------------------------------------------------------------------------
TEST_F(CloudConsumers, Samples)
{
  this->Use(MakeSpherePoints(3000));
  vtkNew<vtkGeodesicSampler> sampler;
  this->Connect(sampler);
  sampler->SetNumberOfSamples(60);
  ExpectSuccess(sampler);
  vtkPolyData* output = sampler->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 60);
  const double radius = Value(output->GetPointData(), "CoveringRadius", 59);
  std::set<double> ids;
  for (vtkIdType i = 0; i < 60; ++i)
  {
    const double id = Value(output->GetPointData(), "vtkOriginalPointIds", i);
    ids.insert(id);
    EXPECT_EQ(Distance(At(output, i), this->Cloud[static_cast<std::size_t>(id)]), 0.0);
    EXPECT_EQ(Value(output->GetPointData(), "FaceId", i), -1.0);
    for (vtkIdType j = 0; j < i; ++j)
    {
      EXPECT_GE(SphereDistance(At(output, i), At(output, j)), radius * 0.99);
    }
  }
  EXPECT_EQ(ids.size(), 60u);
  for (const auto& p : this->Cloud)
  {
    double nearest = 10.0;
    for (vtkIdType i = 0; i < 60; ++i)
    {
      nearest = std::min(nearest, SphereDistance(p, At(output, i)));
    }
    EXPECT_LE(nearest, radius * 1.01);
  }
  const std::set<double> before = ids;
  sampler->InFacesOn(); // there are none
  ExpectSuccess(sampler);
  for (vtkIdType i = 0; i < 60; ++i)
  {
    EXPECT_EQ(
      before.count(Value(sampler->GetOutput()->GetPointData(), "vtkOriginalPointIds", i)), 1u);
  }
}

TEST_F(CloudConsumers, SamplesOfTwoParts)
{
  const Points part = MakeFlatPoints(15, 0.2);
  this->Use(Join(part, Move(part, { { 3.0, 0.0, 0.0 } })));
  vtkNew<vtkGeodesicSampler> sampler;
  this->Connect(sampler);
  sampler->SetNumberOfSamples(2);
  sampler->SetStartData(MakeSourcePoints({ { { 0.3, 0.3, 0.001 } } }));
  ExpectSuccess(sampler);
  EXPECT_LT(At(sampler->GetOutput(), 0)[0], 1.1);
  EXPECT_GT(At(sampler->GetOutput(), 1)[0], 2.9);
}

//------------------------------------------------------------------------------
TEST_F(CloudConsumers, VoronoiLabels)
{
  this->Use(MakeFlatPoints(40, 0.2));
  vtkNew<vtkGeodesicVoronoi> voronoi;
  this->Connect(voronoi);
  voronoi->SetSiteIds({ 0, 1599 });
  voronoi->SetSiteData(MakeSourcePoints({ { { 0.9, 0.1, 0.0 } } }));
  ExpectSuccess(voronoi);
  const Points sites = { this->Cloud[0], this->Cloud[1599], { { 0.9, 0.1, 0.0 } } };
  vtkPointData* data = voronoi->GetOutput()->GetPointData();
  for (std::size_t i = 0; i < this->Cloud.size(); ++i)
  {
    std::array<double, 3> d;
    for (int k = 0; k < 3; ++k)
    {
      d[k] = Distance(this->Cloud[i], sites[k]);
    }
    const auto least = std::min_element(d.begin(), d.end());
    const auto label =
      static_cast<std::size_t>(Value(data, "GeodesicSource", static_cast<vtkIdType>(i)));
    ASSERT_LT(label, 3u);
    EXPECT_LE(d[label], *least + 0.02) << i;
    EXPECT_NEAR(Value(data, "GeodesicDistance", static_cast<vtkIdType>(i)), *least, 0.02);
  }
  // No borders between points that nothing connects.
  EXPECT_EQ(voronoi->GetBoundaries()->GetNumberOfCells(), 0);
  EXPECT_EQ(voronoi->GetCells()->GetNumberOfCells(), 0);
  ASSERT_EQ(voronoi->GetSites()->GetNumberOfPoints(), 3);
  EXPECT_NEAR(Distance(At(voronoi->GetSites(), 2), sites[2]), 0.0, 1e-12);
}

TEST_F(CloudConsumers, CentroidalSites)
{
  this->Use(MakeFlatPoints(50, 0.25));
  vtkNew<vtkGeodesicVoronoi> voronoi;
  this->Connect(voronoi);
  voronoi->SetSiteIds({ 0, 1, 2, 3, 50, 51, 52, 53 }); // all in one corner
  voronoi->CentroidalOn();
  voronoi->SetNumberOfIterations(60);
  ExpectSuccess(voronoi);
  vtkDataArray* energy = voronoi->GetOutput()->GetFieldData()->GetArray("Energy");
  ASSERT_NE(energy, nullptr);
  ASSERT_GT(energy->GetNumberOfTuples(), 5);
  for (vtkIdType i = 1; i < energy->GetNumberOfTuples(); ++i)
  {
    EXPECT_LT(energy->GetTuple1(i), energy->GetTuple1(i - 1));
  }
  EXPECT_LT(energy->GetTuple1(energy->GetNumberOfTuples() - 1), 0.06 * energy->GetTuple1(0));

  // The energy is the sum of the squared distances, and every site is in the middle of its cell.
  vtkPointData* data = voronoi->GetOutput()->GetPointData();
  double sum = 0.0;
  Points middles(8, { { 0.0, 0.0, 0.0 } });
  std::vector<int> counts(8, 0);
  for (vtkIdType i = 0; i < 2500; ++i)
  {
    const double d = Value(data, "GeodesicDistance", i);
    sum += d * d;
    const auto label = static_cast<std::size_t>(Value(data, "GeodesicSource", i));
    ASSERT_LT(label, 8u);
    ++counts[label];
    for (int c = 0; c < 3; ++c)
    {
      middles[label][c] += this->Cloud[i][c];
    }
  }
  EXPECT_NEAR(sum, energy->GetTuple1(energy->GetNumberOfTuples() - 1), 1e-6 * sum);
  for (int k = 0; k < 8; ++k)
  {
    EXPECT_GT(counts[k], 2500 / 8 / 2) << k;
    EXPECT_LT(counts[k], 2500 / 8 * 2) << k;
    for (int c = 0; c < 3; ++c)
    {
      middles[k][c] /= counts[k];
    }
    EXPECT_LT(Distance(middles[k], At(voronoi->GetSites(), k)), 0.05) << k;
    EXPECT_GE(Value(voronoi->GetSites()->GetPointData(), "vtkOriginalPointIds", k), 0.0);
  }
}

TEST_F(CloudConsumers, CentroidalSitesOfSeveralParts)
{
  // Far from the origin, and a part without a site.
  const Points part = Move(MakeFlatPoints(20, 0.2), { { 1000.0, 0.0, 0.0 } });
  this->Use(Join(part, Move(part, { { 3.0, 0.0, 0.0 } })));
  vtkNew<vtkGeodesicVoronoi> voronoi;
  this->Connect(voronoi);
  voronoi->SetSiteIds({ 0, 0, 5 }); // the second has no points
  voronoi->CentroidalOn();
  ExpectSuccess(voronoi);
  vtkPointData* data = voronoi->GetOutput()->GetPointData();
  for (vtkIdType i = 400; i < 800; ++i)
  {
    EXPECT_EQ(Value(data, "GeodesicSource", i), -1.0);
  }
  EXPECT_GT(voronoi->GetOutput()->GetFieldData()->GetArray("Energy")->GetNumberOfTuples(), 2);
}

//------------------------------------------------------------------------------
TEST_F(CloudConsumers, Matrix)
{
  this->Use(MakeFlatPoints(40, 0.2));
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  this->Connect(matrix);
  matrix->SetRowIds({ 0, 100 });
  const Points row = { { { 0.5, 0.5, 0.0 } } };
  const Points columns = { { { 0.51, 0.5, 0.0 } }, { { 0.03, 0.9, 0.0 } }, this->Cloud[100] };
  matrix->SetRowData(MakeSourcePoints(row));
  matrix->SetColumnData(MakeSourcePoints(columns));
  ExpectSuccess(matrix);
  const Points rows = { this->Cloud[0], this->Cloud[100], row[0] };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double exact = Distance(rows[i], columns[j]);
      EXPECT_NEAR(matrix->GetMatrix()->GetComponent(i, j), exact, 0.02 * exact + 1e-12)
        << i << " " << j;
    }
  }
  matrix->SetColumnData(nullptr);
  ExpectSuccess(matrix);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(matrix->GetMatrix()->GetComponent(i, i), 0.0);
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_EQ(matrix->GetMatrix()->GetComponent(i, j), matrix->GetMatrix()->GetComponent(j, i));
    }
  }
}

//------------------------------------------------------------------------------
TEST_F(CloudConsumers, OtherFiltersNeedASurface)
{
  this->Use(MakeFlatPoints(10));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceIds({ 0 });
  vtkNew<vtkExactGeodesicDistance> exact;
  vtkNew<vtkHeatGeodesicDistance> heat;
  vtkNew<vtkFastMarchingGeodesicDistance> marching;
  for (vtkGeodesicDistanceAlgorithm* filter : { static_cast<vtkGeodesicDistanceAlgorithm*>(exact),
         static_cast<vtkGeodesicDistanceAlgorithm*>(heat),
         static_cast<vtkGeodesicDistanceAlgorithm*>(marching) })
  {
    filter->SetInputConnection(this->Graph->GetOutputPort());
    filter->SetSourceIds({ 0 });
    ExpectError(filter, { "no polygons", "vtkPointCloudDGG", "vtkDGGDistance" });
  }
  vtkNew<vtkDGGLoop> loop;
  this->Connect(loop);
  loop->AddPointId(0);
  ExpectError(loop, { "no polygons", "vtkPointCloudDGG" });
  vtkNew<vtkApolloniusIsolines> isolines;
  isolines->SetInputConnection(distance->GetOutputPort());
  isolines->SetValue(0, 0.5);
  ExpectError(isolines, { "no polygons", "vtkPointCloudDGG" });
  vtkNew<vtkGeodesicProbe> probe;
  probe->SetInputConnection(distance->GetOutputPort());
  probe->SetInputData(1, MakeSourcePoints({ { { 0.5, 0.5, 0.0 } } }));
  ExpectError(probe, { "no polygons", "vtkPointCloudDGG" });
}

TEST_F(CloudConsumers, CloudsWithoutAGraph)
{
  const auto cloud = MakeCloud(MakeFlatPoints(10));
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(cloud);
  distance->SetSourceIds({ 0 });
  ExpectError(distance, { "100 points but no polygons", "vtkPointCloudDGG" });
  vtkNew<vtkDGGPath> path;
  path->SetInputData(cloud);
  path->AddPair(0, 1);
  ExpectError(path, { "100 points but no polygons", "vtkPointCloudDGG" });
}

TEST_F(CloudConsumers, FromCloudToMeshAndBack)
{
  const auto mesh = MakeTerrain(15);
  const auto cloud = MakeCloudWithGraph(MakeFlatPoints(15, 0.2));
  vtkNew<vtkDGGDistance> distance;
  distance->SetSourceIds({ 0 });
  distance->SetInputData(cloud);
  ExpectSuccess(distance);
  const std::vector<double> onCloud = GetDistances(distance);
  distance->SetInputData(mesh);
  ExpectSuccess(distance);
  EXPECT_FALSE(distance->GetUsedInputGraph());
  EXPECT_TRUE(distance->GetGraphIsGuaranteed());
  distance->SetInputData(cloud);
  ExpectSuccess(distance);
  EXPECT_EQ(GetDistances(distance), onCloud);
  // A mesh with the graph of its points is a cloud.
  vtkNew<vtkPointCloudDGG> graph;
  graph->SetInputData(mesh);
  distance->SetInputConnection(graph->GetOutputPort());
  ExpectSuccess(distance);
  EXPECT_TRUE(distance->GetUsedInputGraph());
  EXPECT_FALSE(distance->GetGraphIsGuaranteed());
}

TEST_F(CloudConsumers, OtherGraphsOfTheSameCloud)
{
  this->Use(MakeFlatPoints(20, 0.2));
  vtkNew<vtkDGGDistance> distance;
  this->Connect(distance);
  distance->SetSourceData(MakeSourcePoints({ { { 0.512, 0.5, 0.0 } } }));
  ExpectSuccess(distance);
  const std::vector<double> fine = GetDistances(distance);
  this->Graph->SetAccuracy(0.1);
  ExpectSuccess(distance);
  EXPECT_NE(GetDistances(distance), fine);
  this->Graph->SetAccuracy(0.001);
  ExpectSuccess(distance);
  EXPECT_EQ(GetDistances(distance), fine);
}

TEST_F(CloudConsumers, ThreadsDoNotMatter)
{
  this->Use(MakeSpherePoints(600));
  const Points places = { { { 1.0, 0.1, 0.0 } }, { { 0.0, 1.0, 0.02 } } };
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  this->Connect(matrix);
  matrix->SetRowData(MakeSourcePoints(places));
  matrix->SetProjectionTolerance(0.1);
  vtkNew<vtkDGGPath> path;
  this->Connect(path);
  path->AddPair(0, 599);
  path->AddPair(100, 300);
  std::vector<double> first;
  ForEachThreading([&](const std::string& name) {
    matrix->Modified();
    path->Modified();
    ExpectSuccess(matrix);
    ExpectSuccess(path);
    std::vector<double> found = { matrix->GetMatrix()->GetComponent(0, 1) };
    for (vtkIdType i = 0; i < path->GetOutput()->GetNumberOfPoints(); ++i)
    {
      found.push_back(At(path->GetOutput(), i)[0]);
    }
    first = first.empty() ? found : first;
    EXPECT_EQ(found, first) << name;
  });
}
}
