// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVoxelBand.h"

#include "dggMemoryLimit.h"
#include "dggProgressPart.h"
#include "dggSegmentWalk.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace dgg
{
namespace
{
constexpr std::size_t WordsPerBrick = 8;
/// Minimum number of hash table entries per brick.
constexpr std::size_t TablePerBrick = 2;
constexpr Offset PointsPerTask = 4096;
/// Amounts of work between two progress reports: brick positions examined, voxels in boxes around
/// balls, and the number of tasks into which the work is divided.
constexpr std::size_t LooksPerReport = 1 << 15;
constexpr double VoxelsPerReport = 1 << 24;
constexpr Offset TasksPerReport = 256;
/// Maximum number of bricks in the hash table.
constexpr double MostBricks = std::numeric_limits<std::int32_t>::max();

std::uint64_t Scramble(std::uint64_t key)
{
  key ^= key >> 31;
  key *= 0x9e3779b97f4a7c15ULL;
  return key ^ key >> 29;
}

/// Cells of size `size` that a ball intersects along one axis.
struct Range
{
  std::int32_t First;
  std::int32_t Last;
};
Range RangeOf(double center, double radius, double size)
{
  return { static_cast<std::int32_t>(std::floor((center - radius) / size)),
    static_cast<std::int32_t>(std::floor((center + radius) / size)) };
}

/// Returns the distance of a number from the nearest point of an interval (Gap) or from the
/// farthest one (Span).
double Gap(double x, double low, double high)
{
  return x < low ? low - x : std::max(0.0, x - high);
}
double Span(double x, double low, double high)
{
  return std::max(std::abs(x - low), std::abs(x - high));
}

/// Returns the level of the largest cells that fit into balls of mean radius. A cell of level l
/// consists of 2^l bricks along each axis; larger cells lie in no ball. Returns 0 if not even
/// single bricks fit.
int ChooseLevel(const std::vector<double>& radii, double inverseSize)
{
  double sum = 0.0;
  for (const double radius : radii)
  {
    sum += radius;
  }
  // The cell that contains the center of a ball extends from the center by at most the cell
  // diagonal.
  const double cell =
    sum / static_cast<double>(radii.size()) * inverseSize / (std::sqrt(3.0) * 8.0);
  return cell > 1.0 ? std::ilogb(cell) : 0;
}

/// Fails if the number of bricks found so far exceeds a limit.
Status CheckBricks(double bricks, double memoryLimit, const std::string& remedy)
{
  const double bytes = VoxelBand::PredictMemory(bricks);
  if (bytes <= memoryLimit && bricks <= MostBricks)
  {
    return Status::Success();
  }
  return bytes > memoryLimit
    ? CheckMemory("Part of the band of voxels", bytes, memoryLimit, remedy)
    : InvalidInput("The band of voxels has more than 2^31 bricks").Fix(remedy);
}
}

double VoxelBand::PredictMemory(double bricks)
{
  // The hash table doubles its size when full.
  return bricks *
    (WordsPerBrick * sizeof(std::uint64_t) + sizeof(std::uint64_t) +
      2.0 * TablePerBrick * sizeof(std::int32_t));
}

Status VoxelBand::Build(const std::vector<Point3>& points, const std::vector<double>& radii,
  double voxelSize, std::size_t memoryLimit, const ParallelFor& parallel,
  const ProgressCallback& progress, const std::string& remedy)
{
  *this = VoxelBand();
  this->VoxelSize = voxelSize;
  this->InverseSize = 1.0 / voxelSize;
  if (points.empty())
  {
    return Status::Success();
  }
  Status status = this->ChooseBox(points, radii, remedy);
  // If the number of bricks is very large, a pass over larger cells detects the excess early.
  const int level = ChooseLevel(radii, this->InverseSize);
  if (status.IsOk() && level > 0)
  {
    status =
      this->FindCells(points, radii, level, memoryLimit, ProgressPart(progress, 0.0, 0.1), remedy);
  }
  if (status.IsOk())
  {
    status =
      this->FindCells(points, radii, 0, memoryLimit, ProgressPart(progress, 0.1, 0.5), remedy);
  }
  if (status.IsOk())
  {
    status = this->MarkBalls(points, radii, parallel, progress);
  }
  if (!status.IsOk())
  {
    const bool isTooLarge = this->TooLarge;
    *this = VoxelBand();
    this->TooLarge = isTooLarge;
  }
  return status;
}

Status VoxelBand::ChooseBox(
  const std::vector<Point3>& points, const std::vector<double>& radii, const std::string& remedy)
{
  Point3 low{ Infinity, Infinity, Infinity };
  Point3 high{ -Infinity, -Infinity, -Infinity };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double r = radii[i];
    low = { std::min(low.X, points[i].X - r), std::min(low.Y, points[i].Y - r),
      std::min(low.Z, points[i].Z - r) };
    high = { std::max(high.X, points[i].X + r), std::max(high.Y, points[i].Y + r),
      std::max(high.Z, points[i].Z + r) };
  }
  // The margin of two voxels on each side gives the neighbors of marked voxels valid indices.
  const double margin = 2.0 * this->VoxelSize;
  this->Origin = low - Point3{ margin, margin, margin };
  const double extent = std::max({ high.X - low.X, high.Y - low.Y, high.Z - low.Z });
  const double resolution = std::ceil(extent / this->VoxelSize) + 5.0;
  if (!(resolution <= MaximumResolution))
  {
    return InvalidInput(
      "The band has ", resolution, " voxels along its longest side, more than ", MaximumResolution)
      .Fix(remedy);
  }
  this->Resolution = static_cast<std::int32_t>(resolution);
  return Status::Success();
}

