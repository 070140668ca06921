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

#include "dggGreensTask.h"
#include "dggPoissonSession.h"
#include "dggPropertyChecks.h"
#include "dggSpectralDistanceTask.h"
#include "dggSplineTask.h"

namespace dggPython
{
namespace
{
#define DGG_SPECTRAL_DOCUMENTATION                                                              \
  "evaluation : surface points, optional\n"                                                     \
  "    Further points to evaluate at.\n"                                                        \
  "boundary : {\"Neumann\", \"Dirichlet\"}\n"                                                   \
  "intrinsic_delaunay : bool\n"                                                                 \
  "    Flip edges until they are Delaunay.\n"                                                   \
  "result_array_name : str\n"                                                                   \
  "projection_tolerance, memory_limit, number_of_threads, progress\n"                           \
  "    See the module.\n\n"                                                                     \
  "Returns\n-------\n"                                                                          \
  "tuple of two SimpleNamespace\n"                                                              \
  "    Point data of the surface and of the evaluation points.\n\n"                             \
  "Raises\n------\n"                                                                            \
  "Error\n"                                                                                     \
  "    For an invalid point or option, and for triangles that are too thin to solve equations " \
  "on.\n\n"                                                                                     \
  "The factorization is kept by the surface."

constexpr const char* GreensDocumentation =
  "Green's functions of the Laplacian or bi-Laplacian, one per source.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n"
  "sources : surface points\n"
  "order : {\"Laplace\", \"BiLaplace\"}\n"
  "method : {\"SingularitySubtraction\", \"Localized\", \"Interpolated\", \"Vertex\"}\n"
  "sign_convention : {\"PositiveAtSource\", \"NegativeAtSource\"}\n"
  "pole_value : {\"CellAverage\", \"Infinite\"}\n"
  "    Value at the source itself.\n"
  "weighting : {\"Area\", \"Uniform\"}\n"
  "radius : float\n"
  "    Radius of the singular part; 0 for an automatic one.\n"
  "interpolate_regular_part : bool\n"
  "    Reuse columns of vertices, for many sources.\n" DGG_SPECTRAL_DOCUMENTATION
  " `used` of the first\nresult lists the method, the radius and is_near_ridge of each source."
  "\n\nReferences\n----------\n"
  R"(Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans. Graph. 29(3),
2010, section 3 ("Vertex"); Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological
University, 2019, chapter 4 ("Localized").)";

constexpr const char* BiharmonicDocumentation =
  "Biharmonic, commute-time or diffusion distances from each source.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n"
  "sources : surface points\n"
  "kind : {\"Biharmonic\", \"CommuteTime\", \"Diffusion\"}\n"
  "method : {\"Spectrum\", \"Exact\"}\n"
  "number_of_eigenvalues : int\n"
  "diffusion_time : float\n"
  "    Square of a length; 0 for an automatic one.\n"
  "unreached_value : float\n"
  "    Distance in other components. Default: NaN.\n" DGG_SPECTRAL_DOCUMENTATION
  "\n\nReferences\n----------\n"
  R"(Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans. Graph. 29(3),
2010, sections 3 and 4; R. R. Coifman, S. Lafon, "Diffusion maps", Appl. Comput. Harmon. Anal. 21,
2006.)";

constexpr const char* SplineDocumentation =
  "Basis functions of sites, interpolation of values at sites, and Poisson equations.\n\n"
  "Parameters\n----------\n"
  "surface : Surface\n"
  "sources : surface points, optional\n"
  "    Sites. Default: `number_of_sites` sites are chosen.\n"
  "order : {\"Harmonic\", \"Biharmonic\"}\n"
  "number_of_sites : int\n"
  "surface_values, point_values : array_like, shape (n,) or (n, k), optional\n"
  "    Values to interpolate: per point of the surface for sites that are ids, and per site for\n"
  "    all others.\n"
  "right_hand_side : array_like, shape (n,), optional\n"
  "    Of a Poisson equation, per point of the surface.\n"
  "right_hand_side_meaning : {\"Density\", \"Integrated\"}\n"
  "generate_basis, smooth_evaluation : bool\n"
  "cell_array_name, solution_array_name, interpolation_array_name : "
  "str\n" DGG_SPECTRAL_DOCUMENTATION
  " `used_sites` of the first result lists the\npoints of the sites, -1 unless at a point."
  "\n\nReferences\n----------\n"
  R"(P. Feng, J. Warren, "Discrete bi-Laplacians and biharmonic b-splines", ACM Trans. Graph. 31(4),
2012; Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological University, 2019, chapter 4
and section 6.2.1; G. Wahba, "Spline interpolation and smoothing on the sphere", SIAM J. Sci. Stat.
Comput. 2(1), 1981.)";

/// A task and its factorization, which calls reuse.
template <typename Task>
struct SpectralSession
{
  dgg::PoissonSession Poisson;
  Task Function;
};

