// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulation that is nothing but lengths and gluing, whose edges can be flipped. Internal.
#ifndef dggIntrinsicTriangulation_h
#define dggIntrinsicTriangulation_h

#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace dgg
{
/// The faces of a mesh as triangles glued along their edges. Half-edges have the conventions of
/// SurfaceMesh, but the faces that it drops are missing, so that ids differ. Several edges between
/// the same two vertices and edges from a vertex to itself are legal.
class IntrinsicTriangulation
{
public:
  IntrinsicTriangulation() = default;
  explicit IntrinsicTriangulation(const SurfaceMesh& mesh);

  Id GetNumberOfVertices() const { return this->NumberOfVertices; }
  Id GetNumberOfFaces() const { return static_cast<Id>(this->Origins.size() / 3); }
  Id GetNumberOfHalfEdges() const { return static_cast<Id>(this->Origins.size()); }

  Id Origin(Id h) const { return this->Origins[h]; }
  Id Destination(Id h) const { return this->Origins[SurfaceMesh::Next(h)]; }
  /// Next half-edge in the circular list of the edge; NoId on the boundary.
  Id Twin(Id h) const { return this->Twins[h]; }
  double Length(Id h) const { return this->Lengths[h]; }

  /// The smallest of the half-edges of the edge.
  Id FirstOfEdge(Id h) const;
  /// The corner of a face across from its first side, in the plane with that on the x axis.
  Point2 Apex(Id face) const;

  /// Cotangent of the corner at the origin of the half-edge, inside its face. Accurate for slivers.
  double Cotangent(Id h) const;
  double Area(Id face) const;

  /// Whether exactly two different faces meet at the edge.
  bool IsFlippable(Id h) const;

  /// Replace the edge by the other diagonal of its two faces, laid out in the plane. False, and
  /// nothing has changed, when the edge cannot be flipped or a triangle would lose its area.
  bool Flip(Id h);

private:
  bool IsPair(Id h) const;
  /// The half-edge whose twin is h; NoId on the boundary.
  Id FindPredecessor(Id h) const;
  /// Exchange corners 1 and 2 of a face.
  void TurnOver(Id face);

  Id NumberOfVertices = 0;
  std::vector<Id> Origins;
  std::vector<Id> Twins;
  std::vector<double> Lengths;
  /// Of an edge between two faces: whether its half-edges run in the same direction. The origins do
  /// not decide for an edge from a vertex to itself.
  std::vector<std::uint8_t> RunsAlong;
};

/// Flip edges until those between two faces are Delaunay: the cotangents that face them do not add
/// up to less than 0, but for rounding (Bobenko and Springborn, "A discrete Laplace-Beltrami
/// operator for simplicial surfaces", 2007; Fisher et al., "An algorithm for the construction of
/// intrinsic Delaunay triangulations", 2007). Lengths on the surface, angles and areas stay what
/// they are. Edges on the boundary, with more than two faces, or with the same face on both sides
/// stay, as do those whose faces would lose their area to rounding. At most 100 flips per edge,
/// where ordinary meshes need less than one. `flips` is the number of them.
Status MakeDelaunay(
  IntrinsicTriangulation& triangulation, const ProgressCallback& progress, Offset& flips);
}

#endif
