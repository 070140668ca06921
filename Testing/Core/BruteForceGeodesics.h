// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An oracle for small meshes, written without any of the kernel's window code and without any of
/// its cleverness.
#ifndef BruteForceGeodesics_h
#define BruteForceGeodesics_h

#include "dggSurfaceMesh.h"

#include <vector>

namespace dggtest
{
/// Distances between all pairs of vertices, row after row. From every vertex the cone of light
/// through each face sequence is laid out in the plane, and no cone is dropped unless it is farther
/// than the edge graph's bound for all vertices; the straight distances found are then joined at
/// vertices (Floyd and Warshall). Every value is the length of a real path, and a shortest path
/// consists of straight pieces between vertices, so the values are exact.
std::vector<double> BruteForceDistances(const dgg::SurfaceMesh& mesh);
}

#endif