/// Arguments and results that all spectral functions share.
class Spectral
{
public:
  Spectral(const py::object& sources, const char* resultName, Arguments& arguments)
    : Sources(sources, "source", "Sources")
    , Targets(arguments.Take("evaluation"), "evaluation point", "Evaluation")
    , ResultName(resultName)
  {
    this->Sources.ReadTolerance(arguments);
    this->Targets.ReadTolerance(arguments);
    arguments.ReadChoice("boundary",
      { { "Neumann", dgg::PoissonBoundary::Neumann },
        { "Dirichlet", dgg::PoissonBoundary::Dirichlet } },
      this->Options.Boundary);
    arguments.Read("intrinsic_delaunay", this->Options.IntrinsicDelaunay);
    arguments.Read("result_array_name", this->ResultName);
    ThrowUnlessOk(dgg::CheckNames({ { "ResultArrayName", this->ResultName } }));
  }

  SurfacePoints& GetSources() { return this->Sources; }
  const std::string& GetResultName() const { return this->ResultName; }

  /// Runs a task whose other options are set.
  py::tuple Run(
    Call& call, const Surface& surface, dgg::PoissonSession& session, dgg::SpectralTask& task)
  {
    task.Poisson.Boundary = this->Options.Boundary;
    task.Poisson.IntrinsicDelaunay = this->Options.IntrinsicDelaunay;
    task.ResultName = this->ResultName;
    dgg::Output outputs[2];
    call.Run([&] { return this->Compute(call.MakeContext(surface), session, task, outputs); });
    return py::make_tuple(ToPython(outputs[0]), ToPython(outputs[1]));
  }

private:
  dgg::Status Compute(const dgg::TaskContext& context, dgg::PoissonSession& session,
    dgg::SpectralTask& task, dgg::Output* outputs) const
  {
    DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, "Spectral functions"));
    std::vector<dgg::SurfacePoint> sources;
    std::vector<dgg::SurfacePoint> targets;
    if (!task.CanChooseSources() || !this->Sources.IsEmpty())
    {
      DGG_RETURN_IF_ERROR(this->Sources.Locate(context, sources));
    }
    if (!this->Targets.IsEmpty())
    {
      DGG_RETURN_IF_ERROR(this->Targets.Locate(context, targets));
    }
    return task.Run(
      context, session, sources, targets, "Use a smaller mesh or fewer sources at a time", outputs);
  }

  SurfacePoints Sources;
  SurfacePoints Targets;
  std::string ResultName;
  dgg::PoissonOptions Options;
};

//------------------------------------------------------------------------------
py::list ListUsedMethods(const dgg::GreensTask& task, std::size_t numberOfSources)
{
  static const char* const names[] = { "SingularitySubtraction", "Localized", "Interpolated",
    "Vertex" };
  py::list used;
  for (std::size_t i = 0; i < numberOfSources; ++i)
  {
    const dgg::GreensTask::UsedMethod method = task.GetUsed(static_cast<dgg::Offset>(i));
    py::dict item;
    item["method"] = names[method.Method];
    item["radius"] = method.Radius;
    item["is_near_ridge"] = method.Remark == dgg::GreensRemark::NearRidge;
    used.append(item);
  }
  return used;
}

py::object FindGreens(const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  using Method = dgg::GreensMethod;
  Arguments arguments(keywords);
  Call call(arguments);
  Spectral spectral(sources, "GreensFunction", arguments);
  const SessionPool<SpectralSession<dgg::GreensTask>>::Loan session(
    surface.GetPool<SpectralSession<dgg::GreensTask>>());
  dgg::GreensTask& task = session->Function;
  dgg::GreensQuery query;
  dgg::PoissonWeights weights = dgg::PoissonOptions().Weights;
  bool isInterpolated = false;
  arguments.ReadChoice("order",
    { { "Laplace", dgg::GreensOrder::Laplace }, { "BiLaplace", dgg::GreensOrder::BiLaplace } },
    query.Order);
  arguments.ReadChoice("method",
    { { "SingularitySubtraction", Method::SingularitySubtraction },
      { "Localized", Method::Localized }, { "Interpolated", Method::Interpolated },
      { "Vertex", Method::Vertex } },
    query.Method);
  arguments.ReadChoice("sign_convention",
    { { "PositiveAtSource", dgg::GreensSign::Positive },
      { "NegativeAtSource", dgg::GreensSign::Negative } },
    query.Sign);
  arguments.ReadChoice("pole_value",
    { { "CellAverage", dgg::GreensPole::CellAverage }, { "Infinite", dgg::GreensPole::Infinite } },
    query.Pole);
  arguments.ReadChoice("weighting",
    { { "Area", dgg::PoissonWeights::Area }, { "Uniform", dgg::PoissonWeights::Uniform } },
    weights);
  arguments.ReadLength("radius", query.Radius);
  arguments.Read("interpolate_regular_part", isInterpolated);
  task.Query = query;
  task.Poisson.Weights = weights;
  task.IsInterpolated = isInterpolated && query.Method == Method::SingularitySubtraction;
  task.Forget();
  py::tuple results = spectral.Run(call, surface, session->Poisson, task);
  results[0].attr("used") = ListUsedMethods(task, spectral.GetSources().Size());
  return results;
}

