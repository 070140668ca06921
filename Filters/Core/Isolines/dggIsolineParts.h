// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pieces of isolines per edge and face, and their connection. Internal.
#ifndef dggIsolineParts_h
#define dggIsolineParts_h

#include "dggBlockLoop.h"     // for ForBlocks
#include "dggDistanceField.h" // for DistanceField
#include "dggEdges.h"         // for FindEdge
#include "dggIsolines.h"      // for Isolines
#include "dggProgressPart.h"  // for ProgressPart

#include <array>    // for barycentric coordinates
#include <iterator> // for moving pieces
#include <limits>   // for the largest number of them
#include <vector>   // for the pieces

namespace dgg
{
/// A point where an isoline crosses an edge. All faces of the edge share it.
struct LevelCrossing
{
  Id HalfEdge = NoId; ///< the representative of the edge (FindEdge())
  Id Level = 0;       ///< index into the levels, which increase
  Id Interval = 0;    ///< for Apollonius: the preceding node of the edge
  double X = 0.0;     ///< abscissa from the origin of the half-edge, in [0, length]
};

/// All crossings on the edges of reached faces.
struct LevelCrossings
{
  /// Crossings, sorted by half-edge, level and abscissa.
  std::vector<LevelCrossing> Crossings;
  /// The crossings of half-edge h, if it represents its edge: [Offsets[h], Offsets[h + 1]).
  std::vector<Id> Offsets;
};

/// A piece of an isoline within one face, from one crossing on its boundary to another, or closed.
/// The lower distance is on the left of the piece.
struct FaceCurve
{
  Id Face = NoId;
  Id Level = 0;
  Id First = NoId; ///< start crossing; NoId for a closed curve
  Id Last = NoId;
  /// Barycentric coordinates of the points between both ends, with respect to
  /// SurfaceMesh::GetTriangle(). For a closed curve, the coordinates of all points, without
  /// repeating the first.
  std::vector<std::array<double, 3>> Points;
};

/// Returns true if lines are traced in a face of the edge of a half-edge.
bool IsEdgeTraced(const DistanceField& field, Id h);

/// Runs `work(worker, index, pieces)` for all indices, in blocks, and joins the pieces in order.
template <typename Piece, typename MakeWorker, typename Work>
Status CollectPieces(Offset size, Offset blockSize, const ParallelFor& parallel,
  const ProgressCallback& progress, double start, double stop, const MakeWorker& makeWorker,
  const Work& work, std::vector<Piece>& pieces)
{
  std::vector<std::vector<Piece>> blocks(
    static_cast<std::size_t>((size + blockSize - 1) / blockSize));
  DGG_RETURN_IF_ERROR(ForBlocks(size, blockSize, parallel, ProgressPart(progress, start, stop),
    makeWorker, [&](auto& worker, Offset block, Offset begin, Offset end) {
      for (Offset i = begin; i < end; ++i)
      {
        work(worker, static_cast<Id>(i), blocks[static_cast<std::size_t>(block)]);
      }
    }));
  std::size_t count = 0;
  for (const std::vector<Piece>& block : blocks)
  {
    count += block.size();
  }
  if (count > static_cast<std::size_t>(std::numeric_limits<Id>::max()))
  {
    return InvalidInput("The isolines have more than 2^31 - 1 points or pieces")
      .Fix("Use fewer values");
  }
  pieces.reserve(count);
  for (std::vector<Piece>& block : blocks)
  {
    pieces.insert(
      pieces.end(), std::make_move_iterator(block.begin()), std::make_move_iterator(block.end()));
    std::vector<Piece>().swap(block);
  }
  return Status::Success();
}

/// Runs `work(worker, h, crossings)` for the half-edges that represent edges.
template <typename MakeWorker, typename Work>
Status CollectCrossings(const SurfaceMesh& mesh, Offset blockSize, const ParallelFor& parallel,
  const ProgressCallback& progress, double start, double stop, const MakeWorker& makeWorker,
  const Work& work, LevelCrossings& found)
{
  found = LevelCrossings();
  Status status = CollectPieces(
    mesh.GetNumberOfHalfEdges(), blockSize, parallel, progress, start, stop, makeWorker,
    [&](auto& worker, Id h, std::vector<LevelCrossing>& crossings) {
      if (FindEdge(mesh, h) == h)
      {
        work(worker, h, crossings);
      }
    },
    found.Crossings);
  found.Offsets.assign(static_cast<std::size_t>(mesh.GetNumberOfHalfEdges()) + 1, 0);
  for (const LevelCrossing& crossing : found.Crossings)
  {
    ++found.Offsets[static_cast<std::size_t>(crossing.HalfEdge) + 1];
  }
  for (std::size_t h = 1; h < found.Offsets.size(); ++h)
  {
    found.Offsets[h] += found.Offsets[h - 1];
  }
  return status;
}

/// Joins the curves of faces at shared crossings, sorted by level, then curve. A line ends at a
/// crossing that is not shared by exactly two curves: on the boundary, and on non-manifold edges. A
/// line has the direction of its first curve. Lines that collapse to a point because they snap to a
/// vertex are discarded. Fails when stopped; the result must then not be used.
Status JoinFaceCurves(const SurfaceMesh& mesh, const std::vector<LevelCrossing>& crossings,
  const std::vector<FaceCurve>& curves, const ProgressCallback& progress, Isolines& lines);
}

#endif
