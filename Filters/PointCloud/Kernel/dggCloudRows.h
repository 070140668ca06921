// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Builds the rows of a cloud graph: the edges selected at each node. Internal.
#ifndef dggCloudRows_h
#define dggCloudRows_h

#include "dggCloudAssembly.h" // for CloudRowBlock
#include "dggCloudSetup.h"    // for CloudSetup

#include <cstddef> // for std::size_t
#include <vector>  // for row blocks

namespace dgg
{
/// Statistics of the rows of an evenly distributed sample of nodes.
struct RowSample
{
  double MeanCandidates = 0.0; ///< mean number of nodes within reach
  double MeanTargets = 0.0;    ///< mean number of selected targets
  /// Maximum number of nodes within reach.
  double MostCandidates = 0.0;

  /// Returns the number of rows per block, which limits the time and the memory of a block.
  Id GetRowsPerBlock() const;
  /// Returns the approximate memory in bytes that a thread needs to build one block at a time.
  double GetThreadMemory() const;
};

/// Fails if `bytes`, the memory for building rows, exceeds `limit`; 0: no limit.
Status CheckRowMemory(double bytes, std::size_t limit);

/// Builds the rows of a sample of nodes. Fails if a single row exceeds the memory limit, or if
/// `progress` returns false.
Status SampleRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, RowSample& sample);

/// Builds all rows. With a memory limit, the number of simultaneous threads is reduced to those
/// that fit. Fails if a single thread does not fit, or if `progress` returns false.
Status BuildRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, const RowSample& sample, std::vector<CloudRowBlock>& blocks);
}

#endif
