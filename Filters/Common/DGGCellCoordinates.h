// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Barycentric coordinates in the triangles of an input. Internal.
#ifndef DGGCellCoordinates_h
#define DGGCellCoordinates_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggBarycentric.h"            // for TriangleCorners
#include "dggSurfacePoint.h"           // for SurfacePoint

#include "vtkIdList.h" // for the workspace
#include "vtkNew.h"    // for vtkNew
#include "vtkType.h"   // for vtkIdType

#include <array>  // for the coordinates
#include <string> // for messages

namespace dgg
{
class PreparedSurface;
}
class vtkPolyData;

/// Converts between points of a prepared mesh and pairs of a cell of the input and barycentric
/// coordinates with respect to the corners of the cell, in their order. The prepared mesh may have
/// merged corners, or split the cell. Both arguments of the constructor must outlive this object.
class VTKDGGFILTERSCOMMON_EXPORT DGGCellCoordinates
{
public:
  using Coordinates = std::array<double, 3>;

  DGGCellCoordinates(vtkPolyData* input, const dgg::PreparedSurface& mesh);

  /// Returns true if all polygons of the input are triangles and there are no strips.
  static bool AreAllTriangles(vtkPolyData* input);

  /// Returns a predicate that completes "<point> ..." and describes the error; empty if the pair is
  /// valid.
  std::string Check(double cell, const Coordinates& coordinates) const;

  /// Position in space of a pair that Check() accepts.
  Coordinates GetPosition(vtkIdType cell, const Coordinates& coordinates) const;

  /// Returns true if a pair that Check() accepts is at a position, up to the distances by which
  /// corners were merged and to `rounding` times the largest coordinate of a corner.
  bool IsAt(vtkIdType cell, const Coordinates& coordinates, const double position[3],
    double rounding) const;

  /// Finds the point of the mesh for a pair that Check() accepts. Returns false if the mesh has no
  /// face for the cell, because the cell has no area.
  bool FindPoint(vtkIdType cell, const Coordinates& coordinates, dgg::SurfacePoint& point) const;

  /// Coordinates in the cell of a face, which is a triangle, of a point in or around the face.
  Coordinates GetCoordinates(const dgg::SurfacePoint& point, dgg::Id face) const;

private:
  using Corners = std::array<vtkIdType, 3>;

  Corners GetCorners(vtkIdType cell) const;
  /// Returns the coordinates of the corners of a face with respect to a cell with these corners.
  dgg::TriangleCorners GetPart(const Corners& corners, dgg::Id face) const;
  /// Returns the positions in space of these points.
  dgg::TriangleCorners GetPositions(const Corners& corners) const;

  vtkPolyData* Input;
  const dgg::PreparedSurface& Mesh;
  vtkIdType FirstPolygon;
  vtkNew<vtkIdList> Cell; // workspace
};

#endif
