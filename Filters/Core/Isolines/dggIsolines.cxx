// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggIsolines.h"

#include "dggApolloniusParts.h"
#include "dggEdgeEnvelope.h"
#include "dggFaceIsolines.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace dgg
{
namespace
{
constexpr Offset HalfEdgesInBlock = 1024;
constexpr Offset FacesInBlock = 512;
constexpr double DefaultTolerance = 1e-3; // in mean edge lengths
/// Progress after each step.
constexpr double CrossingsDone = 0.3;
constexpr double FacesDone = 0.9;

/// State that is reused between edges.
struct EdgeWorker
{
  EdgeEnvelope Envelope;
  std::vector<double> Roots;
};

/// Appends the crossings of one edge, level by level.
void CrossEdge(const DistanceField& field, const std::vector<double>& levels, Id h,
  EdgeWorker& worker, std::vector<LevelCrossing>& crossings)
{
  const SurfaceMesh& mesh = *field.Mesh;
  const double a = field.Distances[mesh.Origin(h)];
  const double b = field.Distances[mesh.Destination(h)];
  // Bounds of a function with slopes of at most 1, up to rounding. A field may be steeper.
  const double length = (1.0 + 1e-9) * mesh.Length(h);
  const bool isLinear = !field.HasWindows() && !field.HasSources();
  const double lowest = isLinear ? std::min(a, b) : std::min({ a, b, 0.5 * (a + b - length) });
  const double highest = isLinear ? std::max(a, b) : std::max({ a, b, 0.5 * (a + b + length) });
  auto level = std::lower_bound(levels.begin(), levels.end(), lowest);
  if (level == levels.end() || *level > highest || !IsEdgeTraced(field, h))
  {
    return;
  }
  worker.Envelope.Enter(h);
  for (; level != levels.end() && *level <= highest; ++level)
  {
    worker.Roots.clear();
    worker.Envelope.FindCrossings(*level, worker.Roots);
    for (const double x : worker.Roots)
    {
      crossings.push_back({ h, static_cast<Id>(level - levels.begin()), 0, x });
    }
  }
}

/// Finds the crossings and curves of LocalSources.
Status FindLocalParts(const DistanceField& field, const std::vector<double>& levels,
  double tolerance, const ParallelFor& parallel, const ProgressCallback& progress,
  LevelCrossings& crossings, std::vector<FaceCurve>& curves, Id& fallbacks)
{
  DGG_RETURN_IF_ERROR(CollectCrossings(
    *field.Mesh, HalfEdgesInBlock, parallel, progress, 0.0, CrossingsDone,
    [&] {
      return EdgeWorker{ EdgeEnvelope(field), {} };
    },
    [&](EdgeWorker& worker, Id h, std::vector<LevelCrossing>& found) {
      CrossEdge(field, levels, h, worker, found);
    },
    crossings));
  std::atomic<Id> count{ 0 };
  DGG_RETURN_IF_ERROR(CollectPieces(
    field.Mesh->GetNumberOfFaces(), FacesInBlock, parallel, progress, CrossingsDone, FacesDone,
    [&] { return FaceIsolines(field, levels, tolerance, crossings); },
    [&](FaceIsolines& isolines, Id f, std::vector<FaceCurve>& found) {
      if (field.IsTraced(f))
      {
        count += isolines.Trace(f, found);
      }
    },
    curves));
  fallbacks = count;
  return Status::Success();
}
}

Status TraceIsolines(const DistanceField& field, const std::vector<double>& levels,
  const IsolineOptions& options, const ParallelFor& parallel, const ProgressCallback& progress,
  Isolines& lines)
{
  lines = Isolines();
  DGG_RETURN_IF_ERROR(CheckCorners(*field.Mesh));
  std::vector<Id> order(levels.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Id a, Id b) { return levels[a] < levels[b]; });
  std::vector<double> sorted;
  sorted.reserve(levels.size());
  for (const Id level : order)
  {
    sorted.push_back(levels[level]);
  }
  const double tolerance = options.ChordTolerance > 0.0
    ? options.ChordTolerance
    : DefaultTolerance * field.Mesh->GetMeanEdgeLength();

  LevelCrossings crossings;
  std::vector<FaceCurve> curves;
  Id fallbacks = 0;
  DGG_RETURN_IF_ERROR(options.Method == IsolineMethod::Apollonius
      ? FindApolloniusParts(field, options.SteinerPoints, sorted, parallel,
          ProgressPart(progress, 0.0, FacesDone), crossings, curves)
      : FindLocalParts(field, sorted, tolerance, parallel, progress, crossings, curves, fallbacks));
  DGG_RETURN_IF_ERROR(JoinFaceCurves(
    *field.Mesh, crossings.Crossings, curves, ProgressPart(progress, FacesDone, 1.0), lines));
  for (Id& level : lines.Levels)
  {
    level = order[level];
  }
  lines.Fallbacks = fallbacks;
  return ReportTo(progress, 1.0);
}
}
