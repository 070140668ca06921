// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphBuilder.h"

#include "dggBlockLoop.h"
#include "dggCrossingBlocks.h"
#include "dggDegreeSample.h"
#include "dggDirectionUnion.h"
#include "dggGraphAssembly.h"
#include "dggGraphPruning.h"
#include "dggGraphRules.h"
#include "dggGraphWindowTracer.h"
#include "dggProgressPart.h"
#include "dggRowStore.h"
#include "dggStatus.h"
#include "dggSurfaceOrder.h"
#include "dggUnfoldingTable.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace dgg
{
namespace
{
/// Size of the patches of neighboring vertices in the tables. The data that a thread reads around
/// the vertices of a patch fits into its cache.
constexpr Id PatchSize = 256;
/// Rows per task.
constexpr Id BlockSize = 16;
/// Rows are built in waves, because the edges of a wave are temporarily stored twice. The first
/// wave measures the number of edges per row; later waves have about the given number of edges.
constexpr Id RowsOfFirstWave = 256;
constexpr double EdgesOfWave = 1 << 19;
/// Number of blocks of crossings from which on blocks behind the rows are released.
constexpr std::size_t MostBlocks = 2048;
/// Number of rows of a region per wave.
constexpr Id RowsOfRegionWave = 8192;
/// Rows built for an estimate.
constexpr Id SampleSize = 128;
/// Peak memory during assembly, relative to the memory of the graph; measured, with a margin.
constexpr double PeakOfAssembly = 1.3;
/// Capacity of the arrays of rows, relative to their contents.
constexpr double GrowthOfRows = 1.5;
/// Capacity of the edges of a region with the rows that are made of them, relative to the edges.
constexpr double GrowthOfEdges = 2.5;
/// Memory of a thread in bytes, per vertex and per window of a source.
constexpr double BytesPerVertex = 48.0;
constexpr double BytesPerWindow = 512.0;
/// Memory of the table of the mesh in bytes, per vertex and per face.
constexpr double BytesOfTablePerVertex = 12.0;
constexpr double BytesOfTablePerFace = 4.0;

/// Maximum work of a graph, in units of GraphWindowTracer::GetWork(), per face at an accuracy of 1
/// %: about twenty times the work of a mesh of well-shaped triangles. A single vertex may take a
/// fraction of the total (ShareOfVertex). Without this limit, the work could grow with the number
/// of routes if windows can multiply, or with the square of the number of faces if all faces are as
/// long as the mesh.
constexpr double MostWorkOfFace = 1e4;
constexpr double LargestShareOfSample = 2.0; // relative to the average
constexpr std::size_t ShareOfVertex = 16;    // inverse of the maximum share of one vertex
/// Minimum number of faces from which the work limit is computed, for meshes in which windows
/// cannot multiply and for meshes in which they can. Smaller meshes and coarser accuracies take
/// little time in any case; a face takes more time if windows multiply.
constexpr double SmallestMesh = 20000.0;
constexpr double SmallestBranchingMesh = 1000.0;
/// Maximum number of windows per vertex in the fast mode at an accuracy of 1 %, more than on
/// ordinary meshes. If windows cannot multiply, the limit is the number of windows of a plate
/// without interior points, on which each vertex sees all faces (FastWindowsPerFace).
constexpr double FastWindows = 2000.0;
constexpr double FastWindowsPerFace = 4.0;
/// Ratio between the numbers of windows of any other rule and of the progress rule.
constexpr double WindowsOfOtherRules = 16.0;

/// Measured progress weights of the steps.
struct ShareOfSteps
{
  double Rows;
  double Pruning;
};
ShareOfSteps SharesOf(GraphConstruction construction)
{
  return construction == GraphConstruction::Indirect ? ShareOfSteps{ 0.6, 0.37 }
                                                     : ShareOfSteps{ 0.9, 0.0 };
}

/// Returns the ratio of graph edges to edges found, measured on many meshes. Uniting both
/// directions adds some edges; pruning candidates removes most of them.
double UnitedShare(GraphConstruction construction)
{
  switch (construction)
  {
    case GraphConstruction::Guaranteed:
      return 1.22;
    case GraphConstruction::Indirect:
      return 0.22;
    default:
      return 1.1;
  }
}

/// Returns the error of an exceeded limit; `source` describes the origin of the windows.
Status LimitExceeded(const std::string& source, bool canMultiply, const GraphOptions& options)
{
  const bool isLimited = options.Construction == GraphConstruction::SaddleVertexGraph;
  const std::string property = isLimited ? "NumberOfNeighbors" : "Accuracy";
  return InvalidInput("The windows of ", source,
    canMultiply ? " multiply among non-manifold edges or triangles without area"
                : " reach too far over long triangles",
    ", which takes more than twenty times the work on a clean mesh of this size")
    .At(property)
    .Fix(canMultiply ? "Remove inner walls, duplicate faces and triangles without area"
                     : "Split these triangles",
      ", use exact distances, or use a ", isLimited ? "smaller" : "larger", " {", property,
      "} (now ", isLimited ? JoinText(options.NumberOfNeighbors) : JoinText(options.Accuracy), ")");
}

/// Rows built by one thread.
struct RowBlock
{
  Id LimitExceeded = NoId;        ///< first row whose limit was exceeded
  std::vector<std::size_t> Sizes; ///< number of edges per row; RimReached if unknown
  std::vector<RowEdge> Edges;
  static constexpr std::size_t RimReached = std::numeric_limits<std::size_t>::max();

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
  Implementation(const SurfaceMesh& mesh, std::size_t windowLimit)
    : Mesh(mesh)
    , GraphWindowLimit(windowLimit)
    , NumberOfFaces(mesh.GetNumberOfFaces())
    , Table(mesh, ComputePatchOrder(mesh, PatchSize))
    , Crossings(this->Table)
    , HasBranches(Table.HasBranches())
  {
  }

  Implementation(const SurfaceMesh& mesh, const GraphRegion& region)
    : Mesh(mesh)
    , GraphWindowLimit(DefaultWindowLimit)
    , NumberOfFaces(region.NumberOfFaces)
    , Table(mesh, ComputePatchOrder(mesh, PatchSize), region.IsRim)
    , Crossings(this->Table)
    , HasBranches(region.HasBranches)
    , PointIds(region.PointIds)
    , HasRegion(true)
  {
    for (const Id source : region.Sources)
    {
      this->Rows.push_back(this->Table.NewVertex(source));
    }
    std::sort(this->Rows.begin(), this->Rows.end());
  }

  Status Estimate(const GraphOptions& options, GraphEstimate& estimate) const;
  Status Build(
    const GraphOptions& options, GeodesicGraph& graph, GraphStatistics& statistics) const;
  Status FindEdges(const GraphOptions& options, std::vector<RegionEdge>& edges,
    std::vector<Id>& unfinished, std::size_t& totalWork) const;
  Status CheckWork(const GraphOptions& options, std::size_t work) const
  {
    return work > ShareOfVertex * this->LimitWindows(options).Work
      ? this->MeshLimitExceeded(options)
      : Status::Success();
  }
  Status Link(const SurfacePoint& point, const GraphOptions& options,
    const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
    std::vector<double>& direct, std::size_t& work) const;

private:
  /// Calls `use(rule)` with the rule of a construction.
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
      default:
        return use(ProgressRule(options.Accuracy));
    }
  }

  /// Builds the rows of some vertices to measure their degrees and the maximum number of windows.
  template <typename Rule>
  Status SampleRows(
    const Rule& rule, const GraphOptions& options, DegreeSample& degrees, double& windows) const;
  /// Builds the rows of all vertices. If `unite` is true, both directions of an edge are united.
  template <typename Rule>
  Status BuildRows(const Rule& rule, const GraphOptions& options, bool unite, RowStore& rows,
    GraphStatistics& statistics) const;
  Status VertexLimitExceeded(Id row, const GraphOptions& options) const
  {
    const Id v = this->Table.OldVertex(row);
    return LimitExceeded(
      JoinText("vertex ", this->PointIds.empty() ? static_cast<Offset>(v) : this->PointIds[v]),
      this->CanMultiply(), options);
  }
  Status MeshLimitExceeded(const GraphOptions& options) const
  {
    return LimitExceeded("the vertices", this->CanMultiply(), options);
  }
  bool CanMultiply() const { return this->HasBranches || this->Table.HasDegenerateFaces(); }
  Id GetNumberOfRows() const
  {
    return this->HasRegion ? static_cast<Id>(this->Rows.size()) : this->Table.GetNumberOfVertices();
  }
  Id GetRow(Id i) const { return this->HasRegion ? this->Rows[i] : i; }
  WindowLimits LimitWindows(const GraphOptions& options) const;
  bool NeedsWide(const GraphOptions& options) const;
  /// Builds the rows with indices [begin, end).
  template <typename Tracer>
  void FillBlock(Tracer& tracer, CrossingBlocks& crossings, Id begin, Id end, std::size_t mostWork,
    std::atomic<std::size_t>& work, RowBlock& block) const;

  const SurfaceMesh& Mesh;
  std::size_t GraphWindowLimit;
  Offset NumberOfFaces; // of the mesh that contains the region
  UnfoldingTable Table;
  mutable CrossingBlocks Crossings; // of links and samples, and of all rows of small meshes
  bool HasBranches;                 // true if that mesh has edges with more than two faces
  std::vector<Offset> PointIds;     // per vertex; empty without a region
  bool HasRegion = false;
  std::vector<Id> Rows; // rows to build, sorted; all without a region
  mutable WorkspacePool<GraphWindowTracer<ProgressRule>> Linkers;
};

