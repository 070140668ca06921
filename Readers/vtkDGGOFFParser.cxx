// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOFFParser.h"

#include "vtkErrorCode.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace
{
/// Colour of faces that have none in a file where others do: geomview's default.
constexpr float DefaultGrey = 170.0f;
/// Records between two reports of progress.
constexpr vtkIdType ProgressInterval = 1 << 16;

constexpr auto Malformed = vtkErrorCode::FileFormatError;
constexpr auto Unrecognized = vtkErrorCode::UnrecognizedFileTypeError;
constexpr auto Premature = vtkErrorCode::PrematureEndOfFileError;
}

vtkNew<vtkUnsignedCharArray> vtkDGGOFFColors::MakeArray(const std::vector<vtkIdType>& order) const
{
  const int components = this->HasAlpha ? 4 : 3;
  const float scale = this->SawAboveOne ? 1.0f : 255.0f;
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(components == 4 ? "RGBA" : "RGB");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(order.size()));
  unsigned char* out = array->GetPointer(0);
  for (const vtkIdType record : order)
  {
    const float* value = this->Values.data() + 4 * record;
    for (int c = 0; c < components; ++c)
    {
      const bool isOpaque = c == 3 && value[3] < 0.0f;
      const float scaled = value[0] < 0.0f ? DefaultGrey : value[c] * scale;
      *out++ = isOpaque ? 255 : static_cast<unsigned char>(scaled + 0.5f);
    }
  }
  return array;
}

vtkDGGOFFParser::vtkDGGOFFParser(const std::vector<char>& bytes)
  : Begin(bytes.data())
  , End(bytes.data() + bytes.size())
  , Cursor(vtkDGG::SkipByteOrderMark(this->Begin, this->End))
{
}

void vtkDGGOFFParser::ReadKeyword()
{
  if (this->Begin == this->End)
  {
    this->Fail(Premature, "the file is empty");
  }
  if (!this->FindAnywhere())
  {
    this->FailEnd("the keyword OFF", -1);
  }
  const Token token = this->TakeToken();
  bool isInSpace = true;
  if (!this->ParseKeyword(std::string(token.First, token.Last), isInSpace))
  {
    this->Fail(Unrecognized,
      vtkDGG::Quote(token.First, token.Last) +
        " is not the keyword of an OFF file: OFF, or OFF with the prefixes ST, C, N");
  }
  if (!isInSpace)
  {
    this->Fail(Unrecognized,
      vtkDGG::Quote(token.First, token.Last) +
        " has points of four or any number of coordinates: only points in space can be read, "
        "convert the file to OFF");
  }
  const char* const after = this->Cursor;
  if (this->FindOnLine())
  {
    const Token next = this->TakeToken();
    this->IsBinary = std::string(next.First, next.Last) == "BINARY";
    if (this->IsBinary)
    {
      const char* const lineEnd = std::find(this->Cursor, this->End, '\n');
      this->Cursor = lineEnd == this->End ? lineEnd : lineEnd + 1;
      return;
    }
  }
  this->Cursor = after;
}

/// [ST][C][N][4][n]OFF, the prefixes in any order; 4 and n are points that are not in space.
bool vtkDGGOFFParser::ParseKeyword(const std::string& keyword, bool& isInSpace)
{
  if (keyword.size() < 3 || keyword.compare(keyword.size() - 3, 3, "OFF") != 0)
  {
    return false;
  }
  std::string prefix = keyword.substr(0, keyword.size() - 3);
  const auto take = [&prefix](const char* letters) {
    const std::size_t place = prefix.find(letters);
    if (place == std::string::npos)
    {
      return false;
    }
    prefix.replace(place, std::strlen(letters), " "); // "SCT" does not become "ST"
    return true;
  };
  this->HasTCoords = take("ST");
  this->HasColors = take("C");
  this->HasNormals = take("N");
  const bool isHomogeneous = take("4");
  isInSpace = !take("n") && !isHomogeneous;
  return prefix.find_first_not_of(' ') == std::string::npos;
}

