// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkDGGOFFReader: all dialects of the format, and damaged files.
#include "ReaderFixture.h"

#include "vtkDGGOFFReader.h"

#include <cstdint>
#include <cstring>

namespace
{
using dggtest::FileCase;

const char* const Triangle = "OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

class OFFReader : public dggtest::ReaderFixture<vtkDGGOFFReader>
{
protected:
  OFFReader()
    : ReaderFixture("mesh.off", Triangle)
  {
  }
};

/// Bytes of a binary file, most significant first.
class BinaryFile
{
public:
  explicit BinaryFile(const std::string& keyword) { this->Bytes = keyword + " BINARY\n"; }
  BinaryFile& Int(std::int32_t value)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, 4);
    for (int shift = 24; shift >= 0; shift -= 8)
    {
      this->Bytes += static_cast<char>(bits >> shift & 0xff);
    }
    return *this;
  }
  BinaryFile& Float(float value)
  {
    std::int32_t bits = 0;
    std::memcpy(&bits, &value, 4);
    return this->Int(bits);
  }
  BinaryFile& Floats(const std::vector<float>& values)
  {
    for (const float value : values)
    {
      this->Float(value);
    }
    return *this;
  }
  BinaryFile& Ints(const std::vector<std::int32_t>& values)
  {
    for (const std::int32_t value : values)
    {
      this->Int(value);
    }
    return *this;
  }
  const std::string& Get() const { return this->Bytes; }

private:
  std::string Bytes;
};

BinaryFile MakeHead(std::int32_t vertices, std::int32_t faces)
{
  BinaryFile file("OFF");
  file.Ints({ vertices, faces, 0 });
  return file;
}

/// Returns three points. "OFF BINARY\n" has 11 bytes, the counts 12, the points 36: faces begin at
/// byte 59.
BinaryFile MakeTriangle(std::int32_t faces)
{
  BinaryFile file = MakeHead(3, faces);
  file.Floats({ 0, 0, 0, 1, 0, 0, 0, 1, 0 });
  return file;
}

constexpr auto Unrecognized = vtkErrorCode::UnrecognizedFileTypeError;
constexpr auto Premature = vtkErrorCode::PrematureEndOfFileError;
const std::string Zeros(400, '0');
const std::string VertexTail = "\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string FaceHead = "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
const char* const Corners = "0 0 0\n1 0 0\n0 1 0\n";
const std::string TriangleLines = std::string(Corners) + "3 0 1 2\n";
const char* const TriangleContents = "0 0 0, 1 0 0, 0 1 0 | polys 0 1 2";
const char* const RichContents =
  "1 2 3 | active Normals double 0 0 1 | active TCoords double 0.5 0.25 "
  "| active RGBA unsigned char 10 20 30 40";

