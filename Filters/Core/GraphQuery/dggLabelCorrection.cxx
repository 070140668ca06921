// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLabelCorrection.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
// Constants fitted to exact distances on scans. The direction to a virtual source has an error if
// the intermediate surface is not flat, because this part of the surface is not visited. By
// regression to the mean, a large deviation from the straight line is on average overestimated, and
// a small deviation underestimated. Without the constants, estimates are too short on rough
// surfaces, with mean errors larger by up to a quarter and maximum errors by up to a half; on
// smooth surfaces the constants increase errors by up to a quarter.

/// Mean angle defect of the ends of an edge, radians, from which on the surface counts as rough.
constexpr double RoughDefect = 0.04;
/// Spurious fraction of a deviation on a rough surface.
constexpr double SpuriousPart = 0.06;
/// Mean square of unobserved deviations, in units of the largest deviation of an edge.
constexpr double UnseenPart = 0.01;

/// Rounding error of angles stored as floats, radians. Along the boundary, angles end exactly at
/// its directions.
constexpr double AngleSlack = 1e-5;
}

LabelCorrection::LabelCorrection(const GraphView& graph, const SurfaceMesh& mesh)
  : LabelCorrection(
      graph, MeasureVertexAngles(mesh), LargestDeviation(graph), mesh.GetMeanEdgeLength())
{
}

LabelCorrection::LabelCorrection(const GraphView& graph, std::vector<VertexAngle> angles,
  double largestDeviation, double meanEdgeLength)
  : Graph(graph)
  , Angles(std::move(angles))
  , Shrink(LabelShrink(graph.Info))
  , Unseen(0.5 * UnseenPart * std::pow(largestDeviation, 2.0))
  , Scale(meanEdgeLength > 0.0 ? std::exp2(-std::rint(std::log2(meanEdgeLength))) : 1.0)
{
}

double LabelCorrection::OffsetOf(const GraphSeed& seed)
{
  return seed.ArrivalAngle < 0.0 ? seed.Distance : seed.InitialDistance;
}

LabelCorrection::Estimate LabelCorrection::EstimateOf(const GraphSeed& seed)
{
  const double offset = OffsetOf(seed);
  return { { offset, seed.Distance - offset, std::max(0.0, seed.ArrivalAngle) }, seed.Distance };
}

LabelCorrection::Estimate LabelCorrection::Extend(
  const TreeStep& step, double label, const Estimate& tail, double smallestOffset) const
{
  Estimate estimate = this->Follow(step, this->Graph.Length(step.Edge), tail);
  estimate.Distance = ClampToLabel(estimate.Distance, label, smallestOffset, this->Shrink);
  return estimate;
}

double LabelCorrection::FindSmallestOffset(const std::vector<GraphSeed>& seeds)
{
  double smallestOffset = Infinity;
  for (const GraphSeed& seed : seeds)
  {
    smallestOffset = std::min(smallestOffset, OffsetOf(seed));
  }
  return smallestOffset;
}

void LabelCorrection::Run(const std::vector<GraphSeed>& seeds, const std::vector<TreeStep>& steps,
  SearchResult& result) const
{
  WithLengths(
    this->Graph, [&](const auto* lengths) { this->Straighten(lengths, seeds, steps, result); });
}

template <typename Length>
void LabelCorrection::Straighten(const Length* lengths, const std::vector<GraphSeed>& seeds,
  const std::vector<TreeStep>& steps, SearchResult& result) const
{
  const double smallestOffset = FindSmallestOffset(seeds);
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const TreeStep& ahead = steps[std::min(i + Lookahead, steps.size() - 1)];
    if (ahead.Tail != NoId)
    {
      this->PrefetchStep(ahead);
      Prefetch(&result.Virtual[ahead.Tail]);
      Prefetch(&result.Virtual[ahead.Vertex]);
      Prefetch(&result.Corrected[ahead.Tail]);
      Prefetch(&result.Corrected[ahead.Vertex]);
      Prefetch(&result.Distances[ahead.Vertex]);
    }
    const TreeStep& step = steps[i];
    Estimate estimate;
    if (step.Tail == NoId)
    {
      estimate = EstimateOf(seeds[result.Seeds[step.Vertex]]);
    }
    else
    {
      estimate = this->Follow(
        step, lengths[step.Edge], { result.Virtual[step.Tail], result.Corrected[step.Tail] });
      estimate.Distance = ClampToLabel(
        estimate.Distance, result.Distances[step.Vertex], smallestOffset, this->Shrink);
    }
    result.Virtual[step.Vertex] = estimate.Source;
    result.Corrected[step.Vertex] = estimate.Distance;
  }
}

/// Transfers an estimate along an edge, from the tail to the vertex, and returns it.
LabelCorrection::Estimate LabelCorrection::Follow(
  const TreeStep& step, double edge, const Estimate& from) const
{
  const VirtualSource& source = from.Source;
  const VertexAngle& vertex = this->Angles[step.Vertex];
  const VertexAngle& tail = this->Angles[step.Tail];
  const double arrival = this->Graph.ArrivalAngles[step.Edge];
  double turn = this->Graph.Angles[step.Edge] - source.Angle;
  if (tail.Total > 0.0f)
  {
    turn -= tail.Total * std::rint(turn / tail.Total); // the smaller side
  }
  const Estimate restarted{ { from.Distance, edge, arrival }, from.Distance + edge };
  const bool bends = std::abs(turn) >= Pi + AngleSlack;
  if (bends || !(source.Length > 0.0) || tail.Total == 0.0f)
  {
    return restarted;
  }
  // The triangle of virtual source, tail and vertex is nearly degenerate: its angle at the tail is
  // pi minus the deviation. The formula avoids cancellation for small deviations. Single precision
  // suffices, since the angles of the graph are floats.
  const double roughness = std::min(1.0, (tail.Defect + vertex.Defect) / (2.0 * RoughDefect));
  const double deviation = (1.0 - roughness * SpuriousPart) * std::max(0.0, Pi - std::abs(turn));
  const double half = std::sin(static_cast<float>(0.5 * deviation));
  const double sum = source.Length + edge;
  const double height = source.Length * edge / sum;
  const double flatness = 4.0 * height * half * half / sum;
  const double gain = sum * flatness / (1.0 + std::sqrt(std::max(0.0, 1.0 - flatness))) +
    roughness * this->Unseen * height;
  const double x = edge + source.Length * (1.0 - 2.0 * half * half);
  const double y = 2.0 * source.Length * half * std::sqrt(std::max(0.0, 1.0 - half * half));
  const double tilt =
    std::atan2(static_cast<float>(this->Scale * y), static_cast<float>(this->Scale * x));
  const double angle = arrival + (turn > 0.0 ? tilt : -tilt);
  if (vertex.Total < 0.0f && !(angle >= -AngleSlack && angle <= AngleSlack - vertex.Total))
  {
    return restarted; // the straight line leaves the surface
  }
  const double length = std::max(0.0, sum - gain);
  return { { source.Offset, length, angle }, source.Offset + length };
}
}