void vtkDGGOFFParser::ReadData(const vtkDGG::FileProgress& progress)
{
  this->ReadCounts();
  const auto prepare = [this](vtkDataArray* array, int components, bool isUsed) {
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(isUsed ? this->NumberOfVertices : 0);
  };
  prepare(this->Points, 3, true);
  prepare(this->Normals, 3, this->HasNormals);
  prepare(this->TCoords, 2, this->HasTCoords);
  this->FaceOffsets.reserve(static_cast<std::size_t>(this->NumberOfFaces) + 1);
  this->Connectivity.reserve(3 * static_cast<std::size_t>(this->NumberOfFaces));
  const auto report = [&](vtkIdType record) {
    if (record % ProgressInterval == 0)
    {
      progress(static_cast<double>(this->Cursor - this->Begin) /
        static_cast<double>(this->End - this->Begin + 1));
    }
  };
  for (vtkIdType v = 0; v < this->NumberOfVertices; ++v)
  {
    report(v);
    this->ReadVertex(v);
  }
  for (vtkIdType f = 0; f < this->NumberOfFaces; ++f)
  {
    report(f);
    this->ReadFace(f);
  }
  this->FaceOffsets.push_back(static_cast<vtkIdType>(this->Connectivity.size()));
  this->ReadEnd();
  this->CheckColors(this->PointColors);
  this->CheckColors(this->FaceColors);
}

void vtkDGGOFFParser::ReadCounts()
{
  const long long vertices = this->ReadInteger("the number of vertices");
  const long long faces = this->ReadInteger("the number of faces");
  // The number of edges says nothing, and some text files leave it out. It is there when it follows
  // on the same line, or stands alone on the next one.
  if (this->IsBinary)
  {
    this->ReadInteger("the number of edges");
  }
  else if (this->FindOnLine())
  {
    this->ToInteger(this->TakeToken());
    if (this->FindOnLine())
    {
      this->Fail(Malformed, "more than the three counts of vertices, faces and edges");
    }
  }
  else
  {
    const char* const after = this->Cursor;
    const std::size_t line = this->Line;
    long long edges = 0;
    bool isThere = this->FindAnywhere();
    if (isThere)
    {
      const Token token = this->TakeToken();
      const auto parsed = std::from_chars(token.First, token.Last, edges);
      isThere = parsed.ptr == token.Last && parsed.ec == std::errc() && !this->FindOnLine();
    }
    if (!isThere)
    {
      this->Cursor = after;
      this->Line = line;
    }
  }
  this->CheckCounts(vertices, faces);
  this->NumberOfVertices = static_cast<vtkIdType>(vertices);
  this->NumberOfFaces = static_cast<vtkIdType>(faces);
}

/// Before anything is allocated.
void vtkDGGOFFParser::CheckCounts(long long vertices, long long faces)
{
  std::ostringstream message;
  if (vertices < 0 || faces < 0)
  {
    message << "the counts must not be negative, but are " << vertices << " vertices and " << faces
            << " faces";
    this->Fail(Malformed, message.str());
  }
  // The fewest bytes: in text a digit and a blank or line end for each number, and the last line
  // may lack its end.
  const unsigned long long color = this->IsBinary ? 4 : 3;
  const unsigned long long perVertex = (this->IsBinary ? 4 : 2) *
    (3 + (this->HasNormals ? 3 : 0) + (this->HasColors ? color : 0) + (this->HasTCoords ? 2 : 0));
  const unsigned long long perFace = this->IsBinary ? 12 : 4;
  const auto room = static_cast<unsigned long long>(this->GetRemaining() + 1);
  const auto maximum = static_cast<long long>(std::numeric_limits<vtkIdType>::max() / 4);
  const auto v = static_cast<unsigned long long>(vertices);
  const auto f = static_cast<unsigned long long>(faces);
  if (vertices > maximum || faces > maximum || v > room / perVertex || f > room / perFace ||
    v * perVertex + f * perFace > room)
  {
    message << "the file promises " << vertices << " vertices and " << faces << " faces, but only "
            << this->GetRemaining() << " bytes follow";
    this->Fail(Premature, message.str());
  }
}