//------------------------------------------------------------------------------
GraphBuilder::GraphBuilder(const SurfaceMesh& mesh, std::size_t windowLimit)
  : Internals(std::make_unique<Implementation>(mesh, windowLimit))
{
}

GraphBuilder::GraphBuilder(const SurfaceMesh& mesh, const GraphRegion& region)
  : Internals(std::make_unique<Implementation>(mesh, region))
{
}

GraphBuilder::~GraphBuilder() = default;

GraphOptions MakeOptions(const GraphInfo& graph)
{
  GraphOptions options;
  options.Construction = graph.Construction;
  options.Accuracy = graph.Accuracy;
  options.NumberOfNeighbors = graph.NumberOfNeighbors;
  return options;
}

bool IsBuiltWith(const GraphInfo& graph, const GraphOptions& options)
{
  const bool hasAccuracy = options.Construction != GraphConstruction::SaddleVertexGraph;
  return graph.Construction == options.Construction &&
    (hasAccuracy ? graph.Accuracy == options.Accuracy
                 : graph.NumberOfNeighbors == options.NumberOfNeighbors);
}

Status GraphBuilder::Check(const GraphOptions& options)
{
  if (options.Construction > GraphConstruction::SaddleVertexGraph)
  {
    return InvalidInput("{Construction} is a construction of point clouds")
      .At("Construction")
      .Fix("Choose a construction of meshes");
  }
  if (options.Construction == GraphConstruction::SaddleVertexGraph)
  {
    if (options.NumberOfNeighbors < 1)
    {
      return InvalidValue("NumberOfNeighbors", options.NumberOfNeighbors)
        .Fix("Use a number of at least 1");
    }
  }
  else if (!(options.Accuracy >= MinimumAccuracy && options.Accuracy <= MaximumAccuracy))
  {
    return InvalidValue("Accuracy", options.Accuracy)
      .Fix("Use a number from ", MinimumAccuracy, " to ", MaximumAccuracy);
  }
  return Status::Success();
}

