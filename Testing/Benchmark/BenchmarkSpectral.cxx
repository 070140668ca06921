// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Green's functions and their applications: times of factorizations, of columns, of sources at any
/// surface point by each method, of biharmonic columns, eigenpairs and an earth mover's distance;
/// compared with CHOLMOD, libigl and CGAL's heat method, as far as they were found, in one run.
///
/// Usage: BenchmarkSpectral [--benchmark_...] [--name=value...] [mesh...]
///   --sizes=35000,100000  vertices of generated tori; empty: none
///   --sources=5         of columns and Green's functions
///   --eigenpairs=100    number of eigenpairs; 0: none
///   --movers=1          number of earth mover's distances; 0: none
/// Meshes as for BenchmarkExact, without its generated surface. Peers need connected meshes.
///
/// Names of the results are
///   Spectral/MESH/CASE[/K]
///   Spectral/MESH/Greens/WAY/K
///   Peer/MESH/PEER/CASE[/K]         the peer Heat has two matrices
/// Times are CPU seconds on one thread. summarize.py writes tables of the result.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "FieldMethods.h"
#include "PeerPoisson.h"
#include "dggEarthMovers.h"
#include "dggEigenpairs.h"
#include "dggGreensFunction.h"
#include "dggGreensInterpolation.h"
#include "dggPoissonSolver.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace
{
struct OpenedSolver
{
  BenchmarkMesh* Mesh = nullptr;
  const dgg::PoissonSolver* Solver = nullptr;
};

/// Method of GreensFunction, or GreensInterpolation.
struct GreensWay
{
  std::string Name;
  dgg::GreensMethod Method = dgg::GreensMethod::SingularitySubtraction;
  bool IsInterpolation = false; ///< interpolation of regular parts
};

/// Common interface of all methods. The solver must be ready and outlive this object.
class MeasuredGreens
{
public:
  MeasuredGreens(const dgg::PoissonSolver& solver, const GreensWay& way)
    : Way(way)
    , Function(solver)
    , Interpolation(solver)
  {
  }

  dgg::Status Run(const dgg::SurfacePoint& pole, dgg::GreensResult& result)
  {
    dgg::GreensQuery query;
    query.Method = this->Way.Method;
    return this->Way.IsInterpolation ? this->Interpolation.Run(pole, query, result)
                                     : this->Function.Run(pole, query, result);
  }

private:
  GreensWay Way;
  dgg::GreensFunction Function;
  dgg::GreensInterpolation Interpolation;
};

struct PoissonPeer
{
  std::string Name;
  int Power = 1; ///< power of the Laplacian
  std::function<std::unique_ptr<PeerPoisson>(const MeshArrays& mesh)> Make;
};

/// Returns the factorized solver of a recipe. The solver of the last mesh is kept.
OpenedSolver OpenSolver(const MeshRecipe& recipe)
{
  static std::unique_ptr<dgg::PoissonSolver> kept;
  static std::string name;
  if (kept && name != recipe.Name)
  {
    kept.reset(); // release before its mesh is released and the next is allocated
  }
  BenchmarkMesh& mesh = OpenMesh(recipe);
  if (!kept)
  {
    auto solver = std::make_unique<dgg::PoissonSolver>(mesh.GetSurface());
    Require(solver->Prepare({}, nullptr));
    kept = std::move(solver);
    name = recipe.Name;
  }
  return { &mesh, kept.get() };
}

/// Returns a vector that is 1 at a vertex and 0 at all others.
std::vector<double> UnitLoad(const dgg::PoissonSolver& solver, dgg::Id vertex)
{
  std::vector<double> load(static_cast<std::size_t>(solver.GetMesh().GetNumberOfVertices()), 0.0);
  load[vertex] = 1.0;
  return load;
}

/// Computes the Green's function of a vertex: of the Laplacian for power 1, of the bi-Laplacian for
/// 2.
dgg::Status FindColumn(
  const dgg::PoissonSolver& solver, dgg::Id source, int power, std::vector<double>& values)
{
  values = UnitLoad(solver, source);
  dgg::Status status = solver.Solve(values);
  for (int k = 1; k < power && status.IsOk(); ++k)
  {
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      values[v] *= solver.GetAreas()[v];
    }
    status = solver.Solve(values);
  }
  return status;
}

const std::vector<GreensWay> GreensWays = {
  { "SingularitySubtraction", dgg::GreensMethod::SingularitySubtraction, false },
  { "RegularPart", dgg::GreensMethod::SingularitySubtraction, true },
  { "Localized", dgg::GreensMethod::Localized, false },
  { "Interpolated", dgg::GreensMethod::Interpolated, false },
  { "Vertex", dgg::GreensMethod::Vertex, false },
};

