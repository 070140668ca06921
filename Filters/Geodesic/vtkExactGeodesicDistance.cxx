// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExactGeodesicDistance.h"

#include "DGGDistanceInternals.h"

#include "dggDistanceMethods.h"
#include "dggExactGeodesics.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkExactGeodesicDistance);

//------------------------------------------------------------------------------
class vtkExactGeodesicDistance::vtkInternals
  : public DGGInternalsOf<vtkExactGeodesicDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override;
};

//------------------------------------------------------------------------------
vtkExactGeodesicDistance::vtkExactGeodesicDistance()
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkExactGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Engine: " << (this->Engine == Reference ? "Reference" : "Triangle") << "\n";
  os << indent << "GenerateWindows: " << (this->GenerateWindows ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
dgg::Status vtkExactGeodesicDistance::vtkInternals::ComputeDistances(
  const DGGContext& context, dgg::DistanceTask& task)
{
  return dgg::FindExactDistances(context,
    this->Self->Engine == Reference ? dgg::ExactEngine::Reference : dgg::ExactEngine::Triangle,
    this->Self->GenerateWindows, task);
}
