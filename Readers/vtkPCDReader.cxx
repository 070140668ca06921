// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPCDReader.h"

#include "vtkDGGFileLoader.h"
#include "vtkDGGLZF.h"
#include "vtkDGGPCDHeader.h"
#include "vtkDGGPointFields.h"
#include "vtkDGGPointNumbers.h"

#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace
{
/// Enough of a file to find the fields behind comments.
constexpr std::size_t HeaderRange = 16384;
/// Points of text between two reports of progress.
constexpr vtkIdType ProgressInterval = 1 << 14;
/// In files without points, as many values of a point are believed whatever the size of the file
/// is: these say what fields there would be.
constexpr std::size_t MostNumbersOfNothing = 1000000;

constexpr auto Malformed = vtkErrorCode::FileFormatError;
constexpr auto Premature = vtkErrorCode::PrematureEndOfFileError;

/// Put the number that [first, last) says at `out`. Otherwise returns false, and `trouble`
/// completes
/// "'text' ...".
bool ParseValue(const char* first, const char* last, const vtkDGG::PointField& field, char* out,
  const char*& trouble)
{
  vtkDGG::NumberText text = vtkDGG::NumberText::Malformed;
  vtkDGGDispatchNumber(field.Kind, field.Size, [&](auto number) {
    text = vtkDGG::ParseNumber(first, last, number);
    std::memcpy(out, &number, sizeof(number));
  });
  trouble = text == vtkDGG::NumberText::OutOfRange ? "is out of the range of the field"
    : field.Kind == 'F'                            ? "is not a number"
                                                   : "is not an integer";
  return text == vtkDGG::NumberText::Valid;
}

/// Finds the values of all fields in a file, which must stay where it is. Nothing is allocated
/// before the number of points is compared with the size of the file. Throws vtkDGG::FileError.
class Body
{
public:
  Body(const std::vector<char>& bytes, const vtkDGG::FileProgress& progress)
    : File(bytes.data())
    , End(bytes.data() + bytes.size())
    , Progress(progress)
  {
    this->Header.Parse(this->File, this->End);
    this->Begin = this->File + this->Header.BodyBegin;
    this->Left = static_cast<std::size_t>(this->End - this->Begin);
    this->Count = static_cast<std::size_t>(this->Header.GetNumberOfPoints());
    this->PointBytes = this->Header.GetPointBytes();
    this->View.Width = this->Header.Width;
    this->View.Height = this->Header.Height;
    this->View.Sensor = this->Header.Sensor;
  }

  /// Where the values are: in the file, or in a buffer of this object. Without padding.
  const vtkDGG::PointCloudView& Read()
  {
    // Arrays take memory for their components even where there are no points.
    const std::size_t numbers = this->Header.GetPointNumbers();
    if (this->Count == 0 && numbers > MostNumbersOfNothing &&
      numbers > static_cast<std::size_t>(this->End - this->File))
    {
      vtkDGGFailAtLine(Malformed, this->Header.CountLine,
        "the COUNTs promise points of " + std::to_string(numbers) +
          " values, more than the file has bytes");
    }
    switch (this->Header.Data)
    {
      case vtkDGGPCDData::ASCII:
        this->ReadText(numbers);
        break;
      case vtkDGGPCDData::Binary:
        this->CheckCount(this->Left, this->PointBytes);
        this->SetView(this->Begin, false, true);
        this->Progress(0.5);
        this->CheckRest(this->Begin + this->Count * this->PointBytes);
        break;
      default:
        this->ReadCompressed();
        break;
    }
    return this->View;
  }

private:
  void ReadText(std::size_t numbers)
  {
    // The least that a number takes is a digit and a blank or line end, which the last one may
    // lack.
    this->CheckCount(this->Left + 1, 2 * numbers);
    this->Buffer.resize(this->Count * this->PointBytes);
    this->SetView(this->Buffer.data(), false, true);
    const auto count = static_cast<vtkIdType>(this->Count);
    std::size_t line = this->Header.BodyLine;
    vtkIdType point = 0;
    for (const char* cursor = this->Begin; cursor != this->End; ++line)
    {
      cursor = std::find_if_not(cursor, this->End, vtkDGG::IsBlank);
      if (cursor == this->End || *cursor == '\n')
      {
        cursor += cursor != this->End;
        continue;
      }
      if (point == count)
      {
        vtkDGGFailAtLine(Malformed, line,
          "more follows the last of " + std::to_string(point) +
            " points: is their number too small?");
      }
      this->ReadLine(cursor, line, point, numbers);
      ++point;
      if (point % ProgressInterval == 0)
      {
        this->Progress(static_cast<double>(cursor - this->Begin) / static_cast<double>(this->Left));
      }
    }
    if (point != count)
    {
      vtkDGGFailAtLine(Premature, line,
        "the file ends after " + std::to_string(point) + " of " + std::to_string(count) +
          " points");
    }
  }

  void ReadLine(const char*& cursor, std::size_t line, vtkIdType point, std::size_t numbers)
  {
    const char* const last = std::find(cursor, this->End, '\n');
    char* out = this->Buffer.data() + static_cast<std::size_t>(point) * this->PointBytes;
    std::size_t read = 0;
    for (const vtkDGG::PointField& field : this->Header.Fields)
    {
      const bool isPadding = field.Name == vtkDGGPaddingName;
      for (int c = 0; c < field.Count; ++c, ++read, out += field.Size)
      {
        const char* const first = std::find_if_not(cursor, last, vtkDGG::IsBlank);
        cursor = std::find_if(first, last, vtkDGG::IsBlank);
        if (first == cursor)
        {
          vtkDGGFailAtLine(last == this->End ? Premature : Malformed, line,
            "point " + std::to_string(point) + " has " + std::to_string(read) +
              " values, expected " + std::to_string(numbers));
        }
        const char* trouble = nullptr;
        if (!isPadding && !ParseValue(first, cursor, field, out, trouble))
        {
          vtkDGGFailAtLine(Malformed, line,
            "the field " + vtkDGG::Quote(field.Name) + " of point " + std::to_string(point) + ": " +
              vtkDGG::Quote(first, cursor) + " " + trouble);
        }
      }
    }
    cursor = std::find_if_not(cursor, last, vtkDGG::IsBlank);
    if (cursor != last)
    {
      vtkDGGFailAtLine(Malformed, line,
        "point " + std::to_string(point) + " has more than " + std::to_string(numbers) + " values");
    }
    cursor += last != this->End;
  }

  void ReadCompressed()
  {
    if (this->Left < 8)
    {
      if (this->Count > 0)
      {
        this->FailAtByte(
          Premature, this->End, "the file ends before the sizes of the compressed data");
      }
      // PCL writes no sizes when there is nothing.
      this->SetView(this->Begin, true, false);
      this->CheckRest(this->Begin);
      return;
    }
    const std::size_t compressed = ReadSize(this->Begin);
    const std::size_t uncompressed = ReadSize(this->Begin + 4);
    if (compressed > this->Left - 8)
    {
      this->FailAtByte(Premature, this->Begin,
        std::to_string(compressed) + " bytes of compressed data are promised, but " +
          std::to_string(this->Left - 8) + " follow");
    }
    // Padding is not compressed, as PCL does it; other programs may know better.
    std::size_t padding = 0;
    for (const vtkDGG::PointField& field : this->Header.Fields)
    {
      padding += field.Name == vtkDGGPaddingName ? field.GetBytes() : 0;
    }
    const auto fits = [&](std::size_t bytes) {
      return this->Count == 0
        ? uncompressed == 0
        : uncompressed % this->Count == 0 && uncompressed / this->Count == bytes;
    };
    const bool hasPadding = padding > 0 && fits(this->PointBytes);
    if (!hasPadding && !fits(this->PointBytes - padding))
    {
      this->FailAtByte(Malformed, this->Begin,
        "the compressed data promise " + std::to_string(uncompressed) + " bytes, which are not " +
          std::to_string(this->Count) + " points of " + std::to_string(this->PointBytes - padding) +
          " bytes");
    }
    this->Progress(0.1);
    if (uncompressed / vtkDGGLZFMaximumRatio > compressed)
    {
      this->FailAtByte(Malformed, this->Begin,
        std::to_string(compressed) + " bytes of compressed data cannot hold " +
          std::to_string(uncompressed) + " bytes");
    }
    this->Buffer.resize(uncompressed);
    if (!vtkDGGDecompressLZF(this->Begin + 8, compressed, this->Buffer.data(), this->Buffer.size()))
    {
      this->FailAtByte(Malformed, this->Begin + 8, "the compressed data are damaged");
    }
    this->SetView(this->Buffer.data(), true, hasPadding);
    this->Progress(0.9);
    this->CheckRest(this->Begin + 8 + compressed);
  }

  /// The least significant byte comes first.
  static std::uint32_t ReadSize(const char* bytes)
  {
    std::uint32_t size = 0;
    for (int i = 3; i >= 0; --i)
    {
      size = size << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return size;
  }

  /// Points one after the other, each with all of its fields, or (`isByField`) fields one after the
  /// other, each of all points.
  void SetView(const char* data, bool isByField, bool hasPadding)
  {
    data = this->Count == 0 ? nullptr : data;
    for (const vtkDGG::PointField& field : this->Header.Fields)
    {
      const bool isPadding = field.Name == vtkDGGPaddingName;
      if (!isPadding)
      {
        this->View.Fields.push_back(
          { field, data, isByField ? field.GetBytes() : this->PointBytes });
      }
      if (data && (!isPadding || hasPadding))
      {
        data += isByField ? field.GetBytes() * this->Count : field.GetBytes();
      }
    }
  }

  void CheckCount(std::size_t room, std::size_t leastBytes) const
  {
    if (this->Count > room / leastBytes)
    {
      vtkDGGFailAtLine(Premature, this->Header.CountLine,
        std::to_string(this->Count) + " points of at least " + std::to_string(leastBytes) +
          " bytes are promised, but only " + std::to_string(this->Left) +
          " bytes follow the header");
    }
  }

  /// PCL fills files up to whole pages with zeros; anything else is data that nobody expects.
  void CheckRest(const char* rest) const
  {
    const char* const trouble = std::find_if(rest, this->End, [](char c) { return c != 0; });
    if (trouble != this->End)
    {
      this->FailAtByte(Malformed, trouble,
        "more follows the last of " + std::to_string(this->Count) +
          " points: is their number too small?");
    }
  }

  [[noreturn]] void FailAtByte(
    unsigned long code, const char* place, const std::string& message) const
  {
    throw vtkDGG::FileError(code, "byte " + std::to_string(place - this->File) + ": " + message);
  }

  const char* const File;
  const char* const End;
  const vtkDGG::FileProgress& Progress;
  vtkDGGPCDHeader Header;
  const char* Begin = nullptr;
  std::size_t Left = 0; ///< bytes after the header
  std::size_t Count = 0;
  std::size_t PointBytes = 0;
  std::vector<char> Buffer;
  vtkDGG::PointCloudView View;
};
}

vtkStandardNewMacro(vtkPCDReader);

vtkPCDReader::vtkPCDReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkPCDReader::~vtkPCDReader()
{
  this->SetFileName(nullptr);
}

int vtkPCDReader::CanReadFile(const char* fileName)
{
  try
  {
    const std::vector<char> bytes = vtkDGG::LoadFile(fileName ? fileName : "", HeaderRange);
    return vtkDGGLooksLikePCD(bytes.data(), bytes.data() + bytes.size()) ? 1 : 0;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

int vtkPCDReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const auto read = [](const std::vector<char>& bytes, const vtkDGG::FileProgress& progress,
                      vtkPolyData* output) {
    Body body(bytes, progress);
    const vtkDGG::PointCloudView& view = body.Read();
    progress(1.0);
    std::string trouble;
    const vtkSmartPointer<vtkPolyData> cloud = vtkDGG::MakePolyData(view, trouble);
    if (!cloud)
    {
      throw vtkDGG::FileError(Malformed, trouble);
    }
    output->ShallowCopy(cloud);
  };
  unsigned long code = 0;
  const int result = vtkDGG::ReadFile(this, this->FileName, outputVector, read, code);
  this->SetErrorCode(code);
  return result;
}

void vtkPCDReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
