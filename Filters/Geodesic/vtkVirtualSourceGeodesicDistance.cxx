// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSourceGeodesicDistance.h"

#include "DGGDistanceTask.h"
#include "DGGGraphUser.h"
#include "DGGMeshQuality.h"

#include "dggProgressPart.h"
#include "dggSourcePropagation.h"

#include "vtkObjectFactory.h"

#include <utility>

vtkStandardNewMacro(vtkVirtualSourceGeodesicDistance);
vtkDGGGraphUserMacro(vtkVirtualSourceGeodesicDistance);

namespace
{
/// Smaller meshes are done before other threads have started.
constexpr dgg::Id FacesForThreads = 20000;
/// Share of the progress, after the graph, that comes before the search in it.
constexpr double CertifyStart = 0.5;
}

/// Kept until the mesh changes.
struct vtkVirtualSourceGeodesicDistance::Preparation
{
  vtkMTimeType MeshTime;
  dgg::SourcePropagation Solver;
};

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::vtkVirtualSourceGeodesicDistance()
  : Quality(Automatic)
  , Certify(false)
  , GraphUser(new DGGGraphUser)
{
}

//------------------------------------------------------------------------------
vtkVirtualSourceGeodesicDistance::~vtkVirtualSourceGeodesicDistance() = default;

//------------------------------------------------------------------------------
void vtkVirtualSourceGeodesicDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->GraphUser->PrintSelf(os, indent, this->MemoryLimit);
  os << indent << "Quality: " << this->GetQualityAsString() << "\n";
  os << indent << "Certify: " << (this->Certify ? "On" : "Off") << "\n";
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
                       : this->Superclass::GetMemoryRemedy();
}

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::ComputeDistances(DGGDistanceTask& task)
{
  if (this->Certify)
  {
    DGG_RETURN_IF_ERROR(this->GraphUser->Update(task.Context, this));
    if (!this->GraphUser->IsGuaranteed())
    {
      return dgg::Status::Invalid("Certify needs a graph that keeps to an accuracy, unlike the one "
                                  "on the input: build it with the construction Guaranteed, or "
                                  "turn Certify off");
    }
  }
  const DGGPreparedMesh& surface = task.Context.Surface;
  const dgg::SurfaceMesh& mesh =
    task.WantVirtualSource ? surface.GetMesh() : surface.GetMeshWithoutAngles();
  if (!this->Prepared || this->Prepared->MeshTime != surface.GetBuildTime())
  {
    this->Prepared.reset(); // before there are two
    this->Prepared.reset(new Preparation{ surface.GetBuildTime(), dgg::SourcePropagation(mesh) });
  }
  const bool isHigh = this->Quality == High ||
    (this->Quality == Automatic && this->GetMedianAnisotropy() > DGGMostAnisotropy);
  dgg::PropagationOptions options;
  options.Quality = isHigh ? dgg::PropagationQuality::High : dgg::PropagationQuality::Fast;
  // What the graph certifies to be within the limit must not be missed.
  options.MaximumDistance = this->Certify ? dgg::Infinity : task.MaximumDistance;
  options.WantNearestSource = task.WantNearestSource;
  options.WantVirtualSource = task.WantVirtualSource;
  if (mesh.GetNumberOfFaces() >= FacesForThreads)
  {
    options.Parallel = task.Context.Parallel;
  }
  options.Progress = this->Certify
    ? dgg::ProgressPart(this->GraphUser->GetRemainingProgress(task.Context), 0.0, CertifyStart)
    : task.Context.Progress;
  dgg::PropagationResult result;
  DGG_RETURN_IF_ERROR(this->Prepared->Solver.Run(task.Sources, options, result));
  task.Distances = std::move(result.Distances);
  task.NearestSource = std::move(result.NearestSource);
  task.VirtualSource = std::move(result.Virtual);
  return this->Certify ? this->ClampToGraph(task) : dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkVirtualSourceGeodesicDistance::ClampToGraph(DGGDistanceTask& task)
{
  DGGGraphUser& graph = *this->GraphUser;
  std::vector<dgg::GraphSeed> seeds;
  DGG_RETURN_IF_ERROR(graph.MakeSeeds(task.Context, task.Sources, seeds));
  dgg::SearchOptions options;
  options.MaximumDistance = graph.WidenLimit(task.MaximumDistance, task.Sources);
  options.Progress = dgg::ProgressPart(graph.GetRemainingProgress(task.Context), CertifyStart, 1.0);
  dgg::SearchResult result;
  DGG_RETURN_IF_ERROR(graph.GetSearch().Run(seeds, options, result));
  dgg::ClampToLabels(graph.GetSearch().GetGraph(), seeds, result.Distances, task.Distances);
  for (std::size_t v = 0; v < task.VirtualSource.Offsets.size(); ++v)
  {
    task.VirtualSource.Offsets[v] = task.Distances[v] - task.VirtualSource.Lengths[v];
  }
  return dgg::Status::Success();
}
