// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All ways to a Green's function, behind one face.
#ifndef MeasuredGreens_h
#define MeasuredGreens_h

#include "dggGreensFunction.h"      // for methods and results
#include "dggGreensInterpolation.h" // for the way that keeps columns
#include "dggPoissonSolver.h"       // for PoissonSolver

#include <string> // for names
#include <vector> // for the list of ways

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
