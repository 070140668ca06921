// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The graph of a surface in pieces on several processes, and its search: time, memory, messages.
///
/// Usage: mpiexec -n N BenchmarkProcesses [--accuracy=0.01] [--division=strips] [--queries=4]
///          [--repeats=3] [--threads=2] [--terrain=N] [--replay=P] [--rows=N] [--row-threads=1]
///          [--out=FILE] [mesh...]
///
/// Divisions are strips, bisection and scattered. --terrain measures a terrain of N x N points
/// instead. One process with --threads threads then does the same work, and the results are
/// compared bit by bit, unless --threads=0. With --replay=P (or several numbers, separated by
/// commas), its graph and its trees give the number of ghosts, layers and rounds on P processes.
/// --rows=N also finds a matrix of N points on all processes, in the graph of the first one.
///
/// Each mesh gives one line of JSON, which measure_processes.py reads. Lists have one value per
/// process. Times are the minimum of the repetitions. "work" is the sum of CPU times between
/// messages, each of the slowest process: the time with one core per process and without waiting.
/// "exchanges" are transfers in which all processes take part. "boost_seconds" are the times of
/// delta-stepping in the same graph, by the Parallel Boost Graph Library with several widths of
/// buckets. The largest difference of its distances from the labels is relative.

#include "BenchmarkArguments.h"
#include "BenchmarkTools.h"
#include "DGGDistributor.h"
#include "DivisionReplay.h"
#include "MeshFile.h"
#include "PartTestTools.h"
#ifdef DGG_WITH_BOOST
#include "PeerBoost.h"
#endif

#include "dggBitHash.h"
#include "dggMatrixRows.h"
#include "dggPieceGraph.h"
#include "dggPieceSearch.h"
#include "dggPreparedSurface.h"
#include "dggSurfaceRegion.h"
#include "dggTaskContext.h"

#include <vtkMPIController.h>

#include <chrono>
#include <fstream>
#include <iostream>
#include <thread>

namespace
{
using Numbers = std::vector<double>;

/// Layers of cells that measure the boundary of a piece.
constexpr int Layers = 4;
#ifdef DGG_WITH_BOOST
/// Widths of buckets of delta-stepping, in mean lengths of edges. Narrower ones are not tried after
/// one that takes more than twice the shortest time.
constexpr double Widths[] = { 16.0, 4.0, 1.0, 0.25, 0.0625 };
#endif
/// Members of a step, see the top of this file; messages that are empty or to the same process do
/// not count.
enum
{
  Seconds,
  Work,
  Exchanges,
  Messages,
  Bytes
};
const char* const Names[] = { "_seconds", "_work", "_exchanges", "_messages", "_bytes" };
using Step = std::array<double, 5>;

/// One line of JSON.
class Line
{
public:
  void AddText(const std::string& name, const std::string& value)
  {
    this->Text += (this->Text.empty() ? "{\"" : ", \"") + name + "\": " + value;
  }
  void Add(const std::string& name, double value) { this->AddText(name, this->Write({ value })); }
  void Add(const std::string& name, const Numbers& values)
  {
    this->AddText(name, "[" + this->Write(values) + "]");
  }
  void Add(const std::string& name, const Step& step)
  {
    for (std::size_t k = 0; k < step.size(); ++k)
    {
      this->Add(name + Names[k], step[k]);
    }
  }
  std::string Get() const { return this->Text + "}"; }

private:
  static std::string Write(const Numbers& values)
  {
    std::ostringstream stream;
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      stream << (k > 0 ? ", " : "") << std::setprecision(10) << values[k];
    }
    return stream.str();
  }

  std::string Text;
};

