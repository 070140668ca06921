// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPCDReader: every way to get the format wrong.
#include "FilterTestTools.h"
#include "PCDTestTools.h"

#include "vtkErrorCode.h"
#include "vtkPCDWriter.h"

#include <random>
#include <sys/resource.h>

namespace
{
using dggtest::GoodPCD;
using dggtest::PCDLines;
using dggtest::Sizes;

class PCDReaderRefusals : public dggtest::PCDTest
{
protected:
  /// A small file of each mode with several kinds of fields.
  std::string MakeFile(int mode)
  {
    vtkNew<vtkPCDWriter> writer;
    writer->SetInputData(dggtest::MakeRichCloud(VTK_FLOAT));
    writer->SetFileName(this->GetPath("rich.pcd").c_str());
    writer->SetDataMode(mode);
    EXPECT_EQ(writer->Write(), 1);
    return this->Load("rich.pcd");
  }

  /// Whatever the file is, the reader answers; false when it is refused, with nothing left.
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

TEST_F(PCDReaderRefusals, RefusesMalformedHeaders)
{
  const auto code = vtkErrorCode::FileFormatError;
  const auto change = [](std::string PCDLines::*line, const std::string& value) {
    PCDLines lines;
    lines.*line = value;
    return lines.Format() + "0 1 2\n3 4 5\n";
  };
  this->ExpectRefused(change(&PCDLines::Fields, "x y a"), code, { "line 3: ", "no field 'z'" });
  this->ExpectRefused(change(&PCDLines::Fields, "a b c"), code, { "line 3: ", "no field 'x'" });
  this->ExpectRefused(change(&PCDLines::Fields, "x y x"), code, { "line 3: two fields 'x'" });
  this->ExpectRefused(change(&PCDLines::Fields, ""), code, { "no FIELDS" });
  this->ExpectRefused(change(&PCDLines::Fields, " "), code, { "line 3: no FIELDS" });
  this->ExpectRefused(
    change(&PCDLines::Fields, "x y z i"), code, { "line 4: SIZE has 3 values, expected 4" });
  this->ExpectRefused(
    change(&PCDLines::Size, "4 4"), code, { "line 4: SIZE has 2 values, expected 3" });
  this->ExpectRefused(change(&PCDLines::Size, "4 4 2"), code,
    { "line 4: SIZE '2' of the field 'z' is not one of TYPE 'F'", "4 or 8" });
  this->ExpectRefused(change(&PCDLines::Size, "4 -4 4"), code, { "line 4: SIZE '-4'", "'y'" });
  this->ExpectRefused(change(&PCDLines::Size, "4 4 0"), code, { "line 4: SIZE '0'" });
  this->ExpectRefused(change(&PCDLines::Size, "4 4 4.0"), code, { "line 4: SIZE '4.0'" });
  this->ExpectRefused(
    change(&PCDLines::Size, "4 4 99999999999999999999"), code, { "line 4: SIZE '999" });
  this->ExpectRefused(change(&PCDLines::Size, ""), code, { "TYPE without SIZE" });
  this->ExpectRefused(change(&PCDLines::Type, ""), code, { "SIZE without TYPE" });
  this->ExpectRefused(
    change(&PCDLines::Type, "F F"), code, { "line 5: TYPE has 2 values, expected 3" });
  this->ExpectRefused(change(&PCDLines::Type, "F F D"), code,
    { "line 4: SIZE '4' of the field 'z' is not one of TYPE 'D'" });
  this->ExpectRefused(change(&PCDLines::Type, "F F FF"), code, { "is not one of TYPE 'FF'" });
  this->ExpectRefused(
    change(&PCDLines::Count, "1 1"), code, { "line 6: COUNT has 2 values, expected 3" });
  this->ExpectRefused(change(&PCDLines::Count, "1 1 0"), code,
    { "line 6: COUNT '0' of the field 'z' is not a positive number" });
  this->ExpectRefused(change(&PCDLines::Count, "1 1 -1"), code, { "line 6: COUNT '-1'" });
  this->ExpectRefused(
    change(&PCDLines::Count, "1 1 2"), code, { "line 3: ", "'z' has 2 values per point" });
  this->ExpectRefused(change(&PCDLines::Count, "1 1 4294967297"), code, { "line 6: COUNT" });
  this->ExpectRefused(change(&PCDLines::Width, "3"), code, { "line 10: POINTS 2", "WIDTH 3" });
  this->ExpectRefused(change(&PCDLines::Width, "-2"), code, { "line 7: WIDTH '-2'" });
  this->ExpectRefused(
    change(&PCDLines::Width, "two"), code, { "line 7: WIDTH 'two' is not a number of points" });
  this->ExpectRefused(
    change(&PCDLines::Width, "2 2"), code, { "line 7: WIDTH has 2 values, expected 1" });
  this->ExpectRefused(change(&PCDLines::Width, " "), code, { "line 7: WIDTH", "0 values" });
  this->ExpectRefused(
    change(&PCDLines::Width, "99999999999999999999"), code, { "line 7: WIDTH '999" });
  this->ExpectRefused(change(&PCDLines::Height, "2"), code, { "line 10: POINTS 2", "HEIGHT 2" });
  this->ExpectRefused(
    change(&PCDLines::Height, "9223372036854775807"), code, { "line 7: ", "too large" });
  this->ExpectRefused(change(&PCDLines::Points, "5"), code, { "line 10: POINTS 5" });
  this->ExpectRefused(change(&PCDLines::Points, "-1"), code, { "line 10: POINTS '-1'" });
  this->ExpectRefused(
    change(&PCDLines::Viewpoint, "0 0 0"), code, { "line 9: VIEWPOINT has 3 values, expected 7" });
  this->ExpectRefused(change(&PCDLines::Viewpoint, "0 0 0 1 0 0 up"), code,
    { "line 9: VIEWPOINT 'up' is not a finite number" });
  this->ExpectRefused(
    change(&PCDLines::Viewpoint, "0 0 nan 1 0 0 0"), code, { "line 9: VIEWPOINT 'nan'" });
  this->ExpectRefused(change(&PCDLines::Data, "text"), code, { "line 11: DATA" });
  this->ExpectRefused(change(&PCDLines::Data, "ascii binary"), code, { "line 11: DATA" });
  this->ExpectRefused(change(&PCDLines::Data, " "), code, { "line 11: DATA" });
  this->ExpectRefused(change(&PCDLines::Data, "binary_compress"), code, { "line 11: DATA" });
  PCDLines lines;
  lines.Width.clear();
  lines.Height = "2";
  this->ExpectRefused(lines.Format() + "0 1 2\n3 4 5\n", code, { "HEIGHT without WIDTH" });
  lines.Height = "1";
  lines.Points.clear();
  this->ExpectRefused(lines.Format() + "0 1 2\n3 4 5\n", code, { "neither WIDTH nor POINTS" });
  this->ExpectRefused("FIELDS x y z\nFIELDS x y z\nPOINTS 2\nDATA ascii\n0 0 0\n0 0 0\n", code,
    { "line 2: a second FIELDS" });
  std::string many;
  for (int i = 0; i < 10000; ++i)
  {
    many += " f" + std::to_string(i);
  }
  this->ExpectRefused(
    "FIELDS x y z" + many + "\nPOINTS 0\nDATA ascii\n", code, { "line 1: more than 10000 fields" });
  // Words take many times the memory of their text, so that those of a long line are not kept.
  const auto getPeak = [] {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss; // KiB
  };
  std::string endless = "FIELDS x y z";
  for (int i = 0; i < 8000000; ++i)
  {
    endless += " a";
  }
  [[maybe_unused]] const auto before = getPeak();
  this->ExpectRefused(endless + "\nPOINTS 0\nDATA ascii\n", code, { "line 1: more than 10000" });
  this->ExpectRefused(endless, vtkErrorCode::PrematureEndOfFileError, { "before the line DATA" });
#ifndef __SANITIZE_ADDRESS__ // it keeps what is given back
  EXPECT_LT(getPeak() - before, 5 * static_cast<long>(endless.size() / 1024));
#endif
  this->ExpectRefused("FIELDS x y z q\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 100000000\n"
                      "POINTS 0\nDATA binary\n",
    code, { "line 5: COUNT declares 100000003 values per point" });
  this->ExpectRefused("FIELDS x y z\nCOLUMNS x y z\nPOINTS 1\nDATA ascii\n0 0 0\n", code,
    { "both FIELDS and COLUMNS" });
  this->ExpectRefused("VERSION 0.7\nFIELDS x y z\nUNITS m\nPOINTS 1\nDATA ascii\n0 0 0\n", code,
    { "line 3: 'UNITS' is not a keyword of the header of a PCD file" });
  this->ExpectRefused("FIELDS x y z normal_x normal_y normal_z Normals\nPOINTS 1\nDATA ascii\n"
                      "0 0 0 0 0 1 5\n",
    code, { "both become the array Normals" });
}

TEST_F(PCDReaderRefusals, RefusesBadText)
{
  const auto code = vtkErrorCode::FileFormatError;
  const auto end = vtkErrorCode::PrematureEndOfFileError;
  const std::string head = PCDLines().Format();
  this->ExpectRefused(head + "0 0 0\n0 zero 0\n", code,
    { "line 13: the field 'y' of point 1: 'zero' is not a number" });
  this->ExpectRefused(head + "0 0 0x1\n0 0 0\n", code, { "line 12: ", "'z' of point 0: '0x1'" });
  this->ExpectRefused(head + "0 0 1,5\n0 0 0\n", code, { "line 12: ", "'1,5' is not a number" });
  this->ExpectRefused(head + "0 0 1e39\n0 0 0\n", code, { "line 12: ", "'1e39' is out of range" });
  this->ExpectRefused(
    head + "0.5 0\n0 0 0\n", code, { "line 12: point 0 has 2 values, expected 3" });
  this->ExpectRefused(
    head + "0 0 0 0\n0 0 0\n", code, { "line 12: point 0 has more than 3 values" });
  this->ExpectRefused(head + "0 0 0 0 0 0\n", code, { "line 12: point 0 has more than 3 values" });
  this->ExpectRefused(head + "0 0 0\n\n0.25 0.25", end, { "line 14: point 1 has 2 values" });
  this->ExpectRefused(head + "0.125 0.125 0.125\n", end, { "the file ends after 1 of 2 points" });
  this->ExpectRefused(head + "0 0 0\n1 1 1\n2 2 2\n", code,
    { "line 14: data follow the last of 2 points. Increase POINTS" });
  this->ExpectRefused(head + "0 0 0\n1 1 1\nend\n", code, { "line 14: data follow" });
  PCDLines lines;
  lines.Fields = "x y z i";
  lines.Size = "4 4 4 1";
  lines.Type = "F F F U";
  lines.Count = "1 1 1 1";
  lines.Width = lines.Points = "1";
  this->ExpectRefused(lines.Format() + "0 0 0 256\n", code, { "'i' of point 0: '256' is out of" });
  this->ExpectRefused(lines.Format() + "0 0 0 -1\n", code, { "'-1' is not an integer" });
  this->ExpectRefused(lines.Format() + "0 0 0 1.5\n", code, { "'1.5' is not an integer" });
  this->ExpectRefused(lines.Format() + "0 0 0 nan\n", code, { "'nan' is not an integer" });
  lines.Type = "F F F I";
  this->ExpectRefused(lines.Format() + "0 0 0 128\n", code, { "'128' is out of" });
}

TEST_F(PCDReaderRefusals, RefusesBadCompressedData)
{
  const auto code = vtkErrorCode::FileFormatError;
  const auto end = vtkErrorCode::PrematureEndOfFileError;
  PCDLines lines;
  lines.Data = "binary_compressed";
  const std::string head = lines.Format();
  const std::string at = "byte " + std::to_string(head.size()) + ": ";
  this->ExpectRefused(head + "1234567", end, { "before the sizes of the compressed data" });
  this->ExpectRefused(head + Sizes(9, 24) + "12345678", end, { at + "9 bytes", "but 8 follow" });
  this->ExpectRefused(
    head + Sizes(4294967295u, 24) + "12345678", end, { at + "4294967295 bytes", "but 8 follow" });
  this->ExpectRefused(head + Sizes(8, 25) + "12345678", code,
    { at + "the compressed data promise 25 bytes, which are not 2 points of 12 bytes" });
  this->ExpectRefused(head + Sizes(8, 0) + "12345678", code, { "promise 0 bytes" });
  const std::string damaged = "the compressed data are damaged";
  this->ExpectRefused(head + Sizes(3, 24) +
      "\x1F"
      "ab",
    code, { damaged }); // a literal too long
  this->ExpectRefused(
    head + Sizes(2, 24) + std::string("\x20\x00", 2), code, { damaged }); // no past
  this->ExpectRefused(head + Sizes(1, 24) + "\x20", code, { damaged });   // no distance
  this->ExpectRefused(head + Sizes(3, 24) + std::string("\x00\x61\xE0", 3), code, { damaged });
  this->ExpectRefused(head + Sizes(4, 24) + std::string("\x00\x61\xE0\x00", 4), code, { damaged });
  // Too much, too little.
  this->ExpectRefused(
    head + Sizes(5, 24) + std::string("\x00\x61\xE0\xFF\x00", 5), code, { damaged });
  this->ExpectRefused(head + Sizes(4, 24) + std::string("\x00\x61\x20\x00", 4), code, { damaged });
  const std::string whole = head + Sizes(5, 24) + std::string("\x00\x61\xE0\x0E\x00", 5);
  EXPECT_EQ(this->ReadWell(whole)->GetNumberOfPoints(), 2);
  this->ExpectRefused(whole + "!", code, { "data follow the last of 2 points" });
}

TEST_F(PCDReaderRefusals, AllocatesNothingForEmptyPromises)
{
  // Would take gigabytes.
  const auto peak = [] {
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss; // kB
  };
  const long before = peak();
  const auto end = vtkErrorCode::PrematureEndOfFileError;
  PCDLines lines;
  for (const char* count : { "10000000", "100000000", "4294967296", "1000000000000000000" })
  {
    lines.Width = lines.Points = count;
    for (const char* data : { "ascii", "binary" })
    {
      lines.Data = data;
      this->ExpectRefused(
        lines.Format() + "0 0 0\n1 1 1\n", end, { "line 10: ", count, "only 12 bytes follow" });
    }
  }
  // All counts agree, but so few bytes cannot hold so many.
  lines.Width = lines.Points = "10000000";
  lines.Data = "binary_compressed";
  this->ExpectRefused(lines.Format() + Sizes(8, 120000000) + "12345678",
    vtkErrorCode::FileFormatError, { "8 bytes of compressed data cannot hold 120000000 bytes" });
  // Not many points, but huge ones.
  PCDLines wide;
  wide.Fields = "x y z h";
  wide.Size = "4 4 4 8";
  wide.Type = "F F F F";
  wide.Count = "1 1 1 100000000";
  this->ExpectRefused(wide.Format() + "0 0 0\n1 1 1\n", end, { "promised" });
  wide.Count = "1 1 1 2000000000";
  this->ExpectRefused(
    wide.Format() + "0 0 0\n1 1 1\n", vtkErrorCode::FileFormatError, { "more than 2 GB" });
  EXPECT_LT(peak() - before, 30000);
}

TEST_F(PCDReaderRefusals, RefusesFilesCutAnywhere)
{
  for (int mode = 0; mode <= 2; ++mode)
  {
    const std::string whole = this->MakeFile(mode);
    ASSERT_TRUE(this->Survives(whole));
    int read = 0;
    for (std::size_t length = 0; length < whole.size(); ++length)
    {
      read += this->Survives(whole.substr(0, length));
    }
    // In text, the last number may lose digits without a trace, and the last line its end.
    const std::size_t lastWord = whole.size() - 1 - whole.rfind(' ');
    EXPECT_LE(read, mode == 0 ? static_cast<int>(lastWord) : 0);
    EXPECT_GE(read, mode == 0 ? 1 : 0);
  }
}

TEST_F(PCDReaderRefusals, SurvivesDamage)
{
  std::mt19937 random(7);
  for (int mode = 0; mode <= 2; ++mode)
  {
    const std::string whole = this->MakeFile(mode);
    const std::size_t header = whole.find('\n', whole.find("DATA")) + 1;
    int refused = 0;
    // Each byte of the header, and the sizes of the compressed data.
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
    // Lines that are missing, or there twice.
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
