// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graphs with automatic defaults, and the filters that search them, on every point cloud
/// (clouds/*.ply) of the folder DGG_EXTRA_DATA.

#include "ExtraMeshes.h"
#include "FilterTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkDGGPath.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkPLYReader.h"
#include "vtkPointCloudDGG.h"

namespace dggtest
{
namespace
{
class ExtraClouds : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    this->Reader->SetFileName(GetParam().c_str());
    this->Graph->SetInputConnection(this->Reader->GetOutputPort());
    ExpectSuccess(this->Graph);
    this->Cloud = this->Graph->GetOutput();
    ASSERT_GT(this->Cloud->GetNumberOfPoints(), 0);
    vtkDataArray* components = this->Cloud->GetPointData()->GetArray("Component");
    ASSERT_NE(components, nullptr);
    for (vtkIdType i = 0; i < this->Cloud->GetNumberOfPoints(); ++i)
    {
      this->IsMain.push_back(components->GetTuple1(i) == 0.0);
      this->Start = this->Start < 0 && this->IsMain.back() ? i : this->Start;
    }
  }

  vtkNew<vtkPLYReader> Reader;
  vtkNew<vtkPointCloudDGG> Graph;
  vtkPolyData* Cloud = nullptr;
  std::vector<bool> IsMain; // true if the point is in the largest component
  vtkIdType Start = -1;     // a point of the largest component
};
}

TEST_P(ExtraClouds, MostPointsAreConnected)
{
  const vtkIdType n = this->Cloud->GetNumberOfPoints();
  vtkIdType sum = this->Graph->GetNumberOfUnusedPoints();
  for (vtkIdType i = 0; i < this->Graph->GetNumberOfComponents(); ++i)
  {
    sum += this->Graph->GetComponentSize(i);
  }
  EXPECT_EQ(sum, n);
  // One of the scans contains several separate objects.
  EXPECT_GT(static_cast<double>(this->Graph->GetComponentSize(0)), 0.7 * static_cast<double>(n));
  EXPECT_LT(this->Graph->GetMeanDegree(), 300.0);
}

TEST_P(ExtraClouds, DistancesAndPaths)
{
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(this->Graph->GetOutputPort());
  distance->SetSourceIds({ this->Start });
  ExpectSuccess(distance);
  const std::vector<double> values = GetDistances(distance);
  vtkIdType farthest = this->Start;
  for (vtkIdType i = 0; i < this->Cloud->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(std::isfinite(values[i]), this->IsMain[i]) << i;
    if (this->IsMain[i])
    {
      // Lengths are corrected for noise, which matters for close points.
      const double straight = EuclideanDistance(this->Cloud, i, this->Start);
      const double slack = 2.0 * (this->Graph->GetSpacing() + this->Graph->GetNoise());
      ASSERT_GE(values[i], straight * 0.99 - slack) << i;
      farthest = values[i] > values[farthest] ? i : farthest;
    }
  }
  vtkNew<vtkDGGPath> path;
  path->SetInputConnection(this->Graph->GetOutputPort());
  path->AddPair(farthest, this->Start);
  ExpectSuccess(path);
  vtkCellData* data = path->GetOutput()->GetCellData();
  ASSERT_EQ(path->GetOutput()->GetNumberOfLines(), 1);
  EXPECT_NEAR(
    data->GetArray("GraphLength")->GetTuple1(0), values[farthest], 1e-6 * values[farthest]);
  const double length = data->GetArray("Length")->GetTuple1(0);
  EXPECT_LE(length, values[farthest] * 1.05);
  EXPECT_GE(length, EuclideanDistance(this->Cloud, farthest, this->Start) * (1.0 - 1e-6));
}

TEST_P(ExtraClouds, SamplesAndCells)
{
  vtkNew<vtkGeodesicSampler> sampler;
  sampler->SetInputConnection(this->Graph->GetOutputPort());
  sampler->SetNumberOfSamples(100);
  ExpectSuccess(sampler);
  ASSERT_EQ(sampler->GetOutput()->GetNumberOfPoints(), 100);
  vtkNew<vtkGeodesicVoronoi> voronoi;
  voronoi->SetInputConnection(this->Graph->GetOutputPort());
  voronoi->SetSiteConnection(sampler->GetOutputPort());
  voronoi->CentroidalOn();
  ExpectSuccess(voronoi);
  vtkDataArray* energy = voronoi->GetOutput()->GetFieldData()->GetArray("Energy");
  ASSERT_NE(energy, nullptr);
  EXPECT_GT(energy->GetNumberOfTuples(), 2);
  EXPECT_LT(energy->GetTuple1(energy->GetNumberOfTuples() - 1), 0.99 * energy->GetTuple1(0));
}

INSTANTIATE_TEST_SUITE_P(Files, ExtraClouds, testing::ValuesIn(FindExtraClouds()), NameExtraMesh);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ExtraClouds);
}
