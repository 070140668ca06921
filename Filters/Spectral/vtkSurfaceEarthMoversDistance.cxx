// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceEarthMoversDistance.h"

#include "DGGContext.h"
#include "DGGDistribution.h"
#include "DGGFilterInternals.h"
#include "DGGMakeArray.h"
#include "DGGPoissonCache.h"
#include "DGGProperties.h"

#include "dggEarthMovers.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <limits>

vtkStandardNewMacro(vtkSurfaceEarthMoversDistance);

namespace
{
/// Progress after factorization, or after finding a kept factorization.
constexpr double FactorizedAt = 0.4;
constexpr double FoundAt = 0.01;
/// Memory of the search for the flow relative to that of the system, since it factorizes a similar
/// matrix.
constexpr double SearchPart = 1.25;

constexpr const char* DistanceName = "EarthMoversDistance";
constexpr const char* BoundName = "EarthMoversLowerBound";
constexpr const char* PotentialName = "EarthMoversPotential";
constexpr const char* FlowName = "EarthMoversFlow";

/// Returns in space a vector that is given in the frame of a face: x along its first side, y toward
/// its apex. The result has no meaning if corners coincide.
std::array<double, 3> InSpace(
  const std::array<dgg::Id, 3>& corners, vtkPolyData* surface, const dgg::Point2& vector)
{
  double p[3][3];
  for (int k = 0; k < 3; ++k)
  {
    surface->GetPoint(corners[k], p[k]);
  }
  double x[3];
  double y[3];
  vtkMath::Subtract(p[1], p[0], x);
  vtkMath::Subtract(p[2], p[0], y);
  vtkMath::Normalize(x);
  const double along = vtkMath::Dot(x, y);
  for (int axis = 0; axis < 3; ++axis)
  {
    y[axis] -= along * x[axis];
  }
  vtkMath::Normalize(y);
  return { { vector.X * x[0] + vector.Y * y[0], vector.X * x[1] + vector.Y * y[1],
    vector.X * x[2] + vector.Y * y[2] } };
}

/// Returns the flow per cell: the mean over its triangles.
vtkSmartPointer<vtkDoubleArray> MakeFlow(const dgg::PreparedSurface& prepared, vtkPolyData* surface,
  const std::vector<dgg::Point2>& flow, double total)
{
  const auto n = static_cast<std::size_t>(surface->GetNumberOfCells());
  auto array = DGGMakeArray<vtkDoubleArray>(FlowName, n, 3);
  array->Fill(0.0);
  const dgg::SurfaceMesh& mesh = prepared.GetMesh();
  const auto areaOf = [&](dgg::Id f) { return 0.5 * mesh.Length(3 * f) * mesh.ApexY(3 * f); };
  std::vector<double> areas(n, 0.0);
  for (dgg::Id k = 0; k < mesh.GetNumberOfFaces(); ++k)
  {
    const dgg::Id f = mesh.GetOriginal(k);
    areas[static_cast<std::size_t>(prepared.GetCell(k))] += mesh.IsDropped(f) ? 0.0 : areaOf(f);
  }
  for (dgg::Id k = 0; k < mesh.GetNumberOfFaces(); ++k)
  {
    const dgg::Id f = mesh.GetOriginal(k);
    const vtkIdType cell = prepared.GetCell(k);
    const double area = areas[static_cast<std::size_t>(cell)];
    if (mesh.IsDropped(f) || !(area > 0.0))
    {
      continue;
    }
    const std::array<double, 3> vector = InSpace(mesh.GetTriangle(f), surface, flow[f]);
    const double part = areaOf(f) / area * total;
    for (int axis = 0; axis < 3; ++axis)
    {
      array->SetComponent(cell, axis, array->GetComponent(cell, axis) + part * vector[axis]);
    }
  }
  return array;
}

vtkSmartPointer<vtkDoubleArray> MakePotential(const dgg::PreparedSurface& prepared,
  vtkIdType numberOfPoints, const std::vector<double>& potential)
{
  auto array =
    DGGMakeArray<vtkDoubleArray>(PotentialName, static_cast<std::size_t>(numberOfPoints));
  for (vtkIdType i = 0; i < numberOfPoints; ++i)
  {
    array->SetValue(i, potential[prepared.GetVertex(i)]);
  }
  return array;
}

/// Adds active arrays without SetScalars() and SetVectors(), which would remove those of the input.
/// @{
void ShowPotential(vtkPolyData* output, vtkDoubleArray* potential)
{
  output->GetPointData()->AddArray(potential);
  output->GetPointData()->SetActiveScalars(PotentialName);
}

void ShowFlow(vtkPolyData* output, vtkDoubleArray* flow)
{
  output->GetCellData()->AddArray(flow);
  output->GetCellData()->SetActiveVectors(FlowName);
}
/// @}

void AddNumber(vtkPolyData* output, const char* name, double value)
{
  DGGAddArray<vtkDoubleArray>(output->GetFieldData(), name, 1)->SetValue(0, value);
}
}

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

  DGGPoissonCache Cache;

private:
  DGGMassOrigin GetOrigin(int which, vtkInformationVector** inputVector) const;
  void SetResults(const DGGContext& context, vtkPolyData* output, double total,
    const dgg::EarthMoversResult& result);
};

vtkDGGInternalsMacro(vtkSurfaceEarthMoversDistance);

