// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSourceGeodesicDistance.h"

#include "DGGDistanceInternals.h"
#include "DGGPieceSearches.h"
#include "DGGProcesses.h"

#include "dggDistanceMethods.h"
#include "dggPieceGraph.h"
#include "dggPiecePropagation.h"
#include "dggProcessGroup.h"
#include "dggSourceCollection.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <memory>
#include <optional>

vtkStandardNewMacro(vtkVirtualSourceGeodesicDistance);

//------------------------------------------------------------------------------
class vtkVirtualSourceGeodesicDistance::vtkInternals
  : public DGGInternalsOf<vtkVirtualSourceGeodesicDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  void ForgetResults() override { this->Self->QualityWarning = false; }
  dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override;
  bool CanDistribute() const override
  {
    return !this->Self->GetPassSourceArrays() && !this->Self->GetGenerateNearestSource() &&
      !this->Self->GetGenerateVirtualSource();
  }
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
  void ReportQuality(const std::string& warning) override
  {
    this->Self->QualityWarning = this->WarnAboutQuality(warning);
  }
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or the {Quality} Fast";
  }

private:
  dgg::PropagationSession Propagation;
  std::unique_ptr<dgg::PiecePropagation> OfPiece; // of the last update
  dgg::Signature Pieces{};                        // of OfPiece
};

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::vtkVirtualSourceGeodesicDistance()
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkVirtualSourceGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quality: " << this->GetQualityAsString() << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkVirtualSourceGeodesicDistance, Quality, "Automatic", "Fast", "High");

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::vtkInternals::ComputeDistances(
  const DGGContext& context, dgg::DistanceTask& task)
{
  this->OfPiece.reset();
  const std::optional<dgg::PropagationQuality> qualities[] = { std::nullopt,
    dgg::PropagationQuality::Fast, dgg::PropagationQuality::High };
  return dgg::FindPropagatedDistances(
    context, this->Propagation, qualities[this->Self->Quality], task);
}

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::vtkInternals::ExecutePiece(
  const DGGContext& context, const DGGPieceUpdate& update, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  dgg::SourceCollection sources;
  vtkSmartPointer<vtkPolyData> points;
  DGG_RETURN_IF_ERROR(
    DGGCollectFromAll(update, this->GetSources(update.Inputs), sources, points, isDone));
  isDone = isDone && sources.GetNumberOfPositions() == 0;
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  struct
  {
    double MaximumDistance;
    int Quality;
  } first{ this->Self->GetMaximumDistance(), this->Self->Quality };
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(first));
  std::vector<dgg::Signature> signatures;
  DGG_RETURN_IF_ERROR(group.Share(dgg::ComputeSignature(update.Piece), signatures));
  const dgg::Signature pieces = dgg::SumSignatures(signatures);
  bool isKept = this->OfPiece && this->Pieces == pieces;
  DGG_RETURN_IF_ERROR(group.Require(isKept));
  std::unique_ptr<dgg::PiecePropagation> propagation = std::move(this->OfPiece);
  if (!isKept)
  {
    propagation = std::make_unique<dgg::PiecePropagation>();
    DGG_RETURN_IF_ERROR(propagation->Prepare(group, update.Piece, isDone));
  }
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  dgg::DistanceRequest request = this->MakeRequest();
  request.MaximumDistance = first.MaximumDistance;
  dgg::DistanceOutput results;
  DGG_RETURN_IF_ERROR(propagation->Run(context, group, sources,
    first.Quality == High ? dgg::PropagationQuality::High : dgg::PropagationQuality::Fast, request,
    results, isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  this->OfPiece = std::move(propagation); // not after an error
  this->Pieces = pieces;
  this->ReportQuality(results.QualityWarning);
  vtkPolyData* output = vtkPolyData::GetData(update.Outputs);
  output->ShallowCopy(context.Input);
  this->AddResults(results, output);
  return dgg::Status::Success();
}
