// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSurfaceParts.h"

#include "dggCounted.h"
#include "dggStatus.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>

namespace
{
struct PartFinder
{
  std::vector<DGGSurfacePart> Parts;
  vtkIdType Others = 0;
  int Block = 0;

  void AddLeaf(vtkDataObject* leaf)
  {
    if (auto* surface = vtkPolyData::SafeDownCast(leaf))
    {
      this->Parts.push_back({ surface, this->Block });
    }
    else if (leaf)
    {
      ++this->Others;
    }
  }

  void Visit(vtkDataObject* node)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(node))
    {
      for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
      {
        this->Visit(blocks->GetBlock(i));
      }
      return;
    }
    if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(node))
    {
      for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
      {
        this->Visit(collection->GetPartitionedDataSet(i));
      }
      return;
    }
    if (auto* pieces = vtkPartitionedDataSet::SafeDownCast(node))
    {
      for (unsigned int i = 0; i < pieces->GetNumberOfPartitions(); ++i)
      {
        this->AddLeaf(pieces->GetPartitionAsDataObject(i));
      }
    }
    else
    {
      this->AddLeaf(node);
    }
    ++this->Block; // also for a missing block, which another process may have
  }
};

/// Returns, per element, true if a bit of `mask` is set in `array`; all false if the array is null
/// or has another size.
std::vector<bool> ReadMask(vtkUnsignedCharArray* array, vtkIdType size, unsigned char mask)
{
  std::vector<bool> isSet(static_cast<std::size_t>(size), false);
  for (vtkIdType i = 0; array && array->GetNumberOfTuples() == size && i < size; ++i)
  {
    isSet[i] = (array->GetValue(i) & mask) != 0;
  }
  return isSet;
}

bool HasAny(const std::vector<bool>& mask)
{
  return std::find(mask.begin(), mask.end(), true) != mask.end();
}

/// Returns consecutive indices of the elements that are kept; -1 for excluded elements.
std::vector<vtkIdType> Number(const std::vector<bool>& isLeftOut)
{
  std::vector<vtkIdType> numbers(isLeftOut.size(), -1);
  vtkIdType next = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = isLeftOut[i] ? -1 : next++;
  }
  return numbers;
}

/// Calls `visit(cell, size, points)` for each cell, in the order of ids in a vtkPolyData.
template <typename Visitor>
void ForEachCell(vtkPolyData* part, Visitor&& visit)
{
  vtkIdType cell = 0;
  for (int kind = 0; kind < DGGNumberOfCellKinds; ++kind)
  {
    vtkCellArray* cells = DGGGetCells(part, kind);
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      cells->GetCellAtId(i, size, points);
      visit(cell++, size, points);
    }
  }
}

using FieldList = vtkDataSetAttributes::FieldList;

void AssemblePoints(const std::vector<DGGSurfacePart>& parts,
  const std::vector<DGGPartNumbers>& numbers, vtkPolyData* whole)
{
  FieldList arrays;
  vtkIdType size = 0;
  int type = VTK_FLOAT;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    arrays.IntersectFieldList(parts[p].Data->GetPointData());
    for (const vtkIdType number : numbers[p].Points)
    {
      size = std::max(size, number + 1);
    }
    vtkPoints* points = parts[p].Data->GetPoints();
    type = points && points->GetDataType() != VTK_FLOAT ? VTK_DOUBLE : type;
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->SetNumberOfPoints(size);
  whole->SetPoints(points);
  whole->GetPointData()->CopyAllOn();
  whole->GetPointData()->CopyAllocate(arrays, size);
  std::vector<bool> isSet(static_cast<std::size_t>(size), false);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    vtkPolyData* part = parts[p].Data;
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const vtkIdType number = numbers[p].Points[i];
      if (number >= 0 && !isSet[number])
      {
        isSet[number] = true;
        points->SetPoint(number, part->GetPoint(i));
        whole->GetPointData()->CopyData(
          arrays, part->GetPointData(), static_cast<int>(p), i, number);
      }
    }
  }
}

