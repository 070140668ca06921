// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudSetup.h"

#include "dggBandBudget.h"
#include "dggCloudNoise.h"
#include "dggMemoryLimit.h"
#include "dggQuantile.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>

namespace dgg
{
namespace
{
constexpr Offset NodesPerTask = 64;
constexpr Offset BricksPerTask = 16;
/// Tasks of a loop between two reports of progress.
constexpr Offset PiecesPerReport = 64;
/// Share of the progress that goes to the band.
constexpr double ShareOfBand = 0.1;
constexpr double ShareOfFits = 0.22;
/// Of fitting surfaces to more neighbours, and once more when points have been moved.
constexpr double ShareOfNoise = 0.08;

/// The spacing of a point is at most that of its neighbours by this: a point on its own, far off
/// the surface, must not get a ball that reaches it, nor one at a border a larger one.
constexpr double LargestSpacingRatio = 1.25;
/// A group of fewer points than there are neighbours has a gap among the distances of them, the
/// next one being that many times as far. Then only those beyond the gap tell the spacing: the
/// others would tell how far off the group is, when they are the larger part.
constexpr double LeastGap = 4.0;
constexpr std::size_t LeastGroup = SpacingNeighbors / 2 + 1;

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

/// Reach by spacing, scheme C.
constexpr double ReachBySpacing = 10.5;
/// The same where points are followed: what is between them adds up.
constexpr double RoughReachBySpacing = 5.5;
/// With chords, the reach at which zigzag and shortcut balance, by (s^2 / curvature)^(1/3).
constexpr double BalancedReach = 1.67;
constexpr double LeastReach = 3.5;
constexpr double MostReach = 16.0;
/// Turn of the surface along an edge, at most: beyond it arcs are guesses.
constexpr double TurnOfReach = 0.8;
/// Reach by spacing that B is given by default.
constexpr double ConstantReach = 6.0;
/// Direct neighbours that the reach is to include.
constexpr std::size_t LeastNeighbors = 6;
constexpr std::size_t NearNeighbors = 33;

/// How many of the nearest points are a group on their own, far off the next ones; 0 when none are.
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

Status CheckSetup(std::size_t bytes, const CloudGraphOptions& options)
{
  return options.MemoryLimit > 0
    ? CheckMemory("what has to be known of the points of the cloud", static_cast<double>(bytes),
        static_cast<double>(options.MemoryLimit), "use fewer points")
    : Status::Success();
}

/// Steps of the setup, one after the other.
class SetupBuilder
{
public:
  SetupBuilder(const CloudGraphOptions& options, const ProgressCallback& progress,
    CloudSetup& setup, CloudGraphStatistics& statistics)
    : Options(options)
    , Progress(progress)
    , Setup(setup)
    , Pairs(setup.Pairs)
    , Statistics(statistics)
  {
  }

  Status Run(const double* normals)
  {
    const std::size_t n = this->Pairs.Points.size();
    this->Pairs.IsSmooth.assign(n, 0);
    this->Pairs.UsesArcs = this->Options.ArcLengthWeights;
    this->Setup.Neighbors = std::make_unique<CloudNeighbors>(this->Pairs.Points);
    if (this->Progress && !this->Progress(0.0))
    {
      return Status::Abort();
    }
    const NodeLoop loop = [this](double share, const std::function<void(Id, Id)>& body) {
      this->ForNodes(share, body);
      return !this->IsStopped;
    };
    CloudNoise noise;
    if (!FitSurfaces(this->Setup, ShareOfFits, loop, this->Fits) ||
      !RemoveNoise(this->Setup, ShareOfNoise, loop, this->Fits, noise))
    {
      return Status::Abort();
    }
    this->Done = ShareOfFits + ShareOfNoise; // whether there was noise or not
    this->Statistics.Noise = noise.Removed / this->Setup.Nodes.Scale;
    this->Statistics.OffSurface = noise.OffSurface;
    this->Statistics.Scatter = noise.Scatter;
    this->SmoothSpacings();
    if (this->IsStopped)
    {
      return Status::Abort();
    }
    if (normals)
    {
      this->TakeNormals(normals);
    }
    Status status = this->BuildBand();
    if (!status.IsOk())
    {
      return status;
    }
    this->FindNearest();
    this->Pairs.FindNearestPoint = [&neighbors = *this->Setup.Neighbors](const Point3& place) {
      thread_local std::vector<CloudNeighbor> found;
      neighbors.FindNearest(place, 1, found);
      return found[0].Point;
    };
    this->Pairs.Reaches.assign(n, 0.0f);
    this->ChooseReaches();
    return this->IsStopped ? Status::Abort() : status;
  }

private:
  /// Run a loop that takes a share of all steps, in pieces between which progress is told. Nothing
  /// runs any more once the caller has asked to stop.
  void ForPieces(
    Offset size, Offset grain, double share, const std::function<void(Offset, Offset)>& body)
  {
    const Offset piece = PiecesPerReport * grain;
    for (Offset first = 0; first < size && !this->IsStopped; first += piece)
    {
      const Offset count = std::min(piece, size - first);
      ForRange(this->Options.Parallel, count, grain,
        [&](Offset begin, Offset end) { body(first + begin, first + end); });
      const double part = static_cast<double>(first + count) / static_cast<double>(size);
      this->IsStopped = this->Progress && !this->Progress(std::min(1.0, this->Done + share * part));
    }
    this->Done += share;
  }

