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

#include "dggFieldReader.h"
#include "dggIsolineTask.h"
#include "dggOutput.h"
#include "dggProgressPart.h"
#include "dggStoredWindows.h"

#include <optional>
#include <utility>

namespace dggPython
{
namespace
{
#define DGG_FIELD_DOCUMENTATION                                                                \
  "distances : array_like, shape (n,)\n"                                                       \
  "    Distances at the points, by any method; NaN and infinity mark unreached points.\n"      \
  "virtual_sources : array_like, shape (n, 3), optional\n"                                     \
  "    \"GeodesicVirtualSource\" of the distances. Without it and windows, it is estimated.\n" \
  "field_data : dict of arrays, optional\n"                                                    \
  "    With the windows of exact distances.\n"                                                 \
  "unreached_value : float\n"                                                                  \
  "    Further distance that marks unreached points. Default: NaN.\n"                          \
  "unreached : array_like, shape (n,), optional\n"                                             \
  "    Marks of unreached points, used if `unreached_value` is NaN.\n"                         \
  "distance_array_name, virtual_source_array_name : str\n"                                     \
  "    Names of the arrays in `field_data` and in messages.\n"

constexpr const char* IsolinesDocumentation =
  "Isolines of distances, and ridges and bands if requested.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_FIELD_DOCUMENTATION "values : array_like\n"
  "    Distances of the lines.\n"
  "method : {\"LocalSources\", \"Apollonius\", \"Linear\"}\n"
  "    Interpolation inside triangles. \"Apollonius\" and \"Linear\" serve for comparison.\n"
  "chord_tolerance : float\n"
  "    Largest distance of a line from the level set, relative to the mean edge length. Default: a "
  "thousandth.\n"
  "steiner_points : int\n"
  "    Number of points per edge of \"Apollonius\".\n"
  "generate_ridges, generate_bands : bool\n"
  "minimum_ridge_angle : float\n"
  "    Smallest angle between the directions to the source on both sides of a ridge, degrees.\n"
  "memory_limit, number_of_threads, progress\n"
  "    See the module.\n\n"
  "Returns\n-------\n"
  "tuple of three SimpleNamespace\n"
  "    Lines with the cell data \"IsoValue\"; ridges with \"RidgeAngle\" (degrees); bands, "
  "polygons "
  "with\n"
  "    \"Band\", \"BandMinimum\", \"BandMaximum\" and \"FaceId\". The lines have used_windows,\n"
  "    used_virtual_sources and number_of_fallbacks, segments that may miss the tolerance.\n\n"
  "Raises\n------\n"
  "Error\n"
  "    For an invalid distance or option.\n"
  "\nReferences\n----------\n"
  R"(J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic problem", SIAM J.
Comput. 16, 1987, section 3; Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological
University, 2019, section 5.3.)";

constexpr const char* ProbeDocumentation =
  "Distances at points anywhere on a surface.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_FIELD_DOCUMENTATION "at : surface points\n"
  "projection_tolerance, memory_limit, number_of_threads, progress\n"
  "    See the module.\n\n"
  "Returns\n-------\n"
  "SimpleNamespace\n"
  "    Point data: the distance of each point, NaN if unreached.\n\n"
  "Raises\n------\n"
  "Error\n"
  "    For an invalid distance or point.\n"
  "\nReferences\n----------\n"
  R"(J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic problem", SIAM J.
Comput. 16, 1987, section 3.)";

/// Distances, with the windows or virtual sources that interpolate them.
class Field
{
public:
  Field(const py::object& distances, const Surface& surface, Arguments& arguments)
  {
    arguments.Read("distance_array_name", this->Name);
    std::string sourcesName = VirtualSourceName;
    arguments.Read("virtual_source_array_name", sourcesName);
    arguments.Read("unreached_value", this->UnreachedValue);
    const Array<double> numbers = ToTable(distances, 1, "distances");
    if (numbers.size() != surface.GetNumberOfPoints())
    {
      throw py::value_error("distances: expected one per point, " +
        std::to_string(surface.GetNumberOfPoints()) + ", got " + std::to_string(numbers.size()));
    }
    this->Distances = ToInputArray(distances, this->Name);
    this->Marks = ToInputArray(arguments.Take("unreached"), dgg::GetUnreachedName(this->Name));
    this->Sources = ToInputArray(arguments.Take("virtual_sources"), sourcesName);
    if (const py::object data = arguments.Take("field_data"))
    {
      this->FindWindows(py::cast<py::dict>(data));
    }
  }

  /// Reads the distances alone.
  dgg::Status ReadDistances(dgg::FieldReader& reader) const
  {
    return reader.SetDistances(this->Distances, this->UnreachedValue, this->Marks);
  }

  /// Reads all data.
  dgg::Status Read(const dgg::TaskContext& context, const dgg::ProgressCallback& progress,
    dgg::FieldReader& reader) const
  {
    DGG_RETURN_IF_ERROR(this->ReadDistances(reader));
    if (!this->Owned.empty())
    {
      dgg::EdgeWindows windows;
      const dgg::Status status = dgg::StoredWindows::Read(this->Windows, this->Name,
        this->Distances.Values.data(), this->Distances.Values.size(), context.Surface, windows);
      if (!status.IsOk())
      {
        reader.Warn(status.GetProblem() + ". They are ignored");
      }
      reader.SetWindows(std::move(windows));
    }
    reader.SetSources(this->Sources);
    return reader.Complete(context, progress);
  }

