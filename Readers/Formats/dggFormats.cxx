// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFormats.h"

#include "dggParsers.h"
#include "dggWriters.h"

#include <algorithm>
#include <exception>
#include <filesystem>

namespace
{
using dgg::FileCode;

/// Bytes that suffice to recognize a file behind comments.
constexpr std::size_t RecognitionBytes = 16384;

struct Format
{
  bool (*LooksLike)(std::string_view begin);
  void (*Parse)(std::string_view file, const dgg::ProgressReport& progress, dgg::MeshData& mesh);
  void (*Write)(
    const dgg::MeshData& mesh, const dgg::ProgressReport& progress, dgg::FileSink& sink);
};
/// In the order of dgg::FileFormat.
constexpr Format Formats[] = { { dgg::LooksLikeOBJ, dgg::ParseOBJ, dgg::WriteOBJ },
  { dgg::LooksLikeOFF, dgg::ParseOFF, dgg::WriteOFF },
  { dgg::LooksLikePCD, dgg::ParsePCD, dgg::WritePCD },
  { dgg::LooksLikePLY, dgg::ParsePLY, dgg::WritePLY },
  { dgg::LooksLikeSTL, dgg::ParseSTL, dgg::WriteSTL },
  { dgg::LooksLikeXYZ, dgg::ParseXYZ, dgg::WriteXYZ },
  { dgg::LooksLikePCD, dgg::ParsePCD, dgg::WritePCDText },
  { dgg::LooksLikePCD, dgg::ParsePCD, dgg::WritePCDCompressed } };

/// Turns what `work` throws into a status.
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
    return { error.Code, error.what() };
  }
  catch (const std::exception&) // of containers
  {
    return { FileCode::OutOfMemory, "not enough memory" };
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
  return status;
}

dgg::FileStatus dgg::WriteMesh(FileFormat format, const std::string& fileName, const MeshData& mesh,
  const FileProgress& progress)
{
  return Run([&] {
    FileSink sink(fileName);
    Formats[static_cast<int>(format)].Write(mesh, ProgressReport(progress), sink);
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
    mesh.Warnings.emplace_back("The last line has no line end: the file may be truncated.");
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

dgg::FileSink::~FileSink()
{
  std::error_code ignored;
  if (this->IsOpened && !this->IsClosed &&
    std::filesystem::is_regular_file(this->FileName, ignored))
  {
    this->Stream.close();
    std::filesystem::remove(this->FileName, ignored);
  }
}

void dgg::FileSink::Flush()
{
  if (!this->IsOpened)
  {
    this->Stream.open(this->FileName, std::ios::binary);
    this->IsOpened = this->Stream.is_open();
    if (!this->IsOpened)
    {
      Fail(FileCode::CannotOpen, "the file cannot be opened for writing");
    }
  }
  this->Stream.write(this->Buffer.data(), static_cast<std::streamsize>(this->Buffer.size()));
  this->Buffer.clear();
  if (!this->Stream)
  {
    Fail(FileCode::DiskFull, "the data cannot be written, is the disk full?");
  }
}

void dgg::FileSink::Close()
{
  this->Flush();
  this->Stream.close();
  if (!this->Stream)
  {
    Fail(FileCode::DiskFull, "the data cannot be written, is the disk full?");
  }
  this->IsClosed = true;
}
