// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGLoop.h"

#include "DGGGraphUser.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggLoopSearch.h"
#include "dggOutput.h"
#include "dggPropertyChecks.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDGGLoop);
vtkDGGDefineInputMacro(vtkDGGLoop, Point, 1);

//------------------------------------------------------------------------------
class vtkDGGLoop::vtkInternals : public DGGGraphInternalsOf<vtkDGGLoop>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* vtkNotUsed(input)) const override { return false; }
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, a larger {Accuracy} or fewer points at a time";
  }

private:
  DGGSourceSet GetPointSet(vtkInformationVector** inputVector) const;
  dgg::Status FillOutputs(const DGGContext& context, const dgg::LoopOptions& options,
    const dgg::LoopSet& loops, vtkInformationVector* outputVector);
};

vtkDGGInternalsMacro(vtkDGGLoop);
vtkDGGGraphUserMacro(vtkDGGLoop);

//------------------------------------------------------------------------------
vtkDGGLoop::vtkDGGLoop()
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkDGGLoop::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->GetModeAsString() << "\n";
  DGGPrintIds(os, indent, "PointIds", this->PointIds);
  os << indent << "Taut: " << (this->Taut ? "On" : "Off") << "\n";
  os << indent << "TapeWidth: " << this->TapeWidth << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  this->GetInternals().GraphUser.PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkDGGLoop, Mode, "ThroughPoint", "AroundHandles", "Rope");

//------------------------------------------------------------------------------
void vtkDGGLoop::RemoveAllPoints()
{
  this->RemoveAllPointIds();
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkDGGLoop::GetTape()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoop::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(
    dgg::CheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance } }));
  DGG_RETURN_IF_ERROR(dgg::CheckTapeWidth(this->Self->TapeWidth));
  return DGGGraphInternalsOf::CheckProperties();
}

//------------------------------------------------------------------------------
DGGSourceSet vtkDGGLoop::vtkInternals::GetPointSet(vtkInformationVector** inputVector) const
{
  return { this->Self->PointIds, vtkPolyData::GetData(inputVector[1]), 1, "loop point", "PointIds",
    "" };
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoop::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  dgg::LoopOptions options;
  static_assert(static_cast<int>(dgg::LoopOptions::Rope) == Rope, "modes are kinds");
  options.Kind = static_cast<dgg::LoopOptions::KindType>(this->Self->Mode);
  options.Taut = this->Self->Taut;
  options.TapeWidth = this->Self->TapeWidth;
  if (this->Self->Mode != AroundHandles)
  {
    DGG_RETURN_IF_ERROR(DGGLocate(
      context, this->GetPointSet(inputVector), this->Self->ProjectionTolerance, options.Points));
    DGG_RETURN_IF_ERROR(dgg::CheckLoopOptions(options));
    DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  }
  dgg::LoopSet loops;
  DGG_RETURN_IF_ERROR(dgg::FindLoops(context, this->GraphUser, options, loops));
  return this->FillOutputs(context, options, loops, outputVector);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoop::vtkInternals::FillOutputs(const DGGContext& context,
  const dgg::LoopOptions& options, const dgg::LoopSet& loops, vtkInformationVector* outputVector)
{
  dgg::Output curves;
  dgg::Output tapes;
  dgg::WriteLoops(context, options, loops, curves);
  dgg::WriteOffsetCurves(context, options, loops, tapes);
  DGG_RETURN_IF_ERROR(this->FillOutput(context, curves, outputVector, 0));
  return this->FillOutput(context, tapes, outputVector, 1);
}

//------------------------------------------------------------------------------
void vtkDGGLoop::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  this->FillOutputs(context, dgg::LoopOptions(), dgg::LoopSet(), outputVector);
}
