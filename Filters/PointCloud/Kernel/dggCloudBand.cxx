// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudSetup.h"
#include "dggInvalidInput.h"
#include "dggMemoryLimit.h"
#include "dggQuantile.h"
#include "dggSetupLoop.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dgg
{
namespace
{
constexpr Offset BricksPerTask = 16;
/// Shares of the progress of the setup.
constexpr double ShareOfMarks = 0.1;
constexpr double ShareOfNearest = 0.2;

/// Radius of a ball by spacing: of random points, all but 1 in 10000 of the surface lie in balls.
constexpr double BallBySpacing = 1.5;
/// Scheme A takes its reach from pairs in overlapping balls, so they must be larger.
constexpr double BallBySpacingOfCurvatureScheme = 4.0;
constexpr double VoxelsPerSpacing = 2.0;
/// Spacings that voxels are chosen for: that of the densest points are too small.
constexpr double SpacingQuantile = 0.2;
/// Voxels in a ball on average, at most, unless voxels became larger for it than the balls of the
/// densest points are.
constexpr double VoxelsPerBall = 2000.0;
/// Voxels along the longest side when they are chosen automatically, at most.
constexpr double LargestAutomaticResolution = 1 << 23;
/// Spacings along the longest side, at most. Coordinates are rounded by 2^-54 of it, so that edges
/// as long as a spacing keep the digits of a float.
constexpr double MostSpacings = 1 << 30;

/// Voxels of a ball on average, at most: where density varies much, voxels for the balls of the
/// densest points would be far too many in those of the sparsest.
constexpr double MostVoxelsPerBall = 4000.0;
constexpr double VoxelsPerBrick = 512.0;
constexpr double BytesOfNearest = VoxelsPerBrick * sizeof(Id);
/// Voxels that bricks have beyond a layer of voxels or a ball, on both sides together, on average.
constexpr double BeyondLayer = 10.0;
constexpr double BeyondBall = 8.0;
/// A band that does not fit needs more than it may take by that, whatever was predicted.
constexpr double LeastExcess = 1.01;

double GetMeanVolume(const std::vector<double>& radii)
{
  double sum = 0.0;
  for (const double radius : radii)
  {
    sum += radius * radius * radius;
  }
  return 4.0 / 3.0 * Pi * sum / static_cast<double>(radii.size());
}

/// Steps of the band, one after the other.
class BandBuilder
{
public:
  BandBuilder(const CloudGraphOptions& options, double medianSpacing, SetupLoop& loop,
    CloudSetup& setup, CloudGraphStatistics& statistics)
    : Options(options)
    , MedianSpacing(medianSpacing)
    , Loop(loop)
    , Setup(setup)
    , Pairs(setup.Pairs)
    , Statistics(statistics)
  {
  }

  /// Radii of balls, and the size of voxels.
  Status ChooseSizes()
  {
    const std::size_t n = this->Pairs.Points.size();
    const double extent = this->Setup.Nodes.Extent;
    const double h = this->Options.OffsetInVoxels;
    const double factor = this->Options.Scheme == CloudScheme::Curvature
      ? BallBySpacingOfCurvatureScheme
      : BallBySpacing;
    std::vector<double>& radii = this->Pairs.Radii;
    radii.resize(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      radii[i] = factor * this->Pairs.Spacings[i];
    }
    std::vector<float> spacings = this->Pairs.Spacings;
    if (extent > MostSpacings * Quantile(spacings, SpacingQuantile))
    {
      return this->TooFarApart("the digits of coordinates");
    }
    double& size = this->VoxelSize;
    if (this->Options.Resolution > 0)
    {
      size = extent / this->Options.Resolution;
    }
    else
    {
      size = h > 0.0 ? factor * this->MedianSpacing / h : this->ChooseVoxelSize(factor);
      if (extent > LargestAutomaticResolution * size)
      {
        return this->TooFarApart("one band of voxels");
      }
      // Voxels may be too large for the balls of the densest points then: CloudPairs looks at
      // these.
      size = h > 0.0 ? size : std::max(size, std::cbrt(GetMeanVolume(radii) / MostVoxelsPerBall));
    }
    if (!(size > 0.0))
    {
      size = 1.0; // a single point
    }
    if (h > 0.0)
    {
      std::fill(radii.begin(), radii.end(), h * size);
    }
    std::vector<double> sorted = radii;
    this->Statistics.OffsetInVoxels = Quantile(sorted, 0.5) / size;
    this->Statistics.VoxelSize = size / this->Setup.Nodes.Scale;
    // A hair less, so that rounding does not make one more of those that are asked for.
    this->Statistics.Resolution =
      static_cast<Id>(std::min(1e9, std::ceil((1.0 - 1e-12) * extent / size)));
    return Status::Success();
  }

  Status MarkVoxels()
  {
    std::size_t limit = 0;
    if (this->Options.MemoryLimit > 0)
    {
      const std::size_t used = this->Setup.GetMemorySize();
      DGG_RETURN_IF_ERROR(CheckSetupMemory(used + 1, this->Options)); // and something for the band
      // With room for the nearest points of the voxels.
      const double brick = VoxelBand::PredictMemory(1.0);
      const double share = brick / (brick + BytesOfNearest);
      limit = std::max<std::size_t>(1, // 0: none
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

  /// The nearest point of every marked voxel.
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
  /// Small enough for the balls of the densest points, and no smaller than the others allow. Radii
  /// are spacings times a factor.
  double ChooseVoxelSize(double factor) const
  {
    std::vector<float> spacings = this->Pairs.Spacings;
    const double dense = Quantile(spacings, SpacingQuantile);
    return std::clamp(std::cbrt(GetMeanVolume(this->Pairs.Radii) / VoxelsPerBall),
      dense / VoxelsPerSpacing, factor * dense);
  }

  /// Names the point that is farthest from the middle of the cloud.
  Status TooFarApart(const char* limit) const
  {
    const std::vector<Point3>& points = this->Pairs.Points;
    Point3 middle;
    std::vector<double> values(points.size());
    for (double Point3::*const axis : { &Point3::X, &Point3::Y, &Point3::Z })
    {
      std::transform(
        points.begin(), points.end(), values.begin(), [&](const Point3& p) { return p.*axis; });
      middle.*axis = Quantile(values, 0.5);
    }
    std::transform(points.begin(), points.end(), values.begin(),
      [&](const Point3& p) { return Norm(p - middle); });
    const auto farthest =
      static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    const double toPoints = 1.0 / this->Setup.Nodes.Scale;
    return InvalidInput("parts of the cloud are too far apart for ", limit, ": its points are ",
      toPoints * this->MedianSpacing, " from each other, but point ",
      this->Setup.Nodes.Originals[farthest], " is ", toPoints * values[farthest],
      " from the middle. Leave out points that are wrong, or build one graph for each part");
  }

  /// What helps when there are too many voxels.
  std::string RemedyOfBand() const
  {
    const std::string below =
      " below " + std::to_string(std::min(this->Statistics.Resolution, LargestResolution));
    return this->Options.Resolution > 0 ? "use a Resolution" + below
                                        : "set a Resolution" + below + ", that of now";
  }

  /// Bytes of a band and of the nearest points of its voxels, roughly: that of a surface, on which
  /// each point has the square of its spacing.
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
      JoinText("with the band of voxels, ", resolution, " along the longest side as Resolution ",
        isAutomatic ? "is automatic" : "says", ", each of size ", this->Statistics.VoxelSize,
        " where points are ", this->Statistics.Spacing, " from each other, building the graph"),
      std::max(needed, LeastExcess * limit), limit,
      JoinText(isAutomatic ? "set" : "use", " a Resolution below ", resolution));
  }

  const CloudGraphOptions& Options;
  double MedianSpacing;
  SetupLoop& Loop;
  CloudSetup& Setup;
  CloudPairs& Pairs;
  CloudGraphStatistics& Statistics;
  double VoxelSize = 0.0; ///< in units of the nodes
};
}

Status BuildCloudBand(const CloudGraphOptions& options, double medianSpacing, SetupLoop& loop,
  CloudSetup& setup, CloudGraphStatistics& statistics)
{
  BandBuilder builder(options, medianSpacing, loop, setup, statistics);
  DGG_RETURN_IF_ERROR(builder.ChooseSizes());
  DGG_RETURN_IF_ERROR(builder.MarkVoxels());
  builder.FindNearest();
  return loop.IsStopped() ? Status::Abort() : Status::Success();
}
}
