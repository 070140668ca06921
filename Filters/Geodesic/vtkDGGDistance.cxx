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
  const dgg::ProcessGroup& group = update.Group;
  DGG_RETURN_IF_ERROR(
    this->GraphUser.UpdatePiece(context, group, update.Piece, this->Self, isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  const DGGGraphArrays& graph = *this->GraphUser.GetPiece();
  if (!group.Holds(this->PieceSearch && this->PieceKey == graph.GetKey()))
  {
    this->PieceLinks.reset();
    this->PieceSearch = std::make_unique<dgg::PieceSearch>();
    this->PieceKey = graph.GetKey();
    DGG_RETURN_IF_ERROR(this->PieceSearch->Prepare(
      group, update.Piece, graph.GetView(), graph.GetGraph().GetGhosts(), isDone));
  }
  const bool hasPositions = sources.GetNumberOfPositions() > 0;
  if (hasPositions && isDone && !group.Holds(this->PieceLinks != nullptr))
  {
    this->PieceLinks = std::make_unique<dgg::PieceLinks>();
    DGG_RETURN_IF_ERROR(this->PieceLinks->Prepare(group, update.Piece, isDone));
  }
  isDone = isDone && this->PieceSearch->HasConsecutiveIds(); // as the ids of sources
  if (!isDone)
  {
    this->PieceSearch.reset();
    return dgg::Status::Success();
  }
  const double accuracy = this->GraphUser.GetSummary().Info.Accuracy;
  return dgg::FindPieceDistances(group, *this->PieceSearch,
    hasPositions ? this->PieceLinks.get() : nullptr, sources,
    group.Share(this->Self->GetProjectionTolerance()).front(),
    group.Share(this->Self->Correction).front(),
    accuracy > 0.0 ? accuracy : group.Share(this->Self->GetAccuracy()).front(), request,
    context.Progress, results);
}
