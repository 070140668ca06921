// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGLoop.h"

#include "DGGContext.h"
#include "DGGGraphUser.h"
#include "DGGMakeArray.h"
#include "DGGNewGeometry.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggBlockLoop.h"
#include "dggFoundLoop.h"
#include "dggHandleLoops.h"
#include "dggInvalidInput.h"
#include "dggLoopFinder.h"
#include "dggOffsetCurves.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggSurfacePoint.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkDGGLoop);
vtkDGGDefineInputMacro(vtkDGGLoop, Point, 1);

/// Outcomes of the search for a loop: values of LoopStatus.
enum class LoopStatus
{
  Found = 0,
  NotFound = 1,
  NotConnected = 2
};

/// Requested loops, and boundaries of the tapes along them.
struct DGGLoopSet
{
  std::vector<dgg::FoundLoop> Loops; ///< empty if not found
  std::vector<LoopStatus> Status;
  std::vector<std::vector<dgg::SurfacePath>> Rims; ///< per loop; empty without tapes
  std::size_t LoopsTooLong = 0;                    ///< number of loops too long for TapeWidth
  std::size_t TapesTooWide = 0;                    ///< number of tapes without room for a rim
  double SmallestOffsetWidth = 0.0;                ///< smallest width that suffices for all loops
};

namespace
{
using LoopPoints = std::vector<dgg::SurfacePoint>;

/// Finds a loop through each point, on all threads.
dgg::Status RunThroughPoints(const dgg::LoopFinder& finder, const LoopPoints& points, bool taut,
  const dgg::ParallelFor& parallel, const dgg::ProgressCallback& progress, DGGLoopSet& set)
{
  set.Loops.assign(points.size(), dgg::FoundLoop());
  const auto step = [&](std::size_t i, const dgg::ProgressCallback& within) {
    return finder.ThroughPoint(points[i], taut, set.Loops[i], within)
      .Of("point " + std::to_string(i));
  };
  return dgg::ForEach(points.size(), 1, parallel, progress, step);
}

/// Finds a loop through all points.
dgg::Status RunRope(const dgg::LoopFinder& finder, const LoopPoints& points, bool taut,
  const dgg::ProgressCallback& progress, DGGLoopSet& set)
{
  set.Loops.resize(1);
  bool isConnected = true;
  const dgg::Status status =
    finder.Rope(points, taut, set.Loops[0], isConnected, progress).Of("rope");
  if (!isConnected)
  {
    set.Status = { LoopStatus::NotConnected };
  }
  return status;
}

/// Adds the boundaries of tapes along all loops that are not too long.
dgg::Status AddTapes(const dgg::PreparedSurface& mesh, double width,
  const dgg::ProgressCallback& progress, DGGLoopSet& set)
{
  const std::size_t count = set.Loops.size();
  set.Rims.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (set.Loops[i].Loop.IsEmpty())
    {
      continue;
    }
    const double smallest = dgg::GetSmallestOffsetWidth(set.Loops[i].Loop);
    set.SmallestOffsetWidth = std::max(set.SmallestOffsetWidth, smallest);
    if (width < smallest)
    {
      ++set.LoopsTooLong;
      continue;
    }
    const auto part = [&](double fraction) {
      return progress((static_cast<double>(i) + fraction) / static_cast<double>(count));
    };
    DGG_RETURN_IF_ERROR(
      dgg::MakeOffsetCurves(mesh.GetMesh(), set.Loops[i].Loop, width, part, set.Rims[i])
        .Of("tape of loop " + std::to_string(i)));
    set.TapesTooWide += set.Rims[i].empty() ? 1 : 0;
    if (!part(1.0))
    {
      return dgg::Status::Abort();
    }
  }
  return dgg::Status::Success();
}

/// Progress weight of finding loops, after the graph, if there are tapes.
constexpr double LoopShare = 0.5;
constexpr std::size_t FewestPointsOfRope = 3;

/// Rounds up to the number of digits in messages.
double RoundUp(double x)
{
  return x * (1.0 + 1e-5);
}

