// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOFFTextParser.h"

#include "vtkErrorCode.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <system_error>

namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// std::from_chars does not know a leading plus.
const char* SkipPlus(const char* first, const char* last)
{
  return last - first > 1 && first[0] == '+' && first[1] != '-' ? first + 1 : first;
}
}

bool vtkDGGOFFTextParser::IsLoneReturn() const
{
  return *this->Cursor == '\r' && (this->Cursor + 1 == this->End || this->Cursor[1] != '\n');
}

bool vtkDGGOFFTextParser::FindOnLine()
{
  while (this->Cursor != this->End && !this->IsAtLineEnd())
  {
    if (*this->Cursor == '#')
    {
      while (this->Cursor != this->End && !this->IsAtLineEnd())
      {
        ++this->Cursor;
      }
      return false;
    }
    if (!IsBlank(*this->Cursor))
    {
      return true;
    }
    ++this->Cursor;
  }
  return false;
}

bool vtkDGGOFFTextParser::FindAnywhere()
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

vtkDGGOFFTextParser::Token vtkDGGOFFTextParser::TakeToken()
{
  const char* first = this->Cursor;
  while (this->Cursor != this->End && *this->Cursor != '\n' && *this->Cursor != '#' &&
    !IsBlank(*this->Cursor))
  {
    ++this->Cursor;
  }
  return { first, this->Cursor };
}

bool vtkDGGOFFTextParser::ToNumber(const Token& token, double& value)
{
  const char* first = SkipPlus(token.First, token.Last);
  const auto parsed = std::from_chars(first, token.Last, value);
  const bool isNumber = parsed.ptr == token.Last && parsed.ec != std::errc::invalid_argument;
  if (isNumber && parsed.ec == std::errc::result_out_of_range)
  {
    // Too small is as good as zero.
    const std::string text(first, token.Last);
    const std::size_t exponent = text.find_first_of("eE");
    if (exponent != std::string::npos && text.compare(exponent + 1, 1, "-") == 0)
    {
      value = 0.0;
      return true;
    }
    return this->Fail(
      vtkErrorCode::FileFormatError, vtkDGGQuote(token.First, token.Last) + " is too large");
  }
  if (!isNumber)
  {
    return this->Fail(
      vtkErrorCode::FileFormatError, vtkDGGQuote(token.First, token.Last) + " is not a number");
  }
  if (!std::isfinite(value))
  {
    return this->Fail(
      vtkErrorCode::FileFormatError, vtkDGGQuote(token.First, token.Last) + " is not finite");
  }
  return true;
}

bool vtkDGGOFFTextParser::ToInteger(const Token& token, long long& value)
{
  const auto parsed = std::from_chars(SkipPlus(token.First, token.Last), token.Last, value);
  if (parsed.ptr == token.Last && parsed.ec == std::errc())
  {
    return true;
  }
  const bool isLarge = parsed.ptr == token.Last && parsed.ec == std::errc::result_out_of_range;
  return this->Fail(vtkErrorCode::FileFormatError,
    vtkDGGQuote(token.First, token.Last) + (isLarge ? " is too large" : " is not an integer"));
}

bool vtkDGGOFFTextParser::ReadNumber(const char* what, vtkIdType record, double& value)
{
  if (!this->FindAnywhere())
  {
    return this->FailEnd(what + std::to_string(record));
  }
  return this->ToNumber(this->TakeToken(), value);
}

bool vtkDGGOFFTextParser::ReadInteger(const char* what, long long& value)
{
  if (!this->FindAnywhere())
  {
    return this->FailEnd(what);
  }
  return this->ToInteger(this->TakeToken(), value);
}

bool vtkDGGOFFTextParser::ReadKeyword(const char*& binary)
{
  binary = nullptr;
  static const char byteOrderMark[] = "\xEF\xBB\xBF";
  if (this->GetRemaining() >= 3 && std::equal(byteOrderMark, byteOrderMark + 3, this->Cursor))
  {
    this->Cursor += 3;
  }
  if (!this->FindAnywhere())
  {
    return this->FailEnd("the keyword OFF");
  }
  const Token token = this->TakeToken();
  if (!this->Contents.Header.ParseKeyword(std::string(token.First, token.Last)))
  {
    return this->Fail(vtkErrorCode::UnrecognizedFileTypeError,
      vtkDGGQuote(token.First, token.Last) +
        " is not the keyword of an OFF file: OFF, or OFF with the prefixes ST, C, N");
  }
  if (this->Contents.Header.IsHomogeneous || this->Contents.Header.IsAnyDimension)
  {
    return this->Fail(vtkErrorCode::UnrecognizedFileTypeError,
      vtkDGGQuote(token.First, token.Last) +
        " has points of four or any number of coordinates: only points in space can be read, "
        "convert the file to OFF");
  }
  const char* const after = this->Cursor;
  if (this->FindOnLine())
  {
    const Token next = this->TakeToken();
    if (std::string(next.First, next.Last) == "BINARY")
    {
      // The data begin after the line end.
      while (this->Cursor != this->End && *this->Cursor != '\n')
      {
        ++this->Cursor;
      }
      binary = this->Cursor == this->End ? this->Cursor : this->Cursor + 1;
      return true;
    }
    this->Cursor = after;
  }
  return true;
}

