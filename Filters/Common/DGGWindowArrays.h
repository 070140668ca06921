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
class vtkFieldData;

/// Finds or removes the windows that belong to an array of distances in field data: see
/// dgg::StoredWindows.
class VTKDGGFILTERSCOMMON_EXPORT DGGWindowArrays
{
public:
  static void RemoveFrom(vtkFieldData* data, const std::string& distances);

  /// Removes the windows of all distances, regardless of their names.
  static void RemoveAllFrom(vtkFieldData* data);

  /// Finds the windows of `distances`. `complaint` is the defect of existing arrays that cannot be
  /// used; empty if there are no arrays.
  static bool Find(vtkFieldData* data, vtkDataArray* distances, const dgg::PreparedSurface& mesh,
    dgg::EdgeWindows& windows, std::string& complaint);
};

#endif
