// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphSearch.h"

#include "dggBucketQueue.h"
#include "dggBucketSearch.h"
#include "dggGraphFans.h"
#include "dggHeap.h"
#include "dggLabelCorrection.h"
#include "dggLandmarks.h"
#include "dggManySources.h"
#include "dggPointToPoint.h"
#include "dggPrefetch.h"
#include "dggProgressPart.h"
#include "dggSearchLabels.h"
#include "dggSourceGroups.h"
#include "dggStatus.h"
#include "dggTurnLimits.h"
#include "dggWorkspacePool.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <mutex>

namespace dgg
{
namespace
{
Status CheckSeed(const GraphSeed& seed, Id numberOfVertices)
{
  DGG_RETURN_IF_ERROR(CheckVertex(seed.Vertex, numberOfVertices));
  if (!std::isfinite(seed.Distance) || !std::isfinite(seed.InitialDistance))
  {
    return InvalidInput(
      "Its distances ", seed.Distance, " and ", seed.InitialDistance, " are not both finite");
  }
  if (!std::isfinite(seed.ArrivalAngle))
  {
    return InvalidInput("Its arrival angle is ", seed.ArrivalAngle).Fix("Use a finite angle");
  }
  if (seed.ArrivalAngle >= 0.0 && seed.Distance < seed.InitialDistance)
  {
    return InvalidInput(
      "Its distance ", seed.Distance, " is below its initial distance ", seed.InitialDistance);
  }
  return Status::Success();
}

Status CheckRadius(double maximumDistance)
{
  return std::isnan(maximumDistance)
    ? InvalidValue("MaximumDistance", maximumDistance).Fix("Use a number or infinity")
    : Status::Success();
}

/// Minimum number of sources of a joint search. A joint search from this number of sources costs
/// about as much as single searches.
constexpr std::size_t SmallestGroup = 4;
/// Radius of the near field of a group of sources, in units of the distance from a central source
/// to the farthest one. Beyond it, all sources reach the surface in about the same order.
constexpr double NearFieldReach = 2.0;
/// Minimum number of progress reports of a search from many sources. The number is larger if more
/// than VerticesPerReport vertices are searched between two reports. FewestGroups groups between
/// two reports keep the threads busy.
constexpr Offset FewestReports = 8;
constexpr Offset VerticesPerReport = Offset(1) << 21;
constexpr Offset FewestGroups = 4;
/// Approximate number of vertices that a task searches. The number is smaller if there are not
/// FewestTasks tasks between two reports.
constexpr Offset VerticesPerTask = Offset(1) << 12;
constexpr Offset FewestTasks = 64;
/// Progress weight of choosing landmarks.
constexpr double ChoiceShare = 0.2;
/// Maximum near field of a group, as a fraction of the surface. Sources with a larger near field
/// are searched separately.
constexpr double LargestNearField = 0.4;
/// Maximum fraction of the surface that a local search reaches.
constexpr double LargestLocalPart = 0.25;
/// Approximate bytes per vertex: tables of a mesh, labels of a search, labels of a thread that
/// searches from many sources, landmarks.
constexpr std::size_t BytesOfTables = 40;
constexpr std::size_t BytesOfSearch = 84;
constexpr std::size_t BytesOfManySearch = 220;
constexpr std::size_t BytesOfLandmarks = Landmarks::Count * sizeof(std::int16_t) + sizeof(Id);

/// Number of vertices by which data of scattered vertices is prefetched.
constexpr std::size_t TreeLookahead = 12;

/// Removes labels beyond the limit, which a search for targets leaves behind.
void CutAtLimit(SearchLabels& labels)
{
  const auto isReached = [&](Id v) { return labels.IsReached(v); };
  const auto end = std::partition(labels.Touched.begin(), labels.Touched.end(), isReached);
  std::for_each(end, labels.Touched.end(), [&](Id v) { labels.Distances[v] = Infinity; });
  labels.Touched.erase(end, labels.Touched.end());
}

/// Sets all arrays but the distances to their initial values, and empties arrays that are not
/// requested.
void ResetTree(std::size_t n, bool withTree, bool withEstimates, SearchResult& result)
{
  const auto reset = [&](bool isWanted, auto& values, const auto& initial) {
    isWanted ? ResetTouched(values, n, result.Reached, initial) : values.clear();
  };
  reset(withTree, result.Seeds, NoId);
  reset(withTree, result.Edges, Offset(-1));
  reset(withTree, result.Tails, NoId);
  reset(withEstimates, result.Corrected, Infinity);
  reset(withEstimates, result.Virtual, VirtualSource());
}

/// Returns true if vertices that were reached one after the other mostly have ids that are far
/// apart, as in a random order.
bool AreScattered(const std::vector<Id>& touched, std::size_t numberOfVertices)
{
  constexpr std::size_t samples = 256;
  const auto far = static_cast<Id>(numberOfVertices / 8);
  std::size_t count = 0;
  for (std::size_t k = 0; k < samples && touched.size() > samples; ++k)
  {
    const std::size_t i = k * (touched.size() / samples);
    count += std::abs(touched[i + 1] - touched[i]) > far ? 1 : 0;
  }
  return 2 * count > samples;
}

/// Writes edges, tails and seeds of the labels into a result that shares their distances. `steps`
/// receives the reached vertices, every vertex after its tail.
void FinishTree(const SearchLabels& labels, SearchResult& result, std::vector<TreeStep>& steps)
{
  steps.clear();
  steps.reserve(labels.Touched.size());
  std::vector<Id> climbed;
  const auto finish = [&](Id v) {
    if (!labels.IsReached(v))
    {
      return;
    }
    // Climb the tree to a vertex with a known seed, then descend.
    while (result.Seeds[v] == NoId && !labels.Origins[v].IsSeed())
    {
      climbed.push_back(v);
      v = labels.Origins[v].Tail;
    }
    if (result.Seeds[v] == NoId)
    {
      result.Seeds[v] = labels.Origins[v].Tail;
      steps.push_back({ -1, v, NoId });
    }
    const Id seed = result.Seeds[v];
    for (; !climbed.empty(); climbed.pop_back())
    {
      v = climbed.back();
      result.Seeds[v] = seed;
      const LabelOrigin& origin = labels.Origins[v];
      result.Edges[v] = origin.Edge;
      result.Tails[v] = origin.Tail;
      steps.push_back({ origin.Edge, v, origin.Tail });
    }
  };
  if (!AreScattered(labels.Touched, labels.Distances.size()))
  {
    ForEachTouched(labels.Touched, labels.Distances.size(), finish);
    return;
  }
  // In the order of ids, every step of a climb would wait for memory. Most tails are reached
  // before.
  for (std::size_t i = 0; i < labels.Touched.size(); ++i)
  {
    const Id ahead = labels.Touched[std::min(i + TreeLookahead, labels.Touched.size() - 1)];
    Prefetch(&labels.Origins[ahead]);
    Prefetch(&result.Seeds[ahead]);
    Prefetch(&result.Edges[ahead]);
    Prefetch(&result.Tails[ahead]);
    finish(labels.Touched[i]);
  }
}

/// Workspace of one search.
struct SearchWorkspace
{
  SearchResult Result; ///< result of a search from one of many sources
  std::vector<LabelOrigin> Origins;
  std::vector<TreeStep> Steps;
  MinimumHeap Heap;
  BucketQueue Queue;
};

/// Workspace of a search from a group of sources.
struct ManyWorkspace
{
  ManyWorkspace(const GraphView& graph, double bucketWidth)
    : Search(graph, bucketWidth)
  {
  }

