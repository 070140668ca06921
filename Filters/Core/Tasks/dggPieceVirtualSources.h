// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources on a surface that several processes have in pieces. Internal.
#ifndef dggPieceVirtualSources_h
#define dggPieceVirtualSources_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggParallel.h"       // for ParallelFor
#include "dggPieceSearch.h"    // for the relays
#include "dggProcessGroup.h"   // for messages
#include "dggSurfaceRegion.h"  // for the region
#include "dggVirtualSources.h" // for VirtualSources

#include <vector> // for distances

namespace dgg
{
class RelayMerger;

/// Merges the relays of the virtual sources of a search, as FindVirtualSources() does. All
/// functions must be called by all processes.
class DGG_CORE_EXPORT PieceVirtualSources
{
public:
  /// Prepares the mesh of the piece, with a layer of cells around it. `isUsable` becomes false on
  /// all processes for the reasons of SurfaceRegion::Start().
  Status Prepare(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);

  /// Makes `areFine` false on all processes unless the triangles are fine enough for virtual
  /// sources (HasCoarseTriangles()). `labels` are per point of the piece. If rounding decides,
  /// triangles count as coarse, because sums over pieces are rounded differently.
  Status CheckTriangles(
    ProcessGroup& group, const std::vector<double>& labels, double accuracy, bool& areFine) const;

  /// Finds the virtual source of each point of the piece. `found` has estimates and relays. Offset
  /// plus length of a virtual source equals the entry of `distances`. `inUse` are the bytes that
  /// this process uses besides this object.
  Status Find(ProcessGroup& group, const PieceDistances& found,
    const std::vector<double>& distances, const ParallelFor& parallel, double inUse,
    VirtualSources& sources) const;

private:
  struct Forest;

  Status FindForest(
    ProcessGroup& group, const PieceDistances& found, double inUse, Forest& forest) const;
  Status Merge(ProcessGroup& group, const Forest& forest, const RelayMerger& merger, double inUse,
    std::vector<double>& lengths) const;
  std::vector<double> ToMesh(const std::vector<double>& values) const;
  double GetMemorySize() const;

  SurfaceRegion Region;
  RegionMesh Mesh;
  std::vector<Id> Ranks; // per point of the region, its vertex of the mesh
};
}

#endif
