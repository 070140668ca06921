// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudGraphBuilder.h"

#include "dggCloudAssembly.h"
#include "dggCloudRows.h"
#include "dggCloudSetup.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Progress weight of the setup, and total progress at the end of each later step.
constexpr double ShareOfSetup = 0.15;
constexpr double EndOfPrediction = 0.16;
constexpr double EndOfRows = 0.9;
constexpr double EndOfGraph = 0.99;
/// Progress weight of the setup in Estimate().
constexpr double ShareOfSetupToPredict = 0.8;
/// Measured ratio of the number of edges in the graph to the number of selected targets. The union
/// of both directions adds edges.
constexpr double UnitedShare = 1.3;
constexpr double LargestAccuracy = 0.5;
/// Memory per point, in bytes, of per-point lists during the assembly of the graph.
constexpr double BytesPerPointOfGraph = 40.0;

GraphConstruction ConstructionOf(CloudScheme scheme)
{
  switch (scheme)
  {
    case CloudScheme::Curvature:
      return GraphConstruction::CloudCurvature;
    case CloudScheme::Constant:
      return GraphConstruction::CloudConstant;
    case CloudScheme::Spacing:
      break;
  }
  return GraphConstruction::CloudSpacing;
}

/// Returns true if lengths must be stored as double. As float, sums of lengths could overflow, or
/// tiny edges become denormal.
bool NeedsWide(const CloudNodes& nodes, double accuracy)
{
  const double extent = nodes.Extent / nodes.Scale;
  return NeedsWideLengths(accuracy) || extent > 1e30 || (extent > 0.0 && extent < 1e-20);
}

std::size_t BytesPerEdge(bool wide)
{
  return sizeof(Id) + (wide ? sizeof(double) : sizeof(float));
}

/// Predicts size and memory from the rows of a sample of nodes. The peak is the maximum over three
/// phases: before the rows, building the rows, and assembling the graph.
CloudGraphEstimate PredictFrom(const CloudSetup& setup, const CloudGraphOptions& options,
  int numberOfThreads, Id numberOfPoints, const RowSample& sample)
{
  CloudGraphEstimate estimate;
  const auto nodes = static_cast<double>(setup.Pairs.Points.size());
  const auto perEdge = static_cast<double>(BytesPerEdge(NeedsWide(setup.Nodes, options.Accuracy)));
  const auto coincident = static_cast<double>(setup.Nodes.Coincident.size());
  estimate.Edges = UnitedShare * sample.MeanTargets * nodes + 2.0 * coincident;
  estimate.Memory = estimate.Edges * perEdge + (numberOfPoints + 1.0) * sizeof(Offset);

  const auto held = static_cast<double>(setup.GetMemorySize());
  const double rows = sample.MeanTargets * nodes * sizeof(Id);
  const double threads = std::clamp(
    nodes / sample.GetRowsPerBlock(), 1.0, static_cast<double>(std::max(1, numberOfThreads)));
  const double graph = BytesPerPointOfGraph * numberOfPoints +
    std::max(rows + estimate.Edges * sizeof(Id), estimate.Edges * perEdge);
  estimate.Peak = std::max({ static_cast<double>(setup.GetMemoryBefore(numberOfPoints)),
    held + rows + threads * sample.GetThreadMemory(), held + graph });
  return estimate;
}

