// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphSearch.h"

#include "dggBucketQueue.h"
#include "dggLabelCorrection.h"
#include "dggGraphDijkstra.h"
#include "dggGraphFans.h"
#include "dggLabelCorrecting.h"
#include "dggManySources.h"
#include "dggMinimumHeap.h"
#include "dggPointToPoint.h"
#include "dggSearchLabels.h"
#include "dggSearchTree.h"
#include "dggSurfaceOrder.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace dgg
{
namespace
{
Status InvalidSeed(std::size_t index, const std::string& what)
{
  return Status::Invalid("source " + std::to_string(index) + ": " + what);
}

Status CheckVertex(Id vertex, Id numberOfVertices)
{
  if (vertex >= 0 && vertex < numberOfVertices)
  {
    return Status::Success();
  }
  return Status::Invalid("vertex " + std::to_string(vertex) + " does not exist, there are " +
    std::to_string(numberOfVertices) + " vertices");
}

Status CheckSeed(const GraphSeed& seed, std::size_t index, Id numberOfVertices)
{
  const Status status = CheckVertex(seed.Vertex, numberOfVertices);
  if (!status.IsOk())
  {
    return InvalidSeed(index, status.GetMessage());
  }
  std::ostringstream what;
  if (!std::isfinite(seed.Distance) || !std::isfinite(seed.InitialDistance))
  {
    what << "the distances " << seed.Distance << " and " << seed.InitialDistance
         << " that it starts with are not finite";
    return InvalidSeed(index, what.str());
  }
  if (!std::isfinite(seed.ArrivalAngle))
  {
    return InvalidSeed(index, "its arrival angle is not finite");
  }
  if (seed.ArrivalAngle >= 0.0 && seed.Distance < seed.InitialDistance)
  {
    what << "it starts with the distance " << seed.Distance
         << ", which is below its initial distance " << seed.InitialDistance;
    return InvalidSeed(index, what.str());
  }
  return Status::Success();
}

Status CheckSeeds(const std::vector<GraphSeed>& seeds, Id numberOfVertices)
{
  if (seeds.empty())
  {
    return Status::Invalid("there is no source: give at least one");
  }
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const Status status = CheckSeed(seeds[i], i, numberOfVertices);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}

Status CheckOptions(const SearchOptions& options, Id numberOfVertices)
{
  if (std::isnan(options.MaximumDistance))
  {
    return Status::Invalid("the maximum distance is not a number");
  }
  for (std::size_t i = 0; i < options.Targets.size(); ++i)
  {
    const Status status = CheckVertex(options.Targets[i], numberOfVertices);
    if (!status.IsOk())
    {
      return Status::Invalid("target " + std::to_string(i) + ": " + status.GetMessage());
    }
  }
  return Status::Success();
}

/// Mean number of edges per vertex from which on fans pay.
constexpr Offset ShortestLongRow = 55;
/// Sources further apart than this, in vertices per group, are better searched one by one.
constexpr Offset LargestPatch = 1500;

/// What one search needs besides its result.
struct SearchWorkspace
{
  std::vector<double> Distances; ///< when there is no result
  std::vector<LabelOrigin> Origins;
  std::vector<TreeStep> Steps;
  std::vector<LabelCorrection::VirtualSource> VirtualSources;
  MinimumHeap Heap;
  BucketQueue Queue;

  std::size_t GetMemorySize() const
  {
    return this->Distances.capacity() * sizeof(double) +
      this->Origins.capacity() * sizeof(LabelOrigin) + this->Steps.capacity() * sizeof(TreeStep) +
      this->VirtualSources.capacity() * sizeof(LabelCorrection::VirtualSource) +
      this->Heap.GetMemorySize() + this->Queue.GetMemorySize();
  }
};
}

class GraphSearch::Implementation
{
public:
  Implementation(const GraphView& graph, const SurfaceMesh* mesh)
    : Graph(graph)
    , Mesh(graph.Angles && graph.ArrivalAngles ? mesh : nullptr)
    , BucketWidth(ChooseBucketWidth(graph))
  {
    if (this->Mesh)
    {
      this->Fans = std::make_unique<GraphFans>(this->Graph, *this->Mesh);
      this->Correction = std::make_unique<LabelCorrection>(this->Graph, *this->Mesh);
    }
  }

  GraphView Graph;
  const SurfaceMesh* Mesh; ///< null where there are no angles
  double BucketWidth;
  std::unique_ptr<GraphFans> Fans;             ///< null where there are no angles
  std::unique_ptr<LabelCorrection> Correction; ///< null where there are no angles
  mutable WorkspacePool<SearchWorkspace> Workspaces;
  mutable WorkspacePool<PointToPoint> PointWorkspaces;

  bool FindDistances(const std::vector<GraphSeed>& seeds, const SearchOptions& options,
    SearchWorkspace& workspace, SearchLabels& labels, SearchEffort& effort) const
  {
    if (options.Method == SearchMethod::Dijkstra || !options.Targets.empty())
    {
      return RunDijkstra(
        this->Graph, seeds, options.Targets, options.Progress, workspace.Heap, labels, effort);
    }
    const bool overFans = options.Method == SearchMethod::Certified && this->HasLongRows();
    const GraphFans* fans = overFans ? this->Fans.get() : nullptr;
    return RunLabelCorrecting(this->Graph, fans, seeds, this->BucketWidth, options.Progress,
      workspace.Queue, labels, effort);
  }

  /// Whether looking for the fan in a row costs less than relaxing all of it.
  bool HasLongRows() const
  {
    return this->Graph.GetNumberOfEdges() >
      ShortestLongRow * static_cast<Offset>(this->Graph.NumberOfVertices);
  }

  /// Distances from one vertex into a row of a matrix.
  void FillRow(Id source, double radius, double* row) const
  {
    const auto workspace = this->Workspaces.Borrow();
    const std::vector<GraphSeed> seeds{ { source, 0.0, 0.0, 0, -1.0 } };
    SearchLabels labels(workspace->Distances, workspace->Origins, radius);
    labels.Start(this->Graph.NumberOfVertices, seeds);
    SearchEffort effort;
    this->FindDistances(seeds, SearchOptions(), *workspace, labels, effort);
    for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
    {
      row[v] = labels.IsReached(v) ? labels.Distances[v] : Infinity;
    }
  }

  /// The places of sources in an order in which neighbours on the surface are close together.
  std::vector<std::size_t> OrderSources(const std::vector<Id>& sources, Id patchSize) const
  {
    const std::vector<Id> vertices = ComputePatchOrder(*this->Mesh, patchSize);
    std::vector<Id> rank(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      rank[vertices[i]] = static_cast<Id>(i);
    }
    std::vector<std::size_t> order(sources.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return rank[sources[a]] < rank[sources[b]]; });
    return order;
  }
};

