// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDiscreteGreensFunction.h"

#include "DGGContext.h"
#include "DGGSpectralInternals.h"

#include "dggBlockLoop.h"
#include "dggGreensFunction.h"
#include "dggGreensInterpolation.h"
#include "dggStatus.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDiscreteGreensFunction);

namespace
{
constexpr std::size_t BlockSize = dgg::GreensFunction::PolesInBlock;

struct NamedRemark
{
  dgg::GreensRemark Remark;
  const char* Text;
};

/// Reasons why another method than the requested one was used.
const NamedRemark Remarks[] = { { dgg::GreensRemark::TooCoarse,
                                  "the mesh is too coarse around them for the method, so "
                                  "Interpolated was used. Refine the mesh there, or set {Radius}" },
  { dgg::GreensRemark::NoTriangle,
    "they were not found on the flipped mesh, so Interpolated was used. Turn off "
    "{IntrinsicDelaunay}" },
  { dgg::GreensRemark::NotLocalized,
    "the boundary or long triangles are too close to them for the method, so Interpolated was "
    "used" } };

/// Method that was used for a source.
struct UsedMethod
{
  dgg::GreensMethod Method = dgg::GreensMethod::Vertex;
  dgg::GreensRemark Remark = dgg::GreensRemark::None;
  double Radius = 0.0;
};

/// Solvers that are kept for a mesh.
struct Functions
{
  Functions(const dgg::PoissonSolver& solver, vtkMTimeType solverTime)
    : SolverTime(solverTime)
    , Function(solver)
    , Interpolation(solver)
  {
  }

  vtkMTimeType SolverTime;
  dgg::GreensFunction Function;
  dgg::GreensInterpolation Interpolation;
};

/// Finds the functions of the sources of a task.
class Run
{
public:
  Run(DGGSpectralTask& task, const dgg::GreensQuery& query, std::vector<UsedMethod>& used)
    : Task(task)
    , Query(query)
    , Used(used)
  {
    used.assign(task.Sources.size(), UsedMethod());
  }

  dgg::Status Check() const
  {
    for (std::size_t k = 0; k < this->Task.Sources.size(); ++k)
    {
      DGG_RETURN_IF_ERROR(
        this->Task.Solver.CheckPole(this->Task.Sources[k]).Of(dgg::JoinText("Source ", k)));
    }
    return dgg::Status::Success();
  }

  /// Runs blocks of sources, several of them simultaneously.
  dgg::Status InBlocks(const dgg::GreensFunction& function)
  {
    const std::vector<dgg::SurfacePoint>& sources = this->Task.Sources;
    return dgg::ForEach((sources.size() + BlockSize - 1) / BlockSize, 1,
      this->Task.Context.Parallel, this->Task.Progress,
      [&](std::size_t block, const dgg::ProgressCallback& progress) {
        const std::size_t first = block * BlockSize;
        const std::size_t end = std::min(sources.size(), first + BlockSize);
        dgg::GreensQuery query = this->Query;
        query.Progress = progress;
        std::vector<dgg::GreensResult> results;
        const dgg::Status status =
          function.Run({ sources.begin() + first, sources.begin() + end }, query, results);
        for (std::size_t k = 0; k < results.size(); ++k)
        {
          this->Store(first + k, results[k]);
        }
        return status;
      });
  }

  /// Runs sources in succession, since each reuses columns of earlier sources.
  dgg::Status OneByOne(dgg::GreensInterpolation& interpolation)
  {
    const auto count = static_cast<double>(this->Task.Sources.size());
    for (std::size_t k = 0; k < this->Task.Sources.size(); ++k)
    {
      const auto done = static_cast<double>(k);
      dgg::GreensQuery query = this->Query;
      query.Progress = dgg::ProgressPart(this->Task.Progress, done / count, (done + 1.0) / count);
      dgg::GreensResult result;
      DGG_RETURN_IF_ERROR(interpolation.Run(this->Task.Sources[k], query, result));
      this->Store(k, result);
    }
    return dgg::ReportTo(this->Task.Progress, 1.0);
  }

private:
  void Store(std::size_t source, const dgg::GreensResult& result)
  {
    this->Task.Outputs.Set(source, result.Values, result.TargetValues);
    this->Used[source] = { result.Method, result.Remark, result.Radius };
  }

