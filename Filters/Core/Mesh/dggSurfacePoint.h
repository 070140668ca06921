// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A point anywhere on a mesh: at a vertex, on an edge or inside a face. Also represents a point of
/// a cloud, or a point close to a cloud point.
#ifndef dggSurfacePoint_h
#define dggSurfacePoint_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggEdges.h"       // for ForEachFaceBehind
#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <array> // for Barycentric

namespace dgg
{
/// A point of the surface. The support of the point (vertex, edge or face) is determined once, by
/// Snap(). Barycentric coordinates within 1e-9 of a vertex or an edge are snapped, which avoids
/// needle triangles at a metric perturbation of at most 1e-9 edge lengths.
struct DGG_CORE_EXPORT SurfacePoint
{
  enum class Support : std::uint8_t
  {
    Vertex, ///< Vertex is set; Face may be NoId
    Edge,   ///< HalfEdge is set, and Barycentric in its face
    Face,   ///< Face and Barycentric are set
    Near    ///< close to a point of a cloud: Vertex is set, and Barycentric is the offset from it
  };

  Support On = Support::Vertex;
  Id Vertex = NoId;
  Id HalfEdge = NoId;
  Id Face = NoId;
  /// Coordinates with respect to the corners of SurfaceMesh::GetTriangle(Face); non-negative, sum
  /// 1. For a point near a vertex, the vector in space from the vertex to the point.
  std::array<double, 3> Barycentric{ { 1.0, 0.0, 0.0 } };

  static SurfacePoint AtVertex(Id vertex);
  /// Returns the point in space at an offset from a cloud point; the cloud point itself if the
  /// offset is zero. Not used on meshes.
  static SurfacePoint NearVertex(Id vertex, const std::array<double, 3>& offset);
  /// Returns the point at the given coordinates of a face, snapped. The coordinates refer to the
  /// corners of the face *in the order of the input*, so that callers need not consider re-oriented
  /// faces.
  static SurfacePoint InFace(
    const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric);
  /// Returns the same point as InFace(), but coordinates refer to the corners of
  /// SurfaceMesh::GetTriangle().
  static SurfacePoint InTriangle(
    const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric);
  /// Returns the point at parameter t in [0, 1] from Origin(h) to Destination(h), snapped.
  static SurfacePoint OnEdge(const SurfaceMesh& mesh, Id halfEdge, double t);
  /// Returns the same point as OnEdge(), without snapping. t must be strictly between 0 and 1.
  static SurfacePoint InsideEdge(Id halfEdge, double t);

  /// Fails if the point does not exist on the mesh.
  Status Check(const SurfaceMesh& mesh) const;
};

/// Returns true if a point is at a vertex.
inline bool IsVertex(const SurfacePoint& point)
{
  return point.On == SurfacePoint::Support::Vertex;
}

/// Returns true if two points have the same representation. A point on an edge differs from the
/// same point given in another face of the edge.
DGG_CORE_EXPORT bool IsSamePoint(const SurfacePoint& a, const SurfacePoint& b);

/// Returns the factor that scales the total angle at a point to 2 pi. The factor is 1 except at
/// interior vertices.
DGG_CORE_EXPORT double UnrollFactor(const SurfaceMesh& mesh, const SurfacePoint& point);

/// Returns the position of a point, given by barycentric coordinates in the face of half-edge h, in
/// the frame of h.
DGG_CORE_EXPORT Point2 PlaceInFrame(
  const SurfaceMesh& mesh, Id h, const std::array<double, 3>& barycentric);
/// Returns a direction given in the frame of half-edge `from` in the frame of half-edge `to` of the
/// same face.
DGG_CORE_EXPORT Point2 DirectionInFrame(
  const SurfaceMesh& mesh, Id from, Id to, const Point2& direction);
/// Returns the distance inside one face between a point given by barycentric coordinates and corner
/// k.
DGG_CORE_EXPORT double DistanceToCorner(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric, int k);
/// Returns the straight distance inside one face between two points given by barycentric
/// coordinates.
DGG_CORE_EXPORT double DistanceInFace(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& p, const std::array<double, 3>& q);

/// Returns the barycentric coordinates of corner k of a face.
inline std::array<double, 3> CoordinatesOfCorner(Id k)
{
  std::array<double, 3> b{ { 0.0, 0.0, 0.0 } };
  b[k] = 1.0;
  return b;
}

/// Returns the barycentric coordinates, in the face of a half-edge, of the point at parameter t
/// from its origin.
inline std::array<double, 3> CoordinatesOnEdge(Id halfEdge, double t)
{
  std::array<double, 3> b{ { 0.0, 0.0, 0.0 } };
  b[halfEdge % 3] = 1.0 - t;
  b[(halfEdge + 1) % 3] = t;
  return b;
}

/// Returns barycentric coordinates clamped to the face, from which rounding may have moved them. In
/// nearly degenerate faces coordinates have large errors even if the position is accurate.
DGG_CORE_EXPORT std::array<double, 3> ClampedToFace(std::array<double, 3> barycentric);

/// Calls `visit(face, barycentric)` for the face of a point, or for all faces of the edge that
/// contains the point.
template <typename Visitor>
void ForEachFaceAround(const SurfaceMesh& mesh, const SurfacePoint& point, Visitor&& visit)
{
  visit(point.Face, point.Barycentric);
  if (point.On != SurfacePoint::Support::Edge)
  {
    return;
  }
  const Id h = point.HalfEdge;
  const double t = point.Barycentric[(h + 1) % 3]; // from origin to destination
  ForEachFaceBehind(mesh, h, false, [&](Id e, bool isMirrored) {
    visit(SurfaceMesh::Face(e), CoordinatesOnEdge(e, isMirrored ? t : 1.0 - t));
  });
}
}

#endif