/// A curve of an output.
struct Curve
{
  const dgg::SurfacePath* Path;
  bool IsClosed;
  vtkIdType Loop;
};

/// Returns true if the boundary curve ends exactly at its first point.
bool IsClosed(const dgg::SurfacePath& rim)
{
  return rim.Points.size() > 2 && dgg::IsSamePoint(rim.Points.front(), rim.Points.back());
}

/// Adds field data, polylines, Length and LoopId.
void WriteCurves(
  const std::vector<Curve>& curves, const DGGNewGeometry& geometry, vtkPolyData* output)
{
  geometry.Begin(output);
  const auto count = static_cast<vtkIdType>(curves.size());
  vtkIdType size = 0;
  for (const Curve& curve : curves)
  {
    size += DGGPolylineWriter::CountPoints(*curve.Path, curve.IsClosed);
  }
  auto lengths = DGGMakeArray<vtkDoubleArray>("Length", count);
  auto ids = DGGMakeArray<vtkIdTypeArray>("LoopId", count);
  DGGPolylineWriter writer(geometry, size);
  for (vtkIdType i = 0; i < count; ++i)
  {
    writer.Add(*curves[i].Path, curves[i].IsClosed);
    lengths->SetValue(i, curves[i].Path->Length);
    ids->SetValue(i, curves[i].Loop);
  }
  writer.AddTo(output);
  output->GetCellData()->AddArray(lengths);
  output->GetCellData()->AddArray(ids);
}

void WriteLoops(const DGGLoopSet& set, const DGGNewGeometry& geometry, vtkPolyData* output)
{
  std::vector<Curve> curves;
  auto status = DGGMakeArray<vtkIntArray>("LoopStatus", static_cast<vtkIdType>(set.Loops.size()));
  for (std::size_t i = 0; i < set.Loops.size(); ++i)
  {
    const auto loop = static_cast<vtkIdType>(i);
    status->SetValue(loop, static_cast<int>(set.Status[i]));
    if (!set.Loops[i].Loop.IsEmpty())
    {
      curves.push_back({ &set.Loops[i].Loop, true, loop });
    }
  }
  WriteCurves(curves, geometry, output);
  const auto count = static_cast<vtkIdType>(curves.size());
  auto angles = DGGMakeArray<vtkDoubleArray>("Angle", count);
  auto kinked = DGGMakeArray<vtkIntArray>("Kinked", count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const dgg::FoundLoop& loop = set.Loops[curves[i].Loop];
    angles->SetValue(i, loop.Angle);
    kinked->SetValue(i, loop.IsKinked() ? 1 : 0);
  }
  output->GetCellData()->AddArray(angles);
  output->GetCellData()->AddArray(kinked);
  output->GetFieldData()->AddArray(status);
}

void WriteTapes(const DGGLoopSet& set, const DGGNewGeometry& geometry, vtkPolyData* output)
{
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < set.Rims.size(); ++i)
  {
    for (const dgg::SurfacePath& rim : set.Rims[i])
    {
      curves.push_back({ &rim, IsClosed(rim), static_cast<vtkIdType>(i) });
    }
  }
  WriteCurves(curves, geometry, output);
}

void FillOutputs(
  const DGGLoopSet& set, const DGGNewGeometry& geometry, vtkInformationVector* outputVector)
{
  WriteLoops(set, geometry, vtkPolyData::GetData(outputVector, 0));
  WriteTapes(set, geometry, vtkPolyData::GetData(outputVector, 1));
}
}

//------------------------------------------------------------------------------
class vtkDGGLoop::vtkInternals : public DGGGraphInternalsOf<vtkDGGLoop>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  bool IsCloud(vtkPolyData* vtkNotUsed(input)) const override { return false; }
  std::string GetMemoryRemedy() const override
  {
    return "use a smaller mesh, a larger Accuracy or fewer points at a time";
  }

private:
  DGGSourceSet GetPointSet(vtkInformationVector** inputVector) const;
  void WarnAboutMissingLoops(const DGGLoopSet& set);
  void WarnAboutMissingTapes(const DGGLoopSet& set);
};

