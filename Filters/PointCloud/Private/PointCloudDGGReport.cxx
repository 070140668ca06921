// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: getters and warnings.
#include "PointCloudDGGInternals.h"

#include "dggCounted.h"

#include <cmath>

namespace
{
/// Largest ratio of noise to radius of curvature without a warning: distances on spheres are then 1
/// % too short.
constexpr double LargestNoiseByRadius = 0.07;
}

/// Defines the getter of a number of the last update's graph.
#define vtkPointCloudDGGNumberMacro(Type, Name, member)    \
  Type vtkPointCloudDGG::Get##Name() const                 \
  {                                                        \
    return this->GetInternals().Current.Statistics.member; \
  }
vtkPointCloudDGGNumberMacro(vtkIdType, NumberOfUnusedPoints, UnusedPoints);
vtkPointCloudDGGNumberMacro(vtkIdType, NumberOfOutliers, Outliers);
vtkPointCloudDGGNumberMacro(vtkIdType, NumberOfCoincidentPoints, CoincidentPoints);
vtkPointCloudDGGNumberMacro(double, UsedOffsetInVoxels, OffsetInVoxels);
vtkPointCloudDGGNumberMacro(int, UsedResolution, Resolution);
vtkPointCloudDGGNumberMacro(double, UsedAlpha, Alpha);
vtkPointCloudDGGNumberMacro(double, VoxelSize, VoxelSize);
vtkPointCloudDGGNumberMacro(double, Spacing, Spacing);
vtkPointCloudDGGNumberMacro(double, Noise, Noise);
vtkPointCloudDGGNumberMacro(double, OffSurfaceShare, OffSurface);
vtkPointCloudDGGNumberMacro(double, NoiseByRadius, NoiseByRadius);
vtkPointCloudDGGNumberMacro(double, Scatter, Scatter);
vtkPointCloudDGGNumberMacro(double, Reach, Reach);

