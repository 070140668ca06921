// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An order of the vertices in which neighbours on the surface are close together. Internal.
#ifndef dggSurfaceOrder_h
#define dggSurfaceOrder_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for the order

namespace dgg
{
/// Vertices patch by patch: each patch grows breadth-first to about the given size, the next one
/// starts where earlier ones touch it. What a local computation around one vertex reads is then
/// mostly in the cache from the vertex before. Isolated vertices come last.
std::vector<Id> ComputePatchOrder(const SurfaceMesh& mesh, Id patchSize);
}

#endif
