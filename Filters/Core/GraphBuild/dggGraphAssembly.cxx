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

/// Edges that are written between two releases of rows: at least the first number, or this
/// fraction.
constexpr Offset FewestEdgesAtOnce = Offset(1) << 16;
constexpr Offset ShareAtOnce = 16; // inverse

/// Visits the edges of rows from the last one on.
class EdgeWriter
{
public:
  EdgeWriter(const RowStore& rows, const std::vector<Id>& order, const Buffer<Offset>& offsets)
    : Rows(rows)
    , Ends(order.size())
  {
    std::transform(
      order.begin(), order.end(), this->Ends.begin(), [&](Id v) { return offsets[v + 1]; });
  }

  /// Calls `write(row, slot of the row, slot of the target, index)` for each edge of rows
  /// [begin, end). The slots are the positions of the two directions in the graph before rows are
  /// sorted.
  template <typename Write>
  void Run(Id begin, Id end, Write&& write)
  {
    for (Id row = end; row-- > begin;)
    {
      for (Offset i = this->Rows.End(row); i-- > this->Rows.Begin(row);)
      {
        const Offset first = --this->Ends[row];
        write(row, first, --this->Ends[this->Rows.Target(i)], i);
      }
    }
  }

private:
  const RowStore& Rows;
  std::vector<Offset> Ends; // per row, where the edges begin that are written already
};

/// Runs two writers over all edges, simultaneously if possible. Calls `release(row)` when the edges
/// from this row on are written.
template <typename First, typename Second, typename Release>
void WriteEdges(const RowStore& rows, const std::vector<Id>& order, const Buffer<Offset>& offsets,
  const ParallelFor& parallel, const First& first, const Second& second, const Release& release)
{
  EdgeWriter writers[] = { { rows, order, offsets }, { rows, order, offsets } };
  const Offset atOnce = std::max(FewestEdgesAtOnce, rows.GetNumberOfEdges() / ShareAtOnce);
  for (Id end = rows.GetNumberOfRows(); end > 0;)
  {
    const Id begin = std::min(end - 1, rows.FindRow(std::max<Offset>(0, rows.Begin(end) - atOnce)));
    ForRange(parallel, 2, 1, [&](Offset from, Offset to) {
      for (Offset task = from; task < to; ++task)
      {
        task == 0 ? writers[0].Run(begin, end, first) : writers[1].Run(begin, end, second);
      }
    });
    release(begin);
    end = begin;
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

/// Sorts the rows of a graph by angle, and edges with equal angles by target.
class RowSorter
{
public:
  /// `ids` are those of AssembleGraph().
  explicit RowSorter(const Id* ids)
    : TargetIds(ids)
  {
  }

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
    const Id* const targets = graph.Targets.Data() + begin;
    const auto idOf = [this, targets](std::uint64_t key) {
      const Id target = targets[key & 0xffffffffU];
      return this->TargetIds ? this->TargetIds[target] : target;
    };
    std::sort(this->Order.begin(), this->Order.end(), [&](std::uint64_t a, std::uint64_t b) {
      return a >> 32 != b >> 32 ? a < b : idOf(a) < idOf(b);
    });
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

  const Id* TargetIds;
  std::vector<std::uint64_t> Order;
  std::vector<Id> Ids;
  std::vector<float> Floats;
  std::vector<double> Doubles;
};
}

Status AssembleGraph(RowStore& rows, const std::vector<Id>& order, bool wide,
  const ParallelFor& parallel, const ProgressCallback& progress, GeodesicGraph& graph,
  const Id* ids)
{
  const auto isToStop = [&](double done) { return progress && !progress(done); };
  const auto n = static_cast<std::size_t>(rows.GetNumberOfRows());
  const auto edges = static_cast<std::size_t>(2 * rows.GetNumberOfEdges());
  graph.Offsets = Buffer<Offset>(n + 1);
  CountEdges(rows, order, graph.Offsets);

  // Rows are released while the graph is written, so that both share their memory.
  rows.ShrinkToFit();
  graph.Angles = Buffer<float>(edges);
  graph.ArrivalAngles = Buffer<float>(edges);
  WriteEdges(
    rows, order, graph.Offsets, parallel,
    [&](Id, Offset first, Offset second, Offset i) {
      graph.Angles[first] = rows.Departure(i);
      graph.Angles[second] = rows.Arrival(i);
    },
    [&](Id, Offset first, Offset second, Offset i) {
      graph.ArrivalAngles[first] = rows.Arrival(i);
      graph.ArrivalAngles[second] = rows.Departure(i);
    },
    [&](Id row) { rows.TruncateAngles(row); });
  if (isToStop(0.4))
  {
    return Status::Abort();
  }

  graph.Targets = Buffer<Id>(edges);
  graph.Lengths = Buffer<float>(wide ? 0 : edges);
  graph.WideLengths = Buffer<double>(wide ? edges : 0);
  WriteEdges(
    rows, order, graph.Offsets, parallel,
    [&](Id row, Offset first, Offset second, Offset i) {
      graph.Targets[first] = order[rows.Target(i)];
      graph.Targets[second] = order[row];
    },
    [&](Id, Offset first, Offset second, Offset i) {
      if (wide)
      {
        graph.WideLengths[first] = graph.WideLengths[second] = rows.Length(i);
      }
      else
      {
        graph.Lengths[first] = graph.Lengths[second] = static_cast<float>(rows.Length(i));
      }
    },
    [&](Id row) { rows.Truncate(row); });
  if (isToStop(0.8))
  {
    return Status::Abort();
  }

  ForRange(parallel, static_cast<Offset>(n), RowGrain, [&](Offset begin, Offset end) {
    RowSorter sorter(ids);
    for (Offset row = begin; row < end; ++row)
    {
      sorter.Sort(graph, static_cast<Id>(row));
    }
  });
  return isToStop(1.0) ? Status::Abort() : Status::Success();
}
}
