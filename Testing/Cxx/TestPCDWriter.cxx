// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPCDWriter: data is unchanged after writing and reading, and data that cannot be written is
// reported.
#include "FilterTestTools.h"
#include "PCDTestTools.h"

#include "vtkBitArray.h"
#include "vtkCharArray.h"
#include "vtkErrorCode.h"
#include "vtkPCDWriter.h"
#include "vtkSOADataArrayTemplate.h"

#include <cstring>
#include <filesystem>
#include <random>

namespace
{
const char* const ModeNames[] = { "ascii", "binary", "binary_compressed" };

class PCDWriter : public dggtest::PCDTest
{
protected:
  void WriteWell(vtkPolyData* cloud, int mode = vtkPCDWriter::BINARY)
  {
    this->Writer->SetInputData(cloud);
    this->Writer->SetFileName(this->GetPath("cloud.pcd").c_str());
    this->Writer->SetDataMode(mode);
    dggtest::Listener listener(this->Writer);
    EXPECT_EQ(this->Writer->Write(), 1);
    EXPECT_EQ(this->Writer->GetErrorCode(), vtkErrorCode::NoError);
    EXPECT_EQ(listener.Errors, std::vector<std::string>());
    EXPECT_EQ(listener.Warnings, std::vector<std::string>());
  }
  /// Writes the cloud in all modes and expects the same cloud after reading.
  void ExpectRoundTrip(vtkPolyData* cloud)
  {
    for (int mode = 0; mode <= 2; ++mode)
    {
      SCOPED_TRACE(ModeNames[mode]);
      this->WriteWell(cloud, mode);
      EXPECT_NE(
        this->Load().find(std::string("\nDATA ") + ModeNames[mode] + "\n"), std::string::npos);
      dggtest::ExpectSameCloud(cloud, this->ReadWellFile());
    }
  }
  void ExpectFailure(unsigned long code, const std::vector<std::string>& parts)
  {
    dggtest::Listener listener(this->Writer);
    EXPECT_EQ(this->Writer->Write(), 0);
    EXPECT_EQ(this->Writer->GetErrorCode(), code);
    ASSERT_EQ(listener.Errors.size(), 1u);
    for (const std::string& part : parts)
    {
      EXPECT_NE(listener.Errors[0].find(part), std::string::npos) << listener.Errors[0];
    }
  }
  /// Returns the line of the header that begins with this word.
  std::string GetLine(const std::string& word) const
  {
    const std::string content = this->Load();
    const std::size_t begin = content.find("\n" + word) + 1;
    return content.substr(begin, content.find('\n', begin) - begin);
  }

  vtkNew<vtkPCDWriter> Writer;
};

/// Returns points on a line, with the same layout as the output of the reader.
vtkSmartPointer<vtkPolyData> MakeRow(vtkIdType count)
{
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(0.1 * static_cast<double>(i), 1.0, -2.0);
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  return cloud;
}

TEST_F(PCDWriter, KeepsEverythingInAllModes)
{
  this->ExpectRoundTrip(dggtest::MakeRichCloud(VTK_FLOAT));
  this->ExpectRoundTrip(dggtest::MakeRichCloud(VTK_DOUBLE));
  this->ExpectRoundTrip(dggtest::MakeRichCloud(VTK_DOUBLE, false));
}

TEST_F(PCDWriter, KeepsAllFloats)
{
  // Random bit patterns of valid numbers.
  std::mt19937 random(11);
  auto cloud = MakeRow(20000);
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    array->SetName(type == VTK_FLOAT ? "float" : "double");
    array->SetNumberOfTuples(20000);
    auto* bytes = static_cast<unsigned char*>(array->GetVoidPointer(0));
    for (vtkIdType i = 0; i < 20000 * array->GetDataTypeSize(); ++i)
    {
      bytes[i] = static_cast<unsigned char>(random());
    }
    for (vtkIdType i = 0; i < 20000; ++i)
    {
      if (array->GetTuple1(i) != array->GetTuple1(i))
      {
        array->SetTuple1(i, 0.0); // many bit patterns are NaN, but text has only one NaN
      }
    }
    cloud->GetPointData()->AddArray(array);
  }
  for (int mode = 0; mode <= 2; ++mode)
  {
    this->WriteWell(cloud, mode);
    dggtest::ExpectSameArrays(cloud->GetPointData(), this->ReadWellFile()->GetPointData());
  }
}

