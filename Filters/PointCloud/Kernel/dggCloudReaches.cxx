// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudSetup.h"
#include "dggQuantile.h"
#include "dggSetupLoop.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Progress weight within the setup.
constexpr double ShareOfReaches = 0.2;

/// Ratio of reach to spacing, scheme C.
constexpr double ReachBySpacing = 10.5;
/// Ratio of reach to spacing, scheme C, where paths follow points: errors between the points
/// accumulate.
constexpr double RoughReachBySpacing = 5.5;
/// For chord lengths, the ratio of the reach to (s^2 / curvature)^(1/3), with the spacing s, at
/// which zigzag and shortcut errors balance; and limits for the ratio of reach to spacing.
constexpr double BalancedReach = 1.67;
constexpr double LeastReach = 3.5;
constexpr double MostReach = 16.0;
/// Maximum turning angle of the surface along an edge, in radians. Beyond it, arc lengths are
/// unreliable.
constexpr double TurnOfReach = 0.8;
/// Default ratio of reach to median spacing, scheme B.
constexpr double ConstantReach = 6.0;
/// Minimum number of direct neighbors within reach, and number of nearest nodes that are searched
/// for them.
constexpr std::size_t LeastNeighbors = 6;
constexpr std::size_t NearNeighbors = 33;

/// Chooses the reach of each node by the scheme.
class ReachChooser
{
public:
  ReachChooser(const CloudGraphOptions& options, double medianSpacing,
    const std::vector<float>& curvatures, SetupLoop& loop, CloudSetup& setup,
    CloudGraphStatistics& statistics)
    : Options(options)
    , MedianSpacing(medianSpacing)
    , Curvatures(curvatures)
    , Loop(loop)
    , Setup(setup)
    , Pairs(setup.Pairs)
    , Statistics(statistics)
  {
  }

  void Choose()
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
    const std::size_t n = this->Pairs.Points.size();
    reaches.assign(n, 0.0f);
    this->Loop.ForNodes(n, ShareOfReaches, [&](Id begin, Id end) {
      std::vector<CloudNeighbor> neighbors;
      for (Id node = begin; node < end; ++node)
      {
        reaches[node] = static_cast<float>(this->ReachOf(node, alpha, neighbors));
      }
    });
    std::vector<float> sorted = reaches;
    this->Statistics.Reach = Quantile(sorted, 0.5) / this->Setup.Nodes.Scale;
  }

private:
  double ReachOf(Id node, double alpha, std::vector<CloudNeighbor>& neighbors) const
  {
    const double s = this->Pairs.Spacings[node];
    double reach = 0.0;
    switch (this->Options.Scheme)
    {
      case CloudScheme::Curvature:
        reach = this->MeanDirectLength(node, neighbors) / alpha;
        break;
      case CloudScheme::Constant:
        reach = this->Pairs.Band.GetVoxelSize() * (this->Statistics.OffsetInVoxels + alpha);
        break;
      case CloudScheme::Spacing:
        reach = this->Options.Alpha > 0.0 ? alpha * s : this->AutomaticReach(node);
        break;
    }
    return reach < LeastReach * s ? std::max(reach, this->ReachOfFew(node, neighbors)) : reach;
  }

  double AutomaticReach(Id node) const
  {
    const double s = this->Pairs.Spacings[node];
    const double curvature = this->Curvatures[node];
    if (this->Options.ArcLengthWeights)
    {
      if (!this->Pairs.IsSmooth[node])
      {
        return RoughReachBySpacing * s; // without a smooth surface, the curvature is unreliable
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

  /// Returns the mean length of the direct pairs of a node in overlapping balls; 0 if there are
  /// none.
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

  /// Returns the reach that includes the nearest LeastNeighbors direct neighbors, or as many of
  /// them as there are among the NearNeighbors nearest nodes.
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
        // Slightly larger, because reaches are stored as float.
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
  double MedianSpacing;
  const std::vector<float>& Curvatures;
  SetupLoop& Loop;
  CloudSetup& Setup;
  CloudPairs& Pairs;
  CloudGraphStatistics& Statistics;
};
}

void ChooseReaches(const CloudGraphOptions& options, double medianSpacing,
  const std::vector<float>& curvatures, SetupLoop& loop, CloudSetup& setup,
  CloudGraphStatistics& statistics)
{
  ReachChooser(options, medianSpacing, curvatures, loop, setup, statistics).Choose();
}
}
