// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDiscreteGreensFunction.h"

#include "DGGSpectralInternals.h"

#include "dggGreensTask.h"
#include "dggStatus.h"

#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkDiscreteGreensFunction);

//------------------------------------------------------------------------------
class vtkDiscreteGreensFunction::vtkInternals
  : public DGGInternalsOf<vtkDiscreteGreensFunction, DGGSpectralInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override { this->Task.Forget(); }
  dgg::SpectralTask& PrepareTask(vtkPolyData*, const DGGSourceSet&) override;

  dgg::GreensTask Task;
};

vtkDGGInternalsMacro(vtkDiscreteGreensFunction);

//------------------------------------------------------------------------------
vtkDiscreteGreensFunction::vtkDiscreteGreensFunction()
  : vtkSpectralAlgorithm("GreensFunction")
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkDiscreteGreensFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->GetOrderAsString() << "\n";
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "SignConvention: " << this->GetSignConventionAsString() << "\n";
  os << indent << "PoleValue: " << this->GetPoleValueAsString() << "\n";
  os << indent << "Weighting: " << this->GetWeightingAsString() << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "InterpolateRegularPart: " << (this->InterpolateRegularPart ? "On" : "Off")
     << "\n";
  os << indent << "NumberOfColumns: " << this->GetNumberOfColumns() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkDiscreteGreensFunction::GetOrderAsString() const
{
  return this->Order == BiLaplace ? "BiLaplace" : "Laplace";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkDiscreteGreensFunction, Method, "SingularitySubtraction", "Localized",
  "Interpolated", "Vertex");
vtkDGGAsStringMacro(
  vtkDiscreteGreensFunction, SignConvention, "PositiveAtSource", "NegativeAtSource");
vtkDGGAsStringMacro(vtkDiscreteGreensFunction, PoleValue, "CellAverage", "Infinite");
vtkDGGAsStringMacro(vtkDiscreteGreensFunction, Weighting, "Area", "Uniform");

//------------------------------------------------------------------------------
int vtkDiscreteGreensFunction::GetUsedMethod(vtkIdType source) const
{
  return this->GetInternals().Task.GetUsed(source).Method;
}

//------------------------------------------------------------------------------
double vtkDiscreteGreensFunction::GetUsedRadius(vtkIdType source) const
{
  return this->GetInternals().Task.GetUsed(source).Radius;
}

//------------------------------------------------------------------------------
bool vtkDiscreteGreensFunction::IsNearRidge(vtkIdType source) const
{
  return this->GetInternals().Task.GetUsed(source).Remark == dgg::GreensRemark::NearRidge;
}

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkDiscreteGreensFunction, vtkIdType, NumberOfColumns, Task.GetNumberOfColumns());

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDiscreteGreensFunction::GetMemorySize() const
{
  return this->Superclass::GetMemorySize() + this->GetInternals().Task.GetMemorySize();
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGreensFunction::vtkInternals::CheckProperties() const
{
  if (!(this->Self->Radius >= 0.0) || !std::isfinite(this->Self->Radius))
  {
    return dgg::InvalidValue("Radius", this->Self->Radius)
      .Fix("Use a positive number, or 0 for the default");
  }
  return DGGSpectralInternals::CheckProperties();
}

//------------------------------------------------------------------------------
dgg::SpectralTask& vtkDiscreteGreensFunction::vtkInternals::PrepareTask(
  vtkPolyData*, const DGGSourceSet&)
{
  const dgg::GreensMethod methods[] = { dgg::GreensMethod::SingularitySubtraction,
    dgg::GreensMethod::Localized, dgg::GreensMethod::Interpolated, dgg::GreensMethod::Vertex };
  dgg::GreensQuery& query = this->Task.Query;
  query.Method = methods[this->Self->Method];
  query.Order =
    this->Self->Order == BiLaplace ? dgg::GreensOrder::BiLaplace : dgg::GreensOrder::Laplace;
  query.Sign = this->Self->SignConvention == NegativeAtSource ? dgg::GreensSign::Negative
                                                              : dgg::GreensSign::Positive;
  query.Pole = this->Self->PoleValue == InfiniteValue ? dgg::GreensPole::Infinite
                                                      : dgg::GreensPole::CellAverage;
  query.Radius = this->Self->Radius;
  this->Task.IsInterpolated =
    this->Self->InterpolateRegularPart && this->Self->Method == SingularitySubtraction;
  this->Task.Poisson.Weights =
    this->Self->Weighting == Uniform ? dgg::PoissonWeights::Uniform : dgg::PoissonWeights::Area;
  return this->Task;
}
