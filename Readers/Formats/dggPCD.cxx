// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCounted.h"
#include "dggLZF.h"
#include "dggPCDHeader.h"
#include "dggParsers.h"
#include "dggPointCloud.h"
#include "dggWriters.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
using dgg::FileCode;

/// Largest number of values per point in the header of a file without points, independent of the
/// size of the file.
constexpr std::size_t MaximumValuesWithoutPoints = 1000000;

constexpr auto Malformed = FileCode::Malformed;
constexpr auto Premature = FileCode::Premature;

/// Finds the values of all fields in a file, which must stay where it is. Nothing is allocated
/// before the number of points is compared with the size of the file. Throws dgg::FileError.
class PCDParser
{
public:
  PCDParser(std::string_view file, const dgg::ProgressReport& progress)
    : Text(file, {})
    , Progress(progress)
  {
  }

  /// Returns the fields without padding; their values are in the file or in a buffer of this
  /// object.
  const dgg::PointCloudView& Read()
  {
    const std::size_t fileBytes = this->Text.GetRest().size();
    this->Header.Parse(this->Text);
    this->Count = static_cast<std::size_t>(this->Header.GetNumberOfPoints());
    this->PointBytes = this->Header.GetPointBytes();
    static_cast<dgg::CloudLayout&>(this->View) = this->Header.Layout;
    this->SetView(nullptr, false, false);
    const std::string trouble = dgg::CheckPointFields(this->View);
    if (!trouble.empty())
    {
      this->FailAtLine(Malformed, this->Header.FieldsLine, trouble);
    }
    std::size_t numbers = 0;
    for (const dgg::PointField& field : this->Header.Fields)
    {
      numbers += static_cast<std::size_t>(field.Count);
    }
    // Arrays take memory for their components even where there are no points.
    if (this->Count == 0 && numbers > MaximumValuesWithoutPoints && numbers > fileBytes)
    {
      this->FailAtLine(Malformed, this->Header.CountLine, "COUNT declares ", numbers,
        " values per point, more than the file has bytes");
    }
    switch (this->Header.Data)
    {
      case dgg::PCDData::ASCII:
        this->ReadText(numbers);
        break;
      case dgg::PCDData::Binary:
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

  bool IsText() const { return this->Header.Data == dgg::PCDData::ASCII; }

private:
  void ReadText(std::size_t numbers)
  {
    // A number takes at least a digit and a blank; the last blank may be missing.
    this->CheckCount(this->Text.GetBytesLeft() + 1, 2 * numbers);
    this->Buffer.resize(this->Count * this->PointBytes);
    this->SetView(this->Buffer.data(), false, true);
    std::vector<dgg::NumberType> types;
    for (const dgg::PointField& field : this->Header.Fields)
    {
      const bool isPadding = field.Name == dgg::PaddingName;
      types.push_back({ isPadding ? ' ' : field.Kind, static_cast<std::size_t>(field.Size) });
    }
    std::size_t point = 0;
    char* out = this->Buffer.data();
    for (; this->Text.FindAnywhere(); ++point, out += this->PointBytes)
    {
      if (point == this->Count)
      {
        this->FailAtLine(Malformed, this->Text.GetLine(), "data follow the last of ",
          dgg::Counted(point, "point"), ". Increase POINTS, WIDTH or HEIGHT");
      }
      this->ReadPoint(point, types, numbers, out);
      this->Progress.At(point + 1, this->Text.GetFraction());
    }
    if (point != this->Count)
    {
      this->FailAtLine(Premature, this->Text.GetLine(), "the file ends after ", point, " of ",
        dgg::Counted(this->Count, "point"));
    }
  }

  void ReadPoint(
    std::size_t point, const std::vector<dgg::NumberType>& types, std::size_t numbers, char* out)
  {
    std::size_t read = 0;
    for (std::size_t f = 0; f < types.size(); ++f)
    {
      const dgg::PointField& field = this->Header.Fields[f];
      for (int c = 0; c < field.Count; ++c, ++read, out += field.Size)
      {
        if (!this->Text.FindOnLine())
        {
          this->FailAtLine(this->Text.GetBytesLeft() == 0 ? Premature : Malformed,
            this->Text.GetLine(), "point ", point, " has ", dgg::Counted(read, "value"),
            ". Expected ", numbers);
        }
        const std::string_view word = this->Text.TakeWord();
        const char* trouble = nullptr;
        dgg::DispatchNumber(types[f], [&](auto number) {
          trouble = dgg::ParseNumber(word, number);
          std::memcpy(out, &number, sizeof(number));
        });
        if (trouble)
        {
          this->FailAtLine(Malformed, this->Text.GetLine(), "the field ", dgg::Quote(field.Name),
            " of point ", point, ": ", dgg::Quote(word), " ", trouble);
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
      this->CheckRest(0); // PCL writes no sizes if there are no points
      return;
    }
    const std::size_t compressed = ReadSize(body);
    const std::size_t uncompressed = ReadSize(body.substr(4));
    if (compressed > body.size() - 8)
    {
      this->FailAtByte(Premature, 0, compressed, " bytes of compressed data are declared, but ",
        body.size() - 8, " follow");
    }
    // PCL excludes padding from compressed data; other programs may include it.
    std::size_t packed = this->PointBytes;
    for (const dgg::PointField& field : this->Header.Fields)
    {
      packed -= field.Name == dgg::PaddingName ? field.GetBytes() : 0;
    }
    const auto fits = [&](std::size_t bytes) {
      return this->Count <= uncompressed / bytes && uncompressed == this->Count * bytes;
    };
    const bool hasPadding = fits(this->PointBytes);
    if (!hasPadding && !fits(packed))
    {
      this->FailAtByte(Malformed, 0, "the compressed data declare ", uncompressed,
        " bytes, which are not ", dgg::Counted(this->Count, "point"), " of ", packed, " bytes");
    }
    this->Progress(0.1);
    if (uncompressed / dgg::LZFMaximumRatio > compressed)
    {
      this->FailAtByte(
        Malformed, 0, compressed, " bytes of compressed data cannot hold ", uncompressed, " bytes");
    }
    this->Buffer.resize(uncompressed);
    if (!dgg::DecompressLZF(body.data() + 8, compressed, this->Buffer.data(), this->Buffer.size()))
    {
      this->FailAtByte(Malformed, 8, "the compressed data are damaged");
    }
    this->SetView(this->Buffer.data(), true, hasPadding);
    this->Progress(0.9);
    this->CheckRest(8 + compressed);
  }

  /// Reads a size, least significant byte first.
  static std::size_t ReadSize(std::string_view bytes)
  {
    std::size_t size = 0;
    for (std::size_t i = 4; i > 0; --i)
    {
      size = size << 8 | static_cast<unsigned char>(bytes[i - 1]);
    }
    return size;
  }

  /// Sets the view to points in memory: point by point with all fields, or (`isByField`) field by
  /// field with all points.
  void SetView(const char* data, bool isByField, bool hasPadding)
  {
    this->View.Fields.clear();
    data = this->Count == 0 ? nullptr : data;
    for (const dgg::PointField& field : this->Header.Fields)
    {
      const bool isPadding = field.Name == dgg::PaddingName;
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
      this->FailAtLine(Premature, this->Header.CountLine, "the header declares ",
        dgg::Counted(this->Count, "point"), " of at least ", leastBytes, " bytes, but only ",
        this->Text.GetBytesLeft(), " bytes follow it");
    }
  }

  /// Throws unless the rest of the file is empty or zero. PCL fills files with zeros up to whole
  /// pages; any other data are an error.
  void CheckRest(std::size_t begin) const
  {
    const std::size_t trouble = this->Text.GetRest().find_first_not_of('\0', begin);
    if (trouble != std::string_view::npos)
    {
      this->FailAtByte(Malformed, trouble, "data follow the last of ",
        dgg::Counted(this->Count, "point"), ". Increase POINTS, WIDTH or HEIGHT");
    }
  }

  template <typename... Parts>
  [[noreturn]] static void FailAtLine(FileCode code, std::size_t line, const Parts&... parts)
  {
    dgg::Fail(code, "line ", line, ": ", parts...);
  }
  /// Throws an error at a byte after the header.
  template <typename... Parts>
  [[noreturn]] void FailAtByte(FileCode code, std::size_t byte, const Parts&... parts) const
  {
    dgg::Fail(code, "byte ", this->Text.GetByte() + byte, ": ", parts...);
  }

  dgg::TextCursor Text; ///< text after the header, except in text files
  const dgg::ProgressReport& Progress;
  dgg::PCDHeader Header;
  std::size_t Count = 0;
  std::size_t PointBytes = 0;
  std::vector<char> Buffer;
  dgg::PointCloudView View;
};

/// Writes one cloud.
class CloudWriter
{
public:
  /// Throws if the cloud exceeds a limit of the format.
  CloudWriter(dgg::MeshData& mesh, dgg::PCDData mode, const dgg::ProgressReport& progress)
    : Count(mesh.GetNumberOfPoints())
    , Sources(dgg::ListFields(std::move(mesh), true))
    , Progress(progress)
  {
    this->Header.Layout.Width = static_cast<std::int64_t>(this->Count);
    this->Header.Layout =
      mesh.Layout.value_or(this->Header.Layout); // ListFields() moves arrays only
    this->Header.Data = mode;
    for (const dgg::FieldSource& source : this->Sources)
    {
      dgg::PointField field = source.GetField();
      if (field.Name == "rgb" && field.GetBytes() == 4)
      {
        field.Kind = 'U'; // as PCL does in files: as floats, opaque colors are NaN
      }
      this->Header.Fields.push_back(field);
    }
    this->PointBytes = this->Header.GetPointBytes();
    if (this->Header.Fields.size() > dgg::PCDHeader::MaximumFields)
    {
      dgg::Fail(Malformed, "the file would have ", this->Header.Fields.size(),
        " fields, more than ", dgg::PCDHeader::MaximumFields, ". Remove point arrays");
    }
    // Compressed data may be longer by one byte in 32.
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / 33 * 32;
    if (mode == dgg::PCDData::BinaryCompressed && this->Count > most / this->PointBytes)
    {
      dgg::Fail(Malformed, "the compressed data exceed 4 GB. Set the data mode to binary");
    }
  }

  void Write(dgg::FileSink& sink) const
  {
    sink.Put(this->Header.Format());
    if (this->Header.Data == dgg::PCDData::BinaryCompressed)
    {
      this->WriteCompressed(sink);
    }
    else
    {
      this->WriteBlocks(sink);
    }
  }

private:
  void WriteBlocks(dgg::FileSink& sink) const
  {
    const std::size_t perBlock =
      std::max<std::size_t>(dgg::FileSink::BlockBytes / this->PointBytes, 1);
    std::vector<char> block;
    for (std::size_t begin = 0; begin < this->Count; begin += perBlock)
    {
      const std::size_t end = std::min(begin + perBlock, this->Count);
      block.resize((end - begin) * this->PointBytes);
      char* out = block.data();
      for (const dgg::FieldSource& source : this->Sources)
      {
        const dgg::PointField& field = source.GetField();
        source.Copy(begin, end, field.Kind, field.Size, out, this->PointBytes);
        out += field.GetBytes();
      }
      if (this->Header.Data == dgg::PCDData::ASCII)
      {
        this->PutText(block, sink);
      }
      else
      {
        sink.Put({ block.data(), block.size() });
      }
      this->Progress(static_cast<double>(end) / static_cast<double>(this->Count));
    }
  }

  /// Writes a line per point.
  void PutText(const std::vector<char>& block, dgg::FileSink& sink) const
  {
    const char* in = block.data();
    while (in != block.data() + block.size())
    {
      const char* blank = "";
      for (const dgg::PointField& field : this->Header.Fields)
      {
        dgg::DispatchNumber({ field.Kind, static_cast<std::size_t>(field.Size) }, [&](auto number) {
          for (int c = 0; c < field.Count; ++c, in += field.Size, blank = " ")
          {
            std::memcpy(&number, in, sizeof(number));
            sink.PutNumber(number, blank);
          }
        });
      }
      sink.Put("\n");
    }
  }

  /// Writes all values of each field, one field after the other, because the values of one field
  /// are similar and compress better.
  void WriteCompressed(dgg::FileSink& sink) const
  {
    std::vector<char> fields(this->Count * this->PointBytes);
    char* out = fields.data();
    for (const dgg::FieldSource& source : this->Sources)
    {
      const dgg::PointField& field = source.GetField();
      source.Copy(0, this->Count, field.Kind, field.Size, out, field.GetBytes());
      out += field.GetBytes() * this->Count;
    }
    this->Progress(0.3);
    std::vector<char> compressed;
    dgg::CompressLZF(fields.data(), fields.size(), compressed);
    sink.PutBytes(static_cast<std::uint32_t>(compressed.size()));
    sink.PutBytes(static_cast<std::uint32_t>(fields.size()));
    sink.Put({ compressed.data(), compressed.size() });
  }

  const std::size_t Count;
  const std::vector<dgg::FieldSource> Sources;
  const dgg::ProgressReport& Progress;
  dgg::PCDHeader Header;
  std::size_t PointBytes = 0;
};
}

void dgg::ParsePCD(std::string_view file, const ProgressReport& progress, MeshData& mesh)
{
  PCDParser parser(file, progress);
  const PointCloudView& view = parser.Read();
  progress(1.0);
  const std::string defect = ToMesh(view, mesh);
  if (!defect.empty())
  {
    Fail(Malformed, defect);
  }
  if (parser.IsText())
  {
    WarnOfOpenLine(file, mesh);
  }
}

void dgg::WritePCD(MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  CloudWriter(mesh, PCDData::Binary, progress).Write(sink);
}

void dgg::WritePCDText(MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  CloudWriter(mesh, PCDData::ASCII, progress).Write(sink);
}

void dgg::WritePCDCompressed(MeshData& mesh, const ProgressReport& progress, FileSink& sink)
{
  CloudWriter(mesh, PCDData::BinaryCompressed, progress).Write(sink);
}
