// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPCDReader reads files of PCL, and PCL reads files of vtkPCDWriter, without any change of the
// data.
#include "PCDTestTools.h"

#include "vtkDGGPointCloudConversions.h"
#include "vtkPCDWriter.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <cstring>
#include <random>

namespace dggtest
{
/// A custom point type: double coordinates, and a field of each other type.
struct SurveyPoint
{
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double time = 0.0;
  float histogram[33] = {};
  std::uint32_t label = 0;
  std::int32_t offset = 0;
  std::uint16_t ring = 0;
  std::int16_t slope = 0;
  std::uint8_t flags = 0;
  std::int8_t level = 0;
};
}

POINT_CLOUD_REGISTER_POINT_STRUCT(dggtest::SurveyPoint,
  (double, x, x)(double, y, y)(double, z, z)(double, time, time)(float[33], histogram, fpfh)(
    std::uint32_t, label, label)(std::int32_t, offset, offset)(std::uint16_t, ring, ring)(
    std::int16_t, slope, slope)(std::uint8_t, flags, flags)(std::int8_t, level, level))

namespace
{
constexpr int Modes = 3;

class PCDAgainstPCL : public dggtest::PCDTest
{
protected:
  template <typename Point>
  std::string SaveWithPCL(const pcl::PointCloud<Point>& cloud, int mode) const
  {
    const std::string path = this->GetPath("pcl.pcd");
    pcl::PCDWriter writer;
    EXPECT_EQ(mode == vtkPCDWriter::ASCII ? writer.writeASCII(path, cloud, 17)
        : mode == vtkPCDWriter::BINARY    ? writer.writeBinary(path, cloud)
                                          : writer.writeBinaryCompressed(path, cloud),
      0);
    return path;
  }
  void SaveWithVTK(vtkPolyData* data, int mode) const
  {
    vtkNew<vtkPCDWriter> writer;
    writer->SetInputData(data);
    writer->SetDataMode(mode);
    writer->SetFileName(this->GetPath("vtk.pcd").c_str());
    EXPECT_EQ(writer->Write(), 1);
  }

  /// Expects the same cloud after conversion to vtkPolyData and back, and after writing by either
  /// library and reading by the other.
  template <typename Point>
  void ExpectSameBothWays(const pcl::PointCloud<Point>& cloud)
  {
    vtkSmartPointer<vtkPolyData> expected = vtkDGG::ToPolyData(cloud);
    ASSERT_NE(expected, nullptr);
    pcl::PointCloud<Point> converted;
    std::vector<std::string> missing = { "rubbish" };
    ASSERT_TRUE(vtkDGG::FromPolyData(expected, converted, &missing));
    EXPECT_TRUE(missing.empty());
    EXPECT_EQ(converted.is_dense, cloud.is_dense);
    this->ExpectSamePoints(cloud, converted);
    for (int mode = 0; mode < Modes; ++mode)
    {
      SCOPED_TRACE(mode);
      this->SaveWithPCL(cloud, mode);
      dggtest::ExpectSameCloud(expected, this->ReadWellFile("pcl.pcd"));

      this->SaveWithVTK(expected, mode);
      pcl::PointCloud<Point> read;
      ASSERT_EQ(pcl::io::loadPCDFile(this->GetPath("vtk.pcd"), read), 0);
      this->ExpectSamePoints(cloud, read);
    }
  }

  template <typename Point>
  static void ExpectSamePoints(const pcl::PointCloud<Point>& a, const pcl::PointCloud<Point>& b)
  {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.sensor_origin_, b.sensor_origin_);
    EXPECT_EQ(a.sensor_orientation_.coeffs(), b.sensor_orientation_.coeffs());
    for (const pcl::PCLPointField& field : pcl::getFields<Point>())
    {
      const std::size_t bytes =
        field.count * static_cast<std::size_t>(pcl::getFieldSize(field.datatype));
      for (std::size_t i = 0; i < a.size(); ++i)
      {
        const auto* p = reinterpret_cast<const char*>(&a[i]) + field.offset;
        const auto* q = reinterpret_cast<const char*>(&b[i]) + field.offset;
        float f = 0.0f;
        std::memcpy(&f, p, 4);
        const bool isSame = std::memcmp(p, q, bytes) == 0;
        ASSERT_TRUE(isSame) << field.name << " of point " << i << " " << f;
      }
    }
  }
};

