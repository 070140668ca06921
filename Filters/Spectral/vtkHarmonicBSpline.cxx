// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHarmonicBSpline.h"

#include "DGGContext.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGSpectralInternals.h"
#include "DGGSplineRun.h"

#include "dggStatus.h"
#include "dggProgressPart.h"
#include "dggSplineSites.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkHarmonicBSpline);

namespace
{
/// Progress after the preparation, the basis functions and the solution.
constexpr double PreparationDone = 0.4;
constexpr double BasisDone = 0.8;
constexpr double SolutionDone = 0.85;
/// Largest sum of sources without a warning, relative to the sum of their absolute values. The
/// integral of a density depends on the mesh.
constexpr double DensityTolerance = 1e-2;
constexpr double IntegralTolerance = 1e-6;
/// Bytes per point and thread, without smooth evaluation, and numbers per point that are kept:
/// cells, sources, solutions.
constexpr double SplineBytesPerVertex = 450.0;
constexpr double HeldNumbers = 7.0;
/// Numbers per point and component of an interpolation: functions, and their array.
constexpr double InterpolationNumbers = 2.0;
/// Number of simultaneous matrices of pairs of sites: functions at sites and factors.
constexpr double SiteMatrices = 4.0;
}

//------------------------------------------------------------------------------
class vtkHarmonicBSpline::vtkInternals
  : public DGGInternalsOf<vtkHarmonicBSpline, DGGSpectralInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  dgg::Status ReadInputs(vtkPolyData* surface, const DGGSourceSet& sources) override;
  bool CanChooseSources() const override { return true; }
  std::size_t CountResults(std::size_t numberOfSources) const override;
  std::size_t CountSources(const dgg::PoissonSolver& solver, std::size_t given) const override;
  dgg::Status ChooseSources(const dgg::PoissonSolver& solver, const dgg::ProgressCallback& progress,
    std::vector<dgg::SurfacePoint>& sources) const override;
  double EstimateWorkingMemory(const DGGContext& context, const dgg::PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const override;
  void ForgetResults() override;
  dgg::Status ComputeValues(DGGSpectralTask& task) override;

  std::vector<vtkIdType> UsedSites; // by the last update

private:
  // Inputs of this update, from ReadInputs() to ComputeValues().
  std::vector<std::vector<double>> SiteValues; // per component; empty without an interpolation
  std::vector<double> RightHandSide;           // empty without a solution
};

vtkDGGInternalsMacro(vtkHarmonicBSpline);

//------------------------------------------------------------------------------
vtkHarmonicBSpline::vtkHarmonicBSpline()
  : vtkSpectralAlgorithm("HarmonicBSpline")
  , Order(Harmonic)
  , NumberOfSites(20)
  , RightHandSideMeaning(Density)
  , CellArrayName("Cell")
  , SolutionArrayName("PoissonSolution")
  , InterpolationArrayName("Interpolation")
  , GenerateBasis(true)
  , SmoothEvaluation(false)
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkHarmonicBSpline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->GetOrderAsString() << "\n";
  os << indent << "NumberOfSites: " << this->NumberOfSites << "\n";
  os << indent << "RightHandSideArrayName: " << this->RightHandSideArrayName << "\n";
  os << indent << "RightHandSideMeaning: " << this->GetRightHandSideMeaningAsString() << "\n";
  os << indent << "CellArrayName: " << this->CellArrayName << "\n";
  os << indent << "SolutionArrayName: " << this->SolutionArrayName << "\n";
  os << indent << "SiteValuesArrayName: " << this->SiteValuesArrayName << "\n";
  os << indent << "InterpolationArrayName: " << this->InterpolationArrayName << "\n";
  os << indent << "GenerateBasis: " << (this->GenerateBasis ? "On" : "Off") << "\n";
  os << indent << "SmoothEvaluation: " << (this->SmoothEvaluation ? "On" : "Off") << "\n";
  os << indent << "NumberOfUsedSites: " << this->GetNumberOfUsedSites() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHarmonicBSpline::GetOrderAsString() const
{
  return this->Order == Biharmonic ? "Biharmonic" : "Harmonic";
}

//------------------------------------------------------------------------------
const char* vtkHarmonicBSpline::GetRightHandSideMeaningAsString() const
{
  return this->RightHandSideMeaning == Integrated ? "Integrated" : "Density";
}

