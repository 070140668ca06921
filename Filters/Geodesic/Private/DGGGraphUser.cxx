// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGGraphUser.h"

#include "DGGCloudLinks.h"
#include "DGGFreeMemory.h"
#include "DGGGraphBuild.h"
#include "dggSharedTable.h"
#include "DGGThreads.h"

#include "dggInvalidInput.h"
#include "dggProgressPart.h"

#include "vtkObject.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

namespace
{
/// Rounding of lengths in the graph, relative: a point must not be missed because of it.
constexpr double LengthRounding = 1e-6;

/// Share of the progress that goes to a graph that has to be built.
constexpr double BuildShare = 0.9;
/// Share of the rest that goes to links.
constexpr double LinkShare = 0.5;

/// Finding distances from landmarks takes about as long as this many pairs take longer without.
constexpr std::size_t FewestPairsForLandmarks = 256;
/// Share of the rest that goes to landmarks.
constexpr double LandmarkShare = 0.3;

/// Bytes per vertex of what finds paths, about.
constexpr std::size_t BytesOfPaths = 40;
/// Bytes per vertex of a search result, about.
constexpr std::size_t BytesOfResult = 60;

/// Links that a thread makes between two looks at the progress.
constexpr std::size_t LinkBlock = 4;

/// Builders in use, by the build number of the surface.
dgg::SharedTable<std::uint64_t, dgg::GraphBuilder>& GetBuildersInUse()
{
  static dgg::SharedTable<std::uint64_t, dgg::GraphBuilder> builders;
  return builders;
}

template <typename ValueType>
bool Change(ValueType& property, ValueType value)
{
  const bool changes = property != value;
  property = value;
  return changes;
}
}

//------------------------------------------------------------------------------
bool DGGGraphUser::SetAccuracy(double accuracy)
{
  const bool becomesExplicit = Change(this->IsAccuracyExplicit, true);
  return Change(this->Accuracy, accuracy) || becomesExplicit;
}

//------------------------------------------------------------------------------
bool DGGGraphUser::SetAcceptCoarserGraph(bool accept)
{
  return Change(this->AcceptCoarserGraph, accept);
}

