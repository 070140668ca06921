// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBandSizes.h"
#include "dggCloudSetup.h"
#include "dggMemoryLimit.h"
#include "dggSetupLoop.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
constexpr Offset BricksPerTask = 16;
/// Progress weights of steps of the setup.
constexpr double ShareOfMarks = 0.1;
constexpr double ShareOfNearest = 0.2;

/// Ratio of ball radius to spacing for scheme A. Its reach is derived from pairs in overlapping
/// balls, so the balls must be larger than in other schemes.
constexpr double BallBySpacingOfCurvatureScheme = 4.0;

constexpr double VoxelsPerBrick = 512.0;
constexpr double BytesOfNearest = VoxelsPerBrick * sizeof(Id);
/// Average thickness, in voxels, by which bricks exceed a layer of voxels or the diameter of a
/// ball, summed over both sides.
constexpr double BeyondLayer = 10.0;
constexpr double BeyondBall = 8.0;
/// Minimum ratio of the reported memory to the limit if a band does not fit. Used if the predicted
/// memory is lower.
constexpr double LeastExcess = 1.01;

/// Runs the steps of the band construction in sequence.
class BandBuilder
{
public:
  BandBuilder(const CloudGraphOptions& options, SetupLoop& loop, CloudSetup& setup,
    CloudGraphStatistics& statistics)
    : Options(options)
    , Loop(loop)
    , Setup(setup)
    , Pairs(setup.Pairs)
    , Statistics(statistics)
  {
  }

  /// Chooses the ball radii and the voxel size.
  Status ChooseSizes()
  {
    BandOptions options;
    options.OffsetInVoxels = this->Options.OffsetInVoxels;
    options.Resolution = this->Options.Resolution;
    if (this->Options.Scheme == CloudScheme::Curvature)
    {
      options.BallBySpacing = BallBySpacingOfCurvatureScheme;
    }
    BandSizes sizes;
    DGG_RETURN_IF_ERROR(
      ChooseBandSizes(this->Setup.Nodes, this->Pairs.Points, this->Pairs.Spacings, options, sizes));
    this->Pairs.Radii = std::move(sizes.Radii);
    this->VoxelSize = sizes.VoxelSize;
    this->Statistics.OffsetInVoxels = sizes.MedianRadius;
    this->Statistics.VoxelSize = sizes.VoxelSize / this->Setup.Nodes.Scale;
    this->Statistics.Resolution = sizes.Resolution;
    return Status::Success();
  }

  Status MarkVoxels()
  {
    std::size_t limit = 0;
    if (this->Options.MemoryLimit > 0)
    {
      const std::size_t used = this->Setup.GetMemorySize();
      // At least one byte for the band.
      DGG_RETURN_IF_ERROR(CheckSetupMemory(used + 1, this->Options));
      // Reserve memory for the nearest points of the voxels.
      const double brick = VoxelBand::PredictMemory(1.0);
      const double share = brick / (brick + BytesOfNearest);
      limit = std::max<std::size_t>(1, // 0 means no limit
        static_cast<std::size_t>(static_cast<double>(this->Options.MemoryLimit - used) * share));
    }
    Status status = this->Pairs.Band.Build(
      this->Pairs.Points, this->Pairs.Radii, this->VoxelSize, limit, this->Options.Parallel,
      [this](double part) { return this->Loop.Report(ShareOfMarks, part); }, this->RemedyOfBand());
    if (this->Pairs.Band.IsTooLarge())
    {
      status = this->RefuseBand();
    }
    this->Loop.Skip(ShareOfMarks);
    this->Statistics.BandMemory = this->Pairs.Band.GetMemorySize();
    return status;
  }

  /// Finds the nearest point of each marked voxel.
  void FindNearest()
  {
    const VoxelBand& band = this->Pairs.Band;
    const std::size_t bricks = band.GetNumberOfBricks();
    this->Pairs.Nearest.assign(512 * bricks, NoId);
    this->Loop.ForPieces(
      static_cast<Offset>(bricks), BricksPerTask, ShareOfNearest, [&](Offset begin, Offset end) {
        std::vector<CloudNeighbor> neighbors;
        for (Offset brick = begin; brick < end; ++brick)
        {
          const Voxel first = band.GetBrickVoxel(static_cast<std::size_t>(brick));
          for (std::int32_t i = 0; i < 512; ++i)
          {
            const Voxel voxel{ first[0] + (i & 7), first[1] + (i >> 3 & 7), first[2] + (i >> 6) };
            if (band.IsMarked(brick, voxel))
            {
              this->Setup.Neighbors->FindNearest(band.GetCentre(voxel), 1, neighbors);
              this->Pairs.Nearest[VoxelBand::PlaceOf(brick, voxel)] = neighbors[0].Point;
            }
          }
        }
      });
  }

private:
  /// Returns the advice for messages about too many voxels.
  std::string RemedyOfBand() const
  {
    return JoinText(
      "Use a {Resolution} below ", std::min(this->Statistics.Resolution, LargestResolution));
  }

  /// Predicts the memory in bytes of the band and of the nearest points of its voxels. The
  /// prediction assumes a surface on which the area per point is the square of the spacing.
  double PredictMemory() const
  {
    double voxels = 0.0;
    for (std::size_t i = 0; i < this->Pairs.Radii.size(); ++i)
    {
      const double spacing = this->Pairs.Spacings[i] / this->VoxelSize;
      const double diameter = 2.0 * this->Pairs.Radii[i] / this->VoxelSize;
      voxels += std::min(
        spacing * spacing * (diameter + BeyondLayer), std::pow(diameter + BeyondBall, 3.0));
    }
    const double bricks = voxels / VoxelsPerBrick;
    return VoxelBand::PredictMemory(bricks) + BytesOfNearest * bricks;
  }

  Status RefuseBand() const
  {
    const bool isAutomatic = this->Options.Resolution <= 0;
    const double resolution = this->Statistics.Resolution;
    const auto limit = static_cast<double>(this->Options.MemoryLimit);
    const double needed = static_cast<double>(this->Setup.GetMemorySize()) + this->PredictMemory();
    return CheckMemory(
      JoinText("Building the graph with a band of ", resolution,
        isAutomatic ? " (automatic) voxels" : " voxels", " along the longest side, of size ",
        this->Statistics.VoxelSize, " at a point spacing of ", this->Statistics.Spacing, ","),
      std::max(needed, LeastExcess * limit), limit,
      JoinText("Use a {Resolution} below ", resolution));
  }

  const CloudGraphOptions& Options;
  SetupLoop& Loop;
  CloudSetup& Setup;
  CloudPairs& Pairs;
  CloudGraphStatistics& Statistics;
  double VoxelSize = 0.0; ///< in units of nodes
};
}

Status BuildCloudBand(const CloudGraphOptions& options, SetupLoop& loop, CloudSetup& setup,
  CloudGraphStatistics& statistics)
{
  BandBuilder builder(options, loop, setup, statistics);
  DGG_RETURN_IF_ERROR(builder.ChooseSizes());
  DGG_RETURN_IF_ERROR(builder.MarkVoxels());
  builder.FindNearest();
  return loop.IsStopped() ? Status::Abort() : Status::Success();
}
}
