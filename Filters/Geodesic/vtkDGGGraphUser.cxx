// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGGraphUser.h"

#include "vtkPolyData.h"

namespace
{
template <typename ValueType>
bool Change(ValueType& property, ValueType value)
{
  const bool changes = property != value;
  property = value;
  return changes;
}
}

//------------------------------------------------------------------------------
bool vtkDGGGraphUser::SetAccuracy(double accuracy)
{
  const bool becomesExplicit = Change(this->IsAccuracyExplicit, true);
  return Change(this->Accuracy, accuracy) || becomesExplicit;
}

//------------------------------------------------------------------------------
bool vtkDGGGraphUser::SetMemoryLimit(vtkTypeUInt64 limit)
{
  return Change(this->MemoryLimit, limit);
}

//------------------------------------------------------------------------------
bool vtkDGGGraphUser::SetAcceptCoarserGraph(bool accept)
{
  return Change(this->AcceptCoarserGraph, accept);
}

//------------------------------------------------------------------------------
void vtkDGGGraphUser::PrintSelf(std::ostream& os, vtkIndent indent) const
{
  const vtkDGGGraphProvider& graph = this->Provider;
  const vtkDGGGraphSummary& summary = graph.GetSummary();
  const bool isGuaranteed = graph.HasGraph() && summary.Info.IsGuaranteed();
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "Accuracy has been set: " << (this->IsAccuracyExplicit ? "yes" : "no") << "\n";
  os << indent << "AcceptCoarserGraph: " << (this->AcceptCoarserGraph ? "On" : "Off") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "UsedInputGraph: " << (graph.IsFromInput() ? "yes" : "no") << "\n";
  os << indent << "GraphAccuracy: " << summary.Info.Accuracy << "\n";
  os << indent << "GraphIsGuaranteed: " << (isGuaranteed ? "yes" : "no") << "\n";
  os << indent << "NumberOfGraphEdges: " << summary.NumberOfEdges << "\n";
  os << indent << "MemorySize: " << graph.GetMemorySize() << "\n";
  os << indent << "GraphBuildTime: " << graph.GetBuildTime() << "\n";
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphUser::Check() const
{
  dgg::GraphOptions options;
  options.Accuracy = this->Accuracy;
  return dgg::GraphBuilder::Check(options);
}

//------------------------------------------------------------------------------
bool vtkDGGGraphUser::IsCloud(vtkPolyData* input)
{
  return vtkDGGGraphArrays::AreOfCloud(input->GetFieldData());
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphUser::Update(vtkPolyData* input, const vtkDGGPreparedMesh& mesh,
  const dgg::ProgressCallback& progress, vtkObject* filter)
{
  const bool warn = this->IsAccuracyExplicit && !this->AcceptCoarserGraph;
  return this->Provider.Update(
    { input, mesh, this->Accuracy, warn, this->MemoryLimit, progress, filter });
}
