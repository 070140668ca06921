// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceOrder.h"

#include <cstddef>

namespace dgg
{
namespace
{
class PatchOrder
{
public:
  explicit PatchOrder(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , IsPlaced(mesh.GetNumberOfVertices(), false)
  {
    this->Order.reserve(mesh.GetNumberOfVertices());
  }

  std::vector<Id> Run(Id patchSize)
  {
    const Id n = this->Mesh.GetNumberOfVertices();
    for (Id v = 0; v < n; ++v)
    {
      if (!this->IsPlaced[v] && this->Mesh.Kind(v) != VertexKind::Isolated)
      {
        this->OrderComponent(v, patchSize);
      }
    }
    for (Id v = 0; v < n; ++v)
    {
      if (!this->IsPlaced[v])
      {
        this->Order.push_back(v);
      }
    }
    return std::move(this->Order);
  }

private:
  /// Orders the vertices of a component. Patches start from vertices on the border of earlier
  /// patches, oldest first.
  void OrderComponent(Id start, Id patchSize)
  {
    this->Rim.assign(1, start);
    // NOLINTNEXTLINE(modernize-loop-convert): the list grows during the loop
    for (std::size_t next = 0; next < this->Rim.size(); ++next)
    {
      if (!this->IsPlaced[this->Rim[next]])
      {
        this->GrowPatch(this->Rim[next], patchSize);
      }
    }
  }

  void GrowPatch(Id seed, Id patchSize)
  {
    const std::size_t begin = this->Order.size();
    this->Place(seed);
    for (std::size_t i = begin; i < this->Order.size(); ++i)
    {
      const bool isFull = this->Order.size() - begin >= static_cast<std::size_t>(patchSize);
      const Id v = this->Order[i];
      for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
      {
        this->Reach(this->Mesh.Destination(*g), isFull);
        this->Reach(this->Mesh.Apex(*g), isFull);
      }
    }
  }

  void Reach(Id v, bool isFull)
  {
    if (!this->IsPlaced[v])
    {
      if (isFull)
      {
        this->Rim.push_back(v);
      }
      else
      {
        this->Place(v);
      }
    }
  }

  void Place(Id v)
  {
    this->IsPlaced[v] = true;
    this->Order.push_back(v);
  }

  const SurfaceMesh& Mesh;
  std::vector<bool> IsPlaced;
  std::vector<Id> Order;
  std::vector<Id> Rim;
};
}

std::vector<Id> ComputePatchOrder(const SurfaceMesh& mesh, Id patchSize)
{
  return PatchOrder(mesh).Run(patchSize);
}
}
