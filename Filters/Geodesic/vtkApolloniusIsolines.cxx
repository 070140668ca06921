// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkApolloniusIsolines.h"

#include "DGGContext.h"
#include "DGGFieldInput.h"
#include "DGGFilterInternals.h"

#include "dggFieldReader.h"
#include "dggIsolineTask.h"
#include "dggOutput.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkApolloniusIsolines);

namespace
{
/// Progress weight of reading windows and virtual sources.
constexpr double ReadingShare = 0.4;

constexpr double RadiansPerDegree = dgg::Pi / 180.0;

/// Smallest ChordTolerance: time and memory grow without bound as the tolerance decreases.
constexpr double SmallestChordTolerance = 1e-6;
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
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, fewer values or a larger {ChordTolerance}";
  }

private:
  std::vector<double> CopyValues() const;
  dgg::IsolineTaskOptions MakeOptions(const dgg::DistanceField& field) const;
  void WarnAbout(const dgg::FieldReader& reader);
  void WarnAboutNoLine(const dgg::FieldReader& reader, const dgg::Isolines& lines);
  dgg::Status FillOutputs(const DGGContext& context, const std::vector<double>& values,
    const dgg::IsolineResult& result, const std::string& distances,
    vtkInformationVector* outputVector);

  bool WasEmpty = false; // true if the last update had no line and no other output
};

//------------------------------------------------------------------------------
vtkApolloniusIsolines::vtkApolloniusIsolines()
  : Method(LocalSources)
  , ChordTolerance(1e-3)
  , GenerateRidges(false)
  , GenerateBands(false)
  , MinimumRidgeAngle(20.0)
  , SteinerPoints(2)
  , DistanceArrayName("GeodesicDistance")
  , VirtualSourceArrayName("GeodesicVirtualSource")
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
  , UsedWindows(false)
  , UsedVirtualSources(false)
  , NumberOfFallbacks(0)
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
const char* vtkApolloniusIsolines::GetMethodAsString() const
{
  return this->Method == Apollonius ? "Apollonius"
    : this->Method == Linear        ? "Linear"
                                    : "LocalSources";
}

//------------------------------------------------------------------------------
std::vector<double> vtkApolloniusIsolines::vtkInternals::CopyValues() const
{
  const int count = this->Self->ContourValues->GetNumberOfContours();
  std::vector<double> values(std::max(0, count));
  for (int i = 0; i < count; ++i)
  {
    values[i] = this->Self->ContourValues->GetValue(i);
  }
  return values;
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::vtkInternals::CheckProperties() const
{
  if (this->Self->SteinerPoints < 0 || this->Self->SteinerPoints > dgg::MaximumSteinerPoints)
  {
    return dgg::InvalidValue("SteinerPoints", this->Self->SteinerPoints)
      .Fix("Use a number from 0 to ", dgg::MaximumSteinerPoints);
  }
  if (!(this->Self->ChordTolerance >= SmallestChordTolerance))
  {
    return dgg::InvalidValue("ChordTolerance", this->Self->ChordTolerance)
      .Fix("Use a number of at least ", SmallestChordTolerance);
  }
  if (!(this->Self->MinimumRidgeAngle >= 0.0 && this->Self->MinimumRidgeAngle <= 180.0))
  {
    return dgg::InvalidValue("MinimumRidgeAngle", this->Self->MinimumRidgeAngle)
      .Fix("Use degrees from 0 to 180");
  }
  const std::vector<double> values = this->CopyValues();
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!std::isfinite(values[i]))
    {
      return dgg::InvalidInput("Value ", i, " is ", values[i])
        .At("Values", static_cast<dgg::Offset>(i))
        .Fix("Use a finite number");
    }
  }
  return dgg::Status::Success();
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
  this->WarnAbout(reader);
  const dgg::DistanceField& field = reader.GetField();
  const dgg::IsolineTaskOptions options = this->MakeOptions(field);
  DGG_RETURN_IF_ERROR(dgg::FindIsolines(
    context, field, options, dgg::ProgressPart(context.Progress, ReadingShare, 1.0), result));
  this->WarnAboutNoLine(reader, result.Lines);
  this->Self->UsedWindows = field.HasWindows();
  this->Self->UsedVirtualSources = field.HasSources();
  this->Self->NumberOfFallbacks = result.Lines.Fallbacks + result.Ridges.Fallbacks;
  return this->FillOutputs(
    context, options.Values, result, DGGGetDistanceName(distances), outputVector);
}

//------------------------------------------------------------------------------
dgg::IsolineTaskOptions vtkApolloniusIsolines::vtkInternals::MakeOptions(
  const dgg::DistanceField& field) const
{
  const bool isKnown = field.HasWindows() || field.HasSources(); // otherwise linear, with a warning
  dgg::IsolineTaskOptions options;
  options.Values = this->CopyValues();
  options.Lines.ChordTolerance = this->Self->ChordTolerance * field.Mesh->GetMeanEdgeLength();
  options.Lines.SteinerPoints = this->Self->SteinerPoints;
  options.Lines.Method = isKnown && this->Self->Method == Apollonius
    ? dgg::IsolineMethod::Apollonius
    : dgg::IsolineMethod::LocalSources;
  options.Ridges.MinimumAngle = this->Self->MinimumRidgeAngle * RadiansPerDegree;
  options.Ridges.ChordTolerance = options.Lines.ChordTolerance;
  options.WithRidges = this->Self->GenerateRidges;
  options.WithBands = this->Self->GenerateBands;
  return options;
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::vtkInternals::FillOutputs(const DGGContext& context,
  const std::vector<double>& values, const dgg::IsolineResult& result, const std::string& distances,
  vtkInformationVector* outputVector)
{
  dgg::Output outputs[3];
  dgg::WriteIsolines(context, result.Lines, values, outputs[0]);
  dgg::WriteRidges(context, result.Ridges, outputs[1]);
  dgg::WriteBands(context, result.Bands, distances, outputs[2]);
  for (int port = 0; port < 3; ++port)
  {
    DGG_RETURN_IF_ERROR(this->FillOutput(context, outputs[port], outputVector, port));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::vtkInternals::WarnAbout(const dgg::FieldReader& reader)
{
  this->WarnAboutQuality(reader.DescribeQuality());
  this->Warn(reader.GetWarnings());
  if (this->Self->GenerateRidges && !reader.GetField().HasWindows() &&
    !reader.GetField().HasSources())
  {
    this->Warn("There are no ridges in distances that are linear in each triangle. Use another "
               "{Method}, and distances with windows or virtual sources");
  }
  else if (this->Self->GenerateRidges && reader.HasFittedSources())
  {
    this->Warn("Ridges of virtual sources that are fitted to distances alone are not reliable. "
               "Turn on {GenerateWindows} or {GenerateVirtualSource} of the distance filter");
  }
}

//------------------------------------------------------------------------------
/// Warns if only lines are requested and there are none, once for consecutive updates without
/// lines: each move of a source changes the range.
void vtkApolloniusIsolines::vtkInternals::WarnAboutNoLine(
  const dgg::FieldReader& reader, const dgg::Isolines& lines)
{
  const bool isEmpty =
    lines.Lines.empty() && !this->Self->GenerateRidges && !this->Self->GenerateBands;
  if (isEmpty && !this->WasEmpty)
  {
    const auto [smallest, largest] = reader.FindRange();
    if (smallest > largest)
    {
      return; // no point is reached
    }
    this->Warn(dgg::JoinText("There are no isolines: the distances of the points are from ",
      smallest, " to ", largest, ", and none of the values yields a line"));
  }
  this->WasEmpty = isEmpty;
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
