// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPCDReader: every flavour of the format.
#include "FilterTestTools.h"
#include "PCDTestTools.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace
{
using dggtest::GoodPCD;
using dggtest::PCDLines;
using dggtest::Sizes;

class PCDReader : public dggtest::PCDTest
{
};

std::string Floats(const std::vector<float>& values)
{
  return std::string(reinterpret_cast<const char*>(values.data()), 4 * values.size());
}

void ExpectTuple(vtkDataArray* array, vtkIdType id, const std::vector<double>& expected)
{
  ASSERT_NE(array, nullptr);
  ASSERT_EQ(array->GetNumberOfComponents(), static_cast<int>(expected.size()));
  for (std::size_t c = 0; c < expected.size(); ++c)
  {
    EXPECT_EQ(array->GetComponent(id, static_cast<int>(c)), expected[c]) << array->GetName();
  }
}

TEST_F(PCDReader, ReadsText)
{
  vtkPolyData* cloud = this->ReadWell(GoodPCD);
  ASSERT_EQ(cloud->GetNumberOfPoints(), 2);
  EXPECT_EQ(cloud->GetPoints()->GetDataType(), VTK_FLOAT);
  ExpectTuple(cloud->GetPoints()->GetData(), 1, { 3, 4, 5 });
  EXPECT_EQ(cloud->GetPointData()->GetNumberOfArrays(), 0);
  // One vertex per point, so that they are seen.
  ASSERT_EQ(cloud->GetNumberOfVerts(), 2);
  vtkNew<vtkIdList> ids;
  cloud->GetCellPoints(1, ids);
  ASSERT_EQ(ids->GetNumberOfIds(), 1);
  EXPECT_EQ(ids->GetId(0), 1);
  ExpectTuple(cloud->GetFieldData()->GetArray("PCD.Viewpoint"), 3, { 1 });
  ExpectTuple(cloud->GetFieldData()->GetArray("PCD.Dimensions"), 0, { 2 });
  ExpectTuple(cloud->GetFieldData()->GetArray("PCD.Dimensions"), 1, { 1 });
}

TEST_F(PCDReader, ReadsBinary)
{
  PCDLines lines;
  lines.Data = "binary";
  const std::string content = lines.Format() + Floats({ 0, 1, 2, 3, 4.5f, 5 });
  vtkPolyData* cloud = this->ReadWell(content);
  ASSERT_EQ(cloud->GetNumberOfPoints(), 2);
  ExpectTuple(cloud->GetPoints()->GetData(), 1, { 3, 4.5, 5 });
  // PCL fills pages with zeros.
  EXPECT_EQ(this->ReadWell(content + std::string(500, '\0'))->GetNumberOfPoints(), 2);
}

TEST_F(PCDReader, ReadsCompressed)
{
  // Two literals and a copy, made by hand: x x, y y, z z, of which all but the first four bytes are
  // repetitions.
  PCDLines lines;
  lines.Data = "binary_compressed";
  const std::string data = std::string("\x03") + Floats({ 1.5f }) + "\xE0\x0B\x03";
  vtkPolyData* cloud =
    this->ReadWell(lines.Format() + Sizes(static_cast<std::uint32_t>(data.size()), 24) + data);
  ASSERT_EQ(cloud->GetNumberOfPoints(), 2);
  ExpectTuple(cloud->GetPoints()->GetData(), 0, { 1.5, 1.5, 1.5 });
  ExpectTuple(cloud->GetPoints()->GetData(), 1, { 1.5, 1.5, 1.5 });
}

TEST_F(PCDReader, DistinguishesTooSmallFromTooLarge)
{
  // Numbers with many zeros, whose exponents have the other sign.
  const std::string zeros(400, '0');
  const std::string head = "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 1\nDATA ascii\n";
  vtkPolyData* cloud = this->ReadWell(head + "0." + zeros + "1e+10 -1e-400 0." + zeros + "1\n");
  ExpectTuple(cloud->GetPoints()->GetData(), 0, { 0.0, 0.0, 0.0 });
  for (const std::string& number : { "1" + zeros + "e-10", "1" + zeros, std::string("-1e+400") })
  {
    this->Reader->SetFileName(this->Write(head + number + " 0 0\n").c_str());
    this->Reader->Modified();
    dggtest::ExpectError(this->Reader, { "is out of range" });
  }
}

TEST_F(PCDReader, MakesDoublesOfOtherCoordinates)
{
  PCDLines lines;
  lines.Size = "4 8 2";
  lines.Type = "F F I";
  vtkPolyData* cloud = this->ReadWell(lines.Format() + "0.5 0.1 -7\n1 2 3\n");
  EXPECT_EQ(cloud->GetPoints()->GetDataType(), VTK_DOUBLE);
  ExpectTuple(cloud->GetPoints()->GetData(), 0, { 0.5, 0.1, -7 });
}

TEST_F(PCDReader, TakesFieldsOfOtherShapesAsTheyAre)
{
  PCDLines lines;
  lines.Fields = "x y z rgb rgba normal_x normal_y";
  lines.Size = "4 4 4 1 4 4 4";
  lines.Type = "F F F U F F F";
  lines.Count = "1 1 1 3 2 1 1";
  vtkPolyData* cloud =
    this->ReadWell(lines.Format() + "1 2 3 4 5 6 7 8 9 10\n0 0 0 0 0 0 0 0 0 0\n");
  vtkPointData* data = cloud->GetPointData();
  EXPECT_EQ(data->GetNormals(), nullptr);
  EXPECT_EQ(data->GetScalars(), nullptr);
  ExpectTuple(data->GetArray("rgb"), 0, { 4, 5, 6 });
  ExpectTuple(data->GetArray("rgba"), 0, { 7, 8 });
  ExpectTuple(data->GetArray("normal_y"), 0, { 10 });
}

TEST_F(PCDReader, ColorsInAFloat)
{
  PCDLines lines;
  lines.Fields = "x y z rgb";
  lines.Size = "4 4 4 4";
  lines.Type = "F F F F";
  lines.Count.clear();
  lines.Data = "binary";
  lines.Width = lines.Points = "1";
  const std::uint32_t packed = 0xFFFFC080; // not a number as a float
  float asFloat = 0.0f;
  std::memcpy(&asFloat, &packed, 4);
  ExpectTuple(this
                ->ReadWell(lines.Format() + Floats({ 0, 0, 0 }) +
                  std::string(reinterpret_cast<const char*>(&packed), 4))
                ->GetPointData()
                ->GetScalars(),
    0, { 255, 192, 128 });
  // Files of old have it as text: 0x00404080 is a tiny number.
  lines.Data = "ascii";
  ExpectTuple(
    this->ReadWell(lines.Format() + "0 0 0 5.900609994354369e-39\n")->GetPointData()->GetScalars(),
    0, { 64, 64, 128 });
}

TEST_F(PCDReader, PassesOverPadding)
{
  PCDLines lines;
  lines.Fields = "x _ y z _ i";
  lines.Size = "4 1 4 4 2 4";
  lines.Type = "F U F F I F";
  lines.Count = "1 3 1 1 2 1";
  lines.Width = lines.Points = "1";
  const auto check = [this](const std::string& content) {
    vtkPolyData* cloud = this->ReadWell(content);
    ExpectTuple(cloud->GetPoints()->GetData(), 0, { 1, 2, 3 });
    ASSERT_EQ(cloud->GetPointData()->GetNumberOfArrays(), 1);
    ExpectTuple(cloud->GetPointData()->GetArray("i"), 0, { 4 });
  };
  check(lines.Format() + "1 0 0 nothing 2 3 0 0 4\n");
  lines.Data = "binary";
  const std::string two("##", 2);
  check(lines.Format() + Floats({ 1 }) + "###" + Floats({ 2, 3 }) + two + two + Floats({ 4 }));
  // Compressed data do not have it with PCL, and may with others.
  lines.Data = "binary_compressed";
  check(lines.Format() + Sizes(17, 16) + "\x0F" + Floats({ 1, 2, 3, 4 }));
  check(lines.Format() + Sizes(24, 23) + "\x16" + Floats({ 1 }) + "###" + Floats({ 2, 3 }) + two +
    two + Floats({ 4 }));
}

TEST_F(PCDReader, KeepsPointsWithoutAPlace)
{
  vtkPolyData* cloud = this->ReadWell(
    PCDLines{ "x y z i", "4 4 4 4", "F F F F", "1 1 1 1", "4", "1", "", "4" }.Format() +
    "0 0 0 1\nnan 0 0 2\n0 NaN -nan 3\n1 1 inf 4\n");
  ASSERT_EQ(cloud->GetNumberOfPoints(), 4);
  EXPECT_TRUE(std::isnan(cloud->GetPoint(1)[0]));
  EXPECT_TRUE(std::isnan(cloud->GetPoint(2)[2]));
  EXPECT_TRUE(std::isinf(cloud->GetPoint(3)[2]));
  ExpectTuple(cloud->GetPointData()->GetArray("i"), 3, { 4 });
  ASSERT_EQ(cloud->GetNumberOfVerts(), 1);
}

TEST_F(PCDReader, AcceptsWhatMayBeMissing)
{
  const std::string body = "0 1 2\n3 4 5\n";
  const auto check = [this, &body](const std::string& header) {
    SCOPED_TRACE(header);
    vtkPolyData* cloud = this->ReadWell(header + body);
    ASSERT_EQ(cloud->GetNumberOfPoints(), 2);
    ExpectTuple(cloud->GetPoints()->GetData(), 1, { 3, 4, 5 });
  };
  check("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nDATA ascii\n");
  check("FIELDS x y z\nPOINTS 2\nDATA ascii\n");
  check("# .PCD v.5\nVERSION .5\nCOLUMNS x y z\nPOINTS 2\nDATA ascii\n");
  check("FIELDS x y z\nWIDTH 0\nHEIGHT 0\nPOINTS 2\nDATA ascii\n");
  check("WIDTH 2\nPOINTS 2\nTYPE F F F\nSIZE 4 4 4\nFIELDS x y z\nDATA ascii\n");
  check("\n# comment\n\n  FIELDS\tx  y z \r\nPOINTS 2\r\n#\nDATA ascii\r\n");
  // The shortest text of two points, whose last number may be truncated.
  this->ExpectWarningIfCut("FIELDS x y z\nPOINTS 2\nDATA ascii\n0 1 2\n3 4 51\n");
  // Blank lines between points, other line ends.
  EXPECT_EQ(this->ReadWell("FIELDS x y z\nPOINTS 2\nDATA ascii\r\n\r\n0\t1 2 \r\n\n 3 4 5\r\n")
              ->GetNumberOfPoints(),
    2);
}

TEST_F(PCDReader, AcceptsManyFields)
{
  std::string names;
  std::string values;
  for (int i = 0; i < 3000; ++i)
  {
    names += " f" + std::to_string(i);
    values += " " + std::to_string(i);
  }
  vtkPolyData* cloud = this->ReadWell("FIELDS" + names + " x y z\nPOINTS 2\nDATA ascii\n" + values +
    " 1 2 3\n" + values + " 4 5 6\n");
  ASSERT_EQ(cloud->GetPointData()->GetNumberOfArrays(), 3000);
  ExpectTuple(cloud->GetPointData()->GetArray("f2999"), 1, { 2999 });
  ExpectTuple(cloud->GetPoints()->GetData(), 1, { 4, 5, 6 });
}

TEST_F(PCDReader, ReportsProgressAndStops)
{
  std::string content = "FIELDS x y z\nPOINTS 200000\nDATA ascii\n";
  for (int i = 0; i < 200000; ++i)
  {
    content += std::to_string(i) + " 0 0\n";
  }
  this->CheckProgress(content, 200000);
}

TEST_F(PCDReader, SkipsTheMarkOfUTF8)
{
  const std::string file = "\xEF\xBB\xBF"
                           "FIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n";
  ExpectTuple(this->ReadWell(file)->GetPoints()->GetData(), 0, { 1.0, 2.0, 3.0 });
  EXPECT_EQ(vtkPCDReader::CanReadFile(this->Write(file).c_str()), 1);
  EXPECT_EQ(vtkPCDReader::CanReadFile(this->Write("\xEF\xBB\xBF").c_str()), 0);
}

}