//------------------------------------------------------------------------------
vtkSurfaceEarthMoversDistance::vtkSurfaceEarthMoversDistance()
  : ArrayMeaning(Density)
  , Normalize(true)
  , MaximumNumberOfIterations(200)
  , Tolerance(1e-2)
  , ProjectionTolerance(0.01)
  , IntrinsicDelaunay(false)
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
const char* vtkSurfaceEarthMoversDistance::GetArrayMeaningAsString() const
{
  return this->ArrayMeaning == Mass ? "Mass" : "Density";
}

//------------------------------------------------------------------------------
vtkDGGDefineInputMacro(vtkSurfaceEarthMoversDistance, From, 1);
vtkDGGDefineInputMacro(vtkSurfaceEarthMoversDistance, To, 2);

//------------------------------------------------------------------------------
int vtkSurfaceEarthMoversDistance::GetNumberOfFactorizations() const
{
  return this->GetInternals().Cache.GetNumberOfFactorizations();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkSurfaceEarthMoversDistance::GetMemorySize() const
{
  return this->GetInternals().Cache.GetMemorySize();
}

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
  return DGGCheckLengths({ { "Tolerance", this->Self->Tolerance },
    { "ProjectionTolerance", this->Self->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
DGGMassOrigin vtkSurfaceEarthMoversDistance::vtkInternals::GetOrigin(
  int which, vtkInformationVector** inputVector) const
{
  vtkPolyData* points = vtkPolyData::GetData(inputVector[1 + which]);
  return which == 0 ? DGGMassOrigin{ "from", this->Self->FromArrayName, "FromArrayName", points, 1,
    this->Self->MassArrayName }
                    : DGGMassOrigin{ "to", this->Self->ToArrayName, "ToArrayName", points, 2,
                        this->Self->MassArrayName };
}

//------------------------------------------------------------------------------
dgg::Status vtkSurfaceEarthMoversDistance::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  DGGDistribution distributions[2];
  for (int k = 0; k < 2; ++k)
  {
    DGG_RETURN_IF_ERROR(distributions[k].Read(
      context, this->GetOrigin(k, inputVector), this->Self->ProjectionTolerance));
  }
  dgg::PoissonOptions poisson;
  poisson.IntrinsicDelaunay = this->Self->IntrinsicDelaunay;
  dgg::EarthMoversOptions options;
  options.MostIterations = this->Self->MaximumNumberOfIterations;
  options.Tolerance = this->Self->Tolerance;

  const double prepared = this->Cache.IsPrepared(mesh, poisson) ? FoundAt : FactorizedAt;
  const auto others = [&](const dgg::PoissonSolver& solver) {
    return SearchPart * solver.GetEstimatedMemory();
  };
  DGG_RETURN_IF_ERROR(this->Cache.Prepare(context, poisson, others, this->GetMemoryRemedy(),
    dgg::ProgressPart(context.Progress, 0.0, prepared)));
  const std::vector<double>* areas =
    this->Self->ArrayMeaning == Density ? &this->Cache.GetSolver().GetAreas() : nullptr;
  std::vector<double> masses[2];
  for (int k = 0; k < 2; ++k)
  {
    DGG_RETURN_IF_ERROR(distributions[k].Integrate(mesh, areas, masses[k]));
  }
  double total = 1.0;
  DGG_RETURN_IF_ERROR(
    dgg::BalanceMasses(mesh.GetMesh(), this->Self->Normalize, masses[0], masses[1], total));
  dgg::EarthMoversResult result;
  options.Progress = dgg::ProgressPart(context.Progress, prepared, 1.0);
  DGG_RETURN_IF_ERROR(
    dgg::EarthMovers(this->Cache.GetSolver()).Run(masses[0], masses[1], options, result));
  DGG_RETURN_IF_ERROR(dgg::ReportTo(context.Progress, 1.0));
  this->Self->NumberOfIterations = result.Iterations;
  this->SetResults(context, vtkPolyData::GetData(outputVector), total, result);
  if (options.MostIterations > 0 &&
    result.GetGap() > std::max(options.Tolerance, dgg::LeastEarthMoversGap))
  {
    this->Warn(dgg::JoinText("The distance is between ", this->Self->LowerBound, " and ",
      this->Self->Distance, ", a gap of ", 100.0 * this->Self->Gap, " %, after ", result.Iterations,
      " iterations. Raise {MaximumNumberOfIterations} or {Tolerance}, or improve the triangles"));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkSurfaceEarthMoversDistance::vtkInternals::SetResults(const DGGContext& context,
  vtkPolyData* output, double total, const dgg::EarthMoversResult& result)
{
  vtkPolyData* surface = context.Input;
  this->Self->Distance = total * result.Distance;
  this->Self->LowerBound = total * result.LowerBound;
  this->Self->Gap = result.GetGap();
  output->ShallowCopy(surface);
  AddNumber(output, DistanceName, this->Self->Distance);
  AddNumber(output, BoundName, this->Self->LowerBound);
  ShowPotential(
    output, MakePotential(context.Surface, surface->GetNumberOfPoints(), result.Potential));
  if (!result.Flow.empty())
  {
    ShowFlow(output, MakeFlow(context.Surface, surface, result.Flow, total));
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceEarthMoversDistance::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  ShowPotential(output, DGGMakeArray<vtkDoubleArray>(PotentialName, 0));
}
