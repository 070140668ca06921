// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSourceGeodesicDistance.h"

#include "DGGDistanceTask.h"
#include "DGGGraphUser.h"
#include "DGGMeshQuality.h"
#include "DGGPropagation.h"

#include "dggProgressPart.h"
#include "dggSourceFinding.h"

#include "vtkObjectFactory.h"

#include <utility>

vtkStandardNewMacro(vtkVirtualSourceGeodesicDistance);
vtkDGGGraphUserMacro(vtkVirtualSourceGeodesicDistance);

namespace
{
/// Share of the progress, after the graph, that comes before the search in it.
constexpr double CertifyStart = 0.5;
}

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::vtkVirtualSourceGeodesicDistance()
  : Quality(Automatic)
  , Certify(false)
  , QualityWarning(false)
  , MeshTime(0)
  , Propagation(new DGGPropagation)
  , GraphUser(new DGGGraphUser)
{
}

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::~vtkVirtualSourceGeodesicDistance() = default;

//------------------------------------------------------------------------------
void vtkVirtualSourceGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->GraphUser->PrintSelf(os, indent);
  os << indent << "Quality: " << this->GetQualityAsString() << "\n";
  os << indent << "Certify: " << (this->Certify ? "On" : "Off") << "\n";
  os << indent << "QualityWarning: " << (this->QualityWarning ? "true" : "false") << "\n";
}

//------------------------------------------------------------------------------
const char* vtkVirtualSourceGeodesicDistance::GetQualityAsString() const
{
  static const char* const names[] = { "Automatic", "Fast", "High" };
  return names[this->Quality];
}

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::CheckProperties() const
{
  if (this->Certify)
  {
    DGG_RETURN_IF_ERROR(this->GraphUser->Check());
  }
  return this->Superclass::CheckProperties();
}

//------------------------------------------------------------------------------
std::string vtkVirtualSourceGeodesicDistance::GetMemoryRemedy() const
{
  return this->Certify ? "use a smaller mesh, a larger Accuracy, or turn Certify off"
                       : "use a smaller mesh, or SetQualityToFast()";
}

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::ComputeDistances(DGGDistanceTask& task)
{
  dgg::PropagationOptions options;
  options.Quality = this->Quality == Automatic ? DGGPropagation::Choose(task.Context.Surface)
    : this->Quality == High                    ? dgg::PropagationQuality::High
                                               : dgg::PropagationQuality::Fast;
  options.MaximumDistance = task.MaximumDistance;
  options.WantNearestSource = task.WantNearestSource;
  options.WantVirtualSource = task.WantVirtualSource;
  DGGGraphUser& graph = *this->GraphUser;
  std::vector<dgg::GraphSeed> seeds;
  const vtkMTimeType meshTime = this->Certify ? 0 : task.Context.Surface.GetBuildTime();
  if (this->MeshTime != meshTime)
  {
    this->MeshTime = meshTime;
    this->QualityWarning = !this->Certify && DGGWarnOfLongTriangles(this);
  }
  if (this->Certify)
  {
    DGG_RETURN_IF_ERROR(graph.Update(task.Context, this));
    if (!graph.IsGuaranteed())
    {
      return dgg::Status::Invalid("Certify needs a graph that keeps to an accuracy, unlike the one "
                                  "on the input: build it with the construction Guaranteed, or "
                                  "turn Certify off");
    }
    DGG_RETURN_IF_ERROR(graph.MakeSeeds(task.Context, task.Sources, seeds));
    // What the graph certifies to be within the limit may be farther by virtual sources.
    options.MaximumDistance = task.WantNearestSource || task.WantVirtualSource
      ? dgg::Infinity
      : graph.WidenLimit(task.MaximumDistance, task.Sources);
    options.Progress =
      dgg::ProgressPart(graph.GetRemainingProgress(task.Context), 0.0, CertifyStart);
  }
  dgg::PropagationResult result;
  DGG_RETURN_IF_ERROR(this->Propagation->Run(task.Context, task.Sources, options, result));
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  task.VirtualSource = std::move(result.Virtual);
  return this->Certify ? this->ClampToGraph(seeds, task) : dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::ClampToGraph(
  const std::vector<dgg::GraphSeed>& seeds, DGGDistanceTask& task)
{
  DGGGraphUser& graph = *this->GraphUser;
  dgg::SearchOptions options;
  options.Correct = task.WantVirtualSource;
  options.MaximumDistance = graph.WidenLimit(task.MaximumDistance, task.Sources);
  options.Progress = dgg::ProgressPart(graph.GetRemainingProgress(task.Context), CertifyStart, 1.0);
  dgg::SearchResult result;
  DGG_RETURN_IF_ERROR(graph.GetSearch().Run(seeds, options, result));
  const std::vector<double> estimates = task.Distances;
  dgg::ClampToLabels(graph.GetSearch().GetGraph(), seeds, result.Distances, task.Distances);
  // What was not within the interval came from the wrong source.
  dgg::VirtualSources sources;
  if (task.WantVirtualSource)
  {
    dgg::FindVirtualSources(task.Context.Surface.GetMesh(), result, sources, task.Context.Parallel);
  }
  for (std::size_t v = 0; v < estimates.size(); ++v)
  {
    if (task.Distances[v] == estimates[v])
    {
      continue;
    }
    if (task.WantNearestSource)
    {
      const dgg::Id seed = result.Seeds[v];
      task.NearestSource[v] = seed == dgg::NoId ? dgg::NoId : seeds[seed].Source;
    }
    if (task.WantVirtualSource)
    {
      task.VirtualSource.Lengths[v] = sources.Lengths[v];
      task.VirtualSource.Angles[v] = sources.Angles[v];
      task.VirtualSource.Offsets[v] = task.Distances[v] - sources.Lengths[v];
    }
  }
  return dgg::Status::Success();
}
