// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicProbe.h"

#include "DGGContext.h"
#include "DGGFieldInput.h"
#include "DGGFilterInternals.h"
#include "DGGMakeArray.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggFieldReader.h"
#include "dggProgressPart.h"
#include "dggPropertyChecks.h"
#include "dggSurfacePoint.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <limits>
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
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
};

//------------------------------------------------------------------------------
vtkGeodesicProbe::vtkGeodesicProbe()
  : DistanceArrayName("GeodesicDistance")
  , VirtualSourceArrayName("GeodesicVirtualSource")
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
  , ProjectionTolerance(0.01)
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
  const auto found = DGGMakeArray<vtkDoubleArray>(name, places.size());
  DGG_RETURN_IF_ERROR(dgg::ProbeField(context, reader.GetField(), places,
    dgg::ProgressPart(context.Progress, ReadDone, 1.0), found->GetPointer(0)));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(probes.Points);
  // Arrays that belong to an array of this name of the probe points are removed with it.
  DGGRemoveDistances(output, name);
  output->GetPointData()->AddArray(found);
  output->GetPointData()->SetActiveScalars(found->GetName());
  return dgg::Status::Success();
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
