// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Assembles the edges chosen at each node of a cloud into a symmetric graph. Internal.
#ifndef dggCloudAssembly_h
#define dggCloudAssembly_h

#include "dggCloudSetup.h"    // for CloudSetup
#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggParallel.h"      // for ParallelFor

#include <vector> // for row blocks

namespace dgg
{
/// Edge targets of consecutive nodes.
struct CloudRowBlock
{
  std::vector<Id> Sizes; ///< number of targets per row
  /// Targets of all rows as node ids, row after row.
  std::vector<Id> Targets;
};

/// Assembles the graph: each edge in both directions, vertices indexed by point id, rows sorted by
/// target. Each block holds `rowsPerBlock` rows, the last one possibly fewer; blocks are released.
/// Edge lengths are computed here instead of being stored with the targets, which halves the size
/// of the rows; they are stored as double if `wide` is true. Fails if `progress` returns false.
Status AssembleCloudGraph(const CloudSetup& setup, Id numberOfPoints, Id rowsPerBlock,
  std::vector<CloudRowBlock>& blocks, bool wide, const ParallelFor& parallel,
  const ProgressCallback& progress, GeodesicGraph& graph);

/// Finds the connected components of a graph, numbered by decreasing size. Components of equal size
/// are numbered by their smallest vertex id. `components` holds the component of each vertex, NoId
/// for vertices whose `isUsed` is 0; `sizes` holds the number of vertices per component.
void FindCloudComponents(const GeodesicGraph& graph, const std::vector<unsigned char>& isUsed,
  std::vector<Id>& components, std::vector<Id>& sizes);
}

#endif
