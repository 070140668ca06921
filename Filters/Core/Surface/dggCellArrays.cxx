// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCellArrays.h"

#include <algorithm>

namespace dgg
{
//------------------------------------------------------------------------------
Offset CellArrays::FindCell(Offset i) const
{
  return std::upper_bound(this->Offsets, this->Offsets + this->NumberOfCells, i) - this->Offsets -
    1;
}

//------------------------------------------------------------------------------
Status CellArrays::CheckOffsets(const char* owner) const
{
  const Offset* last = this->Offsets + this->NumberOfCells;
  const bool isValid = this->NumberOfCells == 0 ||
    (this->Offsets[0] == 0 && *last == this->NumberOfIds &&
      std::is_sorted(this->Offsets, last + 1));
  return isValid ? Status::Success()
                 : InvalidInput("The offsets and the connectivity of the cells of ", owner,
                     " contradict each other")
                     .Fix("Rebuild the cell array");
}

//------------------------------------------------------------------------------
Status CellArrays::Check(Offset firstCell, Offset numberOfPoints, const char* owner) const
{
  DGG_RETURN_IF_ERROR(this->CheckOffsets(owner));
  const Offset* end = this->Ids + this->NumberOfIds;
  const Offset* wrong =
    std::find_if(this->Ids, end, [&](Offset id) { return id < 0 || id >= numberOfPoints; });
  return wrong == end
    ? Status::Success()
    : InvalidInput("Cell ", firstCell + this->FindCell(wrong - this->Ids), " of ", owner,
        " refers to point ", *wrong, ", but the number of points is ", numberOfPoints)
        .Fix("Repair the cell");
}
}
