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
/// Returns the vertices patch by patch: each patch grows breadth-first to about the given size, the
/// next one starts adjacent to earlier patches. A local computation around a vertex then mostly
/// reads memory that is in the cache from the previous vertex. Isolated vertices come last.
std::vector<Id> ComputePatchOrder(const SurfaceMesh& mesh, Id patchSize);
}

#endif
