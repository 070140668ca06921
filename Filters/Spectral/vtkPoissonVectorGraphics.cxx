// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPoissonVectorGraphics.h"

#include "vtkDGGGraphicsInput.h"
#include "vtkDGGGraphicsOutput.h"
#include "vtkDGGMemory.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSourceCollector.h"

#include "dggGraphicsFragments.h"
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
/// Parts of the preparation: when curves are joined and the surface is refined.
constexpr double JoinedAt = 0.15;
constexpr double EmbeddedAt = 0.22;
constexpr double RefinedAt = 0.3;
/// Part of the progress when all is prepared: if it has to be, or only looked at.
constexpr double FactorizedAt = 0.7;
constexpr double FoundAt = 0.01;
/// Bytes that a fragment takes, besides its colours.
constexpr double BytesPerFragment = sizeof(dgg::SurfacePoint) + 64.0;
constexpr double UsualWidth = 0.05;     // of the diagonal
constexpr double VerticesPerFace = 0.5; // at least, but for a handful

dgg::Status NameCurve(const dgg::Status& status, const dgg::GraphicsCurve& curve)
{
  return status.IsOk() || status.IsAborted()
    ? status
    : dgg::Status::Invalid(curve.Name + ": " + status.GetMessage());
}
}

//------------------------------------------------------------------------------
/// What a factorization depends on.
struct vtkDGGDrawing
{
  vtkMTimeType MeshTime = 0;
  std::vector<std::vector<dgg::SurfacePoint>> Places; // per curve
  std::vector<dgg::GraphicsCurve> Curves;             // types and whether they are closed
  int RefinementLevel = 0;
  int RefinementRegion = 0;
  std::vector<dgg::Id> RefinedFaces;
  bool IntrinsicDelaunay = false;
  vtkTypeUInt64 MemoryLimit = 0; // does not matter

  bool HasPoisson() const
  {
    return std::any_of(
      this->Curves.begin(), this->Curves.end(), [](const dgg::GraphicsCurve& curve) {
        return curve.Type == dgg::GraphicsCurveType::Poisson;
      });
  }
  bool IsSame(const vtkDGGDrawing& other) const
  {
    bool isSame = this->MeshTime == other.MeshTime && this->Places.size() == other.Places.size() &&
      this->RefinementLevel == other.RefinementLevel &&
      this->RefinementRegion == other.RefinementRegion &&
      this->RefinedFaces == other.RefinedFaces &&
      this->IntrinsicDelaunay == other.IntrinsicDelaunay;
    for (std::size_t k = 0; k < this->Places.size() && isSame; ++k)
    {
      isSame = this->Curves[k].Type == other.Curves[k].Type &&
        this->Curves[k].IsClosed == other.Curves[k].IsClosed &&
        std::equal(this->Places[k].begin(), this->Places[k].end(), other.Places[k].begin(),
          other.Places[k].end(), dgg::IsSamePoint);
    }
    return isSame;
  }
};

