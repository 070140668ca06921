// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PCDTestTools.h"

#include "vtkTypeInt64Array.h"

#include <cstring>

namespace dggtest
{
const char* const GoodPCD =
  "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
  "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n0 1 2\n3 4 5\n";

std::string PCDLines::Format() const
{
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n";
  const std::pair<const char*, const std::string*> lines[] = { { "FIELDS ", &this->Fields },
    { "SIZE ", &this->Size }, { "TYPE ", &this->Type }, { "COUNT ", &this->Count },
    { "WIDTH ", &this->Width }, { "HEIGHT ", &this->Height }, { "VIEWPOINT ", &this->Viewpoint },
    { "POINTS ", &this->Points }, { "DATA ", &this->Data } };
  for (const auto& line : lines)
  {
    if (!line.second->empty())
    {
      text += line.first + *line.second + "\n";
    }
  }
  return text;
}

std::string Sizes(std::uint32_t compressed, std::uint32_t uncompressed)
{
  std::string text;
  for (const std::uint32_t size : { compressed, uncompressed })
  {
    for (int i = 0; i < 4; ++i)
    {
      text += static_cast<char>(size >> 8 * i & 255);
    }
  }
  return text;
}

vtkSmartPointer<vtkPolyData> MakeRichCloud(int pointType, bool hasColors)
{
  constexpr vtkIdType count = 6;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const double coordinates[count][3] = { { 0.1, -1.0 / 3.0, 1e-30 }, { nan, nan, nan },
    { 12345.678901234567, -0.0, 3.4e38 }, { inf, -inf, 1.0 }, { 1.4e-45, 16777217.0, 1e10 },
    { -2.5, 1.0 + 1.0 / 8388608.0, 1e-7 } };
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  for (const auto& p : coordinates)
  {
    points->InsertNextPoint(p);
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  vtkPointData* data = cloud->GetPointData();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < 3 * count; ++i)
  {
    normals->SetValue(i, static_cast<float>(std::sin(1.0 + i)));
  }
  normals->SetValue(4, static_cast<float>(nan));
  data->SetNormals(normals);
  for (int components = 3; hasColors && components <= 4; ++components)
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName(components == 3 ? "RGB" : "RGBA");
    colors->SetNumberOfComponents(components);
    colors->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < components * count; ++i)
    {
      colors->SetValue(i, static_cast<unsigned char>(255 - 7 * i));
    }
    data->AddArray(colors);
  }
  if (hasColors)
  {
    data->SetActiveScalars("RGB");
  }
  const std::pair<int, const char*> types[] = { { VTK_SIGNED_CHAR, "int8" },
    { VTK_UNSIGNED_CHAR, "uint8" }, { VTK_SHORT, "int16" }, { VTK_UNSIGNED_SHORT, "uint16" },
    { VTK_INT, "int32" }, { VTK_UNSIGNED_INT, "uint32" }, { VTK_TYPE_INT64, "int64" },
    { VTK_TYPE_UINT64, "uint64" }, { VTK_FLOAT, "intensity" }, { VTK_DOUBLE, "curvature" } };
  for (const auto& type : types)
  {
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type.first));
    array->SetName(type.second);
    array->SetNumberOfTuples(count);
    const double least = array->GetDataTypeMin();
    const double most = array->GetDataTypeMax();
    for (vtkIdType i = 0; i < count; ++i)
    {
      array->SetTuple1(i, i == 0 ? least : i == 1 ? most * 0.9999 : 0.1 + 20.0 * i);
    }
    data->AddArray(array);
  }
  vtkNew<vtkFloatArray> histogram;
  histogram->SetName("fpfh");
  histogram->SetNumberOfComponents(33);
  histogram->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < 33 * count; ++i)
  {
    histogram->SetValue(i, static_cast<float>(std::cos(3.0 * i)));
  }
  data->AddArray(histogram);

  vtkNew<vtkTypeInt64Array> dimensions;
  dimensions->SetName("PCD.Dimensions");
  dimensions->InsertNextValue(3);
  dimensions->InsertNextValue(2);
  cloud->GetFieldData()->AddArray(dimensions);
  vtkNew<vtkDoubleArray> viewpoint;
  viewpoint->SetName("PCD.Viewpoint");
  for (const double value : { 0.1, -2.0, 1.0 / 3.0, 0.5, -0.5, 0.5, 0.5000000001 })
  {
    viewpoint->InsertNextValue(value);
  }
  cloud->GetFieldData()->AddArray(viewpoint);
  return cloud;
}

namespace
{
void ExpectSameArray(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_NE(a, nullptr);
  ASSERT_NE(b, nullptr);
  SCOPED_TRACE(a->GetName() ? a->GetName() : "");
  ASSERT_EQ(a->GetDataType(), b->GetDataType());
  ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents());
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  const auto bytes = static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize());
  EXPECT_TRUE(bytes == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0);
}

const char* GetName(vtkDataArray* array)
{
  return array ? array->GetName() : "(none)";
}
}

void ExpectSameArrays(vtkFieldData* a, vtkFieldData* b)
{
  EXPECT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    ExpectSameArray(a->GetArray(i), b->GetArray(a->GetArray(i)->GetName()));
  }
}

void ExpectSameCloud(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_NE(a, nullptr);
  ASSERT_NE(b, nullptr);
  ExpectSameArray(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  ExpectSameArrays(a->GetPointData(), b->GetPointData());
  ExpectSameArrays(a->GetFieldData(), b->GetFieldData());
  EXPECT_STREQ(GetName(a->GetPointData()->GetScalars()), GetName(b->GetPointData()->GetScalars()));
  EXPECT_STREQ(GetName(a->GetPointData()->GetNormals()), GetName(b->GetPointData()->GetNormals()));
}
}
