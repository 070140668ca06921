// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGDistance.h"

#include "DGGDistanceInternals.h"
#include "DGGGraphUser.h"

#include "dggGraphDistances.h"
#include "dggPieceDistances.h"
#include "dggPieceLinks.h"
#include "dggPieceSearch.h"
#include "dggPieceVirtualSources.h"
#include "dggProcessGroup.h"
#include "dggSourceCollection.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <memory>
#include <utility>

vtkStandardNewMacro(vtkDGGDistance);

//------------------------------------------------------------------------------
class vtkDGGDistance::vtkInternals
  : public DGGGraphInternalsOf<vtkDGGDistance, DGGDistanceInternals>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override;
  bool CanDistribute() const override { return !this->Self->GetPassSourceArrays(); }
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
  std::vector<dgg::VertexArray> DeclareArrays() const override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, a larger {Accuracy} or a {MaximumDistance}";
  }

private:
  /// Searches in the graph of a piece.
  struct PieceSearches
  {
    dgg::PieceSearch Search;
    ///@{
    // Null unless they were needed.
    std::unique_ptr<dgg::PieceLinks> Links;
    std::unique_ptr<dgg::PieceVirtualSources> VirtualSources;
    ///@}
    DGGGraphArrays::Key Key; // of the graph
  };

  dgg::Status PreparePiece(const DGGPieceUpdate& update, bool hasPositions, bool wantVirtualSource,
    std::unique_ptr<PieceSearches>& searches, bool& isDone) const;

  std::unique_ptr<PieceSearches> Searches; // of the last update; null after a failure
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
  this->Searches.reset();
  DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  return dgg::FindGraphDistances(
    context, this->GraphUser, methods[this->Self->Search], this->Self->Correction, task);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::vtkInternals::ExecutePiece(
  const DGGContext& context, const DGGPieceUpdate& update, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  std::unique_ptr<PieceSearches> searches = std::move(this->Searches); // kept after success only
  dgg::SourceCollection sources;
  DGG_RETURN_IF_ERROR(this->CollectFromAll(update, sources, isDone));
  if (isDone)
  {
    DGG_RETURN_IF_ERROR(
      this->GraphUser.UpdatePiece(context, group, update.Piece, this->Self, isDone));
  }
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  struct
  {
    dgg::PieceDistanceOptions Options;
    double MaximumDistance;
    bool WantNearestSource;
    bool WantVirtualSource;
  } first;
  dgg::DistanceRequest request = this->MakeRequest();
  const double accuracy = this->GraphUser.GetPiece().GetView().Info.Accuracy;
  first.Options.Tolerance = this->Self->GetProjectionTolerance();
  first.Options.Accuracy = accuracy > 0.0 ? accuracy : this->Self->GetAccuracy();
  first.Options.Correct = this->Self->Correction;
  first.MaximumDistance = request.MaximumDistance;
  first.WantNearestSource = request.WantNearestSource;
  first.WantVirtualSource = request.WantVirtualSource;
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(first));
  request.MaximumDistance = first.MaximumDistance;
  request.WantNearestSource = first.WantNearestSource;
  request.WantVirtualSource = first.WantVirtualSource;
  DGG_RETURN_IF_ERROR(this->PreparePiece(
    update, sources.GetNumberOfPositions() > 0, request.WantVirtualSource, searches, isDone));
  if (!isDone)
  {
    this->GraphUser.RefusePiece();
    return dgg::Status::Success();
  }
  dgg::DistanceOutput results;
  DGG_RETURN_IF_ERROR(
    dgg::FindPieceDistances(context, group, searches->Search, searches->Links.get(),
      searches->VirtualSources.get(), sources, first.Options, request, results, isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  this->GraphUser.UsePiece(this->Self);
  this->Searches = std::move(searches);
  this->Warn(results.Warnings);
  vtkPolyData* output = vtkPolyData::GetData(update.Outputs);
  output->ShallowCopy(context.Input);
  this->AddResults(results, output);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Prepares searches in the graph of the piece, with positions or virtual sources if they are
/// needed, unless this was done before. Ids of sources must number the points.
dgg::Status vtkDGGDistance::vtkInternals::PreparePiece(const DGGPieceUpdate& update,
  bool hasPositions, bool wantVirtualSource, std::unique_ptr<PieceSearches>& searches,
  bool& isDone) const
{
  const DGGGraphArrays& graph = this->GraphUser.GetPiece();
  bool isPrepared = searches && searches->Key == graph.GetKey();
  DGG_RETURN_IF_ERROR(update.Group.Require(isPrepared));
  if (!isPrepared)
  {
    searches = std::make_unique<PieceSearches>();
    searches->Key = graph.GetKey();
    DGG_RETURN_IF_ERROR(searches->Search.Prepare(
      update.Group, update.Piece, graph.GetView(), graph.GetGraph().GetGhosts(), isDone));
    isDone = isDone && searches->Search.HasConsecutiveIds();
  }
  const auto prepare = [&](bool isNeeded, auto& part) {
    bool isReady = !isNeeded || part;
    if (isDone)
    {
      DGG_RETURN_IF_ERROR(update.Group.Require(isReady));
      if (!isReady)
      {
        part = std::make_unique<typename std::decay_t<decltype(part)>::element_type>();
        DGG_RETURN_IF_ERROR(part->Prepare(update.Group, update.Piece, isDone));
      }
    }
    return dgg::Status::Success();
  };
  DGG_RETURN_IF_ERROR(prepare(hasPositions, searches->Links));
  return prepare(wantVirtualSource, searches->VirtualSources);
}
