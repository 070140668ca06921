// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeatGeodesicDistance.h"

#include "DGGDistanceInternals.h"
#include "DGGMeshQuality.h"

#include "dggHeatMethod.h"
#include "dggInvalidInput.h"
#include "dggProgressPart.h"

#include "vtkObjectFactory.h"

#include <cstdint>
#include <utility>

vtkStandardNewMacro(vtkHeatGeodesicDistance);

/// Factorizations, kept until the mesh changes.
struct vtkHeatGeodesicDistance::Preparation
{
  std::uint64_t MeshBuild;
  dgg::HeatMethod Method;
};

namespace
{
/// Progress after factorization of the systems.
constexpr double FactorizedAt = 0.9;

/// Returns the reasons why distances may be far off; empty if there are none.
std::string DescribeQuality(const dgg::PreparedSurface& surface, double factor, dgg::Id triangles)
{
  return DGGJoinReasons({ DGGDescribeLongTriangles(surface, DGGLongTrianglesMislead),
    triangles < dgg::FewestUsefulTriangles
      ? dgg::JoinText("A source is on a component of ", triangles, " triangles, fewer than ",
          dgg::FewestUsefulTriangles,
          ": mean errors are 10 % or more. Use vtkExactGeodesicDistance, or subdivide the "
          "triangles")
      : "",
    factor < dgg::SmallestUsefulFactor || factor > dgg::LargestUsefulFactor
      ? dgg::JoinText("TimeStepFactor is ", factor, ", outside ", dgg::SmallestUsefulFactor, " to ",
          dgg::LargestUsefulFactor,
          ": mean errors are 10 % or more. Call SetTimeStepFactor() with a number around 1")
      : "" });
}
}

//------------------------------------------------------------------------------
class vtkHeatGeodesicDistance::vtkInternals : public DGGDistanceInternals
{
public:
  explicit vtkInternals(vtkHeatGeodesicDistance* self)
    : DGGDistanceInternals(self)
    , Self(self)
  {
  }

  dgg::Status CheckProperties() const override;
  void ForgetResults() override;
  dgg::Status ComputeDistances(DGGDistanceTask& task) override;
  std::string GetMemoryRemedy() const override;

private:
  vtkHeatGeodesicDistance* Self;
};

//------------------------------------------------------------------------------
vtkHeatGeodesicDistance::vtkHeatGeodesicDistance()
  : TimeStepFactor(1.0)
  , IntrinsicDelaunay(true)
  , Boundary(Neumann)
  , QualityWarning(false)
  , NumberOfFactorizations(0)
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
vtkHeatGeodesicDistance::~vtkHeatGeodesicDistance() = default;

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
  return this->Prepared ? static_cast<vtkTypeUInt64>(this->Prepared->Method.GetEstimatedMemory())
                        : 0;
}

//------------------------------------------------------------------------------
int vtkHeatGeodesicDistance::GetNumberOfFactorizations() const
{
  return this->NumberOfFactorizations +
    (this->Prepared ? this->Prepared->Method.GetNumberOfFactorizations() : 0);
}

//------------------------------------------------------------------------------
dgg::Status vtkHeatGeodesicDistance::vtkInternals::CheckProperties() const
{
  if (!(this->Self->TimeStepFactor >= dgg::SmallestTimeStepFactor &&
        this->Self->TimeStepFactor <= dgg::LargestTimeStepFactor))
  {
    return dgg::InvalidInput("TimeStepFactor is ", this->Self->TimeStepFactor,
      ": call SetTimeStepFactor() with a number from ", dgg::SmallestTimeStepFactor, " to ",
      dgg::LargestTimeStepFactor, ", such as 1");
  }
  return DGGDistanceInternals::CheckProperties();
}

//------------------------------------------------------------------------------
std::string vtkHeatGeodesicDistance::vtkInternals::GetMemoryRemedy() const
{
  return "use a smaller mesh or vtkDGGFastMarchingDistance";
}

//------------------------------------------------------------------------------
void vtkHeatGeodesicDistance::vtkInternals::ForgetResults()
{
  this->Self->QualityWarning = false;
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

  if (!this->Self->Prepared ||
    this->Self->Prepared->MeshBuild != task.Context.Surface.GetBuildNumber())
  {
    this->Self->NumberOfFactorizations = this->Self->GetNumberOfFactorizations();
    this->Self->Prepared.reset(); // release before the next is allocated
    this->Self->Prepared.reset(new Preparation{
      task.Context.Surface.GetBuildNumber(), dgg::HeatMethod(task.Context.Surface.GetMesh()) });
  }
  dgg::HeatMethod& method = this->Self->Prepared->Method;
  bool isTooMuch = false;
  dgg::Status status = method.Prepare(
    options, dgg::ProgressPart(task.Context.Progress, 0.0, FactorizedAt), [&](double bytes) {
      const dgg::Status check = task.Context.Memory.Check(
        "the factorizations of the heat method", bytes, this->GetMemoryRemedy());
      isTooMuch = !check.IsOk();
      return check;
    });
  if (isTooMuch && method.GetNumberOfFactorizations() == 0)
  {
    this->Self->Prepared.reset(); // no factorization exists yet
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
