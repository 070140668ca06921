// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkGeodesicDistanceMatrix on point clouds, and graphs that change upstream of a filter.
#include "CloudFixture.h"
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkGeodesicDistanceMatrix.h"

#include "vtkDoubleArray.h"

#include <vector>

namespace dggtest
{
namespace
{
class CloudConsumers : public CloudFixture
{
};
}

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
