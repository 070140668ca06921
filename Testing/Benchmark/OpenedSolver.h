// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Mesh and Poisson equation of a benchmark case, and a common interface of all methods that
/// compute a Green's function.
#ifndef OpenedSolver_h
#define OpenedSolver_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include "dggGreensFunction.h"      // for methods and results
#include "dggGreensInterpolation.h" // for the method that keeps columns
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

/// Returns a vector that is 1 at a vertex and 0 at all others.
std::vector<double> UnitLoad(const dgg::PoissonSolver& solver, dgg::Id vertex);

/// Computes the Green's function of a vertex: of the Laplacian for power 1, of the bi-Laplacian for
/// 2.
dgg::Status FindColumn(
  const dgg::PoissonSolver& solver, dgg::Id source, int power, std::vector<double>& values);

/// Method of GreensFunction, or GreensInterpolation.
struct GreensWay
{
  std::string Name;
  dgg::GreensMethod Method = dgg::GreensMethod::SingularitySubtraction;
  bool IsInterpolation = false; ///< interpolation of regular parts
};

const std::vector<GreensWay>& GetGreensWays();

class MeasuredGreens
{
public:
  /// The solver must be ready and outlive this object.
  MeasuredGreens(const dgg::PoissonSolver& solver, const GreensWay& way);

  dgg::Status Run(const dgg::SurfacePoint& pole, dgg::GreensResult& result);

private:
  GreensWay Way;
  dgg::GreensFunction Function;
  dgg::GreensInterpolation Interpolation;
};

#endif
