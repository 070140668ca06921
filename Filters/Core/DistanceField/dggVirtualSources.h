// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point sources that approximate a distance field around each vertex.
#ifndef dggVirtualSources_h
#define dggVirtualSources_h

#include "dggTypes.h" // for Infinity

#include <vector> // for VirtualSources

namespace dgg
{
/// Virtual source of a vertex. Near the vertex, the distance is about Offset plus the straight
/// distance from a point at the given polar coordinates around the vertex.
struct VirtualSource
{
  double Offset = Infinity; ///< distance at the virtual source
  double Length = Infinity; ///< straight distance from the virtual source to the vertex
  /// Polar angle at the vertex towards the virtual source, radians (SurfaceMesh::PolarAngle()), not
  /// reduced to one turn.
  double Angle = 0.0;
};

/// Virtual sources per vertex; the entries of unreached vertices are unspecified.
using VirtualSources = std::vector<VirtualSource>;
}

#endif
