// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicProbe.h"

#include "DGGContext.h"
#include "DGGFieldInput.h"
#include "DGGFilterInternals.h"
#include "DGGMakeArray.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGUnreachedArray.h"
#include "DGGWindowArrays.h"

#include "dggBlockLoop.h"
#include "dggFaceProfile.h"
#include "dggProgressPart.h"
#include "dggSurfacePoint.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

vtkStandardNewMacro(vtkGeodesicProbe);
vtkDGGDefineInputMacro(vtkGeodesicProbe, Probe, 1);

namespace
{
/// Number of points that a thread processes as a block.
constexpr std::size_t BlockSize = 1024;
/// Progress after reading distances, which may fit virtual sources.
constexpr double ReadDone = 0.5;

DGGSourceSet GetProbes(vtkInformationVector** inputVector)
{
  static const std::vector<vtkIdType> none;
  return { none, vtkPolyData::GetData(inputVector[1]), 1, "probe point", "call SetProbeData()",
    "" };
}

/// Returns the distance at a surface point; NaN if unreached. On an edge this is the smallest
/// distance of its reached faces, as for isolines: a shortest path may come through any of them.
double Probe(
  const dgg::DistanceField& field, const dgg::SurfacePoint& place, dgg::FaceProfile& profile)
{
  double distance = dgg::Infinity;
  if (place.On == dgg::SurfacePoint::Support::Vertex)
  {
    distance = field.Distances[place.Vertex];
  }
  else
  {
    dgg::ForEachFaceAround(
      *field.Mesh, place, [&](dgg::Id f, const std::array<double, 3>& barycentric) {
        if (field.IsReached(f))
        {
          profile.Enter(f);
          distance = std::min(distance, profile.At(profile.PlaceOf(barycentric)));
        }
      });
  }
  return distance < dgg::Infinity ? distance : std::numeric_limits<double>::quiet_NaN();
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
  return DGGCheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicProbe::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const DGGSourceSet probes = GetProbes(inputVector);
  std::vector<dgg::SurfacePoint> places;
  vtkDataArray* distances = nullptr;
  DGGFieldInput input;
  DGG_RETURN_IF_ERROR(DGGLocate(context, probes, this->Self->ProjectionTolerance, places));
  DGG_RETURN_IF_ERROR(DGGFieldInput::FindDistances(
    this->Self->Information, this->Self->DistanceArrayName, context.Input, distances));
  const std::string name = DGGFieldInput::GetName(distances);
  input.SetUnreachedValue(this->Self->UnreachedValue);
  DGG_RETURN_IF_ERROR(input.Read(context, distances, this->Self->VirtualSourceArrayName,
    dgg::ProgressPart(context.Progress, 0.0, ReadDone)));
  if (!input.GetWarning().empty())
  {
    vtkWarningWithObjectMacro(this->Self, << input.GetWarning() << ".");
  }
  this->WarnAboutQuality(input.DescribeQuality(context.Surface));
  const auto found = DGGMakeArray<vtkDoubleArray>(name, places.size());
  double* values = found->GetPointer(0);
  DGG_RETURN_IF_ERROR(dgg::ForEach((places.size() + BlockSize - 1) / BlockSize, 1, context.Parallel,
    dgg::ProgressPart(context.Progress, ReadDone, 1.0),
    [&](std::size_t block, const dgg::ProgressCallback&) {
      dgg::FaceProfile profile(input.GetField());
      const std::size_t end = std::min(places.size(), (block + 1) * BlockSize);
      for (std::size_t i = block * BlockSize; i < end; ++i)
      {
        values[i] = Probe(input.GetField(), places[i], profile);
      }
      return dgg::Status::Success();
    }));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(probes.Points);
  // Arrays that belong to an array of this name of the probe points are removed with it.
  DGGWindowArrays::RemoveFrom(output->GetFieldData(), name);
  DGGUnreachedArray::RemoveFrom(output->GetPointData(), name);
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
    DGGFieldInput::GetName(this->Self->Information, this->Self->DistanceArrayName), 0);
}