TEST_F(PCDWriter, CompressesAnything)
{
  // Data with short, long, few and no repetitions, of lengths close to those of the items of a
  // compressed stream.
  std::mt19937 random(5);
  const struct
  {
    unsigned int Values;
    vtkIdType Period;
  } kinds[] = { { 1, 1 }, { 2, 100000 }, { 256, 100000 }, { 256, 3 }, { 256, 264 }, { 256, 8191 },
    { 256, 8192 }, { 256, 8193 } };
  for (const auto& kind : kinds)
  {
    for (const vtkIdType count :
      { 1, 2, 3, 30, 31, 32, 33, 34, 263, 264, 265, 8191, 8192, 8193, 8194, 60000 })
    {
      SCOPED_TRACE(std::to_string(kind.Period) + " " + std::to_string(count));
      auto cloud = MakeRow(count);
      vtkNew<vtkUnsignedCharArray> bytes;
      bytes->SetName("bytes");
      for (vtkIdType i = 0; i < count; ++i)
      {
        bytes->InsertNextValue(static_cast<unsigned char>(
          i < kind.Period ? random() % kind.Values : bytes->GetValue(i - kind.Period)));
      }
      cloud->GetPointData()->AddArray(bytes);
      this->WriteWell(cloud, vtkPCDWriter::BINARY_COMPRESSED);
      dggtest::ExpectSameArrays(cloud->GetPointData(), this->ReadWellFile()->GetPointData());
    }
  }
  // A row along x: two of three coordinates are constant.
  this->WriteWell(MakeRow(60000), vtkPCDWriter::BINARY_COMPRESSED);
  EXPECT_LT(this->Load().size(), 60000u * 12u / 2u);
}

TEST_F(PCDWriter, WritesTheFewestDigits)
{
  auto cloud = MakeRow(2);
  vtkNew<vtkFloatArray> array;
  array->SetName("a");
  array->InsertNextValue(std::copysign(std::nanf(""), -1.0f));
  array->InsertNextValue(-std::numeric_limits<float>::infinity());
  cloud->GetPointData()->AddArray(array);
  this->WriteWell(cloud, vtkPCDWriter::ASCII);
  EXPECT_EQ(this->Load(),
    "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z a\nSIZE 4 4 4 4\n"
    "TYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\n"
    "DATA ascii\n0 1 -2 nan\n0.1 1 -2 -inf\n");
}

TEST_F(PCDWriter, KeepsTheLayoutWhileItFits)
{
  auto cloud = dggtest::MakeRichCloud(VTK_FLOAT);
  this->WriteWell(cloud);
  EXPECT_EQ(this->GetLine("WIDTH"), "WIDTH 3");
  EXPECT_EQ(this->GetLine("HEIGHT"), "HEIGHT 2");
  EXPECT_EQ(
    this->GetLine("VIEWPOINT"), "VIEWPOINT 0.1 -2 0.3333333333333333 0.5 -0.5 0.5 0.5000000001");
  vtkDataArray* dimensions = cloud->GetFieldData()->GetArray("PCD.Dimensions");
  for (const double width : { 4.0, 0.0, -3.0, 1e18 })
  {
    dimensions->SetComponent(0, 0, width);
    this->WriteWell(cloud);
    EXPECT_EQ(this->GetLine("WIDTH"), "WIDTH 6");
    EXPECT_EQ(this->GetLine("HEIGHT"), "HEIGHT 1");
  }
  vtkNew<vtkDoubleArray> fractions;
  fractions->SetName("PCD.Dimensions");
  fractions->InsertNextValue(1.5);
  fractions->InsertNextValue(4.0);
  cloud->GetFieldData()->AddArray(fractions);
  this->WriteWell(cloud);
  EXPECT_EQ(this->GetLine("WIDTH"), "WIDTH 6");
}

