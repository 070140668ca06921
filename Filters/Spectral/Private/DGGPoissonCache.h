// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The factorization that a filter keeps from update to update. Internal.
#ifndef DGGPoissonCache_h
#define DGGPoissonCache_h

#include "dggPoissonSolver.h" // for PoissonSolver

#include "vtkTimeStamp.h" // for the solver
#include "vtkType.h"      // for vtkTypeUInt64

#include <cstdint>    // for the build number
#include <functional> // for what else takes memory
#include <memory>     // for the solver
#include <string>     // for advice

namespace dgg
{
class PreparedSurface;
}
struct DGGContext;

/// Keeps a dgg::PoissonSolver until the mesh changes, or an option that matters to its matrix.
class DGGPoissonCache
{
public:
  /// Bytes that will be taken besides the solver's, once it has been analyzed.
  using OtherMemory = std::function<double(const dgg::PoissonSolver&)>;

  /// Bring the solver up to date. Fails when it and what else is wanted would take more memory than
  /// the limit of the context. Must be called in every update: the solver reads the mesh, which
  /// may be another one.
  dgg::Status Prepare(const DGGContext& context, const dgg::PoissonOptions& options,
    const OtherMemory& others, const std::string& remedy, const dgg::ProgressCallback& progress);

  /// Whether Prepare() would have nothing to factorize.
  bool IsPrepared(const dgg::PreparedSurface& mesh, const dgg::PoissonOptions& options) const;

  /// Returns the solver. Call Prepare() first.
  const dgg::PoissonSolver& GetSolver() const { return *this->Solver; }
  /// When that solver was made. What refers to it is released with it.
  vtkMTimeType GetSolverTime() const { return this->SolverTime.GetMTime(); }

  int GetNumberOfFactorizations() const;
  /// About how many bytes are held.
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
