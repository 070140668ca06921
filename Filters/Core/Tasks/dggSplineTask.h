// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Harmonic and biharmonic splines of sites as a task. Internal.
#ifndef dggSplineTask_h
#define dggSplineTask_h

#include "dggInputArray.h"   // for values of sites
#include "dggSpectralTask.h" // for the base

#include <string> // for names
#include <vector> // for sites

namespace dgg
{
/// Computes basis functions of the sources, which are the sites, interpolations of values at sites,
/// and solutions of the Poisson equation. Sites are chosen if none are given.
class DGG_CORE_EXPORT SplineTask : public SpectralTask
{
public:
  bool IsBiharmonic = false;
  bool IsSmooth = false; ///< functions of order 1 at targets are not linear in faces
  bool IsDensity = true; ///< meaning of RightHandSide; otherwise integrated sources
  Id NumberOfSites = 20; ///< to choose
  std::string CellName;  ///< array with the site of each point (order 1)
  std::string SolutionName;
  std::string InterpolationName;

  ///@{
  /// Inputs, released at the end of Run(). An array without a name is not requested.
  InputArray RightHandSide;       ///< array of the surface
  InputArray SurfaceValues;       ///< values of sites that are points of the surface
  InputArray PointValues;         ///< values of other sites, with the same name
  std::vector<Offset> GivenIds;   ///< sources: points of the surface, then others
  Offset NumberOfGivenPoints = 0; ///< number of these others
  ///@}

  /// Fails if a name is empty or used twice.
  static Status CheckNames(const std::string& result, const std::string& cell,
    const std::string& solution, const std::string& interpolation);

  /// Returns the vertex of each site; -1 if a site is not a vertex. Empty after Forget() and after
  /// a failure.
  const std::vector<Offset>& GetUsedSites() const { return this->UsedSites; }
  /// Releases sites and inputs.
  void Forget();

  bool CanChooseSources() const override { return true; }

protected:
  Status CheckInput(const TaskContext& context) override;
  std::size_t CountSources(const PoissonSolver& solver, std::size_t given) const override;
  Status ChooseSources(const PoissonSolver& solver, const ProgressCallback& progress,
    std::vector<SurfacePoint>& sources) const override;
  double EstimateMemory(const TaskContext& context, const PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const override;
  Status Compute(const SpectralRun& run) override;
  void AddEmptyArrays(SpectralOutputs& outputs) const override;

private:
  Status ReadSiteValues(
    const TaskContext& context, const std::vector<Offset>& ids, Offset numberOfPoints);
  Status AppendSiteValues(const InputArray& array, const std::string& where, Offset numberOfPoints,
    const std::vector<Offset>* ids);

  std::vector<std::vector<double>> SiteValues; // per component; empty without an interpolation
  std::vector<Offset> UsedSites;
};
}

#endif