TEST_F(PCDWriter, TakesAllArraysOfNumbers)
{
  auto cloud = MakeRow(3);
  vtkPointData* data = cloud->GetPointData();
  vtkNew<vtkBitArray> bits;
  bits->SetName("bits");
  vtkNew<vtkCharArray> chars;
  chars->SetName("chars");
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  for (int i = 0; i < 3; ++i)
  {
    bits->InsertNextValue(i == 1);
    chars->InsertNextValue(static_cast<char>('a' + i));
    ids->InsertNextValue(vtkIdType(1) << (20 * i));
  }
  vtkNew<vtkSOADataArrayTemplate<float>> apart;
  apart->SetName("apart");
  apart->SetNumberOfComponents(2);
  apart->SetNumberOfTuples(3);
  for (int i = 0; i < 6; ++i)
  {
    apart->SetTypedComponent(i / 2, i % 2, static_cast<float>(i) / 3.0f);
  }
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ bits, chars, ids, apart })
  {
    data->AddArray(array);
  }
  for (int mode = 0; mode <= 2; ++mode)
  {
    this->WriteWell(cloud, mode);
    EXPECT_EQ(this->GetLine("TYPE"), "TYPE F F F U I I F");
    EXPECT_EQ(this->GetLine("SIZE"), "SIZE 4 4 4 1 1 8 4");
    EXPECT_EQ(this->GetLine("COUNT"), "COUNT 1 1 1 1 1 1 2");
    vtkPointData* read = this->ReadWellFile()->GetPointData();
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(read->GetArray("bits")->GetTuple1(i), i == 1);
      EXPECT_EQ(read->GetArray("chars")->GetTuple1(i), 'a' + i);
      EXPECT_EQ(read->GetArray("ids")->GetTuple1(i), ids->GetTuple1(i));
      EXPECT_EQ(read->GetArray("apart")->GetComponent(i, 1), apart->GetComponent(i, 1));
    }
  }
}

TEST_F(PCDWriter, FindsColorsAndNormalsByTheirRole)
{
  auto cloud = MakeRow(1);
  vtkPointData* data = cloud->GetPointData();
  vtkNew<vtkUnsignedCharArray> paint;
  paint->SetName("Paint");
  paint->SetNumberOfComponents(3);
  paint->InsertNextTuple3(1, 2, 3);
  vtkNew<vtkDoubleArray> up;
  up->SetName("Up");
  up->SetNumberOfComponents(3);
  up->InsertNextTuple3(0, 0.1, 1);
  data->AddArray(paint);
  data->AddArray(up);
  this->WriteWell(cloud);
  EXPECT_EQ(this->GetLine("FIELDS"), "FIELDS x y z Paint Up");
  EXPECT_EQ(this->GetLine("COUNT"), "COUNT 1 1 1 3 3");
  data->SetActiveScalars("Paint");
  data->SetActiveNormals("Up");
  this->WriteWell(cloud, vtkPCDWriter::ASCII);
  EXPECT_EQ(this->GetLine("FIELDS"), "FIELDS x y z normal_x normal_y normal_z rgb");
  EXPECT_EQ(this->GetLine("SIZE"), "SIZE 4 4 4 8 8 8 4");
  EXPECT_EQ(this->GetLine("TYPE"), "TYPE F F F F F F U");
  EXPECT_EQ(this->GetLine("0 1"), "0 1 -2 0 0.1 1 4278256131"); // 0xFF010203
  vtkPointData* read = this->ReadWellFile()->GetPointData();
  EXPECT_EQ(read->GetNormals()->GetDataType(), VTK_DOUBLE);
  EXPECT_STREQ(read->GetScalars()->GetName(), "RGB");
}

