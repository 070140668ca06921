// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Patch layouts from cells, and their boundaries as outputs. Internal.
#ifndef dggPatchOutput_h
#define dggPatchOutput_h

#include "dggCoreExport.h"      // for DGG_CORE_EXPORT
#include "dggPatchBoundaries.h" // for PatchLayout

namespace dgg
{
struct CellArrays;
struct Output;
struct TaskContext;

/// Reads a layout whose patches are polygons and whose edges are the segments of lines; the point
/// ids of the cells are indices of landmarks. Indices out of the range of Id become NoId. Fails if
/// offsets and ids contradict each other.
DGG_CORE_EXPORT Status ReadPatchLayout(
  const CellArrays& polygons, const CellArrays& lines, PatchLayout& layout);

/// Writes the curves on one of the two surfaces, with the cell arrays `LayoutEdge` (the landmarks
/// that are joined) and `Length` and the point array `ArcFraction`. The context belongs to
/// this surface.
DGG_CORE_EXPORT void WritePatchBoundaries(
  const TaskContext& context, const PatchBoundaries& boundaries, int side, Output& output);
}

#endif
