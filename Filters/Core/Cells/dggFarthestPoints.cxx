// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFarthestPoints.h"

#include "dggBucketSearch.h"
#include "dggGraphSearch.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// A vertex and its distance when it was entered: later it is at most that.
struct Candidate
{
  double Distance;
  Id Vertex;
};

/// Whether `a` comes after `b`.
bool IsNearer(const Candidate& a, const Candidate& b)
{
  return a.Distance < b.Distance || (a.Distance == b.Distance && a.Vertex > b.Vertex);
}
}

class FarthestPoints::Implementation
{
public:
  Implementation(const GraphView& graph, const SurfaceMesh* mesh)
    : Graph(graph)
    , BucketWidth(ChooseBucketWidth(graph))
    , Labels(Distances, Origins, Infinity)
  {
    if (mesh && graph.Angles && graph.ArrivalAngles)
    {
      this->Fans = std::make_unique<GraphFans>(this->Graph, *mesh);
    }
  }

  void Reset()
  {
    this->Labels.Start(this->Graph.NumberOfVertices, {});
    this->NearestSamples.assign(this->Graph.NumberOfVertices, NoId);
    this->NumberOfSamples = 0;
    this->Candidates.clear();
    for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
    {
      if (this->Graph.Offsets[v] < this->Graph.Offsets[v + 1])
      {
        this->Candidates.push_back({ Infinity, v });
      }
    }
    std::make_heap(this->Candidates.begin(), this->Candidates.end(), IsNearer);
  }

  GraphView Graph;
  double BucketWidth;
  std::vector<double> Distances;
  std::vector<LabelOrigin> Origins;
  SearchLabels Labels;
  std::unique_ptr<GraphFans> Fans; ///< null where there are no angles
  BucketQueue Queue;
  std::vector<Id> Touched;
  std::vector<Id> NearestSamples; ///< per vertex
  Id NumberOfSamples = 0;
  /// All vertices with edges, a heap. Distances in it are not lowered with the labels, but when
  /// they come to the top.
  std::vector<Candidate> Candidates;
};

FarthestPoints::FarthestPoints(const GraphView& graph, const SurfaceMesh* mesh)
  : Internals(std::make_unique<Implementation>(graph, mesh))
{
  this->Internals->Reset();
}

FarthestPoints::~FarthestPoints() = default;

void FarthestPoints::Reset()
{
  this->Internals->Reset();
}

Status FarthestPoints::Add(const std::vector<GraphSeed>& sample, const ProgressCallback& progress)
{
  Implementation& internals = *this->Internals;
  Status status = CheckSeeds(sample, internals.Graph.NumberOfVertices);
  if (status.IsOk() &&
    !LowerLabels(internals.Graph, internals.Fans.get(), sample, internals.BucketWidth, progress,
      internals.Queue, internals.Labels, internals.Touched))
  {
    status = Status::Abort();
  }
  if (status.IsOk())
  {
    for (const Id v : internals.Touched)
    {
      internals.NearestSamples[v] = internals.NumberOfSamples;
    }
    ++internals.NumberOfSamples;
  }
  return status;
}

FarthestVertex FarthestPoints::Find()
{
  std::vector<Candidate>& candidates = this->Internals->Candidates;
  while (!candidates.empty())
  {
    const Candidate top = candidates.front();
    const double distance = this->Internals->Distances[top.Vertex];
    if (distance == top.Distance)
    {
      return { distance > 0.0 ? top.Vertex : NoId, std::max(0.0, distance) };
    }
    std::pop_heap(candidates.begin(), candidates.end(), IsNearer);
    candidates.back().Distance = distance;
    std::push_heap(candidates.begin(), candidates.end(), IsNearer);
  }
  return {};
}

const std::vector<double>& FarthestPoints::GetDistances() const
{
  return this->Internals->Distances;
}

const std::vector<Id>& FarthestPoints::GetNearestSamples() const
{
  return this->Internals->NearestSamples;
}
}