void vtkDGGOFFParser::ReadVertex(vtkIdType vertex)
{
  double* point = this->Points->GetPointer(3 * vertex);
  for (int i = 0; i < 3; ++i)
  {
    point[i] = this->ReadNumber(
      this->IsBinary ? "a coordinate of vertex " : "the coordinates of vertex ", vertex);
  }
  for (int i = 0; this->HasNormals && i < 3; ++i)
  {
    const double value = this->ReadNumber("the normal of vertex ", vertex);
    this->Normals->SetValue(3 * vertex + i, static_cast<float>(value));
  }
  const std::size_t tCoords = this->HasTCoords ? 2 : 0;
  this->Rest.clear();
  if (this->IsBinary)
  {
    for (int i = 0; this->HasColors && i < 4; ++i)
    {
      this->Rest.push_back({ this->ReadNumber("the colour of vertex ", vertex), true });
    }
  }
  else
  {
    this->ReadRestOfLine();
    const std::size_t rest = this->Rest.size();
    if (this->HasColors ? rest != tCoords + 3 && rest != tCoords + 4 : rest != tCoords)
    {
      std::ostringstream message;
      message << "vertex " << vertex << " has " << rest << " numbers after its coordinates"
              << (this->HasNormals ? " and normal" : "") << ", expected "
              << (this->HasColors ? "3 or 4 of a colour" : "none of a colour")
              << (this->HasTCoords ? " and 2 texture coordinates" : "");
      const bool isCut = rest == 0 && this->Cursor == this->End;
      this->Fail(isCut ? Premature : Malformed, message.str());
    }
  }
  const std::size_t colors = this->Rest.size() - (this->IsBinary ? 0 : tCoords);
  if (this->HasColors)
  {
    BeginColor(this->PointColors);
    for (std::size_t i = 0; i < colors; ++i)
    {
      this->AddColor(this->PointColors, this->Rest[i]);
    }
  }
  for (std::size_t i = 0; i < tCoords; ++i)
  {
    const double value = this->IsBinary
      ? this->ReadNumber("a texture coordinate of vertex ", vertex)
      : this->Rest[colors + i].Value;
    this->TCoords->SetValue(2 * vertex + static_cast<vtkIdType>(i), static_cast<float>(value));
  }
}

void vtkDGGOFFParser::ReadFace(vtkIdType face)
{
  const long long corners = this->ReadInteger("face ", face);
  std::ostringstream message;
  if (corners < 1)
  {
    message << "face " << face << " has " << corners << " vertices: at least 1 is needed";
    this->Fail(Malformed, message.str());
  }
  const std::size_t leastCorner = this->IsBinary ? 4 : 2; // in text, "0" and a blank or line end
  if (static_cast<unsigned long long>(corners) > (this->GetRemaining() + 1) / leastCorner)
  {
    message << "face " << face << " promises " << corners << " vertices, but only "
            << this->GetRemaining() << " bytes follow";
    this->Fail(Premature, message.str());
  }
  this->FaceOffsets.push_back(static_cast<vtkIdType>(this->Connectivity.size()));
  for (long long k = 0; k < corners; ++k)
  {
    const long long vertex = this->ReadInteger("the vertices of face ", face);
    if (vertex < 0 || vertex >= this->NumberOfVertices)
    {
      message << "face " << face << " names vertex " << vertex << ", but the file has "
              << this->NumberOfVertices << " vertices, numbered from 0";
      this->Fail(Malformed, message.str());
    }
    this->Connectivity.push_back(static_cast<vtkIdType>(vertex));
  }
  this->ReadFaceColor(face);
}

