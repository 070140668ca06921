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
/// Links a point to the graph of a cloud: a point of the cloud to itself, a point near one to that
/// one and to its neighbors in the graph. Such links are as much longer than straight lines as the
/// edge to the neighbor is. `direct` is the distance to each aim near the same point or near a
/// neighbor, measured alike; infinity for other aims and if either is a point of the cloud.
/// `positions` has x y z per vertex.
DGG_CORE_EXPORT void LinkToCloud(const GraphView& graph, const double* positions,
  const SurfacePoint& point, const std::vector<SurfacePoint>& aims, std::vector<GraphLink>& links,
  std::vector<double>& direct);
}

#endif
