// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGLoopOutput.h"

#include "vtkDGGLoopSearch.h"
#include "vtkDGGMakeArray.h"
#include "vtkDGGNewGeometry.h"
#include "vtkDGGPolylineWriter.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"

#include <cstddef>

namespace
{
/// A curve that goes into an output.
struct Curve
{
  const dgg::SurfacePath* Path;
  bool IsClosed;
  vtkIdType Loop;
};

/// Rims that close do so in the very same point.
bool IsClosed(const dgg::SurfacePath& rim)
{
  return rim.Points.size() > 2 && dgg::IsSamePoint(rim.Points.front(), rim.Points.back());
}

/// Field data, polylines, Length and LoopId.
void WriteCurves(
  const std::vector<Curve>& curves, const vtkDGGNewGeometry& geometry, vtkPolyData* output)
{
  geometry.Begin(output);
  const auto count = static_cast<vtkIdType>(curves.size());
  vtkIdType size = 0;
  for (const Curve& curve : curves)
  {
    size += vtkDGGPolylineWriter::CountPoints(*curve.Path, curve.IsClosed);
  }
  auto lengths = vtkDGGMakeArray<vtkDoubleArray>("Length", count);
  auto ids = vtkDGGMakeArray<vtkIdTypeArray>("LoopId", count);
  vtkDGGPolylineWriter writer(geometry, size);
  for (vtkIdType i = 0; i < count; ++i)
  {
    writer.Add(*curves[i].Path, curves[i].IsClosed);
    lengths->SetValue(i, curves[i].Path->Length);
    ids->SetValue(i, curves[i].Loop);
  }
  writer.AddTo(output);
  output->GetCellData()->AddArray(lengths);
  output->GetCellData()->AddArray(ids);
}
}

//------------------------------------------------------------------------------
void vtkDGGWriteLoops(
  const vtkDGGLoopSet& set, const vtkDGGNewGeometry& geometry, vtkPolyData* output)
{
  std::vector<Curve> curves;
  auto status =
    vtkDGGMakeArray<vtkIntArray>("LoopStatus", static_cast<vtkIdType>(set.Loops.size()));
  for (std::size_t i = 0; i < set.Loops.size(); ++i)
  {
    const auto loop = static_cast<vtkIdType>(i);
    status->SetValue(loop, static_cast<int>(set.Status[i]));
    if (!set.Loops[i].Loop.IsEmpty())
    {
      curves.push_back({ &set.Loops[i].Loop, true, loop });
    }
  }
  WriteCurves(curves, geometry, output);
  const auto count = static_cast<vtkIdType>(curves.size());
  auto angles = vtkDGGMakeArray<vtkDoubleArray>("Angle", count);
  auto kinked = vtkDGGMakeArray<vtkIntArray>("Kinked", count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const dgg::FoundLoop& loop = set.Loops[curves[i].Loop];
    angles->SetValue(i, loop.Angle);
    kinked->SetValue(i, loop.IsKinked() ? 1 : 0);
  }
  output->GetCellData()->AddArray(angles);
  output->GetCellData()->AddArray(kinked);
  output->GetFieldData()->AddArray(status);
}

//------------------------------------------------------------------------------
void vtkDGGWriteTapes(
  const vtkDGGLoopSet& set, const vtkDGGNewGeometry& geometry, vtkPolyData* output)
{
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < set.Rims.size(); ++i)
  {
    for (const dgg::SurfacePath& rim : set.Rims[i])
    {
      curves.push_back({ &rim, IsClosed(rim), static_cast<vtkIdType>(i) });
    }
  }
  WriteCurves(curves, geometry, output);
}