/// A single number is an index into a table of colours that is not in the file.
void vtkDGGOFFParser::ReadFaceColor(vtkIdType face)
{
  BeginColor(this->FaceColors);
  std::ostringstream message;
  const auto isCount = [](auto count) {
    return count == 0 || count == 1 || count == 3 || count == 4;
  };
  if (this->IsBinary)
  {
    const long long components = this->ReadInteger("the colour of face ", face);
    if (!isCount(components))
    {
      message << "face " << face << " has a colour of " << components
              << " components, expected 0, 1 (an index), 3 or 4";
      this->Fail(Malformed, message.str());
    }
    if (components == 1)
    {
      this->ReadInteger("the colour of face ", face);
      return;
    }
    for (long long i = 0; i < components; ++i)
    {
      this->AddColor(this->FaceColors, { this->ReadNumber("the colour of face ", face), true });
    }
    return;
  }
  this->ReadRestOfLine();
  if (!isCount(this->Rest.size()))
  {
    message << "face " << face << " has " << this->Rest.size()
            << " numbers after its vertices, expected none, 1 (an index of a colour) or 3 or 4 (a "
               "colour)";
    this->Fail(Malformed, message.str());
  }
  for (std::size_t i = 0; this->Rest.size() > 1 && i < this->Rest.size(); ++i)
  {
    this->AddColor(this->FaceColors, this->Rest[i]);
  }
}

void vtkDGGOFFParser::ReadEnd()
{
  if (this->IsBinary)
  {
    this->Cursor = std::find_if(this->Cursor, this->End,
      [](char c) { return std::isspace(static_cast<unsigned char>(c)) == 0; });
    if (this->Cursor != this->End)
    {
      this->Fail(Malformed,
        std::to_string(this->GetRemaining()) +
          " bytes follow the last face: are the counts too small?");
    }
  }
  else if (this->FindAnywhere())
  {
    const Token token = this->TakeToken();
    this->Fail(Malformed,
      vtkDGG::Quote(token.First, token.Last) + " follows the last face: are the counts too small?");
  }
}

void vtkDGGOFFParser::CheckColors(const vtkDGGOFFColors& colors) const
{
  if (colors.SawFraction && colors.SawAboveOne)
  {
    this->FailAt(colors.PlaceAboveOne, Malformed,
      "a colour component is above 1, but others of the file are fractions of 1");
  }
}

void vtkDGGOFFParser::BeginColor(vtkDGGOFFColors& colors)
{
  colors.Values.insert(colors.Values.end(), { -1.0f, 0.0f, 0.0f, -1.0f });
  colors.Components = 0;
}

void vtkDGGOFFParser::AddColor(vtkDGGOFFColors& colors, const RestNumber& number) const
{
  const double value = number.Value;
  if (!(value >= 0.0 && value <= (number.IsFraction ? 1.0 : 255.0)))
  {
    std::ostringstream message;
    message << "the colour component " << value
            << " is out of range: fractions must be in [0, 1], integers in [0, 255]";
    this->Fail(Malformed, message.str());
  }
  colors.SawFraction = colors.SawFraction || number.IsFraction;
  if (value > 1.0 && !colors.SawAboveOne)
  {
    colors.SawAboveOne = true;
    colors.PlaceAboveOne = this->GetPlace();
  }
  colors.IsUsed = true;
  colors.HasAlpha = colors.HasAlpha || colors.Components == 3;
  colors.Values[colors.Values.size() - 4 + static_cast<std::size_t>(colors.Components++)] =
    static_cast<float>(value);
}

double vtkDGGOFFParser::ReadNumber(const char* what, vtkIdType record)
{
  if (!this->IsBinary)
  {
    if (!this->FindAnywhere())
    {
      this->FailEnd(what, record);
    }
    return this->ToNumber(this->TakeToken());
  }
  const std::uint32_t bits = this->ReadBits(what, record);
  float value = 0.0f;
  std::memcpy(&value, &bits, sizeof(value));
  if (!std::isfinite(value))
  {
    this->FailAt(this->GetPlace() - 4, Malformed, what + std::to_string(record) + " is not finite");
  }
  return static_cast<double>(value);
}

