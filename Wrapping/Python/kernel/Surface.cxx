// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface.h"

#include "Arguments.h"
#include "Call.h"
#include "Errors.h"
#include "Module.h"
#include "Outputs.h"
#include "SurfacePoints.h"

#include "dggCloudSize.h"
#include "dggPropertyChecks.h"
#include "dggStatus.h"
#include "dggSurfaceOutput.h"

#include <limits>

namespace dggPython
{
namespace
{
constexpr const char* ClassDocumentation =
  R"(A surface or a point cloud, checked and prepared for any number of calls from any thread.

Parameters
----------
points : array_like, shape (n, 3)
    Coordinates. Read-only and strided arrays are accepted. The array is copied. A warning states if
    single precision is too coarse for the edges.
cells : array_like of int, shape (m, k), or tuple (offsets, ids), optional
    Point ids of polygons with k corners, or of polygons of different sizes: the ids of polygon i
    are ids[offsets[i]:offsets[i + 1]].
strips : like `cells`, optional
    Triangle strips. Their cell ids follow those of the polygons.
first_cell : int
    Cell id of the first polygon.
merge_coincident_points : bool
    Connect polygons along points with equal coordinates.
merge_tolerance : float
    Largest distance of merged points, as a fraction of the diagonal of the bounding box.
cloud : bool
    Use the points alone. Cells are ignored.

Raises
------
Error
    For a surface without polygons, and for a point id that is out of range.

Data that calls on this surface reuse, such as factorizations, are kept until release() is called.)";

constexpr const char* ClosestPointsDocumentation =
  R"(The points of the surface that are closest to some positions.

Parameters
----------
positions : surface points
projection_tolerance : float, optional
    Largest distance from the surface, as a fraction of its diagonal. Default: no limit.

Returns
-------
SimpleNamespace
    Points with the point arrays "vtkOriginalPointIds" (-1 unless at a point), "FaceId" (cell) and,
    if all polygons are triangles, "Barycentric".

Raises
------
Error
    For coordinates that are not finite, and for positions that are too far away.)";

constexpr const char* CloudSizeDocumentation =
  R"(The spacing of a cloud, and the number of its components, without a graph.

Parameters
----------
points : array_like, shape (n, 3)
    Points that are not finite are ignored.
gap : float
    Width of the gaps that separate components, in spacings; 0 for no components.
progress
    See the module.

Returns
-------
tuple
    Median distance of about 500 points from their fourth neighbor, and number of components.)";

dgg::Domain ReadDomain(Arguments& arguments)
{
  bool isMerged = false;
  bool isCloud = false;
  dgg::Domain domain;
  arguments.Read("merge_coincident_points", isMerged);
  arguments.ReadLength("merge_tolerance", domain.MergeTolerance);
  arguments.Read("cloud", isCloud);
  domain.Kind = isCloud ? dgg::Domain::Cloud
    : isMerged          ? dgg::Domain::MergedSurface
                        : dgg::Domain::Surface;
  domain.MergeTolerance = domain.Kind == dgg::Domain::MergedSurface ? domain.MergeTolerance : 0.0;
  return domain;
}

py::dict MakeReport(const Surface& surface)
{
  std::vector<dgg::ReportItem> items;
  {
    const py::gil_scoped_release release;
    items = surface.Get().ListReport();
  }
  py::dict report;
  for (const dgg::ReportItem& item : items)
  {
    report[GetArgumentName(item.Name).c_str()] = item.Value;
  }
  return report;
}

py::dict DescribeReport(const Surface& surface)
{
  py::dict report;
  for (const dgg::ReportItem& item : surface.Get().ListReport())
  {
    report[item.Words] = item.Text;
  }
  return report;
}

py::tuple MeasureCloud(const py::handle& points, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  const Array<double> positions = ToTable(points, 3, "points");
  double gap = 0.0;
  arguments.ReadLength("gap", gap);
  dgg::CloudSize size;
  call.Run([&] {
    return dgg::MeasureCloud(positions.data(), positions.size() / 3, gap, call.GetProgress(), size);
  });
  return py::make_tuple(size.Spacing, size.NumberOfComponents);
}

py::object FindClosestPoints(
  const Surface& surface, const py::handle& positions, const py::kwargs& options)
{
  Arguments arguments(options);
  Call call(arguments);
  SurfacePoints points(positions, "position", "Positions");
  points.SetTolerance(std::numeric_limits<double>::max());
  points.ReadTolerance(arguments);
  dgg::Output output;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(surface);
    std::vector<dgg::SurfacePoint> found;
    DGG_RETURN_IF_ERROR(points.Locate(context, found));
    dgg::WriteSurfacePoints(context, found, output);
    return dgg::Status::Success();
  });
  return ToPython(output);
}

