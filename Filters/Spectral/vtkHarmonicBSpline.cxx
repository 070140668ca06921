// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHarmonicBSpline.h"

#include "DGGContext.h"
#include "DGGDistribution.h"
#include "DGGPreparedMesh.h"
#include "DGGProperties.h"
#include "DGGSpectralOutputs.h"

#include "dggGeodesicSource.h"
#include "dggHarmonicSplines.h"
#include "dggProgressPart.h"
#include "dggSplineSites.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkHarmonicBSpline);

namespace
{
/// Parts of the progress: cells, functions at evaluation points, functions at points.
constexpr double CellsDone = 0.3;
constexpr double EvaluationDone = 0.5;
constexpr double BasisDone = 0.95;
/// What sources may sum to without a warning, relative to the sum of their sizes. Densities are
/// only integrated up to the mesh.
constexpr double DensityTolerance = 1e-2;
constexpr double IntegralTolerance = 1e-6;
/// Memory of one thread for each point, without smooth evaluation, and numbers that are held for
/// each: cells, sources, solutions.
constexpr double SplineBytesPerVertex = 450.0;
constexpr double HeldNumbers = 7.0;

/// The corner that a point is nearest to, a free one if there is one.
dgg::Id FindNearestCorner(const dgg::PoissonSolver& solver, const dgg::SurfacePoint& point)
{
  dgg::Id nearest = dgg::NoId;
  double least = 0.0;
  bool isFree = false;
  dgg::ForEachCornerAround(solver.GetMesh(), point, [&](dgg::Id v, double, double distance) {
    const bool isBetter = !solver.IsFixed(v) && !isFree;
    const bool isWorse = solver.IsFixed(v) && isFree;
    if (nearest == dgg::NoId || isBetter || (!isWorse && distance < least))
    {
      nearest = v;
      least = distance;
      isFree = !solver.IsFixed(v);
    }
  });
  return nearest;
}

/// Piecewise linear functions at points.
std::vector<double> Interpolate(const dgg::SurfaceMesh& mesh,
  const std::vector<dgg::SurfacePoint>& points, const std::vector<double>& values)
{
  std::vector<double> found(points.size(), 0.0);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    dgg::ForEachCornerAround(
      mesh, points[k], [&](dgg::Id v, double weight, double) { found[k] += weight * values[v]; });
  }
  return found;
}

/// The numbers of a point array of the surface.
dgg::Status ReadSources(vtkPolyData* surface, const std::string& name, std::vector<double>& values)
{
  return DGGReadNumbers(surface, name, "the surface", "SetRightHandSideArrayName()", false, values);
}

/// Sources per vertex from numbers per point; none where values are given. `imbalance` is the
/// largest sum that has to be balanced in a component, relative to the sum of sizes.
std::vector<double> Integrate(const DGGPreparedMesh& prepared, const dgg::PoissonSolver& solver,
  const std::vector<double>& numbers, bool isDensity, double& imbalance)
{
  const std::size_t n = solver.GetAreas().size();
  std::vector<double> sources(n, 0.0);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const dgg::Id v = prepared.GetVertex(static_cast<vtkIdType>(i));
    const bool isFirst = v == static_cast<dgg::Id>(i);
    if (!solver.IsFixed(v) && (isFirst || !isDensity))
    {
      sources[v] += isDensity ? numbers[i] * solver.GetAreas()[v] : numbers[i];
    }
  }
  dgg::Id count = 0;
  const std::vector<dgg::Id> components = solver.GetMesh().ComputeComponents(count);
  std::vector<double> sums(count, 0.0);
  std::vector<double> sizes(count, 0.0);
  std::vector<char> isGiven(count, 0);
  for (std::size_t v = 0; v < n; ++v)
  {
    const bool hasFace = solver.GetAreas()[v] > 0.0;
    sums[components[v]] += hasFace ? sources[v] : 0.0;
    sizes[components[v]] += std::abs(sources[v]);
    isGiven[components[v]] |= solver.IsFixed(static_cast<dgg::Id>(v)) ? 1 : 0;
  }
  imbalance = 0.0;
  for (dgg::Id c = 0; c < count; ++c)
  {
    const bool counts = !isGiven[c] && sizes[c] > 0.0;
    imbalance = counts ? std::max(imbalance, std::abs(sums[c]) / sizes[c]) : imbalance;
  }
  return sources;
}

