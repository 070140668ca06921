// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGJoinedParts.h"

#include "DGGPartRims.h"

#include "dggDisjointSets.h"
#include "dggStatus.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace
{
using Parts = std::vector<DGGSurfacePart>;
using Numbers = std::vector<DGGPartNumbers>;

/// Largest distance between points with the same global id, as a fraction of the diagonal:
/// processes may round coordinates differently.
constexpr double IdTolerance = 1e-5;

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
  for (int kind = 0; kind < DGGNumberOfCellKinds && same; ++kind)
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

/// Returns the global ids of each part; empty if a part has none.
std::vector<vtkDataArray*> FindGlobalIds(const Parts& parts, bool ofPoints)
{
  std::vector<vtkDataArray*> ids;
  for (const DGGSurfacePart& part : parts)
  {
    vtkPolyData* data = part.Data;
    const vtkIdType size = ofPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells();
    vtkDataArray* array =
      ofPoints ? data->GetPointData()->GetGlobalIds() : data->GetCellData()->GetGlobalIds();
    if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != size)
    {
      return {};
    }
    ids.push_back(array);
  }
  return ids;
}

/// Returns an id exactly; a conversion to double could round the id.
vtkIdType GetId(vtkDataArray* ids, vtkIdType i)
{
  return static_cast<vtkIdType>(ids->GetVariantValue(i).ToTypeInt64());
}

/// Joins points of one block that have equal global ids. Fails if such points have different
/// positions, which happens if each process has numbered its own points.
dgg::Status JoinGlobalIds(
  const Parts& parts, const std::vector<vtkDataArray*>& ids, dgg::DisjointSets& points)
{
  using Named = std::tuple<int, vtkIdType, std::size_t, vtkIdType, dgg::Id>;
  std::vector<Named> named; // block, id, part, point of the part, point of all
  vtkBoundingBox box;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    box.AddBounds(parts[p].Data->GetBounds());
    for (vtkIdType i = 0; i < parts[p].Data->GetNumberOfPoints(); ++i)
    {
      named.emplace_back(
        parts[p].Block, GetId(ids[p], i), p, i, static_cast<dgg::Id>(named.size()));
    }
  }
  std::sort(named.begin(), named.end());
  for (std::size_t k = 1; k < named.size(); ++k)
  {
    const Named& one = named[k - 1];
    const Named& other = named[k];
    if (std::get<0>(one) != std::get<0>(other) || std::get<1>(one) != std::get<1>(other))
    {
      continue;
    }
    points.Join(std::get<4>(one), std::get<4>(other));
    double a[3];
    double b[3];
    parts[std::get<2>(one)].Data->GetPoint(std::get<3>(one), a);
    parts[std::get<2>(other)].Data->GetPoint(std::get<3>(other), b);
    if (std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > IdTolerance * box.GetDiagonalLength())
    {
      return dgg::InvalidInput("Two points have the global id ", std::get<1>(one), ", one at (",
        a[0], ", ", a[1], ", ", a[2], ") and one at (", b[0], ", ", b[1], ", ", b[2], ")")
        .Fix("Renumber the points of all pieces, or remove the global ids to join the pieces by "
             "coordinates");
    }
  }
  return dgg::Status::Success();
}

/// Numbers the sets of joined points consecutively: block by block, within a block by global ids if
/// they exist.
void NumberPoints(const Parts& parts, const std::vector<vtkDataArray*>& ids,
  dgg::DisjointSets& points, Numbers& numbers)
{
  std::vector<std::tuple<int, vtkIdType, dgg::Id>> order; // one point of each set
  dgg::Id inAll = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (vtkIdType i = 0; i < parts[p].Data->GetNumberOfPoints(); ++i, ++inAll)
    {
      if (points.Find(inAll) == inAll)
      {
        order.emplace_back(parts[p].Block, ids.empty() ? 0 : GetId(ids[p], i), inAll);
      }
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<vtkIdType> ofSets(static_cast<std::size_t>(inAll), -1);
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    ofSets[std::get<2>(order[k])] = static_cast<vtkIdType>(k);
  }
  inAll = 0;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (vtkIdType i = 0; i < parts[p].Data->GetNumberOfPoints(); ++i, ++inAll)
    {
      numbers[p].Points.push_back(ofSets[points.Find(inAll)]);
    }
  }
}

