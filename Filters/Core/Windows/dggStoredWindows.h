// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Format of stored windows: the named arrays in field data and in files. Internal.
#ifndef dggStoredWindows_h
#define dggStoredWindows_h

#include "dggBuffer.h"      // for the arrays
#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggEdgeWindows.h" // for EdgeWindows
#include "dggStatus.h"      // for Status
#include "dggStoredArray.h" // for StoredArray

#include <array>   // for the arrays
#include <cstddef> // for std::size_t
#include <cstdint> // for fixed-width words
#include <string>  // for names

namespace dgg
{
class OutputArrays;
class PreparedSurface;

/// The windows that belong to an array of distances as flat arrays. For distances named D the
/// arrays are
///
///  - `D.WindowOffsets` (int64): the windows of half-edge h are [WindowOffsets[h],
///    WindowOffsets[h + 1]);
///  - `D.Windows` (double, 5 components): Begin, End, ImageX, ImageY, Offset of EdgeWindow;
///  - `D.WindowSources` (double, 5 components): face, three barycentric coordinates, Offset of
///    FaceSource;
///  - `D.WindowInfo` (int64, 5 values): format version, the signature of the surface, a hash of the
///    distances, a hash of the other three arrays.
struct DGG_CORE_EXPORT StoredWindows
{
  enum Role
  {
    OffsetsRole,
    WindowsRole,
    SourcesRole,
    InfoRole,
    NumberOfRoles
  };
  using Arrays = std::array<StoredArray, NumberOfRoles>;

  static constexpr int NumberOfComponents = 5; ///< of windows and sources

  /// Returns the name of an array.
  static std::string GetName(const std::string& distances, int role);

  /// Makes the arrays of the windows of distances, one per point, on a surface.
  StoredWindows(const EdgeWindows& windows, const double* distances, std::size_t numberOfDistances,
    const PreparedSurface& surface);

  /// Reads the windows of the distances `name`. Found arrays are not trusted: fails unless sizes,
  /// surface, distances and all values are valid. After a failure there are no windows.
  static Status Read(const Arrays& arrays, const std::string& name, const double* distances,
    std::size_t numberOfDistances, const PreparedSurface& surface, EdgeWindows& windows);

  /// Moves the arrays of the distances `name` to field data.
  void AddTo(const std::string& name, OutputArrays& arrays);

  Buffer<std::int64_t> Offsets;
  Buffer<double> Windows;
  Buffer<double> Sources;
  Buffer<std::int64_t> Info;
};
}

#endif
