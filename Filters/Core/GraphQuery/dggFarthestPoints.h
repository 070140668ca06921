// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Farthest-point sampling of a surface or a cloud.
#ifndef dggFarthestPoints_h
#define dggFarthestPoints_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggGraphSearch.h" // for GraphSeed

#include <algorithm> // for the heap
#include <memory>    // for the fans
#include <vector>    // for the seeds

namespace dgg
{
class BucketQueue;
class GraphFans;
struct LabelOrigin;

/// The vertex farthest from all samples.
struct FarthestVertex
{
  Id Vertex = NoId;      ///< NoId if every vertex is a sample
  double Distance = 0.0; ///< Infinity if no sample reaches the vertex

  /// Returns true if farthest-point sampling uses this vertex rather than the other one. Ties are
  /// resolved in favor of the smallest vertex id.
  bool IsBefore(const FarthestVertex& other) const
  {
    return this->Distance > other.Distance ||
      (this->Distance == other.Distance && this->Vertex < other.Vertex);
  }
};

/// Finds the farthest of several vertices whose distances never grow.
class FarthestHeap
{
public:
  /// Starts with these vertices at infinite distances.
  void Start(const std::vector<Id>& vertices)
  {
    this->Candidates.clear();
    for (const Id v : vertices)
    {
      this->Candidates.push_back({ v, Infinity });
    }
    std::make_heap(this->Candidates.begin(), this->Candidates.end(), IsAfter);
  }

  /// Returns the farthest vertex; `distanceOf(v)` returns present distances.
  template <typename DistanceOf>
  FarthestVertex Find(const DistanceOf& distanceOf)
  {
    std::vector<FarthestVertex>& candidates = this->Candidates;
    while (!candidates.empty())
    {
      const FarthestVertex top = candidates.front();
      const double distance = distanceOf(top.Vertex);
      if (distance == top.Distance)
      {
        return { distance > 0.0 ? top.Vertex : NoId, std::max(0.0, distance) };
      }
      std::pop_heap(candidates.begin(), candidates.end(), IsAfter);
      candidates.back().Distance = distance;
      std::push_heap(candidates.begin(), candidates.end(), IsAfter);
    }
    return {};
  }

private:
  static bool IsAfter(const FarthestVertex& a, const FarthestVertex& b) { return b.IsBefore(a); }

  /// Heap with upper bounds of distances: a distance is updated only when its entry reaches the
  /// top.
  std::vector<FarthestVertex> Candidates;
};

/// Distances of the vertices of a graph from the nearest sample, for farthest-point sampling.
/// Vertices without edges are ignored.
class SampleDistances
{
public:
  virtual ~SampleDistances() = default;

  /// Removes all samples.
  virtual void Reset() = 0;
  /// Adds a sample: a vertex, or a surface point by its links.
  virtual Status Add(const std::vector<GraphSeed>& sample, const ProgressCallback& progress) = 0;
  /// Finds the vertex farthest from all samples; its distance is the covering radius.
  virtual Status FindFarthest(FarthestVertex& farthest) = 0;
  /// Finds the farthest vertex that a sample reaches. There must be a sample with edges.
  virtual Status FindFarthestReached(FarthestVertex& farthest) = 0;
};

/// Farthest-point sampling in a graph (Eldar, Lindenbaum, Porat and Zeevi, "The farthest point
/// strategy for progressive image sampling", 1997). The distance of every vertex from the nearest
/// sample is maintained. A new sample only visits the vertices that are nearer to the new sample
/// than to all other samples.
///
/// The farthest distance, the covering radius, never grows. Samples that are placed successively at
/// the farthest vertex are at least the covering radius apart. Vertices that no sample reaches
/// count as infinitely far, so that every component gets a sample before any component gets a
/// second one. Vertices without edges are ignored. Ties are resolved in favor of the smallest
/// vertex id.
class DGG_CORE_EXPORT FarthestPoints final : public SampleDistances
{
public:
  /// Prepares sampling of a graph. `mesh` is the mesh of the graph, or null for a cloud. Graph and
  /// mesh must outlive the object.
  FarthestPoints(const GraphView& graph, const SurfaceMesh* mesh);
  ~FarthestPoints() override;
  FarthestPoints(const FarthestPoints&) = delete;
  FarthestPoints& operator=(const FarthestPoints&) = delete;

  void Reset() override;
  /// Fails, without changing anything, if there is no seed, or if a seed does not exist or has an
  /// initial distance that is not finite. After an abort, call Reset().
  Status Add(const std::vector<GraphSeed>& sample, const ProgressCallback& progress) override;
  Status FindFarthest(FarthestVertex& farthest) override;
  Status FindFarthestReached(FarthestVertex& farthest) override;

  /// Returns the result of FindFarthest(), which cannot fail here.
  FarthestVertex Find();

  /// Returns the graph distance of every vertex from the nearest sample.
  const std::vector<double>& GetDistances() const { return this->Distances; }
  /// Returns the index of the nearest sample of every vertex, in order of insertion; NoId if
  /// unreached.
  const std::vector<Id>& GetNearestSamples() const { return this->NearestSamples; }

private:
  const GraphView Graph;
  const double BucketWidth;
  std::vector<double> Distances;
  std::vector<LabelOrigin> Origins;
  std::unique_ptr<GraphFans> Fans; // null if the graph has no angles
  std::unique_ptr<BucketQueue> Queue;
  std::vector<Id> Touched;        // vertices labeled by the last sample; may contain duplicates
  std::vector<Id> Labeled;        // vertices labeled by any sample, without duplicates
  std::vector<Id> NearestSamples; // per vertex
  Id NumberOfSamples = 0;
  FarthestHeap Candidates; // all vertices with edges
};
}

#endif
