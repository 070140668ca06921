// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkApolloniusIsolines.h"

#include "DGGContext.h"
#include "DGGFieldInput.h"
#include "DGGFilterInternals.h"
#include "DGGPieceField.h"

#include "dggFieldReader.h"
#include "dggIsolineTask.h"
#include "dggOutput.h"
#include "dggProcessGroup.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkApolloniusIsolines);

namespace
{
/// Progress weight of reading windows and virtual sources.
constexpr double ReadingShare = 0.4;
}

//------------------------------------------------------------------------------
class vtkApolloniusIsolines::vtkInternals : public DGGInternalsOf<vtkApolloniusIsolines>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool CanDistribute() const override { return this->Self->Method != Apollonius; }
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, fewer values or a larger {ChordTolerance}";
  }

private:
  dgg::IsolineTaskOptions MakeOptions() const;
  void WarnAboutNoLine(const std::string& warning);
  dgg::Status FillOutputs(const DGGContext& context, const std::vector<double>& values,
    const dgg::IsolineResult& result, const std::string& distances,
    vtkInformationVector* outputVector, const dgg::PieceSurface* piece = nullptr);

  bool WasEmpty = false; // true if the last update had no line and no other output
  DGGPieceField PieceField;
};

//------------------------------------------------------------------------------
vtkApolloniusIsolines::vtkApolloniusIsolines()
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
vtkApolloniusIsolines::~vtkApolloniusIsolines() = default;

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "ChordTolerance: " << this->ChordTolerance << "\n";
  os << indent << "GenerateRidges: " << (this->GenerateRidges ? "On" : "Off") << "\n";
  os << indent << "GenerateBands: " << (this->GenerateBands ? "On" : "Off") << "\n";
  os << indent << "MinimumRidgeAngle: " << this->MinimumRidgeAngle << "\n";
  os << indent << "SteinerPoints: " << this->SteinerPoints << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "VirtualSourceArrayName: " << this->VirtualSourceArrayName << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "UsedWindows: " << (this->UsedWindows ? "Yes" : "No") << "\n";
  os << indent << "UsedVirtualSources: " << (this->UsedVirtualSources ? "Yes" : "No") << "\n";
  os << indent << "NumberOfFallbacks: " << this->NumberOfFallbacks << "\n";
  os << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::SetValue(int i, double value)
{
  // vtkContourValues does not initialize values that it skips.
  for (int gap = this->ContourValues->GetNumberOfContours(); gap < i; ++gap)
  {
    this->ContourValues->SetValue(gap, 0.0);
  }
  this->ContourValues->SetValue(i, value);
}

//------------------------------------------------------------------------------
double vtkApolloniusIsolines::GetValue(int i)
{
  return this->ContourValues->GetValue(i);
}