/// Finds the bricks that balls intersect. At a level above 0, finds the cells of 2^level bricks
/// along each axis that lie entirely in a ball; such a pass only serves to detect too many bricks
/// early.
Status VoxelBand::FindCells(const std::vector<Point3>& points, const std::vector<double>& radii,
  int level, std::size_t memoryLimit, const ProgressCallback& progress, const std::string& remedy)
{
  const double size = std::ldexp(8.0, level);
  const double bricksPerCell = std::ldexp(1.0, 3 * level);
  const double limit = memoryLimit > 0 ? static_cast<double>(memoryLimit) : Infinity;
  const auto meets = [&](double x, std::int32_t cell) {
    return level > 0 ? Span(x, size * cell, size * (cell + 1.0))
                     : Gap(x, size * cell, size * (cell + 1.0));
  };
  this->Keys.clear();
  this->Rehash(1024);
  std::size_t looks = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point3 center = this->ToGrid(points[i]);
    // The radius is at least one voxel, for the neighbors that are marked in any case.
    const double radius = std::max(level > 0 ? 0.0 : 1.0, radii[i] * this->InverseSize);
    const Range x = RangeOf(center.X, radius, size);
    const Range y = RangeOf(center.Y, radius, size);
    const Range z = RangeOf(center.Z, radius, size);
    for (std::int32_t cz = z.First; cz <= z.Last; ++cz)
    {
      const double byZ = meets(center.Z, cz);
      for (std::int32_t cy = y.First; cy <= y.Last; ++cy)
      {
        const double byY = meets(center.Y, cy);
        for (std::int32_t cx = x.First; cx <= x.Last; ++cx)
        {
          const double byX = meets(center.X, cx);
          if (byX * byX + byY * byY + byZ * byZ <= radius * radius)
          {
            this->AddBrick(BrickKey({ 8 * cx, 8 * cy, 8 * cz }));
          }
        }
        const double bricks = bricksPerCell * static_cast<double>(this->Keys.size());
        Status status = CheckBricks(bricks, limit, remedy);
        if (!status.IsOk())
        {
          this->TooLarge = PredictMemory(bricks) > limit;
          return status;
        }
        looks += static_cast<std::size_t>(x.Last - x.First) + 1;
        if (looks > LooksPerReport)
        {
          looks = 0;
          DGG_RETURN_IF_ERROR(
            ReportTo(progress, static_cast<double>(i) / static_cast<double>(points.size())));
        }
      }
    }
  }
  this->Keys.shrink_to_fit(); // before the larger allocation
  return Status::Success();
}

Status VoxelBand::MarkBalls(const std::vector<Point3>& points, const std::vector<double>& radii,
  const ParallelFor& parallel, const ProgressCallback& progress)
{
  const std::size_t words = WordsPerBrick * this->Keys.size();
  this->Words = std::make_unique<std::atomic<std::uint64_t>[]>(words);
  for (std::size_t i = 0; i < words; ++i)
  {
    this->Words[i].store(0, std::memory_order_relaxed);
  }
  const auto count = static_cast<Offset>(points.size());
  for (Offset first = 0; first < count;)
  {
    DGG_RETURN_IF_ERROR(
      ReportTo(progress, 0.5 + 0.5 * static_cast<double>(first) / static_cast<double>(count)));
    // A batch contains about as many balls as one progress report covers.
    Offset last = first;
    for (double voxels = 0.0; last < count && voxels < VoxelsPerReport; ++last)
    {
      voxels +=
        std::pow(1.0 + 2.0 * radii[static_cast<std::size_t>(last)] * this->InverseSize, 3.0);
    }
    const Offset grain = std::clamp<Offset>((last - first) / TasksPerReport, 1, PointsPerTask);
    ForRange(parallel, last - first, grain, [&](Offset begin, Offset end) {
      for (Offset i = first + begin; i < first + end; ++i)
      {
        const auto ball = static_cast<std::size_t>(i);
        this->MarkBall(this->ToGrid(points[ball]), radii[ball] * this->InverseSize);
      }
    });
    first = last;
  }
  return Status::Success();
}

