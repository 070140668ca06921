// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGDistance.h"

#include "DGGDistanceInternals.h"
#include "DGGGraphUser.h"

#include "dggGraphDistances.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDGGDistance);

//------------------------------------------------------------------------------
class vtkDGGDistance::vtkInternals
  : public DGGGraphInternalsOf<vtkDGGDistance, DGGDistanceInternals>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override;
  std::vector<dgg::VertexArray> DeclareArrays() const override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, a larger {Accuracy} or a {MaximumDistance}";
  }
};

vtkDGGInternalsMacro(vtkDGGDistance);
vtkDGGGraphUserMacro(vtkDGGDistance);

//------------------------------------------------------------------------------
vtkDGGDistance::vtkDGGDistance()
  : Correction(true)
  , Search(Certified)
  , GenerateUpperBound(false)
  , UpperBoundArrayName("GeodesicUpperBound")
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkDGGDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->GetInternals().GraphUser.PrintSelf(os, indent);
  os << indent << "Correction: " << (this->Correction ? "On" : "Off") << "\n";
  os << indent << "Search: " << this->GetSearchAsString() << "\n";
  os << indent << "GenerateUpperBound: " << (this->GenerateUpperBound ? "On" : "Off") << "\n";
  os << indent << "UpperBoundArrayName: " << this->UpperBoundArrayName << "\n";
}

//------------------------------------------------------------------------------
const char* vtkDGGDistance::GetSearchAsString() const
{
  static const char* const names[] = { "Certified", "LabelCorrecting", "Dijkstra" };
  return names[this->Search];
}

//------------------------------------------------------------------------------
std::vector<dgg::VertexArray> vtkDGGDistance::vtkInternals::DeclareArrays() const
{
  if (!this->Self->GenerateUpperBound)
  {
    return {};
  }
  return { { this->Self->UpperBoundArrayName, "UpperBoundArrayName",
    std::vector<std::vector<double>>(1) } };
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::vtkInternals::ComputeDistances(
  const DGGContext& context, dgg::DistanceTask& task)
{
  const dgg::SearchMethod methods[] = { dgg::SearchMethod::Certified,
    dgg::SearchMethod::LabelCorrecting, dgg::SearchMethod::Dijkstra };
  DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  return dgg::FindGraphDistances(
    context, this->GraphUser, methods[this->Self->Search], this->Self->Correction, task);
}