GraphSearch::GraphSearch(const GraphView& graph, const SurfaceMesh* mesh)
  : Internals(std::make_unique<Implementation>(graph, mesh))
{
}

GraphSearch::~GraphSearch() = default;

const GraphView& GraphSearch::GetGraph() const
{
  return this->Internals->Graph;
}

Status GraphSearch::Run(
  const std::vector<GraphSeed>& seeds, const SearchOptions& options, SearchResult& result) const
{
  const Implementation& internals = *this->Internals;
  const Id n = internals.Graph.NumberOfVertices;
  Status status = CheckSeeds(seeds, n);
  if (status.IsOk())
  {
    status = CheckOptions(options, n);
  }
  if (!status.IsOk())
  {
    result = SearchResult();
    return status;
  }
  const auto workspace = internals.Workspaces.Borrow();
  SearchLabels labels(result.Distances, workspace->Origins, options.MaximumDistance);
  labels.Start(n, seeds);
  SearchEffort effort;
  if (!internals.FindDistances(seeds, options, *workspace, labels, effort))
  {
    result = SearchResult();
    return Status::Abort();
  }
  result.NumberOfPops = effort.Pops;
  result.NumberOfRelaxations = effort.Relaxations;
  FinishTree(labels, result, workspace->Steps);
  if (options.Correct && internals.Correction)
  {
    internals.Correction->Run(seeds, workspace->Steps, workspace->VirtualSources, result);
  }
  else
  {
    result.Corrected.clear();
    result.VirtualOffset.clear();
    result.VirtualLength.clear();
    result.VirtualAngle.clear();
  }
  return Status::Success();
}

Status GraphSearch::Between(const std::vector<GraphSeed>& from, const std::vector<GraphSeed>& to,
  const double* positions, double& distance) const
{
  const Id n = this->Internals->Graph.NumberOfVertices;
  distance = Infinity;
  for (const std::vector<GraphSeed>* seeds : { &from, &to })
  {
    const Status status = CheckSeeds(*seeds, n);
    if (!status.IsOk())
    {
      return status;
    }
  }
  const auto workspace = this->Internals->PointWorkspaces.Borrow(n);
  distance = workspace->Run(this->Internals->Graph, from, to, positions);
  return Status::Success();
}

Status GraphSearch::Many(const std::vector<Id>& sources, double maximumDistance,
  const ParallelFor& parallel, double* distances) const
{
  const Implementation& internals = *this->Internals;
  const Id n = internals.Graph.NumberOfVertices;
  if (std::isnan(maximumDistance))
  {
    return Status::Invalid("the maximum distance is not a number");
  }
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const Status status = CheckVertex(sources[i], n);
    if (!status.IsOk())
    {
      return InvalidSeed(i, status.GetMessage());
    }
  }
  const auto count = static_cast<Offset>(sources.size());
  const auto rowOf = [&](std::size_t i) { return distances + i * static_cast<std::size_t>(n); };
  // Vertices per group of sources that are searched together.
  const Offset patchSize = count == 0 ? 0 : Lanes::Size * static_cast<Offset>(n) / count;
  if (!internals.Mesh || patchSize > LargestPatch)
  {
    ForRange(parallel, count, 1, [&](Offset begin, Offset end) {
      for (Offset i = begin; i < end; ++i)
      {
        internals.FillRow(sources[i], maximumDistance, rowOf(i));
      }
    });
    return Status::Success();
  }
  const std::vector<std::size_t> order =
    internals.OrderSources(sources, static_cast<Id>(std::max<Offset>(1, patchSize)));
  ForRange(parallel, (count + Lanes::Size - 1) / Lanes::Size, 1, [&](Offset begin, Offset end) {
    ManySources search(internals.Graph, internals.Fans.get(), internals.BucketWidth);
    for (Offset block = begin; block < end; ++block)
    {
      Id lanes[Lanes::Size] = {};
      double* rows[Lanes::Size] = {};
      int used = 0;
      for (Offset i = block * Lanes::Size; i < std::min(count, (block + 1) * Lanes::Size); ++i)
      {
        lanes[used] = sources[order[i]];
        rows[used] = rowOf(order[i]);
        ++used;
      }
      search.Run(lanes, used, maximumDistance, rows);
    }
  });
  return Status::Success();
}

std::size_t GraphSearch::GetMemorySize() const
{
  const Implementation& internals = *this->Internals;
  return (internals.Fans ? internals.Fans->GetMemorySize() : 0) +
    (internals.Correction ? internals.Correction->GetMemorySize() : 0) +
    internals.Workspaces.GetMemorySize() + internals.PointWorkspaces.GetMemorySize();
}
}
