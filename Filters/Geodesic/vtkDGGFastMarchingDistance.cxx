// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGFastMarchingDistance.h"

#include "DGGDistanceInternals.h"

#include "dggDistanceMethods.h"
#include "dggFastMarching.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDGGFastMarchingDistance);

//------------------------------------------------------------------------------
class vtkDGGFastMarchingDistance::vtkInternals
  : public DGGInternalsOf<vtkDGGFastMarchingDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  bool IsCloud(vtkPolyData* input) const override;
  std::string GetMemoryRemedy() const override
  {
    return DGGDistanceInternals::GetMemoryRemedy() + ", or on a cloud a smaller {Resolution}";
  }
  void ForgetResults() override;
  dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override;
  void ReportQuality(const std::string& warning) override
  {
    this->Self->QualityWarning = this->WarnAboutQuality(warning);
  }

  ///@{
  /// Median radius of balls, in voxels, and resolution of the band of the last update.
  double UsedBandRadius = 0.0;
  int UsedResolution = 0;
  ///@}

private:
  dgg::BandOptions MakeBand() const;

  dgg::MarchingSession Session;
};

vtkDGGInternalsMacro(vtkDGGFastMarchingDistance);

//------------------------------------------------------------------------------
vtkDGGFastMarchingDistance::vtkDGGFastMarchingDistance()
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkDGGFastMarchingDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FrontShape: " << this->GetFrontShapeAsString() << "\n";
  os << indent << "BandRadius: " << this->BandRadius << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "UsedBandRadius: " << this->GetUsedBandRadius() << "\n";
  os << indent << "UsedResolution: " << this->GetUsedResolution() << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkDGGFastMarchingDistance, FrontShape, "Spherical", "Planar");

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkDGGFastMarchingDistance, double, UsedBandRadius, UsedBandRadius);
vtkDGGResultMacro(vtkDGGFastMarchingDistance, int, UsedResolution, UsedResolution);

//------------------------------------------------------------------------------
bool vtkDGGFastMarchingDistance::vtkInternals::IsCloud(vtkPolyData* input) const
{
  return input->GetNumberOfPoints() > 0 &&
    input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0;
}

//------------------------------------------------------------------------------
dgg::BandOptions vtkDGGFastMarchingDistance::vtkInternals::MakeBand() const
{
  dgg::BandOptions band;
  band.OffsetInVoxels = this->Self->BandRadius;
  band.Resolution = this->Self->Resolution;
  return band;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(dgg::MarchingSession::Check(this->MakeBand()));
  return DGGDistanceInternals::CheckProperties();
}

//------------------------------------------------------------------------------
void vtkDGGFastMarchingDistance::vtkInternals::ForgetResults()
{
  this->Self->QualityWarning = false;
  this->UsedBandRadius = 0.0;
  this->UsedResolution = 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFastMarchingDistance::vtkInternals::ComputeDistances(
  const DGGContext& context, dgg::DistanceTask& task)
{
  const dgg::Status status = this->Session.Run(context,
    this->Self->FrontShape == Planar ? dgg::MarchingUpdate::Planar : dgg::MarchingUpdate::Spherical,
    this->MakeBand(), task);
  if (status.IsOk())
  {
    this->UsedBandRadius = this->Session.GetBandRadius();
    this->UsedResolution = this->Session.GetResolution();
  }
  return status;
}
