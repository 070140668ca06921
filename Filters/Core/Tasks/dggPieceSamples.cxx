// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceSamples.h"

#include "dggFarthestPoints.h"
#include "dggPieceLinks.h"
#include "dggPieceSearch.h"
#include "dggPieceSurface.h"
#include "dggSampleSearch.h"
#include "dggSourceCollection.h"
#include "dggTaskContext.h"

#include <numeric>
#include <vector>

namespace dgg
{
namespace
{
/// Distances from samples in the graph of all pieces. Vertices are indices of points in the
/// order of their global ids.
class PieceFarthestPoints : public SampleDistances
{
public:
  PieceFarthestPoints(ProcessGroup& group, PieceSearch& search)
    : Group(group)
    , Search(search)
    , Connected(search.ListConnected())
  {
    this->PieceFarthestPoints::Reset();
  }

  void Reset() override
  {
    this->Search.ClearLabels();
    std::vector<Id> indices(this->Connected.size());
    std::iota(indices.begin(), indices.end(), 0);
    this->Candidates.Start(indices);
  }

  Status Add(const std::vector<GraphSeed>& sample, const ProgressCallback&) override
  {
    std::vector<PieceSeed> seeds;
    for (const GraphSeed& seed : sample)
    {
      seeds.push_back({ this->Search.GetFirstId() + seed.Vertex, seed });
    }
    return this->Search.AddSeeds(this->Group, seeds);
  }

  Status FindFarthest(FarthestVertex& farthest) override
  {
    return this->Choose(
      this->Candidates.Find([this](Id i) { return this->GetDistance(i); }), farthest);
  }

  Status FindFarthestReached(FarthestVertex& farthest) override
  {
    FarthestVertex here;
    for (Id i = 0; i < static_cast<Id>(this->Connected.size()); ++i)
    {
      const FarthestVertex reached{ i, this->GetDistance(i) };
      if (reached.Distance < Infinity && (here.Vertex == NoId || reached.IsBefore(here)))
      {
        here = reached;
      }
    }
    return this->Choose(here, farthest);
  }

private:
  double GetDistance(Id index) const { return this->Search.GetLabels()[this->Connected[index]]; }

  /// Chooses the farthest vertex of all processes; that of this process is given by its index.
  Status Choose(FarthestVertex here, FarthestVertex& farthest)
  {
    if (here.Vertex != NoId)
    {
      const Offset id = this->Search.GetIds()[this->Connected[here.Vertex]];
      here.Vertex = static_cast<Id>(id - this->Search.GetFirstId());
    }
    std::vector<FarthestVertex> all;
    DGG_RETURN_IF_ERROR(this->Group.Share(here, all));
    farthest = FarthestVertex();
    for (const FarthestVertex& other : all)
    {
      const bool isBefore = farthest.Vertex == NoId || other.IsBefore(farthest);
      farthest = other.Vertex != NoId && isBefore ? other : farthest;
    }
    return Status::Success();
  }

  ProcessGroup& Group;
  PieceSearch& Search;
  const std::vector<Id> Connected; // vertices of Search in the order of their numbers
  FarthestHeap Candidates;         // indices into Connected
};
}

Status FindPieceSamples(const TaskContext& context, ProcessGroup& group,
  const PieceSurface& surface, PieceSearch& search, PieceLinks* links, double accuracy,
  const SourceCollection& start, const PieceSampleOptions& options, Output& output)
{
  SamplerOptions sampling;
  sampling.NumberOfSamples = options.NumberOfSamples;
  sampling.CoveringRadius = options.CoveringRadius;
  sampling.Progress = context.Progress;
  std::vector<std::vector<GraphSeed>> given(start.GetNumberOfPositions());
  PiecePoints here; // samples of this process
  if (start.IsConnected)
  {
    std::vector<PieceSeed> seeds;
    DGG_RETURN_IF_ERROR(start.Check(search.GetNumberOfPoints()));
    DGG_RETURN_IF_ERROR(links->Find(group, start, options.Tolerance, accuracy, seeds));
    for (PieceSeed& seed : seeds)
    {
      seed.Seed.Vertex = static_cast<Id>(seed.PointId - search.GetFirstId());
      given[seed.Seed.Source].push_back(seed.Seed);
    }
    DGG_RETURN_IF_ERROR(surface.Locate(group, start, options.Tolerance, here));
  }
  else
  {
    DGG_RETURN_IF_ERROR(CheckFirstSample(options.FirstSample, search.GetNumberOfPoints()));
    sampling.FirstVertex = static_cast<Id>(options.FirstSample);
  }
  sampling.Given.resize(given.size());
  std::vector<SurfaceSample> samples;
  PieceFarthestPoints points(group, search);
  DGG_RETURN_IF_ERROR(SampleVertices(points, given, sampling, samples));
  for (std::size_t i = given.size(); i < samples.size(); ++i)
  {
    surface.AddVertex(samples[i].Point.Vertex, i, group.Here, here);
  }
  DGG_RETURN_IF_ERROR(surface.WritePoints(context, group, here, output));
  if (group.Here == 0)
  {
    DescribeSamples(sampling, samples, false, output);
  }
  return Status::Success();
}
}
