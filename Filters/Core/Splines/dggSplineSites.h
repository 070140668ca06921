// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sites of harmonic B-splines.
#ifndef dggSplineSites_h
#define dggSplineSites_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggPoissonSolver.h" // for PoissonSolver
#include "dggSurfacePoint.h"  // for sites

#include <cstddef> // for std::size_t
#include <cstdint> // for revisions
#include <vector>  // for the sites

namespace dgg
{
/// Chooses vertices that are far from each other and from those with given values, by
/// farthest-point sampling along the edges of the mesh (FarthestPoints). Every component that has a
/// vertex without a given value gets a site, so that there may be more than `count` sites; there
/// are fewer if the mesh has fewer such vertices. A component whose triangles are too thin gets at
/// most one site. The solver must be ready.
DGG_CORE_EXPORT Status ChooseSplineSites(
  const PoissonSolver& solver, Id count, const ProgressCallback& progress, std::vector<Id>& sites);

/// Returns the number of components that have a vertex without a given value, which is the minimum
/// number of sites.
DGG_CORE_EXPORT Id CountSplineComponents(const PoissonSolver& solver);

/// Fails, naming the index of the site, if there are no sites; if a site does not exist, has no
/// face, has a given value (or lies where all corners have), or is the same vertex as an earlier
/// one; if a component with a vertex without given value has no site; or if a component whose
/// triangles are too thin has several sites.
/// @{
DGG_CORE_EXPORT Status CheckSplinePlaces(
  const PoissonSolver& solver, const std::vector<SurfacePoint>& sites);
DGG_CORE_EXPORT Status CheckSplineSites(const PoissonSolver& solver, const std::vector<Id>& sites);
/// @}

/// Fails if there are no sites, or the revision of the system has changed, so that prepared data is
/// missing or outdated.
Status CheckPreparedSites(
  const PoissonSystem& system, std::size_t numberOfSites, std::uint64_t revision);
}

#endif
