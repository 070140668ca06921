// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpectralAlgorithm.h"

#include "DGGContext.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGSpectralInternals.h"

#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace
{
/// Progress after factorization, or after finding a kept factorization.
constexpr double FactorizedAt = 0.4;
constexpr double FoundAt = 0.01;
/// Progress weight of selecting sources within the rest.
constexpr double ChoosingPart = 0.1;

/// Returns the factorization that a filter keeps.
const DGGPoissonCache& GetCache(const DGGFilterInternals& internals)
{
  return static_cast<const DGGSpectralInternals&>(internals).Cache;
}

/// Adds the results to the points of a port as active scalars; without results, the last of the
/// further arrays becomes active.
void AddResult(vtkPolyData* output, vtkPolyData* points, vtkDoubleArray* array,
  const std::vector<vtkSmartPointer<vtkDataArray>>& further)
{
  output->ShallowCopy(points);
  for (vtkDataArray* other : further)
  {
    output->GetPointData()->AddArray(other);
  }
  vtkDataArray* shown = further.empty() ? nullptr : further.back();
  if (array)
  {
    output->GetPointData()->AddArray(array);
    shown = array;
  }
  if (shown)
  {
    output->GetPointData()->SetActiveScalars(shown->GetName());
  }
}
}

//------------------------------------------------------------------------------
vtkSpectralAlgorithm::vtkSpectralAlgorithm(const std::string& resultArrayName)
  : ProjectionTolerance(0.01)
  , Boundary(Neumann)
  , IntrinsicDelaunay(false)
  , ResultArrayName(resultArrayName)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSpectralAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  DGGPrintIds(os, indent, "SourceIds", this->SourceIds);
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "Boundary: " << this->GetBoundaryAsString() << "\n";
  os << indent << "IntrinsicDelaunay: " << (this->IntrinsicDelaunay ? "On" : "Off") << "\n";
  os << indent << "ResultArrayName: " << this->ResultArrayName << "\n";
  os << indent << "NumberOfFactorizations: " << this->GetNumberOfFactorizations() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
}

