// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Links of points close to a cloud to its graph. Internal.
#ifndef dggCloudLinks_h
#define dggCloudLinks_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphBuilder.h"  // for GraphLink
#include "dggSurfacePoint.h"  // for SurfacePoint

#include <vector> // for the links

namespace dgg
{
/// Returns the links of a position to the graph of a cloud. A point of the cloud is linked to
/// itself; a position near a point, to that point and to its neighbors in the graph. The latter
/// links are straight lines, lengthened by the ratio of arc and chord of the edge from the point to
/// the neighbor. `positions` are those of the vertices, x y z each.
std::vector<GraphLink> LinkToCloud(
  const GraphView& graph, const double* positions, const SurfacePoint& place);

/// Returns the distance of two positions near the same point of a cloud, or near neighbors in its
/// graph. Infinity for others, and if one of them is a point of the cloud.
double MeasureDirectly(
  const GraphView& graph, const double* positions, const SurfacePoint& a, const SurfacePoint& b);
}

#endif