  const std::string& GetName() const { return this->Name; }

private:
  void FindWindows(const py::dict& data)
  {
    for (int role = 0; role < dgg::StoredWindows::NumberOfRoles; ++role)
    {
      const std::string name = dgg::StoredWindows::GetName(this->Name, role);
      if (data.contains(name))
      {
        const bool isTable =
          role == dgg::StoredWindows::WindowsRole || role == dgg::StoredWindows::SourcesRole;
        this->Owned.push_back(py::cast<py::array>(data[name.c_str()]));
        this->Windows[role] =
          ToStoredArray(this->Owned.back(), isTable ? dgg::StoredWindows::NumberOfComponents : 1);
      }
    }
  }

  std::string Name = DistanceName;
  double UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  dgg::InputArray Distances;
  dgg::InputArray Marks;
  dgg::InputArray Sources;
  dgg::StoredWindows::Arrays Windows;
  std::vector<py::array> Owned; // arrays of Windows
};

void AddWarnings(const dgg::FieldReader& reader, dgg::Output& output)
{
  output.Warnings = reader.GetWarnings();
  output.Warn(reader.DescribeQuality());
}

//------------------------------------------------------------------------------
dgg::IsolineTaskOptions ReadIsolineOptions(Arguments& arguments, bool& isLinear)
{
  using Method = std::optional<dgg::IsolineMethod>;
  dgg::IsolineTaskOptions options;
  Method method = options.Method;
  arguments.Read("values", options.Values);
  arguments.ReadChoice<Method>("method",
    { { "LocalSources", dgg::IsolineMethod::LocalSources },
      { "Apollonius", dgg::IsolineMethod::Apollonius }, { "Linear", Method() } },
    method);
  isLinear = !method;
  options.Method = method.value_or(options.Method);
  arguments.Read("chord_tolerance", options.ChordTolerance);
  arguments.Read("steiner_points", options.SteinerPoints);
  arguments.Read("generate_ridges", options.WithRidges);
  arguments.Read("generate_bands", options.WithBands);
  arguments.Read("minimum_ridge_angle", options.MinimumRidgeAngle);
  ThrowUnlessOk(options.Check());
  return options;
}

py::object FindIsolines(
  const Surface& surface, const py::object& distances, const py::kwargs& keywords)
{
  constexpr double readingShare = 0.4; // of the progress
  Arguments arguments(keywords);
  Call call(arguments);
  const Field field(distances, surface, arguments);
  bool isLinear = false;
  const dgg::IsolineTaskOptions options = ReadIsolineOptions(arguments, isLinear);
  dgg::Output outputs[3];
  bool usedWindows = false;
  bool usedVirtualSources = false;
  dgg::Offset fallbacks = 0;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(surface);
    DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Isolines"));
    dgg::FieldReader reader(context.Surface);
    const dgg::ProgressCallback reading = dgg::ProgressPart(context.Progress, 0.0, readingShare);
    DGG_RETURN_IF_ERROR(
      isLinear ? field.ReadDistances(reader) : field.Read(context, reading, reader));
    dgg::IsolineResult result;
    DGG_RETURN_IF_ERROR(dgg::FindIsolines(context, reader.GetField(), options,
      dgg::ProgressPart(context.Progress, readingShare, 1.0), result));
    dgg::WriteIsolines(context, result, options.Values, field.GetName(), outputs);
    AddWarnings(reader, outputs[0]);
    outputs[0].Warn(dgg::DescribeRidges(options, reader));
    outputs[0].Warn(
      dgg::DescribeMissingLines(options, reader.FindRange(), !result.Lines.Lines.empty()));
    usedWindows = reader.GetField().HasWindows();
    usedVirtualSources = reader.GetField().HasSources();
    fallbacks = result.Lines.Fallbacks + result.Ridges.Fallbacks;
    return dgg::Status::Success();
  });
  py::object lines = ToPython(outputs[0]);
  lines.attr("used_windows") = usedWindows;
  lines.attr("used_virtual_sources") = usedVirtualSources;
  lines.attr("number_of_fallbacks") = fallbacks;
  return py::make_tuple(lines, ToPython(outputs[1]), ToPython(outputs[2]));
}

//------------------------------------------------------------------------------
py::object Probe(const Surface& surface, const py::object& distances, const py::object& points,
  const py::kwargs& keywords)
{
  constexpr double readingShare = 0.5; // of the progress
  Arguments arguments(keywords);
  Call call(arguments);
  const Field field(distances, surface, arguments);
  SurfacePoints probes(points, "probe point", "At");
  probes.ReadTolerance(arguments);
  dgg::Output output;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(surface);
    DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Distances between points"));
    std::vector<dgg::SurfacePoint> locations;
    DGG_RETURN_IF_ERROR(probes.Locate(context, locations));
    dgg::FieldReader reader(context.Surface);
    DGG_RETURN_IF_ERROR(
      field.Read(context, dgg::ProgressPart(context.Progress, 0.0, readingShare), reader));
    double* const values = output.PointData.Add<double>(field.GetName(), locations.size());
    DGG_RETURN_IF_ERROR(dgg::ProbeField(context, reader.GetField(), locations,
      dgg::ProgressPart(context.Progress, readingShare, 1.0), values));
    output.PointScalars = field.GetName();
    AddWarnings(reader, output);
    return dgg::Status::Success();
  });
  return ToPython(output);
}
}

//------------------------------------------------------------------------------
void AddFields(py::module_& module)
{
  module.def(
    "isolines", &FindIsolines, py::arg("surface"), py::arg("distances"), IsolinesDocumentation);
  module.def(
    "probe", &Probe, py::arg("surface"), py::arg("distances"), py::arg("at"), ProbeDocumentation);
}
}
