// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLoopSearch.h"

#include "dggBlockLoop.h"
#include "dggCounted.h"
#include "dggGraphSession.h"
#include "dggHandleLoops.h"
#include "dggLoopFinder.h"
#include "dggOffsetCurves.h"
#include "dggOutput.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggPropertyChecks.h"
#include "dggStatus.h"
#include "dggSurfaceOutput.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace dgg
{
namespace
{
/// Progress weight of finding loops, after the graph, if there are offset curves.
constexpr double LoopShare = 0.5;
constexpr std::size_t FewestPointsOfRope = 3;

/// Finds loops through points in a graph.
Status SearchGraph(const TaskContext& context, GraphSession& graph, const LoopOptions& options,
  const ProgressCallback& progress, LoopSet& set)
{
  const std::vector<SurfacePoint>& points = options.Points;
  const bool withLinks = !std::all_of(points.begin(), points.end(), IsVertex);
  DGG_RETURN_IF_ERROR(graph.PrepareBuilder(context, withLinks));
  const LoopFinder finder(context.Surface.GetMesh(), graph.GetSearch(),
    withLinks ? &graph.GetBuilder() : nullptr, context.Surface.GetPositions(),
    graph.GetLinkAccuracy());
  if (options.Kind == LoopOptions::Rope)
  {
    set.Loops.resize(1);
    bool isConnected = true;
    DGG_RETURN_IF_ERROR(
      finder.Rope(points, options.Taut, set.Loops[0], isConnected, progress).Of("Rope"));
    if (!isConnected)
    {
      set.Status = { LoopSet::NotConnected };
    }
    return Status::Success();
  }
  set.Loops.resize(points.size());
  return ForEach(points.size(), 1, context.Parallel, progress,
    [&](std::size_t i, const ProgressCallback& within) {
      return finder.ThroughPoint(points[i], options.Taut, set.Loops[i], within)
        .Of("Point " + std::to_string(i));
    });
}

/// Makes the offset curves of all loops that are short enough.
Status FindOffsetCurves(
  const TaskContext& context, double width, const ProgressCallback& progress, LoopSet& set)
{
  const std::size_t count = set.Loops.size();
  set.OffsetCurves.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const SurfacePath& loop = set.Loops[i].Loop;
    const double begin = static_cast<double>(i) / static_cast<double>(count);
    const double end = static_cast<double>(i + 1) / static_cast<double>(count);
    if (!loop.IsEmpty() && width >= GetSmallestOffsetWidth(loop))
    {
      DGG_RETURN_IF_ERROR(MakeOffsetCurves(context.Surface.GetMesh(), loop, width,
        ProgressPart(progress, begin, end), set.OffsetCurves[i])
                            .Of("Tape of loop " + std::to_string(i)));
    }
    DGG_RETURN_IF_ERROR(ReportTo(progress, end));
  }
  return Status::Success();
}

/// Returns a warning about loops that were not found; empty if all were.
std::string DescribeMissingLoops(LoopOptions::KindType kind, const LoopSet& set)
{
  const auto isMissing = [](LoopSet::StatusType status) { return status != LoopSet::Found; };
  const auto missing = std::count_if(set.Status.begin(), set.Status.end(), isMissing);
  const auto first =
    std::find_if(set.Status.begin(), set.Status.end(), isMissing) - set.Status.begin();
  if (kind == LoopOptions::AroundHandles && set.Status.empty())
  {
    return "The surface has no handle, and no component with more than one boundary: all loops on "
           "it can be contracted. The output has none";
  }
  if (missing == 0)
  {
    return {};
  }
  switch (kind)
  {
    case LoopOptions::AroundHandles:
      return JoinText("Non-manifold vertices prevent ", missing, " of ",
        Counted(set.Status.size(), "loop"),
        " around handles from being pulled tight. Missing loops have no polyline, and the "
        "value 1 in the field array LoopStatus. Separate the fans of faces at such vertices");
    case LoopOptions::Rope:
      return set.Status[0] == LoopSet::NotConnected
        ? "The points of the rope are not connected by the surface. There is no polyline, and the "
          "field array LoopStatus is 2"
        : "The rope contracts to a point when it is pulled tight. There is no polyline, and the "
          "field array LoopStatus is 1";
    default:
      return JoinText("No loop was found through ", missing, " of ",
        Counted(set.Status.size(), "point"), " (the first is point ", first,
        "): all loops that were tried contract to the point, as on a surface without handles and "
        "limbs. Missing loops have no polyline, and the value 1 in the field array LoopStatus");
  }
}

/// Adds the cell arrays of all curves.
void AddLengths(
  const std::vector<OutputCurve>& curves, const std::vector<Offset>& loops, Output& output)
{
  double* const lengths = output.CellData.Add<double>("Length", curves.size());
  Offset* const ids = output.CellData.Add<Offset>("LoopId", curves.size());
  std::transform(curves.begin(), curves.end(), lengths,
    [](const OutputCurve& curve) { return curve.Path->Length; });
  std::copy(loops.begin(), loops.end(), ids);
}

/// Rounds up to the number of digits in messages.
double RoundUp(double x)
{
  return x * (1.0 + 1e-5);
}
}

