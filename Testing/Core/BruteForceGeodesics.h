// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Reference implementation for small meshes, independent of the window code of the kernel and
/// without its optimizations.
#ifndef BruteForceGeodesics_h
#define BruteForceGeodesics_h

#include "dggSurfaceMesh.h"

#include <vector>

namespace dggtest
{
/// Returns the distances between all pairs of vertices, row by row. The cones of straight lines
/// from every vertex are laid out in the plane through all face sequences. A cone is discarded only
/// if it is farther than the bound of the edge graph for all vertices. The straight distances are
/// then joined at vertices (Floyd and Warshall). Every value is the length of a real path, and a
/// shortest path consists of straight pieces between vertices, so the values are exact.
std::vector<double> BruteForceDistances(const dgg::SurfaceMesh& mesh);
}

#endif
