// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPCDWriter.h"

#include "DGGFileLoader.h"
#include "DGGLZF.h"
#include "DGGPCDHeader.h"
#include "DGGPointNumbers.h"
#include "vtkDGGPointFields.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace
{
/// Bytes that are kept before they are written.
constexpr std::size_t BlockBytes = std::size_t(1) << 22;

constexpr auto Malformed = vtkErrorCode::FileFormatError;

/// Writes one cloud to a stream. Throws vtkDGG::FileError.
class CloudWriter
{
public:
  /// Refuses what a file cannot hold.
  CloudWriter(vtkPolyData* data, DGGPCDData mode, const vtkDGG::FileProgress& progress)
    : Sources(vtkDGG::ListPointFields(data))
    , Count(data->GetNumberOfPoints())
    , Progress(progress)
  {
    vtkDGG::PointCloudView layout;
    vtkDGG::GetPointCloudLayout(data, layout);
    this->Header.Width = layout.Width;
    this->Header.Height = layout.Height;
    this->Header.Sensor = layout.Sensor;
    this->Header.Data = mode;
    for (const vtkDGG::PointFieldSource& source : this->Sources)
    {
      vtkDGG::PointField field = source.GetField();
      if (field.Name == "rgb" && field.GetBytes() == 4)
      {
        field.Kind = 'U'; // as PCL does in files: as floats, opaque colours are NaN
      }
      this->Header.Fields.push_back(field);
    }
    this->PointBytes = this->Header.GetPointBytes();
    if (this->Header.Fields.size() > DGGPCDHeader::MostFields)
    {
      vtkDGG::Fail(Malformed, "there would be ", this->Header.Fields.size(),
        " fields, but a file has ", DGGPCDHeader::MostFields, " at most: remove point arrays");
    }
    // Compressed data may be longer by one byte in 32.
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / 33 * 32;
    if (mode == DGGPCDData::BinaryCompressed &&
      static_cast<std::size_t>(this->Count) > most / this->PointBytes)
    {
      vtkDGG::Fail(
        Malformed, "compressed data cannot be larger than 4 GB: set the data mode to binary");
    }
  }

  void Write(std::ofstream& stream) const
  {
    Put(stream, this->Header.Format());
    if (this->Header.Data == DGGPCDData::BinaryCompressed)
    {
      this->WriteCompressed(stream);
    }
    else
    {
      this->WriteBlocks(stream);
    }
    stream.close();
    CheckStream(stream);
  }

private:
  static void CheckStream(const std::ofstream& stream)
  {
    if (!stream)
    {
      vtkDGG::Fail(
        vtkErrorCode::OutOfDiskSpaceError, "the data cannot be written, is the disk full?");
    }
  }

  template <typename Bytes>
  static void Put(std::ofstream& stream, const Bytes& bytes)
  {
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    CheckStream(stream);
  }

  void WriteBlocks(std::ofstream& stream) const
  {
    const auto perBlock =
      static_cast<vtkIdType>(std::max<std::size_t>(BlockBytes / this->PointBytes, 1));
    std::vector<char> block;
    for (vtkIdType begin = 0; begin < this->Count; begin += perBlock)
    {
      const vtkIdType end = std::min(begin + perBlock, this->Count);
      block.resize(static_cast<std::size_t>(end - begin) * this->PointBytes);
      char* out = block.data();
      for (const vtkDGG::PointFieldSource& source : this->Sources)
      {
        const vtkDGG::PointField& field = source.GetField();
        source.Copy(begin, end, field.Kind, field.Size, out, this->PointBytes);
        out += field.GetBytes();
      }
      if (this->Header.Data == DGGPCDData::ASCII)
      {
        Put(stream, this->Format(block));
      }
      else
      {
        Put(stream, block);
      }
      this->Progress(static_cast<double>(end) / static_cast<double>(this->Count));
    }
  }

  /// Points as lines of text: of each number the shortest text that gives it again.
  std::string Format(const std::vector<char>& block) const
  {
    std::string text;
    char buffer[64];
    const char* in = block.data();
    while (in != block.data() + block.size())
    {
      for (const vtkDGG::PointField& field : this->Header.Fields)
      {
        DGGDispatchNumber(DGGGetArrayType(field.Kind, field.Size), [&](auto number) {
          for (int c = 0; c < field.Count; ++c, in += field.Size)
          {
            std::memcpy(&number, in, sizeof(number));
            if (number != number)
            {
              text += "nan "; // the sign says nothing, and not all programs know "-nan"
              continue;
            }
            text.append(buffer, std::to_chars(buffer, buffer + sizeof(buffer), number).ptr);
            text += ' ';
          }
        });
      }
      text.back() = '\n';
    }
    return text;
  }

  /// All of each field, one after the other, as values of a kind are more alike.
  void WriteCompressed(std::ofstream& stream) const
  {
    const auto count = static_cast<std::size_t>(this->Count);
    std::vector<char> fields(count * this->PointBytes);
    char* out = fields.data();
    for (const vtkDGG::PointFieldSource& source : this->Sources)
    {
      const vtkDGG::PointField& field = source.GetField();
      source.Copy(0, this->Count, field.Kind, field.Size, out, field.GetBytes());
      out += field.GetBytes() * count;
    }
    this->Progress(0.3);
    std::vector<char> compressed;
    DGGCompressLZF(fields.data(), fields.size(), compressed);
    for (std::size_t size : { compressed.size(), fields.size() })
    {
      for (int i = 0; i < 4; ++i, size >>= 8)
      {
        stream.put(static_cast<char>(size & 255)); // the least significant byte first
      }
    }
    Put(stream, compressed);
  }

  const std::vector<vtkDGG::PointFieldSource> Sources;
  const vtkIdType Count;
  const vtkDGG::FileProgress& Progress;
  DGGPCDHeader Header;
  std::size_t PointBytes = 0;
};
}

