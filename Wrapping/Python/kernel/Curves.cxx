// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Arrays.h"
#include "Call.h"
#include "Distances.h"
#include "Errors.h"
#include "Errors.h"
#include "Graph.h"
#include "Module.h"
#include "Outputs.h"
#include "SurfacePoints.h"

#include "dggLoopSearch.h"
#include "dggOutput.h"
#include "dggPathSearch.h"

#include <optional>

namespace dggPython
{
namespace
{
constexpr const char* PathsDocumentation =
  R"(A shortest path for each pair of points.

Parameters
----------
target : Graph, or Surface with the method "Exact"
pairs : surface points
    Start and end of each pair in turn; integers of shape (n, 2), or floats of shape (n, 2, 3).
method : {"Graph", "Exact"}
straighten : bool
    Shorten paths of a graph to locally shortest geodesics.
detour : float
    Search the shortest of the paths that are longer than the first one by at most this fraction.
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
SimpleNamespace
    Lines with the cell data "Length", "GraphLength", "Straightened" and "PairId", and the field
    data "PathStatus". `number_of_fallbacks` counts edges whose stored direction was not accurate.

Raises
------
Error
    For an invalid point. Points that are not connected give a warning.

References
----------
D. T. Lee, F. P. Preparata, "Euclidean shortest paths in the presence of rectilinear barriers",
Networks 14, 1984; S.-Q. Xin, G.-J. Wang, "Efficiently determining a locally exact shortest path on
polyhedral surfaces", Computer-Aided Design 39, 2007.)";

constexpr const char* LoopsDocumentation =
  R"(Closed geodesics through points, or around the handles and holes of a surface.

Parameters
----------
target : Graph, or Surface with the mode "AroundHandles"
points : surface points, optional
mode : {"ThroughPoint", "AroundHandles", "Rope"}
    A loop through each point, loops around handles, or one loop through all points in their order.
taut : bool
    Release loops at the points and pull them tight.
tape_width : float
    Distance of two curves along each loop; 0 for none.
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
tuple of two SimpleNamespace
    Loops: lines with the cell data "Length", "LoopId", "Angle" and "Kinked", and the field data
    "LoopStatus". Curves of the tape: lines with "Length" and "LoopId".

Raises
------
Error
    For an invalid point, and a rope of fewer than three different points.

References
----------
Handles: J. Erickson, K. Whittlesey, "Greedy optimal homotopy and homology generators", SODA 2005.
Loops are straightened as by `paths`.)";

enum class PathMethod
{
  Graph,
  Exact
};

struct PathArguments
{
  PathMethod Method = PathMethod::Graph;
  dgg::PathOptions Options;
};

/// Finds paths by the method of the arguments. `graph` is null for exact paths.
dgg::Status RunPaths(const dgg::TaskContext& context, const PathArguments& arguments,
  const dgg::PathSearch::Pairs& pairs, dgg::GraphSession* graph, dgg::PathSearch::Paths& paths)
{
  const dgg::PathSearch search(context, pairs);
  if (!graph)
  {
    return search.RunExact(paths);
  }
  return context.Surface.IsCloud() ? search.RunOnCloud(*graph, arguments.Options.Straighten, paths)
                                   : search.RunInGraph(*graph, arguments.Options, paths);
}

py::object FindPaths(const py::object& target, const py::object& pairs, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  SurfacePoints ends(pairs, "path end", "Pairs");
  ends.ReadTolerance(arguments);
  ends.GetCollection().ArePairs = true;
  if (ends.Size() % 2 != 0)
  {
    throw py::value_error(
      "pairs: expected an even number of points, got " + std::to_string(ends.Size()));
  }
  PathArguments options;
  arguments.ReadChoice(
    "method", { { "Graph", PathMethod::Graph }, { "Exact", PathMethod::Exact } }, options.Method);
  arguments.Read("straighten", options.Options.Straighten);
  arguments.ReadLength("detour", options.Options.Detour);
  const SurfaceOrGraph input(target);
  const Graph* const graph = options.Method == PathMethod::Graph
    ? &input.GetGraph("Paths of the method \"Graph\"")
    : nullptr;
  dgg::Output output;
  dgg::Offset fallbacks = 0;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(input.GetSurface());
    DGG_RETURN_IF_ERROR(
      graph ? dgg::Status::Success() : RequireSurface(context.Surface, "Exact paths"));
    std::vector<dgg::SurfacePoint> points;
    DGG_RETURN_IF_ERROR(ends.Locate(context, points));
    std::optional<Graph::Session> session;
    if (graph)
    {
      session.emplace(*graph);
    }
    dgg::PathSearch::Paths paths;
    DGG_RETURN_IF_ERROR(
      RunPaths(context, options, dgg::MakePairs(points), session ? &**session : nullptr, paths));
    fallbacks = dgg::CountFallbacks(paths);
    dgg::WritePaths(context, paths, output);
    return dgg::Status::Success();
  });
  py::object result = ToPython(output);
  result.attr("number_of_fallbacks") = fallbacks;
  return result;
}

