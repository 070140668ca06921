// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudNoise.h"

#include "dggLocalFit.h"
#include "dggQuantile.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace dgg
{
namespace
{
/// Number of neighbors that a surface is fitted to: default, and minimum and maximum for noisy
/// points.
constexpr std::size_t FitNeighbors = 16;
constexpr std::size_t WideFitNeighbors = 32;
constexpr std::size_t MostFitNeighbors = 256;
/// Number of neighbors of a narrow fit, and ratio of residual to spacing above which one is tried.
/// The normal of the narrow fit is used if its residual is less than half as large. This occurs at
/// layers close together and at sharp edges.
constexpr std::size_t NarrowFitNeighbors = 8;
constexpr double LargestResidual = 0.1;
/// Points are noisy if the residual of the fitted surface exceeds NoisyResidual, in spacings, and a
/// fit to more neighbors does not increase it by more than the factor LargestGrowthOfNoise. For
/// shapes too fine for the fit, the residual grows with its width (measured factors: 1.0 to 1.15
/// for noise, 1.35 to 1.6 for scans and terrain). Noisy points are moved to the surface.
constexpr double NoisyResidual = 0.03;
constexpr double LargestGrowthOfNoise = 1.2;
/// Number of nodes at which the growth is measured.
constexpr std::size_t SampleSize = 2000;
/// Ratio of the residual of the fitted surface to the neighborhood radius above which neighbors lie
/// on no surface. In a volume the ratio is 0.27 for 16 neighbors, and 0.3 for more. For noise of 1,
/// 2 and 3 spacings the ratio falls below the limit at 32, 128 and 256 neighbors.
constexpr double MissOfNoSurface = 0.25;
/// Ratio of residual to neighborhood radius from which on more neighbors may distinguish large
/// noise from a volume.
constexpr double MissOfMuchNoise = 0.2;
/// Tolerance for the growth of the residual with each doubling of the number of neighbors, once
/// they distinguish noise from a volume. For a noisy plane with the ratio r of residual to radius,
/// the relative growth is 2 r^2 (measured: within 0.01, for noise of 1 to 3 spacings). A growth
/// that exceeds this by more than the tolerance indicates a shape finer than the fit.
constexpr double GrowthOfFineShape = 0.02;
/// A fit uses at most the fraction 1 / LeastPartsOfCloud of the nodes.
constexpr std::size_t LeastPartsOfCloud = 8;
/// Number of nodes at which fits to many neighbors are measured.
constexpr std::size_t WideSampleSize = 500;
/// Maximum fraction of nodes off any surface that is attributed to single points and edges
/// (measured: below 0.05 on scans, 0.43 for noise of one spacing at 16 neighbors).
constexpr double LargestShareOffSurface = 0.1;
/// Maximum number of neighbors in the search for noise.
constexpr std::size_t WidestFitNeighbors = 512;
/// Ratio of residual to spacing below which a surface is smooth.
constexpr double SmoothResidual = 0.004;

/// Progress weights within the removal of noise: each measurement (at most seven), the kd-tree of
/// the moved points, and each of the fits before and after the move.
constexpr double ShareOfMeasurement = 0.025;
constexpr double ShareOfTree = 0.02;
constexpr double ShareOfFit = 0.4;

/// Finds the nearest nodes of a position, and their positions.
void FindPlaces(const CloudSetup& setup, const Point3& point, std::size_t count,
  std::vector<CloudNeighbor>& neighbors, std::vector<Point3>& places)
{
  setup.Neighbors->FindNearest(point, count, neighbors);
  places.clear();
  for (const CloudNeighbor& neighbor : neighbors)
  {
    places.push_back(setup.Pairs.Points[neighbor.Point]);
  }
}

/// Returns the ratio of a length to the spacing of a node; 0 if the spacing is 0.
float BySpacing(const CloudPairs& pairs, std::size_t node, double length)
{
  const double spacing = pairs.Spacings[node];
  return spacing > 0.0 ? static_cast<float>(length / spacing) : 0.0f;
}

/// Number of passes of a fit. The first pass fits to the points nearest to the node, the second to
/// the points nearest to the first surface. The nearest points of a node far from the surface
/// include too few points on the opposite side of the surface.
enum class FitPasses
{
  One,
  Two
};

/// Fits a surface to `count` neighbors of each node. Sets the spacings and normals of the pairs,
/// and `fits`. `share` is the progress weight. Returns false if stopped.
bool FitTo(std::size_t count, FitPasses passes, CloudSetup& setup, double share, SetupLoop& loop,
  CloudFits& fits)
{
  CloudPairs& pairs = setup.Pairs;
  const std::size_t n = pairs.Points.size();
  pairs.Spacings.assign(n, 0.0f);
  pairs.Normals.assign(n, Point3());
  fits.Curvatures.assign(n, 0.0f);
  fits.Residuals.assign(n, 0.0f);
  fits.ToSurface.assign(n, Point3());
  std::atomic<std::size_t> off{ 0 };
  const std::size_t cost = count / FitNeighbors * (passes == FitPasses::Two ? 2 : 1);
  const auto fitAll = [&](Id begin, Id end) {
    std::vector<CloudNeighbor> neighbors;
    std::vector<Point3> places;
    std::size_t misses = 0;
    for (Id node = begin; node < end; ++node)
    {
      const Point3& point = pairs.Points[node];
      FindPlaces(setup, point, std::max(count, SpacingNeighbors) + 1, neighbors, places);
      const std::size_t k = std::min(SpacingNeighbors, neighbors.size() - 1);
      pairs.Spacings[node] = static_cast<float>(SpacingFrom(neighbors[k].SquaredDistance, k));
      LocalFit fit = FitSurface(point, places.data(), std::min(count + 1, places.size()));
      if (passes == FitPasses::Two)
      {
        const Point3 first = fit.ToSurface;
        FindPlaces(setup, point + first, count + 1, neighbors, places);
        fit = FitSurface(point + first, places.data(), places.size());
        fit.ToSurface = first + fit.ToSurface;
      }
      // Fewer points than requested allow no conclusion.
      misses += places.size() > count &&
          fit.Residual > MissOfNoSurface * std::sqrt(neighbors[count].SquaredDistance)
        ? 1
        : 0;
      pairs.Normals[node] = fit.Normal;
      if (fit.Residual > LargestResidual * pairs.Spacings[node])
      {
        const LocalFit narrow =
          FitSurface(point, places.data(), std::min(NarrowFitNeighbors + 1, places.size()));
        if (2.0 * narrow.Residual < fit.Residual)
        {
          pairs.Normals[node] = narrow.Normal;
        }
      }
      fits.Curvatures[node] = static_cast<float>(fit.Curvature);
      fits.Residuals[node] = static_cast<float>(fit.Residual);
      fits.ToSurface[node] = fit.ToSurface;
    }
    off += misses;
  };
  const bool goesOn = loop.ForNodes(n, share, fitAll, cost);
  fits.OffSurface = n > 0 ? static_cast<double>(off) / static_cast<double>(n) : 0.0;
  return goesOn;
}

/// Median residual of surfaces fitted to a given number of neighbors, over a sample of nodes.
struct TypicalResidual
{
  double BySpacing = 0.0; ///< relative to the spacing
  double ByRadius = 0.0;  ///< relative to the neighborhood radius
};

/// Measures the typical residual. Uses the progress weight of one measurement, as a fraction of
/// `share`. After a stop, the result must not be used.
TypicalResidual MeasureResidual(
  const CloudSetup& setup, std::size_t count, std::size_t sampleSize, double share, SetupLoop& loop)
{
  const CloudPairs& pairs = setup.Pairs;
  const std::size_t n = pairs.Points.size();
  const std::size_t size = std::min(n, sampleSize);
  std::vector<float> bySpacing(size);
  std::vector<float> byRadius(size);
  const auto measure = [&](Id begin, Id end) {
    std::vector<CloudNeighbor> neighbors;
    std::vector<Point3> places;
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      const std::size_t node = i * n / size;
      const Point3& point = pairs.Points[node];
      FindPlaces(setup, point, count + 1, neighbors, places);
      const LocalFit fit = FitSurface(point, places.data(), places.size());
      bySpacing[i] = BySpacing(pairs, node, fit.Residual);
      const double radius = std::sqrt(neighbors.back().SquaredDistance);
      byRadius[i] = radius > 0.0 ? static_cast<float>(fit.Residual / radius) : 0.0f;
    }
  };
  loop.ForNodes(size, ShareOfMeasurement * share, measure, count / FitNeighbors);
  return { Quantile(bySpacing, 0.5), Quantile(byRadius, 0.5) };
}

/// Returns the number of neighbors that reveal the surface if noise is so large that few neighbors
/// seem to lie in a volume; 0 if there is no such number. With this number, the residual is a small
/// fraction of the neighborhood radius and hardly grows with the radius. `residual` is the median
/// residual for FitNeighbors neighbors, in spacings.
std::size_t FindNeighborsForMuchNoise(
  const CloudSetup& setup, double residual, double share, SetupLoop& loop)
{
  if (residual < MissOfMuchNoise * std::sqrt(static_cast<double>(FitNeighbors) / Pi))
  {
    return 0;
  }
  const std::size_t most =
    std::min(WidestFitNeighbors, setup.Pairs.Points.size() / LeastPartsOfCloud);
  std::size_t found = 0;
  double largestGrowth = LargestGrowthOfNoise;
  for (std::size_t count = WideFitNeighbors; count <= most && !loop.IsStopped(); count *= 2)
  {
    const TypicalResidual wide = MeasureResidual(setup, count, WideSampleSize, share, loop);
    const double growth = wide.BySpacing / residual;
    if (growth < largestGrowth && wide.ByRadius < MissOfNoSurface)
    {
      found = count;
      largestGrowth = 1.0 + 2.0 * wide.ByRadius * wide.ByRadius + GrowthOfFineShape;
    }
    else if (found > 0)
    {
      break; // the shape is finer than the fit
    }
    residual = wide.BySpacing;
  }
  return found;
}

/// Returns the number of neighbors of the fits that remove noise; 0 if there is no noise, or if
/// more than a few neighbors are needed to reveal noise. `residual` is the median residual for
/// FitNeighbors neighbors, in spacings.
std::size_t FindNeighborsForNoise(
  const CloudSetup& setup, double residual, double share, SetupLoop& loop)
{
  if (!(residual > NoisyResidual))
  {
    return 0;
  }
  const TypicalResidual wide = MeasureResidual(setup, WideFitNeighbors, SampleSize, share, loop);
  if (!(wide.BySpacing < LargestGrowthOfNoise * residual))
  {
    return 0;
  }
  return static_cast<std::size_t>(
    std::clamp<double>(640.0 * residual, WideFitNeighbors, MostFitNeighbors));
}

/// Returns the typical distance of points from a surface, in spacings; 0 if most nodes lie on one.
/// The distance is measured by the widest fits. The spacing is derived from their neighborhood
/// radius, as for points of a plane.
double MeasureScatter(const CloudSetup& setup, double offSurface, double share, SetupLoop& loop)
{
  if (!(offSurface > LargestShareOffSurface))
  {
    return 0.0;
  }
  const std::size_t count = std::min(WidestFitNeighbors, setup.Pairs.Points.size() - 1);
  return MeasureResidual(setup, count, WideSampleSize, share, loop).ByRadius *
    std::sqrt(static_cast<double>(count) / Pi);
}
}

