// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What vtkHarmonicBSpline computes, of both orders. Internal.
#ifndef DGGSplineRun_h
#define DGGSplineRun_h

#include "DGGSpectralInternals.h" // for the task

#include "dggBiharmonicSplines.h" // for splines of order 2
#include "dggHarmonicSplines.h"   // for splines of order 1

#include <string> // for names
#include <vector> // for values

class vtkPolyData;

/// The corner that a point is nearest to, a free one if there is one.
dgg::Id DGGFindNearestCorner(const dgg::PoissonSolver& solver, const dgg::SurfacePoint& point);

/// Reads the right-hand side of an equation: one finite number per point.
dgg::Status DGGReadRightHandSide(
  vtkPolyData* surface, const std::string& name, std::vector<double>& values);

/// Values at sites: first those of points of the surface, then those of other points, which may be
/// null; from point arrays of the same name. `values[c]` are those of component c. Fails, with a
/// message that says what is wrong, when one is missing or of another kind, or a value of a site is
/// not finite.
dgg::Status DGGReadSiteValues(const std::string& name, vtkPolyData* surface,
  const std::vector<vtkIdType>& ids, vtkPolyData* points, std::vector<std::vector<double>>& values);

/// Finds what a task asks for. Its sources are the sites.
class DGGSplineRun
{
public:
  /// `isSmooth`: of order 1, functions at targets by Green's functions of their own.
  DGGSplineRun(DGGSpectralTask& task, bool isBiharmonic, bool isSmooth);

  /// Sites are checked, and if functions are wanted prepared for. Of order 1 solutions need that.
  dgg::Status Prepare(bool wantsFunctions, const dgg::ProgressCallback& progress);
  /// All basis functions. They become results if `isResult`, and of order 1 are kept at sites for
  /// AddInterpolation() if `isKept`.
  dgg::Status FindBasis(bool isResult, bool isKept, const dgg::ProgressCallback& progress);
  /// The site of each point, of order 1.
  void AddCells(const std::string& name);
  /// Functions with given values at the sites. After Prepare() for functions, of order 1 after
  /// FindBasis() as well.
  dgg::Status AddInterpolation(const std::vector<std::vector<double>>& siteValues,
    const std::string& name, const dgg::ProgressCallback& progress);
  /// The solution for the given numbers at the points. `imbalance` is the largest sum that has to
  /// be balanced in a component, relative to the sum of sizes.
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
  std::vector<double> AtSites;   // basis functions of order 1, one after the other
  std::vector<double> Evaluated; // per target and site, if they are to be smooth
};

#endif
