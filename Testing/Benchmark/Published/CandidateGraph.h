// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The published indirect construction in steps: candidates, and pruning.
#ifndef CandidateGraph_h
#define CandidateGraph_h

#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggSurfaceMesh.h"   // for SurfaceMesh

enum class PruningRule
{
  None,
  Progress, ///< ours: GraphConstruction::Indirect
  /// Removes a candidate (s,t) if some candidate r has w(s,r) + w(r,t) <= (1 + accuracy) w(s,t)
  /// (Fang 2019, sec. 3.3; the condition as printed, in a corrected procedure: the printed one
  /// removes every edge). Removed candidates still serve as r, and sides of triangles are not
  /// exempt; thus errors accumulate, and two candidates can remove each other.
  Published
};

struct CandidateStatistics
{
  double CandidatesPerVertex = 0.0; ///< directed, before pruning
  double FindingSeconds = 0.0;
  double PruningSeconds = 0.0;
};

/// Builds the graph of all candidates, pruned by a rule; the graph is empty on failure.
dgg::Status BuildFromCandidates(const dgg::SurfaceMesh& mesh, double accuracy, PruningRule rule,
  dgg::GeodesicGraph& graph, CandidateStatistics& statistics);

#endif
