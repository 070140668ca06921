// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points close to a cloud, linked to its graph. Internal.
#ifndef dggCloudLinks_h
#define dggCloudLinks_h

#include "dggGraphBuilder.h" // for GraphLink

#include <vector> // for the links

namespace dgg
{
/// Links a point to the graph of a cloud. A point of the cloud is linked to itself. A point near a
/// cloud point is linked to this cloud point and to the neighbors of the cloud point in the graph.
/// The ratio of such a link to the straight line equals that of the edge to the same neighbor.
/// `direct` is the distance to each aim near the same cloud point or near a neighbor, measured in
/// the same manner; Infinity for other aims, and if the point or the aim is a point of the cloud.
/// `positions` has x y z per vertex.
DGG_CORE_EXPORT void LinkToCloud(const GraphView& graph, const double* positions,
  const SurfacePoint& point, const std::vector<SurfacePoint>& aims, std::vector<GraphLink>& links,
  std::vector<double>& direct);
}

#endif
