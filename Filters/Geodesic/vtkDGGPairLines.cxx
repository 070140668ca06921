// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPairLines.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <sstream>

namespace
{
dgg::Status NoPair(bool isConnected)
{
  return dgg::Status::Invalid(isConnected
      ? "there is no pair of points: input port 1 is empty. Give it a line for each pair, or call "
        "AddPair()"
      : "there is no pair of points: call AddPair(), or connect a line for each pair to input port "
        "1");
}

dgg::Status CheckLine(vtkIdType line, vtkIdType size, const vtkIdType* ids, vtkIdType points)
{
  std::ostringstream message;
  if (size == 0)
  {
    message << "line " << line << " of input port 1 has no points: remove it";
    return dgg::Status::Invalid(message.str());
  }
  for (const vtkIdType id : { ids[0], ids[size - 1] })
  {
    if (id < 0 || id >= points)
    {
      message << "line " << line << " of input port 1 names point " << id << ", but there are "
              << points << ": repair the line";
      return dgg::Status::Invalid(message.str());
    }
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPairLines::Read(vtkPolyData* lines, bool isNeeded)
{
  this->Ends.clear();
  this->Cells.clear();
  if (!lines || lines->GetNumberOfPoints() + lines->GetNumberOfLines() == 0)
  {
    return isNeeded ? NoPair(lines != nullptr) : dgg::Status::Success();
  }
  const vtkIdType count = lines->GetNumberOfLines();
  if (count == 0)
  {
    return dgg::Status::Invalid(
      "input port 1 has points but no lines, and only lines are pairs: connect the points of each "
      "pair by a line");
  }
  if (!lines->GetLines()->IsValid())
  {
    return dgg::Status::Invalid("the offsets and the connectivity of the lines of input port 1 "
                                "contradict each other: build the cell array anew");
  }
  const vtkIdType firstCell = lines->GetNumberOfVerts(); // cells are numbered verts first
  for (vtkIdType i = 0; i < count; ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetLines()->GetCellAtId(i, size, ids);
    const dgg::Status status = CheckLine(i, size, ids, lines->GetNumberOfPoints());
    if (!status.IsOk())
    {
      return status;
    }
    this->Ends.push_back(ids[0]);
    this->Ends.push_back(ids[size - 1]);
    this->Cells.push_back(firstCell + i);
  }
  return dgg::Status::Success();
}