//------------------------------------------------------------------------------
struct vtkPoissonVectorGraphics::vtkInternals
{
  vtkDGGSourceCollector Collector;
  vtkDGGGraphicsNames Names;
  dgg::VectorGraphics Graphics;
  vtkDGGDrawing Kept;                // what Graphics was prepared for
  std::vector<dgg::Id> RefinedFaces; // those of its surface that are parts of chosen ones
  bool IsKept = false;
  int NumberOfFactorizations = 0;
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
  return this->Internals->NumberOfFactorizations;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPoissonVectorGraphics::GetMemorySize() const
{
  const vtkInternals& internals = *this->Internals;
  return internals.Graphics.GetMemorySize() + internals.RefinedFaces.size() * sizeof(dgg::Id);
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
/// Whether there is memory for the faces of the surface, refined once they are, before any is
/// taken. Curves make some more.
dgg::Status vtkPoissonVectorGraphics::CheckMemory(const vtkDGGDrawing& drawing) const
{
  const dgg::SurfaceMesh& mesh = this->GetMesh().GetMesh();
  double faces = 0.0;
  for (dgg::Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    faces += mesh.IsDropped(f) ? 0.0 : 1.0;
  }
  faces *= drawing.RefinementRegion == Everywhere ? std::pow(4.0, drawing.RefinementLevel) : 1.0;
  const double vertices =
    std::max(static_cast<double>(mesh.GetNumberOfVertices()), VerticesPerFace * faces);
  return vtkDGGCheckMemory("the refined mesh",
    dgg::VectorGraphics::PredictMemory(faces, vertices, drawing.HasPoisson()), drawing.MemoryLimit,
    this->GetMemoryRemedy());
}

//------------------------------------------------------------------------------
/// Draw the curves, refine and cut the surface, factorize the matrix.
dgg::Status vtkPoissonVectorGraphics::PrepareDrawing(const vtkDGGDrawing& drawing,
  const dgg::GraphicsOptions& options, const std::function<bool(double)>& progress)
{
  const dgg::SurfaceMesh& mesh = this->GetMesh().GetMesh();
  vtkInternals& internals = *this->Internals;
  internals.IsKept = false;
  internals.Graphics.Clear();
  internals.RefinedFaces = std::vector<dgg::Id>();
  const std::size_t count = drawing.Curves.size();
  dgg::Status status = this->CheckMemory(drawing);
  std::vector<dgg::SurfaceCurve> joined(count);
  for (std::size_t k = 0; k < count && status.IsOk(); ++k)
  {
    const double part = JoinedAt / static_cast<double>(count);
    const double begin = static_cast<double>(k) * part;
    status = NameCurve(dgg::JoinPoints(mesh, drawing.Places[k], drawing.Curves[k].IsClosed,
                         dgg::ProgressPart(progress, begin, begin + part), joined[k]),
      drawing.Curves[k]);
  }
  dgg::RefinedSurface refined;
  if (status.IsOk())
  {
    status =
      dgg::EmbedCurves(mesh, joined, dgg::ProgressPart(progress, JoinedAt, EmbeddedAt), refined);
  }
  if (!status.IsOk())
  {
    return status;
  }
  dgg::GraphicsRefinement refinement;
  refinement.Levels = drawing.RefinementLevel;
  refinement.Part = drawing.RefinementRegion == NearCurves ? dgg::RefinedPart::AroundCurves
    : drawing.RefinementRegion == Cells                    ? dgg::RefinedPart::Faces
                                                           : dgg::RefinedPart::Everything;
  refinement.Faces = drawing.RefinedFaces;
  const double bytesPerFace =
    dgg::VectorGraphics::PredictMemory(1.0, VerticesPerFace, drawing.HasPoisson());
  refinement.MostFaces = static_cast<dgg::Offset>(
    std::min(static_cast<double>(vtkDGGGetMemoryLimit(drawing.MemoryLimit)) / bytesPerFace,
      static_cast<double>(refinement.MostFaces)));
  refinement.Progress = dgg::ProgressPart(progress, EmbeddedAt, RefinedAt);
  std::vector<dgg::Id> refinedFaces;
  status = dgg::RefineForGraphics(mesh, refinement, refined, &refinedFaces);
  if (!status.IsOk())
  {
    return status.IsAborted()
      ? status
      : dgg::Status::Invalid(status.GetMessage() +
          ", for memory to suffice: raise MemoryLimit, or " + this->GetMemoryRemedy());
  }
  std::vector<dgg::CurveChain> chains;
  for (std::size_t k = 0; k < count; ++k)
  {
    chains.push_back(dgg::FollowCurve(refined, joined, k));
  }
  dgg::GraphicsOptions own = options;
  own.Progress = dgg::ProgressPart(progress, RefinedAt, 1.0);
  status = internals.Graphics.Prepare(mesh, refined, chains, drawing.Curves, own);
  if (status.IsOk())
  {
    ++internals.NumberOfFactorizations;
    internals.RefinedFaces = std::move(refinedFaces);
  }
  else
  {
    internals.Graphics.Clear();
  }
  internals.IsKept = status.IsOk();
  internals.Kept = drawing;
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::FindFragments(const dgg::GraphicsResult& result, int channels,
  int division, vtkTypeUInt64 memoryLimit, dgg::GraphicsFragments& fragments) const
{
  const vtkInternals& internals = *this->Internals;
  const double count =
    static_cast<double>(internals.RefinedFaces.size()) * std::pow(static_cast<double>(division), 2);
  // Here and as arrays.
  const double bytes = BytesPerFragment + 2.0 * channels * sizeof(double);
  const dgg::Status status = vtkDGGCheckMemory("fragments", count * bytes, memoryLimit,
    "use a smaller FragmentDivision, or refine NearCurves only");
  return status.IsOk()
    ? dgg::MakeFragments(this->GetMesh().GetMesh(), internals.Graphics.GetSurface(),
        internals.RefinedFaces, result.Values, channels, division, fragments)
    : status;
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkDGGMeshAdapter& adapter = this->GetMesh();
  vtkInternals& internals = *this->Internals;
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

  // Observers may change inputs and properties.
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(surface);
  vtkDGGGraphicsOutput output(this->ResultArrayName);
  status = output.Take(copy, adapter, this->GetOutputPointsPrecision());
  drawing.RefinementLevel = this->RefinementLevel;
  drawing.RefinementRegion = this->RefinementRegion;
  if (drawing.RefinementRegion == Cells)
  {
    const dgg::Status found =
      vtkDGGGraphicsInput::FindRefinedFaces(surface, names, adapter, drawing.RefinedFaces);
    status = status.IsOk() ? found : status;
  }
  drawing.IntrinsicDelaunay = this->IntrinsicDelaunay;
  drawing.MemoryLimit = this->MemoryLimit;
  const int division = this->GenerateFragments ? this->FragmentDivision : 0;
  dgg::GraphicsOptions options;
  options.NumberOfChannels = input.GetNumberOfChannels();
  options.Background.assign(this->BackgroundColor, this->BackgroundColor + 3);
  options.Background.resize(static_cast<std::size_t>(options.NumberOfChannels), 0.0);
  options.IntrinsicDelaunay = this->IntrinsicDelaunay;
  options.CheckMemory = [&](double bytes) {
    const double points = static_cast<double>(internals.Graphics.GetSurface().Points.size());
    return vtkDGGCheckMemory("the factorization and the colours",
      bytes + points * output.GetBytesPerPoint(options.NumberOfChannels), drawing.MemoryLimit,
      this->GetMemoryRemedy());
  };
  const std::vector<dgg::GraphicsRegion> regions = input.MakeRegions(adapter);
  const dgg::ProgressCallback progress = [this](double done) { return this->Advance(done); };
  if (status.IsOk() && !progress(0.0))
  {
    status = dgg::Status::Abort();
  }
  const bool isKept = internals.IsKept && internals.Kept.IsSame(drawing);
  const double preparedAt = isKept ? FoundAt : FactorizedAt;
  if (status.IsOk() && !isKept)
  {
    status = this->PrepareDrawing(drawing, options, dgg::ProgressPart(progress, 0.0, preparedAt));
  }
  dgg::GraphicsResult result;
  if (status.IsOk())
  {
    options.Progress = dgg::ProgressPart(progress, preparedAt, 1.0);
    status = internals.Graphics.Run(curves, regions, options, result);
  }
  if (status.IsOk())
  {
    status = adapter.CheckUnchanged(surface, copy); // which has the very points of the input
  }
  dgg::GraphicsFragments fragments;
  if (status.IsOk() && division > 0)
  {
    status = this->FindFragments(
      result, options.NumberOfChannels, division, drawing.MemoryLimit, fragments);
  }
  if (status.IsOk())
  {
    output.Fill(internals.Graphics.GetSurface(), result, options.NumberOfChannels,
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
