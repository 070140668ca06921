// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Closest points of a surface that several processes have in pieces. Internal.
#ifndef dggPieceLocator_h
#define dggPieceLocator_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggLocator.h"      // for closest points
#include "dggProcessGroup.h" // for messages

#include <cstddef> // for std::size_t
#include <memory>  // for the locator
#include <vector>  // for cells

namespace dgg
{
struct SourceCollection;

/// Surface points of this process out of those of all processes.
struct PiecePoints
{
  std::vector<std::size_t> Indices; ///< among the points of all processes
  std::vector<SurfacePoint> Points;

  void Add(std::size_t index, const SurfacePoint& point)
  {
    this->Indices.push_back(index);
    this->Points.push_back(point);
  }
};

/// Finds the points of a surface that are closest to positions, as one process does. Each process
/// has the mesh of its piece with all cells around those of the piece. Functions with a group must
/// be called by all processes.
class DGG_CORE_EXPORT PieceLocator
{
public:
  /// Prepares searches. `mesh`, `positions` (x y z per vertex) and `cellIds` (per face, the global
  /// id of a cell of the piece, or NoId) must outlive this object.
  Status Prepare(ProcessGroup& group, const SurfaceMesh& mesh, const double* positions,
    const std::vector<Offset>& cellIds);

  /// Finds the positions of a collection, which is the same on all processes, whose closest points
  /// are in cells of this process, and adds these points to those here. Of several closest
  /// cells, the one with the smallest id counts. Fails under the conditions of
  /// SourceCollection::Locate(). The arrays of the collection that identify points are not used.
  Status Locate(ProcessGroup& group, const SourceCollection& sources, double tolerance,
    PiecePoints& here) const;

  /// Returns the closest point of the mesh, which must have a face.
  SurfacePoint FindClosestPoint(const std::array<double, 3>& position) const;

private:
  const SurfaceMesh* Mesh = nullptr;
  const std::vector<Offset>* CellIds = nullptr;
  Box SurfaceBox;                                      // bounding box of the entire surface
  std::unique_ptr<const SurfaceLocator> ClosestPoints; // null without faces
};
}

#endif
