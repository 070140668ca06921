// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the distance of each vertex seems to come from.
#ifndef dggVirtualSources_h
#define dggVirtualSources_h

#include <vector> // for the arrays

namespace dgg
{
/// For each vertex the virtual source, as it is seen from the vertex: near the vertex, the distance
/// is about Offset + the straight distance from that source. For vertices that are not reached
/// nothing is said.
struct VirtualSources
{
  std::vector<double> Offsets; ///< distance at the virtual source
  std::vector<double> Lengths; ///< straight distance from it to the vertex; 0 at a source
  /// Polar angle at the vertex towards it, radians (SurfaceMesh::PolarAngle()), not reduced to one
  /// turn.
  std::vector<double> Angles;
};
}

#endif
