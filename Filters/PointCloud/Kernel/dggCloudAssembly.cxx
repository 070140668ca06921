// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudAssembly.h"

#include "dggDisjointSets.h"
#include "dggRowStore.h"

#include <algorithm>
#include <atomic>
#include <memory>

namespace dgg
{
namespace
{
constexpr Offset BlocksPerTask = 4;
constexpr Offset RowsPerTask = 512;
/// Number of nodes whose edges are counted or written, and number of edges whose length is
/// computed, between two progress reports.
constexpr Offset NodesPerReport = 1 << 14;
constexpr Offset EdgesPerReport = 1 << 17;
/// Length of an edge between points at the same position, relative to the extent of the cloud.
constexpr double CoincidentLength = 1e-12;

/// Presents the rows of all blocks as one list of rows. Sorts each row.
class BlockRows
{
public:
  BlockRows(std::vector<CloudRowBlock>& blocks, Id rowsPerBlock, Id numberOfRows,
    const ParallelFor& parallel)
    : Blocks(blocks)
    , RowsPerBlock(rowsPerBlock)
    , Begins(static_cast<std::size_t>(numberOfRows))
  {
    ForRange(
      parallel, static_cast<Offset>(blocks.size()), BlocksPerTask, [&](Offset begin, Offset end) {
        for (Offset b = begin; b < end; ++b)
        {
          std::uint32_t next = 0;
          CloudRowBlock& block = this->Blocks[static_cast<std::size_t>(b)];
          for (std::size_t i = 0; i < block.Sizes.size(); ++i)
          {
            this->Begins[static_cast<std::size_t>(b) * this->RowsPerBlock + i] = next;
            std::sort(block.Targets.begin() + next, block.Targets.begin() + next + block.Sizes[i]);
            next += static_cast<std::uint32_t>(block.Sizes[i]);
          }
        }
      });
  }

  const Id* Begin(Id row) const
  {
    return this->Blocks[row / this->RowsPerBlock].Targets.data() + this->Begins[row];
  }
  Id Size(Id row) const
  {
    return this->Blocks[row / this->RowsPerBlock].Sizes[row % this->RowsPerBlock];
  }
  const Id* End(Id row) const { return this->Begin(row) + this->Size(row); }
  bool Has(Id row, Id target) const
  {
    return std::binary_search(this->Begin(row), this->End(row), target);
  }

private:
  std::vector<CloudRowBlock>& Blocks;
  Id RowsPerBlock;
  std::vector<std::uint32_t> Begins; ///< per row, index of its first target in its block
};
}

Status AssembleCloudGraph(const CloudSetup& setup, Id numberOfPoints, Id rowsPerBlock,
  std::vector<CloudRowBlock>& blocks, bool wide, const ParallelFor& parallel,
  const ProgressCallback& progress, GeodesicGraph& graph)
{
  const auto isStopped = [&](double done) { return progress && !progress(done); };
  const std::vector<Id>& originals = setup.Nodes.Originals;
  const auto nodes = static_cast<Id>(originals.size());
  const auto n = static_cast<std::size_t>(numberOfPoints);
  // Node of each point; NoId for points that are not nodes.
  std::vector<Id> nodeOf(n, NoId);
  for (Id node = 0; node < nodes; ++node)
  {
    nodeOf[originals[node]] = node;
  }
  auto degrees = std::make_unique<std::atomic<Offset>[]>(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    degrees[i].store(0, std::memory_order_relaxed);
  }
  {
    const BlockRows rows(blocks, rowsPerBlock, nodes, parallel);
    // Calls `body` for each node and reports progress from `done` to `done` + 0.1. Returns false if
    // stopped.
    const auto forEachNode = [&](double done, const auto& body) {
      for (Offset first = 0; first < nodes; first += NodesPerReport)
      {
        if (isStopped(done + 0.1 * static_cast<double>(first) / nodes))
        {
          return false;
        }
        const Offset count = std::min(NodesPerReport, nodes - first);
        ForRange(parallel, count, RowsPerTask, [&](Offset begin, Offset end) {
          for (Offset node = first + begin; node < first + end; ++node)
          {
            body(static_cast<Id>(node));
          }
        });
      }
      return true;
    };
    const bool isCounted = forEachNode(0.0, [&](Id node) {
      degrees[originals[node]].fetch_add(rows.Size(node), std::memory_order_relaxed);
      for (const Id* t = rows.Begin(node); t != rows.End(node); ++t)
      {
        if (!rows.Has(*t, node))
        {
          degrees[originals[*t]].fetch_add(1, std::memory_order_relaxed);
        }
      }
    });
    for (const auto& [point, original] : setup.Nodes.Coincident)
    {
      degrees[point].fetch_add(1, std::memory_order_relaxed);
      degrees[original].fetch_add(1, std::memory_order_relaxed);
    }
    if (!isCounted)
    {
      return Status::Abort();
    }
    graph.Offsets = Buffer<Offset>(n + 1);
    graph.Offsets[0] = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Offset degree = degrees[i].load(std::memory_order_relaxed);
      degrees[i].store(graph.Offsets[i], std::memory_order_relaxed);
      graph.Offsets[i + 1] = graph.Offsets[i] + degree;
    }
    graph.Targets = Buffer<Id>(static_cast<std::size_t>(graph.Offsets[n]));
    const auto write = [&](Id from, Id to) {
      graph.Targets[degrees[from].fetch_add(1, std::memory_order_relaxed)] = to;
    };
    const bool isWritten = forEachNode(0.1, [&](Id node) {
      for (const Id* t = rows.Begin(node); t != rows.End(node); ++t)
      {
        write(originals[node], originals[*t]);
        if (!rows.Has(*t, node))
        {
          write(originals[*t], originals[node]);
        }
      }
    });
    if (!isWritten)
    {
      return Status::Abort();
    }
    for (const auto& [point, original] : setup.Nodes.Coincident)
    {
      write(point, original);
      write(original, point);
    }
  }
  blocks.clear();
  blocks.shrink_to_fit();

