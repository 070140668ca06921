// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPieceGraph.h"

#include "DGGContext.h"

#include "dggGraphBuildTask.h"
#include "dggPieceGraph.h"
#include "dggProcessGroup.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

//------------------------------------------------------------------------------
dgg::Status DGGPieceGraph::Update(const DGGContext& context, const dgg::ProcessGroup& group,
  const dgg::SurfacePiece& piece, const dgg::GraphOptions& options, bool acceptsAny, bool& isDone,
  std::string& warning)
{
  vtkFieldData* data = context.Input->GetFieldData();
  // The graph of the entire surface is on the first process.
  isDone = group.Holds(!DGGGraphArrays::AreOfWhole(data));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  const dgg::Signature ofPiece = dgg::ComputeSignature(piece);
  isDone = !group.Holds(this->Refused == ofPiece);
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  const dgg::Signature signature = dgg::SumSignatures(group.Share(ofPiece));
  std::string complaint;
  bool isFound = this->OnInput.FindPiece(data, piece.NumberOfPoints, context.Parallel, complaint);
  if (isFound && this->OnInput.GetView().Info.Surface != signature)
  {
    isFound = false;
    complaint = "The graph {InArrays} is out of date: points or cells have changed since it was "
                "built";
  }
  warning = complaint.empty() ? "" : dgg::DescribeReplacement(complaint, options);
  const auto isUsable = [&](const DGGGraphArrays& graph, const dgg::GraphOptions& wanted) {
    return dgg::IsBuiltWith(graph.GetView().Info, wanted);
  };
  this->IsFound = group.Holds(isFound);
  if (this->IsFound)
  {
    const dgg::GraphOptions first = acceptsAny
      ? dgg::ShareOptions(group, dgg::MakeOptions(this->OnInput.GetView().Info))
      : options;
    this->IsFound = group.Holds(isUsable(this->OnInput, first));
  }
  const bool isKept = group.Holds(this->Built.IsValid() && this->BuiltPiece == ofPiece &&
    this->Built.GetView().Info.Surface == signature && isUsable(this->Built, options));
  if (!this->IsFound && !isKept)
  {
    this->Built.Clear();
    dgg::PieceGraph graph;
    DGG_RETURN_IF_ERROR(
      dgg::BuildPieceGraph(context, group, piece, options, graph, this->Estimate, isDone));
    if (!isDone)
    {
      this->Refused = ofPiece;
      return dgg::Status::Success();
    }
    this->Built.Adopt(graph, context);
    this->BuiltPiece = ofPiece;
    this->BuildTime.Modified();
  }
  this->Summarize(piece);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGPieceGraph::Summarize(const dgg::SurfacePiece& piece)
{
  const dgg::GraphView& rows = this->Get().GetView();
  const dgg::Id* owners = this->Get().GetGraph().GetGhosts().Owners;
  this->Summary = dgg::GraphSummary(rows);
  this->Summary.NumberOfVertices = static_cast<dgg::Id>(piece.NumberOfPoints);
  this->Summary.NumberOfEdges = 0;
  for (dgg::Id v = 0; v < rows.NumberOfVertices; ++v)
  {
    this->Summary.NumberOfEdges +=
      owners[v] == dgg::GhostVertices::Here ? rows.Offsets[v + 1] - rows.Offsets[v] : 0;
  }
}
