// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A band around a point cloud, as a sparse set of voxels.
#ifndef dggVoxelBand_h
#define dggVoxelBand_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggParallel.h"   // for ParallelFor
#include "dggPoint3.h"     // for Point3
#include "dggStatus.h"     // for Status

#include <array>   // for voxels
#include <atomic>  // for words that several threads mark
#include <cstddef> // for std::size_t
#include <cstdint> // for words
#include <memory>  // for words
#include <string>  // for messages
#include <vector>  // for bricks

namespace dgg
{
/// Index of a voxel along each axis. The voxel whose lower corner is the origin of the band is 0,
/// 0, 0.
using Voxel = std::array<std::int32_t, 3>;

/// The band of a cloud (Memoli and Sapiro): the union of balls around its points, rasterized. A
/// voxel belongs to the band if its center lies in a ball. Voxels are bits in bricks of 8 x 8 x 8;
/// only bricks that intersect a ball are stored.
class DGG_CORE_EXPORT VoxelBand
{
public:
  /// Maximum number of voxels along one axis. A key has 21 bits per axis for bricks, and one brick
  /// on each side is reserved.
  static constexpr std::int32_t MaximumResolution = (1 << 24) - 16;

  VoxelBand() = default;
  VoxelBand(VoxelBand&&) = default;
  VoxelBand& operator=(VoxelBand&&) = default;

  /// Builds the band by marking the voxels in balls. `radii` holds one radius per point. A ball
  /// that contains no voxel center marks the voxel of its point and the six neighbors. Points and
  /// radii must be finite. Fails if the number of voxels is too large, or if the band would exceed
  /// `memoryLimit` bytes (0: no limit). The limit is checked before memory is allocated, and early
  /// if balls are large. The result does not depend on `parallel`. The band is empty on failure,
  /// and if `progress` returns false. `remedy` is the advice in messages about too many voxels.
  Status Build(const std::vector<Point3>& points, const std::vector<double>& radii,
    double voxelSize, std::size_t memoryLimit, const ParallelFor& parallel,
    const ProgressCallback& progress = {}, const std::string& remedy = "Use larger voxels");

  /// Returns true if Build() failed because of `memoryLimit`.
  bool IsTooLarge() const { return this->TooLarge; }

  double GetVoxelSize() const { return this->VoxelSize; }
  /// Returns the number of voxels along the longest side of the bounding box of the band.
  std::int32_t GetResolution() const { return this->Resolution; }
  std::size_t GetNumberOfBricks() const { return this->Keys.size(); }
  std::size_t GetNumberOfVoxels() const;
  std::size_t GetMemorySize() const;
  /// Returns the size in bytes of a band of `bricks` bricks.
  static double PredictMemory(double bricks);

  /// Converts a point to units of voxels from the origin.
  Point3 ToGrid(const Point3& point) const { return this->InverseSize * (point - this->Origin); }
  /// Returns true if a position, in units of voxels, lies in the bounding box; false for NaN.
  bool IsInBox(const Point3& inGrid) const
  {
    const double size = this->Resolution;
    return inGrid.X >= 0.0 && inGrid.Y >= 0.0 && inGrid.Z >= 0.0 && inGrid.X < size &&
      inGrid.Y < size && inGrid.Z < size;
  }
  Point3 GetCentre(const Voxel& voxel) const
  {
    return this->Origin +
      this->VoxelSize * Point3{ voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5 };
  }
  static Voxel VoxelOf(const Point3& inGrid)
  {
    return { static_cast<std::int32_t>(std::floor(inGrid.X)),
      static_cast<std::int32_t>(std::floor(inGrid.Y)),
      static_cast<std::int32_t>(std::floor(inGrid.Z)) };
  }

  bool Contains(const Voxel& voxel) const
  {
    if ((voxel[0] | voxel[1] | voxel[2]) < 0)
    {
      return false;
    }
    const std::int64_t brick = this->FindBrick(BrickKey(voxel));
    return brick >= 0 && this->IsMarked(brick, voxel);
  }

  /// Returns true if the segment between two points, in units of voxels, stays in marked voxels.
  /// The result is symmetric.
  bool ContainsSegment(const Point3& from, const Point3& to) const;

  // Functions for traversals that look up each brick once.

  static std::uint64_t BrickKey(const Voxel& voxel)
  {
    return static_cast<std::uint64_t>(voxel[0] >> 3) << 42 |
      static_cast<std::uint64_t>(voxel[1] >> 3) << 21 | static_cast<std::uint64_t>(voxel[2] >> 3);
  }
  /// Returns the index of a brick, or -1.
  std::int64_t FindBrick(std::uint64_t key) const;
  bool IsMarked(std::int64_t brick, const Voxel& voxel) const
  {
    const std::uint64_t word =
      this->Words[8 * static_cast<std::size_t>(brick) + (voxel[2] & 7)].load(
        std::memory_order_relaxed);
    return word >> (8 * (voxel[1] & 7) + (voxel[0] & 7)) & 1;
  }
  /// Returns the index of a voxel in the list of all voxels, marked or not, of all bricks.
  static std::size_t PlaceOf(std::int64_t brick, const Voxel& voxel)
  {
    return 512 * static_cast<std::size_t>(brick) +
      static_cast<std::size_t>(64 * (voxel[2] & 7) + 8 * (voxel[1] & 7) + (voxel[0] & 7));
  }
  /// Returns the lowest voxel of a brick.
  Voxel GetBrickVoxel(std::size_t brick) const;

private:
  Status ChooseBox(
    const std::vector<Point3>& points, const std::vector<double>& radii, const std::string& remedy);
  Status FindCells(const std::vector<Point3>& points, const std::vector<double>& radii, int level,
    std::size_t memoryLimit, const ProgressCallback& progress, const std::string& remedy);
  Status MarkBalls(const std::vector<Point3>& points, const std::vector<double>& radii,
    const ParallelFor& parallel, const ProgressCallback& progress);
  void AddBrick(std::uint64_t key);
  void Rehash(std::size_t size);
  void MarkBall(const Point3& center, double radius);
  void MarkRun(std::int32_t x0, std::int32_t x1, std::int32_t y, std::int32_t z);

  Point3 Origin;
  double VoxelSize = 0.0;
  double InverseSize = 0.0;
  std::int32_t Resolution = 0;
  bool TooLarge = false;
  std::vector<std::uint64_t> Keys; ///< per brick
  std::vector<std::int32_t> Table; ///< open-addressing hash table: index of a brick or -1
  std::unique_ptr<std::atomic<std::uint64_t>[]> Words; ///< eight per brick, one per layer in z
};
}

#endif
