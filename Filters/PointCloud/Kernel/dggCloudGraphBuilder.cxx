// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudGraphBuilder.h"

#include "dggCloudAssembly.h"
#include "dggCloudPruning.h"
#include "dggCloudSetup.h"
#include "dggMemoryLimit.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>

namespace dgg
{
namespace
{
constexpr Id RowsPerBlock = 64;
/// Blocks between two reports of progress: as many as look at that many neighbours, judged by those
/// before them.
constexpr std::size_t CandidatesPerWave = 1 << 19;
constexpr Offset LeastBlocksPerWave = 8;
constexpr Offset MostBlocksPerWave = 512;
/// Rows built for an estimate.
constexpr Id SampleSize = 512;
constexpr Id SamplesPerReport = 16;
constexpr double ShareOfSetup = 0.15;
constexpr double EndOfPrediction = 0.16;
constexpr double EndOfRows = 0.9;
constexpr double EndOfGraph = 0.99;
/// Share of the setup when there is nothing but a prediction.
constexpr double ShareOfSetupToPredict = 0.8;
/// Edges of a graph by edges found, as measured: uniting both directions adds some.
constexpr double UnitedShare = 1.3;
constexpr double LargestAccuracy = 0.5;

/// What one thread needs to build rows.
struct RowWorkspace
{
  RowWorkspace(const CloudSetup& setup, double accuracy)
    : Setup(setup)
    , Pruning(setup.Pairs, accuracy)
  {
  }

  /// Append the targets of a row.
  void Build(Id node, std::vector<Id>& targets)
  {
    const CloudPairs& pairs = this->Setup.Pairs;
    this->Setup.Neighbors->FindWithin(pairs.Points[node], pairs.Reaches[node], this->Found);
    this->Neighbors.clear();
    this->Chords.clear();
    for (const CloudNeighbor& neighbor : this->Found)
    {
      if (neighbor.Point != node)
      {
        this->Neighbors.push_back(neighbor.Point);
        this->Chords.push_back(pairs.Chord(node, neighbor.Point));
      }
    }
    this->Candidates += this->Neighbors.size();
    this->Pruning.ChooseEdges(node, this->Neighbors, this->Chords, targets);
  }

