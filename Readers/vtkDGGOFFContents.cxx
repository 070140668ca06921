// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOFFContents.h"

#include "vtkErrorCode.h"

#include <limits>
#include <sstream>

namespace
{
/// Colour of faces that have none in a file where others do: geomview's default.
constexpr float DefaultGrey = 170.0f;
/// Records between two calls of the progress callback.
constexpr vtkIdType ProgressInterval = 1 << 16;
}

bool vtkDGGOFFHeader::ParseKeyword(const std::string& keyword)
{
  *this = vtkDGGOFFHeader();
  if (keyword.size() < 3 || keyword.compare(keyword.size() - 3, 3, "OFF") != 0)
  {
    return false;
  }
  const std::string prefix = keyword.substr(0, keyword.size() - 3);
  for (std::size_t i = 0; i < prefix.size(); ++i)
  {
    bool* flag = nullptr;
    switch (prefix[i])
    {
      case 'S':
        flag = i + 1 < prefix.size() && prefix[i + 1] == 'T' ? &this->HasTCoords : nullptr;
        ++i;
        break;
      case 'C':
        flag = &this->HasColors;
        break;
      case 'N':
        flag = &this->HasNormals;
        break;
      case '4':
        flag = &this->IsHomogeneous;
        break;
      case 'n':
        flag = &this->IsAnyDimension;
        break;
      default:
        break;
    }
    if (!flag || *flag)
    {
      return false;
    }
    *flag = true;
  }
  return true;
}

void vtkDGGOFFColors::BeginRecord()
{
  // A negative red marks a record without a colour of its own.
  this->Values.insert(this->Values.end(), { -1.0f, 0.0f, 0.0f, -1.0f });
  this->Components = 0;
}

bool vtkDGGOFFColors::Add(double value, bool isFraction, std::size_t place)
{
  if (!(value >= 0.0 && value <= (isFraction ? 1.0 : 255.0)) || this->Components == 4)
  {
    return false;
  }
  this->SawFraction = this->SawFraction || isFraction;
  if (value > 1.0 && !this->SawAboveOne)
  {
    this->SawAboveOne = true;
    this->PlaceAboveOne = place;
  }
  this->Used = true;
  this->HasAlpha = this->HasAlpha || this->Components == 3;
  this->Values[this->Values.size() - 4 + this->Components++] = static_cast<float>(value);
  return true;
}

bool vtkDGGOFFColors::Finish(std::size_t& place)
{
  place = this->PlaceAboveOne;
  this->Scale = this->SawAboveOne ? 1.0f : 255.0f;
  return !(this->SawFraction && this->SawAboveOne);
}

unsigned char vtkDGGOFFColors::Get(std::size_t i, int c) const
{
  const float* value = this->Values.data() + 4 * i;
  if (c == 3 && value[3] < 0.0f)
  {
    return 255;
  }
  const float scaled = value[0] < 0.0f ? DefaultGrey : value[c] * this->Scale;
  return static_cast<unsigned char>(scaled + 0.5f);
}

vtkDGGOFFParser::vtkDGGOFFParser(const char* begin, const char* end,
  const vtkDGGOFFProgress& progress, vtkDGGOFFContents& contents)
  : Begin(begin)
  , End(end)
  , Cursor(begin)
  , Contents(contents)
  , Progress(progress)
{
}

bool vtkDGGOFFParser::Parse()
{
  long long vertices = 0;
  long long faces = 0;
  if (!this->ReadCounts(vertices, faces) || !this->CheckCounts(vertices, faces))
  {
    return false;
  }
  this->NumberOfVertices = static_cast<vtkIdType>(vertices);
  this->NumberOfFaces = static_cast<vtkIdType>(faces);
  const auto count = static_cast<std::size_t>(vertices);
  this->Contents.Points.reserve(3 * count);
  this->Contents.Normals.reserve(this->Contents.Header.HasNormals ? 3 * count : 0);
  this->Contents.TCoords.reserve(this->Contents.Header.HasTCoords ? 2 * count : 0);
  this->Contents.FaceOffsets.reserve(static_cast<std::size_t>(faces) + 1);
  this->Contents.Connectivity.reserve(3 * static_cast<std::size_t>(faces));
  for (vtkIdType v = 0; v < this->NumberOfVertices; ++v)
  {
    if (!this->ReportProgress(v) || !this->ReadVertex(v))
    {
      return false;
    }
  }
  for (vtkIdType f = 0; f < this->NumberOfFaces; ++f)
  {
    if (!this->ReportProgress(f) || !this->ReadFace(f))
    {
      return false;
    }
  }
  this->Contents.FaceOffsets.push_back(static_cast<vtkIdType>(this->Contents.Connectivity.size()));
  if (!this->ReadEnd())
  {
    return false;
  }
  for (vtkDGGOFFColors* colors : { &this->Contents.PointColors, &this->Contents.FaceColors })
  {
    std::size_t place = 0;
    if (!colors->Finish(place))
    {
      return this->FailAt(place, vtkErrorCode::FileFormatError,
        "a colour component is above 1, but others of the file are fractions of 1");
    }
  }
  return true;
}

