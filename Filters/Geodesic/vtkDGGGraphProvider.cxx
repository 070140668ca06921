// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGGraphProvider.h"

#include "vtkDGGCloudLinks.h"
#include "vtkDGGGraphBuild.h"
#include "vtkDGGMemory.h"
#include "vtkDGGPreparedMesh.h"
#include "vtkDGGParallel.h"

#include "dggProgressPart.h"

#include "vtkObject.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>

namespace
{
/// Share of the progress that goes to a graph that has to be built.
constexpr double BuildShare = 0.9;
/// Share of the rest that goes to links.
constexpr double LinkShare = 0.5;

/// Finding distances from landmarks takes about as long as this many pairs take longer without.
constexpr std::size_t FewestPairsForLandmarks = 256;
/// Share of the rest that goes to landmarks.
constexpr double LandmarkShare = 0.3;
/// The same for the band around a cloud.
constexpr double BandShare = 0.2;

/// Bytes per vertex of what finds paths, about.
constexpr std::size_t BytesOfPaths = 40;

/// Links that a thread makes between two looks at the progress.
constexpr std::size_t LinkBlock = 4;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::Update(const vtkDGGGraphRequest& request)
{
  this->Progress = request.Progress;
  this->Done = 0.0;
  this->MemoryLimit = request.MemoryLimit;
  dgg::GraphOptions options;
  options.Accuracy = request.Accuracy;
  dgg::Status status = dgg::GraphBuilder::Check(options);
  if (!status.IsOk())
  {
    return status;
  }
  this->FollowMesh(request.Mesh);
  this->WantedAccuracy = request.Accuracy;

  vtkFieldData* data = request.Input->GetFieldData();
  if (this->IsFromInput() && !this->InputGraph.IsSame(data, request.Mesh))
  {
    this->ForgetGraph(); // before its arrays are let go
  }
  const bool isCloud = request.Mesh.IsCloud();
  if (isCloud && !this->InputGraph.IsValid())
  {
    this->InputGraph.Clear(); // so that what is wrong with it is reported again
  }
  std::string complaint;
  const bool found = this->InputGraph.Find(data, request.Mesh, complaint);
  if (!complaint.empty() && !isCloud)
  {
    vtkWarningWithObjectMacro(request.Filter, << complaint
                                              << ". It is not used; a graph with Accuracy "
                                              << request.Accuracy << " takes its place.");
  }
  if (found)
  {
    this->UseInput(request);
  }
  else if (isCloud)
  {
    status = dgg::Status::Invalid(
      complaint + ". Run vtkPointCloudDGG on these points, or have this filter follow it");
  }
  else
  {
    status = this->UseOwn(request, options);
  }
  if (!status.IsOk())
  {
    this->ForgetGraph();
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::FollowMesh(const vtkDGGPreparedMesh& mesh)
{
  if (this->Mesh == mesh.GetBuildTime())
  {
    return;
  }
  this->Mesh = mesh.GetBuildTime();
  this->ReleaseBuilder();
  this->Store = LinkStore();
  const bool isOwn = this->OwnAccuracy > 0.0 && this->OwnDomain == mesh.GetDomain() &&
    this->OwnGraph.Info.Surface == mesh.GetSignature();
  if (isOwn)
  {
    // The surface is the same, but the search knew the mesh that is gone.
    this->SearchIn(this->OwnGraph.View(), mesh);
  }
  else
  {
    this->ForgetGraph();
  }
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::ForgetGraph()
{
  this->Finder.reset();
  this->Shortener.reset();
  this->Search.reset();
  this->Summary = vtkDGGGraphSummary();
  this->OwnGraph = dgg::GeodesicGraph();
  this->OwnAccuracy = 0.0;
  this->UsedInput = 0;
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::SearchIn(const dgg::GraphView& graph, const vtkDGGPreparedMesh& mesh)
{
  this->Finder.reset();
  this->Search.reset();
  this->Search =
    std::make_unique<dgg::GraphSearch>(graph, mesh.IsCloud() ? nullptr : &mesh.GetMesh());
  this->NumberOfPairs = 0;
  this->Summary = vtkDGGGraphSummary(graph);
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::UseInput(const vtkDGGGraphRequest& request)
{
  if (!this->Search || this->UsedInput != this->InputGraph.GetTime())
  {
    this->ForgetGraph();
    this->SearchIn(this->InputGraph.GetView(), request.Mesh);
    this->UsedInput = this->InputGraph.GetTime();
    this->WarnedAccuracy = 0.0;
  }
  if (!request.Mesh.IsCloud()) // another one could not be built here, and none has a guarantee
  {
    this->WarnAboutAccuracy(request);
  }
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::WarnAboutAccuracy(const vtkDGGGraphRequest& request)
{
  const dgg::GraphInfo& info = this->Summary.Info;
  const bool sufficient = info.IsGuaranteed() && info.Accuracy <= request.Accuracy;
  if (!request.WarnAboutAccuracy || sufficient || this->WarnedAccuracy == request.Accuracy)
  {
    return;
  }
  this->WarnedAccuracy = request.Accuracy;
  std::ostringstream reason;
  if (info.IsGuaranteed())
  {
    reason << "its accuracy is " << info.Accuracy;
  }
  else
  {
    reason << "its construction guarantees no accuracy";
  }
  vtkWarningWithObjectMacro(
    request.Filter, << "the graph on the input is used, although " << reason.str()
                    << " and Accuracy " << request.Accuracy
                    << " is asked for: build it so by vtkDiscreteGeodesicGraph, remove it, or turn "
                       "AcceptCoarserGraph on.");
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::UseOwn(
  const vtkDGGGraphRequest& request, dgg::GraphOptions options)
{
  if (this->Search && this->OwnAccuracy == request.Accuracy)
  {
    return dgg::Status::Success();
  }
  this->ForgetGraph();
  options.Progress = dgg::ProgressPart(this->Progress, 0.0, BuildShare);
  this->Done = BuildShare;
  // Kept only if it is asked for again: it takes memory of its own.
  std::unique_ptr<dgg::GraphBuilder> temporary;
  if (!this->Builder)
  {
    temporary = std::make_unique<dgg::GraphBuilder>(request.Mesh.GetMesh());
  }
  dgg::GraphEstimate estimate;
  const dgg::Status status = vtkDGGBuildGraph(this->Builder ? *this->Builder : *temporary,
    request.Mesh, options, request.MemoryLimit, this->OwnGraph, estimate);
  if (status.IsOk())
  {
    temporary.reset();
    this->SearchIn(this->OwnGraph.View(), request.Mesh);
    this->OwnAccuracy = request.Accuracy;
    this->OwnDomain = request.Mesh.GetDomain();
    this->BuildTime.Modified();
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::ProgressCallback vtkDGGGraphProvider::GetRemainingProgress() const
{
  return dgg::ProgressPart(this->Progress, this->Done, 1.0);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::PrepareForPairs(std::size_t count)
{
  this->NumberOfPairs += count;
  if (this->NumberOfPairs < FewestPairsForLandmarks || this->Search->HasLandmarks())
  {
    return dgg::Status::Success();
  }
  const double start = this->Done;
  const double share = LandmarkShare * (1.0 - start);
  const dgg::Status status = this->Search->PrepareLandmarks(
    vtkDGGMakeParallelFor(this->Progress), dgg::ProgressPart(this->Progress, start, start + share));
  this->Done = start + share;
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::PrepareBuilder(const vtkDGGPreparedMesh& mesh, bool isNeeded)
{
  if (!isNeeded)
  {
    this->ReleaseBuilder();
    return dgg::Status::Success();
  }
  if (this->Builder || mesh.IsCloud())
  {
    return dgg::Status::Success();
  }
  const std::size_t size = vtkDGGEstimateBuilder(mesh);
  const dgg::Status status = vtkDGGCheckMemory(
    "linking points that are not vertices", size, this->MemoryLimit, "use vertices only");
  if (status.IsOk())
  {
    this->Finder.reset(); // it has none
    this->Builder = std::make_unique<dgg::GraphBuilder>(mesh.GetMesh());
    this->BuilderSize = size;
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::ReleaseBuilder()
{
  if (this->Builder)
  {
    this->Finder.reset();
  }
  this->Builder.reset();
  this->BuilderSize = 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::Link(const dgg::SurfacePoint& place, const Points& aims,
  const vtkDGGPreparedMesh& mesh, std::vector<dgg::GraphLink>& links,
  std::vector<double>& direct) const
{
  if (!mesh.IsCloud())
  {
    return this->Builder->Link(place, this->GetLinkAccuracy(), aims, links, direct);
  }
  const dgg::GraphView& graph = this->Search->GetGraph();
  links = vtkDGGLinkToCloud(graph, mesh.GetPositions(), place);
  direct.clear();
  for (const dgg::SurfacePoint& aim : aims)
  {
    direct.push_back(vtkDGGMeasureDirectly(graph, mesh.GetPositions(), place, aim));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::MakeSeeds(const std::vector<dgg::GeodesicSource>& sources,
  const vtkDGGPreparedMesh& mesh, std::vector<dgg::GraphSeed>& seeds)
{
  seeds.clear();
  Points places;
  for (const dgg::GeodesicSource& source : sources)
  {
    if (!dgg::IsVertex(source.Point))
    {
      places.push_back(source.Point);
    }
  }
  const dgg::Status status = this->LinkPlaces(places, mesh);
  if (!status.IsOk())
  {
    return status;
  }
  std::size_t place = 0;
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const double offset = sources[i].InitialDistance;
    const auto index = static_cast<dgg::Id>(i);
    if (dgg::IsVertex(sources[i].Point))
    {
      seeds.push_back({ sources[i].Point.Vertex, offset, offset, index, -1.0 });
      continue;
    }
    for (const dgg::GraphLink& link : this->Store.Links[place])
    {
      seeds.push_back({ link.Vertex, offset + link.Length, offset, index, link.ArrivalAngle });
    }
    ++place;
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::LinkPlaces(const Points& places, const vtkDGGPreparedMesh& mesh)
{
  LinkStore& store = this->Store;
  if (places.empty())
  {
    this->ReleaseBuilder();
    store = LinkStore();
    return dgg::Status::Success();
  }
  const double accuracy = this->GetLinkAccuracy();
  // Those of a cloud depend on its graph, and are found at once.
  if (!mesh.IsCloud() && store.Mesh == mesh.GetBuildTime() && store.Accuracy == accuracy &&
    std::equal(
      places.begin(), places.end(), store.Places.begin(), store.Places.end(), dgg::IsSamePoint))
  {
    return dgg::Status::Success();
  }
  store = LinkStore();
  dgg::Status status = this->PrepareBuilder(mesh);
  if (!status.IsOk())
  {
    return status;
  }
  const double start = this->Done;
  const double share = LinkShare * (1.0 - start);
  store.Links.resize(places.size());
  status =
    vtkDGGForEach(places.size(), LinkBlock, dgg::ProgressPart(this->Progress, start, start + share),
      [&](std::size_t i, const dgg::ProgressCallback&) {
        std::vector<double> none;
        return this->Link(places[i], {}, mesh, store.Links[i], none);
      });
  this->Done = start + share;
  if (!status.IsOk())
  {
    store = LinkStore();
    return status;
  }
  store.Mesh = mesh.GetBuildTime();
  store.Accuracy = accuracy;
  store.Places = places;
  return status;
}

//------------------------------------------------------------------------------
const dgg::PathFinder& vtkDGGGraphProvider::GetPathFinder(const vtkDGGPreparedMesh& mesh)
{
  if (!this->Finder)
  {
    this->Finder = std::make_unique<dgg::PathFinder>(
      mesh.GetMesh(), *this->Search, this->Builder.get(), mesh.GetPositions());
  }
  return *this->Finder;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::PrepareShortener(const vtkDGGPreparedMesh& cloud)
{
  if (this->Shortener)
  {
    return dgg::Status::Success();
  }
  const vtkDGGCloudBand& band = this->InputGraph.GetBand();
  auto shortener = std::make_unique<dgg::BandPathShortener>(
    cloud.GetPositions(), this->Search->GetGraph(), band.Radii);
  const double start = this->Done;
  const double share = BandShare * (1.0 - start);
  const dgg::Status status = shortener->Prepare(band.VoxelSize,
    vtkDGGGetMemoryLimit(this->MemoryLimit), vtkDGGMakeParallelFor(this->Progress),
    dgg::ProgressPart(this->Progress, start, start + share));
  this->Done = start + share;
  if (status.IsOk())
  {
    this->Shortener = std::move(shortener);
  }
  return status;
}

//------------------------------------------------------------------------------
double vtkDGGGraphProvider::GetLinkAccuracy() const
{
  const double accuracy = this->Summary.Info.Accuracy;
  return accuracy > 0.0 ? accuracy : this->WantedAccuracy;
}

//------------------------------------------------------------------------------
std::size_t vtkDGGGraphProvider::GetMemorySize() const
{
  if (!this->Search)
  {
    return 0;
  }
  std::size_t links = 0;
  for (const std::vector<dgg::GraphLink>& list : this->Store.Links)
  {
    links += list.size();
  }
  return this->Summary.MemorySize + this->Search->GetMemorySize() + this->BuilderSize +
    links * sizeof(dgg::GraphLink) +
    (this->Finder ? BytesOfPaths * static_cast<std::size_t>(this->Summary.NumberOfVertices) : 0) +
    (this->Shortener ? this->Shortener->GetMemorySize() : 0);
}
