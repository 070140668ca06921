// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of filters of the Laplacian share: spheres, results as vectors, closed forms.
#ifndef SpectralTestTools_h
#define SpectralTestTools_h

#include "FilterTestTools.h"

#include "vtkSpectralAlgorithm.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace dggtest
{
/// The icosahedron, each of its triangles divided into four `level` times, on the unit sphere.
vtkSmartPointer<vtkPolyData> MakeSphere(int level);

/// Component of a result array at the points of an output; nothing when it is missing.
std::vector<double> GetValues(vtkPolyData* output, const std::string& name, int component = 0);

/// A point of a triangle, by barycentric coordinates.
std::array<double, 3> PointInCell(
  vtkPolyData* surface, vtkIdType cell, const std::array<double, 3>& barycentric);
/// A third of the areas of the triangles around each point.
std::vector<double> GetPointAreas(vtkPolyData* surface);

/// The cosine of the angle between two vectors.
double CosineOf(const double a[3], const double b[3]);
/// The Green's function of the unit sphere, mean 0.
double SphereGreens(double cosine);
}

#endif
