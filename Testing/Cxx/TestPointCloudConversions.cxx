// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkDGGPointCloudConversions.h: conversion of PCL's clouds to vtkPolyData and back.
#include "PCDTestTools.h"

#include "vtkDGGPointCloudConversions.h"

#include "vtkVertexGlyphFilter.h"

#include <pcl/point_types.h>

#include <cstdint>

namespace
{
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using ColoredCloud = pcl::PointCloud<pcl::PointXYZRGB>;
using NormalCloud = pcl::PointCloud<pcl::PointNormal>;

Cloud::Ptr MakeCloud()
{
  Cloud::Ptr cloud(new Cloud);
  cloud->push_back(pcl::PointXYZ(0.1f, 2.0f, 3.0f));
  cloud->push_back(pcl::PointXYZ(std::nanf(""), 2.0f, 3.0f));
  cloud->push_back(pcl::PointXYZ(4.0f, 5.0f, 6.0f));
  return cloud;
}

void ExpectPoint(vtkPolyData* data, vtkIdType id, double x, double y, double z)
{
  double p[3];
  data->GetPoint(id, p);
  EXPECT_EQ(p[0], x);
  EXPECT_EQ(p[1], y);
  EXPECT_EQ(p[2], z);
}

TEST(PointCloudConversions, FromAConstPtrInOneLine)
{
  const Cloud::ConstPtr cloud = MakeCloud();
  vtkNew<vtkVertexGlyphFilter> filter;
  filter->SetInputData(vtkDGG::ToPolyData(cloud));
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 3);
  ExpectPoint(filter->GetOutput(), 0, static_cast<double>(0.1f), 2, 3);
}

TEST(PointCloudConversions, SaysWhatIsMissing)
{
  const vtkSmartPointer<vtkPolyData> data = vtkDGG::ToPolyData(MakeCloud());
  std::vector<std::string> missing;
  NormalCloud normals;
  ASSERT_TRUE(vtkDGG::FromPolyData(data, normals, &missing));
  EXPECT_EQ(missing, (std::vector<std::string>{ "normal_x", "normal_y", "normal_z", "curvature" }));
  EXPECT_EQ(normals[2].y, 5.0f);
  EXPECT_EQ(normals[2].normal_x, pcl::PointNormal().normal_x);
  ColoredCloud colored;
  ASSERT_TRUE(vtkDGG::FromPolyData(data, colored, &missing));
  EXPECT_EQ(missing, (std::vector<std::string>{ "rgb" }));
  EXPECT_EQ(colored[0].a, pcl::PointXYZRGB().a);
}

TEST(PointCloudConversions, ConvertsNumbers)
{
  // Doubles, and an array of another type, converted to a cloud of floats and integers.
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.1, 1e300, -3.0);
  points->InsertNextPoint(1.0, 2.0, 3.0);
  points->InsertNextPoint(1.0, 2.0, 3.0);
  points->InsertNextPoint(1.0, 2.0, 3.0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkFloatArray> labels;
  labels->SetName("label");
  for (const float value : { 7.0f, -1.0f, 1e20f, std::nanf("") })
  {
    labels->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(labels);
  pcl::PointCloud<pcl::PointXYZL> cloud;
  ASSERT_TRUE(vtkDGG::FromPolyData(data, cloud));
  EXPECT_EQ(cloud[0].x, 0.1f);
  EXPECT_EQ(cloud[0].y, std::numeric_limits<float>::infinity());
  EXPECT_EQ(cloud[0].label, 7u);
  EXPECT_EQ(cloud[1].label, 0u);
  EXPECT_EQ(cloud[2].label, 4294967295u);
  EXPECT_EQ(cloud[3].label, 0u);
}

TEST(PointCloudConversions, BlobsOfAnyFields)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const vtkSmartPointer<vtkPolyData> data = dggtest::MakeRichCloud(type);
    pcl::PCLPointCloud2::Ptr blob(new pcl::PCLPointCloud2);
    ASSERT_TRUE(vtkDGG::FromPolyData(data, *blob));
    EXPECT_EQ(blob->width, 3u);
    EXPECT_EQ(blob->height, 2u);
    EXPECT_FALSE(blob->is_dense);
    EXPECT_EQ(blob->row_step, 3 * blob->point_step);
    data->GetFieldData()->RemoveArray("PCD.Viewpoint"); // blobs have no viewpoint
    const auto expectSame = [&] {
      const vtkSmartPointer<vtkPolyData> back = vtkDGG::ToPolyData(blob);
      ASSERT_NE(back, nullptr);
      back->GetFieldData()->RemoveArray("PCD.Viewpoint");
      dggtest::ExpectSameCloud(data, back);
    };
    expectSame();
    EXPECT_NE(vtkDGG::ToPolyData(pcl::PCLPointCloud2::ConstPtr(blob)), nullptr);
    // Data of a machine with the opposite byte order, also with longer rows.
    blob->is_bigendian = !blob->is_bigendian;
    for (std::size_t point = 0; point < blob->data.size(); point += blob->point_step)
    {
      for (const pcl::PCLPointField& field : blob->fields)
      {
        const auto size = static_cast<std::size_t>(pcl::getFieldSize(field.datatype));
        for (std::size_t i = 0; i < field.count; ++i)
        {
          const auto number =
            blob->data.begin() + static_cast<std::ptrdiff_t>(point + field.offset + i * size);
          std::reverse(number, number + static_cast<std::ptrdiff_t>(size));
        }
      }
    }
    expectSame();
    blob->data.insert(blob->data.begin() + blob->row_step, 5, 77);
    blob->row_step += 5;
    expectSame();
  }
}

