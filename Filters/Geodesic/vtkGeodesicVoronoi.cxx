// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicVoronoi.h"

#include "DGGFieldInput.h"
#include "DGGGraphUser.h"
#include "DGGOutput.h"
#include "DGGPieceSearches.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggOutput.h"
#include "dggPieceVoronoi.h"
#include "dggPreparedSurface.h"
#include "dggProcessGroup.h"
#include "dggPropagationSession.h"
#include "dggPropertyChecks.h"
#include "dggSourceCollection.h"
#include "dggVoronoiTask.h"

#include "vtkCellData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkGeodesicVoronoi);
vtkDGGDefineInputMacro(vtkGeodesicVoronoi, Site, 1);

//------------------------------------------------------------------------------
class vtkGeodesicVoronoi::vtkInternals : public DGGGraphInternalsOf<vtkGeodesicVoronoi>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool CanDistribute() const override
  {
    return !this->Self->Centroidal && !this->Self->Preview && !this->Self->PassSiteArrays;
  }
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, a larger {Accuracy} or fewer sites";
  }

private:
  DGGSourceSet GetSiteSet(vtkInformationVector** inputVector) const;
  dgg::VoronoiOptions MakeOptions() const;
  dgg::Status FillOutputs(const DGGContext& context, const dgg::VoronoiOptions& options,
    const dgg::VoronoiResult& result, vtkInformationVector* outputVector);

  void FillSurface(const DGGContext& context, dgg::Output& labels, vtkPolyData* surface) const;

  dgg::PropagationSession PreviewSolver;
  DGGPieceSearches Searches; // of the last update in pieces
};

vtkDGGInternalsMacro(vtkGeodesicVoronoi);
vtkDGGGraphUserMacro(vtkGeodesicVoronoi);

//------------------------------------------------------------------------------
vtkGeodesicVoronoi::vtkGeodesicVoronoi()
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  DGGPrintIds(os, indent, "SiteIds", this->SiteIds);
  os << indent << "Centroidal: " << (this->Centroidal ? "On" : "Off") << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "GenerateCells: " << (this->GenerateCells ? "On" : "Off") << "\n";
  os << indent << "Preview: " << (this->Preview ? "On" : "Off") << "\n";
  os << indent << "RefineBoundaries: " << (this->RefineBoundaries ? "On" : "Off") << "\n";
  os << indent << "PassSiteArrays: " << (this->PassSiteArrays ? "On" : "Off") << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "SourceArrayName: " << this->SourceArrayName << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  this->GetInternals().GraphUser.PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::RemoveAllSites()
{
  this->RemoveAllSiteIds();
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkGeodesicVoronoi::GetBoundaries()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkGeodesicVoronoi::GetCells()
{
  return this->GetOutput(2);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkGeodesicVoronoi::GetSites()
{
  return this->GetOutput(3);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicVoronoi::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(
    dgg::CheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance } }));
  DGG_RETURN_IF_ERROR(this->MakeOptions().Check());
  return DGGGraphInternalsOf::CheckProperties();
}

//------------------------------------------------------------------------------
DGGSourceSet vtkGeodesicVoronoi::vtkInternals::GetSiteSet(vtkInformationVector** inputVector) const
{
  return { this->Self->SiteIds, vtkPolyData::GetData(inputVector[1]), 1, "site", "SiteIds", "" };
}

