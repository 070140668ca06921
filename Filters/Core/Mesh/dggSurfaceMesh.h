// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Intrinsic triangle mesh: half-edge connectivity, edge lengths, angles and vertex kinds.
#ifndef dggSurfaceMesh_h
#define dggSurfaceMesh_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status

#include <array>   // for Triangle
#include <cstdint> // for VertexKind
#include <vector>  // for the arrays

namespace dgg
{
/// Behavior of geodesics at a vertex.
enum class VertexKind : std::uint8_t
{
  Isolated, ///< no face that is not dropped
  Convex,   ///< total angle below 2 pi: no geodesic passes
  Flat,     ///< total angle 2 pi
  Saddle,   ///< total angle above 2 pi: geodesics may bend here
  Boundary, ///< on exactly one boundary fan: geodesics may bend here
  Irregular ///< several fans, a non-manifold edge, a degenerate face or inconsistent orientation:
            ///< angles are unreliable, a path may continue in any direction
};

class SurfaceMesh;

/// Parent of a mesh that is built from lengths. Each face of the mesh is a face of the parent or
/// lies in one. Faces that are degenerate in the parent are degenerate in the submesh; their edges
/// have been lengthened already, and the mean edge length of the parent is used. Hence a submesh of
/// entire faces has the same lengths as its parent, and windows cross the submesh in the same
/// manner as the parent.
struct PartOfMesh
{
  const SurfaceMesh* Parent = nullptr; ///< parent mesh; null if there is none
  const Id* Faces = nullptr;           ///< per triangle, the face of the parent that contains it
};

/// An intrinsic triangle mesh: the properties of a surface that determine geodesics. All properties
/// are derived from the triangles and one length per edge; coordinates are not stored.
///
/// Conventions. Half-edge `3f+k` starts at corner `k` of face `f`. Faces keep the ids of the input.
/// A face with a repeated vertex is *dropped* (it has no area and fewer than three edges): the face
/// keeps its id but is ignored. A *duplicate*, a face on the three vertices of an earlier face, is
/// also dropped: the duplicate is congruent to the earlier face and glued to it along all edges, so
/// that it shortens no path. Faces are re-oriented component by component if re-orientation makes
/// them consistent (distances do not depend on orientation). A re-oriented face has its corners 1
/// and 2 swapped, so always read corners from GetTriangle() or Origin().
///
/// Any triangle complex is accepted. The half-edges of one edge form a circular list through
/// Twin(): one entry on the boundary (Twin is NoId), two on a manifold edge, more on a non-manifold
/// edge, which connects all its faces.
///
/// Degenerate faces (zero area, or a triangle inequality violated by rounding) are *mollified*: the
/// edges of these faces are lengthened by one small delta (GetMollification()), the smallest that
/// leaves a slack of 1e-13 times the mean edge length (or the longest edge of the face, if longer)
/// in each of them (Sharp and Crane, "A Laplacian for Nonmanifold Triangle Meshes", 2020, sec.
/// 4.5). Angles and kinds are those of the lengthened faces; vertices of such faces are Irregular.
class DGG_CORE_EXPORT SurfaceMesh
{
public:
  /// Builds a mesh from `numberOfPoints` points (x y z each) and `numberOfTriangles` triples of
  /// point ids. Fails, naming the element, if an id is out of range, a coordinate used by a
  /// triangle is not finite, an extent is outside [1e-70, 1e70], or there are more than 2^31 - 1
  /// half-edges. `isRim` may flag the vertices (one entry each) at which triangles of a larger mesh
  /// are missing. Edges between two such vertices are not glued, so that everything at the other
  /// vertices is as in the larger mesh.
  static Status FromPoints(const double* points, Offset numberOfPoints, const Id* triangles,
    Offset numberOfTriangles, SurfaceMesh& mesh, const std::uint8_t* isRim = nullptr);

