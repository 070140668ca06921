// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of filters on point clouds.
#ifndef CloudTestTools_h
#define CloudTestTools_h

#include "FilterTestTools.h"

#include "vtkPointCloudDGG.h"

namespace dggtest
{
/// Returns a cloud with points stored as doubles and no cells.
vtkSmartPointer<vtkPolyData> MakeCloud(const Points& points);

/// Returns n x n points over [0, 1] x [0, 1], moved within the plane by up to `jitter` times their
/// spacing.
Points MakeFlatPoints(int n, double jitter = 0.0);
/// Returns points spread evenly over the unit sphere, along a spiral.
Points MakeSpherePoints(int n);
/// Returns random points in the unit cube. They lie on no surface.
Points MakeVolumePoints(int n);
/// Returns the points translated by a vector.
Points Move(Points points, const std::array<double, 3>& by);
/// Returns the points of `first` followed by those of `second`.
Points Join(Points first, const Points& second);

/// Returns a copy of the cloud with its graph.
vtkSmartPointer<vtkPolyData> MakeCloudWithGraph(const Points& points);

/// Returns the names of the field arrays of a cloud.
const std::vector<std::string>& GetCloudArrayNames();
/// Returns all bytes of these arrays, one string per array; empty for a missing array.
std::vector<std::string> GetCloudBytes(vtkPolyData* data);
std::vector<int> GetComponents(vtkPolyData* data);

double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b);
/// Returns the distance between two points along the unit sphere.
double SphereDistance(const std::array<double, 3>& a, const std::array<double, 3>& b);

/// Returns the mean of |value / exact - 1| over all points except the point with distance 0.
double GetMeanCloudError(const std::vector<double>& values, const std::vector<double>& exact);
}

#endif
