// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Factorization that is kept between updates. Internal.
#ifndef dggPoissonSession_h
#define dggPoissonSession_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggPoissonSolver.h" // for PoissonSolver

#include <cstddef>    // for std::size_t
#include <cstdint>    // for the build number
#include <functional> // for OtherMemory
#include <memory>     // for the solver
#include <string>     // for advice

namespace dgg
{
struct TaskContext;

/// Keeps a PoissonSolver until the surface or an option that affects the matrix changes.
class DGG_CORE_EXPORT PoissonSession
{
public:
  /// Returns the bytes that will be allocated in addition to the solver, which has been analyzed.
  using OtherMemory = std::function<double(const PoissonSolver&)>;

  /// Updates the solver. Fails if the solver and `others` would take more memory than the limit of
  /// the context; `remedy` is what to do besides raising it. `done` receives the progress of the
  /// context afterwards. Must be called in every update, because the solver refers to the mesh,
  /// which may have been replaced.
  Status Prepare(const TaskContext& context, const PoissonOptions& options,
    const OtherMemory& others, const std::string& remedy, double& done);

  /// Returns the solver. Call Prepare() first.
  const PoissonSolver& GetSolver() const { return *this->Solver; }
  /// Returns the number of solvers so far. Data that refer to an earlier solver must be released.
  int GetSolverNumber() const { return this->SolverNumber; }

  int GetNumberOfFactorizations() const;
  /// Returns the approximate number of bytes that are held.
  std::size_t GetMemorySize() const
  {
    return this->Solver ? static_cast<std::size_t>(this->Solver->GetEstimatedMemory()) : 0;
  }

private:
  std::unique_ptr<PoissonSolver> Solver;
  int SolverNumber = 0;
  std::uint64_t MeshBuild = 0;
  int EarlierFactorizations = 0; // for meshes before this one
};
}

#endif
