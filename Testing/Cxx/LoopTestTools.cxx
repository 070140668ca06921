// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoopTestTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
/// Tolerance of cosines of angles between segments that are long enough to define an angle.
constexpr double AngleTolerance = 1e-6;
/// Tolerance at the start of a loop; smaller kinks count as straight (vtkDGGLoop).
constexpr double KinkTolerance = 1e-5;
constexpr double ShortestPiece = 1e-5; // relative to the diagonal

const double Pi = vtkMath::Pi();

/// Adds rows of `columns` squares that form a closed ring. Each square is split into two triangles.
void AddBand(Cells& cells, vtkIdType first, vtkIdType columns, vtkIdType rows, bool closes)
{
  for (vtkIdType j = 0; j < rows; ++j)
  {
    for (vtkIdType i = 0; i < columns; ++i)
    {
      const vtkIdType right = (i + 1) % columns;
      const vtkIdType a = first + j * columns;
      const vtkIdType b = first + (closes ? (j + 1) % rows : j + 1) * columns;
      cells.push_back({ a + i, a + right, b + right });
      cells.push_back({ a + i, b + right, b + i });
    }
  }
}

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

/// Finds the ends of the common edge of two triangles. Returns false if there is none.
bool FindEdge(vtkPolyData* surface, vtkIdType a, vtkIdType b, std::array<double, 3> ends[2])
{
  vtkNew<vtkIdList> first;
  vtkNew<vtkIdList> second;
  surface->GetCellPoints(a, first);
  surface->GetCellPoints(b, second);
  first->IntersectWith(second);
  for (vtkIdType i = 0; i < 2 && first->GetNumberOfIds() == 2; ++i)
  {
    surface->GetPoint(first->GetId(i), ends[i].data());
  }
  return first->GetNumberOfIds() == 2;
}

std::array<double, 3> Direction(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
  std::array<double, 3> d{ { to[0] - from[0], to[1] - from[1], to[2] - from[2] } };
  vtkMath::Normalize(d.data());
  return d;
}
}

vtkSmartPointer<vtkPolyData> MakePrism(int sides, int rows)
{
  Points points;
  const double radius = 0.5 / std::sin(Pi / sides);
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * Pi * i / sides;
      points.push_back(
        { { radius * std::cos(angle), radius * std::sin(angle), static_cast<double>(j) } });
    }
  }
  Cells cells;
  AddBand(cells, 0, sides, rows, false);
  return MakeSurface(points, cells);
}

vtkSmartPointer<vtkPolyData> MakeTorus(int nu, int nv)
{
  Points points;
  for (int j = 0; j < nv; ++j)
  {
    for (int i = 0; i < nu; ++i)
    {
      const double u = 2.0 * Pi * i / nu;
      const double v = 2.0 * Pi * j / nv;
      const double r = 1.0 + 0.4 * std::cos(v);
      points.push_back({ { r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v) } });
    }
  }
  Cells cells;
  AddBand(cells, 0, nu, nv, true);
  return MakeSurface(points, cells);
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

void ExpectStraight(const LoopLine& loop, vtkPolyData* surface, bool isSmoothAtStart)
{
  const PathLine& line = loop.Line;
  const std::size_t pieces = line.Positions.size() - 1;
  const double shortest = ShortestPiece * surface->GetLength();
  std::size_t checked = 0;
  for (std::size_t i = isSmoothAtStart ? 0 : 1; i < pieces; ++i)
  {
    const std::size_t before = i > 0 ? i - 1 : pieces - 1;
    const double lengths[2] = { line.ArcLengths[before + 1] - line.ArcLengths[before],
      line.ArcLengths[i + 1] - line.ArcLengths[i] };
    if (line.PointIds[i] >= 0 || std::min(lengths[0], lengths[1]) < shortest)
    {
      continue;
    }
    const auto in = Direction(line.Positions[before], line.Positions[i]);
    const auto out = Direction(line.Positions[i], line.Positions[i + 1]);
    std::array<double, 3> ends[2];
    const double tolerance = i > 0 ? AngleTolerance : KinkTolerance;
    if (line.Faces[before] == line.Faces[i])
    {
      EXPECT_NEAR(vtkMath::Dot(in.data(), out.data()), 1.0, tolerance) << i;
    }
    else if (FindEdge(surface, line.Faces[before], line.Faces[i], ends))
    {
      const auto edge = Direction(ends[0], ends[1]);
      EXPECT_NEAR(
        vtkMath::Dot(in.data(), edge.data()), vtkMath::Dot(out.data(), edge.data()), tolerance)
        << i;
    }
    else
    {
      ADD_FAILURE() << "faces " << line.Faces[before] << " and " << line.Faces[i];
    }
    ++checked;
  }
  const auto corners =
    std::count_if(line.PointIds.begin(), line.PointIds.end(), [](vtkIdType id) { return id >= 0; });
  EXPECT_GT(checked + static_cast<std::size_t>(corners), 0u);
}
}