//------------------------------------------------------------------------------
void vtkPointCloudDGG::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->GetSchemeAsString() << "\n";
  os << indent << "OffsetInVoxels: " << this->OffsetInVoxels << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "ArcLengthWeights: " << (this->ArcLengthWeights ? "On" : "Off") << "\n";
  os << indent << "UseInputNormals: " << (this->UseInputNormals ? "On" : "Off") << "\n";
  os << indent << "OrientedNormals: " << (this->OrientedNormals ? "On" : "Off") << "\n";
  os << indent << "EstimateNormals: " << (this->EstimateNormals ? "On" : "Off") << "\n";
  os << indent << "GenerateVertices: " << (this->GenerateVertices ? "On" : "Off") << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "ComponentArrayName: " << this->ComponentArrayName << "\n";
  os << indent << "EstimatedMemory: " << this->GetEstimatedMemory() << "\n";
  os << indent << "EstimatedPeakMemory: " << this->GetEstimatedPeakMemory() << "\n";
  os << indent << "NumberOfGraphEdges: " << this->GetNumberOfGraphEdges() << "\n";
  os << indent << "MeanDegree: " << this->GetMeanDegree() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "NumberOfComponents: " << this->GetNumberOfComponents() << "\n";
  os << indent << "NumberOfUnusedPoints: " << this->GetNumberOfUnusedPoints() << "\n";
  os << indent << "NumberOfOutliers: " << this->GetNumberOfOutliers() << "\n";
  os << indent << "NumberOfCoincidentPoints: " << this->GetNumberOfCoincidentPoints() << "\n";
  os << indent << "UsedOffsetInVoxels: " << this->GetUsedOffsetInVoxels() << "\n";
  os << indent << "UsedOffset: " << this->GetUsedOffset() << "\n";
  os << indent << "UsedResolution: " << this->GetUsedResolution() << "\n";
  os << indent << "UsedAlpha: " << this->GetUsedAlpha() << "\n";
  os << indent << "VoxelSize: " << this->GetVoxelSize() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Noise: " << this->GetNoise() << "\n";
  os << indent << "OffSurfaceShare: " << this->GetOffSurfaceShare() << "\n";
  os << indent << "NoiseByRadius: " << this->GetNoiseByRadius() << "\n";
  os << indent << "Scatter: " << this->GetScatter() << "\n";
  os << indent << "Reach: " << this->GetReach() << "\n";
  os << indent << "GraphBuildTime: " << this->GetGraphBuildTime() << "\n";
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::GetEstimatedMemory() const
{
  return static_cast<vtkTypeUInt64>(this->GetInternals().Estimate.Memory);
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::GetEstimatedPeakMemory() const
{
  return static_cast<vtkTypeUInt64>(
    std::ceil(this->GetInternals().Estimate.Peak)); // rounded up, so that it suffices as a limit
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfGraphEdges() const
{
  return this->GetInternals().Current.Graph.NumberOfEdges;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetMeanDegree() const
{
  const dgg::GraphSummary& graph = this->GetInternals().Current.Graph;
  return graph.NumberOfVertices > 0
    ? static_cast<double>(graph.NumberOfEdges) / graph.NumberOfVertices
    : 0.0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::GetMemorySize() const
{
  return this->GetInternals().Current.Graph.MemorySize;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfComponents() const
{
  return static_cast<vtkIdType>(this->GetInternals().Current.ComponentSizes.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetComponentSize(vtkIdType i) const
{
  return i >= 0 && i < this->GetNumberOfComponents()
    ? this->GetInternals().Current.ComponentSizes[i]
    : 0;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetUsedOffset() const
{
  return this->GetUsedOffsetInVoxels() * this->GetVoxelSize();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointCloudDGG::GetGraphBuildTime() const
{
  return this->GetInternals().BuildTime.GetMTime();
}

//------------------------------------------------------------------------------
/// Warns about the points of a graph that has just been built.
void vtkPointCloudDGG::vtkInternals::WarnAboutPoints()
{
  const dgg::Id unused = this->Current.Statistics.UnusedPoints;
  if (unused > 0)
  {
    this->Warn(dgg::JoinText("The cloud has ", dgg::Counted(unused, "point"),
      " with a coordinate that is not finite. Such points have no edges in the graph"));
  }
  const dgg::Id outliers = this->Current.Statistics.Outliers;
  if (outliers > 0)
  {
    this->Warn(dgg::JoinText("The cloud has ", dgg::Counted(outliers, "point"),
      " more than 1000 times as far away as all others. The graph connects such points only to "
      "points at the same position"));
  }
  const dgg::CloudGraphStatistics& statistics = this->Current.Statistics;
  if (statistics.Scatter > 0.0)
  {
    this->Warn(dgg::JoinText("The neighbors of ", 100.0 * statistics.OffSurface,
      " % of the points do not lie on a surface: points typically scatter by ", statistics.Scatter,
      " times their spacing. Such noise is removed in part only, so distances may be far off. Thin "
      "the cloud, for example to every tenth point or to averages of points, until points scatter "
      "by less than their spacing"));
  }
  else if (statistics.NoiseByRadius > LargestNoiseByRadius)
  {
    this->Warn(dgg::JoinText("The noise of the points, ", statistics.Noise, ", is ",
      statistics.NoiseByRadius,
      " of the typical radius of curvature. After its removal distances may be off by 1 % or more, "
      "mostly too short. Use points with less noise if that matters"));
  }
}

//------------------------------------------------------------------------------
/// Warns if voxels of a graph that has just been built are coarser than the points.
void vtkPointCloudDGG::vtkInternals::WarnAboutVoxels(const dgg::CloudGraphOptions& options)
{
  const dgg::CloudGraphStatistics& used = this->Current.Statistics;
  if (used.Spacing > 0.0 && used.VoxelSize > used.Spacing)
  {
    const bool isGiven = options.OffsetInVoxels > 0.0;
    this->Warn(dgg::JoinText("The voxels of the band, of size ", used.VoxelSize, " ({Resolution} ",
      used.Resolution, options.Resolution > 0 ? "" : ", automatic",
      "), are larger than the spacing of the points, which is ", used.Spacing, ". ",
      isGiven
        ? "The graph bridges gaps and holes, and may connect separate or split connected parts"
        : "Building is slower",
      ". ",
      options.Resolution > 0 || isGiven
        ? "Use a larger {Resolution}"
        : "Parts of the cloud are much sparser than others. Exclude these parts, or build separate "
          "graphs, if that matters"));
  }
}