//------------------------------------------------------------------------------
void DGGGraphUser::PrintSelf(std::ostream& os, vtkIndent indent) const
{
  const dgg::GraphSummary& summary = this->GetSummary();
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "Accuracy has been set: " << (this->IsAccuracyExplicit ? "yes" : "no") << "\n";
  os << indent << "AcceptCoarserGraph: " << (this->AcceptCoarserGraph ? "On" : "Off") << "\n";
  os << indent << "UsedInputGraph: " << (this->IsFromInput() ? "yes" : "no") << "\n";
  os << indent << "GraphAccuracy: " << summary.Info.Accuracy << "\n";
  os << indent << "GraphIsGuaranteed: " << (this->IsGuaranteed() ? "yes" : "no") << "\n";
  os << indent << "NumberOfGraphEdges: " << summary.NumberOfEdges << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "GraphBuildTime: " << this->GetBuildTime() << "\n";
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::Check() const
{
  dgg::GraphOptions options;
  options.Accuracy = this->Accuracy;
  return dgg::GraphBuilder::Check(options);
}

//------------------------------------------------------------------------------
bool DGGGraphUser::IsCloud(vtkPolyData* input)
{
  return DGGGraphArrays::AreOfCloud(input->GetFieldData());
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::Update(const DGGContext& context, vtkObject* filter)
{
  this->Done = 0.0;
  dgg::GraphOptions options;
  options.Accuracy = this->Accuracy;
  DGG_RETURN_IF_ERROR(this->Check());
  this->FollowMesh(context.Surface);

  vtkFieldData* data = context.Input->GetFieldData();
  if (this->IsFromInput() && !this->InputGraph.IsSame(data, context.Surface))
  {
    this->ForgetGraph();
  }
  const bool isCloud = context.Surface.IsCloud();
  if (isCloud && !this->InputGraph.IsValid())
  {
    this->InputGraph.Clear(); // so that what is wrong with it is reported again
  }
  std::string complaint;
  const bool found = this->InputGraph.Find(data, context.Surface, complaint);
  if (!complaint.empty() && !isCloud)
  {
    vtkWarningWithObjectMacro(filter, << complaint << ". It is not used; a graph with Accuracy "
                                      << this->Accuracy << " takes its place.");
  }
  dgg::Status status;
  if (found)
  {
    this->UseInput(context, filter);
  }
  else if (isCloud)
  {
    status = dgg::Status::Invalid(
      complaint + ". Run vtkPointCloudDGG on these points, or have this filter follow it");
  }
  else
  {
    status = this->UseOwn(context, options);
  }
  if (!status.IsOk())
  {
    this->ForgetGraph();
  }
  return status;
}

//------------------------------------------------------------------------------
void DGGGraphUser::FollowMesh(const dgg::PreparedSurface& mesh)
{
  if (this->Mesh == mesh.GetBuildNumber())
  {
    return;
  }
  this->Mesh = mesh.GetBuildNumber();
  this->ReleaseBuilder();
  this->Store = LinkStore();
  this->Result = dgg::SearchResult();
  const bool isOwn = this->OwnAccuracy > 0.0 &&
    this->Graph->GetSurface().GetDomain() == mesh.GetDomain() &&
    this->Graph->GetSurface().GetSignature() == mesh.GetSignature();
  if (isOwn)
  {
    // The surface is the same, but not the mesh that is searched.
    this->SearchIn(DGGGraphArrays(this->Graph->GetArrays()), mesh);
  }
  else
  {
    this->ForgetGraph();
  }
}

//------------------------------------------------------------------------------
void DGGGraphUser::ForgetGraph()
{
  this->Finder.reset();
  this->Search.reset();
  this->Graph.reset();
  this->OwnAccuracy = 0.0;
  this->UsedInput = 0;
}

//------------------------------------------------------------------------------
void DGGGraphUser::SearchIn(const DGGGraphArrays& arrays, const dgg::PreparedSurface& mesh)
{
  this->Finder.reset();
  this->Search.reset();
  this->Graph.reset(); // before there are two
  this->Graph = DGGPreparedGraph::Make(arrays, mesh);
  this->Search = this->Graph->GetSearch();
  this->NumberOfPairs = 0;
}

//------------------------------------------------------------------------------
void DGGGraphUser::UseInput(const DGGContext& context, vtkObject* filter)
{
  if (!this->Graph || this->UsedInput != this->InputGraph.GetTime())
  {
    this->ForgetGraph();
    this->SearchIn(this->InputGraph, context.Surface);
    this->UsedInput = this->InputGraph.GetTime();
    this->WarnedAccuracy = 0.0;
  }
  if (!context.Surface.IsCloud()) // another one could not be built here, and none has a guarantee
  {
    this->WarnAboutAccuracy(filter);
  }
}

//------------------------------------------------------------------------------
void DGGGraphUser::WarnAboutAccuracy(vtkObject* filter)
{
  const dgg::GraphInfo& info = this->GetSummary().Info;
  const bool isWanted = this->IsAccuracyExplicit && !this->AcceptCoarserGraph;
  const bool sufficient = info.IsGuaranteed() && info.Accuracy <= this->Accuracy;
  if (!isWanted || sufficient || this->WarnedAccuracy == this->Accuracy)
  {
    return;
  }
  this->WarnedAccuracy = this->Accuracy;
  const std::string reason = info.IsGuaranteed() ? dgg::JoinText("its accuracy is ", info.Accuracy)
                                                 : "its construction guarantees no accuracy";
  vtkWarningWithObjectMacro(filter,
    << "the graph on the input is used, although " << reason << " and Accuracy " << this->Accuracy
    << " is asked for: build it so by vtkDiscreteGeodesicGraph, remove it, or turn "
       "AcceptCoarserGraph on.");
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::UseOwn(const DGGContext& context, dgg::GraphOptions options)
{
  if (this->Graph && this->OwnAccuracy == this->Accuracy)
  {
    return dgg::Status::Success();
  }
  this->ForgetGraph();
  options.Progress = this->TakeProgress(context, BuildShare);
  // Kept only if it is asked for again: it takes memory of its own.
  std::unique_ptr<dgg::GraphBuilder> temporary;
  if (!this->Builder)
  {
    temporary = std::make_unique<dgg::GraphBuilder>(context.Surface.GetMesh());
  }
  dgg::GeodesicGraph graph;
  dgg::GraphEstimate estimate;
  DGG_RETURN_IF_ERROR(
    DGGBuildGraph(context, this->Builder ? *this->Builder : *temporary, options, graph, estimate));
  temporary.reset();
  DGGGraphArrays arrays;
  arrays.Adopt(graph, context.Surface);
  this->SearchIn(arrays, context.Surface);
  this->OwnAccuracy = this->Accuracy;
  this->BuildTime.Modified();
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::ProgressCallback DGGGraphUser::GetRemainingProgress(const DGGContext& context) const
{
  return dgg::ProgressPart(context.Progress, this->Done, 1.0);
}

//------------------------------------------------------------------------------
dgg::ProgressCallback DGGGraphUser::TakeProgress(const DGGContext& context, double share)
{
  const double start = this->Done;
  this->Done = start + share * (1.0 - start);
  return dgg::ProgressPart(context.Progress, start, this->Done);
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::PrepareForPairs(const DGGContext& context, std::size_t count)
{
  this->NumberOfPairs += count;
  return this->NumberOfPairs < FewestPairsForLandmarks || this->Search->HasLandmarks()
    ? dgg::Status::Success()
    : this->Search->PrepareLandmarks(context.Parallel, this->TakeProgress(context, LandmarkShare));
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::PrepareBuilder(const DGGContext& context, bool isNeeded)
{
  const bool isLimited = context.MemoryLimit > 0;
  if (!isNeeded)
  {
    const std::size_t size = isLimited ? this->GetMemorySize() : this->BuilderSize;
    if (this->Builder && size > DGGGetMemoryLimit(context.MemoryLimit))
    {
      this->ReleaseBuilder();
    }
    return dgg::Status::Success();
  }
  if (context.Surface.IsCloud())
  {
    return dgg::Status::Success();
  }
  const std::size_t size = DGGEstimateBuilder(context.Surface);
  const std::uint64_t key = context.Surface.GetBuildNumber();
  std::shared_ptr<const dgg::GraphBuilder> builder = GetBuildersInUse().Find(key);
  if (!builder || isLimited) // free memory is not needed for a builder that exists
  {
    DGG_RETURN_IF_ERROR(DGGCheckMemory(
      "linking points that are not vertices", size, context.MemoryLimit, "use vertices only"));
  }
  if (!builder)
  {
    builder = GetBuildersInUse().Add(
      key, std::make_shared<const dgg::GraphBuilder>(context.Surface.GetMesh()));
  }
  if (this->Builder != builder)
  {
    this->Finder.reset(); // The finder was made without a builder.
  }
  this->Builder = builder;
  this->BuilderSize = size;
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGGraphUser::ReleaseBuilder()
{
  if (this->Builder)
  {
    this->Finder.reset();
  }
  this->Builder.reset();
  this->BuilderSize = 0;
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::Link(const dgg::SurfacePoint& place, const Points& aims,
  std::vector<dgg::GraphLink>& links, std::vector<double>& direct) const
{
  const dgg::PreparedSurface& mesh = this->Graph->GetSurface();
  if (!mesh.IsCloud())
  {
    return this->Builder->Link(place, this->GetLinkAccuracy(), aims, links, direct);
  }
  const dgg::GraphView& graph = this->Search->GetGraph();
  links = DGGLinkToCloud(graph, mesh.GetPositions(), place);
  direct.clear();
  for (const dgg::SurfacePoint& aim : aims)
  {
    direct.push_back(DGGMeasureDirectly(graph, mesh.GetPositions(), place, aim));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphUser::MakeSeeds(const DGGContext& context,
  const std::vector<dgg::GeodesicSource>& sources, std::vector<dgg::GraphSeed>& seeds)
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
  DGG_RETURN_IF_ERROR(this->LinkPlaces(context, places));
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
dgg::Status DGGGraphUser::LinkPlaces(const DGGContext& context, const Points& places)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  LinkStore& store = this->Store;
  if (places.empty())
  {
    return this->PrepareBuilder(context, false);
  }
  const double accuracy = this->GetLinkAccuracy();
  // Those of a cloud depend on its graph, and are found at once.
  if (!mesh.IsCloud() && store.Mesh == mesh.GetBuildNumber() && store.Accuracy == accuracy &&
    std::equal(
      places.begin(), places.end(), store.Places.begin(), store.Places.end(), dgg::IsSamePoint))
  {
    return dgg::Status::Success();
  }
  store = LinkStore();
  DGG_RETURN_IF_ERROR(this->PrepareBuilder(context));
  store.Links.resize(places.size());
  const dgg::Status status = DGGForEach(places.size(), LinkBlock,
    this->TakeProgress(context, LinkShare), [&](std::size_t i, const dgg::ProgressCallback&) {
      std::vector<double> none;
      return this->Link(places[i], {}, store.Links[i], none);
    });
  if (!status.IsOk())
  {
    store = LinkStore();
    return status;
  }
  store.Mesh = mesh.GetBuildNumber();
  store.Accuracy = accuracy;
  store.Places = places;
  return status;
}

//------------------------------------------------------------------------------
const dgg::PathFinder& DGGGraphUser::GetPathFinder()
{
  if (!this->Finder)
  {
    const dgg::PreparedSurface& mesh = this->Graph->GetSurface();
    this->Finder = std::make_unique<dgg::PathFinder>(
      mesh.GetMesh(), *this->Search, this->Builder.get(), mesh.GetPositions());
  }
  return *this->Finder;
}

//------------------------------------------------------------------------------
dgg::BandPathShortener DGGGraphUser::MakeShortener(const dgg::PreparedSurface& cloud) const
{
  return { cloud.GetPositions(), this->Search->GetGraph(),
    this->Graph->GetArrays().GetBand().Radii };
}

//------------------------------------------------------------------------------
double DGGGraphUser::GetLinkAccuracy() const
{
  const double accuracy = this->GetSummary().Info.Accuracy;
  return accuracy > 0.0 ? accuracy : this->Accuracy;
}

//------------------------------------------------------------------------------
double DGGGraphUser::WidenLimit(
  double maximum, const std::vector<dgg::GeodesicSource>& sources) const
{
  if (!(maximum < dgg::Infinity))
  {
    return maximum;
  }
  double offset = dgg::Infinity;
  for (const dgg::GeodesicSource& source : sources)
  {
    offset = std::min(offset, source.InitialDistance);
  }
  return maximum + (this->GetLinkAccuracy() + LengthRounding) * std::max(0.0, maximum - offset);
}

//------------------------------------------------------------------------------
const dgg::GraphSummary& DGGGraphUser::GetSummary() const
{
  static const dgg::GraphSummary none;
  return this->Graph ? this->Graph->GetSummary() : none;
}

//------------------------------------------------------------------------------
std::size_t DGGGraphUser::GetMemorySize() const
{
  if (!this->Graph)
  {
    return 0;
  }
  std::size_t links = 0;
  for (const std::vector<dgg::GraphLink>& list : this->Store.Links)
  {
    links += list.size();
  }
  return this->GetSummary().MemorySize + this->Search->GetMemorySize() + this->BuilderSize +
    links * sizeof(dgg::GraphLink) + this->Result.Distances.size() * BytesOfResult +
    (this->Finder ? BytesOfPaths * static_cast<std::size_t>(this->GetSummary().NumberOfVertices)
                  : 0);
}
