// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPoissonVectorGraphics.h"

#include "DGGContext.h"
#include "DGGFilterInternals.h"
#include "DGGGraphicsInput.h"
#include "DGGGraphicsOutput.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggGraphicsFragments.h"
#include "dggGraphicsRefinement.h"
#include "dggStatus.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPoissonVectorGraphics);

namespace
{
/// Progress after preparation, or after finding a kept preparation.
constexpr double FactorizedAt = 0.7;
constexpr double FoundAt = 0.01;
/// Bytes per fragment, without colors.
constexpr double BytesPerFragment = sizeof(dgg::SurfacePoint) + 64.0;
constexpr double UsualWidth = 0.05; // of the diagonal
/// Progress within the preparation: after joining and embedding curves, and refinement.
constexpr double JoinedAt = 0.15;
constexpr double EmbeddedAt = 0.22;
constexpr double RefinedAt = 0.3;

/// The inputs that a factorization depends on.
struct Drawing
{
  std::uint64_t MeshBuild = 0;
  std::vector<std::vector<dgg::SurfacePoint>> Places; // per curve
  std::vector<dgg::GraphicsCurve> Curves;             // types and closedness
  dgg::GraphicsRefinement Refinement;
  bool IntrinsicDelaunay = false;

  bool IsSame(const Drawing& other) const
  {
    bool isSame = this->MeshBuild == other.MeshBuild &&
      this->Places.size() == other.Places.size() &&
      this->Refinement.Levels == other.Refinement.Levels &&
      this->Refinement.Part == other.Refinement.Part &&
      this->Refinement.Faces == other.Refinement.Faces &&
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

/// Returns the bytes for the faces of the surface after refinement. Curves add a few faces.
double EstimateMesh(const dgg::SurfaceMesh& mesh, const Drawing& drawing)
{
  double faces = 0.0;
  for (dgg::Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    faces += mesh.IsDropped(f) ? 0.0 : 1.0;
  }
  return faces * dgg::VectorGraphics::BytesPerFace *
    (drawing.Refinement.Part == dgg::RefinedPart::Everything
        ? std::pow(4.0, drawing.Refinement.Levels)
        : 1.0);
}
}

//------------------------------------------------------------------------------
class vtkPoissonVectorGraphics::vtkInternals : public DGGInternalsOf<vtkPoissonVectorGraphics>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or a lower {RefinementLevel}, or refine near curves only";
  }

  dgg::VectorGraphics Graphics;
  Drawing Kept; // input that Graphics is prepared for
  bool IsKept = false;
  std::vector<dgg::Id> RefinedFaces; // faces within those selected for refinement
  int NumberOfFactorizations = 0;

  /// Draws the curves, refines and cuts the surface, factorizes the matrix. Memory is checked
  /// before allocation. After a failure nothing is kept.
  dgg::Status Prepare(const DGGContext& context, const Drawing& drawing,
    const dgg::GraphicsOptions& options, const dgg::ProgressCallback& progress);

private:
  dgg::Status Draw(const DGGContext& context, const Drawing& drawing,
    const dgg::GraphicsOptions& options, const dgg::ProgressCallback& progress);
  DGGGraphicsNames GetNames() const;
};

