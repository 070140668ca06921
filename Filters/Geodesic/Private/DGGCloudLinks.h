// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points close to a cloud, linked to its graph. Internal.
#ifndef DGGCloudLinks_h
#define DGGCloudLinks_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggGraphBuilder.h"  // for GraphLink
#include "dggSurfacePoint.h"  // for SurfacePoint

#include <vector> // for the links

/// Links of a place to the graph of a cloud: of a point of the cloud to itself, of a place near one
/// to that point and to its neighbours in the graph. These are straight, but longer by as much as
/// the edge from that point to the neighbour is: along the surface. `positions` are those of the
/// vertices, x y z each.
std::vector<dgg::GraphLink> DGGLinkToCloud(
  const dgg::GraphView& graph, const double* positions, const dgg::SurfacePoint& place);

/// The same between two places near the same point of a cloud, or near neighbours in its graph;
/// dgg::Infinity for others, and when either is a point of the cloud.
double DGGMeasureDirectly(const dgg::GraphView& graph, const double* positions,
  const dgg::SurfacePoint& a, const dgg::SurfacePoint& b);

#endif
