// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBandMarching.h"

#include "dggHeap.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace dgg
{
namespace
{
/// Radius, in voxels per axis, of the region around a source and on its layer that is initialized
/// with straight distances. Finite differences are inaccurate where distances have high curvature.
constexpr std::int32_t StartRadius = 2;
/// Distance, in voxels, by which the march continues beyond the limit. Indices of the voxels around
/// a position differ by at most one along each axis.
constexpr double BeyondLimit = 3.0;
/// Diagonal of a voxel. Bounds the error of interpolated distances close to a source, on the layer
/// of the source.
constexpr double Diagonal = 1.7320508075688772;
constexpr std::size_t VoxelsPerReport = 4096;
constexpr std::array<std::int32_t, 3> Strides{ { 1, 8, 64 } };

/// Returns the distance that solves |grad d| = 1, in voxels. `values` holds the smaller neighbor
/// along each axis.
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

/// The result at one position.
struct Arrival
{
  double Distance = Infinity;
  Id Source = NoId;
};

/// Calls `visit(voxel, center)` for the voxels of a band around a position, in units of voxels.
template <typename Visitor>
void ForEachNear(const VoxelBand& band, const Point3& inGrid, Visitor&& visit)
{
  const Voxel own = VoxelBand::VoxelOf(inGrid);
  for (std::int32_t z = own[2] - StartRadius; z <= own[2] + StartRadius; ++z)
  {
    for (std::int32_t y = own[1] - StartRadius; y <= own[1] + StartRadius; ++y)
    {
      for (std::int32_t x = own[0] - StartRadius; x <= own[0] + StartRadius; ++x)
      {
        if (band.Contains({ x, y, z }))
        {
          visit(Voxel{ x, y, z }, Point3{ x + 0.5, y + 0.5, z + 0.5 });
        }
      }
    }
  }
}
}

/// One march. Distances are in voxels, relative to the smallest initial distance.
class BandMarching::March
{
public:
  March(const BandMarching& tables, const std::vector<BandSource>& sources, double shift)
    : Band(tables.Band)
    , Neighbors(tables.Neighbors)
    , Voxels(512 * tables.Band.GetNumberOfBricks())
    , IsFinal(Voxels.size(), 0)
  {
    for (const BandSource& source : sources)
    {
      this->Places.push_back(this->Band.ToGrid(source.Place));
      this->Offsets.push_back((source.InitialDistance - shift) / this->Band.GetVoxelSize());
    }
    for (std::size_t k = 0; k < sources.size(); ++k)
    {
      this->Start(k);
    }
  }

  /// Marches up to a distance limit. Returns false if stopped.
  bool Run(double limit, const ProgressCallback& progress)
  {
    const auto numberOfVoxels = static_cast<double>(this->Band.GetNumberOfVoxels());
    std::size_t done = 0;
    while (!this->Heap.IsEmpty() && this->Heap.Top().Key <= limit + BeyondLimit)
    {
      const auto place = static_cast<std::size_t>(this->Heap.Pop().Index);
      if (this->IsFinal[place])
      {
        continue;
      }
      this->IsFinal[place] = 1;
      if (done++ % VoxelsPerReport == 0 &&
        !ShouldContinue(progress, static_cast<double>(done) / numberOfVoxels))
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

  /// Returns the distance at a position, interpolated trilinearly between the centers of reached
  /// marked voxels. The weights of other voxels are distributed among them. Around the source of
  /// the nearest voxel, returns the straight distance.
  Arrival Interpolate(const Point3& place) const
  {
    const Point3 inGrid = this->Band.ToGrid(place);
    const Point3 centered = inGrid - Point3{ 0.5, 0.5, 0.5 };
    if (!this->Band.IsInBox(centered))
    {
      return {};
    }
    const Voxel low = VoxelBand::VoxelOf(centered);
    const Point3 part = centered -
      Point3{ static_cast<double>(low[0]), static_cast<double>(low[1]),
        static_cast<double>(low[2]) };
    double sum = 0.0;
    double weights = 0.0;
    Arrival nearest;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Voxel voxel{ low[0] + (corner & 1), low[1] + (corner >> 1 & 1),
        low[2] + (corner >> 2) };
      const double weight = ((corner & 1) != 0 ? part.X : 1.0 - part.X) *
        ((corner & 2) != 0 ? part.Y : 1.0 - part.Y) * ((corner & 4) != 0 ? part.Z : 1.0 - part.Z);
      if (weight > 0.0 && this->Band.Contains(voxel))
      {
        const std::int64_t brick = this->Band.FindBrick(VoxelBand::BrickKey(voxel));
        const std::size_t index = VoxelBand::PlaceOf(brick, voxel);
        if (this->IsFinal[index])
        {
          const Arrival& arrival = this->Voxels[index];
          sum += weight * arrival.Distance;
          weights += weight;
          nearest = arrival.Distance < nearest.Distance ? arrival : nearest;
        }
      }
    }
    if (weights == 0.0)
    {
      return {};
    }
    const auto source = static_cast<std::size_t>(nearest.Source);
    const double straight = this->Offsets[source] + Norm(inGrid - this->Places[source]);
    nearest.Distance = sum / weights;
    if (straight - this->Offsets[source] <= StartRadius && nearest.Distance < straight + Diagonal)
    {
      nearest.Distance = std::min(nearest.Distance, straight);
    }
    return nearest;
  }

private:
  /// Initializes the voxel of the band that is closest to a source, and the voxels around the
  /// source that are connected to this voxel. Other voxels are on another layer.
  void Start(std::size_t k)
  {
    const Point3& source = this->Places[k];
    const Voxel own = VoxelBand::VoxelOf(source);
    std::vector<Voxel> reached(1);
    double closest = Infinity;
    ForEachNear(this->Band, source, [&](const Voxel& voxel, const Point3& center) {
      const double distance = Norm(center - source);
      reached[0] = distance < closest ? voxel : reached[0];
      closest = std::min(closest, distance);
    });
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      const Voxel voxel = reached[i];
      const Point3 center{ voxel[0] + 0.5, voxel[1] + 0.5, voxel[2] + 0.5 };
      const std::int64_t brick = this->Band.FindBrick(VoxelBand::BrickKey(voxel));
      this->Offer(VoxelBand::PlaceOf(brick, voxel),
        { this->Offsets[k] + Norm(center - source), static_cast<Id>(k) });
      for (int side = 0; side < 6; ++side)
      {
        Voxel next = voxel;
        next[side / 2] += side % 2 == 0 ? -1 : 1;
        if (std::abs(next[side / 2] - own[side / 2]) <= StartRadius && this->Band.Contains(next) &&
          std::find(reached.begin(), reached.end(), next) == reached.end())
        {
          reached.push_back(next);
        }
      }
    }
  }

  void Offer(std::size_t place, const Arrival& arrival)
  {
    if (arrival.Distance < this->Voxels[place].Distance)
    {
      this->Voxels[place] = arrival;
      this->Heap.Push(arrival.Distance, static_cast<Id>(place));
    }
  }

  /// Returns the index of the marked neighbor on a side, or -1. Sides 2k and 2k+1 are before and
  /// after the voxel along axis k.
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
    Arrival nearest;
    for (int side = 0; side < 6; ++side)
    {
      const std::int64_t next = this->Step(place, side);
      if (next >= 0 && this->IsFinal[static_cast<std::size_t>(next)])
      {
        const Arrival& arrival = this->Voxels[static_cast<std::size_t>(next)];
        values[side / 2] = std::min(values[side / 2], arrival.Distance);
        nearest = arrival.Distance < nearest.Distance ? arrival : nearest;
      }
    }
    this->Offer(place, { SolveUpwind(values), nearest.Source });
  }

  const VoxelBand& Band;
  const std::vector<std::array<std::int32_t, 6>>& Neighbors;
  std::vector<Point3> Places; ///< positions of sources, in units of voxels
  std::vector<double> Offsets;
  std::vector<Arrival> Voxels;
  std::vector<std::uint8_t> IsFinal;
  DistanceHeap Heap;
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

double BandMarching::PredictMemory(double bricks)
{
  return bricks * (512.0 * (sizeof(Arrival) + 1.0) + sizeof(Neighbors[0]));
}

bool BandMarching::CanMarchIn(const VoxelBand& band)
{
  return 512 * band.GetNumberOfBricks() <= static_cast<std::size_t>(std::numeric_limits<Id>::max());
}

bool BandMarching::IsNear(const Point3& place) const
{
  const Point3 inGrid = this->Band.ToGrid(place);
  bool isNear = false;
  if (IsFinite(inGrid) && this->Band.IsInBox(inGrid))
  {
    ForEachNear(this->Band, inGrid, [&](const Voxel&, const Point3&) { isNear = true; });
  }
  return isNear;
}

Status BandMarching::Run(const std::vector<BandSource>& sources, const std::vector<Point3>& places,
  const BandMarchingOptions& options, BandMarchingResult& result) const
{
  result = BandMarchingResult();
  if (sources.empty())
  {
    return InvalidInput("There is no source").Fix("Add at least one source");
  }
  if (!CanMarchIn(this->Band))
  {
    return InvalidInput("The band has too many voxels for a march")
      .Fix("Use a smaller {Resolution}");
  }
  double shift = Infinity;
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    if (!IsFinite(sources[k].Place) || !std::isfinite(sources[k].InitialDistance))
    {
      return InvalidInput("Source ", k, " has a position or an initial distance that is not finite")
        .Fix("Move or remove the source");
    }
    if (!this->IsNear(sources[k].Place))
    {
      return InvalidInput("Source ", k, " is outside of the band of voxels")
        .Fix("Move the source closer to the points");
    }
    shift = std::min(shift, sources[k].InitialDistance);
  }
  const double size = this->Band.GetVoxelSize();
  March march(*this, sources, shift);
  if (!march.Run((options.MaximumDistance - shift) / size, options.Progress))
  {
    return Status::Abort();
  }
  result.Distances.reserve(places.size());
  result.NearestSource.reserve(places.size());
  for (const Point3& place : places)
  {
    const Arrival arrival = march.Interpolate(place);
    result.Distances.push_back(shift + size * arrival.Distance);
    result.NearestSource.push_back(arrival.Source);
  }
  return Status::Success();
}
}
