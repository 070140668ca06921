// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: given normals, and normals from planes.
#include "PointCloudDGGFixture.h"

namespace dggtest
{
TEST_F(PointCloudDGG, NormalsByPlanes)
{
  // A small sphere far from the origin.
  const Points points = MakeSpherePoints(1000);
  Points cloud = points;
  for (auto& p : cloud)
  {
    p = { { 1e-6 * (p[0] + 100.0), 1e-6 * p[1], 1e-6 * p[2] } };
  }
  this->Use(cloud);
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
}

TEST_F(PointCloudDGG, NoNormalsByPlanesWhereThereAreNone)
{
  // A square, and a distant line that does not define a plane; also rounded to floats.
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
  this->Filter->EstimateNormalsOn(); // the cloud already has normals
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

TEST_F(PointCloudDGG, OrientedNormalsThatAreNotThere)
{
  this->Use(MakeFlatPoints(15, 0.2));
  this->Filter->OrientedNormalsOn();
  ExpectWarning(this->Filter, { "OrientedNormals", "no effect" });
  EXPECT_EQ(this->Filter->GetNumberOfComponents(), 1);
  // The graph is unchanged and kept, but the warning is repeated.
  this->Filter->OrientedNormalsOff();
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  this->Filter->OrientedNormalsOn();
  ExpectWarning(this->Filter, { "OrientedNormals", "no effect" });
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  // Estimated normals have an arbitrary sign.
  this->Filter->EstimateNormalsOn();
  ExpectWarning(this->Filter, { "OrientedNormals", "no effect" });
  this->Filter->OrientedNormalsOff();
  ExpectSuccess(this->Filter);
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
}
