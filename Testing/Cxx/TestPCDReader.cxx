// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPCDReader: all dialects of the format, and damaged files.
#include "FilterTestTools.h"
#include "PCDTestTools.h"

#include "vtkPCDReader.h"
#include "vtkPCDWriter.h"

#include <sys/resource.h>

#include <random>

namespace
{
using dggtest::FileCase;
using dggtest::GoodPCD;
using dggtest::PCDLines;
using dggtest::Sizes;

class PCDReader : public dggtest::PCDTest
{
protected:
  /// Returns a small file of the given mode with several kinds of fields.
  std::string MakeFile(int mode)
  {
    vtkNew<vtkPCDWriter> writer;
    writer->SetInputData(dggtest::MakeRichCloud(VTK_FLOAT));
    writer->SetFileName(this->GetPath("rich.pcd").c_str());
    writer->SetDataMode(mode);
    EXPECT_EQ(writer->Write(), 1);
    return this->Load("rich.pcd");
  }

  /// Returns true if the file is read, and false if it is refused with an empty output.
  bool Survives(const std::string& content)
  {
    this->Reader->SetFileName(this->Write(content).c_str());
    this->Reader->Modified();
    dggtest::Listener listener(this->Reader);
    this->Reader->Update();
    const bool isRead = this->Reader->GetErrorCode() == vtkErrorCode::NoError;
    EXPECT_EQ(listener.Errors.size(), isRead ? 0u : 1u);
    if (!isRead)
    {
      dggtest::ExpectEmptyOutput(this->Reader);
    }
    return isRead;
  }
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

/// Returns a header with one replaced line.
std::string Header(std::string PCDLines::*line, const std::string& value, PCDLines lines = {})
{
  lines.*line = value;
  return lines.Format();
}

const std::string Zeros(400, '0');
const std::string DoubleHeader = "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 1\nDATA ascii\n";
const std::string BinaryHeader = Header(&PCDLines::Data, "binary");
const std::string CompressedHeader = Header(&PCDLines::Data, "binary_compressed");
/// Returns a file of one point with fields in addition to the coordinates.
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
const std::string TextHeader = PCDLines().Format();
const std::string WithByte = Fields("x y z i", "4 4 4 1", "F F F U", "1 1 1 1", "ascii");
const std::string WithSignedByte = Fields("x y z i", "4 4 4 1", "F F F I", "1 1 1 1", "ascii");
const std::string CompressedAt = "byte " + std::to_string(CompressedHeader.size()) + ": ";
const char* const Damaged = "the compressed data are damaged";
constexpr auto Premature = vtkErrorCode::PrematureEndOfFileError;
const char* const TwoPoints = "float 0 1 2, 3 4 5 | verts 0, 1";

const FileCase Cases[] = {
  { "text", GoodPCD, TwoPoints },
  { "binary", BinaryHeader + Floats({ 0, 1, 2, 3, 4.5f, 5 }), "float 0 1 2, 3 4.5 5 | verts 0, 1" },
  { "binary, filled up with zeros as by PCL",
    BinaryHeader + Floats({ 0, 1, 2, 3, 4.5f, 5 }) + std::string(500, '\0'),
    "float 0 1 2, 3 4.5 5 | verts 0, 1" },
  // Four literal bytes, which are repeated until the end.
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
  // 0xFFFFC080, which is NaN as a float.
  { "color in the bits of a float",
    Fields("x y z rgb", "4 4 4 4", "F F F F", "", "binary") + Floats({ 0, 0, 0 }) +
      "\x80\xC0\xFF\xFF",
    "float 0 0 0 | verts 0 | active RGB unsigned char 255 192 128" },
  // 0x00404080, the bits of this tiny number.
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
  { "text", TextHeader + "0 0 0\n0 zero 0\n",
    "line 13: the field 'y' of point 1: 'zero' is not a number" },
  { "text", TextHeader + "0 0 1e39\n0 0 0\n", "line 12: *'1e39' is out of range" },
  { "text", TextHeader + "0.5 0\n0 0 0\n", "line 12: point 0 has 2 values. Expected 3" },
  { "text", TextHeader + "0 0 0 0\n0 0 0\n", "line 12: point 0 has more than 3 values" },
  { "text", TextHeader + "0 0 0 0 0 0\n", "line 12: point 0 has more than 3 values" },
  { "text", TextHeader + "0 0 0\n\n0.25 0.25", "line 14: point 1 has 2 values", Premature },
  { "text", TextHeader + "0.125 0.125 0.125\n", "the file ends after 1 of 2 points", Premature },
  { "text", TextHeader + "0 0 0\n1 1 1\n2 2 2\n",
    "line 14: data follow the last of 2 points. Increase POINTS" },
  { "text", TextHeader + "0 0 0\n1 1 1\nend\n", "line 14: data follow" },
  { "text", WithByte + "0 0 0 256\n", "'i' of point 0: '256' is out of" },
  { "text", WithByte + "0 0 0 -1\n", "'-1' is not an integer" },
  { "text", WithByte + "0 0 0 1.5\n", "'1.5' is not an integer" },
  { "text", WithSignedByte + "0 0 0 128\n", "'128' is out of" },
  { "height alone", PCDLines{ "x y z", "4 4 4", "F F F", "1 1 1", "", "2" }.Format() + TwoLines,
    "HEIGHT is given without WIDTH" },
  { "no number of points", "FIELDS x y z\nDATA ascii\n" + TwoLines, "neither WIDTH nor POINTS" },
  { "line twice", "FIELDS x y z\nFIELDS x y z\nPOINTS 2\nDATA ascii\n" + TwoLines,
    "line 2: the header has a second FIELDS" },
  { "columns and fields", "FIELDS x y z\nCOLUMNS x y z\nPOINTS 2\nDATA ascii\n" + TwoLines,
    "both FIELDS and COLUMNS" },
  { "unknown keyword", "VERSION 0.7\nFIELDS x y z\nUNITS m\nPOINTS 2\nDATA ascii\n" + TwoLines,
    "line 3: 'UNITS' is not a keyword of the header of a PCD file" },
  { "arrays of one name",
    "FIELDS x y z normal_x normal_y normal_z Normals\nPOINTS 1\nDATA ascii\n0 0 0 0 0 1 5\n",
    "both become the array Normals" },
  { "values of each point",
    "FIELDS x y z q\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 100000000\nPOINTS 0\nDATA binary\n",
    "line 5: COUNT declares 100000003 values per point" },
  { "huge points", Fields("x y z h", "4 4 4 8", "F F F F", "1 1 1 2000000000", "ascii") + "0 0 0\n",
    "more than 2 GB" },
  { "compressed", CompressedHeader + "1234567", "before the sizes of the compressed data",
    Premature },
  { "compressed", CompressedHeader + Sizes(9, 24) + "12345678",
    CompressedAt + "9 bytes*but 8 follow", Premature },
  { "compressed", CompressedHeader + Sizes(4294967295u, 24) + "12345678",
    CompressedAt + "4294967295 bytes*but 8 follow", Premature },
  { "compressed", CompressedHeader + Sizes(8, 25) + "12345678",
    CompressedAt + "the compressed data declare 25 bytes, which are not 2 points of 12 bytes" },
  { "compressed", CompressedHeader + Sizes(8, 0) + "12345678", "declare 0 bytes" },
  { "literal too long", CompressedHeader + Sizes(3, 24) + "\x1F" + "ab", Damaged },
  { "no past", CompressedHeader + Sizes(2, 24) + std::string("\x20\x00", 2), Damaged },
  { "no distance", CompressedHeader + Sizes(1, 24) + "\x20", Damaged },
  { "no length", CompressedHeader + Sizes(3, 24) + std::string("\x00\x61\xE0", 3), Damaged },
  { "no distance of many", CompressedHeader + Sizes(4, 24) + std::string("\x00\x61\xE0\x00", 4),
    Damaged },
  { "too much", CompressedHeader + Sizes(5, 24) + std::string("\x00\x61\xE0\xFF\x00", 5), Damaged },
  { "too little", CompressedHeader + Sizes(4, 24) + std::string("\x00\x61\x20\x00", 4), Damaged },
  { "data behind the end",
    CompressedHeader + Sizes(5, 24) + std::string("\x00\x61\xE0\x0E\x00!", 6),
    "data follow the last of 2 points" },
};

/// Invalid lines of a header of two points.
const struct
{
  std::string PCDLines::*Line;
  const char* Value;
  const char* Error;
} HeaderCases[] = {
  { &PCDLines::Fields, "x y a", "line 3: *no field 'z'" },
  { &PCDLines::Fields, "x y x", "line 3: there are two fields 'x'" },
  { &PCDLines::Fields, "", "no FIELDS" },
  { &PCDLines::Fields, " ", "line 3: the header has no FIELDS" },
  { &PCDLines::Fields, "x y z i", "line 4: SIZE has 3 values. Expected 4" },
  { &PCDLines::Size, "4 4", "line 4: SIZE has 2 values. Expected 3" },
  { &PCDLines::Size, "4 4 2", "line 4: SIZE '2' of the field 'z' is not one of TYPE 'F'*4 or 8" },
  { &PCDLines::Size, "4 -4 4", "line 4: SIZE '-4'*'y'" },
  { &PCDLines::Size, "4 4 4.0", "line 4: SIZE '4.0'" },
  { &PCDLines::Size, "4 4 99999999999999999999", "line 4: SIZE '999" },
  { &PCDLines::Size, "", "TYPE is given without SIZE" },
  { &PCDLines::Type, "", "SIZE is given without TYPE" },
  { &PCDLines::Type, "F F", "line 5: TYPE has 2 values. Expected 3" },
  { &PCDLines::Type, "F F D", "line 4: SIZE '4' of the field 'z' is not one of TYPE 'D'" },
  { &PCDLines::Type, "F F FF", "is not one of TYPE 'FF'" },
  { &PCDLines::Count, "1 1", "line 6: COUNT has 2 values. Expected 3" },
  { &PCDLines::Count, "1 1 0", "line 6: COUNT '0' of the field 'z' is not a positive number" },
  { &PCDLines::Count, "1 1 2", "line 3: *'z' has 2 values per point" },
  { &PCDLines::Count, "1 1 4294967297", "line 6: COUNT" },
  { &PCDLines::Width, "3", "line 10: POINTS 2*WIDTH 3" },
  { &PCDLines::Width, "-2", "line 7: WIDTH '-2'" },
  { &PCDLines::Width, "two", "line 7: WIDTH 'two' is not a number of points" },
  { &PCDLines::Width, "2 2", "line 7: WIDTH has 2 values. Expected 1" },
  { &PCDLines::Width, " ", "line 7: WIDTH*0 values" },
  { &PCDLines::Height, "2", "line 10: POINTS 2*HEIGHT 2" },
  { &PCDLines::Height, "9223372036854775807", "line 7: *too large" },
  { &PCDLines::Points, "5", "line 10: POINTS 5" },
  { &PCDLines::Viewpoint, "0 0 0", "line 9: VIEWPOINT has 3 values. Expected 7" },
  { &PCDLines::Viewpoint, "0 0 0 1 0 0 up", "line 9: VIEWPOINT 'up' is not a finite number" },
  { &PCDLines::Viewpoint, "0 0 nan 1 0 0 0", "line 9: VIEWPOINT 'nan'" },
  { &PCDLines::Data, "text", "line 11: the value of DATA" },
  { &PCDLines::Data, " ", "line 11: the value of DATA" },
  { &PCDLines::Data, "binary_compress", "line 11: the value of DATA" },
};

TEST_F(PCDReader, ReadsOrRefuses)
{
  this->Check(Cases);
}

TEST_F(PCDReader, RefusesWrongHeaders)
{
  std::vector<FileCase> cases;
  for (const auto& wrong : HeaderCases)
  {
    cases.push_back({ wrong.Value, Header(wrong.Line, wrong.Value) + TwoLines, wrong.Error });
  }
  this->Check(cases);
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

TEST_F(PCDReader, SkipsTheMarkOfUTF8)
{
  const std::string file = "\xEF\xBB\xBF"
                           "FIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n";
  ExpectTuple(this->ReadWell(file)->GetPoints()->GetData(), 0, { 1.0, 2.0, 3.0 });
  EXPECT_EQ(vtkPCDReader::CanReadFile(this->Write(file).c_str()), 1);
  EXPECT_EQ(vtkPCDReader::CanReadFile(this->Write("\xEF\xBB\xBF").c_str()), 0);
}

/// Returns the peak memory of the process so far, KiB.
long GetPeak()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST_F(PCDReader, RefusesHeadersOfManyFields)
{
  std::string many;
  for (int i = 0; i < 10000; ++i)
  {
    many += " f" + std::to_string(i);
  }
  // Words take many times the memory of their text. The words of a long line are therefore not
  // stored.
  std::string endless = "FIELDS x y z";
  for (int i = 0; i < 8000000; ++i)
  {
    endless += " a";
  }
  [[maybe_unused]] const long before = GetPeak();
  const auto code = vtkErrorCode::FileFormatError;
  const std::string end = "\nPOINTS 0\nDATA ascii\n";
  this->ExpectRefused(
    "FIELDS x y z" + many + end, code, { "line 1: the header has more than 10000 fields" });
  this->ExpectRefused(endless + end, code, { "line 1: the header has more than 10000" });
  this->ExpectRefused(endless, Premature, { "before the line DATA" });
#ifndef __SANITIZE_ADDRESS__ // it retains released memory
  EXPECT_LT(GetPeak() - before, 5 * static_cast<long>(endless.size() / 1024));
#endif
}

TEST_F(PCDReader, AllocatesNothingForEmptyPromises)
{
  // Counts that would require gigabytes of memory.
  const long before = GetPeak();
  PCDLines lines;
  for (const char* count : { "10000000", "100000000", "4294967296", "1000000000000000000" })
  {
    lines.Width = lines.Points = count;
    for (const char* data : { "ascii", "binary" })
    {
      lines.Data = data;
      this->ExpectRefused(lines.Format() + "0 0 0\n1 1 1\n", Premature,
        { "line 10: ", count, "only 12 bytes follow" });
    }
  }
  // All counts agree, but the compressed data is too short for them.
  lines.Width = lines.Points = "10000000";
  lines.Data = "binary_compressed";
  this->ExpectRefused(lines.Format() + Sizes(8, 120000000) + "12345678",
    vtkErrorCode::FileFormatError, { "8 bytes of compressed data cannot hold 120000000 bytes" });
  // Few points, but huge ones.
  this->ExpectRefused(
    Fields("x y z h", "4 4 4 8", "F F F F", "1 1 1 100000000", "ascii") + "0 0 0\n", Premature,
    { "the header declares" });
  EXPECT_LT(GetPeak() - before, 30000);
}

TEST_F(PCDReader, SurvivesDamage)
{
  std::mt19937 random(7);
  for (int mode = 0; mode <= 2; ++mode)
  {
    const std::string whole = this->MakeFile(mode);
    const std::size_t header = whole.find('\n', whole.find("DATA")) + 1;
    int refused = 0;
    if (mode > 0)
    {
      this->CheckTruncation(whole, true);
    }
    // Each byte of the header and of the sizes of the compressed data is changed.
    for (std::size_t i = 0; i < header + 8; ++i)
    {
      for (const char byte : { ' ', '\n', '9', '-', '\0', '\xFF' })
      {
        std::string damaged = whole;
        damaged[i] = byte;
        refused += !this->Survives(damaged);
      }
      std::string shorter = whole;
      shorter.erase(i, 1);
      refused += !this->Survives(shorter);
    }
    EXPECT_GT(refused, static_cast<int>(header));
    for (int i = 0; i < 300; ++i)
    {
      std::string damaged = whole;
      for (int k = 0; k < 3; ++k)
      {
        damaged[header + random() % (damaged.size() - header)] = static_cast<char>(random());
      }
      this->Survives(damaged);
    }
    // Lines are removed or duplicated.
    for (std::size_t begin = 0; begin < header;)
    {
      const std::size_t next = whole.find('\n', begin) + 1;
      const std::string line = whole.substr(begin, next - begin);
      const bool isTwice = this->Survives(whole.substr(0, next) + line + whole.substr(next));
      EXPECT_EQ(isTwice, line[0] == '#') << line;
      const bool isWithout = this->Survives(whole.substr(0, begin) + whole.substr(next));
      const std::string word = line.substr(0, line.find(' '));
      const bool mayLack =
        word == "#" || word == "VERSION" || word == "VIEWPOINT" || word == "POINTS";
      if (word != "WIDTH" && word != "COUNT")
      {
        EXPECT_EQ(isWithout, mayLack) << line;
      }
      begin = next;
    }
  }
}
}