bool vtkDGGOFFParser::CheckCounts(long long vertices, long long faces)
{
  std::ostringstream message;
  if (vertices < 0 || faces < 0)
  {
    message << "the counts must not be negative, but are " << vertices << " vertices and " << faces
            << " faces";
    return this->Fail(vtkErrorCode::FileFormatError, message.str());
  }
  // Before anything is allocated. One byte more for a last line that is not ended.
  const auto room = static_cast<unsigned long long>(this->GetRemaining() + 1);
  const auto maximum = static_cast<long long>(std::numeric_limits<vtkIdType>::max() / 4);
  const unsigned long long forVertices = room / this->GetLeastVertexSize();
  const unsigned long long forFaces = room / this->GetLeastFaceSize();
  const auto v = static_cast<unsigned long long>(vertices);
  const auto f = static_cast<unsigned long long>(faces);
  if (vertices > maximum || faces > maximum || v > forVertices || f > forFaces ||
    v * this->GetLeastVertexSize() + f * this->GetLeastFaceSize() > room)
  {
    message << "the file promises " << vertices << " vertices and " << faces << " faces, but only "
            << this->GetRemaining() << " bytes follow";
    return this->Fail(vtkErrorCode::PrematureEndOfFileError, message.str());
  }
  return true;
}

bool vtkDGGOFFParser::ReportProgress(vtkIdType record)
{
  if (record % ProgressInterval != 0 || !this->Progress)
  {
    return true;
  }
  const auto done = static_cast<double>(this->Cursor - this->Begin);
  return this->Progress(done / static_cast<double>(this->End - this->Begin + 1));
}

bool vtkDGGOFFParser::BeginFace(vtkIdType face, long long corners, std::size_t leastCornerSize)
{
  if (corners < 1)
  {
    std::ostringstream message;
    message << "face " << face << " has " << corners << " vertices: at least 1 is needed";
    return this->Fail(vtkErrorCode::FileFormatError, message.str());
  }
  if (static_cast<unsigned long long>(corners) > (this->GetRemaining() + 1) / leastCornerSize)
  {
    std::ostringstream message;
    message << "face " << face << " promises " << corners << " vertices, but only "
            << this->GetRemaining() << " bytes follow";
    return this->Fail(vtkErrorCode::PrematureEndOfFileError, message.str());
  }
  this->Contents.FaceOffsets.push_back(static_cast<vtkIdType>(this->Contents.Connectivity.size()));
  return true;
}

bool vtkDGGOFFParser::AddCorner(vtkIdType face, long long vertex)
{
  if (vertex < 0 || vertex >= this->NumberOfVertices)
  {
    std::ostringstream message;
    message << "face " << face << " names vertex " << vertex << ", but the file has "
            << this->NumberOfVertices << " vertices, numbered from 0";
    return this->Fail(vtkErrorCode::FileFormatError, message.str());
  }
  this->Contents.Connectivity.push_back(static_cast<vtkIdType>(vertex));
  return true;
}

bool vtkDGGOFFParser::AddColor(vtkDGGOFFColors& colors, double value, bool isFraction)
{
  if (colors.Add(value, isFraction, this->GetPlace()))
  {
    return true;
  }
  std::ostringstream message;
  message << "the colour component " << value
          << " is out of range: fractions must be in [0, 1], integers in [0, 255]";
  return this->Fail(vtkErrorCode::FileFormatError, message.str());
}

bool vtkDGGOFFParser::Fail(unsigned long code, const std::string& message)
{
  return this->FailAt(this->GetPlace(), code, message);
}

bool vtkDGGOFFParser::FailAt(std::size_t place, unsigned long code, const std::string& message)
{
  this->Error.Code = code;
  this->Error.Message = this->DescribePlace(place) + ": " + message;
  return false;
}

bool vtkDGGOFFParser::FailEnd(const std::string& what)
{
  return this->Fail(vtkErrorCode::PrematureEndOfFileError, "the file ends before " + what);
}