TEST_F(PCDWriter, ChangesNamesThatCannotBeWritten)
{
  auto cloud = MakeRow(1);
  const char* const names[] = { "a b", "a_b", "x", "_", "", "tab\there\n", "#", "x_", nullptr,
    "Höhe" };
  for (int i = 0; i < 10; ++i)
  {
    vtkNew<vtkIntArray> array;
    array->SetName(names[i]);
    array->InsertNextValue(i);
    cloud->GetPointData()->AddArray(array);
  }
  ASSERT_EQ(cloud->GetPointData()->GetNumberOfArrays(), 10);
  for (int mode = 0; mode <= 2; ++mode)
  {
    this->WriteWell(cloud, mode);
    EXPECT_EQ(this->GetLine("FIELDS"), "FIELDS x y z a_b a_b_ x_ __ ___ tab_here_ # x__ ____ Höhe");
    vtkPointData* data = this->ReadWellFile()->GetPointData();
    ASSERT_EQ(data->GetNumberOfArrays(), 10);
    for (int i = 0; i < 10; ++i)
    {
      EXPECT_EQ(data->GetArray(i)->GetTuple1(0), i);
    }
  }
}

TEST_F(PCDWriter, ReportsWhatCannotBeWritten)
{
  this->Writer->SetInputData(MakeRow(2));
  this->ExpectFailure(vtkErrorCode::NoFileNameError, { "vtkPCDWriter", "Set FileName" });
  this->Writer->SetFileName(this->Folder.string().c_str());
  this->ExpectFailure(vtkErrorCode::CannotOpenFileError, { this->Folder.string(), "opened" });
  const std::string missing = this->GetPath("none/cloud.pcd");
  this->Writer->SetFileName(missing.c_str());
  this->ExpectFailure(vtkErrorCode::CannotOpenFileError, { missing, "opened" });
  if (std::filesystem::exists("/dev/full"))
  {
    this->Writer->SetFileName("/dev/full");
    for (int mode = 0; mode <= 2; ++mode)
    {
      this->Writer->SetDataMode(mode);
      this->ExpectFailure(vtkErrorCode::OutOfDiskSpaceError, { "/dev/full", "enough space" });
    }
    EXPECT_TRUE(std::filesystem::exists("/dev/full"));
  }
  this->WriteWell(MakeRow(2));
}

/// Arrays that are shorter or longer than the points cause an error, and are not read beyond their
/// end.
TEST_F(PCDWriter, ReportsArraysOfAnotherLength)
{
  for (const vtkIdType length : { 0, 2, 1000 })
  {
    for (const std::string name : { "values", "RGB", "Normals" })
    {
      SCOPED_TRACE(name + " " + std::to_string(length));
      const auto cloud = MakeRow(100);
      const auto array = vtkSmartPointer<vtkDataArray>::Take(
        vtkDataArray::CreateDataArray(name == "RGB" ? VTK_UNSIGNED_CHAR : VTK_FLOAT));
      array->SetName(name.c_str());
      array->SetNumberOfComponents(3);
      array->SetNumberOfTuples(length);
      array->Fill(1.0);
      cloud->GetPointData()->AddArray(array);
      cloud->GetPointData()->SetActiveNormals("Normals");
      this->Writer->SetInputData(cloud);
      this->Writer->SetFileName(this->GetPath("cloud.pcd").c_str());
      this->ExpectFailure(vtkErrorCode::FileFormatError, { name, "for 100 points" });
      EXPECT_FALSE(std::filesystem::exists(this->GetPath("cloud.pcd")));
    }
  }
}

TEST_F(PCDWriter, StopsAndLeavesNoPart)
{
  this->Writer->SetInputData(MakeRow(1000000));
  this->Writer->SetFileName(this->GetPath("cloud.pcd").c_str());
  dggtest::ProgressWatch stop(this->Writer);
  for (int mode = 0; mode <= 2; ++mode)
  {
    this->Writer->SetDataMode(mode);
    this->Writer->SetAbortExecute(0);
    stop.StopAt = 0.1;
    EXPECT_EQ(this->Writer->Write(), 0);
    EXPECT_EQ(this->Writer->GetErrorCode(), vtkErrorCode::NoError);
    EXPECT_FALSE(std::filesystem::exists(this->GetPath("cloud.pcd")));
  }
  this->Writer->SetAbortExecute(0);
  stop.StopAt = 2.0;
  EXPECT_EQ(this->Writer->Write(), 1);
  EXPECT_EQ(this->ReadWellFile()->GetNumberOfPoints(), 1000000);
}

}