Status GraphBuilder::Estimate(const GraphOptions& options, GraphEstimate& estimate) const
{
  estimate = GraphEstimate();
  DGG_RETURN_IF_ERROR(Check(options));
  return this->Internals->Estimate(options, estimate);
}

Status GraphBuilder::Build(
  const GraphOptions& options, GeodesicGraph& graph, GraphStatistics* statistics) const
{
  graph = GeodesicGraph();
  GraphStatistics unused;
  GraphStatistics& wanted = statistics ? *statistics : unused;
  wanted = GraphStatistics();
  DGG_RETURN_IF_ERROR(Check(options));
  Status status = this->Internals->Build(options, graph, wanted);
  if (!status.IsOk())
  {
    graph = GeodesicGraph();
  }
  return status;
}

Status GraphBuilder::FindEdges(const GraphOptions& options, std::vector<RegionEdge>& edges,
  std::vector<Id>& unfinished, std::size_t& work) const
{
  return this->Internals->FindEdges(options, edges, unfinished, work);
}

Status GraphBuilder::CheckWork(const GraphOptions& options, std::size_t work) const
{
  return this->Internals->CheckWork(options, work);
}

Status GraphBuilder::Link(const SurfacePoint& point, double accuracy,
  const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
  std::vector<double>& direct, std::size_t* work) const
{
  std::size_t unused = 0;
  links.clear();
  direct.clear();
  GraphOptions options;
  options.Accuracy = accuracy;
  DGG_RETURN_IF_ERROR(Check(options));
  Status status =
    this->Internals->Link(point, options, targets, links, direct, work ? *work : unused);
  if (!status.IsOk())
  {
    links.clear();
    direct.clear();
  }
  return status;
}

