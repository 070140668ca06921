// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPCDReader.h"

#include "DGGFileLoader.h"
#include "DGGLZF.h"
#include "DGGPCDHeader.h"
#include "DGGPointNumbers.h"
#include "vtkDGGPointFields.h"

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
constexpr std::size_t ProgressInterval = 1 << 14;
/// In files without points, as many values of a point are believed whatever the size of the file
/// is: these say what fields there would be.
constexpr std::size_t MostNumbersOfNothing = 1000000;

constexpr auto Malformed = vtkErrorCode::FileFormatError;
constexpr auto Premature = vtkErrorCode::PrematureEndOfFileError;

/// Finds the values of all fields in a file, which must stay where it is. Nothing is allocated
/// before the number of points is compared with the size of the file. Throws vtkDGG::FileError.
class PCDParser
{
public:
  PCDParser(std::string_view file, const vtkDGG::FileProgress& progress)
    : Text(file, false)
    , Progress(progress)
  {
  }

  /// Where the values are: in the file, or in a buffer of this object. Without padding.
  const vtkDGG::PointCloudView& Read()
  {
    const std::size_t fileBytes = this->Text.GetRest().size();
    this->Header.Parse(this->Text);
    this->Count = static_cast<std::size_t>(this->Header.GetNumberOfPoints());
    this->PointBytes = this->Header.GetPointBytes();
    this->View.Width = this->Header.Width;
    this->View.Height = this->Header.Height;
    this->View.Sensor = this->Header.Sensor;
    this->SetView(nullptr, false, false);
    const std::string trouble = vtkDGG::CheckPointFields(this->View);
    if (!trouble.empty())
    {
      this->FailAtLine(Malformed, this->Header.FieldsLine, trouble);
    }
    std::size_t numbers = 0;
    for (const vtkDGG::PointField& field : this->Header.Fields)
    {
      numbers += static_cast<std::size_t>(field.Count);
    }
    // Arrays take memory for their components even where there are no points.
    if (this->Count == 0 && numbers > MostNumbersOfNothing && numbers > fileBytes)
    {
      this->FailAtLine(Malformed, this->Header.CountLine, "the COUNTs promise points of ", numbers,
        " values, more than the file has bytes");
    }
    switch (this->Header.Data)
    {
      case DGGPCDData::ASCII:
        this->ReadText(numbers);
        break;
      case DGGPCDData::Binary:
        this->CheckCount(this->Text.GetBytesLeft(), this->PointBytes);
        this->SetView(this->Text.GetRest().data(), false, true);
        this->Progress(0.5);
        this->CheckRest(this->Count * this->PointBytes);
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
    this->CheckCount(this->Text.GetBytesLeft() + 1, 2 * numbers);
    const auto whole = static_cast<double>(this->Text.GetByte() + this->Text.GetBytesLeft());
    this->Buffer.resize(this->Count * this->PointBytes);
    this->SetView(this->Buffer.data(), false, true);
    std::vector<int> types;
    for (const vtkDGG::PointField& field : this->Header.Fields)
    {
      const bool isPadding = field.Name == DGGPaddingName;
      types.push_back(isPadding ? VTK_VOID : DGGGetArrayType(field.Kind, field.Size));
    }
    std::size_t point = 0;
    char* out = this->Buffer.data();
    for (; this->Text.FindAnywhere(); ++point, out += this->PointBytes)
    {
      if (point == this->Count)
      {
        this->FailAtLine(Malformed, this->Text.GetLine(), "more follows the last of ", point,
          " points: is their number too small?");
      }
      this->ReadPoint(point, types, numbers, out);
      if ((point + 1) % ProgressInterval == 0)
      {
        this->Progress(static_cast<double>(this->Text.GetByte()) / whole);
      }
    }
    if (point != this->Count)
    {
      this->FailAtLine(Premature, this->Text.GetLine(), "the file ends after ", point, " of ",
        this->Count, " points");
    }
  }

  void ReadPoint(std::size_t point, const std::vector<int>& types, std::size_t numbers, char* out)
  {
    std::size_t read = 0;
    for (std::size_t f = 0; f < types.size(); ++f)
    {
      const vtkDGG::PointField& field = this->Header.Fields[f];
      for (int c = 0; c < field.Count; ++c, ++read, out += field.Size)
      {
        if (!this->Text.FindOnLine())
        {
          this->FailAtLine(this->Text.GetBytesLeft() == 0 ? Premature : Malformed,
            this->Text.GetLine(), "point ", point, " has ", read, " values, expected ", numbers);
        }
        const std::string_view word = this->Text.TakeWord();
        const char* trouble = nullptr;
        DGGDispatchNumber(types[f], [&](auto number) {
          trouble = vtkDGG::ParseNumber(word, number);
          std::memcpy(out, &number, sizeof(number));
        });
        if (trouble)
        {
          this->FailAtLine(Malformed, this->Text.GetLine(), "the field ", vtkDGG::Quote(field.Name),
            " of point ", point, ": ", vtkDGG::Quote(word), " ", trouble);
        }
      }
    }
    if (this->Text.FindOnLine())
    {
      this->FailAtLine(
        Malformed, this->Text.GetLine(), "point ", point, " has more than ", numbers, " values");
    }
  }

  void ReadCompressed()
  {
    const std::string_view body = this->Text.GetRest();
    if (body.size() < 8)
    {
      if (this->Count > 0)
      {
        this->FailAtByte(
          Premature, body.size(), "the file ends before the sizes of the compressed data");
      }
      this->CheckRest(0); // PCL writes no sizes when there is nothing
      return;
    }
    const std::size_t compressed = ReadSize(body);
    const std::size_t uncompressed = ReadSize(body.substr(4));
    if (compressed > body.size() - 8)
    {
      this->FailAtByte(Premature, 0, compressed, " bytes of compressed data are promised, but ",
        body.size() - 8, " follow");
    }
    // Padding is not compressed, as PCL does it; other programs may know better.
    std::size_t packed = this->PointBytes;
    for (const vtkDGG::PointField& field : this->Header.Fields)
    {
      packed -= field.Name == DGGPaddingName ? field.GetBytes() : 0;
    }
    const auto fits = [&](std::size_t bytes) {
      return this->Count <= uncompressed / bytes && uncompressed == this->Count * bytes;
    };
    const bool hasPadding = fits(this->PointBytes);
    if (!hasPadding && !fits(packed))
    {
      this->FailAtByte(Malformed, 0, "the compressed data promise ", uncompressed,
        " bytes, which are not ", this->Count, " points of ", packed, " bytes");
    }
    this->Progress(0.1);
    if (uncompressed / DGGLZFMaximumRatio > compressed)
    {
      this->FailAtByte(
        Malformed, 0, compressed, " bytes of compressed data cannot hold ", uncompressed, " bytes");
    }
    this->Buffer.resize(uncompressed);
    if (!DGGDecompressLZF(body.data() + 8, compressed, this->Buffer.data(), this->Buffer.size()))
    {
      this->FailAtByte(Malformed, 8, "the compressed data are damaged");
    }
    this->SetView(this->Buffer.data(), true, hasPadding);
    this->Progress(0.9);
    this->CheckRest(8 + compressed);
  }

  /// The least significant byte comes first.
  static std::size_t ReadSize(std::string_view bytes)
  {
    std::size_t size = 0;
    for (std::size_t i = 4; i > 0; --i)
    {
      size = size << 8 | static_cast<unsigned char>(bytes[i - 1]);
    }
    return size;
  }

  /// Points one after the other, each with all of its fields, or (`isByField`) fields one after the
  /// other, each of all points.
  void SetView(const char* data, bool isByField, bool hasPadding)
  {
    this->View.Fields.clear();
    data = this->Count == 0 ? nullptr : data;
    for (const vtkDGG::PointField& field : this->Header.Fields)
    {
      const bool isPadding = field.Name == DGGPaddingName;
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
      this->FailAtLine(Premature, this->Header.CountLine, this->Count, " points of at least ",
        leastBytes, " bytes are promised, but only ", this->Text.GetBytesLeft(),
        " bytes follow the header");
    }
  }

  /// PCL fills files up to whole pages with zeros; anything else is data that nobody expects.
  void CheckRest(std::size_t begin) const
  {
    const std::size_t trouble = this->Text.GetRest().find_first_not_of('\0', begin);
    if (trouble != std::string_view::npos)
    {
      this->FailAtByte(Malformed, trouble, "more follows the last of ", this->Count,
        " points: is their number too small?");
    }
  }

  template <typename... Parts>
  [[noreturn]] static void FailAtLine(unsigned long code, std::size_t line, const Parts&... parts)
  {
    vtkDGG::Fail(code, "line ", line, ": ", parts...);
  }
  /// At a byte behind the header.
  template <typename... Parts>
  [[noreturn]] void FailAtByte(unsigned long code, std::size_t byte, const Parts&... parts) const
  {
    vtkDGG::Fail(code, "byte ", this->Text.GetByte() + byte, ": ", parts...);
  }

  vtkDGG::TextCursor Text; ///< behind the header, except in text files
  const vtkDGG::FileProgress& Progress;
  DGGPCDHeader Header;
  std::size_t Count = 0;
  std::size_t PointBytes = 0;
  std::vector<char> Buffer;
  vtkDGG::PointCloudView View;
};
}

vtkStandardNewMacro(vtkPCDReader);

int vtkPCDReader::CanReadFile(const char* fileName)
{
  try
  {
    const std::vector<char> bytes = vtkDGG::LoadFile(fileName ? fileName : "", HeaderRange);
    return DGGLooksLikePCD({ bytes.data(), bytes.size() }) ? 1 : 0;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

int vtkPCDReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const auto read = [](std::string_view file, const vtkDGG::FileProgress& progress,
                      vtkPolyData* output) {
    PCDParser parser(file, progress);
    const vtkDGG::PointCloudView& view = parser.Read();
    progress(1.0);
    std::string trouble;
    const vtkSmartPointer<vtkPolyData> cloud = vtkDGG::MakePolyData(view, trouble);
    if (!cloud)
    {
      vtkDGG::Fail(Malformed, trouble);
    }
    output->ShallowCopy(cloud);
  };
  this->SetErrorCode(vtkDGG::ReadFile(this, this->FileName, outputVector, read));
  return vtkDGG::GoesOn(this->ErrorCode, outputVector) ? 1 : 0;
}