vtkDGGInternalsMacro(vtkPoissonVectorGraphics);

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::vtkInternals::Draw(const DGGContext& context,
  const Drawing& drawing, const dgg::GraphicsOptions& options,
  const dgg::ProgressCallback& progress)
{
  const dgg::SurfaceMesh& mesh = context.Surface.GetMesh();
  const std::size_t count = drawing.Curves.size();
  DGG_RETURN_IF_ERROR(
    context.Memory.Check("The refined mesh", EstimateMesh(mesh, drawing), this->GetMemoryRemedy()));
  std::vector<dgg::SurfaceCurve> joined(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    const double part = JoinedAt / static_cast<double>(count);
    const double begin = static_cast<double>(k) * part;
    DGG_RETURN_IF_ERROR(dgg::JoinPoints(mesh, drawing.Places[k], drawing.Curves[k].IsClosed,
      dgg::ProgressPart(progress, begin, begin + part), joined[k])
                          .Of(drawing.Curves[k].Name));
  }
  dgg::SubMesh refined;
  DGG_RETURN_IF_ERROR(
    dgg::EmbedCurves(mesh, joined, dgg::ProgressPart(progress, JoinedAt, EmbeddedAt), refined));
  dgg::GraphicsRefinement refinement = drawing.Refinement;
  refinement.MostFaces =
    static_cast<dgg::Offset>(std::min(context.Memory.GetBytes() / dgg::VectorGraphics::BytesPerFace,
      static_cast<double>(refinement.MostFaces)));
  refinement.Progress = dgg::ProgressPart(progress, EmbeddedAt, RefinedAt);
  const dgg::Status status = dgg::RefineForGraphics(mesh, refinement, refined, &this->RefinedFaces);
  if (!status.IsOk())
  {
    return status.GetCode() == dgg::Status::Code::OutOfMemory
      ? status.Fix(this->GetMemoryRemedy(), ", or raise {MemoryLimit}")
      : status;
  }
  std::vector<dgg::CurveChain> chains;
  for (std::size_t k = 0; k < count; ++k)
  {
    chains.push_back(dgg::FollowCurve(refined, joined, k));
  }
  dgg::GraphicsOptions own = options;
  own.Progress = dgg::ProgressPart(progress, RefinedAt, 1.0);
  return this->Graphics.Prepare(mesh, refined, chains, drawing.Curves, own);
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::vtkInternals::Prepare(const DGGContext& context,
  const Drawing& drawing, const dgg::GraphicsOptions& options,
  const dgg::ProgressCallback& progress)
{
  this->IsKept = false;
  this->Graphics.Clear();
  this->RefinedFaces = std::vector<dgg::Id>();
  this->Kept = Drawing();
  const dgg::Status status = this->Draw(context, drawing, options, progress);
  if (!status.IsOk())
  {
    this->Graphics.Clear();
    return status;
  }
  ++this->NumberOfFactorizations;
  this->Kept = drawing;
  for (dgg::GraphicsCurve& curve : this->Kept.Curves) // colors do not affect the factorization
  {
    curve.Left = std::vector<double>();
    curve.Right = std::vector<double>();
  }
  this->IsKept = true;
  return status;
}

//------------------------------------------------------------------------------
vtkPoissonVectorGraphics::vtkPoissonVectorGraphics()
  : CurveTypeArrayName("CurveType")
  , LeftColorArrayName("LeftColor")
  , RightColorArrayName("RightColor")
  , StrengthArrayName("Strength")
  , RightStrengthArrayName("RightStrength")
  , WidthArrayName("Width")
  , RegionStrengthArrayName("RegionStrength")
  , RefinementArrayName("Refine")
  , Width(0.0)
  , BackgroundColor{ 0.0, 0.0, 0.0 }
  , RefinementLevel(1)
  , RefinementRegion(Everywhere)
  , ProjectionTolerance(0.01)
  , IntrinsicDelaunay(true)
  , GenerateFragments(false)
  , FragmentDivision(1)
  , ResultArrayName("Colors")
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CurveTypeArrayName: " << this->CurveTypeArrayName << "\n";
  os << indent << "LeftColorArrayName: " << this->LeftColorArrayName << "\n";
  os << indent << "RightColorArrayName: " << this->RightColorArrayName << "\n";
  os << indent << "StrengthArrayName: " << this->StrengthArrayName << "\n";
  os << indent << "RightStrengthArrayName: " << this->RightStrengthArrayName << "\n";
  os << indent << "WidthArrayName: " << this->WidthArrayName << "\n";
  os << indent << "RegionArrayName: " << this->RegionArrayName << "\n";
  os << indent << "RegionStrengthArrayName: " << this->RegionStrengthArrayName << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "BackgroundColor: " << this->BackgroundColor[0] << " " << this->BackgroundColor[1]
     << " " << this->BackgroundColor[2] << "\n";
  os << indent << "RefinementLevel: " << this->RefinementLevel << "\n";
  os << indent << "RefinementRegion: " << this->GetRefinementRegionAsString() << "\n";
  os << indent << "RefinementArrayName: " << this->RefinementArrayName << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "IntrinsicDelaunay: " << (this->IntrinsicDelaunay ? "On" : "Off") << "\n";
  os << indent << "GenerateFragments: " << (this->GenerateFragments ? "On" : "Off") << "\n";
  os << indent << "FragmentDivision: " << this->FragmentDivision << "\n";
  os << indent << "ResultArrayName: " << this->ResultArrayName << "\n";
  os << indent << "NumberOfFactorizations: " << this->GetNumberOfFactorizations() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
}

