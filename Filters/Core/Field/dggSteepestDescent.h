// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where a field falls fastest. Internal.
#ifndef dggSteepestDescent_h
#define dggSteepestDescent_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

namespace dgg
{
/// The direction in which a field falls fastest from a vertex.
struct SteepestDescent
{
  double Slope = 0.0;   ///< 0 when it falls nowhere
  double Angle = 0.0;   ///< polar angle at the vertex
  bool IsKnown = false; ///< whether there is a value at the vertex and at a neighbour
};

/// Of a field that is linear in faces and known where its values are finite.
SteepestDescent FindSteepestDescent(const SurfaceMesh& mesh, const double* values, Id v);
}

#endif
