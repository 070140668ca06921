// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Arrays.h"
#include "Call.h"
#include "Module.h"
#include "Outputs.h"

#include "dggFormats.h"
#include "dggMeshArrays.h"
#include "dggNumberTypes.h"
#include "dggPointCloud.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace dggPython
{
namespace
{
constexpr const char* ReadDocumentation =
  R"(Points, cells and arrays of a file.

Coordinates keep all digits, and points their order. The file may be compressed by gzip.

Parameters
----------
path : str or os.PathLike
format : {"obj", "off", "pcd", "ply", "stl", "xyz"}
progress
    See the module. `memory_limit` and `number_of_threads` have no effect.

Returns
-------
SimpleNamespace
    points, cells, point_data, cell_data, field_data and warnings as described in the module; points
    are float32 where the file stores all coordinates so. "active" is a dict with the names of
    "normals", "tcoords" and "scalars" of the points, as far as there are such arrays.

Raises
------
ValueError
    For another format, and a truncated or damaged file. Messages do not contain the path.
OSError, MemoryError
    If the file does not exist or cannot be opened, or is too large.)";

constexpr const char* WriteDocumentation =
  R"(Write points, cells and arrays to a file.

An older file is replaced when the new one is complete. Without cells, all points with finite
coordinates become verts.

Parameters
----------
path : str or os.PathLike
format : {"obj", "off", "pcd", "ply", "stl", "xyz", "pcd_text", "pcd_compressed"}
    "pcd" is binary.
points : array_like, shape (n, 3)
    Stored as float32 if the type is float32.
verts, lines, polygons : array_like of int, shape (m, k), or tuple (offsets, ids), optional
point_data, cell_data, field_data : dict of str to array_like, optional
    Of "field_data", only the layout of a point cloud is used, "PCD.Dimensions" and "PCD.Viewpoint".
active : dict, optional
    Names of "normals", "tcoords" and "scalars" of the points.
progress
    See the module. `memory_limit` and `number_of_threads` have no effect.

Returns
-------
list of str
    Warnings.

Raises
------
ValueError
    For arrays that do not fit the points and cells, and data that the format cannot store.
OSError, MemoryError
    If the file cannot be written, or memory does not suffice. Messages do not contain the path.)";

/// Throws the exception for an outcome other than success. After an abort, the call has thrown.
void ThrowUnlessOk(const dgg::FileStatus& status)
{
  using Code = dgg::FileStatus::Code;
  if (status.IsOk())
  {
    return;
  }
  PyObject* const type = status.Kind == Code::NotFound                 ? PyExc_FileNotFoundError
    : status.Kind == Code::OutOfMemory                                 ? PyExc_MemoryError
    : status.Kind == Code::CannotOpen || status.Kind == Code::DiskFull ? PyExc_OSError
                                                                       : PyExc_ValueError;
  PyErr_SetString(type, status.Message.c_str());
  throw py::error_already_set();
}

std::string ToFileName(const py::object& path)
{
  return py::cast<std::string>(py::module_::import("os").attr("fsencode")(path));
}

dgg::FileFormat ToFormat(const std::string& name)
{
  // Names in the order of dgg::FileFormat.
  const char* const names[] = { "obj", "off", "pcd", "ply", "stl", "xyz", "pcd_text",
    "pcd_compressed" };
  const auto* const found = std::find(std::begin(names), std::end(names), name);
  if (found == std::end(names))
  {
    throw py::value_error("format: expected one of obj, off, pcd, ply, stl, xyz, pcd_text and "
                          "pcd_compressed, got " +
      name);
  }
  return static_cast<dgg::FileFormat>(found - std::begin(names));
}

/// Returns the text of a file, whose encoding may be damaged.
py::str ToText(const std::string& text)
{
  PyObject* const decoded =
    PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace");
  if (!decoded)
  {
    throw py::error_already_set();
  }
  return py::reinterpret_steal<py::str>(decoded);
}

