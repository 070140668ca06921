// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces fitted to the neighbors of nodes, and removal of noise. Internal.
#ifndef dggCloudNoise_h
#define dggCloudNoise_h

#include "dggCloudSetup.h" // for CloudSetup
#include "dggSetupLoop.h"  // for SetupLoop

#include <vector> // for per-node arrays

namespace dgg
{
/// Properties, other than normals, of the surface fitted to the neighbors of each node.
struct CloudFits
{
  std::vector<float> Curvatures; ///< largest absolute normal curvature per node
  std::vector<float> Residuals;  ///< RMS distance of the neighbors from the surface, per node
  std::vector<Point3> ToSurface; ///< vector from each node to its surface
  double OffSurface = 0.0;       ///< fraction of nodes whose neighbors lie on no surface
};

/// Noise of a cloud.
struct CloudNoise
{
  /// Median distance of nodes from the surface that they were moved to, estimated by the residuals
  /// of fits, in units of nodes; 0 if nodes were not moved.
  double Removed = 0.0;
  /// Ratio of Removed to the median radius of curvature of the surface.
  double RemovedByRadius = 0.0;
  /// Fraction of nodes whose neighbors, in the number used, lie on no surface: the residual of the
  /// fitted surface exceeds a quarter of the radius of the neighborhood.
  double OffSurface = 0.0;
  /// If OffSurface exceeds 0.1: typical distance of nodes from a surface, in spacings. Otherwise 0.
  double Scatter = 0.0;
};

/// Fits a surface to the nearest points of each node. Sets the spacings and normals of the pairs,
/// and `fits`. `share` is the progress weight of this step. Returns false if stopped.
bool FitSurfaces(CloudSetup& setup, double share, SetupLoop& loop, CloudFits& fits);

/// Sets IsSmooth of each node. If the cloud as a whole is noisy, moves the nodes to the fitted
/// surface and fits again; this takes the progress weight `share`. Returns false if stopped.
bool RemoveNoise(
  CloudSetup& setup, double share, SetupLoop& loop, CloudFits& fits, CloudNoise& noise);
}

#endif
