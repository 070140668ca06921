// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Spectral distances from sources as a task. Internal.
#ifndef dggSpectralDistanceTask_h
#define dggSpectralDistanceTask_h

#include "dggSpectralDistance.h" // for options
#include "dggSpectralTask.h"     // for the base

#include <limits>   // for NaN
#include <optional> // for the kept distance

namespace dgg
{
/// Computes distances from each source. Eigenvalues are kept until the surface changes.
class DGG_CORE_EXPORT SpectralDistanceTask : public SpectralTask
{
public:
  SpectralOptions Options;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();

  /// Returns the number of spectra computed so far.
  int GetNumberOfSpectra() const;
  /// Returns the bytes that are kept.
  std::size_t GetMemorySize() const { return this->Distance ? this->Distance->GetMemorySize() : 0; }

protected:
  double EstimateMemory(const TaskContext& context, const PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const override;
  Status Compute(const SpectralRun& run) override;

private:
  std::optional<SpectralDistance> Distance; // on the solver of SolverNumber
  int SolverNumber = 0;
  int EarlierSpectra = 0; // number of spectra of earlier meshes
};
}

#endif
