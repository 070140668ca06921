// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The same layout of patches drawn on two surfaces.
#ifndef dggPatchBoundaries_h
#define dggPatchBoundaries_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePath.h"  // for SurfacePath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <array>  // for edges and for the two meshes
#include <vector> // for landmarks

namespace dgg
{
/// A layout of curves between landmarks.
struct PatchLayout
{
  /// Pairs of landmarks to be joined by a curve, besides the sides of patches. No pair twice.
  std::vector<std::array<Id, 2>> Edges;
  /// Each patch is the list of landmarks around it. All patches turn the same way: two that share a
  /// side pass it in opposite directions.
  std::vector<std::vector<Id>> Patches;
};

/// A surface and the places of the landmarks on it.
struct PatchSurface
{
  const SurfaceMesh& Mesh;
  const std::vector<SurfacePoint>& Landmarks;
};

/// Curves on both surfaces.
struct PatchBoundaries
{
  /// The pairs of landmarks that are joined: the sides of the patches in the order in which they
  /// occur first, then the edges.
  std::vector<std::array<Id, 2>> Edges;
  /// Per surface, the curves in that order, each from the first landmark to the second. Curves meet
  /// at landmarks only. Unlike those of other paths, their points may lie inside faces, where they
  /// keep clear of each other.
  std::array<std::vector<SurfacePath>, 2> Curves;
};

/// Draw a layout on two surfaces such that the curves correspond: they do not cross or touch, they
/// leave each landmark in the same order, and they divide both surfaces alike, so that each patch
/// is a disk on both. The idea is that of Praun, Sweldens and Schroeder, "Consistent mesh
/// parameterizations", 2001: curves are traced one by one, short ones first, those of a spanning
/// tree before all others, so that nothing is separated too early, and each starts and ends in the
/// sector of its landmarks that the order demands. Here they are exact shortest paths on the
/// surface cut open along the curves that are there already; a path that would touch one of those
/// is traced again at a small distance from them.
///
/// The order of the curves around a landmark is that of the patches, where these determine it;
/// elsewhere it is found on the first surface and imposed on the second one. A surface may be a
/// mirror image of the other, or of the patches.
///
/// Fails with the reason when landmarks do not correspond, lie in one place or are not connected,
/// when the layout is not one, and when it cannot be drawn on one of the surfaces. Edges may have
/// two faces at most, and the surfaces must be orientable. Points where sheets touch are not
/// passed.
DGG_CORE_EXPORT Status TracePatchBoundaries(const PatchSurface& first, const PatchSurface& second,
  const PatchLayout& layout, const ProgressCallback& progress, PatchBoundaries& boundaries);
}

#endif
