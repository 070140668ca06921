// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Samples of a surface or a cloud, each as far as possible from those before.
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

/// The vertex that is farthest from all samples.
struct FarthestVertex
{
  Id Vertex = NoId;      ///< NoId when every vertex is a sample
  double Distance = 0.0; ///< Infinity where no sample reaches
};

/// Farthest point sampling in a graph (Eldar, Lindenbaum, Porat and Zeevi, "The farthest point
/// strategy for progressive image sampling", 1997). Keeps the distance of every vertex from the
/// nearest sample; a new sample only touches the vertices that are nearer to it than to all others.
///
/// The farthest distance, the covering radius, never grows, and samples taken one after the other
/// where it is are at least that far from each other. Vertices that no sample reaches count as
/// infinitely far, so that every component gets a sample before any gets a second one. Vertices
/// without edges are left out. Of vertices at the same distance the one with the smallest id is the
/// farthest.
class DGG_CORE_EXPORT FarthestPoints
{
public:
  /// `mesh` is that of the graph, or null for a cloud. Graph and mesh must outlive the object.
  FarthestPoints(const GraphView& graph, const SurfaceMesh* mesh);
  ~FarthestPoints();
  FarthestPoints(const FarthestPoints&) = delete;
  FarthestPoints& operator=(const FarthestPoints&) = delete;

  /// Forget all samples.
  void Reset();

  /// Add a sample: a vertex, or a surface point by its links. Fails when there is no seed, or one
  /// does not exist or starts with a distance that is not finite; then nothing changes. After an
  /// abort, call Reset().
  Status Add(const std::vector<GraphSeed>& sample, const ProgressCallback& progress);

  /// The vertex farthest from all samples, and so the covering radius.
  FarthestVertex Find();

  /// Distance of every vertex from the nearest sample, along the graph.
  const std::vector<double>& GetDistances() const { return this->Distances; }
  /// The nearest sample of every vertex, numbered as they were added; NoId where none reaches.
  const std::vector<Id>& GetNearestSamples() const { return this->NearestSamples; }

private:
  /// A vertex and its distance when it was entered: later it is at most that.
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
  std::unique_ptr<GraphFans> Fans; // null where there are no angles
  std::unique_ptr<BucketQueue> Queue;
  std::vector<Id> Touched;        // by the last sample, a few more than once
  std::vector<Id> Labeled;        // by any sample, each once
  std::vector<Id> NearestSamples; // per vertex
  Id NumberOfSamples = 0;
  /// All vertices with edges, a heap. Distances in it are not lowered with the labels, but when
  /// they come to the top.
  std::vector<Candidate> Candidates;
};
}

#endif
