// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A point cloud under measurement, with the true distances and a graph.
#ifndef MeasuredCloud_h
#define MeasuredCloud_h

#include "BenchmarkMesh.h"        // for MeshRecipe
#include "GeneratedCloud.h"       // for distances in closed form
#include "dggCloudGraphBuilder.h" // for CloudGraph
#include "dggGraphSearch.h"       // for GraphSearch

#include <map>    // for the truth
#include <memory> // for the search
#include <string> // for names
#include <vector> // for points

/// Where points come from.
enum class CloudShape
{
  Square,
  Cylinder,
  Sphere,
  Sheets,   ///< two squares
  Vertices, ///< those of a mesh, without its faces
  Samples   ///< random points of a mesh
};

struct CloudRecipe
{
  std::string Name;
  CloudShape Shape = CloudShape::Sphere;
  int Points = 0;       ///< not for the vertices of a mesh
  double Noise = 0.0;   ///< of a sphere, see RandomSphere()
  double Density = 1.0; ///< of a sphere
  double Gap = 0.0;     ///< between two squares
  /// Distances along it are the truth. Its name shows it from all other meshes.
  MeshRecipe Mesh;
};

/// Which graph of which cloud.
struct CloudGraphRecipe
{
  CloudRecipe Cloud;
  std::string Name; ///< shows the graphs of one cloud apart
  dgg::CloudGraphOptions Options;
  /// When positive: the size of voxels that makes the case what its name says, up to 1 %.
  double VoxelSize = 0.0;
  int Threads = 1;
};

class MeasuredCloud
{
public:
  explicit MeasuredCloud(const CloudRecipe& recipe);

  /// Why the cloud cannot be used; empty when it can.
  const std::string& GetError() const { return this->Error; }
  const std::vector<double>& GetPoints() const { return this->Points; }
  dgg::Id GetSize() const { return static_cast<dgg::Id>(this->Points.size() / 3); }
  dgg::CloudGraphBuilder GetBuilder() const { return { this->Points.data(), this->GetSize() }; }
  /// The k-th of so many fixed sources.
  dgg::Id GetSource(int k, int numberOfSources) const;
  /// Distances along the surface from a point, found once. Empty, with an error, when that fails.
  const std::vector<double>& GetTruth(dgg::Id source);
  /// Of faces of the mesh, those with an edge that is too long to be of the surface.
  std::size_t CountDroppedFaces() const;
  /// Of directed edges of a graph, those between points of different parts of the surface; those
  /// of a mesh are one part.
  std::size_t CountFalseEdges(const dgg::GraphView& graph) const;

  void Build(const CloudGraphRecipe& recipe);
  /// Build the graph unless it is there. Only the last one is kept.
  void NeedGraph(const CloudGraphRecipe& recipe);
  void Clear();
  /// Why there is no graph; empty when there is one.
  const std::string& GetGraphError() const { return this->GraphError; }
  const dgg::CloudGraph& GetGraph() const { return this->Graph; }
  const dgg::CloudGraphStatistics& GetStatistics() const { return this->Statistics; }
  /// The search of the graph, prepared once.
  const dgg::GraphSearch& GetSearch();

private:
  void TakeMesh(const CloudRecipe& recipe);

  std::string Error;
  std::vector<double> Points;
  std::function<double(dgg::Id, dgg::Id)> Distance; ///< empty when the truth is that of a mesh
  MeshRecipe Mesh;
  std::vector<dgg::SurfacePoint> Places; ///< of samples, on the mesh
  std::map<dgg::Id, std::vector<double>> Truth;
  std::string GraphError;
  std::string GraphName;
  dgg::CloudGraph Graph;
  dgg::CloudGraphStatistics Statistics;
  std::unique_ptr<dgg::GraphSearch> Search;
};

/// The cloud of a recipe. Only the last one is kept.
MeasuredCloud& GetMeasuredCloud(const CloudRecipe& recipe);

#endif
