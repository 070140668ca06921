// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Conversion of clouds of the Point Cloud Library to vtkPolyData and back. The only header that
/// includes PCL (libpcl_common).
///
/// <b>Input and output</b>. Fields and arrays correspond as in vtkDGGPointFields.h. Width, height,
/// `sensor_origin_` and `sensor_orientation_` are in the field data, `is_dense` follows from the
/// coordinates, and the header (time, frame) is lost. Points that are not finite have no vert.
///
/// <b>Guarantee and cost</b>. Everything is copied; numbers keep their values.
///
/// <b>Errors</b>. See the functions: null or false, and a message.
///
/// @code
/// pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>(10, 1));
/// vtkNew<vtkPointCloudDGG> graph;
/// graph->SetInputData(vtkDGG::ToPolyData(cloud));
/// graph->Update();
/// pcl::PointCloud<pcl::PointXYZ> result;
/// vtkDGG::FromPolyData(graph->GetOutput(), result);
/// @endcode
#ifndef vtkDGGPointCloudConversions_h
#define vtkDGGPointCloudConversions_h

#include "vtkDGGPointFields.h" // for the conversion

#include "vtkObject.h"       // for vtkGenericWarningMacro
#include "vtkPolyData.h"     // for the data
#include "vtkSmartPointer.h" // for the result

#include <pcl/PCLPointCloud2.h> // for clouds of any fields
#include <pcl/PCLPointField.h>  // for fields
#include <pcl/common/io.h>      // for pcl::getFields and types
#include <pcl/memory.h>         // for pcl::shared_ptr
#include <pcl/point_cloud.h>    // for clouds of points

#include <algorithm> // for std::reverse
#include <cstddef>   // for std::size_t
#include <limits>    // for the range of a width
#include <string>    // for messages
#include <vector>    // for fields

