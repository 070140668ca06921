// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A vertex order in which neighbors on the surface are close together. Internal.
#ifndef dggSurfaceOrder_h
#define dggSurfaceOrder_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for the order

namespace dgg
{
/// Returns the vertices patch by patch. Each patch grows breadth-first to about the given size, and
/// the next patch starts adjacent to earlier patches. With this order, a local computation around a
/// vertex mostly reads memory that is in the cache from the previous vertex. Isolated vertices come
/// last.
std::vector<Id> ComputePatchOrder(const SurfaceMesh& mesh, Id patchSize);
}

#endif