  ManySources Search;
  SweepOrder Order;
  std::vector<double> Field;
  std::vector<Id> Reached;
};

const std::vector<Id>* GetTargets(const ManyOptions& options)
{
  return options.Targets.empty() ? nullptr : &options.Targets;
}

const GraphSeed& NearestOf(const std::vector<GraphSeed>& seeds)
{
  return *std::min_element(seeds.begin(), seeds.end(),
    [](const GraphSeed& a, const GraphSeed& b) { return a.Distance < b.Distance; });
}
}

Status CheckVertex(Id vertex, Id numberOfVertices)
{
  if (vertex >= 0 && vertex < numberOfVertices)
  {
    return Status::Success();
  }
  return InvalidInput("Vertex ", vertex, " does not exist")
    .Fix("Use ids from 0 to ", numberOfVertices - 1);
}

Status CheckSeeds(const std::vector<GraphSeed>& seeds, Id numberOfVertices)
{
  if (seeds.empty())
  {
    return InvalidInput("There is no source").Fix("Add at least one source");
  }
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    DGG_RETURN_IF_ERROR(CheckSeed(seeds[i], numberOfVertices).Of(JoinText("Source ", i)));
  }
  return Status::Success();
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
      this->Correction = std::make_unique<LabelCorrection>(this->Graph, *this->Mesh);
    }
  }
  Implementation(const GraphView& graph, std::vector<VertexAngle> angles, double meanEdgeLength)
    : Implementation(graph, nullptr)
  {
    if (!angles.empty())
    {
      const double deviation = LargestDeviation(graph);
      this->Fans = std::make_unique<GraphFans>(this->Graph, angles, deviation);
      this->Correction = std::make_unique<LabelCorrection>(
        this->Graph, std::move(angles), deviation, meanEdgeLength);
    }
  }

  GraphView Graph;
  const SurfaceMesh* Mesh; ///< null where there are no angles
  double BucketWidth;
  std::unique_ptr<LabelCorrection> Correction; ///< null where there are no angles
  mutable std::once_flag FansOnce;
  mutable std::unique_ptr<GraphFans> Fans; ///< see GetFans()
  mutable std::once_flag LimitsOnce;
  mutable std::unique_ptr<TurnLimits> Limits; ///< see GetLimits()
  mutable WorkspacePool<SearchWorkspace> Workspaces;
  mutable WorkspacePool<ManyWorkspace> ManyWorkspaces;
  mutable WorkspacePool<PointToPoint> PointWorkspaces;
  mutable std::mutex MarksMutex;
  mutable std::weak_ptr<const Landmarks> Marks; ///< landmarks in use by any copy

  /// Returns the fans, which are made from the mesh at the first call; null without angles.
  const GraphFans* GetFans() const
  {
    std::call_once(this->FansOnce, [this] {
      if (this->Mesh)
      {
        this->Fans = std::make_unique<GraphFans>(this->Graph, *this->Mesh);
      }
    });
    return this->Fans.get();
  }
  /// Returns the limits of turns, made at the first call; null if unknown.
  const TurnLimits* GetLimits() const
  {
    std::call_once(this->LimitsOnce, [this] {
      this->Limits = this->Mesh && TurnLimits::AreKnown(this->Graph)
        ? std::make_unique<TurnLimits>(this->Graph, *this->Mesh)
        : nullptr;
    });
    return this->Limits.get();
  }

  bool FindDistances(const std::vector<GraphSeed>& seeds, const SearchOptions& options,
    SearchWorkspace& workspace, SearchLabels& labels, SearchEffort& effort) const
  {
    if (options.Method == SearchMethod::Dijkstra)
    {
      return RunDijkstra(this->Graph, seeds, options.Progress, workspace.Heap, labels, effort);
    }
    const bool overFans =
      options.Method == SearchMethod::Certified && GraphFans::AreWorthwhile(this->Graph);
    const GraphFans* fans = overFans ? this->GetFans() : nullptr;
    return RunBucketSearch(this->Graph, fans, seeds, this->BucketWidth, options.Progress,
      workspace.Queue, labels, effort);
  }

  /// Computes distances from the nearest seed. Computes the tree, which estimates require, and the
  /// estimates on request. Returns false if aborted.
  bool RunSingle(const std::vector<GraphSeed>& seeds, const SearchOptions& options,
    const std::vector<Id>* targets, bool withTree, SearchWorkspace& workspace,
    SearchResult& result) const
  {
    const Id n = this->Graph.NumberOfVertices;
    const bool withEstimates = options.Correct && this->Correction;
    ResetTree(static_cast<std::size_t>(n), withTree, withEstimates, result);
    SearchLabels labels(
      result.Distances, workspace.Origins, result.Reached, options.MaximumDistance);
    labels.Targets = targets;
    SearchEffort effort;
    effort.Labels = labels.Start(n, seeds);
    const bool isDone = this->FindDistances(seeds, options, workspace, labels, effort);
    result.NumberOfPops = effort.Pops;
    result.NumberOfRelaxations = effort.Relaxations;
    result.NumberOfLabels = effort.Labels + labels.Touched.size();
    CutAtLimit(labels);
    if (isDone && withTree)
    {
      FinishTree(labels, result, workspace.Steps);
    }
    if (isDone && withEstimates)
    {
      this->Correction->Run(seeds, workspace.Steps, result);
    }
    return isDone;
  }

  /// Returns the indices of sources, grouped for common searches.
  std::vector<std::vector<std::size_t>> GroupByPlace(
    const std::vector<Id>& sources, bool areLocal) const
  {
    if (this->Mesh && !areLocal)
    {
      return GroupSources(*this->Mesh, sources, Lanes::Size);
    }
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < sources.size(); ++i)
    {
      groups.push_back({ i });
    }
    return groups;
  }

  /// Computes distances from each source of a group, given by their indices, until `shouldContinue`
  /// returns false. Returns the number of labels that were written.
  std::size_t ConsumeGroup(const std::vector<std::vector<GraphSeed>>& sources,
    const std::vector<std::size_t>& group, const ManyOptions& options,
    const std::function<bool()>& shouldContinue, const FieldConsumer& consume) const
  {
    if (group.size() >= SmallestGroup && this->GetFans() && !options.Correct)
    {
      const auto workspace = this->ManyWorkspaces.Borrow(this->Graph, this->BucketWidth);
      ManySources::Sources members;
      for (std::size_t place : group)
      {
        members.push_back(&sources[place]);
      }
      if (this->PlanSweep(members, options, workspace->Order))
      {
        const bool isDone =
          workspace->Search.Run(members, options.MaximumDistance, workspace->Order, shouldContinue);
        for (std::size_t k = 0; k < group.size() && isDone; ++k)
        {
          workspace->Search.GetField(k, workspace->Field, workspace->Reached);
          consume(group[k], workspace->Field.data(), workspace->Reached);
        }
        return group.size() * static_cast<std::size_t>(this->Graph.NumberOfVertices);
      }
    }
    SearchOptions single;
    single.MaximumDistance = options.MaximumDistance;
    single.Correct = options.Correct;
    std::size_t labels = 0;
    for (std::size_t i = 0; i < group.size() && shouldContinue(); ++i)
    {
      const auto workspace = this->Workspaces.Borrow();
      SearchResult& result = workspace->Result;
      this->RunSingle(
        sources[group[i]], single, GetTargets(options), options.Correct, *workspace, result);
      const bool hasEstimates = !result.Corrected.empty();
      consume(
        group[i], hasEstimates ? result.Corrected.data() : result.Distances.data(), result.Reached);
      labels += result.NumberOfLabels;
    }
    return labels;
  }

  /// Returns the largest number of vertices that a search from the first, the middle or the last
  /// source reaches. Returns the number of all vertices if one of these searches is not local.
  std::size_t FindReach(
    const std::vector<std::vector<GraphSeed>>& sources, const ManyOptions& options) const
  {
    const auto n = static_cast<std::size_t>(this->Graph.NumberOfVertices);
    if (sources.size() < SmallestGroup ||
      (options.MaximumDistance == Infinity && options.Targets.empty()))
    {
      return n;
    }
    const auto workspace = this->Workspaces.Borrow();
    SearchOptions probe;
    probe.MaximumDistance = options.MaximumDistance;
    probe.Progress = [](double share) { return share < LargestLocalPart; };
    std::size_t reach = 0;
    for (const std::size_t i : { std::size_t(0), sources.size() / 2, sources.size() - 1 })
    {
      const bool isDone = this->RunSingle(
        sources[i], probe, GetTargets(options), false, *workspace, workspace->Result);
      if (!isDone)
      {
        return n;
      }
      reach = std::max(reach, workspace->Result.Reached.size());
    }
    return reach;
  }

  /// Plans the joint search of a group. Returns false if separate searches are cheaper. Separate
  /// searches are cheaper if the sources are far apart, or if few vertices are within the radius or
  /// nearer than the targets, since a joint search certifies all edges.
  bool PlanSweep(
    const ManySources::Sources& group, const ManyOptions& options, SweepOrder& order) const
  {
    const auto workspace = this->Workspaces.Borrow();
    const std::vector<GraphSeed>& middle = *group[group.size() / 2];
    ResetTree(0, false, false, workspace->Result); // The tree would belong to other labels.
    SearchLabels labels(workspace->Result.Distances, workspace->Origins, workspace->Result.Reached,
      options.MaximumDistance);
    labels.Targets = GetTargets(options);
    labels.Start(this->Graph.NumberOfVertices, middle);
    RunAlongFans(this->Graph, *this->GetFans(), middle, this->BucketWidth, workspace->Queue, labels,
      order.Vertices);
    const double start = NearestOf(middle).Distance;
    double farthest = start;
    for (const std::vector<GraphSeed>* source : group)
    {
      const Id v = NearestOf(*source).Vertex;
      farthest = std::max(farthest, labels.IsReached(v) ? labels.Distances[v] : start);
    }
    const double rim = start + NearFieldReach * (farthest - start);
    const auto far = std::find_if(order.Vertices.begin(), order.Vertices.end(),
      [&](Id v) { return labels.Distances[v] > rim; });
    order.NearField = static_cast<std::size_t>(far - order.Vertices.begin());
    const auto reached = static_cast<double>(order.Vertices.size());
    return reached > 0.5 * this->Graph.NumberOfVertices &&
      static_cast<double>(order.NearField) < LargestNearField * reached;
  }
};

