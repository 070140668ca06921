// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One parser per format, and a test of its first bytes. Parsers throw dgg::FileError. Nothing is
/// allocated for the counts of a header before these are compared with the size of the file.
#ifndef dggParsers_h
#define dggParsers_h

#include "dggFileText.h" // for errors and progress

#include <cstdint>     // for ids
#include <string_view> // for files
#include <vector>      // for ids

namespace dgg
{
bool LooksLikeOBJ(std::string_view begin);
void ParseOBJ(std::string_view file, const ProgressReport& progress, MeshData& mesh);

bool LooksLikeOFF(std::string_view begin);
void ParseOFF(std::string_view file, const ProgressReport& progress, MeshData& mesh);

bool LooksLikePCD(std::string_view begin);
void ParsePCD(std::string_view file, const ProgressReport& progress, MeshData& mesh);

bool LooksLikePLY(std::string_view begin);
void ParsePLY(std::string_view file, const ProgressReport& progress, MeshData& mesh);

bool LooksLikeSTL(std::string_view begin);
void ParseSTL(std::string_view file, const ProgressReport& progress, MeshData& mesh);

bool LooksLikeXYZ(std::string_view begin);
void ParseXYZ(std::string_view file, const ProgressReport& progress, MeshData& mesh);

/// Adds a warning if the last line of a text file has no line end, because its last number may be
/// truncated.
void WarnOfOpenLine(std::string_view file, MeshData& mesh);

/// Sorts the faces of a file into verts, lines and polygons by their number of corners.
class FaceSorter
{
public:
  explicit FaceSorter(MeshData& mesh)
    : Mesh(mesh)
  {
  }

  /// Adds the next face of the file. Precondition: it has corners.
  void Add(const std::vector<std::int64_t>& corners);
  std::size_t GetCount() const { return this->Count; }
  /// Moves the values of the faces, in the order of the file, to the order of the cells.
  void Sort(DataArray& values) const;

private:
  MeshData& Mesh;
  std::vector<std::size_t> Faces[3]; ///< indices in the file of verts, lines and polygons
  std::size_t Count = 0;
};
}

#endif
