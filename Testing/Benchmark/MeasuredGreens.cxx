// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredGreens.h"

const std::vector<GreensWay>& GetGreensWays()
{
  using dgg::GreensMethod;
  static const std::vector<GreensWay> ways = {
    { "SingularitySubtraction", GreensMethod::SingularitySubtraction, false },
    { "RegularPart", GreensMethod::SingularitySubtraction, true },
    { "Localized", GreensMethod::Localized, false },
    { "Interpolated", GreensMethod::Interpolated, false },
    { "Vertex", GreensMethod::Vertex, false },
  };
  return ways;
}

MeasuredGreens::MeasuredGreens(const dgg::PoissonSolver& solver, const GreensWay& way)
  : Way(way)
  , Function(solver)
  , Interpolation(solver)
{
}

dgg::Status MeasuredGreens::Run(const dgg::SurfacePoint& pole, dgg::GreensResult& result)
{
  dgg::GreensQuery query;
  query.Method = this->Way.Method;
  return this->Way.IsInterpolation ? this->Interpolation.Run(pole, query, result)
                                   : this->Function.Run(pole, query, result);
}
