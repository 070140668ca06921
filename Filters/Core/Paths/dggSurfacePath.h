// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A polyline that lies on a surface.
#ifndef dggSurfacePath_h
#define dggSurfacePath_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the points

namespace dgg
{
/// A polyline on a surface: every piece, between two consecutive points, is straight and lies in
/// one face, or on an edge of it. Points are vertices, on edges that are crossed, or, at the ends
/// of a path, anywhere.
struct DGG_CORE_EXPORT SurfacePath
{
  /// From start to end. One point when start and end coincide, none when there is no path. A closed
  /// path (a loop) ends with the point that it starts with.
  std::vector<SurfacePoint> Points;
  /// Per piece, the face that it lies in; one less than points.
  std::vector<Id> Faces;
  double Length = 0.0; ///< sum of the lengths of the pieces

  bool IsEmpty() const { return this->Points.empty(); }
  void Clear();
  /// Appends a point and the piece that leads to the point in a face; the first point has no piece.
  /// Returns the length of the piece.
  double Append(const SurfaceMesh& mesh, const SurfacePoint& point, Id face);
};

/// Coordinates of a point in one of the faces that it lies in, with respect to the corners of
/// SurfaceMesh::GetTriangle(). False when it does not lie in that face.
DGG_CORE_EXPORT bool FindInFace(
  const SurfaceMesh& mesh, const SurfacePoint& point, Id face, std::array<double, 3>& barycentric);

/// A face that contains the point, for points at vertices as well; NoId at isolated vertices.
DGG_CORE_EXPORT Id FindFaceOf(const SurfaceMesh& mesh, const SurfacePoint& point);

/// Length of a piece, measured within its face. NaN when it does not lie there.
DGG_CORE_EXPORT double MeasurePiece(
  const SurfaceMesh& mesh, const SurfacePath& path, std::size_t piece);

/// Fails with a message when a piece of the path does not lie in its face, or the length is not
/// that of its pieces to 1e-9.
DGG_CORE_EXPORT Status CheckPath(const SurfaceMesh& mesh, const SurfacePath& path);

/// Fails when a face names a vertex twice, as SurfaceMesh::FromGluedLengths() allows: a point at
/// that vertex would be in two places of the face, and paths need one.
DGG_CORE_EXPORT Status CheckCorners(const SurfaceMesh& mesh);

/// Position in space, given those of the vertices (x y z each).
DGG_CORE_EXPORT std::array<double, 3> PositionOf(
  const SurfaceMesh& mesh, const SurfacePoint& point, const double* positions);
}

#endif
