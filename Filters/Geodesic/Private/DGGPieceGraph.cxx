// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPieceGraph.h"

#include "DGGContext.h"

#include "dggGraphBuildTask.h"
#include "dggPieceGraph.h"
#include "dggProcessGroup.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <vector>

//------------------------------------------------------------------------------
dgg::Status DGGPieceGraph::Update(const DGGContext& context, dgg::ProcessGroup& group,
  const dgg::SurfacePiece& piece, dgg::GraphOptions options, bool acceptsAny, bool& isDone,
  std::vector<std::string>& warnings)
{
  vtkFieldData* data = context.Input->GetFieldData();
  const dgg::Signature ofPiece = dgg::ComputeSignature(piece);
  std::vector<dgg::Signature> signatures;
  DGG_RETURN_IF_ERROR(group.Share(ofPiece, signatures));
  const dgg::Signature signature = dgg::SumSignatures(signatures);
  this->Pieces = signature;
  // The graph of an entire surface is on the first process.
  isDone = this->Refused != signature && !DGGGraphArrays::AreOfEntireSurface(data);
  DGG_RETURN_IF_ERROR(group.Require(isDone));
  if (!isDone)
  {
    this->Built.Clear();
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(dgg::ShareOptions(group, options));
  std::string complaint;
  bool isFound = this->OnInput.FindPiece(data, piece.NumberOfPoints, context.Parallel, complaint);
  if (isFound &&
    (this->OnInput.GetView().Info.Surface != signature || !this->OnInput.GetGraph().IsOf(ofPiece)))
  {
    isFound = false;
    if (this->WarnedTime != this->OnInput.GetTime())
    {
      this->WarnedTime = this->OnInput.GetTime();
      complaint = "The graph {InArrays} is out of date: points or cells have changed since it was "
                  "built";
    }
  }
  if (!complaint.empty())
  {
    warnings.push_back(dgg::DescribeReplacement(complaint, options));
  }
  dgg::GraphOptions wanted = options;
  if (acceptsAny)
  {
    wanted = dgg::MakeOptions(this->OnInput.GetView().Info);
    DGG_RETURN_IF_ERROR(dgg::ShareOptions(group, wanted));
  }
  this->IsFound = isFound && dgg::IsBuiltWith(this->OnInput.GetView().Info, wanted);
  DGG_RETURN_IF_ERROR(group.Require(this->IsFound));
  if (this->IsFound)
  {
    this->Built.Clear();
  }
  const dgg::GraphInfo& built = this->Built.GetView().Info;
  bool isKept = this->Built.IsValid() && this->BuiltPiece == ofPiece &&
    built.Surface == signature && dgg::IsBuiltWith(built, options);
  DGG_RETURN_IF_ERROR(group.Require(isKept));
  if (!this->IsFound && !isKept)
  {
    this->Built.Clear();
    dgg::PieceGraph graph;
    std::vector<std::string> defects;
    DGG_RETURN_IF_ERROR(
      dgg::BuildPieceGraph(context, group, piece, options, graph, this->Estimate, defects, isDone));
    if (!isDone)
    {
      this->Refuse();
      return dgg::Status::Success();
    }
    this->Built.Adopt(graph, context);
    this->BuiltPiece = ofPiece;
    this->BuildTime.Modified();
    if (group.Here == 0)
    {
      warnings.insert(warnings.end(), defects.begin(), defects.end());
    }
  }
  this->Summarize(piece);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGPieceGraph::Refuse()
{
  this->Refused = this->Pieces;
  this->Built.Clear();
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
