// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cells of harmonic B-splines, and how well they conduct. Internal.
#ifndef dggSplineCells_h
#define dggSplineCells_h

#include "dggParallel.h"      // for ParallelFor
#include "dggPoissonSystem.h" // for the system

#include <Eigen/SparseCore> // for the matrix

#include <vector> // for arrays

namespace dgg
{
/// The geodesic Voronoi diagram of sites, which are vertices, as a partition of the vertices
/// without given values, and its Laplacian by finite volumes with fluxes between two points: what
/// flows from cell i to cell j is c_ij (f_i - f_j),
///
///     c_ij = length of the border between the cells / geodesic distance of the sites.
///
/// Borders cross mesh edges (u, v), so they are made of the edges dual to these, which are w_uv
/// |uv| long, w_uv the cotangent weight. These go to and fro: their lengths, added up, are too
/// large by 10 to 30 %, however fine the mesh is. What counts is the part along the border. In the
/// plane the function (d_i^2 - d_j^2) / (2 d_ij), d_i the distance from site i, is linear with
/// slope 1 across the border, so its flux through the dual edges is the length of the straight
/// border between their ends:
///
///     c_ij = sum over cut edges, u in cell i, v in cell j, of
///            w_uv (d_i(v)^2 - d_i(u)^2 + d_j(u)^2 - d_j(v)^2) / (2 d_ij^2).
///
/// The bracket is not negative, as u is nearer to i and v to j. When u and v are the sites it is
/// 2 d_ij^2: with all vertices as sites, K is the cotangent Laplacian itself, whatever the mesh.
///
/// To given values, at distance e(u) from vertex u, flows w_uv e(u) / (mean of e over the cell) for
/// each edge from u to a vertex with a given value: again the length of the border, over the
/// distance. With the mean in place of the distance of the site, basis functions sum to 1 away from
/// given values on a boundary.
struct SplineCells
{
  /// What flows from a cell to a vertex with a given value.
  struct Rim
  {
    Id Site;
    Id Vertex;
    double Coefficient;
  };

  std::vector<Id> Cells;       ///< per vertex, the site; NoId with given values or without a face
  std::vector<Id> Components;  ///< per site
  std::vector<double> Weights; ///< per site, the sum of PoissonSystem::GetWeight()
  /// K: -c_ij off the diagonal. Rows sum to what flows to given values, so to 0 without these.
  Eigen::SparseMatrix<double> Stiffness;
  std::vector<Rim> Rims;
};

/// The sites must have been checked. A vertex at the same distance from several sites goes to any
/// of them, always the same.
Status FindSplineCells(const PoissonSystem& system, const std::vector<Id>& sites,
  const ParallelFor& parallel, const ProgressCallback& progress, SplineCells& cells);

/// Solve K lambda = b. The right-hand side is per vertex: integrated sources, or given values.
/// `coefficients` of the sites in `given` are given. Components where nothing is given are
/// balanced, and have the mean 0. False when some cells do not conduct, or conduct so badly that
/// the equations cannot be solved to 1e-8.
bool SolveSiteEquations(const PoissonSystem& system, const SplineCells& cells,
  const std::vector<double>& rightHandSide, const std::vector<Id>& given,
  std::vector<double>& coefficients);
}

#endif
