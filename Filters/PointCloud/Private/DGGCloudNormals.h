// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Normals of a point cloud, by PCL. Internal.
#ifndef DGGCloudNormals_h
#define DGGCloudNormals_h

#include "dggTypes.h" // for Status

#include <vector> // for the normals

/// Fit a plane to the nearest `numberOfNeighbors` points of each point, itself included, on the
/// threads of VTK. `normals` receives three numbers per point, of length 1 or all 0 where a point
/// is not finite, or an outlier (dggOutliers.h), or its neighbours define no plane. Which side they
/// point to is arbitrary, though always the same. `positions` are x y z per point.
dgg::Status DGGEstimateNormals(const double* positions, dgg::Id numberOfPoints,
  int numberOfNeighbors, const dgg::ProgressCallback& progress, std::vector<double>& normals);

#endif
