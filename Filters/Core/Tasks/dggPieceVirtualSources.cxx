// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPieceVirtualSources.h"

#include "dggGroups.h"
#include "dggMeshQuality.h"
#include "dggSourceFinding.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace dgg
{
namespace
{
/// Bytes of a point of the region: its position, rank, estimates, relay and lengths.
constexpr double BytesOfPoint = 160.0;

/// Contribution of a piece to HasCoarseTriangles().
struct PieceTriangles
{
  ReachedTriangles Reached;
  MeanAnisotropy Anisotropy;

  void Add(const PieceTriangles& piece)
  {
    this->Reached.Add(piece.Reached);
    this->Anisotropy.Add(piece.Anisotropy);
  }
};
}

/// Relays of the points of the piece that belong to this process. Nodes are the points of the
/// piece, followed by relays that belong to other processes.
struct PieceVirtualSources::Forest
{
  std::vector<Id> Relays;      // per point of the piece, a node or NoId
  std::vector<double> Lengths; // per node, of the virtual source before merging
  ///@{
  // Per process: points whose lengths it has requested, and nodes whose lengths it sends.
  std::vector<std::vector<Id>> Sent;
  std::vector<std::vector<Id>> Received;
  ///@}
};

Status PieceVirtualSources::Prepare(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable)
{
  DGG_RETURN_IF_ERROR(this->Region.Start(group, piece, isUsable));
  if (!isUsable)
  {
    return Status::Success();
  }
  DGG_RETURN_IF_ERROR(this->Region.Grow(group, 1, true, 0.0));
  this->Region.MakeMesh(this->Mesh);
  const std::vector<Id>& order = this->Mesh.Points;
  this->Ranks.resize(order.size());
  for (std::size_t v = 0; v < order.size(); ++v)
  {
    this->Ranks[order[v]] = static_cast<Id>(v);
  }
  return Status::Success();
}

Status PieceVirtualSources::CheckTriangles(
  ProcessGroup& group, const std::vector<double>& labels, double accuracy, bool& areFine) const
{
  const SurfaceMesh& mesh = this->Mesh.Mesh;
  const std::vector<double> distances = this->ToMesh(labels);
  PieceTriangles triangles;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (this->Mesh.CellIds[f] != NoId)
    {
      triangles.Reached.Add(mesh, f, distances);
      triangles.Anisotropy.Add(mesh, f);
    }
  }
  DGG_RETURN_IF_ERROR(group.Sum(triangles));
  areFine = !triangles.Reached.AreCoarse(accuracy, (1.0 + SumMargin) * ErrorInsideTriangles) &&
    !MayHaveLongTriangles(triangles.Anisotropy);
  return Status::Success();
}

Status PieceVirtualSources::Find(ProcessGroup& group, const PieceDistances& found,
  const std::vector<double>& distances, const ParallelFor& parallel, double inUse,
  VirtualSources& sources) const
{
  inUse += this->GetMemorySize();
  Forest forest;
  DGG_RETURN_IF_ERROR(this->FindForest(group, found, inUse, forest));
  std::vector<double> estimates = found.Corrected;
  estimates.resize(this->Ranks.size());
  DGG_RETURN_IF_ERROR(this->Region.TakeFromOwners(group, 1, estimates, inUse));
  estimates = this->ToMesh(estimates);
  VirtualSources pieces(this->Ranks.size());
  std::vector<double> relayLengths(this->Ranks.size(), RelayMerger::NoRelay);
  for (std::size_t point = 0; point < forest.Relays.size(); ++point)
  {
    const Id v = this->Ranks[point];
    const Id relay = forest.Relays[point];
    pieces[v] = found.Virtual[point];
    relayLengths[v] = relay == NoId ? RelayMerger::NoRelay : forest.Lengths[relay];
  }
  const RelayMerger merger(this->Mesh.Mesh, estimates, pieces, std::move(relayLengths), parallel);
  std::vector<double> lengths;
  DGG_RETURN_IF_ERROR(this->Merge(group, forest, merger, inUse, lengths));
  lengths.resize(this->Ranks.size());
  DGG_RETURN_IF_ERROR(this->Region.TakeFromOwners(group, 1, lengths, inUse));
  sources = found.Virtual;
  for (std::size_t point = 0; point < sources.size(); ++point)
  {
    sources[point].Length = lengths[point];
    sources[point].Offset = distances[point] - lengths[point];
  }
  return Status::Success();
}

