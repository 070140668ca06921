// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths on a surface that several processes have in pieces. Internal.
#ifndef dggPiecePaths_h
#define dggPiecePaths_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPathSearch.h" // for paths

namespace dgg
{
class PieceSearch;
class PieceSurface;
class ProcessGroup;
struct SourceCollection;
struct SurfacePiece;

/// Finds the paths of pairs of points, given by ids, together with the other processes: searches in
/// the graph of all pieces, gathers the cells around the paths to the first process, and traces the
/// paths there. `paths` are those of PathSearch::RunInGraph(), on `surface`, prepared by
/// PieceSurface::PrepareToGather(); they are empty on other processes. Ends and options must be the
/// same on all processes. `isDone` becomes false on all processes for the reasons of
/// PieceSearch::Run(), if a path cannot be traced among the cells around it, or if a point has no
/// edges.
DGG_CORE_EXPORT Status FindPiecePaths(const TaskContext& context, ProcessGroup& group,
  const SurfacePiece& piece, PieceSearch& search, PieceSurface& surface,
  const SourceCollection& ends, const PathOptions& options, PathSearch::Paths& paths, bool& isDone);
}

#endif