vtkDGGInternalsMacro(vtkDGGLoop);
vtkDGGGraphUserMacro(vtkDGGLoop);

//------------------------------------------------------------------------------
vtkDGGLoop::vtkDGGLoop()
  : Mode(ThroughPoint)
  , Taut(false)
  , TapeWidth(0.0)
  , ProjectionTolerance(0.01)
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkDGGLoop::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->GetModeAsString() << "\n";
  DGGPrintIds(os, indent, "PointIds", this->PointIds);
  os << indent << "Taut: " << (this->Taut ? "On" : "Off") << "\n";
  os << indent << "TapeWidth: " << this->TapeWidth << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  this->GetInternals().GraphUser.PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkDGGLoop::GetModeAsString() const
{
  static const char* const names[] = { "ThroughPoint", "AroundHandles", "Rope" };
  return names[this->Mode];
}

//------------------------------------------------------------------------------
void vtkDGGLoop::RemoveAllPoints()
{
  this->RemoveAllPointIds();
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkDGGLoop::GetTape()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoop::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(DGGCheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance },
    { "TapeWidth", this->Self->TapeWidth } }));
  return std::isinf(this->Self->TapeWidth)
    ? dgg::Status::Invalid("TapeWidth is infinite: call SetTapeWidth() with a finite width")
    : DGGGraphInternalsOf::CheckProperties();
}

