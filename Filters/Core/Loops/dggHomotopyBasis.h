// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Non-contractible loops of mesh edges. Internal.
#ifndef dggHomotopyBasis_h
#define dggHomotopyBasis_h

#include "dggSurfaceComponents.h" // for SurfaceComponents

#include <cstddef> // for std::size_t
#include <cstdint> // for signatures
#include <vector>  // for the loops

namespace dgg
{
/// A closed chain of mesh edges: half-edge i leads from vertex i to vertex i + 1, forwards or
/// backwards, and the last one back to vertex 0.
struct EdgeLoop
{
  std::vector<Id> Vertices;
  std::vector<Id> HalfEdges;
  double Length = 0.0;
};

/// Homology signatures modulo 2, which determine whether loops of a component are independent.
class HomologySignatures
{
public:
  /// `base` is a vertex of the component. If Check() fails, no other function may be called.
  /// `steps` is increased by the number of visited vertices, faces and half-edges.
  HomologySignatures(const SurfaceComponents& components, Id base, std::size_t& steps);
  const Status& Check() const { return this->TheStatus; }
  /// The dimension: two for each handle, one for each boundary loop but the last, one for each
  /// cross-cap.
  std::size_t GetDimension() const { return this->Dimension; }
  /// Bit i is bit i % 64 of word i / 64.
  std::vector<std::uint64_t> GetSignature(const EdgeLoop& loop) const;

private:
  const SurfaceComponents& Components;
  Status TheStatus;
  std::size_t Dimension = 0;
  /// Per half-edge that represents an edge of the component, the dual cycles that contain the edge.
  std::vector<std::vector<Id>> Cycles;
};

/// For each component with non-contractible loops, finds its vertex of smallest id. Fails on
/// non-manifold edges.
Status FindBasesOfLoops(const SurfaceComponents& components, std::vector<Id>& bases);

/// Finds the shortest loops of edges through the vertex `base` that generate all others on its
/// component: two for each handle, one for each boundary loop but the last, one for each cross-cap;
/// shortest first (greedy homotopy basis: Erickson and Whittlesey, "Greedy optimal homotopy and
/// homology generators", 2005, sec. 3). Fails on a component with non-manifold edges. `steps` as in
/// HomologySignatures.
Status FindHomotopyBasis(
  const SurfaceComponents& components, Id base, std::vector<EdgeLoop>& loops, std::size_t& steps);
}

#endif
