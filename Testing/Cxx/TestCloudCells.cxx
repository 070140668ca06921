// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkGeodesicSampler and vtkGeodesicVoronoi on point clouds.
#include "CloudFixture.h"

#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include <cstddef>

namespace dggtest
{
namespace
{
class CloudCells : public CloudFixture
{
};
}

TEST_F(CloudCells, Samples)
{
  this->Use(MakeSpherePoints(3000));
  vtkNew<vtkGeodesicSampler> sampler;
  this->Connect(sampler);
  sampler->SetNumberOfSamples(60);
  ExpectSuccess(sampler);
  vtkPolyData* output = sampler->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 60);
  const std::string before = DescribeGeometry(output);
  std::set<double> ids;
  for (vtkIdType i = 0; i < 60; ++i)
  {
    const double id = Value(output->GetPointData(), "vtkOriginalPointIds", i);
    ids.insert(id);
    EXPECT_EQ(Distance(At(output, i), this->Cloud[static_cast<std::size_t>(id)]), 0.0);
    EXPECT_EQ(Value(output->GetPointData(), "FaceId", i), -1.0);
  }
  EXPECT_EQ(ids.size(), 60u);
  sampler->InFacesOn(); // the cloud has no faces
  ExpectSuccess(sampler);
  EXPECT_EQ(DescribeGeometry(sampler->GetOutput()), before);
}

TEST_F(CloudCells, VoronoiLabels)
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
  // There are no borders between points that are not connected.
  EXPECT_EQ(voronoi->GetBoundaries()->GetNumberOfCells(), 0);
  EXPECT_EQ(voronoi->GetCells()->GetNumberOfCells(), 0);
  ASSERT_EQ(voronoi->GetSites()->GetNumberOfPoints(), 3);
  EXPECT_NEAR(Distance(At(voronoi->GetSites(), 2), sites[2]), 0.0, 1e-12);
}

TEST_F(CloudCells, CentroidalSites)
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

  for (vtkIdType k = 0; k < 8; ++k)
  {
    EXPECT_GE(Value(voronoi->GetSites()->GetPointData(), "vtkOriginalPointIds", k), 0.0);
  }
}
}
