// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPCDReader: every flavour of the format.
#include "FilterTestTools.h"
#include "PCDTestTools.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <cstdint>

namespace
{
using dggtest::FileCase;
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

/// A header with other values in some lines.
std::string Header(std::string PCDLines::*line, const std::string& value, PCDLines lines = {})
{
  lines.*line = value;
  return lines.Format();
}

const std::string Zeros(400, '0');
const std::string DoubleHeader = "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 1\nDATA ascii\n";
const std::string BinaryHeader = Header(&PCDLines::Data, "binary");
const std::string CompressedHeader = Header(&PCDLines::Data, "binary_compressed");
/// Fields beside the coordinates; one point.
std::string Fields(const std::string& fields, const std::string& size, const std::string& type,
  const std::string& count, const std::string& data)
{
  return PCDLines{ fields, size, type, count, "1", "1", "", "1", data }.Format();
}
std::string PaddingHeader(const std::string& data)
{
  return Fields("x _ y z _ i", "4 1 4 4 2 4", "F U F F I F", "1 3 1 1 2 1", data);
}
const char* const PaddingContents = "float 1 2 3 | verts 0 | i float 4";
const std::string TwoLines = "0 1 2\n3 4 5\n";
const char* const TwoPoints = "float 0 1 2, 3 4 5 | verts 0, 1";

const FileCase Cases[] = {
  { "text", GoodPCD, TwoPoints },
  { "binary", BinaryHeader + Floats({ 0, 1, 2, 3, 4.5f, 5 }), "float 0 1 2, 3 4.5 5 | verts 0, 1" },
  { "binary, filled up with zeros as by PCL",
    BinaryHeader + Floats({ 0, 1, 2, 3, 4.5f, 5 }) + std::string(500, '\0'),
    "float 0 1 2, 3 4.5 5 | verts 0, 1" },
  // Four literal bytes, which are repeated to the end.
  { "compressed", CompressedHeader + Sizes(8, 24) + "\x03" + Floats({ 1.5f }) + "\xE0\x0B\x03",
    "float 1.5 1.5 1.5, 1.5 1.5 1.5 | verts 0, 1" },
  { "numbers too small for doubles",
    DoubleHeader + "0." + Zeros + "1e+10 -1e-400 0." + Zeros + "1\n", "0 0 0 | verts 0" },
  { "digits too large for doubles", DoubleHeader + "1" + Zeros + " 0 0\n", "is out of range" },
  { "digits too large with an exponent below zero", DoubleHeader + "1" + Zeros + "e-10 0 0\n",
    "is out of range" },
  { "exponent too large for doubles", DoubleHeader + "-1e+400 0 0\n", "is out of range" },
  { "coordinates of several types",
    Header(&PCDLines::Type, "F F I", { "x y z", "4 8 2" }) + "0.5 0.1 -7\n1 2 3\n",
    "0.5 0.1 -7, 1 2 3 | verts 0, 1" },
  { "colors and normals of other shapes",
    Fields("x y z rgb rgba normal_x normal_y", "4 4 4 1 4 4 4", "F F F U F F F", "1 1 1 3 2 1 1",
      "ascii") +
      "1 2 3 4 5 6 7 8 9 10\n",
    "float 1 2 3 | verts 0 | rgb unsigned char 4 5 6 | rgba float 7 8 | normal_x float 9 "
    "| normal_y float 10" },
  // 0xFFFFC080, which is not a number as a float.
  { "color in the bits of a float",
    Fields("x y z rgb", "4 4 4 4", "F F F F", "", "binary") + Floats({ 0, 0, 0 }) +
      "\x80\xC0\xFF\xFF",
    "float 0 0 0 | verts 0 | active RGB unsigned char 255 192 128" },
  // The bits of this tiny number are 0x00404080.
  { "color in the text of a float",
    Fields("x y z rgb", "4 4 4 4", "F F F F", "", "ascii") + "0 0 0 5.900609994354369e-39\n",
    "float 0 0 0 | verts 0 | active RGB unsigned char 64 64 128" },
  { "padding in text", PaddingHeader("ascii") + "1 0 0 nothing 2 3 0 0 4\n", PaddingContents },
  { "padding in binary",
    PaddingHeader("binary") + Floats({ 1 }) + "###" + Floats({ 2, 3 }) + "####" + Floats({ 4 }),
    PaddingContents },
  { "compressed without the padding, as by PCL",
    PaddingHeader("binary_compressed") + Sizes(17, 16) + "\x0F" + Floats({ 1, 2, 3, 4 }),
    PaddingContents },
  { "compressed with the padding",
    PaddingHeader("binary_compressed") + Sizes(24, 23) + "\x16" + Floats({ 1 }) + "###" +
      Floats({ 2, 3 }) + "####" + Floats({ 4 }),
    PaddingContents },
  { "points that are not finite",
    PCDLines{ "x y z i", "4 4 4 4", "F F F F", "1 1 1 1", "4", "1", "", "4" }.Format() +
      "0 0 0 1\nnan 0 0 2\n0 NaN -nan 3\n1 1 inf 4\n",
    "float 0 0 0, nan 0 0, 0 nan -nan, 1 1 inf | verts 0 | i float 1, 2, 3, 4" },
  { "no counts of values, one of points",
    "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nDATA ascii\n" + TwoLines, TwoPoints },
  { "fewest lines", "FIELDS x y z\nPOINTS 2\nDATA ascii\n" + TwoLines, TwoPoints },
  { "keywords of older versions",
    "# .PCD v.5\nVERSION .5\nCOLUMNS x y z\nPOINTS 2\nDATA ascii\n" + TwoLines, TwoPoints },
  { "no width", "FIELDS x y z\nWIDTH 0\nHEIGHT 0\nPOINTS 2\nDATA ascii\n" + TwoLines, TwoPoints },
  { "any order", "WIDTH 2\nPOINTS 2\nTYPE F F F\nSIZE 4 4 4\nFIELDS x y z\nDATA ascii\n" + TwoLines,
    TwoPoints },
  { "blanks, comments, line ends of Windows in the header",
    "\n# comment\n\n  FIELDS\tx  y z \r\nPOINTS 2\r\n#\nDATA ascii\r\n" + TwoLines, TwoPoints },
  { "blanks and line ends of Windows between points",
    "FIELDS x y z\nPOINTS 2\nDATA ascii\r\n\r\n0\t1 2 \r\n\n 3 4 5\r\n", TwoPoints },
};

TEST_F(PCDReader, ReadsOrRefuses)
{
  this->Check(Cases);
}

// The shortest text of two points.
TEST_F(PCDReader, WarnsOfTruncatedLastNumbers)
{
  this->ExpectWarningIfCut("FIELDS x y z\nPOINTS 2\nDATA ascii\n0 1 2\n3 4 51\n");
}

TEST_F(PCDReader, KeepsTheLayout)
{
  vtkFieldData* data = this->ReadWell(GoodPCD)->GetFieldData();
  ExpectTuple(data->GetArray("PCD.Viewpoint"), 3, { 1 });
  ExpectTuple(data->GetArray("PCD.Dimensions"), 0, { 2 });
  ExpectTuple(data->GetArray("PCD.Dimensions"), 1, { 1 });
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