/// The processes, and counters of their messages.
class Processes
{
public:
  explicit Processes(vtkMPIController* controller)
    : Controller(controller)
  {
    this->Group.Here = controller->GetLocalProcessId();
    this->Group.Count = controller->GetNumberOfProcesses();
    this->Group.Transfer = [this](
                             std::vector<dgg::Message>& sent, std::vector<dgg::Message>& received) {
      this->Works.push_back(ThreadSeconds() - this->Resumed);
      ++this->Counted[Exchanges];
      for (int to = 0; to < this->Group.Count; ++to)
      {
        const bool isCounted = to != this->Group.Here && !sent[to].empty();
        this->Counted[Messages] += isCounted ? 1.0 : 0.0;
        this->Counted[Bytes] += isCounted ? static_cast<double>(sent[to].size()) : 0.0;
      }
      DGGDistributor::Get()->Transfer(this->Controller, sent, received);
      this->Resumed = ThreadSeconds();
    };
    this->Group.FindFailure = [this](const dgg::Status& status) {
      this->Works.push_back(ThreadSeconds() - this->Resumed);
      Require(status); // ends all processes
      this->Controller->Barrier();
      this->Resumed = ThreadSeconds();
      return status;
    };
    this->Group.ShareMemory = [this](
                                std::vector<dgg::SharedBlock>& blocks, dgg::SharedCopies& copies) {
      return DGGDistributor::Get()->ShareMemory(this->Controller, blocks, copies);
    };
  }

  void Gather(Line& line, const char* name, double value) const
  {
    Numbers all(static_cast<std::size_t>(this->Group.Count));
    this->Controller->Gather(&value, all.data(), 1, 0);
    line.Add(name, all);
  }

  /// Runs a step on all processes several times.
  Step Measure(int repeats, const std::function<void()>& run)
  {
    Step step{ dgg::Infinity, dgg::Infinity };
    for (int repeat = 0; repeat < repeats; ++repeat)
    {
      this->Counted = Step();
      this->Works.clear();
      this->Controller->Barrier();
      const double start = WallSeconds();
      this->Resumed = ThreadSeconds();
      run();
      this->Works.push_back(ThreadSeconds() - this->Resumed);
      this->Works.push_back(WallSeconds() - start);
      Numbers slowest(this->Works.size());
      this->Controller->AllReduce(this->Works.data(), slowest.data(),
        static_cast<vtkIdType>(slowest.size()), vtkCommunicator::MAX_OP);
      step[Seconds] = std::min(step[Seconds], slowest.back());
      step[Work] = std::min(step[Work], std::accumulate(slowest.begin(), slowest.end() - 1, 0.0));
    }
    step[Exchanges] = this->Counted[Exchanges];
    this->Controller->AllReduce(
      this->Counted.data() + Messages, step.data() + Messages, 2, vtkCommunicator::SUM_OP);
    return step;
  }

  /// Runs a function on the first process, while the others wait without using a core.
  void RunOnFirst(const std::function<void()>& run) const
  {
    constexpr int tag = 77;
    int done = 1;
    if (this->Group.Here == 0)
    {
      run();
      for (int process = 1; process < this->Group.Count; ++process)
      {
        this->Controller->Send(&done, 1, process, tag);
      }
      return;
    }
    vtkMPICommunicator::Request request;
    for (this->Controller->NoBlockReceive(&done, 1, 0, tag, request); request.Test() == 0;)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  dgg::ProcessGroup Group;

private:
  vtkMPIController* Controller;
  Step Counted;
  Numbers Works; // CPU seconds between messages
  double Resumed = 0.0;
};

/// Assigns each cell to one of `count` pieces.
dggtest::Labels Divide(vtkPolyData* surface, const std::string& division, int count)
{
  return division == "strips" ? dggtest::LabelStrips(surface, count)
    : division == "bisection" ? dggtest::LabelBisection(surface, count)
                              : dggtest::LabelScattered(surface, count);
}

/// A piece of a mesh.
struct Piece
{
  Piece(vtkPolyData* surface, const std::string& division, const dgg::ProcessGroup& group)
  {
    const auto part = dggtest::TakePart(
      surface, Divide(surface, division, group.Count), group.Here, dggtest::PartIds::Global);
    this->Arrays = ToArrays(part);
    this->Corners.assign(this->Arrays.Triangles.begin(), this->Arrays.Triangles.end());
    for (std::size_t corner = 0; corner <= this->Corners.size(); corner += 3)
    {
      this->Offsets.push_back(static_cast<dgg::Offset>(corner));
    }
    const auto getIds = [](vtkDataSetAttributes* data) {
      auto* ids = vtkIdTypeArray::SafeDownCast(data->GetGlobalIds());
      return std::vector<dgg::Offset>(ids->Begin(), ids->End());
    };
    this->PointIds = getIds(part->GetPointData());
    this->CellIds = getIds(part->GetCellData());
    this->Input.Points = this->Arrays.Points.data();
    this->Input.NumberOfPoints = static_cast<dgg::Offset>(this->PointIds.size());
    this->Input.Cells[2] = { static_cast<dgg::Offset>(this->CellIds.size()), this->Offsets.data(),
      this->Corners.data(), static_cast<dgg::Offset>(this->Corners.size()) };
    this->Input.PointIds = this->PointIds.data();
    this->Input.CellIds = this->CellIds.data();
  }
  Piece(const Piece&) = delete;

