// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGCellCoordinates.h"

#include "dggPreparedSurface.h"

#include "dggInvalidInput.h"
#include "dggSurfacePath.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
DGGCellCoordinates::DGGCellCoordinates(vtkPolyData* input, const dgg::PreparedSurface& mesh)
  : Input(input)
  , Mesh(mesh)
  , FirstPolygon(input->GetNumberOfVerts() + input->GetNumberOfLines())
{
}

//------------------------------------------------------------------------------
bool DGGCellCoordinates::AreAllTriangles(vtkPolyData* input)
{
  return input->GetNumberOfStrips() == 0 &&
    (input->GetNumberOfPolys() == 0 || input->GetPolys()->IsHomogeneous() == 3);
}

//------------------------------------------------------------------------------
std::string DGGCellCoordinates::Check(double cell, const Coordinates& coordinates) const
{
  if (this->Mesh.IsCloud())
  {
    return "has FaceId and Barycentric, but the input is a point cloud. Remove these arrays.";
  }
  const vtkIdType count = this->Input->GetNumberOfCells();
  if (cell != std::floor(cell))
  {
    return dgg::JoinText(
      "has FaceId ", cell, ", which is not an integer. Correct the array FaceId.");
  }
  if (!(cell >= 0.0 && cell < static_cast<double>(count)))
  {
    return dgg::JoinText(
      "has FaceId ", cell, ", which is out of range: the input has ", count, " cells.");
  }
  const vtkIdType polygon = static_cast<vtkIdType>(cell) - this->FirstPolygon;
  if (polygon < 0 || polygon >= this->Input->GetNumberOfPolys() ||
    this->Input->GetPolys()->GetCellSize(polygon) != 3)
  {
    return dgg::JoinText("has FaceId ", cell,
      ", which is not a triangle. Triangulate the surface, or remove the array Barycentric.");
  }
  if (!dgg::AreBarycentric(coordinates))
  {
    return dgg::JoinText("has the Barycentric coordinates (", coordinates[0], ", ", coordinates[1],
      ", ", coordinates[2], "): they must be finite, not negative, and sum to 1");
  }
  return {};
}

//------------------------------------------------------------------------------
DGGCellCoordinates::Coordinates DGGCellCoordinates::GetPosition(
  vtkIdType cell, const Coordinates& coordinates) const
{
  return dgg::ConvertFromPart(this->GetPositions(this->GetCorners(cell)), coordinates);
}

//------------------------------------------------------------------------------
bool DGGCellCoordinates::IsAt(
  vtkIdType cell, const Coordinates& coordinates, const double position[3], double rounding) const
{
  const Corners corners = this->GetCorners(cell);
  Corners merged;
  std::transform(corners.begin(), corners.end(), merged.begin(),
    [this](vtkIdType id) { return this->Mesh.GetVertex(id); });
  const dgg::TriangleCorners positions = this->GetPositions(corners);
  const Coordinates inInput = dgg::ConvertFromPart(positions, coordinates);
  const Coordinates inMesh = dgg::ConvertFromPart(this->GetPositions(merged), coordinates);
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
bool DGGCellCoordinates::FindPoint(
  vtkIdType cell, const Coordinates& coordinates, dgg::SurfacePoint& point) const
{
  const dgg::SurfaceMesh& mesh = this->Mesh.GetMeshWithoutAngles();
  const Corners corners = this->GetCorners(cell);
  double best = -dgg::Infinity;
  for (const dgg::Id part : this->Mesh.GetFaces(cell))
  {
    const dgg::Id face = mesh.GetOriginal(part);
    Coordinates inPart{};
    if (dgg::ConvertToPart(this->GetPart(corners, face), coordinates, inPart) &&
      *std::min_element(inPart.begin(), inPart.end()) > best)
    {
      best = *std::min_element(inPart.begin(), inPart.end());
      point = dgg::SurfacePoint::InTriangle(mesh, face, dgg::ClampedToFace(inPart));
    }
  }
  return best > -dgg::Infinity;
}

//------------------------------------------------------------------------------
DGGCellCoordinates::Coordinates DGGCellCoordinates::GetCoordinates(
  const dgg::SurfacePoint& point, dgg::Id face) const
{
  Coordinates inPart{};
  dgg::FindInFace(this->Mesh.GetMeshWithoutAngles(), point, face, inPart);
  return dgg::ConvertFromPart(
    this->GetPart(this->GetCorners(this->Mesh.GetCell(face)), face), inPart);
}

//------------------------------------------------------------------------------
DGGCellCoordinates::Corners DGGCellCoordinates::GetCorners(vtkIdType cell) const
{
  // A copy of the ids is safe while other threads read cells; the pointer version is not.
  this->Input->GetPolys()->GetCellAtId(cell - this->FirstPolygon, this->Cell);
  return { { this->Cell->GetId(0), this->Cell->GetId(1), this->Cell->GetId(2) } };
}

//------------------------------------------------------------------------------
dgg::TriangleCorners DGGCellCoordinates::GetPart(const Corners& corners, dgg::Id face) const
{
  dgg::TriangleCorners part{};
  const std::array<dgg::Id, 3> triangle = this->Mesh.GetMeshWithoutAngles().GetTriangle(face);
  for (int k = 0; k < 3; ++k)
  {
    const auto corner = std::find_if(corners.begin(), corners.end(),
      [&](vtkIdType id) { return this->Mesh.GetVertex(id) == triangle[k]; });
    if (corner != corners.end())
    {
      part[k] = dgg::CoordinatesOfCorner(static_cast<dgg::Id>(corner - corners.begin()));
      continue;
    }
    // The apex of a cap, at which the cell was split.
    Coordinates apex{};
    this->Input->GetPoint(triangle[k], apex.data());
    double squaredDistance = 0.0;
    part[k] = dgg::FindClosestInTriangle(this->GetPositions(corners), apex, squaredDistance);
  }
  return part;
}

//------------------------------------------------------------------------------
dgg::TriangleCorners DGGCellCoordinates::GetPositions(const Corners& corners) const
{
  dgg::TriangleCorners positions{};
  for (int k = 0; k < 3; ++k)
  {
    this->Input->GetPoint(corners[k], positions[k].data());
  }
  return positions;
}
