// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGDistance.h"

#include "DGGDistanceInternals.h"
#include "DGGGraphUser.h"

#include "dggPreparedSurface.h"
#include "dggSourceFinding.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkDGGDistance);

namespace
{
void ReplaceBySources(const std::vector<dgg::GraphSeed>& seeds, std::vector<dgg::Id>& indices)
{
  std::transform(indices.begin(), indices.end(), indices.begin(),
    [&](dgg::Id seed) { return seed == dgg::NoId ? dgg::NoId : seeds[seed].Source; });
}

/// Returns the values at the given vertices.
template <typename Value>
std::vector<Value> Select(const std::vector<Value>& values, const std::vector<dgg::Id>& vertices)
{
  std::vector<Value> selected(vertices.size());
  std::transform(vertices.begin(), vertices.end(), selected.begin(),
    [&](dgg::Id vertex) { return values[vertex]; });
  return selected;
}
}

//------------------------------------------------------------------------------
class vtkDGGDistance::vtkInternals
  : public DGGGraphInternalsOf<vtkDGGDistance, DGGDistanceInternals>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status ComputeDistances(DGGDistanceTask& task) override;
  std::vector<dgg::VertexArray> DeclareArrays() const override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, a larger {Accuracy} or a {MaximumDistance}";
  }
};

vtkDGGInternalsMacro(vtkDGGDistance);
vtkDGGGraphUserMacro(vtkDGGDistance);

//------------------------------------------------------------------------------
vtkDGGDistance::vtkDGGDistance()
  : Correction(true)
  , Search(Certified)
  , GenerateUpperBound(false)
  , UpperBoundArrayName("GeodesicUpperBound")
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
void vtkDGGDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->GetInternals().GraphUser.PrintSelf(os, indent);
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
std::vector<dgg::VertexArray> vtkDGGDistance::vtkInternals::DeclareArrays() const
{
  if (!this->Self->GenerateUpperBound)
  {
    return {};
  }
  return { { this->Self->UpperBoundArrayName, "UpperBoundArrayName",
    std::vector<std::vector<double>>(1) } };
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGDistance::vtkInternals::ComputeDistances(DGGDistanceTask& task)
{
  const DGGContext& context = task.Context;
  const bool isCloud = context.Surface.IsCloud();
  const bool correct = this->Self->Correction && !isCloud;
  DGGGraphUser& graph = this->GraphUser;
  DGG_RETURN_IF_ERROR(graph.Update(context, this->Self));
  std::vector<dgg::GraphSeed> seeds;
  DGG_RETURN_IF_ERROR(graph.MakeSeeds(context, task.Sources, seeds));

  const dgg::SearchMethod methods[] = { dgg::SearchMethod::Certified,
    dgg::SearchMethod::LabelCorrecting, dgg::SearchMethod::Dijkstra };
  dgg::SearchOptions options;
  options.Method = methods[this->Self->Search];
  options.Correct = correct || task.WantVirtualSource;
  options.MaximumDistance =
    correct ? graph.WidenLimit(task.MaximumDistance, task.Sources) : task.MaximumDistance;
  options.Progress = graph.GetRemainingProgress(context);
  dgg::SearchResult& result = graph.GetResult();
  DGG_RETURN_IF_ERROR(graph.GetSearch().Run(seeds, options, result));
  if (task.WantVirtualSource)
  {
    dgg::FindVirtualSources(context.Surface.GetMesh(), result,
      correct ? result.Corrected : result.Distances, task.VirtualSource, context.Parallel);
  }
  task.IsSparse = task.MayBeSparse && !task.WantVirtualSource && result.IsLocal();
  if (task.IsSparse)
  {
    task.Vertices = result.Reached;
  }
  const auto take = [&](auto& values) {
    return task.IsSparse ? Select(values, task.Vertices) : std::move(values);
  };
  if (task.WantNearestSource)
  {
    task.NearestSource = take(result.Seeds);
    ReplaceBySources(seeds, task.NearestSource);
  }
  for (dgg::VertexArray& array : task.Arrays)
  {
    array.Components = { task.IsSparse ? Select(result.Distances, task.Vertices)
                                       : result.Distances };
  }
  task.Distances = take(correct ? result.Corrected : result.Distances);
  if (!task.IsSparse)
  {
    result = dgg::SearchResult();
  }
  return dgg::Status::Success();
}
