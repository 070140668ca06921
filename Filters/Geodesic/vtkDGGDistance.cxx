// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGDistance.h"

#include "DGGDistanceInternals.h"
#include "DGGGraphUser.h"
#include "DGGPieceSearches.h"

#include "dggGraphDistances.h"
#include "dggPieceDistances.h"
#include "dggProcessGroup.h"
#include "dggSourceCollection.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

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
  DGGPieceSearches Searches; // of the last update
};

vtkDGGInternalsMacro(vtkDGGDistance);
vtkDGGGraphUserMacro(vtkDGGDistance);

//------------------------------------------------------------------------------
vtkDGGDistance::vtkDGGDistance()
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
vtkDGGAsStringMacro(vtkDGGDistance, Search, "Certified", "LabelCorrecting", "Dijkstra");

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
  this->Searches = DGGPieceSearches();
  DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  return dgg::FindGraphDistances(
    context, this->GraphUser, methods[this->Self->Search], this->Self->Correction, task);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::vtkInternals::ExecutePiece(
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
  struct
  {
    dgg::PieceDistanceOptions Options;
    double MaximumDistance;
    bool WantNearestSource;
    bool WantVirtualSource;
  } first;
  dgg::DistanceRequest request = this->MakeRequest();
  first.Options.Tolerance = this->Self->GetProjectionTolerance();
  first.Options.Correct = this->Self->Correction;
  first.MaximumDistance = request.MaximumDistance;
  first.WantNearestSource = request.WantNearestSource;
  first.WantVirtualSource = request.WantVirtualSource;
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(first));
  request.MaximumDistance = first.MaximumDistance;
  request.WantNearestSource = first.WantNearestSource;
  request.WantVirtualSource = first.WantVirtualSource;
  DGG_RETURN_IF_ERROR(this->Searches.Prepare(context, update,
    { sources.GetNumberOfPositions() > 0, request.WantVirtualSource }, this->GraphUser, this->Self,
    isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  first.Options.Accuracy = this->Searches.GetAccuracy();
  dgg::DistanceOutput results;
  DGG_RETURN_IF_ERROR(dgg::FindPieceDistances(this->Searches.MakeContext(context), group,
    this->Searches.GetSearch(), this->Searches.GetLinks(), this->Searches.GetVirtualSources(),
    sources, first.Options, request, results, isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  this->Searches.Keep(this->GraphUser, this->Self);
  this->Warn(results.Warnings);
  vtkPolyData* output = vtkPolyData::GetData(update.Outputs);
  output->ShallowCopy(context.Input);
  this->AddResults(results, output);
  return dgg::Status::Success();
}