//------------------------------------------------------------------------------
Status CheckTapeWidth(double width)
{
  DGG_RETURN_IF_ERROR(CheckLengths({ { "TapeWidth", width } }));
  return width < Infinity
    ? Status::Success()
    : InvalidValue("TapeWidth", width).Fix("Set {TapeWidth} to a finite width");
}

//------------------------------------------------------------------------------
Status CheckLoopOptions(const LoopOptions& options)
{
  if (options.Kind != LoopOptions::Rope)
  {
    return Status::Success();
  }
  std::vector<SurfacePoint> different;
  for (const SurfacePoint& point : options.Points)
  {
    if (std::none_of(different.begin(), different.end(),
          [&](const SurfacePoint& other) { return IsSamePoint(point, other); }))
    {
      different.push_back(point);
    }
    if (different.size() == FewestPointsOfRope)
    {
      return Status::Success();
    }
  }
  return InvalidInput("A rope through ", different.size(),
    different.size() == 1 ? " point" : " different points", " runs back along itself")
    .Fix("Specify at least three different points");
}

//------------------------------------------------------------------------------
Status FindLoops(
  const TaskContext& context, GraphSession& graph, const LoopOptions& options, LoopSet& loops)
{
  const bool usesGraph = options.Kind != LoopOptions::AroundHandles;
  const ProgressCallback progress =
    usesGraph ? graph.GetRemainingProgress(context) : context.Progress;
  const ProgressCallback finding =
    ProgressPart(progress, 0.0, options.TapeWidth > 0.0 ? LoopShare : 1.0);
  DGG_RETURN_IF_ERROR(usesGraph ? SearchGraph(context, graph, options, finding, loops)
                                : FindHandleLoops(context.Surface.GetMesh(), finding, loops.Loops));
  for (std::size_t i = loops.Status.size(); i < loops.Loops.size(); ++i)
  {
    loops.Status.push_back(loops.Loops[i].Loop.IsEmpty() ? LoopSet::NotFound : LoopSet::Found);
  }
  DGG_RETURN_IF_ERROR(ReportTo(finding, 1.0));
  return options.TapeWidth > 0.0
    ? FindOffsetCurves(context, options.TapeWidth, ProgressPart(progress, LoopShare, 1.0), loops)
    : Status::Success();
}

//------------------------------------------------------------------------------
void WriteLoops(
  const TaskContext& context, const LoopOptions& options, const LoopSet& loops, Output& output)
{
  std::int32_t* const status =
    output.FieldData.Add<std::int32_t>("LoopStatus", loops.Status.size());
  std::copy(loops.Status.begin(), loops.Status.end(), status);
  std::vector<OutputCurve> curves;
  std::vector<Offset> ids;
  for (std::size_t i = 0; i < loops.Loops.size(); ++i)
  {
    if (!loops.Loops[i].Loop.IsEmpty())
    {
      curves.push_back({ &loops.Loops[i].Loop, true });
      ids.push_back(static_cast<Offset>(i));
    }
  }
  WriteCurves(context, curves, output);
  AddLengths(curves, ids, output);
  double* const angles = output.CellData.Add<double>("Angle", ids.size());
  std::int32_t* const kinked = output.CellData.Add<std::int32_t>("Kinked", ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const FoundLoop& loop = loops.Loops[ids[i]];
    angles[i] = loop.Angle;
    kinked[i] = loop.IsKinked() ? 1 : 0;
  }
  output.Warn(DescribeMissingLoops(options.Kind, loops));
}

//------------------------------------------------------------------------------
void WriteOffsetCurves(
  const TaskContext& context, const LoopOptions& options, const LoopSet& loops, Output& output)
{
  std::vector<OutputCurve> curves;
  std::vector<Offset> ids;
  std::size_t tooLong = 0; // number of loops
  std::size_t noRoom = 0;  // number of loops
  double smallestWidth = 0.0;
  for (std::size_t i = 0; i < loops.OffsetCurves.size(); ++i)
  {
    const SurfacePath& loop = loops.Loops[i].Loop;
    const double width = GetSmallestOffsetWidth(loop);
    smallestWidth = std::max(smallestWidth, width);
    tooLong += width > options.TapeWidth ? 1 : 0;
    noRoom +=
      !loop.IsEmpty() && width <= options.TapeWidth && loops.OffsetCurves[i].empty() ? 1 : 0;
    for (const SurfacePath& curve : loops.OffsetCurves[i])
    {
      curves.push_back({ &curve,
        curve.Points.size() > 2 && IsSamePoint(curve.Points.front(), curve.Points.back()) });
      ids.push_back(static_cast<Offset>(i));
    }
  }
  WriteCurves(context, curves, output);
  AddLengths(curves, ids, output);
  if (tooLong > 0)
  {
    output.Warnings.push_back(
      JoinText("{TapeWidth} is ", options.TapeWidth, ", which is too small for the length of ",
        tooLong, " of ", Counted(loops.Loops.size(), "loop"),
        ". Such loops have no tape. Set {TapeWidth} to at least ", RoundUp(smallestWidth)));
  }
  if (noRoom > 0)
  {
    output.Warnings.push_back(JoinText("{TapeWidth} is ", options.TapeWidth,
      ", and no point is at half of that distance from ", noRoom, " of ",
      Counted(loops.Loops.size(), "loop"), ". Such loops have no tape. Use a smaller {TapeWidth}"));
  }
}
}
