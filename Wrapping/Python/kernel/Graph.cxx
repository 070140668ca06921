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
stored : dict of arrays, optional
    As for from_arrays(). The graph in these arrays is used instead if it belongs to the surface. If
    not, a warning states the reason; for a cloud it is an error.
must_match : bool
    Use a stored graph only if it was built with the three parameters above.
accept_coarser_graph : bool
    Omit the warning that the stored graph does not guarantee the `accuracy` that is given.
memory_limit, number_of_threads, progress
    See the module.

Raises
------
Error
    For an option that is out of range, and if the graph would take more memory than the limit.

Any number of threads may search one graph. `arrays` and from_arrays() are for copies and files.

References
----------
X. Wang et al., "Discrete geodesic graph (DGG) for computing geodesic distances on polyhedral
surfaces", CAGD 52-53, 2017; Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological
University, 2019.)";

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

constexpr const char* InfoDocumentation =
  R"(The parameters of the graph in stored arrays, as a SimpleNamespace.

Its attributes are is_cloud, is_guaranteed, construction, accuracy (None for a SaddleVertexGraph),
number_of_neighbors, merge_coincident_points and merge_tolerance.

Raises
------
Error
    For an array "DGG.Info" that is missing, damaged or of another version.)";

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

/// Arrays of a graph by name. Writable arrays are copied, because callers could change them.
struct StoredArrays
{
  explicit StoredArrays(const py::object& arrays)
  {
    for (int role = 0; arrays && role < dgg::StoredGraph::NumberOfRoles; ++role)
    {
      const char* name = dgg::StoredGraph::GetName(role);
      if (arrays.contains(name))
      {
        auto array = py::cast<py::array>(arrays[name]);
        array = array.writeable() ? MakeReadOnly(array.attr("copy")()) : array;
        this->Named[name] = array;
        this->ByRole[role] = ToStoredArray(array);
      }
    }
  }

  py::dict Named;
  dgg::StoredGraph::Arrays ByRole;
};

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

const char* GetConstruction(const dgg::GraphInfo& info)
{
  static const char* const names[] = { "Guaranteed", "OneRelay", "Indirect", "SaddleVertexGraph",
    "A", "B", "C" };
  return names[static_cast<int>(info.Construction)];
}

py::object ReadInfo(const py::dict& arrays)
{
  dgg::StoredGraph graph;
  ThrowUnlessOk(graph.ReadInfo(StoredArrays(arrays).ByRole[dgg::StoredGraph::Info]));
  const dgg::GraphInfo& info = graph.GetView().Info;
  const bool hasAccuracy = info.Construction != dgg::GraphConstruction::SaddleVertexGraph;
  py::object result = MakeNamespace();
  result.attr("is_cloud") = info.Kind == dgg::GraphKind::Cloud;
  result.attr("is_guaranteed") = info.IsGuaranteed();
  result.attr("construction") = GetConstruction(info);
  result.attr("accuracy") =
    hasAccuracy ? py::object(py::float_(info.Accuracy)) : py::object(py::none());
  result.attr("number_of_neighbors") = info.NumberOfNeighbors;
  result.attr("merge_coincident_points") = graph.GetDomain().Kind == dgg::Domain::MergedSurface;
  result.attr("merge_tolerance") = graph.GetDomain().MergeTolerance;
  return result;
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
  py::dict arrays;
  const auto add = [&](int role, auto& values) {
    if (stored.HasRole(role))
    {
      arrays[dgg::StoredGraph::GetName(role)] = MakeReadOnly(ToArray(std::move(values)));
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
  return Adopt(call, surface, stored, arrays);
}

//------------------------------------------------------------------------------
std::shared_ptr<Graph> Graph::Read(
  Call& call, const std::shared_ptr<Surface>& surface, const py::dict& arrays)
{
  const StoredArrays given(arrays);
  dgg::StoredGraph stored;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(*surface);
    return stored.Read(given.ByRole, surface->Get(), context.Parallel);
  });
  const std::shared_ptr<Graph> made = Adopt(call, surface, stored, given.Named);
  made->Stored = true;
  return made;
}