  const CloudSetup& Setup;
  CloudPruning Pruning;
  std::vector<CloudNeighbor> Found;
  std::vector<Id> Neighbors;
  std::vector<double> Chords;
  std::size_t Candidates = 0;
};

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

/// Sums of lengths must stay within the range of float, and tiny edges above its denormals.
bool NeedsWide(const CloudNodes& nodes, double accuracy)
{
  const double extent = nodes.Extent / nodes.Scale;
  return NeedsWideLengths(accuracy) || extent > 1e30 || (extent > 0.0 && extent < 1e-20);
}

std::size_t BytesPerEdge(bool wide)
{
  return sizeof(Id) + (wide ? sizeof(double) : sizeof(float));
}

/// Of what comes before rows, or of rows, graph and what is needed to unite them.
double PredictPeak(const CloudSetup& setup, Id numberOfPoints, double edges, bool wide)
{
  const double points = numberOfPoints;
  const double rows = edges / UnitedShare * sizeof(Id);
  const double arrays = points * (2.0 * sizeof(Offset) + 4.0 * sizeof(Id) + sizeof(double));
  const double graph =
    arrays + std::max(rows + edges * sizeof(Id), edges * static_cast<double>(BytesPerEdge(wide)));
  return std::max(
    static_cast<double>(setup.NormalsMemory + CloudNodes::PredictMemory(numberOfPoints)),
    static_cast<double>(setup.GetMemorySize()) + graph);
}

/// Predict from the rows of some nodes, evenly spread.
Status PredictFrom(const CloudSetup& setup, const CloudGraphOptions& options, Id numberOfPoints,
  const ProgressCallback& progress, CloudGraphEstimate& estimate)
{
  const auto nodes = static_cast<Id>(setup.Pairs.Points.size());
  const Id sample = std::min(nodes, SampleSize);
  RowWorkspace workspace(setup, options.Accuracy);
  std::vector<Id> targets;
  for (Id i = 0; i < sample; ++i)
  {
    if (i % SamplesPerReport == 0 && progress && !progress(static_cast<double>(i) / sample))
    {
      return Status::Abort();
    }
    workspace.Build(static_cast<Id>(static_cast<Offset>(i) * nodes / sample), targets);
  }
  const double degree = sample > 0 ? static_cast<double>(targets.size()) / sample : 0.0;
  const bool wide = NeedsWide(setup.Nodes, options.Accuracy);
  const auto coincident = static_cast<double>(setup.Nodes.Coincident.size());
  estimate.Edges = UnitedShare * degree * nodes + 2.0 * coincident;
  estimate.Memory = estimate.Edges * static_cast<double>(BytesPerEdge(wide)) +
    (numberOfPoints + 1.0) * sizeof(Offset);
  estimate.Peak = PredictPeak(setup, numberOfPoints, estimate.Edges, wide);
  return Status::Success();
}

Status BuildRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, std::vector<CloudRowBlock>& blocks,
  CloudGraphStatistics& statistics)
{
  const auto nodes = static_cast<Id>(setup.Pairs.Points.size());
  blocks = std::vector<CloudRowBlock>((nodes + RowsPerBlock - 1) / RowsPerBlock);
  std::atomic<std::size_t> candidates{ 0 };
  std::atomic<std::size_t> walks{ 0 };
  std::atomic<std::size_t> edges{ 0 };
  const auto count = static_cast<Offset>(blocks.size());
  Offset size = LeastBlocksPerWave;
  for (Offset first = 0; first < count; first += size)
  {
    if (progress && !progress(static_cast<double>(first) / static_cast<double>(count)))
    {
      return Status::Abort();
    }
    if (first > 0)
    {
      const double perBlock = static_cast<double>(candidates) / static_cast<double>(first);
      size = static_cast<Offset>(std::clamp(CandidatesPerWave / std::max(1.0, perBlock),
        static_cast<double>(LeastBlocksPerWave), static_cast<double>(MostBlocksPerWave)));
    }
    size = std::min(size, count - first);
    ForRange(options.Parallel, size, 1, [&](Offset begin, Offset end) {
      RowWorkspace workspace(setup, options.Accuracy);
      std::vector<Id> targets;
      for (Offset b = first + begin; b < first + end; ++b)
      {
        CloudRowBlock& block = blocks[static_cast<std::size_t>(b)];
        targets.clear();
        const auto firstRow = static_cast<Id>(b * RowsPerBlock);
        const Id lastRow = std::min(nodes, firstRow + RowsPerBlock);
        for (Id row = firstRow; row < lastRow; ++row)
        {
          const std::size_t before = targets.size();
          workspace.Build(row, targets);
          block.Sizes.push_back(static_cast<Id>(targets.size() - before));
        }
        block.Targets.assign(targets.begin(), targets.end()); // no larger than it has to be
        edges += targets.size();
      }
      candidates += workspace.Candidates;
      walks += workspace.Pruning.GetNumberOfWalks();
    });
  }
  statistics.Candidates = candidates;
  statistics.Walks = walks;
  statistics.OutEdges = edges;
  return Status::Success();
}

Status BuildGraph(const double* points, Id numberOfPoints, const CloudGraphOptions& options,
  CloudGraph& result, CloudGraphStatistics& statistics)
{
  CloudSetup setup;
  Status status = SetUpCloud(points, numberOfPoints, options,
    ProgressPart(options.Progress, 0.0, ShareOfSetup), setup, statistics);
  if (!status.IsOk())
  {
    return status;
  }
  statistics.BandMemory += setup.Pairs.Nearest.size() * sizeof(Id);
  if (options.MemoryLimit > 0)
  {
    CloudGraphEstimate estimate;
    status = PredictFrom(setup, options, numberOfPoints,
      ProgressPart(options.Progress, ShareOfSetup, EndOfPrediction), estimate);
    if (!status.IsOk())
    {
      return status;
    }
    status = CheckMemory("building the graph of the cloud", estimate.Peak,
      static_cast<double>(options.MemoryLimit), "use a larger Accuracy or a smaller Alpha");
    if (!status.IsOk())
    {
      return status;
    }
  }
  std::vector<CloudRowBlock> blocks;
  status = BuildRows(
    setup, options, ProgressPart(options.Progress, EndOfPrediction, EndOfRows), blocks, statistics);
  if (!status.IsOk())
  {
    return status;
  }
  const bool wide = NeedsWide(setup.Nodes, options.Accuracy);
  status = AssembleCloudGraph(setup, numberOfPoints, RowsPerBlock, blocks, wide, options.Parallel,
    ProgressPart(options.Progress, EndOfRows, EndOfGraph), result.Graph);
  if (!status.IsOk())
  {
    return status;
  }
  statistics.PeakMemory = static_cast<std::size_t>(
    PredictPeak(setup, numberOfPoints, static_cast<double>(result.Graph.Targets.Size()), wide));

  const auto n = static_cast<std::size_t>(numberOfPoints);
  std::vector<unsigned char> isUsed(n, 0);
  result.Radii.assign(n, 0.0);
  const double toPoints = 1.0 / setup.Nodes.Scale;
  for (std::size_t node = 0; node < setup.Nodes.Originals.size(); ++node)
  {
    isUsed[setup.Nodes.Originals[node]] = 1;
    result.Radii[setup.Nodes.Originals[node]] = toPoints * setup.Pairs.Radii[node];
  }
  for (const Id point : setup.Nodes.Stray)
  {
    isUsed[point] = 1;
  }
  for (const auto& [point, original] : setup.Nodes.Coincident)
  {
    isUsed[point] = 1;
    result.Radii[point] = result.Radii[original];
  }
  result.VoxelSize = toPoints * setup.Pairs.Band.GetVoxelSize();
  if (options.Progress && !options.Progress(EndOfGraph))
  {
    return Status::Abort();
  }
  FindCloudComponents(result.Graph, isUsed, result.Components, result.ComponentSizes);
  result.Graph.Info.Kind = GraphKind::Cloud;
  result.Graph.Info.Construction = ConstructionOf(options.Scheme);
  result.Graph.Info.Accuracy = options.Accuracy;
  return options.Progress && !options.Progress(1.0) ? Status::Abort() : Status::Success();
}
}

