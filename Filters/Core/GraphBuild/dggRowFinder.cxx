// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggRowFinder.h"

#include "dggBlockLoop.h"
#include "dggGraphRules.h"
#include "dggGraphWindowTracer.h"
#include "dggProgressPart.h"
#include "dggStatus.h"
#include "dggSurfaceOrder.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <cmath>

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
/// Rows built for an estimate.
constexpr Id SampleSize = 128;
/// Peak memory during assembly, relative to the memory of the graph; measured, with a margin.
constexpr double PeakOfAssembly = 1.3;
/// Capacity of the arrays of rows, relative to their contents.
constexpr double GrowthOfRows = 1.5;
/// Bytes of an edge of a region, with the row that is made of it and the capacity of its array.
constexpr double BytesOfRegionEdge = 80.0;
/// Memory of a thread in bytes, per vertex and per window of a source.
constexpr double BytesPerVertex = 48.0;
constexpr double BytesPerWindow = 512.0;

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

constexpr const char* AllVertices = "the vertices"; // source in messages

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
Status DescribeLimit(const std::string& source, bool canMultiply, const GraphOptions& options)
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

/// Calls `use(rule)` with the rule of a construction.
template <typename User>
auto WithRule(const GraphOptions& options, User&& use)
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

WindowLimits GetLimits(
  const GraphOptions& options, double faces, bool canMultiply, std::size_t windowLimit)
{
  // The number of windows per vertex of a manifold mesh grows with this power of the accuracy, or
  // with the number of neighbors.
  const double growth = options.Construction == GraphConstruction::SaddleVertexGraph
    ? std::max(1.0, options.NumberOfNeighbors / 50.0)
    : std::pow(0.01 / options.Accuracy, 2.0 / 3.0);
  const double windows =
    growth * (options.Construction == GraphConstruction::Guaranteed ? 1.0 : WindowsOfOtherRules);
  const double fewest = canMultiply ? SmallestBranchingMesh : SmallestMesh;
  const double work =
    growth * (options.Construction == GraphConstruction::Indirect ? WindowsOfOtherRules : 1.0);
  WindowLimits limits{ windowLimit, static_cast<std::size_t>(FastWindows * windows),
    static_cast<std::size_t>(
      MostWorkOfFace * std::max(fewest * std::max(1.0, work), faces * work)) /
      ShareOfVertex };
  if (!canMultiply)
  {
    limits.FastWindowLimit = std::max(
      limits.FastWindowLimit, static_cast<std::size_t>(FastWindowsPerFace * windows * faces));
  }
  return limits;
}

/// Fails if the work exceeds the limit of all sources.
Status CompareWork(
  const GraphOptions& options, std::size_t work, const WindowLimits& limits, bool canMultiply)
{
  return work > ShareOfVertex * limits.Work ? DescribeLimit(AllVertices, canMultiply, options)
                                            : Status::Success();
}
}

/// Statistics of the number of edges found per vertex, from a sample of vertices.
struct RowFinder::Sample
{
  void Add(double degree)
  {
    this->Count += 1.0;
    this->Sum += degree;
    this->SumOfSquares += degree * degree;
  }
  double GetMean() const { return this->Sum / this->Count; }
  /// Returns an upper bound of the mean over all vertices: three standard errors above the sample
  /// mean.
  double GetLargestMean() const
  {
    const double mean = this->GetMean();
    const double variance = std::max(0.0, this->SumOfSquares / this->Count - mean * mean);
    return mean + 3.0 * std::sqrt(variance / this->Count);
  }

  double Windows = 0.0; ///< maximum of a vertex
  double Count = 0.0;
  double Sum = 0.0;
  double SumOfSquares = 0.0;
};

