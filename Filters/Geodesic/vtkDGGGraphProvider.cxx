// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGGraphProvider.h"

#include "vtkDGGGraphBuild.h"
#include "vtkDGGMeshAdapter.h"

#include "vtkObject.h"
#include "vtkPolyData.h"

#include <sstream>

namespace
{
/// Share of the progress that goes to a graph that has to be built.
constexpr double BuildShare = 0.9;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::Update(const vtkDGGGraphRequest& request)
{
  this->Progress = request.Progress;
  this->Done = 0.0;
  dgg::GraphOptions options;
  options.Accuracy = request.Accuracy;
  dgg::Status status = dgg::GraphBuilder::Check(options);
  if (!status.IsOk())
  {
    return status;
  }
  this->FollowMesh(request.Mesh);
  this->WantedAccuracy = request.Accuracy;

  std::string complaint;
  const bool found = this->InputGraph.Find(request.Input->GetFieldData(), request.Mesh, complaint);
  if (!complaint.empty())
  {
    vtkWarningWithObjectMacro(request.Filter, << complaint
                                              << ". It is not used; a graph with Accuracy "
                                              << request.Accuracy << " takes its place.");
  }
  if (found)
  {
    this->UseInput(request);
    return dgg::Status::Success();
  }
  status = this->UseOwn(request, options);
  if (!status.IsOk())
  {
    this->ForgetGraph();
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::FollowMesh(const vtkDGGMeshAdapter& mesh)
{
  if (this->Mesh != mesh.GetBuildTime())
  {
    this->ForgetGraph();
    this->Builder.reset();
    this->Mesh = mesh.GetBuildTime();
  }
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::ForgetGraph()
{
  this->Search.reset();
  this->OwnGraph = dgg::GeodesicGraph();
  this->OwnAccuracy = 0.0;
  this->UsedInput = 0;
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::UseInput(const vtkDGGGraphRequest& request)
{
  const dgg::GraphView& graph = this->InputGraph.GetView();
  if (!this->Search || this->UsedInput != this->InputGraph.GetTime())
  {
    this->ForgetGraph();
    this->Search = std::make_unique<dgg::GraphSearch>(graph, &request.Mesh.GetMesh());
    this->UsedInput = this->InputGraph.GetTime();
    this->WarnedAccuracy = 0.0;
  }
  this->WarnAboutAccuracy(request, graph.Info);
}

//------------------------------------------------------------------------------
void vtkDGGGraphProvider::WarnAboutAccuracy(
  const vtkDGGGraphRequest& request, const dgg::GraphInfo& info)
{
  const bool sufficient = info.IsGuaranteed() && info.Accuracy <= request.Accuracy;
  if (!request.IsAccuracyExplicit || sufficient || this->WarnedAccuracy == request.Accuracy)
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
  vtkWarningWithObjectMacro(request.Filter,
    << "the graph on the input is used, although " << reason.str() << " and Accuracy "
    << request.Accuracy << " is asked for: build it so by vtkDiscreteGeodesicGraph, or remove it.");
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
  options.Progress = [this](double fraction) { return this->Progress(BuildShare * fraction); };
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
    this->Search =
      std::make_unique<dgg::GraphSearch>(this->OwnGraph.View(), &request.Mesh.GetMesh());
    this->OwnAccuracy = request.Accuracy;
    this->BuildTime.Modified();
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::ProgressCallback vtkDGGGraphProvider::GetRemainingProgress() const
{
  return [progress = this->Progress, done = this->Done](
           double fraction) { return progress(done + (1.0 - done) * fraction); };
}

//------------------------------------------------------------------------------
const dgg::GraphBuilder& vtkDGGGraphProvider::GetBuilder(const vtkDGGMeshAdapter& mesh)
{
  if (!this->Builder)
  {
    this->Builder = std::make_unique<dgg::GraphBuilder>(mesh.GetMesh());
  }
  return *this->Builder;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphProvider::AddSeeds(const dgg::GeodesicSource& source, dgg::Id index,
  const vtkDGGMeshAdapter& mesh, std::vector<dgg::GraphSeed>& seeds)
{
  const double offset = source.InitialDistance;
  if (source.Point.On == dgg::SurfacePoint::Support::Vertex)
  {
    seeds.push_back({ source.Point.Vertex, offset, offset, index, -1.0 });
    return dgg::Status::Success();
  }
  std::vector<dgg::GraphLink> links;
  std::vector<double> none;
  const dgg::Status status =
    this->GetBuilder(mesh).Link(source.Point, this->GetLinkAccuracy(), {}, links, none);
  for (const dgg::GraphLink& link : links)
  {
    seeds.push_back({ link.Vertex, offset + link.Length, offset, index, link.ArrivalAngle });
  }
  return status;
}

//------------------------------------------------------------------------------
double vtkDGGGraphProvider::GetLinkAccuracy() const
{
  const double accuracy = this->GetGraph().Info.Accuracy;
  return accuracy > 0.0 ? accuracy : this->WantedAccuracy;
}

//------------------------------------------------------------------------------
std::size_t vtkDGGGraphProvider::GetMemorySize() const
{
  return this->Search
    ? vtkDGGGraphArrays::GetMemorySize(this->GetGraph()) + this->Search->GetMemorySize()
    : 0;
}
