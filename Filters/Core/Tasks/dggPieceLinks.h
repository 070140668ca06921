// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of a surface that several processes have in pieces, as seeds. Internal.
#ifndef dggPieceLinks_h
#define dggPieceLinks_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h"  // for links
#include "dggPieceLocator.h"  // for closest points
#include "dggPieceSearch.h"   // for PieceSeed
#include "dggProcessGroup.h"  // for messages
#include "dggSurfaceRegion.h" // for the region

#include <cstddef> // for std::size_t
#include <memory>  // for what depends on the mesh
#include <vector>  // for the seeds

namespace dgg
{
struct SourceCollection;

/// Finds the points of a surface that are closest to positions, and links them to the vertices of a
/// graph, as one process does. All functions must be called by all processes.
class DGG_CORE_EXPORT PieceLinks
{
public:
  /// Prepares searches. `isUsable` becomes false on all processes for the reasons of
  /// SurfaceRegion::Start().
  Status Prepare(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);

  /// Appends the seeds of the positions of a collection, which is the same on all processes and has
  /// no arrays that identify points. Fails under the conditions of SourceCollection::Locate().
  Status Find(ProcessGroup& group, const SourceCollection& sources, double tolerance,
    double accuracy, std::vector<PieceSeed>& seeds);

private:
  /// Link of the point at a position.
  struct PositionLink
  {
    std::size_t Position; // index
    Offset PointId;
    double Length;
    double ArrivalAngle;
  };

  Status MakeMesh(ProcessGroup& group);
  Status LinkHere(const SourceCollection& sources, double accuracy, std::vector<std::size_t>& here,
    std::vector<PositionLink>& links) const;

  SurfaceRegion Region;
  int NextLayers = 0; // of the next growth
  RegionMesh Mesh;
  std::vector<Offset> PointIds; // per vertex of the mesh
  PieceLocator Locator;
  std::unique_ptr<const GraphBuilder> Builder; // null without faces
};
}

#endif