bool FitSurfaces(CloudSetup& setup, double share, SetupLoop& loop, CloudFits& fits)
{
  return FitTo(FitNeighbors, FitPasses::One, setup, share, loop, fits);
}

bool RemoveNoise(
  CloudSetup& setup, double share, SetupLoop& loop, CloudFits& fits, CloudNoise& noise)
{
  CloudPairs& pairs = setup.Pairs;
  const std::size_t n = pairs.Points.size();
  noise = CloudNoise();
  noise.OffSurface = fits.OffSurface;
  std::vector<float> residuals(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    residuals[i] = BySpacing(pairs, i, fits.Residuals[i]);
    pairs.IsSmooth[i] = residuals[i] < SmoothResidual ? 1 : 0;
  }
  const double residual = Quantile(residuals, 0.5);
  std::size_t count = FindNeighborsForNoise(setup, residual, share, loop);
  const bool isMuch = count == 0;
  if (isMuch)
  {
    count = FindNeighborsForMuchNoise(setup, residual, share, loop);
  }
  if (count == 0)
  {
    noise.Scatter = MeasureScatter(setup, noise.OffSurface, share, loop);
    return !loop.IsStopped();
  }
  std::vector<float> lengths = fits.Residuals;
  const FitPasses passes = isMuch ? FitPasses::Two : FitPasses::One;
  if (!FitTo(count, passes, setup, ShareOfFit * share, loop, fits))
  {
    return false;
  }
  if (isMuch)
  {
    lengths = fits.Residuals; // fits to few neighbors have followed the noise
  }
  noise.Removed = Quantile(lengths, 0.5);
  noise.OffSurface = fits.OffSurface;
  noise.Scatter = MeasureScatter(setup, noise.OffSurface, share, loop);
  if (loop.IsStopped())
  {
    return false;
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    pairs.Points[i] = pairs.Points[i] + fits.ToSurface[i];
  }
  setup.Neighbors.reset(); // release the old tree before the new one is built
  setup.Neighbors = std::make_unique<CloudNeighbors>(pairs.Points);
  loop.Skip(ShareOfTree * share);
  // Paths must not follow the remaining noise.
  std::fill(pairs.IsSmooth.begin(), pairs.IsSmooth.end(), 1);
  if (!FitTo(count, FitPasses::One, setup, ShareOfFit * share, loop, fits))
  {
    return false;
  }
  std::vector<float> curvatures = fits.Curvatures;
  noise.RemovedByRadius = noise.Removed * Quantile(curvatures, 0.5);
  return true;
}
}
