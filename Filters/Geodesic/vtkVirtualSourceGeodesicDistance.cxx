// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSourceGeodesicDistance.h"

#include "DGGDistanceInternals.h"
#include "DGGPieceSearches.h"
#include "DGGProcesses.h"

#include "dggDistanceMethods.h"
#include "dggPiecePropagation.h"
#include "dggProcessGroup.h"
#include "dggSourceCollection.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

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
  dgg::PiecePropagation OfPiece; // of the last update in pieces
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
  this->OfPiece = dgg::PiecePropagation();
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
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  dgg::DistanceRequest request = this->MakeRequest();
  struct
  {
    double MaximumDistance;
    double Tolerance;
    int Quality;
  } first{ request.MaximumDistance, this->Self->GetProjectionTolerance(), this->Self->Quality };
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(first));
  request.MaximumDistance = first.MaximumDistance;
  DGG_RETURN_IF_ERROR(this->OfPiece.Prepare(group, update.Piece, isDone));
  if (!isDone)
  {
    this->OfPiece = dgg::PiecePropagation(); // release memory before pieces are gathered
    return dgg::Status::Success();
  }
  dgg::DistanceOutput results;
  DGG_RETURN_IF_ERROR(this->OfPiece.Run(context, group, sources, first.Tolerance,
    first.Quality == High ? dgg::PropagationQuality::High : dgg::PropagationQuality::Fast, request,
    results, isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  if (group.Here == 0)
  {
    this->ReportQuality(results.QualityWarning);
  }
  this->Self->QualityWarning = !results.QualityWarning.empty();
  vtkPolyData* output = vtkPolyData::GetData(update.Outputs);
  output->ShallowCopy(context.Input);
  this->AddResults(results, output);
  return dgg::Status::Success();
}
