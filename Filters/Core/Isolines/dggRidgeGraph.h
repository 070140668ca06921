// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pieces of ridges, and how they hang together. Internal.
#ifndef dggRidgeGraph_h
#define dggRidgeGraph_h

#include "dggRidges.h"       // for Ridges
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for nodes and arcs

namespace dgg
{
/// A graph on a surface: nodes are points of it, arcs polylines within one face.
class RidgeGraph
{
public:
  explicit RidgeGraph(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , NodeOfVertex(mesh.GetNumberOfVertices(), NoId)
  {
  }

  Id AddNode(const SurfacePoint& point);
  /// The node at a vertex, of which there is one.
  Id AddVertex(Id v);
  /// An arc in a face; nothing when it is empty.
  void AddArc(Id from, Id to, Id face, double angle, std::vector<SurfacePoint> between);

  /// Polylines from nodes that do not have two arcs to others, and closed ones.
  void MakeLines(Ridges& ridges) const;

private:
  struct Arc
  {
    Id From;
    Id To;
    Id Face;
    double Angle;
    std::vector<SurfacePoint> Between;
  };

  void Follow(Id node, Id arc, const std::vector<Id>& first, const std::vector<Id>& arcsAt,
    std::vector<bool>& isUsed, Ridges& ridges) const;

  const SurfaceMesh& Mesh;
  std::vector<Id> NodeOfVertex;
  std::vector<SurfacePoint> Nodes;
  std::vector<Arc> Arcs;
};
}

#endif
