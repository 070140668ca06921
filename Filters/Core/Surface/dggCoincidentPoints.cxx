// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCoincidentPoints.h"

#include "dggBoxTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace dgg
{
namespace
{
using Cell = std::array<std::int64_t, 3>;

struct CellHash
{
  std::size_t operator()(const Cell& cell) const
  {
    std::uint64_t hash = 0;
    for (const std::int64_t x : cell)
    {
      hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// Points in the cells of a grid that is wider than the tolerance, so that few cells are near a
/// point.
class PointGrid
{
public:
  PointGrid(const double* points, double tolerance, const Box& bounds)
    : Points(points)
    , Tolerance(tolerance)
    , Origin(bounds.Low)
    , Width(std::max(4.0 * tolerance, std::ldexp(bounds.GetDiagonal(), -60)))
  {
  }

  /// Returns the closest point that was added within the tolerance, or NoId.
  Id Find(Id id) const
  {
    const Cell low = this->GetCell(id, -this->Tolerance);
    const Cell high = this->GetCell(id, this->Tolerance);
    Id closest = NoId;
    double smallest = this->Tolerance;
    Cell cell{};
    for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
    {
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
      {
        for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
        {
          const auto found = this->Cells.find(cell);
          for (Id k = found == this->Cells.end() ? NoId : found->second; k != NoId;
               k = this->Entries[k].Next)
          {
            const Id other = this->Entries[k].Point;
            const double distance = this->GetDistance(id, other);
            if (distance < smallest ||
              (distance == smallest && (closest == NoId || other < closest)))
            {
              closest = other;
              smallest = distance;
            }
          }
        }
      }
    }
    return closest;
  }

  void Add(Id id)
  {
    Id& last = this->Cells.emplace(this->GetCell(id, 0.0), NoId).first->second;
    this->Entries.push_back({ id, last });
    last = static_cast<Id>(this->Entries.size()) - 1;
  }

private:
  struct Entry
  {
    Id Point;
    Id Next; // entry of the same cell
  };

  const double* At(Id id) const { return this->Points + 3 * static_cast<std::size_t>(id); }

  double GetDistance(Id a, Id b) const
  {
    const double* p = this->At(a);
    const double* q = this->At(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  Cell GetCell(Id id, double shift) const
  {
    const double* p = this->At(id);
    Cell cell{};
    for (int k = 0; k < 3; ++k)
    {
      cell[k] =
        static_cast<std::int64_t>(std::floor((p[k] - this->Origin[k] + shift) / this->Width));
    }
    return cell;
  }

  const double* Points;
  double Tolerance;
  std::array<double, 3> Origin;
  double Width;
  std::vector<Entry> Entries;
  std::unordered_map<Cell, Id, CellHash> Cells; // their last entries
};

/// Returns FindRepresentatives() for a tolerance of 0.
std::vector<Id> FindCoincident(const double* points, const std::vector<Id>& ids)
{
  const auto at = [&](std::size_t i) { return points + 3 * static_cast<std::size_t>(ids[i]); };
  std::vector<std::size_t> order(ids.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  const auto isBefore = [&](std::size_t i, std::size_t j) {
    return std::lexicographical_compare(at(i), at(i) + 3, at(j), at(j) + 3);
  };
  std::stable_sort(order.begin(), order.end(), isBefore);
  std::vector<Id> result(ids.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool isFirst = i == 0 || isBefore(order[i - 1], order[i]);
    result[order[i]] = isFirst ? ids[order[i]] : result[order[i - 1]];
  }
  return result;
}
}

//------------------------------------------------------------------------------
std::vector<Id> FindRepresentatives(
  const double* points, const std::vector<Id>& ids, double tolerance)
{
  if (!(tolerance > 0.0))
  {
    return FindCoincident(points, ids);
  }
  if (std::isinf(tolerance) && !ids.empty())
  {
    return std::vector<Id>(ids.size(), ids.front());
  }
  Box bounds;
  for (const Id id : ids)
  {
    bounds.Add(points + 3 * static_cast<std::size_t>(id));
  }
  PointGrid grid(points, tolerance, bounds);
  std::vector<Id> result;
  result.reserve(ids.size());
  for (const Id id : ids)
  {
    const Id close = grid.Find(id);
    result.push_back(close == NoId ? id : close);
    if (close == NoId)
    {
      grid.Add(id);
    }
  }
  return result;
}
}