const FileCase Cases[] = {
  { "numbers", "OFF\n4 2 5\n0 0 0\n1.5 0 0\n0 -2.25e1 0\n+1 .5 1e-3\n3 0 1 2\n3 1 3 2\n",
    "0 0 0, 1.5 0 0, 0 -22.5 0, 1 0.5 0.001 | polys 0 1 2, 1 3 2" },
  { "double digits", "OFF 1 0 0\n0.1 3.14159265358979323846 123456789.123456789\n",
    "0.1 3.141592653589793 123456789.12345679" },
  { "numbers too small for doubles", "OFF 1 0 0\n0." + Zeros + "1 0." + Zeros + "1e10 0\n",
    "0 0 0" },
  { "number too large for doubles", "OFF 1 0 0\n1" + Zeros + "e-10 0 0\n", "is out of range" },
  { "comments and blank lines",
    "# a\n\nOFF # b\n\n  # c\n3 1 0 # d\n\n0 0 0\n# e\n1 0 0 # f\n\t0 1 0\n\n3 0 1 2 # g\n# h\n",
    TriangleContents },
  { "line ends of Windows", "OFF\r\n1 0 0\r\n0 1 0\r\n", "0 1 0" },
  { "lone carriage returns", "OFF\r1 0 0\r0 1 0\r", "0 1 0" },
  { "counts beside the keyword", "OFF 3 1 3\n" + TriangleLines, TriangleContents },
  { "no count of edges", "OFF 3 1\n" + TriangleLines, TriangleContents },
  { "two counts below the keyword", "OFF\n3 1\n" + TriangleLines, TriangleContents },
  { "counts on three lines", "OFF\n3\n1\n3\n" + TriangleLines, TriangleContents },
  { "counts on two lines", "OFF\n3 1\n3\n" + TriangleLines, TriangleContents },
  { "keyword joined to the counts", "OFF3 1 0\n" + TriangleLines, TriangleContents },
  { "no keyword", "3 1 0\n" + TriangleLines, TriangleContents },
  { "two counts after a comment", "# c\n3 1\n" + TriangleLines, TriangleContents },
  { "lower case", "off\n3 1 0\n" + TriangleLines, TriangleContents },
  { "lower case joined to the counts", "off3 1 0\n" + TriangleLines, TriangleContents },
  { "lower case with colors", "coff 1 0 0\n0 0 0 1 2 3\n",
    "0 0 0 | active RGB unsigned char 1 2 3" },
  { "colors without C", "OFF 2 0 0\n0 0 0 1 2 3 4\n1 0 0 5 6 7 8\n",
    "0 0 0, 1 0 0 | active RGBA unsigned char 1 2 3 4, 5 6 7 8" },
  { "records on several lines", "OFF 3 1 0\n0\n0 0\n1 0\n0\n0 1 0\n3\n0 1\n2 255 0 0\n",
    TriangleContents + std::string(" | cells active RGB unsigned char 255 0 0") },
  { "cells of all kinds, one without a color",
    "OFF 5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 2\n4 0 1 2 3 10 0 0\n2 0 2 20 0 0\n1 4 30 0 0\n"
    "3 0 1 2\n5 0 1 2 3 4 50 0 0\n",
    "0 0 0, 1 0 0, 1 1 0, 0 1 0, 2 2 2 | verts 4 | lines 0 2 | polys 0 1 2 3, 0 1 2, 0 1 2 3 4 "
    "| cells active RGB unsigned char 30 0 0, 20 0 0, 10 0 0, 170 170 170, 50 0 0" },
  { "integer colors", "COFF\n2 0 0\n0 0 0 255 128 0\n1 1 1 1 2 3\n",
    "0 0 0, 1 1 1 | active RGB unsigned char 255 128 0, 1 2 3" },
  { "integer colors with alpha", "COFF\n2 0 0\n0 0 0 255 128 0 64\n1 1 1 1 2 3 255\n",
    "0 0 0, 1 1 1 | active RGBA unsigned char 255 128 0 64, 1 2 3 255" },
  { "fractions", "COFF\n2 0 0\n0 0 0 1.0 0.5 0.0\n1 1 1 0 1 0\n",
    "0 0 0, 1 1 1 | active RGB unsigned char 255 128 0, 0 255 0" },
  { "fractions with alpha", "COFF\n2 0 0\n0 0 0 1. 0. .2 0.4\n1 1 1 1 1 1 1\n",
    "0 0 0, 1 1 1 | active RGBA unsigned char 255 0 51 102, 255 255 255 255" },
  { "integers of which none is above 1", "COFF\n2 0 0\n0 0 0 1 0 0\n1 1 1 0 1 1\n",
    "0 0 0, 1 1 1 | active RGB unsigned char 255 0 0, 0 255 255" },
  { "alpha of one color only", "COFF\n2 0 0\n0 0 0 10 20 30\n1 1 1 40 50 60 70\n",
    "0 0 0, 1 1 1 | active RGBA unsigned char 10 20 30 255, 40 50 60 70" },
  { "colors of faces", std::string("OFF 3 2 0\n") + Corners + "3 0 1 2 0.2 0.4 0.6 0.8\n3 0 2 1\n",
    "0 0 0, 1 0 0, 0 1 0 | polys 0 1 2, 0 2 1 "
    "| cells active RGBA unsigned char 51 102 153 204, 170 170 170 255" },
  { "ids of colors", std::string("OFF 3 2 0\n") + Corners + "3 0 1 2 7\n3 0 2 1 8\n",
    "0 0 0, 1 0 0, 0 1 0 | polys 0 1 2, 0 2 1" },
  { "all prefixes", "STCNOFF 1 0 0\n1 2 3 0 0 1 10 20 30 40 0.5 0.25\n", RichContents },
  { "all prefixes, C first", "CNSTOFF 1 0 0\n1 2 3 0 0 1 10 20 30 40 0.5 0.25\n", RichContents },
  { "all prefixes, N first", "NCSTOFF 1 0 0\n1 2 3 0 0 1 10 20 30 40 0.5 0.25\n", RichContents },
  { "colors of three numbers before texture coordinates", "STCOFF 1 0 0\n1 2 3 10 20 30 0.5 0.25\n",
    "1 2 3 | active TCoords double 0.5 0.25 | active RGB unsigned char 10 20 30" },
  { "binary",
    BinaryFile("STCNOFF")
        .Ints({ 1, 1, 0 })
        .Floats({ 1, 2, 3, 0, 0, 1, 1.0f, 0.2f, 0.4f, 0.6f, 0.5f, 0.25f })
        .Ints({ 1, 0, 4 })
        .Floats({ 1.0f, 0.0f, 0.0f, 1.0f })
        .Get() +
      "\n",
    "float 1 2 3 | verts 0 | active Normals double 0 0 1 | active TCoords double 0.5 0.25 "
    "| active RGBA unsigned char 255 51 102 153 | cells active RGBA unsigned char 255 0 0 255" },
  { "keyword", "ply\nformat ascii 1.0\n", "line 1: *'ply'", Unrecognized },
  { "keyword", "\n# c\nOBJ 3 1 0\n", "line 3: *'OBJ'", Unrecognized },
  { "keyword", "1.5 1 0\n0 0 0\n", "line 1: *'1.5'", Unrecognized },
  { "keyword", "CCOFF 3 1 0\n", "line 1: *'CCOFF'", Unrecognized },
  { "keyword", "Off 3 1 0\n", "line 1: *'Off'", Unrecognized },
  { "keyword", "OFF3x 1 0\n", "line 1: *'OFF3x'", Unrecognized },
  { "keyword", std::string("\x7f\x45\x4c\x46\x00\x01", 6), "line 1: *'?ELF?\?'", Unrecognized },
  { "keyword", std::string(100, 'x'), "line 1: *...'", Unrecognized },
  { "keyword", "4OFF 1 0 0\n0 0 0 1\n", "line 1: *other than three", Unrecognized },
  { "keyword", "nOFF 3\n1 0 0\n0 0 0\n", "line 1: *Convert the file", Unrecognized },
  { "keyword", "ST4nOFF BINARY\n", "line 1: *other than three", Unrecognized },
  { "counts", "OFF\n-3 1 0\n", "line 2: *-3 vertices" },
  { "counts", "OFF\n3.5 1 0\n", "line 2: *'3.5' is not an integer" },
  { "counts", "OFF\n3 1 x\n", "line 2: *'x' is not an integer" },
  { "counts", "OFF\n3 1 0 7\n", "line 2: *more than the three counts" },
  { "counts", "OFF\n99999999999999999999 1 0\n",
    "line 2: *'99999999999999999999' is out of range" },
  { "counts", "OFF\n1000000000000 1 0\n0 0 0\n", "line 2: *only 7 bytes follow", Premature },
  { "counts", "OFF\n9223372036854775807 9223372036854775807 0\n", "line 2: *declares", Premature },
  { "counts", "OFF\n1 4000000000000000000 0\n0 0 0\n", "line 2: *declares", Premature },
  { "counts", "NOFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "line 2: *declares", Premature },
  { "vertices", "OFF 3 1 0\n0 zero 0" + VertexTail, "line 2: *'zero' is not a number" },
  { "vertices", "OFF 3 1 0\n0 0x10 0" + VertexTail, "line 2: *'0x10'" },
  { "vertices", "OFF 3 1 0\n0 +-1 0" + VertexTail, "line 2: *'+-1'" },
  { "vertices", "OFF 3 1 0\n0 1e999 0" + VertexTail, "line 2: *'1e999' is out of range" },
  { "vertices", "OFF 3 1 0\n0 0 0\n1 0 0 5" + VertexTail, "line 3: *vertex 1 has 1" },
  { "vertices", "COFF 1 0 0\n0 0 0 1 1\n", "line 2: *vertex 0 has 2" },
  { "vertices", "COFF 1 0 0\n0 0 0\n1 1 1\n", "line 2: *vertex 0 has 0" },
  { "vertices", "COFF 1 0 0\n0 0 0 1 1 red\n", "line 2: *'red'" },
  { "vertices", "COFF 1 0 0\n0 0 0 1 1 256\n", "line 2: *256 is out of range" },
  { "vertices", "COFF 1 0 0\n0 0 0 1 1 -1\n", "line 2: *NOFF if" },
  { "vertices", "COFF 1 0 0\n0 0 0 1 1 nan\n", "line 2: *nan is out of range" },
  { "vertices", "COFF 1 0 0\n0 0 0 1 1 1.5\n", "line 2: *1.5 is out of range" },
  { "vertices", "COFF 2 0 0\n0 0 0 1 200 1\n0 0 0 0.5 0 0\n", "line 2: *fractions of 1" },
  { "vertices", "STOFF 1 0 0\n0 0 0 0.5\n# padding\n", "line 2: *vertex 0 has 1" },
  { "faces", FaceHead + "3 0 1 3\n", "line 5: *refers to vertex 3, but the file has 3" },
  { "faces", FaceHead + "3 0 1 99999999999\n", "line 5: *refers to vertex 99999999999" },
  { "faces", FaceHead + "3 0 1 2.0\n", "line 5: *'2.0' is not an integer" },
  { "faces", FaceHead + "0\n####\n", "line 5: *face 0 has 0 vertices" },
  { "faces", FaceHead + "-3 0 1 2\n", "line 5: *face 0 has -3 vertices" },
  { "faces", FaceHead + "3 0 1 2 10 20\n", "line 5: *face 0 has 2 numbers" },
  { "faces", FaceHead + "3 0 1 2 1 2 3 4 5\n", "line 5: *face 0 has 5 numbers" },
  { "faces", FaceHead + "3 0 1 2 10 20 300\n", "line 5: *300 is out of range" },
  { "faces", FaceHead + "1000000000 0 1 2\n", "line 5: *declares", Premature },
  { "faces", FaceHead + "3 0 1 2\n3 0 1 2\n", "line 6: *'3' follows the last face" },
  { "binary", "OFF BINARY", "byte 10: *before the number of vertices", Premature },
  { "binary", MakeHead(-1, 0).Get(), "byte 23: *-1 vertices" },
  { "binary", MakeHead(0, -1).Get(), "byte 23: *-1 faces" },
  { "binary", MakeHead(2147483647, 2147483647).Get(), "byte 23: *declares", Premature },
  { "binary", MakeTriangle(1).Ints({ 0, 0, 0 }).Get(), "byte 63: *0 vertices" },
  { "binary", MakeTriangle(1).Ints({ -2, 0, 0 }).Get(), "byte 63: *-2 vertices" },
  { "binary", MakeTriangle(1).Ints({ 2147483647, 0, 0 }).Get(), "byte 63: *declares", Premature },
  { "binary", MakeTriangle(1).Ints({ 3, 0, 1, 7, 0 }).Get(), "byte 75: *vertex 7" },
  { "binary", MakeTriangle(1).Ints({ 3, 0, 1, 2, 2 }).Get(), "byte 79: *face 0 has 2 numbers" },
  { "binary", MakeTriangle(1).Ints({ 3, 0, 1, 2, 3 }).Floats({ 0, 2, 0 }).Get(),
    "byte 91: *out of range" },
  { "binary", MakeTriangle(1).Ints({ 3, 0, 1, 2, 0, 9 }).Get(), "byte 79: *4 bytes follow" },
};
}

TEST_F(OFFReader, ReadsOrRefuses)
{
  this->Check(Cases);
}

TEST_F(OFFReader, WarnsOfTruncatedLastNumbers)
{
  this->ExpectWarningIfCut("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 10 20 30\n");
}

TEST_F(OFFReader, RefusesTruncatedFiles)
{
  this->CheckTruncation("STCNOFF\n3 1 3\n0 0 0 0 0 1 255 0 0 0.5 0.5\n1 0 0 0 0 1 255 0 0 0.5 0.5\n"
                        "0 1 0 0 0 1 255 0 0 0.5 0.5\n3 0 1 2\n",
    true);
  this->CheckTruncation(MakeTriangle(1).Ints({ 3, 0, 1, 2, 3 }).Floats({ 0, 1, 0 }).Get(), true);
}