void VoxelBand::MarkBall(const Point3& center, double radius)
{
  const Voxel own = VoxelOf(center);
  // Centers of voxels are at half-integers.
  const auto firstZ = static_cast<std::int32_t>(std::ceil(center.Z - radius - 0.5));
  const auto lastZ = static_cast<std::int32_t>(std::floor(center.Z + radius - 0.5));
  for (std::int32_t z = firstZ; z <= lastZ; ++z)
  {
    const double dz = z + 0.5 - center.Z;
    const double inLayer = std::sqrt(std::max(0.0, radius * radius - dz * dz));
    const auto firstY = static_cast<std::int32_t>(std::ceil(center.Y - inLayer - 0.5));
    const auto lastY = static_cast<std::int32_t>(std::floor(center.Y + inLayer - 0.5));
    for (std::int32_t y = firstY; y <= lastY; ++y)
    {
      const double dy = y + 0.5 - center.Y;
      const double inRow = std::sqrt(std::max(0.0, inLayer * inLayer - dy * dy));
      const auto firstX = static_cast<std::int32_t>(std::ceil(center.X - inRow - 0.5));
      const auto lastX = static_cast<std::int32_t>(std::floor(center.X + inRow - 0.5));
      this->MarkRun(firstX, lastX, y, z);
    }
  }
  if (radius < 0.9)
  {
    this->MarkRun(own[0] - 1, own[0] + 1, own[1], own[2]);
    for (const std::int32_t side : { -1, 1 })
    {
      this->MarkRun(own[0], own[0], own[1] + side, own[2]);
      this->MarkRun(own[0], own[0], own[1], own[2] + side);
    }
  }
}

void VoxelBand::MarkRun(std::int32_t x0, std::int32_t x1, std::int32_t y, std::int32_t z)
{
  for (std::int32_t x = x0; x <= x1;)
  {
    const std::int32_t end = std::min(x1, x | 7);
    const std::int64_t brick = this->FindBrick(BrickKey({ x, y, z }));
    // Rounding may lead slightly beyond the bricks of the ball.
    if (brick >= 0)
    {
      const std::uint64_t run = (std::uint64_t{ 2 } << (end - x)) - 1;
      this->Words[WordsPerBrick * static_cast<std::size_t>(brick) + (z & 7)].fetch_or(
        run << (8 * (y & 7) + (x & 7)), std::memory_order_relaxed);
    }
    x = end + 1;
  }
}

bool VoxelBand::ContainsSegment(const Point3& from, const Point3& to) const
{
  const bool isForward = std::tie(from.X, from.Y, from.Z) <= std::tie(to.X, to.Y, to.Z);
  std::uint64_t key = ~std::uint64_t{ 0 };
  std::int64_t brick = -1;
  return WalkSegment(isForward ? from : to, isForward ? to : from,
    [&](std::int32_t x, std::int32_t y, std::int32_t z) {
      const Voxel voxel{ x, y, z };
      const std::uint64_t here = BrickKey(voxel);
      if (here != key)
      {
        key = here;
        brick = this->FindBrick(here);
      }
      return brick >= 0 && this->IsMarked(brick, voxel);
    });
}

std::int64_t VoxelBand::FindBrick(std::uint64_t key) const
{
  if (this->Table.empty())
  {
    return -1;
  }
  const std::size_t mask = this->Table.size() - 1;
  for (std::size_t i = Scramble(key) & mask;; i = (i + 1) & mask)
  {
    const std::int32_t brick = this->Table[i];
    if (brick < 0 || this->Keys[brick] == key)
    {
      return brick;
    }
  }
}

void VoxelBand::AddBrick(std::uint64_t key)
{
  if (this->FindBrick(key) >= 0)
  {
    return;
  }
  if (TablePerBrick * (this->Keys.size() + 1) > this->Table.size())
  {
    this->Rehash(2 * this->Table.size());
  }
  const std::size_t mask = this->Table.size() - 1;
  std::size_t i = Scramble(key) & mask;
  while (this->Table[i] >= 0)
  {
    i = (i + 1) & mask;
  }
  this->Table[i] = static_cast<std::int32_t>(this->Keys.size());
  this->Keys.push_back(key);
}

void VoxelBand::Rehash(std::size_t size)
{
  this->Table.assign(size, -1);
  const std::size_t mask = size - 1;
  for (std::size_t brick = 0; brick < this->Keys.size(); ++brick)
  {
    std::size_t i = Scramble(this->Keys[brick]) & mask;
    while (this->Table[i] >= 0)
    {
      i = (i + 1) & mask;
    }
    this->Table[i] = static_cast<std::int32_t>(brick);
  }
}

Voxel VoxelBand::GetBrickVoxel(std::size_t brick) const
{
  const std::uint64_t key = this->Keys[brick];
  constexpr std::uint64_t mask = (1 << 21) - 1;
  return { static_cast<std::int32_t>(key >> 42 & mask) * 8,
    static_cast<std::int32_t>(key >> 21 & mask) * 8, static_cast<std::int32_t>(key & mask) * 8 };
}

std::size_t VoxelBand::GetNumberOfVoxels() const
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < WordsPerBrick * this->Keys.size(); ++i)
  {
    std::uint64_t word = this->Words[i].load(std::memory_order_relaxed);
    for (; word != 0; word &= word - 1)
    {
      ++count;
    }
  }
  return count;
}

std::size_t VoxelBand::GetMemorySize() const
{
  return this->Keys.size() * WordsPerBrick * sizeof(std::uint64_t) +
    this->Keys.capacity() * sizeof(std::uint64_t) + this->Table.capacity() * sizeof(std::int32_t);
}
}
