// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGDistance.h"

#include "DGGDistanceInternals.h"
#include "DGGGraphUser.h"

#include "dggGraphDistances.h"
#include "dggPieceDistances.h"
#include "dggPieceLinks.h"
#include "dggPieceSearch.h"
#include "dggProcessGroup.h"
#include "dggSourceCollection.h"

#include "vtkObjectFactory.h"

#include <memory>

vtkStandardNewMacro(vtkDGGDistance);

//------------------------------------------------------------------------------
class vtkDGGDistance::vtkInternals
  : public DGGGraphInternalsOf<vtkDGGDistance, DGGDistanceInternals>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override;
  dgg::Status ComputePiece(const DGGContext& context, const DGGPieceUpdate& update,
    const dgg::SourceCollection& sources, const dgg::DistanceRequest& request,
    dgg::DistanceOutput& results, bool& isDone) override;
  std::vector<dgg::VertexArray> DeclareArrays() const override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, a larger {Accuracy} or a {MaximumDistance}";
  }

private:
  dgg::Status PreparePiece(
    dgg::ProcessGroup& group, const dgg::SurfacePiece& piece, bool hasPositions, bool& isDone);

  std::unique_ptr<dgg::PieceSearch> PieceSearch; // in the graph with PieceKey
  std::unique_ptr<dgg::PieceLinks> PieceLinks;   // null unless positions were found
  DGGGraphArrays::Key PieceKey;
};

vtkDGGInternalsMacro(vtkDGGDistance);
vtkDGGGraphUserMacro(vtkDGGDistance);

//------------------------------------------------------------------------------
vtkDGGDistance::vtkDGGDistance()
  : Correction(true)
  , Search(Certified)
  , GenerateUpperBound(false)
  , UpperBoundArrayName("GeodesicUpperBound")
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkDGGDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->GetInternals().GraphUser.PrintSelf(os, indent);
  os << indent << "Correction: " << (this->Correction ? "On" : "Off") << "\n";
  os << indent << "Search: " << this->GetSearchAsString() << "\n";
  os << indent << "GenerateUpperBound: " << (this->GenerateUpperBound ? "On" : "Off") << "\n";
  os << indent << "UpperBoundArrayName: " << this->UpperBoundArrayName << "\n";
}

//------------------------------------------------------------------------------
const char* vtkDGGDistance::GetSearchAsString() const
{
  static const char* const names[] = { "Certified", "LabelCorrecting", "Dijkstra" };
  return names[this->Search];
}

//------------------------------------------------------------------------------
std::vector<dgg::VertexArray> vtkDGGDistance::vtkInternals::DeclareArrays() const
{
  if (!this->Self->GenerateUpperBound)
  {
    return {};
  }
  return { { this->Self->UpperBoundArrayName, "UpperBoundArrayName",
    std::vector<std::vector<double>>(1) } };
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::vtkInternals::ComputeDistances(
  const DGGContext& context, dgg::DistanceTask& task)
{
  const dgg::SearchMethod methods[] = { dgg::SearchMethod::Certified,
    dgg::SearchMethod::LabelCorrecting, dgg::SearchMethod::Dijkstra };
  this->PieceSearch.reset();
  this->PieceLinks.reset();
  DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  return dgg::FindGraphDistances(
    context, this->GraphUser, methods[this->Self->Search], this->Self->Correction, task);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::vtkInternals::ComputePiece(const DGGContext& context,
  const DGGPieceUpdate& update, const dgg::SourceCollection& sources,
  const dgg::DistanceRequest& request, dgg::DistanceOutput& results, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  DGG_RETURN_IF_ERROR(
    this->GraphUser.UpdatePiece(context, group, update.Piece, this->Self, isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(
    this->PreparePiece(group, update.Piece, sources.GetNumberOfPositions() > 0, isDone));
  if (!isDone)
  {
    this->PieceSearch.reset();
    return dgg::Status::Success();
  }
  dgg::PieceDistanceOptions options;
  options.Tolerance = this->Self->GetProjectionTolerance();
  options.Correct = this->Self->Correction;
  options.Accuracy = this->GraphUser.GetSummary().Info.Accuracy;
  if (!(options.Accuracy > 0.0))
  {
    options.Accuracy = this->Self->GetAccuracy();
  }
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(options));
  return dgg::FindPieceDistances(group, *this->PieceSearch, this->PieceLinks.get(), sources,
    options, request, context.Progress, results);
}

//------------------------------------------------------------------------------
/// Prepares searches in the graph of the piece, from positions as well if there are any. Ids of
/// sources must number the points.
dgg::Status vtkDGGDistance::vtkInternals::PreparePiece(
  dgg::ProcessGroup& group, const dgg::SurfacePiece& piece, bool hasPositions, bool& isDone)
{
  const DGGGraphArrays& graph = *this->GraphUser.GetPiece();
  bool isPrepared = this->PieceSearch && this->PieceKey == graph.GetKey();
  DGG_RETURN_IF_ERROR(group.Require(isPrepared));
  if (!isPrepared)
  {
    this->PieceLinks.reset();
    this->PieceSearch = std::make_unique<dgg::PieceSearch>();
    this->PieceKey = graph.GetKey();
    DGG_RETURN_IF_ERROR(this->PieceSearch->Prepare(
      group, piece, graph.GetView(), graph.GetGraph().GetGhosts(), isDone));
    isDone = isDone && this->PieceSearch->HasConsecutiveIds();
  }
  bool canLink = this->PieceLinks != nullptr;
  DGG_RETURN_IF_ERROR(group.Require(canLink));
  if (hasPositions && !canLink && isDone)
  {
    this->PieceLinks = std::make_unique<dgg::PieceLinks>();
    DGG_RETURN_IF_ERROR(this->PieceLinks->Prepare(group, piece, isDone));
  }
  return dgg::Status::Success();
}
