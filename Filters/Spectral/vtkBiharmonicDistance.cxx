// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBiharmonicDistance.h"

#include "DGGContext.h"
#include "DGGSpectralInternals.h"

#include "dggStatus.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggSpectralDistance.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

vtkStandardNewMacro(vtkBiharmonicDistance);

namespace
{
/// Progress after eigenvalues or solutions for all points, and after distances to evaluation
/// points.
constexpr double SpectrumDone = 0.6;
constexpr double TargetsDone = 0.7;
/// Memory of the search for eigenvalues, in functions per eigenvalue, and of an exact solve, in
/// numbers per point and thread.
constexpr double FunctionsPerEigenvalue = 3.0;
constexpr double NumbersPerThread = 24.0;

using PlaceCheck = dgg::Status (dgg::SpectralDistance::*)(const dgg::SurfacePoint&) const;

/// Checks all points before the long computations.
dgg::Status CheckAll(const dgg::SpectralDistance& distance, PlaceCheck check,
  const std::vector<dgg::SurfacePoint>& points, const std::string& name)
{
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    DGG_RETURN_IF_ERROR((distance.*check)(points[k]).Of(name + std::to_string(k)));
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
class vtkBiharmonicDistance::vtkInternals
  : public DGGInternalsOf<vtkBiharmonicDistance, DGGSpectralInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  double EstimateWorkingMemory(const DGGContext& context, const dgg::PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const override;
  dgg::Status ComputeValues(DGGSpectralTask& task) override;

  /// Solver, kept until the mesh changes.
  struct Preparation
  {
    vtkMTimeType SolverTime;
    dgg::SpectralDistance Distance;
  };

  int GetNumberOfSpectra() const
  {
    return this->EarlierSpectra +
      (this->Prepared ? this->Prepared->Distance.GetNumberOfSpectra() : 0);
  }

  std::unique_ptr<Preparation> Prepared;
  int EarlierSpectra = 0; // for meshes before the last one
};

vtkDGGInternalsMacro(vtkBiharmonicDistance);

//------------------------------------------------------------------------------
vtkBiharmonicDistance::vtkBiharmonicDistance()
  : vtkSpectralAlgorithm("BiharmonicDistance")
  , Kind(Biharmonic)
  , Method(Spectrum)
  , NumberOfEigenvalues(150)
  , DiffusionTime(0.0)
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkBiharmonicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->GetKindAsString() << "\n";
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "NumberOfEigenvalues: " << this->NumberOfEigenvalues << "\n";
  os << indent << "DiffusionTime: " << this->DiffusionTime << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "NumberOfSpectra: " << this->GetNumberOfSpectra() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkBiharmonicDistance::GetKindAsString() const
{
  static const char* const names[] = { "Biharmonic", "CommuteTime", "Diffusion" };
  return names[this->Kind];
}

//------------------------------------------------------------------------------
const char* vtkBiharmonicDistance::GetMethodAsString() const
{
  return this->Method == Exact ? "Exact" : "Spectrum";
}

//------------------------------------------------------------------------------
int vtkBiharmonicDistance::GetNumberOfSpectra() const
{
  return this->GetInternals().GetNumberOfSpectra();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkBiharmonicDistance::GetMemorySize() const
{
  const auto& prepared = this->GetInternals().Prepared;
  return this->Superclass::GetMemorySize() + (prepared ? prepared->Distance.GetMemorySize() : 0);
}

//------------------------------------------------------------------------------
dgg::Status vtkBiharmonicDistance::vtkInternals::CheckProperties() const
{
  if (this->Self->Kind == Diffusion && this->Self->Method == Exact)
  {
    return dgg::InvalidInput("Diffusion distances need eigenvalues")
      .At("Method")
      .Fix("Set {Method} to Spectrum");
  }
  if (!(this->Self->DiffusionTime >= 0.0) || !std::isfinite(this->Self->DiffusionTime))
  {
    return dgg::InvalidValue("DiffusionTime", this->Self->DiffusionTime)
      .Fix("Use a positive number, or 0 for the default");
  }
  if (this->Self->NumberOfEigenvalues < 1)
  {
    return dgg::InvalidValue("NumberOfEigenvalues", this->Self->NumberOfEigenvalues)
      .Fix("Use a positive number, such as 150");
  }
  return DGGSpectralInternals::CheckProperties();
}

//------------------------------------------------------------------------------
double vtkBiharmonicDistance::vtkInternals::EstimateWorkingMemory(const DGGContext& context,
  const dgg::PoissonSolver& solver, std::size_t numberOfSources, std::size_t numberOfTargets) const
{
  const auto n = static_cast<double>(solver.GetAreas().size());
  const double count = std::min<double>(this->Self->NumberOfEigenvalues, n);
  const auto points =
    numberOfTargets > 0 ? static_cast<double>(numberOfSources + numberOfTargets) : 0.0;
  const double numbers = this->Self->Method == Exact
    ? n * (NumbersPerThread * context.NumberOfThreads + points)
    : count * (FunctionsPerEigenvalue * n + points);
  return numbers * sizeof(double);
}

//------------------------------------------------------------------------------
dgg::Status vtkBiharmonicDistance::vtkInternals::ComputeValues(DGGSpectralTask& task)
{
  const dgg::SpectralKind kinds[] = { dgg::SpectralKind::Biharmonic, dgg::SpectralKind::CommuteTime,
    dgg::SpectralKind::Diffusion };
  dgg::SpectralOptions options;
  options.Kind = kinds[this->Self->Kind];
  options.Method =
    this->Self->Method == Exact ? dgg::SpectralMethod::Exact : dgg::SpectralMethod::Spectrum;
  options.NumberOfEigenvalues = this->Self->NumberOfEigenvalues;
  options.Time = this->Self->DiffusionTime;
  if (!this->Prepared || this->Prepared->SolverTime != task.SolverTime)
  {
    this->EarlierSpectra = this->GetNumberOfSpectra();
    this->Prepared.reset(); // release before the next is allocated
    this->Prepared.reset(new Preparation{ task.SolverTime, dgg::SpectralDistance(task.Solver) });
  }
  dgg::SpectralDistance& distance = this->Prepared->Distance;
  DGG_RETURN_IF_ERROR(
    CheckAll(distance, &dgg::SpectralDistance::CheckSource, task.Sources, "source "));
  DGG_RETURN_IF_ERROR(
    CheckAll(distance, &dgg::SpectralDistance::CheckPlace, task.Targets, "Evaluation point "));
  const dgg::ParallelFor& parallel = task.Context.Parallel;
  DGG_RETURN_IF_ERROR(distance.Prepare(
    options, parallel, dgg::ProgressPart(task.Progress, 0.0, SpectrumDone), task.Sources));
  // Between sources and evaluation points, row by row.
  std::vector<double> matrix;
  if (!task.Targets.empty())
  {
    DGG_RETURN_IF_ERROR(distance.Between(task.Sources, task.Targets, parallel,
      dgg::ProgressPart(task.Progress, SpectrumDone, TargetsDone), matrix));
  }
  const auto count = static_cast<double>(task.Sources.size());
  for (std::size_t k = 0; k < task.Sources.size(); ++k)
  {
    std::vector<double> values;
    DGG_RETURN_IF_ERROR(distance.FromPoint(task.Sources[k], values));
    const double done = static_cast<double>(k + 1) / count;
    DGG_RETURN_IF_ERROR(dgg::ReportTo(task.Progress, TargetsDone + (1.0 - TargetsDone) * done));
    const auto row = matrix.begin() + static_cast<std::ptrdiff_t>(k * task.Targets.size());
    std::vector<double> targetValues(row, row + static_cast<std::ptrdiff_t>(task.Targets.size()));
    std::replace(values.begin(), values.end(), dgg::Infinity, this->Self->UnreachedValue);
    std::replace(
      targetValues.begin(), targetValues.end(), dgg::Infinity, this->Self->UnreachedValue);
    task.Outputs.Set(k, values, targetValues);
  }
  return dgg::ReportTo(task.Progress, 1.0);
}
