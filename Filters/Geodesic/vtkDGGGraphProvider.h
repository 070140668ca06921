// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The graph that a filter searches. Internal.
#ifndef vtkDGGGraphProvider_h
#define vtkDGGGraphProvider_h

#include "vtkDGGGraphArrays.h" // for the graph on the input

#include "dggExactGeodesics.h" // for GeodesicSource
#include "dggGraphBuilder.h"   // for GraphBuilder
#include "dggGraphSearch.h"    // for GraphSearch

#include "vtkTimeStamp.h" // for the build time

#include <memory> // for what is made on demand
#include <vector> // for seeds

class vtkDGGMeshAdapter;
class vtkObject;
class vtkPolyData;

/// What a filter asks for.
struct vtkDGGGraphRequest
{
  vtkPolyData* Input;
  const vtkDGGMeshAdapter& Mesh;  ///< of the input; must outlive the provider
  double Accuracy;                ///< of a graph that is built
  bool IsAccuracyExplicit;        ///< whether the user has asked for this accuracy
  vtkTypeUInt64 MemoryLimit;      ///< bytes; 0 for the default
  dgg::ProgressCallback Progress; ///< of the whole update of the filter
  vtkObject* Filter;              ///< that warns
};

/// Finds the graph on the input of a filter, or else builds one and keeps it until the mesh or the
/// accuracy changes. All filters that search a graph get it from here.
class vtkDGGGraphProvider
{
public:
  /// Provide a graph. When it fails there is none. Warns about a graph on the input that cannot be
  /// used, or is not as accurate as the user wants it: once for each.
  dgg::Status Update(const vtkDGGGraphRequest& request);

  /// The rest of the progress: where the filter goes on after the last update.
  dgg::ProgressCallback GetRemainingProgress() const;

  /// Whether there is a graph.
  bool HasGraph() const { return this->Search != nullptr; }
  const dgg::GraphView& GetGraph() const { return this->Search->GetGraph(); }
  const dgg::GraphSearch& GetSearch() const { return *this->Search; }
  /// For links of points that are not vertices. Made when it is asked for.
  const dgg::GraphBuilder& GetBuilder(const vtkDGGMeshAdapter& mesh);
  /// Add what a search from a source starts from: a seed, or one for each link of the source.
  dgg::Status AddSeeds(const dgg::GeodesicSource& source, dgg::Id index,
    const vtkDGGMeshAdapter& mesh, std::vector<dgg::GraphSeed>& seeds);
  /// The accuracy that links have to have: that of the graph, or that asked for when it has none.
  double GetLinkAccuracy() const;

  /// Whether the graph is that on the input.
  bool IsFromInput() const { return this->UsedInput != 0; }
  /// When a graph was last built.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }
  /// Bytes held by the graph and the search, also where the graph is shared with the input.
  std::size_t GetMemorySize() const;

private:
  void FollowMesh(const vtkDGGMeshAdapter& mesh);
  void UseInput(const vtkDGGGraphRequest& request);
  dgg::Status UseOwn(const vtkDGGGraphRequest& request, dgg::GraphOptions options);
  void WarnAboutAccuracy(const vtkDGGGraphRequest& request, const dgg::GraphInfo& info);
  void ForgetGraph();

  vtkMTimeType Mesh = 0; // build time of the mesh that all of this belongs to
  vtkDGGGraphArrays InputGraph;
  vtkMTimeType UsedInput = 0; // when the graph on the input was found, if it is searched
  dgg::GeodesicGraph OwnGraph;
  double OwnAccuracy = 0.0; // 0 when there is no own graph
  double WantedAccuracy = 0.0;
  double WarnedAccuracy = 0.0; // about which the user knows
  std::unique_ptr<dgg::GraphBuilder> Builder;
  std::unique_ptr<dgg::GraphSearch> Search;
  vtkTimeStamp BuildTime;
  dgg::ProgressCallback Progress; // of the last request
  double Done = 0.0;              // share of it
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGGraphProvider.h
