// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of filters of the Laplacian: spheres, results as vectors, closed
/// forms.
#ifndef SpectralTestTools_h
#define SpectralTestTools_h

#include "FilterTestTools.h"

#include "vtkSpectralAlgorithm.h"

namespace dggtest
{
/// Returns the icosahedron on the unit sphere, each triangle subdivided into four `level` times.
vtkSmartPointer<vtkPolyData> MakeSphere(int level);

/// Returns a component of a result array at the points of an output; empty if the array is missing.
std::vector<double> GetValues(vtkPolyData* output, const std::string& name, int component = 0);

/// Returns a point of a triangle by barycentric coordinates.
std::array<double, 3> PointInCell(
  vtkPolyData* surface, vtkIdType cell, const std::array<double, 3>& barycentric);
/// Returns one third of the area of the triangles around each point.
std::vector<double> GetPointAreas(vtkPolyData* surface);

/// Returns the cosine of the angle between two vectors.
double CosineOf(const double a[3], const double b[3]);
/// Returns the Green's function of the unit sphere with mean 0.
double SphereGreens(double cosine);
}

#endif
