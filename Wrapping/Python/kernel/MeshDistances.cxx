// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Distances.h"
#include "Module.h"

#include "dggCloudMarching.h"
#include "dggExactGeodesics.h"
#include "dggFastMarching.h"
#include "dggHeatMethod.h"
#include "dggMeshQuality.h"
#include "dggProgressPart.h"
#include "dggPropagationSession.h"
#include "dggSourceFinding.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace dggPython
{
namespace
{
constexpr const char* ExactDocumentation =
  "Exact distances from the nearest source, by propagation of windows.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_DISTANCE_DOCUMENTATION "\n"
  "generate_windows : bool\n"
  "    Add field data that determine the distance at every point of the surface.\n"
  "engine : {\"Triangle\", \"Reference\"}\n"
  "    \"Reference\" is slow and serves for comparison.\n";

constexpr const char* VirtualSourceDocumentation =
  "Approximate distances in milliseconds, by propagation of virtual sources; no bound of the "
  "error.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_DISTANCE_DOCUMENTATION "\n"
  "quality : {\"Automatic\", \"Fast\", \"High\"}\n";

constexpr const char* HeatDocumentation =
  "Approximate distances by the heat method; no bound of the error. Factorizations are kept by the "
  "surface.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_DISTANCE_DOCUMENTATION "\n"
  "time_step_factor : float\n"
  "    Factor of the square of the mean edge length that gives the time of the flow.\n"
  "intrinsic_delaunay : bool\n"
  "    Flip edges until they are Delaunay.\n"
  "boundary : {\"Neumann\", \"Dirichlet\", \"Average\"}\n";

constexpr const char* MarchingDocumentation =
  "Approximate distances by fast marching, on a surface or a cloud; no bound of the error.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n" DGG_DISTANCE_DOCUMENTATION "\n"
  "front_shape : {\"Spherical\", \"Planar\"}\n"
  "    On a surface.\n"
  "band_radius : float\n"
  "    On a cloud, radius of balls around points in voxels; 0 for an automatic one.\n"
  "resolution : int\n"
  "    On a cloud, number of voxels along the longest side; 0 for an automatic one.\n";

/// Moves distances and their sources to a task.
template <typename Result>
void TakeResults(Result& result, dgg::DistanceTask& task)
{
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
}

void AddReason(const std::string& reason, std::vector<std::string>& warnings)
{
  if (!reason.empty())
  {
    warnings.push_back(reason);
  }
}

//------------------------------------------------------------------------------
dgg::Status RunExact(
  const dgg::TaskContext& context, dgg::ExactOptions options, dgg::DistanceTask& task)
{
  DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Exact distances"));
  options.MaximumDistance = task.MaximumDistance;
  options.Progress = context.Progress;
  options.MemoryLimit = static_cast<std::size_t>(context.Memory.Limit);
  const dgg::SurfaceMesh& mesh = context.Surface.GetMesh();
  dgg::ExactResult result;
  DGG_RETURN_IF_ERROR(dgg::ExactGeodesics(mesh).Run(task.Sources, options, result));
  if (task.WantVirtualSource)
  {
    dgg::FindVirtualSources(mesh, task.Sources, result, task.VirtualSource, context.Parallel);
  }
  task.Windows = std::move(result.Windows);
  TakeResults(result, task);
  return dgg::Status::Success();
}

py::object ComputeExact(
  const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Distances distances(sources, arguments);
  dgg::ExactOptions options;
  arguments.Read("generate_windows", options.KeepWindows);
  arguments.ReadChoice("engine",
    { { "Triangle", dgg::ExactEngine::Triangle }, { "Reference", dgg::ExactEngine::Reference } },
    options.Engine);
  return distances.Run(call, surface,
    [&](const dgg::TaskContext& context, dgg::DistanceTask& task, std::vector<std::string>&) {
      return RunExact(context, options, task);
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
  return distances.Run(call, surface,
    [&](const dgg::TaskContext& context, dgg::DistanceTask& task,
      std::vector<std::string>& warnings) {
      DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Virtual sources"));
      dgg::PropagationOptions options;
      options.Quality = quality ? *quality : dgg::PropagationSession::Choose(context.Surface);
      options.MaximumDistance = task.MaximumDistance;
      options.WantNearestSource = task.WantNearestSource;
      options.WantVirtualSource = task.WantVirtualSource;
      dgg::PropagationResult result;
      DGG_RETURN_IF_ERROR(session->Run(context, task.Sources, options, result));
      AddReason(
        dgg::JoinReasons({ dgg::DescribeLongTriangles(context.Surface, dgg::LongTrianglesMislead),
          result.IsSettled ? "" : dgg::UnsettledDistances }),
        warnings);
      task.VirtualSource = std::move(result.Virtual);
      TakeResults(result, task);
      return dgg::Status::Success();
    });
}

//------------------------------------------------------------------------------
/// Factorizations that calls reuse.
struct HeatSession
{
  std::optional<dgg::HeatMethod> Method;
};

dgg::Status RunHeat(const dgg::TaskContext& context, const dgg::HeatOptions& options,
  HeatSession& session, dgg::DistanceTask& task)
{
  constexpr double factorizedAt = 0.9; // progress
  DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Distances by the heat method"));
  if (!session.Method)
  {
    session.Method.emplace(context.Surface.GetMesh());
  }
  DGG_RETURN_IF_ERROR(session.Method->Prepare(
    options, dgg::ProgressPart(context.Progress, 0.0, factorizedAt), [&](double bytes) {
      return context.Memory.Check("The heat method", bytes, "Use a smaller mesh");
    }));
  dgg::HeatQuery query;
  query.MaximumDistance = task.MaximumDistance;
  query.WantNearestSource = task.WantNearestSource;
  query.WantVirtualSource = task.WantVirtualSource;
  query.Progress = dgg::ProgressPart(context.Progress, factorizedAt, 1.0);
  dgg::HeatResult result;
  DGG_RETURN_IF_ERROR(session.Method->Run(task.Sources, query, result));
  task.VirtualSource = std::move(result.Virtual);
  TakeResults(result, task);
  return dgg::Status::Success();
}

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
  const SessionPool<HeatSession>::Loan session(surface.GetPool<HeatSession>());
  return distances.Run(call, surface,
    [&](const dgg::TaskContext& context, dgg::DistanceTask& task,
      std::vector<std::string>& warnings) {
      AddReason(dgg::DescribeLongTriangles(context.Surface, dgg::LongTrianglesMislead), warnings);
      return RunHeat(context, options, *session, task);
    });
}

//------------------------------------------------------------------------------
/// Solvers that calls reuse: of a surface, or of the band of a cloud.
struct MarchingSession
{
  std::optional<dgg::FastMarching> OnMesh;
  std::optional<dgg::CloudMarching> OnCloud;
  dgg::BandOptions Band; // of OnCloud
};

dgg::Status MarchOnMesh(const dgg::TaskContext& context, dgg::MarchingOptions options,
  MarchingSession& session, dgg::DistanceTask& task)
{
  options.MaximumDistance = task.MaximumDistance;
  options.WantVirtualSource = task.WantVirtualSource;
  options.Progress = context.Progress;
  if (!session.OnMesh)
  {
    session.OnMesh.emplace(context.Surface.GetMesh());
  }
  dgg::MarchingResult result;
  DGG_RETURN_IF_ERROR(session.OnMesh->Run(task.Sources, options, result));
  task.VirtualSource = std::move(result.Virtual);
  TakeResults(result, task);
  return dgg::Status::Success();
}

dgg::Status MarchOnCloud(const dgg::TaskContext& context, const dgg::BandOptions& band,
  MarchingSession& session, dgg::DistanceTask& task)
{
  constexpr double bandShare = 0.4; // of the progress
  const bool isKept = session.OnCloud && session.Band.OffsetInVoxels == band.OffsetInVoxels &&
    session.Band.Resolution == band.Resolution;
  if (!isKept)
  {
    session.Band = band;
    session.OnCloud.emplace();
    const dgg::Status status =
      session.OnCloud->Prepare(context, band, dgg::ProgressPart(context.Progress, 0.0, bandShare));
    if (!status.IsOk())
    {
      session.OnCloud.reset();
      return status;
    }
  }
  dgg::MarchingResult result;
  DGG_RETURN_IF_ERROR(session.OnCloud->Run(context, task.Sources, task.MaximumDistance,
    dgg::ProgressPart(context.Progress, isKept ? 0.0 : bandShare, 1.0), result));
  TakeResults(result, task);
  return dgg::Status::Success();
}

py::object ComputeMarching(
  const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Distances distances(sources, arguments);
  dgg::MarchingOptions options;
  dgg::BandOptions band;
  arguments.ReadChoice("front_shape",
    { { "Spherical", dgg::MarchingUpdate::Spherical }, { "Planar", dgg::MarchingUpdate::Planar } },
    options.Update);
  arguments.Read("band_radius", band.OffsetInVoxels);
  arguments.Read("resolution", band.Resolution);
  const SessionPool<MarchingSession>::Loan session(surface.GetPool<MarchingSession>());
  return distances.Run(call, surface,
    [&](const dgg::TaskContext& context, dgg::DistanceTask& task,
      std::vector<std::string>& warnings) {
      if (context.Surface.IsCloud())
      {
        return MarchOnCloud(context, band, *session, task);
      }
      AddReason(dgg::DescribeLongTriangles(context.Surface, dgg::LongTrianglesMislead), warnings);
      return MarchOnMesh(context, options, *session, task);
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
