// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudRows.h"

#include "dggCloudPruning.h"
#include "dggMemoryLimit.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace dgg
{
namespace
{
/// Rows in a block, at most; fewer where they have so many candidates that a block had more than
/// that.
constexpr Id MostRowsPerBlock = 64;
constexpr double CandidatesPerBlock = 1 << 16;
/// Blocks between two reports of progress: as many as look at that many neighbours, judged by those
/// before them.
constexpr double CandidatesPerWave = 1 << 19;
constexpr Offset LeastBlocksPerWave = 8;
constexpr Offset MostBlocksPerWave = 512;
/// Rows that are looked at to know all.
constexpr Id SampleSize = 512;
constexpr Id SamplesPerReport = 16;

/// A list that grows by doubling is there twice while it does: as many times its final size.
constexpr double Growth = 3.0;
/// Bytes per candidate: what is found, and lists of numbers and chords, which are made as large as
/// they have to be, beside those of the row before.
constexpr double BytesPerCandidate =
  Growth * sizeof(CloudNeighbor) + 2.0 * (sizeof(Id) + sizeof(double));

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
    this->Neighbors.reserve(this->Found.size());
    this->Chords.clear();
    this->Chords.reserve(this->Found.size());
    for (const CloudNeighbor& neighbor : this->Found)
    {
      if (neighbor.Point != node)
      {
        this->Neighbors.push_back(neighbor.Point);
        this->Chords.push_back(pairs.Chord(node, neighbor.Point));
      }
    }
    const std::size_t before = targets.size();
    this->Pruning.ChooseEdges(node, this->Neighbors, this->Chords, targets);
    this->Candidates += this->Neighbors.size();
    this->MostCandidates = std::max(this->MostCandidates, this->Found.size());
    this->MostTargets = std::max(this->MostTargets, targets.size() - before);
  }

  const CloudSetup& Setup;
  CloudPruning Pruning;
  std::vector<CloudNeighbor> Found;
  std::vector<Id> Neighbors;
  std::vector<double> Chords;
  std::size_t Candidates = 0; ///< of all rows so far
  std::size_t MostCandidates = 0;
  std::size_t MostTargets = 0;
};

void Raise(std::atomic<std::size_t>& most, std::size_t value)
{
  std::size_t known = most.load();
  while (value > known && !most.compare_exchange_weak(known, value))
  {
  }
}
}

Id RowSample::GetRowsPerBlock() const
{
  return static_cast<Id>(std::clamp(CandidatesPerBlock / std::max(1.0, this->MeanCandidates), 1.0,
    static_cast<double>(MostRowsPerBlock)));
}

double RowSample::CountBlocks(Id rows) const
{
  return std::ceil(static_cast<double>(rows) / this->GetRowsPerBlock());
}

double RowSample::GetBlockMemory(Id rows) const
{
  return this->CountBlocks(rows) * sizeof(CloudRowBlock) + sizeof(Id) * static_cast<double>(rows);
}

double RowSample::GetThreadMemory() const
{
  // Targets of a block are copied when it is finished.
  const double targets = static_cast<double>(this->MostTargets) * this->GetRowsPerBlock();
  return BytesPerCandidate * static_cast<double>(this->MostCandidates) +
    (Growth + 1.0) * sizeof(Id) * targets +
    static_cast<double>(CloudPruning::PredictMemory(this->MostTargets));
}

Status CheckRowMemory(double bytes, std::size_t limit)
{
  return CheckMemory("building the graph of the cloud", bytes, static_cast<double>(limit),
    "use a larger Accuracy or a smaller Alpha");
}