constexpr unsigned int PointSeed = 20190525u;

/// Measures matrix, elimination ordering and factorization; reports the memory that was predicted
/// after the ordering, and the memory used.
void MeasureFactor(benchmark::State& state, const MeshRecipe& recipe)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  std::unique_ptr<dgg::PoissonSolver> solver;
  dgg::Status status;
  double analysis = 0.0;
  const auto prepare = [&] {
    const double start = CPUSeconds();
    solver = std::make_unique<dgg::PoissonSolver>(mesh.GetSurface());
    status = solver->Prepare({}, nullptr, [&](double, double) {
      analysis = CPUSeconds() - start;
      return dgg::Status::Success();
    });
  };
  Measure(
    state, [&] { solver.reset(); }, prepare);
  Require(status);
  ReportMesh(state, mesh);
  state.counters["analysis_seconds"] = analysis;
  state.counters["factor_entries"] = static_cast<double>(solver->GetNumberOfFactorEntries());
  // Memory is measured in a separate run. The prediction is for the factorization, after the
  // analysis.
  solver.reset();
  const MemoryProbe probe;
  std::size_t analyzed = 0;
  std::optional<MemoryProbe> later;
  solver = std::make_unique<dgg::PoissonSolver>(mesh.GetSurface());
  solver->Prepare({}, nullptr, [&](double bytes, double) {
    state.counters["analysis_bytes"] = static_cast<double>(probe.GetHeapPeak());
    state.counters["predicted_bytes"] = bytes;
    analyzed = probe.GetHeapGrowth();
    later.emplace();
    return dgg::Status::Success();
  });
  state.counters["peak_bytes"] = static_cast<double>(analyzed + later->GetHeapPeak());
}

