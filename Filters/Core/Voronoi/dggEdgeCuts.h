// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the borders of Voronoi cells cross the edges of a mesh. Internal.
#ifndef dggEdgeCuts_h
#define dggEdgeCuts_h

#include "dggSiteDistances.h" // for the distances
#include "dggSurfaceMesh.h"   // for SurfaceMesh

#include <vector> // for the cuts

namespace dgg
{
class BorderRefinement;
struct VoronoiDiagram;

/// A point where the nearest site changes.
struct EdgeCut
{
  double Parameter; ///< from the origin to the destination of a half-edge
  Id Before;        ///< site on the side of the origin
  Id After;
  Id Point; ///< of the diagram
};

/// Places on an edge, or within a face, closer than this are one; barycentric. Graphs keep
/// lengths in single precision, so that borders are off by about 1e-7 times the distance. Slivers
/// where they should pass through a vertex are of no use, and filters that triangulate polygons
/// may lose the whole polygon for them.
constexpr double SamePlace = 1e-5;

/// The cuts of all edges. They depend on the ends of the edge and its length alone, so all faces
/// around an edge find the same ones.
class EdgeCuts
{
public:
  explicit EdgeCuts(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Find the cuts. Appends border points to the diagram, whose nearest sites are known. The
  /// refinement may be null. False when aborted.
  bool Run(const SiteDistances& distances, const BorderRefinement* refinement,
    const ProgressCallback& progress, VoronoiDiagram& diagram);

  /// The cuts of a half-edge, from its origin on.
  std::vector<EdgeCut> Of(Id halfEdge) const;

private:
  void Refine(Id halfEdge, const BorderRefinement& refinement, VoronoiDiagram& diagram);
  void Cut(Id halfEdge, const SiteDistances& distances, VoronoiDiagram& diagram);

  const SurfaceMesh& Mesh;
  std::vector<Offset> Offsets; ///< per half-edge, and one more; only those of FindEdge() have cuts
  std::vector<EdgeCut> Cuts;
};
}

#endif
