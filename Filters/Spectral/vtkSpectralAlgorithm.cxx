// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSpectralAlgorithm.h"

#include "DGGContext.h"
#include "DGGOutput.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGSpectralInternals.h"

#include "dggPropertyChecks.h"
#include "dggSpectralTask.h"

#include "vtkPolyData.h"

#include <vector>

namespace
{
/// Returns the factorization that a filter keeps.
const dgg::PoissonSession& GetSession(const DGGFilterInternals& internals)
{
  return static_cast<const DGGSpectralInternals&>(internals).Session;
}

const std::vector<vtkIdType> NoIds;

/// Fills both ports: the surface and the evaluation points, which may be null, with results.
void FillOutputs(dgg::Output* outputs, vtkPolyData* surface, vtkPolyData* places,
  vtkInformationVector* outputVector)
{
  vtkPolyData* const inputs[] = { surface, places };
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* data = vtkPolyData::GetData(outputVector, port);
    if (inputs[port])
    {
      data->ShallowCopy(inputs[port]);
    }
    DGGAddArrays(outputs[port], data);
  }
}
}

//------------------------------------------------------------------------------
vtkSpectralAlgorithm::vtkSpectralAlgorithm(const std::string& resultArrayName)
  : ResultArrayName(resultArrayName)
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
vtkDGGAsStringMacro(vtkSpectralAlgorithm, Boundary, "Neumann", "Dirichlet");

//------------------------------------------------------------------------------
int vtkSpectralAlgorithm::GetNumberOfFactorizations() const
{
  return GetSession(*this->Internals).GetNumberOfFactorizations();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkSpectralAlgorithm::GetMemorySize() const
{
  return GetSession(*this->Internals).GetMemorySize();
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
  DGG_RETURN_IF_ERROR(dgg::CheckNames({ { "ResultArrayName", this->Filter->ResultArrayName } }));
  return dgg::CheckLengths({ { "ProjectionTolerance", this->Filter->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
/// Returns the task with the properties of all spectral filters, too.
dgg::SpectralTask& DGGSpectralInternals::PrepareTaskWithOptions(
  vtkPolyData* surface, const DGGSourceSet& sources)
{
  dgg::SpectralTask& task = this->PrepareTask(surface, sources);
  task.Poisson.Boundary = this->Filter->Boundary == vtkSpectralAlgorithm::Dirichlet
    ? dgg::PoissonBoundary::Dirichlet
    : dgg::PoissonBoundary::Neumann;
  task.Poisson.IntrinsicDelaunay = this->Filter->IntrinsicDelaunay;
  task.ResultName = this->Filter->ResultArrayName;
  return task;
}

//------------------------------------------------------------------------------
DGGSourceSet DGGSpectralInternals::GetSources(vtkPolyData* points) const
{
  return { this->Filter->SourceIds, points, 1, "source", "SourceIds", "" };
}

//------------------------------------------------------------------------------
dgg::Status DGGSpectralInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* places = vtkPolyData::GetData(inputVector[2]);
  const DGGSourceSet sourceSet = this->GetSources(vtkPolyData::GetData(inputVector[1]));
  const DGGSourceSet targetSet{ NoIds, places, 2, "evaluation point", "", "" };
  dgg::SpectralTask& task = this->PrepareTaskWithOptions(context.Input, sourceSet);
  std::vector<dgg::SurfacePoint> sources;
  std::vector<dgg::SurfacePoint> targets;
  if (!task.CanChooseSources() || !sourceSet.IsEmpty())
  {
    DGG_RETURN_IF_ERROR(DGGLocate(context, sourceSet, this->Filter->ProjectionTolerance, sources));
  }
  if (!targetSet.IsEmpty())
  {
    DGG_RETURN_IF_ERROR(DGGLocate(context, targetSet, this->Filter->ProjectionTolerance, targets));
  }
  dgg::Output outputs[2];
  DGG_RETURN_IF_ERROR(
    task.Run(context, this->Session, sources, targets, this->GetMemoryRemedy(), outputs));
  this->WarnAtEnd(outputs[0]);
  FillOutputs(outputs, context.Input, places, outputVector);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGSpectralInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  dgg::Output outputs[2];
  this->PrepareTaskWithOptions(context.Input, this->GetSources(nullptr))
    .WriteEmpty(context.Surface, outputs);
  FillOutputs(outputs, context.Input, nullptr, outputVector);
}
