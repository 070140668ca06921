// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPoissonVectorGraphics.h"

#include "vtkDGGGraphicsInput.h"
#include "vtkDGGGraphicsKeeper.h"
#include "vtkDGGGraphicsOutput.h"
#include "vtkDGGMemory.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSourceCollector.h"

#include "dggGraphicsFragments.h"
#include "dggProgressPart.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPoissonVectorGraphics);

namespace
{
/// Part of the progress when all is prepared: if it has to be, or only looked at.
constexpr double FactorizedAt = 0.7;
constexpr double FoundAt = 0.01;
/// Bytes that a fragment takes, besides its colours.
constexpr double BytesPerFragment = sizeof(dgg::SurfacePoint) + 64.0;
constexpr double UsualWidth = 0.05; // of the diagonal
}

//------------------------------------------------------------------------------
struct vtkPoissonVectorGraphics::vtkInternals
{
  vtkDGGSourceCollector Collector;
  vtkDGGGraphicsNames Names;
  vtkDGGGraphicsKeeper Keeper;
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
  , GenerateFragments(false)
  , FragmentDivision(1)
  , ResultArrayName("Colors")
  , Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  vtkDGGGraphicsNames& names = this->Internals->Names;
  names.CurveType = "CurveType";
  names.LeftColor = "LeftColor";
  names.RightColor = "RightColor";
  names.Strength = "Strength";
  names.RightStrength = "RightStrength";
  names.Width = "Width";
  names.RegionStrength = "RegionStrength";
  names.Refinement = "Refine";
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
  os << indent << "RefinementArrayName: " << names.Refinement << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "IntrinsicDelaunay: " << (this->IntrinsicDelaunay ? "On" : "Off") << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "GenerateFragments: " << (this->GenerateFragments ? "On" : "Off") << "\n";
  os << indent << "FragmentDivision: " << this->FragmentDivision << "\n";
  os << indent << "ResultArrayName: " << this->ResultArrayName << "\n";
  os << indent << "NumberOfFactorizations: " << this->GetNumberOfFactorizations() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
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
/// The assertion is there for the semicolon.
#define vtkDGGNameMacro(Property)                                           \
  void vtkPoissonVectorGraphics::Set##Property##ArrayName(const char* name) \
  {                                                                         \
    this->SetName(this->Internals->Names.Property, name);                   \
  }                                                                         \
  const char* vtkPoissonVectorGraphics::Get##Property##ArrayName() const    \
  {                                                                         \
    return this->Internals->Names.Property.c_str();                         \
  }                                                                         \
  static_assert(true, #Property)
vtkDGGNameMacro(CurveType);
vtkDGGNameMacro(LeftColor);
vtkDGGNameMacro(RightColor);
vtkDGGNameMacro(Strength);
vtkDGGNameMacro(RightStrength);
vtkDGGNameMacro(Width);
vtkDGGNameMacro(Region);
vtkDGGNameMacro(RegionStrength);
vtkDGGNameMacro(Refinement);
#undef vtkDGGNameMacro

//------------------------------------------------------------------------------
const char* vtkPoissonVectorGraphics::GetRefinementRegionAsString() const
{
  return this->RefinementRegion == NearCurves ? "NearCurves"
    : this->RefinementRegion == Cells         ? "Cells"
                                              : "Everywhere";
}

//------------------------------------------------------------------------------
vtkPolyData* vtkPoissonVectorGraphics::GetFragments()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
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
int vtkPoissonVectorGraphics::GetNumberOfFactorizations() const
{
  return this->Internals->Keeper.GetNumberOfFactorizations();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPoissonVectorGraphics::GetMemorySize() const
{
  return this->Internals->Keeper.GetMemorySize();
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::CheckProperties() const
{
  if (this->ResultArrayName.empty())
  {
    return dgg::Status::Invalid("ResultArrayName is empty: call SetResultArrayName() with a name");
  }
  if (vtkDGGGraphicsOutput::IsTaken(this->ResultArrayName))
  {
    return dgg::Status::Invalid("ResultArrayName is '" + this->ResultArrayName +
      "', which another array of the output has: call SetResultArrayName() with another name");
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
  return status.IsOk() && this->RefinementRegion == Cells
    ? vtkDGGGraphicsInput::CheckRefinement(surface, names)
    : status;
}

//------------------------------------------------------------------------------
std::string vtkPoissonVectorGraphics::GetMemoryRemedy() const
{
  return "use a smaller mesh or a lower RefinementLevel, or refine NearCurves only";
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::FindFragments(const dgg::GraphicsResult& result, int channels,
  int division, vtkTypeUInt64 memoryLimit, dgg::GraphicsFragments& fragments) const
{
  const vtkDGGGraphicsKeeper& keeper = this->Internals->Keeper;
  const double count = static_cast<double>(keeper.GetRefinedFaces().size()) *
    std::pow(static_cast<double>(division), 2);
  // Here and as arrays.
  const double bytes = BytesPerFragment + 2.0 * channels * sizeof(double);
  const dgg::Status status = vtkDGGCheckMemory("fragments", count * bytes, memoryLimit,
    "use a smaller FragmentDivision, or refine NearCurves only");
  return status.IsOk()
    ? dgg::MakeFragments(this->GetMesh().GetMesh(), keeper.GetGraphics().GetSurface(),
        keeper.GetRefinedFaces(), result.Values, channels, division, fragments)
    : status;
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkDGGMeshAdapter& adapter = this->GetMesh();
  vtkInternals& internals = *this->Internals;
  vtkDGGGraphicsKeeper& keeper = internals.Keeper;
  vtkPolyData* lines = vtkPolyData::GetData(inputVector[1]);
  vtkDGGGraphicsNames names = internals.Names;
  double bounds[6];
  surface->GetPoints()->GetBounds(bounds);
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  names.DefaultWidth = this->Width > 0.0 ? this->Width : UsualWidth * diagonal;
  vtkDGGGraphicsInput input;
  dgg::Status status = input.Read(lines, surface, names);
  const std::vector<dgg::GraphicsCurve>& curves = input.GetCurves();
  vtkDGGDrawing drawing;
  drawing.MeshTime = adapter.GetBuildTime();
  drawing.Curves = curves;
  drawing.Places.resize(curves.size());
  static const std::vector<vtkIdType> none;
  for (std::size_t k = 0; k < curves.size() && status.IsOk(); ++k)
  {
    vtkDGGSourceSet set{ none, lines, 1, "curve point", "call SetCurveData()", "" };
    set.PointIds = &input.GetPointIds()[k];
    status = vtkDGGSourceCollector::Check(set, surface->GetNumberOfPoints());
    std::vector<dgg::GeodesicSource> found;
    if (status.IsOk())
    {
      status = internals.Collector.Collect(
        set, this->ProjectionTolerance, adapter, surface->GetPoints(), found);
    }
    drawing.Places[k] = vtkDGGGetPlaces(found);
  }
  if (!status.IsOk())
  {
    return status;
  }

  vtkDGGGraphicsOutput output(this->ResultArrayName);
  status = output.Take(surface, adapter, this->GetOutputPointsPrecision());
  drawing.RefinementLevel = this->RefinementLevel;
  drawing.RefinedPart = this->RefinementRegion == NearCurves ? dgg::RefinedPart::AroundCurves
    : this->RefinementRegion == Cells                        ? dgg::RefinedPart::Faces
                                                             : dgg::RefinedPart::Everything;
  if (drawing.RefinedPart == dgg::RefinedPart::Faces)
  {
    drawing.RefinedFaces = vtkDGGGraphicsInput::FindRefinedFaces(surface, names, adapter);
  }
  drawing.IntrinsicDelaunay = this->IntrinsicDelaunay;
  drawing.MemoryLimit = this->MemoryLimit;
  const int division = this->GenerateFragments ? this->FragmentDivision : 0;
  dgg::GraphicsOptions options;
  options.NumberOfChannels = input.GetNumberOfChannels();
  options.Background.assign(this->BackgroundColor, this->BackgroundColor + 3);
  options.Background.resize(static_cast<std::size_t>(options.NumberOfChannels), 0.0);
  options.IntrinsicDelaunay = this->IntrinsicDelaunay;
  options.CheckMemory = [&](double bytes, double missing) {
    const double points = static_cast<double>(keeper.GetGraphics().GetSurface().Points.size());
    const double own = drawing.MemoryLimit == 0 ? missing : bytes;
    return vtkDGGCheckMemory("the factorization and the colours",
      own + points * output.GetBytesPerPoint(options.NumberOfChannels), drawing.MemoryLimit,
      this->GetMemoryRemedy());
  };
  const std::vector<dgg::GraphicsRegion> regions = input.MakeRegions(adapter);
  const dgg::ProgressCallback progress = [this](double done) { return this->Advance(done); };
  if (status.IsOk() && !progress(0.0))
  {
    status = dgg::Status::Abort();
  }
  const bool isKept = keeper.IsUpToDate(drawing);
  const double preparedAt = isKept ? FoundAt : FactorizedAt;
  if (status.IsOk() && !isKept)
  {
    status = keeper.Prepare(adapter.GetMesh(), drawing, options, this->GetMemoryRemedy(),
      dgg::ProgressPart(progress, 0.0, preparedAt));
  }
  dgg::GraphicsResult result;
  if (status.IsOk())
  {
    options.Progress = dgg::ProgressPart(progress, preparedAt, 1.0);
    status = keeper.GetGraphics().Run(curves, regions, options, result);
  }
  dgg::GraphicsFragments fragments;
  if (status.IsOk() && division > 0)
  {
    status = this->FindFragments(
      result, options.NumberOfChannels, division, drawing.MemoryLimit, fragments);
  }
  if (status.IsOk())
  {
    output.Fill(keeper.GetGraphics().GetSurface(), result, options.NumberOfChannels,
      vtkPolyData::GetData(outputVector));
    if (division > 0)
    {
      output.FillFragments(
        fragments, options.NumberOfChannels, vtkPolyData::GetData(outputVector, 1));
    }
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::MakeEmptyOutput(
  vtkPolyData* surface, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(surface);
  const vtkDGGGraphicsOutput arrays(this->ResultArrayName);
  arrays.AddColors({}, 3, output);
  arrays.AddNetSources({}, 3, output);
}
