// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Parts of a surface. Internal.
#ifndef DGGSurfaceParts_h
#define DGGSurfaceParts_h

#include "DGGSurfaceArrays.h"          // for copies
#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggSurfacePieces.h"          // for SurfacePiece

#include "vtkPolyData.h"     // for the parts
#include "vtkSmartPointer.h" // for the parts

#include <vector> // for the parts

class vtkCellArray;
class vtkDataObject;

/// Part of a surface: a block, a partition, or the piece that one of several processes holds.
struct DGGSurfacePart
{
  vtkSmartPointer<vtkPolyData> Data; ///< never null
  int Block = 0;                     ///< parts of different blocks are not connected
};

/// Returns the vtkPolyData leaves of a data object, which may be null, in their order. Each leaf of
/// a multi-block data set is a block; partitions and pieces are parts of one block. `others` is the
/// number of leaves of other types.
VTKDGGFILTERSCOMMON_EXPORT std::vector<DGGSurfacePart> DGGFindParts(
  vtkDataObject* data, vtkIdType& others);

/// Returns true if a part has neither points nor cells.
inline bool DGGIsEmpty(vtkPolyData* part)
{
  return part->GetNumberOfPoints() == 0 && part->GetNumberOfCells() == 0;
}

/// Returns the cells of a kind (0 verts, 1 lines, 2 polygons, 3 strips). The cell ids of a
/// vtkPolyData count one kind after the other.
VTKDGGFILTERSCOMMON_EXPORT vtkCellArray* DGGGetCells(vtkPolyData* part, int kind);

/// Converts a part. `copies`, made for this part, holds the arrays that had to be copied, and
/// determines if the piece has positions.
VTKDGGFILTERSCOMMON_EXPORT dgg::SurfacePiece DGGConvertPart(
  const DGGSurfacePart& part, DGGSurfaceArrays& copies);

/// Returns the vtkPolyData that parts form, with the arrays that all parts have.
VTKDGGFILTERSCOMMON_EXPORT vtkSmartPointer<vtkPolyData> DGGAssembleParts(
  const std::vector<DGGSurfacePart>& parts, const dgg::PieceNumbering& numbering);

/// Removes the cells that another process owns, according to the ghost array, and points that only
/// these cells use. A part without such cells remains the same object. Hidden cells are kept. Fails
/// if a cell has a point id that is out of range.
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGRemoveGhosts(vtkSmartPointer<vtkPolyData>& part);

#endif
