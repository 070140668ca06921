// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The published indirect construction in steps: candidates, and what pruning leaves of them.
#ifndef CandidateGraph_h
#define CandidateGraph_h

#include "dggGeodesicGraph.h" // for GeodesicGraph
#include "dggSurfaceMesh.h"   // for SurfaceMesh

enum class PruningRule
{
  None,
  Progress, ///< ours: GraphConstruction::Indirect
  /// A candidate (s,t) goes if some candidate r has w(s,r) + w(r,t) <= (1 + accuracy) w(s,t) (Fang
  /// 2019, sec. 3.3, the condition as printed, in a procedure that works: the printed one removes
  /// every edge). Candidates that are removed go on to serve as evidence, and sides of triangles
  /// are not spared, so that errors add up and two candidates can remove each other.
  Published
};

struct CandidateStatistics
{
  double CandidatesPerVertex = 0.0; ///< directed, before pruning
  double FindingSeconds = 0.0;
  double PruningSeconds = 0.0;
};

/// Build the graph of all candidates, pruned by a rule; empty on failure.
dgg::Status BuildFromCandidates(const dgg::SurfaceMesh& mesh, double accuracy, PruningRule rule,
  dgg::GeodesicGraph& graph, CandidateStatistics& statistics);

#endif