void AssembleCells(const std::vector<DGGSurfacePart>& parts,
  const std::vector<DGGPartNumbers>& numbers, vtkPolyData* whole)
{
  FieldList arrays;
  for (const DGGSurfacePart& part : parts)
  {
    arrays.IntersectFieldList(part.Data->GetCellData());
  }
  whole->GetCellData()->CopyAllOn();
  whole->GetCellData()->CopyAllocate(arrays);
  vtkIdType before = 0; // number of cells of earlier kinds
  std::vector<vtkIdType> firstCells(parts.size(), 0);
  for (int kind = 0; kind < DGGNumberOfCellKinds; ++kind)
  {
    // Part and cell id from which each cell of this kind is copied, by the id of the copy.
    std::vector<std::pair<std::size_t, vtkIdType>> origins;
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      const vtkIdType count = DGGGetCells(parts[p].Data, kind)->GetNumberOfCells();
      for (vtkIdType i = count - 1; i >= 0; --i)
      {
        const vtkIdType number = numbers[p].Cells[firstCells[p] + i];
        if (number >= 0)
        {
          origins.resize(
            std::max(origins.size(), static_cast<std::size_t>(number - before) + 1), { p, -1 });
          auto& origin = origins[static_cast<std::size_t>(number - before)];
          origin = origin.second < 0 ? std::make_pair(p, i) : origin;
        }
      }
    }
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkIdList> corners;
    for (const auto& origin : origins)
    {
      const std::size_t p = origin.first;
      vtkPolyData* part = parts[p].Data;
      DGGGetCells(part, kind)->GetCellAtId(origin.second, corners);
      for (vtkIdType& corner : *corners)
      {
        corner = numbers[p].Points[corner];
      }
      const vtkIdType number = before + cells->InsertNextCell(corners);
      whole->GetCellData()->CopyData(
        arrays, part->GetCellData(), static_cast<int>(p), firstCells[p] + origin.second, number);
    }
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      firstCells[p] += DGGGetCells(parts[p].Data, kind)->GetNumberOfCells();
    }
    before += cells->GetNumberOfCells();
    kind == 0     ? whole->SetVerts(cells)
      : kind == 1 ? whole->SetLines(cells)
      : kind == 2 ? whole->SetPolys(cells)
                  : whole->SetStrips(cells);
  }
}
}

//------------------------------------------------------------------------------
std::vector<DGGSurfacePart> DGGFindParts(vtkDataObject* data, vtkIdType& others)
{
  PartFinder finder;
  finder.Visit(data);
  others = finder.Others;
  return finder.Parts;
}

//------------------------------------------------------------------------------
vtkCellArray* DGGGetCells(vtkPolyData* part, int kind)
{
  return kind == 0 ? part->GetVerts()
    : kind == 1    ? part->GetLines()
    : kind == 2    ? part->GetPolys()
                   : part->GetStrips();
}

//------------------------------------------------------------------------------
dgg::Status DGGCheckCells(vtkPolyData* part)
{
  for (int kind = 0; kind < DGGNumberOfCellKinds; ++kind)
  {
    vtkCellArray* cells = DGGGetCells(part, kind);
    if (!cells->IsValid())
    {
      return dgg::InvalidInput("The offsets and the connectivity of the cells of a piece of the "
                               "input contradict each other")
        .Fix("Rebuild its cell arrays");
    }
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(i, size, ids);
      for (vtkIdType k = 0; k < size; ++k)
      {
        if (ids[k] < 0 || ids[k] >= part->GetNumberOfPoints())
        {
          return dgg::InvalidInput("A cell of a piece of the input refers to point ", ids[k],
            ", but the piece has ", dgg::Counted(part->GetNumberOfPoints(), "point"))
            .Fix("Repair the cell");
        }
      }
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> DGGAssembleParts(
  const std::vector<DGGSurfacePart>& parts, const std::vector<DGGPartNumbers>& numbers)
{
  auto whole = vtkSmartPointer<vtkPolyData>::New();
  AssemblePoints(parts, numbers, whole);
  AssembleCells(parts, numbers, whole);
  return whole;
}

//------------------------------------------------------------------------------
dgg::Status DGGRemoveGhosts(vtkSmartPointer<vtkPolyData>& part)
{
  const std::vector<bool> isGhostCell = ReadMask(
    part->GetCellGhostArray(), part->GetNumberOfCells(), vtkDataSetAttributes::DUPLICATECELL);
  std::vector<bool> isGhostPoint = ReadMask(
    part->GetPointGhostArray(), part->GetNumberOfPoints(), vtkDataSetAttributes::DUPLICATEPOINT);
  if (!HasAny(isGhostCell) && !HasAny(isGhostPoint))
  {
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(DGGCheckCells(part));
  // Points of remaining cells are kept; points that only removed cells use are removed.
  for (const bool isGhost : { true, false })
  {
    ForEachCell(part, [&](vtkIdType cell, vtkIdType size, const vtkIdType* ids) {
      for (vtkIdType k = 0; isGhostCell[cell] == isGhost && k < size; ++k)
      {
        isGhostPoint[ids[k]] = isGhost;
      }
    });
  }
  auto kept = DGGAssembleParts({ { part, 0 } }, { { Number(isGhostPoint), Number(isGhostCell) } });
  kept->GetFieldData()->PassData(part->GetFieldData());
  part = kept;
  return dgg::Status::Success();
}
