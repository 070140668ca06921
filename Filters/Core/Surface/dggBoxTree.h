// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A tree of boxes for nearest-neighbor searches. Internal.
#ifndef dggBoxTree_h
#define dggBoxTree_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggTypes.h"      // for Id

#include <algorithm> // for std::min
#include <array>     // for Box
#include <cmath>     // for std::hypot
#include <cstddef>   // for std::size_t
#include <utility>   // for std::swap
#include <vector>    // for the nodes

namespace dgg
{
/// Axis-aligned box in space. The default is empty and infinitely far from every point.
struct Box
{
  std::array<double, 3> Low{ { Infinity, Infinity, Infinity } };
  std::array<double, 3> High{ { -Infinity, -Infinity, -Infinity } };

  void Add(const double* point) { this->Add(point, point); }
  void Add(const Box& box) { this->Add(box.Low.data(), box.High.data()); }
  double GetDiagonal() const
  {
    const Box& b = *this;
    return b.Low[0] > b.High[0]
      ? 0.0
      : std::hypot(b.High[0] - b.Low[0], b.High[1] - b.Low[1], b.High[2] - b.Low[2]);
  }
  double GetSquaredDistance(const std::array<double, 3>& point) const
  {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double below = this->Low[k] - point[k];
      const double above = point[k] - this->High[k];
      const double outside = below > above ? below : above;
      sum += outside > 0.0 ? outside * outside : 0.0;
    }
    return sum;
  }

private:
  void Add(const double* low, const double* high)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Low[k] = std::min(this->Low[k], low[k]);
      this->High[k] = std::max(this->High[k], high[k]);
    }
  }
};

/// A balanced binary tree over the boxes of elements, in the order of a space-filling curve.
/// Several threads may search at the same time.
class DGG_CORE_EXPORT BoxTree
{
public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& elements);

  /// Calls `visit(element)` for elements around a point, near boxes first. `visit` returns the
  /// squared distance beyond which elements are skipped from then on; `squaredLimit` is its initial
  /// value. All closer elements are visited.
  template <typename Visitor>
  void Search(const std::array<double, 3>& point, double squaredLimit, Visitor&& visit) const;

  /// Calls `visit(element)` for the elements of each leaf if `isRelevant(box)` is true for the leaf
  /// and all its ancestors.
  template <typename Test, typename Visitor>
  void ForEach(Test&& isRelevant, Visitor&& visit, std::size_t node = 0) const
  {
    if (node >= this->Nodes.size() || !isRelevant(this->Nodes[node]))
    {
      return;
    }
    if (node < this->GetFirstLeaf())
    {
      this->ForEach(isRelevant, visit, 2 * node + 1);
      this->ForEach(isRelevant, visit, 2 * node + 2);
      return;
    }
    this->VisitLeaf(node, visit);
  }

private:
  static constexpr std::size_t LeafSize = 4;

  template <typename Visitor>
  void VisitLeaf(std::size_t node, Visitor&& visit) const
  {
    const std::size_t begin = LeafSize * (node - this->GetFirstLeaf());
    for (std::size_t i = begin; i < begin + LeafSize && i < this->Elements.size(); ++i)
    {
      visit(this->Elements[i]);
    }
  }

  std::size_t GetFirstLeaf() const { return this->Nodes.size() / 2; }

  std::vector<Box> Nodes;   // children of node i are 2i+1 and 2i+2; a power of two of leaves
  std::vector<Id> Elements; // LeafSize per leaf, fewer in the last one
};

//------------------------------------------------------------------------------
template <typename Visitor>
void BoxTree::Search(const std::array<double, 3>& point, double squaredLimit, Visitor&& visit) const
{
  struct Entry
  {
    std::size_t Node;
    double SquaredDistance;
  };
  if (this->Nodes.empty())
  {
    return;
  }
  std::array<Entry, 64> stack; // one sibling per level
  std::size_t size = 0;
  stack[size++] = { 0, this->Nodes[0].GetSquaredDistance(point) };
  while (size > 0)
  {
    const Entry entry = stack[--size];
    if (entry.SquaredDistance > squaredLimit)
    {
      continue;
    }
    if (entry.Node < this->GetFirstLeaf())
    {
      Entry near{ 2 * entry.Node + 1, this->Nodes[2 * entry.Node + 1].GetSquaredDistance(point) };
      Entry far{ 2 * entry.Node + 2, this->Nodes[2 * entry.Node + 2].GetSquaredDistance(point) };
      if (far.SquaredDistance < near.SquaredDistance)
      {
        std::swap(near, far);
      }
      stack[size++] = far;
      stack[size++] = near;
      continue;
    }
    this->VisitLeaf(entry.Node, [&](Id element) { squaredLimit = visit(element); });
  }
}
}

#endif