//------------------------------------------------------------------------------
DGGSourceSet vtkDGGLoop::vtkInternals::GetPointSet(vtkInformationVector** inputVector) const
{
  return { this->Self->PointIds, vtkPolyData::GetData(inputVector[1]), 1, "loop point",
    "call AddPointId() or SetPointIds()", "" };
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoop::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  LoopPoints points;
  if (this->Self->Mode != AroundHandles)
  {
    DGG_RETURN_IF_ERROR(
      DGGLocate(context, this->GetPointSet(inputVector), this->Self->ProjectionTolerance, points));
  }
  if (this->Self->Mode == Rope && points.size() < FewestPointsOfRope)
  {
    return dgg::InvalidInput("a rope through ", points.size(),
      points.size() == 1 ? " point" : " points",
      " runs back along itself: specify three points or more");
  }
  DGGNewGeometry geometry;
  DGG_RETURN_IF_ERROR(geometry.Take(context, this->Self->GetOutputPointsPrecision()));
  dgg::ProgressCallback progress = context.Progress;
  if (this->Self->Mode != AroundHandles)
  {
    DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
    progress = this->GraphUser.GetRemainingProgress(context);
  }

  DGGLoopSet set;
  const dgg::ProgressCallback finding =
    dgg::ProgressPart(progress, 0.0, this->Self->TapeWidth > 0.0 ? LoopShare : 1.0);
  if (this->Self->Mode == AroundHandles)
  {
    DGG_RETURN_IF_ERROR(dgg::FindHandleLoops(mesh.GetMesh(), finding, set.Loops));
  }
  else
  {
    DGGGraphUser& graph = this->GraphUser;
    const bool withLinks = !std::all_of(points.begin(), points.end(), dgg::IsVertex);
    DGG_RETURN_IF_ERROR(graph.PrepareBuilder(context, withLinks));
    const dgg::LoopFinder finder(mesh.GetMesh(), graph.GetSearch(),
      withLinks ? &graph.GetBuilder() : nullptr, geometry.GetPositions(), graph.GetLinkAccuracy());
    const bool taut = this->Self->Taut;
    DGG_RETURN_IF_ERROR(this->Self->Mode == Rope
        ? RunRope(finder, points, taut, finding, set)
        : RunThroughPoints(finder, points, taut, context.Parallel, finding, set));
  }
  for (std::size_t i = set.Status.size(); i < set.Loops.size(); ++i)
  {
    set.Status.push_back(set.Loops[i].Loop.IsEmpty() ? LoopStatus::NotFound : LoopStatus::Found);
  }
  DGG_RETURN_IF_ERROR(dgg::ReportTo(finding, 1.0));
  if (this->Self->TapeWidth > 0.0)
  {
    DGG_RETURN_IF_ERROR(
      AddTapes(mesh, this->Self->TapeWidth, dgg::ProgressPart(progress, LoopShare, 1.0), set));
  }
  FillOutputs(set, geometry, outputVector);
  this->WarnAboutMissingLoops(set);
  this->WarnAboutMissingTapes(set);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkDGGLoop::vtkInternals::WarnAboutMissingLoops(const DGGLoopSet& set)
{
  const auto isMissing = [](LoopStatus status) { return status != LoopStatus::Found; };
  const auto missing = std::count_if(set.Status.begin(), set.Status.end(), isMissing);
  const auto first =
    std::find_if(set.Status.begin(), set.Status.end(), isMissing) - set.Status.begin();
  if (this->Self->Mode == AroundHandles && set.Status.empty())
  {
    vtkWarningWithObjectMacro(this->Self,
      "The surface has no handle, and no component with more than one boundary: all "
      "loops on it can be contracted. There are none in the output.");
  }
  else if (missing > 0 && this->Self->Mode == AroundHandles)
  {
    vtkWarningWithObjectMacro(
      this->Self, << missing << " of " << set.Status.size() << " loops around handles "
                  << (missing == 1 ? "has" : "have")
                  << " to pass a pinched vertex, and cannot be pulled tight there: "
                  << (missing == 1 ? "it has" : "they have") << " no polyline, and 1 in "
                  << "the field array LoopStatus. Separate the fans of faces at such vertices.");
  }
  else if (missing > 0 && this->Self->Mode == Rope)
  {
    const bool isConnected = set.Status[0] != LoopStatus::NotConnected;
    vtkWarningWithObjectMacro(
      this->Self, << (isConnected ? "The rope contracts to a point when it is pulled tight. "
                                  : "The points of the rope are not connected by the surface. ")
                  << "There is no polyline, and " << (isConnected ? 1 : 2)
                  << " in the field array LoopStatus.");
  }
  else if (missing > 0)
  {
    vtkWarningWithObjectMacro(
      this->Self, << "No loop was found through " << missing << " of " << set.Status.size()
                  << (set.Status.size() == 1 ? " point" : " points")
                  << (missing == 1 ? ", point " : ", the first of them point ") << first
                  << ": all loops that were tried contract to the point, as on a surface without "
                  << "handles and limbs. " << (missing == 1 ? "It has" : "They have")
                  << " no polyline, and 1 in the field array LoopStatus.");
  }
}

//------------------------------------------------------------------------------
void vtkDGGLoop::vtkInternals::WarnAboutMissingTapes(const DGGLoopSet& set)
{
  if (set.LoopsTooLong > 0)
  {
    vtkWarningWithObjectMacro(this->Self,
      << "TapeWidth is " << this->Self->TapeWidth << ", too small for the length of "
      << set.LoopsTooLong << " of " << set.Loops.size()
      << (set.Loops.size() == 1 ? " loop" : " loops") << ": there is no tape along "
      << (set.LoopsTooLong == 1 ? "it" : "them") << ". For all loops it has to be at least "
      << RoundUp(set.SmallestOffsetWidth) << ".");
  }
  if (set.TapesTooWide > 0)
  {
    vtkWarningWithObjectMacro(this->Self,
      << "TapeWidth is " << this->Self->TapeWidth
      << ", and no point is at half of that distance from " << set.TapesTooWide << " of "
      << set.Loops.size() << (set.Loops.size() == 1 ? " loop" : " loops")
      << ": output 1 has no curve for " << (set.TapesTooWide == 1 ? "it" : "them") << ".");
  }
}

//------------------------------------------------------------------------------
void vtkDGGLoop::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  DGGNewGeometry geometry;
  geometry.Take(context, this->Self->GetOutputPointsPrecision());
  FillOutputs(DGGLoopSet(), geometry, outputVector);
}
