// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Variational form of the heat method, for comparison.
#ifndef VariationalHeat_h
#define VariationalHeat_h

#include "dggLaplaceSystem.h" // for the triangles and their Laplacian

#include <array>  // for triangles
#include <vector> // for the values

/// Distances that minimize the integral of (|grad u| - 1)^2 (Belyaev and Fayolle, "On variational
/// and PDE-based distance function approximations", 2015). The heat method provides the initial
/// values. Gradients p are then separated from u, and both are improved alternately by the
/// alternating direction method of multipliers: u solves a Poisson equation, always with the same
/// matrix; the lengths of p have a closed form in each face; multipliers w accumulate the
/// differences of p and grad u.
///
/// The integral does not control the value at a point, so distances around the source would drift.
/// Therefore, in faces at the source, p remains the gradient of the straight distances of their
/// corners.
class VariationalHeat : private dgg::LaplaceSystem
{
public:
  /// The mesh must outlive this object.
  explicit VariationalHeat(const dgg::SurfaceMesh& mesh);

  /// Prepares the solver for the triangles of the mesh or, if `isDelaunay`, for those after edge
  /// flips.
  dgg::Status Prepare(bool isDelaunay);

  /// Improves the distances of the heat method from a vertex in `iterations` steps of one
  /// substitution each; 0 leaves them unchanged. Distances of other components remain Infinity.
  /// Call Prepare() first.
  void Improve(dgg::Id source, int iterations, std::vector<double>& distances) const;

  /// Returns the integral over the reached faces.
  double Energy(const std::vector<double>& distances) const;

private:
  /// A triangle whose first side lies on the x axis.
  struct Frame
  {
    std::array<dgg::Id, 3> Corners;
    double Length;
    dgg::Point2 Apex;
  };

  static dgg::Point2 Gradient(const Frame& frame, const std::vector<double>& values);
  static void AddDivergence(const Frame& frame, const dgg::Point2& flow, std::vector<double>& sums);

  std::vector<Frame> Frames; ///< triangles with a positive area
  dgg::SparseFactor Factor;
};

#endif