/// Finds what a task asks for.
class Run
{
public:
  explicit Run(DGGSpectralTask& task)
    : Task(task)
    , Mesh(task.Solver.GetMesh())
    , Splines(task.Solver)
  {
  }

  /// Cells and functions of sites.
  dgg::Status FindBasis(const std::vector<dgg::Id>& sites, bool isSmooth,
    const std::string& cellName, const dgg::ProgressCallback& progress)
  {
    const dgg::ParallelFor& parallel = this->Task.Context.Parallel;
    DGG_RETURN_IF_ERROR(
      this->Splines.Prepare(sites, parallel, dgg::ProgressPart(progress, 0.0, CellsDone)));
    if (isSmooth)
    {
      DGG_RETURN_IF_ERROR(
        this->Splines.Evaluate(this->Task.Targets, dgg::GreensMethod::SingularitySubtraction,
          parallel, dgg::ProgressPart(progress, CellsDone, EvaluationDone), this->Evaluated));
    }
    DGG_RETURN_IF_ERROR(this->Splines.FindBasis(parallel,
      dgg::ProgressPart(progress, isSmooth ? EvaluationDone : CellsDone, BasisDone),
      [this](dgg::Id site, const std::vector<double>& values) {
        this->Task.Outputs.Set(static_cast<std::size_t>(site), values,
          this->Evaluated.empty() ? Interpolate(this->Mesh, this->Task.Targets, values)
                                  : this->EvaluatedOf(static_cast<std::size_t>(site)));
      }));
    const std::vector<dgg::Id>& cells = this->Splines.GetCells();
    std::vector<dgg::Id> targetCells;
    for (const dgg::SurfacePoint& target : this->Task.Targets)
    {
      targetCells.push_back(cells[FindNearestCorner(this->Task.Solver, target)]);
    }
    this->Task.Outputs.Add<vtkIdTypeArray>(cellName, cells, targetCells);
    return dgg::Status::Success();
  }

  /// The solution for the sources of an array.
  dgg::Status FindSolution(const std::string& sourceName, bool isDensity,
    const std::string& solutionName, double& imbalance)
  {
    std::vector<double> numbers;
    std::vector<double> coefficients;
    std::vector<double> solution;
    DGG_RETURN_IF_ERROR(ReadSources(this->Task.Context.Input, sourceName, numbers));
    const std::vector<double> sources =
      Integrate(this->Task.Context.Surface, this->Task.Solver, numbers, isDensity, imbalance);
    DGG_RETURN_IF_ERROR(this->Splines.Solve(sources, {}, coefficients));
    DGG_RETURN_IF_ERROR(this->Splines.Combine(coefficients, {}, solution));
    std::vector<double> atTargets = Interpolate(this->Mesh, this->Task.Targets, solution);
    if (!this->Evaluated.empty())
    {
      std::fill(atTargets.begin(), atTargets.end(), 0.0);
      for (std::size_t site = 0; site < coefficients.size(); ++site)
      {
        const std::vector<double> function = this->EvaluatedOf(site);
        for (std::size_t k = 0; k < function.size(); ++k)
        {
          atTargets[k] += coefficients[site] * function[k];
        }
      }
    }
    this->Task.Outputs.Add<vtkDoubleArray>(solutionName, solution, atTargets);
    return dgg::Status::Success();
  }

private:
  /// The function of a site at the targets.
  std::vector<double> EvaluatedOf(std::size_t site) const
  {
    std::vector<double> values;
    for (std::size_t k = site; k < this->Evaluated.size(); k += this->Task.Sources.size())
    {
      values.push_back(this->Evaluated[k]);
    }
    return values;
  }

