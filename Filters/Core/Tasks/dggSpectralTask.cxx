// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSpectralTask.h"

#include "dggPoissonSession.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggTaskContext.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Progress weight of selecting sources, within the progress after the factorization.
constexpr double ChoosingPart = 0.1;
}

//------------------------------------------------------------------------------
SpectralOutputs::SpectralOutputs(
  const PreparedSurface& surface, std::size_t numberOfTargets, Output* outputs)
  : Surface(surface)
  , NumberOfPoints(static_cast<std::size_t>(surface.GetMeshWithoutAngles().GetNumberOfVertices()))
  , NumberOfTargets(numberOfTargets)
  , Outputs(outputs)
{
}

//------------------------------------------------------------------------------
template <typename ValueType>
SpectralOutputs::Values<ValueType> SpectralOutputs::Add(
  const std::string& name, std::size_t components)
{
  const auto add = [&](Output& output, std::size_t tuples) {
    ValueType* const values =
      output.PointData.Add<ValueType>(name, tuples, static_cast<int>(components));
    std::fill_n(values, tuples * components, ValueType(0));
    return values;
  };
  if (components == 0)
  {
    return {};
  }
  return { components, add(this->Outputs[0], this->NumberOfPoints),
    add(this->Outputs[1], this->NumberOfTargets) };
}

//------------------------------------------------------------------------------
template <typename ValueType, typename Number>
void SpectralOutputs::Set(const Values<ValueType>& array, std::size_t component,
  const std::vector<Number>& values, const std::vector<Number>& targetValues) const
{
  for (std::size_t i = 0; i < this->NumberOfPoints; ++i)
  {
    array.AtPoints[i * array.Components + component] =
      values[this->Surface.GetVertex(static_cast<Offset>(i))];
  }
  for (std::size_t i = 0; i < targetValues.size(); ++i)
  {
    array.AtTargets[i * array.Components + component] = targetValues[i];
  }
}

template SpectralOutputs::Values<double> SpectralOutputs::Add(const std::string&, std::size_t);
template SpectralOutputs::Values<Offset> SpectralOutputs::Add(const std::string&, std::size_t);
template void SpectralOutputs::Set(
  const Values<double>&, std::size_t, const std::vector<double>&, const std::vector<double>&) const;
template void SpectralOutputs::Set(
  const Values<Offset>&, std::size_t, const std::vector<Id>&, const std::vector<Id>&) const;

//------------------------------------------------------------------------------
Status SpectralTask::Run(const TaskContext& context, PoissonSession& session,
  std::vector<SurfacePoint> sources, const std::vector<SurfacePoint>& targets,
  const std::string& remedy, Output* outputs)
{
  DGG_RETURN_IF_ERROR(this->CheckInput(context));
  double needed = 0.0;
  const auto others = [&](const PoissonSolver& solver) {
    const std::size_t count = this->CountSources(solver, sources.size());
    needed = static_cast<double>(solver.GetAreas().size() + targets.size()) *
        static_cast<double>(this->WantResult ? count : 0) * sizeof(double) +
      this->EstimateMemory(context, solver, count, targets.size());
    return needed;
  };
  double prepared = 0.0;
  DGG_RETURN_IF_ERROR(session.Prepare(context, this->Poisson, others, remedy, prepared));
  const PoissonSolver& solver = session.GetSolver();
  const double chosen =
    prepared + (this->CanChooseSources() ? ChoosingPart * (1.0 - prepared) : 0.0);
  DGG_RETURN_IF_ERROR(
    this->ChooseSources(solver, ProgressPart(context.Progress, prepared, chosen), sources));
  const double held = !context.Memory.IsExplicit() ? 0.0 : solver.GetEstimatedMemory();
  const double left = context.Memory.GetBytes() - held - needed;

  SpectralOutputs writer(context.Surface, targets.size(), outputs);
  DGG_RETURN_IF_ERROR(this->Compute({ context, solver, session.GetSolverNumber(), sources, targets,
    std::max(0.0, left), ProgressPart(context.Progress, chosen, 1.0),
    writer.Add<double>(this->ResultName, this->WantResult ? sources.size() : 0), writer,
    outputs[0].Warnings }));
  for (Output* output : { outputs, outputs + 1 })
  {
    OutputArrays& arrays = output->PointData;
    if (this->WantResult)
    {
      std::rotate(arrays.begin(), arrays.begin() + 1, arrays.end());
    }
    output->PointScalars = arrays.empty() ? std::string() : arrays.back().Name;
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
void SpectralTask::WriteEmpty(const PreparedSurface& surface, Output* outputs) const
{
  SpectralOutputs writer(surface, 0, outputs);
  writer.Add<double>(this->ResultName, this->WantResult ? 1 : 0);
  for (Output* output : { outputs, outputs + 1 })
  {
    output->PointScalars = output->PointData.empty() ? std::string() : this->ResultName;
  }
  this->AddEmptyArrays(writer);
}
}