//------------------------------------------------------------------------------
py::object FindBiharmonic(
  const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Spectral spectral(sources, "BiharmonicDistance", arguments);
  const SessionPool<SpectralSession<dgg::SpectralDistanceTask>>::Loan session(
    surface.GetPool<SpectralSession<dgg::SpectralDistanceTask>>());
  dgg::SpectralDistanceTask& task = session->Function;
  dgg::SpectralOptions options;
  task.UnreachedValue = std::numeric_limits<double>::quiet_NaN();
  arguments.ReadChoice("kind",
    { { "Biharmonic", dgg::SpectralKind::Biharmonic },
      { "CommuteTime", dgg::SpectralKind::CommuteTime },
      { "Diffusion", dgg::SpectralKind::Diffusion } },
    options.Kind);
  arguments.ReadChoice("method",
    { { "Spectrum", dgg::SpectralMethod::Spectrum }, { "Exact", dgg::SpectralMethod::Exact } },
    options.Method);
  arguments.Read("number_of_eigenvalues", options.NumberOfEigenvalues);
  arguments.ReadLength("diffusion_time", options.Time);
  arguments.Read("unreached_value", task.UnreachedValue);
  task.Options = options;
  return spectral.Run(call, surface, session->Poisson, task);
}

//------------------------------------------------------------------------------
void ReadSplineOptions(Arguments& arguments, dgg::SplineTask& task)
{
  const dgg::SplineTask defaults;
  task.WantResult = defaults.WantResult;
  task.NumberOfSites = defaults.NumberOfSites;
  task.IsBiharmonic = defaults.IsBiharmonic;
  task.IsSmooth = defaults.IsSmooth;
  task.IsDensity = defaults.IsDensity;
  task.CellName = "Cell";
  task.SolutionName = "PoissonSolution";
  task.InterpolationName = "Interpolation";
  arguments.ReadChoice(
    "order", { { "Harmonic", false }, { "Biharmonic", true } }, task.IsBiharmonic);
  arguments.ReadChoice(
    "right_hand_side_meaning", { { "Density", true }, { "Integrated", false } }, task.IsDensity);
  arguments.Read("number_of_sites", task.NumberOfSites);
  arguments.Read("generate_basis", task.WantResult);
  arguments.Read("smooth_evaluation", task.IsSmooth);
  arguments.Read("cell_array_name", task.CellName);
  arguments.Read("solution_array_name", task.SolutionName);
  arguments.Read("interpolation_array_name", task.InterpolationName);
}

py::object FindSpline(const Surface& surface, const py::object& sources, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  Spectral spectral(sources, "HarmonicBSpline", arguments);
  const SessionPool<SpectralSession<dgg::SplineTask>>::Loan session(
    surface.GetPool<SpectralSession<dgg::SplineTask>>());
  dgg::SplineTask& task = session->Function;
  ReadSplineOptions(arguments, task);
  ThrowUnlessOk(dgg::SplineTask::CheckNames(
    spectral.GetResultName(), task.CellName, task.SolutionName, task.InterpolationName));
  task.Forget();
  task.RightHandSide = ToInputArray(arguments.Take("right_hand_side"), "right_hand_side");
  task.SurfaceValues = ToInputArray(arguments.Take("surface_values"), "surface_values");
  task.PointValues = ToInputArray(arguments.Take("point_values"), "point_values");
  // Both arrays have the same name; either may be missing.
  task.SurfaceValues.Name = task.SurfaceValues.Name + task.PointValues.Name;
  task.PointValues.Name = task.SurfaceValues.Name;
  const dgg::SourceCollection& sites = spectral.GetSources().GetCollection();
  task.GivenIds = sites.Ids;
  task.NumberOfGivenPoints = static_cast<dgg::Offset>(sites.Positions.size() / 3);
  py::tuple results = spectral.Run(call, surface, session->Poisson, task);
  results[0].attr("used_sites") = ToArray(std::vector<dgg::Offset>(task.GetUsedSites()));
  return results;
}
}

//------------------------------------------------------------------------------
void AddSpectral(py::module_& module)
{
  module.def(
    "greens_function", &FindGreens, py::arg("surface"), py::arg("sources"), GreensDocumentation);
  module.def("biharmonic_distance", &FindBiharmonic, py::arg("surface"), py::arg("sources"),
    BiharmonicDocumentation);
  module.def("harmonic_spline", &FindSpline, py::arg("surface"), py::arg("sources") = py::none(),
    SplineDocumentation);
}
}
