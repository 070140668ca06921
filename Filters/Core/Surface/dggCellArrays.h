// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Cells as flat arrays.
#ifndef dggCellArrays_h
#define dggCellArrays_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status

namespace dgg
{
/// Cells as flat arrays: cell i has the point ids `Ids[Offsets[i]]` to `Ids[Offsets[i+1]-1]`.
struct DGG_CORE_EXPORT CellArrays
{
  Offset NumberOfCells = 0;
  const Offset* Offsets = nullptr; ///< NumberOfCells + 1
  const Offset* Ids = nullptr;
  Offset NumberOfIds = 0;

  const Offset* Begin(Offset cell) const { return this->Ids + this->Offsets[cell]; }
  const Offset* End(Offset cell) const { return this->Ids + this->Offsets[cell + 1]; }
  /// Returns the cell that contains `Ids[i]`.
  Offset FindCell(Offset i) const;

  ///@{
  /// Returns an error if the offsets do not divide the ids, or if a point id is out of range.
  /// `firstCell` is the id of cell 0, and `owner` the name of the dataset, in messages.
  Status CheckOffsets(const char* owner) const;
  Status Check(Offset firstCell, Offset numberOfPoints, const char* owner) const;
  ///@}
};
}

#endif
