// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCellArrays.h"

#include "dggCounted.h"

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
Status CellArrays::Check(Offset firstCell, Offset numberOfPoints, const char* owner) const
{
  if (this->NumberOfCells == 0)
  {
    return Status::Success();
  }
  const Offset* last = this->Offsets + this->NumberOfCells;
  if (this->Offsets[0] != 0 || *last != this->NumberOfIds ||
    !std::is_sorted(this->Offsets, last + 1))
  {
    return InvalidInput(
      "The offsets and the connectivity of cells of the ", owner, " contradict each other")
      .Fix("Rebuild the cell array");
  }
  const Offset* end = this->Ids + this->NumberOfIds;
  const Offset* wrong =
    std::find_if(this->Ids, end, [&](Offset id) { return id < 0 || id >= numberOfPoints; });
  return wrong == end
    ? Status::Success()
    : InvalidInput("Cell ", firstCell + this->FindCell(wrong - this->Ids), " refers to point ",
        *wrong, ", but the ", owner, " has ", Counted(numberOfPoints, "point"))
        .Fix("Repair the cell");
}
}
