// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudSize.h"

#include "dggCloudNeighbors.h"
#include "dggDisjointSets.h"
#include "dggMeshReport.h"
#include "dggPoint3.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace dgg
{
namespace
{
constexpr std::size_t SampleSize = 500;
constexpr std::size_t NeighborRank = 4;
/// Side of a voxel, in gaps: its diagonal is shorter than a gap.
constexpr double VoxelSide = 0.577;
/// Voxels within two steps along each axis; points in others are farther apart than a gap.
constexpr int NumberOfSteps = 125;
constexpr Id VoxelsPerReport = 256;

double MeasureSpacing(const std::vector<Point3>& points, const CloudNeighbors& neighbors)
{
  std::vector<double> distances;
  std::vector<CloudNeighbor> nearest;
  const std::size_t step = std::max<std::size_t>(1, points.size() / SampleSize);
  for (std::size_t i = 0; i < points.size(); i += step)
  {
    neighbors.FindNearest(points[i], NeighborRank + 1, nearest);
    distances.push_back(std::sqrt(nearest.back().SquaredDistance));
  }
  std::sort(distances.begin(), distances.end());
  const std::size_t count = distances.size();
  return 0.5 * (distances[count / 2] + distances[(count - 1) / 2]);
}

using Voxel = std::array<double, 3>; // whole numbers
using Voxels = std::map<Voxel, std::vector<Point3>>;

/// Returns the points by voxel. Points in one voxel are not farther apart than the gap.
Voxels SortIntoVoxels(const std::vector<Point3>& points, double gap)
{
  Voxels voxels;
  const double side = VoxelSide * gap;
  for (const Point3& p : points)
  {
    voxels[{ { std::floor(p.X / side), std::floor(p.Y / side), std::floor(p.Z / side) } }]
      .push_back(p);
  }
  return voxels;
}

bool AreNear(const std::vector<Point3>& some, const std::vector<Point3>& others, double gap)
{
  const auto isNear = [gap](const Point3& p, const Point3& q) {
    const double x = p.X - q.X;
    const double y = p.Y - q.Y;
    const double z = p.Z - q.Z;
    return x * x + y * y + z * z <= gap * gap;
  };
  return std::any_of(some.begin(), some.end(), [&](const Point3& p) {
    return std::any_of(others.begin(), others.end(), [&](const Point3& q) { return isNear(p, q); });
  });
}

/// Counts the components of a cloud, which gaps wider than `gap` separate.
Status CountComponents(
  const std::vector<Point3>& points, double gap, const ProgressCallback& progress, Id& count)
{
  const Voxels voxels = SortIntoVoxels(points, gap);
  std::map<Voxel, Id> numbers;
  for (const auto& voxel : voxels)
  {
    numbers.emplace(voxel.first, static_cast<Id>(numbers.size()));
  }
  count = static_cast<Id>(voxels.size());
  DisjointSets components(voxels.size());
  Id done = 0;
  for (const auto& [place, inside] : voxels)
  {
    if (done % VoxelsPerReport == 0)
    {
      DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(done) / voxels.size()));
    }
    for (int step = 0; step < NumberOfSteps; ++step)
    {
      const Voxel beside{ { place[0] + step / 25 - 2, place[1] + step / 5 % 5 - 2,
        place[2] + step % 5 - 2 } };
      const auto found = voxels.find(beside);
      if (found == voxels.end() || !(place < beside))
      {
        continue;
      }
      const Id other = numbers[beside];
      if (components.Find(done) != components.Find(other) && AreNear(inside, found->second, gap))
      {
        components.Join(done, other);
        --count;
      }
    }
    ++done;
  }
  return Status::Success();
}
}

//------------------------------------------------------------------------------
Status MeasureCloud(const double* points, Offset numberOfPoints, double gap,
  const ProgressCallback& progress, CloudSize& size)
{
  size = CloudSize();
  std::vector<Point3> finite;
  for (Id i = 0; i < static_cast<Id>(numberOfPoints); ++i)
  {
    if (IsFinite(PointAt(points, i)))
    {
      finite.push_back(PointAt(points, i));
    }
  }
  if (finite.empty())
  {
    return Status::Success();
  }
  const CloudNeighbors neighbors(finite);
  size.Spacing = MeasureSpacing(finite, neighbors);
  if (gap == 0.0)
  {
    return Status::Success();
  }
  const auto count = static_cast<Id>(finite.size());
  size.NumberOfComponents = count;
  if (size.Spacing == 0.0)
  {
    size.NumberOfComponents -= static_cast<Id>(CountCoincidentPoints(&finite.data()->X, count));
    return Status::Success();
  }
  return CountComponents(finite, gap * size.Spacing, progress, size.NumberOfComponents);
}
}