  MeshArrays Arrays;
  std::vector<dgg::Offset> Corners;
  std::vector<dgg::Offset> Offsets;
  std::vector<dgg::Offset> PointIds;
  std::vector<dgg::Offset> CellIds;
  dgg::SurfacePiece Input;
};

/// Returns the sum of hashes of the rows of some vertices, and of their results.
dgg::Signature HashRows(const dgg::GeodesicGraph& graph, const std::vector<dgg::Offset>& ids,
  const std::vector<dgg::PieceDistances>& results, const std::function<bool(dgg::Id)>& isHere)
{
  std::vector<dgg::Signature> hashes;
  for (dgg::Id v = 0; v < graph.GetNumberOfVertices(); ++v)
  {
    if (!isHere(v))
    {
      continue;
    }
    const auto begin = static_cast<std::size_t>(graph.Offsets[v]);
    const auto size = static_cast<std::size_t>(graph.Offsets[v + 1]) - begin;
    dgg::BitHash hash;
    hash.Add(&ids[v], 1);
    for (std::size_t e = begin; e < begin + size; ++e)
    {
      hash.Add(&ids[graph.Targets[e]], 1);
    }
    hash.Add(graph.Lengths.Data() + begin, size);
    hash.Add(graph.Angles.Data() + begin, size);
    hash.Add(graph.ArrivalAngles.Data() + begin, size);
    for (const dgg::PieceDistances& result : results)
    {
      hash.Add(&result.Labels[v], 1);
      hash.Add(&result.Corrected[v], 1);
      hash.Add(&result.NearestSource[v], 1);
    }
    hashes.push_back(hash.Finish());
  }
  return dgg::SumSignatures(hashes);
}

/// Builds and searches the graph of a mesh on one process.
class Alone
{
public:
  Alone(Line& line, vtkPolyData* input, const BenchmarkArguments& arguments)
  {
    const MeshArrays mesh = ToArrays(input);
    const int threads = arguments.GetInteger("threads");
    const int queries = arguments.GetInteger("queries");
    const auto measure = [&](const std::string& name, const std::function<void()>& run) {
      double seconds = dgg::Infinity;
      double work = dgg::Infinity;
      for (int repeat = 0; repeat < arguments.GetInteger("repeats"); ++repeat)
      {
        const double start = WallSeconds();
        const double before = CPUSeconds();
        run();
        work = std::min(work, CPUSeconds() - before);
        seconds = std::min(seconds, WallSeconds() - start);
      }
      line.Add("alone_" + name + Names[Seconds], seconds);
      line.Add("alone_" + name + Names[Work], work); // of all threads together
    };
    dgg::GraphOptions options;
    options.Accuracy = arguments.GetNumber("accuracy");
    options.NumberOfThreads = threads;
    options.Parallel = ThreadedLoop(threads);
    dgg::SurfaceMesh surface;
    const auto n = static_cast<dgg::Offset>(mesh.GetNumberOfVertices());
    auto probe = std::make_unique<const MemoryProbe>();
    measure("build", [&] {
      Require(dgg::SurfaceMesh::FromPoints(mesh.Points.data(), n, mesh.Triangles.data(),
        static_cast<dgg::Offset>(mesh.GetNumberOfFaces()), surface));
      Require(dgg::GraphBuilder(surface).Build(options, this->Graph));
    });
    line.Add("alone_build_peak", static_cast<double>(probe->GetHeapPeak()));
    probe = std::make_unique<const MemoryProbe>();
    const dgg::GraphSearch search(this->Graph.View(), &surface);
    dgg::SearchOptions searched;
    searched.Correct = true;
    std::vector<dgg::SearchResult> results(static_cast<std::size_t>(queries));
    measure("queries", [&] {
      for (int query = 0; query < queries; ++query)
      {
        dgg::GraphSeed seed;
        seed.Vertex = static_cast<dgg::Id>(n * query / queries);
        Require(search.Run({ seed }, searched, results[query]));
      }
    });
    for (const dgg::SearchResult& result : results)
    {
      this->Results.push_back({ result.Distances, result.Corrected, result.Seeds, {}, {} });
    }
    line.Add("threads", threads);
    line.Add("edges", static_cast<double>(this->Graph.Targets.Size()));
    line.Add("reach", MeasureReach(mesh, this->Graph));
    Numbers lists[6];
    for (const int pieces : arguments.GetIntegers("replay"))
    {
      const DivisionReplay replay(
        mesh, Divide(input, arguments.Get("division"), pieces), this->Graph, results);
      lists[0].push_back(pieces);
      lists[1].push_back(replay.Ghosts);
      lists[2].push_back(replay.LabelRounds);
      lists[3].push_back(replay.TreeRounds);
      lists[5].push_back(replay.Depth);
      lists[4].insert(lists[4].end(), replay.Layers.begin(), replay.Layers.end());
    }
    line.Add("replay_processes", lists[0]);
    line.Add("replay_ghosts", lists[1]);
    line.Add("replay_label_rounds", lists[2]);
    line.Add("replay_tree_rounds", lists[3]);
    line.Add("replay_layers", lists[4]);
    line.Add("replay_depth", lists[5]);
    std::vector<dgg::Offset> ids(static_cast<std::size_t>(n));
    std::iota(ids.begin(), ids.end(), 0);
    this->Hash = HashRows(this->Graph, ids, this->Results, [](dgg::Id) { return true; });
  }