py::list ToList(const std::vector<std::string>& texts)
{
  py::list list;
  for (const std::string& text : texts)
  {
    list.append(ToText(text));
  }
  return list;
}

py::dict ToDict(std::vector<dgg::DataArray>&& arrays)
{
  py::dict dict;
  for (dgg::DataArray& array : arrays)
  {
    if (!array.Name.empty())
    {
      dict[ToText(array.Name)] = std::visit(
        [&array](auto& values) {
          return ToArray(std::move(values), static_cast<std::size_t>(array.Components));
        },
        array.Values);
    }
  }
  return dict;
}

py::tuple ToTuple(dgg::CellList& cells)
{
  return py::make_tuple(ToArray(std::move(cells.Offsets)), ToArray(std::move(cells.Connectivity)));
}

py::object ReadMesh(const py::object& path, const std::string& format, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  const std::string fileName = ToFileName(path);
  const dgg::FileFormat type = ToFormat(format);
  dgg::MeshData mesh;
  dgg::FileStatus status;
  call.Run([&] {
    status = dgg::ReadMesh(type, fileName, call.GetProgress(), mesh);
    return dgg::Status::Success();
  });
  ThrowUnlessOk(status);

  py::dict active;
  for (const dgg::DataArray& array : mesh.PointArrays)
  {
    if (array.Role != dgg::ArrayRole::None)
    {
      active[array.Role == dgg::ArrayRole::Normals ? "normals"
          : array.Role == dgg::ArrayRole::TCoords  ? "tcoords"
                                                   : "scalars"] = ToText(array.Name);
    }
  }
  py::dict cells;
  cells["verts"] = ToTuple(mesh.Verts);
  cells["lines"] = ToTuple(mesh.Lines);
  cells["polygons"] = ToTuple(mesh.Polygons);
  py::object result = MakeNamespace();
  result.attr("points") = mesh.HasFloatPoints
    ? ToArray(std::vector<float>(mesh.Points.begin(), mesh.Points.end()), 3)
    : ToArray(std::move(mesh.Points), 3);
  result.attr("cells") = cells;
  result.attr("point_data") = ToDict(std::move(mesh.PointArrays));
  result.attr("cell_data") = ToDict(std::move(mesh.CellArrays));
  result.attr("field_data") =
    mesh.Layout ? ToDict(dgg::MakeLayoutArrays(*mesh.Layout)) : py::dict();
  result.attr("active") = active;
  result.attr("warnings") = ToList(mesh.Warnings);
  return result;
}

dgg::CellList ToCellList(const py::object& object, const char* name)
{
  const Cells cells(object, name);
  const dgg::CellArrays arrays = cells.Get();
  dgg::CellList list;
  if (arrays.NumberOfCells > 0)
  {
    list.Offsets.assign(arrays.Offsets, arrays.Offsets + arrays.NumberOfCells + 1);
    list.Connectivity.assign(arrays.Ids, arrays.Ids + arrays.NumberOfIds);
  }
  return list;
}

/// Returns a copy. Types that files cannot hold become double, and truth values become bytes.
dgg::DataArray ToDataArray(const std::string& name, const py::handle& object)
{
  const py::array array = py::array::ensure(object);
  const char kind = array ? array.dtype().kind() : 'O';
  if (!array || std::string("biuf").find(kind) == std::string::npos || array.ndim() < 1 ||
    array.ndim() > 2 || (array.ndim() == 2 && array.shape(1) == 0))
  {
    PyErr_Clear();
    throw py::value_error(name + ": expected numbers of the shape (n,) or (n, k)");
  }
  dgg::DataArray result;
  result.Name = name;
  result.Components = array.ndim() == 2 ? static_cast<int>(array.shape(1)) : 1;
  const auto copy = [&](auto zero) {
    using Value = decltype(zero);
    const Array<Value> values = Array<Value>::ensure(array);
    if (!values)
    {
      throw py::error_already_set();
    }
    result.Values = std::vector<Value>(values.data(), values.data() + values.size());
  };
  const char fileKind = kind == 'i' ? 'I' : kind == 'f' ? 'F' : 'U';
  if (!dgg::DispatchNumber({ fileKind, static_cast<std::size_t>(array.itemsize()) }, copy))
  {
    copy(0.0);
  }
  return result;
}

