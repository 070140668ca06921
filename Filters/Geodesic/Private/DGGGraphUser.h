// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What all filters that search a graph have in common. Internal.
#ifndef DGGGraphUser_h
#define DGGGraphUser_h

#include "DGGContext.h"       // for the update
#include "DGGPreparedGraph.h" // for the graph

#include "dggBandPath.h"       // for BandPathShortener
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggGraphBuilder.h"   // for GraphBuilder
#include "dggPathFinder.h"     // for PathFinder

#include "vtkIndent.h"    // for PrintSelf()
#include "vtkTimeStamp.h" // for the build time

#include <cstdint>  // for the build number
#include <memory>   // for what is made on demand
#include <optional> // for the search
#include <ostream>  // for PrintSelf()
#include <vector>   // for seeds

class vtkObject;

/// The properties of a filter that searches a graph, and the graph: that on its input, or else one
/// that it builds and keeps until the mesh or the accuracy changes. That of a cloud has to be on
/// the input. Such filters have different superclasses, so this is a member:
/// `std::unique_ptr<DGGGraphUser> GraphUser`. The filter declares the properties and documents
/// them; vtkDGGGraphUserMacro() defines them.
class DGGGraphUser
{
public:
  DGGGraphUser() = default;
  DGGGraphUser(const DGGGraphUser&) = delete;
  DGGGraphUser& operator=(const DGGGraphUser&) = delete;

  ///@{
  /// Setters return whether something has changed.
  bool SetAccuracy(double accuracy);
  bool SetAcceptCoarserGraph(bool accept);
  double GetAccuracy() const { return this->Accuracy; }
  bool GetAcceptCoarserGraph() const { return this->AcceptCoarserGraph; }
  ///@}

  void PrintSelf(std::ostream& os, vtkIndent indent) const;
  /// What is wrong with the properties.
  dgg::Status Check() const;

  /// Whether such filters take an input for a cloud: when it says that it has the graph of one.
  static bool IsCloud(vtkPolyData* input);

  /// Bring the graph up to date; when it fails there is none. `filter` warns about a graph on the
  /// input that cannot be used, or is not as accurate as the user wants it: once for each.
  dgg::Status Update(const DGGContext& context, vtkObject* filter);

  /// The rest of the progress: where the filter goes on after the last call.
  dgg::ProgressCallback GetRemainingProgress(const DGGContext& context) const;

  /// Only right after a successful Update().
  const dgg::GraphSearch& GetSearch() const { return *this->Search; }
  /// Kept after local searches, so that the next search resets only reached vertices.
  dgg::SearchResult& GetResult() { return this->Result; }
  /// The accuracy that links have to have: that of the graph, or that asked for when it has none.
  double GetLinkAccuracy() const;
  /// How far to search so that every point closer than `maximum` is reached through the graph.
  double WidenLimit(double maximum, const std::vector<dgg::GeodesicSource>& sources) const;

  /// Pairs of points are about to be searched for. When there are enough of them, counting earlier
  /// ones, distances from landmarks are found first, which show all later searches the way.
  dgg::Status PrepareForPairs(const DGGContext& context, std::size_t count);

  /// What a search from the sources starts from: a seed for each that is a vertex, and one for each
  /// link of the others. Links are kept while mesh, accuracy and places are the same.
  dgg::Status MakeSeeds(const DGGContext& context, const std::vector<dgg::GeodesicSource>& sources,
    std::vector<dgg::GraphSeed>& seeds);
  /// Prepares the builder that links points that are not vertices. All filters with the mesh share
  /// it. Fails if it would take too much memory; clouds have none. A builder that is not needed now
  /// is kept for later updates unless it exceeds the memory limit.
  dgg::Status PrepareBuilder(const DGGContext& context, bool isNeeded = true);
  const dgg::GraphBuilder& GetBuilder() const { return *this->Builder; }
  /// Links of a place, and how far it is from each of `aims` besides the graph: those that a
  /// straight way leads to. Needs PrepareBuilder() for places that are not vertices.
  dgg::Status Link(const dgg::SurfacePoint& place, const std::vector<dgg::SurfacePoint>& aims,
    std::vector<dgg::GraphLink>& links, std::vector<double>& direct) const;

  /// For paths in the graph, with links when there is a builder. Its memory is as large as the
  /// mesh, whose positions have been made; it is kept as long as graph and builder are the same.
  const dgg::PathFinder& GetPathFinder();
  /// Returns the shortener of paths on a cloud. It uses the graph, which must outlive it.
  dgg::BandPathShortener MakeShortener(const dgg::PreparedSurface& cloud) const;