  void ForNodes(double share, const std::function<void(Id, Id)>& body)
  {
    this->ForPieces(static_cast<Offset>(this->Pairs.Points.size()), NodesPerTask, share,
      [&](Offset begin, Offset end) { body(static_cast<Id>(begin), static_cast<Id>(end)); });
  }

  template <typename Body>
  void ForEachNode(double share, Body&& body)
  {
    this->ForNodes(share, [&](Id begin, Id end) {
      std::vector<CloudNeighbor> neighbors;
      for (Id node = begin; node < end; ++node)
      {
        body(node, neighbors);
      }
    });
  }

  /// Values that single points far off cannot spoil.
  void SmoothSpacings()
  {
    std::vector<float> spacings(this->Pairs.Spacings.size());
    std::vector<float> curvatures(spacings.size());
    this->ForEachNode(0.2, [&](Id node, std::vector<CloudNeighbor>& neighbors) {
      this->Setup.Neighbors->FindNearest(this->Pairs.Points[node], SpacingNeighbors + 1, neighbors);
      std::vector<float> around;
      for (const CloudNeighbor& neighbor : neighbors)
      {
        around.push_back(this->Pairs.Spacings[neighbor.Point]);
      }
      around.erase(
        around.begin(), around.begin() + static_cast<std::ptrdiff_t>(CountBeforeGap(neighbors)));
      spacings[node] = std::min(this->Pairs.Spacings[node],
        static_cast<float>(LargestSpacingRatio) * Quantile(around, 0.5));
      around.clear();
      for (const CloudNeighbor& neighbor : neighbors)
      {
        around.push_back(this->Fits.Curvatures[neighbor.Point]);
      }
      curvatures[node] = Quantile(around, 0.5);
    });
    this->Pairs.Spacings.swap(spacings);
    this->Fits.Curvatures.swap(curvatures);
    spacings = this->Pairs.Spacings;
    this->MedianSpacing = Quantile(spacings, 0.5);
    this->Statistics.Spacing = this->MedianSpacing / this->Setup.Nodes.Scale;
  }

  void TakeNormals(const double* normals)
  {
    const std::size_t oriented = this->Options.HasOrientedNormals ? this->Pairs.Points.size() : 0;
    this->Pairs.IsOriented.assign(oriented, 0);
    for (std::size_t i = 0; i < this->Pairs.Points.size(); ++i)
    {
      const double* n = normals + 3 * static_cast<std::size_t>(this->Setup.Nodes.Originals[i]);
      const double largest = std::max({ std::abs(n[0]), std::abs(n[1]), std::abs(n[2]) });
      if (largest > 0.0 && std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]))
      {
        const Point3 normal{ n[0] / largest, n[1] / largest, n[2] / largest };
        this->Pairs.Normals[i] = (1.0 / Norm(normal)) * normal;
        if (this->Options.HasOrientedNormals)
        {
          this->Pairs.IsOriented[i] = 1; // fitted ones point to either side
        }
      }
    }
  }

  /// Small enough for the balls of the densest points, and no smaller than the others allow. Radii
  /// are spacings times a factor.
  double ChooseVoxelSize(double factor) const
  {
    std::vector<float> spacings = this->Pairs.Spacings;
    const double dense = Quantile(spacings, SpacingQuantile);
    double sum = 0.0;
    for (const double radius : this->Pairs.Radii)
    {
      sum += radius * radius * radius;
    }
    const double meanVolume = 4.0 / 3.0 * Pi * sum / static_cast<double>(spacings.size());
    return std::clamp(
      std::cbrt(meanVolume / VoxelsPerBall), dense / VoxelsPerSpacing, factor * dense);
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
    std::ostringstream text;
    text << "parts of the cloud are too far apart for " << limit << ": its points are "
         << toPoints * this->MedianSpacing << " from each other, but point "
         << this->Setup.Nodes.Originals[farthest] << " is " << toPoints * values[farthest]
         << " from the middle. Leave out points that are wrong, or build one graph for each part";
    return Status::Invalid(text.str());
  }

