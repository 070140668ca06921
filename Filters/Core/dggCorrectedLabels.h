// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Better estimates of the distance than the lengths of graph paths. Internal.
#ifndef dggCorrectedLabels_h
#define dggCorrectedLabels_h

#include "dggSearchLabels.h" // for GraphSeed, SearchResult
#include "dggSurfaceMesh.h"  // for SurfaceMesh

#include <vector> // for the order

namespace dgg
{
/// Fill the corrected estimates of a finished search. A path in the graph zigzags about the
/// geodesic for which it stands. Unfolded hop by hop into the plane it can be pulled straight: down
/// the tree of paths, each vertex gets the place of the source as seen from itself, a virtual
/// source at some distance in some direction. `order` holds the reached vertices, each after its
/// tail.
void CorrectLabels(const GraphView& graph, const SurfaceMesh& mesh,
  const std::vector<GraphSeed>& seeds, const std::vector<Id>& order, SearchResult& result);
}

#endif
