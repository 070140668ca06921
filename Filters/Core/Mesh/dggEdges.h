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
/// The half-edge that stands for the edge of h: the smallest one of all that lie there.
inline Id FindEdge(const SurfaceMesh& mesh, Id h)
{
  Id smallest = h;
  for (Id e = mesh.Twin(h); e != NoId && e != h; e = mesh.Twin(e))
  {
    smallest = std::min(smallest, e);
  }
  return smallest;
}
}

#endif
