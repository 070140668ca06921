// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a surface says about a layout before anything is drawn. Internal.
#ifndef dggLayoutSurvey_h
#define dggLayoutSurvey_h

#include "dggExactPath.h"   // for ExactPathFinder
#include "dggLayoutOrder.h" // for EdgeOrder
#include "dggSurfacePath.h" // for SurfacePath

#include <array>  // for edges
#include <vector> // for lists

namespace dgg
{
/// Shortest paths between the landmarks of all edges of a layout, whatever they cross.
class LayoutSurvey
{
public:
  LayoutSurvey(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& landmarks,
    const std::vector<std::array<Id, 2>>& edges)
    : Mesh(mesh)
    , Landmarks(landmarks)
    , Edges(edges)
    , Paths(edges.size())
  {
  }

  /// Find the paths. `unconnected` receives an edge whose landmarks are not connected, or NoId;
  /// then there are not all of them.
  Status FindPaths(const ProgressCallback& progress, Id& unconnected);

  /// Per edge.
  const std::vector<SurfacePath>& GetPaths() const { return this->Paths; }
  /// The order in which the paths leave each landmark. No edges where that is not found out: it is
  /// a hint.
  std::vector<EdgeOrder> FindOrders() const;

private:
  Status FindPathsFrom(
    ExactPathFinder& finder, Id landmark, const ProgressCallback& progress, Id& unconnected);

  const SurfaceMesh& Mesh;
  const std::vector<SurfacePoint>& Landmarks;
  const std::vector<std::array<Id, 2>>& Edges;
  std::vector<SurfacePath> Paths;
};
}

#endif
