// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBiharmonicDistance.h"

#include "DGGSpectralInternals.h"

#include "dggSpectralDistanceTask.h"
#include "dggStatus.h"

#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkBiharmonicDistance);

//------------------------------------------------------------------------------
class vtkBiharmonicDistance::vtkInternals
  : public DGGInternalsOf<vtkBiharmonicDistance, DGGSpectralInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::SpectralTask& PrepareTask(vtkPolyData*, const DGGSourceSet&) override;

  dgg::SpectralDistanceTask Task;
};

vtkDGGInternalsMacro(vtkBiharmonicDistance);

//------------------------------------------------------------------------------
vtkBiharmonicDistance::vtkBiharmonicDistance()
  : vtkSpectralAlgorithm("BiharmonicDistance")
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkBiharmonicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->GetKindAsString() << "\n";
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "NumberOfEigenvalues: " << this->NumberOfEigenvalues << "\n";
  os << indent << "DiffusionTime: " << this->DiffusionTime << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "NumberOfSpectra: " << this->GetNumberOfSpectra() << "\n";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkBiharmonicDistance, Kind, "Biharmonic", "CommuteTime", "Diffusion");
vtkDGGAsStringMacro(vtkBiharmonicDistance, Method, "Spectrum", "Exact");

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkBiharmonicDistance, int, NumberOfSpectra, Task.GetNumberOfSpectra());

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkBiharmonicDistance::GetMemorySize() const
{
  return this->Superclass::GetMemorySize() + this->GetInternals().Task.GetMemorySize();
}

//------------------------------------------------------------------------------
dgg::Status vtkBiharmonicDistance::vtkInternals::CheckProperties() const
{
  if (this->Self->Kind == Diffusion && this->Self->Method == Exact)
  {
    return dgg::InvalidInput("Diffusion distances need eigenvalues")
      .At("Method")
      .Fix("Set {Method} to Spectrum");
  }
  if (!(this->Self->DiffusionTime >= 0.0) || !std::isfinite(this->Self->DiffusionTime))
  {
    return dgg::InvalidValue("DiffusionTime", this->Self->DiffusionTime)
      .Fix("Use a positive number, or 0 for the default");
  }
  if (this->Self->NumberOfEigenvalues < 1)
  {
    return dgg::InvalidValue("NumberOfEigenvalues", this->Self->NumberOfEigenvalues)
      .Fix("Use a positive number, such as 150");
  }
  return DGGSpectralInternals::CheckProperties();
}

//------------------------------------------------------------------------------
dgg::SpectralTask& vtkBiharmonicDistance::vtkInternals::PrepareTask(
  vtkPolyData*, const DGGSourceSet&)
{
  const dgg::SpectralKind kinds[] = { dgg::SpectralKind::Biharmonic, dgg::SpectralKind::CommuteTime,
    dgg::SpectralKind::Diffusion };
  this->Task.Options.Kind = kinds[this->Self->Kind];
  this->Task.Options.Method =
    this->Self->Method == Exact ? dgg::SpectralMethod::Exact : dgg::SpectralMethod::Spectrum;
  this->Task.Options.NumberOfEigenvalues = this->Self->NumberOfEigenvalues;
  this->Task.Options.Time = this->Self->DiffusionTime;
  this->Task.UnreachedValue = this->Self->UnreachedValue;
  return this->Task;
}
