// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The variational form of the heat method, to compare with.
#ifndef VariationalHeat_h
#define VariationalHeat_h

#include "dggLaplaceSystem.h" // for the triangles and their Laplacian

#include <array>  // for triangles
#include <vector> // for the values

/// Distances as what makes the integral of (|grad u| - 1)^2 small (Belyaev and Fayolle, "On
/// variational and PDE-based distance function approximations", 2015). The heat method gives the
/// start. Then gradients p are taken apart from u, and both are improved in turn by the alternating
/// direction method of multipliers: u solves a Poisson equation, always with the same matrix; the
/// lengths of p are in closed form, face by face; multipliers w collect how far p is from grad u.
///
/// A point has no say in an integral, and without one, distances around the source drift away from
/// what they should be. So in the faces at the source p stays the gradient of the straight lengths
/// to their corners.
class VariationalHeat : private dgg::LaplaceSystem
{
public:
  /// The mesh must outlive this.
  explicit VariationalHeat(const dgg::SurfaceMesh& mesh);

  /// On the triangles of the mesh, or on those after flips of edges.
  dgg::Status Prepare(bool isDelaunay);

  /// Improve the distances of the heat method from a vertex, in so many steps of one substitution
  /// each; no step leaves them as they are. Infinity stays in other components. After Prepare().
  void Improve(dgg::Id source, int iterations, std::vector<double>& distances) const;

  /// The integral, over what is reached.
  double Energy(const std::vector<double>& distances) const;

private:
  /// A triangle with its first side on the x axis.
  struct Frame
  {
    std::array<dgg::Id, 3> Corners;
    double Length;
    dgg::Point2 Apex;
  };

  static dgg::Point2 Gradient(const Frame& frame, const std::vector<double>& values);
  static void AddDivergence(const Frame& frame, const dgg::Point2& flow, std::vector<double>& sums);

  std::vector<Frame> Frames; ///< triangles that have an area
  dgg::SparseFactor Factor;
};

#endif