CloudGraphBuilder::CloudGraphBuilder(const double* points, Id numberOfPoints)
  : Points(points)
  , NumberOfPoints(numberOfPoints)
{
}

Status CloudGraphBuilder::Check(const CloudGraphOptions& options)
{
  std::ostringstream text;
  if (!(options.OffsetInVoxels == 0.0 ||
        (options.OffsetInVoxels >= 0.5 && options.OffsetInVoxels <= 1000.0)))
  {
    // Smaller balls may have no centre of a voxel in them.
    text << "the offset is " << options.OffsetInVoxels
         << " voxels, but has to be 0 (automatic), or at least 0.5 and at most 1000";
  }
  else if (options.Resolution < 0 || options.Resolution > LargestResolution)
  {
    text << "the resolution is " << options.Resolution
         << ", but has to be 0 (automatic) or at most " << LargestResolution;
  }
  else if (!(options.Alpha == 0.0 || (options.Alpha >= 1e-3 && options.Alpha <= 1e6)))
  {
    text << "alpha is " << options.Alpha
         << ", but has to be 0 (automatic), or at least 1e-3 and at most 1e6";
  }
  else if (!(options.Accuracy == 0.0 ||
             (options.Accuracy >= 1e-6 && options.Accuracy <= LargestAccuracy)))
  {
    text << "the accuracy is " << options.Accuracy
         << ", but has to be 0 (all edges) or between 1e-6 and " << LargestAccuracy;
  }
  else if (options.HasOrientedNormals && !options.Normals)
  {
    text << "there are no normals that could be oriented";
  }
  return text.str().empty() ? Status::Success() : Status::Invalid(text.str());
}

Status CloudGraphBuilder::Estimate(
  const CloudGraphOptions& options, CloudGraphEstimate& estimate) const
{
  estimate = CloudGraphEstimate();
  Status status = Check(options);
  if (!status.IsOk())
  {
    return status;
  }
  CloudSetup setup;
  CloudGraphStatistics statistics;
  const ProgressCallback& progress = options.Progress;
  status = SetUpCloud(this->Points, this->NumberOfPoints, options,
    ProgressPart(progress, 0.0, ShareOfSetupToPredict), setup, statistics);
  return status.IsOk() ? PredictFrom(setup, options, this->NumberOfPoints,
                           ProgressPart(progress, ShareOfSetupToPredict, 1.0), estimate)
                       : status;
}

Status CloudGraphBuilder::Build(
  const CloudGraphOptions& options, CloudGraph& result, CloudGraphStatistics* statistics) const
{
  result = CloudGraph();
  CloudGraphStatistics local;
  Status status = Check(options);
  if (status.IsOk())
  {
    status = BuildGraph(this->Points, this->NumberOfPoints, options, result, local);
  }
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