  ///@{
  /// What getters of filters report: whether the graph is that on the input, its numbers, all zero
  /// when there is none, when one was last built, and the bytes held by the graph, also where it is
  /// shared, and by what searches and links need, about.
  bool IsFromInput() const { return this->UsedInput != 0; }
  const dgg::GraphSummary& GetSummary() const;
  bool IsGuaranteed() const { return this->Graph && this->GetSummary().Info.IsGuaranteed(); }
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }
  std::size_t GetMemorySize() const;
  ///@}

private:
  using Points = std::vector<dgg::SurfacePoint>;

  /// Links of points, and what they depend on.
  struct LinkStore
  {
    std::uint64_t Mesh = 0;
    double Accuracy = 0.0;
    Points Places;
    std::vector<std::vector<dgg::GraphLink>> Links; // per place
  };

  void FollowMesh(const dgg::PreparedSurface& mesh);
  void ReleaseBuilder();
  void UseInput(const DGGContext& context, vtkObject* filter);
  dgg::Status UseOwn(const DGGContext& context, dgg::GraphOptions options);
  void SearchIn(const DGGGraphArrays& arrays, const dgg::PreparedSurface& mesh);
  void WarnAboutAccuracy(vtkObject* filter);
  dgg::Status LinkPlaces(const DGGContext& context, const Points& places);
  void ForgetGraph();
  /// A share of what is left of the progress, which is done then.
  dgg::ProgressCallback TakeProgress(const DGGContext& context, double share);

  double Accuracy = 0.01;
  bool IsAccuracyExplicit = false; // whether the user has asked for it
  bool AcceptCoarserGraph = false;

  std::uint64_t Mesh = 0; // build number of the surface that all of this belongs to
  DGGGraphArrays InputGraph;
  vtkMTimeType UsedInput = 0;  // when the graph on the input was found, if it is searched
  double OwnAccuracy = 0.0;    // 0 when the graph is not an own one
  double WarnedAccuracy = 0.0; // about which the user knows
  DGGPreparedGraph::Pointer Graph;
  std::optional<dgg::GraphSearch> Search; // that of Graph, with landmarks when there are enough
  std::size_t NumberOfPairs = 0;          // that it has been asked for
  dgg::SearchResult Result;
  std::shared_ptr<const dgg::GraphBuilder> Builder;
  std::size_t BuilderSize = 0;             // bytes, about
  std::unique_ptr<dgg::PathFinder> Finder; // in Search, with Builder
  LinkStore Store;
  vtkTimeStamp BuildTime;
  double Done = 0.0; // share of the progress
};

/// A setter of a filter that hands the value on.
#define vtkDGGGraphUserSetMacro(Class, Property, Type) \
  void Class::Set##Property(Type value)                \
  {                                                    \
    if (this->GraphUser->Set##Property(value))         \
    {                                                  \
      this->Modified();                                \
    }                                                  \
  }                                                    \
  Type Class::Get##Property() const                    \
  {                                                    \
    return this->GraphUser->Get##Property();           \
  }

/// A number of the graph in use.
#define vtkDGGGraphUserNumberMacro(Class, Type, Name, Number) \
  Type Class::Name() const                                    \
  {                                                           \
    return static_cast<Type>(this->GraphUser->Number);        \
  }

/// All that a filter with a graph has to have. One that does not declare a part of it does not
/// compile, so that no two of them drift apart.
#define vtkDGGGraphUserMacro(Class)                                                                \
  vtkDGGGraphUserSetMacro(Class, Accuracy, double);                                                \
  vtkDGGGraphUserSetMacro(Class, AcceptCoarserGraph, bool);                                        \
  vtkDGGGraphUserNumberMacro(Class, bool, GetUsedInputGraph, IsFromInput());                       \
  vtkDGGGraphUserNumberMacro(Class, double, GetGraphAccuracy, GetSummary().Info.Accuracy);         \
  vtkDGGGraphUserNumberMacro(Class, bool, GetGraphIsGuaranteed, IsGuaranteed());                   \
  vtkDGGGraphUserNumberMacro(Class, vtkIdType, GetNumberOfGraphEdges, GetSummary().NumberOfEdges); \
  vtkDGGGraphUserNumberMacro(Class, vtkTypeUInt64, GetMemorySize, GetMemorySize());                \
  vtkDGGGraphUserNumberMacro(Class, vtkMTimeType, GetGraphBuildTime, GetBuildTime())

#endif
