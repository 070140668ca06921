// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Intrinsic triangle mesh: half-edge connectivity, edge lengths, angles and vertex kinds.
#ifndef dggSurfaceMesh_h
#define dggSurfaceMesh_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggTypes.h"      // for Id, Offset, Status

#include <array>   // for Triangle
#include <cstdint> // for VertexKind
#include <vector>  // for the arrays

namespace dgg
{
/// How geodesics behave at a vertex.
enum class VertexKind : std::uint8_t
{
  Isolated, ///< no (usable) face
  Convex,   ///< total angle below 2 pi: no geodesic passes
  Flat,     ///< total angle 2 pi
  Saddle,   ///< total angle above 2 pi: geodesics may bend here
  Boundary, ///< on exactly one boundary fan: geodesics may bend here
  Irregular ///< several fans, a non-manifold edge, a degenerate face or no consistent orientation:
            ///< angles are not to be trusted, every direction may follow every other
};

class SurfaceMesh;

/// What a mesh made of lengths is a part of: each of its faces is a face of another mesh or lies in
/// one. What is degenerate there is degenerate in the part as well, its edges have been lengthened
/// already, and the mean edge length that counts is that of the whole. So a part made of whole
/// faces has the same lengths, and windows cross it as they cross the whole.
struct PartOfMesh
{
  const SurfaceMesh* Whole = nullptr; ///< another mesh; null when the mesh is not a part
  const Id* Faces = nullptr;          ///< per triangle, the face of the whole that it lies in
};

/// An intrinsic triangle mesh: what a geodesic sees of a surface. Everything is derived from the
/// triangles and one length per edge; coordinates are not kept.
///
/// Conventions. Half-edge `3f+k` starts at corner `k` of face `f`. Faces keep the ids of the input.
/// A face with a repeated vertex is *dropped* (it has no area and no three edges): it keeps its id
/// but takes no part. So is a *duplicate*, a face on the three vertices of an earlier one: it is
/// congruent to that one and glued to it along all edges, so that no path gains by it. Faces are
/// re-oriented component by component where that makes them consistent (distances do not depend on
/// orientation); a re-oriented face has its corners 1 and 2 swapped, so always read corners from
/// GetTriangle() or Origin().
///
/// Any triangle complex is accepted. The half-edges of one edge form a circular list through
/// Twin(): one entry on the boundary (Twin is NoId), two on a manifold edge, more on a non-manifold
/// edge, which conducts between all its faces.
///
/// Degenerate faces (zero area, or a triangle inequality lost to rounding) are *mollified*: the
/// edges of the faces concerned are lengthened by one small delta (GetMollification()), the
/// smallest that leaves a slack of 1e-13 times the mean edge length (or the longest edge of the
/// face, if longer) in each of them (Sharp and Crane, "A Laplacian for Nonmanifold Triangle
/// Meshes", 2020, sec. 4.5). Angles and kinds are those of the lengthened faces; vertices of such
/// faces are Irregular.
class DGG_CORE_EXPORT SurfaceMesh
{
public:
  /// Build from `numberOfPoints` points (x y z each) and `numberOfTriangles` triples of point ids.
  /// Fails with a message that names the element when an id is out of range, a coordinate used by a
  /// triangle is not finite, an extent is outside [1e-70, 1e70], or there are more than 2^31 - 1
  /// half-edges.
  static Status FromPoints(const double* points, Offset numberOfPoints, const Id* triangles,
    Offset numberOfTriangles, SurfaceMesh& mesh);

  /// As FromPoints(), but faster: TotalAngle(), PolarAngle(), Kind() and IsPassThrough() are not to
  /// be asked for before MeasureAngles().
  static Status FromPointsWithoutAngles(const double* points, Offset numberOfPoints,
    const Id* triangles, Offset numberOfTriangles, SurfaceMesh& mesh);

  /// Add what a mesh made without angles lacks. Other threads may read all else meanwhile.
  void MeasureAngles();

  /// Build from lengths alone: `lengths[3f+k]` is the length of the edge from corner k to corner
  /// k+1 of face f. Faces glue along equal vertex pairs. Both halves of an edge must give the same
  /// length (to 1e-9 relative; the larger one is used). The triangle inequality may be violated by
  /// 1e-12 of the longest edge of the mesh, the rounding of lengths taken from coordinates. A part
  /// of a mesh says so by `origin`.
  static Status FromLengths(Offset numberOfVertices, const Id* triangles, Offset numberOfTriangles,
    const double* lengths, SurfaceMesh& mesh, const PartOfMesh& origin = {});

