// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBucketSearch.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace dgg
{
namespace
{
/// Number of vertices between two progress reports, some milliseconds.
constexpr std::size_t ProgressInterval = 16384;
/// Number of queue entries by which vertices, and their edges, are prefetched.
constexpr std::size_t VertexLookahead = 12;
constexpr std::size_t EdgesLookahead = 6;

template <typename Length>
bool RunNearestFirst(const GraphView& graph, const Length* lengths,
  const ProgressCallback& progress, MinimumHeap& heap, SearchLabels& labels, SearchEffort& effort)
{
  double* const distances = labels.Distances.data();
  while (!heap.IsEmpty())
  {
    const MinimumHeap::Entry top = heap.Pop();
    const Id v = top.Index;
    if (top.Key > distances[v]) // the label has been lowered since
    {
      continue;
    }
    ++effort.Pops;
    if (effort.Pops % ProgressInterval == 0 && progress &&
      !progress(static_cast<double>(effort.Pops) / graph.NumberOfVertices))
    {
      return false;
    }
    const Offset end = graph.Offsets[v + 1];
    effort.Relaxations += static_cast<std::size_t>(end - graph.Offsets[v]);
    for (Offset e = graph.Offsets[v]; e < end; ++e)
    {
      const double distance = top.Key + lengths[e];
      const Id t = graph.Targets[e];
      if (distance < distances[t] && distance < labels.Limit)
      {
        labels.SetDistance(t, distance);
        labels.Origins[t] = { e, v, -1.0f };
        heap.Push(distance, t);
      }
      else if (distance == distances[t] && labels.IsPreferred(t, v))
      {
        labels.Origins[t] = { e, v, -1.0f };
      }
    }
  }
  return true;
}

template <typename Length>
class LabelCorrecting
{
public:
  LabelCorrecting(const GraphView& graph, const Length* lengths, const GraphFans* fans,
    const ProgressCallback& progress, BucketQueue& queue, SearchLabels& labels,
    SearchEffort& effort)
    : Graph(graph)
    , Lengths(lengths)
    , Fans(fans)
    , Progress(progress)
    , Queue(queue)
    , Labels(labels)
    , Effort(effort)
    , Targets(labels.Targets)
  {
  }

  bool Run(const std::vector<GraphSeed>& seeds, double width)
  {
    this->Start(seeds, width);
    if (!this->Fans)
    {
      return this->Propagate<false>();
    }
    if (!this->Propagate<true>())
    {
      return false;
    }
    this->Targets = nullptr; // The limit already excludes all vertices beyond the targets.
    this->Queue.Reset(NearestOf(seeds), width);
    this->Certify();
    return this->Propagate<false>();
  }

  void RunAlongFans(const std::vector<GraphSeed>& seeds, double width, std::vector<Id>& order)
  {
    this->Order = &order;
    this->Start(seeds, width);
    this->Propagate<true>();
  }

  /// Searches from new seeds. `touched` receives the vertices whose labels are lowered. Returns
  /// false if aborted.
  bool RunFromNewSeeds(const std::vector<GraphSeed>& seeds, double width, std::vector<Id>& touched)
  {
    touched.clear();
    this->Order = &touched;
    this->Queue.Reset(NearestOf(seeds), width);
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      const GraphSeed& seed = seeds[i];
      if (this->Labels.Lower(seed, i))
      {
        this->Queue.Push(seed.Distance, seed.Vertex);
      }
    }
    if (!this->Fans)
    {
      return this->Propagate<false>();
    }
    if (!this->Propagate<true>())
    {
      return false;
    }
    // Vertices whose label has not changed need no certification.
    this->Queue.Reset(NearestOf(seeds), width);
    for (const Id v : this->CountChildren(touched))
    {
      this->CertifyRow(v);
    }
    this->Children = nullptr;
    return this->Propagate<false>();
  }

private:
  static double NearestOf(const std::vector<GraphSeed>& seeds)
  {
    double nearest = Infinity;
    for (const GraphSeed& seed : seeds)
    {
      nearest = std::min(nearest, seed.Distance);
    }
    return nearest;
  }

  void Start(const std::vector<GraphSeed>& seeds, double width)
  {
    this->Queue.Reset(NearestOf(seeds), width);
    for (const GraphSeed& seed : seeds)
    {
      if (seed.Distance < this->Labels.Limit)
      {
        this->Queue.Push(seed.Distance, seed.Vertex);
      }
    }
  }

  /// Processes the queue, bucket by bucket. Returns false if aborted.
  template <bool OverFans>
  bool Propagate()
  {
    const auto isOutdated = [this](const BucketQueue::Entry& entry) {
      return entry.Key > this->Queue.Key(this->Labels.Distances[entry.Vertex]);
    };
    while (this->Queue.Advance() && !this->AreTargetsPassed())
    {
      this->Queue.Sift(isOutdated);
      // The bucket grows during the loop: nearby vertices are put into the same bucket.
      const std::vector<BucketQueue::Entry>& bucket = this->Queue.Current();
      const std::size_t pops = this->Effort.Pops;
      for (std::size_t i = 0; i < bucket.size(); ++i)
      {
        this->template LookAhead<OverFans>(i);
        if (!isOutdated(bucket[i]))
        {
          const Id v = bucket[i].Vertex;
          ++this->Effort.Pops;
          if (this->Order)
          {
            this->Order->push_back(v);
          }
          this->template RelaxFrom<OverFans>(v, this->Labels.Distances[v]);
        }
      }
      this->Queue.ClearCurrent();
      if (!this->Report(this->Effort.Pops - pops))
      {
        return false;
      }
    }
    return true;
  }

  /// Returns true if there are targets and no label in the queue can lower the labels of the
  /// targets. In this case the largest distance of a target becomes the limit.
  bool AreTargetsPassed()
  {
    if (!this->Targets)
    {
      return false;
    }
    const std::vector<Id>& targets = *this->Targets;
    const std::vector<double>& distances = this->Labels.Distances;
    while (this->Passed < targets.size() && this->Queue.IsPast(distances[targets[this->Passed]]))
    {
      this->Largest = std::max(this->Largest, distances[targets[this->Passed]]);
      ++this->Passed;
    }
    if (this->Passed < targets.size())
    {
      return false;
    }
    this->Labels.Limit = std::min(this->Labels.Limit, std::nextafter(this->Largest, Infinity));
    return true;
  }

  /// Prefetches the data of vertices further back in the queue. Without prefetching a search is
  /// bound by memory latency.
  template <bool OverFans>
  void LookAhead(std::size_t i) const
  {
    if (const BucketQueue::Entry* entry = this->Queue.LookAhead(i, VertexLookahead))
    {
      if (OverFans)
      {
        Prefetch(&this->Labels.Origins[entry->Vertex]);
        this->Fans->PrefetchVertex(entry->Vertex);
      }
      else
      {
        Prefetch(&this->Graph.Offsets[entry->Vertex]);
      }
    }
    if (const BucketQueue::Entry* entry = this->Queue.LookAhead(i, EdgesLookahead))
    {
      const Id v = entry->Vertex;
      if (OverFans)
      {
        this->Fans->PrefetchFan(
          this->Graph, this->Lengths, v, this->Labels.Origins[v].ArrivalAngle);
      }
      else
      {
        this->PrefetchRow(this->Graph.Offsets[v], this->Graph.Offsets[v + 1]);
      }
    }
  }

  void PrefetchRow(Offset begin, Offset end) const
  {
    // Prefetch only the beginning of a long row; the hardware prefetcher handles the remainder.
    end = std::min<Offset>(end, begin + 96);
    for (Offset e = begin; e < end; e += 16)
    {
      Prefetch(this->Graph.Targets + e);
      Prefetch(this->Lengths + e);
    }
  }

  template <bool OverFans>
  void RelaxFrom(Id v, double label)
  {
    // Local copies, because the compiler cannot exclude aliasing between labels and members.
    const double* const distances = this->Labels.Distances.data();
    LabelOrigin* const origins = this->Labels.Origins.data();
    const Id* const targets = this->Graph.Targets;
    const Length* const lengths = this->Lengths;
    const double limit = this->Labels.Limit;
    std::size_t relaxations = 0;
    const auto relax = [&, v, label, distances, origins, targets, lengths, limit](Offset e) {
      ++relaxations;
      const Id t = targets[e];
      const double distance = label + lengths[e];
      if (distance < distances[t] && distance < limit)
      {
        if (!OverFans)
        {
          this->RemoveChild(t);
        }
        this->Labels.SetDistance(t, distance);
        origins[t] = { e, v, OverFans ? this->Graph.ArrivalAngles[e] : -1.0f };
        this->Queue.Push(distance, t);
      }
      else if (!OverFans && distance == distances[t] && this->Labels.IsPreferred(t, v))
      {
        this->RemoveChild(t);
        origins[t] = { e, v, -1.0f };
      }
    };
    if (OverFans)
    {
      this->Fans->ForEach(v, origins[v].ArrivalAngle, relax);
    }
    else
    {
      for (Offset e = this->Graph.Offsets[v]; e < this->Graph.Offsets[v + 1]; ++e)
      {
        relax(e);
      }
    }
    this->Effort.Relaxations += relaxations;
  }

  /// Checks every edge for a shorter or another shortest path, which few edges give.
  void Certify()
  {
    const Id n = this->Graph.NumberOfVertices;
    if (AreFew(this->Labels.Touched, static_cast<std::size_t>(n)))
    {
      // Most rows end at vertices without a label, so that counting would not save work. Vertices
      // that are reached during the loop are in the queue.
      for (const Id v : std::vector<Id>(this->Labels.Touched))
      {
        if (this->Labels.IsReached(v))
        {
          this->template RelaxFrom<false>(v, this->Labels.Distances[v]);
        }
      }
      return;
    }
    this->CountChildren(this->Labels.Touched);
    // The sequential pass through the arrays is cheaper per edge than any random access.
    for (Id v = 0; v < n; ++v)
    {
      this->CertifyRow(v);
    }
    this->Children = nullptr;
  }

  /// Counts the children of vertices in the tree whose labels are those of their paths. Returns the
  /// vertices, each once.
  std::vector<Id> CountChildren(const std::vector<Id>& vertices)
  {
    std::vector<Id>& children = this->Queue.Children;
    children.resize(static_cast<std::size_t>(this->Graph.NumberOfVertices));
    std::for_each(vertices.begin(), vertices.end(), [&](Id v) { children[v] = NoId; });
    std::vector<Id> once;
    once.reserve(vertices.size());
    for (const Id v : vertices)
    {
      if (children[v] == NoId)
      {
        children[v] = 0;
        once.push_back(v);
      }
    }
    for (const Id v : once)
    {
      // The label of a tail may have dropped since.
      const LabelOrigin& origin = this->Labels.Origins[v];
      const std::vector<double>& distances = this->Labels.Distances;
      if (!origin.IsSeed() && distances[v] == distances[origin.Tail] + this->Lengths[origin.Edge])
      {
        ++children[origin.Tail];
      }
    }
    this->Children = children.data();
    return once;
  }

  /// Called before the label of a vertex is lowered or its tail is replaced.
  void RemoveChild(Id v)
  {
    if (this->Children && this->Labels.Distances[v] < Infinity && !this->Labels.Origins[v].IsSeed())
    {
      --this->Children[this->Labels.Origins[v].Tail];
    }
  }

  void CertifyRow(Id v)
  {
    if (!this->Labels.IsReached(v))
    {
      return;
    }
    const Offset begin = this->Graph.Offsets[v];
    const Offset end = this->Graph.Offsets[v + 1];
    this->Effort.Relaxations += static_cast<std::size_t>(end - begin);
    const double label = this->Labels.Distances[v];
    if (this->CountPaths(label, begin, end) > this->Children[v])
    {
      this->template RelaxFrom<false>(v, label);
    }
  }

  /// Returns the number of edges of a row over which the paths to their ends are not longer than
  /// the labels there. These are the edges to the children, unless there is another shortest path.
  /// Branchless.
  Id CountPaths(double label, Offset begin, Offset end) const
  {
    const double* const distances = this->Labels.Distances.data();
    const Id* const targets = this->Graph.Targets;
    const Length* const lengths = this->Lengths;
    const auto count = [=](Offset e) {
      return distances[targets[e]] >= label + lengths[e] ? 1.0 : 0.0;
    };
    // Sums of doubles in four independent chains take fewer instructions than one integer.
    double sums[4] = {};
    Offset e = begin;
    for (; e + 4 <= end; e += 4)
    {
      for (int k = 0; k < 4; ++k)
      {
        sums[k] += count(e + k);
      }
    }
    for (; e < end; ++e)
    {
      sums[0] += count(e);
    }
    return static_cast<Id>(sums[0] + sums[1] + sums[2] + sums[3]);
  }

  /// Counts vertices, and reports progress periodically. Returns false if aborted.
  bool Report(std::size_t pops)
  {
    this->PopsSinceReport += pops;
    if (this->PopsSinceReport < ProgressInterval)
    {
      return true;
    }
    this->PopsSinceReport = 0;
    return !this->Progress ||
      this->Progress(
        std::min(1.0, static_cast<double>(this->Effort.Pops) / this->Graph.NumberOfVertices));
  }

  const GraphView& Graph;
  const Length* Lengths;
  const GraphFans* Fans;
  const ProgressCallback& Progress;
  BucketQueue& Queue;
  SearchLabels& Labels;
  SearchEffort& Effort;
  std::vector<Id>* Order = nullptr; ///< receives the vertices taken from the queue
  const std::vector<Id>* Targets;   ///< targets that end the search; null: none
  Id* Children = nullptr;           ///< per vertex, children in the tree; null unless certifying
  std::size_t Passed = 0;           ///< number of leading targets with final labels
  double Largest = -Infinity;       ///< largest distance of these
  std::size_t PopsSinceReport = 0;
};
}

