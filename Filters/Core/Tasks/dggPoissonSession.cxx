// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPoissonSession.h"

#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggTaskContext.h"

namespace dgg
{
namespace
{
/// Progress after factorization, or after finding a kept factorization.
constexpr double FactorizedAt = 0.4;
constexpr double FoundAt = 0.01;
}

//------------------------------------------------------------------------------
int PoissonSession::GetNumberOfFactorizations() const
{
  return this->EarlierFactorizations +
    (this->Solver ? this->Solver->GetNumberOfFactorizations() : 0);
}

//------------------------------------------------------------------------------
Status PoissonSession::Prepare(const TaskContext& context, const PoissonOptions& options,
  const OtherMemory& others, const std::string& remedy, double& done)
{
  const PreparedSurface& surface = context.Surface;
  const bool isNew = !this->Solver || this->MeshBuild != surface.GetBuildNumber();
  done = !isNew && this->Solver->IsReady() &&
      this->Solver->GetOptions().Boundary == options.Boundary &&
      this->Solver->GetOptions().DirichletVertices == options.DirichletVertices &&
      this->Solver->GetOptions().IntrinsicDelaunay == options.IntrinsicDelaunay
    ? FoundAt
    : FactorizedAt;
  if (isNew)
  {
    this->EarlierFactorizations = this->GetNumberOfFactorizations();
    this->Solver.reset(); // release before the next is allocated
    this->Solver = std::make_unique<PoissonSolver>(surface.GetMesh());
    ++this->SolverNumber;
    this->MeshBuild = surface.GetBuildNumber();
  }
  const auto check = [&](double bytes, double missing) {
    // Memory that the solver already holds is not free any more, so it must not be compared with
    // the free memory.
    const double own = !context.Memory.IsExplicit() ? missing : bytes;
    return context.Memory.Check(
      "The factorization with the results", own + others(*this->Solver), remedy);
  };
  return this->Solver->Prepare(options, ProgressPart(context.Progress, 0.0, done), check);
}
}
