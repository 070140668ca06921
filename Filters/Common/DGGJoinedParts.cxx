// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGJoinedParts.h"

#include "dggSurfacePieces.h"
#include "dggStatus.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstring>
#include <list>
#include <numeric>
#include <utility>

namespace
{
using Parts = std::vector<DGGSurfacePart>;

bool AreSame(vtkDataArray* a, vtkDataArray* b)
{
  return a == b ||
    (a && b && a->GetDataType() == b->GetDataType() &&
      a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
      a->GetNumberOfTuples() == b->GetNumberOfTuples() &&
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
        static_cast<std::size_t>(a->GetDataSize()) *
          static_cast<std::size_t>(a->GetDataTypeSize())) == 0);
}

/// Returns true if two parts are copies of each other, sent by two processes: the same cells on the
/// same points and, for parts without faces such as sources, the same point data.
bool AreSame(vtkPolyData* a, vtkPolyData* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfCells() != b->GetNumberOfCells())
  {
    return false;
  }
  bool same = !a->GetPoints() || AreSame(a->GetPoints()->GetData(), b->GetPoints()->GetData());
  for (int kind = 0; kind < dgg::NumberOfCellKinds && same; ++kind)
  {
    vtkCellArray* of[2] = { DGGGetCells(a, kind), DGGGetCells(b, kind) };
    same = of[0]->GetNumberOfCells() == of[1]->GetNumberOfCells() &&
      (of[0]->GetNumberOfCells() == 0 ||
        (AreSame(of[0]->GetOffsetsArray(), of[1]->GetOffsetsArray()) &&
          AreSame(of[0]->GetConnectivityArray(), of[1]->GetConnectivityArray())));
  }
  const bool hasFaces = a->GetNumberOfPolys() + a->GetNumberOfStrips() > 0;
  vtkPointData* data = a->GetPointData();
  same = same && (hasFaces || data->GetNumberOfArrays() == b->GetPointData()->GetNumberOfArrays());
  for (int i = 0; i < data->GetNumberOfArrays() && same && !hasFaces; ++i)
  {
    vtkDataArray* array = data->GetArray(i); // null for strings, which are not compared
    same = !array ||
      AreSame(array,
        array->GetName() ? b->GetPointData()->GetArray(array->GetName())
                         : b->GetPointData()->GetArray(i));
  }
  return same;
}

/// Finds the ids of the points and cells of parts on the joined surface.
dgg::Status NumberParts(const Parts& parts, dgg::PieceNumbering& numbering)
{
  std::list<DGGSurfaceArrays> copies;
  std::vector<dgg::SurfacePiece> pieces;
  for (const DGGSurfacePart& part : parts)
  {
    pieces.push_back(DGGConvertPart(part, copies.emplace_back(part.Data, true, false)));
  }
  return dgg::JoinSurfacePieces(pieces, numbering);
}

/// Returns the differences between an output and `whole`, the joined surface that the output was
/// computed from.
DGGChangedArrays FindChanges(
  vtkDataSetAttributes* whole, vtkDataSetAttributes* output, const std::vector<dgg::Offset>& ids)
{
  DGGChangedArrays changes;
  for (int i = 0; i < whole->GetNumberOfArrays(); ++i)
  {
    const char* name = whole->GetAbstractArray(i)->GetName();
    if (name && !output->HasArray(name))
    {
      changes.Removed.emplace_back(name);
    }
  }
  for (int i = 0; i < output->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = output->GetAbstractArray(i);
    // Arrays of other types cannot be sent.
    if (!(vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array)) ||
      !array->GetName() || whole->GetAbstractArray(array->GetName()) == array)
    {
      continue;
    }
    auto some = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    some->SetName(array->GetName());
    some->SetNumberOfComponents(array->GetNumberOfComponents());
    some->CopyComponentNames(array);
    some->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      some->SetTuple(static_cast<vtkIdType>(k), ids[k], array);
    }
    changes.Added.push_back(some);
  }
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* active = output->GetAbstractAttribute(type);
    changes.Active[type] = active && active->GetName() ? active->GetName() : "";
  }
  return changes;
}

void ApplyChanges(const DGGChangedArrays& changes, vtkDataSetAttributes* data)
{
  for (const std::string& name : changes.Removed)
  {
    data->RemoveArray(name.c_str());
  }
  for (vtkAbstractArray* array : changes.Added)
  {
    data->AddArray(array);
  }
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    const std::string& name = changes.Active[type];
    if (!name.empty())
    {
      data->SetActiveAttribute(name.c_str(), type);
    }
  }
}
}

//------------------------------------------------------------------------------
dgg::Status DGGJoinedParts::Join(const Parts& parts)
{
  this->Ids.assign(parts.size(), {});
  this->Whole = vtkSmartPointer<vtkPolyData>::New();
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return parts[a].Block < parts[b].Block; });
  std::vector<std::size_t> used; // non-empty parts without repeated copies
  std::vector<std::size_t> first(parts.size());
  for (const std::size_t p : order)
  {
    const auto same = std::find_if(used.begin(), used.end(), [&](std::size_t q) {
      return parts[q].Block == parts[p].Block && AreSame(parts[q].Data, parts[p].Data);
    });
    first[p] = same == used.end() ? p : *same;
    if (same == used.end() && !DGGIsEmpty(parts[p].Data))
    {
      used.push_back(p);
    }
  }
  const bool isNumbered = parts.size() > 1 && used.size() == 1 &&
    parts[used[0]].Data->GetPointData()->GetGlobalIds() != nullptr;
  if (used.size() <= 1 && !isNumbered)
  {
    if (!parts.empty())
    {
      this->Whole->ShallowCopy(parts[used.empty() ? 0 : used[0]].Data);
    }
    for (const std::size_t p : used)
    {
      this->Ids[p] = dgg::PieceIds::MakeIdentity(
        parts[p].Data->GetNumberOfPoints(), parts[p].Data->GetNumberOfCells());
    }
  }
  else
  {
    Parts some;
    for (const std::size_t p : used)
    {
      some.push_back(parts[p]);
    }
    dgg::PieceNumbering numbering;
    DGG_RETURN_IF_ERROR(NumberParts(some, numbering));
    this->Whole = DGGAssembleParts(some, numbering);
    for (std::size_t k = 0; k < used.size(); ++k)
    {
      this->Ids[used[k]] = std::move(numbering.Pieces[k]);
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    this->Ids[p] = this->Ids[first[p]];
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
DGGPartResult DGGJoinedParts::MakeResult(vtkPolyData* output, std::size_t part) const
{
  const dgg::PieceIds& ids = this->Ids[part];
  return { FindChanges(this->Whole->GetPointData(), output->GetPointData(), ids.Points),
    FindChanges(this->Whole->GetCellData(), output->GetCellData(), ids.Cells) };
}

//------------------------------------------------------------------------------
void DGGJoinedParts::AddResult(const DGGPartResult& result, vtkPolyData* part)
{
  ApplyChanges(result.Points, part->GetPointData());
  ApplyChanges(result.Cells, part->GetCellData());
}
