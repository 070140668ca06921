// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cells of harmonic B-splines, and their conductances. Internal.
#ifndef dggSplineCells_h
#define dggSplineCells_h

#include "dggParallel.h"      // for ParallelFor
#include "dggPoissonSystem.h" // for the system

#include <Eigen/SparseCore> // for the matrix

#include <vector> // for arrays

namespace dgg
{
/// The geodesic Voronoi diagram of sites, which are vertices, as a partition of the vertices
/// without given values, and its Laplacian by finite volumes with two-point fluxes: the flux from
/// cell i to cell j is c_ij (f_i - f_j),
///
///     c_ij = length of the border between the cells / geodesic distance of the sites.
///
/// Borders cross mesh edges (u, v), so they consist of the edges dual to these, which have the
/// length w_uv |uv| with the cotangent weight w_uv. Dual edges zigzag: their total length is too
/// large by 10 to 30 %, however fine the mesh is, and only the component along the border counts.
/// In the plane the function (d_i^2 - d_j^2) / (2 d_ij), with the distance d_i from site i, is
/// linear with slope 1 across the border, so its flux through the dual edges is the length of the
/// straight border between their ends:
///
///     c_ij = sum over cut edges, u in cell i, v in cell j, of
///            w_uv (d_i(v)^2 - d_i(u)^2 + d_j(u)^2 - d_j(v)^2) / (2 d_ij^2).
///
/// The bracket is not negative, as u is nearer to i and v to j. If u and v are the sites it equals
/// 2 d_ij^2: with all vertices as sites, K is the cotangent Laplacian itself, for any mesh.
///
/// The flux to given values, at distance e(u) from vertex u, is w_uv e(u) / (mean of e over the
/// cell) for each edge from u to a vertex with a given value: again the length of the border over
/// the distance. The mean over the cell is used instead of the distance of the site, so that basis
/// functions sum to 1 away from given values on a boundary.
struct SplineCells
{
  /// Flux from a cell to a vertex with a given value.
  struct Rim
  {
    Id Site;
    Id Vertex;
    double Coefficient;
  };

  std::vector<Id> Cells;       ///< per vertex, its site; NoId with given values or without a face
  std::vector<Id> Components;  ///< per site
  std::vector<double> Weights; ///< per site, the sum of PoissonSystem::GetWeight()
  /// K: -c_ij off the diagonal. Rows sum to the flux to given values, hence to 0 without these.
  Eigen::SparseMatrix<double> Stiffness;
  std::vector<Rim> Rims;
};

/// Computes the cells; sites must have been checked. Ties between sites are resolved
/// deterministically.
Status FindSplineCells(const PoissonSystem& system, const std::vector<Id>& sites,
  const ParallelFor& parallel, const ProgressCallback& progress, SplineCells& cells);

/// Solves K lambda = b. The right-hand side is per vertex: integrated sources, or given values. The
/// coefficients of the sites in `given` are given. Components where nothing is given are balanced,
/// and their solution has mean 0. Returns false if some cells have no conductance, or if the
/// conductances are so small that the equations cannot be solved to 1e-8.
bool SolveSiteEquations(const PoissonSystem& system, const SplineCells& cells,
  const std::vector<double>& rightHandSide, const std::vector<Id>& given,
  std::vector<double>& coefficients);
}

#endif