GraphSearch::GraphSearch(const GraphView& graph, const SurfaceMesh* mesh)
  : Internals(std::make_shared<const Implementation>(graph, mesh))
{
}

GraphSearch::GraphSearch(
  const GraphView& graph, std::vector<VertexAngle> angles, double meanEdgeLength)
  : Internals(std::make_shared<const Implementation>(graph, std::move(angles), meanEdgeLength))
{
}

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
  status = status.IsOk() ? CheckRadius(options.MaximumDistance) : status;
  if (!status.IsOk())
  {
    result = SearchResult();
    return status;
  }
  const auto workspace = internals.Workspaces.Borrow();
  if (!internals.RunSingle(seeds, options, nullptr, true, *workspace, result))
  {
    result = SearchResult();
    return Status::Abort();
  }
  return Status::Success();
}

Status GraphSearch::Between(const std::vector<GraphSeed>& from, const std::vector<GraphSeed>& to,
  const double* positions, GraphPath& path) const
{
  const Implementation& internals = *this->Internals;
  const Id n = internals.Graph.NumberOfVertices;
  path = GraphPath();
  for (const std::vector<GraphSeed>* seeds : { &from, &to })
  {
    DGG_RETURN_IF_ERROR(CheckSeeds(*seeds, n));
  }
  const PathGuides guides{ internals.GetFans(), internals.GetLimits(), this->Marks.get(), positions,
    internals.BucketWidth };
  internals.PointWorkspaces.Borrow(n)->Run(internals.Graph, guides, from, to, path);
  return Status::Success();
}

