// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkApolloniusIsolines.h"

#include "vtkDGGFieldInput.h"
#include "vtkDGGIsolineOutputs.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGNewGeometry.h"
#include "vtkDGGParallel.h"
#include "vtkDGGProperties.h"

#include "dggApolloniusParts.h"

#include "vtkContourValues.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkApolloniusIsolines);

namespace
{
/// Share of the progress that goes to what is known besides distances.
constexpr double ReadingShare = 0.4;

/// Of the rest, the shares of isolines, ridges and bands, where they are wanted.
constexpr double LineWork = 1.0;
constexpr double RidgeWork = 1.0;
constexpr double BandWork = 1.5;

constexpr double RadiansPerDegree = dgg::Pi / 180.0;

/// The part of a progress between two fractions of it.
dgg::ProgressCallback PartOf(const dgg::ProgressCallback& progress, double begin, double end)
{
  return [=](double fraction) { return progress(begin + (end - begin) * fraction); };
}
}

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
  , UsedWindows(false)
  , UsedVirtualSources(false)
  , NumberOfFallbacks(0)
{
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
  os << indent << "UsedWindows: " << (this->UsedWindows ? "Yes" : "No") << "\n";
  os << indent << "UsedVirtualSources: " << (this->UsedVirtualSources ? "Yes" : "No") << "\n";
  os << indent << "NumberOfFallbacks: " << this->NumberOfFallbacks << "\n";
  os << indent << "ContourValues:\n";
  this->ContourValues->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::SetValue(int i, double value)
{
  // vtkContourValues leaves anything in values that it skips.
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
void vtkApolloniusIsolines::SetDistanceArrayName(const char* name)
{
  if (vtkDGGChangeName(this->DistanceArrayName, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkApolloniusIsolines::GetDistanceArrayName() const
{
  return this->DistanceArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkApolloniusIsolines::SetVirtualSourceArrayName(const char* name)
{
  if (vtkDGGChangeName(this->VirtualSourceArrayName, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkApolloniusIsolines::GetVirtualSourceArrayName() const
{
  return this->VirtualSourceArrayName.c_str();
}

//------------------------------------------------------------------------------
std::vector<double> vtkApolloniusIsolines::CopyValues() const
{
  const int count = this->ContourValues->GetNumberOfContours();
  std::vector<double> values(std::max(0, count));
  for (int i = 0; i < count; ++i)
  {
    values[i] = this->ContourValues->GetValue(i);
  }
  return values;
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::CheckProperties() const
{
  std::ostringstream message;
  if (this->SteinerPoints < 0 || this->SteinerPoints > dgg::MaximumSteinerPoints)
  {
    message << "SteinerPoints is " << this->SteinerPoints
            << ": call SetSteinerPoints() with a number from 0 to " << dgg::MaximumSteinerPoints;
  }
  else if (!(this->ChordTolerance > 0.0))
  {
    message << "ChordTolerance is " << this->ChordTolerance
            << ": call SetChordTolerance() with a positive number";
  }
  else if (!(this->MinimumRidgeAngle >= 0.0 && this->MinimumRidgeAngle <= 180.0))
  {
    message << "MinimumRidgeAngle is " << this->MinimumRidgeAngle
            << ": call SetMinimumRidgeAngle() with degrees from 0 to 180";
  }
  const std::vector<double> values = this->CopyValues();
  for (std::size_t i = 0; i < values.size() && message.str().empty(); ++i)
  {
    if (!std::isfinite(values[i]))
    {
      message << "value " << i << " is " << values[i]
              << ": call SetValue() with a finite number, or GenerateValues()";
    }
  }
  return message.str().empty() ? dgg::Status::Success() : dgg::Status::Invalid(message.str());
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::FindDistances(
  vtkPolyData* surface, vtkDataArray*& distances) const
{
  vtkInformationVector* arrays = this->Information->Get(INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* array = arrays ? arrays->GetInformationObject(0) : nullptr;
  if (array && array->Has(vtkDataObject::FIELD_ASSOCIATION()))
  {
    const int where = array->Get(vtkDataObject::FIELD_ASSOCIATION());
    if (where != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
      where != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
    {
      return dgg::Status::Invalid("the array to process is not one of points: call "
                                  "SetInputArrayToProcess() with FIELD_ASSOCIATION_POINTS");
    }
    const char* name = array->Get(vtkDataObject::FIELD_NAME());
    return vtkDGGFieldInput::FindDistances(surface, name ? name : "", distances);
  }
  vtkPointData* data = surface->GetPointData();
  const bool isThere = data->HasArray(this->DistanceArrayName.c_str()) != 0;
  return vtkDGGFieldInput::FindDistances(
    surface, isThere || !data->GetScalars() ? this->DistanceArrayName : "", distances);
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::CheckInputs(
  vtkPolyData* surface, vtkInformationVector** vtkNotUsed(inputVector)) const
{
  vtkDataArray* distances = nullptr;
  return this->FindDistances(surface, distances);
}

//------------------------------------------------------------------------------
std::string vtkApolloniusIsolines::GetMemoryRemedy() const
{
  return "use a smaller mesh, fewer values or a larger ChordTolerance";
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::Execute(vtkPolyData* surface,
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  this->UsedWindows = false;
  this->UsedVirtualSources = false;
  this->NumberOfFallbacks = 0;
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  // Observers may change the input and the properties.
  const std::vector<double> values = this->CopyValues();
  dgg::IsolineOptions options;
  options.ChordTolerance = this->ChordTolerance * mesh.GetMesh().GetMeanEdgeLength();
  options.SteinerPoints = this->SteinerPoints;
  options.Method =
    this->Method == Apollonius ? dgg::IsolineMethod::Apollonius : dgg::IsolineMethod::LocalSources;
  dgg::RidgeOptions ridgeOptions;
  ridgeOptions.MinimumAngle = this->MinimumRidgeAngle * RadiansPerDegree;
  ridgeOptions.ChordTolerance = options.ChordTolerance;
  const bool isLinear = this->Method == Linear;
  const bool wantsRidges = this->GenerateRidges;
  const bool wantsBands = this->GenerateBands;
  vtkDataArray* distances = nullptr;
  vtkDGGFieldInput input;
  vtkDGGNewGeometry geometry;
  dgg::Status status = this->FindDistances(surface, distances);
  const std::string name = status.IsOk() && distances->GetName() ? distances->GetName() : "";
  if (status.IsOk())
  {
    status = geometry.Take(surface, mesh, this->GetOutputPointsPrecision());
  }
  if (status.IsOk())
  {
    status = isLinear
      ? input.ReadDistances(surface, distances, mesh)
      : input.Read(surface, distances, this->VirtualSourceArrayName, mesh,
          [this](double fraction) { return this->Advance(ReadingShare * fraction); });
  }
  if (!status.IsOk())
  {
    return status;
  }
  if (!input.GetWarning().empty())
  {
    vtkWarningMacro(<< input.GetWarning() << ".");
  }
  const dgg::DistanceField& field = input.GetField();
  if (!field.HasWindows() && !field.HasSources())
  {
    options.Method = dgg::IsolineMethod::LocalSources; // linear, as the warning says
  }
  const double work = LineWork + (wantsRidges ? RidgeWork : 0.0) + (wantsBands ? BandWork : 0.0);
  const double atRidges = ReadingShare + (1.0 - ReadingShare) * LineWork / work;
  const double atBands =
    wantsRidges ? atRidges + (1.0 - ReadingShare) * RidgeWork / work : atRidges;
  const dgg::ProgressCallback progress = [this](double done) { return this->Advance(done); };
  dgg::Isolines lines;
  dgg::Ridges ridges;
  dgg::Bands bands;
  status = dgg::TraceIsolines(field, values, options, vtkDGGMakeParallelFor(),
    PartOf(progress, ReadingShare, atRidges), lines);
  if (status.IsOk() && wantsRidges)
  {
    status = this->FindRidges(field, ridgeOptions, PartOf(progress, atRidges, atBands), ridges);
  }
  if (status.IsOk() && wantsBands)
  {
    status = dgg::MakeBands(field, values, lines, PartOf(progress, atBands, 1.0), bands);
  }
  if (status.IsOk())
  {
    this->UsedWindows = field.HasWindows();
    this->UsedVirtualSources = field.HasSources();
    this->NumberOfFallbacks = lines.Fallbacks + ridges.Fallbacks;
    const vtkDGGIsolineOutputs outputs(geometry, name);
    outputs.WriteLines(lines, values, vtkPolyData::GetData(outputVector, 0));
    outputs.WriteRidges(ridges, vtkPolyData::GetData(outputVector, 1));
    outputs.WriteBands(bands, vtkPolyData::GetData(outputVector, 2));
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkApolloniusIsolines::FindRidges(const dgg::DistanceField& field,
  const dgg::RidgeOptions& options, const dgg::ProgressCallback& progress, dgg::Ridges& ridges)
{
  if (!field.HasWindows() && !field.HasSources())
  {
    vtkWarningMacro(<< "there are no ridges in distances that are linear in each triangle: choose "
                       "another Method, and distances with windows or virtual sources.");
    return dgg::Status::Success();
  }
  return dgg::FindRidges(field, options, vtkDGGMakeParallelFor(), progress, ridges);
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
void vtkApolloniusIsolines::MakeEmptyOutput(
  vtkPolyData* surface, vtkInformationVector* outputVector)
{
  this->UsedWindows = false;
  this->UsedVirtualSources = false;
  this->NumberOfFallbacks = 0;
  vtkDGGNewGeometry geometry;
  geometry.Take(surface, this->GetMesh(), this->GetOutputPointsPrecision());
  const vtkDGGIsolineOutputs outputs(geometry, this->DistanceArrayName);
  outputs.WriteLines(dgg::Isolines(), {}, vtkPolyData::GetData(outputVector, 0));
  outputs.WriteRidges(dgg::Ridges(), vtkPolyData::GetData(outputVector, 1));
  outputs.WriteBands(dgg::Bands(), vtkPolyData::GetData(outputVector, 2));
}
