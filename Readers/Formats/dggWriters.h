// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One writer per format. Writers throw dgg::FileError and may move arrays out of the mesh.
#ifndef dggWriters_h
#define dggWriters_h

#include "dggFileText.h"    // for errors and progress
#include "dggNumberTypes.h" // for values

#include <cstring>     // for std::memcpy
#include <filesystem>  // for names of files
#include <fstream>     // for the file
#include <string>      // for the buffer
#include <string_view> // for text

namespace dgg
{
/// Collects text and bytes, and writes them in large blocks to a file <name>.part. An older file is
/// replaced by Close().
class FileSink
{
public:
  static constexpr std::size_t BlockBytes = std::size_t(1) << 22;

  explicit FileSink(const std::string& fileName);
  /// Removes an unfinished file.
  ~FileSink();
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;

  void Put(std::string_view text)
  {
    this->Buffer += text;
    if (this->Buffer.size() > BlockBytes)
    {
      this->Flush();
    }
  }
  /// Appends `separator` and the shortest text that reads back as the same number.
  template <typename Number>
  void PutNumber(Number number, std::string_view separator = " ")
  {
    this->Put(separator);
    char buffer[64];
    const bool isNaN = number != number; // some programs do not read -nan
    const char* const end =
      isNaN ? buffer : std::to_chars(buffer, buffer + sizeof(buffer), number).ptr;
    this->Put(isNaN ? "nan" : std::string_view(buffer, static_cast<std::size_t>(end - buffer)));
  }
  /// Writes the numbers of an array for one point or cell.
  void PutNumbers(const DataArray& array, std::size_t i)
  {
    const auto components = static_cast<std::size_t>(array.Components);
    std::visit(
      [&](const auto& values) {
        for (std::size_t c = 0; c < components; ++c)
        {
          this->PutNumber(values[i * components + c]);
        }
      },
      array.Values);
  }
  /// Writes the bytes of a number, least significant first.
  template <typename Number>
  void PutBytes(Number number)
  {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    this->Put({ bytes, sizeof(Number) });
  }
  /// Finishes the file.
  void Close();

private:
  void Flush();

  std::filesystem::path FileName;
  std::filesystem::path PartName; ///< equal to FileName for devices and pipes
  std::string Buffer;
  std::ofstream Stream;
  bool IsClosed = false;
};

/// Throws if there are no points, because the format has no empty files.
void RequirePoints(const MeshData& mesh);

void WriteOBJ(MeshData& mesh, const ProgressReport& progress, FileSink& sink);
void WriteOFF(MeshData& mesh, const ProgressReport& progress, FileSink& sink);
void WritePCD(MeshData& mesh, const ProgressReport& progress, FileSink& sink);
void WritePCDText(MeshData& mesh, const ProgressReport& progress, FileSink& sink);
void WritePCDCompressed(MeshData& mesh, const ProgressReport& progress, FileSink& sink);
void WritePLY(MeshData& mesh, const ProgressReport& progress, FileSink& sink);
void WriteSTL(MeshData& mesh, const ProgressReport& progress, FileSink& sink);
void WriteXYZ(MeshData& mesh, const ProgressReport& progress, FileSink& sink);
}

#endif