std::vector<dgg::DataArray> ToDataArrays(const py::dict& dict)
{
  std::vector<dgg::DataArray> arrays;
  for (const auto& [name, values] : dict)
  {
    arrays.push_back(ToDataArray(py::cast<std::string>(name), values));
  }
  return arrays;
}

/// Returns the values of a named array as doubles; empty if there is none.
std::vector<double> ToDoubles(const py::dict& dict, const char* name)
{
  if (!dict.contains(name))
  {
    return {};
  }
  const Array<double> values = ToNumbers(dict[name], name);
  return { values.data(), values.data() + values.size() };
}

/// Returns the index of the active array of one kind; -1 for none.
int FindActive(const py::dict& active, const char* kind, const std::vector<dgg::DataArray>& arrays)
{
  for (std::size_t i = 0; active.contains(kind) && i < arrays.size(); ++i)
  {
    if (arrays[i].Name == py::cast<std::string>(active[kind]))
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

py::list WriteMesh(const py::object& path, const std::string& format, const py::object& points,
  const py::object& verts, const py::object& lines, const py::object& polygons,
  const py::dict& pointData, const py::dict& cellData, const py::dict& fieldData,
  const py::dict& active, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  const std::string fileName = ToFileName(path);
  const dgg::FileFormat type = ToFormat(format);
  dgg::MeshData mesh;
  const Array<double> coordinates = ToTable(points, 3, "points");
  mesh.Points.assign(coordinates.data(), coordinates.data() + coordinates.size());
  mesh.HasFloatPoints = py::isinstance<py::array_t<float>>(points);
  mesh.Verts = ToCellList(verts, "verts");
  mesh.Lines = ToCellList(lines, "lines");
  mesh.Polygons = ToCellList(polygons, "polygons");
  if (mesh.Verts.GetCount() + mesh.Lines.GetCount() + mesh.Polygons.GetCount() == 0)
  {
    dgg::AddVertsOfFinitePoints(mesh);
  }
  mesh.PointArrays = ToDataArrays(pointData);
  dgg::SetRoles(mesh.PointArrays,
    { FindActive(active, "normals", mesh.PointArrays),
      FindActive(active, "tcoords", mesh.PointArrays),
      FindActive(active, "scalars", mesh.PointArrays) });
  mesh.CellArrays = ToDataArrays(cellData);
  dgg::SetRoles(mesh.CellArrays, {});
  mesh.Layout = dgg::ReadLayout(mesh.GetNumberOfPoints(), ToDoubles(fieldData, dgg::DimensionsName),
    ToDoubles(fieldData, dgg::ViewpointName));
  dgg::FileStatus status;
  call.Run([&] {
    status = dgg::WriteMesh(type, fileName, mesh, call.GetProgress());
    return dgg::Status::Success();
  });
  ThrowUnlessOk(status);
  return ToList(mesh.Warnings);
}
}

//------------------------------------------------------------------------------
void AddFormats(py::module_& module)
{
  module.def("read_mesh", &ReadMesh, py::arg("path"), py::arg("format"), ReadDocumentation);
  module.def("write_mesh", &WriteMesh, py::arg("path"), py::arg("format"), py::arg("points"),
    py::arg("verts") = py::none(), py::arg("lines") = py::none(), py::arg("polygons") = py::none(),
    py::arg("point_data") = py::dict(), py::arg("cell_data") = py::dict(),
    py::arg("field_data") = py::dict(), py::arg("active") = py::dict(), WriteDocumentation);
}
}
