// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Normals of a point cloud, by PCL. Internal.
#ifndef dggCloudNormals_h
#define dggCloudNormals_h

#include "dggTaskContext.h" // for the cloud and the threads

#include <vector> // for the normals

namespace dgg
{
/// Fits a plane to the nearest `numberOfNeighbors` points of each point of the cloud, including the
/// point. `normals` receives three numbers per point: a unit vector, or zeros if the point is not
/// finite or an outlier (dggOutliers.h), or if its neighbors do not define a plane. The sign of
/// normals is arbitrary, but reproducible.
Status EstimateNormals(const TaskContext& context, int numberOfNeighbors,
  const ProgressCallback& progress, std::vector<double>& normals);
}

#endif
