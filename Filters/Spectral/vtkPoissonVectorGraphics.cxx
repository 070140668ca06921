// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPoissonVectorGraphics.h"

#include "vtkDGGGraphicsInput.h"
#include "vtkDGGGraphicsOutput.h"
#include "vtkDGGMemory.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSourceCollector.h"

#include "dggGraphicsRefinement.h"
#include "dggProgressPart.h"
#include "dggVectorGraphics.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPoissonVectorGraphics);

namespace
{
/// Parts of the progress: when curves are joined, the surface is refined, the system factorized.
constexpr double JoinedAt = 0.1;
constexpr double EmbeddedAt = 0.15;
constexpr double RefinedAt = 0.2;
constexpr double FactorizedAt = 0.7;
/// Bytes that a face takes at least while it is refined.
constexpr double BytesPerFace = 256.0;
constexpr double UsualWidth = 0.05; // of the diagonal

dgg::ProgressCallback PartOf(const dgg::ProgressCallback& progress, double begin, double end)
{
  return dgg::ProgressPart(progress, begin, end);
}

dgg::Status NameCurve(const dgg::Status& status, std::size_t k)
{
  return status.IsOk() || status.IsAborted()
    ? status
    : dgg::Status::Invalid("curve " + std::to_string(k) + ": " + status.GetMessage());
}
}

//------------------------------------------------------------------------------
struct vtkPoissonVectorGraphics::vtkInternals
{
  vtkDGGSourceCollector Collector;
  vtkDGGGraphicsNames Names;
};

//------------------------------------------------------------------------------
vtkPoissonVectorGraphics::vtkPoissonVectorGraphics()
  : Width(0.0)
  , BackgroundColor{ 0.0, 0.0, 0.0 }
  , RefinementLevel(1)
  , RefinementRegion(Everywhere)
  , ProjectionTolerance(0.01)
  , IntrinsicDelaunay(true)
  , MemoryLimit(0)
  , ResultArrayName("Colors")
  , Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
  vtkDGGGraphicsNames& names = this->Internals->Names;
  names.CurveType = "CurveType";
  names.LeftColor = "LeftColor";
  names.RightColor = "RightColor";
  names.Strength = "Strength";
  names.RightStrength = "RightStrength";
  names.Width = "Width";
  names.RegionStrength = "RegionStrength";
}

