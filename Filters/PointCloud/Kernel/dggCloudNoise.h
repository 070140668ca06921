// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces fitted to the neighbours of points, and points that are scattered about them. Internal.
#ifndef dggCloudNoise_h
#define dggCloudNoise_h

#include "dggCloudSetup.h" // for CloudSetup
#include "dggSetupLoop.h"  // for SetupLoop

#include <vector> // for what is known of nodes

namespace dgg
{
/// What the surfaces fitted to the neighbours of nodes show of them, besides normals.
struct CloudFits
{
  std::vector<float> Curvatures; ///< the largest of each
  std::vector<float> Residuals;  ///< how far neighbours lie off
  std::vector<Point3> ToSurface; ///< from the node
  double OffSurface = 0.0;       ///< share of nodes whose neighbours lie on no surface
};

/// How noisy a cloud is.
struct CloudNoise
{
  /// Median distance of nodes from the surface that they were moved to, in units of nodes; 0 when
  /// they were not.
  double Removed = 0.0;
  /// That by the median radius of curvature of the surface.
  double RemovedByRadius = 0.0;
  /// Share of nodes whose neighbours lie on no surface, as many as were looked at: the fitted one
  /// misses them by more than a quarter of the radius that they are in.
  double OffSurface = 0.0;
  /// When more than a tenth are such nodes, how far nodes typically lie off a surface, in spacings;
  /// otherwise 0.
  double Scatter = 0.0;
};

/// Fit surfaces to the nearest points of all nodes: spacings and normals of the pairs, and `fits`.
/// False when stopped.
bool FitSurfaces(CloudSetup& setup, double share, SetupLoop& loop, CloudFits& fits);

/// See whether the surface is smooth at each node. When the cloud as a whole is noisy, move nodes
/// to the surface, and fit anew. Takes that share of the progress when it does. False when stopped.
bool RemoveNoise(
  CloudSetup& setup, double share, SetupLoop& loop, CloudFits& fits, CloudNoise& noise);
}

#endif
