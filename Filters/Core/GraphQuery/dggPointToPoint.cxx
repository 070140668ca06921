// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPointToPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dgg
{
namespace
{
/// Width of the buckets relative to a search without a goal. Along a path to the goal, the sum of
/// label and bound hardly grows; in wide buckets vertices would be expanded many times.
constexpr double WidthShare = 0.02;
/// Relative rounding error of the length of a path compared to a straight line.
constexpr double StraightMargin = 1e-9;
/// Number of queue entries by which labels, and edges, are prefetched.
constexpr std::size_t VertexLookahead = 12;
constexpr std::size_t EdgesLookahead = 6;

double StraightLength(const double* p, const double* q)
{
  const double x = p[0] - q[0];
  const double y = p[1] - q[1];
  const double z = p[2] - q[2];
  return std::sqrt(x * x + y * y + z * z);
}
}

PointToPoint::PointToPoint(Id numberOfVertices)
  : Distances(numberOfVertices, Infinity)
  , Labels(numberOfVertices)
{
}

void PointToPoint::Run(const GraphView& graph, const PathGuides& guides,
  const std::vector<GraphSeed>& from, const std::vector<GraphSeed>& to, GraphPath& path)
{
  this->Forget();
  this->Guides = guides;
  this->Aim(to);
  this->Start(from);
  WithLengths(graph, [&](const auto* lengths) {
    this->Search(graph, lengths);
    this->CollectPath(graph, lengths, from, path);
  });
}

void PointToPoint::Forget()
{
  for (Id v : this->Touched)
  {
    this->Distances[v] = Infinity;
    this->Labels[v] = Label();
  }
  this->Touched.clear();
  this->Best = Infinity;
  this->End = NoId;
}

void PointToPoint::Aim(const std::vector<GraphSeed>& to)
{
  this->To = &to;
  this->SmallestToGo = Infinity;
  for (std::size_t i = 0; i < to.size(); ++i)
  {
    this->SmallestToGo = std::min(this->SmallestToGo, to[i].Distance);
    Label& label = this->Labels[to[i].Vertex];
    if (label.Goal == NoId)
    {
      this->Touched.push_back(to[i].Vertex);
    }
    if (label.Goal == NoId || to[i].Distance < to[label.Goal].Distance)
    {
      label.Goal = static_cast<Id>(i);
    }
  }
  if (this->Guides.Marks)
  {
    this->Guides.Marks->Aim(to, this->MarksGoal);
  }
  if (!this->Guides.Positions)
  {
    return;
  }
  // Approximate position of the point whose links are the seeds. Any point would be valid: its
  // straight-line distance yields a lower bound for each seed.
  double center[3] = {};
  double sum = 0.0;
  const double tiny = 1e-3 * this->Guides.BucketWidth;
  for (const GraphSeed& seed : to)
  {
    const double* p = this->Guides.Positions + 3 * static_cast<std::size_t>(seed.Vertex);
    const double length = tiny + std::max(0.0, seed.Distance - seed.InitialDistance);
    const double weight = 1.0 / (length * length);
    sum += weight;
    for (int k = 0; k < 3; ++k)
    {
      center[k] += weight * p[k];
    }
  }
  this->CenterToGo = Infinity;
  for (int k = 0; k < 3; ++k)
  {
    this->Center[k] = center[k] / sum;
  }
  for (const GraphSeed& seed : to)
  {
    const double* p = this->Guides.Positions + 3 * static_cast<std::size_t>(seed.Vertex);
    this->CenterToGo = std::min(this->CenterToGo, seed.Distance - StraightLength(p, this->Center));
  }
}

double PointToPoint::EstimateToGo(Id v) const
{
  double bound = this->SmallestToGo;
  if (this->Guides.Marks)
  {
    bound = std::max(bound, this->Guides.Marks->Bound(v, this->MarksGoal));
  }
  if (this->Guides.Positions)
  {
    const double* p = this->Guides.Positions + 3 * static_cast<std::size_t>(v);
    bound =
      std::max(bound, this->CenterToGo + (1.0 - StraightMargin) * StraightLength(p, this->Center));
  }
  return bound;
}

void PointToPoint::Start(const std::vector<GraphSeed>& from)
{
  double nearest = Infinity;
  for (const GraphSeed& seed : from)
  {
    nearest = std::min(nearest, seed.Distance + this->EstimateToGo(seed.Vertex));
  }
  this->Queue.Reset(nearest, WidthShare * this->Guides.BucketWidth);
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const Id v = from[i].Vertex;
    const auto isGoal = [&](const GraphSeed& seed) {
      return !this->Guides.Marks || this->Guides.Marks->AreConnected(v, seed.Vertex);
    };
    if (from[i].Distance < this->Distances[v] &&
      std::any_of(this->To->begin(), this->To->end(), isGoal))
    {
      if (Label* label = this->Lower(v, from[i].Distance))
      {
        label->Tail = static_cast<Id>(i);
        label->Edge = -1;
        label->ArrivalAngle = -1.0f;
      }
    }
  }
}

