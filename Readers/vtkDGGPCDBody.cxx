// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPCDBody.h"

#include "vtkDGGLZF.h"
#include "vtkDGGPCDText.h"
#include "vtkDGGPointNumbers.h"

#include "vtkErrorCode.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace
{
constexpr vtkIdType ProgressInterval = 1 << 14;
/// In files without points, as many values of a point are believed whatever the size of the file
/// is: these tell what fields there would be.
constexpr std::size_t MostNumbersOfNothing = 1000000;

bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// The least significant byte comes first.
std::uint32_t ReadSize(const char* bytes)
{
  std::uint32_t size = 0;
  for (int i = 3; i >= 0; --i)
  {
    size = size << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return size;
}
}

vtkDGGPCDBody::vtkDGGPCDBody(const char* begin, const char* end, const vtkDGGPCDHeader& header,
  const vtkDGGFileProgress& progress)
  : Begin(begin)
  , Body(begin + header.BodyBegin)
  , End(end)
  , Header(header)
  , Progress(progress)
{
}

bool vtkDGGPCDBody::Read()
{
  this->View.Width = this->Header.Width;
  this->View.Height = this->Header.Height;
  this->View.Sensor = this->Header.Sensor;
  // Arrays take memory for their components even where there are no points.
  const std::size_t numbers = this->Header.GetPointNumbers();
  if (this->Header.GetNumberOfPoints() == 0 && numbers > MostNumbersOfNothing &&
    numbers > static_cast<std::size_t>(this->End - this->Begin))
  {
    return this->FailAtLine(vtkErrorCode::FileFormatError, this->Header.CountLine,
      "the COUNTs promise points of " + std::to_string(numbers) +
        " values, more than the file has bytes");
  }
  switch (this->Header.Data)
  {
    case vtkDGGPCDData::ASCII:
      return this->ReadText();
    case vtkDGGPCDData::Binary:
      return this->ReadBinary();
    default:
      return this->ReadCompressed();
  }
}

bool vtkDGGPCDBody::ReadText()
{
  // The least that a number takes is a digit and a blank or line end, which the last one may lack.
  const auto count = static_cast<std::size_t>(this->Header.GetNumberOfPoints());
  const std::size_t least = 2 * this->Header.GetPointNumbers();
  if (count > (static_cast<std::size_t>(this->End - this->Body) + 1) / least)
  {
    return this->FailCount(std::to_string(least));
  }
  this->Buffer.resize(count * this->Header.GetPointBytes());
  this->SetView(this->Buffer.data(), false, true);

  const char* cursor = this->Body;
  std::size_t line = this->Header.BodyLine;
  vtkIdType point = 0;
  for (; cursor != this->End; ++line)
  {
    cursor = std::find_if_not(cursor, this->End, IsBlank);
    if (cursor == this->End || *cursor == '\n')
    {
      cursor += cursor != this->End;
      continue;
    }
    if (point == this->Header.GetNumberOfPoints())
    {
      return this->FailAtLine(vtkErrorCode::FileFormatError, line,
        "more follows the last of " + std::to_string(point) +
          " points: is their number too small?");
    }
    if (!this->ReadLine(cursor, line, point))
    {
      return false;
    }
    ++point;
    if (point % ProgressInterval == 0 &&
      !this->Tell(
        static_cast<double>(cursor - this->Body) / static_cast<double>(this->End - this->Body)))
    {
      return false;
    }
  }
  return point == this->Header.GetNumberOfPoints() ||
    this->FailAtLine(vtkErrorCode::PrematureEndOfFileError, line,
      "the file ends after " + std::to_string(point) + " of " +
        std::to_string(this->Header.GetNumberOfPoints()) + " points");
}

bool vtkDGGPCDBody::ReadLine(const char*& cursor, std::size_t line, vtkIdType point)
{
  const char* const last = std::find(cursor, this->End, '\n');
  char* out = this->Buffer.data() + static_cast<std::size_t>(point) * this->Header.GetPointBytes();
  std::size_t read = 0;
  for (const vtkDGG::PointField& field : this->Header.Fields)
  {
    for (int c = 0; c < field.Count; ++c, ++read, out += field.Size)
    {
      const char* const first = std::find_if_not(cursor, last, IsBlank);
      cursor = std::find_if(first, last, IsBlank);
      if (first == cursor)
      {
        return this->FailAtLine(
          last == this->End ? vtkErrorCode::PrematureEndOfFileError : vtkErrorCode::FileFormatError,
          line,
          "point " + std::to_string(point) + " has " + std::to_string(read) + " values, expected " +
            std::to_string(this->Header.GetPointNumbers()));
      }
      std::string trouble;
      if (field.Name != vtkDGGPaddingName &&
        !vtkDGGParsePCDNumber(first, cursor, field.Kind, field.Size, out, trouble))
      {
        return this->FailAtLine(vtkErrorCode::FileFormatError, line,
          "the field " + vtkDGGQuote(field.Name) + " of point " + std::to_string(point) + ": " +
            vtkDGGQuote(first, cursor) + " " + trouble);
      }
    }
  }
  cursor = std::find_if_not(cursor, last, IsBlank);
  if (cursor != last)
  {
    return this->FailAtLine(vtkErrorCode::FileFormatError, line,
      "point " + std::to_string(point) + " has more than " +
        std::to_string(this->Header.GetPointNumbers()) + " values");
  }
  cursor += last != this->End;
  return true;
}

bool vtkDGGPCDBody::ReadBinary()
{
  const auto count = static_cast<std::size_t>(this->Header.GetNumberOfPoints());
  const std::size_t bytes = this->Header.GetPointBytes();
  if (count > static_cast<std::size_t>(this->End - this->Body) / bytes)
  {
    return this->FailCount(std::to_string(bytes));
  }
  this->SetView(this->Body, false, true);
  return this->Tell(0.5) && this->CheckRest(this->Body + count * bytes) && this->Tell(1.0);
}

bool vtkDGGPCDBody::ReadCompressed()
{
  const auto left = static_cast<std::size_t>(this->End - this->Body);
  const auto count = static_cast<std::size_t>(this->Header.GetNumberOfPoints());
  if (left < 8 && count > 0)
  {
    return this->FailAtByte(vtkErrorCode::PrematureEndOfFileError, this->End,
      "the file ends before the sizes of the compressed data");
  }
  if (left < 8)
  {
    // PCL writes no sizes when there is nothing.
    this->SetView(this->Body, true, false);
    return this->CheckRest(this->Body);
  }
  const std::size_t compressed = ReadSize(this->Body);
  const std::size_t uncompressed = ReadSize(this->Body + 4);
  if (compressed > left - 8)
  {
    return this->FailAtByte(vtkErrorCode::PrematureEndOfFileError, this->Body,
      std::to_string(compressed) + " bytes of compressed data are promised, but " +
        std::to_string(left - 8) + " follow");
  }
  // Padding is not compressed, as PCL does it; other programs may know better.
  std::size_t padding = 0;
  for (const vtkDGG::PointField& field : this->Header.Fields)
  {
    padding += field.Name == vtkDGGPaddingName ? field.GetBytes() : 0;
  }
  const std::size_t whole = this->Header.GetPointBytes();
  const auto fits = [uncompressed, count](std::size_t bytes) {
    return count == 0 ? uncompressed == 0
                      : uncompressed % count == 0 && uncompressed / count == bytes;
  };
  const bool hasPadding = padding > 0 && fits(whole);
  if (!hasPadding && !fits(whole - padding))
  {
    return this->FailAtByte(vtkErrorCode::FileFormatError, this->Body,
      "the compressed data promise " + std::to_string(uncompressed) + " bytes, which are not " +
        std::to_string(count) + " points of " + std::to_string(whole - padding) + " bytes");
  }
  if (!this->Tell(0.1) || !this->Decompress(compressed, uncompressed))
  {
    return false;
  }
  this->SetView(this->Buffer.data(), true, hasPadding);
  return this->Tell(0.9) && this->CheckRest(this->Body + 8 + compressed) && this->Tell(1.0);
}

/// False when the caller has asked to stop.
bool vtkDGGPCDBody::Tell(double done) const
{
  return !this->Progress || this->Progress(done);
}

bool vtkDGGPCDBody::Decompress(std::size_t compressed, std::size_t uncompressed)
{
  if (uncompressed / vtkDGGLZFMaximumRatio > compressed)
  {
    return this->FailAtByte(vtkErrorCode::FileFormatError, this->Body,
      std::to_string(compressed) + " bytes of compressed data cannot hold " +
        std::to_string(uncompressed) + " bytes");
  }
  this->Buffer.resize(uncompressed);
  return vtkDGGDecompressLZF(
           this->Body + 8, compressed, this->Buffer.data(), this->Buffer.size()) ||
    this->FailAtByte(
      vtkErrorCode::FileFormatError, this->Body + 8, "the compressed data are damaged");
}

void vtkDGGPCDBody::SetView(const char* data, bool isByField, bool hasPadding)
{
  const std::size_t pointBytes = this->Header.GetPointBytes();
  const auto count = static_cast<std::size_t>(this->Header.GetNumberOfPoints());
  data = count == 0 ? nullptr : data;
  for (const vtkDGG::PointField& field : this->Header.Fields)
  {
    const bool isPadding = field.Name == vtkDGGPaddingName;
    if (!isPadding)
    {
      this->View.Fields.push_back({ field, data, isByField ? field.GetBytes() : pointBytes });
    }
    if (data && (!isPadding || hasPadding))
    {
      data += isByField ? field.GetBytes() * count : field.GetBytes();
    }
  }
}

/// PCL fills files up to whole pages with zeros; anything else is data that nobody expects.
bool vtkDGGPCDBody::CheckRest(const char* rest)
{
  const char* const trouble = std::find_if(rest, this->End, [](char c) { return c != 0; });
  return trouble == this->End ||
    this->FailAtByte(vtkErrorCode::FileFormatError, trouble,
      "more follows the last of " + std::to_string(this->Header.GetNumberOfPoints()) +
        " points: is their number too small?");
}

bool vtkDGGPCDBody::FailAtLine(unsigned long code, std::size_t line, const std::string& message)
{
  this->Error = { code, "line " + std::to_string(line) + ": " + message };
  return false;
}

bool vtkDGGPCDBody::FailAtByte(unsigned long code, const char* place, const std::string& message)
{
  this->Error = { code, "byte " + std::to_string(place - this->Begin) + ": " + message };
  return false;
}

bool vtkDGGPCDBody::FailCount(const std::string& needed)
{
  return this->FailAtLine(vtkErrorCode::PrematureEndOfFileError, this->Header.CountLine,
    std::to_string(this->Header.GetNumberOfPoints()) + " points of at least " + needed +
      " bytes are promised, but only " + std::to_string(this->End - this->Body) +
      " bytes follow the header");
}