TEST(PointCloudConversions, BlobsOfTypedClouds)
{
  // Padding between the fields, and rows that are longer than their points.
  Cloud cloud(2, 2, pcl::PointXYZ(1.0f, 2.0f, 3.0f));
  cloud(1, 1).z = 9.0f;
  pcl::PCLPointCloud2 blob;
  pcl::toPCLPointCloud2(cloud, blob);
  EXPECT_EQ(blob.point_step, 16u);
  ExpectPoint(vtkDGG::ToPolyData(blob), 3, 1, 2, 9);
  std::vector<std::uint8_t> wide(100, 77);
  std::copy(blob.data.begin(), blob.data.begin() + 32, wide.begin());
  std::copy(blob.data.begin() + 32, blob.data.end(), wide.begin() + 60);
  blob.data.assign(wide.begin(), wide.begin() + 92); // the last row may end with its points
  blob.row_step = 60;
  ExpectPoint(vtkDGG::ToPolyData(blob), 3, 1, 2, 9);
  ExpectPoint(vtkDGG::ToPolyData(blob), 1, 1, 2, 3);
  // PCL converts blobs from FromPolyData().
  ASSERT_TRUE(vtkDGG::FromPolyData(vtkDGG::ToPolyData(cloud), blob));
  Cloud back;
  pcl::fromPCLPointCloud2(blob, back);
  EXPECT_EQ(back(1, 1).z, 9.0f);
}

TEST(PointCloudConversions, RefusesMalformedBlobs)
{
  const auto good = [] {
    pcl::PCLPointCloud2 blob;
    pcl::toPCLPointCloud2(*MakeCloud(), blob);
    return blob;
  };
  std::string error = "rubbish";
  EXPECT_NE(vtkDGG::ToPolyData(good(), &error), nullptr);
  EXPECT_EQ(error, "");
  const auto expect = [&error](const pcl::PCLPointCloud2& blob, const char* part) {
    EXPECT_EQ(vtkDGG::ToPolyData(blob, &error), nullptr);
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  auto blob = good();
  blob.data.pop_back();
  expect(blob, "3 x 1 points of 16 bytes");
  blob = good();
  blob.width = 4294967295u;
  expect(blob, " bytes, got ");
  blob = good();
  blob.height = 4294967295u;
  expect(blob, " bytes, got ");
  blob = good();
  blob.row_step = 1;
  expect(blob, " bytes, got ");
  blob = good();
  blob.fields[2].offset = 13;
  expect(blob, "'z' reaches beyond");
  blob.fields[2].offset = 4294967295u;
  expect(blob, "'z' reaches beyond");
  blob = good();
  blob.fields[1].count = 4294967295u;
  expect(blob, "'y'");
  blob = good();
  blob.fields[1].count = 2;
  expect(blob, "'y' has 2 values");
  blob.fields[1].count = 0; // PCL's notation for a count of 1
  EXPECT_NE(vtkDGG::ToPolyData(blob, &error), nullptr);
  blob = good();
  blob.fields[1].datatype = 99;
  expect(blob, "'y' has an unknown type of numbers");
  blob = good();
  blob.fields[1].name = "x";
  expect(blob, "two fields 'x'");
  blob.fields[1].name = "w";
  expect(blob, "no field 'y'");
  expect(pcl::PCLPointCloud2(), "no field 'x'");
  // Points without coordinates.
  const pcl::PointCloud<pcl::Normal> normals;
  EXPECT_EQ(vtkDGG::ToPolyData(normals, &error), nullptr);
  EXPECT_NE(error.find("no field 'x'"), std::string::npos);
}

TEST(PointCloudConversions, NothingAtAll)
{
  std::string error;
  EXPECT_EQ(vtkDGG::ToPolyData(Cloud::ConstPtr(), &error), nullptr);
  EXPECT_NE(error, "");
  error.clear();
  EXPECT_EQ(vtkDGG::ToPolyData(pcl::PCLPointCloud2::Ptr(), &error), nullptr);
  EXPECT_NE(error, "");
  Cloud cloud = *MakeCloud();
  EXPECT_FALSE(vtkDGG::FromPolyData(nullptr, cloud));
  EXPECT_TRUE(cloud.empty());
  pcl::PCLPointCloud2 blob;
  EXPECT_FALSE(vtkDGG::FromPolyData(nullptr, blob));
  // An empty cloud is valid.
  vtkSmartPointer<vtkPolyData> data = vtkDGG::ToPolyData(Cloud(), &error);
  ASSERT_NE(data, nullptr);
  EXPECT_EQ(error, "");
  EXPECT_EQ(data->GetNumberOfPoints(), 0);
  EXPECT_TRUE(vtkDGG::FromPolyData(data, cloud));
  EXPECT_TRUE(vtkDGG::FromPolyData(data, blob));
  EXPECT_EQ(blob.fields.size(), 3u);
  ASSERT_NE(vtkDGG::ToPolyData(blob), nullptr);
  vtkNew<vtkPolyData> empty;
  EXPECT_TRUE(vtkDGG::FromPolyData(empty, cloud));
  EXPECT_TRUE(cloud.empty());
}
}
