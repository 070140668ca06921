// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances on a point cloud by fast marching in the band around it.
#ifndef BandMarching_h
#define BandMarching_h

#include "dggPoint3.h"    // for Point3
#include "dggTypes.h"     // for Id, Status
#include "dggVoxelBand.h" // for VoxelBand

#include <array>   // for neighbours
#include <cstdint> // for std::int64_t
#include <vector>  // for distances

namespace dgg
{
/// A place in space where distances start.
struct BandSource
{
  Point3 Place;
  double InitialDistance = 0.0;
};

/// Memoli and Sapiro, "Fast computation of weighted distance functions and geodesics on implicit
/// hyper-surfaces", 2001: the Eikonal equation |grad d| = 1 on the voxels of a band, by first order
/// upwind differences. Distances in the band are those of the surface but for the square root of
/// its width; that, and the first order, make errors of some per cent. For comparison.
class BandMarching
{
public:
  /// The band must outlive it.
  explicit BandMarching(const VoxelBand& band);

  /// Distances of places from the nearest of the sources; Infinity where there is no way, and off
  /// the band. Fails when there is no source, or one is not finite or off the band. May be called
  /// by several threads at once.
  Status Run(const std::vector<BandSource>& sources, const std::vector<Point3>& places,
    const ProgressCallback& progress, std::vector<double>& distances) const;

private:
  class March;

  const VoxelBand& Band;
  /// Per brick, those before and after it along each axis, or -1.
  std::vector<std::array<std::int32_t, 6>> Neighbors;
};
}

#endif
