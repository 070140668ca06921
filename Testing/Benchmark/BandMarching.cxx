// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BandMarching.h"

#include "dggHeap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace dgg
{
namespace
{
/// Voxels around a source, along each axis, that are given their straight distances: differences
/// would be wrong where distances bend that much.
constexpr std::int32_t StartRadius = 2;
constexpr std::size_t VoxelsPerReport = 4096;
constexpr std::array<std::int32_t, 3> Strides{ { 1, 8, 64 } };

/// The distance that solves |grad d| = 1, given the smaller neighbour along each axis, in voxels.
double SolveUpwind(std::array<double, 3> values)
{
  std::sort(values.begin(), values.end());
  double d = values[0] + 1.0;
  if (d <= values[1])
  {
    return d;
  }
  const double sum = values[0] + values[1];
  const double difference = values[1] - values[0];
  d = 0.5 * (sum + std::sqrt(std::max(0.0, 2.0 - difference * difference)));
  if (d <= values[2])
  {
    return d;
  }
  const double all = sum + values[2];
  const double squares = values[0] * values[0] + values[1] * values[1] + values[2] * values[2];
  return (all + std::sqrt(std::max(0.0, all * all - 3.0 * (squares - 1.0)))) / 3.0;
}

}

/// One march. Distances are in voxels.
class BandMarching::March
{
public:
  explicit March(const BandMarching& tables)
    : Band(tables.Band)
    , Neighbors(tables.Neighbors)
    , Distances(512 * tables.Band.GetNumberOfBricks(), Infinity)
    , IsFinal(Distances.size(), 0)
  {
  }

  /// False when no voxel is near.
  bool Start(const BandSource& source)
  {
    const double size = this->Band.GetVoxelSize();
    const Point3 place = this->Band.ToGrid(source.Place);
    const Voxel own = VoxelBand::VoxelOf(place);
    bool isNear = false;
    for (std::int32_t z = own[2] - StartRadius; z <= own[2] + StartRadius; ++z)
    {
      for (std::int32_t y = own[1] - StartRadius; y <= own[1] + StartRadius; ++y)
      {
        for (std::int32_t x = own[0] - StartRadius; x <= own[0] + StartRadius; ++x)
        {
          const Voxel voxel{ x, y, z };
          const Point3 centre{ x + 0.5, y + 0.5, z + 0.5 };
          if (this->Band.Contains(voxel))
          {
            isNear = true;
            const std::int64_t brick = this->Band.FindBrick(VoxelBand::BrickKey(voxel));
            this->Offer(VoxelBand::PlaceOf(brick, voxel),
              source.InitialDistance / size + Norm(centre - place));
          }
        }
      }
    }
    return isNear;
  }

  /// False when stopped.
  bool Run(const ProgressCallback& progress, double numberOfVoxels)
  {
    std::size_t done = 0;
    while (!this->Heap.IsEmpty())
    {
      const auto place = static_cast<std::size_t>(this->Heap.Pop().Index);
      if (this->IsFinal[place])
      {
        continue;
      }
      this->IsFinal[place] = 1;
      if (progress && done++ % VoxelsPerReport == 0 &&
        !progress(static_cast<double>(done) / numberOfVoxels))
      {
        return false;
      }
      for (int side = 0; side < 6; ++side)
      {
        const std::int64_t next = this->Step(place, side);
        if (next >= 0 && !this->IsFinal[static_cast<std::size_t>(next)])
        {
          this->Update(static_cast<std::size_t>(next));
        }
      }
    }
    return true;
  }

  /// Trilinear between the centres of marked voxels, those that were reached; what others would
  /// weigh is shared among them.
  double Interpolate(const Point3& place) const
  {
    const Point3 centred = this->Band.ToGrid(place) - Point3{ 0.5, 0.5, 0.5 };
    if (!this->Band.IsInBox(centred))
    {
      return Infinity;
    }
    const Voxel low = VoxelBand::VoxelOf(centred);
    const Point3 part = centred -
      Point3{ static_cast<double>(low[0]), static_cast<double>(low[1]),
        static_cast<double>(low[2]) };
    double sum = 0.0;
    double weights = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Voxel voxel{ low[0] + (corner & 1), low[1] + (corner >> 1 & 1),
        low[2] + (corner >> 2) };
      const double weight = ((corner & 1) != 0 ? part.X : 1.0 - part.X) *
        ((corner & 2) != 0 ? part.Y : 1.0 - part.Y) * ((corner & 4) != 0 ? part.Z : 1.0 - part.Z);
      if (weight > 0.0 && this->Band.Contains(voxel))
      {
        const std::int64_t brick = this->Band.FindBrick(VoxelBand::BrickKey(voxel));
        const double distance = this->Distances[VoxelBand::PlaceOf(brick, voxel)];
        if (distance < Infinity)
        {
          sum += weight * distance;
          weights += weight;
        }
      }
    }
    return weights > 0.0 ? sum / weights * this->Band.GetVoxelSize() : Infinity;
  }

private:
  void Offer(std::size_t place, double distance)
  {
    if (distance < this->Distances[place])
    {
      this->Distances[place] = distance;
      this->Heap.Push(distance, static_cast<Id>(place));
    }
  }

  /// The marked voxel on a side, or -1. Sides 2k and 2k+1 are before and after along axis k.
  std::int64_t Step(std::size_t place, int side) const
  {
    const int axis = side / 2;
    const auto local = static_cast<std::int32_t>(place % 512);
    const std::int32_t coordinate = local / Strides[axis] % 8;
    auto brick = static_cast<std::int64_t>(place / 512);
    std::int32_t next = local;
    if (side % 2 == 0)
    {
      brick = coordinate > 0 ? brick : this->Neighbors[brick][side];
      next += coordinate > 0 ? -Strides[axis] : 7 * Strides[axis];
    }
    else
    {
      brick = coordinate < 7 ? brick : this->Neighbors[brick][side];
      next += coordinate < 7 ? Strides[axis] : -7 * Strides[axis];
    }
    if (brick < 0)
    {
      return -1;
    }
    const Voxel inBrick{ next & 7, next >> 3 & 7, next >> 6 };
    return this->Band.IsMarked(brick, inBrick) ? 512 * brick + next : -1;
  }

  void Update(std::size_t place)
  {
    std::array<double, 3> values{ { Infinity, Infinity, Infinity } };
    for (int side = 0; side < 6; ++side)
    {
      const std::int64_t next = this->Step(place, side);
      if (next >= 0 && this->IsFinal[static_cast<std::size_t>(next)])
      {
        values[side / 2] =
          std::min(values[side / 2], this->Distances[static_cast<std::size_t>(next)]);
      }
    }
    this->Offer(place, SolveUpwind(values));
  }

  const VoxelBand& Band;
  const std::vector<std::array<std::int32_t, 6>>& Neighbors;
  std::vector<double> Distances;
  std::vector<std::uint8_t> IsFinal;
  MinimumHeap Heap;
};

