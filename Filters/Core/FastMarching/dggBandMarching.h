// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances on a point cloud by fast marching in the band around it.
#ifndef dggBandMarching_h
#define dggBandMarching_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggPoint3.h"     // for Point3
#include "dggTypes.h"      // for Id, Status
#include "dggVoxelBand.h"  // for VoxelBand

#include <array>   // for neighbours
#include <cstdint> // for std::int32_t
#include <vector>  // for distances

namespace dgg
{
/// A place in space where distances start.
struct BandSource
{
  Point3 Place;
  double InitialDistance = 0.0;
};

struct BandMarchingOptions
{
  /// Places farther than this may be left unreached.
  double MaximumDistance = Infinity;
  ProgressCallback Progress; ///< may be empty
};

struct BandMarchingResult
{
  std::vector<double> Distances; ///< per place; Infinity where unreached
  std::vector<Id> NearestSource; ///< per place, index into the sources; NoId where unreached
};

/// Memoli and Sapiro, "Fast computation of weighted distance functions and geodesics on implicit
/// hyper-surfaces", 2001: the Eikonal equation |grad d| = 1 on the voxels of a band, by first order
/// upwind differences. Distances in the band are those of the surface but for the square root of
/// its width; that, and the first order, make errors of some per cent.
class DGG_CORE_EXPORT BandMarching
{
public:
  /// The band must outlive it.
  explicit BandMarching(const VoxelBand& band);

  /// Bytes of a march in a band of that many bricks, without what is on the way.
  static double PredictMemory(double bricks);

  /// Whether its voxels can be numbered.
  static bool CanMarchIn(const VoxelBand& band);

  /// Whether distances can start at a place: a voxel of the band is close.
  bool IsNear(const Point3& place) const;

  /// Distances of places from the nearest of the sources. Places as close to a source as the voxels
  /// that it starts with, on its sheet, have their straight distance. Fails when there is no
  /// source, or one is not finite or not near. May be called by several threads at once.
  Status Run(const std::vector<BandSource>& sources, const std::vector<Point3>& places,
    const BandMarchingOptions& options, BandMarchingResult& result) const;

private:
  class March;

  const VoxelBand& Band;
  /// Per brick, those before and after it along each axis, or -1.
  std::vector<std::array<std::int32_t, 6>> Neighbors;
};
}

#endif
