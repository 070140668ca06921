// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Delaunay triangulations of surfaces by flips of edges. Internal.
#ifndef dggIntrinsicDelaunay_h
#define dggIntrinsicDelaunay_h

#include "dggIntrinsicTriangulation.h"

namespace dgg
{
struct DelaunayReport
{
  Offset Flips = 0;
  /// Edges that should be flipped and were not, because a face would lose its area to rounding.
  Offset Refused = 0;
  /// False when the bound on flips was met first. The triangulation is good, but not Delaunay.
  bool IsComplete = true;
};

/// Flip edges until those between two faces are Delaunay: the cotangents that face them do not add
/// up to less than 0, but for rounding (Bobenko and Springborn, "A discrete Laplace-Beltrami
/// operator for simplicial surfaces", 2007; Fisher et al., "An algorithm for the construction of
/// intrinsic Delaunay triangulations", 2007). Lengths on the surface, angles and areas stay what
/// they are. Edges on the boundary, with more than two faces, or with the same face on both sides
/// stay. At most `mostFlips` flips; negative is the default, 100 per edge, where ordinary meshes
/// need less than one.
Status MakeDelaunay(IntrinsicTriangulation& triangulation, Offset mostFlips,
  const ProgressCallback& progress, DelaunayReport& report);
}

#endif
