// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances along mesh edges: an upper bound of geodesic distances.
#ifndef EdgeGraph_h
#define EdgeGraph_h

#include "dggExactGeodesics.h"

#include <vector>

namespace dggtest
{
/// Returns the shortest distance per vertex over the mesh edges (Dijkstra); Infinity where
/// unreached. Sources are those of ExactGeodesics. A source that is not at a vertex starts at the
/// corners of its face. Sources that do not exist on the mesh are ignored.
std::vector<double> EdgeGraphDistances(
  const dgg::SurfaceMesh& mesh, const std::vector<dgg::GeodesicSource>& sources);
}

#endif