/// Finds the nodes of the relays, and requests the lengths of those of other processes.
Status PieceVirtualSources::FindForest(
  ProcessGroup& group, const PieceDistances& found, double inUse, Forest& forest) const
{
  const auto n = static_cast<Id>(found.Relays.size());
  const auto count = static_cast<std::size_t>(group.Count);
  std::vector<Id> remote; // points whose relays belong to other processes
  forest.Relays.assign(found.Relays.size(), NoId);
  for (Id point = 0; point < n; ++point)
  {
    const PieceRelay& relay = found.Relays[point];
    forest.Lengths.push_back(found.Virtual[point].Length);
    if (relay.Process == NoId || this->Region.GetOwner(point) != group.Here)
    {
      continue;
    }
    if (relay.Process == group.Here)
    {
      forest.Relays[point] = this->Region.GetPoint(relay.PointId);
    }
    else
    {
      remote.push_back(point);
    }
  }
  const auto keyOf = [&](Id point) {
    const PieceRelay& relay = found.Relays[point];
    return std::make_pair(relay.Process, relay.PointId);
  };
  std::sort(remote.begin(), remote.end(), [&](Id a, Id b) { return keyOf(a) < keyOf(b); });
  std::vector<std::vector<Offset>> ids(count);
  forest.Received.resize(count);
  Id next = n;
  for (std::size_t i = 0; i < remote.size(); ++i)
  {
    if (i == 0 || keyOf(remote[i]) != keyOf(remote[i - 1]))
    {
      const auto [process, id] = keyOf(remote[i]);
      ids[process].push_back(id);
      forest.Received[process].push_back(next++);
    }
    forest.Relays[remote[i]] = next - 1;
  }
  DGG_RETURN_IF_ERROR(group.ExchangeLists(ids, inUse));
  forest.Sent.resize(count);
  std::vector<std::vector<double>> lengths(count);
  for (std::size_t process = 0; process < count; ++process)
  {
    for (const Offset id : ids[process])
    {
      forest.Sent[process].push_back(this->Region.GetPoint(id));
      lengths[process].push_back(forest.Lengths[forest.Sent[process].back()]);
    }
  }
  DGG_RETURN_IF_ERROR(group.ExchangeLists(lengths, inUse));
  for (const std::vector<double>& list : lengths)
  {
    forest.Lengths.insert(forest.Lengths.end(), list.begin(), list.end());
  }
  return Status::Success();
}

/// Finds the lengths after merging, per node. A relay of another process counts as not merged until
/// that process sends another length.
Status PieceVirtualSources::Merge(ProcessGroup& group, const Forest& forest,
  const RelayMerger& merger, double inUse, std::vector<double>& lengths) const
{
  const auto n = static_cast<Id>(forest.Relays.size());
  const auto nodes = static_cast<Id>(forest.Lengths.size());
  const Groups children = MakeGroups(n, nodes, [&](Id point) { return forest.Relays[point]; });
  std::vector<Id> changed; // nodes
  lengths.assign(forest.Lengths.size(), std::numeric_limits<double>::quiet_NaN());
  for (Id node = 0; node < nodes; ++node)
  {
    if (node >= n || forest.Relays[node] == NoId)
    {
      lengths[node] = forest.Lengths[node];
      changed.push_back(node);
    }
  }
  std::vector<double> known = forest.Lengths; // to the processes that have requested lengths
  std::vector<Message> messages(forest.Sent.size());
  for (bool isOver = false; !isOver;)
  {
    while (!changed.empty())
    {
      const Id node = changed.back();
      changed.pop_back();
      for (Offset i = children.Begins[node]; i < children.Begins[node + 1]; ++i)
      {
        const Id point = children.Members[i];
        const double length = merger.FindLength(this->Ranks[point], lengths[node]);
        if (length != lengths[point])
        {
          lengths[point] = length;
          changed.push_back(point);
        }
      }
    }
    for (std::size_t process = 0; process < messages.size(); ++process)
    {
      std::vector<SharedValue<double>> list;
      for (std::size_t k = 0; k < forest.Sent[process].size(); ++k)
      {
        const Id point = forest.Sent[process][k];
        if (lengths[point] != known[point])
        {
          list.push_back({ static_cast<Id>(k), lengths[point] });
        }
      }
      messages[process].clear();
      AppendIfAny(messages[process], list);
    }
    std::copy_n(lengths.begin(), n, known.begin());
    DGG_RETURN_IF_ERROR(group.Exchange(messages, inUse, &isOver));
    for (std::size_t process = 0; process < messages.size(); ++process)
    {
      for (const auto& merged : MessageReader(messages[process]).Take<SharedValue<double>>())
      {
        const Id node = forest.Received[process][merged.Index];
        lengths[node] = merged.Content;
        changed.push_back(node);
      }
    }
  }
  return Status::Success();
}

/// Returns values per vertex of the mesh, given those of the first points of the region. The values
/// of other vertices are infinite.
std::vector<double> PieceVirtualSources::ToMesh(const std::vector<double>& values) const
{
  std::vector<double> ofMesh(this->Ranks.size(), Infinity);
  for (std::size_t point = 0; point < values.size(); ++point)
  {
    ofMesh[this->Ranks[point]] = values[point];
  }
  return ofMesh;
}

double PieceVirtualSources::GetMemorySize() const
{
  return this->Region.GetMemorySize() + static_cast<double>(this->Mesh.Mesh.GetMemorySize()) +
    BytesOfPoint * static_cast<double>(this->Ranks.size());
}
}
