// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceSearch.h"

#include "dggBucketSearch.h"
#include "dggPrefetch.h"
#include "dggProgressPart.h"
#include "dggSourceFinding.h"
#include "dggSurfaceRegion.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace dgg
{
namespace
{
/// Progress weight of finding labels if the tree is followed as well.
constexpr double LabelShare = 0.7;
/// Bytes per vertex of ids, labels, fans, arrivals and results.
constexpr std::size_t BytesOfVertex = 248;

/// Contribution of a process to the size of the entire graph.
struct GraphSize
{
  Offset Points = 0;
  Offset Edges = 0;
  Offset SmallestId = std::numeric_limits<Offset>::max();
  Offset LargestId = std::numeric_limits<Offset>::min();
};

}

Status PieceSearch::Prepare(ProcessGroup& group, const SurfacePiece& piece, const GraphView& graph,
  const GhostVertices& ghosts, bool& isUsable)
{
  *this = PieceSearch();
  this->Process = group.Here;
  this->Graph = graph;
  this->Ghosts = ghosts;
  this->PointsHere = static_cast<Id>(piece.NumberOfPoints);
  this->Sent.resize(static_cast<std::size_t>(group.Count));
  this->Received.resize(static_cast<std::size_t>(group.Count));
  DGG_RETURN_IF_ERROR(this->FindReaders(group, piece, isUsable));
  return isUsable ? this->MeasureAngles(group, piece, isUsable) : Status::Success();
}

/// Finds the processes that have vertices of this process as ghosts or shared points.
Status PieceSearch::FindReaders(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  this->Ids.assign(piece.PointIds, piece.PointIds + piece.NumberOfPoints);
  this->Ids.insert(this->Ids.end(), this->Ghosts.Ids, this->Ghosts.Ids + this->Ghosts.Count);
  this->ById.resize(this->Ids.size());
  std::iota(this->ById.begin(), this->ById.end(), 0);
  std::sort(this->ById.begin(), this->ById.end(),
    [this](Id a, Id b) { return this->Ids[a] < this->Ids[b]; });
  isUsable = true;
  std::vector<std::vector<Offset>> requested(this->Received.size());
  for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
  {
    const Id owner = this->Ghosts.Owners[v];
    if (owner >= 0 && owner < group.Count)
    {
      this->Received[owner].push_back(v);
      requested[owner].push_back(this->Ids[v]);
    }
    isUsable =
      isUsable && (this->IsHere(v) ? v < this->PointsHere : owner >= 0 && owner < group.Count);
  }
  DGG_RETURN_IF_ERROR(group.ExchangeLists(requested));
  for (std::size_t process = 0; process < requested.size(); ++process)
  {
    for (const Offset id : requested[process])
    {
      const Id v = this->FindVertex(id);
      isUsable = isUsable && v != NoId && this->IsHere(v);
      this->Sent[process].push_back(v);
    }
    this->LastSent.emplace_back(requested[process].size(), Infinity);
  }
  return group.Require(isUsable);
}

/// Measures the angles around all vertices, and prepares what depends on them.
Status PieceSearch::MeasureAngles(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  SurfaceRegion region;
  DGG_RETURN_IF_ERROR(region.Start(group, piece, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(region.Grow(group, 1, true, 0.0)); // all cells at the points of the piece
  RegionMesh mesh;
  region.MakeMesh(mesh);
  isUsable = mesh.IsValid;
  DGG_RETURN_IF_ERROR(group.Require(isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  const std::vector<VertexAngle> ofMesh = MeasureVertexAngles(mesh.Mesh);
  std::vector<VertexAngle> angles(static_cast<std::size_t>(this->Graph.NumberOfVertices));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (mesh.Points[i] < this->PointsHere)
    {
      angles[mesh.Points[i]] = ofMesh[i];
    }
  }
  DGG_RETURN_IF_ERROR(this->TakeFromOwners(group, angles));
  Offset edges = 0;
  DGG_RETURN_IF_ERROR(this->CountPoints(group, edges));
  const double deviation = LargestDeviation(this->Graph.Info,
    static_cast<double>(edges) / std::max(1.0, static_cast<double>(this->NumberOfPoints)));
  this->BucketWidth = ChooseBucketWidth(this->Graph);
  if (GraphFans::AreWorthwhile(this->Graph))
  {
    this->Fans = std::make_unique<const GraphFans>(this->Graph, angles, deviation);
  }
  // The mean length decides a scale, which does not affect the results.
  this->Correction = std::make_unique<const LabelCorrection>(
    this->Graph, std::move(angles), deviation, mesh.Mesh.GetMeanEdgeLength());
  return Status::Success();
}

/// Counts the points and edges of the entire graph.
Status PieceSearch::CountPoints(ProcessGroup& group, Offset& edges)
{
  GraphSize here;
  for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
  {
    if (this->IsHere(v))
    {
      ++here.Points;
      here.Edges += this->Graph.Offsets[v + 1] - this->Graph.Offsets[v];
      here.SmallestId = std::min(here.SmallestId, this->Ids[v]);
      here.LargestId = std::max(here.LargestId, this->Ids[v]);
    }
  }
  std::vector<GraphSize> parts;
  DGG_RETURN_IF_ERROR(group.Share(here, parts));
  for (const GraphSize& part : parts)
  {
    this->NumberOfPoints += part.Points;
    this->SmallestId = std::min(this->SmallestId, part.SmallestId);
    this->LargestId = std::max(this->LargestId, part.LargestId);
    edges += part.Edges;
  }
  return Status::Success();
}

Status PieceSearch::Run(ProcessGroup& group, const std::vector<PieceSeed>& seeds,
  const PieceSearchOptions& options, PieceDistances& result, bool& isUsable)
{
  result = PieceDistances();
  isUsable = true;
  const std::vector<GraphSeed> here = this->TakeSeeds(seeds);
  this->ClearLabels();
  DGG_RETURN_IF_ERROR(this->FindLabels(group, here, options, true));
  result.Labels.assign(this->Distances.begin(), this->Distances.begin() + this->PointsHere);
  if (!options.NeedsTree())
  {
    return Status::Success();
  }
  double smallestOffset = Infinity;
  for (const PieceSeed& seed : seeds)
  {
    smallestOffset = std::min(smallestOffset, LabelCorrection::OffsetOf(seed.Seed));
  }
  std::vector<Arrival> arrivals;
  DGG_RETURN_IF_ERROR(this->FollowTree(group, here, smallestOffset, options, arrivals, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  for (Id i = 0; i < this->PointsHere; ++i)
  {
    const Arrival& arrival = arrivals[i];
    if (options.Correct)
    {
      result.Corrected.push_back(arrival.Source == NoId ? Infinity : arrival.Estimate.Distance);
    }
    if (options.FindSources)
    {
      result.NearestSource.push_back(arrival.Source);
    }
    if (options.FindRelays)
    {
      result.Virtual.push_back(arrival.Estimate.Source);
      result.Relays.push_back(arrival.Relay);
    }
  }
  return Status::Success();
}

void PieceSearch::ClearLabels()
{
  SearchLabels(this->Distances, this->Origins, this->Touched, Infinity)
    .Start(this->Graph.NumberOfVertices, {});
  for (std::vector<double>& sent : this->LastSent)
  {
    std::fill(sent.begin(), sent.end(), Infinity);
  }
}

Status PieceSearch::AddSeeds(ProcessGroup& group, const std::vector<PieceSeed>& seeds)
{
  return this->FindLabels(group, this->TakeSeeds(seeds), PieceSearchOptions(), false);
}

/// Returns the seeds at vertices of this part of the graph.
std::vector<GraphSeed> PieceSearch::TakeSeeds(const std::vector<PieceSeed>& seeds) const
{
  std::vector<GraphSeed> here;
  for (const PieceSeed& seed : seeds)
  {
    const Id v = this->FindVertex(seed.PointId);
    if (v != NoId)
    {
      here.push_back(seed.Seed);
      here.back().Vertex = v;
    }
  }
  return here;
}

std::vector<Id> PieceSearch::ListConnected() const
{
  std::vector<Id> connected;
  std::copy_if(this->ById.begin(), this->ById.end(), std::back_inserter(connected), [this](Id v) {
    return this->IsHere(v) && this->Graph.Offsets[v] < this->Graph.Offsets[v + 1];
  });
  return connected;
}

Status PieceSearch::FindIsolated(ProcessGroup& group, const std::vector<PieceSeed>& seeds,
  std::vector<std::size_t>& isolated) const
{
  std::vector<std::size_t> here;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const Id v = this->FindVertex(seeds[i].PointId);
    if (v != NoId && this->IsHere(v) && this->Graph.Offsets[v] == this->Graph.Offsets[v + 1])
    {
      here.push_back(i);
    }
  }
  DGG_RETURN_IF_ERROR(group.JoinLists(here));
  isolated.insert(isolated.end(), here.begin(), here.end());
  std::sort(isolated.begin(), isolated.end());
  return Status::Success();
}

/// Returns the vertex with a global id; NoId if it is not in this part of the graph.
Id PieceSearch::FindVertex(Offset id) const
{
  const auto found = std::lower_bound(this->ById.begin(), this->ById.end(), id,
    [this](Id v, Offset wanted) { return this->Ids[v] < wanted; });
  return found != this->ById.end() && this->Ids[*found] == id ? *found : NoId;
}

double PieceSearch::GetMemorySize() const
{
  return static_cast<double>(BytesOfVertex) * static_cast<double>(this->Ids.size());
}

/// Lowers the labels of all vertices by seeds, the first or further ones, and finds the tree of the
/// vertices of this process.
Status PieceSearch::FindLabels(ProcessGroup& group, std::vector<GraphSeed> seeds,
  const PieceSearchOptions& options, bool areFirst)
{
  SearchLabels labels(this->Distances, this->Origins, this->Touched, options.MaximumDistance);
  labels.Ids = this->Ids.data();
  const ProgressCallback searchProgress =
    ProgressPart(options.Progress, 0.0, options.NeedsTree() ? LabelShare : 1.0);
  const ProgressCallback progress = [&](double) {
    return ShouldContinue(searchProgress,
      static_cast<double>(this->Touched.size()) / std::max<Id>(1, this->Graph.NumberOfVertices));
  };
  std::vector<Message> messages;
  for (bool isOver = false; !isOver; areFirst = false)
  {
    if (!this->LowerLabels(seeds, areFirst, labels, progress))
    {
      return Status::Abort();
    }
    DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
    this->CollectLowered(messages);
    DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize(), &isOver));
    seeds = this->ReadLowered(messages);
  }
  return Status::Success();
}

/// Searches from seeds, the first or further ones. Returns false if aborted.
bool PieceSearch::LowerLabels(const std::vector<GraphSeed>& seeds, bool areFirst,
  SearchLabels& labels, const ProgressCallback& progress)
{
  if (areFirst)
  {
    labels.Start(this->Graph.NumberOfVertices, seeds);
    SearchEffort effort;
    return seeds.empty() ||
      RunBucketSearch(this->Graph, this->Fans.get(), seeds, this->BucketWidth, progress,
        this->Queue, labels, effort);
  }
  return seeds.empty() ||
    dgg::LowerLabels(this->Graph, this->Fans.get(), seeds, this->BucketWidth, progress, this->Queue,
      labels, this->Lowered);
}

/// Makes messages with the labels that have been lowered since they were last sent.
void PieceSearch::CollectLowered(std::vector<Message>& messages)
{
  messages.assign(this->Sent.size(), Message());
  for (std::size_t process = 0; process < this->Sent.size(); ++process)
  {
    std::vector<SharedValue<double>> list;
    for (std::size_t k = 0; k < this->Sent[process].size(); ++k)
    {
      const double label = this->Distances[this->Sent[process][k]];
      if (label < this->LastSent[process][k])
      {
        this->LastSent[process][k] = label;
        list.push_back({ static_cast<Id>(k), label });
      }
    }
    AppendIfAny(messages[process], list);
  }
}

/// Returns the labels in messages that are lower than those here.
std::vector<GraphSeed> PieceSearch::ReadLowered(const std::vector<Message>& messages) const
{
  std::vector<GraphSeed> lowered;
  for (std::size_t process = 0; process < messages.size(); ++process)
  {
    for (const auto& value : MessageReader(messages[process]).Take<SharedValue<double>>())
    {
      const Id v = this->Received[process][value.Index];
      if (value.Content < this->Distances[v])
      {
        lowered.push_back({ v, value.Content, value.Content });
      }
    }
  }
  return lowered;
}

/// Tree of the vertices whose arrivals this process computes, and the arrivals that are missing.
struct PieceSearch::Tree
{
  std::vector<std::uint8_t> IsFollowed; // arrivals are computed here, per vertex
  std::vector<Id> Left;                 // followed vertices without an arrival
  /// Per vertex, the last round in which it was left, or Listed.
  std::vector<int> LastRounds;
  static constexpr int Listed = std::numeric_limits<int>::max();
  int Round = 0;
  std::vector<std::vector<Id>> Pending; // per process, indices into Sent that it waits for
  bool HasRelays = false;               // messages contain relays
};

/// Computes the arrivals at the vertices of this process, and at the other points of the piece. The
/// tree crosses pieces: arrivals are sent to the processes that need them as they become known.
Status PieceSearch::FollowTree(ProcessGroup& group, const std::vector<GraphSeed>& seeds,
  double smallestOffset, const PieceSearchOptions& options, std::vector<Arrival>& arrivals,
  bool& isUsable)
{
  const ProgressCallback progress = ProgressPart(options.Progress, LabelShare, 1.0);
  Tree tree;
  tree.HasRelays = options.FindRelays;
  arrivals.assign(static_cast<std::size_t>(this->Graph.NumberOfVertices), Arrival());
  DGG_RETURN_IF_ERROR(this->PrepareTree(group, tree, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  std::vector<Message> messages;
  const auto total = static_cast<double>(std::max<std::size_t>(1, tree.Left.size()));
  bool isAnyNew = true; // arrivals from which others may follow
  for (bool isOver = false; !isOver;)
  {
    if (isAnyNew)
    {
      this->Descend(seeds, smallestOffset, tree, arrivals);
    }
    DGG_RETURN_IF_ERROR(ReportTo(progress, 1.0 - static_cast<double>(tree.Left.size()) / total));
    this->CollectArrivals(arrivals, tree, messages);
    DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize(), &isOver));
    isAnyNew = this->ReadArrivals(messages, arrivals);
  }
  bool isComplete = tree.Left.empty();
  DGG_RETURN_IF_ERROR(group.Require(isComplete));
  return isComplete ? Status::Success()
                    : Status(Status::Code::DamagedGraph, "The pieces do not form one graph")
                        .Fix("Compute the graph again on these processes");
}

/// Chooses the vertices whose arrivals this process computes: those that belong to it, and ghosts
/// that it needs and whose tails belong to it. A path that leaves the piece and returns with the
/// next edge then needs no message.
Status PieceSearch::PrepareTree(ProcessGroup& group, Tree& tree, bool& isUsable)
{
  const Id n = this->Graph.NumberOfVertices;
  const auto count = static_cast<std::size_t>(group.Count);
  std::vector<std::uint8_t> isNeeded(static_cast<std::size_t>(n), 0);
  tree.IsFollowed = isNeeded;
  isUsable = true;
  for (Id v = 0; v < n; ++v)
  {
    const bool isReached = this->Distances[v] < Infinity;
    tree.IsFollowed[v] = isReached && this->IsHere(v) ? 1 : 0;
    isNeeded[v] |= isReached && v < this->PointsHere ? 1 : 0;
    if (tree.IsFollowed[v] && !this->Origins[v].IsSeed())
    {
      const Id tail = this->Origins[v].Tail;
      isNeeded[tail] = 1;
      isUsable = isUsable && this->Distances[tail] < this->Distances[v]; // tails form no cycle
    }
  }
  std::vector<Message> messages(count);
  for (std::size_t process = 0; process < count; ++process)
  {
    std::vector<Id> needed;                 // indices into Received
    std::vector<SharedValue<Offset>> tails; // global ids of tails that belong to the process
    for (std::size_t k = 0; k < this->Received[process].size(); ++k)
    {
      if (isNeeded[this->Received[process][k]])
      {
        needed.push_back(static_cast<Id>(k));
      }
    }
    for (std::size_t k = 0; k < this->Sent[process].size(); ++k)
    {
      const Id v = this->Sent[process][k];
      if (this->HasTailOf(v, process))
      {
        tails.push_back({ static_cast<Id>(k), this->Ids[this->Origins[v].Tail] });
      }
    }
    Append(messages[process], needed);
    Append(messages[process], tails);
  }
  DGG_RETURN_IF_ERROR(group.Exchange(messages, this->GetMemorySize()));
  tree.Pending.resize(count);
  for (std::size_t process = 0; process < count; ++process)
  {
    MessageReader reader(messages[process]);
    std::vector<Id>& pending = tree.Pending[process];
    pending = reader.Take<Id>();
    pending.erase(std::remove_if(pending.begin(), pending.end(),
                    [&](Id k) { return this->HasTailOf(this->Sent[process][k], process); }),
      pending.end());
    for (const auto& tail : reader.Take<SharedValue<Offset>>())
    {
      const Id v = this->Received[process][tail.Index];
      if (isNeeded[v])
      {
        isUsable = this->SetTail(v, this->FindVertex(tail.Content)) && isUsable;
        tree.IsFollowed[v] = 1;
      }
    }
  }
  DGG_RETURN_IF_ERROR(group.Require(isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  tree.LastRounds.assign(static_cast<std::size_t>(n), 0);
  for (Id v = 0; v < n; ++v)
  {
    if (tree.IsFollowed[v])
    {
      tree.Left.push_back(v);
    }
  }
  return Status::Success();
}

/// Returns true if the tail of a vertex of this process belongs to `process`.
bool PieceSearch::HasTailOf(Id v, std::size_t process) const
{
  return this->Distances[v] < Infinity && !this->Origins[v].IsSeed() &&
    this->Ghosts.Owners[this->Origins[v].Tail] == static_cast<Id>(process);
}

/// Sets the tail of a ghost to a vertex of this process. Returns false if no edge joins them.
bool PieceSearch::SetTail(Id v, Id tail)
{
  if (tail == NoId || !(this->Distances[tail] < this->Distances[v]))
  {
    return false;
  }
  const Id* const row = this->Graph.Targets + this->Graph.Offsets[tail];
  const Id* const end = this->Graph.Targets + this->Graph.Offsets[tail + 1];
  const Id* const found = std::find(row, end, v);
  if (found != end)
  {
    this->Origins[v] = { found - this->Graph.Targets, tail };
  }
  return found != end;
}

/// Enters the arrivals in messages. Returns true if there are any.
bool PieceSearch::ReadArrivals(
  const std::vector<Message>& messages, std::vector<Arrival>& arrivals) const
{
  bool isAny = false;
  for (std::size_t process = 0; process < messages.size(); ++process)
  {
    MessageReader reader(messages[process]);
    const auto list = reader.Take<SharedValue<Estimated>>();
    isAny = isAny || !list.empty();
    const auto relays = reader.Take<PieceRelay>();
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      arrivals[this->Received[process][list[i].Index]] = { list[i].Content,
        relays.empty() ? PieceRelay() : relays[i] };
    }
  }
  return isAny;
}

/// Computes all arrivals that follow from known ones.
void PieceSearch::Descend(const std::vector<GraphSeed>& seeds, double smallestOffset, Tree& tree,
  std::vector<Arrival>& arrivals) const
{
  const std::vector<TreeStep> steps = this->FindSteps(tree, arrivals);
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const TreeStep& ahead = steps[std::min(i + LabelCorrection::Lookahead, steps.size() - 1)];
    Prefetch(&arrivals[ahead.Vertex]);
    if (ahead.Tail != NoId)
    {
      Prefetch(&arrivals[ahead.Tail]);
      this->Correction->PrefetchStep(ahead);
    }
    const TreeStep& step = steps[i];
    if (step.Tail == NoId)
    {
      const GraphSeed& seed = seeds[this->Origins[step.Vertex].Tail];
      arrivals[step.Vertex] = { { LabelCorrection::EstimateOf(seed), seed.Source }, {} };
    }
    else
    {
      const Arrival& tail = arrivals[step.Tail];
      Arrival& arrival = arrivals[step.Vertex];
      arrival = { { this->Correction->Extend(
                      step, this->Distances[step.Vertex], tail.Estimate, smallestOffset),
                    tail.Source },
        tail.Relay };
      if (!IsStraight(tail.Estimate.Source, arrival.Estimate.Source))
      {
        const Id owner = this->Ghosts.Owners[step.Tail];
        arrival.Relay = { this->Ids[step.Tail],
          owner == GhostVertices::Here ? this->Process : owner };
      }
    }
  }
}

/// Returns the vertices whose arrivals follow from known ones, every vertex after its tail, and
/// removes them from those that are left. From each vertex, climbs to a known arrival or a seed,
/// then descends.
std::vector<TreeStep> PieceSearch::FindSteps(Tree& tree, const std::vector<Arrival>& arrivals) const
{
  ++tree.Round;
  std::vector<TreeStep> steps;
  steps.reserve(tree.Left.size());
  std::vector<Id> climbed;
  for (const Id start : tree.Left)
  {
    Id v = start;
    for (; tree.IsFollowed[v] && tree.LastRounds[v] < tree.Round; v = this->Origins[v].Tail)
    {
      tree.LastRounds[v] = tree.Round;
      if (this->Origins[v].IsSeed())
      {
        steps.push_back({ -1, v, NoId });
        tree.LastRounds[v] = Tree::Listed;
        break;
      }
      climbed.push_back(v);
    }
    const bool isKnown =
      tree.IsFollowed[v] ? tree.LastRounds[v] == Tree::Listed : arrivals[v].Source != NoId;
    for (; isKnown && !climbed.empty(); climbed.pop_back())
    {
      v = climbed.back();
      steps.push_back({ this->Origins[v].Edge, v, this->Origins[v].Tail });
      tree.LastRounds[v] = Tree::Listed;
    }
    climbed.clear();
  }
  tree.Left.erase(std::remove_if(tree.Left.begin(), tree.Left.end(),
                    [&](Id v) { return tree.LastRounds[v] == Tree::Listed; }),
    tree.Left.end());
  return steps;
}

/// Makes messages with the arrivals that other processes wait for.
void PieceSearch::CollectArrivals(
  const std::vector<Arrival>& arrivals, Tree& tree, std::vector<Message>& messages) const
{
  messages.assign(this->Sent.size(), Message());
  for (std::size_t process = 0; process < this->Sent.size(); ++process)
  {
    std::vector<Id>& pending = tree.Pending[process];
    const auto left = std::partition(pending.begin(), pending.end(),
      [&](Id k) { return arrivals[this->Sent[process][k]].Source != NoId; });
    std::vector<SharedValue<Estimated>> list;
    std::vector<PieceRelay> relays;
    std::for_each(pending.begin(), left, [&](Id k) {
      list.push_back({ k, arrivals[this->Sent[process][k]] });
      relays.push_back(arrivals[this->Sent[process][k]].Relay);
    });
    pending.erase(pending.begin(), left);
    AppendIfAny(messages[process], list);
    if (tree.HasRelays)
    {
      AppendIfAny(messages[process], relays);
    }
  }
}
}