//------------------------------------------------------------------------------
dgg::VoronoiOptions vtkGeodesicVoronoi::vtkInternals::MakeOptions() const
{
  dgg::VoronoiOptions options;
  options.IsCentroidal = this->Self->Centroidal;
  options.LabelsOnly = !this->Self->GenerateCells;
  options.IsPreview = this->Self->Preview;
  options.IsRefined = this->Self->RefineBoundaries;
  options.Moving.NumberOfIterations = this->Self->NumberOfIterations;
  options.Moving.Tolerance = this->Self->Tolerance;
  options.DistanceName = this->Self->DistanceArrayName;
  options.SourceName = this->Self->SourceArrayName;
  options.UnreachedValue = this->Self->UnreachedValue;
  return options;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicVoronoi::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Searches = DGGPieceSearches();
  const DGGSourceSet set = this->GetSiteSet(inputVector);
  const dgg::VoronoiOptions options = this->MakeOptions();
  dgg::VoronoiResult result;
  DGG_RETURN_IF_ERROR(
    DGGLocate(context, set, this->Self->ProjectionTolerance, result.Sites, this->Self));
  if (this->Self->Preview)
  {
    DGG_RETURN_IF_ERROR(dgg::FindVoronoiPreview(context, this->PreviewSolver, result));
  }
  else
  {
    DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
    DGG_RETURN_IF_ERROR(dgg::FindVoronoiCells(context, this->GraphUser, options, result));
  }
  this->WarnAboutQuality(result.QualityWarning);
  DGG_RETURN_IF_ERROR(this->FillOutputs(context, options, result, outputVector));
  if (this->Self->PassSiteArrays)
  {
    std::vector<dgg::Id> all(result.Sites.size());
    std::iota(all.begin(), all.end(), 0);
    DGGPassArrays(set, dgg::GetNearestSites(context, result),
      vtkPolyData::GetData(outputVector, 0)->GetPointData());
    DGGPassArrays(
      set, result.Diagram.PolygonSites, vtkPolyData::GetData(outputVector, 2)->GetCellData());
    DGGPassArrays(set, all, vtkPolyData::GetData(outputVector, 3)->GetPointData());
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicVoronoi::vtkInternals::ExecutePiece(
  const DGGContext& context, const DGGPieceUpdate& update, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  dgg::SourceCollection sites;
  vtkSmartPointer<vtkPolyData> points;
  DGG_RETURN_IF_ERROR(
    DGGCollectFromAll(update, this->GetSiteSet(update.Inputs), sites, points, isDone));
  if (isDone)
  {
    DGG_RETURN_IF_ERROR(this->Searches.Prepare(context, update,
      { sites.GetNumberOfPositions() > 0, false, true }, this->GraphUser, this->Self, isDone));
  }
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  dgg::PieceVoronoiInput input{ this->Searches.GetSearch(), *this->Searches.GetSurface(),
    this->Searches.GetLinks(), sites, {}, this->MakeOptions() };
  input.Options.Tolerance = this->Self->ProjectionTolerance;
  input.Options.Accuracy = this->Searches.GetAccuracy();
  std::array<int, 2> cells{ { input.Voronoi.LabelsOnly, input.Voronoi.IsRefined } };
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(input.Options.Tolerance));
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(cells));
  input.Voronoi.LabelsOnly = cells[0] != 0;
  input.Voronoi.IsRefined = cells[1] != 0;
  dgg::PieceVoronoiOutput found;
  DGG_RETURN_IF_ERROR(
    dgg::FindPieceVoronoi(this->Searches.MakeContext(context), group, input, found, isDone));
  if (!isDone)
  {
    this->Searches = DGGPieceSearches(); // release memory before pieces are gathered
    return dgg::Status::Success();
  }
  this->Warn(found.Labels.Warnings);
  this->FillSurface(context, found.Labels, vtkPolyData::GetData(update.Outputs, 0));
  DGG_RETURN_IF_ERROR(this->FillOutput(context, found.Borders, update.Outputs, 1));
  DGG_RETURN_IF_ERROR(this->FillOutput(context, found.Cells, update.Outputs, 2));
  if (group.Here == 0)
  {
    DGG_RETURN_IF_ERROR(this->FillOutput(context, found.Sites, update.Outputs, 3));
  }
  this->Searches.Keep(this->GraphUser, this->Self);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicVoronoi::vtkInternals::FillOutputs(const DGGContext& context,
  const dgg::VoronoiOptions& options, const dgg::VoronoiResult& result,
  vtkInformationVector* outputVector)
{
  dgg::Output outputs[4];
  dgg::WriteVoronoi(context, options, result, outputs[0], outputs[1], outputs[2], outputs[3]);
  this->FillSurface(context, outputs[0], vtkPolyData::GetData(outputVector, 0));
  for (int port = 1; port < 4; ++port)
  {
    DGG_RETURN_IF_ERROR(this->FillOutput(context, outputs[port], outputVector, port));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::vtkInternals::FillSurface(
  const DGGContext& context, dgg::Output& labels, vtkPolyData* surface) const
{
  surface->ShallowCopy(context.Input);
  // Windows and marks of the input belong to the replaced array.
  DGGRemoveDistances(surface, this->Self->DistanceArrayName);
  DGGAddArrays(labels, surface);
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  this->FillOutputs(context, this->MakeOptions(), dgg::VoronoiResult(), outputVector);
}
