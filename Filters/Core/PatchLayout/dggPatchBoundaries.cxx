// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPatchBoundaries.h"

#include "dggDisjointSets.h"
#include "dggLayoutDrawing.h"
#include "dggLayoutOrder.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace dgg
{
namespace
{
using Sector = LayoutSector;

/// Progress weight of the survey of curve lengths.
constexpr double SurveyShare = 0.2;

/// Returns the agreement of two cyclic orders of the same edges: positive if they have the same
/// orientation.
int CompareOrders(const EdgeOrder& first, const EdgeOrder& second)
{
  const auto size = static_cast<std::ptrdiff_t>(first.Edges.size());
  if (size < 3 || second.Edges.size() != first.Edges.size())
  {
    return 0;
  }
  int votes = 0;
  for (std::ptrdiff_t i = 0; i < size; ++i)
  {
    const auto place = std::find(second.Edges.begin(), second.Edges.end(), first.Edges[i]);
    if (place == second.Edges.end())
    {
      return 0;
    }
    const std::ptrdiff_t j = place - second.Edges.begin();
    const Id next = first.Edges[(i + 1) % size];
    votes += second.Edges[(j + 1) % size] == next ? 1 : 0;
    votes -= second.Edges[(j + size - 1) % size] == next ? 1 : 0;
  }
  return votes;
}

std::vector<EdgeOrder> Reversed(const std::vector<EdgeOrder>& orders)
{
  std::vector<EdgeOrder> reversed;
  reversed.reserve(orders.size());
  for (const EdgeOrder& order : orders)
  {
    reversed.push_back(order.Reversed());
  }
  return reversed;
}

/// Orientations of the patches and surfaces.
struct Senses
{
  bool PatchesAreMirrored = false; ///< patches, on the first surface
  bool SecondIsMirrored = false;   ///< second surface relative to the first
};

class BoundaryTracer
{
public:
  BoundaryTracer(const PatchSurface& first, const PatchSurface& second, const PatchLayout& layout,
    const ProgressCallback& progress)
    : Surfaces{ { &first, &second } }
    , Layout(layout)
    , Progress(progress)
    , NumberOfLandmarks(static_cast<Id>(first.Landmarks.size()))
  {
  }

  Status Run(PatchBoundaries& boundaries);

private:
  Status Prepare();
  Status BeginDrawings();
  std::vector<Senses> FindSenses();
  Status Try(const Senses& senses);
  std::vector<Id> FindSequence() const;
  Status DrawAll(const std::vector<Id>& sequence);
  Status CheckPatches(int side) const;
  Status CompareParts() const;

  const std::array<const PatchSurface*, 2> Surfaces;
  const PatchLayout& Layout;
  const ProgressCallback& Progress;
  const Id NumberOfLandmarks;
  LayoutOrder Order;
  std::vector<LayoutDrawing> Drawings; // one per surface
  std::array<std::vector<double>, 2> Lengths;
  std::array<std::vector<EdgeOrder>, 2> Surveys;
  std::vector<EdgeOrder> Orders; // orders on the first surface
  bool PatchesAreMirrored = false;
  bool SecondIsMirrored = false; // relative to the first surface
};

Status BoundaryTracer::Prepare()
{
  const std::size_t others = this->Surfaces[1]->Landmarks.size();
  if (this->Surfaces[0]->Landmarks.size() != others)
  {
    return InvalidInput("There are ", this->NumberOfLandmarks,
      " landmarks on the first surface and ", others, " on the second one")
      .Fix("Give both surfaces the same number of landmarks");
  }
  DGG_RETURN_IF_ERROR(this->Order.Read(this->Layout, this->NumberOfLandmarks));
  return this->BeginDrawings();
}

/// Starts both drawings without curves.
Status BoundaryTracer::BeginDrawings()
{
  this->Drawings.clear();
  const std::array<const char*, 2> names{ { "the first surface", "the second surface" } };
  for (int side = 0; side < 2; ++side)
  {
    this->Drawings.emplace_back(*this->Surfaces[side], this->Order.GetEdges(), names[side]);
    DGG_RETURN_IF_ERROR(this->Drawings[side].Begin());
  }
  return Status::Success();
}

Status BoundaryTracer::Run(PatchBoundaries& boundaries)
{
  boundaries = PatchBoundaries();
  DGG_RETURN_IF_ERROR(this->Prepare());
  for (int side = 0; side < 2; ++side)
  {
    DGG_RETURN_IF_ERROR(this->Drawings[side].Survey(
      ProgressPart(this->Progress, 0.5 * SurveyShare * side, 0.5 * SurveyShare * (side + 1)),
      this->Lengths[side], this->Surveys[side]));
  }
  const std::vector<Senses> choices = this->FindSenses();
  Status status = this->Try(choices[0]);
  for (std::size_t i = 1; i < choices.size() && !status.IsOk() && !status.IsAborted(); ++i)
  {
    const Status other = this->Try(choices[i]);
    status = other.IsOk() || other.IsAborted() ? other : status; // otherwise the first failure
  }
  DGG_RETURN_IF_ERROR(status);
  boundaries.Edges = this->Order.GetEdges();
  for (int side = 0; side < 2; ++side)
  {
    boundaries.Curves[side] = std::move(this->Drawings[side].GetCurves());
  }
  return Status::Success();
}

/// Returns the possible orientations of the patches on the first surface, and of the second surface
/// relative to the first: by majority of the landmarks, when each edge is a shortest path. If no
/// landmark has enough edges to decide, as on an open surface with a single patch, all
/// possibilities are returned, in the order in which to try them.
std::vector<Senses> BoundaryTracer::FindSenses()
{
  int first = 0;
  std::vector<EdgeOrder> orders = this->Order.GetOrders();
  bool hasPatches = false;
  for (Id l = 0; l < this->NumberOfLandmarks; ++l)
  {
    first += CompareOrders(orders[l], this->Surveys[0][l]);
    hasPatches = hasPatches || orders[l].IsKnown;
  }
  if (first < 0)
  {
    orders = Reversed(orders);
  }
  int second = 0;
  for (Id l = 0; l < this->NumberOfLandmarks; ++l)
  {
    const EdgeOrder& order = orders[l].IsKnown ? orders[l] : this->Surveys[0][l];
    second += CompareOrders(order, this->Surveys[1][l]);
  }
  std::vector<Senses> choices{ { first < 0, second < 0 } };
  if (hasPatches && second == 0)
  {
    choices.push_back({ first < 0, true });
  }
  if (hasPatches && first == 0)
  {
    for (std::size_t i = 0, size = choices.size(); i < size; ++i)
    {
      choices.push_back({ true, choices[i].SecondIsMirrored });
    }
  }
  return choices;
}

/// Draws the curves and checks the result.
Status BoundaryTracer::Try(const Senses& senses)
{
  this->PatchesAreMirrored = senses.PatchesAreMirrored;
  this->SecondIsMirrored = senses.SecondIsMirrored;
  this->Orders = this->Order.GetOrders();
  if (this->PatchesAreMirrored)
  {
    this->Orders = Reversed(this->Orders);
  }
  DGG_RETURN_IF_ERROR(this->BeginDrawings());
  DGG_RETURN_IF_ERROR(this->DrawAll(this->FindSequence()));
  for (int side = 0; side < 2; ++side)
  {
    DGG_RETURN_IF_ERROR(this->CheckPatches(side));
  }
  return this->CompareParts();
}

/// Returns the edges in order of length, but the edges of a spanning tree first (Kruskal 1956). For
/// the tree, each boundary loop counts as connected already.
std::vector<Id> BoundaryTracer::FindSequence() const
{
  std::vector<double> lengths(this->Order.GetEdges().size(), 0.0);
  for (int side = 0; side < 2; ++side)
  {
    const double sum = std::accumulate(this->Lengths[side].begin(), this->Lengths[side].end(), 0.0);
    for (std::size_t e = 0; e < lengths.size(); ++e)
    {
      lengths[e] += this->Lengths[side][e] / sum;
    }
  }
  std::vector<Id> sorted(lengths.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::stable_sort(
    sorted.begin(), sorted.end(), [&](Id a, Id b) { return lengths[a] < lengths[b]; });

  DisjointSets trees(this->NumberOfLandmarks);
  for (const LayoutDrawing& drawing : this->Drawings)
  {
    const std::vector<Id> loops = drawing.FindBoundaryLoops();
    std::map<Id, Id> first;
    for (Id l = 0; l < this->NumberOfLandmarks; ++l)
    {
      if (loops[l] != NoId)
      {
        trees.Join(l, first.emplace(loops[l], l).first->second);
      }
    }
  }
  std::vector<Id> sequence;
  std::vector<Id> rest;
  for (const Id e : sorted)
  {
    const std::array<Id, 2>& ends = this->Order.GetEdges()[e];
    (trees.Join(ends[0], ends[1]) ? sequence : rest).push_back(e);
  }
  sequence.insert(sequence.end(), rest.begin(), rest.end());
  return sequence;
}

Status BoundaryTracer::DrawAll(const std::vector<Id>& sequence)
{
  const double step = (1.0 - SurveyShare) / static_cast<double>(sequence.size());
  for (std::size_t i = 0; i < sequence.size(); ++i)
  {
    const double done = SurveyShare + step * static_cast<double>(i);
    if (this->Progress && !this->Progress(done))
    {
      return Status::Abort();
    }
    DGG_RETURN_IF_ERROR(this->Drawings[0].Draw(
      sequence[i], this->Orders, ProgressPart(this->Progress, done, done + 0.5 * step)));
    std::vector<EdgeOrder> imposed = this->SecondIsMirrored ? Reversed(this->Orders) : this->Orders;
    DGG_RETURN_IF_ERROR(this->Drawings[1].Draw(
      sequence[i], imposed, ProgressPart(this->Progress, done + 0.5 * step, done + step)));
  }
  return Status::Success();
}

/// Checks that each patch is a disk with exactly its own corners.
Status BoundaryTracer::CheckPatches(int side) const
{
  const bool mirrored = this->PatchesAreMirrored != (side == 1 && this->SecondIsMirrored);
  std::vector<Sector> sectors;
  std::vector<Id> characteristics;
  this->Drawings[side].FindParts(sectors, characteristics);
  std::vector<std::size_t> corners(characteristics.size(), 0);
  for (const Sector& sector : sectors)
  {
    corners[sector.Part] += sector.Begin != NoId || sector.End != NoId ? 1 : 0;
  }
  constexpr const char* remedy = "Correct the patch, or add landmarks around holes and handles";
  std::vector<char> isTaken(characteristics.size(), 0);
  for (std::size_t p = 0; p < this->Layout.Patches.size(); ++p)
  {
    const std::vector<Id>& patch = this->Layout.Patches[p];
    const std::string isNoDisk = JoinText(
      "Patch ", p, " of the layout is not a disk on ", this->Drawings[side].GetName(), ": ");
    Id part = NoId;
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      Id begin = this->Order.FindEdge(patch[i], patch[(i + 1) % patch.size()]);
      Id end = this->Order.FindEdge(patch[(i + patch.size() - 1) % patch.size()], patch[i]);
      if (mirrored)
      {
        std::swap(begin, end);
      }
      const auto sector = std::find_if(sectors.begin(), sectors.end(), [&](const Sector& s) {
        return s.Landmark == patch[i] && s.Begin == begin && s.End == end;
      });
      if (sector == sectors.end())
      {
        return InvalidInput(isNoDisk, "its sides are not adjacent at landmark ", patch[i])
          .Fix(remedy);
      }
      part = i == 0 ? sector->Part : part;
      if (sector->Part != part)
      {
        return InvalidInput(isNoDisk, "its corners at landmarks ", patch[0], " and ", patch[i],
          " are in different parts of the surface")
          .Fix(remedy);
      }
    }
    if (characteristics[part] != 1 || corners[part] != patch.size() || isTaken[part])
    {
      return InvalidInput(isNoDisk,
        characteristics[part] != 1 ? "there is a hole or a handle in it"
                                   : "it is connected with another patch")
        .Fix(remedy);
    }
    isTaken[part] = 1;
  }
  return Status::Success();
}

/// Checks that the curves divide both surfaces alike: the same corners belong together, in parts of
/// the same topology.
Status BoundaryTracer::CompareParts() const
{
  using Corner = std::array<Id, 3>; // landmark and the adjacent curves, none without curves
  std::array<std::map<Corner, Id>, 2> parts;
  std::array<std::vector<Id>, 2> characteristics;
  for (int side = 0; side < 2; ++side)
  {
    std::vector<Sector> sectors;
    this->Drawings[side].FindParts(sectors, characteristics[side]);
    for (Sector& sector : sectors)
    {
      if (side == 1 && this->SecondIsMirrored)
      {
        std::swap(sector.Begin, sector.End);
      }
      if (sector.IsWhole || (sector.Begin != NoId && sector.End != NoId))
      {
        parts[side][{ { sector.Landmark, sector.Begin, sector.End } }] = sector.Part;
      }
    }
  }
  std::map<Id, Id> images;
  std::map<Id, Id> origins;
  for (const std::pair<const Corner, Id>& corner : parts[0])
  {
    const auto other = parts[1].find(corner.first);
    if (other == parts[1].end())
    {
      continue; // at the boundary of the second surface
    }
    const Id image = images.emplace(corner.second, other->second).first->second;
    const Id origin = origins.emplace(other->second, corner.second).first->second;
    if (image != other->second || origin != corner.second ||
      characteristics[0][corner.second] != characteristics[1][other->second])
    {
      return InvalidInput(
        "The curves divide the two surfaces differently at landmark ", corner.first[0])
        .Fix(
          "Check that the landmarks correspond, and add landmarks where the surface has handles");
    }
  }
  return Status::Success();
}
}

Status TracePatchBoundaries(const PatchSurface& first, const PatchSurface& second,
  const PatchLayout& layout, const ProgressCallback& progress, PatchBoundaries& boundaries)
{
  return BoundaryTracer(first, second, layout, progress).Run(boundaries);
}
}
