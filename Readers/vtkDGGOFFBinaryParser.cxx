// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOFFBinaryParser.h"

#include "vtkErrorCode.h"

#include <cctype>
#include <cmath>
#include <cstring>
#include <sstream>

vtkDGGOFFBinaryParser::vtkDGGOFFBinaryParser(const char* begin, const char* end,
  const char* dataBegin, const vtkDGGOFFProgress& progress, vtkDGGOFFContents& contents)
  : vtkDGGOFFParser(begin, end, progress, contents)
{
  this->Cursor = dataBegin;
}

bool vtkDGGOFFBinaryParser::ReadInteger(const std::string& what, std::int32_t& value)
{
  if (this->GetRemaining() < 4)
  {
    return this->FailEnd(what);
  }
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; ++i)
  {
    bits = bits << 8 | static_cast<unsigned char>(*this->Cursor++);
  }
  std::memcpy(&value, &bits, sizeof(value));
  return true;
}

bool vtkDGGOFFBinaryParser::ReadNumber(const std::string& what, float& value)
{
  std::int32_t bits = 0;
  if (!this->ReadInteger(what, bits))
  {
    return false;
  }
  std::memcpy(&value, &bits, sizeof(value));
  if (!std::isfinite(value))
  {
    this->Cursor -= 4; // the place of the error
    return this->Fail(vtkErrorCode::FileFormatError, what + " is not finite");
  }
  return true;
}

bool vtkDGGOFFBinaryParser::ReadNumbers(
  const char* what, vtkIdType record, int count, float* values)
{
  const std::string name = what + std::to_string(record);
  for (int i = 0; i < count; ++i)
  {
    if (!this->ReadNumber(name, values[i]))
    {
      return false;
    }
  }
  return true;
}

bool vtkDGGOFFBinaryParser::ReadCounts(long long& vertices, long long& faces)
{
  std::int32_t v = 0;
  std::int32_t f = 0;
  std::int32_t edges = 0;
  if (!this->ReadInteger("the number of vertices", v) ||
    !this->ReadInteger("the number of faces", f) ||
    !this->ReadInteger("the number of edges", edges))
  {
    return false;
  }
  vertices = v;
  faces = f;
  return true;
}

std::size_t vtkDGGOFFBinaryParser::GetLeastVertexSize() const
{
  const vtkDGGOFFHeader& header = this->Contents.Header;
  return 4 *
    (3 + (header.HasNormals ? 3 : 0) + (header.HasColors ? 4 : 0) + (header.HasTCoords ? 2 : 0));
}

bool vtkDGGOFFBinaryParser::ReadVertex(vtkIdType vertex)
{
  const vtkDGGOFFHeader& header = this->Contents.Header;
  float values[4];
  if (!this->ReadNumbers("a coordinate of vertex ", vertex, 3, values))
  {
    return false;
  }
  this->Contents.Points.insert(this->Contents.Points.end(), values, values + 3);
  if (header.HasNormals)
  {
    if (!this->ReadNumbers("the normal of vertex ", vertex, 3, values))
    {
      return false;
    }
    this->Contents.Normals.insert(this->Contents.Normals.end(), values, values + 3);
  }
  if (header.HasColors)
  {
    if (!this->ReadNumbers("the colour of vertex ", vertex, 4, values))
    {
      return false;
    }
    this->Contents.PointColors.BeginRecord();
    for (int i = 0; i < 4; ++i)
    {
      if (!this->AddColor(this->Contents.PointColors, values[i], true))
      {
        return false;
      }
    }
  }
  if (header.HasTCoords)
  {
    if (!this->ReadNumbers("a texture coordinate of vertex ", vertex, 2, values))
    {
      return false;
    }
    this->Contents.TCoords.insert(this->Contents.TCoords.end(), values, values + 2);
  }
  return true;
}

bool vtkDGGOFFBinaryParser::ReadFace(vtkIdType face)
{
  std::int32_t corners = 0;
  const std::string name = "face " + std::to_string(face);
  if (!this->ReadInteger(name, corners) || !this->BeginFace(face, corners, 4))
  {
    return false;
  }
  for (std::int32_t k = 0; k < corners; ++k)
  {
    std::int32_t vertex = 0;
    if (!this->ReadInteger("the vertices of " + name, vertex) || !this->AddCorner(face, vertex))
    {
      return false;
    }
  }
  std::int32_t components = 0;
  if (!this->ReadInteger("the colour of " + name, components))
  {
    return false;
  }
  if (components != 0 && components != 1 && components != 3 && components != 4)
  {
    std::ostringstream message;
    message << name << " has a colour of " << components
            << " components, expected 0, 1 (an index), 3 or 4";
    return this->Fail(vtkErrorCode::FileFormatError, message.str());
  }
  this->Contents.FaceColors.BeginRecord();
  if (components == 1)
  {
    std::int32_t index = 0; // into a table that is not in the file
    return this->ReadInteger("the colour of " + name, index);
  }
  for (std::int32_t i = 0; i < components; ++i)
  {
    float value = 0.0f;
    if (!this->ReadNumber("the colour of " + name, value) ||
      !this->AddColor(this->Contents.FaceColors, value, true))
    {
      return false;
    }
  }
  return true;
}

bool vtkDGGOFFBinaryParser::ReadEnd()
{
  while (this->Cursor != this->End && std::isspace(static_cast<unsigned char>(*this->Cursor)))
  {
    ++this->Cursor;
  }
  if (this->Cursor == this->End)
  {
    return true;
  }
  std::ostringstream message;
  message << this->GetRemaining() << " bytes follow the last face: are the counts too small?";
  return this->Fail(vtkErrorCode::FileFormatError, message.str());
}

std::string vtkDGGOFFBinaryParser::DescribePlace(std::size_t place) const
{
  return "byte " + std::to_string(place);
}

std::size_t vtkDGGOFFBinaryParser::GetPlace() const
{
  return static_cast<std::size_t>(this->Cursor - this->Begin);
}