//------------------------------------------------------------------------------
void vtkSpectralAlgorithm::RemoveAllSources()
{
  this->RemoveAllSourceIds();
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
vtkDGGDefineInputMacro(vtkSpectralAlgorithm, Source, 1);
vtkDGGDefineInputMacro(vtkSpectralAlgorithm, Evaluation, 2);

//------------------------------------------------------------------------------
vtkPolyData* vtkSpectralAlgorithm::GetEvaluation()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
const char* vtkSpectralAlgorithm::GetBoundaryAsString() const
{
  return this->Boundary == vtkSpectralAlgorithm::Dirichlet ? "Dirichlet" : "Neumann";
}

//------------------------------------------------------------------------------
int vtkSpectralAlgorithm::GetNumberOfFactorizations() const
{
  return GetCache(*this->Internals).GetNumberOfFactorizations();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkSpectralAlgorithm::GetMemorySize() const
{
  return GetCache(*this->Internals).GetMemorySize();
}

//------------------------------------------------------------------------------
DGGSpectralInternals::DGGSpectralInternals(vtkSpectralAlgorithm* filter)
  : DGGFilterInternals(filter)
  , Filter(filter)
{
}

//------------------------------------------------------------------------------
dgg::Status DGGSpectralInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(DGGCheckNames({ { "ResultArrayName", this->Filter->ResultArrayName } }));
  return DGGCheckLengths({ { "ProjectionTolerance", this->Filter->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
dgg::PoissonOptions DGGSpectralInternals::GetPoissonOptions() const
{
  dgg::PoissonOptions options;
  options.Boundary = this->Filter->Boundary == vtkSpectralAlgorithm::Dirichlet
    ? dgg::PoissonBoundary::Dirichlet
    : dgg::PoissonBoundary::Neumann;
  options.IntrinsicDelaunay = this->Filter->IntrinsicDelaunay;
  return options;
}

//------------------------------------------------------------------------------
DGGSourceSet DGGSpectralInternals::GetSources(vtkInformationVector** inputVector) const
{
  return { this->Filter->SourceIds, vtkPolyData::GetData(inputVector[1]), 1, "source", "SourceIds",
    "" };
}

//------------------------------------------------------------------------------
DGGSourceSet DGGSpectralInternals::GetTargets(vtkInformationVector** inputVector)
{
  static const std::vector<vtkIdType> none;
  return { none, vtkPolyData::GetData(inputVector[2]), 2, "evaluation point", "", "" };
}

//------------------------------------------------------------------------------
dgg::Status DGGSpectralInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  const DGGSourceSet targetSet = GetTargets(inputVector);
  const DGGSourceSet sourceSet = this->GetSources(inputVector);
  std::vector<dgg::SurfacePoint> sources;
  std::vector<dgg::SurfacePoint> targets;
  if (!this->CanChooseSources() || !sourceSet.IsEmpty())
  {
    DGG_RETURN_IF_ERROR(DGGLocate(context, sourceSet, this->Filter->ProjectionTolerance, sources));
  }
  if (!targetSet.IsEmpty())
  {
    DGG_RETURN_IF_ERROR(DGGLocate(context, targetSet, this->Filter->ProjectionTolerance, targets));
  }
  DGG_RETURN_IF_ERROR(this->ReadInputs(context.Input, sourceSet));

  const auto numberOfPoints = static_cast<std::size_t>(context.Input->GetNumberOfPoints());
  const dgg::PoissonOptions options = this->GetPoissonOptions();
  double needed = 0.0;
  const auto others = [&](const dgg::PoissonSolver& solver) {
    const std::size_t count = this->CountSources(solver, sources.size());
    needed = DGGSpectralOutputs::EstimateMemory(
               numberOfPoints, targets.size(), this->CountResults(count)) +
      this->EstimateWorkingMemory(context, solver, count, targets.size());
    return needed;
  };
  const double prepared = this->Cache.IsPrepared(mesh, options) ? FoundAt : FactorizedAt;
  const double chosen =
    prepared + (this->CanChooseSources() ? ChoosingPart * (1.0 - prepared) : 0.0);
  DGG_RETURN_IF_ERROR(this->Cache.Prepare(context, options, others, this->GetMemoryRemedy(),
    dgg::ProgressPart(context.Progress, 0.0, prepared)));
  DGG_RETURN_IF_ERROR(this->ChooseSources(
    this->Cache.GetSolver(), dgg::ProgressPart(context.Progress, prepared, chosen), sources));
  const double held =
    !context.Memory.IsExplicit() ? 0.0 : this->Cache.GetSolver().GetEstimatedMemory();
  const double left = context.Memory.GetBytes() - held - needed;
  DGGSpectralOutputs outputs(mesh, numberOfPoints, targets.size(),
    this->CountResults(sources.size()), this->Filter->ResultArrayName);
  DGGSpectralTask task{ context, this->Cache.GetSolver(), this->Cache.GetSolverTime(), sources,
    targets, sourceSet, std::max(0.0, left), dgg::ProgressPart(context.Progress, chosen, 1.0),
    outputs };
  DGG_RETURN_IF_ERROR(this->ComputeValues(task));
  AddResult(vtkPolyData::GetData(outputVector, 0), context.Input, outputs.GetPointArray(),
    outputs.GetFurtherArrays(0));
  vtkNew<vtkPolyData> none;
  AddResult(vtkPolyData::GetData(outputVector, 1), targetSet.Points ? targetSet.Points : none,
    outputs.GetTargetArray(), outputs.GetFurtherArrays(1));
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGSpectralInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  const DGGSpectralOutputs outputs(
    context.Surface, 0, 0, this->CountResults(1), this->Filter->ResultArrayName);
  AddResult(vtkPolyData::GetData(outputVector, 0), context.Input, outputs.GetPointArray(),
    outputs.GetFurtherArrays(0));
  vtkNew<vtkPolyData> none;
  AddResult(vtkPolyData::GetData(outputVector, 1), none, outputs.GetTargetArray(),
    outputs.GetFurtherArrays(1));
}
