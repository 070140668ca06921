// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances along the graph of a surface that several processes have in pieces. Internal.
#ifndef dggPieceDistances_h
#define dggPieceDistances_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status

#include <cstddef> // for std::size_t
#include <vector>  // for seeds

namespace dgg
{
class PieceLinks;
class PieceSearch;
class PieceVirtualSources;
class ProcessGroup;
struct DistanceOutput;
struct DistanceRequest;
struct DistanceResults;
struct PieceSeed;
struct SourceCollection;
struct TaskContext;

/// Options of distances in pieces.
struct PieceDistanceOptions
{
  double Tolerance = 0.0; ///< see SourceCollection::Locate()
  double Accuracy = 0.0;  ///< of links
  bool Correct = true;    ///< false: lengths of paths in the graph
};

/// Finds the seeds of a collection, which is the same on all processes. `isolated` receives the
/// indices of seeds at points without edges. `links` may be null if there are no positions. Must be
/// called by all processes.
DGG_CORE_EXPORT Status MakePieceSeeds(ProcessGroup& group, const PieceSearch& search,
  PieceLinks* links, const SourceCollection& sources, const PieceDistanceOptions& options,
  std::vector<PieceSeed>& seeds, std::vector<std::size_t>& isolated);

/// Adds distances of a piece as arrays of its points. Must be called by all processes.
DGG_CORE_EXPORT Status WritePieceDistances(ProcessGroup& group, DistanceResults& results,
  const DistanceRequest& request, DistanceOutput& output);

/// Computes distances together with the other processes, and adds them as arrays of the points of
/// the piece. Arrays of the request receive the lengths of paths, which are upper bounds. The
/// surface of the context is not used. `links` may be null if the collection has no positions, and
/// `virtualSources` if these are not requested. Collection, options and request must be the same on
/// all processes. Sources of points are not available. `isDone` becomes false on all processes for
/// the reasons of PieceSearch::Run(), and if virtual sources need windows.
DGG_CORE_EXPORT Status FindPieceDistances(const TaskContext& context, ProcessGroup& group,
  PieceSearch& search, PieceLinks* links, const PieceVirtualSources* virtualSources,
  const SourceCollection& sources, const PieceDistanceOptions& options,
  const DistanceRequest& request, DistanceOutput& output, bool& isDone);
}

#endif
