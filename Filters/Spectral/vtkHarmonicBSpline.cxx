// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHarmonicBSpline.h"

#include "DGGSources.h"
#include "DGGSpectralInternals.h"
#include "DGGSurfaceArrays.h"

#include "dggPropertyChecks.h"
#include "dggSplineTask.h"
#include "dggStatus.h"

#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHarmonicBSpline);

//------------------------------------------------------------------------------
class vtkHarmonicBSpline::vtkInternals
  : public DGGInternalsOf<vtkHarmonicBSpline, DGGSpectralInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override { this->Task.Forget(); }
  dgg::SpectralTask& PrepareTask(vtkPolyData* surface, const DGGSourceSet& sources) override;

  dgg::SplineTask Task;
};

vtkDGGInternalsMacro(vtkHarmonicBSpline);

//------------------------------------------------------------------------------
vtkHarmonicBSpline::vtkHarmonicBSpline()
  : vtkSpectralAlgorithm("HarmonicBSpline")
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkHarmonicBSpline::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Order: " << this->GetOrderAsString() << "\n";
  os << indent << "NumberOfSites: " << this->NumberOfSites << "\n";
  os << indent << "RightHandSideArrayName: " << this->RightHandSideArrayName << "\n";
  os << indent << "RightHandSideMeaning: " << this->GetRightHandSideMeaningAsString() << "\n";
  os << indent << "CellArrayName: " << this->CellArrayName << "\n";
  os << indent << "SolutionArrayName: " << this->SolutionArrayName << "\n";
  os << indent << "SiteValuesArrayName: " << this->SiteValuesArrayName << "\n";
  os << indent << "InterpolationArrayName: " << this->InterpolationArrayName << "\n";
  os << indent << "GenerateBasis: " << (this->GenerateBasis ? "On" : "Off") << "\n";
  os << indent << "SmoothEvaluation: " << (this->SmoothEvaluation ? "On" : "Off") << "\n";
  os << indent << "NumberOfUsedSites: " << this->GetNumberOfUsedSites() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHarmonicBSpline::GetOrderAsString() const
{
  return this->Order == Biharmonic ? "Biharmonic" : "Harmonic";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkHarmonicBSpline, RightHandSideMeaning, "Density", "Integrated");

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkHarmonicBSpline, vtkIdType, NumberOfUsedSites, Task.GetUsedSites().size());

//------------------------------------------------------------------------------
vtkIdType vtkHarmonicBSpline::GetUsedSite(vtkIdType site) const
{
  return site >= 0 && site < this->GetNumberOfUsedSites()
    ? this->GetInternals().Task.GetUsedSites()[site]
    : -1;
}

//------------------------------------------------------------------------------
dgg::Status vtkHarmonicBSpline::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(DGGSpectralInternals::CheckProperties());
  return dgg::SplineTask::CheckNames(this->Self->GetResultArrayName(), this->Self->CellArrayName,
    this->Self->SolutionArrayName, this->Self->InterpolationArrayName);
}

//------------------------------------------------------------------------------
dgg::SpectralTask& vtkHarmonicBSpline::vtkInternals::PrepareTask(
  vtkPolyData* surface, const DGGSourceSet& sources)
{
  const std::string& values = this->Self->SiteValuesArrayName;
  dgg::SplineTask& task = this->Task;
  task.IsBiharmonic = this->Self->Order == Biharmonic;
  task.WantResult = this->Self->GenerateBasis;
  task.IsSmooth = this->Self->SmoothEvaluation;
  task.IsDensity = this->Self->RightHandSideMeaning == Density;
  task.NumberOfSites = this->Self->NumberOfSites;
  task.CellName = this->Self->CellArrayName;
  task.SolutionName = this->Self->SolutionArrayName;
  task.InterpolationName = this->Self->InterpolationArrayName;
  task.RightHandSide = DGGReadArray(surface->GetPointData(), this->Self->RightHandSideArrayName);
  task.SurfaceValues = DGGReadArray(surface->GetPointData(), values);
  task.PointValues =
    DGGReadArray(sources.Points ? sources.Points->GetPointData() : nullptr, values);
  task.GivenIds.assign(sources.Ids.begin(), sources.Ids.end());
  task.NumberOfGivenPoints = static_cast<dgg::Offset>(sources.CountPoints());
  return task;
}
