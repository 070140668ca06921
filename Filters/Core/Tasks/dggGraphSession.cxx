// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphSession.h"

#include "dggBlockLoop.h"
#include "dggCloudLinks.h"
#include "dggGraphBuildTask.h"
#include "dggGraphSeeds.h"
#include "dggProgressPart.h"
#include "dggSharedTable.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
/// Relative rounding of stored lengths; a search radius is widened by it.
constexpr double LengthRounding = 1e-6;

/// Progress weight of the construction of a graph.
constexpr double BuildShare = 0.9;
/// Progress weights of links and of landmarks, as fractions of the progress that remains.
constexpr double LinkShare = 0.5;
constexpr double LandmarkShare = 0.3;

/// Number of pairs from which on landmarks save more time than they cost.
constexpr std::size_t FewestPairsForLandmarks = 256;

/// Estimated bytes per vertex of a path finder and of a search result.
constexpr std::size_t BytesOfPaths = 40;
constexpr std::size_t BytesOfResult = 60;

/// Number of points that a thread links between reports of the progress.
constexpr std::size_t LinkBlock = 4;

/// Builders in use, by the build number of the surface.
SharedTable<std::uint64_t, GraphBuilder>& GetBuildersInUse()
{
  static SharedTable<std::uint64_t, GraphBuilder> builders;
  return builders;
}
}

void GraphSession::Start(const PreparedSurface& surface)
{
  this->Done = 0.0;
  if (this->Surface == surface.GetBuildNumber())
  {
    return;
  }
  this->Surface = surface.GetBuildNumber();
  this->ReleaseBuilder();
  this->Store = LinkStore();
  this->Result = SearchResult();
  const bool isEqual = this->Graph &&
    this->Graph->GetSurface().GetDomain() == surface.GetDomain() &&
    this->Graph->GetSurface().GetSignature() == surface.GetSignature();
  if (isEqual)
  {
    this->Use(this->Graph->MoveTo(surface));
  }
  else
  {
    this->Release();
  }
}

void GraphSession::Release()
{
  this->Finder.reset();
  this->Search.reset();
  this->Graph.reset();
}

void GraphSession::Use(PreparedGraph::Pointer graph)
{
  this->Release();
  this->Graph = std::move(graph);
  this->Search = this->Graph->GetSearch();
  this->NumberOfPairs = 0;
}

Status GraphSession::Build(const TaskContext& context, GraphOptions options, GeodesicGraph& graph)
{
  options.Progress = this->TakeProgress(context, BuildShare);
  GraphEstimate estimate;
  if (this->Builder)
  {
    return BuildGraph(context, *this->Builder, options, graph, estimate);
  }
  // Only kept from the second use on, because a builder takes as much memory as the mesh.
  const GraphBuilder temporary(context.Surface.GetMesh());
  return BuildGraph(context, temporary, options, graph, estimate);
}

ProgressCallback GraphSession::GetRemainingProgress(const TaskContext& context) const
{
  return ProgressPart(context.Progress, this->Done, 1.0);
}

ProgressCallback GraphSession::TakeProgress(const TaskContext& context, double share)
{
  const double start = this->Done;
  this->Done = start + share * (1.0 - start);
  return ProgressPart(context.Progress, start, this->Done);
}

Status GraphSession::PrepareForPairs(const TaskContext& context, std::size_t count)
{
  this->NumberOfPairs += count;
  return this->NumberOfPairs < FewestPairsForLandmarks || this->Search->HasLandmarks()
    ? Status::Success()
    : this->Search->PrepareLandmarks(context.Parallel, this->TakeProgress(context, LandmarkShare));
}

Status GraphSession::PrepareBuilder(const TaskContext& context, bool isNeeded)
{
  const bool isLimited = context.Memory.IsExplicit();
  if (!isNeeded)
  {
    const std::size_t size = isLimited ? this->GetMemorySize() : this->BuilderSize;
    if (this->Builder && static_cast<double>(size) > context.Memory.GetBytes())
    {
      this->ReleaseBuilder();
    }
    return Status::Success();
  }
  if (context.Surface.IsCloud())
  {
    return Status::Success();
  }
  const std::size_t size = EstimateBuilder(context.Surface);
  const std::uint64_t key = context.Surface.GetBuildNumber();
  std::shared_ptr<const GraphBuilder> builder = GetBuildersInUse().Find(key);
  if (!builder || isLimited) // free memory is not needed for a builder that exists
  {
    DGG_RETURN_IF_ERROR(context.Memory.Check(
      "Linking points that are not vertices", static_cast<double>(size), "Use vertices only"));
  }
  if (!builder)
  {
    builder =
      GetBuildersInUse().Add(key, std::make_shared<const GraphBuilder>(context.Surface.GetMesh()));
  }
  if (this->Builder != builder)
  {
    this->Finder.reset(); // The finder was made without a builder.
  }
  this->Builder = builder;
  this->BuilderSize = size;
  return Status::Success();
}