  /// As FromLengths(), with the gluing given as well: `twins[h]` is the other half of the edge of
  /// half-edge `h`, or NoId. Needed where faces meet along edges that vertex pairs do not
  /// distinguish, as on a flat torus of few triangles.
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
  /// The vertex of the half-edge's face that is not on the half-edge.
  Id Apex(Id h) const { return this->Origins[Previous(h)]; }
  /// Next half-edge in the circular list of the edge; NoId on the boundary.
  Id Twin(Id h) const { return this->Twins[h]; }
  /// Whether the edge has more than two faces.
  bool IsNonManifold(Id h) const
  {
    return this->Twins[h] != NoId && this->Twins[this->Twins[h]] != h;
  }
  double Length(Id h) const { return this->Lengths[h]; }
  std::array<Id, 3> GetTriangle(Id f) const
  {
    return { this->Origins[3 * f], this->Origins[3 * f + 1], this->Origins[3 * f + 2] };
  }
  /// Whether the face takes no part, because it repeats a vertex or an earlier face.
  bool IsDropped(Id f) const { return (this->FaceFlags[f] & DroppedFlag) != 0; }
  /// Whether the face was dropped because an earlier one has the same vertices. Faces that were
  /// glued by hand have no duplicates.
  bool IsDuplicate(Id f) const { return (this->FaceFlags[f] & DuplicateFlag) != 0; }
  /// The face that a duplicate repeats; any other face itself.
  Id GetOriginal(Id f) const;
  /// Whether corners 1 and 2 were swapped with respect to the input.
  bool IsFlipped(Id f) const { return (this->FaceFlags[f] & FlippedFlag) != 0; }
  /// Whether the face had no area, up to rounding, before its edges were lengthened.
  bool IsDegenerate(Id f) const { return (this->FaceFlags[f] & DegenerateFlag) != 0; }
  /// Whether its edges were lengthened because it is degenerate or became so when a neighbour's
  /// edges were lengthened: its angles are not to be trusted.
  bool IsMollified(Id f) const { return (this->FaceFlags[f] & MollifiedFlag) != 0; }

  /// Position of the apex in the frame of the half-edge: origin at Origin(h), x axis towards
  /// Destination(h), y > 0.
  double ApexX(Id h) const { return this->ApexXs[h]; }
  double ApexY(Id h) const { return this->ApexYs[h]; }

  VertexKind Kind(Id v) const { return this->Kinds[v]; }
  /// Whether the kind is Irregular, which is known without angles.
  bool IsIrregular(Id v) const { return (this->VertexFlags[v] & IrregularFlag) != 0; }
  /// Sum of the corner angles at the vertex, radians.
  double TotalAngle(Id v) const { return this->TotalAngles[v]; }
  /// Whether a shortest path may pass through the vertex with a bend, so that it has to act as a
  /// pseudo-source. Convex boundary corners are left out: nothing can bend there.
  bool IsPassThrough(Id v) const;

  /// Outgoing half-edges of the vertex, counter-clockwise, fan after fan. On the boundary a fan
  /// starts with its clockwise-most half-edge; in the interior with its half-edge of smallest id.
  const Id* FanBegin(Id v) const { return this->Fans.data() + this->FanOffsets[v]; }
  const Id* FanEnd(Id v) const { return this->Fans.data() + this->FanOffsets[v + 1]; }
  /// Polar angle of the half-edge at its origin: the sum of the corner angles before it in the fan
  /// order.
  double PolarAngle(Id h) const { return this->PolarAngles[h]; }
  /// Corner angle at the origin of the half-edge, inside its face.
  double CornerAngle(Id h) const;

  /// Connected components (through edges and shared vertices), numbered by smallest vertex id;
  /// isolated vertices have a component of their own.
  std::vector<Id> ComputeComponents(Id& numberOfComponents) const;

  double GetMeanEdgeLength() const { return this->MeanEdgeLength; }
  double GetMaximumEdgeLength() const { return this->MaximumEdgeLength; }
  /// Length added to the edges of degenerate faces, at most; 0 when there are none.
  double GetMollification() const { return this->Mollification; }
  /// Number of faces that were lengthened.
  Id GetNumberOfMollifiedFaces() const { return this->NumberOfMollifiedFaces; }
  /// Degenerate faces of the input: zero area, up to rounding (dropped faces not counted).
  Id GetNumberOfDegenerateFaces() const { return this->NumberOfDegenerateFaces; }

  /// Bytes held by the arrays.
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
  std::vector<std::array<Id, 2>> Duplicates; // with their originals, sorted
  double MeanEdgeLength = 0.0;
  double MaximumEdgeLength = 0.0;
  double Mollification = 0.0;
  Id NumberOfMollifiedFaces = 0;
  Id NumberOfDegenerateFaces = 0;
};
}

#endif
