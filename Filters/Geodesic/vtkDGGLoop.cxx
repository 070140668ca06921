// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGLoop.h"

#include "vtkDGGGraphUser.h"
#include "vtkDGGLoopOutput.h"
#include "vtkDGGLoopSearch.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGNewGeometry.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSourceCollector.h"

#include "dggProgressPart.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

vtkStandardNewMacro(vtkDGGLoop);
vtkDGGGraphUserMacro(vtkDGGLoop);

namespace
{
/// Share of the progress after the graph that finding loops takes when there are tapes.
constexpr double LoopShare = 0.5;
constexpr std::size_t FewestPointsOfRope = 3;

/// To as many digits as messages have.
double RoundUp(double x)
{
  return x * (1.0 + 1e-5);
}

void FillOutputs(
  const vtkDGGLoopSet& set, const vtkDGGNewGeometry& geometry, vtkInformationVector* outputVector)
{
  vtkDGGWriteLoops(set, geometry, vtkPolyData::GetData(outputVector, 0));
  vtkDGGWriteTapes(set, geometry, vtkPolyData::GetData(outputVector, 1));
}
}

//------------------------------------------------------------------------------
vtkDGGLoop::vtkDGGLoop()
  : Mode(ThroughPoint)
  , Taut(false)
  , TapeWidth(0.0)
  , ProjectionTolerance(0.01)
  , GraphUser(new vtkDGGGraphUser)
  , Collector(new vtkDGGSourceCollector)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDGGLoop::~vtkDGGLoop() = default;

//------------------------------------------------------------------------------
void vtkDGGLoop::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << this->GetModeAsString() << "\n";
  vtkDGGPrintIds(os, indent, "PointIds", this->PointIds);
  os << indent << "Taut: " << (this->Taut ? "On" : "Off") << "\n";
  os << indent << "TapeWidth: " << this->TapeWidth << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  this->GraphUser->PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkDGGLoop::GetModeAsString() const
{
  switch (this->Mode)
  {
    case AroundHandles:
      return "AroundHandles";
    case Rope:
      return "Rope";
    default:
      return "ThroughPoint";
  }
}

