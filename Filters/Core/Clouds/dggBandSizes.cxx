// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBandSizes.h"

#include "dggQuantile.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Maximum ratio of the spacing of a point to the median spacing of its neighbors.
constexpr double LargestSpacingRatio = 1.25;
constexpr double VoxelsPerSpacing = 2.0;
/// Quantile of the spacings from which the voxel size is chosen. The smallest spacings are not
/// representative.
constexpr double SpacingQuantile = 0.2;
/// Maximum mean number of voxels per ball, except where larger voxels would exceed the balls of the
/// densest points.
constexpr double VoxelsPerBall = 2000.0;
/// Unconditional maximum of the mean number of voxels per ball. If the density varies strongly,
/// voxels that fit the balls of the densest points would be far too numerous in the balls of the
/// sparsest points.
constexpr double MostVoxelsPerBall = 4000.0;
/// Maximum automatic number of voxels along the longest side.
constexpr double LargestAutomaticResolution = 1 << 23;
/// Maximum number of spacings along the longest side. Coordinates have a rounding error of 2^-54 of
/// the longest side, so that edges as long as a spacing keep float precision.
constexpr double MostSpacings = 1 << 30;

/// Smallest ratio between the distances of successive neighbors that counts as a gap. The spacing
/// of a point in a group of fewer than SpacingNeighbors points is the distance of the group from
/// the rest of the cloud. If most neighbors of a point belong to such a group, only the neighbors
/// beyond the gap determine its spacing.
constexpr double LeastGap = 4.0;
constexpr std::size_t LeastGroup = SpacingNeighbors / 2 + 1;

/// Returns the number of nearest points that form a separate group, far from the next ones; 0 if no
/// group is separate.
std::size_t CountBeforeGap(const std::vector<CloudNeighbor>& neighbors)
{
  for (std::size_t i = neighbors.size(); i-- > LeastGroup;)
  {
    if (neighbors[i].SquaredDistance > LeastGap * LeastGap * neighbors[i - 1].SquaredDistance)
    {
      return i;
    }
  }
  return 0;
}

double GetMeanVolume(const std::vector<double>& radii)
{
  double sum = 0.0;
  for (const double radius : radii)
  {
    sum += radius * radius * radius;
  }
  return 4.0 / 3.0 * Pi * sum / static_cast<double>(radii.size());
}

/// Returns the error that names the point farthest from the center of the cloud.
Status TooFarApart(
  const CloudNodes& nodes, const std::vector<Point3>& places, double spacing, const char* limit)
{
  Point3 middle;
  std::vector<double> values(places.size());
  for (double Point3::*const axis : { &Point3::X, &Point3::Y, &Point3::Z })
  {
    std::transform(
      places.begin(), places.end(), values.begin(), [&](const Point3& p) { return p.*axis; });
    middle.*axis = Quantile(values, 0.5);
  }
  std::transform(places.begin(), places.end(), values.begin(),
    [&](const Point3& p) { return Norm(p - middle); });
  const auto farthest =
    static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  const double toPoints = 1.0 / nodes.Scale;
  return InvalidInput("Parts of the cloud are too far apart for ", limit,
    ": the spacing of points is ", toPoints * spacing, ", but point ", nodes.Originals[farthest],
    " is ", toPoints * values[farthest], " from the center")
    .Fix("Remove outliers, or process each part separately");
}
}

double SpacingFrom(double squaredDistance, std::size_t k)
{
  return k == 0 ? 0.0 : std::sqrt(Pi * squaredDistance / static_cast<double>(k));
}

float SmoothSpacing(
  float spacing, const std::vector<CloudNeighbor>& neighbors, const std::vector<float>& spacings)
{
  std::vector<float> around;
  for (std::size_t i = CountBeforeGap(neighbors); i < neighbors.size(); ++i)
  {
    around.push_back(spacings[neighbors[i].Point]);
  }
  return std::min(spacing, static_cast<float>(LargestSpacingRatio) * Quantile(around, 0.5));
}

Status ChooseBandSizes(const CloudNodes& nodes, const std::vector<Point3>& places,
  const std::vector<float>& spacings, const BandOptions& options, BandSizes& sizes)
{
  sizes = BandSizes();
  const double h = options.OffsetInVoxels;
  const double factor = options.BallBySpacing;
  std::vector<float> sorted = spacings;
  const double median = Quantile(sorted, 0.5);
  const double dense = Quantile(sorted, SpacingQuantile);
  if (nodes.Extent > MostSpacings * dense)
  {
    return TooFarApart(nodes, places, median, "the precision of coordinates");
  }
  std::vector<double>& radii = sizes.Radii;
  radii.resize(places.size());
  std::transform(spacings.begin(), spacings.end(), radii.begin(),
    [factor](float spacing) { return factor * spacing; });
  double& size = sizes.VoxelSize;
  if (options.Resolution > 0)
  {
    size = nodes.Extent / options.Resolution;
  }
  else
  {
    // The voxels are small enough for the balls of the densest points, unless the other balls would
    // then contain too many voxels.
    const double volume = GetMeanVolume(radii);
    size = h > 0.0
      ? factor * median / h
      : std::clamp(std::cbrt(volume / VoxelsPerBall), dense / VoxelsPerSpacing, factor * dense);
    if (nodes.Extent > LargestAutomaticResolution * size)
    {
      return TooFarApart(nodes, places, median, "a single band of voxels");
    }
    // This minimum may make the voxels too large for the balls of the densest points.
    size = h > 0.0 ? size : std::max(size, std::cbrt(volume / MostVoxelsPerBall));
  }
  if (!(size > 0.0))
  {
    size = 1.0; // a single point
  }
  if (h > 0.0)
  {
    std::fill(radii.begin(), radii.end(), h * size);
  }
  std::vector<double> reordered = radii;
  sizes.MedianRadius = Quantile(reordered, 0.5) / size;
  // The extent is slightly reduced, so that rounding does not increase the requested resolution by
  // one.
  sizes.Resolution = static_cast<Id>(std::min(1e9, std::ceil((1.0 - 1e-12) * nodes.Extent / size)));
  return Status::Success();
}
}
