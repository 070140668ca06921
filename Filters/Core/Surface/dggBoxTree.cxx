// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBoxTree.h"

#include "dggMortonCode.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace dgg
{
//------------------------------------------------------------------------------
BoxTree::BoxTree(const std::vector<Box>& elements)
{
  if (elements.empty())
  {
    return;
  }
  Box whole;
  for (const Box& box : elements)
  {
    whole.Add(box);
  }
  double extent = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    extent = std::max(extent, whole.High[k] - whole.Low[k]);
  }
  const double scale = extent > 0.0 ? 1.0 / extent : 0.0;
  std::vector<std::pair<std::uint64_t, Id>> order;
  order.reserve(elements.size());
  for (const Box& box : elements)
  {
    std::array<double, 3> middle{}; // NaN for an empty box
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = scale * (0.5 * box.Low[k] + 0.5 * box.High[k] - whole.Low[k]);
    }
    order.emplace_back(
      GetMortonCode(middle[0], middle[1], middle[2]), static_cast<Id>(order.size()));
  }
  std::sort(order.begin(), order.end());

  std::size_t numberOfLeaves = 1;
  while (LeafSize * numberOfLeaves < elements.size())
  {
    numberOfLeaves *= 2;
  }
  this->Nodes.resize(2 * numberOfLeaves - 1);
  this->Elements.reserve(elements.size());
  for (const auto& entry : order)
  {
    const std::size_t leaf = this->Elements.size() / LeafSize;
    this->Nodes[this->GetFirstLeaf() + leaf].Add(elements[static_cast<std::size_t>(entry.second)]);
    this->Elements.push_back(entry.second);
  }
  for (std::size_t i = this->GetFirstLeaf(); i-- > 0;)
  {
    this->Nodes[i].Add(this->Nodes[2 * i + 1]);
    this->Nodes[i].Add(this->Nodes[2 * i + 2]);
  }
}
}
