// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An intrinsic triangulation, given by lengths and gluing, whose edges can be flipped. Internal.
#ifndef dggIntrinsicTriangulation_h
#define dggIntrinsicTriangulation_h

#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <cstdint> // for flags
#include <vector>  // for the arrays

namespace dgg
{
/// The faces of a mesh as triangles glued along their edges. Half-edges have the conventions of
/// SurfaceMesh, but dropped faces are omitted, so that ids differ. Several edges between the same
/// two vertices and edges from a vertex to itself are allowed.
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
  /// Returns the next half-edge in the circular list of the edge; NoId on the boundary.
  Id Twin(Id h) const { return this->Twins[h]; }
  double Length(Id h) const { return this->Lengths[h]; }

  /// Returns the smallest half-edge of the edge.
  Id FirstOfEdge(Id h) const;
  /// Returns the corner of a face opposite to its first side, in the plane with that side on the x
  /// axis.
  Point2 Apex(Id face) const;

  /// Returns the cotangent of the corner at the origin of the half-edge. Accurate for slivers.
  double Cotangent(Id h) const;
  double Area(Id face) const;

  /// Returns true if exactly two different faces meet at the edge.
  bool IsFlippable(Id h) const;

  /// Replaces the edge by the other diagonal of its two faces, laid out in the plane. Returns false
  /// without any change if the edge cannot be flipped or a triangle would become degenerate.
  bool Flip(Id h);

private:
  bool IsPair(Id h) const;
  /// Returns the half-edge whose twin is h; NoId on the boundary.
  Id FindPredecessor(Id h) const;
  /// Swaps corners 1 and 2 of a face.
  void TurnOver(Id face);

  Id NumberOfVertices = 0;
  std::vector<Id> Origins;
  std::vector<Id> Twins;
  std::vector<double> Lengths;
  /// Per half-edge of an edge between two faces, true if both half-edges run in the same direction.
  /// The origins do not determine this for an edge from a vertex to itself.
  std::vector<std::uint8_t> RunsAlong;
};

/// Flips edges until those between two faces are Delaunay: the sum of the cotangents opposite to an
/// edge is not negative, up to rounding (Bobenko and Springborn, "A discrete Laplace-Beltrami
/// operator for simplicial surfaces", 2007; Fisher et al., "An algorithm for the construction of
/// intrinsic Delaunay triangulations", 2007). The metric of the surface does not change. Edges on
/// the boundary, with more than two faces, or with the same face on both sides are kept, as are
/// those whose faces would become degenerate by rounding. At most 100 flips per edge are made;
/// ordinary meshes need less than one. `flips` receives the number of flips.
Status MakeDelaunay(
  IntrinsicTriangulation& triangulation, const ProgressCallback& progress, Offset& flips);
}

#endif
