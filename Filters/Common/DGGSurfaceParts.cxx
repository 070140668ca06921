// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSurfaceParts.h"

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

using FieldList = vtkDataSetAttributes::FieldList;

void AssemblePoints(const std::vector<DGGSurfacePart>& parts,
  const std::vector<dgg::PieceElement>& origins, vtkPolyData* whole)
{
  FieldList arrays;
  int type = VTK_FLOAT;
  for (const DGGSurfacePart& part : parts)
  {
    arrays.IntersectFieldList(part.Data->GetPointData());
    vtkPoints* points = part.Data->GetPoints();
    type = points && points->GetDataType() != VTK_FLOAT ? VTK_DOUBLE : type;
  }
  const auto size = static_cast<vtkIdType>(origins.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->SetNumberOfPoints(size);
  whole->SetPoints(points);
  whole->GetPointData()->CopyAllOn();
  whole->GetPointData()->CopyAllocate(arrays, size);
  for (vtkIdType k = 0; k < size; ++k)
  {
    const dgg::PieceElement& origin = origins[k];
    vtkPolyData* part = parts[origin.Piece].Data;
    points->SetPoint(k, part->GetPoint(origin.Index));
    whole->GetPointData()->CopyData(
      arrays, part->GetPointData(), static_cast<int>(origin.Piece), origin.Index, k);
  }
}

void AssembleCells(const std::vector<DGGSurfacePart>& parts, const dgg::PieceNumbering& numbering,
  vtkPolyData* whole)
{
  FieldList arrays;
  for (const DGGSurfacePart& part : parts)
  {
    arrays.IntersectFieldList(part.Data->GetCellData());
  }
  whole->GetCellData()->CopyAllOn();
  whole->GetCellData()->CopyAllocate(arrays);
  std::vector<vtkIdType> firstCells(parts.size(), 0); // of the kind
  for (int kind = 0; kind < dgg::NumberOfCellKinds; ++kind)
  {
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkIdList> corners;
    for (vtkIdType k = numbering.FirstCells[kind]; k < numbering.FirstCells[kind + 1]; ++k)
    {
      const dgg::PieceElement& origin = numbering.Cells[k];
      const std::size_t p = origin.Piece;
      vtkPolyData* part = parts[p].Data;
      DGGGetCells(part, kind)->GetCellAtId(origin.Index - firstCells[p], corners);
      for (vtkIdType& corner : *corners)
      {
        corner = numbering.Pieces[p].Points[corner];
      }
      cells->InsertNextCell(corners);
      whole->GetCellData()->CopyData(
        arrays, part->GetCellData(), static_cast<int>(p), origin.Index, k);
    }
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      firstCells[p] += std::max<vtkIdType>(0, DGGGetCells(parts[p].Data, kind)->GetNumberOfCells());
    }
    kind == 0     ? whole->SetVerts(cells)
      : kind == 1 ? whole->SetLines(cells)
      : kind == 2 ? whole->SetPolys(cells)
                  : whole->SetStrips(cells);
  }
}

/// Returns the flags of `size` points or cells; null if there is no such array of this size.
const unsigned char* GetFlags(vtkUnsignedCharArray* flags, vtkIdType size)
{
  static_assert(
    vtkDataSetAttributes::DUPLICATEPOINT == 1 && vtkDataSetAttributes::DUPLICATECELL == 1);
  return flags && flags->GetNumberOfTuples() == size ? flags->GetPointer(0) : nullptr;
}

/// Returns the global ids of `size` points or cells; null if there is no such array of this size.
vtkDataArray* GetGlobalIds(vtkDataSetAttributes* data, vtkIdType size)
{
  vtkDataArray* ids = data->GetGlobalIds();
  return ids && ids->GetNumberOfComponents() == 1 && ids->GetNumberOfTuples() == size ? ids
                                                                                      : nullptr;
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
dgg::SurfacePiece DGGConvertPart(const DGGSurfacePart& part, DGGSurfaceArrays& copies)
{
  vtkPolyData* data = part.Data;
  dgg::SurfacePiece piece;
  piece.Block = part.Block;
  piece.Points = copies.Get().Points;
  piece.NumberOfPoints = data->GetNumberOfPoints();
  piece.AreFromFloats = copies.Get().AreFromFloats;
  for (int kind = 0; kind < dgg::NumberOfCellKinds; ++kind)
  {
    piece.Cells[kind] = copies.ConvertCells(DGGGetCells(data, kind));
  }
  const dgg::Offset numberOfCells = piece.GetNumberOfCells();
  piece.PointIds = copies.ConvertIds(GetGlobalIds(data->GetPointData(), data->GetNumberOfPoints()));
  piece.CellIds = copies.ConvertIds(GetGlobalIds(data->GetCellData(), numberOfCells));
  piece.PointFlags = GetFlags(data->GetPointGhostArray(), data->GetNumberOfPoints());
  piece.CellFlags = GetFlags(data->GetCellGhostArray(), numberOfCells);
  return piece;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> DGGAssembleParts(
  const std::vector<DGGSurfacePart>& parts, const dgg::PieceNumbering& numbering)
{
  auto whole = vtkSmartPointer<vtkPolyData>::New();
  AssemblePoints(parts, numbering.Points, whole);
  AssembleCells(parts, numbering, whole);
  return whole;
}

//------------------------------------------------------------------------------
dgg::Status DGGRemoveGhosts(vtkSmartPointer<vtkPolyData>& part)
{
  const auto hasGhosts = [](vtkUnsignedCharArray* flags, vtkIdType size) {
    return dgg::HasGhosts(GetFlags(flags, size), size);
  };
  if (!hasGhosts(part->GetPointGhostArray(), part->GetNumberOfPoints()) &&
    !hasGhosts(part->GetCellGhostArray(), part->GetNumberOfCells()))
  {
    return dgg::Status::Success();
  }
  DGGSurfaceArrays copies(part, false, false); // positions are not needed
  const dgg::SurfacePiece piece = DGGConvertPart({ part, 0 }, copies);
  dgg::PieceNumbering numbering;
  DGG_RETURN_IF_ERROR(dgg::ExcludeGhosts(piece, numbering));
  auto kept = DGGAssembleParts({ { part, 0 } }, numbering);
  kept->GetFieldData()->PassData(part->GetFieldData());
  part = kept;
  return dgg::Status::Success();
}