  DGGSpectralTask& Task;
  const dgg::GreensQuery& Query;
  std::vector<UsedMethod>& Used;
};
}

//------------------------------------------------------------------------------
class vtkDiscreteGreensFunction::vtkInternals
  : public DGGInternalsOf<vtkDiscreteGreensFunction, DGGSpectralInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::PoissonOptions GetPoissonOptions() const override;
  double EstimateWorkingMemory(const DGGContext& context, const dgg::PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const override;
  void ForgetResults() override { this->Used.clear(); }
  dgg::Status ComputeValues(DGGSpectralTask& task) override;

  std::unique_ptr<Functions> Kept;
  std::vector<UsedMethod> Used; // per source

private:
  void WarnAboutRemarks() const;
};

vtkDGGInternalsMacro(vtkDiscreteGreensFunction);

//------------------------------------------------------------------------------
vtkDiscreteGreensFunction::vtkDiscreteGreensFunction()
  : vtkSpectralAlgorithm("GreensFunction")
  , Order(Laplace)
  , Method(SingularitySubtraction)
  , SignConvention(PositiveAtSource)
  , PoleValue(CellAverage)
  , Weighting(Area)
  , Radius(0.0)
  , InterpolateRegularPart(false)
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkDiscreteGreensFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->GetOrderAsString() << "\n";
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "SignConvention: " << this->GetSignConventionAsString() << "\n";
  os << indent << "PoleValue: " << this->GetPoleValueAsString() << "\n";
  os << indent << "Weighting: " << this->GetWeightingAsString() << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "InterpolateRegularPart: " << (this->InterpolateRegularPart ? "On" : "Off")
     << "\n";
  os << indent << "NumberOfColumns: " << this->GetNumberOfColumns() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkDiscreteGreensFunction::GetOrderAsString() const
{
  return this->Order == BiLaplace ? "BiLaplace" : "Laplace";
}

//------------------------------------------------------------------------------
const char* vtkDiscreteGreensFunction::GetMethodAsString() const
{
  static const char* const names[] = { "SingularitySubtraction", "Localized", "Interpolated",
    "Vertex" };
  return names[this->Method];
}

//------------------------------------------------------------------------------
const char* vtkDiscreteGreensFunction::GetSignConventionAsString() const
{
  return this->SignConvention == NegativeAtSource ? "NegativeAtSource" : "PositiveAtSource";
}

//------------------------------------------------------------------------------
const char* vtkDiscreteGreensFunction::GetPoleValueAsString() const
{
  return this->PoleValue == InfiniteValue ? "Infinite" : "CellAverage";
}

//------------------------------------------------------------------------------
const char* vtkDiscreteGreensFunction::GetWeightingAsString() const
{
  return this->Weighting == Uniform ? "Uniform" : "Area";
}

//------------------------------------------------------------------------------
int vtkDiscreteGreensFunction::GetUsedMethod(vtkIdType source) const
{
  const std::vector<UsedMethod>& used = this->GetInternals().Used;
  return source >= 0 && source < static_cast<vtkIdType>(used.size())
    ? static_cast<int>(used[source].Method)
    : -1;
}

//------------------------------------------------------------------------------
double vtkDiscreteGreensFunction::GetUsedRadius(vtkIdType source) const
{
  const std::vector<UsedMethod>& used = this->GetInternals().Used;
  return source >= 0 && source < static_cast<vtkIdType>(used.size()) ? used[source].Radius : 0.0;
}

//------------------------------------------------------------------------------
bool vtkDiscreteGreensFunction::IsNearRidge(vtkIdType source) const
{
  const std::vector<UsedMethod>& used = this->GetInternals().Used;
  return source >= 0 && source < static_cast<vtkIdType>(used.size()) &&
    used[source].Remark == dgg::GreensRemark::NearRidge;
}

