// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Corrects the positions of border points of Voronoi cells. Internal.
#ifndef dggBorderRefinement_h
#define dggBorderRefinement_h

#include "dggGraphBuilder.h"  // for links
#include "dggSiteDistances.h" // for the distances
#include "dggSurfacePoint.h"  // for SurfacePoint

#include <array>   // for coordinates
#include <cstddef> // for std::size_t
#include <vector>  // for the sites

namespace dgg
{
/// Distances in a face that are interpolated from its corners are wrong where the shortest paths to
/// the corners pass different sides of an obstacle: in faces that are large compared to cells, and
/// close to points where geodesics bend. There a border point gets links of its own, like a graph
/// vertex, and is moved to where its distances are equal.
///
/// Where windows multiply, at non-manifold edges and among degenerate triangles, computing links is
/// expensive. The work is limited in proportion to the number of faces; after that, points are not
/// moved.
///
/// The need for refinement is detected from the virtual sources of the corners: each of them
/// predicts the distance at the point. Where all predictions agree, nothing is done.
class BorderRefinement
{
public:
  /// All arguments must outlive the object. `sites` are the positions of all sites; a site outside
  /// of a region has the vertex NoId. Links have the given `accuracy`; distances may differ by a
  /// fraction of it.
  BorderRefinement(const SurfaceMesh& mesh, const SiteDistances& distances,
    const GraphBuilder& builder, double accuracy, const std::vector<SurfacePoint>& sites);

  /// Balances a point on an edge between two sites, of which the first is on the side of the
  /// origin: moves the parameter within (low, high) and corrects the distance.
  void Balance(Id halfEdge, const std::array<Id, 2>& sites, double low, double high,
    double& parameter, double& distance) const;

  /// Balances a point inside a face where three cells meet.
  void Balance(
    Id face, const std::array<Id, 3>& sites, std::array<double, 3>& place, double& distance) const;

  /// Returns true if the measured distances from two sites differ by more than 1.5 times the
  /// accuracy at a border point inside a face. Only points where predictions differ by more than
  /// twice the accuracy are measured.
  bool IsWrong(Id face, const std::array<Id, 2>& sites, const std::array<double, 3>& place,
    double distance) const;

  /// Return the work of links where windows multiplied (see GraphBuilder::Link()), and its limit,
  /// which is proportional to the number of faces. If the mesh is a region of a larger surface, the
  /// limit is that of the surface.
  std::size_t GetWork() const { return this->Work; }
  std::size_t GetMostWork() const;
  void SetNumberOfFaces(Offset ofSurface) { this->NumberOfFaces = ofSurface; }
  /// Returns true if windows of a link met the rim of a region, after which no point is moved.
  bool HasMetRim() const { return this->MeetsRim; }

private:
  using Coordinates = std::array<double, 3>;

  /// Maximum relative difference between predictions of a distance, in units of the accuracy.
  static constexpr double PredictionTolerance = 0.6;

  bool IsDoubtful(Id face, const Coordinates& place, Id site, double distance,
    double tolerance = PredictionTolerance) const;
  bool Measure(
    const SurfacePoint& point, const Id* sites, std::size_t count, double* distances) const;

  const SurfaceMesh& Mesh;
  const SiteDistances& Distances;
  const GraphBuilder& Builder;
  double Accuracy;
  const std::vector<SurfacePoint>& Sites;
  Offset NumberOfFaces;
  mutable std::size_t Work = 0;
  mutable bool MeetsRim = false;
};
}

#endif