  const std::size_t edges = graph.Targets.Size();
  graph.Lengths = Buffer<float>(wide ? 0 : edges);
  graph.WideLengths = Buffer<double>(wide ? edges : 0);
  const double toPoints = 1.0 / setup.Nodes.Scale;
  const double coincident =
    CoincidentLength * (setup.Nodes.Extent > 0.0 ? setup.Nodes.Extent : 1.0);
  const auto measureRows = [&](Offset begin, Offset end) {
    for (Offset row = begin; row < end; ++row)
    {
      // Restore a defined order: threads have written the targets in any order.
      std::sort(
        graph.Targets.begin() + graph.Offsets[row], graph.Targets.begin() + graph.Offsets[row + 1]);
      const Id from = nodeOf[row];
      for (Offset e = graph.Offsets[row]; e < graph.Offsets[row + 1]; ++e)
      {
        const Id to = nodeOf[graph.Targets[e]];
        double length = from == NoId || to == NoId ? 0.0 : setup.Pairs.Length(from, to);
        if (!(length > 0.0))
        {
          length = coincident; // also used where the distance underflows
        }
        if (wide)
        {
          graph.WideLengths[e] = toPoints * length;
        }
        else
        {
          graph.Lengths[e] = RoundedUp(toPoints * length);
        }
      }
    }
  };
  const auto count = static_cast<Offset>(n);
  for (Offset first = 0; first < count;)
  {
    if (isStopped(0.2 + 0.8 * static_cast<double>(first) / static_cast<double>(count)))
    {
      return Status::Abort();
    }
    Offset last = first;
    while (last < count && graph.Offsets[last] - graph.Offsets[first] < EdgesPerReport)
    {
      last = std::min(count, last + RowsPerTask);
    }
    ForRange(parallel, last - first, RowsPerTask,
      [&](Offset begin, Offset end) { measureRows(first + begin, first + end); });
    first = last;
  }
  return Status::Success();
}

void FindCloudComponents(const GeodesicGraph& graph, const std::vector<unsigned char>& isUsed,
  std::vector<Id>& components, std::vector<Id>& sizes)
{
  const Id n = graph.GetNumberOfVertices();
  DisjointSets sets(static_cast<std::size_t>(n));
  for (Id v = 0; v < n; ++v)
  {
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      if (graph.Targets[e] > v)
      {
        sets.Join(v, graph.Targets[e]);
      }
    }
  }
  std::vector<Id> sizeOf(static_cast<std::size_t>(n), 0);
  std::vector<Id> roots;
  for (Id v = 0; v < n; ++v)
  {
    if (isUsed[v] && sizeOf[sets.Find(v)]++ == 0)
    {
      roots.push_back(sets.Find(v));
    }
  }
  std::stable_sort(roots.begin(), roots.end(), [&](Id a, Id b) { return sizeOf[a] > sizeOf[b]; });
  sizes.clear();
  std::vector<Id> number(static_cast<std::size_t>(n), NoId);
  for (std::size_t i = 0; i < roots.size(); ++i)
  {
    number[roots[i]] = static_cast<Id>(i);
    sizes.push_back(sizeOf[roots[i]]);
  }
  components.assign(static_cast<std::size_t>(n), NoId);
  for (Id v = 0; v < n; ++v)
  {
    components[v] = isUsed[v] ? number[sets.Find(v)] : NoId;
  }
}
}
