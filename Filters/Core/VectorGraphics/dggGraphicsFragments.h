// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Coloured points of a surface.
#ifndef dggGraphicsFragments_h
#define dggGraphicsFragments_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfaceCut.h"  // for CutSurface
#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for places and values

namespace dgg
{
/// Coloured points spread over a surface: a texture that needs no parametrization. None is on a
/// curve, so that each has one colour.
struct GraphicsFragments
{
  std::vector<SurfacePoint> Places; ///< on the mesh that curves were drawn on
  std::vector<Id> Faces;            ///< per fragment, the face of that mesh
  std::vector<double> Values;       ///< all channels of a fragment after each other
};

/// Divide faces of a coloured surface into division^2 parts of one size and shape, and take the
/// middle of each. The mean over the fragments of a face is that over the face.
/// `faces` are those of `surface`; `values` has `channels` numbers for each of its vertices.
DGG_CORE_EXPORT GraphicsFragments MakeFragments(const SurfaceMesh& mesh, const CutSurface& surface,
  const std::vector<Id>& faces, const std::vector<double>& values, int channels, int division);
}

#endif