  /// What helps when there are too many voxels.
  std::string RemedyOfBand() const
  {
    const std::string below =
      " below " + std::to_string(std::min(this->Statistics.Resolution, LargestResolution));
    return this->Options.Resolution > 0 ? "use a Resolution" + below
                                        : "set a Resolution" + below + ", that of now";
  }

  Status RefuseBand(double voxelSize) const
  {
    BandInNumbers numbers;
    numbers.Resolution = this->Statistics.Resolution;
    numbers.IsAutomatic = this->Options.Resolution <= 0;
    numbers.VoxelSize = this->Statistics.VoxelSize;
    numbers.Spacing = this->Statistics.Spacing;
    numbers.Used = static_cast<double>(this->Setup.GetMemorySize());
    numbers.Needed = PredictBandMemory(this->Pairs.Spacings, this->Pairs.Radii, voxelSize);
    numbers.MemoryLimit = static_cast<double>(this->Options.MemoryLimit);
    return dgg::RefuseBand(numbers);
  }

  Status BuildBand()
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
    double size = 0.0;
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
      size = h > 0.0 ? size : std::max(size, FindLeastVoxelSize(radii));
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
    std::size_t limit = 0;
    if (this->Options.MemoryLimit > 0)
    {
      const std::size_t used = this->Setup.GetMemorySize();
      const Status status = CheckSetup(used + 1, this->Options); // and something for the band
      if (!status.IsOk())
      {
        return status;
      }
      limit =
        std::max<std::size_t>(1, GetShareOfBricks(this->Options.MemoryLimit - used)); // 0: none
    }
    const auto progress = [this](double part) {
      this->IsStopped =
        this->Progress && !this->Progress(std::min(1.0, this->Done + ShareOfBand * part));
      return !this->IsStopped;
    };
    Status status = this->Pairs.Band.Build(this->Pairs.Points, radii, size, limit,
      this->Options.Parallel, progress, this->RemedyOfBand());
    if (this->Pairs.Band.IsTooLarge())
    {
      status = this->RefuseBand(size);
    }
    this->Done += ShareOfBand;
    this->Statistics.BandMemory = this->Pairs.Band.GetMemorySize();
    return status;
  }

  void ChooseReaches()
  {
    const double size = this->Pairs.Band.GetVoxelSize();
    const double h = this->Statistics.OffsetInVoxels;
    double alpha = this->Options.Alpha;
    const bool isAutomatic = !(alpha > 0.0);
    switch (this->Options.Scheme)
    {
      case CloudScheme::Curvature:
        alpha = isAutomatic ? 1.0 : alpha;
        break;
      case CloudScheme::Constant:
        alpha = isAutomatic ? std::max(h, ConstantReach * this->MedianSpacing / size - h) : alpha;
        break;
      case CloudScheme::Spacing:
        alpha = isAutomatic ? ReachBySpacing : alpha;
        break;
    }
    this->Statistics.Alpha = alpha;
    std::vector<float>& reaches = this->Pairs.Reaches;
    this->ForEachNode(0.2, [&](Id node, std::vector<CloudNeighbor>& neighbors) {
      const double s = this->Pairs.Spacings[node];
      double reach = 0.0;
      switch (this->Options.Scheme)
      {
        case CloudScheme::Curvature:
          reach = this->MeanDirectLength(node, neighbors) / alpha;
          break;
        case CloudScheme::Constant:
          reach = size * (h + alpha);
          break;
        case CloudScheme::Spacing:
          reach = isAutomatic ? this->AutomaticReach(node) : alpha * s;
          break;
      }
      if (reach < LeastReach * s)
      {
        reach = std::max(reach, this->ReachOfFew(node, neighbors));
      }
      reaches[node] = static_cast<float>(reach);
    });
    std::vector<float> sorted = reaches;
    this->Statistics.Reach = Quantile(sorted, 0.5) / this->Setup.Nodes.Scale;
  }

  /// The nearest point of every marked voxel.
  void FindNearest()
  {
    const VoxelBand& band = this->Pairs.Band;
    const std::size_t bricks = band.GetNumberOfBricks();
    this->Pairs.Nearest.assign(512 * bricks, NoId);
    this->ForPieces(static_cast<Offset>(bricks), BricksPerTask, 0.2, [&](Offset begin, Offset end) {
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

  double AutomaticReach(Id node) const
  {
    const double s = this->Pairs.Spacings[node];
    const double curvature = this->Fits.Curvatures[node];
    if (this->Options.ArcLengthWeights)
    {
      if (!this->Pairs.IsSmooth[node])
      {
        return RoughReachBySpacing * s; // the curvature is not that of a surface
      }
      return std::max(LeastReach * s,
        curvature > 0.0 ? std::min(ReachBySpacing * s, TurnOfReach / curvature)
                        : ReachBySpacing * s);
    }
    const double balanced =
      curvature > 0.0 ? BalancedReach * std::cbrt(s * s / curvature) : MostReach * s;
    return std::clamp(balanced, LeastReach * s, MostReach * s);
  }

  bool IsDirect(Id p, Id q, double chord) const
  {
    return this->Pairs.Length(p, q, chord) < Infinity && this->Pairs.IsDirect(p, q, chord);
  }

  /// Of pairs in overlapping balls.
  double MeanDirectLength(Id node, std::vector<CloudNeighbor>& neighbors) const
  {
    this->Setup.Neighbors->FindWithin(
      this->Pairs.Points[node], 2.0 * this->Pairs.Radii[node], neighbors);
    double sum = 0.0;
    std::size_t count = 0;
    for (const CloudNeighbor& neighbor : neighbors)
    {
      const double chord = std::sqrt(neighbor.SquaredDistance);
      if (neighbor.Point != node && this->IsDirect(node, neighbor.Point, chord))
      {
        sum += chord;
        ++count;
      }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  }

  /// Reach that includes the nearest direct neighbours.
  double ReachOfFew(Id node, std::vector<CloudNeighbor>& neighbors) const
  {
    this->Setup.Neighbors->FindNearest(this->Pairs.Points[node], NearNeighbors, neighbors);
    double reach = 0.0;
    std::size_t count = 0;
    for (const CloudNeighbor& neighbor : neighbors)
    {
      const double chord = std::sqrt(neighbor.SquaredDistance);
      if (neighbor.Point != node && this->IsDirect(node, neighbor.Point, chord))
      {
        // A hair more, as reaches are floats.
        reach = chord * (1.0 + 1e-6);
        if (++count == LeastNeighbors)
        {
          break;
        }
      }
    }
    return reach;
  }

  const CloudGraphOptions& Options;
  const ProgressCallback& Progress;
  CloudSetup& Setup;
  CloudPairs& Pairs;
  CloudGraphStatistics& Statistics;
  CloudFits Fits;
  double MedianSpacing = 0.0;
  double Done = 0.0;      ///< of all steps
  bool IsStopped = false; ///< by the caller
};
}

std::size_t CloudSetup::PredictMemory(std::size_t nodes)
{
  // Points, normals and what is fitted (with copies while it is smoothed), and the tree.
  return nodes * (3 * sizeof(Point3) + 2 * sizeof(double) + 8 * sizeof(float) + sizeof(Id) + 2) +
    CloudNeighbors::PredictMemory(nodes);
}

std::size_t CloudSetup::GetMemorySize() const
{
  return this->NormalsMemory + PredictMemory(this->Pairs.Points.size()) +
    this->Nodes.Coincident.capacity() * sizeof(this->Nodes.Coincident[0]) +
    this->Pairs.Band.GetMemorySize() + this->Pairs.Nearest.capacity() * sizeof(Id);
}

Status SetUpCloud(const double* points, Id numberOfPoints, const CloudGraphOptions& options,
  const ProgressCallback& progress, CloudSetup& setup, CloudGraphStatistics& statistics)
{
  setup.NormalsMemory =
    options.Normals ? static_cast<std::size_t>(numberOfPoints) * sizeof(Point3) : 0;
  Status status =
    CheckSetup(setup.NormalsMemory + CloudNodes::PredictMemory(numberOfPoints), options);
  if (!status.IsOk())
  {
    return status;
  }
  status = FindNodes(points, numberOfPoints, setup.Nodes, setup.Pairs.Points);
  statistics.UnusedPoints = setup.Nodes.Unused;
  statistics.StrayPoints = setup.Nodes.NumberOfStray;
  statistics.CoincidentPoints = static_cast<Id>(setup.Nodes.Coincident.size());
  if (!status.IsOk() || setup.Pairs.Points.empty())
  {
    return status;
  }
  status = CheckSetup(setup.GetMemorySize(), options);
  if (!status.IsOk())
  {
    return status;
  }
  if (progress && !progress(0.0))
  {
    return Status::Abort();
  }
  SetupBuilder builder(options, progress, setup, statistics);
  return builder.Run(options.Normals);
}
}
