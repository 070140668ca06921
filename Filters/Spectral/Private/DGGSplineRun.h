// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Computation of vtkHarmonicBSpline, of both orders. Internal.
#ifndef DGGSplineRun_h
#define DGGSplineRun_h

#include "DGGSpectralInternals.h" // for the task

#include "dggBiharmonicSplines.h" // for splines of order 2
#include "dggHarmonicSplines.h"   // for splines of order 1

#include <string> // for names
#include <vector> // for values

class vtkPolyData;

/// Returns the corner closest to a surface point, preferably a corner without a prescribed value.
dgg::Id DGGFindNearestCorner(const dgg::PoissonSolver& solver, const dgg::SurfacePoint& point);

/// Reads the right-hand side of an equation: one finite number per point.
dgg::Status DGGReadRightHandSide(
  vtkPolyData* surface, const std::string& name, std::vector<double>& values);

/// Reads the values at sites from point arrays of the same name: first at points of the surface,
/// then at other points, which may be null. `values[c]` are the values of component c. Fails if an
/// array is missing or of another kind, or if a value of a site is not finite; the message names
/// the defect.
dgg::Status DGGReadSiteValues(const std::string& name, vtkPolyData* surface,
  const std::vector<vtkIdType>& ids, vtkPolyData* points, std::vector<std::vector<double>>& values);

/// Computes the results that a task requests. The sources of the task are the sites.
class DGGSplineRun
{
public:
  /// `isSmooth`: with order 1, functions at targets are computed by Green's functions of the
  /// targets.
  DGGSplineRun(DGGSpectralTask& task, bool isBiharmonic, bool isSmooth);

  /// Checks the sites. If `wantsFunctions`, prepares functions, which solutions of order 1 require.
  dgg::Status Prepare(bool wantsFunctions, const dgg::ProgressCallback& progress);
  /// Computes all basis functions. They become results if `isResult`. If `isKept`, their values at
  /// sites are kept for AddInterpolation() (order 1).
  dgg::Status FindBasis(bool isResult, bool isKept, const dgg::ProgressCallback& progress);
  /// Adds the site of each point (order 1).
  void AddCells(const std::string& name);
  /// Adds functions with the given values at the sites. Requires Prepare() with functions, and with
  /// order 1 also FindBasis().
  dgg::Status AddInterpolation(const std::vector<std::vector<double>>& siteValues,
    const std::string& name, const dgg::ProgressCallback& progress);
  /// Adds the solution for the given numbers at the points. `imbalance` is the largest absolute sum
  /// of sources over a component that must be balanced, relative to the sum of absolute values.
  dgg::Status AddSolution(const std::vector<double>& numbers, bool isDensity,
    const std::string& solutionName, double& imbalance);

private:
  std::vector<double> EvaluatedOf(std::size_t site) const;

  DGGSpectralTask& Task;
  const dgg::SurfaceMesh& Mesh;
  bool IsBiharmonic;
  bool IsSmooth;
  dgg::HarmonicSplines Harmonic;
  dgg::BiharmonicSplines Biharmonic;
  std::vector<double> AtSites;   // basis functions of order 1, in succession
  std::vector<double> Evaluated; // per target and site; empty unless smooth
};

#endif
