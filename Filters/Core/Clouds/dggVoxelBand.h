// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The space close to a point cloud, as a sparse set of voxels.
#ifndef dggVoxelBand_h
#define dggVoxelBand_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggParallel.h"   // for ParallelFor
#include "dggPoint3.h"     // for Point3
#include "dggTypes.h"      // for Id, Status

#include <array>   // for voxels
#include <atomic>  // for words that several threads mark
#include <cstddef> // for std::size_t
#include <cstdint> // for words
#include <memory>  // for words
#include <string>  // for messages
#include <vector>  // for bricks

namespace dgg
{
/// A voxel by its place along each axis; the voxel with its lower corner at the origin of the band
/// is 0, 0, 0.
using Voxel = std::array<std::int32_t, 3>;

/// The band of a cloud (Memoli and Sapiro): the union of balls around its points, rasterised.
/// A voxel belongs to it when its centre lies in a ball. Voxels are bits in bricks of 8 x 8 x 8;
/// only bricks that a ball meets are there.
class DGG_CORE_EXPORT VoxelBand
{
public:
  /// Voxels along one axis, at most: as many as the 21 bits of a key distinguish in bricks, but for
  /// one brick on each side.
  static constexpr std::int32_t MaximumResolution = (1 << 24) - 16;

  VoxelBand() = default;
  VoxelBand(VoxelBand&&) = default;
  VoxelBand& operator=(VoxelBand&&) = default;

  /// Mark the balls. `radii` holds one radius per point. Balls that are too small for any voxel
  /// mark the voxel of their point and its six neighbours. Fails when the voxels are so small that
  /// there are too many, or when the band would take more than `memoryLimit` bytes (0: no limit),
  /// before it takes them, and soon where balls are large. Points and radii have to be finite. The
  /// same for any `parallel`. The band is empty when it fails, or when `progress` asks to stop.
  /// `remedy` is what messages advise when there would be too many voxels.
  Status Build(const std::vector<Point3>& points, const std::vector<double>& radii,
    double voxelSize, std::size_t memoryLimit, const ParallelFor& parallel,
    const ProgressCallback& progress = {}, const std::string& remedy = "use larger voxels");

  /// Whether Build() failed for `memoryLimit`.
  bool IsTooLarge() const { return this->TooLarge; }

  double GetVoxelSize() const { return this->VoxelSize; }
  const Point3& GetOrigin() const { return this->Origin; }
  /// Voxels along the longest side of the box of the band.
  std::int32_t GetResolution() const { return this->Resolution; }
  std::size_t GetNumberOfBricks() const { return this->Keys.size(); }
  std::size_t GetNumberOfVoxels() const;
  std::size_t GetMemorySize() const;
  /// Bytes of a band of that many bricks.
  static double PredictMemory(double bricks);

  /// In units of voxels from the origin.
  Point3 ToGrid(const Point3& point) const { return this->InverseSize * (point - this->Origin); }
  /// Whether a place, in units of voxels, is where there may be voxels; not NaN.
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

  /// Whether the segment between two points, given in units of voxels, stays in marked voxels. The
  /// same both ways round.
  bool ContainsSegment(const Point3& from, const Point3& to) const;

  // For walks that look up each brick once.

  static std::uint64_t BrickKey(const Voxel& voxel)
  {
    return static_cast<std::uint64_t>(voxel[0] >> 3) << 42 |
      static_cast<std::uint64_t>(voxel[1] >> 3) << 21 | static_cast<std::uint64_t>(voxel[2] >> 3);
  }
  /// Index of a brick, or -1.
  std::int64_t FindBrick(std::uint64_t key) const;
  bool IsMarked(std::int64_t brick, const Voxel& voxel) const
  {
    const std::uint64_t word =
      this->Words[8 * static_cast<std::size_t>(brick) + (voxel[2] & 7)].load(
        std::memory_order_relaxed);
    return word >> (8 * (voxel[1] & 7) + (voxel[0] & 7)) & 1;
  }
  /// Place of a voxel in a list of all voxels, marked or not, of all bricks.
  static std::size_t PlaceOf(std::int64_t brick, const Voxel& voxel)
  {
    return 512 * static_cast<std::size_t>(brick) +
      static_cast<std::size_t>(64 * (voxel[2] & 7) + 8 * (voxel[1] & 7) + (voxel[0] & 7));
  }
  /// Lowest voxel of a brick.
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
  void MarkBall(const Point3& centre, double radius);
  void MarkRun(std::int32_t x0, std::int32_t x1, std::int32_t y, std::int32_t z);

  Point3 Origin;
  double VoxelSize = 0.0;
  double InverseSize = 0.0;
  std::int32_t Resolution = 0;
  bool TooLarge = false;
  std::vector<std::uint64_t> Keys;                     ///< per brick
  std::vector<std::int32_t> Table;                     ///< open hash: index of a brick or -1
  std::unique_ptr<std::atomic<std::uint64_t>[]> Words; ///< eight per brick, one per layer in z
};
}

#endif
