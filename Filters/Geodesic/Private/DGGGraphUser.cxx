// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGGraphUser.h"
#include "DGGProperties.h"

#include "dggGraphBuildTask.h"
#include "dggProcessGroup.h"
#include "dggStatus.h"

#include "vtkObject.h"

#include <memory>
#include <string>
#include <vector>

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
bool DGGGraphUser::SetAccuracy(double accuracy)
{
  const bool becomesExplicit = Change(this->IsAccuracyExplicit, true);
  return Change(this->Accuracy, accuracy) || becomesExplicit;
}

//------------------------------------------------------------------------------
bool DGGGraphUser::SetAcceptCoarserGraph(bool accept)
{
  return Change(this->AcceptCoarserGraph, accept);
}

//------------------------------------------------------------------------------
void DGGGraphUser::PrintSelf(std::ostream& os, vtkIndent indent) const
{
  const dgg::GraphSummary& summary = this->GetSummary();
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "Accuracy has been set: " << (this->IsAccuracyExplicit ? "yes" : "no") << "\n";
  os << indent << "AcceptCoarserGraph: " << (this->AcceptCoarserGraph ? "On" : "Off") << "\n";
  os << indent << "UsedInputGraph: " << (this->IsFromInput() ? "yes" : "no") << "\n";
  os << indent << "GraphAccuracy: " << summary.Info.Accuracy << "\n";
  os << indent << "GraphIsGuaranteed: " << (this->IsGuaranteed() ? "yes" : "no") << "\n";
  os << indent << "NumberOfGraphEdges: " << summary.NumberOfEdges << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "GraphBuildTime: " << this->GetBuildTime() << "\n";
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::Check() const
{
  dgg::GraphOptions options;
  options.Accuracy = this->Accuracy;
  return dgg::GraphBuilder::Check(options);
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::Update(const DGGContext& context, vtkObject* filter)
{
  dgg::GraphOptions options;
  options.Accuracy = this->Accuracy;
  DGG_RETURN_IF_ERROR(this->Check());
  this->SetLinkAccuracy(this->Accuracy);
  vtkFieldData* data = context.Input->GetFieldData();
  if (this->IsFromInput() && !this->InputGraph.IsSame(data, context.Surface))
  {
    this->ForgetGraph();
  }
  this->Start(context.Surface);
  if (!this->HasGraph())
  {
    this->ForgetGraph();
  }
  const bool isCloud = context.Surface.IsCloud();
  if (isCloud && !this->InputGraph.IsValid())
  {
    this->InputGraph.Clear(); // so that its defect is reported again
  }
  std::string complaint;
  const bool found = this->InputGraph.Find(data, context, complaint);
  if (!complaint.empty() && !isCloud)
  {
    vtkWarningWithObjectMacro(
      filter, << DGGRender(dgg::DescribeReplacement(complaint, options)) << ".");
  }
  dgg::Status status;
  if (found)
  {
    this->UseInput(context, filter);
  }
  else if (isCloud)
  {
    status = dgg::RequireCloudGraph(complaint);
  }
  else
  {
    status = this->UseOwn(context, options);
  }
  if (!status.IsOk())
  {
    this->ForgetGraph();
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::UpdatePiece(const DGGContext& context, dgg::ProcessGroup& group,
  const dgg::SurfacePiece& piece, vtkObject* filter, bool& isDone)
{
  dgg::GraphOptions options;
  options.Accuracy = this->Accuracy;
  this->IsOnFirst = group.Here == 0;
  std::vector<std::string> warnings;
  DGG_RETURN_IF_ERROR(this->Piece.Update(context, group, piece, options, true, isDone, warnings));
  for (const std::string& warning : warnings)
  {
    vtkWarningWithObjectMacro(filter, << DGGRender(warning) << ".");
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGGraphUser::UsePiece(vtkObject* filter)
{
  this->ForgetGraph();
  this->UsesPiece = true;
  const vtkMTimeType found = this->Piece.IsOnInput() ? this->Piece.Get().GetTime() : 0;
  if (found != this->PieceTime)
  {
    this->PieceTime = found;
    this->WarnedAccuracy = 0.0;
  }
  if (found != 0 && this->IsOnFirst)
  {
    this->WarnAboutAccuracy(filter);
  }
}

//------------------------------------------------------------------------------
void DGGGraphUser::ForgetGraph()
{
  this->Release();
  this->OwnAccuracy = 0.0;
  this->UsedInput = 0;
}

//------------------------------------------------------------------------------
void DGGGraphUser::SearchIn(const DGGGraphArrays& arrays, const dgg::PreparedSurface& surface)
{
  this->Use(dgg::PreparedGraph::Make(
    arrays.GetGraph(), arrays.GetKey(), std::make_shared<DGGGraphArrays>(arrays), surface));
}

//------------------------------------------------------------------------------
void DGGGraphUser::UseInput(const DGGContext& context, vtkObject* filter)
{
  if (this->UsedInput != this->InputGraph.GetTime())
  {
    this->ForgetGraph();
    this->SearchIn(this->InputGraph, context.Surface);
    this->UsedInput = this->InputGraph.GetTime();
    this->WarnedAccuracy = 0.0;
  }
  if (!context.Surface.IsCloud()) // a cloud's graph cannot be rebuilt here and has no guarantee
  {
    this->WarnAboutAccuracy(filter);
  }
}

//------------------------------------------------------------------------------
void DGGGraphUser::WarnAboutAccuracy(vtkObject* filter)
{
  const std::string complaint =
    dgg::DescribeAccuracy(this->GetSummary().Info, this->Accuracy, true);
  const bool isWanted = this->IsAccuracyExplicit && !this->AcceptCoarserGraph;
  if (!isWanted || complaint.empty() || this->WarnedAccuracy == this->Accuracy)
  {
    return;
  }
  this->WarnedAccuracy = this->Accuracy;
  vtkWarningWithObjectMacro(filter, << DGGRender(complaint) << ".");
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::UseOwn(const DGGContext& context, dgg::GraphOptions options)
{
  if (this->OwnAccuracy == this->Accuracy)
  {
    return dgg::Status::Success();
  }
  this->ForgetGraph();
  dgg::GeodesicGraph graph;
  DGG_RETURN_IF_ERROR(this->Build(context, options, graph));
  DGGGraphArrays arrays;
  arrays.Adopt(graph, context);
  this->SearchIn(arrays, context.Surface);
  this->OwnAccuracy = this->Accuracy;
  this->BuildTime.Modified();
  return dgg::Status::Success();
}