namespace vtkDGG
{
namespace Detail
{
/// Converts the description of a field. Returns false if the type of PCL is unknown.
inline bool FromPCLField(const pcl::PCLPointField& in, PointField& out)
{
  const char kind = pcl::getFieldType(static_cast<int>(in.datatype));
  const int size = static_cast<int>(pcl::getFieldSize(static_cast<int>(in.datatype)));
  // PCL treats a count of 0 as 1.
  out = { in.name, kind == 'B' ? 'U' : kind, size, in.count == 0 ? 1 : static_cast<int>(in.count) };
  return size > 0;
}

/// Adds the fields of contiguous points. Returns false on error.
inline bool AddFields(const std::vector<pcl::PCLPointField>& fields, const void* points,
  std::size_t step, PointCloudView& view, std::string& error)
{
  for (const pcl::PCLPointField& in : fields)
  {
    PointFieldView out;
    const bool isKnown = FromPCLField(in, out.Field);
    if (in.name == "_")
    {
      continue; // padding
    }
    if (!isKnown || out.Field.Count < 1)
    {
      error = "the field '" + in.name + "' has an unknown type of numbers";
      return false;
    }
    if (in.offset > step || out.Field.GetBytes() > step - in.offset)
    {
      error = "the field '" + in.name + "' reaches beyond the points, which have " +
        std::to_string(step) + " bytes";
      return false;
    }
    out.Data = points ? static_cast<const char*>(points) + in.offset : nullptr;
    out.Stride = step;
    view.Fields.push_back(out);
  }
  return true;
}

/// Reverses the bytes of all numbers of the points that fill `bytes`.
inline void SwapBytes(const PointCloudView& view, std::size_t step, std::vector<char>& bytes)
{
  for (const PointFieldView& in : view.Fields)
  {
    const auto size = static_cast<std::size_t>(in.Field.Size);
    const auto offset = static_cast<std::size_t>(in.Data - bytes.data());
    for (std::size_t point = 0; size > 1 && point + step <= bytes.size(); point += step)
    {
      char* number = bytes.data() + point + offset;
      for (int i = 0; i < in.Field.Count; ++i, number += size)
      {
        std::reverse(number, number + size);
      }
    }
  }
}

inline vtkSmartPointer<vtkPolyData> Finish(
  const PointCloudView& view, bool isValid, std::string message, std::string* error)
{
  vtkSmartPointer<vtkPolyData> data = isValid ? MakePolyData(view, message) : nullptr;
  if (error)
  {
    *error = data ? std::string() : message;
  }
  else if (!data)
  {
    vtkGenericWarningMacro("The point cloud cannot be converted: " << message);
  }
  return data;
}
}

/// Converts a cloud of any fields, which must include x, y and z. Returns null if the cloud is
/// malformed; `error` receives the defect (empty if there is none), or VTK's output window if it is
/// null.
inline vtkSmartPointer<vtkPolyData> ToPolyData(
  const pcl::PCLPointCloud2& cloud, std::string* error = nullptr)
{
  PointCloudView view;
  std::string message;
  const std::size_t step = cloud.point_step;
  const std::size_t width = cloud.width;
  const std::size_t height = cloud.height;
  // Rows may be longer than their points. row_step may be 0 in clouds of one row.
  const std::size_t row = cloud.row_step == 0 ? step * width : cloud.row_step;
  bool isValid = width == 0 || height == 0 ||
    (row >= step * width && cloud.data.size() >= step * width &&
      height - 1 <= (cloud.data.size() - step * width) / (row == 0 ? 1 : row));
  if (!isValid)
  {
    message = "expected " + std::to_string(width) + " x " + std::to_string(height) + " points of " +
      std::to_string(step) + " bytes, got " + std::to_string(cloud.data.size()) + " bytes";
  }
  const char* points = reinterpret_cast<const char*>(cloud.data.data());
  std::vector<char> packed;
  // The byte order may differ.
  const bool isSwapped = cloud.is_bigendian != pcl::PCLPointCloud2().is_bigendian;
  if (isValid && width > 0 && (isSwapped || (height > 1 && row != step * width)))
  {
    packed.reserve(step * width * height);
    for (std::size_t j = 0; j < height; ++j)
    {
      packed.insert(packed.end(), points + j * row, points + j * row + step * width);
    }
    points = packed.data();
  }
  view.Width = static_cast<vtkIdType>(width);
  view.Height = static_cast<vtkIdType>(height);
  isValid = isValid && Detail::AddFields(cloud.fields, points, step, view, message);
  if (isValid && isSwapped && !packed.empty())
  {
    Detail::SwapBytes(view, step, packed);
  }
  return Detail::Finish(view, isValid, message, error);
}

/// Converts a cloud of any type of point that is registered with PCL and has x, y and z.
template <typename Point>
vtkSmartPointer<vtkPolyData> ToPolyData(
  const pcl::PointCloud<Point>& cloud, std::string* error = nullptr)
{
  PointCloudView view;
  std::string message;
  // Width and height may be unset in clouds of one row.
  const std::size_t count = cloud.size();
  const bool fits =
    cloud.height > 0 && cloud.width == count / cloud.height && count % cloud.height == 0;
  view.Width = static_cast<vtkIdType>(fits ? cloud.width : count);
  view.Height = static_cast<vtkIdType>(fits ? cloud.height : 1);
  for (int i = 0; i < 3; ++i)
  {
    view.Sensor[static_cast<std::size_t>(i)] = cloud.sensor_origin_[i];
    view.Sensor[static_cast<std::size_t>(i + 4)] = cloud.sensor_orientation_.vec()[i];
  }
  view.Sensor[3] = cloud.sensor_orientation_.w();
  const bool isValid =
    Detail::AddFields(pcl::getFields<Point>(), cloud.points.data(), sizeof(Point), view, message);
  return Detail::Finish(view, isValid, message, error);
}

/// Converts the cloud of a shared pointer. Null is an error.
template <typename Cloud>
vtkSmartPointer<vtkPolyData> ToPolyData(
  const pcl::shared_ptr<Cloud>& cloud, std::string* error = nullptr)
{
  return cloud ? ToPolyData(*cloud, error)
               : Detail::Finish(PointCloudView(), false, "there is no cloud", error);
}

/// Copies all points and all arrays of numbers. Returns false and an empty cloud if there are no
/// data or more than PCL can count.
inline bool FromPolyData(vtkPolyData* data, pcl::PCLPointCloud2& cloud)
{
  cloud = pcl::PCLPointCloud2();
  if (!data)
  {
    return false;
  }
  PointCloudView layout;
  GetPointCloudLayout(data, layout);
  const std::vector<PointFieldSource> sources = ListPointFields(data);
  std::size_t step = 0;
  for (const PointFieldSource& source : sources)
  {
    step += source.GetField().GetBytes();
  }
  constexpr std::size_t most = (std::numeric_limits<pcl::uindex_t>::max)();
  const auto width = static_cast<std::size_t>(layout.Width);
  const auto height = static_cast<std::size_t>(layout.Height);
  if (step > most || height > most || (step > 0 && width > most / step))
  {
    return false;
  }
  cloud.width = static_cast<pcl::uindex_t>(width);
  cloud.height = static_cast<pcl::uindex_t>(height);
  cloud.point_step = static_cast<pcl::uindex_t>(step);
  cloud.row_step = static_cast<pcl::uindex_t>(step * width);
  cloud.is_dense = IsPointCloudDense(data);
  cloud.data.resize(step * width * height);
  std::size_t offset = 0;
  for (const PointFieldSource& source : sources)
  {
    const PointField& field = source.GetField();
    pcl::PCLPointField out;
    out.name = field.Name;
    out.offset = static_cast<pcl::uindex_t>(offset);
    out.count = static_cast<pcl::uindex_t>(field.Count);
    out.datatype = static_cast<decltype(out.datatype)>(pcl::getFieldType(field.Size, field.Kind));
    cloud.fields.push_back(out);
    source.Copy(0, data->GetNumberOfPoints(), field.Kind, field.Size,
      reinterpret_cast<char*>(cloud.data.data()) + offset, step);
    offset += field.GetBytes();
  }
  return true;
}

/// Copies the fields of the type of point. Numbers are converted to the types of the fields; `rgba`
/// and `rgb` replace each other. Fields that the data lack keep the value of a new point and are
/// listed in `missing`. Returns false and an empty cloud if there are no data or more points than
/// PCL can count.
template <typename Point>
bool FromPolyData(
  vtkPolyData* data, pcl::PointCloud<Point>& cloud, std::vector<std::string>* missing = nullptr)
{
  cloud = pcl::PointCloud<Point>();
  if (missing)
  {
    missing->clear();
  }
  PointCloudView layout;
  if (data)
  {
    GetPointCloudLayout(data, layout);
  }
  if (!data ||
    static_cast<std::size_t>(data->GetNumberOfPoints()) >
      static_cast<std::size_t>((std::numeric_limits<pcl::index_t>::max)()))
  {
    return false;
  }
  std::vector<PointField> fields;
  std::vector<std::size_t> offsets;
  for (const pcl::PCLPointField& in : pcl::getFields<Point>())
  {
    PointField field;
    if (Detail::FromPCLField(in, field))
    {
      fields.push_back(field);
      offsets.push_back(in.offset);
    }
  }
  cloud.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  cloud.width = static_cast<decltype(cloud.width)>(layout.Width);
  cloud.height = static_cast<decltype(cloud.height)>(layout.Height);
  cloud.is_dense = IsPointCloudDense(data);
  const Viewpoint& sensor = layout.Sensor;
  for (int i = 0; i < 3; ++i)
  {
    cloud.sensor_origin_[i] = static_cast<float>(sensor[static_cast<std::size_t>(i)]);
    cloud.sensor_orientation_.vec()[i] =
      static_cast<float>(sensor[static_cast<std::size_t>(i + 4)]);
  }
  cloud.sensor_orientation_.w() = static_cast<float>(sensor[3]);

  std::vector<PointFieldSource> storage;
  const std::vector<const PointFieldSource*> sources = FindPointFields(data, fields, storage);
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    if (sources[i] && !cloud.empty())
    {
      sources[i]->Copy(0, data->GetNumberOfPoints(), fields[i].Kind, fields[i].Size,
        reinterpret_cast<char*>(cloud.points.data()) + offsets[i], sizeof(Point));
    }
    else if (!sources[i] && missing)
    {
      missing->push_back(fields[i].Name);
    }
  }
  return true;
}
}

#endif
