// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceEarthMoversDistance.h"

#include "DGGContext.h"
#include "DGGFilterInternals.h"
#include "DGGOutput.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGSurfaceArrays.h"

#include "dggEarthMoversTask.h"
#include "dggPoissonSession.h"
#include "dggPropertyChecks.h"

#include "vtkCellData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <limits>

vtkStandardNewMacro(vtkSurfaceEarthMoversDistance);

//------------------------------------------------------------------------------
class vtkSurfaceEarthMoversDistance::vtkInternals
  : public DGGInternalsOf<vtkSurfaceEarthMoversDistance>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;

  dgg::PoissonSession Session;

private:
  dgg::Status ReadDistribution(const DGGContext& context, const std::string& arrayName,
    vtkInformationVector** inputVector, int port, dgg::MassDistribution& distribution) const;
};

vtkDGGInternalsMacro(vtkSurfaceEarthMoversDistance);

//------------------------------------------------------------------------------
vtkSurfaceEarthMoversDistance::vtkSurfaceEarthMoversDistance()
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(3);
  this->Internals->ForgetResults();
}

//------------------------------------------------------------------------------
void vtkSurfaceEarthMoversDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FromArrayName: " << this->FromArrayName << "\n";
  os << indent << "ToArrayName: " << this->ToArrayName << "\n";
  os << indent << "ArrayMeaning: " << this->GetArrayMeaningAsString() << "\n";
  os << indent << "MassArrayName: " << this->MassArrayName << "\n";
  os << indent << "Normalize: " << (this->Normalize ? "On" : "Off") << "\n";
  os << indent << "MaximumNumberOfIterations: " << this->MaximumNumberOfIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "IntrinsicDelaunay: " << (this->IntrinsicDelaunay ? "On" : "Off") << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "LowerBound: " << this->LowerBound << "\n";
  os << indent << "Gap: " << this->Gap << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "NumberOfFactorizations: " << this->GetNumberOfFactorizations() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkSurfaceEarthMoversDistance, ArrayMeaning, "Density", "Mass");

//------------------------------------------------------------------------------
vtkDGGDefineInputMacro(vtkSurfaceEarthMoversDistance, From, 1);
vtkDGGDefineInputMacro(vtkSurfaceEarthMoversDistance, To, 2);

//------------------------------------------------------------------------------
vtkDGGResultMacro(
  vtkSurfaceEarthMoversDistance, int, NumberOfFactorizations, Session.GetNumberOfFactorizations());
vtkDGGResultMacro(
  vtkSurfaceEarthMoversDistance, vtkTypeUInt64, MemorySize, Session.GetMemorySize());

//------------------------------------------------------------------------------
void vtkSurfaceEarthMoversDistance::vtkInternals::ForgetResults()
{
  this->Self->Distance = std::numeric_limits<double>::quiet_NaN();
  this->Self->LowerBound = std::numeric_limits<double>::quiet_NaN();
  this->Self->Gap = std::numeric_limits<double>::quiet_NaN();
  this->Self->NumberOfIterations = 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkSurfaceEarthMoversDistance::vtkInternals::CheckProperties() const
{
  return dgg::CheckLengths({ { "Tolerance", this->Self->Tolerance },
    { "ProjectionTolerance", this->Self->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
dgg::Status vtkSurfaceEarthMoversDistance::vtkInternals::ReadDistribution(const DGGContext& context,
  const std::string& arrayName, vtkInformationVector** inputVector, int port,
  dgg::MassDistribution& distribution) const
{
  vtkPolyData* points = vtkPolyData::GetData(inputVector[port]);
  static const std::vector<vtkIdType> none;
  const DGGSourceSet set{ none, points, port, "'" + distribution.Role + "'", "", "" };
  distribution.Values = DGGReadArray(context.Input->GetPointData(), arrayName);
  distribution.Masses =
    DGGReadArray(points ? points->GetPointData() : nullptr, this->Self->MassArrayName);
  distribution.NumberOfPlaces = static_cast<dgg::Offset>(set.CountPoints());
  DGG_RETURN_IF_ERROR(distribution.Check(context.Surface));
  return set.IsEmpty()
    ? dgg::Status::Success()
    : DGGLocate(context, set, this->Self->ProjectionTolerance, distribution.Places);
}

//------------------------------------------------------------------------------
dgg::Status vtkSurfaceEarthMoversDistance::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  dgg::MassDistribution distributions[] = { { "from", "FromArrayName", "FromPoints" },
    { "to", "ToArrayName", "ToPoints" } };
  DGG_RETURN_IF_ERROR(
    this->ReadDistribution(context, this->Self->FromArrayName, inputVector, 1, distributions[0]));
  DGG_RETURN_IF_ERROR(
    this->ReadDistribution(context, this->Self->ToArrayName, inputVector, 2, distributions[1]));

  dgg::EarthMoversTask task;
  task.Options.MostIterations = this->Self->MaximumNumberOfIterations;
  task.Options.Tolerance = this->Self->Tolerance;
  task.IsIntrinsicDelaunay = this->Self->IntrinsicDelaunay;
  task.AreDensities = this->Self->ArrayMeaning == Density;
  task.Normalizes = this->Self->Normalize;
  task.NumberOfCells = context.Input->GetNumberOfCells();
  dgg::Output results;
  DGG_RETURN_IF_ERROR(dgg::FindEarthMoversDistance(
    context, this->Session, distributions, this->GetMemoryRemedy(), task, results));
  this->Self->Distance = task.Distance;
  this->Self->LowerBound = task.LowerBound;
  this->Self->Gap = task.Gap;
  this->Self->NumberOfIterations = task.Iterations;
  this->WarnAtEnd(results);
  const bool hasFlow = !results.CellData.empty();
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  DGGAddArrays(results, output);
  if (hasFlow)
  {
    output->GetCellData()->SetActiveVectors(dgg::EarthMoversFlowName);
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkSurfaceEarthMoversDistance::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  dgg::Output results;
  results.PointData.Add<double>(dgg::EarthMoversPotentialName, 0);
  results.PointScalars = dgg::EarthMoversPotentialName;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  DGGAddArrays(results, output);
}