//------------------------------------------------------------------------------
vtkIdType vtkHarmonicBSpline::GetNumberOfUsedSites() const
{
  return static_cast<vtkIdType>(this->GetInternals().UsedSites.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkHarmonicBSpline::GetUsedSite(vtkIdType site) const
{
  return DGGGetId(this->GetInternals().UsedSites, site);
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(DGGSpectralInternals::CheckProperties());
  return DGGCheckNames({ { "ResultArrayName", this->Self->GetResultArrayName() },
    { "CellArrayName", this->Self->CellArrayName },
    { "SolutionArrayName", this->Self->SolutionArrayName },
    { "InterpolationArrayName", this->Self->InterpolationArrayName } });
}

//------------------------------------------------------------------------------
void vtkHarmonicBSpline::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  DGGSpectralInternals::MakeEmptyOutput(context, outputVector);
  for (int port = 0; port < 2; ++port)
  {
    vtkPointData* data = vtkPolyData::GetData(outputVector, port)->GetPointData();
    const auto add = [&](vtkDataArray* array, const std::string& name, bool isThere) {
      array->SetName(name.c_str());
      if (isThere)
      {
        data->AddArray(array);
      }
    };
    add(vtkNew<vtkIdTypeArray>(), this->Self->CellArrayName, this->Self->Order == Harmonic);
    add(vtkNew<vtkDoubleArray>(), this->Self->InterpolationArrayName,
      !this->Self->SiteValuesArrayName.empty());
    add(vtkNew<vtkDoubleArray>(), this->Self->SolutionArrayName,
      !this->Self->RightHandSideArrayName.empty());
  }
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::vtkInternals::ReadInputs(
  vtkPolyData* surface, const DGGSourceSet& sources)
{
  if (!this->Self->SiteValuesArrayName.empty())
  {
    // Selected sites are not known yet; the array is checked nevertheless.
    DGG_RETURN_IF_ERROR(DGGReadSiteValues(
      this->Self->SiteValuesArrayName, surface, sources.Ids, sources.Points, this->SiteValues));
  }
  return this->Self->RightHandSideArrayName.empty()
    ? dgg::Status::Success()
    : DGGReadRightHandSide(surface, this->Self->RightHandSideArrayName, this->RightHandSide);
}

//------------------------------------------------------------------------------
std::size_t vtkHarmonicBSpline::vtkInternals::CountResults(std::size_t numberOfSources) const
{
  return this->Self->GenerateBasis ? numberOfSources : 0;
}

//------------------------------------------------------------------------------
std::size_t vtkHarmonicBSpline::vtkInternals::CountSources(
  const dgg::PoissonSolver& solver, std::size_t given) const
{
  const auto wanted =
    std::max<std::size_t>(this->Self->NumberOfSites, dgg::CountSplineComponents(solver));
  return given > 0 ? given : std::min(wanted, solver.GetAreas().size());
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::vtkInternals::ChooseSources(const dgg::PoissonSolver& solver,
  const dgg::ProgressCallback& progress, std::vector<dgg::SurfacePoint>& sources) const
{
  if (!sources.empty())
  {
    for (dgg::SurfacePoint& source : sources)
    {
      source = this->Self->Order == Harmonic
        ? dgg::SurfacePoint::AtVertex(DGGFindNearestCorner(solver, source))
        : source;
    }
    return dgg::Status::Success();
  }
  std::vector<dgg::Id> sites;
  const dgg::Status status =
    dgg::ChooseSplineSites(solver, this->Self->NumberOfSites, progress, sites);
  for (const dgg::Id site : sites)
  {
    sources.push_back(dgg::SurfacePoint::AtVertex(site));
  }
  return status;
}

//------------------------------------------------------------------------------
double vtkHarmonicBSpline::vtkInternals::EstimateWorkingMemory(const DGGContext& context,
  const dgg::PoissonSolver& solver, std::size_t numberOfSources, std::size_t numberOfTargets) const
{
  const auto n = static_cast<double>(solver.GetAreas().size());
  const auto sites = static_cast<double>(numberOfSources);
  const auto targets = static_cast<double>(numberOfTargets);
  const bool isHarmonic = this->Self->Order == Harmonic;
  const bool isSmooth = this->Self->SmoothEvaluation && isHarmonic && numberOfTargets > 0;
  const bool hasMatrices =
    !this->Self->SiteValuesArrayName.empty() || (!isHarmonic && this->Self->GenerateBasis);
  const double bytes = isSmooth ? dgg::GreensFunction::BytesPerVertex : SplineBytesPerVertex;
  const double held =
    HeldNumbers + InterpolationNumbers * static_cast<double>(this->SiteValues.size());
  // Threads; equations of sites, like those of vertices; cells, solutions, interpolations.
  return bytes * n * context.NumberOfThreads +
    (isHarmonic ? std::min(1.0, sites / n) * solver.GetEstimatedMemory() : 0.0) +
    (held * (n + targets) + (isSmooth ? sites * targets : 0.0) +
      (hasMatrices ? SiteMatrices * sites * sites : 0.0)) *
    sizeof(double);
}

//------------------------------------------------------------------------------
void vtkHarmonicBSpline::vtkInternals::ForgetResults()
{
  this->UsedSites.clear();
  this->SiteValues = {};
  this->RightHandSide = {};
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::vtkInternals::ComputeValues(DGGSpectralTask& task)
{
  if (task.Sources.empty())
  {
    return dgg::InvalidInput("Values are prescribed at all points, so no point can be a site")
      .At("Boundary")
      .Fix("Set {Boundary} to Neumann");
  }
  std::vector<vtkIdType> sites;
  for (const dgg::SurfacePoint& source : task.Sources)
  {
    sites.push_back(dgg::IsVertex(source) ? source.Vertex : -1);
  }
  const bool hasValues = !this->SiteValues.empty();
  if (hasValues && task.SourceSet.IsEmpty())
  {
    DGG_RETURN_IF_ERROR(DGGReadSiteValues(
      this->Self->SiteValuesArrayName, task.Context.Input, sites, nullptr, this->SiteValues));
  }
  const bool isHarmonic = this->Self->Order == Harmonic;
  const auto part = [&](double begin, double end) {
    return dgg::ProgressPart(task.Progress, begin, end);
  };
  DGGSplineRun run(task, !isHarmonic, this->Self->SmoothEvaluation);
  DGG_RETURN_IF_ERROR(
    run.Prepare(this->Self->GenerateBasis || hasValues, part(0.0, PreparationDone)));
  if (this->Self->GenerateBasis || (isHarmonic && hasValues))
  {
    DGG_RETURN_IF_ERROR(
      run.FindBasis(this->Self->GenerateBasis, hasValues, part(PreparationDone, BasisDone)));
  }
  if (isHarmonic)
  {
    run.AddCells(this->Self->CellArrayName);
  }
  const bool isDensity = this->Self->RightHandSideMeaning == Density;
  double imbalance = 0.0;
  if (!this->RightHandSide.empty())
  {
    DGG_RETURN_IF_ERROR(dgg::ReportTo(task.Progress, BasisDone));
    DGG_RETURN_IF_ERROR(
      run.AddSolution(this->RightHandSide, isDensity, this->Self->SolutionArrayName, imbalance));
  }
  if (hasValues)
  {
    DGG_RETURN_IF_ERROR(run.AddInterpolation(
      this->SiteValues, this->Self->InterpolationArrayName, part(SolutionDone, 1.0)));
  }
  if (imbalance > (isDensity ? DensityTolerance : IntegralTolerance))
  {
    this->Warn(
      dgg::JoinText("The sources in a component of the surface sum to a fraction of ", imbalance,
        " of their absolute values, and no boundary absorbs the sum, so they were balanced in "
        "proportion to area. Make their sum 0"));
  }
  const auto components = static_cast<std::size_t>(dgg::CountSplineComponents(task.Solver));
  if (components > 1 && sites.size() == components &&
    task.Solver.GetOptions().Boundary == dgg::PoissonBoundary::Neumann)
  {
    this->Warn(dgg::JoinText("The surface has ", components,
      " components, each with a single site, whose function is 1 everywhere. Use more sites, or a "
      "single component"));
  }
  DGG_RETURN_IF_ERROR(dgg::ReportTo(task.Progress, 1.0));
  this->UsedSites.swap(sites);
  this->SiteValues = {};
  this->RightHandSide = {};
  return dgg::Status::Success();
}
