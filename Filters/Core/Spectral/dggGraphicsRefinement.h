// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finer faces for vector graphics.
#ifndef dggGraphicsRefinement_h
#define dggGraphicsRefinement_h

#include "dggRefinedSurface.h" // for RefinedSurface

#include <limits> // for the most faces

namespace dgg
{
/// Where faces are made finer, and by how much, before the colours are solved for. The solution on
/// the finer mesh takes the place of evaluations of the coarse one between its vertices.
struct GraphicsRefinement
{
  /// How often faces are split in four.
  int Levels = 0;
  /// All of them; otherwise those around curves, fewer with each level.
  bool IsEverywhere = true;
  /// Around curves: how many rings of faces besides those that touch a curve.
  int Rings = 2;
  /// More faces are an error.
  Offset MostFaces = std::numeric_limits<Id>::max() / 3;
  ProgressCallback Progress; ///< may be empty
};

/// Refine a surface that EmbedCurves() has made of a mesh. An open curve that is a single edge is
/// split in any case: its ends have one value each, so that it needs a vertex between them to have
/// two sides.
Status RefineForGraphics(
  const SurfaceMesh& mesh, const GraphicsRefinement& refinement, RefinedSurface& surface);
}

#endif
