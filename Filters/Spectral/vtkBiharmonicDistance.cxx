// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBiharmonicDistance.h"

#include "vtkDGGParallel.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSpectralOutputs.h"

#include "dggProgressPart.h"
#include "dggSpectralDistance.h"

#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkBiharmonicDistance);

namespace
{
/// Parts of the progress: eigenvalues, or solutions for all points; distances to evaluation points.
constexpr double SpectrumDone = 0.6;
constexpr double TargetsDone = 0.7;
/// Memory of the search for eigenvalues, in functions for each, and that of an exact solve, in
/// numbers for each point and thread.
constexpr double FunctionsPerEigenvalue = 3.0;
constexpr double NumbersPerThread = 24.0;

bool IsSame(const dgg::SpectralOptions& a, const dgg::SpectralOptions& b)
{
  return a.Kind == b.Kind && a.Method == b.Method && a.Time == b.Time &&
    a.NumberOfEigenvalues == b.NumberOfEigenvalues;
}

bool HasSameSpectrum(const dgg::SpectralOptions& a, const dgg::SpectralOptions& b)
{
  return a.Method == dgg::SpectralMethod::Spectrum && b.Method == dgg::SpectralMethod::Spectrum &&
    a.NumberOfEigenvalues == b.NumberOfEigenvalues;
}

using PlaceCheck = dgg::Status (dgg::SpectralDistance::*)(const dgg::SurfacePoint&) const;

/// Before anything takes long.
dgg::Status CheckAll(const dgg::SpectralDistance& distance, PlaceCheck check,
  const std::vector<dgg::SurfacePoint>& points, const std::string& name)
{
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const dgg::Status status = (distance.*check)(points[k]);
    if (!status.IsOk())
    {
      return dgg::Status::Invalid(name + std::to_string(k) + ": " + status.GetMessage());
    }
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
/// Kept until the mesh or the system changes.
struct vtkBiharmonicDistance::Preparation
{
  explicit Preparation(const vtkDGGSpectralTask& task)
    : MeshTime(task.MeshTime)
    , Revision(task.Solver.GetRevision())
    , Distance(task.Solver)
  {
  }

  vtkMTimeType MeshTime;
  std::uint64_t Revision;
  dgg::SpectralDistance Distance;
  dgg::SpectralOptions Options;
  bool IsReady = false;
};

//------------------------------------------------------------------------------
vtkBiharmonicDistance::vtkBiharmonicDistance()
  : vtkSpectralAlgorithm("BiharmonicDistance")
  , Kind(Biharmonic)
  , Method(Spectrum)
  , NumberOfEigenvalues(150)
  , DiffusionTime(0.0)
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
  , NumberOfSpectra(0)
{
}

//------------------------------------------------------------------------------
vtkBiharmonicDistance::~vtkBiharmonicDistance() = default;

//------------------------------------------------------------------------------
void vtkBiharmonicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->GetKindAsString() << "\n";
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "NumberOfEigenvalues: " << this->NumberOfEigenvalues << "\n";
  os << indent << "DiffusionTime: " << this->DiffusionTime << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "NumberOfSpectra: " << this->NumberOfSpectra << "\n";
}

//------------------------------------------------------------------------------
const char* vtkBiharmonicDistance::GetKindAsString() const
{
  switch (this->Kind)
  {
    case CommuteTime:
      return "CommuteTime";
    case Diffusion:
      return "Diffusion";
    default:
      return "Biharmonic";
  }
}

//------------------------------------------------------------------------------
const char* vtkBiharmonicDistance::GetMethodAsString() const
{
  return this->Method == Exact ? "Exact" : "Spectrum";
}

//------------------------------------------------------------------------------
void vtkBiharmonicDistance::SetUnreachedValue(double value)
{
  if (vtkDGGChangeNumber(this->UnreachedValue, value))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkBiharmonicDistance::GetNumberOfSpectra() const
{
  return this->NumberOfSpectra;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkBiharmonicDistance::GetMemorySize() const
{
  return this->Superclass::GetMemorySize() +
    (this->Prepared ? this->Prepared->Distance.GetMemorySize() : 0);
}

//------------------------------------------------------------------------------
dgg::Status vtkBiharmonicDistance::CheckProperties() const
{
  std::ostringstream message;
  if (this->Kind == Diffusion && this->Method == Exact)
  {
    message << "diffusion distances need eigenvalues: call SetMethodToSpectrum()";
  }
  else if (!(this->DiffusionTime >= 0.0) || !std::isfinite(this->DiffusionTime))
  {
    message << "DiffusionTime is " << this->DiffusionTime
            << ": call SetDiffusionTime() with a positive number, or 0 for the usual one";
  }
  else if (this->NumberOfEigenvalues < 1)
  {
    message << "NumberOfEigenvalues is " << this->NumberOfEigenvalues
            << ": call SetNumberOfEigenvalues() with a positive number, as 150";
  }
  return message.str().empty() ? this->Superclass::CheckProperties()
                               : dgg::Status::Invalid(message.str());
}

//------------------------------------------------------------------------------
double vtkBiharmonicDistance::EstimateWorkingMemory(
  const dgg::PoissonSolver& solver, std::size_t numberOfSources, std::size_t numberOfTargets) const
{
  const auto n = static_cast<double>(solver.GetAreas().size());
  const double count = std::min<double>(this->NumberOfEigenvalues, n);
  const auto points =
    numberOfTargets > 0 ? static_cast<double>(numberOfSources + numberOfTargets) : 0.0;
  const double numbers = this->Method == Exact
    ? n * (NumbersPerThread * vtkSMPTools::GetEstimatedNumberOfThreads() + points)
    : count * (FunctionsPerEigenvalue * n + points);
  return numbers * sizeof(double);
}

//------------------------------------------------------------------------------
dgg::Status vtkBiharmonicDistance::ComputeValues(vtkDGGSpectralTask& task)
{
  const dgg::SpectralKind kinds[] = { dgg::SpectralKind::Biharmonic, dgg::SpectralKind::CommuteTime,
    dgg::SpectralKind::Diffusion };
  dgg::SpectralOptions options;
  options.Kind = kinds[this->Kind];
  options.Method =
    this->Method == Exact ? dgg::SpectralMethod::Exact : dgg::SpectralMethod::Spectrum;
  options.NumberOfEigenvalues = this->NumberOfEigenvalues;
  options.Time = this->DiffusionTime;
  const double unreached = this->UnreachedValue;

  if (!this->Prepared || this->Prepared->MeshTime != task.MeshTime ||
    this->Prepared->Revision != task.Solver.GetRevision())
  {
    this->Prepared.reset(); // before there are two
    this->Prepared.reset(new Preparation(task));
  }
  Preparation& prepared = *this->Prepared;
  dgg::Status status =
    CheckAll(prepared.Distance, &dgg::SpectralDistance::CheckSource, task.Sources, "source ");
  status = status.IsOk() ? CheckAll(prepared.Distance, &dgg::SpectralDistance::CheckPlace,
                             task.Targets, "evaluation point ")
                         : status;
  if (!status.IsOk())
  {
    return status;
  }
  if (!prepared.IsReady || !IsSame(prepared.Options, options))
  {
    const bool hasSpectrum = prepared.IsReady && HasSameSpectrum(prepared.Options, options);
    dgg::Eigenpairs pairs = hasSpectrum ? prepared.Distance.GetEigenpairs() : dgg::Eigenpairs();
    prepared.IsReady = false;
    status = hasSpectrum
      ? prepared.Distance.Prepare(options, std::move(pairs))
      : prepared.Distance.Prepare(options, dgg::ProgressPart(task.Progress, 0.0, SpectrumDone));
    this->NumberOfSpectra +=
      status.IsOk() && !hasSpectrum && options.Method == dgg::SpectralMethod::Spectrum ? 1 : 0;
    prepared.IsReady = status.IsOk();
    prepared.Options = options;
  }
  const dgg::ParallelFor parallel = vtkDGGMakeParallelFor(task.Progress);
  if (status.IsOk() && prepared.Distance.NeedsDiagonal())
  {
    std::vector<double> diagonal;
    status = prepared.Distance.FindDiagonal(
      parallel, dgg::ProgressPart(task.Progress, 0.0, SpectrumDone), diagonal);
    prepared.Distance.KeepDiagonal(std::move(diagonal));
  }
  // Between sources and evaluation points, row by row.
  std::vector<double> matrix;
  if (status.IsOk() && !task.Targets.empty())
  {
    status = prepared.Distance.Between(task.Sources, task.Targets, parallel,
      dgg::ProgressPart(task.Progress, SpectrumDone, TargetsDone), matrix);
  }
  const auto count = static_cast<double>(task.Sources.size());
  for (std::size_t k = 0; k < task.Sources.size() && status.IsOk(); ++k)
  {
    const double begin = TargetsDone + (1.0 - TargetsDone) * static_cast<double>(k) / count;
    const double end = begin + (1.0 - TargetsDone) / count;
    const dgg::ProgressCallback progress = dgg::ProgressPart(task.Progress, begin, end);
    std::vector<double> values;
    status = prepared.Distance.FromPoint(task.Sources[k], parallel, progress, values);
    if (status.IsOk() && !progress(1.0))
    {
      status = dgg::Status::Abort();
    }
    if (status.IsOk())
    {
      const auto row = matrix.begin() + static_cast<std::ptrdiff_t>(k * task.Targets.size());
      std::vector<double> targetValues;
      if (!task.Targets.empty())
      {
        targetValues.assign(row, row + static_cast<std::ptrdiff_t>(task.Targets.size()));
      }
      std::replace(values.begin(), values.end(), dgg::Infinity, unreached);
      std::replace(targetValues.begin(), targetValues.end(), dgg::Infinity, unreached);
      task.Outputs.Set(k, values, targetValues);
    }
  }
  return status.IsOk() && !task.Progress(1.0) ? dgg::Status::Abort() : status;
}