  DGGSpectralTask& Task;
  const dgg::SurfaceMesh& Mesh;
  dgg::HarmonicSplines Splines;
  std::vector<double> Evaluated; // per target and site, if they are to be smooth
};
}

//------------------------------------------------------------------------------
vtkHarmonicBSpline::vtkHarmonicBSpline()
  : vtkSpectralAlgorithm("HarmonicBSpline")
  , NumberOfSites(20)
  , RightHandSideMeaning(Density)
  , CellArrayName("Cell")
  , SolutionArrayName("PoissonSolution")
  , SmoothEvaluation(false)
{
}

//------------------------------------------------------------------------------
vtkHarmonicBSpline::~vtkHarmonicBSpline() = default;

//------------------------------------------------------------------------------
void vtkHarmonicBSpline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSites: " << this->NumberOfSites << "\n";
  os << indent << "RightHandSideArrayName: " << this->RightHandSideArrayName << "\n";
  os << indent << "RightHandSideMeaning: " << this->GetRightHandSideMeaningAsString() << "\n";
  os << indent << "CellArrayName: " << this->CellArrayName << "\n";
  os << indent << "SolutionArrayName: " << this->SolutionArrayName << "\n";
  os << indent << "SmoothEvaluation: " << (this->SmoothEvaluation ? "On" : "Off") << "\n";
  os << indent << "NumberOfUsedSites: " << this->GetNumberOfUsedSites() << "\n";
}

//------------------------------------------------------------------------------

//------------------------------------------------------------------------------
const char* vtkHarmonicBSpline::GetRightHandSideMeaningAsString() const
{
  return this->RightHandSideMeaning == Integrated ? "Integrated" : "Density";
}

