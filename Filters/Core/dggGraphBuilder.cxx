// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphBuilder.h"

#include "dggConeTracer.h"
#include "dggGraphAssembly.h"
#include "dggGraphPruning.h"
#include "dggGraphRules.h"
#include "dggRowStore.h"
#include "dggSurfaceOrder.h"
#include "dggUnfoldingTable.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <sstream>
#include <utility>

namespace dgg
{
namespace
{
/// Vertices that are close to each other in the tables: what a thread reads around them fits into
/// its cache.
constexpr Id PatchSize = 256;
/// Rows that a thread builds in one go.
constexpr Id BlockSize = 64;
/// Rows built between two looks at the abort flag: as many as take about this long.
constexpr double SecondsBetweenReports = 0.2;
constexpr Id SmallestWave = 1024;
constexpr Id LargestWave = 65536;
/// Of the progress; assembly gets the rest.
constexpr double ShareOfRows = 0.9;
/// Rows built for an estimate.
constexpr Id SampleSize = 128;

/// Edges of a graph by edges found, as measured on many meshes: uniting both directions adds some,
/// pruning candidates takes most away.
double UnitedShare(GraphConstruction construction)
{
  switch (construction)
  {
    case GraphConstruction::Guaranteed:
      return 1.22;
    case GraphConstruction::Indirect:
      return 0.22;
    case GraphConstruction::OneRelay:
    case GraphConstruction::SaddleVertexGraph:
      break;
  }
  return 1.1;
}

Status Overwhelmed(Id vertex)
{
  std::ostringstream message;
  message << "the light of vertex " << vertex
          << " multiplies without end, as it can among many non-manifold edges: make the mesh "
             "manifold, or use a larger accuracy";
  return Status::Invalid(message.str());
}

/// Rows that one thread has built.
struct RowBlock
{
  Id Overwhelmed = NoId; ///< first row that had to be given up
  std::vector<std::size_t> Sizes;
  std::vector<RowEdge> Edges;

