// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpectralAlgorithm.h"

#include "vtkDGGMemory.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGPoissonKeeper.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSourceCollector.h"
#include "vtkDGGSpectralOutputs.h"

#include "dggProgressPart.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace
{
/// Part of the progress when the system is ready: if it has to be factorized, or only looked at.
constexpr double FactorizedAt = 0.4;
constexpr double FoundAt = 0.01;
/// Part of what is left then, in which sources are chosen.
constexpr double ChoosingPart = 0.1;

bool IsEmpty(const vtkDGGSourceSet& set)
{
  return set.Ids.empty() && (!set.Points || set.Points->GetNumberOfPoints() == 0);
}

/// The points of a port with the results as active scalars.
void AddResult(vtkPolyData* output, vtkPolyData* points, vtkDoubleArray* array,
  const std::vector<vtkSmartPointer<vtkDataArray>>& further)
{
  output->ShallowCopy(points);
  for (vtkDataArray* other : further)
  {
    output->GetPointData()->AddArray(other);
  }
  output->GetPointData()->AddArray(array);
  output->GetPointData()->SetActiveScalars(array->GetName());
}
}

//------------------------------------------------------------------------------
struct vtkSpectralAlgorithm::vtkInternals
{
  vtkDGGSourceCollector Collector;
  vtkDGGPoissonKeeper Keeper;
};

//------------------------------------------------------------------------------
vtkSpectralAlgorithm::vtkSpectralAlgorithm(const std::string& resultArrayName)
  : ProjectionTolerance(0.01)
  , Boundary(Neumann)
  , IntrinsicDelaunay(false)
  , MemoryLimit(0)
  , ResultArrayName(resultArrayName)
  , Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkSpectralAlgorithm::~vtkSpectralAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkSpectralAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  vtkDGGPrintIds(os, indent, "SourceIds", this->SourceIds);
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "Boundary: " << this->GetBoundaryAsString() << "\n";
  os << indent << "IntrinsicDelaunay: " << (this->IntrinsicDelaunay ? "On" : "Off") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
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
  return this->Boundary == Dirichlet ? "Dirichlet" : "Neumann";
}

//------------------------------------------------------------------------------
vtkDGGDefineNameMacro(vtkSpectralAlgorithm, ResultArrayName, ResultArrayName);

