// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphAssembly.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace dgg
{
namespace
{
constexpr Offset RowGrain = 256;

/// Calls `visit(slot of the first end, slot of the second end, index in the rows)` for every edge.
/// The slots are the positions of the two directions in the graph before rows are sorted.
template <typename Visitor>
void ForEachEdge(const RowStore& rows, const std::vector<Id>& order, const Buffer<Offset>& offsets,
  Visitor&& visit)
{
  std::vector<Offset> next(rows.GetNumberOfRows());
  for (Id row = 0; row < rows.GetNumberOfRows(); ++row)
  {
    next[row] = offsets[order[row]];
  }
  for (Id row = 0; row < rows.GetNumberOfRows(); ++row)
  {
    for (Offset i = rows.Begin(row); i < rows.End(row); ++i)
    {
      const Offset first = next[row]++;
      visit(first, next[rows.Target(i)]++, i);
    }
  }
}

void CountEdges(const RowStore& rows, const std::vector<Id>& order, Buffer<Offset>& offsets)
{
  const Id n = rows.GetNumberOfRows();
  std::fill(offsets.begin(), offsets.end(), 0);
  for (Id row = 0; row < n; ++row)
  {
    offsets[order[row] + 1] += rows.End(row) - rows.Begin(row);
    for (Offset i = rows.Begin(row); i < rows.End(row); ++i)
    {
      ++offsets[order[rows.Target(i)] + 1];
    }
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
}

/// Sorts the rows of a graph by angle.
class RowSorter
{
public:
  void Sort(GeodesicGraph& graph, Id row)
  {
    const Offset begin = graph.Offsets[row];
    const auto size = static_cast<std::size_t>(graph.Offsets[row + 1] - begin);
    // The bit patterns of non-negative floats are ordered like the floats: one integer holds both
    // key and index.
    this->Order.resize(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      std::uint32_t bits = 0;
      std::memcpy(&bits, graph.Angles.Data() + begin + i, sizeof(bits));
      this->Order[i] = static_cast<std::uint64_t>(bits) << 32 | i;
    }
    std::sort(this->Order.begin(), this->Order.end());
    this->Permute(graph.Targets.Data() + begin, this->Ids);
    this->Permute(graph.Angles.Data() + begin, this->Floats);
    this->Permute(graph.ArrivalAngles.Data() + begin, this->Floats);
    if (graph.WideLengths.IsEmpty())
    {
      this->Permute(graph.Lengths.Data() + begin, this->Floats);
    }
    else
    {
      this->Permute(graph.WideLengths.Data() + begin, this->Doubles);
    }
  }

private:
  template <typename T>
  void Permute(T* values, std::vector<T>& copy)
  {
    copy.assign(values, values + this->Order.size());
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      values[i] = copy[this->Order[i] & 0xffffffffU];
    }
  }

  std::vector<std::uint64_t> Order;
  std::vector<Id> Ids;
  std::vector<float> Floats;
  std::vector<double> Doubles;
};
}

Status AssembleGraph(RowStore& rows, const std::vector<Id>& order, bool wide,
  const ParallelFor& parallel, const ProgressCallback& progress, GeodesicGraph& graph)
{
  const auto isToStop = [&](double done) { return progress && !progress(done); };
  const auto n = static_cast<std::size_t>(rows.GetNumberOfRows());
  const auto edges = static_cast<std::size_t>(2 * rows.GetNumberOfEdges());
  graph.Offsets = Buffer<Offset>(n + 1);
  CountEdges(rows, order, graph.Offsets);

  // Properties are copied one by one, so that the arrays of the rows can be released in two steps.
  graph.Angles = Buffer<float>(edges);
  graph.ArrivalAngles = Buffer<float>(edges);
  ForRange(parallel, 2, 1, [&](Offset begin, Offset end) {
    for (Offset task = begin; task < end; ++task)
    {
      float* values = task == 0 ? graph.Angles.Data() : graph.ArrivalAngles.Data();
      ForEachEdge(rows, order, graph.Offsets, [&](Offset first, Offset second, Offset i) {
        values[first] = task == 0 ? rows.Departure(i) : rows.Arrival(i);
        values[second] = task == 0 ? rows.Arrival(i) : rows.Departure(i);
      });
    }
  });
  rows.FreeAngles();
  if (isToStop(0.4))
  {
    return Status::Abort();
  }

  graph.Targets = Buffer<Id>(edges);
  graph.Lengths = Buffer<float>(wide ? 0 : edges);
  graph.WideLengths = Buffer<double>(wide ? edges : 0);
  ForRange(parallel, 2, 1, [&](Offset begin, Offset end) {
    for (Offset task = begin; task < end; ++task)
    {
      if (task == 0)
      {
        Id row = 0;
        ForEachEdge(rows, order, graph.Offsets, [&](Offset first, Offset second, Offset i) {
          while (i >= rows.End(row))
          {
            ++row;
          }
          graph.Targets[first] = order[rows.Target(i)];
          graph.Targets[second] = order[row];
        });
      }
      else if (wide)
      {
        ForEachEdge(rows, order, graph.Offsets, [&](Offset first, Offset second, Offset i) {
          graph.WideLengths[first] = graph.WideLengths[second] = rows.Length(i);
        });
      }
      else
      {
        ForEachEdge(rows, order, graph.Offsets, [&](Offset first, Offset second, Offset i) {
          graph.Lengths[first] = graph.Lengths[second] = static_cast<float>(rows.Length(i));
        });
      }
    }
  });
  rows.FreeTargetsAndLengths();
  if (isToStop(0.8))
  {
    return Status::Abort();
  }

  ForRange(parallel, static_cast<Offset>(n), RowGrain, [&](Offset begin, Offset end) {
    RowSorter sorter;
    for (Offset row = begin; row < end; ++row)
    {
      sorter.Sort(graph, static_cast<Id>(row));
    }
  });
  return isToStop(1.0) ? Status::Abort() : Status::Success();
}
}
