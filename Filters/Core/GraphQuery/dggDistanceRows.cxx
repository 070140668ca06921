// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggDistanceRows.h"

#include "dggMemoryLimit.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <atomic>

namespace dgg
{
namespace
{
struct Entry
{
  Id Column;
  double Distance;
};

using Row = std::vector<Entry>;

/// Bytes per entry while rows are collected and compressed.
constexpr std::size_t BytesPerEntry = sizeof(Entry) + sizeof(Id) + sizeof(double);

void FillRow(const double* distances, const std::vector<Id>& reached,
  const DistanceRowsOptions& options, Row& row)
{
  row.reserve(reached.size());
  for (const Id vertex : reached)
  {
    const bool isNear = distances[vertex] <= options.MaximumDistance;
    for (Id p = isNear ? vertex : NoId; p != NoId;
         p = options.NextPoints.empty() ? NoId : options.NextPoints[p])
    {
      row.push_back({ p, distances[vertex] });
    }
  }
  std::sort(
    row.begin(), row.end(), [](const Entry& a, const Entry& b) { return a.Column < b.Column; });
}

void Compress(std::vector<Row>& found, std::size_t numberOfEntries, DistanceRows& rows)
{
  rows.Offsets = Buffer<Offset>(found.size() + 1);
  rows.Columns = Buffer<Id>(numberOfEntries);
  rows.Distances = Buffer<double>(numberOfEntries);
  std::size_t end = 0;
  rows.Offsets[0] = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    for (const Entry& entry : found[i])
    {
      rows.Columns[end] = entry.Column;
      rows.Distances[end] = entry.Distance;
      ++end;
    }
    rows.Offsets[i + 1] = static_cast<Offset>(end);
    Row().swap(found[i]);
  }
}
}

Status FindDistanceRows(const GraphSearch& search,
  const std::vector<std::vector<GraphSeed>>& sources, const DistanceRowsOptions& options,
  const ParallelFor& parallel, const ProgressCallback& progress, DistanceRows& rows)
{
  ManyOptions many;
  many.MaximumDistance = options.SearchRadius;
  many.Correct = options.Correct;
  std::vector<Row> found(sources.size());
  std::atomic<std::size_t> count{ 0 };
  const auto bytes = [&] { return static_cast<double>(count) * BytesPerEntry; };
  const auto shouldContinue = [&](double done) {
    return bytes() <= options.MemoryLimit && ShouldContinue(progress, done);
  };
  const Status status = search.Many(sources, many, parallel, shouldContinue,
    [&](std::size_t source, const double* distances, const std::vector<Id>& reached) {
      FillRow(distances, reached, options, found[source]);
      count += found[source].size();
    });
  DGG_RETURN_IF_ERROR(CheckMemory("The matrix so far", bytes(), options.MemoryLimit,
    "Use fewer rows at a time or a smaller {MaximumDistance}"));
  DGG_RETURN_IF_ERROR(status);
  Compress(found, count, rows);
  return status;
}

std::vector<Id> FindNextPoints(const PreparedSurface& surface)
{
  std::vector<Id> next;
  if (surface.GetNumberOfMergedPoints() > 0)
  {
    const Id size = surface.GetMesh().GetNumberOfVertices();
    next.assign(size, NoId);
    for (Id p = size - 1; p >= 0; --p)
    {
      const Id vertex = surface.GetVertex(p);
      if (vertex != p)
      {
        next[p] = next[vertex];
        next[vertex] = p;
      }
    }
  }
  return next;
}
}
