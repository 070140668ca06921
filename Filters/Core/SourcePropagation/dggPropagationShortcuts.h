// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths that the virtual sources stored per face or edge have missed. Internal.
#ifndef dggPropagationShortcuts_h
#define dggPropagationShortcuts_h

#include "dggParallel.h"         // for ParallelFor
#include "dggPropagationFaces.h" // for the faces
#include "dggPropagationLabel.h" // for labels

#include <atomic> // for distances
#include <vector> // for shortcuts

namespace dgg
{
/// A path to a vertex by a label that no face or edge stores.
struct PropagationShortcut
{
  Id Vertex;
  float Distance;
  /// Label that has entered a face at the vertex. If the path follows an edge from the origin of
  /// its entry, its root is NoId, which means the root of that vertex.
  PropagationLabel Label;
};

/// Returns the path from one corner of a face to another along their edge.
inline PropagationShortcut WayAlongEdge(
  Id f, const PropagationFace& face, int from, int to, float start)
{
  const float length = face.Lengths[to == NextOf(from) ? from : to];
  return { face.Corners[to], start + length, { 0.0F, 0.0F, start, 3 * f + from, NoId } };
}

/// Relaxes all mesh edges up to the radius: no distance exceeds the distance of a neighbor plus
/// the edge length, up to rounding. Appends the resulting paths.
void TakeWaysAlongEdges(const SurfaceMesh& mesh, const PropagationFaces& faces, float radius,
  const ParallelFor& parallel, std::atomic<float>* distances,
  std::vector<PropagationShortcut>& shortcuts);

/// Keeps the shortcuts that define vertex distances, nearest first, in a deterministic order.
void KeepShortest(const std::atomic<float>* distances, std::vector<PropagationShortcut>& shortcuts);
}

#endif
