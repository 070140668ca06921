// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The graph that a filter searches. Internal.
#ifndef vtkDGGGraphProvider_h
#define vtkDGGGraphProvider_h

#include "vtkDGGDomain.h"      // for what the graph is of
#include "vtkDGGGraphArrays.h" // for the graph on the input

#include "dggBandPath.h"       // for BandPathShortener
#include "dggExactGeodesics.h" // for GeodesicSource
#include "dggGraphBuilder.h"   // for GraphBuilder
#include "dggGraphSearch.h"    // for GraphSearch
#include "dggPathFinder.h"     // for PathFinder

#include "vtkTimeStamp.h" // for the build time

#include <memory> // for what is made on demand
#include <vector> // for seeds

class vtkDGGPreparedMesh;
class vtkObject;
class vtkPolyData;

/// What a filter asks for.
struct vtkDGGGraphRequest
{
  vtkPolyData* Input;
  const vtkDGGPreparedMesh& Mesh; ///< of the input; must outlive the provider
  double Accuracy;                ///< of a graph that is built
  bool WarnAboutAccuracy;         ///< when the graph on the input promises less than that
  vtkTypeUInt64 MemoryLimit;      ///< bytes; 0 for the default
  dgg::ProgressCallback Progress; ///< of the whole update of the filter
  vtkObject* Filter;              ///< that warns
};

/// Finds the graph on the input of a filter, or else builds one and keeps it until the mesh or the
/// accuracy changes. All filters that search a graph get it from here. That of a cloud has to be on
/// the input.
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
  /// Its numbers; all zero when there is none.
  const vtkDGGGraphSummary& GetSummary() const { return this->Summary; }
  /// Only right after a successful Update().
  const dgg::GraphSearch& GetSearch() const { return *this->Search; }

  /// Pairs of points are about to be searched for. When there are enough of them, counting earlier
  /// ones, distances from landmarks are found first, which show all later searches the way.
  dgg::Status PrepareForPairs(std::size_t count);

  /// What a search from the sources starts from: a seed for each that is a vertex, and one for each
  /// link of the others. Links are kept while mesh, accuracy and places are the same.
  dgg::Status MakeSeeds(const std::vector<dgg::GeodesicSource>& sources,
    const vtkDGGPreparedMesh& mesh, std::vector<dgg::GraphSeed>& seeds);
  /// For links of points that are not vertices; kept until ReleaseBuilder() or another mesh. Fails
  /// when it would take too much memory. Clouds need none, and have none. One that is not needed is
  /// released.
  dgg::Status PrepareBuilder(const vtkDGGPreparedMesh& mesh, bool isNeeded = true);
  /// Links of a place, and how far it is from each of `aims` besides the graph: those that a
  /// straight way leads to. Needs PrepareBuilder() for places that are not vertices.
  dgg::Status Link(const dgg::SurfacePoint& place, const std::vector<dgg::SurfacePoint>& aims,
    const vtkDGGPreparedMesh& mesh, std::vector<dgg::GraphLink>& links,
    std::vector<double>& direct) const;
  const dgg::GraphBuilder& GetBuilder() const { return *this->Builder; }
  void ReleaseBuilder();
  /// For paths in the graph, with links when there is a builder. Its memory is as large as the
  /// mesh, whose positions have been made; it is kept as long as graph and builder are the same.
  const dgg::PathFinder& GetPathFinder(const vtkDGGPreparedMesh& mesh);
  /// The accuracy that links have to have: that of the graph, or that asked for when it has none.
  double GetLinkAccuracy() const;

  /// For smooth paths on a cloud: rebuild the band that its graph was built in, unless it is there
  /// already. Kept as long as the graph is the same. Fails when it would take too much memory.
  dgg::Status PrepareShortener(const vtkDGGPreparedMesh& cloud);
  const dgg::BandPathShortener& GetShortener() const { return *this->Shortener; }

  /// Whether the graph is that on the input.
  bool IsFromInput() const { return this->UsedInput != 0; }
  /// When a graph was last built.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }
  /// Bytes held by the graph, also where it is shared with the input, and by what searches and
  /// links need, about.
  std::size_t GetMemorySize() const;

private:
  using Points = std::vector<dgg::SurfacePoint>;

  /// Links of points, and what they depend on.
  struct LinkStore
  {
    vtkMTimeType Mesh = 0;
    double Accuracy = 0.0;
    Points Places;
    std::vector<std::vector<dgg::GraphLink>> Links; // per place
  };

  void FollowMesh(const vtkDGGPreparedMesh& mesh);
  void UseInput(const vtkDGGGraphRequest& request);
  dgg::Status UseOwn(const vtkDGGGraphRequest& request, dgg::GraphOptions options);
  void SearchIn(const dgg::GraphView& graph, const vtkDGGPreparedMesh& mesh);
  void WarnAboutAccuracy(const vtkDGGGraphRequest& request);
  dgg::Status LinkPlaces(const Points& places, const vtkDGGPreparedMesh& mesh);
  void ForgetGraph();

  vtkMTimeType Mesh = 0; // build time of the mesh that all of this belongs to
  vtkDGGGraphArrays InputGraph;
  vtkMTimeType UsedInput = 0; // when the graph on the input was found, if it is searched
  dgg::GeodesicGraph OwnGraph;
  double OwnAccuracy = 0.0; // 0 when there is no own graph
  vtkDGGDomain OwnDomain;
  double WantedAccuracy = 0.0;
  double WarnedAccuracy = 0.0; // about which the user knows
  vtkTypeUInt64 MemoryLimit = 0;
  vtkDGGGraphSummary Summary;
  std::unique_ptr<dgg::GraphSearch> Search;
  std::size_t NumberOfPairs = 0; // that it has been asked for
  std::unique_ptr<dgg::GraphBuilder> Builder;
  std::size_t BuilderSize = 0;                       // bytes, about
  std::unique_ptr<dgg::PathFinder> Finder;           // in Search, with Builder
  std::unique_ptr<dgg::BandPathShortener> Shortener; // on a cloud
  LinkStore Store;
  vtkTimeStamp BuildTime;
  dgg::ProgressCallback Progress; // of the last request
  double Done = 0.0;              // share of it
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGGraphProvider.h
