// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGDistance.h"

#include "vtkDGGDistanceTask.h"
#include "vtkDGGGraphProvider.h"
#include "vtkDGGMeshAdapter.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkDGGDistance);

namespace
{
/// Rounding of lengths in the graph, relative: a point must not be missed because of it.
constexpr double LengthRounding = 1e-6;

/// Which of the additional arrays is which.
constexpr const char* UpperBoundProperty = "UpperBoundArrayName";
constexpr const char* VirtualSourceProperty = "VirtualSourceArrayName";

/// How far to search so that every point closer than `maximum` is reached through the graph.
double WidenLimit(double maximum, double accuracy, const std::vector<dgg::GeodesicSource>& sources)
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
  return maximum + (accuracy + LengthRounding) * std::max(0.0, maximum - offset);
}

bool WantsVirtualSource(const vtkDGGDistanceTask& task)
{
  return std::any_of(task.Arrays.begin(), task.Arrays.end(),
    [](const vtkDGGPointArray& array) { return array.Property == VirtualSourceProperty; });
}

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
  : Accuracy(0.01)
  , IsAccuracyExplicit(false)
  , Correction(true)
  , Search(Certified)
  , MemoryLimit(0)
  , GenerateUpperBound(false)
  , GenerateVirtualSource(false)
  , UpperBoundArrayName("GeodesicUpperBound")
  , VirtualSourceArrayName("GeodesicVirtualSource")
  , Provider(new vtkDGGGraphProvider)
{
}

//------------------------------------------------------------------------------
vtkDGGDistance::~vtkDGGDistance() = default;

//------------------------------------------------------------------------------
void vtkDGGDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const searches[] = { "Certified", "LabelCorrecting", "Dijkstra" };
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "Correction: " << (this->Correction ? "On" : "Off") << "\n";
  os << indent << "Search: " << searches[this->Search] << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "GenerateUpperBound: " << (this->GenerateUpperBound ? "On" : "Off") << "\n";
  os << indent << "GenerateVirtualSource: " << (this->GenerateVirtualSource ? "On" : "Off") << "\n";
  os << indent << "UpperBoundArrayName: " << this->UpperBoundArrayName << "\n";
  os << indent << "VirtualSourceArrayName: " << this->VirtualSourceArrayName << "\n";
  os << indent << "UsedInputGraph: " << (this->GetUsedInputGraph() ? "yes" : "no") << "\n";
  os << indent << "GraphAccuracy: " << this->GetGraphAccuracy() << "\n";
  os << indent << "GraphIsGuaranteed: " << (this->GetGraphIsGuaranteed() ? "yes" : "no") << "\n";
  os << indent << "NumberOfGraphEdges: " << this->GetNumberOfGraphEdges() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "GraphBuildTime: " << this->GetGraphBuildTime() << "\n";
}

//------------------------------------------------------------------------------
void vtkDGGDistance::SetAccuracy(double accuracy)
{
  if (this->Accuracy != accuracy || !this->IsAccuracyExplicit)
  {
    this->Accuracy = accuracy;
    this->IsAccuracyExplicit = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkDGGDistance::SetUpperBoundArrayName(const char* name)
{
  this->SetName(this->UpperBoundArrayName, name);
}

//------------------------------------------------------------------------------
const char* vtkDGGDistance::GetUpperBoundArrayName() const
{
  return this->UpperBoundArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkDGGDistance::SetVirtualSourceArrayName(const char* name)
{
  this->SetName(this->VirtualSourceArrayName, name);
}

//------------------------------------------------------------------------------
const char* vtkDGGDistance::GetVirtualSourceArrayName() const
{
  return this->VirtualSourceArrayName.c_str();
}

//------------------------------------------------------------------------------
bool vtkDGGDistance::GetUsedInputGraph() const
{
  return this->Provider->IsFromInput();
}

//------------------------------------------------------------------------------
double vtkDGGDistance::GetGraphAccuracy() const
{
  return this->Provider->HasGraph() ? this->Provider->GetGraph().Info.Accuracy : 0.0;
}

//------------------------------------------------------------------------------
bool vtkDGGDistance::GetGraphIsGuaranteed() const
{
  return this->Provider->HasGraph() && this->Provider->GetGraph().Info.IsGuaranteed();
}

//------------------------------------------------------------------------------
vtkIdType vtkDGGDistance::GetNumberOfGraphEdges() const
{
  return this->Provider->HasGraph() ? this->Provider->GetGraph().GetNumberOfEdges() : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDGGDistance::GetMemorySize() const
{
  return this->Provider->GetMemorySize();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkDGGDistance::GetGraphBuildTime() const
{
  return this->Provider->GetBuildTime();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::CheckProperties() const
{
  dgg::GraphOptions options;
  options.Accuracy = this->Accuracy;
  const dgg::Status status = dgg::GraphBuilder::Check(options);
  return status.IsOk() ? this->Superclass::CheckProperties() : status;
}

//------------------------------------------------------------------------------
std::string vtkDGGDistance::GetMemoryRemedy() const
{
  return "use a smaller mesh, a larger Accuracy or MaximumDistance";
}

//------------------------------------------------------------------------------
std::vector<vtkDGGPointArray> vtkDGGDistance::DeclareArrays() const
{
  std::vector<vtkDGGPointArray> arrays;
  if (this->GenerateUpperBound)
  {
    arrays.push_back(
      { this->UpperBoundArrayName, UpperBoundProperty, std::vector<std::vector<double>>(1) });
  }
  if (this->GenerateVirtualSource)
  {
    arrays.push_back(
      { this->VirtualSourceArrayName, VirtualSourceProperty, std::vector<std::vector<double>>(3) });
  }
  return arrays;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::ComputeDistances(vtkDGGDistanceTask& task)
{
  const bool correct = this->Correction; // observers may change it
  dgg::Status status = this->Provider->Update({ task.Input, this->GetMesh(), this->Accuracy,
    this->IsAccuracyExplicit, this->MemoryLimit, task.Progress, this });
  std::vector<dgg::GraphSeed> seeds;
  for (std::size_t i = 0; i < task.Sources.size() && status.IsOk(); ++i)
  {
    status =
      this->Provider->AddSeeds(task.Sources[i], static_cast<dgg::Id>(i), this->GetMesh(), seeds);
  }
  if (!status.IsOk())
  {
    return status;
  }

  const dgg::SearchMethod methods[] = { dgg::SearchMethod::Certified,
    dgg::SearchMethod::LabelCorrecting, dgg::SearchMethod::Dijkstra };
  dgg::SearchOptions options;
  options.Method = methods[this->Search];
  options.Correct = correct || WantsVirtualSource(task);
  options.MaximumDistance = correct
    ? WidenLimit(task.MaximumDistance, this->Provider->GetLinkAccuracy(), task.Sources)
    : task.MaximumDistance;
  options.Progress = this->Provider->GetRemainingProgress();
  dgg::SearchResult result;
  status = this->Provider->GetSearch().Run(seeds, options, result);
  if (!status.IsOk())
  {
    return status;
  }
  if (task.WantNearestSource)
  {
    task.NearestSource = FindSources(seeds, result.Seeds);
  }
  for (vtkDGGPointArray& array : task.Arrays)
  {
    if (array.Property == UpperBoundProperty)
    {
      array.Components = { result.Distances };
    }
    else
    {
      array.Components = { std::move(result.VirtualOffset), std::move(result.VirtualLength),
        std::move(result.VirtualAngle) };
    }
  }
  task.Distances = std::move(correct ? result.Corrected : result.Distances);
  return status;
}
