// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The edges chosen at each point of a cloud, and what it takes to choose them. Internal.
#ifndef dggCloudRows_h
#define dggCloudRows_h

#include "dggCloudAssembly.h" // for CloudRowBlock
#include "dggCloudSetup.h"    // for CloudSetup

#include <cstddef> // for std::size_t
#include <vector>  // for blocks

namespace dgg
{
/// What the rows of some nodes, evenly spread, show of all.
struct RowSample
{
  double MeanCandidates = 0.0; ///< nodes within reach
  double MeanTargets = 0.0;    ///< chosen of these
  double MostCandidates = 0.0;

  /// So many that a block does not take long, nor much memory.
  Id GetRowsPerBlock() const;
  /// Bytes that a thread needs to build blocks, one at a time, about.
  double GetThreadMemory() const;
};

/// Fails when building rows would take more than the limit; 0: there is none.
Status CheckRowMemory(double bytes, std::size_t limit);

/// Fails if a single row exceeds the memory limit, or if `progress` returns false.
Status SampleRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, RowSample& sample);

/// Build all rows. Where there is a memory limit, no more threads work at the same time than fit,
/// and it fails when not even one may.
Status BuildRows(const CloudSetup& setup, const CloudGraphOptions& options,
  const ProgressCallback& progress, const RowSample& sample, std::vector<CloudRowBlock>& blocks);
}

#endif
