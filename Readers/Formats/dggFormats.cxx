// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFormats.h"

#include "dggMeshChecks.h"
#include "dggParsers.h"
#include "dggWriters.h"

#include <algorithm>
#include <exception>
#include <filesystem>

namespace
{
using dgg::FileCode;

/// Number of leading bytes that LooksLike() inspects; headers may begin with comments
constexpr std::size_t RecognitionBytes = 16384;

struct Format
{
  bool (*LooksLike)(std::string_view begin);
  void (*Parse)(std::string_view file, const dgg::ProgressReport& progress, dgg::MeshData& mesh);
  void (*Write)(dgg::MeshData& mesh, const dgg::ProgressReport& progress, dgg::FileSink& sink);
  bool HasLines;
};
/// Formats in the order of dgg::FileFormat.
constexpr Format Formats[] = { { dgg::LooksLikeOBJ, dgg::ParseOBJ, dgg::WriteOBJ, true },
  { dgg::LooksLikeOFF, dgg::ParseOFF, dgg::WriteOFF, true },
  { dgg::LooksLikePCD, dgg::ParsePCD, dgg::WritePCD, false },
  { dgg::LooksLikePLY, dgg::ParsePLY, dgg::WritePLY, false },
  { dgg::LooksLikeSTL, dgg::ParseSTL, dgg::WriteSTL, false },
  { dgg::LooksLikeXYZ, dgg::ParseXYZ, dgg::WriteXYZ, false },
  { dgg::LooksLikePCD, dgg::ParsePCD, dgg::WritePCDText, false },
  { dgg::LooksLikePCD, dgg::ParsePCD, dgg::WritePCDCompressed, false } };

/// Runs `work` and converts its exceptions to a status.
template <typename Work>
dgg::FileStatus Run(const Work& work)
{
  try
  {
    work();
    return {};
  }
  catch (const dgg::FileError& error)
  {
    return { error.Code, std::string(error.what()) + "." };
  }
  catch (const std::exception&) // std::bad_alloc or std::length_error
  {
    return { FileCode::OutOfMemory, "not enough memory." };
  }
}
}

dgg::FileStatus dgg::ReadMesh(
  FileFormat format, const std::string& fileName, const FileProgress& progress, MeshData& mesh)
{
  mesh = MeshData();
  FileStatus status = Run([&] {
    const std::vector<char> bytes = LoadFile(fileName, SIZE_MAX);
    if (bytes.empty())
    {
      Fail(FileCode::Premature, "line 1: the file is empty");
    }
    Formats[static_cast<int>(format)].Parse(
      { bytes.data(), bytes.size() }, ProgressReport(progress), mesh);
  });
  if (!status.IsOk())
  {
    mesh = MeshData();
  }
  if (status.Kind == FileCode::Premature)
  {
    status.Message += " The file may be truncated. Copy or export it again.";
  }
  return status;
}

dgg::FileStatus dgg::WriteMesh(
  FileFormat format, const std::string& fileName, MeshData& mesh, const FileProgress& progress)
{
  return Run([&] {
    CheckMesh(mesh);
    if (format == FileFormat::PLY)
    {
      WarnOfRounding(mesh);
    }
    if (format == FileFormat::STL)
    {
      TriangulatePolygons(mesh);
    }
    const Format& writer = Formats[static_cast<int>(format)];
    if (mesh.Lines.GetCount() > 0 && !writer.HasLines)
    {
      Fail(FileCode::Malformed,
        "the format cannot store lines. Remove the lines or write an OBJ file");
    }
    FileSink sink(fileName);
    writer.Write(mesh, ProgressReport(progress), sink);
    sink.Close();
  });
}

bool dgg::LooksLike(FileFormat format, const std::string& fileName)
{
  bool looksLike = false;
  const FileStatus status = Run([&] {
    const std::vector<char> bytes = LoadFile(fileName, RecognitionBytes);
    looksLike = Formats[static_cast<int>(format)].LooksLike({ bytes.data(), bytes.size() });
  });
  return status.IsOk() && looksLike;
}

void dgg::WarnOfOpenLine(std::string_view file, MeshData& mesh)
{
  if (file.back() != '\n' && file.back() != '\r')
  {
    mesh.Warnings.emplace_back("The last line has no line end. The file may be truncated.");
  }
}

void dgg::FaceSorter::Add(const std::vector<std::int64_t>& corners)
{
  CellList* const lists[] = { &this->Mesh.Verts, &this->Mesh.Lines, &this->Mesh.Polygons };
  const std::size_t kind = std::min<std::size_t>(corners.size(), 3) - 1;
  CellList& cells = *lists[kind];
  cells.Connectivity.insert(cells.Connectivity.end(), corners.begin(), corners.end());
  cells.EndCell();
  this->Faces[kind].push_back(this->Count++);
}

void dgg::FaceSorter::Sort(DataArray& values) const
{
  if (this->Faces[2].size() == this->Count)
  {
    return;
  }
  const auto components = static_cast<std::size_t>(values.Components);
  std::visit(
    [&](auto& old) {
      std::remove_reference_t<decltype(old)> sorted;
      sorted.reserve(old.size());
      for (const std::vector<std::size_t>& faces : this->Faces)
      {
        for (const std::size_t face : faces)
        {
          const auto first = old.begin() + static_cast<std::ptrdiff_t>(face * components);
          sorted.insert(sorted.end(), first, first + values.Components);
        }
      }
      old = std::move(sorted);
    },
    values.Values);
}

dgg::FileSink::FileSink(const std::string& fileName)
  : FileName(fileName)
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path target = fs::canonical(fileName, ignored); // follows links
  this->FileName = target.empty() ? this->FileName : target;
  const bool isReplaceable = target.empty() || fs::is_regular_file(target, ignored);
  this->PartName = this->FileName;
  this->PartName += isReplaceable ? ".part" : ""; // not for devices and pipes
  this->Stream.open(this->PartName, std::ios::binary);
  if (!this->Stream)
  {
    Fail(FileCode::CannotOpen, "the file cannot be opened for writing");
  }
}

dgg::FileSink::~FileSink()
{
  if (this->PartName != this->FileName && !this->IsClosed)
  {
    std::error_code ignored;
    this->Stream.close();
    std::filesystem::remove(this->PartName, ignored);
  }
}

void dgg::RequirePoints(const MeshData& mesh)
{
  if (mesh.Points.empty())
  {
    Fail(FileCode::Malformed, "the input has no points");
  }
}

void dgg::FileSink::Flush()
{
  this->Stream.write(this->Buffer.data(), static_cast<std::streamsize>(this->Buffer.size()));
  this->Buffer.clear();
  if (!this->Stream)
  {
    Fail(FileCode::DiskFull, "the data cannot be written. Check that the disk has enough space");
  }
}

void dgg::FileSink::Close()
{
  this->Flush();
  this->Stream.close();
  std::error_code code;
  if (this->Stream && this->PartName != this->FileName)
  {
    std::filesystem::rename(this->PartName, this->FileName, code);
  }
  if (!this->Stream || code)
  {
    Fail(FileCode::DiskFull, "the data cannot be written. Check that the disk has enough space");
  }
  this->IsClosed = true;
}
