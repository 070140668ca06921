// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finer faces for vector graphics.
#ifndef dggGraphicsRefinement_h
#define dggGraphicsRefinement_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggRefinedSurface.h" // for RefinedSurface

#include <limits> // for the most faces
#include <vector> // for faces

namespace dgg
{
/// Which faces are made finer.
enum class RefinedPart
{
  Everything,
  AroundCurves, ///< those that touch a curve; RefineFaces() takes a ring along for further levels
  Faces         ///< those that are given
};

/// Where faces are made finer, and by how much, before the colours are solved for. The solution on
/// the finer mesh takes the place of evaluations of the coarse one between its vertices by Green's
/// identity, u(x) = mean + sum_y g(x, y) (L u)_y: these cost one Green's function each, and are no
/// better than linear interpolation, since the values at the vertices have errors as large. For a
/// spherical harmonic of degree 5 on the unit sphere with 10 242 vertices, errors inside of faces
/// (root of the mean square) were 1.6e-3 by linear interpolation and 1.9e-3 by Green's identity;
/// one level finer they were 4.9e-4.
struct GraphicsRefinement
{
  /// How often faces are split in four.
  int Levels = 0;
  RefinedPart Part = RefinedPart::Everything;
  /// Of the mesh that curves were drawn on, for RefinedPart::Faces. They must exist.
  std::vector<Id> Faces;
  /// More faces are an error, before they are made.
  Offset MostFaces = std::numeric_limits<Id>::max() / 3;
  ProgressCallback Progress; ///< may be empty
};

/// Refine a surface that EmbedCurves() has made of a mesh. `parts` gets the faces of the refined
/// surface that lie in faces that were chosen, not those that neighbours were split into; may be
/// null.
DGG_CORE_EXPORT Status RefineForGraphics(const SurfaceMesh& mesh,
  const GraphicsRefinement& refinement, RefinedSurface& surface, std::vector<Id>* parts = nullptr);
}

#endif
