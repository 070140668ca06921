// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeatGeodesicDistance.h"

#include "DGGDistanceInternals.h"

#include "dggCounted.h"
#include "dggHeatMethod.h"
#include "dggMeshQuality.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include "vtkObjectFactory.h"

#include <cstdint>
#include <memory>
#include <utility>

vtkStandardNewMacro(vtkHeatGeodesicDistance);

namespace
{
/// Progress after factorization of the systems.
constexpr double FactorizedAt = 0.9;

/// Returns the reasons why distances may be far off; empty if there are none.
std::string DescribeQuality(const dgg::PreparedSurface& surface, double factor, dgg::Id triangles)
{
  return dgg::JoinReasons({ dgg::DescribeLongTriangles(surface, dgg::LongTrianglesMislead),
    triangles < dgg::FewestUsefulTriangles
      ? dgg::JoinText("A source is on a component of ", dgg::Counted(triangles, "triangle"),
          ", fewer than ", dgg::FewestUsefulTriangles,
          ", where mean errors are 10 % or more. Use exact distances, or subdivide the triangles")
      : "",
    factor < dgg::SmallestUsefulFactor || factor > dgg::LargestUsefulFactor
      ? dgg::JoinText("{TimeStepFactor} is ", factor, ", outside of ", dgg::SmallestUsefulFactor,
          " to ", dgg::LargestUsefulFactor,
          ", where mean errors are below 10 %. Use a number around 1")
      : "" });
}
}

//------------------------------------------------------------------------------
class vtkHeatGeodesicDistance::vtkInternals
  : public DGGInternalsOf<vtkHeatGeodesicDistance, DGGDistanceInternals>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override { this->Self->QualityWarning = false; }
  dgg::Status ComputeDistances(DGGDistanceTask& task) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh or vtkDGGFastMarchingDistance";
  }

  /// Factorizations, kept until the mesh changes.
  struct Preparation
  {
    std::uint64_t MeshBuild;
    dgg::HeatMethod Method;
  };

  int GetNumberOfFactorizations() const
  {
    return this->EarlierFactorizations +
      (this->Prepared ? this->Prepared->Method.GetNumberOfFactorizations() : 0);
  }

  std::unique_ptr<Preparation> Prepared;
  int EarlierFactorizations = 0; // for meshes before the last one
};

vtkDGGInternalsMacro(vtkHeatGeodesicDistance);

//------------------------------------------------------------------------------
vtkHeatGeodesicDistance::vtkHeatGeodesicDistance()
  : TimeStepFactor(1.0)
  , IntrinsicDelaunay(true)
  , Boundary(Neumann)
  , QualityWarning(false)
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkHeatGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeStepFactor: " << this->TimeStepFactor << "\n";
  os << indent << "IntrinsicDelaunay: " << (this->IntrinsicDelaunay ? "On" : "Off") << "\n";
  os << indent << "Boundary: " << this->GetBoundaryAsString() << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
  os << indent << "NumberOfFactorizations: " << this->GetNumberOfFactorizations() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHeatGeodesicDistance::GetBoundaryAsString() const
{
  static const char* const names[] = { "Neumann", "Dirichlet", "Average" };
  return names[this->Boundary];
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkHeatGeodesicDistance::GetMemorySize() const
{
  const auto& prepared = this->GetInternals().Prepared;
  return prepared ? static_cast<vtkTypeUInt64>(prepared->Method.GetEstimatedMemory()) : 0;
}

//------------------------------------------------------------------------------
int vtkHeatGeodesicDistance::GetNumberOfFactorizations() const
{
  return this->GetInternals().GetNumberOfFactorizations();
}

//------------------------------------------------------------------------------
dgg::Status vtkHeatGeodesicDistance::vtkInternals::CheckProperties() const
{
  if (!(this->Self->TimeStepFactor >= dgg::SmallestTimeStepFactor &&
        this->Self->TimeStepFactor <= dgg::LargestTimeStepFactor))
  {
    return dgg::InvalidValue("TimeStepFactor", this->Self->TimeStepFactor)
      .Fix("Use a number from ", dgg::SmallestTimeStepFactor, " to ", dgg::LargestTimeStepFactor,
        ", such as 1");
  }
  return DGGDistanceInternals::CheckProperties();
}

//------------------------------------------------------------------------------
dgg::Status vtkHeatGeodesicDistance::vtkInternals::ComputeDistances(DGGDistanceTask& task)
{
  const dgg::HeatBoundary boundaries[] = { dgg::HeatBoundary::Neumann, dgg::HeatBoundary::Dirichlet,
    dgg::HeatBoundary::Average };
  dgg::HeatOptions options;
  options.TimeStepFactor = this->Self->TimeStepFactor;
  options.IntrinsicDelaunay = this->Self->IntrinsicDelaunay;
  options.Boundary = boundaries[this->Self->Boundary];

  if (!this->Prepared || this->Prepared->MeshBuild != task.Context.Surface.GetBuildNumber())
  {
    this->EarlierFactorizations = this->GetNumberOfFactorizations();
    this->Prepared.reset(); // release before the next is allocated
    this->Prepared.reset(new Preparation{
      task.Context.Surface.GetBuildNumber(), dgg::HeatMethod(task.Context.Surface.GetMesh()) });
  }
  dgg::HeatMethod& method = this->Prepared->Method;
  bool isTooMuch = false;
  dgg::Status status = method.Prepare(
    options, dgg::ProgressPart(task.Context.Progress, 0.0, FactorizedAt), [&](double bytes) {
      const dgg::Status check =
        task.Context.Memory.Check("The heat method", bytes, this->GetMemoryRemedy());
      isTooMuch = !check.IsOk();
      return check;
    });
  if (isTooMuch && method.GetNumberOfFactorizations() == 0)
  {
    this->Prepared.reset(); // no factorization exists yet
  }
  if (!status.IsOk())
  {
    return status;
  }
  dgg::HeatQuery query;
  query.MaximumDistance = task.MaximumDistance;
  query.WantNearestSource = task.WantNearestSource;
  query.WantVirtualSource = task.WantVirtualSource;
  query.Progress = dgg::ProgressPart(task.Context.Progress, FactorizedAt, 1.0);
  dgg::HeatResult result;
  DGG_RETURN_IF_ERROR(method.Run(task.Sources, query, result));
  this->Self->QualityWarning = this->WarnAboutQuality(
    DescribeQuality(task.Context.Surface, options.TimeStepFactor, result.FewestTriangles));
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  task.VirtualSource = std::move(result.Virtual);
  return dgg::Status::Success();
}
