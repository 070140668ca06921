// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi cells on a surface that several processes have in pieces. Internal.
#ifndef dggPieceVoronoi_h
#define dggPieceVoronoi_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status

namespace dgg
{
class PieceLinks;
class PieceSearch;
class PieceSurface;
class ProcessGroup;
struct DistanceOutput;
struct Output;
struct PieceDistanceOptions;
struct SourceCollection;
struct TaskContext;
struct VoronoiOptions;

/// Computes labels of sites together with the other processes. Writes the point arrays of the piece
/// to `labels`, and the sites of all processes to `sites` on the first one, as WriteVoronoi() does
/// if there are only labels. `options` are those of FindPieceDistances(), which also describes
/// `links` and `isDone`. The names of arrays are those of `voronoi`, and so is the value of
/// unreached points.
DGG_CORE_EXPORT Status FindPieceLabels(const TaskContext& context, ProcessGroup& group,
  const PieceSurface& surface, PieceSearch& search, PieceLinks* links,
  const SourceCollection& collection, const PieceDistanceOptions& options,
  const VoronoiOptions& voronoi, DistanceOutput& labels, Output& sites, bool& isDone);
}

#endif
