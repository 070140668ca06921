// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Groups neighboring sources. Internal.
#ifndef dggSourceGroups_h
#define dggSourceGroups_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <cstddef> // for std::size_t
#include <vector>  // for the sources

namespace dgg
{
/// Indices into a list of sources that are close together on the surface, sorted by distance from
/// the first.
using SourceGroup = std::vector<std::size_t>;

/// Returns a partition of sources (vertices) into groups of `groupSize`, and a few smaller groups.
/// Groups are peeled off from the far ends of the surface, so that no isolated sources remain
/// between the groups.
std::vector<SourceGroup> GroupSources(
  const SurfaceMesh& mesh, const std::vector<Id>& sources, std::size_t groupSize);
}

#endif
