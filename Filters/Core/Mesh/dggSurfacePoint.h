// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A point anywhere on a mesh: at a vertex, on an edge or inside a face. Also a point of a cloud,
/// or close to it.
#ifndef dggSurfacePoint_h
#define dggSurfacePoint_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggEdges.h"       // for ForEachFaceBehind
#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <array> // for Barycentric

namespace dgg
{
/// A point of the surface. What it lies on is decided once, by Snap(): barycentric coordinates
/// within 1e-9 of a vertex or an edge are on it, which keeps needle triangles away at a metric
/// perturbation of at most 1e-9 edge lengths.
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
  /// Coordinates with respect to the corners of SurfaceMesh::GetTriangle(Face); non-negative,
  /// sum 1. Of a point near a vertex, the vector from the vertex to it in space.
  std::array<double, 3> Barycentric{ { 1.0, 0.0, 0.0 } };

  static SurfacePoint AtVertex(Id vertex);
  /// Point in space at an offset from a point of a cloud; at it when the offset is zero. There is
  /// no such point on a mesh.
  static SurfacePoint NearVertex(Id vertex, const std::array<double, 3>& offset);
  /// Point at the given coordinates of a face, snapped. The coordinates refer to the corners of the
  /// face *in the order of the input*, so that callers need not know of re-oriented faces.
  static SurfacePoint InFace(
    const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric);
  /// The same with coordinates that refer to the corners of SurfaceMesh::GetTriangle().
  static SurfacePoint InTriangle(
    const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric);
  /// Point at parameter t in [0, 1] from Origin(h) to Destination(h), snapped.
  static SurfacePoint OnEdge(const SurfaceMesh& mesh, Id halfEdge, double t);
  /// The same, not snapped: t is between 0 and 1.
  static SurfacePoint InsideEdge(Id halfEdge, double t);

  /// Fails with a message when the point does not exist on the mesh.
  Status Check(const SurfaceMesh& mesh) const;
};

/// Whether a point is at a vertex.
inline bool IsVertex(const SurfacePoint& point)
{
  return point.On == SurfacePoint::Support::Vertex;
}

/// Whether two points are the same, given in the same way: a point on an edge in one of its faces
/// is not the same as in another one.
DGG_CORE_EXPORT bool IsSamePoint(const SurfacePoint& a, const SurfacePoint& b);

/// Factor of angles by which the tangent plane at a point gets a full turn: 1 but for vertices that
/// are not on the boundary.
DGG_CORE_EXPORT double UnrollFactor(const SurfaceMesh& mesh, const SurfacePoint& point);

/// Position of the point with the given barycentric coordinates (in its face) in the frame of
/// half-edge h.
DGG_CORE_EXPORT Point2 PlaceInFrame(
  const SurfaceMesh& mesh, Id h, const std::array<double, 3>& barycentric);
/// A direction in the frame of half-edge `from`, in that of half-edge `to` of the same face.
DGG_CORE_EXPORT Point2 DirectionInFrame(
  const SurfaceMesh& mesh, Id from, Id to, const Point2& direction);
/// Distance inside one face between a point given by barycentric coordinates and corner k.
DGG_CORE_EXPORT double DistanceToCorner(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric, int k);
/// Straight distance inside one face between two points given by barycentric coordinates.
DGG_CORE_EXPORT double DistanceInFace(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& p, const std::array<double, 3>& q);

/// Coordinates of corner k of a face.
inline std::array<double, 3> CoordinatesOfCorner(Id k)
{
  std::array<double, 3> b{ { 0.0, 0.0, 0.0 } };
  b[k] = 1.0;
  return b;
}

/// Coordinates, in the face of a half-edge, of the point at parameter t from its origin on.
inline std::array<double, 3> CoordinatesOnEdge(Id halfEdge, double t)
{
  std::array<double, 3> b{ { 0.0, 0.0, 0.0 } };
  b[halfEdge % 3] = 1.0 - t;
  b[(halfEdge + 1) % 3] = t;
  return b;
}

/// Coordinates of a point of a face that rounding has moved out of it: in a face of near-zero area,
/// by much more than it moves a place.
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