/// Returns a view of the coordinates, which keeps the surface alive.
py::array GetPoints(const py::object& self)
{
  const auto& surface = py::cast<const Surface&>(self);
  return MakeReadOnly(py::array_t<double>(
    { static_cast<py::ssize_t>(surface.GetNumberOfPoints()), static_cast<py::ssize_t>(3) },
    surface.Get().GetPositions(), self));
}
}

//------------------------------------------------------------------------------
Surface::Surface(const py::handle& points, const py::handle& cells, const py::kwargs& options)
{
  Arguments arguments(options);
  Call call(arguments);
  const Array<double> positions = ToTable(points, 3, "points");
  const dgg::Domain domain = ReadDomain(arguments);
  const bool isCloud = domain.Kind == dgg::Domain::Cloud;
  this->Polygons = Cells(isCloud ? py::handle() : cells, "cells");
  this->Strips = Cells(isCloud ? py::object() : arguments.Take("strips"), "strips");
  arguments.Read("first_cell", this->Input.FirstCell);
  this->Input.Polygons = this->Polygons.Get();
  this->Input.Strips = this->Strips.Get();
  this->Input.NumberOfPoints = positions.size() / 3;
  this->Input.AreFromFloats = py::isinstance<py::array_t<float>>(points);
  dgg::SurfaceArrays input = this->Input;
  input.Points = positions.data();
  call.Run([&] {
    DGG_RETURN_IF_ERROR(isCloud ? dgg::Status::Success()
                                : dgg::CheckCells(input.NumberOfPoints,
                                    input.Polygons.NumberOfCells + input.Strips.NumberOfCells,
                                    "Pass {Cells}, or turn on {Cloud}"));
    return dgg::PreparedSurface::Make(
      input, domain, dgg::PreparedSurface::ComputeFingerprint(input, domain), this->Prepared);
  });
  if (this->Prepared->HasCellsOfInput())
  {
    this->Polygons = Cells();
    this->Input.Polygons = {};
  }
}

//------------------------------------------------------------------------------
const dgg::SurfaceArrays& Surface::GetCells() const
{
  std::call_once(this->PolygonsOnce, [this] {
    if (this->Prepared->HasCellsOfInput())
    {
      this->Polygons = Cells(this->Prepared->GetMeshWithoutAngles());
      this->Input.Polygons = this->Polygons.Get();
    }
  });
  return this->Input;
}

//------------------------------------------------------------------------------
std::size_t Surface::GetNumberOfSessions() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  std::size_t count = 0;
  for (const auto& [kind, pool] : this->Pools)
  {
    count += pool->GetSize();
  }
  return count;
}

//------------------------------------------------------------------------------
void Surface::Release()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  for (auto& [kind, pool] : this->Pools)
  {
    pool->Clear();
  }
}

//------------------------------------------------------------------------------
void AddSurface(py::module_& module)
{
  module.def("cloud_size", &MeasureCloud, py::arg("points"), CloudSizeDocumentation);
  py::class_<Surface, std::shared_ptr<Surface>>(module, "Surface", ClassDocumentation)
    .def(py::init([](const py::object& points, const py::object& cells, const py::kwargs& options) {
      return std::make_shared<Surface>(points, cells, options);
    }),
      py::arg("points"), py::arg("cells") = py::none())
    .def_property_readonly("points", &GetPoints, "Coordinates, shape (n, 3), read-only.")
    .def_property_readonly("number_of_points", &Surface::GetNumberOfPoints)
    .def_property_readonly(
      "number_of_triangles",
      [](
        const Surface& surface) { return surface.Get().GetMeshWithoutAngles().GetNumberOfFaces(); },
      "Number of triangles of all polygons and strips.")
    .def_property_readonly(
      "is_cloud", [](const Surface& surface) { return surface.Get().IsCloud(); })
    .def_property_readonly(
      "signature",
      [](const Surface& surface) {
        return py::make_tuple(surface.Get().GetSignature()[0], surface.Get().GetSignature()[1]);
      },
      "Two integers that identify points and triangles.")
    .def_property_readonly(
      "warnings",
      [](const Surface& surface) { return RenderWarnings(surface.Get().GetWarnings()); },
      "Warnings about the surface.")
    .def("report", &MakeReport, "Size, defects and quality of the surface: numbers by name.")
    .def("describe", &DescribeReport, "The report as texts by readable name.")
    .def("closest_points", &FindClosestPoints, py::arg("positions"), ClosestPointsDocumentation)
    .def_property_readonly("number_of_sessions", &Surface::GetNumberOfSessions,
      "Number of sessions that calls reuse: one for each kind of call, more after simultaneous "
      "calls.")
    .def("release", &Surface::Release, "Releases the data that calls on this surface reuse.");
}
}