//------------------------------------------------------------------------------
vtkIdType vtkDiscreteGreensFunction::GetNumberOfColumns() const
{
  return this->GetInternals().Kept ? this->GetInternals().Kept->Interpolation.GetNumberOfColumns()
                                   : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDiscreteGreensFunction::GetMemorySize() const
{
  return this->Superclass::GetMemorySize() +
    (this->GetInternals().Kept ? this->GetInternals().Kept->Interpolation.GetMemorySize() : 0);
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGreensFunction::vtkInternals::CheckProperties() const
{
  if (!(this->Self->Radius >= 0.0) || !std::isfinite(this->Self->Radius))
  {
    return dgg::InvalidValue("Radius", this->Self->Radius)
      .Fix("Use a positive number, or 0 for the default");
  }
  return DGGSpectralInternals::CheckProperties();
}

//------------------------------------------------------------------------------
dgg::PoissonOptions vtkDiscreteGreensFunction::vtkInternals::GetPoissonOptions() const
{
  dgg::PoissonOptions options = DGGSpectralInternals::GetPoissonOptions();
  options.Weights =
    this->Self->Weighting == Uniform ? dgg::PoissonWeights::Uniform : dgg::PoissonWeights::Area;
  return options;
}

//------------------------------------------------------------------------------
double vtkDiscreteGreensFunction::vtkInternals::EstimateWorkingMemory(const DGGContext& context,
  const dgg::PoissonSolver& solver, std::size_t numberOfSources, std::size_t numberOfTargets) const
{
  const std::size_t blocks = (numberOfSources + BlockSize - 1) / BlockSize;
  const auto threads = static_cast<std::size_t>(context.NumberOfThreads);
  return static_cast<double>(std::min(threads, blocks)) *
    (dgg::GreensFunction::BytesPerVertex * static_cast<double>(solver.GetAreas().size()) +
      dgg::GreensFunction::BytesPerTarget * static_cast<double>(numberOfTargets));
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGreensFunction::vtkInternals::ComputeValues(DGGSpectralTask& task)
{
  const dgg::GreensMethod methods[] = { dgg::GreensMethod::SingularitySubtraction,
    dgg::GreensMethod::Localized, dgg::GreensMethod::Interpolated, dgg::GreensMethod::Vertex };
  dgg::GreensQuery query;
  query.Method = methods[this->Self->Method];
  query.Order =
    this->Self->Order == BiLaplace ? dgg::GreensOrder::BiLaplace : dgg::GreensOrder::Laplace;
  query.Sign = this->Self->SignConvention == NegativeAtSource ? dgg::GreensSign::Negative
                                                              : dgg::GreensSign::Positive;
  query.Pole = this->Self->PoleValue == InfiniteValue ? dgg::GreensPole::Infinite
                                                      : dgg::GreensPole::CellAverage;
  query.Radius = this->Self->Radius;
  query.Targets = task.Targets;
  const bool isInterpolated =
    this->Self->InterpolateRegularPart && this->Self->Method == SingularitySubtraction;

  if (!this->Kept || this->Kept->SolverTime != task.SolverTime)
  {
    this->Kept.reset(); // release before the next is allocated
    this->Kept = std::make_unique<Functions>(task.Solver, task.SolverTime);
  }
  std::vector<UsedMethod> used;
  Run run(task, query, used);
  DGG_RETURN_IF_ERROR(run.Check());
  if (isInterpolated)
  {
    const double most = 0.5 * static_cast<double>(std::numeric_limits<std::size_t>::max());
    this->Kept->Interpolation.SetMemoryLimit(
      static_cast<std::size_t>(std::min(most, task.FreeMemory)));
    DGG_RETURN_IF_ERROR(run.OneByOne(this->Kept->Interpolation));
  }
  else
  {
    DGG_RETURN_IF_ERROR(run.InBlocks(this->Kept->Function));
  }
  this->Used.swap(used);
  this->WarnAboutRemarks();
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkDiscreteGreensFunction::vtkInternals::WarnAboutRemarks() const
{
  const std::vector<UsedMethod>& used = this->Used;
  for (const NamedRemark& remark : Remarks)
  {
    const auto has = [&](const UsedMethod& of) { return of.Remark == remark.Remark; };
    const auto count = std::count_if(used.begin(), used.end(), has);
    if (count > 0)
    {
      const auto first = std::find_if(used.begin(), used.end(), has) - used.begin();
      this->Warn(dgg::JoinText(
        count, " of the ", used.size(), " sources, the first of them ", first, ": ", remark.Text));
    }
  }
}
