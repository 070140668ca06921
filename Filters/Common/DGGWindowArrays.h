// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Windows of exact distances as arrays in field data. Internal.
#ifndef DGGWindowArrays_h
#define DGGWindowArrays_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggEdgeWindows.h"            // for EdgeWindows

#include <string> // for the name

namespace dgg
{
class PreparedSurface;
}
class vtkDataArray;
class vtkDoubleArray;
class vtkFieldData;

/// Stores the windows that belong to an array of distances in field data, and finds them there. For
/// distances named D the arrays are
///
///  - `D.WindowOffsets` (int64): the windows of half-edge h are [WindowOffsets[h],
///    WindowOffsets[h + 1]);
///  - `D.Windows` (double, 5 components): Begin, End, ImageX, ImageY, Offset of dgg::EdgeWindow;
///  - `D.WindowSources` (double, 5 components): face, three barycentric coordinates, Offset of
///    dgg::FaceSource;
///  - `D.WindowInfo` (int64, 5 values): format version, the signature of the surface, a hash of the
///    distances, a hash of the other three arrays.
///
/// Found arrays are not trusted: sizes, surface, distances and all values are checked.
class VTKDGGFILTERSCOMMON_EXPORT DGGWindowArrays
{
public:
  static void AddTo(vtkFieldData* data, vtkDoubleArray* distances, const dgg::PreparedSurface& mesh,
    const dgg::EdgeWindows& windows);

  static void RemoveFrom(vtkFieldData* data, const std::string& distances);

  /// Removes the windows of all distances, regardless of their names.
  static void RemoveAllFrom(vtkFieldData* data);

  /// Finds the windows of `distances`. `complaint` is the defect of existing arrays that cannot be
  /// used; empty if there are no arrays.
  static bool Find(vtkFieldData* data, vtkDataArray* distances, const dgg::PreparedSurface& mesh,
    dgg::EdgeWindows& windows, std::string& complaint);
};

#endif