Status SampleRows(const CloudSetup& setup, const CloudGraphOptions& options,
  RowSample::Content content, const ProgressCallback& progress, RowSample& sample)
{
  const CloudPairs& pairs = setup.Pairs;
  const auto nodes = static_cast<Id>(pairs.Points.size());
  const Id size = std::min(nodes, SampleSize);
  const auto held = static_cast<double>(setup.GetMemorySize());
  RowWorkspace workspace(setup, options.Accuracy);
  std::vector<Id> targets;
  double candidates = 0.0;
  double chosen = 0.0;
  for (Id i = 0; i < size; ++i)
  {
    if (i % SamplesPerReport == 0 && progress && !progress(static_cast<double>(i) / size))
    {
      return Status::Abort();
    }
    const auto node = static_cast<Id>(static_cast<Offset>(i) * nodes / size);
    const std::size_t count = setup.Neighbors->CountWithin(pairs.Points[node], pairs.Reaches[node]);
    candidates += static_cast<double>(count);
    sample.MostCandidates = std::max(sample.MostCandidates, count);
    if (content == RowSample::All)
    {
      Status status = options.MemoryLimit > 0
        ? CheckRowMemory(held + sample.GetThreadMemory(), options.MemoryLimit)
        : Status::Success();
      if (!status.IsOk())
      {
        return status;
      }
      targets.clear();
      workspace.Build(node, targets);
      chosen += static_cast<double>(targets.size());
      sample.MostTargets = std::max(sample.MostTargets, targets.size());
    }
  }
  sample.MeanCandidates = size > 0 ? candidates / size : 0.0;
  sample.Targets = size > 0 ? chosen / size : 0.0;
  return Status::Success();
}

Status BuildRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, RowSample& sample, std::vector<CloudRowBlock>& blocks,
  CloudGraphStatistics& statistics)
{
  const auto nodes = static_cast<Id>(setup.Pairs.Points.size());
  const Id rowsPerBlock = sample.GetRowsPerBlock();
  const auto count = static_cast<Offset>(sample.CountBlocks(nodes));
  blocks = std::vector<CloudRowBlock>(static_cast<std::size_t>(count));
  std::atomic<std::size_t> candidates{ 0 };
  std::atomic<std::size_t> mostCandidates{ sample.MostCandidates };
  std::atomic<std::size_t> mostTargets{ sample.MostTargets };
  std::atomic<std::size_t> walks{ 0 };
  std::atomic<std::size_t> edges{ 0 };
  const double held = static_cast<double>(setup.GetMemorySize()) + sample.GetBlockMemory(nodes);
  double perBlock = sample.MeanCandidates * rowsPerBlock;
  Offset size = 0;
  for (Offset first = 0; first < count; first += size)
  {
    if (progress && !progress(static_cast<double>(first) / static_cast<double>(count)))
    {
      return Status::Abort();
    }
    perBlock = first > 0 ? static_cast<double>(candidates) / static_cast<double>(first) : perBlock;
    size = static_cast<Offset>(std::clamp(CandidatesPerWave / std::max(1.0, perBlock),
      static_cast<double>(LeastBlocksPerWave), static_cast<double>(MostBlocksPerWave)));
    size = std::min(size, count - first);
    if (options.MemoryLimit > 0)
    {
      // There are no more threads at work than blocks.
      const double used = held + sizeof(Id) * static_cast<double>(edges);
      const double left = static_cast<double>(options.MemoryLimit) - used;
      Status status = CheckRowMemory(used + sample.GetThreadMemory(), options.MemoryLimit);
      if (!status.IsOk())
      {
        return status;
      }
      size =
        static_cast<Offset>(std::min(static_cast<double>(size), left / sample.GetThreadMemory()));
    }
    ForRange(options.Parallel, size, 1, [&](Offset begin, Offset end) {
      RowWorkspace workspace(setup, options.Accuracy);
      std::vector<Id> targets;
      for (Offset b = first + begin; b < first + end; ++b)
      {
        CloudRowBlock& block = blocks[static_cast<std::size_t>(b)];
        targets.clear();
        const auto firstRow = static_cast<Id>(b * rowsPerBlock);
        const Id lastRow = std::min(nodes, firstRow + rowsPerBlock);
        block.Sizes.reserve(static_cast<std::size_t>(lastRow - firstRow));
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
      Raise(mostCandidates, workspace.MostCandidates);
      Raise(mostTargets, workspace.MostTargets);
      walks += workspace.Pruning.GetNumberOfWalks();
    });
    sample.MostCandidates = mostCandidates;
    sample.MostTargets = mostTargets;
  }
  statistics.Candidates = candidates;
  statistics.Walks = walks;
  statistics.OutEdges = edges;
  return Status::Success();
}
}
