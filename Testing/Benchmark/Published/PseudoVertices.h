// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The published remedy for anisotropic triangles: more vertices where a graph has gaps.
#ifndef PseudoVertices_h
#define PseudoVertices_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggSurfaceMesh.h"   // for SurfaceMesh

/// Look for gaps in the directions of the edges of each vertex, those of the graph of all
/// candidates, that are larger than sqrt(accuracy), send geodesics of the median length of its
/// edges into them, evenly, and make their ends vertices of the mesh (Fang 2019, sec. 3.3.3; what
/// it leaves open is decided as in its prose: that threshold, and the gap between the last and the
/// first edge counts). `refined` is the same surface with more vertices, its old ones first;
/// `added` is their number.
dgg::Status AddPseudoVertices(const dgg::SurfaceMesh& mesh, const dgg::GraphView& graph,
  double accuracy, dgg::SurfaceMesh& refined, dgg::Id& added);

#endif