PointToPoint::Label* PointToPoint::Lower(Id v, double distance)
{
  Label& label = this->Labels[v];
  if (label.ToGo == -Infinity)
  {
    label.ToGo = this->EstimateToGo(v);
    this->Touched.push_back(v);
  }
  // The distance is also stored if the vertex is too far away, so that the vertex is not examined
  // again.
  this->Distances[v] = distance;
  const double through = distance + label.ToGo;
  if (through >= this->Best)
  {
    return nullptr;
  }
  this->Queue.Push(through, v);
  if (label.Goal != NoId)
  {
    const double length = distance + (*this->To)[label.Goal].Distance;
    if (length < this->Best)
    {
      this->Best = length;
      this->End = v;
    }
  }
  return &label;
}

template <typename Length>
void PointToPoint::Search(const GraphView& graph, const Length* lengths)
{
  const auto isOutdated = [this](const BucketQueue::Entry& entry) {
    const double through = this->Distances[entry.Vertex] + this->Labels[entry.Vertex].ToGo;
    return through >= this->Best || entry.Key > this->Queue.Key(through);
  };
  const auto isPast = [this](const BucketQueue::Entry& entry) {
    return entry.Key > this->Queue.Key(this->Best);
  };
  while (this->Queue.Advance())
  {
    // The bucket grows during the loop.
    const std::vector<BucketQueue::Entry>& bucket = this->Queue.Current();
    if (std::all_of(bucket.begin(), bucket.end(), isPast)) // and so are all later buckets
    {
      return;
    }
    this->Queue.Sift(isOutdated);
    for (std::size_t i = 0; i < std::min(bucket.size(), EdgesLookahead); ++i)
    {
      this->PrefetchEdges(graph, lengths, bucket[i].Vertex);
    }
    for (std::size_t i = 0; i < bucket.size(); ++i)
    {
      if (i + EdgesLookahead < bucket.size())
      {
        this->PrefetchEdges(graph, lengths, bucket[i + EdgesLookahead].Vertex);
      }
      if (const BucketQueue::Entry* next = this->Queue.LookAhead(i, VertexLookahead))
      {
        Prefetch(&this->Distances[next->Vertex]);
        Prefetch(&this->Labels[next->Vertex]);
      }
      const BucketQueue::Entry entry = bucket[i];
      if (!isOutdated(entry))
      {
        this->Expand(graph, lengths, entry.Vertex);
      }
    }
    this->Queue.ClearCurrent();
  }
}

template <typename Length>
void PointToPoint::PrefetchEdges(const GraphView& graph, const Length* lengths, Id v) const
{
  if (this->Guides.Limits)
  {
    this->Guides.Fans->PrefetchFan(graph, lengths, v, this->Labels[v].ArrivalAngle);
    return;
  }
  for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; e += 16)
  {
    Prefetch(graph.Targets + e);
    Prefetch(lengths + e);
  }
}

