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
/// Bytes per entry while rows are collected and compressed.
constexpr std::size_t BytesPerEntry = sizeof(RowEntry) + sizeof(Id) + sizeof(double);

/// Adds the other points that are merged into the vertices of a row.
void AddMergedPoints(const std::vector<Id>& nextPoints, DistanceRow& row)
{
  const std::size_t size = row.size();
  for (std::size_t k = 0; k < size; ++k)
  {
    for (Id p = nextPoints[row[k].Column]; p != NoId; p = nextPoints[p])
    {
      row.push_back({ p, row[k].Distance });
    }
  }
  SortRow(row);
}

void Compress(std::vector<DistanceRow>& found, std::size_t numberOfEntries, DistanceRows& rows)
{
  rows.Offsets = Buffer<Offset>(found.size() + 1);
  rows.Columns = Buffer<Id>(numberOfEntries);
  rows.Distances = Buffer<double>(numberOfEntries);
  std::size_t end = 0;
  rows.Offsets[0] = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    for (const RowEntry& entry : found[i])
    {
      rows.Columns[end] = entry.Column;
      rows.Distances[end] = entry.Distance;
      ++end;
    }
    rows.Offsets[i + 1] = static_cast<Offset>(end);
    DistanceRow().swap(found[i]);
  }
}
}

void SortRow(DistanceRow& row)
{
  std::sort(row.begin(), row.end(),
    [](const RowEntry& a, const RowEntry& b) { return a.Column < b.Column; });
}

Status CheckRows(double bytes, double limit)
{
  return CheckMemory(
    "The matrix so far", bytes, limit, "Use fewer rows at a time or a smaller {MaximumDistance}");
}

Status CompressRows(std::size_t numberOfSources,
  const std::function<Status(const ProgressCallback&, const RowConsumer&)>& search,
  const DistanceRowsOptions& options, const ProgressCallback& progress, DistanceRows& rows)
{
  std::vector<DistanceRow> found(numberOfSources);
  std::atomic<std::size_t> count{ 0 };
  const auto bytes = [&] { return static_cast<double>(count) * BytesPerEntry; };
  const auto shouldContinue = [&](double done) {
    return bytes() <= options.MemoryLimit && ShouldContinue(progress, done);
  };
  const Status status = search(shouldContinue, [&](std::size_t source, DistanceRow& row) {
    if (!options.NextPoints.empty())
    {
      AddMergedPoints(options.NextPoints, row);
    }
    count += row.size();
    found[source].swap(row);
  });
  DGG_RETURN_IF_ERROR(CheckRows(bytes(), options.MemoryLimit));
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