//------------------------------------------------------------------------------
vtkPoissonVectorGraphics::~vtkPoissonVectorGraphics() = default;

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const vtkDGGGraphicsNames& names = this->Internals->Names;
  os << indent << "CurveTypeArrayName: " << names.CurveType << "\n";
  os << indent << "LeftColorArrayName: " << names.LeftColor << "\n";
  os << indent << "RightColorArrayName: " << names.RightColor << "\n";
  os << indent << "StrengthArrayName: " << names.Strength << "\n";
  os << indent << "RightStrengthArrayName: " << names.RightStrength << "\n";
  os << indent << "WidthArrayName: " << names.Width << "\n";
  os << indent << "RegionArrayName: " << names.Region << "\n";
  os << indent << "RegionStrengthArrayName: " << names.RegionStrength << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "BackgroundColor: " << this->BackgroundColor[0] << " " << this->BackgroundColor[1]
     << " " << this->BackgroundColor[2] << "\n";
  os << indent << "RefinementLevel: " << this->RefinementLevel << "\n";
  os << indent << "RefinementRegion: " << this->GetRefinementRegionAsString() << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "IntrinsicDelaunay: " << (this->IntrinsicDelaunay ? "On" : "Off") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "ResultArrayName: " << this->ResultArrayName << "\n";
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::SetCurveConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::SetCurveData(vtkPolyData* curves)
{
  this->SetInputData(1, curves);
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::SetName(std::string& property, const char* name)
{
  if (vtkDGGChangeName(property, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
#define vtkDGGNameMacro(Property)                                           \
  void vtkPoissonVectorGraphics::Set##Property##ArrayName(const char* name) \
  {                                                                         \
    this->SetName(this->Internals->Names.Property, name);                   \
  }                                                                         \
  const char* vtkPoissonVectorGraphics::Get##Property##ArrayName() const    \
  {                                                                         \
    return this->Internals->Names.Property.c_str();                         \
  }
vtkDGGNameMacro(CurveType);
vtkDGGNameMacro(LeftColor);
vtkDGGNameMacro(RightColor);
vtkDGGNameMacro(Strength);
vtkDGGNameMacro(RightStrength);
vtkDGGNameMacro(Width);
vtkDGGNameMacro(Region);
vtkDGGNameMacro(RegionStrength);
#undef vtkDGGNameMacro

//------------------------------------------------------------------------------
const char* vtkPoissonVectorGraphics::GetRefinementRegionAsString() const
{
  return this->RefinementRegion == NearCurves ? "NearCurves" : "Everywhere";
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::SetResultArrayName(const char* name)
{
  this->SetName(this->ResultArrayName, name);
}

//------------------------------------------------------------------------------
const char* vtkPoissonVectorGraphics::GetResultArrayName() const
{
  return this->ResultArrayName.c_str();
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::CheckProperties() const
{
  if (this->ResultArrayName.empty())
  {
    return dgg::Status::Invalid("ResultArrayName is empty: call SetResultArrayName() with a name");
  }
  const dgg::Status status = vtkDGGCheckLength("Width", this->Width);
  return status.IsOk() ? vtkDGGCheckLength("ProjectionTolerance", this->ProjectionTolerance)
                       : status;
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::CheckInputs(
  vtkPolyData* surface, vtkInformationVector** inputVector) const
{
  vtkDGGGraphicsNames names = this->Internals->Names;
  names.DefaultWidth = 1.0; // found when the mesh is
  vtkDGGGraphicsInput input;
  const dgg::Status status = input.Read(vtkPolyData::GetData(inputVector[1]), surface, names);
  if (status.IsOk() && input.GetCurves().empty() && names.Region.empty())
  {
    return dgg::Status::Invalid("there is nothing to draw: connect lines to input port 1 with "
                                "SetCurveData(), or call SetRegionArrayName()");
  }
  return status;
}

//------------------------------------------------------------------------------
std::string vtkPoissonVectorGraphics::GetMemoryRemedy() const
{
  return "use a smaller mesh or a lower RefinementLevel, or refine NearCurves only";
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkDGGMeshAdapter& adapter = this->GetMesh();
  const dgg::SurfaceMesh& mesh = adapter.GetMesh();
  vtkPolyData* lines = vtkPolyData::GetData(inputVector[1]);
  vtkDGGGraphicsNames names = this->Internals->Names;
  double bounds[6];
  surface->GetPoints()->GetBounds(bounds);
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  names.DefaultWidth = this->Width > 0.0 ? this->Width : UsualWidth * diagonal;
  vtkDGGGraphicsInput input;
  dgg::Status status = input.Read(lines, surface, names);
  const std::vector<dgg::GraphicsCurve>& curves = input.GetCurves();
  std::vector<std::vector<dgg::SurfacePoint>> places(curves.size());
  static const std::vector<vtkIdType> none;
  for (std::size_t k = 0; k < curves.size() && status.IsOk(); ++k)
  {
    vtkDGGSourceSet set{ none, lines, 1, "curve point", "call SetCurveData()", "" };
    set.PointIds = &input.GetPointIds()[k];
    status = vtkDGGSourceCollector::Check(set, surface->GetNumberOfPoints());
    std::vector<dgg::GeodesicSource> found;
    if (status.IsOk())
    {
      status = this->Internals->Collector.Collect(
        set, this->ProjectionTolerance, adapter, surface->GetPoints(), found);
    }
    places[k] = vtkDGGGetPlaces(found);
  }
  if (!status.IsOk())
  {
    return status;
  }

  // Observers may change inputs and properties.
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(surface);
  vtkDGGGraphicsOutput output(this->ResultArrayName);
  status = output.Take(copy, adapter, this->GetOutputPointsPrecision());
  const vtkTypeUInt64 limit = this->MemoryLimit;
  const auto channels = static_cast<std::size_t>(input.GetNumberOfChannels());
  dgg::GraphicsOptions options;
  options.NumberOfChannels = input.GetNumberOfChannels();
  options.Background.assign(this->BackgroundColor, this->BackgroundColor + 3);
  options.Background.resize(channels, 0.0);
  options.IntrinsicDelaunay = this->IntrinsicDelaunay;
  options.CheckMemory = [&](double bytes) {
    return vtkDGGCheckMemory(
      "the factorization and the colours", bytes, limit, this->GetMemoryRemedy());
  };
  dgg::GraphicsRefinement refinement;
  refinement.Levels = this->RefinementLevel;
  refinement.IsEverywhere = this->RefinementRegion == Everywhere;
  refinement.MostFaces = static_cast<dgg::Offset>(
    std::min(static_cast<double>(vtkDGGGetMemoryLimit(limit)) / BytesPerFace,
      static_cast<double>(refinement.MostFaces)));
  const dgg::ProgressCallback progress = [this](double done) { return this->Advance(done); };

  if (status.IsOk() && !progress(0.0))
  {
    status = dgg::Status::Abort();
  }
  std::vector<dgg::SurfaceCurve> joined(curves.size());
  for (std::size_t k = 0; k < curves.size() && status.IsOk(); ++k)
  {
    const double part = JoinedAt / static_cast<double>(curves.size());
    const double begin = static_cast<double>(k) * part;
    status = NameCurve(dgg::JoinPoints(mesh, places[k], curves[k].IsClosed,
                         PartOf(progress, begin, begin + part), joined[k]),
      k);
  }
  dgg::RefinedSurface refined;
  if (status.IsOk())
  {
    status = dgg::EmbedCurves(mesh, joined, PartOf(progress, JoinedAt, EmbeddedAt), refined);
  }
  if (status.IsOk())
  {
    refinement.Progress = PartOf(progress, EmbeddedAt, RefinedAt);
    status = dgg::RefineForGraphics(mesh, refinement, refined);
    if (!status.IsOk() && !status.IsAborted())
    {
      status = dgg::Status::Invalid(status.GetMessage() +
        ", for memory to suffice: raise MemoryLimit, or " + this->GetMemoryRemedy());
    }
  }
  std::vector<dgg::CurveChain> chains;
  for (std::size_t k = 0; k < curves.size() && status.IsOk(); ++k)
  {
    chains.push_back(dgg::FollowCurve(refined, joined, k));
  }
  dgg::VectorGraphics graphics;
  if (status.IsOk())
  {
    options.Progress = PartOf(progress, RefinedAt, FactorizedAt);
    status = graphics.Prepare(mesh, refined, chains, curves, options);
  }
  dgg::GraphicsResult result;
  if (status.IsOk())
  {
    options.Progress = PartOf(progress, FactorizedAt, 1.0);
    status = graphics.Run(curves, input.MakeRegions(adapter), options, result);
  }
  if (status.IsOk())
  {
    status = adapter.CheckUnchanged(surface, copy); // which has the very points of the input
  }
  if (status.IsOk())
  {
    output.Fill(
      graphics.GetSurface(), result, options.NumberOfChannels, vtkPolyData::GetData(outputVector));
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::MakeEmptyOutput(
  vtkPolyData* surface, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(surface);
  vtkDGGGraphicsOutput(this->ResultArrayName).AddColors({}, 3, output);
}