//------------------------------------------------------------------------------
vtkIdType vtkHarmonicBSpline::GetNumberOfUsedSites() const
{
  return static_cast<vtkIdType>(this->UsedSites.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkHarmonicBSpline::GetUsedSite(vtkIdType site) const
{
  return DGGGetId(this->UsedSites, site);
}

//------------------------------------------------------------------------------
int vtkHarmonicBSpline::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->UsedSites.clear(); // whatever goes wrong
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(this->Superclass::CheckProperties());
  const std::string result = this->GetResultArrayName();
  const std::string& cell = this->CellArrayName;
  const std::string& solution = this->SolutionArrayName;
  if (cell.empty() || solution.empty())
  {
    return dgg::Status::Invalid(
      "CellArrayName or SolutionArrayName is empty: call SetCellArrayName() and "
      "SetSolutionArrayName() with a name");
  }
  if (result == cell || result == solution || cell == solution)
  {
    return dgg::Status::Invalid("ResultArrayName '" + result + "', CellArrayName '" + cell +
      "' and SolutionArrayName '" + solution + "' must be different: change one of them");
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkHarmonicBSpline::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  this->Superclass::MakeEmptyOutput(context, outputVector);
  for (int port = 0; port < 2; ++port)
  {
    vtkPointData* data = vtkPolyData::GetData(outputVector, port)->GetPointData();
    vtkNew<vtkIdTypeArray> cells;
    cells->SetName(this->CellArrayName.c_str());
    data->AddArray(cells);
    if (!this->RightHandSideArrayName.empty())
    {
      vtkNew<vtkDoubleArray> solution;
      solution->SetName(this->SolutionArrayName.c_str());
      data->AddArray(solution);
    }
  }
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::CheckInputs(
  vtkPolyData* surface, vtkInformationVector** inputVector) const
{
  DGG_RETURN_IF_ERROR(this->Superclass::CheckInputs(surface, inputVector));
  std::vector<double> values;
  return this->RightHandSideArrayName.empty()
    ? dgg::Status::Success()
    : ReadSources(surface, this->RightHandSideArrayName, values);
}

//------------------------------------------------------------------------------
std::size_t vtkHarmonicBSpline::CountSources(
  const dgg::PoissonSolver& solver, std::size_t given) const
{
  const auto wanted =
    std::max<std::size_t>(this->NumberOfSites, dgg::CountSplineComponents(solver));
  return given > 0 ? given : std::min(wanted, solver.GetAreas().size());
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::ChooseSources(const dgg::PoissonSolver& solver,
  const std::function<bool(double)>& progress, std::vector<dgg::SurfacePoint>& sources) const
{
  if (!sources.empty())
  {
    for (dgg::SurfacePoint& source : sources)
    {
      source = dgg::SurfacePoint::AtVertex(FindNearestCorner(solver, source));
    }
    return dgg::Status::Success();
  }
  std::vector<dgg::Id> sites;
  const dgg::Status status = dgg::ChooseSplineSites(solver, this->NumberOfSites, progress, sites);
  for (const dgg::Id site : sites)
  {
    sources.push_back(dgg::SurfacePoint::AtVertex(site));
  }
  return status;
}

//------------------------------------------------------------------------------
double vtkHarmonicBSpline::EstimateWorkingMemory(
  const dgg::PoissonSolver& solver, std::size_t numberOfSources, std::size_t numberOfTargets) const
{
  const auto n = static_cast<double>(solver.GetAreas().size());
  const auto sites = static_cast<double>(numberOfSources);
  const auto targets = static_cast<double>(numberOfTargets);
  const bool isSmooth = this->SmoothEvaluation && numberOfTargets > 0;
  const double bytes = isSmooth ? dgg::GreensFunction::BytesPerVertex : SplineBytesPerVertex;
  // Of threads; the equations of sites, as those of vertices; cells and solutions.
  return bytes * n * vtkSMPTools::GetEstimatedNumberOfThreads() +
    std::min(1.0, sites / n) * solver.GetEstimatedMemory() +
    (HeldNumbers * (n + targets) + (isSmooth ? sites * targets : 0.0)) * sizeof(double);
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::ComputeValues(DGGSpectralTask& task)
{
  const bool isDensity = this->RightHandSideMeaning == Density;
  const bool isSmooth = this->SmoothEvaluation && !task.Targets.empty();
  std::vector<dgg::Id> sites;
  for (const dgg::SurfacePoint& source : task.Sources)
  {
    sites.push_back(source.Vertex);
  }
  if (sites.empty())
  {
    return dgg::Status::Invalid(
      "values are given at all points: there is no place for a site, use Neumann conditions");
  }
  Run run(task);
  DGG_RETURN_IF_ERROR(run.FindBasis(sites, isSmooth, this->CellArrayName, task.Progress));
  double imbalance = 0.0;
  if (!this->RightHandSideArrayName.empty())
  {
    DGG_RETURN_IF_ERROR(run.FindSolution(
      this->RightHandSideArrayName, isDensity, this->SolutionArrayName, imbalance));
  }
  if (imbalance > (isDensity ? DensityTolerance : IntegralTolerance))
  {
    vtkWarningMacro(<< "the sources in a part of the surface sum to a fraction of " << imbalance
                    << " of their sizes, with nothing given that this could flow to: they were "
                       "balanced in proportion to area. Make their sum 0.");
  }
  const auto components = static_cast<std::size_t>(dgg::CountSplineComponents(task.Solver));
  if (components > 1 && sites.size() == components &&
    task.Solver.GetOptions().Boundary == dgg::PoissonBoundary::Neumann)
  {
    vtkWarningMacro(
      << "the surface has " << components
      << " components, each with a single site, whose function is 1 all over it: use "
         "more sites (SetNumberOfSites()), or one component (vtkConnectivityFilter).");
  }
  DGG_RETURN_IF_ERROR(dgg::ReportTo(task.Progress, 1.0));
  this->UsedSites.assign(sites.begin(), sites.end());
  return dgg::Status::Success();
}
