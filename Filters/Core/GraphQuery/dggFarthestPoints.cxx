// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFarthestPoints.h"

#include "dggBucketSearch.h"
#include "dggGraphSearch.h"

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

void FarthestPoints::Reset()
{
  SearchLabels(this->Distances, this->Origins, this->Labeled, Infinity)
    .Start(this->Graph.NumberOfVertices, {});
  this->NearestSamples.assign(this->Graph.NumberOfVertices, NoId);
  this->NumberOfSamples = 0;
  std::vector<Id> candidates;
  for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
  {
    if (this->Graph.Offsets[v] < this->Graph.Offsets[v + 1])
    {
      candidates.push_back(v);
    }
  }
  this->Candidates.Start(candidates);
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
  return this->Candidates.Find([this](Id v) { return this->Distances[v]; });
}

Status FarthestPoints::FindFarthest(FarthestVertex& farthest)
{
  farthest = this->Find();
  return Status::Success();
}

Status FarthestPoints::FindFarthestReached(FarthestVertex& farthest)
{
  farthest = FarthestVertex();
  for (const Id v : this->Labeled)
  {
    const FarthestVertex reached{ v, this->Distances[v] };
    farthest = farthest.Vertex == NoId || reached.IsBefore(farthest) ? reached : farthest;
  }
  return Status::Success();
}
}
