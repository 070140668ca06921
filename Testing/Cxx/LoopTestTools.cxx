// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoopTestTools.h"

#include "TestMeshes.h"

namespace dggtest
{
namespace
{
const double Pi = vtkMath::Pi();

LoopLine ReadLoop(vtkPolyData* output, vtkIdType line)
{
  LoopLine loop;
  ReadPolyline(output, line, loop.Line);
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  output->GetLines()->GetCellAtId(line, size, ids);
  loop.IsClosed = size > 2 && ids[0] == ids[size - 1];
  EXPECT_EQ(std::count(ids + 1, ids + size - 1, ids[0]), 0);
  if (loop.IsClosed)
  {
    loop.Line.ArcLengths.back() = loop.Line.Length;
  }
  loop.Loop =
    static_cast<vtkIdType>(output->GetCellData()->GetArray("LoopId")->GetComponent(line, 0));
  return loop;
}
}

vtkSmartPointer<vtkPolyData> MakePrism(int sides, int rows)
{
  return MakeSurface(PrismSide(sides, 1, rows));
}

vtkSmartPointer<vtkPolyData> MakeTorus(int nu, int nv)
{
  return MakeSurface(Torus(nu, nv));
}

double GetTubeLength(int nu, int nv)
{
  // Halfway between two rows of points, where the tube is narrowest.
  double length = 0.0;
  for (int j = 0; j < nv; ++j)
  {
    const double a = 2.0 * Pi * j / nv;
    const double b = 2.0 * Pi * (j + 1) / nv;
    length +=
      0.4 * std::hypot((std::cos(b) - std::cos(a)) * std::cos(Pi / nu), std::sin(b) - std::sin(a));
  }
  return length;
}

double GetHoleLength(int nu)
{
  return nu * 2.0 * 0.6 * std::sin(Pi / nu);
}

bool LoopLine::operator==(const LoopLine& other) const
{
  return this->Line == other.Line && this->IsClosed == other.IsClosed && this->Loop == other.Loop &&
    this->Angle == other.Angle && this->Kinked == other.Kinked;
}

std::vector<LoopLine> GetLoops(vtkDGGLoop* filter)
{
  vtkPolyData* output = filter->GetOutput();
  std::vector<LoopLine> loops;
  if (!HasPolylines(output, { "Length", "LoopId", "Angle", "Kinked" }))
  {
    ADD_FAILURE() << "no polylines";
    return loops;
  }
  for (vtkIdType line = 0; line < output->GetNumberOfCells(); ++line)
  {
    LoopLine loop = ReadLoop(output, line);
    EXPECT_TRUE(loop.IsClosed);
    loop.Angle = output->GetCellData()->GetArray("Angle")->GetComponent(line, 0);
    loop.Kinked =
      static_cast<int>(output->GetCellData()->GetArray("Kinked")->GetComponent(line, 0));
    loops.push_back(loop);
  }
  return loops;
}

std::vector<LoopLine> GetRims(vtkDGGLoop* filter)
{
  vtkPolyData* output = filter->GetTape();
  std::vector<LoopLine> rims;
  if (!HasPolylines(output, { "Length", "LoopId" }))
  {
    ADD_FAILURE() << "no polylines";
    return rims;
  }
  for (vtkIdType line = 0; line < output->GetNumberOfCells(); ++line)
  {
    rims.push_back(ReadLoop(output, line));
  }
  return rims;
}

std::vector<int> GetLoopStatus(vtkDGGLoop* filter)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray("LoopStatus");
  std::vector<int> values;
  if (!array)
  {
    ADD_FAILURE() << "field data LoopStatus";
    return values;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(static_cast<int>(array->GetComponent(i, 0)));
  }
  return values;
}
}
