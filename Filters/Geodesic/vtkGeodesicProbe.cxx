// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicProbe.h"

#include "DGGContext.h"
#include "DGGFieldInput.h"
#include "DGGFilterInternals.h"
#include "DGGMakeArray.h"
#include "DGGPieceField.h"
#include "DGGPieceSearches.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggFieldReader.h"
#include "dggProcessGroup.h"
#include "dggProgressPart.h"
#include "dggPropertyChecks.h"
#include "dggSourceCollection.h"
#include "dggSurfacePoint.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkGeodesicProbe);
vtkDGGDefineInputMacro(vtkGeodesicProbe, Probe, 1);

namespace
{
/// Progress after reading distances, which may fit virtual sources.
constexpr double ReadDone = 0.5;

DGGSourceSet GetProbes(vtkInformationVector** inputVector)
{
  static const std::vector<vtkIdType> none;
  return { none, vtkPolyData::GetData(inputVector[1]), 1, "probe point", "", "" };
}
}

//------------------------------------------------------------------------------
class vtkGeodesicProbe::vtkInternals : public DGGInternalsOf<vtkGeodesicProbe>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool CanDistribute() const override { return true; }
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;

private:
  static void FillOutput(vtkPolyData* probes, const std::string& name,
    dgg::Buffer<double>& distances, vtkPolyData* output);

  DGGPieceField PieceField;
};

//------------------------------------------------------------------------------
vtkGeodesicProbe::vtkGeodesicProbe()
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkGeodesicProbe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "VirtualSourceArrayName: " << this->VirtualSourceArrayName << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicProbe::vtkInternals::CheckProperties() const
{
  return dgg::CheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicProbe::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const DGGSourceSet probes = GetProbes(inputVector);
  std::vector<dgg::SurfacePoint> places;
  vtkDataArray* distances = nullptr;
  dgg::FieldReader reader(context.Surface);
  DGG_RETURN_IF_ERROR(DGGLocate(context, probes, this->Self->ProjectionTolerance, places));
  DGG_RETURN_IF_ERROR(DGGFindDistances(
    this->Self->Information, this->Self->DistanceArrayName, context.Input, distances));
  DGG_RETURN_IF_ERROR(DGGReadField(context, distances, this->Self->UnreachedValue,
    this->Self->VirtualSourceArrayName.c_str(), dgg::ProgressPart(context.Progress, 0.0, ReadDone),
    reader));
  this->Warn(reader.GetWarnings());
  this->WarnAboutQuality(reader.DescribeQuality());
  const std::string name = DGGGetDistanceName(distances);
  dgg::Buffer<double> found(places.size());
  DGG_RETURN_IF_ERROR(dgg::ProbeField(context, reader.GetField(), places,
    dgg::ProgressPart(context.Progress, ReadDone, 1.0), found.Data()));
  FillOutput(probes.Points, name, found, vtkPolyData::GetData(outputVector));
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicProbe::vtkInternals::ExecutePiece(
  const DGGContext& context, const DGGPieceUpdate& update, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  struct
  {
    double UnreachedValue;
    double Tolerance;
  } first{ this->Self->UnreachedValue, this->Self->ProjectionTolerance };
  dgg::SourceCollection probes;
  vtkSmartPointer<vtkPolyData> points;
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(first));
  DGG_RETURN_IF_ERROR(DGGCollectFromAll(update, GetProbes(update.Inputs), probes, points, isDone));
  if (isDone)
  {
    DGG_RETURN_IF_ERROR(this->PieceField.Update(context, update, this->Self->Information,
      { this->Self->DistanceArrayName, this->Self->VirtualSourceArrayName, false,
        first.UnreachedValue },
      isDone));
  }
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  const dgg::PieceSurface& surface = this->PieceField.GetSurface();
  dgg::PiecePoints here;
  DGG_RETURN_IF_ERROR(probes.Check(0));
  DGG_RETURN_IF_ERROR(surface.Locate(group, probes, first.Tolerance, here));
  // Processes without points must notice an abort, too.
  DGG_RETURN_IF_ERROR(dgg::ReportTo(context.Progress, ReadDone));
  dgg::Buffer<double> found(here.Points.size());
  DGG_RETURN_IF_ERROR(
    dgg::ProbeField(this->PieceField.MakeContext(context), this->PieceField.GetReader().GetField(),
      here.Points, dgg::ProgressPart(context.Progress, ReadDone, 1.0), found.Data()));
  DGG_RETURN_IF_ERROR(group.Gather(here.Indices, 1, found));
  if (group.Here == 0)
  {
    FillOutput(points, this->PieceField.GetName(), found, vtkPolyData::GetData(update.Outputs));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkGeodesicProbe::vtkInternals::FillOutput(
  vtkPolyData* probes, const std::string& name, dgg::Buffer<double>& distances, vtkPolyData* output)
{
  output->ShallowCopy(probes);
  // Arrays that belong to an array of this name of the probe points are removed with it.
  DGGRemoveDistances(output, name);
  const auto array = DGGAdoptArray<vtkDoubleArray>(distances, name.c_str());
  output->GetPointData()->AddArray(array);
  output->GetPointData()->SetActiveScalars(array->GetName());
}

//------------------------------------------------------------------------------
void vtkGeodesicProbe::vtkInternals::MakeEmptyOutput(
  const DGGContext& vtkNotUsed(context), vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  DGGAddArray<vtkDoubleArray>(output->GetPointData(),
    DGGGetDistanceName(this->Self->Information, this->Self->DistanceArrayName), 0);
}
