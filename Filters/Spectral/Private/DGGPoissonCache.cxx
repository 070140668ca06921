// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPoissonCache.h"

#include "DGGContext.h"

#include "dggPreparedSurface.h"

//------------------------------------------------------------------------------
int DGGPoissonCache::GetNumberOfFactorizations() const
{
  return this->EarlierFactorizations +
    (this->Solver ? this->Solver->GetNumberOfFactorizations() : 0);
}

//------------------------------------------------------------------------------
bool DGGPoissonCache::IsPrepared(
  const dgg::PreparedSurface& mesh, const dgg::PoissonOptions& options) const
{
  return this->Solver && this->MeshBuild == mesh.GetBuildNumber() && this->Solver->IsReady() &&
    this->Solver->GetOptions().Boundary == options.Boundary &&
    this->Solver->GetOptions().DirichletVertices == options.DirichletVertices &&
    this->Solver->GetOptions().IntrinsicDelaunay == options.IntrinsicDelaunay;
}

//------------------------------------------------------------------------------
dgg::Status DGGPoissonCache::Prepare(const DGGContext& context, const dgg::PoissonOptions& options,
  const OtherMemory& others, const std::string& remedy, const dgg::ProgressCallback& progress)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  if (!this->Solver || this->MeshBuild != mesh.GetBuildNumber())
  {
    this->EarlierFactorizations = this->GetNumberOfFactorizations();
    this->Solver.reset(); // release before the next is allocated
    this->Solver = std::make_unique<dgg::PoissonSolver>(mesh.GetMesh());
    this->SolverTime.Modified();
    this->MeshBuild = mesh.GetBuildNumber();
  }
  return this->Solver->Prepare(options, progress, [&](double bytes, double missing) {
    // Memory that the solver already holds is not free any more, so it must not be compared with
    // the free memory.
    const double own = !context.Memory.IsExplicit() ? missing : bytes;
    return context.Memory.Check(
      "The factorization with the results", own + others(*this->Solver), remedy);
  });
}
