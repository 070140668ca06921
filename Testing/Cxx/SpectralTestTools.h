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
/// Both, the second one moved along x; points and cells of the first one come first.
vtkSmartPointer<vtkPolyData> MakePair(vtkPolyData* first, vtkPolyData* second, double shift);

/// Component of a result array at the points of an output; nothing when it is missing.
std::vector<double> GetValues(vtkPolyData* output, const std::string& name, int component = 0);

/// A point of a triangle, by barycentric coordinates.
std::array<double, 3> PointInCell(
  vtkPolyData* surface, vtkIdType cell, const std::array<double, 3>& barycentric);
/// A third of the areas of the triangles around each point.
std::vector<double> GetPointAreas(vtkPolyData* surface);

/// The progress grows. Stopped at each of the fractions, which is no error, the output is empty;
/// the next update has the same values again. `values` reads them from the output.
void ExpectProgressAndStops(vtkAlgorithm* filter, const std::vector<double>& stops,
  const std::function<std::vector<double>()>& values);

/// The cosine of the angle between two vectors.
double CosineOf(const double a[3], const double b[3]);
/// The Green's function of the unit sphere, mean 0.
double SphereGreens(double cosine);
}

#endif
