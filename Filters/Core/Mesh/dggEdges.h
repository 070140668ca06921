// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Edges as such, of which a mesh knows half-edges only. Internal.
#ifndef dggEdges_h
#define dggEdges_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <algorithm> // for std::min

namespace dgg
{
/// The half-edge that stands for the edge of h: the smallest one of all that lie there. `surface`
/// is a SurfaceMesh, or has half-edges as that has.
template <typename Surface>
Id FindEdge(const Surface& surface, Id h)
{
  Id smallest = h;
  for (Id e = surface.Twin(h); e != NoId && e != h; e = surface.Twin(e))
  {
    smallest = std::min(smallest, e);
  }
  return smallest;
}
}

#endif
