// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicSampler.h"

#include "DGGGraphUser.h"
#include "DGGPieceSearches.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggOutput.h"
#include "dggPieceSamples.h"
#include "dggPreparedSurface.h"
#include "dggProcessGroup.h"
#include "dggPropertyChecks.h"
#include "dggSampleSearch.h"
#include "dggSourceCollection.h"
#include "dggStatus.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkGeodesicSampler);
vtkDGGDefineInputMacro(vtkGeodesicSampler, Start, 1);

namespace
{
const std::vector<vtkIdType> NoIds;
}

//------------------------------------------------------------------------------
class vtkGeodesicSampler::vtkInternals : public DGGGraphInternalsOf<vtkGeodesicSampler>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool CanDistribute() const override { return !this->Self->InFaces; }
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or a larger {Accuracy}";
  }

private:
  DGGSourceSet GetStart(vtkInformationVector** inputVector) const;
  dgg::SamplerOptions MakeOptions() const;

  DGGPieceSearches Searches; // of the last update in pieces
};

vtkDGGInternalsMacro(vtkGeodesicSampler);
vtkDGGGraphUserMacro(vtkGeodesicSampler);

//------------------------------------------------------------------------------
vtkGeodesicSampler::vtkGeodesicSampler()
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkGeodesicSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "FirstSample: " << this->FirstSample << "\n";
  os << indent << "CoveringRadius: " << this->CoveringRadius << "\n";
  os << indent << "InFaces: " << (this->InFaces ? "On" : "Off") << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  this->GetInternals().GraphUser.PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicSampler::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(dgg::CheckSamplerOptions(this->MakeOptions()));
  DGG_RETURN_IF_ERROR(
    dgg::CheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance } }));
  return DGGGraphInternalsOf::CheckProperties();
}

//------------------------------------------------------------------------------
DGGSourceSet vtkGeodesicSampler::vtkInternals::GetStart(vtkInformationVector** inputVector) const
{
  return { NoIds, vtkPolyData::GetData(inputVector[1]), 1, "start", "", "" };
}

//------------------------------------------------------------------------------
dgg::SamplerOptions vtkGeodesicSampler::vtkInternals::MakeOptions() const
{
  dgg::SamplerOptions options;
  options.NumberOfSamples = this->Self->NumberOfSamples;
  options.CoveringRadius = this->Self->CoveringRadius;
  options.InFaces = this->Self->InFaces;
  return options;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicSampler::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Searches = DGGPieceSearches();
  dgg::SamplerOptions options = this->MakeOptions();
  const DGGSourceSet start = this->GetStart(inputVector);
  DGG_RETURN_IF_ERROR(start.Points
      ? DGGLocate(context, start, this->Self->ProjectionTolerance, options.Given)
      : dgg::SetFirstSample(context.Surface, this->Self->FirstSample, options));
  std::vector<dgg::SurfaceSample> samples;
  dgg::Output output;
  DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  DGG_RETURN_IF_ERROR(dgg::FindSamples(context, this->GraphUser, options, samples));
  dgg::WriteSamples(context, options, samples, output);
  return this->FillOutput(context, output, outputVector);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicSampler::vtkInternals::ExecutePiece(
  const DGGContext& context, const DGGPieceUpdate& update, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  dgg::PieceSampleOptions options{ this->Self->NumberOfSamples, this->Self->CoveringRadius,
    this->Self->FirstSample, this->Self->ProjectionTolerance };
  dgg::SourceCollection start;
  vtkSmartPointer<vtkPolyData> points;
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(options));
  DGG_RETURN_IF_ERROR(
    DGGCollectFromAll(update, this->GetStart(update.Inputs), start, points, isDone));
  if (isDone)
  {
    DGG_RETURN_IF_ERROR(this->Searches.Prepare(
      context, update, { start.IsConnected, false, true }, this->GraphUser, this->Self, isDone));
  }
  isDone = isDone && this->Searches.GetSearch().GetNumberOfPoints() <= VTK_INT_MAX;
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  dgg::Output output;
  DGG_RETURN_IF_ERROR(dgg::FindPieceSamples(this->Searches.MakeContext(context), group,
    *this->Searches.GetSurface(), this->Searches.GetSearch(), this->Searches.GetLinks(),
    this->Searches.GetAccuracy(), start, options, output));
  if (group.Here == 0)
  {
    DGG_RETURN_IF_ERROR(this->FillOutput(context, output, update.Outputs));
  }
  this->Searches.Keep(this->GraphUser, this->Self);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkGeodesicSampler::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  dgg::SamplerOptions options;
  options.NumberOfSamples = 0;
  dgg::Output output;
  dgg::WriteSamples(context, options, {}, output);
  this->FillOutput(context, output, outputVector);
}
