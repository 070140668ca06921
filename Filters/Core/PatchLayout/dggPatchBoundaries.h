// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Draws the same patch layout on two surfaces.
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
  /// Pairs of landmarks to be joined by a curve, in addition to the sides of patches. No pair may
  /// occur twice.
  std::vector<std::array<Id, 2>> Edges;
  /// Each patch is the list of landmarks around it. All patches must have the same orientation: two
  /// that share a side traverse it in opposite directions.
  std::vector<std::vector<Id>> Patches;
};

/// A surface and the positions of the landmarks on it.
struct PatchSurface
{
  const SurfaceMesh& Mesh;
  const std::vector<SurfacePoint>& Landmarks;
};

/// Curves on both surfaces.
struct PatchBoundaries
{
  /// The pairs of landmarks that are joined: first the sides of the patches in order of occurrence,
  /// then the edges.
  std::vector<std::array<Id, 2>> Edges;
  /// Per surface, the curves in the order of Edges, each from the first landmark to the second.
  /// Curves meet only at landmarks. Unlike other paths, they may have points inside faces, where
  /// they keep a distance from each other.
  std::array<std::vector<SurfacePath>, 2> Curves;
};

/// Draws a layout on two surfaces such that the curves correspond: they do not cross or touch, they
/// leave each landmark in the same order, and they divide both surfaces alike, so that each patch
/// is a disk on both. The approach follows Praun, Sweldens and Schroeder, "Consistent mesh
/// parameterizations", 2001: curves are traced one by one, short ones first. The curves of a
/// spanning tree come before all others, so that nothing is separated too early. Each curve starts
/// and ends in the sector of its landmarks that the order requires. Here curves are exact shortest
/// paths on the surface cut open along the existing curves; a path that would touch an existing
/// curve is traced again at a small distance from all of them.
///
/// The order of the curves around a landmark is that of the patches, if they determine it;
/// otherwise it is found on the first surface and imposed on the second one. A surface may be a
/// mirror image of the other, or of the patches.
///
/// Fails with the reason if landmarks do not correspond, coincide or are not connected, if the
/// layout is invalid, or if it cannot be drawn on one of the surfaces. Edges may have at most two
/// faces, and the surfaces must be orientable. Curves do not pass through vertices with several
/// fans of faces.
DGG_CORE_EXPORT Status TracePatchBoundaries(const PatchSurface& first, const PatchSurface& second,
  const PatchLayout& layout, const ProgressCallback& progress, PatchBoundaries& boundaries);
}

#endif