//------------------------------------------------------------------------------
double* vtkApolloniusIsolines::GetValues()
{
  return this->ContourValues->GetValues();
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::GetValues(double* contourValues)
{
  this->ContourValues->GetValues(contourValues);
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::SetNumberOfContours(int number)
{
  if (number > this->ContourValues->GetNumberOfContours())
  {
    this->SetValue(number - 1, 0.0);
  }
  this->ContourValues->SetNumberOfContours(number);
}

//------------------------------------------------------------------------------
vtkIdType vtkApolloniusIsolines::GetNumberOfContours()
{
  return this->ContourValues->GetNumberOfContours();
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::GenerateValues(int numContours, double range[2])
{
  this->ContourValues->GenerateValues(numContours, range);
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::GenerateValues(int numContours, double rangeStart, double rangeEnd)
{
  this->ContourValues->GenerateValues(numContours, rangeStart, rangeEnd);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkApolloniusIsolines::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->ContourValues->GetMTime());
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkApolloniusIsolines, Method, "LocalSources", "Apollonius", "Linear");

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::vtkInternals::CheckProperties() const
{
  return this->MakeOptions().Check();
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::vtkInternals::ForgetResults()
{
  this->Self->UsedWindows = false;
  this->Self->UsedVirtualSources = false;
  this->Self->NumberOfFallbacks = 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::vtkInternals::Execute(const DGGContext& context,
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkDataArray* distances = nullptr;
  dgg::FieldReader reader(context.Surface);
  dgg::IsolineResult result;
  DGG_RETURN_IF_ERROR(DGGFindDistances(
    this->Self->Information, this->Self->DistanceArrayName, context.Input, distances));
  DGG_RETURN_IF_ERROR(DGGReadField(context, distances, this->Self->UnreachedValue,
    this->Self->Method == Linear ? nullptr : this->Self->VirtualSourceArrayName.c_str(),
    dgg::ProgressPart(context.Progress, 0.0, ReadingShare), reader));
  const dgg::IsolineTaskOptions options = this->MakeOptions();
  this->WarnAboutQuality(reader.DescribeQuality());
  this->Warn(reader.GetWarnings());
  this->Warn(dgg::DescribeRidges(options, reader));
  const dgg::DistanceField& field = reader.GetField();
  DGG_RETURN_IF_ERROR(dgg::FindIsolines(
    context, field, options, dgg::ProgressPart(context.Progress, ReadingShare, 1.0), result));
  this->WarnAboutNoLine(
    dgg::DescribeMissingLines(options, reader.FindRange(), !result.Lines.Lines.empty()));
  this->Self->UsedWindows = field.HasWindows();
  this->Self->UsedVirtualSources = field.HasSources();
  this->Self->NumberOfFallbacks = result.Lines.Fallbacks + result.Ridges.Fallbacks;
  return this->FillOutputs(
    context, options.Values, result, DGGGetDistanceName(distances), outputVector);
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::vtkInternals::ExecutePiece(
  const DGGContext& context, const DGGPieceUpdate& update, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  struct
  {
    double ChordTolerance;
    double MinimumRidgeAngle;
    double UnreachedValue;
    bool IsLinear;
    bool WithRidges;
    bool WithBands;
  } first{ this->Self->ChordTolerance, this->Self->MinimumRidgeAngle, this->Self->UnreachedValue,
    this->Self->Method == Linear, this->Self->GenerateRidges, this->Self->GenerateBands };
  dgg::IsolineTaskOptions options = this->MakeOptions();
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(first));
  DGG_RETURN_IF_ERROR(group.TakeListFromFirst(options.Values));
  DGG_RETURN_IF_ERROR(this->PieceField.Update(context, update, this->Self->Information,
    { this->Self->DistanceArrayName, this->Self->VirtualSourceArrayName, first.IsLinear,
      first.UnreachedValue },
    isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  options.ChordTolerance = first.ChordTolerance;
  options.MinimumRidgeAngle = first.MinimumRidgeAngle;
  options.WithRidges = first.WithRidges && !first.IsLinear;
  options.WithBands = first.WithBands;
  const DGGContext onPiece = this->PieceField.MakeContext(context);
  const dgg::DistanceField field = this->PieceField.GetField();
  dgg::IsolineResult result;
  dgg::FieldPieces pieces = this->PieceField.GetSurface().MakeFieldPieces(group);
  DGG_RETURN_IF_ERROR(dgg::FindIsolines(onPiece, field, options,
    dgg::ProgressPart(context.Progress, ReadingShare, 1.0), result, &pieces));
  options.WithRidges = first.WithRidges;
  if (group.Here == 0 && first.IsLinear)
  {
    this->Warn(dgg::DescribeRidges(options, this->PieceField.GetReader()));
  }
  std::string warning;
  DGG_RETURN_IF_ERROR(dgg::DescribeMissingLines(group, options,
    this->PieceField.GetReader().FindRange(), !result.Lines.Lines.empty(), warning));
  this->WarnAboutNoLine(warning);
  this->Self->UsedVirtualSources = !first.IsLinear;
  this->Self->NumberOfFallbacks = result.Lines.Fallbacks + result.Ridges.Fallbacks;
  return this->FillOutputs(onPiece, options.Values, result, this->PieceField.GetName(),
    update.Outputs, &this->PieceField.GetSurface());
}

//------------------------------------------------------------------------------
dgg::IsolineTaskOptions vtkApolloniusIsolines::vtkInternals::MakeOptions() const
{
  dgg::IsolineTaskOptions options;
  for (int i = 0; i < this->Self->ContourValues->GetNumberOfContours(); ++i)
  {
    options.Values.push_back(this->Self->ContourValues->GetValue(i));
  }
  options.ChordTolerance = this->Self->ChordTolerance;
  options.Method = this->Self->Method == Apollonius ? dgg::IsolineMethod::Apollonius
                                                    : dgg::IsolineMethod::LocalSources;
  options.SteinerPoints = this->Self->SteinerPoints;
  options.WithRidges = this->Self->GenerateRidges;
  options.MinimumRidgeAngle = this->Self->MinimumRidgeAngle;
  options.WithBands = this->Self->GenerateBands;
  return options;
}

//------------------------------------------------------------------------------
/// Writes the outputs. `piece` is null if the surface of the context is the input.
dgg::Status vtkApolloniusIsolines::vtkInternals::FillOutputs(const DGGContext& context,
  const std::vector<double>& values, const dgg::IsolineResult& result, const std::string& distances,
  vtkInformationVector* outputVector, const dgg::PieceSurface* piece)
{
  dgg::Output outputs[3];
  dgg::WriteIsolines(context, result, values, distances, outputs);
  for (int port = 0; port < 3; ++port)
  {
    if (piece)
    {
      piece->Renumber(outputs[port]);
    }
    DGG_RETURN_IF_ERROR(this->FillOutput(context, outputs[port], outputVector, port));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Warns about missing lines, once for consecutive updates: each move of a source changes the
/// range.
void vtkApolloniusIsolines::vtkInternals::WarnAboutNoLine(const std::string& warning)
{
  this->Warn(this->WasEmpty ? std::string() : warning);
  this->WasEmpty = !warning.empty();
}

//------------------------------------------------------------------------------
vtkPolyData* vtkApolloniusIsolines::GetRidges()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
vtkPolyData* vtkApolloniusIsolines::GetBands()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  this->FillOutputs(context, {}, dgg::IsolineResult(),
    DGGGetDistanceName(this->Self->Information, this->Self->DistanceArrayName), outputVector);
}
