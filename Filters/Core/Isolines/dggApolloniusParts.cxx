// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggApolloniusParts.h"

#include "dggApolloniusFace.h"
#include "dggBlockLoop.h"
#include "dggEdges.h"
#include "dggProgressPart.h"
#include "dggSourceFit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
/// Edges or faces that one thread does in a row.
constexpr Offset BlockSize = 64;
/// Where in the progress the fit and the edges are done.
constexpr double FitDone = 0.1;
constexpr double EdgesDone = 0.2;
/// No point of a triangle is farther from its corners than this part of the longest side.
constexpr double FarthestFromCorners = 0.58;

/// Levels in increasing order, and what numbers they have.
struct SortedLevels
{
  explicit SortedLevels(const std::vector<double>& levels)
    : Numbers(levels.size())
  {
    for (std::size_t i = 0; i < levels.size(); ++i)
    {
      this->Numbers[i] = static_cast<Id>(i);
    }
    std::stable_sort(this->Numbers.begin(), this->Numbers.end(),
      [&](Id a, Id b) { return levels[a] < levels[b]; });
    for (const Id number : this->Numbers)
    {
      this->Values.push_back(levels[number]);
    }
  }

  /// The first level that is at least as large.
  std::size_t FirstFrom(double value) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(this->Values.begin(), this->Values.end(), value) - this->Values.begin());
  }

  std::vector<Id> Numbers;
  std::vector<double> Values;
};

/// A crossing before it is numbered.
struct FoundCrossing
{
  LevelCrossing Crossing;
  std::size_t Rank;     // of the level
  std::size_t Interval; // between two nodes of the edge
};

/// All crossings, to be found again.
class CrossingTable
{
public:
  CrossingTable(const SurfaceMesh& mesh, std::vector<FoundCrossing> found)
    : Found(std::move(found))
    , First(static_cast<std::size_t>(mesh.GetNumberOfHalfEdges()) + 1, 0)
  {
    for (const FoundCrossing& c : this->Found)
    {
      ++this->First[static_cast<std::size_t>(c.Crossing.HalfEdge) + 1];
    }
    for (std::size_t h = 1; h < this->First.size(); ++h)
    {
      this->First[h] += this->First[h - 1];
    }
  }

  Id Find(Id halfEdge, std::size_t rank, std::size_t interval) const
  {
    const auto begin = this->Found.begin() + this->First[halfEdge];
    const auto end = this->Found.begin() + this->First[halfEdge + 1];
    const auto place =
      std::lower_bound(begin, end, rank, [&](const FoundCrossing& c, std::size_t r) {
        return c.Rank != r ? c.Rank < r : c.Interval < interval;
      });
    return static_cast<Id>(place - this->Found.begin());
  }

  void Take(std::vector<LevelCrossing>& crossings) const
  {
    crossings.clear();
    crossings.reserve(this->Found.size());
    for (const FoundCrossing& c : this->Found)
    {
      crossings.push_back(c.Crossing);
    }
  }

private:
  std::vector<FoundCrossing> Found;
  std::vector<Offset> First;
};

/// Runs `work(worker, index, pieces)` for all indices, in blocks, and joins the pieces in order.
template <typename Piece, typename MakeWorker, typename Work>
Status Collect(Offset size, const ParallelFor& parallel, const ProgressCallback& progress,
  double start, double stop, const MakeWorker& makeWorker, const Work& work,
  std::vector<Piece>& pieces)
{
  std::vector<std::vector<Piece>> blocks(
    static_cast<std::size_t>((size + BlockSize - 1) / BlockSize));
  Status status = ForBlocks(size, BlockSize, parallel, ProgressPart(progress, start, stop),
    makeWorker, [&](auto& worker, Offset block, Offset begin, Offset end) {
      for (Offset i = begin; i < end; ++i)
      {
        work(worker, static_cast<Id>(i), blocks[static_cast<std::size_t>(block)]);
      }
    });
  if (!status.IsOk())
  {
    return status;
  }
  std::size_t count = 0;
  for (const std::vector<Piece>& block : blocks)
  {
    count += block.size();
  }
  if (count > static_cast<std::size_t>(std::numeric_limits<Id>::max()))
  {
    return Status::Invalid(
      "there are more than 2^31 - 1 points where levels cross edges, or pieces "
      "of isolines: use fewer levels");
  }
  pieces.reserve(count);
  for (std::vector<Piece>& block : blocks)
  {
    pieces.insert(
      pieces.end(), std::make_move_iterator(block.begin()), std::make_move_iterator(block.end()));
    std::vector<Piece>().swap(block);
  }
  return status;
}

