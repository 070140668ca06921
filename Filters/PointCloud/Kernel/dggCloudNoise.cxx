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
/// Neighbours that a surface is fitted to; more where points are noisy.
constexpr std::size_t FitNeighbors = 16;
constexpr std::size_t WideFitNeighbors = 32;
constexpr std::size_t MostFitNeighbors = 256;
/// The plane of fewer neighbours is taken where the surface does not fit, by its residual in
/// spacings, and the plane does twice as well: at sheets close together and sharp edges.
constexpr std::size_t NarrowFitNeighbors = 8;
constexpr double LargestResidual = 0.1;
/// Points are noisy when they lie off the fitted surface by that much of their spacing, and not by
/// more when it is fitted to more neighbours: from shapes too fine for it they are off the more the
/// wider it is (measured: 1.0 to 1.15 for noise, 1.35 to 1.6 for scans and terrain). Noisy points
/// are moved to the surface.
constexpr double NoisyResidual = 0.03;
constexpr double LargestGrowthOfNoise = 1.2;
/// Nodes at which the growth is measured.
constexpr std::size_t SampleSize = 2000;
/// Neighbours lie on no surface when the fitted one misses them by more than that part of the
/// radius that they are in. In a volume it is 0.27 at 16 neighbours, and 0.3 at more; for noise of
/// 1, 2 and 3 spacings it falls below at 32, 128 and 256.
constexpr double MissOfNoSurface = 0.25;
/// From that part on, more neighbours may distinguish more noise from a volume.
constexpr double MissOfMuchNoise = 0.2;
/// Once they do, the residual of a noisy plane grows with each doubling by twice the square of its
/// part of the radius (measured: within 0.01, for 1 to 3 spacings), and by more than this besides
/// where the shape is finer.
constexpr double GrowthOfFineShape = 0.02;
/// Fits are for no more than that part of the cloud.
constexpr std::size_t LeastPartsOfCloud = 8;
constexpr std::size_t WideSampleSize = 500;
/// Share of such nodes that is too large to be single points and edges (measured: below 0.05 on
/// scans, 0.43 for noise of one spacing at 16 neighbours).
constexpr double LargestShareOffSurface = 0.1;
/// Noise is looked for with as many neighbours as that at most.
constexpr std::size_t WidestFitNeighbors = 512;
/// Residual, by spacing, of surfaces that are smooth.
constexpr double SmoothResidual = 0.004;

/// Shares of the progress of taking noise off: of each measurement (there are seven at most), of
/// the tree of the points that have been moved, and of the fits before and after.
constexpr double ShareOfMeasurement = 0.025;
constexpr double ShareOfTree = 0.02;
constexpr double ShareOfFit = 0.4;

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

float BySpacing(const CloudPairs& pairs, std::size_t node, double length)
{
  const double spacing = pairs.Spacings[node];
  return spacing > 0.0 ? static_cast<float>(length / spacing) : 0.0f;
}

/// How often surfaces are fitted: to the nearest points, and to those nearest to the first surface
/// then. A node far off has fewer of those on the other side of the surface among its nearest.
enum class FitPasses
{
  One,
  Two
};

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
      // Of fewer points nothing can be said.
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

/// Median residual of surfaces that are fitted to so many neighbours, at some of the nodes.
struct TypicalResidual
{
  double BySpacing = 0.0;
  double ByRadius = 0.0; ///< that the neighbours are in
};

/// Takes a measurement's part of the share. What it returns means nothing when stopped.
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

/// As many neighbours as show the surface where noise is so large that few of them seem to lie in a
/// volume: the residual is a small part of the radius that they are in, and hardly grows with it. 0
/// when there is no such number. `residual` is the one of FitNeighbors, by spacing.
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
      break; // the shape is finer
    }
    residual = wide.BySpacing;
  }
  return found;
}

/// As many neighbours as noise is taken off with; 0 when there is none, or more than few show it.
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

/// How far points scatter about what surface there may be, in spacings: by the widest fits, whose
/// neighbours show the spacing as well, as a part of a plane would have it.
/// 0 when most nodes lie on one.
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
    lengths = fits.Residuals; // fits to few neighbours have followed it
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
  setup.Neighbors.reset(); // before another one is taken
  setup.Neighbors = std::make_unique<CloudNeighbors>(pairs.Points);
  loop.Skip(ShareOfTree * share);
  // What is left of the noise is not to be followed.
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