/// Numbers cells consecutively, kind by kind. Cells with the same global id are joined if they have
/// the same points; otherwise they are not, because faces of a volume have the id of the volume.
void NumberCells(const Parts& parts, const std::vector<vtkDataArray*>& ids, Numbers& numbers)
{
  vtkIdType next = 0;
  for (int kind = 0; kind < DGGNumberOfCellKinds; ++kind)
  {
    using Origin = std::tuple<int, vtkIdType, std::size_t, vtkIdType>; // block, id, part, cell
    std::vector<Origin> order;
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      auto cell = static_cast<vtkIdType>(numbers[p].Cells.size());
      const vtkIdType end = cell + DGGGetCells(parts[p].Data, kind)->GetNumberOfCells();
      numbers[p].Cells.resize(static_cast<std::size_t>(end), -1);
      for (; cell < end; ++cell)
      {
        order.emplace_back(parts[p].Block, ids.empty() ? 0 : GetId(ids[p], cell), p, cell);
      }
    }
    const auto hasSameId = [&](const Origin& a, const Origin& b) {
      return !ids.empty() && std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b);
    };
    const auto getCorners = [&](const Origin& origin) {
      const std::size_t p = std::get<2>(origin);
      vtkCellArray* cells = DGGGetCells(parts[p].Data, kind);
      const auto end = static_cast<vtkIdType>(numbers[p].Cells.size());
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      cells->GetCellAtId(std::get<3>(origin) - (end - cells->GetNumberOfCells()), size, points);
      std::vector<vtkIdType> corners;
      for (vtkIdType k = 0; k < size; ++k)
      {
        corners.push_back(numbers[p].Points[points[k]]);
      }
      std::sort(corners.begin(), corners.end());
      return corners;
    };
    std::sort(order.begin(), order.end(), [&](const Origin& a, const Origin& b) {
      return hasSameId(a, b) ? std::make_pair(getCorners(a), a) < std::make_pair(getCorners(b), b)
                             : a < b;
    });
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      const bool isAgain = k > 0 && hasSameId(order[k - 1], order[k]) &&
        getCorners(order[k - 1]) == getCorners(order[k]);
      next += isAgain ? 0 : 1;
      numbers[std::get<2>(order[k])].Cells[std::get<3>(order[k])] = next - 1;
    }
  }
}

DGGPartNumbers MakeIdentity(vtkPolyData* part)
{
  DGGPartNumbers numbers;
  numbers.Points.resize(static_cast<std::size_t>(part->GetNumberOfPoints()));
  numbers.Cells.resize(static_cast<std::size_t>(part->GetNumberOfCells()));
  std::iota(numbers.Points.begin(), numbers.Points.end(), 0);
  std::iota(numbers.Cells.begin(), numbers.Cells.end(), 0);
  return numbers;
}

/// Returns the differences between an output and `whole`, the joined surface that the output was
/// computed from.
DGGChangedArrays FindChanges(
  vtkDataSetAttributes* whole, vtkDataSetAttributes* output, const std::vector<vtkIdType>& numbers)
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
    some->SetNumberOfTuples(static_cast<vtkIdType>(numbers.size()));
    for (std::size_t k = 0; k < numbers.size(); ++k)
    {
      some->SetTuple(static_cast<vtkIdType>(k), numbers[k], array);
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
  this->Numbers.assign(parts.size(), DGGPartNumbers());
  this->Whole = vtkSmartPointer<vtkPolyData>::New();
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return parts[a].Block < parts[b].Block; });
  std::vector<std::size_t> used; // non-empty parts without repeated copies
  std::vector<std::size_t> first(parts.size());
  vtkIdType size = 0;
  for (const std::size_t p : order)
  {
    const auto same = std::find_if(used.begin(), used.end(), [&](std::size_t q) {
      return parts[q].Block == parts[p].Block && AreSame(parts[q].Data, parts[p].Data);
    });
    first[p] = same == used.end() ? p : *same;
    if (same == used.end() && !DGGIsEmpty(parts[p].Data))
    {
      used.push_back(p);
      size += parts[p].Data->GetNumberOfPoints();
    }
  }
  if (size > std::numeric_limits<dgg::Id>::max())
  {
    return dgg::InvalidInput("The pieces of the input have ", size, " points, more than ",
      std::numeric_limits<dgg::Id>::max())
      .Fix("Use fewer points");
  }
  if (used.size() <= 1)
  {
    if (!parts.empty())
    {
      this->Whole->ShallowCopy(parts[used.empty() ? 0 : used[0]].Data);
    }
    for (const std::size_t p : used)
    {
      this->Numbers[p] = MakeIdentity(parts[p].Data);
    }
  }
  else
  {
    Parts some;
    for (const std::size_t p : used)
    {
      DGG_RETURN_IF_ERROR(DGGCheckCells(parts[p].Data));
      some.push_back(parts[p]);
    }
    ::Numbers numbers(some.size());
    const std::vector<vtkDataArray*> pointIds = FindGlobalIds(some, true);
    dgg::DisjointSets points(static_cast<std::size_t>(size));
    if (pointIds.empty())
    {
      DGGJoinRims(some, points);
    }
    else
    {
      DGG_RETURN_IF_ERROR(JoinGlobalIds(some, pointIds, points));
    }
    NumberPoints(some, pointIds, points, numbers);
    NumberCells(some, FindGlobalIds(some, false), numbers);
    this->Whole = DGGAssembleParts(some, numbers);
    for (std::size_t k = 0; k < used.size(); ++k)
    {
      this->Numbers[used[k]] = std::move(numbers[k]);
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    this->Numbers[p] = this->Numbers[first[p]];
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
DGGPartResult DGGJoinedParts::MakeResult(vtkPolyData* output, std::size_t part) const
{
  const DGGPartNumbers& numbers = this->Numbers[part];
  return { FindChanges(this->Whole->GetPointData(), output->GetPointData(), numbers.Points),
    FindChanges(this->Whole->GetCellData(), output->GetCellData(), numbers.Cells) };
}

//------------------------------------------------------------------------------
void DGGJoinedParts::AddResult(const DGGPartResult& result, vtkPolyData* part)
{
  ApplyChanges(result.Points, part->GetPointData());
  ApplyChanges(result.Cells, part->GetCellData());
}
