// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Call.h"
#include "Distances.h"
#include "Errors.h"
#include "Graph.h"
#include "Module.h"
#include "Outputs.h"
#include "SurfacePoints.h"

#include "dggOutput.h"
#include "dggPropagationSession.h"
#include "dggSampleSearch.h"
#include "dggVoronoiTask.h"

#include <limits>

namespace dggPython
{
namespace
{
constexpr const char* VoronoiDocumentation =
  R"(Voronoi cells of sites: the points of a surface or a cloud that are nearest to each site.

Parameters
----------
target : Graph, or Surface for a preview
sites : surface points
centroidal : bool
    Move the sites to the centers of their cells first.
number_of_iterations : int
tolerance : float
    Stop when no site moves by more than this fraction of the mean edge length.
generate_cells : bool
    Otherwise only the nearest site of each point is found. Clouds have no cells.
preview : bool
    Find the nearest site of each point by virtual sources, in milliseconds; no bound of the error.
refine_boundaries : bool
    Move points of boundaries to where both distances are equal. Boundaries are exact where
    triangles are large for the accuracy of the graph.
unreached_value : float
    Distance of unreached points. Default: NaN.
distance_array_name, source_array_name : str
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
tuple of four SimpleNamespace
    The surface, with the point data "GeodesicDistance" and "GeodesicSource"; boundaries, lines with
    the cell data "SiteId" (two sites); cells, polygons with "SiteId", "CellArea" and "FaceId"; and
    sites, points with "SiteId" and "CellArea".

Raises
------
Error
    For an invalid site.)";

constexpr const char* SamplesDocumentation =
  R"(Farthest-point samples of a surface or a cloud.

Parameters
----------
graph : Graph
start : surface points, optional
    First samples.
number_of_samples : int
    Including those of `start`.
first_sample : int
    Id of the first sample without `start`; -1 for an automatic one.
covering_radius : float
    Stop when no point is farther from the samples than this distance.
in_faces : bool
    Place samples inside triangles as well.
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
SimpleNamespace
    Points with the point data "CoveringRadius", "vtkOriginalPointIds", "FaceId" and "Barycentric".

Raises
------
Error
    For an invalid point or option.

References
----------
G. Peyre, L. D. Cohen, "Geodesic remeshing using front propagation", Int. J. Comput. Vis. 69(1),
2006.)";

//------------------------------------------------------------------------------
dgg::VoronoiOptions ReadVoronoiOptions(Arguments& arguments)
{
  dgg::VoronoiOptions options;
  bool wantCells = true;
  options.IsRefined = true;
  options.DistanceName = DistanceName;
  options.SourceName = SourceName;
  options.UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  arguments.Read("centroidal", options.IsCentroidal);
  arguments.Read("number_of_iterations", options.Moving.NumberOfIterations);
  arguments.Read("tolerance", options.Moving.Tolerance);
  arguments.Read("generate_cells", wantCells);
  arguments.Read("preview", options.IsPreview);
  arguments.Read("refine_boundaries", options.IsRefined);
  arguments.Read("unreached_value", options.UnreachedValue);
  arguments.Read("distance_array_name", options.DistanceName);
  arguments.Read("source_array_name", options.SourceName);
  options.LabelsOnly = !wantCells;
  ThrowUnlessOk(options.Check());
  return options;
}

py::object FindVoronoi(
  const py::object& target, const py::object& sites, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  SurfacePoints points(sites, "site", "Sites");
  points.ReadTolerance(arguments);
  const dgg::VoronoiOptions options = ReadVoronoiOptions(arguments);
  const SurfaceOrGraph input(target);
  const Graph* const graph =
    options.IsPreview ? nullptr : &input.GetGraph("Cells that are not a preview");
  const SessionPool<dgg::PropagationSession>::Loan preview(
    input.GetSurface().GetPool<dgg::PropagationSession>());
  dgg::Output outputs[4];
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(input.GetSurface());
    dgg::VoronoiResult result;
    DGG_RETURN_IF_ERROR(points.Locate(context, result.Sites, &outputs[0].Warnings));
    DGG_RETURN_IF_ERROR(graph
        ? dgg::FindVoronoiCells(context, *Graph::Session(*graph), options, result)
        : dgg::FindVoronoiPreview(context, *preview, result));
    outputs[0].Warn(result.QualityWarning);
    dgg::WriteVoronoi(context, options, result, outputs[0], outputs[1], outputs[2], outputs[3]);
    return dgg::Status::Success();
  });
  return py::make_tuple(
    ToPython(outputs[0]), ToPython(outputs[1]), ToPython(outputs[2]), ToPython(outputs[3]));
}

//------------------------------------------------------------------------------
py::object FindSamples(const Graph& graph, const py::object& start, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  SurfacePoints given(start, "start", "Start");
  given.ReadTolerance(arguments);
  dgg::SamplerOptions options;
  dgg::Offset first = dgg::NoId;
  arguments.Read("number_of_samples", options.NumberOfSamples);
  arguments.Read("first_sample", first);
  arguments.Read("covering_radius", options.CoveringRadius);
  arguments.Read("in_faces", options.InFaces);
  ThrowUnlessOk(dgg::CheckSamplerOptions(options));
  dgg::Output output;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(graph.GetSurface());
    DGG_RETURN_IF_ERROR(given.IsEmpty() ? dgg::SetFirstSample(context.Surface, first, options)
                                        : given.Locate(context, options.Given));
    const Graph::Session session(graph);
    std::vector<dgg::SurfaceSample> samples;
    DGG_RETURN_IF_ERROR(dgg::FindSamples(context, *session, options, samples));
    dgg::WriteSamples(context, options, samples, output);
    return dgg::Status::Success();
  });
  return ToPython(output);
}
}

//------------------------------------------------------------------------------
void AddRegions(py::module_& module)
{
  module.def("voronoi", &FindVoronoi, py::arg("target"), py::arg("sites"), VoronoiDocumentation);
  module.def(
    "samples", &FindSamples, py::arg("graph"), py::arg("start") = py::none(), SamplesDocumentation);
}
}