void GraphSession::ReleaseBuilder()
{
  if (this->Builder)
  {
    this->Finder.reset();
  }
  this->Builder.reset();
  this->BuilderSize = 0;
}

Status GraphSession::Link(const SurfacePoint& place, const Points& aims,
  std::vector<GraphLink>& links, std::vector<double>& direct) const
{
  const PreparedSurface& mesh = this->Graph->GetSurface();
  if (!mesh.IsCloud())
  {
    return FindLinks(this->Builder.get(), place, this->GetLinkAccuracy(), aims, links, direct);
  }
  LinkToCloud(this->Search->GetGraph(), mesh.GetPositions(), place, aims, links, direct);
  return Status::Success();
}

Status GraphSession::MakeSeeds(const TaskContext& context,
  const std::vector<GeodesicSource>& sources, std::vector<GraphSeed>& seeds)
{
  seeds.clear();
  Points places;
  for (const GeodesicSource& source : sources)
  {
    if (!IsVertex(source.Point))
    {
      places.push_back(source.Point);
    }
  }
  DGG_RETURN_IF_ERROR(this->LinkPlaces(context, places));
  std::size_t place = 0;
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const double offset = sources[i].InitialDistance;
    const auto index = static_cast<Id>(i);
    if (IsVertex(sources[i].Point))
    {
      seeds.push_back({ sources[i].Point.Vertex, offset, offset, index, -1.0 });
      continue;
    }
    AppendSeeds(this->Store.Links[place++], seeds, index, offset);
  }
  return Status::Success();
}

Status GraphSession::LinkPlaces(const TaskContext& context, const Points& places)
{
  LinkStore& store = this->Store;
  if (places.empty())
  {
    return this->PrepareBuilder(context, false);
  }
  const double accuracy = this->GetLinkAccuracy();
  // Links to a cloud depend on its graph, and are quickly found.
  if (!context.Surface.IsCloud() && store.Accuracy == accuracy &&
    std::equal(places.begin(), places.end(), store.Places.begin(), store.Places.end(), IsSamePoint))
  {
    return Status::Success();
  }
  store = LinkStore();
  DGG_RETURN_IF_ERROR(this->PrepareBuilder(context));
  store.Links.resize(places.size());
  const Status status = ForEach(places.size(), LinkBlock, context.Parallel,
    this->TakeProgress(context, LinkShare), [&](std::size_t i, const ProgressCallback&) {
      std::vector<double> none;
      return this->Link(places[i], {}, store.Links[i], none);
    });
  if (!status.IsOk())
  {
    store = LinkStore();
    return status;
  }
  store.Accuracy = accuracy;
  store.Places = places;
  return status;
}

const PathFinder& GraphSession::GetPathFinder()
{
  if (!this->Finder)
  {
    const PreparedSurface& mesh = this->Graph->GetSurface();
    this->Finder = std::make_unique<PathFinder>(
      mesh.GetMesh(), *this->Search, this->Builder.get(), mesh.GetPositions());
  }
  return *this->Finder;
}

double GraphSession::GetLinkAccuracy() const
{
  const double accuracy = this->GetSummary().Info.Accuracy;
  return accuracy > 0.0 ? accuracy : this->DefaultAccuracy;
}

double GraphSession::WidenLimit(double maximum, const std::vector<GeodesicSource>& sources) const
{
  double offset = Infinity;
  for (const GeodesicSource& source : sources)
  {
    offset = std::min(offset, source.InitialDistance);
  }
  return WidenLimit(maximum, offset, this->GetLinkAccuracy());
}

double GraphSession::WidenLimit(double maximum, double offset, double accuracy)
{
  return maximum < Infinity
    ? maximum + (accuracy + LengthRounding) * std::max(0.0, maximum - offset)
    : maximum;
}

const GraphSummary& GraphSession::GetSummary() const
{
  static const GraphSummary none;
  return this->Graph ? this->Graph->GetSummary() : none;
}

std::size_t GraphSession::GetMemorySize() const
{
  if (!this->Graph)
  {
    return 0;
  }
  std::size_t links = 0;
  for (const std::vector<GraphLink>& list : this->Store.Links)
  {
    links += list.size();
  }
  return this->GetSummary().MemorySize + this->Search->GetMemorySize() + this->BuilderSize +
    links * sizeof(GraphLink) + this->Result.Distances.size() * BytesOfResult +
    (this->Finder ? BytesOfPaths * static_cast<std::size_t>(this->GetSummary().NumberOfVertices)
                  : 0);
}

BandPathShortener GraphSession::MakeShortener() const
{
  return { this->Graph->GetSurface().GetPositions(), this->Search->GetGraph(),
    this->Graph->GetGraph().GetBand().Radii };
}
}
