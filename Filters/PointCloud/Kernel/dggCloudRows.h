// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The edges chosen at each point of a cloud, and what it takes to choose them. Internal.
#ifndef dggCloudRows_h
#define dggCloudRows_h

#include "dggCloudAssembly.h" // for CloudRowBlock
#include "dggCloudSetup.h"    // for CloudSetup

#include <cstddef> // for std::size_t
#include <cstdint> // for std::uint8_t
#include <vector>  // for blocks

namespace dgg
{
/// What the rows of some nodes, evenly spread, tell of all.
struct RowSample
{
  enum Content : std::uint8_t
  {
    Candidates, ///< counts them only
    All         ///< builds rows
  };

  double MeanCandidates = 0.0; ///< nodes within reach
  double Targets = 0.0;        ///< chosen of these, on average
  std::size_t MostCandidates = 0;
  std::size_t MostTargets = 0;

  /// So many that a block does not take long, nor much memory.
  Id GetRowsPerBlock() const;
  double CountBlocks(Id rows) const;
  /// Bytes of the blocks of that many rows, but for the targets in them.
  double GetBlockMemory(Id rows) const;
  /// Bytes that a thread needs to build blocks, one at a time.
  double GetThreadMemory() const;
};

/// Fails when building rows would take more than the limit.
Status CheckRowMemory(double bytes, std::size_t limit);

/// Fails when the memory limit has no room for a single row, and when `progress` asks to stop.
Status SampleRows(const CloudSetup& setup, const CloudGraphOptions& options,
  RowSample::Content content, const ProgressCallback& progress, RowSample& sample);

/// Build all rows. The sample learns of rows that are larger than those it has seen: where there is
/// a memory limit, fewer threads work at the same time then, and it fails when not even one may.
Status BuildRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, RowSample& sample, std::vector<CloudRowBlock>& blocks,
  CloudGraphStatistics& statistics);
}

#endif
