// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tasks that solve Poisson equations for sources. Internal.
#ifndef dggSpectralTask_h
#define dggSpectralTask_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggOutput.h"        // for Output
#include "dggPoissonSolver.h" // for the solver
#include "dggSurfacePoint.h"  // for sources

#include <cstddef> // for std::size_t
#include <string>  // for names
#include <vector>  // for points and values

namespace dgg
{
class PoissonSession;
class PreparedSurface;
struct TaskContext;

/// Writer of arrays at the points of a surface and at evaluation points.
class DGG_CORE_EXPORT SpectralOutputs
{
public:
  /// Values of an array, tuple by tuple.
  template <typename ValueType>
  struct Values
  {
    std::size_t Components;
    ValueType* AtPoints;
    ValueType* AtTargets;
  };

  /// All arguments must outlive this object. `outputs` are the outputs of points and of targets.
  SpectralOutputs(const PreparedSurface& surface, std::size_t numberOfTargets, Output* outputs);

  /// Adds an array, unless it has no components.
  template <typename ValueType>
  Values<ValueType> Add(const std::string& name, std::size_t components = 1);
  /// Sets one component from values per vertex and per target. Several threads may set different
  /// components simultaneously.
  template <typename ValueType, typename Number>
  void Set(const Values<ValueType>& array, std::size_t component, const std::vector<Number>& values,
    const std::vector<Number>& targetValues) const;

private:
  const PreparedSurface& Surface;
  std::size_t NumberOfPoints;
  std::size_t NumberOfTargets;
  Output* Outputs;
};

/// Arguments of SpectralTask::Compute().
struct SpectralRun
{
  const TaskContext& Context;
  const PoissonSolver& Solver;              ///< ready
  int SolverNumber;                         ///< changes with the solver
  const std::vector<SurfacePoint>& Sources; ///< empty only if the task may select sources
  const std::vector<SurfacePoint>& Targets; ///< points to evaluate at; may be empty
  double FreeMemory;                        ///< bytes of the limit that are left for caches
  ProgressCallback Progress;                ///< remaining progress of the context
  SpectralOutputs::Values<double> Result;   ///< to be set for each source, if requested
  SpectralOutputs& Outputs;                 ///< for further arrays
  std::vector<std::string>& Warnings;       ///< without the final period
};

/// A task that computes a function for each source on a surface.
class DGG_CORE_EXPORT SpectralTask
{
public:
  virtual ~SpectralTask() = default;

  PoissonOptions Poisson;
  std::string ResultName;
  bool WantResult = true;

  /// Computes all arrays. `outputs` are the outputs of the surface and of the targets; the result
  /// is the last array and the active one. Warnings belong to the first output. `remedy` is the
  /// action besides raising the memory limit.
  Status Run(const TaskContext& context, PoissonSession& session, std::vector<SurfacePoint> sources,
    const std::vector<SurfacePoint>& targets, const std::string& remedy, Output* outputs);

  /// Writes the same arrays for a surface without points.
  void WriteEmpty(const PreparedSurface& surface, Output* outputs) const;

  /// Returns true if sources may be missing.
  virtual bool CanChooseSources() const { return false; }

protected:
  /// Checks the input besides sources, before the factorization, so that errors cost little.
  virtual Status CheckInput(const TaskContext&) { return Status::Success(); }

  ///@{
  /// For tasks that select sources themselves or move given ones: the number of sources on a
  /// surface that is ready to be factorized, and the sources. By default sources are used as given.
  virtual std::size_t CountSources(const PoissonSolver&, std::size_t given) const { return given; }
  virtual Status ChooseSources(
    const PoissonSolver&, const ProgressCallback&, std::vector<SurfacePoint>&) const
  {
    return Status::Success();
  }
  ///@}

  /// Returns the largest number of bytes that Compute() allocates besides its results.
  virtual double EstimateMemory(const TaskContext& context, const PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const = 0;

  virtual Status Compute(const SpectralRun& run) = 0;

  /// Adds the arrays of Compute() without tuples.
  virtual void AddEmptyArrays(SpectralOutputs&) const {}
};
}

#endif