/// Returns five points, one of them not finite, with values that need all of their digits.
template <typename Point>
pcl::PointCloud<Point> MakeCloud()
{
  pcl::PointCloud<Point> cloud;
  for (int i = 0; i < 6; ++i)
  {
    Point point;
    point.x = static_cast<decltype(point.x)>(std::sin(1.0 + i) / 3.0);
    point.y = static_cast<decltype(point.y)>(std::exp(7.0 * i - 20.0));
    point.z = static_cast<decltype(point.z)>(-1.0 / (1.0 + i));
    cloud.push_back(point);
  }
  cloud[2].x = cloud[2].y = cloud[2].z = std::numeric_limits<decltype(cloud[2].x)>::quiet_NaN();
  cloud.is_dense = false;
  return cloud;
}

TEST_F(PCDAgainstPCL, Colors)
{
  auto rgb = MakeCloud<pcl::PointXYZRGB>();
  auto rgba = MakeCloud<pcl::PointXYZRGBA>();
  for (std::size_t i = 0; i < rgb.size(); ++i)
  {
    rgb[i].r = rgba[i].r = static_cast<std::uint8_t>(255 - i);
    rgb[i].g = rgba[i].g = static_cast<std::uint8_t>(40 * i);
    rgb[i].b = rgba[i].b = static_cast<std::uint8_t>(3 * i);
    rgba[i].a = static_cast<std::uint8_t>(50 * i);
  }
  this->ExpectSameBothWays(rgb);
  this->ExpectSameBothWays(rgba);
}

TEST_F(PCDAgainstPCL, Normals)
{
  auto cloud = MakeCloud<pcl::PointNormal>();
  auto colored = MakeCloud<pcl::PointXYZRGBNormal>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const auto t = static_cast<float>(i);
    cloud[i].normal_x = colored[i].normal_x = std::sin(t);
    cloud[i].normal_y = colored[i].normal_y = std::cos(t);
    cloud[i].normal_z = colored[i].normal_z = i == 4 ? std::nanf("") : 0.3f;
    cloud[i].curvature = colored[i].curvature = 0.1f * t;
    colored[i].r = static_cast<std::uint8_t>(30 * i);
  }
  this->ExpectSameBothWays(cloud);
  this->ExpectSameBothWays(colored);
}

TEST_F(PCDAgainstPCL, OtherTypesAndCounts)
{
  auto cloud = MakeCloud<dggtest::SurveyPoint>();
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    dggtest::SurveyPoint& point = cloud[i];
    point.time = 1.6e9 + 1e-6 * static_cast<double>(i);
    for (std::size_t k = 0; k < 33; ++k)
    {
      point.histogram[k] = std::sin(static_cast<float>(33 * i + k));
    }
    point.label = 4294967295u - static_cast<std::uint32_t>(i);
    point.offset = i == 0 ? std::numeric_limits<std::int32_t>::min() : -static_cast<int>(i);
    point.ring = static_cast<std::uint16_t>(65535 - i);
    point.slope = static_cast<std::int16_t>(-32768 + static_cast<int>(i));
    point.flags = static_cast<std::uint8_t>(255 - i);
    point.level = static_cast<std::int8_t>(-128 + static_cast<int>(i));
  }
  this->ExpectSameBothWays(cloud);
  vtkPolyData* read = this->ReadWellFile("pcl.pcd");
  EXPECT_EQ(read->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(read->GetPointData()->GetArray("fpfh")->GetNumberOfComponents(), 33);
  EXPECT_EQ(read->GetPointData()->GetArray("level")->GetDataType(), VTK_SIGNED_CHAR);
}

