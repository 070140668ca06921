// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudSize.h"

#include "dggCloudNeighbors.h"
#include "dggDisjointSets.h"
#include "dggMeshReport.h"
#include "dggPoint3.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dgg
{
namespace
{
constexpr std::size_t SampleSize = 500;
constexpr std::size_t NeighborRank = 4;
/// Number of points between two reports of progress.
constexpr Id Block = 4096;

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
  DisjointSets components(finite.size());
  std::vector<CloudNeighbor> near;
  for (Id i = 0; i < count; ++i)
  {
    if (i % Block == 0)
    {
      DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(i) / count));
    }
    neighbors.FindWithin(finite[i], gap * size.Spacing, near);
    for (const CloudNeighbor& neighbor : near)
    {
      size.NumberOfComponents -= components.Join(i, neighbor.Point) ? 1 : 0;
    }
  }
  return Status::Success();
}
}
