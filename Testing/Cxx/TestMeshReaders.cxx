// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkDGGOBJReader, vtkDGGPLYReader, vtkDGGSTLReader and vtkDGGXYZReader: dialects, digits, ids,
// connectivity and invalid files; tests shared with vtkDGGOFFReader and vtkPCDReader.
#include "MeshDescription.h"
#include "ReaderFixture.h"

#include "vtkDGGOBJReader.h"
#include "vtkDGGOFFReader.h"
#include "vtkDGGPLYReader.h"
#include "vtkDGGSTLReader.h"
#include "vtkDGGXYZReader.h"
#include "vtkPCDReader.h"

#include <zlib.h>

#include <cstdint>
#include <cstring>

namespace
{
using dggtest::Describe;
using dggtest::Digits;
using dggtest::FileCase;

/// Returns numbers as bytes.
template <typename T>
std::string Bytes(const std::vector<T>& values, bool isBigEndian = false)
{
  std::string bytes;
  for (const T value : values)
  {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (isBigEndian)
    {
      std::reverse(raw, raw + sizeof(T));
    }
    bytes.append(raw, sizeof(T));
  }
  return bytes;
}

/// Returns a PLY file with points, cells, normals, arrays of points and cells, and an element and
/// lists that are skipped.
std::string MakePLY(const std::string& format)
{
  const bool isBig = format == "binary_big_endian";
  const bool isText = format == "ascii";
  std::string file = "ply\nformat " + format +
    " 1.0\ncomment a b\nelement other 1\nproperty list ushort float w\nproperty short s\n"
    "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
    "property float nx\nproperty float ny\nproperty float nz\nproperty float32 quality\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int u\n"
    "element face 2\nproperty int label\nproperty list uint8 int32 vertex_indices\nend_header\n";
  if (isText)
  {
    return file +
      "2 0.5 0.5 7\n512345.678 5403210.987 0.1 0 0 1 0.25 1 2 3 -4\n1 0 0 0 0 1 0.5 4 5 6 5\n"
      "0 1 0 0 0 1 1 255 0 9 6\n8 2 0 1\n9 3 0 1 2\n";
  }
  file += Bytes<std::uint16_t>({ 2 }, isBig) + Bytes<float>({ 0.5f, 0.5f }, isBig) +
    Bytes<std::int16_t>({ 7 }, isBig);
  const std::vector<double> points[] = { { 512345.678, 5403210.987, 0.1 }, { 1.0, 0.0, 0.0 },
    { 0.0, 1.0, 0.0 } };
  const float qualities[] = { 0.25f, 0.5f, 1.0f };
  const std::string colors[] = { "\x01\x02\x03", "\x04\x05\x06", std::string("\xff\0\x09", 3) };
  for (int i = 0; i < 3; ++i)
  {
    file += Bytes(points[i], isBig) + Bytes<float>({ 0.0f, 0.0f, 1.0f, qualities[i] }, isBig) +
      colors[i] + Bytes<std::int32_t>({ i == 0 ? -4 : 4 + i }, isBig);
  }
  return file + Bytes<std::int32_t>({ 8 }, isBig) + "\2" + Bytes<std::int32_t>({ 0, 1 }, isBig) +
    Bytes<std::int32_t>({ 9 }, isBig) + "\3" + Bytes<std::int32_t>({ 0, 1, 2 }, isBig);
}
const char* const PLYContents =
  "512345.678 5403210.987 0.1, 1 0 0, 0 1 0 | lines 0 1 | polys 0 1 2 "
  "| active Normals float 0 0 1, 0 0 1, 0 0 1 "
  "| active RGB unsigned char 1 2 3, 4 5 6, 255 0 9 "
  "| quality float 0.25, 0.5, 1 | u int -4, 5, 6 | cells label int 8, 9";

/// Returns a text file of points with additional properties.
std::string MakeTextPLY(const std::string& properties, const std::string& elements,
  const std::string& data, const std::string& count = "3")
{
  return "ply\nformat ascii 1.0\nelement vertex " + count +
    "\nproperty float x\nproperty float y\nproperty float z\n" + properties + elements +
    "end_header\n" + data;
}

const char* const FacetText = "solid name of it\nfacet normal 0 0 1\n outer loop\n"
                              "  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1.1 0\n"
                              " endloop\nendfacet\n";
const char* const SecondFacet = "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 1.1 0\nVERTEX 1 0 0\n"
                                "VERTEX 1 -0 2\nENDLOOP\nENDFACET\nENDSOLID\n";

std::string MakeSTL(std::uint32_t count, const std::string& header = "binary")
{
  std::string file =
    header + std::string(80 - header.size(), ' ') + Bytes<std::uint32_t>({ count });
  file += Bytes<float>({ 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.1f, 0 }) + std::string(2, '\0');
  file += Bytes<float>({ 0, 0, 1, 0, 0.1f, 0, 1, 0, 0, 1, 1, 0 }) + std::string(2, '\0');
  return file;
}

constexpr auto Unrecognized = vtkErrorCode::UnrecognizedFileTypeError;
constexpr auto Premature = vtkErrorCode::PrematureEndOfFileError;

const FileCase OBJCases[] = {
  { "points are the lines v whatever normals the faces name",
    "v 0 0 0\nv 3 0 0\nv 3 4 0\nv 0 4 0\nvn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\n"
    "f 1//2 3//2 4//2\n",
    "0 0 0, 3 0 0, 3 4 0, 0 4 0 | polys 0 1 2, 0 2 3" },
  { "normals and texture coordinates of one value per point",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0.1\nvt 1 0\nvt 0 1 7\nvt 0 0.1\nvn 0 0 1\n"
    "f 1/1/1 2/2/1 3/3/1\nf 1/4/1 3/3/-1 2/2/1\n",
    "0 0 0, 1 0 0, 0 1 0 | polys 0 1 2, 0 2 1 | active Normals double 0 0 1, 0 0 1, 0 0 1 "
    "| active TCoords double 0 0.1, 1 0, 0 1" },
  { "texture coordinates that some corners lack",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3\n", "0 0 0, 1 0 0, 0 1 0 | polys 0 1 2" },
  { "double digits", "v 512345.678 5403210.987 0.1\nv 1e-400 +2 .5\n",
    "512345.678 5403210.987 0.1, 0 2 0.5" },
  { "negative ids count backwards",
    "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -4 -3\n",
    "9 9 9, 0 0 0, 1 0 0, 0 1 0, 5 5 5 | polys 1 2 3, 4 1 2" },
  { "polygons, polylines and points",
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nl 1/1 2 3\n"
    "vt 0 0\np 1 4\n",
    "0 0 0, 1 0 0, 1 1 0, 0 1 0 | verts 0, 3 | lines 0 1 2 | polys 0 1 2 3" },
  { "faces before points", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
    "0 0 0, 1 0 0, 0 1 0 | polys 0 1 2" },
  { "comments, continuations, statements to skip, line ends of other systems",
    "# v 1 1 1\r\nmtllib a b\\\r\ng group # g\r\nv 0 \\\r\n 0 0 # v\r\n\r\nv 1 0 0\r\nv 0 1 0\r\n"
    "f 1 2 \\\r\n3\r\ncurv 0 1 \\\r\n1 2 3\r\n",
    "0 0 0, 1 0 0, 0 1 0 | polys 0 1 2" },
  { "lone carriage returns", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
    "0 0 0, 1 0 0, 0 1 0 | polys 0 1 2" },
  { "colors and weights", "v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1 1\n",
    "0 0 0, 1 0 0 | active RGB unsigned char 255 128 0, 0 0 255" },
  { "colors up to 255", "v 0 0 0 255 7 0\n", "0 0 0 | active RGB unsigned char 255 7 0" },
  { "weights", "v 0 0 0 1\nv nan 0 0 2\n", "0 0 0, nan 0 0" },
  { "id behind the last point", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 5\nv 2 2 2\n",
    "line 4: the point 5 is out of range: the file has 4 points" },
  { "id of a huge point with a normal", "v 0 0 0\nvn 0 0 1\nf 1 1 9000000000000//1\n",
    "line 3: the point 9000000000000" },
  { "id 0", "v 0 0 0\nf 1 1 0\n", "line 2: the point 0 is out of range" },
  { "id before the first point", "v 0 0 0\nf 1 1 -2\nv 0 0 0\n",
    "line 2: the point -2 is out of range: the file has 1 point before this line" },
  { "normal out of range", "v 0 0 0\nf 1 1 1//1\n",
    "line 2: the normal 1 is out of range: the file has 0 normals" },
  { "texture coordinate out of range", "v 0 0 0\nvt 0 0\nf 1/1 1/2 1\n",
    "line 3: the texture coordinate 2 is out of range" },
  { "too few coordinates", "v 0 0 0\nv 1 0\n", "line 2: point 1 has 2 numbers" },
  { "too many coordinates", "v 0 0 0 1 1 1 1 1\n", "line 1: '1' follows the last value" },
  { "too few corners", "v 0 0 0\nf 1 1\n", "line 2: the face has 2 points" },
  { "no number", "v 0 0 zero\n", "line 1: 'zero' is not a number" },
  { "no corner", "v 0 0 0\nf 1 1/x 1\n", "line 2: '1/x' is not a corner" },
  { "corner of four", "v 0 0 0\nf 1 1 1/1/1/1\n", "line 2: '1/1/1/1' is not a corner" },
  { "no points", "# nothing\n", "the file has no points" },
};

const FileCase PLYCases[] = {
  { "text", MakePLY("ascii"), PLYContents },
  { "little endian", MakePLY("binary_little_endian"), PLYContents },
  { "big endian", MakePLY("binary_big_endian"), PLYContents },
  { "float points",
    "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 1\r\nproperty float z\r\n"
    "property float x\r\nproperty float y\r\nend_header\r\n" +
      Bytes<float>({ 3.0f, 1.0f, 2.0f }),
    "float 1 2 3" },
  { "double digits in a text whose header promises floats",
    MakeTextPLY("", "", "512345.678 5403210.987 0.1\n", "1"), "512345.678 5403210.987 0.1" },
  { "alpha and texture coordinates",
    MakeTextPLY("property uchar alpha\nproperty uchar red\nproperty uchar green\nproperty uchar "
                "blue\nproperty double s\nproperty double t\n",
      "", "0 0 0 4 1 2 3 0.1 0.2\n", "1"),
    "0 0 0 | active TCoords double 0.1 0.2 | active RGBA unsigned char 1 2 3 4" },
  { "colors that are no bytes are numbers",
    MakeTextPLY("property float red\nproperty float green\nproperty float blue\n", "",
      "0 0 0 1 0.5 0\n", "1"),
    "0 0 0 | red float 1 | green float 0.5 | blue float 0" },
  { "faces before points, their colors and an index list of another name",
    "ply\nformat ascii 1.0\nelement face 2\nproperty list int uint vertex_index\nproperty list "
    "uchar float texcoord\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement "
    "vertex 3\nproperty int x\nproperty int y\nproperty int z\nend_header\n"
    "3 0 1 2 2 0.5 0.5 1 2 3\n1 2 0 4 5 6\n0 0 0 1 0 0 0 1 0\n",
    "0 0 0, 1 0 0, 0 1 0 | verts 2 | polys 0 1 2 "
    "| cells active RGB unsigned char 4 5 6, 1 2 3" },
  { "arrays of one name, and a second list of indices",
    MakeTextPLY("property float nx\nproperty float ny\nproperty float nz\nproperty int Normals\n"
                "property float u\nproperty float v\nproperty float s\nproperty float t\n",
      "element face 1\nproperty list int int vertex_indices\n"
      "property list int int vertex_index\n",
      "0 0 0 0 0 1 7 0.25 0.5 2 3\n1 0\n1 9\n", "1"),
    "0 0 0 | verts 0 | active Normals float 0 0 1 | active TCoords float 0.25 0.5 | Normals_ int 7 "
    "| s float 2 | t float 3" },
  { "strips",
    MakeTextPLY("", "element tristrips 1\nproperty list int int vertex_indices\n",
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 0 1 2 3 -1 2 1 0 -1\n", "4"),
    "0 0 0, 1 0 0, 0 1 0, 1 1 0 | polys 0 1 2, 2 1 3, 2 1 0" },
  { "faces without corners",
    MakeTextPLY("", "element face 1\nproperty int label\n", "0 0 0\n7\n", "1"), "0 0 0" },
  { "no points behind the header", MakeTextPLY("", "", "", "0"), "" },
  { "more points than bytes", MakeTextPLY("", "", "0 0 0\n", "1000000000000"),
    "line 3: the header declares 1000000000000 records of the element 'vertex' with at least 6 "
    "bytes each, but only 7 bytes follow",
    Premature },
  { "list beyond the end",
    MakeTextPLY("", "element face 1\nproperty list int int vertex_indices\n",
      "0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n"),
    "line 13: the file ends in record 0 of 1 of the element 'face'", Premature },
  { "id behind the last point",
    MakeTextPLY("", "element face 1\nproperty list int int vertex_indices\n",
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
    "line 13: record 0 of the element 'face': the point 3 is out of range: the file has 3 points" },
  { "face without corners",
    MakeTextPLY(
      "", "element face 1\nproperty list int int vertex_indices\n", "0 0 0\n1 0 0\n0 1 0\n0\n"),
    "the list 'vertex_indices' has 0 values" },
  { "indices that are no integers",
    MakeTextPLY("", "element face 1\nproperty list int float vertex_indices\n", ""),
    "line 8: 'float' is not a type of integers" },
  { "more than the last record", MakeTextPLY("", "", "0 0 0\n1 0 0\n", "1"),
    "line 9: 6 bytes follow the last record" },
  { "no number", MakeTextPLY("", "", "0 0 x\n", "1"),
    "line 8: record 0 of the element 'vertex': 'x' is not a number" },
  { "other file", "plyx\n", "line 1: the file does not begin", Unrecognized },
  { "unknown format", "ply\nformat binary 1.0\nend_header\n", "line 3: the format 'binary'" },
  { "unknown type", "ply\nelement vertex 1\nproperty half x\n", "line 3: 'half' is not a type" },
  { "unknown keyword", "ply\nelements 3\n", "line 2: 'elements' is not a keyword" },
  { "negative count", "ply\nelement vertex -1\n", "line 2: '-1' is not a number of records" },
  { "second element", "ply\nelement a 1\nelement a 1\n",
    "line 3: the header has a second element 'a'" },
  { "second property", "ply\nelement a 1\nproperty int x\nproperty int x\n",
    "line 4: the element has a second property 'x'" },
  { "property of nothing", "ply\nproperty int x\n", "line 2: a property precedes" },
  { "point without z",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n0 0\n",
    "line 3: the element 'vertex' has no property z" },
  { "no points", "ply\nformat ascii 1.0\nend_header\n", "the header has no element 'vertex'" },
};

const FileCase STLCases[] = {
  { "text", std::string(FacetText) + SecondFacet,
    "0 0 0, 1 0 0, 0 1.1 0, 1 0 2 | polys 0 1 2, 2 1 3" },
  { "two solids", std::string(FacetText) + "endsolid a b\nsolid\nendsolid\n",
    "0 0 0, 1 0 0, 0 1.1 0 | polys 0 1 2" },
  { "binary", MakeSTL(2),
    "float 0 0 0, 1 0 0, 0 " + Digits(0.1f) + " 0, 1 1 0 | polys 0 1 2, 2 1 3" },
  { "binary that begins with solid", MakeSTL(2, "solid"),
    "float 0 0 0, 1 0 0, 0 " + Digits(0.1f) + " 0, 1 1 0 | polys 0 1 2, 2 1 3" },
  { "binary that is too short", MakeSTL(3, "solid"),
    "byte 80: the header declares 3 triangles, 234 bytes in all, but the file has 184 bytes",
    Premature },
  { "binary that is too long", MakeSTL(1),
    "byte 80: the header declares 1 triangle, 134 bytes in all, but the file has 184 bytes" },
  { "short header", "nothing", "byte 7: the file ends inside the header of 84 bytes", Premature },
  { "text without endsolid", FacetText, "line 9: the file ends before endsolid", Premature },
  { "facet of four corners",
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 "
    "0\n"
    "endloop\nendfacet\nendsolid\n",
    "line 7: expected endloop, got 'vertex'" },
  { "no number", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 a\n",
    "line 4: 'a' is not a number" },
  { "other word", "solid\nvertex 0 0 0\n", "line 2: expected facet or endsolid, got 'vertex'" },
};

const FileCase XYZCases[] = {
  { "separators, comments, further words",
    "# c\n1 2 3 9 n\n\n4;5;\t6 // c, d\n512345.678\t0.1 nan\n",
    "1 2 3, 4 5 6, 512345.678 0.1 nan | verts 0, 1" },
  { "count", "2\n1 2 3\n4 5 6\n", "1 2 3, 4 5 6 | verts 0, 1" },
  { "count of too many points", "5\n0 0 0\n1 1 1\n",
    "the declared number of points is 5, but the file has 2. The file", Premature },
  { "count of too few points", "1\n0 0 0\n1 1 1\n",
    "the declared number of points is 1, but the file has 2" },
  { "decimal commas", "0;0;0\n1.5;2;3,5\n", "line 2: ',' may separate numbers" },
  { "decimal commas and blanks", "0,5 0,5 0,1\n1,5 2,5 3,5\n", "line 1: ',' may separate numbers" },
  { "header", "//X,Y\nX,Y,Z,\"nx\"\n1,2,3,0\n", "1 2 3 | verts 0" },
  { "too few numbers", "1 2 3\n4 5\n",
    "line 2: the line has 2 numbers. Expected the coordinates x, y and z" },
  { "words behind the first line", "1 2 3\nx y z\n", "line 2: 'x' is not a number" },
  { "header with a number", "x 2 z\n1 2 3\n", "line 1: 'x' is not a number" },
  { "no points", "# c\n", "the file has no points" },
};

/// Parts from which a valid file with n points is composed. '@' is replaced by n, and '#' by the
/// index of a row.
struct GoodFile
{
  const char* Name;
  bool HasCounts; ///< true if truncation is always detected
  std::string Head;
  std::string Row;
  std::string Tail = "";
  int FirstRow = 2;

  std::string Make(int points) const
  {
    std::string file = this->Head;
    const std::size_t count = file.find('@');
    if (count != std::string::npos)
    {
      file.replace(count, 1, std::to_string(points));
    }
    const std::size_t index = this->Row.find('#');
    for (int i = this->FirstRow; i < points; ++i)
    {
      file += this->Row.substr(0, index) + std::to_string(i) + this->Row.substr(index + 1);
    }
    return file + this->Tail;
  }
};
template <typename ReaderType>
const GoodFile Good = { "mesh.obj", false, "v 1.5 2.25 1000.5\nv 1 0 0\n", "v 0 1 #\nf 1 2 3\n" };
template <>
const GoodFile Good<vtkDGGOFFReader> = { "mesh.off", true, "OFF @ 1 0\n1.5 2.25 1000.5\n1 0 0\n",
  "0 1 #\n", "3 0 1 2\n" };
template <>
const GoodFile Good<vtkPCDReader> = { "cloud.pcd", true,
  "FIELDS x y z\nPOINTS @\nDATA ascii\n1.5 2.25 1000.5\n", "# 0 1\n", "", 1 };
template <>
const GoodFile Good<vtkDGGPLYReader> = { "mesh.ply", true,
  MakeTextPLY(
    "", "element face 1\nproperty list int int vertex_indices\n", "1.5 2.25 1000.5\n1 0 0\n", "@"),
  "0 1 #\n", "3 0 1 2\n" };
template <>
const GoodFile Good<vtkDGGSTLReader> = { "mesh.stl", true, "solid\n",
  "facet normal 0 0 1\nouter loop\nvertex 1.5 2.25 1000.5\nvertex 1 0 0\nvertex 0 1 #\nendloop\n"
  "endfacet\n",
  "endsolid\n" };
template <>
const GoodFile Good<vtkDGGXYZReader> = { "cloud.xyz", false, "1.5 2.25 1000.5\n", "0 1 #\n", "",
  1 };

template <typename ReaderType>
class MeshReaders : public dggtest::ReaderFixture<ReaderType>
{
protected:
  MeshReaders()
    : dggtest::ReaderFixture<ReaderType>(::Good<ReaderType>.Name, ::Good<ReaderType>.Make(3))
  {
  }
};

using OBJReader = MeshReaders<vtkDGGOBJReader>;
using PLYReader = MeshReaders<vtkDGGPLYReader>;
using STLReader = MeshReaders<vtkDGGSTLReader>;
using XYZReader = MeshReaders<vtkDGGXYZReader>;
}

TEST_F(OBJReader, ReadsOrRefuses)
{
  this->Check(OBJCases);
}

TEST_F(PLYReader, ReadsOrRefuses)
{
  this->Check(PLYCases);
}

TEST_F(PLYReader, RefusesTruncatedFiles)
{
  for (const char* format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    this->CheckTruncation(MakePLY(format), true);
  }
}

TEST_F(PLYReader, WarnsOfTruncatedLastNumbers)
{
  std::string points;
  for (int i = 0; i < 12; ++i)
  {
    points += "0 0 " + std::to_string(i) + "\n";
  }
  this->ExpectWarningIfCut(MakeTextPLY(
    "", "element face 1\nproperty list int int vertex_indices\n", points + "3 0 1 11\n", "12"));
}

TEST_F(PLYReader, RecognizesByteOrderMarks)
{
  const std::string path = this->Write("\xEF\xBB\xBF" + this->Good);
  EXPECT_EQ(vtkDGGPLYReader::CanReadFile(path.c_str()), 1);
}

TEST_F(PLYReader, RefusesHeadersOfManyProperties)
{
  std::string file = "ply\nformat ascii 1.0\nelement vertex 1\n";
  for (int i = 0; i < 10001; ++i)
  {
    file += "property int " + std::to_string(i) + "\n";
  }
  this->ExpectRefused(file, vtkErrorCode::FileFormatError, { "line 10003", "more than 10000" });
}

TEST_F(STLReader, ReadsOrRefuses)
{
  this->Check(STLCases);
}

TEST_F(STLReader, RefusesTruncatedBinaryFiles)
{
  this->CheckTruncation(MakeSTL(2), true);
}

TEST_F(STLReader, RecognizesFilesWithoutTriangles)
{
  const std::string path = this->Write(MakeSTL(0).substr(0, 80) + std::string(4, '\0'));
  EXPECT_EQ(vtkDGGSTLReader::CanReadFile(path.c_str()), 1);
}

TEST_F(XYZReader, ReadsOrRefuses)
{
  this->Check(XYZCases);
}

using ReaderTypes = testing::Types<vtkDGGOBJReader, vtkDGGOFFReader, vtkDGGPLYReader,
  vtkDGGSTLReader, vtkDGGXYZReader, vtkPCDReader>;
TYPED_TEST_SUITE(MeshReaders, ReaderTypes);

TYPED_TEST(MeshReaders, NoticesTruncatedFiles)
{
  this->CheckTruncation(::Good<TypeParam>.Make(30), ::Good<TypeParam>.HasCounts);
}

TYPED_TEST(MeshReaders, ReadsCompressedFiles)
{
  const std::string& content = this->Good;
  const std::string expected = Describe(this->ReadWell(content));
  const std::string path = this->GetPath("file.gz");
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, content.data(), static_cast<unsigned>(content.size()));
  gzclose(file);
  EXPECT_EQ(Describe(this->ReadWellFile("file.gz")), expected);
  EXPECT_EQ(TypeParam::CanReadFile(path.c_str()), 1);

  std::string compressed = this->Load("file.gz");
  this->ExpectRefused(compressed.substr(0, compressed.size() / 2),
    vtkErrorCode::PrematureEndOfFileError, { "the compressed data end too early" });
  compressed[compressed.size() - 8] ^= 1; // corrupts the checksum
  this->ExpectRefused(compressed, vtkErrorCode::FileFormatError,
    { "the file cannot be decompressed: incorrect data check" });
}

TYPED_TEST(MeshReaders, FilesThatCannotBeRead)
{
  this->CheckFilesThatCannotBeRead();
}

TYPED_TEST(MeshReaders, ProgressAndAbort)
{
  this->CheckProgress(::Good<TypeParam>.Make(100000), 100000);
}

TYPED_TEST(MeshReaders, Locales)
{
  this->CheckLocales(this->Good);
}
