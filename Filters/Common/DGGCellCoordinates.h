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

class DGGPreparedMesh;
class vtkPolyData;

/// Converts between points of a prepared mesh and pairs of a cell of the input and barycentric
/// coordinates with respect to the corners of the cell, in their order. The prepared mesh may have
/// merged corners, or split the cell. Both arguments of the constructor must outlive this object.
class VTKDGGFILTERSCOMMON_EXPORT DGGCellCoordinates
{
public:
  using Coordinates = std::array<double, 3>;

  DGGCellCoordinates(vtkPolyData* input, const DGGPreparedMesh& mesh);

  /// Returns true if all polygons of the input are triangles and there are no strips.
  static bool AreAllTriangles(vtkPolyData* input);

  /// Returns what is wrong with a pair, as the end of a sentence whose subject is the point; empty
  /// if it names a point.
  std::string Check(double cell, const Coordinates& coordinates) const;

  /// Position in space of a pair that Check() accepts.
  Coordinates GetPosition(vtkIdType cell, const Coordinates& coordinates) const;

  /// Returns true if a pair that Check() accepts is at a position, up to single precision and to
  /// the distances by which corners were merged.
  bool IsAt(vtkIdType cell, const Coordinates& coordinates, const double position[3]) const;

  /// Finds the point of the mesh for a pair that Check() accepts. Returns false if the mesh has no
  /// face for the cell, because the cell has no area.
  bool FindPoint(vtkIdType cell, const Coordinates& coordinates, dgg::SurfacePoint& point) const;

  /// Coordinates in the cell of a face, which is a triangle, of a point in or around the face.
  Coordinates GetCoordinates(const dgg::SurfacePoint& point, dgg::Id face) const;

private:
  using Corners = std::array<vtkIdType, 3>;

  Corners GetCorners(vtkIdType cell) const;
  /// Coordinates in the cell with these corners of the corners of a face.
  dgg::TriangleCorners GetPart(const Corners& corners, dgg::Id face) const;
  /// Coordinates of points.
  dgg::TriangleCorners GetPositions(const Corners& corners) const;

  vtkPolyData* Input;
  const DGGPreparedMesh& Mesh;
  vtkIdType FirstPolygon;
  vtkNew<vtkIdList> Cell; // workspace
};

#endif
