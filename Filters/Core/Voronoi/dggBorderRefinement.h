// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Puts points of borders between Voronoi cells where they belong. Internal.
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
/// Distances in a face that follow from those at its corners are wrong where ways to the corners
/// lead around different sides of something: in faces that are large compared to cells, and close
/// to points where geodesics bend. There a border point gets links of its own, as a vertex of the
/// graph would have them, and is moved to where its distances are equal.
///
/// Where windows multiply, among non-manifold edges and triangles of near-zero area, links take
/// long. Their work is limited in proportion to the number of faces; the points after that stay
/// where they are.
///
/// Whether that is needed is seen from the virtual sources of the corners: each of them has its own
/// idea of the distance at the point. Where all agree, nothing is done.
class BorderRefinement
{
public:
  /// Everything must outlive the object. `sites` are the places of all sites. Links have the
  /// `accuracy`; distances may differ by some part of it.
  BorderRefinement(const SurfaceMesh& mesh, const SiteDistances& distances,
    const GraphBuilder& builder, double accuracy, const std::vector<SurfacePoint>& sites);

  /// A point on an edge between two sites, the first one on the side of the origin: move its
  /// parameter within (low, high), and correct its distance.
  void Balance(Id halfEdge, const std::array<Id, 2>& sites, double low, double high,
    double& parameter, double& distance) const;

  /// A point inside a face where three cells meet.
  void Balance(
    Id face, const std::array<Id, 3>& sites, std::array<double, 3>& place, double& distance) const;

  /// What links have taken where windows multiply, see GraphBuilder::Link(), and what they may
  /// take.
  std::size_t GetWork() const { return this->Work; }
  std::size_t GetMostWork() const;

private:
  using Coordinates = std::array<double, 3>;

  bool IsDoubtful(Id face, const Coordinates& place, Id site, double distance) const;
  double Predict(Id halfEdge, const SiteDistances::Entry& entry, const Point2& place) const;
  bool Measure(
    const SurfacePoint& point, const Id* sites, std::size_t count, double* distances) const;
  bool Measure(Id face, const Coordinates& place, const std::array<Id, 3>& sites,
    std::array<double, 3>& distances) const;

  const SurfaceMesh& Mesh;
  const SiteDistances& Distances;
  const GraphBuilder& Builder;
  double Accuracy;
  const std::vector<SurfacePoint>& Sites;
  mutable std::size_t Work = 0;
};
}

#endif
