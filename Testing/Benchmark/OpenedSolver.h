// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh and the Poisson equation on it, for one case of a benchmark; and all ways to a Green's
/// function, behind one face.
#ifndef OpenedSolver_h
#define OpenedSolver_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include "dggGreensFunction.h"      // for methods and results
#include "dggGreensInterpolation.h" // for the way that keeps columns
#include "dggPoissonSolver.h"       // for PoissonSolver

#include <string> // for names
#include <vector> // for loads

struct OpenedSolver
{
  BenchmarkMesh* Mesh = nullptr;
  const dgg::PoissonSolver* Solver = nullptr;
};

/// Returns the factorized solver of a recipe. The solver of the last mesh is kept.
OpenedSolver OpenSolver(const MeshRecipe& recipe);

/// One at a vertex, 0 at others.
std::vector<double> UnitLoad(const dgg::PoissonSolver& solver, dgg::Id vertex);

/// The Green's function of a vertex: of the Laplacian for the power 1, of the bi-Laplacian for 2.
dgg::Status FindColumn(
  const dgg::PoissonSolver& solver, dgg::Id source, int power, std::vector<double>& values);

/// The methods of GreensFunction, and GreensInterpolation.
struct GreensWay
{
  std::string Name;
  dgg::GreensMethod Method = dgg::GreensMethod::SingularitySubtraction;
  bool IsInterpolation = false; ///< of regular parts
};

const std::vector<GreensWay>& GetGreensWays();

class MeasuredGreens
{
public:
  /// The solver must be ready and outlive this.
  MeasuredGreens(const dgg::PoissonSolver& solver, const GreensWay& way);

  dgg::Status Run(const dgg::SurfacePoint& pole, dgg::GreensResult& result);

private:
  GreensWay Way;
  dgg::GreensFunction Function;
  dgg::GreensInterpolation Interpolation;
};

#endif
