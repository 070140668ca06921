// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From the edges found from each vertex to a symmetric graph. Internal.
#ifndef dggGraphAssembly_h
#define dggGraphAssembly_h

#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggParallel.h"      // for ParallelFor
#include "dggRowStore.h"      // for RowStore

#include <cstddef> // for std::size_t
#include <vector>  // for the order

namespace dgg
{
/// Unite both directions: of an edge that was found from both ends, only the copy in the row of the
/// vertex that comes first is kept; it takes over the other way if that is shorter. `first` is the
/// first row that has not been united with the rows before it.
void UniteDirections(RowStore& rows, Id first, const ParallelFor& parallel);

/// Write the graph from united rows, each edge in both directions, every row sorted by angle, and
/// give up the rows on the way. `order` lists the final ids of the rows. Returns the most bytes
/// held at one time by rows and graph together.
std::size_t AssembleGraph(RowStore& rows, const std::vector<Id>& order, bool wide,
  const ParallelFor& parallel, GeodesicGraph& graph);
}

#endif
