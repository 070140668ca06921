// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ways that the virtual sources of faces and edges have missed. Internal.
#ifndef dggPropagationShortcuts_h
#define dggPropagationShortcuts_h

#include "dggParallel.h"         // for ParallelFor
#include "dggPropagationFaces.h" // for the faces
#include "dggPropagationLabel.h" // for labels

#include <atomic> // for distances
#include <vector> // for shortcuts

namespace dgg
{
/// A way to a vertex by a label that no face or edge keeps.
struct PropagationShortcut
{
  Id Vertex;
  float Distance;
  /// Has entered a face at the vertex. Its root is NoId where it follows an edge from the vertex
  /// that its entry starts at: then it is the root of that vertex.
  PropagationLabel Label;
};

/// The way from one corner of a face to another one along their edge.
inline PropagationShortcut WayAlongEdge(
  Id f, const PropagationFace& face, int from, int to, float start)
{
  const float length = face.Lengths[to == NextOf(from) ? from : to];
  return { face.Corners[to], start + length, { 0.0F, 0.0F, start, 3 * f + from, NoId } };
}

/// Lower the distances of vertices to those along edges: none is farther than a neighbour and the
/// edge between them, up to rounding and up to the radius. Appends the ways.
void TakeWaysAlongEdges(const SurfaceMesh& mesh, const PropagationFaces& faces, float radius,
  const ParallelFor& parallel, std::atomic<float>* distances,
  std::vector<PropagationShortcut>& shortcuts);

/// Keep those that vertices have their distances from, nearest first, in an order of their own.
void KeepShortest(const std::atomic<float>* distances, std::vector<PropagationShortcut>& shortcuts);
}

#endif
