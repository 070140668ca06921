// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkGeodesicDistanceMatrix on point clouds, and graphs that change upstream of a filter.
#include "CloudFixture.h"
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkGeodesicDistanceMatrix.h"

namespace dggtest
{
namespace
{
class CloudConsumers : public CloudFixture
{
};
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
  // A mesh with the graph of its points is treated as a cloud.
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

}