vtkStandardNewMacro(vtkPCDWriter);

vtkPCDWriter::~vtkPCDWriter()
{
  this->SetFileName(nullptr);
}

int vtkPCDWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

vtkPolyData* vtkPCDWriter::GetInput()
{
  return this->GetInput(0);
}

vtkPolyData* vtkPCDWriter::GetInput(int port)
{
  return vtkPolyData::SafeDownCast(this->Superclass::GetInput(port));
}

int vtkPCDWriter::Write()
{
  this->IsWritten = false;
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Superclass::Write();
  if (!this->IsWritten && this->GetErrorCode() == vtkErrorCode::NoError &&
    this->GetAbortExecute() == 0)
  {
    // The superclass says nothing of a reader or filter before this one that has failed.
    this->SetErrorCode(vtkErrorCode::UnknownError);
  }
  return this->IsWritten ? 1 : 0;
}

void vtkPCDWriter::CheckArrays()
{
  vtkPolyData* input = this->GetInput();
  for (int i = 0; i < input->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = input->GetPointData()->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "(without a name)";
    if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
    {
      vtkDGG::Fail(Malformed, "the point array ", name, " has ", array->GetNumberOfTuples(),
        " values for ", input->GetNumberOfPoints(), " points");
    }
    if (!vtkDataArray::SafeDownCast(array))
    {
      vtkWarningMacro("The array " << name << " is left out: it does not hold numbers.");
    }
  }
}

void vtkPCDWriter::WriteData()
{
  namespace fs = std::filesystem;
  bool isOpened = false;
  const auto work = [&](const vtkDGG::FileProgress& progress) {
    this->CheckArrays();
    const CloudWriter writer(this->GetInput(), static_cast<DGGPCDData>(this->DataMode), progress);
    std::ofstream stream(this->FileName, std::ios::binary);
    isOpened = stream.is_open();
    if (!isOpened)
    {
      vtkDGG::Fail(vtkErrorCode::CannotOpenFileError, "the file cannot be opened for writing");
    }
    writer.Write(stream);
  };
  unsigned long code = vtkErrorCode::NoError;
  this->IsWritten = vtkDGG::RunOnFile(this, "write", this->FileName, work, code);
  this->SetErrorCode(code);
  std::error_code ignored;
  if (!this->IsWritten && isOpened && fs::is_regular_file(this->FileName, ignored))
  {
    fs::remove(this->FileName, ignored); // a part is worse than none; devices are left alone
  }
}

void vtkPCDWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const modes[] = { "ASCII", "Binary", "BinaryCompressed" };
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "DataMode: " << modes[this->DataMode] << "\n";
}
