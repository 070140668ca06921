// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Mesh refinement for vector graphics.
#ifndef dggGraphicsRefinement_h
#define dggGraphicsRefinement_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggSubMesh.h"    // for SubMesh

#include <limits> // for the most faces
#include <vector> // for faces

namespace dgg
{
/// Faces to be refined.
enum class RefinedPart
{
  Everything,
  AroundCurves, ///< faces that touch a curve; RefineFaces() adds rings for further levels
  Faces         ///< the given faces
};

/// Refinement before colors are computed. An alternative would be to evaluate the coarse solution
/// between vertices by Green's identity, u(x) = mean + sum_y g(x, y) (L u)_y. This evaluation costs
/// one Green's function per point and is not better than linear interpolation, since the values at
/// the vertices have errors of the same size. For a spherical harmonic of degree 5 on the unit
/// sphere with 10 242 vertices, the root mean square errors inside faces were 1.6e-3 by linear
/// interpolation and 1.9e-3 by Green's identity; with one level of refinement they were 4.9e-4.
struct GraphicsRefinement
{
  /// Number of times that faces are split in four.
  int Levels = 0;
  RefinedPart Part = RefinedPart::Everything;
  /// For RefinedPart::Faces: faces of the mesh on which curves were drawn. They must exist.
  std::vector<Id> Faces;
  /// Maximum number of faces, checked before refinement; exceeding it is an error.
  Offset MostFaces = (std::numeric_limits<Id>::max)() / 3;
  ProgressCallback Progress; ///< may be empty
};

/// Refines a surface that EmbedCurves() has made of a mesh. `parts` receives the faces of the
/// refined surface that lie in chosen faces, without those into which neighbors were split; may be
/// null.
DGG_CORE_EXPORT Status RefineForGraphics(const SurfaceMesh& mesh,
  const GraphicsRefinement& refinement, SubMesh& surface, std::vector<Id>* parts = nullptr);
}

#endif
