// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The parts that a surface comes in. Internal.
#ifndef DGGSurfaceParts_h
#define DGGSurfaceParts_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggTypes.h"                  // for Status

#include "vtkPolyData.h"     // for the parts
#include "vtkSmartPointer.h" // for the parts

#include <vector> // for the parts

class vtkCellArray;
class vtkDataObject;

/// A part of a surface: a block, a partition, or what one of several processes has of these.
struct DGGSurfacePart
{
  vtkSmartPointer<vtkPolyData> Data; ///< never null
  int Block = 0;                     ///< parts of different blocks are not connected
};

/// The vtkPolyData of a data object, which may be null, in their order. Each leaf of a multi-block
/// is a block; partitions and pieces are parts of one. `others` counts leaves of other types.
VTKDGGFILTERSCOMMON_EXPORT std::vector<DGGSurfacePart> DGGFindParts(
  vtkDataObject* data, vtkIdType& others);

/// Whether there is nothing in a part.
inline bool DGGIsEmpty(vtkPolyData* part)
{
  return part->GetNumberOfPoints() == 0 && part->GetNumberOfCells() == 0;
}

/// The cells of a kind (0 verts, 1 lines, 2 polygons, 3 strips), of which a vtkPolyData numbers
/// those of one kind after the other.
VTKDGGFILTERSCOMMON_EXPORT vtkCellArray* DGGGetCells(vtkPolyData* part, int kind);
constexpr int DGGNumberOfCellKinds = 4;

/// Fails when cells name points that are not there.
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGCheckCells(vtkPolyData* part);

/// What the points and the cells of a part are in another vtkPolyData; -1 where they are not.
struct DGGPartNumbers
{
  std::vector<vtkIdType> Points;
  std::vector<vtkIdType> Cells;
};

/// The vtkPolyData that parts are numbered in, with the arrays that all of them have. Where several
/// have the same number, the first one counts.
VTKDGGFILTERSCOMMON_EXPORT vtkSmartPointer<vtkPolyData> DGGAssembleParts(
  const std::vector<DGGSurfacePart>& parts, const std::vector<DGGPartNumbers>& numbers);

/// Take away the cells that another process owns, by the ghost array, and points that only these
/// use; a part without them stays the same object. Hidden cells stay. Fails as DGGCheckCells().
VTKDGGFILTERSCOMMON_EXPORT dgg::Status DGGRemoveGhosts(vtkSmartPointer<vtkPolyData>& part);

#endif
