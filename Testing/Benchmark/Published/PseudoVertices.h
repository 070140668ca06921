// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The published remedy for anisotropic triangles: additional vertices in gaps of a graph.
#ifndef PseudoVertices_h
#define PseudoVertices_h

#include "dggGeodesicGraph.h" // for GraphView
#include "dggSurfaceMesh.h"   // for SurfaceMesh

/// Finds gaps larger than sqrt(accuracy) in the directions of the edges of each vertex in the graph
/// of all candidates. Traces geodesics of the median edge length of the vertex into these gaps,
/// evenly, and adds their ends to the mesh as vertices (Fang 2019, sec. 3.3.3; unspecified details
/// follow its prose: this threshold, and the gap between the last and the first edge counts).
/// `refined` is the same surface with more vertices, the original ones first; `added` is their
/// number.
dgg::Status AddPseudoVertices(const dgg::SurfaceMesh& mesh, const dgg::GraphView& graph,
  double accuracy, dgg::SurfaceMesh& refined, dgg::Id& added);

#endif
