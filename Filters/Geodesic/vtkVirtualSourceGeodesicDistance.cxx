// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSourceGeodesicDistance.h"

#include "DGGDistanceInternals.h"

#include "dggMeshQuality.h"
#include "dggPropagationSession.h"

#include "vtkObjectFactory.h"

#include <utility>

vtkStandardNewMacro(vtkVirtualSourceGeodesicDistance);

//------------------------------------------------------------------------------
class vtkVirtualSourceGeodesicDistance::vtkInternals
  : public DGGInternalsOf<vtkVirtualSourceGeodesicDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  void ForgetResults() override { this->Self->QualityWarning = false; }
  dgg::Status ComputeDistances(DGGDistanceTask& task) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or the {Quality} Fast";
  }

private:
  dgg::PropagationSession Propagation;
};

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::vtkVirtualSourceGeodesicDistance()
  : Quality(Automatic)
  , QualityWarning(false)
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
const char* vtkVirtualSourceGeodesicDistance::GetQualityAsString() const
{
  static const char* const names[] = { "Automatic", "Fast", "High" };
  return names[this->Quality];
}

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::vtkInternals::ComputeDistances(DGGDistanceTask& task)
{
  dgg::PropagationOptions options;
  options.Quality = this->Self->Quality == Automatic
    ? dgg::PropagationSession::Choose(task.Context.Surface)
    : this->Self->Quality == High ? dgg::PropagationQuality::High
                                  : dgg::PropagationQuality::Fast;
  options.MaximumDistance = task.MaximumDistance;
  options.WantNearestSource = task.WantNearestSource;
  options.WantVirtualSource = task.WantVirtualSource;
  dgg::PropagationResult result;
  DGG_RETURN_IF_ERROR(this->Propagation.Run(task.Context, task.Sources, options, result));
  this->Self->QualityWarning = this->WarnAboutQuality(
    dgg::JoinReasons({ dgg::DescribeLongTriangles(task.Context.Surface, dgg::LongTrianglesMislead),
      result.IsSettled ? "" : dgg::UnsettledDistances }));
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  task.VirtualSource = std::move(result.Virtual);
  return dgg::Status::Success();
}
