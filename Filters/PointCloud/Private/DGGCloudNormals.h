// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Normals of a point cloud, by PCL. Internal.
#ifndef DGGCloudNormals_h
#define DGGCloudNormals_h

#include "dggTypes.h" // for Status

#include <vector> // for the normals

/// Fits a plane to the nearest `numberOfNeighbors` points of each point, including the point, on
/// the threads of VTK. `normals` receives three numbers per point: a unit vector, or zeros if the
/// point is not finite or an outlier (dggOutliers.h), or if its neighbors do not define a plane.
/// The sign of normals is arbitrary, but reproducible. `positions` are x y z per point.
dgg::Status DGGEstimateNormals(const double* positions, dgg::Id numberOfPoints,
  int numberOfNeighbors, const dgg::ProgressCallback& progress, std::vector<double>& normals);

#endif
