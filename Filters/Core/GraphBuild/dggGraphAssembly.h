// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Assembles the symmetric graph from the edges found from each vertex. Internal.
#ifndef dggGraphAssembly_h
#define dggGraphAssembly_h

#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggParallel.h"      // for ParallelFor
#include "dggRowStore.h"      // for RowStore

#include <vector> // for the order

namespace dgg
{
/// Writes the graph from united rows: each edge in both directions, every row sorted by angle.
/// Releases the rows during the assembly. `order` lists the final ids of the rows. Edges with equal
/// angles are sorted by `ids` of their targets, or by the final ids if `ids` is null. Fails if
/// `progress`, which may be empty, returns false.
Status AssembleGraph(RowStore& rows, const std::vector<Id>& order, bool wide,
  const ParallelFor& parallel, const ProgressCallback& progress, GeodesicGraph& graph,
  const Id* ids = nullptr);
}

#endif
