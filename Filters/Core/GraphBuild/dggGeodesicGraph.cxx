// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGeodesicGraph.h"

#include "dggBitHash.h"
#include "dggStatus.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace dgg
{
namespace
{
/// Number of rows per task of the check.
constexpr Offset RowsPerTask = 1024;
/// Bytes per partial checksum. Changing this value changes checksums.
constexpr std::size_t BlockSize = std::size_t(1) << 20;

struct ByteRange
{
  const unsigned char* Begin;
  std::size_t Size;
};

/// Appends the byte ranges of the blocks of an array. At least one block is appended, so that the
/// boundaries between arrays, and the presence of an array, affect the checksum.
template <typename T>
void AddBlocks(const T* values, std::size_t count, std::vector<ByteRange>& blocks)
{
  const auto* bytes = reinterpret_cast<const unsigned char*>(values);
  std::size_t left = values ? count * sizeof(T) : 0;
  do
  {
    const std::size_t size = std::min(left, BlockSize);
    blocks.push_back({ bytes, size });
    bytes = size > 0 ? bytes + size : bytes;
    left -= size;
  } while (left > 0);
}

template <typename... Parts>
Status Damaged(const Parts&... what)
{
  return Status(Status::Code::DamagedGraph, JoinText(what...)).Fix("Build the graph again");
}

Status DamagedEdge(Id row, Offset edge, const std::string& what)
{
  return Damaged("Edge ", edge, " of vertex ", row, " ", what);
}

/// Returns true if a value is positive and finite.
template <typename T>
bool IsLength(T value)
{
  return value > T(0) && value <= std::numeric_limits<T>::max();
}

bool IsAngle(float value)
{
  return value >= 0.0f && value <= std::numeric_limits<float>::max();
}

/// Fails if a required array is missing.
Status CheckArrays(const GraphView& graph, Offset numberOfEdges)
{
  if (graph.NumberOfVertices < 0 || numberOfEdges < 0)
  {
    return Damaged("The size of an array is negative");
  }
  if (!graph.Offsets)
  {
    return graph.NumberOfVertices == 0 && numberOfEdges == 0
      ? Status::Success()
      : Damaged("The array of offsets is missing");
  }
  if (graph.Offsets[0] != 0 || graph.Offsets[graph.NumberOfVertices] != numberOfEdges)
  {
    return Damaged("Offsets range from ", graph.Offsets[0], " to ",
      graph.Offsets[graph.NumberOfVertices], ", but there are ", numberOfEdges, " edges");
  }
  if (numberOfEdges == 0)
  {
    return Status::Success();
  }
  if (!graph.Targets)
  {
    return Damaged("The array of targets is missing");
  }
  if ((graph.Lengths != nullptr) == (graph.WideLengths != nullptr))
  {
    return Damaged(
      graph.Lengths ? "Lengths are given in two precisions" : "The array of lengths is missing");
  }
  if ((graph.Angles != nullptr) != (graph.ArrivalAngles != nullptr))
  {
    return Damaged("One of the two arrays of angles is missing");
  }
  if (graph.Info.Kind == GraphKind::Mesh && !graph.Angles)
  {
    return Damaged("The arrays of angles are missing");
  }
  return Status::Success();
}

/// Fails if the row is not valid.
Status CheckRow(const GraphView& graph, Id row, Offset numberOfEdges)
{
  const Offset begin = graph.Offsets[row];
  const Offset end = graph.Offsets[row + 1];
  if (begin < 0 || end < begin || end > numberOfEdges)
  {
    return Damaged("The offsets of vertex ", row, " are ", begin, " and ", end);
  }
  float last = 0.0f;
  for (Offset e = begin; e < end; ++e)
  {
    const Id target = graph.Targets[e];
    if (target < 0 || target >= graph.NumberOfVertices)
    {
      return DamagedEdge(
        row, e, JoinText("leads to vertex ", target, " of ", graph.NumberOfVertices));
    }
    if (target == row)
    {
      return DamagedEdge(row, e, "leads back to its own vertex");
    }
    if (graph.Lengths ? !IsLength(graph.Lengths[e]) : !IsLength(graph.WideLengths[e]))
    {
      return DamagedEdge(row, e, JoinText("has the length ", graph.Length(e)));
    }
    if (!graph.Angles)
    {
      continue;
    }
    if (!IsAngle(graph.Angles[e]) || !IsAngle(graph.ArrivalAngles[e]))
    {
      return DamagedEdge(
        row, e, JoinText("has the angles ", graph.Angles[e], " and ", graph.ArrivalAngles[e]));
    }
    if (graph.Angles[e] < last)
    {
      return DamagedEdge(row, e, "is not sorted by angle");
    }
    last = graph.Angles[e];
  }
  return Status::Success();
}
}

Signature ComputeSignature(
  const double* points, Offset numberOfPoints, const Id* triangles, Offset numberOfTriangles)
{
  BitHash hash;
  hash.Add(points, 3 * static_cast<std::size_t>(numberOfPoints));
  hash.Add(triangles, 3 * static_cast<std::size_t>(numberOfTriangles));
  return hash.Finish();
}

GraphView GeodesicGraph::View() const
{
  GraphView view;
  view.Info = this->Info;
  view.NumberOfVertices = this->GetNumberOfVertices();
  view.Offsets = this->Offsets.Data();
  view.Targets = this->Targets.Data();
  view.Lengths = this->Lengths.Data();
  view.WideLengths = this->WideLengths.Data();
  view.Angles = this->Angles.Data();
  view.ArrivalAngles = this->ArrivalAngles.Data();
  return view;
}

std::size_t GeodesicGraph::GetMemorySize() const
{
  return this->Offsets.Size() * sizeof(Offset) + this->Targets.Size() * sizeof(Id) +
    this->WideLengths.Size() * sizeof(double) +
    (this->Lengths.Size() + this->Angles.Size() + this->ArrivalAngles.Size()) * sizeof(float);
}

Status CheckGraph(const GraphView& graph, Offset numberOfEdges, const ParallelFor& parallel)
{
  DGG_RETURN_IF_ERROR(CheckArrays(graph, numberOfEdges));
  const Id n = graph.NumberOfVertices;
  std::atomic<Id> damaged(n); // smallest damaged row, independent of the order of threads
  ForRange(parallel, n, RowsPerTask, [&](Offset begin, Offset end) {
    for (auto row = static_cast<Id>(begin); row < static_cast<Id>(end); ++row)
    {
      if (!CheckRow(graph, row, numberOfEdges).IsOk())
      {
        Id first = damaged;
        while (row < first && !damaged.compare_exchange_weak(first, row))
        {
        }
        return;
      }
    }
  });
  return damaged == n ? Status::Success() : CheckRow(graph, damaged, numberOfEdges);
}

std::uint64_t ComputeChecksum(const GraphView& graph, const ParallelFor& parallel)
{
  // Threads compute checksums of blocks in parallel; the result is the checksum of these checksums.
  const auto n = static_cast<std::size_t>(graph.NumberOfVertices);
  const auto edges = static_cast<std::size_t>(graph.GetNumberOfEdges());
  std::vector<ByteRange> blocks;
  AddBlocks(graph.Offsets, n + 1, blocks);
  AddBlocks(graph.Targets, edges, blocks);
  AddBlocks(graph.Lengths, edges, blocks);
  AddBlocks(graph.WideLengths, edges, blocks);
  AddBlocks(graph.Angles, edges, blocks);
  AddBlocks(graph.ArrivalAngles, edges, blocks);
  std::vector<std::array<std::uint64_t, 2>> sums(blocks.size());
  ForRange(parallel, static_cast<Offset>(blocks.size()), 1, [&](Offset begin, Offset end) {
    for (Offset i = begin; i < end; ++i)
    {
      BitHash hash;
      hash.Add(blocks[i].Begin, blocks[i].Size);
      sums[i] = hash.Finish();
    }
  });
  BitHash hash;
  hash.Add(sums.data(), sums.size());
  return hash.Finish()[0];
}
}
