// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Private implementation of spectral filters. Internal.
#ifndef DGGSpectralInternals_h
#define DGGSpectralInternals_h

#include "DGGFilterInternals.h" // for the base
#include "DGGPoissonCache.h"    // for the factorization
#include "DGGSpectralOutputs.h" // for results

#include "dggPoissonSolver.h" // for the solver
#include "dggSurfacePoint.h"  // for surface points

#include <cstddef> // for std::size_t
#include <string>  // for the remedy
#include <vector>  // for points

struct DGGSourceSet;
class vtkSpectralAlgorithm;

/// Arguments of DGGSpectralInternals::ComputeValues(). Surface points are valid and the solver is
/// ready; a filter checks further inputs and properties of its own.
struct DGGSpectralTask
{
  const DGGContext& Context;                     ///< context of the update
  const dgg::PoissonSolver& Solver;              ///< ready
  vtkMTimeType SolverTime;                       ///< changes with the solver
  const std::vector<dgg::SurfacePoint>& Sources; ///< empty only if the filter may select sources
  const std::vector<dgg::SurfacePoint>& Targets; ///< may be empty
  const DGGSourceSet& SourceSet;                 ///< sources as given
  double FreeMemory;                             ///< bytes of the limit that are left for caches
  dgg::ProgressCallback Progress;                ///< remaining progress of the context
  DGGSpectralOutputs& Outputs;                   ///< to be set for each source
};

/// The steps of an update of a vtkSpectralAlgorithm, except the computation of values.
class DGGSpectralInternals : public DGGFilterInternals
{
public:
  explicit DGGSpectralInternals(vtkSpectralAlgorithm* filter);

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or fewer sources at a time";
  }

  /// Returns the options of the system to factorize.
  virtual dgg::PoissonOptions GetPoissonOptions() const;

  ///@{
  /// For filters that select sources themselves or move given ones. CanChooseSources() returns true
  /// if there may be no given source; the number of sources on a surface that is ready to be
  /// factorized; and the sources. The callback takes the progress and returns false to stop. By
  /// default sources are required and used as given.
  virtual bool CanChooseSources() const { return false; }
  virtual std::size_t CountSources(
    const dgg::PoissonSolver& vtkNotUsed(solver), std::size_t given) const
  {
    return given;
  }
  virtual dgg::Status ChooseSources(const dgg::PoissonSolver& vtkNotUsed(solver),
    const dgg::ProgressCallback& vtkNotUsed(progress),
    std::vector<dgg::SurfacePoint>& vtkNotUsed(sources)) const
  {
    return dgg::Status::Success();
  }
  ///@}

  /// Reads and checks the inputs besides sources, which have been checked. Called before the
  /// factorization, so that errors cost little. Default: no further inputs.
  virtual dgg::Status ReadInputs(
    vtkPolyData* vtkNotUsed(surface), const DGGSourceSet& vtkNotUsed(sources))
  {
    return dgg::Status::Success();
  }

  /// Returns the number of components of the result array; 0 if the array is not requested.
  /// Default: one per source.
  virtual std::size_t CountResults(std::size_t numberOfSources) const { return numberOfSources; }

  /// Returns the largest number of bytes that ComputeValues() allocates besides its results.
  virtual double EstimateWorkingMemory(const DGGContext& context, const dgg::PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const = 0;

  /// Sets the outputs of the task for each source. Returns an error, which is reported, or the
  /// status of an abort by the task's Progress. May throw.
  virtual dgg::Status ComputeValues(DGGSpectralTask& task) = 0;

  DGGPoissonCache Cache;

private:
  DGGSourceSet GetSources(vtkInformationVector** inputVector) const;
  static DGGSourceSet GetTargets(vtkInformationVector** inputVector);

  vtkSpectralAlgorithm* Filter;
};

#endif
