// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A layout on its way onto one surface. Internal.
#ifndef dggLayoutDrawing_h
#define dggLayoutDrawing_h

#include "dggLayoutOrder.h"       // for EdgeOrder
#include "dggPatchBoundaries.h"   // for PatchSurface
#include "dggSurfaceCut.h"        // for CutSurface
#include "dggSurfaceRefinement.h" // for RefinedSurface

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
    , IsDrawn(edges.size(), 0)
  {
  }

  /// Start with no curve. Fails when the surface or the landmarks are unfit.
  Status Begin();

  /// Shortest paths between the landmarks of all edges, whatever they cross: their lengths, and
  /// the order in which they leave the landmarks.
  Status Survey(const ProgressCallback& progress, std::vector<double>& lengths,
    std::vector<EdgeOrder>& orders) const;

  /// Draw an edge between the curves that come before and after it in the order around its
  /// landmarks; where that is not known, anywhere, and then it becomes known.
  Status Draw(Id edge, std::vector<EdgeOrder>& orders, const ProgressCallback& progress);

  /// A corner of what lies between the curves: a sector of a landmark, from a curve
  /// counter-clockwise to the next one; NoId stands for the boundary of the surface.
  struct Sector
  {
    Id Landmark = NoId;
    Id Begin = NoId;
    Id End = NoId;
    bool IsWhole = false; ///< goes all the way round: there is no curve yet
    Id Vertex = NoId;     ///< of the surface cut open
    Id Part = NoId;       ///< of the surface, as the curves divide it
  };
  /// All corners, and the Euler characteristic of each part. A disk has 1.
  void FindParts(std::vector<Sector>& sectors, std::vector<Id>& characteristics) const;

  std::vector<SurfacePath>& GetCurves() { return this->Curves; }
  const std::string& GetName() const { return this->Name; }
  /// Boundary loop of the surface that each landmark is on, NoId in the interior.
  std::vector<Id> FindBoundaryLoops() const;

private:
  Status CheckSurface() const;
  Status CheckLandmarks() const;
  Status Refine(const SurfacePath* more, RefinedSurface& refined) const;
  Status Cut();
  void FindSectors();
  Id FindCurve(Id landmark, Id neighbour) const;
  std::vector<Sector> FindAllowed(Id landmark, const EdgeOrder& order, Id edge) const;
  bool Allows(const Sector& sector, const EdgeOrder& order, Id edge) const;
  bool KeepsClear(const RefinedSurface& refined) const;
  Status Trace(const Sector& from, const std::vector<Sector>& to, const ProgressCallback& progress,
    SurfacePath& path, std::size_t& reached) const;
  Status TraceClear(const Sector& from, const Sector& to, const ProgressCallback& progress,
    SurfacePath& path) const;
  void MarkObstacles(Id from, Id to, std::vector<char>& isBlocked, std::vector<char>& isCut) const;
  Status Refuse(Id edge, const std::string& reason) const;

  const SurfaceMesh& Mesh;
  const std::vector<SurfacePoint>& Landmarks;
  const std::vector<std::array<Id, 2>>& Edges;
  std::string Name;
  std::vector<SurfacePath> Curves; // per edge
  std::vector<char> IsDrawn;       // per edge
  // The refined surface has the landmarks' single points as its first paths, then the curves.
  RefinedSurface Refined;
  std::vector<Id> DrawnEdges; // in the order of those paths
  CutSurface Opened;
  SurfaceMesh OpenedMesh;
  std::vector<Sector> Sectors; // without Part
};
}

#endif