//------------------------------------------------------------------------------
py::array ReadPathEnds(const py::object& lines, dgg::Offset numberOfPoints)
{
  std::vector<dgg::Offset> ends;
  ThrowUnlessOk(dgg::ReadPathEnds(Cells(lines, "lines").Get(), numberOfPoints, ends));
  return ToArray(std::move(ends));
}

//------------------------------------------------------------------------------
py::object FindLoops(const py::object& target, const py::object& points, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  SurfacePoints given(points, "loop point", "Points");
  given.ReadTolerance(arguments);
  dgg::LoopOptions options;
  arguments.ReadChoice("mode",
    { { "ThroughPoint", dgg::LoopOptions::ThroughPoint },
      { "AroundHandles", dgg::LoopOptions::AroundHandles }, { "Rope", dgg::LoopOptions::Rope } },
    options.Kind);
  arguments.Read("taut", options.Taut);
  arguments.Read("tape_width", options.TapeWidth);
  ThrowUnlessOk(dgg::CheckTapeWidth(options.TapeWidth));
  const SurfaceOrGraph input(target);
  const bool isThroughPoints = options.Kind != dgg::LoopOptions::AroundHandles;
  const Graph* const graph = isThroughPoints ? &input.GetGraph("Loops through points") : nullptr;
  dgg::Output outputs[2];
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(input.GetSurface());
    DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Loops"));
    std::optional<Graph::Session> session;
    dgg::GraphSession none;
    if (graph)
    {
      DGG_RETURN_IF_ERROR(given.Locate(context, options.Points));
      DGG_RETURN_IF_ERROR(dgg::CheckLoopOptions(options));
      session.emplace(*graph);
    }
    dgg::LoopSet loops;
    DGG_RETURN_IF_ERROR(dgg::FindLoops(context, session ? **session : none, options, loops));
    dgg::WriteLoops(context, options, loops, outputs[0]);
    dgg::WriteOffsetCurves(context, options, loops, outputs[1]);
    return dgg::Status::Success();
  });
  return py::make_tuple(ToPython(outputs[0]), ToPython(outputs[1]));
}
}

//------------------------------------------------------------------------------
void AddCurves(py::module_& module)
{
  module.def("paths", &FindPaths, py::arg("target"), py::arg("pairs"), PathsDocumentation);
  module.def("path_ends", &ReadPathEnds, py::arg("lines"), py::arg("number_of_points"),
    "Returns the first and the last point id of each line, in turn. `lines` is a tuple (offsets, "
    "ids). Raises an Error for a line without points and for an id that does not exist.");
  module.def(
    "loops", &FindLoops, py::arg("target"), py::arg("points") = py::none(), LoopsDocumentation);
}
}
