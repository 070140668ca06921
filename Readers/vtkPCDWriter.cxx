// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPCDWriter.h"

#include "vtkDGGLZF.h"
#include "vtkDGGPCDHeader.h"
#include "vtkDGGPCDText.h"
#include "vtkDGGPointFields.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// Bytes that are kept before they are written.
constexpr std::size_t BlockBytes = std::size_t(1) << 22;

/// Writes one cloud to a stream.
class CloudWriter
{
public:
  CloudWriter(vtkPolyData* data, vtkDGGPCDData mode, const vtkDGGFileProgress& progress)
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
  }

  /// What a file cannot hold, to be seen before one is opened. False when GetError() is not empty.
  bool Check()
  {
    if (this->Header.Fields.size() > vtkDGGPCDHeader::MostFields)
    {
      this->Error = "there would be " + std::to_string(this->Header.Fields.size()) +
        " fields, but a file has " + std::to_string(vtkDGGPCDHeader::MostFields) +
        " at most: remove point arrays";
      return false;
    }
    if (this->Header.Data == vtkDGGPCDData::BinaryCompressed)
    {
      // Compressed data may be longer by one byte in 32.
      constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() / 33 * 32;
      if (static_cast<std::size_t>(this->Count) > most / this->Header.GetPointBytes())
      {
        this->Error = "compressed data cannot be larger than 4 GB: set the data mode to binary";
        return false;
      }
    }
    return true;
  }

  /// What was there is lost. False when it cannot be opened.
  bool Open(const char* name)
  {
    this->Stream.open(name, std::ios::binary);
    return static_cast<bool>(this->Stream);
  }

  /// False when stopped, or when IsBroken().
  bool Write()
  {
    const std::string header = this->Header.Format();
    this->Stream.write(header.data(), static_cast<std::streamsize>(header.size()));
    return this->Header.Data == vtkDGGPCDData::BinaryCompressed ? this->WriteCompressed()
                                                                : this->WriteBlocks();
  }
  /// False when not all has come to the file.
  bool Close()
  {
    this->Stream.close();
    return static_cast<bool>(this->Stream);
  }
  bool IsBroken() const { return !this->Stream; }
  const std::string& GetError() const { return this->Error; }

private:
  bool WriteBlocks()
  {
    const std::size_t step = this->Header.GetPointBytes();
    const auto perBlock = static_cast<vtkIdType>(std::max<std::size_t>(BlockBytes / step, 1));
    std::vector<char> block;
    std::string text;
    for (vtkIdType begin = 0; begin < this->Count; begin += perBlock)
    {
      const vtkIdType end = std::min(begin + perBlock, this->Count);
      block.resize(static_cast<std::size_t>(end - begin) * step);
      this->Fill(begin, end, block.data());
      if (this->Header.Data == vtkDGGPCDData::ASCII)
      {
        this->Format(block, text);
        this->Stream.write(text.data(), static_cast<std::streamsize>(text.size()));
      }
      else
      {
        this->Stream.write(block.data(), static_cast<std::streamsize>(block.size()));
      }
      if (!this->Stream ||
        !this->Progress(static_cast<double>(end) / static_cast<double>(this->Count)))
      {
        return false;
      }
    }
    return true;
  }

  /// The points [begin, end), one after the other.
  void Fill(vtkIdType begin, vtkIdType end, char* out) const
  {
    const std::size_t step = this->Header.GetPointBytes();
    for (const vtkDGG::PointFieldSource& source : this->Sources)
    {
      const vtkDGG::PointField& field = source.GetField();
      source.Copy(begin, end, field.Kind, field.Size, out, step);
      out += field.GetBytes();
    }
  }

  /// Points as lines of text.
  void Format(const std::vector<char>& block, std::string& text) const
  {
    text.clear();
    const char* in = block.data();
    while (in != block.data() + block.size())
    {
      for (const vtkDGG::PointField& field : this->Header.Fields)
      {
        for (int c = 0; c < field.Count; ++c, in += field.Size)
        {
          vtkDGGAppendPCDNumber(in, field.Kind, field.Size, text);
          text += ' ';
        }
      }
      text.back() = '\n';
    }
  }

  /// All of each field, one after the other, as values of a kind are more alike.
  bool WriteCompressed()
  {
    const std::size_t step = this->Header.GetPointBytes();
    const auto count = static_cast<std::size_t>(this->Count);
    std::vector<char> fields(count * step);
    char* out = fields.data();
    for (const vtkDGG::PointFieldSource& source : this->Sources)
    {
      const vtkDGG::PointField& field = source.GetField();
      source.Copy(0, this->Count, field.Kind, field.Size, out, field.GetBytes());
      out += field.GetBytes() * count;
    }
    if (!this->Progress(0.3))
    {
      return false;
    }
    std::vector<char> compressed;
    vtkDGGCompressLZF(fields.data(), fields.size(), compressed);
    this->WriteSize(compressed.size());
    this->WriteSize(fields.size());
    this->Stream.write(compressed.data(), static_cast<std::streamsize>(compressed.size()));
    return static_cast<bool>(this->Stream);
  }

  /// The least significant byte comes first.
  void WriteSize(std::size_t size)
  {
    for (int i = 0; i < 4; ++i, size >>= 8)
    {
      this->Stream.put(static_cast<char>(size & 255));
    }
  }

  const std::vector<vtkDGG::PointFieldSource> Sources;
  const vtkIdType Count;
  std::ofstream Stream;
  const vtkDGGFileProgress& Progress;
  vtkDGGPCDHeader Header;
  std::string Error;
};

