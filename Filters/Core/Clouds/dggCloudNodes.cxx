// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudNodes.h"

#include "dggCloudFrame.h"
#include "dggMortonCode.h"
#include "dggOutliers.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace dgg
{
namespace
{
/// A point with its sort key.
struct NodeEntry
{
  std::uint64_t Code;
  Point3 Place;
  Id Original;
};

bool IsFirst(const std::vector<NodeEntry>& entries, std::size_t i)
{
  const Point3& p = entries[i].Place;
  const Point3& before = entries[i > 0 ? i - 1 : 0].Place;
  return i == 0 || before.X != p.X || before.Y != p.Y || before.Z != p.Z;
}

/// Sorts points and returns the number of distinct positions.
std::size_t SortEntries(std::vector<NodeEntry>& entries)
{
  std::sort(entries.begin(), entries.end(), [](const NodeEntry& a, const NodeEntry& b) {
    return std::tie(a.Code, a.Place.X, a.Place.Y, a.Place.Z, a.Original) <
      std::tie(b.Code, b.Place.X, b.Place.Y, b.Place.Z, b.Original);
  });
  std::size_t places = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    places += IsFirst(entries, i) ? 1 : 0;
  }
  return places;
}

/// Reports the first point of each position, together with the other points at this position.
/// Arrays are allocated in advance.
void ReportPlaces(const std::vector<NodeEntry>& entries, std::size_t places,
  std::vector<Id>& originals, std::vector<std::pair<Id, Id>>& coincident)
{
  originals.reserve(places);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (IsFirst(entries, i))
    {
      originals.push_back(entries[i].Original);
    }
    else
    {
      coincident.emplace_back(entries[i].Original, originals.back());
    }
  }
}
}

Status FindNodes(
  const double* points, Id numberOfPoints, CloudNodes& nodes, std::vector<Point3>& places)
{
  const Outliers outliers(points, numberOfPoints);
  const CloudFrame frame(
    points, numberOfPoints, [&](const Point3& p) { return outliers.IsOutlier(p); });
  nodes = CloudNodes();
  places.clear();
  nodes.NumberOfOutliers = outliers.GetNumberOfPoints();
  nodes.Unused = numberOfPoints - frame.GetNumberOfPoints() - outliers.GetNumberOfPoints();
  if (frame.GetNumberOfPoints() == 0)
  {
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(frame.CheckRange());
  nodes.Scale = frame.GetScale();
  nodes.Extent = 2.0 * frame.GetHalfExtent() * nodes.Scale;

  std::vector<NodeEntry> entries;
  std::vector<NodeEntry> outlierEntries;
  entries.reserve(static_cast<std::size_t>(frame.GetNumberOfPoints()));
  outlierEntries.reserve(static_cast<std::size_t>(outliers.GetNumberOfPoints()));
  for (Id i = 0; i < numberOfPoints; ++i)
  {
    const Point3 point = PointAt(points, i);
    if (IsFinite(point) && outliers.IsOutlier(point))
    {
      outlierEntries.push_back({ 0, point, i });
    }
    else if (IsFinite(point))
    {
      const Point3 place = frame.ToLocal(point);
      entries.push_back(
        { GetMortonCode(0.5 * (place.X + 1.0), 0.5 * (place.Y + 1.0), 0.5 * (place.Z + 1.0)), place,
          i });
    }
  }
  const std::size_t count = SortEntries(entries);
  const std::size_t outlierCount = SortEntries(outlierEntries);
  nodes.Coincident.reserve(entries.size() - count + outlierEntries.size() - outlierCount);
  ReportPlaces(entries, count, nodes.Originals, nodes.Coincident);
  ReportPlaces(outlierEntries, outlierCount, nodes.Outliers, nodes.Coincident);
  places.reserve(count);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (IsFirst(entries, i))
    {
      places.push_back(entries[i].Place);
    }
  }
  return Status::Success();
}
}
