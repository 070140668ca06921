// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Incremental drawing of a layout on one surface. Internal.
#ifndef dggLayoutDrawing_h
#define dggLayoutDrawing_h

#include "dggExactPath.h"         // for paths
#include "dggLayoutOrder.h"       // for EdgeOrder, LayoutSector
#include "dggPatchBoundaries.h"   // for PatchSurface
#include "dggSurfaceRefinement.h" // for SubMesh

#include <string> // for the name
#include <vector> // for curves

namespace dgg
{
/// The curves drawn so far on a surface, and the surface cut open along them.
class LayoutDrawing
{
public:
  LayoutDrawing(
    const PatchSurface& surface, const std::vector<std::array<Id, 2>>& edges, std::string name)
    : Mesh(surface.Mesh)
    , Landmarks(surface.Landmarks)
    , Edges(edges)
    , Name(std::move(name))
    , Curves(edges.size())
  {
    this->Surface.IsDrawn.assign(edges.size(), 0);
  }

  /// Starts without curves. Fails if the surface or the landmarks are unsuitable.
  Status Begin();

  /// Computes shortest paths between the landmarks of all edges, ignoring crossings: their lengths,
  /// and the order in which they leave the landmarks.
  Status Survey(const ProgressCallback& progress, std::vector<double>& lengths,
    std::vector<EdgeOrder>& orders) const;

  /// Draws an edge between its neighbors in the order around its landmarks. If the order is
  /// unknown, the edge is drawn anywhere, and the order is updated.
  Status Draw(Id edge, std::vector<EdgeOrder>& orders, const ProgressCallback& progress);

  /// Finds all sectors, and the Euler characteristic of each part; a disk has 1.
  void FindParts(std::vector<LayoutSector>& sectors, std::vector<Id>& characteristics) const;

  std::vector<SurfacePath>& GetCurves() { return this->Curves; }
  const std::string& GetName() const { return this->Name; }
  /// Returns for each landmark the boundary loop that contains it, NoId in the interior.
  std::vector<Id> FindBoundaryLoops() const;

private:
  /// A path between two sectors.
  struct Connection
  {
    SurfacePath Path;
    LayoutSector From;
    LayoutSector To;
  };

  Status FindPathsFrom(ExactPathFinder& finder, Id landmark, const ProgressCallback& progress,
    std::vector<SurfacePath>& paths) const;
  std::vector<EdgeOrder> FindOrders(const std::vector<SurfacePath>& paths) const;
  Status CheckSurface() const;
  Status CheckLandmarks() const;
  Status Refine(const SurfacePath* more, SubMesh& refined) const;
  Status Cut();
  Status Connect(const std::vector<LayoutSector>& from, const std::vector<LayoutSector>& to,
    const ProgressCallback& progress, Connection& connection) const;
  Status KeepClear(
    Id edge, const ProgressCallback& progress, Connection& connection, SubMesh& refined) const;
  bool KeepsClear(const SubMesh& refined) const;
  Status Trace(const LayoutSector& from, const std::vector<LayoutSector>& to,
    const ProgressCallback& progress, SurfacePath& path, std::size_t& reached) const;
  Status TraceClear(const LayoutSector& from, const LayoutSector& to,
    const ProgressCallback& progress, SurfacePath& path) const;
  void MarkObstacles(Id from, Id to, std::vector<char>& isBlocked, std::vector<char>& isCut) const;
  Status Refuse(Id edge, const std::string& reason) const;

  const SurfaceMesh& Mesh;
  const std::vector<SurfacePoint>& Landmarks;
  const std::vector<std::array<Id, 2>>& Edges;
  std::string Name;
  std::vector<SurfacePath> Curves; // per edge
  DrawnSurface Surface;
  std::vector<LayoutSector> Sectors; // Part is not set
};
}

#endif
