// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Graph.h"

#include "Arguments.h"
#include "Arrays.h"
#include "Call.h"
#include "Errors.h"
#include "GraphQueries.h"
#include "Module.h"
#include "Outputs.h"

#include "dggGraphBuildTask.h"
#include "dggOutput.h"
#include "dggStatus.h"

#include <utility>

namespace dggPython
{
namespace
{
constexpr const char* ClassDocumentation =
  R"(A discrete geodesic graph, in which shortest paths are geodesics up to a known error.

Parameters
----------
surface : Surface
accuracy : float
    Largest relative error of a distance, in [1e-6, 0.5].
construction : {"Guaranteed", "OneRelay", "Indirect", "SaddleVertexGraph"}
    Rule that selects the edges. The others serve for comparison.
number_of_neighbors : int
    Number of nearest points that a point of a SaddleVertexGraph may connect to.
memory_limit, number_of_threads, progress
    See the module.

Raises
------
Error
    For an option that is out of range, and if the graph would take more memory than the limit.

Any number of threads may search one graph. `arrays` and from_arrays() are for copies and files.)";

constexpr const char* FromArraysDocumentation =
  R"(The graph of a surface or a cloud from its arrays.

Parameters
----------
surface : Surface
    The points and cells that the graph was built from.
arrays : dict of arrays
    As `arrays` of a graph. Read-only arrays are used without a copy.

Raises
------
Error
    For arrays that are missing, damaged, or of another surface.)";

constexpr const char* EstimateDocumentation =
  R"(Predicts the size of a graph: a SimpleNamespace with edges, memory and peak (bytes).

The parameters are those of the class.)";

constexpr const char* LinesDocumentation =
  R"(The edges as lines between points of the surface, with the cell array "Length".)";

dgg::GraphOptions ReadOptions(Arguments& arguments)
{
  dgg::GraphOptions options;
  arguments.Read("accuracy", options.Accuracy);
  arguments.Read("number_of_neighbors", options.NumberOfNeighbors);
  arguments.ReadChoice("construction",
    { { "Guaranteed", dgg::GraphConstruction::Guaranteed },
      { "OneRelay", dgg::GraphConstruction::OneRelay },
      { "Indirect", dgg::GraphConstruction::Indirect },
      { "SaddleVertexGraph", dgg::GraphConstruction::SaddleVertexGraph } },
    options.Construction);
  ThrowUnlessOk(dgg::GraphBuilder::Check(options));
  return options;
}

dgg::Status RequireMesh(const Surface& surface)
{
  return surface.Get().IsCloud() ? dgg::InvalidInput("The surface is a point cloud")
                                     .At("Surface")
                                     .Fix("Build its graph by cloud_graph()")
                                 : dgg::Status::Success();
}

std::shared_ptr<Graph> BuildGraph(
  const std::shared_ptr<Surface>& surface, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  dgg::GraphOptions options = ReadOptions(arguments);
  dgg::GeodesicGraph graph;
  call.Run([&] {
    DGG_RETURN_IF_ERROR(RequireMesh(*surface));
    const dgg::TaskContext context = call.MakeContext(*surface);
    options.Progress = context.Progress;
    dgg::GraphEstimate estimate;
    return dgg::BuildGraph(
      context, dgg::GraphBuilder(surface->Get().GetMesh()), options, graph, estimate);
  });
  return Graph::Adopt(call, surface, graph);
}

py::object EstimateGraph(const Surface& surface, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  dgg::GraphOptions options = ReadOptions(arguments);
  dgg::GraphEstimate estimate;
  call.Run([&] {
    DGG_RETURN_IF_ERROR(RequireMesh(surface));
    const dgg::TaskContext context = call.MakeContext(surface);
    options.Progress = context.Progress;
    dgg::UseThreads(context, options);
    return dgg::GraphBuilder(surface.Get().GetMesh()).Estimate(options, estimate);
  });
  py::object result = MakeNamespace();
  result.attr("edges") = estimate.Edges;
  result.attr("memory") = estimate.Memory;
  result.attr("peak") = estimate.Peak;
  return result;
}

py::object GetLines(const Graph& graph, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  dgg::Output output;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(graph.GetSurface());
    const Graph::Session session(graph);
    return dgg::WriteGraphLines(context, session->GetSearch().GetGraph(), context.Progress, output);
  });
  return ToPython(output);
}

const char* GetConstruction(const Graph& graph)
{
  static const char* const names[] = { "Guaranteed", "OneRelay", "Indirect", "SaddleVertexGraph",
    "CloudCurvature", "CloudConstant", "CloudSpacing" };
  return names[static_cast<int>(graph.GetSummary().Info.Construction)];
}

/// Returns an owner of Python objects that any thread may destroy.
std::shared_ptr<const void> MakeOwner(const py::dict& arrays)
{
  return std::shared_ptr<const void>(new py::dict(arrays), [](const py::dict* owned) {
    const py::gil_scoped_acquire acquire;
    delete owned;
  });
}

/// Returns the key of the arrays, which is valid while they exist.
dgg::PreparedGraph::Key MakeKey(const dgg::GraphView& graph)
{
  return { reinterpret_cast<std::uintptr_t>(graph.Offsets),
    reinterpret_cast<std::uintptr_t>(graph.Targets) };
}
}

