// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Splits the faces of a mesh along paths.
#ifndef dggSurfaceRefinement_h
#define dggSurfaceRefinement_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggSubMesh.h"    // for SubMesh

#include <vector> // for the paths

namespace dgg
{
struct RefinementOptions
{
  /// If true, a vertex is inserted where paths cross; otherwise crossings are an error.
  bool InsertCrossings = false;
  /// Progress and abort; may be empty.
  ProgressCallback Progress;
};

/// Splits the faces of a mesh along paths, which may share points, touch, and run along edges of
/// the mesh or each other. Points within 1e-9, in barycentric coordinates, become one vertex. Fails
/// if a path is not on the mesh, or if paths cross and InsertCrossings is false.
DGG_CORE_EXPORT Status RefineAlongPaths(const SurfaceMesh& mesh,
  const std::vector<SurfacePath>& paths, const RefinementOptions& options, SubMesh& refined);
}

#endif
