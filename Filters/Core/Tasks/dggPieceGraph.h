// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graph of a surface that several processes have in pieces. Internal.
#ifndef dggPieceGraph_h
#define dggPieceGraph_h

#include "dggBuffer.h"        // for the ghosts
#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggGeodesicGraph.h" // for the rows
#include "dggGraphBuilder.h"  // for the options
#include "dggProcessGroup.h"  // for messages
#include "dggStoredGraph.h"   // for the ghosts
#include "dggSurfacePieces.h" // for pieces

#include <string> // for warnings
#include <vector> // for pieces

namespace dgg
{
struct TaskContext;

/// The part of a graph that belongs to a piece of a surface. Vertices are the points of the piece,
/// followed by ghosts: points of other pieces at the ends of edges. Vertices that belong to this
/// process (SurfaceRegion) have all of their edges, and others have their edges to these.
/// `Info.Surface` is the signature of all pieces.
struct PieceGraph
{
  GeodesicGraph Rows;
  Buffer<Offset> GhostIds; ///< global ids, ascending
  Buffer<Id> Owners;       ///< see GhostVertices
  Signature Piece{};       ///< ComputeSignature() of the piece
};

/// Returns the signature of a piece; zeros for an empty one.
DGG_CORE_EXPORT Signature ComputeSignature(const SurfacePiece& piece);
/// Returns the signature of all pieces, which does not depend on their order.
DGG_CORE_EXPORT Signature SumSignatures(const std::vector<Signature>& pieces);

/// Replaces options by those of the first process, except for callbacks and threads.
DGG_CORE_EXPORT Status ShareOptions(ProcessGroup& group, GraphOptions& options);

/// Builds the graph of a surface together with the other processes; each one builds the rows of its
/// piece, which has no ghosts. All pieces together are the graph that one process would build of
/// the surface that JoinSurfacePieces() makes, bit by bit. `isUsable` becomes false on all
/// processes if the pieces must be gathered instead: for the reasons of SurfaceRegion::Start(), and
/// for faces that are degenerate or not oriented consistently. The options must be the same on all
/// processes, and not ask for the indirect construction. The surface of the context is not used.
/// `warnings` are those of the surface, except for coincident points of the boundary. If this
/// process fails or throws alone, ProcessGroup::Agree() ends the others.
DGG_CORE_EXPORT Status BuildPieceGraph(const TaskContext& context, ProcessGroup& group,
  const SurfacePiece& piece, GraphOptions options, PieceGraph& graph, GraphEstimate& estimate,
  std::vector<std::string>& warnings, bool& isUsable);

/// A piece of a stored graph, to be joined.
struct StoredPiece
{
  GraphView Rows;
  GhostVertices Ghosts;
  const std::vector<Offset>* Points = nullptr; ///< per point of the piece, its id on the surface
};

/// Joins the graphs of all pieces. `globalIds` are those of the points of the surface, ascending;
/// they are used if there is more than one piece.
DGG_CORE_EXPORT Status JoinPieceGraphs(const std::vector<StoredPiece>& pieces,
  const Offset* globalIds, Offset numberOfPoints, GeodesicGraph& graph);
}

#endif
