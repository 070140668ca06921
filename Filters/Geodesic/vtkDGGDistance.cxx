// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGDistance.h"

#include "DGGDistanceTask.h"
#include "DGGGraphUser.h"
#include "DGGPreparedMesh.h"

#include "dggSourceFinding.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkDGGDistance);
vtkDGGGraphUserMacro(vtkDGGDistance);

namespace
{
std::vector<dgg::Id> FindSources(
  const std::vector<dgg::GraphSeed>& seeds, const std::vector<dgg::Id>& seedOfVertex)
{
  std::vector<dgg::Id> sources(seedOfVertex.size());
  std::transform(seedOfVertex.begin(), seedOfVertex.end(), sources.begin(),
    [&](dgg::Id seed) { return seed == dgg::NoId ? dgg::NoId : seeds[seed].Source; });
  return sources;
}
}

//------------------------------------------------------------------------------
vtkDGGDistance::vtkDGGDistance()
  : Correction(true)
  , Search(Certified)
  , GenerateUpperBound(false)
  , UpperBoundArrayName("GeodesicUpperBound")
  , GraphUser(new DGGGraphUser)
{
}

//------------------------------------------------------------------------------
vtkDGGDistance::~vtkDGGDistance() = default;

//------------------------------------------------------------------------------
void vtkDGGDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->GraphUser->PrintSelf(os, indent);
  os << indent << "Correction: " << (this->Correction ? "On" : "Off") << "\n";
  os << indent << "Search: " << this->GetSearchAsString() << "\n";
  os << indent << "GenerateUpperBound: " << (this->GenerateUpperBound ? "On" : "Off") << "\n";
  os << indent << "UpperBoundArrayName: " << this->UpperBoundArrayName << "\n";
}

//------------------------------------------------------------------------------
const char* vtkDGGDistance::GetSearchAsString() const
{
  static const char* const names[] = { "Certified", "LabelCorrecting", "Dijkstra" };
  return names[this->Search];
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(this->GraphUser->Check());
  return this->Superclass::CheckProperties();
}

//------------------------------------------------------------------------------
bool vtkDGGDistance::IsCloud(vtkPolyData* input) const
{
  return DGGGraphUser::IsCloud(input);
}

//------------------------------------------------------------------------------
std::string vtkDGGDistance::GetMemoryRemedy() const
{
  return "use a smaller mesh, a larger Accuracy or MaximumDistance";
}

//------------------------------------------------------------------------------
std::vector<DGGPointArray> vtkDGGDistance::DeclareArrays() const
{
  if (!this->GenerateUpperBound)
  {
    return {};
  }
  return { { this->UpperBoundArrayName, "UpperBoundArrayName",
    std::vector<std::vector<double>>(1) } };
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::ComputeDistances(DGGDistanceTask& task)
{
  const DGGContext& context = task.Context;
  const bool isCloud = context.Surface.IsCloud();
  const bool correct = this->Correction && !isCloud;
  DGGGraphUser& graph = *this->GraphUser;
  DGG_RETURN_IF_ERROR(graph.Update(context, this));
  std::vector<dgg::GraphSeed> seeds;
  DGG_RETURN_IF_ERROR(graph.MakeSeeds(context, task.Sources, seeds));

  const dgg::SearchMethod methods[] = { dgg::SearchMethod::Certified,
    dgg::SearchMethod::LabelCorrecting, dgg::SearchMethod::Dijkstra };
  dgg::SearchOptions options;
  options.Method = methods[this->Search];
  options.Correct = correct || task.WantVirtualSource;
  options.MaximumDistance =
    correct ? graph.WidenLimit(task.MaximumDistance, task.Sources) : task.MaximumDistance;
  options.Progress = graph.GetRemainingProgress(context);
  dgg::SearchResult result;
  DGG_RETURN_IF_ERROR(graph.GetSearch().Run(seeds, options, result));
  if (task.WantNearestSource)
  {
    task.NearestSource = FindSources(seeds, result.Seeds);
  }
  if (task.WantVirtualSource)
  {
    dgg::FindVirtualSources(
      context.Surface.GetMesh(), result, task.VirtualSource, context.Parallel);
  }
  for (DGGPointArray& array : task.Arrays)
  {
    array.Components = { result.Distances };
  }
  task.Distances = std::move(correct ? result.Corrected : result.Distances);
  return dgg::Status::Success();
}