RowFinder::RowFinder(const SurfaceMesh& mesh, std::size_t windowLimit)
  : Mesh(mesh)
  , GraphWindowLimit(windowLimit)
  , NumberOfFaces(mesh.GetNumberOfFaces())
  , Table(mesh, ComputePatchOrder(mesh, PatchSize))
  , Crossings(this->Table)
  , HasBranches(Table.HasBranches())
{
}

RowFinder::RowFinder(const SurfaceMesh& mesh, const GraphRegion& region)
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

WindowLimits RowFinder::LimitWindows(const GraphOptions& options) const
{
  return GetLimits(
    options, static_cast<double>(this->NumberOfFaces), this->CanMultiply(), this->GraphWindowLimit);
}

Status RowFinder::CheckWork(
  const GraphOptions& options, const GraphRegion& region, std::size_t work)
{
  return CompareWork(options, work,
    GetLimits(
      options, static_cast<double>(region.NumberOfFaces), region.HasBranches, DefaultWindowLimit),
    region.HasBranches);
}

Status RowFinder::LimitExceeded(const std::string& source, const GraphOptions& options) const
{
  return DescribeLimit(source, this->CanMultiply(), options);
}

Status RowFinder::VertexLimitExceeded(Id row, const GraphOptions& options) const
{
  const Id v = this->Table.OldVertex(row);
  const Offset id = this->PointIds.empty() ? static_cast<Offset>(v) : this->PointIds[v];
  return this->LimitExceeded(JoinText("vertex ", id), options);
}

bool RowFinder::NeedsWide(const GraphOptions& options) const
{
  // Sums of lengths must also stay within the range of float, and lengths above its denormals.
  const double longest =
    this->Mesh.GetMaximumEdgeLength() * std::max<Id>(1, this->Mesh.GetNumberOfFaces());
  const double mean = this->Mesh.GetMeanEdgeLength();
  return (options.Construction != GraphConstruction::SaddleVertexGraph &&
           NeedsWideLengths(options.Accuracy)) ||
    longest > 1e37 || (mean > 0.0 && mean < 1e-25);
}

/// Returns the crossings of small meshes that are kept, or new ones.
CrossingBlocks& RowFinder::ChooseCrossings(std::optional<CrossingBlocks>& temporary) const
{
  return this->Table.GetNumberOfBlocks() > MostBlocks ? temporary.emplace(this->Table)
                                                      : this->Crossings;
}

