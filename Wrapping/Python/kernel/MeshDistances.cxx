// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Distances.h"
#include "Module.h"

#include "dggDistanceMethods.h"
#include "dggExactGeodesics.h"
#include "dggFastMarching.h"

#include <optional>

namespace dggPython
{
namespace
{
constexpr const char* ExactDocumentation =
  "Exact distances from the nearest source, by propagation of windows.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_DISTANCE_DOCUMENTATION(
    "generate_windows : bool\n"
    "    Add field data that determine the distance at every point of the surface.\n"
    "engine : {\"Triangle\", \"Reference\"}\n"
    "    \"Reference\" is slow and serves for comparison.\n",
    R"(J. S. B. Mitchell, D. M. Mount, C. H. Papadimitriou, "The discrete geodesic problem", SIAM J.
Comput. 16, 1987; J. Chen, Y. Han, "Shortest paths on a polyhedron", SoCG 1990; Y. Qin et al.,
"Fast and exact discrete geodesic computation based on triangle-oriented wavefront propagation", ACM
Trans. Graph. 35(4), 2016.)");

constexpr const char* VirtualSourceDocumentation =
  "Approximate distances in milliseconds, by propagation of virtual sources; no bound of the "
  "error.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_DISTANCE_DOCUMENTATION(
    "quality : {\"Automatic\", \"Fast\", \"High\"}\n",
    R"(P. Trettner, D. Bommes, L. Kobbelt, "Geodesic distance computation via virtual source
propagation", Computer Graphics Forum 40(5), 2021.)");

constexpr const char* HeatDocumentation =
  "Approximate distances by the heat method; no bound of the error. Factorizations are kept by the "
  "surface.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_DISTANCE_DOCUMENTATION(
    "time_step_factor : float\n"
    "    Factor of the square of the mean edge length that gives the time of the flow.\n"
    "intrinsic_delaunay : bool\n"
    "    Flip edges until they are Delaunay.\n"
    "boundary : {\"Neumann\", \"Dirichlet\", \"Average\"}\n",
    R"(K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in heat: a new approach to computing distance
based on heat flow", ACM Trans. Graph. 32(5), 2013.)");

constexpr const char* MarchingDocumentation =
  "Approximate distances by fast marching, on a surface or a cloud; no bound of the error.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_DISTANCE_DOCUMENTATION(
    "front_shape : {\"Spherical\", \"Planar\"}\n"
    "    On a surface.\n"
    "band_radius : float\n"
    "    On a cloud, radius of balls around points in voxels; 0 for an automatic one.\n"
    "resolution : int\n"
    "    On a cloud, number of voxels along the longest side; 0 for an automatic one.\n",
    R"(R. Kimmel, J. A. Sethian, "Computing geodesic paths on manifolds", Proc. Natl. Acad. Sci. 95,
1998; M. Novotni, R. Klein, "Computing geodesic distances on triangular meshes", WSCG 2002; clouds:
F. Memoli, G. Sapiro, "Fast computation of weighted distance functions and geodesics on implicit
hyper-surfaces", J. Comput. Phys. 173, 2001.)");

//------------------------------------------------------------------------------
py::object ComputeExact(
  const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Distances distances(sources, arguments);
  bool keepWindows = false;
  dgg::ExactEngine engine = dgg::ExactEngine::Triangle;
  arguments.Read("generate_windows", keepWindows);
  arguments.ReadChoice("engine",
    { { "Triangle", dgg::ExactEngine::Triangle }, { "Reference", dgg::ExactEngine::Reference } },
    engine);
  return distances.Run(call, surface, "Exact distances",
    [&](const dgg::TaskContext& context, dgg::DistanceTask& task) {
      return dgg::FindExactDistances(context, engine, keepWindows, task);
    });
}

//------------------------------------------------------------------------------
py::object ComputeVirtualSource(
  const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  using Quality = std::optional<dgg::PropagationQuality>;
  Arguments arguments(keywords);
  Call call(arguments);
  Distances distances(sources, arguments);
  Quality quality;
  arguments.ReadChoice<Quality>("quality",
    { { "Automatic", Quality() }, { "Fast", dgg::PropagationQuality::Fast },
      { "High", dgg::PropagationQuality::High } },
    quality);
  const SessionPool<dgg::PropagationSession>::Loan session(
    surface.GetPool<dgg::PropagationSession>());
  return distances.Run(call, surface, "Virtual sources",
    [&](const dgg::TaskContext& context, dgg::DistanceTask& task) {
      return dgg::FindPropagatedDistances(context, *session, quality, task);
    });
}

//------------------------------------------------------------------------------
py::object ComputeHeat(
  const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Distances distances(sources, arguments);
  dgg::HeatOptions options;
  arguments.Read("time_step_factor", options.TimeStepFactor);
  arguments.Read("intrinsic_delaunay", options.IntrinsicDelaunay);
  arguments.ReadChoice("boundary",
    { { "Neumann", dgg::HeatBoundary::Neumann }, { "Dirichlet", dgg::HeatBoundary::Dirichlet },
      { "Average", dgg::HeatBoundary::Average } },
    options.Boundary);
  const SessionPool<dgg::HeatSession>::Loan session(surface.GetPool<dgg::HeatSession>());
  return distances.Run(call, surface, "Distances by the heat method",
    [&](const dgg::TaskContext& context, dgg::DistanceTask& task) {
      return session->Run(context, options, "Use a smaller mesh", task);
    });
}

//------------------------------------------------------------------------------
py::object ComputeMarching(
  const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Distances distances(sources, arguments);
  dgg::MarchingUpdate update = dgg::MarchingUpdate::Spherical;
  dgg::BandOptions band;
  arguments.ReadChoice("front_shape",
    { { "Spherical", dgg::MarchingUpdate::Spherical }, { "Planar", dgg::MarchingUpdate::Planar } },
    update);
  arguments.Read("band_radius", band.OffsetInVoxels);
  arguments.Read("resolution", band.Resolution);
  const SessionPool<dgg::MarchingSession>::Loan session(surface.GetPool<dgg::MarchingSession>());
  return distances.Run(
    call, surface, nullptr, [&](const dgg::TaskContext& context, dgg::DistanceTask& task) {
      return session->Run(context, update, band, task);
    });
}
}

//------------------------------------------------------------------------------
void AddDistances(py::module_& module)
{
  const auto add = [&](const char* name, auto function, const char* documentation) {
    module.def(name, function, py::arg("surface"), py::arg("sources"), documentation);
  };
  add("exact_distance", &ComputeExact, ExactDocumentation);
  add("virtual_source_distance", &ComputeVirtualSource, VirtualSourceDocumentation);
  add("heat_distance", &ComputeHeat, HeatDocumentation);
  add("fast_marching_distance", &ComputeMarching, MarchingDocumentation);
}
}