Status GraphSearch::PrepareLandmarks(const ParallelFor& parallel, const ProgressCallback& progress)
{
  const Implementation& internals = *this->Internals;
  {
    const std::lock_guard<std::mutex> lock(internals.MarksMutex);
    this->Marks = internals.Marks.lock();
  }
  if (this->Marks)
  {
    return Status::Success();
  }
  const auto marks = std::make_shared<Landmarks>();
  DGG_RETURN_IF_ERROR(
    marks->Choose(internals.Graph, internals.Mesh, ProgressPart(progress, 0.0, ChoiceShare)));
  std::vector<std::vector<GraphSeed>> sources;
  for (const Id v : marks->GetVertices())
  {
    sources.emplace_back(1);
    sources.back()[0].Vertex = v;
  }
  DGG_RETURN_IF_ERROR(
    this->Many(sources, ManyOptions(), parallel, ProgressPart(progress, ChoiceShare, 1.0),
      [&](std::size_t k, const double* distances, const std::vector<Id>&) {
        marks->SetDistances(k, distances);
      }));
  this->Marks = marks;
  const std::lock_guard<std::mutex> lock(internals.MarksMutex);
  internals.Marks = marks;
  return Status::Success();
}

bool GraphSearch::HasLandmarks() const
{
  return this->Marks != nullptr;
}