long long vtkDGGOFFParser::ReadInteger(const char* what, vtkIdType record)
{
  if (this->IsBinary)
  {
    return static_cast<std::int32_t>(this->ReadBits(what, record));
  }
  if (!this->FindAnywhere())
  {
    this->FailEnd(what, record);
  }
  return this->ToInteger(this->TakeToken());
}

/// Four bytes, the most significant one first.
std::uint32_t vtkDGGOFFParser::ReadBits(const char* what, vtkIdType record)
{
  if (this->GetRemaining() < 4)
  {
    this->FailEnd(what, record);
  }
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i)
  {
    bits = bits << 8 | static_cast<unsigned char>(*this->Cursor++);
  }
  return bits;
}

void vtkDGGOFFParser::ReadRestOfLine()
{
  this->Rest.clear();
  while (this->FindOnLine())
  {
    const Token token = this->TakeToken();
    const bool isFraction =
      std::any_of(token.First, token.Last, [](char c) { return c == '.' || c == 'e' || c == 'E'; });
    this->Rest.push_back({ this->ToNumber(token), isFraction });
  }
}

/// Lines may end with a return alone.
bool vtkDGGOFFParser::IsAtLineEnd() const
{
  const char* const next = this->Cursor + 1;
  return *this->Cursor == '\n' || (*this->Cursor == '\r' && (next == this->End || *next != '\n'));
}

bool vtkDGGOFFParser::FindOnLine()
{
  bool isComment = false;
  for (; this->Cursor != this->End && !this->IsAtLineEnd(); ++this->Cursor)
  {
    isComment = isComment || *this->Cursor == '#';
    if (!isComment && !vtkDGG::IsBlank(*this->Cursor))
    {
      return true;
    }
  }
  return false;
}

bool vtkDGGOFFParser::FindAnywhere()
{
  while (!this->FindOnLine())
  {
    if (this->Cursor == this->End)
    {
      return false;
    }
    ++this->Cursor; // the line end
    ++this->Line;
  }
  return true;
}

vtkDGGOFFParser::Token vtkDGGOFFParser::TakeToken()
{
  const char* const first = this->Cursor;
  this->Cursor = std::find_if(
    first, this->End, [](char c) { return c == '\n' || c == '#' || vtkDGG::IsBlank(c); });
  return { first, this->Cursor };
}

double vtkDGGOFFParser::ToNumber(const Token& token) const
{
  double value = 0.0;
  const vtkDGG::NumberText text = vtkDGG::ParseNumber(token.First, token.Last, value);
  if (text != vtkDGG::NumberText::Valid || !std::isfinite(value))
  {
    this->Fail(Malformed,
      vtkDGG::Quote(token.First, token.Last) +
        (text == vtkDGG::NumberText::Valid           ? " is not finite"
            : text == vtkDGG::NumberText::OutOfRange ? " is too large"
                                                     : " is not a number"));
  }
  return value;
}

long long vtkDGGOFFParser::ToInteger(const Token& token) const
{
  long long value = 0;
  const vtkDGG::NumberText text = vtkDGG::ParseNumber(token.First, token.Last, value);
  if (text != vtkDGG::NumberText::Valid)
  {
    this->Fail(Malformed,
      vtkDGG::Quote(token.First, token.Last) +
        (text == vtkDGG::NumberText::OutOfRange ? " is too large" : " is not an integer"));
  }
  return value;
}

std::size_t vtkDGGOFFParser::GetPlace() const
{
  return this->IsBinary ? static_cast<std::size_t>(this->Cursor - this->Begin) : this->Line;
}

void vtkDGGOFFParser::Fail(unsigned long code, const std::string& message) const
{
  this->FailAt(this->GetPlace(), code, message);
}

void vtkDGGOFFParser::FailAt(
  std::size_t place, unsigned long code, const std::string& message) const
{
  throw vtkDGG::FileError(
    code, (this->IsBinary ? "byte " : "line ") + std::to_string(place) + ": " + message);
}

void vtkDGGOFFParser::FailEnd(const char* what, vtkIdType record) const
{
  this->Fail(Premature,
    std::string("the file ends before ") + what + (record < 0 ? "" : std::to_string(record)));
}
