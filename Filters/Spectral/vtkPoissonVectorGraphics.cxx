// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPoissonVectorGraphics.h"

#include "DGGContext.h"
#include "DGGFilterInternals.h"
#include "DGGOutput.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGSurfaceArrays.h"

#include "dggGraphicsTask.h"
#include "dggPropertyChecks.h"

#include "vtkCellData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkPoissonVectorGraphics);

namespace
{
/// Reads the arrays of this name of the points and of the cells.
dgg::GraphicsArray ReadArrays(vtkPolyData* data, const std::string& name)
{
  return { DGGReadArray(data ? data->GetPointData() : nullptr, name),
    DGGReadArray(data ? data->GetCellData() : nullptr, name) };
}

/// Returns the bytes per tuple of all arrays.
double CountBytes(vtkFieldData* data, vtkIdType tuples)
{
  return tuples > 0 ? 1024.0 * data->GetActualMemorySize() / static_cast<double>(tuples) : 0.0;
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

  dgg::GraphicsTask Task;

private:
  dgg::GraphicsInput ReadInput(
    vtkPolyData* surface, vtkPolyData* lines, DGGSurfaceArrays& linesAsArrays) const;
  dgg::GraphicsSettings GetSettings(vtkPolyData* surface) const;
};

vtkDGGInternalsMacro(vtkPoissonVectorGraphics);

//------------------------------------------------------------------------------
vtkPoissonVectorGraphics::vtkPoissonVectorGraphics()
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
vtkDGGAsStringMacro(
  vtkPoissonVectorGraphics, RefinementRegion, "Everywhere", "NearCurves", "Cells");

//------------------------------------------------------------------------------
vtkPolyData* vtkPoissonVectorGraphics::GetFragments()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
vtkDGGResultMacro(
  vtkPoissonVectorGraphics, int, NumberOfFactorizations, Task.GetNumberOfFactorizations());
vtkDGGResultMacro(vtkPoissonVectorGraphics, vtkTypeUInt64, MemorySize, Task.GetEstimatedMemory());

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(dgg::GraphicsTask::CheckName(this->Self->ResultArrayName));
  return dgg::CheckLengths(
    { { "Width", this->Self->Width }, { "ProjectionTolerance", this->Self->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
/// Reads the inputs. `linesAsArrays` holds the lines.
dgg::GraphicsInput vtkPoissonVectorGraphics::vtkInternals::ReadInput(
  vtkPolyData* surface, vtkPolyData* lines, DGGSurfaceArrays& linesAsArrays) const
{
  dgg::GraphicsInput input;
  if (lines)
  {
    input.Lines = linesAsArrays.ConvertCells(lines->GetLines());
    input.FirstLine = lines->GetNumberOfVerts(); // cell ids count verts first
    input.NumberOfCells = lines->GetNumberOfCells();
    input.NumberOfPoints = lines->GetNumberOfPoints();
    input.Points = linesAsArrays.Get().Points;
  }
  input.CurveType =
    DGGReadArray(lines ? lines->GetCellData() : nullptr, this->Self->CurveTypeArrayName);
  input.LeftColor = ReadArrays(lines, this->Self->LeftColorArrayName);
  input.RightColor = ReadArrays(lines, this->Self->RightColorArrayName);
  input.Strength = ReadArrays(lines, this->Self->StrengthArrayName);
  input.RightStrength = ReadArrays(lines, this->Self->RightStrengthArrayName);
  input.Width = ReadArrays(lines, this->Self->WidthArrayName);
  input.DefaultWidth = this->Self->Width;
  vtkCellData* cells = surface->GetCellData();
  input.NumberOfSurfaceCells = surface->GetNumberOfCells();
  input.Region = DGGReadArray(cells, this->Self->RegionArrayName);
  if (!input.Region.Name.empty())
  {
    input.RegionStrength = DGGReadArray(cells, this->Self->RegionStrengthArrayName);
  }
  input.WantRefinement = this->Self->RefinementRegion == Cells;
  if (input.WantRefinement)
  {
    input.Refinement = DGGReadArray(cells, this->Self->RefinementArrayName);
  }
  return input;
}

//------------------------------------------------------------------------------
dgg::GraphicsSettings vtkPoissonVectorGraphics::vtkInternals::GetSettings(
  vtkPolyData* surface) const
{
  const dgg::RefinedPart parts[] = { dgg::RefinedPart::Everything, dgg::RefinedPart::AroundCurves,
    dgg::RefinedPart::Faces };
  dgg::GraphicsSettings settings;
  settings.ResultName = this->Self->ResultArrayName;
  settings.RefinementLevel = this->Self->RefinementLevel;
  settings.Refinement = parts[this->Self->RefinementRegion];
  settings.Background.assign(this->Self->BackgroundColor, this->Self->BackgroundColor + 3);
  settings.IsIntrinsicDelaunay = this->Self->IntrinsicDelaunay;
  settings.WantFragments = this->Self->GenerateFragments;
  settings.FragmentDivision = this->Self->FragmentDivision;
  settings.BytesPerPoint = CountBytes(surface->GetPointData(), surface->GetNumberOfPoints());
  settings.BytesPerCell = CountBytes(surface->GetCellData(), surface->GetNumberOfCells());
  settings.MemoryRemedy = this->GetMemoryRemedy();
  return settings;
}

//------------------------------------------------------------------------------
dgg::Status vtkPoissonVectorGraphics::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* lines = vtkPolyData::GetData(inputVector[1]);
  DGGSurfaceArrays arrays(lines, lines != nullptr, false);
  dgg::GraphicsDrawing drawing;
  DGG_RETURN_IF_ERROR(
    dgg::ReadGraphics(this->ReadInput(context.Input, lines, arrays), context.Surface, drawing));
  std::vector<dgg::SurfacePoint> places;
  if (!drawing.Points.empty())
  {
    static const std::vector<vtkIdType> none;
    const std::vector<vtkIdType> points(drawing.Points.begin(), drawing.Points.end());
    DGGSourceSet set{ none, lines, 1, "curve point", "", "" };
    set.PointIds = &points;
    DGG_RETURN_IF_ERROR(DGGLocate(context, set, this->Self->ProjectionTolerance, places));
  }
  dgg::Output outputs[2];
  DGG_RETURN_IF_ERROR(this->Task.Run(
    context, drawing, places, this->GetSettings(context.Input), outputs[0], outputs[1]));
  DGG_RETURN_IF_ERROR(this->FillOutput(context, outputs[0], outputVector));
  return this->Self->GenerateFragments ? this->FillOutput(context, outputs[1], outputVector, 1)
                                       : dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkPoissonVectorGraphics::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  dgg::Output results;
  dgg::GraphicsTask::WriteEmpty(this->Self->ResultArrayName, results);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  DGGAddArrays(results, output);
}