//------------------------------------------------------------------------------
std::shared_ptr<Graph> Graph::ReadOrBuild(
  const std::shared_ptr<Surface>& surface, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  dgg::GraphOptions options = ReadOptions(arguments);
  bool mustMatch = false;
  bool acceptsCoarser = !arguments.Take("accuracy");
  const bool canAccept = static_cast<bool>(arguments.Take("accept_coarser_graph"));
  arguments.Read("must_match", mustMatch);
  arguments.Read("accept_coarser_graph", acceptsCoarser);
  const StoredArrays given(arguments.Take("stored"));
  const bool hasStored = !given.Named.empty();
  dgg::StoredGraph stored;
  dgg::GeodesicGraph graph;
  std::string warning;
  bool usesStored = false;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(*surface);
    if (hasStored)
    {
      const dgg::Status status = stored.Read(given.ByRole, surface->Get(), context.Parallel);
      if (surface->Get().IsCloud())
      {
        usesStored = true;
        return status.IsOk() ? status : dgg::RequireCloudGraph(status.GetProblem());
      }
      if (status.GetCode() == dgg::Status::Code::OutOfMemory)
      {
        return status;
      }
      const dgg::GraphInfo& info = stored.GetView().Info;
      usesStored = status.IsOk() && !(mustMatch && !dgg::IsBuiltWith(info, options));
      warning = !status.IsOk()        ? dgg::DescribeReplacement(status.GetProblem(), options)
        : mustMatch || acceptsCoarser ? std::string()
                                      : dgg::DescribeAccuracy(info, options.Accuracy, canAccept);
    }
    if (usesStored)
    {
      return dgg::Status::Success();
    }
    DGG_RETURN_IF_ERROR(RequireMesh(*surface));
    options.Progress = context.Progress;
    dgg::GraphEstimate estimate;
    return dgg::BuildGraph(
      context, dgg::GraphBuilder(surface->Get().GetMesh()), options, graph, estimate);
  });
  const std::shared_ptr<Graph> made =
    usesStored ? Adopt(call, surface, stored, given.Named) : Adopt(call, surface, graph);
  made->Stored = usesStored;
  made->Damage = stored.GetDamage();
  made->Warnings.resize(warning.empty() ? 0 : 1, warning);
  return made;
}

//------------------------------------------------------------------------------
std::shared_ptr<Graph> Graph::Adopt(Call& call, const std::shared_ptr<Surface>& surface,
  const dgg::StoredGraph& graph, const py::dict& arrays)
{
  auto made = std::make_shared<Graph>();
  made->Owner = surface;
  made->Arrays = arrays;
  const std::shared_ptr<const void> owner = MakeOwner(arrays);
  call.Run([&] {
    made->Prepared =
      dgg::PreparedGraph::Make(graph, MakeKey(graph.GetView()), owner, surface->Get());
    return dgg::Status::Success();
  });
  return made;
}

//------------------------------------------------------------------------------
SurfaceOrGraph::SurfaceOrGraph(const py::handle& object)
{
  if (py::isinstance<Graph>(object))
  {
    this->OptionalGraph = py::cast<std::shared_ptr<Graph>>(object);
    this->Owner =
      std::shared_ptr<const Surface>(this->OptionalGraph, &this->OptionalGraph->GetSurface());
  }
  else if (py::isinstance<Surface>(object))
  {
    this->Owner = py::cast<std::shared_ptr<Surface>>(object);
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
  ThrowUnlessOk(this->OptionalGraph
      ? dgg::Status::Success()
      : dgg::InvalidInput(what, " need a graph").At("Graph").Fix("Pass a Graph of the surface"));
  return *this->OptionalGraph;
}

//------------------------------------------------------------------------------
void AddGraph(py::module_& module)
{
  py::class_<Graph, std::shared_ptr<Graph>> type(module, "Graph", ClassDocumentation);
  module.def("graph_info", &ReadInfo, py::arg("arrays"), InfoDocumentation);
  module.def(
    "is_graph_of_cloud",
    [](const py::dict& arrays) {
      return dgg::StoredGraph::IsOfCloud(StoredArrays(arrays).ByRole[dgg::StoredGraph::Info]);
    },
    py::arg("arrays"), "Returns true if stored arrays, which may be damaged, belong to a cloud.");
  type.def(py::init(&Graph::ReadOrBuild), py::arg("surface"))
    .def_static(
      "from_arrays",
      [](const std::shared_ptr<Surface>& surface, const py::dict& arrays,
        const py::kwargs& keywords) {
        Arguments arguments(keywords);
        Call call(arguments);
        return Graph::Read(call, surface, arrays);
      },
      py::arg("surface"), py::arg("arrays"), FromArraysDocumentation)
    .def_static(
      "check",
      [](const py::kwargs& keywords) {
        Arguments arguments(keywords);
        const Call call(arguments);
        ReadOptions(arguments);
        arguments.Finish();
      },
      "Raises an Error if the accuracy, the construction or the number of neighbors is wrong.")
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
    .def_property_readonly(
      "construction", [](const Graph& graph) { return GetConstruction(graph.GetSummary().Info); })
    .def_property_readonly("number_of_neighbors",
      [](const Graph& graph) { return graph.GetSummary().Info.NumberOfNeighbors; })
    .def_property_readonly(
      "is_guaranteed", [](const Graph& graph) { return graph.GetSummary().Info.IsGuaranteed(); })
    .def_property_readonly(
      "number_of_edges", [](const Graph& graph) { return graph.GetSummary().NumberOfEdges; })
    .def_property_readonly(
      "memory_size", [](const Graph& graph) { return graph.GetSummary().MemorySize; })
    .def_property_readonly("search_memory_size", &Graph::GetSearchMemorySize,
      "Bytes of the data that calls on this graph reuse.")
    .def_property_readonly(
      "is_stored", &Graph::IsStored, "True if the graph is that of the argument `stored`.")
    .def_property_readonly(
      "warnings", [](const Graph& graph) { return RenderWarnings(graph.GetWarnings()); })
    .def_property_readonly("damage", &Graph::GetDamage,
      "What is damaged in the argument `stored`; empty if it is intact or of another surface.");
  AddGraphQueries(type);
}
}
