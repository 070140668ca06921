// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Arrays.h"
#include "Call.h"
#include "Distances.h"
#include "Errors.h"
#include "Module.h"
#include "Outputs.h"
#include "SurfacePoints.h"

#include "dggGraphicsInput.h"
#include "dggGraphicsTask.h"
#include "dggOutput.h"

namespace dggPython
{
namespace
{
constexpr const char* GraphicsDocumentation =
  R"(Smooth colors on a surface, defined by curves and regions (Poisson vector graphics).

Parameters
----------
surface : Surface
curves : dict, optional
    "points", shape (n, 3), and "lines", a tuple (offsets, ids); "cell_data" and "point_data", dicts
    of arrays: "CurveType" per line; "LeftColor", "RightColor", "Strength", "RightStrength" and
    "Width" per line or per point.
cell_data : dict of arrays, optional
    Arrays of the cells of the surface: regions, "RegionStrength", "Refine".
curve_type_array_name, left_color_array_name, right_color_array_name, strength_array_name,
right_strength_array_name, width_array_name, region_array_name, region_strength_array_name,
refinement_array_name, result_array_name : str
width : float
    Width of Poisson curves without their own; 0 for a fraction of the diagonal.
background_color : array_like
refinement_level : int
    Number of times that triangles are split in four.
refinement_region : {"Everywhere", "NearCurves", "Cells"}
intrinsic_delaunay : bool
    Flip edges until they are Delaunay.
generate_fragments : bool
fragment_division : int
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
tuple of two SimpleNamespace
    The colored surface, polygons with the point data "Colors" and `origins`; and fragments.

Raises
------
Error
    For an invalid curve, array or option.

References
----------
F. Hou et al., "Poisson vector graphics", IEEE Trans. Vis. Comput. Graph. 26(2), 2020;
A. Orzan et al., "Diffusion curves", ACM Trans. Graph. 27(3), 2008.)";

/// Names of the arrays of a drawing.
struct GraphicsNames
{
  explicit GraphicsNames(Arguments& arguments)
  {
    arguments.Read("curve_type_array_name", this->CurveType);
    arguments.Read("left_color_array_name", this->LeftColor);
    arguments.Read("right_color_array_name", this->RightColor);
    arguments.Read("strength_array_name", this->Strength);
    arguments.Read("right_strength_array_name", this->RightStrength);
    arguments.Read("width_array_name", this->Width);
    arguments.Read("region_array_name", this->Region);
    arguments.Read("region_strength_array_name", this->RegionStrength);
    arguments.Read("refinement_array_name", this->Refinement);
  }

  std::string CurveType = "CurveType";
  std::string LeftColor = "LeftColor";
  std::string RightColor = "RightColor";
  std::string Strength = "Strength";
  std::string RightStrength = "RightStrength";
  std::string Width = "Width";
  std::string Region; // none
  std::string RegionStrength = "RegionStrength";
  std::string Refinement = "Refine";
};

/// Returns an item of a dict; a null object if there is none.
py::object GetItem(const py::object& dict, const char* key)
{
  if (!dict || dict.is_none() || !py::cast<py::dict>(dict).contains(key))
  {
    return py::object();
  }
  return dict[key];
}

/// Reads the array of this name; an empty name requests none.
dgg::InputArray ReadArray(const py::object& arrays, const std::string& name)
{
  dgg::InputArray array =
    name.empty() ? dgg::InputArray() : ToInputArray(GetItem(arrays, name.c_str()), name);
  array.Name = name;
  return array;
}

/// A drawing as arrays, with the cells and points that its input refers to.
struct Drawing
{
  Drawing(const py::object& curves, const py::object& surfaceCells, const GraphicsNames& names,
    const Surface& surface)
    : Lines(GetItem(curves, "lines"), "curves[\"lines\"]")
  {
    const py::object cells = GetItem(curves, "cell_data");
    const py::object points = GetItem(curves, "point_data");
    const auto read = [&](const std::string& name) {
      return dgg::GraphicsArray{ ReadArray(points, name), ReadArray(cells, name) };
    };
    if (const py::object positions = GetItem(curves, "points"))
    {
      this->Points = ToTable(positions, 3, "curves[\"points\"]");
    }
    this->Input.Lines = this->Lines.Get();
    this->Input.NumberOfCells = this->Input.Lines.NumberOfCells;
    this->Input.NumberOfPoints = this->Points.size() / 3;
    this->Input.Points = this->Points.data();
    this->Input.CurveType = ReadArray(cells, names.CurveType);
    this->Input.LeftColor = read(names.LeftColor);
    this->Input.RightColor = read(names.RightColor);
    this->Input.Strength = read(names.Strength);
    this->Input.RightStrength = read(names.RightStrength);
    this->Input.Width = read(names.Width);
    const dgg::SurfaceArrays& arrays = surface.GetCells();
    this->Input.NumberOfSurfaceCells =
      arrays.FirstCell + arrays.Polygons.NumberOfCells + arrays.Strips.NumberOfCells;
    this->Input.Region = ReadArray(surfaceCells, names.Region);
    this->Input.RegionStrength =
      ReadArray(surfaceCells, names.Region.empty() ? "" : names.RegionStrength);
  }

