// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudRows.h"

#include "dggCloudPruning.h"
#include "dggMemoryLimit.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <atomic>

namespace dgg
{
namespace
{
/// Maximum number of rows in a block. Blocks have fewer rows if they would otherwise exceed
/// CandidatesPerBlock candidates.
constexpr Id MostRowsPerBlock = 64;
constexpr double CandidatesPerBlock = 1 << 16;
/// Number of candidates between two progress reports, and limits for the number of blocks. The
/// number of blocks is estimated from the candidates of earlier blocks.
constexpr double CandidatesPerWave = 1 << 19;
constexpr Offset LeastBlocksPerWave = 8;
constexpr Offset MostBlocksPerWave = 512;
/// Number of rows that are sampled to estimate all rows.
constexpr Id SampleSize = 512;
constexpr Id SamplesPerReport = 16;

/// Memory of a thread, in bytes, for each candidate of a row and each target of a block. Lists that
/// grow by doubling exist twice while they grow.
constexpr double BytesPerCandidate = 128.0;
constexpr double BytesPerTarget = 16.0;

/// Buffers of one thread for building rows.
struct RowWorkspace
{
  RowWorkspace(const CloudSetup& setup, double accuracy)
    : Setup(setup)
    , Pruning(setup.Pairs, accuracy)
  {
  }

  /// Appends the targets of a row.
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
    this->Pruning.ChooseEdges(node, this->Neighbors, this->Chords, targets);
    this->Candidates += this->Neighbors.size();
  }

  const CloudSetup& Setup;
  CloudPruning Pruning;
  std::vector<CloudNeighbor> Found;
  std::vector<Id> Neighbors;
  std::vector<double> Chords;
  std::size_t Candidates = 0; ///< number of candidates of all rows so far
};
}

Id RowSample::GetRowsPerBlock() const
{
  return static_cast<Id>(std::clamp(CandidatesPerBlock / std::max(1.0, this->MeanCandidates), 1.0,
    static_cast<double>(MostRowsPerBlock)));
}

double RowSample::GetThreadMemory() const
{
  return BytesPerCandidate * this->MostCandidates +
    BytesPerTarget * this->MeanTargets * this->GetRowsPerBlock();
}

Status CheckRowMemory(double bytes, std::size_t limit)
{
  return limit == 0 ? Status::Success()
                    : CheckMemory("Building the graph of the cloud", bytes,
                        static_cast<double>(limit), "Use a larger {Accuracy} or a smaller {Alpha}");
}

Status SampleRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, RowSample& sample)
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
    const auto count =
      static_cast<double>(setup.Neighbors->CountWithin(pairs.Points[node], pairs.Reaches[node]));
    candidates += count;
    sample.MostCandidates = std::max(sample.MostCandidates, count);
    DGG_RETURN_IF_ERROR(CheckRowMemory(held + sample.GetThreadMemory(), options.MemoryLimit));
    targets.clear();
    workspace.Build(node, targets);
    chosen += static_cast<double>(targets.size());
  }
  sample.MeanCandidates = size > 0 ? candidates / size : 0.0;
  sample.MeanTargets = size > 0 ? chosen / size : 0.0;
  return Status::Success();
}

Status BuildRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, const RowSample& sample, std::vector<CloudRowBlock>& blocks)
{
  const auto nodes = static_cast<Id>(setup.Pairs.Points.size());
  const Id rowsPerBlock = sample.GetRowsPerBlock();
  const Offset count = (static_cast<Offset>(nodes) + rowsPerBlock - 1) / rowsPerBlock;
  blocks = std::vector<CloudRowBlock>(static_cast<std::size_t>(count));
  std::atomic<std::size_t> candidates{ 0 };
  std::atomic<std::size_t> edges{ 0 };
  double perBlock = sample.MeanCandidates * rowsPerBlock;
  Offset size = 0;
  for (Offset first = 0; first < count; first += size)
  {
    DGG_RETURN_IF_ERROR(
      ReportTo(progress, static_cast<double>(first) / static_cast<double>(count)));
    perBlock = first > 0 ? static_cast<double>(candidates) / static_cast<double>(first) : perBlock;
    size = static_cast<Offset>(std::clamp(CandidatesPerWave / std::max(1.0, perBlock),
      static_cast<double>(LeastBlocksPerWave), static_cast<double>(MostBlocksPerWave)));
    size = std::min(size, count - first);
    if (options.MemoryLimit > 0)
    {
      // The number of threads does not exceed the number of blocks, so limiting the blocks limits
      // the memory.
      const double used =
        static_cast<double>(setup.GetMemorySize()) + sizeof(Id) * static_cast<double>(edges);
      const double left = static_cast<double>(options.MemoryLimit) - used;
      DGG_RETURN_IF_ERROR(CheckRowMemory(used + sample.GetThreadMemory(), options.MemoryLimit));
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
        block.Targets.assign(targets.begin(), targets.end()); // no excess capacity
        edges += targets.size();
      }
      candidates += workspace.Candidates;
    });
  }
  return Status::Success();
}
}
