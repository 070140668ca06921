// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Farthest-point sampling of a surface or a cloud.
#ifndef dggFarthestPoints_h
#define dggFarthestPoints_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggGraphSearch.h" // for GraphSeed

#include <memory> // for the fans
#include <vector> // for the seeds

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
class DGG_CORE_EXPORT FarthestPoints
{
public:
  /// Prepares sampling of a graph. `mesh` is the mesh of the graph, or null for a cloud. Graph and
  /// mesh must outlive the object.
  FarthestPoints(const GraphView& graph, const SurfaceMesh* mesh);
  ~FarthestPoints();
  FarthestPoints(const FarthestPoints&) = delete;
  FarthestPoints& operator=(const FarthestPoints&) = delete;

  /// Removes all samples.
  void Reset();

  /// Adds a sample: a vertex, or a surface point by its links. Fails, without changing anything, if
  /// there is no seed, or if a seed does not exist or has an initial distance that is not finite.
  /// After an abort, call Reset().
  Status Add(const std::vector<GraphSeed>& sample, const ProgressCallback& progress);

  /// Returns the vertex farthest from all samples; its distance is the covering radius.
  FarthestVertex Find();

  /// Returns the graph distance of every vertex from the nearest sample.
  const std::vector<double>& GetDistances() const { return this->Distances; }
  /// Returns the index of the nearest sample of every vertex, in order of insertion; NoId if
  /// unreached.
  const std::vector<Id>& GetNearestSamples() const { return this->NearestSamples; }

private:
  /// A vertex and an upper bound of its distance: the distance at the time of insertion.
  struct Candidate
  {
    double Distance;
    Id Vertex;
  };
  static bool IsNearer(const Candidate& a, const Candidate& b);

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
  /// Heap of all vertices with edges. A distance in the heap is updated only when its entry reaches
  /// the top.
  std::vector<Candidate> Candidates;
};
}

#endif