//------------------------------------------------------------------------------
void vtkDGGLoop::RemoveAllPoints()
{
  this->RemoveAllPointIds();
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
void vtkDGGLoop::SetPointConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkDGGLoop::SetPointData(vtkPolyData* points)
{
  this->SetInputData(1, points);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkDGGLoop::GetTape()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoop::CheckProperties() const
{
  dgg::Status status = vtkDGGCheckLength("ProjectionTolerance", this->ProjectionTolerance);
  if (status.IsOk())
  {
    status = vtkDGGCheckLength("TapeWidth", this->TapeWidth);
  }
  if (status.IsOk() && std::isinf(this->TapeWidth))
  {
    status = dgg::Status::Invalid("TapeWidth is infinite: call SetTapeWidth() with a finite width");
  }
  return status.IsOk() ? this->GraphUser->Check() : status;
}

//------------------------------------------------------------------------------
vtkDGGSourceSet vtkDGGLoop::GetPointSet(vtkInformationVector** inputVector) const
{
  return { this->PointIds, vtkPolyData::GetData(inputVector[1]), 1, "loop point",
    "call AddPointId() or SetPointIds()", "" };
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoop::CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const
{
  if (this->Mode == AroundHandles)
  {
    return dgg::Status::Success();
  }
  const vtkDGGSourceSet set = this->GetPointSet(inputVector);
  const std::size_t count =
    set.Ids.size() + (set.Points ? static_cast<std::size_t>(set.Points->GetNumberOfPoints()) : 0);
  if (this->Mode == Rope && count > 0 && count < FewestPointsOfRope)
  {
    return dgg::Status::Invalid("a rope through " + std::to_string(count) +
      (count == 1 ? " point" : " points") +
      " goes back the way that it came: give it three points or more");
  }
  return vtkDGGSourceCollector::Check(set, surface->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
std::string vtkDGGLoop::GetMemoryRemedy() const
{
  return "use a smaller mesh, a larger Accuracy or fewer points at a time";
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGLoop::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  std::vector<dgg::GeodesicSource> sources;
  dgg::Status status;
  if (this->Mode != AroundHandles)
  {
    status = this->Collector->Collect(this->GetPointSet(inputVector), this->ProjectionTolerance,
      mesh, surface->GetPoints(), sources);
  }
  vtkDGGNewGeometry geometry;
  if (status.IsOk())
  {
    status = geometry.Take(surface, mesh, this->GetOutputPointsPrecision());
  }
  if (status.IsOk() && !this->Advance(0.0))
  {
    status = dgg::Status::Abort();
  }
  dgg::ProgressCallback progress = [this](double fraction) { return this->Advance(fraction); };
  if (status.IsOk() && this->Mode != AroundHandles)
  {
    status = this->GraphUser->Update(surface, mesh, progress, this);
    progress = this->GraphUser->GetProvider().GetRemainingProgress();
  }
  if (!status.IsOk())
  {
    return status;
  }

  const double* positions = geometry.GetPositions();
  vtkDGGGraphProvider& graph = this->GraphUser->GetProvider();
  const vtkDGGLoopSearch::Points points = vtkDGGGetPlaces(sources);
  const vtkDGGLoopSearch search(mesh);
  vtkDGGLoopSet set;
  const dgg::ProgressCallback finding =
    dgg::ProgressPart(progress, 0.0, this->TapeWidth > 0.0 ? LoopShare : 1.0);
  switch (this->Mode)
  {
    case AroundHandles:
      status = search.RunAroundHandles(finding, set);
      break;
    case Rope:
      status = search.RunRope(graph, positions, points, this->Taut, finding, set);
      break;
    default:
      status = search.RunThroughPoints(graph, positions, points, this->Taut, finding, set);
      break;
  }
  if (status.IsOk() && !finding(1.0))
  {
    status = dgg::Status::Abort();
  }
  if (status.IsOk() && this->TapeWidth > 0.0)
  {
    status = search.AddTapes(this->TapeWidth, dgg::ProgressPart(progress, LoopShare, 1.0), set);
  }
  if (status.IsOk())
  {
    FillOutputs(set, geometry, outputVector);
    this->WarnAboutMissingLoops(set);
    this->WarnAboutMissingTapes(set);
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkDGGLoop::WarnAboutMissingLoops(const vtkDGGLoopSet& set)
{
  const auto isMissing = [](vtkDGGLoopStatus status) { return status != vtkDGGLoopStatus::Found; };
  const auto missing = std::count_if(set.Status.begin(), set.Status.end(), isMissing);
  const auto first =
    std::find_if(set.Status.begin(), set.Status.end(), isMissing) - set.Status.begin();
  if (this->Mode == AroundHandles && set.Status.empty())
  {
    vtkWarningMacro("The surface has no handle, and no component with more than one boundary: all "
                    "loops on it can be contracted. There are none in the output.");
  }
  else if (missing > 0 && this->Mode == AroundHandles)
  {
    vtkWarningMacro(<< missing << " of " << set.Status.size() << " loops around handles "
                    << (missing == 1 ? "has" : "have")
                    << " to pass a point in which faces meet in nothing "
                    << "else, and cannot be pulled tight there: "
                    << (missing == 1 ? "it has" : "they have") << " no polyline, and 1 in "
                    << "the field array LoopStatus. Separate the faces at such points.");
  }
  else if (missing > 0 && this->Mode == Rope)
  {
    const bool isConnected = set.Status[0] != vtkDGGLoopStatus::NotConnected;
    vtkWarningMacro(<< (isConnected ? "The rope contracts to a point when it is pulled tight: "
                                      "nothing on the surface holds it. "
                                    : "The points of the rope are not connected by the surface. ")
                    << "There is no polyline, and " << (isConnected ? 1 : 2)
                    << " in the field array LoopStatus.");
  }
  else if (missing > 0)
  {
    vtkWarningMacro(<< "No loop was found through " << missing << " of " << set.Status.size()
                    << (set.Status.size() == 1 ? " point" : " points")
                    << (missing == 1 ? ", point " : ", the first of them point ") << first
                    << ": all ways around that were tried contract to the point, as they do on a "
                    << "surface without handles and limbs. "
                    << (missing == 1 ? "It has" : "They have")
                    << " no polyline, and 1 in the field array LoopStatus.");
  }
}

//------------------------------------------------------------------------------
void vtkDGGLoop::WarnAboutMissingTapes(const vtkDGGLoopSet& set)
{
  if (set.LoopsTooLong > 0)
  {
    vtkWarningMacro(<< "TapeWidth is " << this->TapeWidth << ", too small for the length of "
                    << set.LoopsTooLong << " of " << set.Loops.size()
                    << (set.Loops.size() == 1 ? " loop" : " loops") << ": there is no tape along "
                    << (set.LoopsTooLong == 1 ? "it" : "them")
                    << ". For all loops it has to be at least " << RoundUp(set.SmallestTapeWidth)
                    << ".");
  }
}

//------------------------------------------------------------------------------
void vtkDGGLoop::MakeEmptyOutput(vtkPolyData* surface, vtkInformationVector* outputVector)
{
  vtkDGGNewGeometry geometry;
  geometry.Take(surface, this->GetMesh(), this->GetOutputPointsPrecision());
  FillOutputs(vtkDGGLoopSet(), geometry, outputVector);
}
