// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Barycentric coordinates in the triangles of an input. Internal.
#ifndef dggCellCoordinates_h
#define dggCellCoordinates_h

#include "dggBarycentric.h"     // for TriangleCorners
#include "dggPreparedSurface.h" // for SurfaceArrays
#include "dggSurfacePoint.h"    // for SurfacePoint

#include <array> // for the coordinates

namespace dgg
{
/// Converts between points of a prepared surface and pairs of a cell of the input and barycentric
/// coordinates with respect to the corners of the cell, in their order. The surface may have merged
/// corners, or split the cell.
class DGG_CORE_EXPORT CellCoordinates
{
public:
  using Coordinates = std::array<double, 3>;

  /// Uses the cells of `input`, but not its points. The arrays and the surface must outlive this
  /// object.
  CellCoordinates(const SurfaceArrays& input, const PreparedSurface& surface)
    : Input(input)
    , Surface(surface)
  {
  }

  /// Returns true if all polygons of the input are triangles and there are no strips.
  static bool AreAllTriangles(const SurfaceArrays& input);

  /// Checks a pair of a cell id and coordinates in the cell.
  Status Check(double cell, const Coordinates& coordinates) const;

  /// Returns the position in space of a pair that Check() accepts.
  Coordinates GetPosition(Offset cell, const Coordinates& coordinates) const;

  /// Returns true if a pair that Check() accepts is at a position, up to the distances by which
  /// corners were merged and to `rounding` times the largest coordinate of a corner.
  bool IsAt(Offset cell, const Coordinates& coordinates, const Coordinates& position,
    double rounding) const;

  /// Finds the surface point of a pair that Check() accepts. Returns false if the surface has no
  /// face for the cell, because the cell has no area.
  bool FindPoint(Offset cell, const Coordinates& coordinates, SurfacePoint& point) const;

  /// Returns the coordinates in the cell of a face, a triangle, of a point in or around the face.
  Coordinates GetCoordinates(const SurfacePoint& point, Id face) const;

private:
  using Corners = std::array<Offset, 3>;

  Corners GetCorners(Offset cell) const;
  /// Returns the coordinates of the corners of a face with respect to a cell with these corners.
  TriangleCorners GetPart(const Corners& corners, Id face) const;
  /// Returns the positions in space of these points.
  TriangleCorners GetPositions(const Corners& corners) const;

  const SurfaceArrays& Input;
  const PreparedSurface& Surface;
};
}

#endif