Status BuildGraph(const double* points, Id numberOfPoints, const CloudGraphOptions& options,
  CloudGraph& result, CloudGraphStatistics& statistics)
{
  CloudSetup setup;
  DGG_RETURN_IF_ERROR(SetUpCloud(points, numberOfPoints, options,
    ProgressPart(options.Progress, 0.0, ShareOfSetup), setup, statistics));
  statistics.BandMemory += setup.Pairs.Nearest.size() * sizeof(Id);
  RowSample sample;
  DGG_RETURN_IF_ERROR(SampleRows(
    setup, options, ProgressPart(options.Progress, ShareOfSetup, EndOfPrediction), sample));
  // BuildRows() uses the number of threads that fits, so success does not depend on this number.
  const double least = PredictFrom(setup, options, 1, numberOfPoints, sample).Peak;
  DGG_RETURN_IF_ERROR(CheckRowMemory(least, options.MemoryLimit));
  std::vector<CloudRowBlock> blocks;
  DGG_RETURN_IF_ERROR(BuildRows(
    setup, options, ProgressPart(options.Progress, EndOfPrediction, EndOfRows), sample, blocks));
  const bool wide = NeedsWide(setup.Nodes, options.Accuracy);
  DGG_RETURN_IF_ERROR(AssembleCloudGraph(setup, numberOfPoints, sample.GetRowsPerBlock(), blocks,
    wide, options.Parallel, ProgressPart(options.Progress, EndOfRows, EndOfGraph), result.Graph));
  const auto n = static_cast<std::size_t>(numberOfPoints);
  std::vector<unsigned char> isUsed(n, 0);
  result.Radii.assign(n, 0.0);
  const double toPoints = 1.0 / setup.Nodes.Scale;
  for (std::size_t node = 0; node < setup.Nodes.Originals.size(); ++node)
  {
    isUsed[setup.Nodes.Originals[node]] = 1;
    result.Radii[setup.Nodes.Originals[node]] = toPoints * setup.Pairs.Radii[node];
  }
  for (const Id point : setup.Nodes.Outliers)
  {
    isUsed[point] = 1;
  }
  for (const auto& [point, original] : setup.Nodes.Coincident)
  {
    isUsed[point] = 1;
    result.Radii[point] = result.Radii[original];
  }
  result.VoxelSize = toPoints * setup.Pairs.Band.GetVoxelSize();
  DGG_RETURN_IF_ERROR(ReportTo(options.Progress, EndOfGraph));
  FindCloudComponents(result.Graph, isUsed, result.Components, result.ComponentSizes);
  result.Graph.Info.Kind = GraphKind::Cloud;
  result.Graph.Info.Construction = ConstructionOf(options.Scheme);
  result.Graph.Info.Accuracy = options.Accuracy;
  return ReportTo(options.Progress, 1.0);
}
}

CloudGraphBuilder::CloudGraphBuilder(const double* points, Id numberOfPoints)
  : Points(points)
  , NumberOfPoints(numberOfPoints)
{
}

Status CloudGraphBuilder::Check(const CloudGraphOptions& options)
{
  if (!(options.OffsetInVoxels == 0.0 ||
        (options.OffsetInVoxels >= 0.5 && options.OffsetInVoxels <= 1000.0)))
  {
    // Smaller balls may contain no voxel center.
    return InvalidValue("OffsetInVoxels", options.OffsetInVoxels)
      .Fix("Use a number from 0.5 to 1000, or 0 for an automatic one");
  }
  if (options.Resolution < 0 || options.Resolution > LargestResolution)
  {
    return InvalidValue("Resolution", options.Resolution)
      .Fix("Use a number of at most ", LargestResolution, ", or 0 for an automatic one");
  }
  if (!(options.Alpha == 0.0 || (options.Alpha >= 1e-3 && options.Alpha <= 1e6)))
  {
    return InvalidValue("Alpha", options.Alpha)
      .Fix("Use a number from 1e-3 to 1e6, or 0 for an automatic one");
  }
  if (!(options.Accuracy == 0.0 ||
        (options.Accuracy >= 1e-6 && options.Accuracy <= LargestAccuracy)))
  {
    return InvalidValue("Accuracy", options.Accuracy)
      .Fix("Use a number from 1e-6 to ", LargestAccuracy, ", or 0 for all edges");
  }
  if (options.HasOrientedNormals && !options.Normals)
  {
    return InvalidInput("There are no normals, which {OrientedNormals} needs")
      .At("OrientedNormals")
      .Fix("Pass normals");
  }
  return Status::Success();
}

Status CloudGraphBuilder::Estimate(
  const CloudGraphOptions& options, CloudGraphEstimate& estimate) const
{
  estimate = CloudGraphEstimate();
  DGG_RETURN_IF_ERROR(Check(options));
  CloudSetup setup;
  CloudGraphStatistics statistics;
  const ProgressCallback& progress = options.Progress;
  DGG_RETURN_IF_ERROR(SetUpCloud(this->Points, this->NumberOfPoints, options,
    ProgressPart(progress, 0.0, ShareOfSetupToPredict), setup, statistics));
  RowSample sample;
  DGG_RETURN_IF_ERROR(
    SampleRows(setup, options, ProgressPart(progress, ShareOfSetupToPredict, 1.0), sample));
  estimate = PredictFrom(setup, options, options.NumberOfThreads, this->NumberOfPoints, sample);
  return Status::Success();
}

Status CloudGraphBuilder::Build(
  const CloudGraphOptions& options, CloudGraph& result, CloudGraphStatistics* statistics) const
{
  result = CloudGraph();
  CloudGraphStatistics local;
  Status status = Check(options);
  status =
    status.IsOk() ? BuildGraph(this->Points, this->NumberOfPoints, options, result, local) : status;
  if (!status.IsOk())
  {
    result = CloudGraph();
  }
  if (statistics)
  {
    *statistics = local;
  }
  return status;
}
}
