// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared tools for tests of graph searches.
#ifndef SearchChecks_h
#define SearchChecks_h

#include "GraphChecks.h"

#include "dggGraphSearch.h"
#include "dggSurfaceMesh.h"

namespace dggtest
{
/// A mesh, its graph, and a search in the graph.
class SearchCase
{
public:
  SearchCase(const std::string& name, const TestMesh& mesh, double accuracy,
    dgg::GraphConstruction construction = dgg::GraphConstruction::Guaranteed);

  const std::string& GetName() const { return this->Name; }
  const TestMesh& GetPoints() const { return this->Points; }
  const dgg::SurfaceMesh& GetMesh() const { return this->Mesh; }
  dgg::GraphView GetGraph() const { return this->Graph.View(); }
  const dgg::GraphSearch& GetSearch() const { return *this->Search; }
  /// Returns the search for use before a run.
  dgg::GraphSearch& GetSearch() { return *this->Search; }
  Id GetNumberOfVertices() const { return this->Mesh.GetNumberOfVertices(); }

  /// Runs a search that must succeed. `change` may adjust the options.
  dgg::SearchResult Run(const std::vector<dgg::GraphSeed>& seeds,
    const std::function<void(dgg::SearchOptions&)>& change = nullptr) const;

private:
  std::string Name;
  TestMesh Points;
  dgg::SurfaceMesh Mesh;
  dgg::GeodesicGraph Graph;
  std::unique_ptr<dgg::GraphSearch> Search;
};

/// Returns sound meshes and meshes with defects, at several accuracies and with all constructions.
std::vector<std::unique_ptr<SearchCase>> SearchCases();

dgg::GraphSeed SeedAt(Id vertex, double distance = 0.0, Id source = 0);
/// Returns seeds at random vertices with offsets that may be negative; one vertex occurs twice.
std::vector<dgg::GraphSeed> RandomSeeds(Id numberOfVertices, Id count, std::uint64_t seed);
/// Returns the seeds of an arbitrary surface point, by its links.
std::vector<dgg::GraphSeed> SeedsOf(const dgg::GraphBuilder& builder,
  const dgg::SurfacePoint& point, double accuracy, double offset = 0.0);
/// Returns the graph without directions, like the graph of a point cloud.
dgg::GraphView AsCloud(dgg::GraphView graph);
/// Returns the distances of an independent Dijkstra.
std::vector<double> ReferenceDistances(
  const dgg::GraphView& graph, const std::vector<dgg::GraphSeed>& seeds);

/// Returns the smallest tail of the last edges of all shortest paths to each vertex, given the
/// distances of a search; NoId if no edge ends a shortest path.
std::vector<Id> FindSmallestTails(
  const dgg::GraphView& graph, const std::vector<double>& distances);

/// Expects equal fields.
void ExpectSameDistances(
  const std::vector<double>& expected, const std::vector<double>& actual, const std::string& what);
/// Expects the edges, tails and seeds to form a tree that leads to each vertex at its distance; of
/// several paths, the tree has the one with the smallest tail.
void ExpectConsistentTree(const dgg::GraphView& graph, const std::vector<dgg::GraphSeed>& seeds,
  const dgg::SearchResult& result, const std::string& what);

std::string MethodName(dgg::SearchMethod method);
extern const std::vector<dgg::SearchMethod> AllMethods;
}

#endif