/// A part of a file is worse than none. Devices are left alone.
void RemoveFile(const char* name)
{
  std::error_code code;
  if (std::filesystem::is_regular_file(name, code))
  {
    std::filesystem::remove(name, code);
  }
}
}

vtkStandardNewMacro(vtkPCDWriter);

vtkPCDWriter::vtkPCDWriter() = default;

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
  return vtkPolyData::SafeDownCast(this->Superclass::GetInput());
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

void vtkPCDWriter::Fail(unsigned long code, const char* message)
{
  this->SetErrorCode(code);
  vtkErrorMacro("Cannot write " << this->FileName << ": " << message);
}

void vtkPCDWriter::WriteData()
{
  vtkPolyData* input = this->GetInput();
  this->IsWritten = false;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !this->FileName[0])
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("There is no file name: call SetFileName() first.");
    return;
  }
  for (int i = 0; i < input->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = input->GetPointData()->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "(without a name)";
    if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
    {
      std::ostringstream message;
      message << "the point array " << name << " has " << array->GetNumberOfTuples()
              << " values for " << input->GetNumberOfPoints() << " points";
      this->Fail(vtkErrorCode::FileFormatError, message.str().c_str());
      return;
    }
    if (!vtkDataArray::SafeDownCast(array))
    {
      vtkWarningMacro("The array " << name << " is left out: it does not hold numbers.");
    }
  }
  bool isOpened = false;
  try
  {
    const vtkDGGFileProgress progress = [this](double done) {
      this->UpdateProgress(done);
      return this->GetAbortExecute() == 0;
    };
    const auto mode = static_cast<vtkDGGPCDData>(this->DataMode);
    CloudWriter writer(input, mode, progress);
    if (!writer.Check())
    {
      this->Fail(vtkErrorCode::FileFormatError, writer.GetError().c_str());
      return;
    }
    if (!writer.Open(this->FileName))
    {
      this->Fail(vtkErrorCode::CannotOpenFileError, "the file cannot be opened for writing");
      return;
    }
    isOpened = true;
    const bool isWhole = writer.Write();
    const bool isBroken = writer.IsBroken();
    this->IsWritten = writer.Close() && isWhole;
    if (!this->IsWritten && (isBroken || isWhole)) // otherwise aborted
    {
      this->Fail(
        vtkErrorCode::OutOfDiskSpaceError, "the data cannot be written, is the disk full?");
    }
  }
  catch (const std::exception& exception) // out of memory
  {
    this->IsWritten = false;
    this->Fail(vtkErrorCode::UnknownError, exception.what());
  }
  catch (...)
  {
    this->IsWritten = false;
    this->Fail(vtkErrorCode::UnknownError, "unexpected failure");
  }
  if (isOpened && !this->IsWritten)
  {
    RemoveFile(this->FileName);
  }
}

void vtkPCDWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const modes[] = { "ASCII", "Binary", "BinaryCompressed" };
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "DataMode: " << modes[this->DataMode] << "\n";
}
