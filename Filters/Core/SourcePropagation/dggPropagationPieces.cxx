// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagationPieces.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
}

PropagationPieces::PropagationPieces(
  const SurfaceMesh& mesh, std::vector<int> owners, Offset numberOfFaces, const ProcessGroup& group)
  : Here(group.Here)
  , NumberOfFaces(numberOfFaces)
  , Owners(std::move(owners))
  , IsUsed(static_cast<std::size_t>(mesh.GetNumberOfVertices()), 0)
  , Vertices(static_cast<std::size_t>(group.Count))
  , Exits(Vertices.size())
  , Entries(Vertices.size())
{
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const int owner = this->Owners[SurfaceMesh::Face(h)];
    const Id twin = mesh.Twin(h);
    const int other = twin == NoId ? owner : this->Owners[SurfaceMesh::Face(twin)];
    if (owner == this->Here)
    {
      this->IsUsed[mesh.Origin(h)] = 1;
    }
    if (owner != other && other == this->Here)
    {
      this->Exits[owner].push_back(h);
    }
    if (owner != other && owner == this->Here)
    {
      this->Entries[other].push_back(h);
    }
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    for (const Id* g = mesh.FanBegin(v); this->HasVertex(v) && g != mesh.FanEnd(v); ++g)
    {
      const int owner = this->Owners[SurfaceMesh::Face(*g)];
      std::vector<Id>& vertices = this->Vertices[owner];
      if (owner != this->Here && (vertices.empty() || vertices.back() != v))
      {
        vertices.push_back(v);
      }
    }
  }
}

void PropagationPieces::Start(ProcessGroup& group, double inUse)
{
  this->Group = &group;
  this->InUse = inUse;
  this->LastSent.clear();
  for (const std::vector<Id>& vertices : this->Vertices)
  {
    this->LastSent.emplace_back(vertices.size(), UnreachedKey);
  }
}

Status PropagationPieces::FindLeast(double& value) const
{
  std::vector<double> all;
  DGG_RETURN_IF_ERROR(this->Group->Share(value, all));
  value = *std::min_element(all.begin(), all.end());
  return Status::Success();
}

Status PropagationPieces::ShareDistances(
  std::atomic<float>* distances, std::vector<Id>& lowered, bool& isOver)
{
  std::vector<Message> messages(this->Vertices.size());
  for (std::size_t process = 0; process < messages.size(); ++process)
  {
    std::vector<SharedValue<float>> list;
    for (std::size_t i = 0; i < this->Vertices[process].size(); ++i)
    {
      const float distance = distances[this->Vertices[process][i]].load(std::memory_order_relaxed);
      if (distance < this->LastSent[process][i])
      {
        this->LastSent[process][i] = distance;
        list.push_back({ static_cast<Id>(i), distance });
      }
    }
    AppendIfAny(messages[process], list);
  }
  DGG_RETURN_IF_ERROR(this->Group->Exchange(messages, this->InUse, &isOver));
  for (std::size_t process = 0; process < messages.size(); ++process)
  {
    for (const auto& shared : MessageReader(messages[process]).Take<SharedValue<float>>())
    {
      const Id v = this->Vertices[process][shared.Index];
      float& last = this->LastSent[process][shared.Index];
      last = std::min(last, shared.Content);
      if (shared.Content < distances[v].load(std::memory_order_relaxed))
      {
        distances[v].store(shared.Content, std::memory_order_relaxed);
        lowered.push_back(v);
      }
    }
  }
  return Status::Success();
}

Status PropagationPieces::ExchangeLabels(std::vector<PropagationLabel>& labels) const
{
  std::vector<std::vector<PropagationLabel>> sent(this->Exits.size());
  for (PropagationLabel label : labels)
  {
    const int process = this->Owners[SurfaceMesh::Face(label.Entry)];
    const std::vector<Id>& exits = this->Exits[process];
    label.Entry =
      static_cast<Id>(std::lower_bound(exits.begin(), exits.end(), label.Entry) - exits.begin());
    sent[process].push_back(label);
  }
  labels.clear();
  std::vector<Message> messages(sent.size());
  for (std::size_t process = 0; process < sent.size(); ++process)
  {
    AppendIfAny(messages[process], sent[process]);
  }
  DGG_RETURN_IF_ERROR(this->Group->Exchange(messages, this->InUse));
  for (std::size_t process = 0; process < messages.size(); ++process)
  {
    for (auto& label : MessageReader(messages[process]).Take<PropagationLabel>())
    {
      label.Entry = this->Entries[process][label.Entry];
      labels.push_back(label);
    }
  }
  return Status::Success();
}
}
