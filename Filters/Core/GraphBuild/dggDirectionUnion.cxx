// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggDirectionUnion.h"

#include <algorithm>

namespace dgg
{
void DirectionUnion::Unite(RowStore& rows, Id first, const ParallelFor& parallel)
{
  const Offset base = rows.Begin(first);
  this->IsDouble.assign(static_cast<std::size_t>(rows.GetNumberOfEdges() - base), 0);
  // Threads only read rows in this loop, except for the reverse edges to the current rows.
  ForRange(parallel, rows.GetNumberOfRows() - first, RowsAtOnce, [&](Offset begin, Offset end) {
    const auto workspace = this->Workspaces.Borrow();
    for (Offset row = begin; row < end; row += RowsAtOnce)
    {
      const Offset last = std::min<Offset>(end, row + RowsAtOnce);
      workspace->Unite(this->Ids, rows, first + static_cast<Id>(row), first + static_cast<Id>(last),
        base, this->IsDouble.data());
    }
  });
  rows.Remove(first, this->IsDouble);
}

void DirectionUnion::Workspace::Unite(
  const std::vector<Id>& ids, RowStore& rows, Id begin, Id end, Offset base, unsigned char* flags)
{
  if (this->Heads.size() < static_cast<std::size_t>(end))
  {
    this->Heads.reserve(static_cast<std::size_t>(rows.GetCapacityOfRows()));
    this->Heads.resize(static_cast<std::size_t>(end), NoId);
  }
  for (Id row = begin; row < end; ++row)
  {
    for (Offset i = rows.Begin(row); i < rows.End(row); ++i)
    {
      if (rows.Target(i) < row)
      {
        Id& head = this->Heads[rows.Target(i)];
        if (head == NoId)
        {
          this->Targets.push_back(rows.Target(i));
        }
        this->AllWanted.push_back({ i, row, head });
        head = static_cast<Id>(this->AllWanted.size() - 1);
      }
    }
  }
  const auto size = static_cast<std::uint32_t>(end - begin);
  this->WaysBack.assign(RowsAtOnce, -1);
  for (const Id target : this->Targets)
  {
    for (Offset i = rows.Begin(target); i < rows.End(target); ++i)
    {
      // A single comparison suffices, because the difference wraps around for earlier rows.
      const auto place = static_cast<std::uint32_t>(rows.Target(i) - begin);
      if (place < size)
      {
        this->WaysBack[place] = i;
        this->Found.push_back(place);
      }
    }
    for (Id k = this->Heads[target]; k != NoId; k = this->AllWanted[k].Next)
    {
      const Wanted& wanted = this->AllWanted[k];
      const Offset back = this->WaysBack[wanted.Row - begin];
      if (back >= 0)
      {
        flags[wanted.Edge - base] = 1;
        const double length = rows.Length(wanted.Edge);
        if (length < rows.Length(back) ||
          (length == rows.Length(back) && ids[wanted.Row] < ids[target]))
        {
          const RowEdge edge = rows.Get(wanted.Edge);
          rows.SetWay(back, edge.Length, edge.Arrival, edge.Departure);
        }
      }
    }
    for (const std::uint32_t place : this->Found)
    {
      this->WaysBack[place] = -1;
    }
    this->Found.clear();
    this->Heads[target] = NoId;
  }
  this->Targets.clear();
  this->AllWanted.clear();
}
}
