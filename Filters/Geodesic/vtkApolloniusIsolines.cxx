// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkApolloniusIsolines.h"

#include "DGGContext.h"
#include "DGGFieldInput.h"
#include "DGGFilterInternals.h"
#include "DGGIsolineOutputs.h"
#include "DGGNewGeometry.h"

#include "dggInvalidInput.h"
#include "dggProgressPart.h"

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

/// Progress weights of isolines, ridges and bands within the rest, if they are requested.
constexpr double LineWork = 1.0;
constexpr double RidgeWork = 1.0;
constexpr double BandWork = 1.5;

constexpr double RadiansPerDegree = dgg::Pi / 180.0;

/// Smallest ChordTolerance: time and memory grow without bound as the tolerance decreases.
constexpr double SmallestChordTolerance = 1e-6;

/// Results of an update.
struct Curves
{
  dgg::Isolines Lines;
  dgg::Ridges Ridges;
  dgg::Bands Bands;
};
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
    return "use a smaller mesh, fewer values or a larger ChordTolerance";
  }

private:
  std::vector<double> CopyValues() const;
  dgg::Status ReadField(const DGGContext& context, vtkDataArray* distances, DGGFieldInput& input);
  void WarnAbout(const DGGFieldInput& input, const DGGContext& context);
  void WarnAboutNoLine(const std::vector<double>& distances, const dgg::Isolines& lines);
  dgg::Status FindCurves(
    const DGGContext& context, const dgg::DistanceField& field, Curves& curves);

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
    return dgg::InvalidInput("SteinerPoints is ", this->Self->SteinerPoints,
      ": call SetSteinerPoints() with a number from 0 to ", dgg::MaximumSteinerPoints);
  }
  if (!(this->Self->ChordTolerance >= SmallestChordTolerance))
  {
    return dgg::InvalidInput("ChordTolerance is ", this->Self->ChordTolerance,
      ": call SetChordTolerance() with a number of at least ", SmallestChordTolerance);
  }
  if (!(this->Self->MinimumRidgeAngle >= 0.0 && this->Self->MinimumRidgeAngle <= 180.0))
  {
    return dgg::InvalidInput("MinimumRidgeAngle is ", this->Self->MinimumRidgeAngle,
      ": call SetMinimumRidgeAngle() with degrees from 0 to 180");
  }
  const std::vector<double> values = this->CopyValues();
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!std::isfinite(values[i]))
    {
      return dgg::InvalidInput("value ", i, " is ", values[i],
        ": call SetValue() with a finite number, or GenerateValues()");
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
  DGGNewGeometry geometry;
  DGGFieldInput input;
  Curves curves;
  DGG_RETURN_IF_ERROR(DGGFieldInput::FindDistances(
    this->Self->Information, this->Self->DistanceArrayName, context.Input, distances));
  DGG_RETURN_IF_ERROR(geometry.Take(context, this->Self->GetOutputPointsPrecision()));
  DGG_RETURN_IF_ERROR(this->ReadField(context, distances, input));
  this->WarnAbout(input, context);
  DGG_RETURN_IF_ERROR(this->FindCurves(context, input.GetField(), curves));
  this->WarnAboutNoLine(input.GetDistances(), curves.Lines);
  this->Self->UsedWindows = input.GetField().HasWindows();
  this->Self->UsedVirtualSources = input.GetField().HasSources();
  this->Self->NumberOfFallbacks = curves.Lines.Fallbacks + curves.Ridges.Fallbacks;
  const DGGIsolineOutputs outputs(geometry, DGGFieldInput::GetName(distances));
  outputs.WriteLines(curves.Lines, this->CopyValues(), vtkPolyData::GetData(outputVector, 0));
  outputs.WriteRidges(curves.Ridges, vtkPolyData::GetData(outputVector, 1));
  outputs.WriteBands(curves.Bands, vtkPolyData::GetData(outputVector, 2));
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Reads the distances and, unless Method is Linear, their windows or virtual sources.
dgg::Status vtkApolloniusIsolines::vtkInternals::ReadField(
  const DGGContext& context, vtkDataArray* distances, DGGFieldInput& input)
{
  input.SetUnreachedValue(this->Self->UnreachedValue);
  return this->Self->Method == Linear
    ? input.ReadDistances(context, distances)
    : input.Read(context, distances, this->Self->VirtualSourceArrayName,
        dgg::ProgressPart(context.Progress, 0.0, ReadingShare));
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::vtkInternals::WarnAbout(
  const DGGFieldInput& input, const DGGContext& context)
{
  this->WarnAboutQuality(input.DescribeQuality(context.Surface));
  if (!input.GetWarning().empty())
  {
    vtkWarningWithObjectMacro(this->Self, << input.GetWarning() << ".");
  }
  if (this->Self->GenerateRidges && !input.GetField().HasWindows() &&
    !input.GetField().HasSources())
  {
    vtkWarningWithObjectMacro(
      this->Self, << "there are no ridges in distances that are linear in each triangle: choose "
                     "another Method, and distances with windows or virtual sources.");
  }
  else if (this->Self->GenerateRidges && input.HasFittedSources())
  {
    vtkWarningWithObjectMacro(
      this->Self, << "ridges of virtual sources that are fitted to distances alone are not "
                     "reliable: call GenerateWindowsOn() of vtkExactGeodesicDistance, or "
                     "GenerateVirtualSourceOn() of it or of vtkDGGDistance.");
  }
}

//------------------------------------------------------------------------------
/// Warns if only lines are requested and there are none, once for consecutive updates without
/// lines: each move of a source changes the range.
void vtkApolloniusIsolines::vtkInternals::WarnAboutNoLine(
  const std::vector<double>& distances, const dgg::Isolines& lines)
{
  const bool isEmpty =
    lines.Lines.empty() && !this->Self->GenerateRidges && !this->Self->GenerateBands;
  if (isEmpty && !this->WasEmpty)
  {
    double smallest = dgg::Infinity;
    double largest = -dgg::Infinity;
    for (const double distance : distances)
    {
      smallest = std::min(smallest, distance);
      largest = distance < dgg::Infinity ? std::max(largest, distance) : largest;
    }
    if (smallest > largest)
    {
      return; // no point is reached
    }
    vtkWarningWithObjectMacro(
      this->Self, << "there are no isolines: the distances of the points are from " << smallest
                  << " to " << largest << ", and none of the values yields a line.");
  }
  this->WasEmpty = isEmpty;
}

//------------------------------------------------------------------------------
/// Finds lines and, if requested, ridges and bands.
dgg::Status vtkApolloniusIsolines::vtkInternals::FindCurves(
  const DGGContext& context, const dgg::DistanceField& field, Curves& curves)
{
  const bool isKnown = field.HasWindows() || field.HasSources(); // otherwise linear, with a warning
  const std::vector<double> values = this->CopyValues();
  dgg::IsolineOptions options;
  options.ChordTolerance = this->Self->ChordTolerance * field.Mesh->GetMeanEdgeLength();
  options.SteinerPoints = this->Self->SteinerPoints;
  options.Method = isKnown && this->Self->Method == Apollonius ? dgg::IsolineMethod::Apollonius
                                                               : dgg::IsolineMethod::LocalSources;
  dgg::RidgeOptions ridgeOptions;
  ridgeOptions.MinimumAngle = this->Self->MinimumRidgeAngle * RadiansPerDegree;
  ridgeOptions.ChordTolerance = options.ChordTolerance;
  const double work = LineWork + (this->Self->GenerateRidges ? RidgeWork : 0.0) +
    (this->Self->GenerateBands ? BandWork : 0.0);
  const double unit = (1.0 - ReadingShare) / work;
  const double atRidges = ReadingShare + LineWork * unit;
  const double atBands = atRidges + (this->Self->GenerateRidges ? RidgeWork * unit : 0.0);
  const dgg::ProgressCallback& progress = context.Progress;
  DGG_RETURN_IF_ERROR(dgg::TraceIsolines(field, values, options, context.Parallel,
    dgg::ProgressPart(progress, ReadingShare, atRidges), curves.Lines));
  if (this->Self->GenerateRidges && isKnown)
  {
    DGG_RETURN_IF_ERROR(dgg::FindRidges(field, ridgeOptions, context.Parallel,
      dgg::ProgressPart(progress, atRidges, atBands), curves.Ridges));
  }
  return this->Self->GenerateBands ? dgg::MakeBands(field, values, curves.Lines,
                                       dgg::ProgressPart(progress, atBands, 1.0), curves.Bands)
                                   : dgg::Status::Success();
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
  DGGNewGeometry geometry;
  geometry.Take(context, this->Self->GetOutputPointsPrecision());
  const DGGIsolineOutputs outputs(
    geometry, DGGFieldInput::GetName(this->Self->Information, this->Self->DistanceArrayName));
  outputs.WriteLines(dgg::Isolines(), {}, vtkPolyData::GetData(outputVector, 0));
  outputs.WriteRidges(dgg::Ridges(), vtkPolyData::GetData(outputVector, 1));
  outputs.WriteBands(dgg::Bands(), vtkPolyData::GetData(outputVector, 2));
}