  dgg::Signature Hash{};

private:
  dgg::GeodesicGraph Graph;
  std::vector<dgg::PieceDistances> Results;
};

/// Finds the distances between some points. The first process has the graph.
void RunRows(
  Processes& processes, const BenchmarkArguments& arguments, vtkPolyData* input, Line& line)
{
  dgg::ProcessGroup& group = processes.Group;
  const Piece all(input, "strips", dgg::ProcessGroup());
  dgg::SurfaceArrays arrays;
  arrays.Points = all.Input.Points;
  arrays.NumberOfPoints = all.Input.NumberOfPoints;
  arrays.Polygons = all.Input.Cells[2];
  dgg::PreparedSurface::Pointer surface;
  Require(dgg::PreparedSurface::Make(
    arrays, {}, dgg::PreparedSurface::ComputeFingerprint(arrays, {}), surface));
  dgg::GraphOptions options;
  options.Accuracy = arguments.GetNumber("accuracy");
  dgg::GeodesicGraph graph;
  dgg::MatrixRowLinks links;
  dgg::MatrixRowOptions rows;
  rows.NumberOfSources = arguments.GetInteger("rows");
  rows.HasTargets = true;
  rows.IsSymmetric = true;
  for (std::size_t i = 0; i < rows.NumberOfSources; ++i)
  {
    const auto row = static_cast<dgg::Id>(i);
    const auto v = static_cast<dgg::Id>(i * arrays.NumberOfPoints / rows.NumberOfSources);
    links.Seeds.push_back({ v, 0.0, 0.0, row, -1.0 });
    links.Targets.push_back({ row, v, 0.0 });
  }
  if (group.Here == 0)
  {
    Require(dgg::GraphBuilder(surface->GetMesh()).Build(options, graph));
  }
  const int threads = arguments.GetInteger("row-threads");
  dgg::TaskContext context{ *surface, {}, threads, nullptr, ThreadedLoop(threads), nullptr };
  context.Group = group.Count > 1 ? &group : nullptr;
  const MemoryProbe probe;
  line.Add("rows", processes.Measure(arguments.GetInteger("repeats"), [&] {
    if (group.Here > 0)
    {
      Require(dgg::HelpFirstProcess(context));
      return;
    }
    const dgg::GraphSearch search(graph.View(), &surface->GetMesh());
    Require(dgg::FindMatrixRows(
      context, search, links, rows, nullptr, [](std::size_t, const dgg::DistanceRow&) {}));
    if (context.Group)
    {
      Require(dgg::DismissHelpers(group));
    }
  }));
  processes.Gather(line, "rows_peak", static_cast<double>(probe.GetHeapPeak()));
}

void RunMesh(Processes& processes, const BenchmarkArguments& arguments, const std::string& name,
  const std::function<vtkSmartPointer<vtkPolyData>()>& make, std::ostream& file)
{
  dgg::ProcessGroup& group = processes.Group;
  const int repeats = arguments.GetInteger("repeats");
  const int queries = arguments.GetInteger("queries");
  const Piece piece(make(), arguments.Get("division"), group);
  Line line;
  const auto report = [&](const char* key, auto value) {
    processes.Gather(line, key, static_cast<double>(value));
  };
  line.AddText("mesh", '"' + name + '"');
  line.AddText("division", '"' + arguments.Get("division") + '"');
  line.Add("processes", group.Count);
  line.Add("accuracy", arguments.GetNumber("accuracy"));
  report("points", piece.PointIds.size());
  report("faces", piece.CellIds.size());

  static const dgg::PreparedSurface none;
  const dgg::TaskContext context{ none, {}, 1, nullptr, nullptr, nullptr };
  dgg::GraphOptions options;
  options.Accuracy = arguments.GetNumber("accuracy");
  dgg::PieceGraph graph;
  bool isUsable = false;
  auto probe = std::make_unique<const MemoryProbe>();
  line.Add("build", processes.Measure(repeats, [&] {
    dgg::GraphEstimate estimate;
    std::vector<std::string> warnings;
    Require(dgg::BuildPieceGraph(
      context, group, piece.Input, options, graph, estimate, warnings, isUsable));
    Require(isUsable, "the pieces of " + name + " must be gathered");
  }));
  report("build_peak", probe->GetHeapPeak());
  report("shared", // about half of them belong to other processes
    2 *
      std::count_if(graph.Owners.begin(), graph.Owners.begin() + piece.Input.NumberOfPoints,
        [](dgg::Id owner) { return owner != dgg::GhostVertices::Here; }));
  report("ghosts", graph.GhostIds.Size());
  report("graph_bytes", graph.Rows.GetMemorySize());
  dgg::SurfaceRegion region;
  dgg::RegionMesh mesh;
  Require(region.Start(group, piece.Input, isUsable));
  Require(region.Grow(group, Layers, true, 0.0));
  region.MakeMesh(mesh);
  report("layer_cells", (mesh.CellIds.size() - piece.CellIds.size()) / Layers);

  probe = std::make_unique<const MemoryProbe>();
  const dgg::GhostVertices ghosts{ graph.GhostIds.Data(),
    static_cast<dgg::Id>(graph.GhostIds.Size()), graph.Owners.Data() };
  dgg::PieceSearch search;
  line.Add("prepare", processes.Measure(repeats, [&] {
    Require(search.Prepare(group, piece.Input, graph.Rows.View(), ghosts, isUsable));
  }));
  const dgg::Offset n = search.GetNumberOfPoints();
  line.Add("vertices", static_cast<double>(n));
  std::vector<dgg::PieceDistances> results(static_cast<std::size_t>(queries));
  const auto source = [&](int query) { return n * query / queries; };
  const auto measure = [&](const std::function<void(int)>& run) {
    Step mean{};
    for (int query = 0; query < queries; ++query)
    {
      const Step one = processes.Measure(repeats, [&] { run(query); });
      std::transform(one.begin(), one.end(), mean.begin(), mean.begin(),
        [&](double value, double sum) { return sum + value / queries; });
    }
    return mean;
  };
  for (const bool isCorrected : { false, true })
  {
    dgg::PieceSearchOptions searched;
    searched.Correct = isCorrected;
    searched.FindSources = isCorrected;
    line.Add(isCorrected ? "query" : "labels", measure([&](int query) {
      Require(search.Run(group, { { source(query), {} } }, searched, results[query], isUsable));
      Require(isUsable, "the paths on " + name + " are too long");
    }));
  }
  report("query_peak", probe->GetHeapPeak());
  probe.reset();

  std::vector<dgg::Offset> ids(piece.PointIds);
  ids.insert(ids.end(), graph.GhostIds.begin(), graph.GhostIds.end());
#ifdef DGG_WITH_BOOST
  PeerBoost peer(graph.Rows.View(), ids, ghosts);
  double difference = 0.0;
  Numbers seconds;
  for (const double width : Widths)
  {
    seconds.push_back(measure([&](int query) { peer.Run(source(query), width); })[Seconds]);
    for (int query = 0; query < queries; ++query)
    {
      peer.Run(source(query), width);
      const std::vector<double> distances = peer.GetDistances();
      for (std::size_t v = 0; v < distances.size(); ++v)
      {
        if (graph.Owners[v] == dgg::GhostVertices::Here)
        {
          const double label = results[query].Labels[v];
          difference = std::max(difference, std::abs(distances[v] / label - 1.0));
        }
      }
    }
    if (seconds.back() > 2.0 * *std::min_element(seconds.begin(), seconds.end()))
    {
      break;
    }
  }
  line.Add("boost_seconds", seconds);
  report("boost_difference", difference);
#endif

  if (arguments.GetInteger("threads") > 0)
  {
    std::vector<dgg::Signature> hashes;
    Require(group.Share(HashRows(graph.Rows, ids, results,
                          [&](dgg::Id v) { return graph.Owners[v] == dgg::GhostVertices::Here; }),
      hashes));
    processes.RunOnFirst([&] {
      const Alone alone(line, make(), arguments);
      line.AddText("same", alone.Hash == dgg::SumSignatures(hashes) ? "true" : "false");
    });
  }
  if (arguments.GetInteger("rows") > 0)
  {
    RunRows(processes, arguments, make(), line);
  }
  if (group.Here == 0)
  {
    std::cout << line.Get() << std::endl;
    file << line.Get() << std::endl;
  }
}
}

int main(int argc, char** argv)
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv, 0);
  try
  {
    Processes processes(controller);
    BenchmarkArguments arguments({ { "accuracy", "0.01" }, { "out", "" }, { "division", "strips" },
      { "queries", "4" }, { "repeats", "3" }, { "replay", "" }, { "row-threads", "1" },
      { "rows", "0" }, { "terrain", "" }, { "threads", "2" } });
    arguments.Parse(argc, argv);
    std::ofstream file;
    if (processes.Group.Here == 0)
    {
      file.open(arguments.Get("out"));
    }
    const std::vector<int> sizes = arguments.GetIntegers("terrain");
    for (const int size : sizes)
    {
      RunMesh(
        processes, arguments, "terrain-" + std::to_string(size),
        [size] { return dggtest::MakeTerrain(size); }, file);
    }
    for (const MeshRecipe& recipe :
      sizes.empty() ? arguments.GetMeshes() : std::vector<MeshRecipe>())
    {
      RunMesh(
        processes, arguments, recipe.Name, [&] { return recipe.Make(); }, file);
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    std::_Exit(EXIT_FAILURE); // ends the other processes
  }
  controller->Finalize();
  return 0;
}
