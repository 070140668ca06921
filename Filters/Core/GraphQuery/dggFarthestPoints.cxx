// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFarthestPoints.h"

#include "dggBucketSearch.h"
#include "dggGraphSearch.h"

#include <algorithm>

namespace dgg
{
FarthestPoints::FarthestPoints(const GraphView& graph, const SurfaceMesh* mesh)
  : Graph(graph)
  , BucketWidth(ChooseBucketWidth(graph))
  , Queue(std::make_unique<BucketQueue>())
{
  if (mesh && graph.Angles && graph.ArrivalAngles)
  {
    this->Fans = std::make_unique<GraphFans>(this->Graph, *mesh);
  }
  this->Reset();
}

FarthestPoints::~FarthestPoints() = default;

/// Heap order: returns true if `a` comes after `b`.
bool FarthestPoints::IsNearer(const Candidate& a, const Candidate& b)
{
  return a.Distance < b.Distance || (a.Distance == b.Distance && a.Vertex > b.Vertex);
}

void FarthestPoints::Reset()
{
  SearchLabels(this->Distances, this->Origins, this->Labeled, Infinity)
    .Start(this->Graph.NumberOfVertices, {});
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

Status FarthestPoints::Add(const std::vector<GraphSeed>& sample, const ProgressCallback& progress)
{
  SearchLabels labels(this->Distances, this->Origins, this->Labeled, Infinity);
  DGG_RETURN_IF_ERROR(CheckSeeds(sample, this->Graph.NumberOfVertices));
  if (!LowerLabels(this->Graph, this->Fans.get(), sample, this->BucketWidth, progress, *this->Queue,
        labels, this->Touched))
  {
    return Status::Abort();
  }
  for (const Id v : this->Touched)
  {
    this->NearestSamples[v] = this->NumberOfSamples;
  }
  ++this->NumberOfSamples;
  return Status::Success();
}

FarthestVertex FarthestPoints::Find()
{
  std::vector<Candidate>& candidates = this->Candidates;
  while (!candidates.empty())
  {
    const Candidate top = candidates.front();
    const double distance = this->Distances[top.Vertex];
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
}
