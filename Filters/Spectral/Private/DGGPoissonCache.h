// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Factorization that a filter keeps between updates. Internal.
#ifndef DGGPoissonCache_h
#define DGGPoissonCache_h

#include "dggPoissonSolver.h" // for PoissonSolver

#include "vtkTimeStamp.h" // for the solver
#include "vtkType.h"      // for vtkTypeUInt64

#include <cstdint>    // for the build number
#include <functional> // for OtherMemory
#include <memory>     // for the solver
#include <string>     // for advice

namespace dgg
{
class PreparedSurface;
}
struct DGGContext;

/// Keeps a dgg::PoissonSolver until the mesh or an option that affects the matrix changes.
class DGGPoissonCache
{
public:
  /// Returns the bytes that will be allocated in addition to the solver, which has been analyzed.
  using OtherMemory = std::function<double(const dgg::PoissonSolver&)>;

  /// Updates the solver. Fails if the solver and `others` would take more memory than the limit of
  /// the context. Must be called in every update, because the solver refers to the mesh, which may
  /// have been replaced.
  dgg::Status Prepare(const DGGContext& context, const dgg::PoissonOptions& options,
    const OtherMemory& others, const std::string& remedy, const dgg::ProgressCallback& progress);

  /// Returns true if Prepare() would not factorize.
  bool IsPrepared(const dgg::PreparedSurface& mesh, const dgg::PoissonOptions& options) const;

  /// Returns the solver. Call Prepare() first.
  const dgg::PoissonSolver& GetSolver() const { return *this->Solver; }
  /// Time at which the solver was created. Data that refer to an earlier solver must be released.
  vtkMTimeType GetSolverTime() const { return this->SolverTime.GetMTime(); }

  int GetNumberOfFactorizations() const;
  /// Returns the approximate number of bytes that are held.
  vtkTypeUInt64 GetMemorySize() const
  {
    return this->Solver ? static_cast<vtkTypeUInt64>(this->Solver->GetEstimatedMemory()) : 0;
  }

private:
  std::unique_ptr<dgg::PoissonSolver> Solver;
  vtkTimeStamp SolverTime;
  std::uint64_t MeshBuild = 0;
  int EarlierFactorizations = 0; // for meshes before this one
};

#endif
