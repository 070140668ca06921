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
/// Vertices that are far from each other and from those with given values, one after the other the
/// farthest one along the edges of the mesh (FarthestPoints). Every component that has a vertex
/// without a given value gets a site, so there may be more than asked for; there are fewer when the
/// mesh has fewer such vertices. Where triangles are too thin, a component has no more than one.
/// The solver must be ready.
DGG_CORE_EXPORT Status ChooseSplineSites(
  const PoissonSolver& solver, Id count, const ProgressCallback& progress, std::vector<Id>& sites);

/// The components that have a vertex without a given value: how many sites there are at least.
DGG_CORE_EXPORT Id CountSplineComponents(const PoissonSolver& solver);

/// Fails, with a message that names the site by its number, when there is none, or one does not
/// exist, has no face, has a given value (or is where all corners have), or is the same vertex as
/// an earlier one; when a component with a vertex without given value has no site, or one with
/// triangles that are too thin has several.
/// @{
DGG_CORE_EXPORT Status CheckSplinePlaces(
  const PoissonSolver& solver, const std::vector<SurfacePoint>& sites);
DGG_CORE_EXPORT Status CheckSplineSites(const PoissonSolver& solver, const std::vector<Id>& sites);
/// @}

/// Fails when there are no sites, or the system is not that of this revision any more: what was
/// prepared is not there, or out of date.
Status CheckPreparedSites(
  const PoissonSystem& system, std::size_t numberOfSites, std::uint64_t revision);
}

#endif
