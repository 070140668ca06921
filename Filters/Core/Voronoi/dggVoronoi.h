// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Geodesic Voronoi diagrams: the nearest site of every point of a surface.
#ifndef dggVoronoi_h
#define dggVoronoi_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggGraphBuilder.h" // for links
#include "dggGraphSearch.h"  // for GraphSearch
#include "dggSurfacePoint.h" // for SurfacePoint

#include <array>   // for pairs of sites
#include <cstddef> // for std::size_t
#include <cstdint> // for layers
#include <vector>  // for the diagram

namespace dgg
{
/// A Voronoi diagram as a mesh. Its points are the vertices of the surface, with their ids,
/// followed by points on the borders of cells, where these cross edges of the surface or meet
/// inside faces.
///
/// Every border point has one id in all faces that contain it. Therefore cells and borders have no
/// gaps.
struct VoronoiDiagram
{
  /// Per vertex, the nearest site (on ties, the first one) and the estimated distance from it; NoId
  /// and Infinity if unreached.
  std::vector<Id> NearestSites;
  std::vector<double> Distances;

  /// Border points: border point i is point n + i, for n vertices.
  std::vector<SurfacePoint> BorderPoints;
  std::vector<double> BorderDistances; ///< estimated distances from the nearest sites

  /// Subdivision of faces: polygon i has the points PolygonPoints[PolygonOffsets[i]] and so on, in
  /// the order of the corners of SurfaceMesh::GetTriangle(). The polygons cover all faces that have
  /// not been dropped.
  std::vector<Offset> PolygonOffsets;
  std::vector<Id> PolygonPoints;
  std::vector<Id> PolygonSites; ///< NoId if unreached
  std::vector<Id> PolygonFaces;
  std::vector<double> PolygonAreas; ///< computed from the edge lengths of the surface

  /// Borders between two cells: polylines whose segments each lie within a face. A closed curve
  /// repeats its first point at the end. The smaller site comes first.
  std::vector<Offset> CurveOffsets;
  std::vector<Id> CurvePoints;
  std::vector<std::array<Id, 2>> CurveSites;

  /// True if the distances from two sites, in the middle of a refined segment between them, differ
  /// by more than 1.5 times the accuracy. Only exact distances give correct cells then.
  bool AreBordersWrong = false;

  std::size_t GetNumberOfPolygons() const { return this->PolygonSites.size(); }
  std::size_t GetNumberOfCurves() const { return this->CurveSites.size(); }
};

class BorderRefinement;
class SiteDistances;

/// Sites, and the means to refine their borders.
struct VoronoiInput
{
  /// Source is the index of the site, from 0 on; initial distances are not allowed.
  std::vector<GraphSeed> Seeds;
  /// Computes links of border points with the given accuracy; without a builder nothing is refined.
  const GraphBuilder* Builder = nullptr;
  double Accuracy = 0.01;
  std::vector<SurfacePoint> Places; ///< positions of all sites; only used with a builder
  /// If true, only NearestSites and Distances are filled, by a single search.
  bool LabelsOnly = false;
};

/// Computes the Voronoi diagram of sites. A site at the position of an earlier one has no cell.
///
/// Inside a face, the squared distance from a site is computed as if the (corrected) distances d_i
/// at the corners were straight-line distances from one point: with barycentric coordinates b and
/// side lengths l_ij, sum_i b_i d_i^2 - sum_{i<j} b_i b_j l_ij^2. This is exact where the surface
/// is flat. Since the second sum is the same for all sites, borders within a face are straight
/// lines; cf. Xin et al., "SurfaceVoronoi: efficiently computing Voronoi diagrams over mesh
/// surfaces with arbitrary distance solvers", 2022. A cell that extends into a face without
/// containing any of its corners is found if two of the corners belong to different cells.
///
/// Where the shortest paths from a site to the corners of a face take different routes, this is not
/// accurate enough: in faces that are large compared to cells, and behind points where geodesics
/// bend. There, border points are linked to the graph and moved to where both (or all three)
/// distances are equal.
///
/// `search` must belong to a graph of `mesh`. Fails like GraphSearch::Run(), and if a seed has an
/// initial distance or no site; then the diagram is empty.
DGG_CORE_EXPORT Status ComputeVoronoi(const GraphSearch& search, const SurfaceMesh& mesh,
  const VoronoiInput& input, const ProgressCallback& progress, VoronoiDiagram& diagram);

/// Computes the diagram of known distances. `refinement` may be null. If `layers` are not null
/// (DistanceField::Layers), the mesh has at least two layers of cells around the piece of this
/// process; the diagram then has the polygons of the piece, and borders end where pieces meet.
/// Fails if aborted, and if a site reaches a vertex but no site reaches its neighbor.
Status ComputeCells(const SurfaceMesh& mesh, const SiteDistances& distances,
  const BorderRefinement* refinement, const std::uint8_t* layers, const ProgressCallback& progress,
  VoronoiDiagram& diagram);
}

#endif
