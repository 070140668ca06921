// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceOutput.h"

#include "dggCellCoordinates.h"
#include "dggPreparedSurface.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

namespace dgg
{
namespace
{
using Triple = std::array<double, 3>;

void Copy(const Triple& from, double* to)
{
  std::copy(from.begin(), from.end(), to);
}

/// Writes points of an output: position, cell, id and coordinates in the input.
class PointWriter
{
public:
  /// `areIdsFirst` chooses the order of the arrays.
  PointWriter(const TaskContext& context, std::size_t size, bool areIdsFirst, Output& output)
    : Surface(context.Surface)
  {
    output.Points = Buffer<double>(3 * size);
    this->Positions = output.Points.Data();
    if (areIdsFirst)
    {
      this->Points = output.PointData.Add<Offset>("vtkOriginalPointIds", size);
    }
    this->Cells = output.PointData.Add<Offset>("FaceId", size);
    if (!this->Surface.IsCloud() && CellCoordinates::AreAllTriangles(context.GetCells()))
    {
      this->Coordinates.emplace(context.GetCells(), this->Surface);
      this->Barycentric = output.PointData.Add<double>("Barycentric", size, 3);
    }
    if (!areIdsFirst)
    {
      this->Points = output.PointData.Add<Offset>("vtkOriginalPointIds", size);
    }
  }

  /// Writes point i of the output, which is in or around `face`.
  void Write(std::size_t i, const SurfacePoint& point, Id face)
  {
    Copy(PositionOf(this->Surface.GetMesh(), point, this->Surface.GetPositions()),
      this->Positions + 3 * i);
    this->Points[i] = GetOriginalPoint(point);
    this->Cells[i] = GetOriginalCell(this->Surface, face);
    if (this->Coordinates)
    {
      Copy(
        face == NoId ? Triple{ { 0.0, 0.0, 0.0 } } : this->Coordinates->GetCoordinates(point, face),
        this->Barycentric + 3 * i);
    }
  }

private:
  const PreparedSurface& Surface;
  std::optional<CellCoordinates> Coordinates;
  double* Positions;
  Offset* Points = nullptr;
  Offset* Cells;
  double* Barycentric = nullptr;
};

/// Returns the number of points of a curve in the output.
std::size_t CountPoints(const OutputCurve& curve)
{
  return curve.Path->Points.size() - (curve.IsClosed ? 1 : 0);
}

/// Returns the number of point ids of the line of a curve.
std::size_t CountIds(const OutputCurve& curve)
{
  return std::max<std::size_t>(2, curve.Path->Points.size());
}

/// Returns the face of a segment; for the last point, the face of the last segment.
Id GetFace(const SurfaceMesh& mesh, const SurfacePath& path, std::size_t segment)
{
  return path.Faces.empty() ? FindFaceOf(mesh, path.Points[segment])
                            : path.Faces[std::min(segment, path.Faces.size() - 1)];
}

/// Returns the length of a segment; paths without faces are straight in space.
double MeasureSegment(const PreparedSurface& surface, const SurfacePath& path, std::size_t segment)
{
  const SurfaceMesh& mesh = surface.GetMesh();
  if (!path.Faces.empty())
  {
    return MeasurePiece(mesh, path, segment);
  }
  const auto p = PositionOf(mesh, path.Points[segment], surface.GetPositions());
  const auto q = PositionOf(mesh, path.Points[segment + 1], surface.GetPositions());
  return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}
}

//------------------------------------------------------------------------------
void WritePositions(
  const PreparedSurface& surface, const std::vector<SurfacePoint>& points, Output& output)
{
  output.Points = Buffer<double>(3 * points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Copy(PositionOf(surface.GetMesh(), points[i], surface.GetPositions()),
      output.Points.Data() + 3 * i);
  }
}

//------------------------------------------------------------------------------
void WriteVerts(std::size_t size, Output& output)
{
  output.Verts.Offsets = Buffer<Offset>(size + 1);
  output.Verts.Points = Buffer<Offset>(size);
  std::iota(output.Verts.Offsets.begin(), output.Verts.Offsets.end(), 0);
  std::iota(output.Verts.Points.begin(), output.Verts.Points.end(), 0);
}

//------------------------------------------------------------------------------
OutputCells MakeCellOfAllPoints(Offset numberOfPoints)
{
  OutputCells cells{ Buffer<Offset>(2), Buffer<Offset>(static_cast<std::size_t>(numberOfPoints)) };
  cells.Offsets[0] = 0;
  cells.Offsets[1] = numberOfPoints;
  std::iota(cells.Points.begin(), cells.Points.end(), 0);
  return cells;
}

//------------------------------------------------------------------------------
Offset GetOriginalPoint(const SurfacePoint& point)
{
  return IsVertex(point) ? point.Vertex : NoId;
}

//------------------------------------------------------------------------------
Offset GetOriginalCell(const PreparedSurface& surface, Id face)
{
  return face == NoId ? NoId : surface.GetCell(face);
}

//------------------------------------------------------------------------------
void WriteSurfacePoints(
  const TaskContext& context, const std::vector<SurfacePoint>& points, Output& output)
{
  WriteVerts(points.size(), output);
  PointWriter writer(context, points.size(), true, output);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    writer.Write(i, points[i], FindFaceOf(context.Surface.GetMesh(), points[i]));
  }
}

//------------------------------------------------------------------------------
const double* WriteCurves(
  const TaskContext& context, const std::vector<OutputCurve>& curves, Output& output)
{
  std::size_t numberOfPoints = 0;
  std::size_t numberOfIds = 0;
  for (const OutputCurve& curve : curves)
  {
    numberOfPoints += CountPoints(curve);
    numberOfIds += CountIds(curve);
  }
  output.Lines.Offsets = Buffer<Offset>(curves.size() + 1);
  output.Lines.Points = Buffer<Offset>(numberOfIds);
  PointWriter writer(context, numberOfPoints, false, output);
  double* const arcLengths = output.PointData.Add<double>("ArcLength", numberOfPoints);

  std::size_t first = 0; // index of the first point of the curve
  Offset* ids = output.Lines.Points.Data();
  output.Lines.Offsets[0] = 0;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const SurfacePath& path = *curves[c].Path;
    const std::size_t count = CountPoints(curves[c]);
    double arcLength = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      arcLength += i > 0 ? MeasureSegment(context.Surface, path, i - 1) : 0.0;
      arcLengths[first + i] = arcLength;
      writer.Write(first + i, path.Points[i], GetFace(context.Surface.GetMesh(), path, i));
      *ids++ = static_cast<Offset>(first + i);
    }
    if (CountIds(curves[c]) > count)
    {
      *ids++ = static_cast<Offset>(first);
    }
    output.Lines.Offsets[c + 1] = ids - output.Lines.Points.Data();
    first += count;
  }
  return arcLengths;
}
}