//------------------------------------------------------------------------------
std::shared_ptr<Graph> Graph::Adopt(Call& call, const std::shared_ptr<Surface>& surface,
  dgg::GeodesicGraph& graph, const std::vector<double>& radii, double voxelSize)
{
  dgg::Buffer<double> ownRadii(radii.size());
  std::copy(radii.begin(), radii.end(), ownRadii.begin());
  // The arrays take over the memory that the view refers to.
  const dgg::StoredGraph stored(graph.View(), { voxelSize, ownRadii.Data() });
  auto made = std::make_shared<Graph>();
  made->Owner = surface;
  const auto add = [&](int role, auto& values) {
    if (stored.HasRole(role))
    {
      made->Arrays[dgg::StoredGraph::GetName(role)] = MakeReadOnly(ToArray(std::move(values)));
    }
  };
  dgg::Buffer<std::int64_t> info;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(*surface);
    info = stored.MakeInfo(surface->Get(), context.Parallel);
    return dgg::Status::Success();
  });
  add(dgg::StoredGraph::Offsets, graph.Offsets);
  add(dgg::StoredGraph::Targets, graph.Targets);
  if (stored.GetView().WideLengths)
  {
    add(dgg::StoredGraph::Lengths, graph.WideLengths);
  }
  else
  {
    add(dgg::StoredGraph::Lengths, graph.Lengths);
  }
  add(dgg::StoredGraph::Angles, graph.Angles);
  add(dgg::StoredGraph::ArrivalAngles, graph.ArrivalAngles);
  add(dgg::StoredGraph::Radii, ownRadii);
  add(dgg::StoredGraph::Info, info);
  made->Prepare(call, stored);
  return made;
}

//------------------------------------------------------------------------------
std::shared_ptr<Graph> Graph::Read(
  Call& call, const std::shared_ptr<Surface>& surface, const py::dict& arrays)
{
  auto made = std::make_shared<Graph>();
  made->Owner = surface;
  dgg::StoredGraph::Arrays found;
  for (int role = 0; role < dgg::StoredGraph::NumberOfRoles; ++role)
  {
    const char* name = dgg::StoredGraph::GetName(role);
    if (!arrays.contains(name))
    {
      continue;
    }
    auto array = py::cast<py::array>(arrays[name]);
    array = array.writeable() ? MakeReadOnly(array.attr("copy")()) : array;
    made->Arrays[name] = array;
    found[role] = ToStoredArray(array);
  }
  dgg::StoredGraph stored;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(*surface);
    return stored.Read(found, surface->Get(), context.Parallel);
  });
  made->Prepare(call, stored);
  return made;
}

//------------------------------------------------------------------------------
void Graph::Prepare(Call& call, const dgg::StoredGraph& graph)
{
  const std::shared_ptr<const void> owner = MakeOwner(this->Arrays);
  call.Run([&] {
    this->Prepared =
      dgg::PreparedGraph::Make(graph, MakeKey(graph.GetView()), owner, this->Owner->Get());
    return dgg::Status::Success();
  });
}

//------------------------------------------------------------------------------
SurfaceOrGraph::SurfaceOrGraph(const py::handle& object)
{
  if (py::isinstance<Graph>(object))
  {
    this->TheGraph = py::cast<std::shared_ptr<Graph>>(object);
    this->TheSurface =
      std::shared_ptr<const Surface>(this->TheGraph, &this->TheGraph->GetSurface());
  }
  else if (py::isinstance<Surface>(object))
  {
    this->TheSurface = py::cast<std::shared_ptr<Surface>>(object);
  }
  else
  {
    throw py::type_error("expected a Surface or a Graph, got " +
      py::cast<std::string>(py::str(py::type::handle_of(object))));
  }
}

//------------------------------------------------------------------------------
const Graph& SurfaceOrGraph::GetGraph(const char* what) const
{
  ThrowUnlessOk(this->TheGraph
      ? dgg::Status::Success()
      : dgg::InvalidInput(what, " need a graph").At("Graph").Fix("Pass a Graph of the surface"));
  return *this->TheGraph;
}

//------------------------------------------------------------------------------
void AddGraph(py::module_& module)
{
  py::class_<Graph, std::shared_ptr<Graph>> type(module, "Graph", ClassDocumentation);
  type.def(py::init(&BuildGraph), py::arg("surface"))
    .def_static(
      "from_arrays",
      [](const std::shared_ptr<Surface>& surface, const py::dict& arrays,
        const py::kwargs& keywords) {
        Arguments arguments(keywords);
        Call call(arguments);
        return Graph::Read(call, surface, arrays);
      },
      py::arg("surface"), py::arg("arrays"), FromArraysDocumentation)
    .def_static("estimate", &EstimateGraph, py::arg("surface"), EstimateDocumentation)
    .def("lines", &GetLines, LinesDocumentation)
    .def("release", &Graph::Release, "Releases the data that calls on this graph reuse.")
    .def_property_readonly(
      "surface", [](const Graph& graph) { return graph.GetSurface().shared_from_this(); })
    .def_property_readonly(
      "arrays", [](const Graph& graph) { return graph.GetArrays().attr("copy")(); },
      "Arrays of the graph by name, read-only.")
    .def_property_readonly(
      "accuracy", [](const Graph& graph) { return graph.GetSummary().Info.Accuracy; })
    .def_property_readonly("construction", &GetConstruction)
    .def_property_readonly("number_of_neighbors",
      [](const Graph& graph) { return graph.GetSummary().Info.NumberOfNeighbors; })
    .def_property_readonly(
      "is_guaranteed", [](const Graph& graph) { return graph.GetSummary().Info.IsGuaranteed(); })
    .def_property_readonly(
      "number_of_edges", [](const Graph& graph) { return graph.GetSummary().NumberOfEdges; })
    .def_property_readonly(
      "memory_size", [](const Graph& graph) { return graph.GetSummary().MemorySize; })
    .def_property_readonly("search_memory_size", &Graph::GetSearchMemorySize,
      "Bytes of the data that calls on this graph reuse.");
  AddGraphQueries(type);
}
}