Status RowFinder::Estimate(const GraphOptions& options, GraphEstimate& estimate) const
{
  const double n = this->GetNumberOfRows();
  Sample sample;
  DGG_RETURN_IF_ERROR(this->Table.Check());
  if (n == 0.0)
  {
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(
    WithRule(options, [&](const auto& rule) { return this->SampleRows(rule, options, sample); }));
  const double bytes = this->NeedsWide(options) ? 20.0 : 16.0;
  const auto unite = [&](double degree) {
    return n *
      std::min(degree * UnitedShare(options.Construction), this->Table.GetNumberOfVertices() - 1.0);
  };
  estimate.Edges = unite(sample.GetMean());
  estimate.Memory = estimate.Edges * bytes + 8.0 * (n + 1.0);

  // While edges are found, about half of the graph edges are stored in growing arrays, and the
  // edges of a wave in blocks of up to twice their size; then rows are converted to the graph. In
  // the indirect construction all candidates are stored before any candidate is pruned.
  const double out = n * sample.GetLargestMean();
  const double wave = std::min(out, EdgesOfWave) * 2.0 * sizeof(RowEdge);
  const double graph = unite(sample.GetLargestMean()) * bytes + 8.0 * (n + 1.0);
  const bool isIndirect = options.Construction == GraphConstruction::Indirect;
  const double finding = this->HasRegion
    ? BytesOfRegionEdge * out
    : 0.5 * GrowthOfRows * (isIndirect ? 2.0 * out * bytes : graph) + wave;
  const double tables = static_cast<double>(this->Table.GetMemorySize()) +
    sizeof(CrossingBlock) *
      static_cast<double>(std::min(this->Table.GetNumberOfBlocks(), MostBlocks));
  estimate.Peak = std::max(PeakOfAssembly * graph, finding) + tables +
    std::max(1, options.NumberOfThreads) *
      (BytesPerVertex * this->Table.GetNumberOfVertices() + BytesPerWindow * sample.Windows);
  return Status::Success();
}

template <typename Rule>
Status RowFinder::SampleRows(const Rule& rule, const GraphOptions& options, Sample& sample) const
{
  const Id n = this->GetNumberOfRows();
  // The sample is every k-th vertex of an order in which neighbors are close together.
  const Id count = std::min(n, SampleSize);
  const WindowLimits limits = this->LimitWindows(options);
  std::optional<CrossingBlocks> temporary;
  CrossingBlocks& crossings = this->ChooseCrossings(temporary);
  GraphWindowTracer<Rule> tracer(crossings, rule, limits);
  std::size_t work = 0;
  // A few vertices may require most of the total work.
  const double mostWork = static_cast<double>(ShareOfVertex * limits.Work) *
    std::min(1.0, LargestShareOfSample * count / n);
  for (Id i = 0; i < count; ++i)
  {
    const Id row = this->GetRow(static_cast<Id>(static_cast<Offset>(n) * i / count));
    const std::size_t before = tracer.GetNumberOfWindows();
    sample.Add(static_cast<double>(tracer.TraceVertex(row).size()));
    sample.Windows =
      std::max(sample.Windows, static_cast<double>(tracer.GetNumberOfWindows() - before));
    work += tracer.GetWork();
    if (tracer.ExceededLimit())
    {
      return this->VertexLimitExceeded(row, options);
    }
    if (static_cast<double>(work) > mostWork)
    {
      return this->LimitExceeded(AllVertices, options);
    }
    if (temporary)
    {
      temporary->Trim(MostBlocks);
    }
  }
  return Status::Success();
}

Status RowFinder::Find(
  const GraphOptions& options, GraphStatistics& statistics, const Receiver& receive) const
{
  DGG_RETURN_IF_ERROR(this->Table.Check());
  return WithRule(
    options, [&](const auto& rule) { return this->FindRows(rule, options, statistics, receive); });
}

template <typename Rule>
Status RowFinder::FindRows(const Rule& rule, const GraphOptions& options,
  GraphStatistics& statistics, const Receiver& receive) const
{
  const Id n = this->GetNumberOfRows();
  const WindowLimits limits = this->LimitWindows(options);
  const std::size_t mostWork = ShareOfVertex * limits.Work;
  std::optional<CrossingBlocks> temporary;
  CrossingBlocks& crossings = this->ChooseCrossings(temporary);
  WorkspacePool<GraphWindowTracer<Rule>> tracers;
  std::vector<RowBlock> blocks;
  std::atomic<std::size_t> work{ statistics.Work };
  std::atomic<std::size_t> windows{ statistics.Windows };
  std::size_t found = 0;
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
    DGG_RETURN_IF_ERROR(CompareWork(options, work, limits, this->CanMultiply()));
    for (const RowBlock& block : blocks)
    {
      if (block.LimitExceeded != NoId)
      {
        return this->VertexLimitExceeded(block.LimitExceeded, options);
      }
      found += block.Edges.size();
    }
    receive(blocks, first);
    const double degree = std::max(1.0, static_cast<double>(found) / last);
    rowsOfWave = static_cast<Id>(EdgesOfWave / degree) + 1;
    if (temporary)
    {
      temporary->Trim(MostBlocks);
    }
  }
  statistics.Work = work;
  statistics.Windows = windows;
  statistics.OutEdges += found;
  return Status::Success();
}

template <typename Tracer>
void RowFinder::FillBlock(Tracer& tracer, CrossingBlocks& crossings, Id begin, Id end,
  std::size_t mostWork, std::atomic<std::size_t>& work, RowBlock& block) const
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
}