  /// Builds a mesh like FromPoints(), but faster. TotalAngle(), PolarAngle(), Kind() and
  /// IsPassThrough() must not be called before MeasureAngles().
  static Status FromPointsWithoutAngles(const double* points, Offset numberOfPoints,
    const Id* triangles, Offset numberOfTriangles, SurfaceMesh& mesh,
    const std::uint8_t* isRim = nullptr);

  /// Computes the angles of a mesh built without angles. Other threads may read all other
  /// properties during the call.
  void MeasureAngles();

  /// Builds a mesh from lengths: `lengths[3f+k]` is the length of the edge from corner k to corner
  /// k+1 of face f. Faces are glued along equal vertex pairs. Both halves of an edge must give the
  /// same length (to 1e-9 relative; the larger one is used). The triangle inequality may be
  /// violated by 1e-12 of the longest edge of the mesh, the rounding error of lengths computed from
  /// coordinates. `origin` describes the parent of a submesh.
  static Status FromLengths(Offset numberOfVertices, const Id* triangles, Offset numberOfTriangles,
    const double* lengths, SurfaceMesh& mesh, const PartOfMesh& origin = {});

  /// Builds a mesh like FromLengths(), with explicit gluing: `twins[h]` is the other half of the
  /// edge of half-edge `h`, or NoId. Explicit gluing is needed if edges are not identified by their
  /// vertex pairs, as on a flat torus of few triangles.
  static Status FromGluedLengths(Offset numberOfVertices, const Id* triangles,
    Offset numberOfTriangles, const double* lengths, const Id* twins, SurfaceMesh& mesh,
    const PartOfMesh& origin = {});

  Id GetNumberOfVertices() const { return static_cast<Id>(this->VertexFlags.size()); }
  Id GetNumberOfFaces() const { return static_cast<Id>(this->Origins.size() / 3); }
  Id GetNumberOfHalfEdges() const { return static_cast<Id>(this->Origins.size()); }

