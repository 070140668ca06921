// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkGeodesicSampler and vtkGeodesicVoronoi on point clouds.
#include "CloudFixture.h"

#include "vtkFieldData.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>

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
  sampler->InFacesOn(); // the cloud has no faces
  ExpectSuccess(sampler);
  EXPECT_EQ(DescribeGeometry(sampler->GetOutput()), before);
}

TEST_F(CloudCells, SamplesOfTwoParts)
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

  // The energy is the sum of the squared distances.
  double sum = 0.0;
  for (vtkIdType i = 0; i < 2500; ++i)
  {
    const double d = Value(voronoi->GetOutput()->GetPointData(), "GeodesicDistance", i);
    sum += d * d;
  }
  EXPECT_NEAR(sum, energy->GetTuple1(energy->GetNumberOfTuples() - 1), 1e-6 * sum);
  for (vtkIdType k = 0; k < 8; ++k)
  {
    EXPECT_GE(Value(voronoi->GetSites()->GetPointData(), "vtkOriginalPointIds", k), 0.0);
  }
}

TEST_F(CloudCells, CentroidalSitesOfSeveralParts)
{
  // The cloud is far from the origin, and one component has no site.
  const Points part = Move(MakeFlatPoints(20, 0.2), { { 1000.0, 0.0, 0.0 } });
  this->Use(Join(part, Move(part, { { 3.0, 0.0, 0.0 } })));
  vtkNew<vtkGeodesicVoronoi> voronoi;
  this->Connect(voronoi);
  voronoi->SetSiteIds({ 0, 0, 5 }); // the second site has no points
  voronoi->CentroidalOn();
  ExpectSuccess(voronoi);
  vtkPointData* data = voronoi->GetOutput()->GetPointData();
  for (vtkIdType i = 400; i < 800; ++i)
  {
    EXPECT_EQ(Value(data, "GeodesicSource", i), -1.0);
  }
  EXPECT_GT(voronoi->GetOutput()->GetFieldData()->GetArray("Energy")->GetNumberOfTuples(), 2);
}
}