//------------------------------------------------------------------------------
WindowLimits GraphBuilder::Implementation::LimitWindows(const GraphOptions& options) const
{
  // The number of windows per vertex of a manifold mesh grows with this power of the accuracy, or
  // with the number of neighbors.
  const double growth = options.Construction == GraphConstruction::SaddleVertexGraph
    ? std::max(1.0, options.NumberOfNeighbors / 50.0)
    : std::pow(0.01 / options.Accuracy, 2.0 / 3.0);
  const auto faces = static_cast<double>(this->NumberOfFaces);
  const double windows =
    growth * (options.Construction == GraphConstruction::Guaranteed ? 1.0 : WindowsOfOtherRules);
  const double fewest = this->CanMultiply() ? SmallestBranchingMesh : SmallestMesh;
  const double work =
    growth * (options.Construction == GraphConstruction::Indirect ? WindowsOfOtherRules : 1.0);
  WindowLimits limits{ this->GraphWindowLimit, static_cast<std::size_t>(FastWindows * windows),
    static_cast<std::size_t>(
      MostWorkOfFace * std::max(fewest * std::max(1.0, work), faces * work)) /
      ShareOfVertex };
  if (!this->CanMultiply())
  {
    limits.FastWindowLimit = std::max(
      limits.FastWindowLimit, static_cast<std::size_t>(FastWindowsPerFace * windows * faces));
  }
  return limits;
}

