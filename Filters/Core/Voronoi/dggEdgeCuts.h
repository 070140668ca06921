// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Crossings between the borders of Voronoi cells and the edges of a mesh. Internal.
#ifndef dggEdgeCuts_h
#define dggEdgeCuts_h

#include "dggSiteDistances.h" // for the distances
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include <cstdint> // for layers
#include <vector>  // for the cuts

namespace dgg
{
class BorderRefinement;
struct VoronoiDiagram;

/// A point where the nearest site changes.
struct EdgeCut
{
  double Parameter; ///< from 0 at the origin to 1 at the destination of a half-edge
  Id Before;        ///< site on the side of the origin
  Id After;
  Id Point; ///< point of the diagram
};

/// Merge tolerance of positions on an edge or within a face, barycentric. Graphs store lengths in
/// single precision, so that borders have errors of about 1e-7 times the distance. Without merging,
/// a border that should pass through a vertex would create slivers, and filters that triangulate
/// polygons may lose an entire polygon because of them.
constexpr double SamePlace = 1e-5;

/// The cuts of all edges. They depend only on the ends of an edge and its length, so that all faces
/// of the edge find the same cuts.
class EdgeCuts
{
public:
  /// If `layers` are not null, finds only the cuts of edges of faces up to layer 1
  /// (DistanceField::Layers).
  explicit EdgeCuts(const SurfaceMesh& mesh, const std::uint8_t* layers = nullptr)
    : Mesh(mesh)
    , Layers(layers)
  {
  }

  /// Finds the cuts. Appends border points to the diagram, whose nearest sites must be known. The
  /// refinement may be null. Fails if aborted.
  Status Run(const SiteDistances& distances, const BorderRefinement* refinement,
    const ProgressCallback& progress, VoronoiDiagram& diagram);

  /// Returns the cuts of a half-edge, sorted from its origin.
  std::vector<EdgeCut> Of(Id halfEdge) const;

private:
  bool IsNeeded(Id halfEdge) const;
  void Refine(Id halfEdge, const BorderRefinement& refinement, VoronoiDiagram& diagram);
  void Cut(Id halfEdge, const SiteDistances& distances, VoronoiDiagram& diagram);

  const SurfaceMesh& Mesh;
  const std::uint8_t* Layers;
  std::vector<Offset>
    Offsets; ///< per half-edge, plus one; only FindEdge() representatives have cuts
  std::vector<EdgeCut> Cuts;
};
}

#endif
