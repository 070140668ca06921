// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPathOutput.h"

#include "vtkDGGMakeArray.h"
#include "vtkDGGNewGeometry.h"
#include "vtkDGGPolylineWriter.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace
{
/// Values of PathStatus.
constexpr int HasPath = 0;
constexpr int NotConnected = 1;

/// An array with a tuple of `from` for each polyline, or null values.
vtkSmartPointer<vtkAbstractArray> PassArray(
  vtkAbstractArray* from, const std::vector<vtkIdType>& tuples)
{
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
  array->SetNumberOfComponents(from->GetNumberOfComponents());
  array->CopyComponentNames(from);
  array->SetName(from->GetName());
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    numbers->Fill(0.0);
  }
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    if (tuples[i] >= 0 && tuples[i] < from->GetNumberOfTuples())
    {
      array->SetTuple(static_cast<vtkIdType>(i), tuples[i], from);
    }
  }
  return array;
}

void AddCellData(const vtkDGGPathSet& set, const std::vector<vtkIdType>& pairs, vtkCellData* output)
{
  const auto count = static_cast<vtkIdType>(pairs.size());
  // Pairs by id come before those of lines, and have no tuple.
  const auto firstLine = static_cast<vtkIdType>(set.Paths.size() - set.CellsOfLast.size());
  std::vector<vtkIdType> tuples;
  auto ids = vtkDGGMakeArray<vtkIdTypeArray>("PairId", count);
  auto lengths = vtkDGGMakeArray<vtkDoubleArray>("Length", count);
  auto graphLengths = vtkDGGMakeArray<vtkDoubleArray>("GraphLength", count);
  auto straightened = vtkDGGMakeArray<vtkIntArray>("Straightened", count);
  for (vtkIdType line = 0; line < count; ++line)
  {
    const vtkIdType pair = pairs[line];
    const dgg::FoundPath& path = set.Paths[pair];
    tuples.push_back(pair < firstLine ? -1 : set.CellsOfLast[pair - firstLine]);
    ids->SetValue(line, pair);
    lengths->SetValue(line, path.Path.Length);
    graphLengths->SetValue(line, path.GraphLength);
    straightened->SetValue(line, path.IsStraightened ? 1 : 0);
  }
  for (int a = 0; set.CellData && a < set.CellData->GetNumberOfArrays(); ++a)
  {
    output->AddArray(PassArray(set.CellData->GetAbstractArray(a), tuples));
  }
  output->AddArray(lengths);
  output->AddArray(graphLengths);
  output->AddArray(straightened);
  output->AddArray(ids);
}
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> vtkDGGFindUnconnected(const std::vector<dgg::FoundPath>& paths)
{
  std::vector<vtkIdType> unconnected;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    if (paths[i].Path.IsEmpty())
    {
      unconnected.push_back(static_cast<vtkIdType>(i));
    }
  }
  return unconnected;
}

//------------------------------------------------------------------------------
void vtkDGGWritePaths(
  const vtkDGGPathSet& set, const vtkDGGNewGeometry& geometry, vtkPolyData* output)
{
  geometry.Begin(output);
  const auto status =
    vtkDGGAddArray<vtkIntArray>(output->GetFieldData(), "PathStatus", set.Paths.size());
  std::vector<vtkIdType> pairs;
  vtkIdType size = 0;
  for (std::size_t i = 0; i < set.Paths.size(); ++i)
  {
    const dgg::SurfacePath& path = set.Paths[i].Path;
    status->SetValue(static_cast<vtkIdType>(i), path.IsEmpty() ? NotConnected : HasPath);
    if (!path.IsEmpty())
    {
      pairs.push_back(static_cast<vtkIdType>(i));
      size += static_cast<vtkIdType>(path.Points.size());
    }
  }
  vtkDGGPolylineWriter writer(geometry, size);
  for (const vtkIdType pair : pairs)
  {
    writer.Add(set.Paths[pair].Path);
  }
  writer.AddTo(output);
  AddCellData(set, pairs, output->GetCellData());
}
