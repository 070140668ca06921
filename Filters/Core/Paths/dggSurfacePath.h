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
/// A polyline on a surface: every segment between two consecutive points is straight and lies in
/// one face or on an edge of it. Points are vertices, crossings of edges, or, at the ends of a
/// path, any surface points.
struct DGG_CORE_EXPORT SurfacePath
{
  /// From start to end. A single point if start and end coincide, none if there is no path. A
  /// closed path (a loop) repeats its first point at the end.
  std::vector<SurfacePoint> Points;
  /// Per segment, the face that contains it; one less than points.
  std::vector<Id> Faces;
  double Length = 0.0; ///< sum of the lengths of the segments

  bool IsEmpty() const { return this->Points.empty(); }
  void Clear();
  /// Appends a point and the segment that leads to it in a face; the first point has no segment.
  /// Returns the length of the segment.
  double Append(const SurfaceMesh& mesh, const SurfacePoint& point, Id face);
};

/// Computes the barycentric coordinates of a point in one of its faces, with respect to the corners
/// of SurfaceMesh::GetTriangle(). Returns false if the point does not lie in that face.
DGG_CORE_EXPORT bool FindInFace(
  const SurfaceMesh& mesh, const SurfacePoint& point, Id face, std::array<double, 3>& barycentric);

/// Returns a face that contains the point, also for points at vertices; NoId at isolated vertices.
DGG_CORE_EXPORT Id FindFaceOf(const SurfaceMesh& mesh, const SurfacePoint& point);

/// Returns the length of a segment, measured within its face; NaN if the segment does not lie in
/// the face.
DGG_CORE_EXPORT double MeasurePiece(
  const SurfaceMesh& mesh, const SurfacePath& path, std::size_t piece);

/// Fails if a segment of the path does not lie in its face, or the length differs from the sum of
/// the segments by more than 1e-9 (relative).
DGG_CORE_EXPORT Status CheckPath(const SurfaceMesh& mesh, const SurfacePath& path);

/// Fails if a face contains a vertex twice, as SurfaceMesh::FromGluedLengths() allows: a point at
/// that vertex would have two positions in the face, and paths require a unique one.
DGG_CORE_EXPORT Status CheckCorners(const SurfaceMesh& mesh);

/// Returns the position in space, given the vertex positions (x y z each).
DGG_CORE_EXPORT std::array<double, 3> PositionOf(
  const SurfaceMesh& mesh, const SurfacePoint& point, const double* positions);
}

#endif
