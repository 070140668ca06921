// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBoxTree.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace dgg
{
namespace
{
/// Places two zero bits between each of the lowest 21 bits.
std::uint64_t SpreadBits(std::uint64_t x)
{
  x = (x | x << 32) & 0x001f00000000ffffULL;
  x = (x | x << 16) & 0x001f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

/// Returns the position of the middle of a box along the Z-order curve through a larger box.
std::uint64_t GetCurvePosition(const Box& box, const Box& whole, double cellsPerUnit)
{
  constexpr double last = (1 << 21) - 1;
  std::uint64_t position = 0;
  for (int k = 0; k < 3; ++k)
  {
    const double middle = 0.5 * box.Low[k] + 0.5 * box.High[k];
    // In this order of arguments the result is 0 for the NaN of an empty box.
    const double cell = std::min(std::max(0.0, (middle - whole.Low[k]) * cellsPerUnit), last);
    position |= SpreadBits(static_cast<std::uint64_t>(cell)) << k;
  }
  return position;
}
}

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
  const double cellsPerUnit = extent > 0.0 ? (1 << 21) / extent : 0.0;
  std::vector<std::pair<std::uint64_t, Id>> order;
  order.reserve(elements.size());
  for (const Box& box : elements)
  {
    order.emplace_back(GetCurvePosition(box, whole, cellsPerUnit), static_cast<Id>(order.size()));
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
