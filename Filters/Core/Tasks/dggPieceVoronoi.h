// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi cells on a surface that several processes have in pieces. Internal.
#ifndef dggPieceVoronoi_h
#define dggPieceVoronoi_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggDistanceOutput.h" // for the labels
#include "dggOutput.h"         // for the cells
#include "dggPieceDistances.h" // for the options
#include "dggVoronoiTask.h"    // for the options

namespace dgg
{
class PieceSurface;

/// Sites on a surface in pieces. Everything except for the pieces must be the same on all
/// processes.
struct PieceVoronoiInput
{
  PieceSearch& Search;
  PieceSurface& Surface; ///< receives more layers of cells if borders need them
  PieceLinks* Links;     ///< may be null if all sites have ids
  const SourceCollection& Sites;
  PieceDistanceOptions Options;
  VoronoiOptions Voronoi; ///< sites are not moved
};

/// Results on one process.
struct PieceVoronoiOutput
{
  DistanceOutput Labels; ///< arrays of the points of the piece
  Output Borders;        ///< in the cells of the piece
  Output Cells;          ///< in the cells of the piece
  Output Sites;          ///< sites of all processes, on the first one
};

/// Computes labels or cells of sites together with the other processes. The outputs are those of
/// WriteVoronoi(), except that borders end where pieces meet, and that areas, which are sums over
/// pieces, may be rounded differently. `isDone` becomes false on all processes if the pieces must
/// be gathered: for the reasons of PieceSearch::Run(), if borders need exact distances, if the work
/// of links would be limited, or if the graph does not connect adjacent vertices.
DGG_CORE_EXPORT Status FindPieceVoronoi(const TaskContext& context, ProcessGroup& group,
  const PieceVoronoiInput& input, PieceVoronoiOutput& output, bool& isDone);
}

#endif