bool RunDijkstra(const GraphView& graph, const std::vector<GraphSeed>& seeds,
  const ProgressCallback& progress, MinimumHeap& heap, SearchLabels& labels, SearchEffort& effort)
{
  heap.Clear();
  for (const GraphSeed& seed : seeds)
  {
    if (seed.Distance == labels.Distances[seed.Vertex])
    {
      heap.Push(seed.Distance, seed.Vertex);
    }
  }
  return WithLengths(graph, [&](const auto* lengths) {
    return RunNearestFirst(graph, lengths, progress, heap, labels, effort);
  });
}

bool RunBucketSearch(const GraphView& graph, const GraphFans* fans,
  const std::vector<GraphSeed>& seeds, double width, const ProgressCallback& progress,
  BucketQueue& queue, SearchLabels& labels, SearchEffort& effort)
{
  return WithLengths(graph, [&](const auto* lengths) {
    using Length = std::remove_cv_t<std::remove_pointer_t<decltype(lengths)>>;
    return LabelCorrecting<Length>(graph, lengths, fans, progress, queue, labels, effort)
      .Run(seeds, width);
  });
}

void RunAlongFans(const GraphView& graph, const GraphFans& fans,
  const std::vector<GraphSeed>& seeds, double width, BucketQueue& queue, SearchLabels& labels,
  std::vector<Id>& order)
{
  const ProgressCallback noProgress;
  SearchEffort effort;
  order.clear();
  WithLengths(graph, [&](const auto* lengths) {
    using Length = std::remove_cv_t<std::remove_pointer_t<decltype(lengths)>>;
    LabelCorrecting<Length>(graph, lengths, &fans, noProgress, queue, labels, effort)
      .RunAlongFans(seeds, width, order);
  });
}

bool LowerLabels(const GraphView& graph, const GraphFans* fans, const std::vector<GraphSeed>& seeds,
  double width, const ProgressCallback& progress, BucketQueue& queue, SearchLabels& labels,
  std::vector<Id>& touched)
{
  SearchEffort effort;
  return WithLengths(graph, [&](const auto* lengths) {
    using Length = std::remove_cv_t<std::remove_pointer_t<decltype(lengths)>>;
    return LabelCorrecting<Length>(graph, lengths, fans, progress, queue, labels, effort)
      .RunFromNewSeeds(seeds, width, touched);
  });
}

double ChooseBucketWidth(const GraphView& graph)
{
  // The width is the mean of the shortest edges of some vertices.
  constexpr Id sampleSize = 1000;
  const Id step = std::max<Id>(1, graph.NumberOfVertices / sampleSize);
  double sum = 0.0;
  Id count = 0;
  for (Id v = 0; v < graph.NumberOfVertices; v += step)
  {
    double shortest = Infinity;
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      shortest = std::min(shortest, graph.Length(e));
    }
    if (shortest < Infinity)
    {
      sum += shortest;
      ++count;
    }
  }
  return count == 0 ? 1.0 : sum / count;
}
}
