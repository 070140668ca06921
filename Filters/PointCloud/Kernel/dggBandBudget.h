// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How many voxels the band of a cloud may have. Internal.
#ifndef dggBandBudget_h
#define dggBandBudget_h

#include "dggTypes.h" // for Status

#include <cstddef> // for std::size_t
#include <vector>  // for radii

namespace dgg
{
/// The smallest voxels of which balls have no more than 4000 on average. Where density varies that
/// much, voxels for the balls of the densest points would be far too many in those of the sparsest.
double FindLeastVoxelSize(const std::vector<double>& radii);

/// Bytes of a band and of the nearest points of its voxels, roughly: that of a surface, on which
/// each point has the square of its spacing.
double PredictBandMemory(
  const std::vector<float>& spacings, const std::vector<double>& radii, double voxelSize);

/// The part of the memory that the bricks of the band may take, so that there is room for the
/// nearest points of their voxels.
std::size_t GetShareOfBricks(std::size_t memory);

/// What is said of a band for which there is no room. `used` bytes are there already; `needed` are
/// those that were predicted for the band. Units of sizes are those of the points.
struct BandInNumbers
{
  double Resolution = 0.0;
  bool IsAutomatic = false; ///< Resolution
  double VoxelSize = 0.0;
  double Spacing = 0.0; ///< median
  double Used = 0.0;
  double Needed = 0.0;
  double MemoryLimit = 0.0;
};
Status RefuseBand(const BandInNumbers& band);
}

#endif
