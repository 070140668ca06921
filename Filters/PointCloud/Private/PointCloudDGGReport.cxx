// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: getters and warnings.
#include "PointCloudDGGInternals.h"

#include <cmath>

vtkDGGResultMacro(
  vtkPointCloudDGG, vtkIdType, NumberOfUnusedPoints, Current.Statistics.UnusedPoints);
vtkDGGResultMacro(vtkPointCloudDGG, vtkIdType, NumberOfOutliers, Current.Statistics.Outliers);
vtkDGGResultMacro(
  vtkPointCloudDGG, vtkIdType, NumberOfCoincidentPoints, Current.Statistics.CoincidentPoints);
vtkDGGResultMacro(vtkPointCloudDGG, double, UsedOffsetInVoxels, Current.Statistics.OffsetInVoxels);
vtkDGGResultMacro(vtkPointCloudDGG, int, UsedResolution, Current.Statistics.Resolution);
vtkDGGResultMacro(vtkPointCloudDGG, double, UsedAlpha, Current.Statistics.Alpha);
vtkDGGResultMacro(vtkPointCloudDGG, double, VoxelSize, Current.Statistics.VoxelSize);
vtkDGGResultMacro(vtkPointCloudDGG, double, Spacing, Current.Statistics.Spacing);
vtkDGGResultMacro(vtkPointCloudDGG, double, Noise, Current.Statistics.Noise);
vtkDGGResultMacro(vtkPointCloudDGG, double, OffSurfaceShare, Current.Statistics.OffSurface);
vtkDGGResultMacro(vtkPointCloudDGG, double, NoiseByRadius, Current.Statistics.NoiseByRadius);
vtkDGGResultMacro(vtkPointCloudDGG, double, Scatter, Current.Statistics.Scatter);
vtkDGGResultMacro(vtkPointCloudDGG, double, Reach, Current.Statistics.Reach);

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
vtkDGGResultMacro(vtkPointCloudDGG, vtkTypeUInt64, EstimatedMemory, Estimate.Memory);

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::GetEstimatedPeakMemory() const
{
  return static_cast<vtkTypeUInt64>(
    std::ceil(this->GetInternals().Estimate.Peak)); // rounded up, so that it suffices as a limit
}

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkPointCloudDGG, vtkIdType, NumberOfGraphEdges, Current.Graph.NumberOfEdges);

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetMeanDegree() const
{
  const dgg::GraphSummary& graph = this->GetInternals().Current.Graph;
  return graph.NumberOfVertices > 0
    ? static_cast<double>(graph.NumberOfEdges) / graph.NumberOfVertices
    : 0.0;
}

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkPointCloudDGG, vtkTypeUInt64, MemorySize, Current.Graph.MemorySize);
vtkDGGResultMacro(vtkPointCloudDGG, vtkIdType, NumberOfComponents, Current.ComponentSizes.size());

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
vtkDGGResultMacro(vtkPointCloudDGG, vtkMTimeType, GraphBuildTime, BuildTime.GetMTime());
