// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Colored points of a surface.
#ifndef dggGraphicsFragments_h
#define dggGraphicsFragments_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSubMesh.h"     // for SubMesh
#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for places and values

namespace dgg
{
/// Colored points distributed over a surface: a texture without parametrization. No point lies on a
/// curve, so that each has one color.
struct GraphicsFragments
{
  std::vector<SurfacePoint> Places; ///< points of the mesh on which curves were drawn
  std::vector<Id> Faces;            ///< per fragment, its face in that mesh
  std::vector<double> Values;       ///< all channels of a fragment consecutively
};

/// Subdivides faces of a colored surface into division^2 congruent triangles, and samples the
/// center of each. The mean over the fragments of a face equals the mean over the face. `faces` are
/// faces of `surface`; `values` has `channels` values per vertex.
DGG_CORE_EXPORT GraphicsFragments MakeFragments(const SurfaceMesh& mesh, const SubMesh& surface,
  const std::vector<Id>& faces, const std::vector<double>& values, int channels, int division);
}

#endif
