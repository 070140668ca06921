// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GraphQueries.h"

#include "Distances.h"
#include "Errors.h"

#include "dggDistanceRows.h"
#include "dggGraphDistances.h"
#include "dggMatrixSearch.h"

#include <string>
#include <utility>

namespace dggPython
{
namespace
{
constexpr const char* DistanceDocumentation =
  "Distances from the nearest source.\n\n"
  "Parameters\n----------\n" DGG_DISTANCE_DOCUMENTATION(
    "correction : bool\n"
    "    Estimate distances within the accuracy, instead of lengths of paths in the graph.\n"
    "search : {\"Certified\", \"LabelCorrecting\", \"Dijkstra\"}\n"
    "generate_upper_bound : bool\n"
    "    Add \"GeodesicUpperBound\", the lengths of paths.\n"
    "upper_bound_array_name : str\n",
    "See the class.");

constexpr const char* MatrixDocumentation =
  R"(Distances of all pairs of a row and a column, as lengths of paths.

Parameters
----------
rows : surface points
columns : surface points, optional
    Default: the rows.
maximum_distance : float
    Larger distances become `unreached_value`.
unreached_value : float
    Default: NaN.
generate_table, with_copy : bool
    Reserve memory for a table with the same entries, or for another copy of the matrix, which the
    caller makes after the call.
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
numpy.ndarray of float64, shape (rows, columns)

Raises
------
Error
    For an invalid point, and if memory is insufficient.)";

constexpr const char* NeighborhoodDocumentation =
  R"(The points around each row and their distances, as compressed rows.

Parameters
----------
rows : surface points
maximum_distance : float
    Largest distance from a row.
correction : bool
    Estimate distances within the accuracy, instead of lengths of paths in the graph.
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
tuple of numpy.ndarray
    Offsets (int64), columns (int32) and distances (float64): row i has the entries from offsets[i]
    to offsets[i + 1], as in scipy.sparse.csr_array((distances, columns, offsets)).

Raises
------
Error
    For an invalid point, and if memory is insufficient.)";

//------------------------------------------------------------------------------
py::object ComputeDistance(
  const Graph& graph, const py::object& sources, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Distances distances(sources, arguments);
  bool correct = true;
  bool wantUpperBound = false;
  std::string upperBoundName = "GeodesicUpperBound";
  dgg::SearchMethod method = dgg::SearchOptions().Method;
  arguments.Read("correction", correct);
  arguments.Read("generate_upper_bound", wantUpperBound);
  arguments.Read("upper_bound_array_name", upperBoundName);
  arguments.ReadChoice("search",
    { { "Certified", dgg::SearchMethod::Certified },
      { "LabelCorrecting", dgg::SearchMethod::LabelCorrecting },
      { "Dijkstra", dgg::SearchMethod::Dijkstra } },
    method);
  if (wantUpperBound)
  {
    distances.RequestUpperBound(upperBoundName);
  }
  return distances.Run(call, graph.GetSurface(), nullptr,
    [&](const dgg::TaskContext& context, dgg::DistanceTask& task) {
      const Graph::Session session(graph);
      return dgg::FindGraphDistances(context, *session, method, correct, task);
    });
}

//------------------------------------------------------------------------------
/// Arguments of matrices.
struct MatrixArguments
{
  MatrixArguments(Arguments& arguments, const py::object& rows, const py::object& columns)
    : Rows(rows, "row", "Rows")
    , Columns(columns, "column", "Columns")
    , IsSymmetric(columns.is_none())
  {
    this->Rows.ReadTolerance(arguments);
    this->Columns.ReadTolerance(arguments);
    arguments.ReadLength("maximum_distance", this->Radius);
    arguments.Read("unreached_value", this->UnreachedValue);
    arguments.Read("generate_table", this->WithTable);
    arguments.Read("with_copy", this->WithCopy);
  }

  SurfacePoints Rows;
  SurfacePoints Columns;
  bool IsSymmetric;
  bool WithTable = false;
  bool WithCopy = false;
  double Radius = dgg::Infinity;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
};

dgg::Status FindMatrix(const dgg::TaskContext& context, const Graph& graph,
  const MatrixArguments& arguments, dgg::Buffer<double>& matrix)
{
  std::vector<dgg::SurfacePoint> rows;
  std::vector<dgg::SurfacePoint> columns;
  DGG_RETURN_IF_ERROR(arguments.Rows.Locate(context, rows));
  if (!arguments.IsSymmetric)
  {
    DGG_RETURN_IF_ERROR(arguments.Columns.Locate(context, columns));
  }
  DGG_RETURN_IF_ERROR(dgg::AllocateMatrix(context.Memory, rows.size(),
    arguments.IsSymmetric ? rows.size() : columns.size(), arguments.WithTable, arguments.WithCopy,
    matrix));
  const Graph::Session session(graph);
  return dgg::FindMatrix(context, *session, rows, arguments.IsSymmetric ? nullptr : &columns,
    arguments.Radius, arguments.UnreachedValue, matrix.Data());
}

py::object ComputeMatrix(
  const Graph& graph, const py::object& rows, const py::object& columns, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  const MatrixArguments options(arguments, rows, columns);
  const std::size_t count = (options.IsSymmetric ? options.Rows : options.Columns).Size();
  dgg::Buffer<double> matrix;
  call.Run(
    [&] { return FindMatrix(call.MakeContext(graph.GetSurface()), graph, options, matrix); });
  return ToArray(std::move(matrix))
    .reshape(std::vector<py::ssize_t>{ -1, static_cast<py::ssize_t>(count) });
}

//------------------------------------------------------------------------------
py::object ComputeNeighborhood(
  const Graph& graph, const py::object& rows, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  SurfacePoints points(rows, "row", "Rows");
  double radius = dgg::Infinity;
  bool correct = false;
  points.ReadTolerance(arguments);
  arguments.ReadLength("maximum_distance", radius);
  arguments.Read("correction", correct);
  dgg::DistanceRows found;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(graph.GetSurface());
    std::vector<dgg::GeodesicSource> sources;
    DGG_RETURN_IF_ERROR(points.Locate(context, sources));
    const Graph::Session session(graph);
    return dgg::FindDistanceRows(context, *session, sources, radius, correct, found);
  });
  return py::make_tuple(ToArray(std::move(found.Offsets)), ToArray(std::move(found.Columns)),
    ToArray(std::move(found.Distances)));
}
}

//------------------------------------------------------------------------------
void AddGraphQueries(py::class_<Graph, std::shared_ptr<Graph>>& type)
{
  type.def("distance", &ComputeDistance, py::arg("sources"), DistanceDocumentation)
    .def("matrix", &ComputeMatrix, py::arg("rows"), py::arg("columns") = py::none(),
      MatrixDocumentation)
    .def("neighborhood", &ComputeNeighborhood, py::arg("rows"), NeighborhoodDocumentation);
}
}