  /// Returns the points of curves, which are to be located.
  SurfacePoints Select(const std::vector<dgg::Offset>& ids) const
  {
    // Not py::none(), which counts a reference: the caller has released Python's lock.
    SurfacePoints points(Py_None, "curve point", "Curves");
    dgg::SourceCollection& collection = points.GetCollection();
    collection.Indices = ids;
    for (const dgg::Offset id : ids)
    {
      const double* const point = this->Points.data() + 3 * id;
      collection.Positions.insert(collection.Positions.end(), point, point + 3);
    }
    return points;
  }

  Cells Lines;
  Array<double> Points{ 0 };
  dgg::GraphicsInput Input;
};

dgg::GraphicsSettings ReadSettings(Arguments& arguments)
{
  dgg::GraphicsSettings settings;
  settings.ResultName = "Colors";
  settings.Background = { 0.0, 0.0, 0.0 };
  settings.MemoryRemedy =
    "Use a smaller mesh or a lower {RefinementLevel}, or refine near curves only";
  arguments.Read("result_array_name", settings.ResultName);
  ThrowUnlessOk(dgg::GraphicsTask::CheckName(settings.ResultName));
  arguments.Read("background_color", settings.Background);
  arguments.Read("refinement_level", settings.RefinementLevel);
  arguments.ReadChoice("refinement_region",
    { { "Everywhere", dgg::RefinedPart::Everything },
      { "NearCurves", dgg::RefinedPart::AroundCurves }, { "Cells", dgg::RefinedPart::Faces } },
    settings.Refinement);
  arguments.Read("intrinsic_delaunay", settings.IsIntrinsicDelaunay);
  arguments.Read("generate_fragments", settings.WantFragments);
  arguments.Read("fragment_division", settings.FragmentDivision);
  return settings;
}

py::object ColorSurface(const Surface& surface, const py::object& curves,
  const py::object& cellData, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  const GraphicsNames names(arguments);
  const dgg::GraphicsSettings settings = ReadSettings(arguments);
  Drawing drawing(curves, cellData, names, surface);
  arguments.ReadLength("width", drawing.Input.DefaultWidth);
  drawing.Input.WantRefinement = settings.Refinement == dgg::RefinedPart::Faces;
  drawing.Input.Refinement =
    ReadArray(cellData, drawing.Input.WantRefinement ? names.Refinement : "");
  double tolerance = dgg::SourceCollection::DefaultTolerance;
  arguments.ReadLength("projection_tolerance", tolerance);
  const SessionPool<dgg::GraphicsTask>::Loan task(surface.GetPool<dgg::GraphicsTask>());
  dgg::Output outputs[2];
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(surface);
    DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Vector graphics"));
    dgg::GraphicsDrawing found;
    DGG_RETURN_IF_ERROR(dgg::ReadGraphics(drawing.Input, context.Surface, found));
    std::vector<dgg::SurfacePoint> locations;
    if (!found.Points.empty())
    {
      SurfacePoints points = drawing.Select(found.Points);
      points.SetTolerance(tolerance);
      DGG_RETURN_IF_ERROR(points.Locate(context, locations));
    }
    return task->Run(context, found, locations, settings, outputs[0], outputs[1]);
  });
  return py::make_tuple(ToPython(outputs[0]), ToPython(outputs[1]));
}
}

//------------------------------------------------------------------------------
void AddVectorGraphics(py::module_& module)
{
  module.def("vector_graphics", &ColorSurface, py::arg("surface"), py::arg("curves") = py::none(),
    py::arg("cell_data") = py::none(), GraphicsDocumentation);
}
}