bool GraphBuilder::Implementation::NeedsWide(const GraphOptions& options) const
{
  // Sums of lengths must also stay within the range of float, and lengths above its denormals.
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
  const double n = this->GetNumberOfRows();
  DegreeSample degrees;
  double windows = 0.0;
  DGG_RETURN_IF_ERROR(this->Table.Check());
  if (n == 0.0)
  {
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(WithRule(
    options, [&](const auto& rule) { return this->SampleRows(rule, options, degrees, windows); }));
  const double bytes = this->NeedsWide(options) ? 20.0 : 16.0;
  const auto unite = [&](double degree) {
    return n *
      std::min(degree * UnitedShare(options.Construction), this->Table.GetNumberOfVertices() - 1.0);
  };
  estimate.Edges = unite(degrees.GetMean());
  estimate.Memory = estimate.Edges * bytes + 8.0 * (n + 1.0);

  // While edges are found, about half of the graph edges are stored in growing arrays, and the
  // edges of a wave in blocks of up to twice their size; then rows are converted to the graph. In
  // the indirect construction all candidates are stored before any candidate is pruned.
  const double out = n * degrees.GetLargestMean();
  const double wave = std::min(out, EdgesOfWave) * 2.0 * sizeof(RowEdge);
  const double graph = unite(degrees.GetLargestMean()) * bytes + 8.0 * (n + 1.0);
  const bool isIndirect = options.Construction == GraphConstruction::Indirect;
  const double finding = this->HasRegion
    ? GrowthOfEdges * out * sizeof(RegionEdge)
    : 0.5 * GrowthOfRows * (isIndirect ? 2.0 * out * bytes : graph) + wave;
  const double tables = BytesOfTablePerVertex * this->Table.GetNumberOfVertices() +
    BytesOfTablePerFace * this->Mesh.GetNumberOfFaces() +
    sizeof(CrossingBlock) *
      static_cast<double>(std::min(this->Table.GetNumberOfBlocks(), MostBlocks));
  estimate.Peak = std::max(PeakOfAssembly * graph, finding) + tables +
    std::max(1, options.NumberOfThreads) *
      (BytesPerVertex * this->Table.GetNumberOfVertices() + BytesPerWindow * windows);
  return Status::Success();
}

template <typename Rule>
Status GraphBuilder::Implementation::SampleRows(
  const Rule& rule, const GraphOptions& options, DegreeSample& degrees, double& windows) const
{
  const Id n = this->GetNumberOfRows();
  // The sample is every k-th vertex of an order in which neighbors are close together.
  const Id count = std::min(n, SampleSize);
  const WindowLimits limits = this->LimitWindows(options);
  GraphWindowTracer<Rule> tracer(this->Crossings, rule, limits);
  std::size_t work = 0;
  // A few vertices may require most of the total work.
  const double mostWork = static_cast<double>(ShareOfVertex * limits.Work) *
    std::min(1.0, LargestShareOfSample * count / n);
  for (Id i = 0; i < count; ++i)
  {
    const Id row = this->GetRow(static_cast<Id>(static_cast<Offset>(n) * i / count));
    const std::size_t before = tracer.GetNumberOfWindows();
    degrees.Add(static_cast<double>(tracer.TraceVertex(row).size()));
    windows = std::max(windows, static_cast<double>(tracer.GetNumberOfWindows() - before));
    work += tracer.GetWork();
    if (tracer.ExceededLimit())
    {
      return this->VertexLimitExceeded(row, options);
    }
    if (static_cast<double>(work) > mostWork)
    {
      return this->MeshLimitExceeded(options);
    }
  }
  return Status::Success();
}

template <typename Rule>
Status GraphBuilder::Implementation::BuildRows(const Rule& rule, const GraphOptions& options,
  bool unite, RowStore& rows, GraphStatistics& statistics) const
{
  const Id n = this->Table.GetNumberOfVertices();
  const WindowLimits limits = this->LimitWindows(options);
  const std::size_t mostWork = ShareOfVertex * limits.Work;
  std::atomic<std::size_t> work{ 0 };
  std::optional<CrossingBlocks> own; // of a large mesh
  if (this->Table.GetNumberOfBlocks() > MostBlocks)
  {
    own.emplace(this->Table);
  }
  CrossingBlocks& crossings = own ? *own : this->Crossings;
  WorkspacePool<GraphWindowTracer<Rule>> tracers;
  std::vector<RowBlock> blocks;
  DirectionUnion directions(this->Table.GetOrder());
  std::atomic<std::size_t> windows{ 0 };
  Id last = 0;
  for (Id first = 0, rowsOfWave = RowsOfFirstWave; first < n; first = last)
  {
    last = first + std::min(n - first, rowsOfWave);
    blocks.resize((static_cast<std::size_t>(last - first) + BlockSize - 1) / BlockSize);
    DGG_RETURN_IF_ERROR(ForBlocks(
      last - first, BlockSize, options.Parallel,
      ProgressPart(options.Progress, static_cast<double>(first) / n, static_cast<double>(last) / n),
      [&] { return tracers.Borrow(std::ref(crossings), rule, limits); },
      [&](auto& tracer, Offset b, Offset begin, Offset end) {
        const std::size_t before = tracer->GetNumberOfWindows();
        this->FillBlock(*tracer, crossings, first + static_cast<Id>(begin),
          first + static_cast<Id>(end), mostWork, work, blocks[b]);
        windows += tracer->GetNumberOfWindows() - before;
      }));
    // The work never decreases, so that the outcome does not depend on the number of threads.
    DGG_RETURN_IF_ERROR(this->CheckWork(options, work));
    for (const RowBlock& block : blocks)
    {
      if (block.LimitExceeded != NoId)
      {
        return this->VertexLimitExceeded(block.LimitExceeded, options);
      }
      block.AppendTo(rows);
      statistics.OutEdges += block.Edges.size();
    }
    if (unite)
    {
      directions.Unite(rows, first, options.Parallel);
    }
    const double degree = std::max(1.0, static_cast<double>(statistics.OutEdges) / last);
    rowsOfWave = static_cast<Id>(EdgesOfWave / degree) + 1;
    if (own)
    {
      own->Trim(MostBlocks);
    }
  }
  statistics.Windows = windows;
  return Status::Success();
}

template <typename Tracer>
void GraphBuilder::Implementation::FillBlock(Tracer& tracer, CrossingBlocks& crossings, Id begin,
  Id end, std::size_t mostWork, std::atomic<std::size_t>& work, RowBlock& block) const
{
  block.LimitExceeded = NoId;
  block.Sizes.clear();
  block.Edges.clear();
  for (Id i = begin; i < end && work <= mostWork; ++i)
  {
    const Id row = this->GetRow(i);
    const std::vector<FoundEdge>& edges = tracer.TraceVertex(row);
    if (tracer.HasReachedRim())
    {
      block.Sizes.push_back(RowBlock::RimReached);
      continue;
    }
    work += tracer.GetWork();
    if (tracer.ExceededLimit())
    {
      block.LimitExceeded = row;
      return;
    }
    block.Sizes.push_back(edges.size());
    for (const FoundEdge& edge : edges)
    {
      block.Edges.push_back(
        { edge.Target, edge.Length, this->Table.StoredAngle(row, edge.DepartureAngle(this->Mesh)),
          this->Table.StoredAngle(edge.Target, edge.ArrivalAngle(crossings)) });
    }
  }
}

Status GraphBuilder::Implementation::FindEdges(const GraphOptions& options,
  std::vector<RegionEdge>& edges, std::vector<Id>& unfinished, std::size_t& totalWork) const
{
  DGG_RETURN_IF_ERROR(this->Table.Check());
  const WindowLimits limits = this->LimitWindows(options);
  std::atomic<std::size_t> work{ totalWork };
  CrossingBlocks crossings(this->Table);
  const Id n = this->GetNumberOfRows();
  for (Id first = 0, last = 0; first < n; first = last)
  {
    last = first + std::min(n - first, RowsOfRegionWave);
    std::vector<RowBlock> blocks(
      (static_cast<std::size_t>(last - first) + BlockSize - 1) / BlockSize);
    DGG_RETURN_IF_ERROR(WithRule(options, [&](const auto& rule) {
      WorkspacePool<GraphWindowTracer<std::decay_t<decltype(rule)>>> tracers;
      return ForBlocks(
        last - first, BlockSize, options.Parallel,
        ProgressPart(
          options.Progress, static_cast<double>(first) / n, static_cast<double>(last) / n),
        [&] { return tracers.Borrow(std::ref(crossings), rule, limits); },
        [&](auto& tracer, Offset b, Offset begin, Offset end) {
          this->FillBlock(*tracer, crossings, first + static_cast<Id>(begin),
            first + static_cast<Id>(end), ShareOfVertex * limits.Work, work, blocks[b]);
        });
    }));
    crossings.Trim(MostBlocks);
    DGG_RETURN_IF_ERROR(this->CheckWork(options, work));
    Id i = first;
    for (const RowBlock& block : blocks)
    {
      if (block.LimitExceeded != NoId)
      {
        return this->VertexLimitExceeded(block.LimitExceeded, options);
      }
      const RowEdge* next = block.Edges.data();
      for (const std::size_t size : block.Sizes)
      {
        const Id source = this->Table.OldVertex(this->GetRow(i++));
        if (size == RowBlock::RimReached)
        {
          unfinished.push_back(source);
          continue;
        }
        for (const RowEdge* const end = next + size; next != end; ++next)
        {
          edges.push_back({ source, this->Table.OldVertex(next->Target), next->Length,
            next->Departure, next->Arrival });
        }
      }
    }
  }
  totalWork = work;
  return Status::Success();
}

Status GraphBuilder::Implementation::Build(
  const GraphOptions& options, GeodesicGraph& graph, GraphStatistics& statistics) const
{
  DGG_RETURN_IF_ERROR(this->Table.Check());
  const Id n = this->Table.GetNumberOfVertices();
  const bool wide = this->NeedsWide(options);
  const bool isIndirect = options.Construction == GraphConstruction::Indirect;
  const ShareOfSteps shares = SharesOf(options.Construction);
  RowStore rows(wide);
  rows.ReserveRows(n);
  GraphOptions forRows = options;
  forRows.Progress = ProgressPart(options.Progress, 0.0, shares.Rows);
  DGG_RETURN_IF_ERROR(WithRule(options, [&](const auto& rule) {
    return this->BuildRows(rule, forRows, !isIndirect, rows, statistics);
  }));
  if (isIndirect)
  {
    DGG_RETURN_IF_ERROR(PruneCandidates(rows, options.Accuracy, options.Parallel,
      ProgressPart(options.Progress, shares.Rows, shares.Rows + shares.Pruning)));
    DirectionUnion(this->Table.GetOrder()).Unite(rows, 0, options.Parallel);
  }
  const double done = shares.Rows + shares.Pruning;
  DGG_RETURN_IF_ERROR(AssembleGraph(rows, this->Table.GetOrder(), wide, options.Parallel,
    ProgressPart(options.Progress, done, 1.0), graph));
  graph.Info.Kind = GraphKind::Mesh;
  graph.Info.Construction = options.Construction;
  const bool isByNumber = options.Construction == GraphConstruction::SaddleVertexGraph;
  graph.Info.Accuracy = isByNumber ? 0.0 : options.Accuracy;
  graph.Info.NumberOfNeighbors = isByNumber ? options.NumberOfNeighbors : 0;
  return Status::Success();
}

Status GraphBuilder::Implementation::Link(const SurfacePoint& point, const GraphOptions& options,
  const std::vector<SurfacePoint>& targets, std::vector<GraphLink>& links,
  std::vector<double>& direct, std::size_t& work) const
{
  DGG_RETURN_IF_ERROR(this->Table.Check());
  DGG_RETURN_IF_ERROR(point.Check(this->Mesh));
  for (const SurfacePoint& target : targets)
  {
    DGG_RETURN_IF_ERROR(target.Check(this->Mesh));
  }
  direct.assign(targets.size(), Infinity);
  if (point.On == SurfacePoint::Support::Vertex)
  {
    links.push_back({ point.Vertex, 0.0, 0.0, 0.0 });
    return Status::Success();
  }
  std::vector<std::pair<Id, std::array<double, 3>>> positions;
  ForEachFaceAround(
    this->Mesh, point, [&](Id f, const std::array<double, 3>& b) { positions.emplace_back(f, b); });
  std::vector<GraphWindowTarget> windowTargets;
  for (std::size_t t = 0; t < targets.size(); ++t)
  {
    if (targets[t].On != SurfacePoint::Support::Vertex)
    {
      ForEachFaceAround(this->Mesh, targets[t], [&](Id f, const std::array<double, 3>& b) {
        windowTargets.push_back({ f, t, b });
      });
    }
  }
  std::stable_sort(windowTargets.begin(), windowTargets.end(),
    [](const GraphWindowTarget& a, const GraphWindowTarget& b) { return a.Face < b.Face; });

  const ProgressRule rule(options.Accuracy);
  const auto tracer =
    this->Linkers.Borrow(std::ref(this->Crossings), rule, this->LimitWindows(options));
  tracer->SetRule(rule);
  const std::vector<FoundEdge>& edges =
    tracer->TracePoint(positions, GraphWindowTargets(this->Mesh, windowTargets, direct));
  work += tracer->GetWork();
  if (tracer->ExceededLimit())
  {
    return LimitExceeded("the surface point", this->CanMultiply(), options);
  }
  for (const FoundEdge& edge : edges)
  {
    links.push_back({ this->Table.OldVertex(edge.Target), edge.Length,
      this->Table.StoredAngle(edge.Target, edge.ArrivalAngle(this->Crossings)),
      DepartureAngle(this->Mesh, point, edge) });
  }
  std::sort(links.begin(), links.end(),
    [](const GraphLink& a, const GraphLink& b) { return a.Vertex < b.Vertex; });
  return Status::Success();
}
}
