// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLevelCrossings.h"

#include "dggBlockLoop.h"
#include "dggEdgeProfile.h"
#include "dggEdges.h"

#include <algorithm>
#include <limits>

namespace dgg
{
namespace
{
constexpr Offset BlockSize = 1024;

/// Whether some face of the edge is reached.
bool IsLooked(const DistanceField& field, Id h)
{
  Id e = h;
  do
  {
    if (field.IsReached(SurfaceMesh::Face(e)))
    {
      return true;
    }
    e = field.Mesh->Twin(e);
  } while (e != NoId && e != h);
  return false;
}

/// What is used again from edge to edge.
struct Worker
{
  EdgeProfile Profile;
  std::vector<double> Roots;
};

/// Appends the crossings of one edge, level by level.
void FindOnEdge(const DistanceField& field, const std::vector<double>& levels, Id h, Worker& worker,
  std::vector<LevelCrossing>& crossings)
{
  const SurfaceMesh& mesh = *field.Mesh;
  const double a = field.Distances[mesh.Origin(h)];
  const double b = field.Distances[mesh.Destination(h)];
  // Within these bounds a function of slope 1 at most stays, but for rounding; a field may be
  // steeper than that.
  const double length = (1.0 + 1e-9) * mesh.Length(h);
  const bool isLinear = !field.HasWindows() && !field.HasSources();
  const double lowest = isLinear ? std::min(a, b) : std::min({ a, b, 0.5 * (a + b - length) });
  const double highest = isLinear ? std::max(a, b) : std::max({ a, b, 0.5 * (a + b + length) });
  auto level = std::lower_bound(levels.begin(), levels.end(), lowest);
  if (level == levels.end() || *level > highest || !IsLooked(field, h))
  {
    return;
  }
  worker.Profile.Enter(h);
  for (; level != levels.end() && *level <= highest; ++level)
  {
    worker.Roots.clear();
    worker.Profile.FindCrossings(*level, worker.Roots);
    for (const double x : worker.Roots)
    {
      crossings.push_back({ h, x, static_cast<Id>(level - levels.begin()) });
    }
  }
}
}

Status FindLevelCrossings(const DistanceField& field, const std::vector<double>& levels,
  const ParallelFor& parallel, const ProgressCallback& progress, LevelCrossings& found)
{
  const SurfaceMesh& mesh = *field.Mesh;
  const Id halfEdges = mesh.GetNumberOfHalfEdges();
  std::vector<std::vector<LevelCrossing>> blocks((halfEdges + BlockSize - 1) / BlockSize);
  Status status = ForBlocks(
    halfEdges, BlockSize, parallel, progress,
    [&] {
      return Worker{ EdgeProfile(field), {} };
    },
    [&](Worker& worker, Offset block, Offset begin, Offset end) {
      for (Id h = static_cast<Id>(begin); h < static_cast<Id>(end); ++h)
      {
        const Id twin = mesh.Twin(h);
        if ((twin == NoId || h < twin) && FindEdge(mesh, h) == h)
        {
          FindOnEdge(field, levels, h, worker, blocks[block]);
        }
      }
    });
  if (!status.IsOk())
  {
    return status;
  }
  std::size_t count = 0;
  for (const std::vector<LevelCrossing>& block : blocks)
  {
    count += block.size();
  }
  if (count > static_cast<std::size_t>(std::numeric_limits<Id>::max()))
  {
    return Status::Invalid(
      "there are more than 2^31 - 1 points where levels cross edges: use fewer "
      "levels");
  }
  found.Crossings.clear();
  found.Crossings.reserve(count);
  found.Offsets.assign(static_cast<std::size_t>(halfEdges) + 1, 0);
  for (const std::vector<LevelCrossing>& block : blocks)
  {
    for (const LevelCrossing& crossing : block)
    {
      ++found.Offsets[static_cast<std::size_t>(crossing.HalfEdge) + 1];
      found.Crossings.push_back(crossing);
    }
  }
  for (std::size_t h = 1; h < found.Offsets.size(); ++h)
  {
    found.Offsets[h] += found.Offsets[h - 1];
  }
  return status;
}
}