Status GraphSearch::Many(const std::vector<std::vector<GraphSeed>>& sources,
  const ManyOptions& options, const ParallelFor& parallel, const ProgressCallback& progress,
  const FieldConsumer& consume, std::size_t* numberOfLabels) const
{
  ManyPlan plan;
  DGG_RETURN_IF_ERROR(this->PlanMany(sources, options, plan));
  return this->Many(sources, options, plan, parallel, progress, consume, numberOfLabels);
}

Status GraphSearch::PlanMany(const std::vector<std::vector<GraphSeed>>& sources,
  const ManyOptions& options, ManyPlan& plan) const
{
  const Implementation& internals = *this->Internals;
  const auto n = static_cast<std::size_t>(internals.Graph.NumberOfVertices);
  DGG_RETURN_IF_ERROR(CheckRadius(options.MaximumDistance));
  std::vector<Id> vertices;
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    DGG_RETURN_IF_ERROR(CheckSeeds(sources[i], internals.Graph.NumberOfVertices)
                          .Of(JoinText("Set ", i, " of sources")));
    vertices.push_back(NearestOf(sources[i]).Vertex);
  }
  plan.Reach = internals.FindReach(sources, options);
  const bool areLocal =
    sources.size() < SmallestGroup || static_cast<double>(plan.Reach) < LargestLocalPart * n;
  plan.Groups = internals.GroupByPlace(vertices, areLocal);
  return Status::Success();
}

