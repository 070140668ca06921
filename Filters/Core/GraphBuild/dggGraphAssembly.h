// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From the edges found from each vertex to a symmetric graph. Internal.
#ifndef dggGraphAssembly_h
#define dggGraphAssembly_h

#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggParallel.h"      // for ParallelFor
#include "dggRowStore.h"      // for RowStore

#include <vector> // for the order

namespace dgg
{
/// Write the graph from united rows, each edge in both directions, every row sorted by angle, and
/// give up the rows on the way. `order` lists the final ids of the rows. Fails when `progress`,
/// which may be empty, asks to stop.
Status AssembleGraph(RowStore& rows, const std::vector<Id>& order, bool wide,
  const ParallelFor& parallel, const ProgressCallback& progress, GeodesicGraph& graph);
}

#endif
