// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Moves sites on a point cloud to the middle of their Voronoi cells.
#ifndef dggCloudCenters_h
#define dggCloudCenters_h

#include "dggCentroidal.h"   // for CentroidalOptions
#include "dggGraphSearch.h"  // for GraphSearch
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the sites

namespace dgg
{
/// Lloyd's iteration on a cloud, where there are no directions and sites are points of the cloud.
/// What is made smaller is the energy, the sum over all points of their squared distance from the
/// nearest site; points count equally, so that there are more sites where points are denser.
///
/// As seen from a site, a point of its cell stands at its distance in the direction of the first
/// edge of the way to it. The site is to go to the mean of these, and becomes the point of its cell
/// that is closest to it in space. When the energy does not decrease, only those sites move that
/// are closer to the points of their cells then; when that does not help, all steps are halved, and
/// at last the iteration ends. Its Tolerance has no use.
///
/// `search` is that of the graph of a cloud, `positions` are those of its points, x y z each. Sites
/// that are near points of the cloud start as these. `energies` receives the energy at the start
/// and after each iteration; it decreases. Fails as GraphSearch::Run() does; then `sites` are
/// unchanged.
Status MoveToCloudCenters(const GraphSearch& search, const double* positions,
  const CentroidalOptions& options, std::vector<SurfacePoint>& sites,
  std::vector<double>& energies);
}

#endif
