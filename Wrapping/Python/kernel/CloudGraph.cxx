// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Arrays.h"
#include "Call.h"
#include "Errors.h"
#include "Graph.h"
#include "Module.h"
#include "Outputs.h"

#include "dggCloudGraphTask.h"

#include <utility>

namespace dggPython
{
namespace
{
constexpr const char* CloudDocumentation =
  R"(The graph of a point cloud.

Parameters
----------
surface : Surface
    A cloud: Surface(points, cloud=True).
scheme : {"C", "B", "A"}
    What determines the maximum length of the edges of a point: the local spacing, a constant, or
    the curvature.
offset_in_voxels : float
    Radius of the balls that form the band; 0 for an automatic one.
resolution : int
    Number of voxels along the longest side; 0 for an automatic one.
alpha : float
    Parameter of the scheme; 0 for its default.
accuracy : float
    Relative error by which edges are removed; 0 keeps all.
arc_length_weights : bool
    Estimate arc lengths from normals; otherwise edges have the lengths of chords.
normals : array_like, shape (n, 3), optional
    Default: estimated from neighbors.
oriented_normals : bool
    True if all given normals point to the same side.
memory_limit, number_of_threads, progress
    See the module.

Returns
-------
SimpleNamespace
    graph (a Graph); components (int32, shape (n,)), -1 for points that are not finite;
    component_sizes; statistics, a dict of numbers; warnings.

Raises
------
Error
    For an option that is out of range, and if memory is insufficient.

References
----------
Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological University, 2019, chapter 5:
the band and the schemes "Curvature" and "Constant".)";

/// Options with the normals they refer to.
struct CloudArguments
{
  CloudArguments(Arguments& arguments, const Surface& surface)
  {
    dgg::CloudGraphOptions& options = this->Options;
    arguments.ReadChoice("scheme",
      { { "A", dgg::CloudScheme::Curvature }, { "B", dgg::CloudScheme::Constant },
        { "C", dgg::CloudScheme::Spacing } },
      options.Scheme);
    arguments.Read("offset_in_voxels", options.OffsetInVoxels);
    arguments.Read("resolution", options.Resolution);
    arguments.Read("alpha", options.Alpha);
    arguments.Read("accuracy", options.Accuracy);
    arguments.Read("arc_length_weights", options.ArcLengthWeights);
    arguments.Read("oriented_normals", options.HasOrientedNormals);
    if (const py::object normals = arguments.Take("normals"))
    {
      this->Normals = ToTable(normals, 3, "normals");
      if (this->Normals.size() != 3 * surface.GetNumberOfPoints())
      {
        throw py::value_error("normals: expected one per point, " +
          std::to_string(surface.GetNumberOfPoints()) + ", got " +
          std::to_string(this->Normals.size() / 3));
      }
      options.Normals = this->Normals.data();
    }
    options.HasOrientedNormals = options.HasOrientedNormals && options.Normals;
  }

  Array<double> Normals{ 0 };
  dgg::CloudGraphOptions Options;
};

py::dict ToDict(const dgg::CloudGraphStatistics& statistics)
{
  py::dict dict;
  dict["number_of_unused_points"] = statistics.UnusedPoints;
  dict["number_of_outliers"] = statistics.Outliers;
  dict["number_of_coincident_points"] = statistics.CoincidentPoints;
  dict["spacing"] = statistics.Spacing;
  dict["noise"] = statistics.Noise;
  dict["noise_by_radius"] = statistics.NoiseByRadius;
  dict["off_surface_share"] = statistics.OffSurface;
  dict["scatter"] = statistics.Scatter;
  dict["voxel_size"] = statistics.VoxelSize;
  dict["offset_in_voxels"] = statistics.OffsetInVoxels;
  dict["resolution"] = statistics.Resolution;
  dict["alpha"] = statistics.Alpha;
  dict["reach"] = statistics.Reach;
  return dict;
}

py::object MakeCloudGraph(const std::shared_ptr<Surface>& surface, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  const CloudArguments cloud(arguments, *surface);
  dgg::CloudGraph graph;
  dgg::CloudGraphStatistics statistics;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(*surface);
    return dgg::BuildCloudGraph(context, cloud.Options, context.Progress, graph, statistics);
  });
  py::object result = MakeNamespace();
  result.attr("graph") = Graph::Adopt(call, surface, graph.Graph, graph.Radii, graph.VoxelSize);
  result.attr("components") = ToArray(std::move(graph.Components));
  result.attr("component_sizes") = ToArray(std::move(graph.ComponentSizes));
  result.attr("statistics") = ToDict(statistics);
  result.attr("warnings") = RenderWarnings(dgg::DescribeCloudGraph(cloud.Options, statistics));
  return result;
}
}

//------------------------------------------------------------------------------
void AddCloudGraph(py::module_& module)
{
  module.def("cloud_graph", &MakeCloudGraph, py::arg("surface"), CloudDocumentation);
}
}
