// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Reads and writes files of meshes and point clouds, without VTK. No function throws.
#ifndef dggFormats_h
#define dggFormats_h

#include "dggMeshData.h"

#include <functional> // for progress
#include <string>     // for names and messages

namespace dgg
{
enum class FileFormat
{
  OBJ,
  OFF,
  PCD, ///< binary when written
  PLY,
  STL,
  XYZ,
  PCDText,      ///< PCD, as text when written
  PCDCompressed ///< PCD, compressed by LZF when written
};

/// Outcome of reading or writing a file.
struct FileStatus
{
  enum class Code
  {
    Ok,
    NotFound,     ///< the file does not exist
    CannotOpen,   ///< the file is not a regular file or cannot be opened
    Unrecognized, ///< the file has another format
    Premature,    ///< the file ends too early
    Malformed,    ///< the contents violate the format
    DiskFull,     ///< the contents cannot be written
    OutOfMemory,
    Aborted ///< the progress callback returned false
  };

  Code Kind = Code::Ok;
  std::string Message; ///< the defect, with its line or byte; without the name of the file

  bool IsOk() const { return this->Kind == Code::Ok; }
};

/// Called with the finished fraction in [0, 1]; returns false to stop.
using FileProgress = std::function<bool(double)>;

/// Reads a file, which may be compressed by gzip. On failure `mesh` is empty.
FileStatus ReadMesh(
  FileFormat format, const std::string& fileName, const FileProgress& progress, MeshData& mesh);

/// Writes a file, which replaces an older one only when it is complete. Data that the format cannot
/// store are skipped or refused; vtkDGGMeshWriter lists them. Cells without points are skipped, and
/// STL files get the triangles of polygons. Fails if a cell or an array does not fit the points.
/// Afterwards only the warnings of the mesh may be used.
FileStatus WriteMesh(
  FileFormat format, const std::string& fileName, MeshData& mesh, const FileProgress& progress);

/// Returns true if the beginning of the file has the given format.
bool LooksLike(FileFormat format, const std::string& fileName);
}

#endif
