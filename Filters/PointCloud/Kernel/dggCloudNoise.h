// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces fitted to the neighbours of points, and points that are scattered about them. Internal.
#ifndef dggCloudNoise_h
#define dggCloudNoise_h

#include "dggCloudSetup.h" // for CloudSetup

#include <cstddef>    // for std::size_t
#include <functional> // for NodeLoop
#include <vector>     // for what is told of nodes

namespace dgg
{
/// What the surfaces fitted to the neighbours of nodes tell of them, besides normals.
struct CloudFits
{
  std::vector<float> Curvatures; ///< the largest of each
  std::vector<float> Residuals;  ///< how far neighbours lie off
  std::vector<Point3> ToSurface; ///< from the node
};

/// Calls `body(begin, end)` with ranges of all nodes, in several threads, and takes a share of the
/// progress of all steps. False when the caller has asked to stop.
using NodeLoop = std::function<bool(double share, const std::function<void(Id, Id)>& body)>;

/// Fit surfaces to the nearest points of all nodes: spacings and normals of the pairs, and `fits`.
/// False when stopped.
bool FitSurfaces(CloudSetup& setup, double share, const NodeLoop& loop, CloudFits& fits);

/// See whether the surface is smooth at each node. When the cloud as a whole is noisy, move nodes
/// to the surface, fit anew, and tell the median distance that they had from it in `noise`, in
/// units of nodes. False when stopped.
bool RemoveNoise(CloudSetup& setup, const NodeLoop& loop, CloudFits& fits, double& noise);
}

#endif