//------------------------------------------------------------------------------
vtkDGGDefineInputMacro(vtkPoissonVectorGraphics, Curve, 1);

//------------------------------------------------------------------------------
DGGGraphicsNames vtkPoissonVectorGraphics::vtkInternals::GetNames() const
{
  return { this->Self->CurveTypeArrayName, this->Self->LeftColorArrayName,
    this->Self->RightColorArrayName, this->Self->StrengthArrayName,
    this->Self->RightStrengthArrayName, this->Self->WidthArrayName, this->Self->RegionArrayName,
    this->Self->RegionStrengthArrayName, this->Self->RefinementArrayName };
}

//------------------------------------------------------------------------------
const char* vtkPoissonVectorGraphics::GetRefinementRegionAsString() const
{
  static const char* const names[] = { "Everywhere", "NearCurves", "Cells" };
  return names[this->RefinementRegion];
}

//------------------------------------------------------------------------------
vtkPolyData* vtkPoissonVectorGraphics::GetFragments()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkPoissonVectorGraphics::GetNumberOfFactorizations() const
{
  return this->GetInternals().NumberOfFactorizations;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPoissonVectorGraphics::GetMemorySize() const
{
  return static_cast<vtkTypeUInt64>(this->GetInternals().Graphics.GetEstimatedMemory());
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(DGGCheckNames({ { "ResultArrayName", this->Self->ResultArrayName } }));
  if (DGGGraphicsOutput::IsTaken(this->Self->ResultArrayName))
  {
    return dgg::InvalidInput("{ResultArrayName} is '", this->Self->ResultArrayName,
      "', the name of another array of the output")
      .At("ResultArrayName")
      .Fix("Use another name");
  }
  return DGGCheckLengths(
    { { "Width", this->Self->Width }, { "ProjectionTolerance", this->Self->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const dgg::PreparedSurface& prepared = context.Surface;
  vtkPolyData* lines = vtkPolyData::GetData(inputVector[1]);
  DGGGraphicsNames names = this->GetNames();
  double bounds[6];
  context.Input->GetPoints()->GetBounds(bounds);
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  names.DefaultWidth = this->Self->Width > 0.0 ? this->Self->Width : UsualWidth * diagonal;
  DGGGraphicsInput input;
  DGG_RETURN_IF_ERROR(input.Read(lines, context.Input, names));
  const std::vector<dgg::GraphicsCurve>& curves = input.GetCurves();
  if (curves.empty() && names.Region.empty())
  {
    return dgg::InvalidInput("There is nothing to draw")
      .Fix("Connect lines to input port 1, or set {RegionArrayName}");
  }
  Drawing drawing;
  drawing.MeshBuild = prepared.GetBuildNumber();
  drawing.Curves = curves;
  drawing.Places.resize(curves.size());
  static const std::vector<vtkIdType> none;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    DGGSourceSet set{ none, lines, 1, "curve point", "", "" };
    set.PointIds = &input.GetPointIds()[k];
    DGG_RETURN_IF_ERROR(
      DGGLocate(context, set, this->Self->ProjectionTolerance, drawing.Places[k]));
  }

  DGGGraphicsOutput output(this->Self->ResultArrayName);
  DGG_RETURN_IF_ERROR(output.Take(context, this->Self->GetOutputPointsPrecision()));
  const dgg::RefinedPart parts[] = { dgg::RefinedPart::Everything, dgg::RefinedPart::AroundCurves,
    dgg::RefinedPart::Faces };
  drawing.Refinement.Levels = this->Self->RefinementLevel;
  drawing.Refinement.Part = parts[this->Self->RefinementRegion];
  if (this->Self->RefinementRegion == Cells)
  {
    DGG_RETURN_IF_ERROR(
      DGGGraphicsInput::FindRefinedFaces(context.Input, names, prepared, drawing.Refinement.Faces));
  }
  drawing.IntrinsicDelaunay = this->Self->IntrinsicDelaunay;
  dgg::GraphicsOptions options;
  options.NumberOfChannels = input.GetNumberOfChannels();
  options.Background.assign(this->Self->BackgroundColor, this->Self->BackgroundColor + 3);
  options.Background.resize(static_cast<std::size_t>(options.NumberOfChannels), 0.0);
  if (!std::all_of(options.Background.begin(), options.Background.end(),
        [](double x) { return std::isfinite(x); }))
  {
    return dgg::InvalidInput("{BackgroundColor} is not finite")
      .At("BackgroundColor")
      .Fix("Use finite numbers");
  }
  options.IntrinsicDelaunay = this->Self->IntrinsicDelaunay;
  options.CheckMemory = [&](double bytes, double missing) {
    const double points = static_cast<double>(this->Graphics.GetSurface().Points.size());
    const double own = !context.Memory.IsExplicit() ? missing : bytes;
    return context.Memory.Check("The factorization with the colors",
      own + points * output.GetBytesPerPoint(options.NumberOfChannels), this->GetMemoryRemedy());
  };
  const std::vector<dgg::GraphicsRegion> regions = input.MakeRegions(prepared);
  const bool isKept = this->IsKept && this->Kept.IsSame(drawing);
  const double preparedAt = isKept ? FoundAt : FactorizedAt;
  if (!isKept)
  {
    DGG_RETURN_IF_ERROR(this->Prepare(
      context, drawing, options, dgg::ProgressPart(context.Progress, 0.0, preparedAt)));
  }
  dgg::GraphicsResult result;
  options.Progress = dgg::ProgressPart(context.Progress, preparedAt, 1.0);
  DGG_RETURN_IF_ERROR(this->Graphics.Run(curves, regions, options, result));
  const dgg::SubMesh& cut = this->Graphics.GetSurface();
  const int channels = options.NumberOfChannels;
  if (this->Self->GenerateFragments)
  {
    // Memory as fragments and as arrays.
    const double bytes = BytesPerFragment + 2.0 * channels * sizeof(double);
    const double count = static_cast<double>(this->RefinedFaces.size()) *
      std::pow(static_cast<double>(this->Self->FragmentDivision), 2);
    DGG_RETURN_IF_ERROR(context.Memory.Check("The output of fragments", count * bytes,
      "Use a smaller {FragmentDivision}, or refine near curves only"));
  }
  output.Fill(cut, result, channels, vtkPolyData::GetData(outputVector));
  if (this->Self->GenerateFragments)
  {
    output.FillFragments(dgg::MakeFragments(prepared.GetMesh(), cut, this->RefinedFaces,
                           result.Values, channels, this->Self->FragmentDivision),
      channels, vtkPolyData::GetData(outputVector, 1));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  const DGGGraphicsOutput arrays(this->Self->ResultArrayName);
  arrays.AddColors({}, 3, output);
  arrays.AddNetSources({}, 3, output);
}
