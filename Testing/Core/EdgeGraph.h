// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances along mesh edges only: an upper bound of the geodesic ones.
#ifndef EdgeGraph_h
#define EdgeGraph_h

#include "dggExactGeodesics.h" // for GeodesicSource

#include <vector> // for the distances

namespace dggtest
{
/// Shortest distances over the mesh edges (Dijkstra) from the same kind of sources as
/// ExactGeodesics takes: per vertex, Infinity where unreached. A source off the vertices starts at
/// the corners of its face. Sources that do not exist on the mesh are passed over.
std::vector<double> EdgeGraphDistances(
  const dgg::SurfaceMesh& mesh, const std::vector<dgg::GeodesicSource>& sources);
}

#endif