  static Id Next(Id h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Id Previous(Id h) { return h % 3 == 0 ? h + 2 : h - 1; }
  static Id Face(Id h) { return h / 3; }

  Id Origin(Id h) const { return this->Origins[h]; }
  Id Destination(Id h) const { return this->Origins[Next(h)]; }
  /// Returns the vertex of the half-edge's face that is not on the half-edge.
  Id Apex(Id h) const { return this->Origins[Previous(h)]; }
  /// Returns the next half-edge in the circular list of the edge; NoId on the boundary.
  Id Twin(Id h) const { return this->Twins[h]; }
  /// Returns true if the edge has more than two faces.
  bool IsNonManifold(Id h) const
  {
    return this->Twins[h] != NoId && this->Twins[this->Twins[h]] != h;
  }
  double Length(Id h) const { return this->Lengths[h]; }
  std::array<Id, 3> GetTriangle(Id f) const
  {
    return { this->Origins[3 * f], this->Origins[3 * f + 1], this->Origins[3 * f + 2] };
  }
  /// Returns true if the face is ignored because it repeats a vertex or an earlier face.
  bool IsDropped(Id f) const { return (this->FaceFlags[f] & DroppedFlag) != 0; }
  /// Returns true if the face was dropped because an earlier face has the same vertices. Meshes
  /// with explicit gluing have no duplicates.
  bool IsDuplicate(Id f) const { return (this->FaceFlags[f] & DuplicateFlag) != 0; }
  /// Returns the face that a duplicate repeats; for any other face, the face itself.
  Id GetOriginal(Id f) const;
  /// Returns true if corners 1 and 2 were swapped with respect to the input.
  bool IsFlipped(Id f) const { return (this->FaceFlags[f] & FlippedFlag) != 0; }
  /// Returns true if the face had no area, up to rounding, before its edges were lengthened.
  bool IsDegenerate(Id f) const { return (this->FaceFlags[f] & DegenerateFlag) != 0; }
  /// Returns true if edges of the face were lengthened because the face or a neighbor is
  /// degenerate, so that its angles are unreliable.
  bool IsMollified(Id f) const { return (this->FaceFlags[f] & MollifiedFlag) != 0; }

  /// Returns a coordinate of the apex in the frame of the half-edge: origin at Origin(h), x axis
  /// towards Destination(h), y > 0.
  double ApexX(Id h) const { return this->ApexXs[h]; }
  double ApexY(Id h) const { return this->ApexYs[h]; }

  VertexKind Kind(Id v) const { return this->Kinds[v]; }
  /// Returns true if the kind is Irregular; does not need angles.
  bool IsIrregular(Id v) const { return (this->VertexFlags[v] & IrregularFlag) != 0; }
  /// Returns the sum of the corner angles at the vertex, radians.
  double TotalAngle(Id v) const { return this->TotalAngles[v]; }
  /// Returns true if a shortest path may bend at the vertex, so that the vertex must act as a
  /// pseudo-source. Returns false for convex boundary corners, at which no shortest path bends.
  bool IsPassThrough(Id v) const;

  /// Returns the range of the outgoing half-edges of the vertex, counter-clockwise, fan after fan.
  /// On the boundary a fan starts with its clockwise-most half-edge; in the interior with its
  /// half-edge of smallest id.
  const Id* FanBegin(Id v) const { return this->Fans.data() + this->FanOffsets[v]; }
  const Id* FanEnd(Id v) const { return this->Fans.data() + this->FanOffsets[v + 1]; }
  /// Returns the polar angle of the half-edge at its origin, radians: the sum of the corner angles
  /// before the half-edge in the fan order.
  double PolarAngle(Id h) const { return this->PolarAngles[h]; }
  /// Returns the corner angle at the origin of the half-edge, inside its face, radians.
  double CornerAngle(Id h) const;

  /// Returns, per vertex, the id of its connected component (through edges and shared vertices).
  /// Components are numbered by smallest vertex id; isolated vertices have a component of their
  /// own.
  std::vector<Id> ComputeComponents(Id& numberOfComponents) const;

  double GetMeanEdgeLength() const { return this->MeanEdgeLength; }
  double GetMaximumEdgeLength() const { return this->MaximumEdgeLength; }
  /// Returns the largest length added to the edges of degenerate faces; 0 without degenerate faces.
  double GetMollification() const { return this->Mollification; }
  /// Returns the number of faces that were lengthened.
  Id GetNumberOfMollifiedFaces() const { return this->NumberOfMollifiedFaces; }
  /// Returns the number of degenerate faces of the input: zero area, up to rounding (without
  /// dropped faces).
  Id GetNumberOfDegenerateFaces() const { return this->NumberOfDegenerateFaces; }

  /// Returns the size of the arrays in bytes.
  std::size_t GetMemorySize() const;

private:
  VertexKind Classify(Id v) const;

  friend class SurfaceMeshBuilder;

  static constexpr std::uint8_t DroppedFlag = 1;
  static constexpr std::uint8_t FlippedFlag = 2;
  static constexpr std::uint8_t DegenerateFlag = 4;
  static constexpr std::uint8_t MollifiedFlag = 8;
  static constexpr std::uint8_t DuplicateFlag = 16;

  static constexpr std::uint8_t IrregularFlag = 1;

  std::vector<Id> Origins;                   // 3m
  std::vector<Id> Twins;                     // 3m
  std::vector<double> Lengths;               // 3m
  std::vector<double> ApexXs;                // 3m
  std::vector<double> ApexYs;                // 3m
  std::vector<double> PolarAngles;           // 3m
  std::vector<Offset> FanOffsets;            // n+1
  std::vector<Id> Fans;                      // 3m, without dropped faces
  std::vector<double> TotalAngles;           // n
  std::vector<VertexKind> Kinds;             // n
  std::vector<std::uint8_t> VertexFlags;     // n
  std::vector<std::uint8_t> FaceFlags;       // m
  std::vector<std::array<Id, 2>> Duplicates; // duplicates with their originals, sorted
  double MeanEdgeLength = 0.0;
  double MaximumEdgeLength = 0.0;
  double Mollification = 0.0;
  Id NumberOfMollifiedFaces = 0;
  Id NumberOfDegenerateFaces = 0;
};
}

#endif