  void AppendTo(RowStore& rows) const
  {
    const RowEdge* next = this->Edges.data();
    for (const std::size_t size : this->Sizes)
    {
      rows.AppendRow(next, next + size);
      next += size;
    }
  }
};
}

class GraphBuilder::Implementation
{
public:
  explicit Implementation(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , Table(mesh, ComputePatchOrder(mesh, PatchSize))
  {
  }

  Status Estimate(const GraphOptions& options, GraphEstimate& estimate) const;
  Status Build(
    const GraphOptions& options, GeodesicGraph& graph, GraphStatistics& statistics) const;
  Status Link(const SurfacePoint& point, double accuracy, const std::vector<SurfacePoint>& targets,
    std::vector<GraphLink>& links, std::vector<double>& direct) const;

private:
  /// Call `use(rule)` with the rule of a construction.
  template <typename User>
  static auto WithRule(const GraphOptions& options, User&& use)
  {
    switch (options.Construction)
    {
      case GraphConstruction::OneRelay:
        return use(OneRelayRule(options.Accuracy));
      case GraphConstruction::Indirect:
        return use(CandidateRule(options.Accuracy));
      case GraphConstruction::SaddleVertexGraph:
        return use(NearestRule(options.NumberOfNeighbors));
      case GraphConstruction::Guaranteed:
        break;
    }
    return use(ProgressRule(options.Accuracy));
  }

  /// The rows of all vertices. With `unite`, both directions of an edge are one.
  template <typename Rule>
  Status BuildRows(const Rule& rule, const GraphOptions& options, bool unite, RowStore& rows,
    GraphStatistics& statistics) const;
  bool NeedsWide(const GraphOptions& options) const;
  /// Rows [begin, end).
  template <typename Tracer>
  void FillBlock(Tracer& tracer, Id begin, Id end, RowBlock& block) const;

  const SurfaceMesh& Mesh;
  UnfoldingTable Table;
  mutable WorkspacePool<ConeTracer<ProgressRule>> Linkers;
};

//------------------------------------------------------------------------------
GraphBuilder::GraphBuilder(const SurfaceMesh& mesh)
  : Internals(std::make_unique<Implementation>(mesh))
{
}

GraphBuilder::~GraphBuilder() = default;

Status GraphBuilder::Check(const GraphOptions& options)
{
  std::ostringstream message;
  if (options.Construction == GraphConstruction::SaddleVertexGraph)
  {
    if (options.NumberOfNeighbors < 1)
    {
      message << "the number of neighbours is " << options.NumberOfNeighbors
              << ": it has to be at least 1";
      return Status::Invalid(message.str());
    }
  }
  else if (!(options.Accuracy >= MinimumAccuracy && options.Accuracy <= MaximumAccuracy))
  {
    message << "the accuracy is " << options.Accuracy << ": it has to be in [" << MinimumAccuracy
            << ", " << MaximumAccuracy << "]";
    return Status::Invalid(message.str());
  }
  return Status::Success();
}

Status GraphBuilder::Estimate(const GraphOptions& options, GraphEstimate& estimate) const
{
  estimate = GraphEstimate();
  const Status status = Check(options);
  return status.IsOk() ? this->Internals->Estimate(options, estimate) : status;
}

Status GraphBuilder::Build(
  const GraphOptions& options, GeodesicGraph& graph, GraphStatistics* statistics) const
{
  graph = GeodesicGraph();
  GraphStatistics unused;
  GraphStatistics& wanted = statistics ? *statistics : unused;
  wanted = GraphStatistics();
  Status status = Check(options);
  if (status.IsOk())
  {
    status = this->Internals->Build(options, graph, wanted);
  }
  if (!status.IsOk())
  {
    graph = GeodesicGraph();
  }
  return status;
}

Status GraphBuilder::Link(const SurfacePoint& point, double accuracy,
  const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
  std::vector<double>& direct) const
{
  links.clear();
  direct.clear();
  GraphOptions options;
  options.Accuracy = accuracy;
  const Status status = Check(options);
  return status.IsOk() ? this->Internals->Link(point, accuracy, targets, links, direct) : status;
}

//------------------------------------------------------------------------------
bool GraphBuilder::Implementation::NeedsWide(const GraphOptions& options) const
{
  // Sums of lengths must stay within the range of float as well, and lengths above its denormals.
  const double longest =
    this->Mesh.GetMaximumEdgeLength() * std::max<Id>(1, this->Mesh.GetNumberOfFaces());
  const double mean = this->Mesh.GetMeanEdgeLength();
  return (options.Construction != GraphConstruction::SaddleVertexGraph &&
           NeedsWideLengths(options.Accuracy)) ||
    longest > 1e37 || (mean > 0.0 && mean < 1e-25);
}

Status GraphBuilder::Implementation::Estimate(
  const GraphOptions& options, GraphEstimate& estimate) const
{
  const Id n = this->Table.GetNumberOfVertices();
  if (n == 0)
  {
    return Status::Success();
  }
  // Every k-th vertex of an order in which neighbours are close together.
  const Id count = std::min(n, SampleSize);
  std::size_t outEdges = 0;
  std::size_t workspace = 0;
  WithRule(options, [&](const auto& rule) {
    ConeTracer<std::decay_t<decltype(rule)>> tracer(this->Table, rule);
    for (Id i = 0; i < count; ++i)
    {
      const auto v = static_cast<Id>(static_cast<Offset>(n) * i / count);
      outEdges += tracer.TraceVertex(v).size();
    }
    workspace = tracer.GetMemorySize();
  });
  const double united = UnitedShare(options.Construction);
  const double out = static_cast<double>(outEdges) / count * n;
  const double bytes = this->NeedsWide(options) ? 20.0 : 16.0;
  estimate.Edges = std::min(out * united, static_cast<double>(n) * (n - 1.0));
  estimate.Memory = estimate.Edges * bytes + 8.0 * (n + 1.0);
  estimate.Peak = 1.3 * estimate.Memory + static_cast<double>(this->Table.GetMemorySize()) +
    static_cast<double>(workspace);
  if (options.Construction == GraphConstruction::Indirect)
  {
    estimate.Peak += out * bytes;
  }
  return Status::Success();
}

template <typename Rule>
Status GraphBuilder::Implementation::BuildRows(const Rule& rule, const GraphOptions& options,
  bool unite, RowStore& rows, GraphStatistics& statistics) const
{
  using Clock = std::chrono::steady_clock;
  const Id n = this->Table.GetNumberOfVertices();
  WorkspacePool<ConeTracer<Rule>> tracers;
  std::vector<RowBlock> blocks;
  std::atomic<std::size_t> windows{ 0 };
  Id wave = SmallestWave;
  for (Id first = 0; first < n;)
  {
    const auto start = Clock::now();
    const Id last = std::min(n, first + wave);
    blocks.resize(static_cast<std::size_t>((last - first + BlockSize - 1) / BlockSize));
    ForRange(
      options.Parallel, static_cast<Offset>(blocks.size()), 1, [&](Offset begin, Offset end) {
        const auto tracer = tracers.Borrow(this->Table, rule);
        const std::size_t before = tracer->GetNumberOfWindows();
        for (Offset b = begin; b < end; ++b)
        {
          const Id row = first + static_cast<Id>(b * BlockSize);
          this->FillBlock(*tracer, row, std::min<Id>(last, row + BlockSize), blocks[b]);
        }
        windows += tracer->GetNumberOfWindows() - before;
      });
    for (const RowBlock& block : blocks)
    {
      if (block.Overwhelmed != NoId)
      {
        return Overwhelmed(this->Table.OldVertex(block.Overwhelmed));
      }
      block.AppendTo(rows);
      statistics.OutEdges += block.Edges.size();
    }
    if (unite)
    {
      UniteDirections(rows, first, options.Parallel);
    }
    if (options.Progress && !options.Progress(ShareOfRows * last / n))
    {
      return Status::Abort();
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const double rate = (last - first) / std::max(seconds, 1e-6);
    wave = static_cast<Id>(
      std::max<double>(BlockSize, std::min<double>(LargestWave, rate * SecondsBetweenReports)));
    first = last;
  }
  statistics.Windows = windows;
  statistics.Workspace += tracers.GetMemorySize();
  return Status::Success();
}

template <typename Tracer>
void GraphBuilder::Implementation::FillBlock(
  Tracer& tracer, Id begin, Id end, RowBlock& block) const
{
  block.Overwhelmed = NoId;
  block.Sizes.clear();
  block.Edges.clear();
  for (Id row = begin; row < end; ++row)
  {
    const std::vector<FoundEdge>& edges = tracer.TraceVertex(row);
    if (tracer.WasOverwhelmed())
    {
      block.Overwhelmed = row;
      return;
    }
    block.Sizes.push_back(edges.size());
    for (const FoundEdge& edge : edges)
    {
      block.Edges.push_back(
        { edge.Target, edge.Length, this->Table.StoredAngle(row, edge.DepartureAngle(this->Table)),
          this->Table.StoredAngle(edge.Target, edge.ArrivalAngle(this->Table)) });
    }
  }
}

Status GraphBuilder::Implementation::Build(
  const GraphOptions& options, GeodesicGraph& graph, GraphStatistics& statistics) const
{
  const bool wide = this->NeedsWide(options);
  const bool isIndirect = options.Construction == GraphConstruction::Indirect;
  RowStore rows(wide);
  rows.ReserveRows(this->Table.GetNumberOfVertices());
  statistics.Workspace = this->Table.GetMemorySize();
  Status status = WithRule(options, [&](const auto& rule) {
    return this->BuildRows(rule, options, !isIndirect, rows, statistics);
  });
  if (!status.IsOk())
  {
    return status;
  }
  std::size_t pruningPeak = 0;
  if (isIndirect)
  {
    pruningPeak = rows.GetMemorySize();
    PruneCandidates(rows, options.Accuracy, options.Parallel);
    UniteDirections(rows, 0, options.Parallel);
  }
  std::vector<Id> order(this->Table.GetNumberOfVertices());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = this->Table.OldVertex(static_cast<Id>(i));
  }
  statistics.PeakMemory =
    std::max(pruningPeak, AssembleGraph(rows, order, wide, options.Parallel, graph));
  graph.Info.Kind = GraphKind::Mesh;
  graph.Info.Construction = options.Construction;
  const bool isByNumber = options.Construction == GraphConstruction::SaddleVertexGraph;
  graph.Info.Accuracy = isByNumber ? 0.0 : options.Accuracy;
  graph.Info.NumberOfNeighbors = isByNumber ? options.NumberOfNeighbors : 0;
  if (options.Progress && !options.Progress(1.0))
  {
    return Status::Abort();
  }
  return Status::Success();
}

Status GraphBuilder::Implementation::Link(const SurfacePoint& point, double accuracy,
  const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
  std::vector<double>& direct) const
{
  Status status = point.Check(this->Mesh);
  for (std::size_t t = 0; t < targets.size() && status.IsOk(); ++t)
  {
    status = targets[t].Check(this->Mesh);
  }
  if (!status.IsOk())
  {
    return status;
  }
  direct.assign(targets.size(), Infinity);
  if (point.On == SurfacePoint::Support::Vertex)
  {
    links.push_back({ point.Vertex, 0.0, 0.0 });
    return Status::Success();
  }
  std::vector<std::pair<Id, std::array<double, 3>>> positions;
  ForEachFaceAround(
    this->Mesh, point, [&](Id f, const std::array<double, 3>& b) { positions.emplace_back(f, b); });
  std::vector<ConeTarget> coneTargets;
  for (std::size_t t = 0; t < targets.size(); ++t)
  {
    if (targets[t].On != SurfacePoint::Support::Vertex)
    {
      ForEachFaceAround(this->Mesh, targets[t], [&](Id f, const std::array<double, 3>& b) {
        coneTargets.push_back({ f, t, b });
      });
    }
  }
  std::stable_sort(coneTargets.begin(), coneTargets.end(),
    [](const ConeTarget& a, const ConeTarget& b) { return a.Face < b.Face; });

  const auto tracer = this->Linkers.Borrow(this->Table, ProgressRule(accuracy));
  tracer->SetRule(ProgressRule(accuracy));
  for (const FoundEdge& edge : tracer->TracePoint(positions, coneTargets, direct))
  {
    links.push_back({ this->Table.OldVertex(edge.Target), edge.Length,
      this->Table.StoredAngle(edge.Target, edge.ArrivalAngle(this->Table)) });
  }
  std::sort(links.begin(), links.end(),
    [](const GraphLink& a, const GraphLink& b) { return a.Vertex < b.Vertex; });
  return Status::Success();
}
}
