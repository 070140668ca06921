// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBandBudget.h"

#include "dggMemoryLimit.h"
#include "dggVoxelBand.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dgg
{
namespace
{
constexpr double MostVoxelsPerBall = 4000.0;
constexpr double VoxelsPerBrick = 512.0;
constexpr double BytesOfNearest = VoxelsPerBrick * sizeof(Id);
/// Voxels that bricks have beyond a layer of voxels or a ball, on both sides together, on average.
constexpr double BeyondLayer = 10.0;
constexpr double BeyondBall = 8.0;
/// A band that does not fit needs more than it may take by that, whatever was predicted.
constexpr double LeastExcess = 1.01;
}

double FindLeastVoxelSize(const std::vector<double>& radii)
{
  double sum = 0.0;
  for (const double radius : radii)
  {
    sum += radius * radius * radius;
  }
  const double meanVolume = 4.0 / 3.0 * Pi * sum / static_cast<double>(radii.size());
  return std::cbrt(meanVolume / MostVoxelsPerBall);
}

double PredictBandMemory(
  const std::vector<float>& spacings, const std::vector<double>& radii, double voxelSize)
{
  double voxels = 0.0;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    const double spacing = spacings[i] / voxelSize;
    const double diameter = 2.0 * radii[i] / voxelSize;
    voxels +=
      std::min(spacing * spacing * (diameter + BeyondLayer), std::pow(diameter + BeyondBall, 3.0));
  }
  const double bricks = voxels / VoxelsPerBrick;
  return VoxelBand::PredictMemory(bricks) + BytesOfNearest * bricks;
}

std::size_t GetShareOfBricks(std::size_t memory)
{
  const double brick = VoxelBand::PredictMemory(1.0);
  return static_cast<std::size_t>(static_cast<double>(memory) * brick / (brick + BytesOfNearest));
}

Status RefuseBand(const BandInNumbers& band)
{
  std::ostringstream what;
  what << "with the band of voxels, " << band.Resolution << " along the longest side as Resolution "
       << (band.IsAutomatic ? "is automatic" : "says") << ", each of size " << band.VoxelSize
       << " where points are " << band.Spacing << " from each other, building the graph";
  std::ostringstream remedy;
  remedy << (band.IsAutomatic ? "set" : "use") << " a Resolution below " << band.Resolution;
  return CheckMemory(what.str(), std::max(band.Used + band.Needed, LeastExcess * band.MemoryLimit),
    band.MemoryLimit, remedy.str());
}
}