TEST_F(PCDAgainstPCL, Layout)
{
  auto cloud = MakeCloud<pcl::PointXYZ>();
  cloud.width = 2;
  cloud.height = 3;
  // PCL writes these values with six digits.
  cloud.sensor_origin_ = Eigen::Vector4f(0.5f, -2.25f, 100.0f, 0.0f);
  cloud.sensor_orientation_ = Eigen::Quaternionf(0.5f, -0.5f, 0.5f, 0.5f);
  this->ExpectSameBothWays(cloud);
  vtkFieldData* field = this->ReadWellFile("pcl.pcd")->GetFieldData();
  EXPECT_EQ(field->GetArray("PCD.Dimensions")->GetComponent(1, 0), 3);
  EXPECT_EQ(field->GetArray("PCD.Viewpoint")->GetComponent(4, 0), -0.5);
}

TEST_F(PCDAgainstPCL, ManyPoints)
{
  // More points than a block of the writer, and compressed data of all kinds of items.
  std::mt19937 random(3);
  pcl::PointCloud<pcl::PointXYZI> cloud;
  for (int i = 0; i < 400000; ++i)
  {
    pcl::PointXYZI point;
    point.x = 0.001f * static_cast<float>(i % 1000);
    point.y = 0.5f * static_cast<float>(i / 1000);
    point.z = static_cast<float>(random()) / 4294967296.0f;
    point.intensity = static_cast<float>(random() % 3);
    cloud.push_back(point);
  }
  this->ExpectSameBothWays(cloud);
}

TEST_F(PCDAgainstPCL, FilesOfPCLBlobs)
{
  // PCL writes clouds of arbitrary fields with separate functions, whose binary files end in zeros.
  const auto data = dggtest::MakeRichCloud(VTK_DOUBLE);
  pcl::PCLPointCloud2 blob;
  ASSERT_TRUE(vtkDGG::FromPolyData(data, blob));
  pcl::PCDWriter writer;
  const Eigen::Vector4f origin = Eigen::Vector4f::Zero();
  const Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  data->GetFieldData()->RemoveArray("PCD.Viewpoint");
  for (int mode = 0; mode < Modes; ++mode)
  {
    SCOPED_TRACE(mode);
    const std::string path = this->GetPath("blob.pcd");
    ASSERT_EQ(mode == 0 ? writer.writeASCII(path, blob, origin, orientation, 17)
        : mode == 1     ? writer.writeBinary(path, blob, origin, orientation)
                        : writer.writeBinaryCompressed(path, blob, origin, orientation),
      0);
    vtkPolyData* read = this->ReadWellFile("blob.pcd");
    read->GetFieldData()->RemoveArray("PCD.Viewpoint");
    dggtest::ExpectSameCloud(data, read);

    // PCL reads the file of vtkPCDWriter to the same bytes.
    this->SaveWithVTK(data, mode);
    pcl::PCLPointCloud2 again;
    ASSERT_EQ(pcl::io::loadPCDFile(this->GetPath("vtk.pcd"), again), 0);
    EXPECT_EQ(again.width, blob.width);
    EXPECT_EQ(again.height, blob.height);
    EXPECT_EQ(again.data == blob.data, true);
    ASSERT_EQ(again.fields.size(), blob.fields.size());
    for (std::size_t i = 0; i < blob.fields.size(); ++i)
    {
      EXPECT_EQ(again.fields[i].name, blob.fields[i].name);
      EXPECT_EQ(again.fields[i].offset, blob.fields[i].offset);
      EXPECT_EQ(again.fields[i].count, blob.fields[i].count);
      if (blob.fields[i].name != "rgb") // unsigned in files, float in clouds
      {
        EXPECT_EQ(again.fields[i].datatype, blob.fields[i].datatype);
      }
    }
  }
}

TEST_F(PCDAgainstPCL, NoPoints)
{
  const pcl::PointCloud<pcl::PointXYZI> cloud;
  for (int mode = 0; mode < Modes; ++mode)
  {
    const std::string path = this->GetPath("pcl.pcd");
    pcl::PCDWriter writer;
    // PCL may report an error for an empty cloud, but nevertheless writes a file.
    mode == 0     ? writer.writeASCII(path, cloud)
      : mode == 1 ? writer.writeBinary(path, cloud)
                  : writer.writeBinaryCompressed(path, cloud);
    vtkPolyData* read = this->ReadWellFile("pcl.pcd");
    EXPECT_EQ(read->GetNumberOfPoints(), 0);
    EXPECT_NE(read->GetPointData()->GetArray("intensity"), nullptr);
  }
}
}