template <typename Length>
void PointToPoint::Expand(const GraphView& graph, const Length* lengths, Id v)
{
  const double distance = this->Distances[v];
  const Label& label = this->Labels[v];
  const double* const distances = this->Distances.data();
  const Id* const targets = graph.Targets;
  this->Shorter.clear();
  const auto relax = [&, distance, distances, targets, lengths](Offset e) {
    const Id t = targets[e];
    if (distance + lengths[e] < distances[t])
    {
      this->Shorter.push_back(e);
      Prefetch(&this->Labels[t]);
      if (distances[t] == Infinity)
      {
        this->PrefetchGuides(t);
      }
    }
  };
  const bool hasLimits = this->Guides.Limits != nullptr;
  if (hasLimits && label.ArrivalAngle >= 0.0f)
  {
    const float angle = this->Guides.Limits->SmallestAngle(v, label.ArrivalLength);
    this->Guides.Fans->ForEachBeyond(v, label.ArrivalAngle, angle, relax);
  }
  else
  {
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      relax(e);
    }
  }
  for (const Offset e : this->Shorter)
  {
    const double longer = distance + lengths[e];
    // The second comparison handles two edges to the same target.
    Label* next = longer < distances[targets[e]] ? this->Lower(targets[e], longer) : nullptr;
    if (next)
    {
      next->Edge = e;
      next->Tail = v;
      next->ArrivalAngle = hasLimits ? graph.ArrivalAngles[e] : -1.0f;
      next->ArrivalLength = static_cast<float>(lengths[e]);
    }
  }
}

void PointToPoint::PrefetchGuides(Id v) const
{
  if (this->Guides.Marks)
  {
    this->Guides.Marks->PrefetchVertex(v);
  }
  if (this->Guides.Positions)
  {
    Prefetch(this->Guides.Positions + 3 * static_cast<std::size_t>(v));
  }
  if (this->Guides.Limits)
  {
    this->Guides.Fans->PrefetchVertex(v);
    this->Guides.Limits->PrefetchVertex(v);
  }
}

template <typename Length>
Offset PointToPoint::FindEdgeTo(const GraphView& graph, const Length* lengths, Id v, Id& tail) const
{
  const auto isOver = [&](Id t, Offset e) {
    return this->Distances[t] < this->Distances[v] &&
      this->Distances[t] + lengths[e] == this->Distances[v];
  };
  Offset edge = -1;
  tail = std::numeric_limits<Id>::max();
  for (Offset back = graph.Offsets[v]; back < graph.Offsets[v + 1]; ++back)
  {
    const Id t = graph.Targets[back];
    for (Offset e = graph.Offsets[t]; t < tail && isOver(t, back) && e < graph.Offsets[t + 1]; ++e)
    {
      if (graph.Targets[e] == v && isOver(t, e))
      {
        edge = e;
        tail = t;
      }
    }
  }
  return edge;
}

/// Collects the shortest path. Of equally short paths, the path ends at the seed with the smallest
/// vertex, and its tails are those of the tree of a search (SearchLabels::IsPreferred()), so that
/// the path does not depend on the guides.
template <typename Length>
void PointToPoint::CollectPath(const GraphView& graph, const Length* lengths,
  const std::vector<GraphSeed>& from, GraphPath& path)
{
  path = GraphPath();
  path.Length = this->Best;
  if (this->End == NoId)
  {
    return;
  }
  Id end = this->End;
  for (const GraphSeed& seed : *this->To)
  {
    const bool isReached = this->Distances[seed.Vertex] + seed.Distance == this->Best;
    end = isReached ? std::min(end, seed.Vertex) : end;
  }
  Id v = end;
  const auto isSeed = [&](const GraphSeed& seed) {
    return seed.Vertex == v && seed.Distance == this->Distances[v];
  };
  path.Vertices.push_back(v);
  auto seed = from.begin();
  // Without a reverse edge, or if a path absorbs the length of an edge, the labels give the path.
  bool usesRows = true;
  while ((seed = std::find_if(from.begin(), from.end(), isSeed)) == from.end())
  {
    Id tail = this->Labels[v].Tail;
    const Offset edge = usesRows ? this->FindEdgeTo(graph, lengths, v, tail) : this->Labels[v].Edge;
    if (edge < 0 && usesRows)
    {
      usesRows = false;
      v = end = this->End;
      path.Edges.clear();
      path.Vertices.assign(1, v);
      continue;
    }
    v = tail;
    path.Edges.push_back(edge);
    path.Vertices.push_back(v);
  }
  path.ToSeed = this->Labels[end].Goal;
  path.FromSeed = static_cast<Id>(seed - from.begin());
  std::reverse(path.Vertices.begin(), path.Vertices.end());
  std::reverse(path.Edges.begin(), path.Edges.end());
}
}