//------------------------------------------------------------------------------
int vtkSpectralAlgorithm::GetNumberOfFactorizations() const
{
  return this->Internals->Keeper.GetNumberOfFactorizations();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkSpectralAlgorithm::GetMemorySize() const
{
  return this->Internals->Keeper.GetMemorySize();
}

//------------------------------------------------------------------------------
int vtkSpectralAlgorithm::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
dgg::Status vtkSpectralAlgorithm::CheckProperties() const
{
  if (this->ResultArrayName.empty())
  {
    return dgg::Status::Invalid("ResultArrayName is empty: call SetResultArrayName() with a name");
  }
  return vtkDGGCheckLength("ProjectionTolerance", this->ProjectionTolerance);
}

//------------------------------------------------------------------------------
dgg::Status vtkSpectralAlgorithm::CheckInputs(
  vtkPolyData* surface, vtkInformationVector** inputVector) const
{
  const vtkIdType n = surface->GetNumberOfPoints();
  const vtkDGGSourceSet sources = this->GetSources(inputVector);
  const dgg::Status status = this->CanChooseSources() && IsEmpty(sources)
    ? dgg::Status::Success()
    : vtkDGGSourceCollector::Check(sources, n);
  const vtkDGGSourceSet targets = GetTargets(inputVector);
  return status.IsOk() && !IsEmpty(targets) ? vtkDGGSourceCollector::Check(targets, n) : status;
}

//------------------------------------------------------------------------------
std::string vtkSpectralAlgorithm::GetMemoryRemedy() const
{
  return "use a smaller mesh or fewer sources at a time";
}

//------------------------------------------------------------------------------
dgg::PoissonOptions vtkSpectralAlgorithm::GetPoissonOptions() const
{
  dgg::PoissonOptions options;
  options.Boundary =
    this->Boundary == Dirichlet ? dgg::PoissonBoundary::Dirichlet : dgg::PoissonBoundary::Neumann;
  options.IntrinsicDelaunay = this->IntrinsicDelaunay;
  return options;
}

//------------------------------------------------------------------------------
std::size_t vtkSpectralAlgorithm::CountSources(
  const dgg::PoissonSolver& vtkNotUsed(solver), std::size_t given) const
{
  return given;
}

//------------------------------------------------------------------------------
dgg::Status vtkSpectralAlgorithm::ChooseSources(const dgg::PoissonSolver& vtkNotUsed(solver),
  const std::function<bool(double)>& vtkNotUsed(progress),
  std::vector<dgg::SurfacePoint>& vtkNotUsed(sources)) const
{
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
vtkDGGSourceSet vtkSpectralAlgorithm::GetSources(vtkInformationVector** inputVector) const
{
  return { this->SourceIds, vtkPolyData::GetData(inputVector[1]), 1, "source",
    "call AddSourceId() or SetSourceIds()", "" };
}

//------------------------------------------------------------------------------
vtkDGGSourceSet vtkSpectralAlgorithm::GetTargets(vtkInformationVector** inputVector)
{
  static const std::vector<vtkIdType> none;
  return { none, vtkPolyData::GetData(inputVector[2]), 2, "evaluation point",
    "call SetEvaluationData()", "" };
}

//------------------------------------------------------------------------------
dgg::Status vtkSpectralAlgorithm::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  vtkDGGPoissonKeeper& keeper = this->Internals->Keeper;
  const vtkDGGSourceSet targetSet = GetTargets(inputVector);
  const vtkDGGSourceSet sourceSet = this->GetSources(inputVector);
  const bool hasTargets = !IsEmpty(targetSet);
  std::vector<dgg::GeodesicSource> found[2];
  dgg::Status status;
  if (!this->CanChooseSources() || !IsEmpty(sourceSet))
  {
    status = this->Internals->Collector.Collect(
      sourceSet, this->ProjectionTolerance, mesh, surface->GetPoints(), found[0]);
  }
  if (status.IsOk() && hasTargets)
  {
    status = this->Internals->Collector.Collect(
      targetSet, this->ProjectionTolerance, mesh, surface->GetPoints(), found[1]);
  }
  if (!status.IsOk())
  {
    return status;
  }
  std::vector<dgg::SurfacePoint> sources = vtkDGGGetPlaces(found[0]);
  const std::vector<dgg::SurfacePoint> targets = vtkDGGGetPlaces(found[1]);

  const auto numberOfPoints = static_cast<std::size_t>(surface->GetNumberOfPoints());
  const dgg::PoissonOptions options = this->GetPoissonOptions();
  double needed = 0.0;
  const auto others = [&](const dgg::PoissonSolver& solver) {
    const std::size_t count = this->CountSources(solver, sources.size());
    needed = vtkDGGSpectralOutputs::EstimateMemory(numberOfPoints, targets.size(), count) +
      this->EstimateWorkingMemory(solver, count, targets.size());
    return needed;
  };
  const dgg::ProgressCallback progress = [this](double done) { return this->Advance(done); };
  const double prepared = keeper.IsPrepared(mesh, options) ? FoundAt : FactorizedAt;
  const double chosen =
    prepared + (this->CanChooseSources() ? ChoosingPart * (1.0 - prepared) : 0.0);
  status = this->Advance(0.0)
    ? keeper.Prepare(mesh, options, others, this->MemoryLimit, this->GetMemoryRemedy(),
        dgg::ProgressPart(progress, 0.0, prepared))
    : dgg::Status::Abort();
  if (status.IsOk())
  {
    status = this->ChooseSources(
      keeper.GetSolver(), dgg::ProgressPart(progress, prepared, chosen), sources);
  }
  if (!status.IsOk())
  {
    return status;
  }
  const double held = this->MemoryLimit == 0 ? 0.0 : keeper.GetSolver().GetEstimatedMemory();
  const double left = static_cast<double>(vtkDGGGetMemoryLimit(this->MemoryLimit)) - held - needed;
  vtkDGGSpectralOutputs outputs(
    mesh, numberOfPoints, targets.size(), sources.size(), this->ResultArrayName);
  vtkDGGSpectralTask task{ keeper.GetSolver(), surface, mesh.GetBuildTime(), sources, targets,
    std::max(0.0, left), dgg::ProgressPart(progress, chosen, 1.0), outputs };
  DGG_RETURN_IF_ERROR(this->ComputeValues(task));
  AddResult(vtkPolyData::GetData(outputVector, 0), surface, outputs.GetPointArray(),
    outputs.GetFurtherArrays(0));
  vtkNew<vtkPolyData> none;
  AddResult(vtkPolyData::GetData(outputVector, 1), targetSet.Points ? targetSet.Points : none,
    outputs.GetTargetArray(), outputs.GetFurtherArrays(1));
  return status;
}

//------------------------------------------------------------------------------
void vtkSpectralAlgorithm::MakeEmptyOutput(vtkPolyData* surface, vtkInformationVector* outputVector)
{
  const vtkDGGSpectralOutputs outputs(this->GetMesh(), 0, 0, 0, this->ResultArrayName);
  AddResult(vtkPolyData::GetData(outputVector, 0), surface, outputs.GetPointArray(),
    outputs.GetFurtherArrays(0));
  vtkNew<vtkPolyData> none;
  AddResult(vtkPolyData::GetData(outputVector, 1), none, outputs.GetTargetArray(),
    outputs.GetFurtherArrays(1));
}