/// Whether the half-edge stands for an edge of a face that is reached.
bool IsEdgeAtWork(const DistanceField& field, Id h)
{
  const SurfaceMesh& mesh = *field.Mesh;
  if (mesh.IsDropped(SurfaceMesh::Face(h)) || FindEdge(mesh, h) != h)
  {
    return false;
  }
  bool isReached = field.IsReached(SurfaceMesh::Face(h));
  for (Id e = mesh.Twin(h); e != NoId && e != h; e = mesh.Twin(e))
  {
    isReached = isReached || field.IsReached(SurfaceMesh::Face(e));
  }
  return isReached;
}

void CrossEdge(
  const HermiteEdge& edge, const SortedLevels& levels, std::vector<FoundCrossing>& found)
{
  const std::vector<RimNode>& nodes = edge.GetNodes();
  const auto range = std::minmax_element(nodes.begin(), nodes.end(),
    [](const RimNode& a, const RimNode& b) { return a.Value < b.Value; });
  for (std::size_t r = levels.FirstFrom(range.first->Value);
       r < levels.Values.size() && levels.Values[r] <= range.second->Value; ++r)
  {
    const double level = levels.Values[r];
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      const RimNode& a = nodes[i];
      const RimNode& b = nodes[i + 1];
      if ((a.Value < level) != (b.Value < level))
      {
        const double t = (level - a.Value) / (b.Value - a.Value);
        const double x = std::min(b.X, std::max(a.X, (1.0 - t) * a.X + t * b.X));
        found.push_back({ { edge.GetHalfEdge(), x, levels.Numbers[r] }, r, i });
      }
    }
  }
}

void CrossFace(ApolloniusFace& face, const DistanceField& field, Id f, const SortedLevels& levels,
  const CrossingTable& table, std::vector<FaceCurve>& curves)
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
  // What is possible for a distance; a cubic may go beyond by as much again.
  const double reach = 2.0 * FarthestFromCorners * longest;
  const std::size_t first = levels.FirstFrom(low - reach);
  if (first == levels.Values.size() || levels.Values[first] > high + reach)
  {
    return;
  }
  face.Enter(f);
  for (std::size_t r = levels.FirstFrom(face.GetSmallest());
       r < levels.Values.size() && levels.Values[r] <= face.GetLargest(); ++r)
  {
    face.FindCurves(
      levels.Values[r], levels.Numbers[r],
      [&](Id h, std::size_t interval) { return table.Find(h, r, interval); }, curves);
  }
}

Status CheckInput(const DistanceField& field, int steinerPoints, const std::vector<double>& levels)
{
  if (!field.Mesh || !field.Distances)
  {
    return Status::Invalid("there is no distance: set Mesh and Distances of the field");
  }
  if (steinerPoints < 0 || steinerPoints > MaximumSteinerPoints)
  {
    return Status::Invalid("the number of Steiner points per edge is " +
      std::to_string(steinerPoints) + ": it must be 0 to " + std::to_string(MaximumSteinerPoints));
  }
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    if (!std::isfinite(levels[i]))
    {
      return Status::Invalid(
        "value " + std::to_string(i) + " of the isolines is not finite: give a number");
    }
  }
  return Status::Success();
}
}

Status FindApolloniusParts(const DistanceField& field, int steinerPoints,
  const std::vector<double>& levels, const ParallelFor& parallel, const ProgressCallback& progress,
  std::vector<LevelCrossing>& crossings, std::vector<FaceCurve>& curves)
{
  crossings.clear();
  curves.clear();
  Status status = CheckInput(field, steinerPoints, levels);
  if (!status.IsOk())
  {
    return status;
  }
  const SurfaceMesh& mesh = *field.Mesh;
  DistanceField used = field;
  VirtualSources fitted;
  double begin = 0.0;
  if (!field.Sources || field.Sources->Offsets.empty())
  {
    if (!FitVirtualSources(
          mesh, field.Distances, parallel, fitted, ProgressPart(progress, 0.0, FitDone)))
    {
      return Status::Abort();
    }
    used.Sources = &fitted;
    begin = FitDone;
  }
  const SortedLevels sorted(levels);
  std::vector<FoundCrossing> found;
  status = Collect(
    mesh.GetNumberOfHalfEdges(), parallel, progress, begin, EdgesDone,
    [&] { return HermiteEdge(used, steinerPoints); },
    [&](HermiteEdge& edge, Id h, std::vector<FoundCrossing>& block) {
      if (IsEdgeAtWork(used, h))
      {
        edge.Enter(h);
        CrossEdge(edge, sorted, block);
      }
    },
    found);
  if (!status.IsOk())
  {
    return status;
  }
  const CrossingTable table(mesh, std::move(found));
  status = Collect(
    mesh.GetNumberOfFaces(), parallel, progress, EdgesDone, 1.0,
    [&] { return ApolloniusFace(used, steinerPoints); },
    [&](ApolloniusFace& face, Id f, std::vector<FaceCurve>& block) {
      if (used.IsReached(f))
      {
        CrossFace(face, used, f, sorted, table, block);
      }
    },
    curves);
  if (!status.IsOk())
  {
    return status;
  }
  table.Take(crossings);
  return Status::Success();
}
}
