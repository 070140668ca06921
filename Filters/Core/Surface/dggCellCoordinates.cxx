// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCellCoordinates.h"

#include "dggCounted.h"
#include "dggStatus.h"
#include "dggSurfacePath.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
//------------------------------------------------------------------------------
bool CellCoordinates::AreAllTriangles(const SurfaceArrays& input)
{
  const CellArrays& cells = input.Polygons;
  bool areTriangles = input.Strips.NumberOfCells == 0;
  for (Offset i = 0; areTriangles && i < cells.NumberOfCells; ++i)
  {
    areTriangles = cells.Offsets[i + 1] - cells.Offsets[i] == 3;
  }
  return areTriangles;
}

//------------------------------------------------------------------------------
Status CellCoordinates::Check(double cell, const Coordinates& coordinates) const
{
  if (this->Surface.IsCloud())
  {
    return InvalidInput("FaceId and Barycentric do not apply to a point cloud")
      .Fix("Remove these arrays");
  }
  const Offset polygons = this->Input.Polygons.NumberOfCells;
  const Offset count = this->Input.FirstCell + polygons + this->Input.Strips.NumberOfCells;
  if (cell != std::floor(cell))
  {
    return InvalidInput("FaceId ", cell, " is not an integer").Fix("Correct the array FaceId");
  }
  if (!(cell >= 0.0 && cell < static_cast<double>(count)))
  {
    return InvalidInput("FaceId ", cell, " is out of range: the input has ", Counted(count, "cell"))
      .Fix("Correct the array FaceId");
  }
  const Offset polygon = static_cast<Offset>(cell) - this->Input.FirstCell;
  const Offset* offsets = this->Input.Polygons.Offsets;
  if (polygon < 0 || polygon >= polygons || offsets[polygon + 1] - offsets[polygon] != 3)
  {
    return InvalidInput("FaceId ", cell, " is not a triangle")
      .Fix("Triangulate the surface, or remove the array Barycentric");
  }
  if (!AreBarycentric(coordinates))
  {
    return InvalidInput("The coordinates Barycentric are (", coordinates[0], ", ", coordinates[1],
      ", ", coordinates[2], ")")
      .Fix("Use non-negative numbers with the sum 1");
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
CellCoordinates::Coordinates CellCoordinates::GetPosition(
  Offset cell, const Coordinates& coordinates) const
{
  return ConvertFromPart(this->GetPositions(this->GetCorners(cell)), coordinates);
}

//------------------------------------------------------------------------------
bool CellCoordinates::IsAt(
  Offset cell, const Coordinates& coordinates, const Coordinates& position, double rounding) const
{
  const Corners corners = this->GetCorners(cell);
  Corners merged;
  std::transform(corners.begin(), corners.end(), merged.begin(),
    [this](Offset id) { return this->Surface.GetVertex(id); });
  const TriangleCorners positions = this->GetPositions(corners);
  const Coordinates inInput = ConvertFromPart(positions, coordinates);
  const Coordinates inMesh = ConvertFromPart(this->GetPositions(merged), coordinates);
  double largest = 0.0;
  double farthest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    farthest =
      std::max(farthest, std::abs(inInput[i] - position[i]) - std::abs(inInput[i] - inMesh[i]));
    for (const Coordinates& corner : positions)
    {
      largest = std::max(largest, std::abs(corner[i]));
    }
  }
  return farthest <= rounding * largest;
}

//------------------------------------------------------------------------------
bool CellCoordinates::FindPoint(
  Offset cell, const Coordinates& coordinates, SurfacePoint& point) const
{
  const SurfaceMesh& mesh = this->Surface.GetMeshWithoutAngles();
  const Corners corners = this->GetCorners(cell);
  double best = -Infinity;
  for (const Id part : this->Surface.GetFaces(cell))
  {
    const Id face = mesh.GetOriginal(part);
    Coordinates inPart{};
    if (ConvertToPart(this->GetPart(corners, face), coordinates, inPart) &&
      *std::min_element(inPart.begin(), inPart.end()) > best)
    {
      best = *std::min_element(inPart.begin(), inPart.end());
      point = SurfacePoint::InTriangle(mesh, face, ClampedToFace(inPart));
    }
  }
  return best > -Infinity;
}

//------------------------------------------------------------------------------
CellCoordinates::Coordinates CellCoordinates::GetCoordinates(
  const SurfacePoint& point, Id face) const
{
  Coordinates inPart{};
  FindInFace(this->Surface.GetMeshWithoutAngles(), point, face, inPart);
  return ConvertFromPart(
    this->GetPart(this->GetCorners(this->Surface.GetCell(face)), face), inPart);
}

//------------------------------------------------------------------------------
CellCoordinates::Corners CellCoordinates::GetCorners(Offset cell) const
{
  const CellArrays& cells = this->Input.Polygons;
  const Offset* ids = cells.Ids + cells.Offsets[cell - this->Input.FirstCell];
  return { { ids[0], ids[1], ids[2] } };
}

//------------------------------------------------------------------------------
TriangleCorners CellCoordinates::GetPart(const Corners& corners, Id face) const
{
  TriangleCorners part{};
  const SurfaceMesh& mesh = this->Surface.GetMeshWithoutAngles();
  const std::array<Id, 3> triangle = mesh.GetTriangle(face);
  for (int k = 0; k < 3; ++k)
  {
    const auto corner = std::find_if(corners.begin(), corners.end(),
      [&](Offset id) { return this->Surface.GetVertex(id) == triangle[k]; });
    if (corner != corners.end())
    {
      part[k] = CoordinatesOfCorner(static_cast<Id>(corner - corners.begin()));
      continue;
    }
    // The apex of a cap, at which the cell was split.
    const Coordinates apex =
      PositionOf(mesh, SurfacePoint::AtVertex(triangle[k]), this->Surface.GetPositions());
    double squaredDistance = 0.0;
    part[k] = FindClosestInTriangle(this->GetPositions(corners), apex, squaredDistance);
  }
  return part;
}

//------------------------------------------------------------------------------
TriangleCorners CellCoordinates::GetPositions(const Corners& corners) const
{
  TriangleCorners positions{};
  for (int k = 0; k < 3; ++k)
  {
    std::copy_n(this->Surface.GetPositions() + 3 * corners[k], 3, positions[k].begin());
  }
  return positions;
}
}
