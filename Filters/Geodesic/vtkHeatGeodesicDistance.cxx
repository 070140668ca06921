// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeatGeodesicDistance.h"

#include "DGGDistanceInternals.h"

#include "dggDistanceMethods.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHeatGeodesicDistance);

//------------------------------------------------------------------------------
class vtkHeatGeodesicDistance::vtkInternals
  : public DGGInternalsOf<vtkHeatGeodesicDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override { this->Self->QualityWarning = false; }
  dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override;
  void ReportQuality(const std::string& warning) override
  {
    this->Self->QualityWarning = this->WarnAboutQuality(warning);
  }
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or vtkDGGFastMarchingDistance";
  }

  dgg::HeatOptions MakeOptions() const;

  dgg::HeatSession Session;
};

vtkDGGInternalsMacro(vtkHeatGeodesicDistance);

//------------------------------------------------------------------------------
vtkHeatGeodesicDistance::vtkHeatGeodesicDistance()
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkHeatGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeStepFactor: " << this->TimeStepFactor << "\n";
  os << indent << "IntrinsicDelaunay: " << (this->IntrinsicDelaunay ? "On" : "Off") << "\n";
  os << indent << "Boundary: " << this->GetBoundaryAsString() << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
  os << indent << "NumberOfFactorizations: " << this->GetNumberOfFactorizations() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkHeatGeodesicDistance, Boundary, "Neumann", "Dirichlet", "Average");

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkHeatGeodesicDistance, vtkTypeUInt64, MemorySize, Session.GetMemorySize());
vtkDGGResultMacro(
  vtkHeatGeodesicDistance, int, NumberOfFactorizations, Session.GetNumberOfFactorizations());

//------------------------------------------------------------------------------
dgg::HeatOptions vtkHeatGeodesicDistance::vtkInternals::MakeOptions() const
{
  const dgg::HeatBoundary boundaries[] = { dgg::HeatBoundary::Neumann, dgg::HeatBoundary::Dirichlet,
    dgg::HeatBoundary::Average };
  dgg::HeatOptions options;
  options.TimeStepFactor = this->Self->TimeStepFactor;
  options.IntrinsicDelaunay = this->Self->IntrinsicDelaunay;
  options.Boundary = boundaries[this->Self->Boundary];
  return options;
}

//------------------------------------------------------------------------------
dgg::Status vtkHeatGeodesicDistance::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(dgg::HeatMethod::Check(this->MakeOptions()));
  return DGGDistanceInternals::CheckProperties();
}

//------------------------------------------------------------------------------
dgg::Status vtkHeatGeodesicDistance::vtkInternals::ComputeDistances(
  const DGGContext& context, dgg::DistanceTask& task)
{
  return this->Session.Run(context, this->MakeOptions(), this->GetMemoryRemedy(), task);
}
