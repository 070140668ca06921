// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Outputs.h"

#include "Arrays.h"
#include "Errors.h"

#include <cstddef>
#include <string>
#include <utility>
#include <variant>

namespace dggPython
{
namespace
{
py::dict ToDict(dgg::OutputArrays& arrays)
{
  py::dict dict;
  for (dgg::OutputArray& array : arrays)
  {
    const auto components = static_cast<std::size_t>(array.NumberOfComponents);
    dict[array.Name.c_str()] = std::visit(
      [components](auto& values) { return ToArray(std::move(values), components); }, array.Values);
  }
  return dict;
}

py::tuple ToTuple(dgg::OutputCells& cells)
{
  if (cells.Offsets.IsEmpty())
  {
    cells.Offsets = dgg::Buffer<dgg::Offset>(1);
    cells.Offsets[0] = 0;
  }
  return py::make_tuple(ToArray(std::move(cells.Offsets)), ToArray(std::move(cells.Points)));
}

py::object ToName(const std::string& name)
{
  return name.empty() ? py::object(py::none()) : py::object(py::str(name));
}

/// Returns a dict of the points of the input, their weights, and the cells of the input from which
/// points and cells are made; None if they are not known.
py::object ToOrigins(dgg::Output& output)
{
  if (!output.PointOrigins)
  {
    return py::none();
  }
  const std::size_t count = output.PointOrigins->Size();
  dgg::Buffer<dgg::Id> points(3 * count);
  dgg::Buffer<double> weights(3 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const dgg::PointOrigin& origin = (*output.PointOrigins)[i];
    std::copy(origin.Points.begin(), origin.Points.end(), points.begin() + 3 * i);
    std::copy(origin.Weights.begin(), origin.Weights.end(), weights.begin() + 3 * i);
  }
  py::dict origins;
  origins["points"] = ToArray(std::move(points), 3);
  origins["weights"] = ToArray(std::move(weights), 3);
  if (output.CellOrigins)
  {
    origins["cells"] = ToArray(std::move(*output.CellOrigins));
  }
  return origins;
}
}

//------------------------------------------------------------------------------
py::object MakeNamespace()
{
  return py::module_::import("types").attr("SimpleNamespace")();
}

//------------------------------------------------------------------------------
py::object ToPython(dgg::Output& output)
{
  py::dict cells;
  cells["verts"] = ToTuple(output.Verts);
  cells["lines"] = ToTuple(output.Lines);
  cells["polygons"] = ToTuple(output.Polygons);
  py::object result = MakeNamespace();
  result.attr("points") = ToArray(std::move(output.Points), 3);
  result.attr("cells") = cells;
  result.attr("point_data") = ToDict(output.PointData);
  result.attr("cell_data") = ToDict(output.CellData);
  result.attr("field_data") = ToDict(output.FieldData);
  py::dict active;
  active["points"] = ToName(output.PointScalars);
  active["cells"] = ToName(output.CellScalars);
  result.attr("active") = active;
  result.attr("origins") = ToOrigins(output);
  result.attr("warnings") = RenderWarnings(output.Warnings);
  return result;
}
}
