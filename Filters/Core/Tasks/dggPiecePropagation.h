// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual source propagation on a surface that several processes have in pieces. Internal.
#ifndef dggPiecePropagation_h
#define dggPiecePropagation_h

#include "dggCoreExport.h"        // for DGG_CORE_EXPORT
#include "dggPieceSurface.h"      // for the surface
#include "dggSourcePropagation.h" // for the solver

#include <memory> // for the solver
#include <vector> // for sources

namespace dgg
{
struct DistanceOutput;
struct DistanceRequest;
struct PlacedSource;

/// Virtual source propagation in pieces, prepared once for each surface. All functions must be
/// called by all processes.
class DGG_CORE_EXPORT PiecePropagation
{
public:
  /// Prepares the propagation unless no piece has changed. `isUsable` becomes false on all
  /// processes if the pieces must be gathered: for the reasons of PieceSurface::Prepare(), if a
  /// vertex is irregular, if a piece has points that only cells of other processes use, and if
  /// triangles may be too long.
  Status Prepare(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);

  /// Computes distances and adds them as arrays of the points of the piece. Everything except for
  /// the pieces must be the same on all processes; the request must not include nearest and virtual
  /// sources. For `tolerance` see SourceCollection::Locate(). `isDone` becomes false on all
  /// processes if a source has no cells. The surface of the context is not used.
  Status Run(const TaskContext& context, ProcessGroup& group, const SourceCollection& sources,
    double tolerance, PropagationQuality quality, const DistanceRequest& request,
    DistanceOutput& output, bool& isDone) const;

private:
  Status PrepareSurface(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);
  double GetMemorySize() const;
  Status FindSources(ProcessGroup& group, const SourceCollection& sources, double tolerance,
    std::vector<GeodesicSource>& points, std::vector<PlacedSource>& positions,
    bool& areFound) const;

  PieceSurface Surface;
  std::unique_ptr<SourcePropagation> Solver; // null unless prepared
  std::vector<Signature> Pieces;             // of all pieces, if prepared
  Offset NumberOfPoints = 0;                 // of the piece
};
}

#endif