/// Measures the Green's function of the k-th of `numberOfSources` vertices: one solve.
void MeasureColumn(
  benchmark::State& state, const MeshRecipe& recipe, int power, int k, int numberOfSources)
{
  const OpenedSolver opened = OpenSolver(recipe);
  const dgg::Id source = opened.Mesh->GetSource(k, numberOfSources);
  std::vector<double> values;
  dgg::Status status;
  Measure(
    state, [&] { values.clear(); },
    [&] { status = FindColumn(*opened.Solver, source, power, values); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
}

/// Measures the Green's functions of a block of vertices that are solved for together.
void MeasureColumnBlock(benchmark::State& state, const MeshRecipe& recipe)
{
  const OpenedSolver opened = OpenSolver(recipe);
  constexpr int Count = dgg::GreensFunction::PolesInBlock;
  const dgg::GreensFunction function(*opened.Solver);
  std::vector<dgg::SurfacePoint> poles;
  for (int k = 0; k < Count; ++k)
  {
    poles.push_back(dgg::SurfacePoint::AtVertex(opened.Mesh->GetSource(k, Count)));
  }
  dgg::GreensQuery query;
  query.Method = dgg::GreensMethod::Vertex;
  std::vector<dgg::GreensResult> results;
  dgg::Status status;
  Measure(
    state, [&] { results.clear(); }, [&] { status = function.Run(poles, query, results); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["columns"] = Count;
}

/// Measures the Green's function of the k-th of `numberOfSources` random surface points. Data kept
/// between points, such as columns of vertices, already exist; the time of the first point is
/// reported separately.
void MeasureGreens(benchmark::State& state, const MeshRecipe& recipe, const GreensWay& way, int k,
  int numberOfSources)
{
  const OpenedSolver opened = OpenSolver(recipe);
  const dgg::SurfaceMesh& surface = opened.Mesh->GetSurface();
  const dgg::SurfacePoint pole = RandomPoints(surface, numberOfSources, false, PointSeed)[k];
  MeasuredGreens greens(*opened.Solver, way);
  dgg::GreensResult result;
  const double start = CPUSeconds();
  dgg::Status status = greens.Run(pole, result);
  const double first = CPUSeconds() - start;
  Measure(
    state, [] {}, [&] { status = greens.Run(pole, result); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["first_seconds"] = first;
  state.counters["radius_in_edges"] = result.Radius / surface.GetMeanEdgeLength();
  state.counters["other_method"] = result.Method == way.Method ? 0.0 : 1.0;
  state.counters["near_ridge"] = result.Remark == dgg::GreensRemark::NearRidge ? 1.0 : 0.0;
}

void MeasureEigenpairs(benchmark::State& state, const MeshRecipe& recipe, int count)
{
  const OpenedSolver opened = OpenSolver(recipe);
  std::vector<dgg::Eigenpairs> pairs;
  dgg::Status status;
  Measure(
    state, [&] { pairs.clear(); },
    [&] { status = dgg::FindEigenpairs(*opened.Solver, count, nullptr, pairs); });
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["pairs"] = pairs.front().GetCount();
  state.counters["complete"] = pairs.front().IsComplete ? 1.0 : 0.0;
}

/// Measures the earth mover's distance between two vertices, with default options; reports their
/// geodesic distance as well.
void MeasureEarthMovers(benchmark::State& state, const MeshRecipe& recipe)
{
  const OpenedSolver opened = OpenSolver(recipe);
  const dgg::Id here = opened.Mesh->GetSource(0, 2);
  const dgg::Id there = opened.Mesh->GetSource(1, 2);
  const std::vector<double> from = UnitLoad(*opened.Solver, here);
  const std::vector<double> to = UnitLoad(*opened.Solver, there);
  const dgg::EarthMovers movers(*opened.Solver);
  dgg::EarthMoversResult result;
  dgg::Status status;
  std::size_t peak = 0;
  Measure(
    state, [&] { result = dgg::EarthMoversResult(); },
    [&] {
      const MemoryProbe probe;
      status = movers.Run(from, to, {}, result);
      peak = probe.GetHeapPeak();
    });
  Require(status);
  ReportMesh(state, *opened.Mesh);
  state.counters["iterations"] = result.Iterations;
  state.counters["gap"] = (result.Distance - result.LowerBound) / result.Distance;
  state.counters["per_geodesic"] = result.Distance / opened.Mesh->GetExactDistances(here)[there];
  state.counters["heap_bytes_per_vertex"] =
    static_cast<double>(peak) / opened.Mesh->GetNumberOfVertices();
}

constexpr const char* Refusal = "the peer could not factorize or solve";

/// Returns a factorized solver. Only the last one is kept.
PeerPoisson* GetPrepared(
  const MeshRecipe& recipe, const BenchmarkMesh& mesh, const PoissonPeer& peer)
{
  static std::unique_ptr<PeerPoisson> kept;
  static std::string name;
  const std::string wanted = recipe.Name + "/" + peer.Name;
  if (!kept || name != wanted)
  {
    kept.reset(); // release before the next is allocated
    kept = peer.Make(mesh.GetArrays());
    name = wanted;
    if (!kept->Prepare())
    {
      kept.reset();
    }
  }
  return kept.get();
}

/// Returns the largest difference up to a constant, relative to the largest value.
double DifferenceOf(const dgg::PoissonSolver& solver, const std::vector<double>& ours,
  const std::vector<double>& theirs)
{
  double shift = 0.0;
  for (std::size_t v = 0; v < ours.size(); ++v)
  {
    shift += solver.GetWeight(static_cast<dgg::Id>(v)) * (theirs[v] - ours[v]);
  }
  double difference = 0.0;
  double size = 0.0;
  for (std::size_t v = 0; v < ours.size(); ++v)
  {
    difference = std::max(difference, std::abs(theirs[v] - shift - ours[v]));
    size = std::max(size, std::abs(ours[v]));
  }
  return difference / size;
}

/// Returns the peers that this build includes.
std::vector<PoissonPeer> ListPoissonPeers()
{
  std::vector<PoissonPeer> peers;
#ifdef DGG_WITH_CHOLMOD
  peers.push_back({ "Cholmod", 1, MakePeerCholmod });
#endif
#ifdef DGG_WITH_LIBIGL
  for (const int power : { 1, 2 })
  {
    peers.push_back({ power == 1 ? "Libigl" : "LibiglBiharmonic", power,
      [power](const MeshArrays& mesh) { return MakePeerLibigl(mesh, power); } });
  }
#endif
  return peers;
}

/// Measures matrix and factorization, and their peak memory.
void MeasurePeerFactor(benchmark::State& state, const MeshRecipe& recipe, const PoissonPeer& peer)
{
  const BenchmarkMesh& mesh = OpenMesh(recipe);
  bool isPrepared = false;
  std::unique_ptr<PeerPoisson> solver;
  Measure(
    state,
    [&] {
      solver.reset();
      solver = peer.Make(mesh.GetArrays());
    },
    [&] { isPrepared = solver->Prepare(); });
  Require(isPrepared, Refusal);
  ReportMesh(state, mesh);
  solver.reset();
  solver = peer.Make(mesh.GetArrays());
  const MemoryProbe probe;
  solver->Prepare();
  state.counters["peak_bytes"] = static_cast<double>(probe.GetHeapPeak());
}

/// Measures one solve for the k-th of `numberOfSources` vertices; reports the difference from our
/// solution.
void MeasurePeerColumn(benchmark::State& state, const MeshRecipe& recipe, const PoissonPeer& peer,
  int k, int numberOfSources)
{
  const OpenedSolver opened = OpenSolver(recipe);
  PeerPoisson* solver = GetPrepared(recipe, *opened.Mesh, peer);
  const dgg::Id source = opened.Mesh->GetSource(k, numberOfSources);
  std::vector<double> sources;
  for (dgg::Id v = 0; v < opened.Mesh->GetSurface().GetNumberOfVertices(); ++v)
  {
    sources.push_back((v == source ? 1.0 : 0.0) - opened.Solver->GetWeight(v));
  }
  std::vector<double> theirs;
  bool isSolved = solver != nullptr;
  Measure(
    state, [&] { theirs.clear(); }, [&] { isSolved = isSolved && solver->Solve(sources, theirs); });
  Require(isSolved, Refusal);
  std::vector<double> ours;
  Require(FindColumn(*opened.Solver, source, peer.Power, ours));
  ReportMesh(state, *opened.Mesh);
  state.counters["difference"] = DifferenceOf(*opened.Solver, ours, theirs);
}

void RegisterMesh(const MeshRecipe& mesh, const BenchmarkArguments& arguments, int sources)
{
  const CaseGroup cases("Spectral/" + mesh.Name + "/");
  cases.Add("Factor", MeasureFactor, mesh);
  cases.AddSources("Column", sources, MeasureColumn, mesh, 1);
  cases.Add("Block", MeasureColumnBlock, mesh);
  for (const GreensWay& way : GreensWays)
  {
    cases.AddSources("Greens/" + way.Name, sources, MeasureGreens, mesh, way);
  }
  cases.AddSources("Biharmonic", sources, MeasureColumn, mesh, 2);
  if (const int pairs = arguments.GetInteger("eigenpairs"))
  {
    cases.For(Once).Add("Eigenpairs", MeasureEigenpairs, mesh, pairs);
  }
  if (arguments.GetInteger("movers") > 0)
  {
    cases.For(Once).Add("EarthMovers", MeasureEarthMovers, mesh);
  }
}

void RegisterPeers(const MeshRecipe& mesh, int sources)
{
  for (const PoissonPeer& peer : ListPoissonPeers())
  {
    const CaseGroup cases("Peer/" + mesh.Name + "/" + peer.Name + "/");
    cases.Add("Factor", MeasurePeerFactor, mesh, peer);
    cases.AddSources("Column", sources, MeasurePeerColumn, mesh, peer);
  }
#ifdef DGG_WITH_HEAT
  const NamedMethod direct = HeatOfCGAL(PeerHeat::Triangulation::Direct);
  const CaseGroup cases("Peer/" + mesh.Name + "/Heat/");
  cases.Add("Factor", MeasurePreparation, mesh, direct);
  cases.AddSources("Column", sources, MeasureField, mesh, direct, dgg::Infinity);
#endif
}

/// Returns the recipe of a torus with about `size` vertices.
MeshRecipe TorusOf(int size)
{
  MeshRecipe torus;
  torus.Rings = static_cast<int>(std::lround(std::sqrt(2.0 * size)));
  torus.Name = "torus-" + SizeName(size);
  return torus;
}

std::vector<MeshRecipe> ListMeshes(const BenchmarkArguments& arguments)
{
  std::vector<MeshRecipe> meshes;
  for (const int size : arguments.GetIntegers("sizes"))
  {
    Require(size >= 100, "sizes must be at least 100");
    meshes.push_back(TorusOf(size));
  }
  for (const MeshRecipe& mesh : arguments.GetMeshes())
  {
    if (!mesh.File.empty())
    {
      meshes.push_back(mesh);
    }
  }
  return meshes;
}

void RegisterAll(const BenchmarkArguments& arguments)
{
  const int sources = arguments.GetAtLeast("sources", 1);
  for (const MeshRecipe& mesh : ListMeshes(arguments))
  {
    RegisterMesh(mesh, arguments, sources);
    RegisterPeers(mesh, sources);
  }
#ifdef DGG_WITH_CHOLMOD
  benchmark::AddCustomContext("cholmod_version", DGG_BENCHMARK_CHOLMOD);
#endif
}
}

int main(int argc, char** argv)
{
  return RunBenchmarks(argc, argv,
    { { "sizes", "35000,100000" }, { "sources", "5" }, { "eigenpairs", "100" }, { "movers", "1" } },
    RegisterAll);
}
