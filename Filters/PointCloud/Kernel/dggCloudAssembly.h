// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From the edges chosen at each point of a cloud to a symmetric graph. Internal.
#ifndef dggCloudAssembly_h
#define dggCloudAssembly_h

#include "dggCloudSetup.h"    // for CloudSetup
#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggParallel.h"      // for ParallelFor

#include <cstddef> // for std::size_t
#include <vector>  // for rows

namespace dgg
{
/// Targets chosen from consecutive nodes.
struct CloudRowBlock
{
  std::vector<Id> Sizes; ///< per row
  std::vector<Id> Targets;
};

/// Writes the graph, each edge in both directions, in the numbering of the points, rows sorted by
/// target. The blocks hold `rowsPerBlock` rows each and are released. Lengths are measured here, so
/// that rows are half as large. Fails if `progress` returns false.
Status AssembleCloudGraph(const CloudSetup& setup, Id numberOfPoints, Id rowsPerBlock,
  std::vector<CloudRowBlock>& blocks, bool wide, const ParallelFor& parallel,
  const ProgressCallback& progress, GeodesicGraph& graph);

/// Components of a graph, numbered from the largest on, by the first vertex where sizes are equal.
/// Vertices whose `isUsed` is 0 belong to none.
void FindCloudComponents(const GeodesicGraph& graph, const std::vector<unsigned char>& isUsed,
  std::vector<Id>& components, std::vector<Id>& sizes);
}

#endif
