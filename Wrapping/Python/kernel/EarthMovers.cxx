// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Arrays.h"
#include "Call.h"
#include "Distances.h"
#include "Module.h"
#include "Outputs.h"
#include "SurfacePoints.h"

#include "dggEarthMoversTask.h"
#include "dggOutput.h"
#include "dggPoissonSession.h"

#include <utility>

namespace dggPython
{
namespace
{
constexpr const char* EarthMoversDocumentation =
  R"(The earth mover's distance of two distributions of mass on a surface.

Parameters
----------
surface : Surface
from_values, to_values : array_like, shape (n,), optional
    Mass at the points of the surface.
from_points, to_points : surface points, optional
    Further masses at points.
from_masses, to_masses : array_like, one per point, optional
    Default: 1.
array_meaning : {"Density", "Mass"}
    Meaning of the values.
normalize : bool
    Scale both distributions to the mass 1.
maximum_number_of_iterations : int
tolerance : float
    Stop when the relative gap between the bounds is smaller.
intrinsic_delaunay : bool
    Flip edges until they are Delaunay. Then there is no flow.
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
SimpleNamespace
    The numbers distance, lower_bound, gap and number_of_iterations; the point data
    "EarthMoversPotential" and the cell data "EarthMoversFlow".

Raises
------
Error
    For distributions without mass, of negative mass, or of different masses.

References
----------
J. Solomon, R. Rustamov, L. Guibas, A. Butscher, "Earth mover's distances on discrete surfaces", ACM
Trans. Graph. 33(4), 2014, section 4.)";

/// A distribution and its points, before they are located.
struct Distribution
{
  Distribution(
    Arguments& arguments, const std::string& role, const char* property, const char* pointsProperty)
    : Mass{ role, property, pointsProperty }
    , Points(arguments.Take((role + "_points").c_str()), "\"" + role + "\"", pointsProperty)
  {
    const std::string masses = role + "_masses";
    this->Mass.Values = ToInputArray(arguments.Take((role + "_values").c_str()), role + "_values");
    this->Mass.Masses = ToInputArray(arguments.Take(masses.c_str()), masses);
    this->Mass.NumberOfPlaces = static_cast<dgg::Offset>(this->Points.Size());
    this->Points.ReadTolerance(arguments);
  }

  dgg::Status Prepare(const dgg::TaskContext& context)
  {
    DGG_RETURN_IF_ERROR(this->Mass.Check(context.Surface));
    return this->Points.IsEmpty() ? dgg::Status::Success()
                                  : this->Points.Locate(context, this->Mass.Places);
  }

  dgg::MassDistribution Mass;
  SurfacePoints Points;
};

dgg::EarthMoversTask ReadTask(Arguments& arguments, const Surface& surface)
{
  dgg::EarthMoversTask task;
  arguments.ReadChoice(
    "array_meaning", { { "Density", true }, { "Mass", false } }, task.AreDensities);
  arguments.Read("normalize", task.Normalizes);
  arguments.Read("maximum_number_of_iterations", task.Options.MostIterations);
  arguments.ReadLength("tolerance", task.Options.Tolerance);
  arguments.Read("intrinsic_delaunay", task.IsIntrinsicDelaunay);
  const dgg::SurfaceArrays& cells = surface.GetCells();
  task.NumberOfCells = cells.FirstCell + cells.Polygons.NumberOfCells + cells.Strips.NumberOfCells;
  return task;
}

py::object FindEarthMovers(const Surface& surface, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Distribution from(arguments, "from", "FromValues", "FromPoints");
  Distribution to(arguments, "to", "ToValues", "ToPoints");
  dgg::EarthMoversTask task = ReadTask(arguments, surface);
  const SessionPool<dgg::PoissonSession>::Loan session(surface.GetPool<dgg::PoissonSession>());
  dgg::Output output;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(surface);
    DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Earth mover's distances"));
    DGG_RETURN_IF_ERROR(from.Prepare(context));
    DGG_RETURN_IF_ERROR(to.Prepare(context));
    const dgg::MassDistribution distributions[] = { std::move(from.Mass), std::move(to.Mass) };
    return dgg::FindEarthMoversDistance(
      context, *session, distributions, "Use a smaller mesh", task, output);
  });
  py::object result = ToPython(output);
  result.attr("distance") = task.Distance;
  result.attr("lower_bound") = task.LowerBound;
  result.attr("gap") = task.Gap;
  result.attr("number_of_iterations") = task.Iterations;
  return result;
}
}

//------------------------------------------------------------------------------
void AddEarthMovers(py::module_& module)
{
  module.def(
    "earth_movers_distance", &FindEarthMovers, py::arg("surface"), EarthMoversDocumentation);
}
}
