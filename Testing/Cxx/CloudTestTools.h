// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of filters on point clouds share.
#ifndef CloudTestTools_h
#define CloudTestTools_h

#include "FilterTestTools.h"

#include "vtkPointCloudDGG.h"

#include <string>
#include <vector>

namespace dggtest
{
/// A cloud with points stored as doubles and no cells.
vtkSmartPointer<vtkPolyData> MakeCloud(const Points& points);

/// n x n points over [0, 1] x [0, 1], moved within the plane by up to `jitter` of their distance.
Points MakeFlatPoints(int n, double jitter = 0.0);
/// Points spread evenly over the unit sphere, along a spiral.
Points MakeSpherePoints(int n);
/// Random points of a unit cube: they lie on no surface.
Points MakeVolumePoints(int n);
/// All points moved by a vector.
Points Move(Points points, const std::array<double, 3>& by);
/// The points of both.
Points Join(Points first, const Points& second);

/// The cloud with its graph, a copy of its own.
vtkSmartPointer<vtkPolyData> MakeCloudWithGraph(const Points& points);

/// Names of the field arrays of a cloud.
const std::vector<std::string>& GetCloudArrayNames();
/// All bytes of these, one string for each; empty for a missing one.
std::vector<std::string> GetCloudBytes(vtkPolyData* data);
std::vector<int> GetComponents(vtkPolyData* data);

double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b);
/// Along the unit sphere.
double SphereDistance(const std::array<double, 3>& a, const std::array<double, 3>& b);

/// Mean of |value / exact - 1| over all points but the one where it is 0.
double GetMeanCloudError(const std::vector<double>& values, const std::vector<double>& exact);
}

#endif
