// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How far around a source shortest ways do not meet from different sides. Internal.
#ifndef dggRidgeRadius_h
#define dggRidgeRadius_h

#include "dggExactGeodesics.h" // for ExactResult

#include <vector> // for sources

namespace dgg
{
/// The least distance of an edge at whose ends light from the source arrives in directions that
/// differ by more than 60 degrees (once the edge and its ways are laid out in the plane), or
/// Infinity. Behind every convex vertex ways meet from two sides, but hardly differ in direction:
/// these ridges are not meant. Edges within
/// the distance `checked` are left out.
double FindRidgeRadius(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const ExactResult& distances, double checked = 0.0);
}

#endif
