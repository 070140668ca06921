// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graph of a benchmark.
#ifndef MeasuredGraph_h
#define MeasuredGraph_h

#include "dggGraphBuilder.h" // for GraphBuilder
#include "dggGraphSearch.h"  // for GraphSearch

#include <memory> // for the search
#include <string> // for the error

class MeasuredGraph
{
public:
  /// The mesh must outlive the graph. The graph is not built yet.
  MeasuredGraph(const dgg::SurfaceMesh& surface, const dgg::GraphOptions& options);

  /// Builds the graph, including the tables of the builder.
  void Build(const dgg::ParallelFor& parallel);
  /// Builds the graph unless it has been built.
  void NeedGraph();
  /// Releases the graph.
  void Clear();

  /// Prepares a new search: all steps between a build and the first query.
  void PrepareSearch();
  /// Returns the search of the graph, prepared once.
  const dgg::GraphSearch& GetSearch();
  /// Prepares landmarks of the search, once.
  void NeedLandmarks();
  /// Returns the builder that links points to the graph, prepared once.
  const dgg::GraphBuilder& GetBuilder();

  /// Returns the reason why there is no graph; empty if there is one.
  const std::string& GetError() const { return this->Error; }
  const dgg::GraphOptions& GetOptions() const { return this->Options; }
  const dgg::GeodesicGraph& GetGraph() const { return this->Graph; }
  const dgg::GraphStatistics& GetStatistics() const { return this->Statistics; }
  /// Computes mean and standard deviation of the number of outgoing edges per vertex.
  void GetDegree(double& mean, double& deviation) const;

private:
  const dgg::SurfaceMesh& Surface;
  dgg::GraphOptions Options;
  std::string Error;
  dgg::GeodesicGraph Graph;
  dgg::GraphStatistics Statistics;
  std::unique_ptr<dgg::GraphSearch> Search;
  std::unique_ptr<dgg::GraphBuilder> Builder;
};

#endif
