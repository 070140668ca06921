// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSourceGeodesicDistance.h"

#include "DGGDistanceInternals.h"

#include "dggDistanceMethods.h"

#include "vtkObjectFactory.h"

#include <optional>

vtkStandardNewMacro(vtkVirtualSourceGeodesicDistance);

//------------------------------------------------------------------------------
class vtkVirtualSourceGeodesicDistance::vtkInternals
  : public DGGInternalsOf<vtkVirtualSourceGeodesicDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  void ForgetResults() override { this->Self->QualityWarning = false; }
  dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override;
  void ReportQuality(const std::string& warning) override
  {
    this->Self->QualityWarning = this->WarnAboutQuality(warning);
  }
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or the {Quality} Fast";
  }

private:
  dgg::PropagationSession Propagation;
};

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::vtkVirtualSourceGeodesicDistance()
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkVirtualSourceGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quality: " << this->GetQualityAsString() << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkVirtualSourceGeodesicDistance, Quality, "Automatic", "Fast", "High");

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::vtkInternals::ComputeDistances(
  const DGGContext& context, dgg::DistanceTask& task)
{
  const std::optional<dgg::PropagationQuality> qualities[] = { std::nullopt,
    dgg::PropagationQuality::Fast, dgg::PropagationQuality::High };
  return dgg::FindPropagatedDistances(
    context, this->Propagation, qualities[this->Self->Quality], task);
}
