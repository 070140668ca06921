// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which of many sources are neighbours. Internal.
#ifndef dggSourceGroups_h
#define dggSourceGroups_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <cstddef> // for std::size_t
#include <vector>  // for the sources

namespace dgg
{
/// Places in a list of sources, close together on the surface; nearest first as seen from the
/// first.
using SourceGroup = std::vector<std::size_t>;

/// All sources (vertices) in groups of `groupSize`, and a few smaller ones. The surface is peeled
/// from its far ends, so that no stragglers are left between the groups.
std::vector<SourceGroup> GroupSources(
  const SurfaceMesh& mesh, const std::vector<Id>& sources, std::size_t groupSize);
}

#endif