Status GraphSearch::Many(const std::vector<std::vector<GraphSeed>>& sources,
  const ManyOptions& options, const ManyPlan& plan, const ParallelFor& parallel,
  const ProgressCallback& progress, const FieldConsumer& consume, std::size_t* numberOfLabels) const
{
  const Implementation& internals = *this->Internals;
  const auto& groups = plan.Groups;
  const auto numberOfGroups = static_cast<Offset>(groups.size());
  const auto verticesPerGroup = static_cast<Offset>(std::max<std::size_t>(1, plan.Reach));
  const Offset step = std::max(
    FewestGroups, std::min(numberOfGroups / FewestReports, VerticesPerReport / verticesPerGroup));
  const Offset grain = std::max<Offset>(
    1, std::min(VerticesPerTask / verticesPerGroup, std::min(step, numberOfGroups) / FewestTasks));
  std::atomic<bool> isStopped{ false };
  std::atomic<std::size_t> labels{ 0 };
  for (Offset first = 0; first < numberOfGroups; first += step)
  {
    const Offset size = std::min(step, numberOfGroups - first);
    ForRange(parallel, size, grain, [&](Offset begin, Offset end) {
      const double done = static_cast<double>(first) / static_cast<double>(numberOfGroups);
      const auto shouldContinue = [&] {
        isStopped = isStopped || !ShouldContinue(progress, done);
        return !isStopped;
      };
      for (Offset i = begin; i < end && shouldContinue(); ++i)
      {
        labels +=
          internals.ConsumeGroup(sources, groups[first + i], options, shouldContinue, consume);
      }
    });
    if (isStopped)
    {
      return Status::Abort();
    }
    const auto done = static_cast<double>(std::min(first + step, numberOfGroups));
    DGG_RETURN_IF_ERROR(ReportTo(progress, done / static_cast<double>(numberOfGroups)));
  }
  if (numberOfLabels)
  {
    *numberOfLabels += labels;
  }
  return Status::Success();
}

bool SearchResult::IsLocal() const
{
  return AreFew(this->Reached, this->Distances.size());
}

std::size_t GraphSearch::GetMemorySize() const
{
  const Implementation& internals = *this->Internals;
  return static_cast<std::size_t>(internals.Graph.NumberOfVertices) *
    (BytesOfSearch + (internals.Correction ? BytesOfTables : 0) +
      (this->Marks ? BytesOfLandmarks : 0));
}

double GraphSearch::EstimateMany(Id numberOfVertices, int numberOfThreads)
{
  const auto threads = static_cast<std::size_t>(numberOfThreads);
  return static_cast<double>(BytesOfTables + BytesOfManySearch * threads) * numberOfVertices;
}
}