BandMarching::BandMarching(const VoxelBand& band)
  : Band(band)
  , Neighbors(band.GetNumberOfBricks())
{
  for (std::size_t brick = 0; brick < this->Neighbors.size(); ++brick)
  {
    const Voxel first = band.GetBrickVoxel(brick);
    for (int side = 0; side < 6; ++side)
    {
      Voxel next = first;
      next[side / 2] += side % 2 == 0 ? -8 : 8;
      this->Neighbors[brick][side] = next[side / 2] < 0
        ? -1
        : static_cast<std::int32_t>(band.FindBrick(VoxelBand::BrickKey(next)));
    }
  }
}

Status BandMarching::Run(const std::vector<BandSource>& sources, const std::vector<Point3>& places,
  const ProgressCallback& progress, std::vector<double>& distances) const
{
  distances.clear();
  if (sources.empty())
  {
    return Status::Invalid("there are no sources: give at least one");
  }
  if (512 * this->Neighbors.size() > static_cast<std::size_t>(std::numeric_limits<Id>::max()))
  {
    return Status::Invalid("the band has too many voxels to march in: use a smaller resolution");
  }
  March march(*this);
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const Point3& p = sources[k].Place;
    if (!std::isfinite(Dot(p, p)) || !std::isfinite(sources[k].InitialDistance))
    {
      return Status::Invalid("source " + std::to_string(k) + " is not finite");
    }
    if (!this->Band.IsInBox(this->Band.ToGrid(p)) || !march.Start(sources[k]))
    {
      return Status::Invalid(
        "source " + std::to_string(k) + " is not in the band: move it closer to the points");
    }
  }
  if (!march.Run(progress, static_cast<double>(this->Band.GetNumberOfVoxels())))
  {
    return Status::Abort();
  }
  distances.reserve(places.size());
  for (const Point3& place : places)
  {
    distances.push_back(march.Interpolate(place));
  }
  return Status::Success();
}
}
