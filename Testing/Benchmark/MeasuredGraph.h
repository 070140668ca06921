// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A graph under measurement.
#ifndef MeasuredGraph_h
#define MeasuredGraph_h

#include "dggGraphBuilder.h" // for GraphBuilder
#include "dggGraphSearch.h"  // for GraphSearch

#include <memory> // for the search
#include <string> // for the error

class MeasuredGraph
{
public:
  /// The mesh must outlive the graph. Nothing is built yet.
  MeasuredGraph(const dgg::SurfaceMesh& surface, const dgg::GraphOptions& options);

  /// Build the graph, the builder's tables included.
  void Build(const dgg::ParallelFor& parallel);
  /// Build the graph if that has not been done.
  void NeedGraph();
  /// Free it.
  void Clear();

  /// Prepare a new search: what comes between a graph and its first query.
  void PrepareSearch();
  /// The search of the graph, prepared once.
  const dgg::GraphSearch& GetSearch();
  /// Have that search prepare landmarks, once.
  void NeedLandmarks();
  /// The builder that links points to the graph, prepared once.
  const dgg::GraphBuilder& GetBuilder();

  /// Why there is no graph; empty when there is one.
  const std::string& GetError() const { return this->Error; }
  const dgg::GraphOptions& GetOptions() const { return this->Options; }
  const dgg::GeodesicGraph& GetGraph() const { return this->Graph; }
  const dgg::GraphStatistics& GetStatistics() const { return this->Statistics; }
  /// Edges that leave a vertex: mean and standard deviation.
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
