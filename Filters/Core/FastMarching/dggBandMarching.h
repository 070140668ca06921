// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances on a point cloud by fast marching in the band around it.
#ifndef dggBandMarching_h
#define dggBandMarching_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3
#include "dggStatus.h"     // for Status
#include "dggVoxelBand.h"  // for VoxelBand

#include <array>   // for neighbors
#include <cstdint> // for std::int32_t
#include <vector>  // for distances

namespace dgg
{
/// A source position in space.
struct BandSource
{
  Point3 Place;
  double InitialDistance = 0.0;
};

struct BandMarchingOptions
{
  /// Positions farther than this distance may be left unreached.
  double MaximumDistance = Infinity;
  ProgressCallback Progress; ///< may be empty
};

struct BandMarchingResult
{
  std::vector<double> Distances; ///< per position; Infinity where unreached
  std::vector<Id> NearestSource; ///< per position, index into the sources; NoId where unreached
};

/// Fast marching in a band (Memoli and Sapiro, "Fast computation of weighted distance functions and
/// geodesics on implicit hyper-surfaces", 2001): solves the Eikonal equation |grad d| = 1 on the
/// voxels of a band by first-order upwind differences. Distances in the band differ from distances
/// on the surface by an amount proportional to the square root of the band width. In combination
/// with the first-order discretization, this difference causes errors of a few per cent.
class DGG_CORE_EXPORT BandMarching
{
public:
  /// Prepares marching in a band, which must outlive the object.
  explicit BandMarching(const VoxelBand& band);

  /// Returns the size in bytes of marching in a band of `bricks` bricks, without the queue of the
  /// front.
  static double PredictMemory(double bricks);

  /// Returns true if the voxels of the band can be indexed.
  static bool CanMarchIn(const VoxelBand& band);

  /// Returns true if distances can start at a position, because a voxel of the band is close.
  bool IsNear(const Point3& place) const;

  /// Computes the distances of positions from the nearest source. A position within the initial
  /// voxels of a source, on the layer of the source, gets its straight distance. Fails if there is
  /// no source, or if a source is not finite or not near the band. May be called by several threads
  /// simultaneously.
  Status Run(const std::vector<BandSource>& sources, const std::vector<Point3>& places,
    const BandMarchingOptions& options, BandMarchingResult& result) const;

private:
  class March;

  const VoxelBand& Band;
  /// Per brick, the neighboring bricks before and after it along each axis, or -1.
  std::vector<std::array<std::int32_t, 6>> Neighbors;
};
}

#endif
