// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a Poisson equation on a surface is completed by.
#ifndef dggPoissonOptions_h
#define dggPoissonOptions_h

#include "dggTypes.h" // for Id

#include <vector> // for vertices

namespace dgg
{
/// What happens at the boundary of the surface.
enum class PoissonBoundary
{
  Neumann,  ///< nothing flows through it
  Dirichlet ///< values are given there; 0 for Green's functions
};

/// How sources are balanced, and means taken, where no values are given.
enum class PoissonWeights
{
  Area,   ///< in proportion to the area around a vertex
  Uniform ///< the same for all vertices (Lipman, Rustamov and Funkhouser, "Biharmonic distance",
          ///< 2010): right for cells of equal area only
};

struct PoissonOptions
{
  PoissonBoundary Boundary = PoissonBoundary::Neumann;
  PoissonWeights Weights = PoissonWeights::Area;
  /// Vertices whose values are given besides those of a Dirichlet boundary, in any order; they may
  /// repeat.
  std::vector<Id> GivenVertices;
  /// Flip edges until they are Delaunay first: then there are no negative weights, and the maximum
  /// principle holds. For meshes with obtuse triangles.
  bool IntrinsicDelaunay = false;
};
}

#endif
