// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggApolloniusFace.h"
#include "dggProgressPart.h"
#include "dggSourceFinding.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Edges or faces per task.
constexpr Offset BlockSize = 64;
/// Progress after the fit and after the edges.
constexpr double FitDone = 0.1;
constexpr double EdgesDone = 0.2;
/// Maximum distance of a point of a triangle from its nearest corner, relative to the longest side.
constexpr double FarthestFromCorners = 0.58;

/// Returns the first level that is not below a value.
Id FirstFrom(const std::vector<double>& levels, double value)
{
  return static_cast<Id>(std::lower_bound(levels.begin(), levels.end(), value) - levels.begin());
}

void CrossEdge(
  const HermiteEdge& edge, const std::vector<double>& levels, std::vector<LevelCrossing>& found)
{
  const std::vector<RimNode>& nodes = edge.GetNodes();
  const auto range = std::minmax_element(nodes.begin(), nodes.end(),
    [](const RimNode& a, const RimNode& b) { return a.Value < b.Value; });
  const auto count = static_cast<Id>(levels.size());
  for (Id r = FirstFrom(levels, range.first->Value); r < count && levels[r] <= range.second->Value;
       ++r)
  {
    const double level = levels[r];
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      const RimNode& a = nodes[i];
      const RimNode& b = nodes[i + 1];
      if ((a.Value < level) != (b.Value < level))
      {
        const double t = (level - a.Value) / (b.Value - a.Value);
        const double x = std::min(b.X, std::max(a.X, (1.0 - t) * a.X + t * b.X));
        found.push_back({ edge.GetHalfEdge(), r, static_cast<Id>(i), x });
      }
    }
  }
}

/// Returns the index of the crossing of a level between two neighboring nodes of an edge.
Id FindCrossing(const LevelCrossings& crossings, Id h, Id level, Id interval)
{
  const auto begin = crossings.Crossings.begin();
  const auto place = std::lower_bound(begin + crossings.Offsets[h],
    begin + crossings.Offsets[h + 1], level, [&](const LevelCrossing& c, Id r) {
      return c.Level != r ? c.Level < r : c.Interval < interval;
    });
  return static_cast<Id>(place - begin);
}

void CrossFace(ApolloniusFace& face, const DistanceField& field, Id f,
  const std::vector<double>& levels, const LevelCrossings& crossings,
  std::vector<FaceCurve>& curves)
{
  const SurfaceMesh& mesh = *field.Mesh;
  double low = Infinity;
  double high = -Infinity;
  double longest = 0.0;
  for (Id h = 3 * f; h < 3 * f + 3; ++h)
  {
    const double d = field.Distances[mesh.Origin(h)];
    low = std::min(low, d);
    high = std::max(high, d);
    longest = std::max(longest, mesh.Length(h));
  }
  // Range of a distance. A cubic may exceed the range by the same amount.
  const double reach = 2.0 * FarthestFromCorners * longest;
  const auto count = static_cast<Id>(levels.size());
  const Id first = FirstFrom(levels, low - reach);
  if (first == count || levels[first] > high + reach)
  {
    return;
  }
  face.Enter(f);
  for (Id r = FirstFrom(levels, face.GetSmallest()); r < count && levels[r] <= face.GetLargest();
       ++r)
  {
    face.FindCurves(
      levels[r], r, [&](Id h, Id interval) { return FindCrossing(crossings, h, r, interval); },
      curves);
  }
}
}

Status FindApolloniusParts(const DistanceField& field, int steinerPoints,
  const std::vector<double>& levels, const ParallelFor& parallel, const ProgressCallback& progress,
  LevelCrossings& crossings, std::vector<FaceCurve>& curves)
{
  DistanceField used = field;
  VirtualSources fitted;
  double begin = 0.0;
  if (!field.Sources || field.Sources->empty())
  {
    if (!FitVirtualSources(
          *field.Mesh, field.Distances, parallel, fitted, ProgressPart(progress, 0.0, FitDone)))
    {
      return Status::Abort();
    }
    used.Sources = &fitted;
    begin = FitDone;
  }
  DGG_RETURN_IF_ERROR(CollectCrossings(
    *field.Mesh, BlockSize, parallel, progress, begin, EdgesDone,
    [&] { return HermiteEdge(used, steinerPoints); },
    [&](HermiteEdge& edge, Id h, std::vector<LevelCrossing>& found) {
      if (IsEdgeReached(used, h))
      {
        edge.Enter(h);
        CrossEdge(edge, levels, found);
      }
    },
    crossings));
  return CollectPieces(
    field.Mesh->GetNumberOfFaces(), BlockSize, parallel, progress, EdgesDone, 1.0,
    [&] { return ApolloniusFace(used, steinerPoints); },
    [&](ApolloniusFace& face, Id f, std::vector<FaceCurve>& found) {
      if (used.IsReached(f))
      {
        CrossFace(face, used, f, levels, crossings, found);
      }
    },
    curves);
}
}