bool vtkDGGOFFTextParser::ReadCounts(long long& vertices, long long& faces)
{
  if (!this->ReadInteger("the number of vertices", vertices) ||
    !this->ReadInteger("the number of faces", faces))
  {
    return false;
  }
  // The number of edges says nothing, and some files leave it out. It is there when it follows on
  // the same line, or stands alone on the next one.
  long long edges = 0;
  if (this->FindOnLine())
  {
    return this->ToInteger(this->TakeToken(), edges) &&
      (!this->FindOnLine() ||
        this->Fail(vtkErrorCode::FileFormatError,
          "more than the three counts of vertices, faces and edges"));
  }
  const char* const after = this->Cursor;
  const std::size_t line = this->Line;
  if (this->FindAnywhere())
  {
    const Token token = this->TakeToken();
    const auto parsed = std::from_chars(token.First, token.Last, edges);
    if (parsed.ptr == token.Last && parsed.ec == std::errc() && !this->FindOnLine())
    {
      return true;
    }
  }
  this->Cursor = after;
  this->Line = line;
  return true;
}

std::size_t vtkDGGOFFTextParser::GetLeastVertexSize() const
{
  // A digit and a blank or line end for each number.
  const vtkDGGOFFHeader& header = this->Contents.Header;
  return 2 *
    (3 + (header.HasNormals ? 3 : 0) + (header.HasColors ? 3 : 0) + (header.HasTCoords ? 2 : 0));
}

bool vtkDGGOFFTextParser::ReadRestOfLine()
{
  this->Rest.clear();
  while (this->FindOnLine())
  {
    const Token token = this->TakeToken();
    double value = 0.0;
    if (!this->ToNumber(token, value))
    {
      return false;
    }
    const bool isFraction =
      std::any_of(token.First, token.Last, [](char c) { return c == '.' || c == 'e' || c == 'E'; });
    this->Rest.push_back({ value, isFraction });
  }
  return true;
}

bool vtkDGGOFFTextParser::AddColors(vtkDGGOFFColors& colors, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!this->AddColor(colors, this->Rest[i].Value, this->Rest[i].IsFraction))
    {
      return false;
    }
  }
  return true;
}

bool vtkDGGOFFTextParser::ReadVertex(vtkIdType vertex)
{
  const vtkDGGOFFHeader& header = this->Contents.Header;
  double value = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    if (!this->ReadNumber("the coordinates of vertex ", vertex, value))
    {
      return false;
    }
    this->Contents.Points.push_back(value);
  }
  for (int i = 0; header.HasNormals && i < 3; ++i)
  {
    if (!this->ReadNumber("the normal of vertex ", vertex, value))
    {
      return false;
    }
    this->Contents.Normals.push_back(static_cast<float>(value));
  }
  if (!this->ReadRestOfLine())
  {
    return false;
  }
  const std::size_t tCoords = header.HasTCoords ? 2 : 0;
  const std::size_t rest = this->Rest.size();
  const bool fits = header.HasColors ? rest == tCoords + 3 || rest == tCoords + 4 : rest == tCoords;
  if (!fits)
  {
    std::ostringstream message;
    message << "vertex " << vertex << " has " << rest << " numbers after its coordinates"
            << (header.HasNormals ? " and normal" : "") << ", expected "
            << (header.HasColors ? "3 or 4 of a colour" : "none of a colour")
            << (header.HasTCoords ? " and 2 texture coordinates" : "");
    const bool isCut = rest == 0 && this->Cursor == this->End;
    return this->Fail(
      isCut ? vtkErrorCode::PrematureEndOfFileError : vtkErrorCode::FileFormatError, message.str());
  }
  if (header.HasColors)
  {
    this->Contents.PointColors.BeginRecord();
    if (!this->AddColors(this->Contents.PointColors, rest - tCoords))
    {
      return false;
    }
  }
  for (std::size_t i = rest - tCoords; i < rest; ++i)
  {
    this->Contents.TCoords.push_back(static_cast<float>(this->Rest[i].Value));
  }
  return true;
}

bool vtkDGGOFFTextParser::ReadFace(vtkIdType face)
{
  long long corners = 0;
  if (!this->FindAnywhere())
  {
    return this->FailEnd("face " + std::to_string(face));
  }
  // "0" and a blank or line end for each corner.
  if (!this->ToInteger(this->TakeToken(), corners) || !this->BeginFace(face, corners, 2))
  {
    return false;
  }
  for (long long k = 0; k < corners; ++k)
  {
    long long vertex = 0;
    if (!this->FindAnywhere())
    {
      return this->FailEnd("the vertices of face " + std::to_string(face));
    }
    if (!this->ToInteger(this->TakeToken(), vertex) || !this->AddCorner(face, vertex))
    {
      return false;
    }
  }
  if (!this->ReadRestOfLine())
  {
    return false;
  }
  this->Contents.FaceColors.BeginRecord();
  switch (this->Rest.size())
  {
    case 0:
    case 1: // the index of a colour in a table that is not in the file
      return true;
    case 3:
    case 4:
      return this->AddColors(this->Contents.FaceColors, this->Rest.size());
    default:
      break;
  }
  std::ostringstream message;
  message << "face " << face << " has " << this->Rest.size()
          << " numbers after its vertices, expected none, 1 (an index of a colour) or 3 or 4 (a "
             "colour)";
  return this->Fail(vtkErrorCode::FileFormatError, message.str());
}

bool vtkDGGOFFTextParser::ReadEnd()
{
  if (!this->FindAnywhere())
  {
    return true;
  }
  const Token token = this->TakeToken();
  return this->Fail(vtkErrorCode::FileFormatError,
    vtkDGGQuote(token.First, token.Last) + " follows the last face: are the counts too small?");
}

std::string vtkDGGOFFTextParser::DescribePlace(std::size_t place) const
{
  return "line " + std::to_string(place);
}
