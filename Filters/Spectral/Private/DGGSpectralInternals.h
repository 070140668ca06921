// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Private implementation of spectral filters. Internal.
#ifndef DGGSpectralInternals_h
#define DGGSpectralInternals_h

#include "DGGFilterInternals.h" // for the base

#include "dggPoissonSession.h" // for the factorization

#include <string> // for the remedy

namespace dgg
{
class SpectralTask;
}
struct DGGSourceSet;
class vtkSpectralAlgorithm;

/// The steps of an update of a vtkSpectralAlgorithm.
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

  /// Returns the task, with the properties of the subclass and its inputs besides sources.
  virtual dgg::SpectralTask& PrepareTask(vtkPolyData* surface, const DGGSourceSet& sources) = 0;

  dgg::PoissonSession Session;

private:
  dgg::SpectralTask& PrepareTaskWithOptions(vtkPolyData* surface, const DGGSourceSet& sources);
  DGGSourceSet GetSources(vtkPolyData* points) const;

  vtkSpectralAlgorithm* Filter;
};

#endif
