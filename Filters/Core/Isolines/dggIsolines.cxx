// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggIsolines.h"

#include "dggApolloniusParts.h"
#include "dggBlockLoop.h"
#include "dggFaceIsolines.h"
#include "dggIsolineChains.h"
#include "dggLevelCrossings.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <string>

namespace dgg
{
namespace
{
constexpr Offset FacesInBlock = 512;
constexpr double DefaultTolerance = 1e-3; // in mean edge lengths
/// Shares of the progress.
constexpr double CrossingsDone = 0.3;
constexpr double FacesDone = 0.9;

Status CheckArguments(
  const DistanceField& field, const std::vector<double>& levels, const IsolineOptions& options)
{
  if (!field.Mesh || !field.Distances)
  {
    return Status::Invalid("there is no distance: set Mesh and Distances of the field");
  }
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    if (!std::isfinite(levels[i]))
    {
      return Status::Invalid(
        "value " + std::to_string(i) + " of the isolines is not finite: give a number");
    }
  }
  if (!(options.ChordTolerance >= 0.0))
  {
    return Status::Invalid("the chord tolerance is " + std::to_string(options.ChordTolerance) +
      ": it must not be negative");
  }
  return CheckCorners(*field.Mesh);
}

/// The pieces of a block of faces.
struct Block
{
  std::vector<FaceCurve> Curves;
  Id Fallbacks = 0;
};

Status FindFaceCurves(const DistanceField& field, const std::vector<double>& levels,
  double tolerance, const LevelCrossings& crossings, const ParallelFor& parallel,
  const ProgressCallback& progress, std::vector<FaceCurve>& curves, Id& fallbacks)
{
  const Offset faces = field.Mesh->GetNumberOfFaces();
  std::vector<Block> blocks((faces + FacesInBlock - 1) / FacesInBlock);
  Status status = ForBlocks(
    faces, FacesInBlock, parallel, ProgressPart(progress, CrossingsDone, FacesDone),
    [&] { return FaceIsolines(field, levels, tolerance, crossings); },
    [&](FaceIsolines& isolines, Offset block, Offset begin, Offset end) {
      const Id before = isolines.GetNumberOfFallbacks();
      for (Id f = static_cast<Id>(begin); f < static_cast<Id>(end); ++f)
      {
        if (field.IsReached(f))
        {
          isolines.Trace(f, blocks[block].Curves);
        }
      }
      blocks[block].Fallbacks = isolines.GetNumberOfFallbacks() - before;
    });
  if (status.IsOk())
  {
    for (Block& block : blocks)
    {
      std::move(block.Curves.begin(), block.Curves.end(), std::back_inserter(curves));
      fallbacks += block.Fallbacks;
    }
  }
  return status;
}
}

Status TraceIsolines(const DistanceField& field, const std::vector<double>& levels,
  const IsolineOptions& options, const ParallelFor& parallel, const ProgressCallback& progress,
  Isolines& lines)
{
  lines = Isolines();
  Status status = CheckArguments(field, levels, options);
  if (!status.IsOk())
  {
    return status;
  }
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
  if (options.Method == IsolineMethod::Apollonius)
  {
    status = FindApolloniusParts(field, options.SteinerPoints, sorted, parallel,
      ProgressPart(progress, 0.0, FacesDone), crossings.Crossings, curves);
  }
  else
  {
    status = FindLevelCrossings(
      field, sorted, parallel, ProgressPart(progress, 0.0, CrossingsDone), crossings);
    if (status.IsOk())
    {
      status =
        FindFaceCurves(field, sorted, tolerance, crossings, parallel, progress, curves, fallbacks);
    }
  }
  if (!status.IsOk())
  {
    return status;
  }
  status = JoinFaceCurves(
    *field.Mesh, crossings.Crossings, curves, ProgressPart(progress, FacesDone, 1.0), lines);
  if (!status.IsOk())
  {
    return status;
  }
  for (Id& level : lines.Levels)
  {
    level = order[level];
  }
  lines.Fallbacks = fallbacks;
  if (progress && !progress(1.0))
  {
    lines = Isolines();
    return Status::Abort();
  }
  return status;
}
}
